//! A case file → railway and studies, everything checked before anything is computed.

use super::about::About;
use super::changed::{self, Changed};
use super::error::{CaseError, Finding};
use super::faults::{self, Read};
use super::loader::Loader;
use super::schema::{CaseInput, SoilInput};
use super::track::Carried;
use super::uncertain::Uncertain;
use super::values::Named;
use super::vehicle::Wheels;
use super::{files, ground, plausible, roughness, studies, track, train};
use crate::columns;
use crate::concern::Concern;
use crate::foundation::FoundationModel;
use crate::railway::{Contact, Ground, Railway, Support};
use crate::soil::Solver;
use crate::study::{Study, StudyError};
use crate::track::{Layout, Rails, Stack};
use crate::vehicle::Train;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::path::Path;

/// A case ready to run.
#[derive(Debug)]
pub struct Case {
    /// Title.
    pub title: String,
    /// Where the numbers come from.
    pub source: Option<String>,
    /// For whom the report is, and by whom.
    pub about: About,
    /// The case file as it was read.
    pub text: String,
    /// Contents of every other file the case uses, by the name it uses: records and library entries.
    pub files: BTreeMap<String, String>,
    /// Sources of the library entries in use.
    pub references: Vec<String>,
    /// Ground, track, train.
    pub railway: Railway,
    /// The same with the solver that is to verify it (`soil.solver.verify`).
    pub witness: Option<Railway>,
    /// What is asked.
    pub studies: Vec<Study>,
    /// What its numbers may be doubted for: slips of unit, profiles with gaps.
    pub concerns: Vec<Concern>,
    /// What of it is uncertain: its samples are run by [`crate::ensemble`].
    pub study: Option<Uncertain>,
}

/// Ground or springs, and the solver to verify the ground with.
type Carrier = (Support, Option<Solver>);

impl Loader<'_> {
    /// What is doubtful in the numbers of the case and of every file that stands for one of its tables; what cannot be is a
    /// fault, unless its key is refused already.
    fn review(&self, input: &CaseInput) -> Vec<Concern> {
        let (mut refused, mut concerns) = plausible::review("", self.name, self.text);
        for (root, name, text) in self.tables.borrow().iter() {
            let (more_refused, more) = plausible::review(root, name, text);
            refused.extend(more_refused);
            concerns.extend(more);
        }
        let mut faults = self.faults.borrow_mut();
        refused.retain(|new| !faults.iter().any(|old| old.key() == new.key()));
        faults.extend(refused);
        let profile = input.irregularity.iter().flat_map(|i| roughness::concerns(i, &|name| self.file(name)));
        concerns.extend(profile);
        let records = input.track_response.iter().flat_map(|t| t.measured.iter().enumerate());
        concerns.extend(records.filter_map(|(i, record)| {
            let columns = columns::read(&self.file(&record.file).ok()?).ok()?;
            roughness::of_record(&format!("track_response.measured[{i}].file"), &record.file, &columns)
        }));
        concerns
    }

    /// Remembers the library track that the case changes.
    fn takes(&self, Changed { file: (file, contents), reference, .. }: &Changed) {
        self.files.borrow_mut().insert(file.clone(), contents.clone());
        match reference {
            Some(reference) => self.references.borrow_mut().push(reference.clone()),
            None => self.tables.borrow_mut().push(("track", file.clone(), contents.clone())),
        }
    }

    /// What lies under the track.
    fn support(&self, input: &CaseInput) -> Option<Carrier> {
        match (&input.soil, &input.foundation) {
            (Some(_), Some(_)) => self.keep(Err(self.fault(
                Finding::new("foundation", "soil and foundation are both given").help("remove one of them"),
            ))),
            (Some(soil), None) => {
                let (ground, second) = self.keep(self.soil(soil))?;
                Some((Support::Ground(ground), second))
            }
            (None, Some(springs)) => Some((Support::Springs(springs.clone()), None)),
            (None, None) if self.lacks("soil") && self.lacks("foundation") => {
                let finding = Finding::new("", "the case has no ground");
                self.keep(Err(self.fault(finding.help("add [soil], or [foundation] for springs"))))
            }
            (None, None) => None,
        }
    }

    /// The track, its contact with the ground, and how many rails its numbers stand for.
    fn track(&self, input: &CaseInput) -> Option<(Layout, Option<Contact>, Rails)> {
        let Some(named) = &input.track else {
            if input.foundation.is_some() && input.soil.is_none() && self.lacks("track") {
                let finding = Finding::new("foundation", "springs need a track on them");
                self.keep::<()>(Err(
                    self.fault(finding.help("add [track], or track = \"…\" above the first table"))
                ));
            }
            // the ground alone
            return (input.foundation.is_none() && self.lacks("track"))
                .then(|| (Stack::default().into(), None, Rails::Two));
        };
        let resolved = self.keep(self.resolve(named, "track", "tracks"))?;
        let on = match &input.foundation {
            Some(springs) if springs.joined() => Carried::Joined,
            Some(_) => Carried::Apart,
            None if self.spoilt.contains("foundation") => Carried::Apart,
            None => Carried::Ground,
        };
        let track = track::track(&resolved, on);
        let (layout, contact) = self.keep(track.map_err(|f| f.at(&resolved.name, &resolved.text)))?;
        let rock = input.foundation.as_ref().is_some_and(|f| *f.model() == FoundationModel::Rigid);
        let lies = |stack: &Stack| stack.links().len() < stack.members().len();
        let lies = match &layout {
            Layout::Continuous(stack) => lies(stack),
            Layout::Discrete(supports) => lies(&supports.under),
            Layout::Varying(sections) => sections.iter().any(|section| lies(&section.supports.under)),
        };
        if rock && lies {
            let finding =
                Finding::new("foundation.kind", "the lowest mass of the track lies on rock, and cannot move");
            let finding = finding.help(
                "kind = \"rigid\" carries springs: ballast.kind = \"spring\", \"bars\" or \"consistent-mass\"; or give a foundation of springs",
            );
            return self.keep(Err(self.fault(finding)));
        }
        Some((layout, contact, resolved.table.track.rails()))
    }

    /// The train, if there is one; none of both where it is faulty.
    fn train(&self, input: &CaseInput) -> Option<Option<(Train, Wheels)>> {
        match &input.train {
            Some(named) => self.keep(train::train(self, named)).map(Some),
            None => self.lacks("train").then_some(None),
        }
    }

    /// The railway, and the one to verify it.
    fn railways(
        &self,
        railway: Result<Railway, impl std::fmt::Display>,
        second: Option<Solver>,
    ) -> Option<(Railway, Option<Railway>)> {
        let railway = self.keep(railway.map_err(|e| self.fault(Finding::new("track", e))))?;
        let witness = second
            .map(|solver| railway.with_solver(solver))
            .transpose()
            .map_err(|e| self.fault(Finding::new("soil.solver.verify", e)));
        let witness = self.keep(witness)?;
        Some((railway, witness))
    }

    /// Refuses `studies` that `railway` has no answer to.
    fn questions(&self, railway: &Railway, studies: &[Study]) {
        for study in studies {
            let lacks = study.check(railway).err().unwrap_or_default();
            let at = |error: &StudyError| match study.key_of(error) {
                "" => study.name().to_owned(),
                key => format!("{}.{key}", study.name()),
            };
            let faults = lacks.into_iter().map(|e| self.fault(Finding::new(at(&e), e)));
            self.faults.borrow_mut().extend(faults);
        }
    }

    /// The ground, its solver and the one to verify it with.
    pub(super) fn soil(&self, named: &Named<SoilInput>) -> Result<(Ground, Option<Solver>), CaseError> {
        let mut soil = self.resolve(named, "soil", "soils")?;
        let solver_path = |prefix: &str| [prefix, "solver"].join(if prefix.is_empty() { "" } else { "." });
        let mut solvers = ground::solvers(soil.table.solver, &solver_path(&soil.prefix))
            .map_err(|f| f.at(&soil.name, &soil.text))?;
        if let Some(name) = &soil.table.library {
            let path = format!("{}.library", soil.prefix);
            if soil.prefix.is_empty() {
                let finding = Finding::new("library", "a library soil cannot name another one");
                return Err(finding.help("give its layers").at(&soil.name, &soil.text));
            }
            if !soil.table.layer.is_empty() || soil.table.half_space.is_some() || soil.table.base.is_some() {
                let finding = Finding::new(path, "a library soil and layers of its own are both given");
                return Err(self.fault(finding.help("remove library, or the layers and the base")));
            }
            let own = soil.table.solver.is_some();
            soil = self.resolve(&Named::Name(name.clone()), &path, "soils")?;
            if soil.table.library.is_some() {
                let finding = Finding::new("library", "a library soil cannot name another one");
                return Err(finding.help("give its layers").at(&soil.name, &soil.text));
            }
            if !own {
                solvers =
                    ground::solvers(soil.table.solver, "solver").map_err(|f| f.at(&soil.name, &soil.text))?;
            }
        }
        let profile = ground::profile(&soil.table, &soil.prefix).map_err(|faults| {
            CaseError::all(faults.into_iter().map(|f| f.at(&soil.name, &soil.text)), self.name)
        })?;
        let materials = soil.table.layer.iter().chain(&soil.table.half_space);
        let names = materials.map(|material| material.name.clone()).collect();
        Ok((Ground::new(profile, solvers.0, None).named(names), solvers.1))
    }
}

/// What the case `text`, called `name`, says, with its library track in place where it changes one.
fn read(
    (text, name): (&str, &str),
    open: &dyn Fn(&str) -> Result<String, String>,
) -> (Option<Changed>, Read<CaseInput>) {
    let (changed, refused) = match changed::track((text, name), open) {
        Ok(changed) => (changed, None),
        Err(fault) => (None, Some(fault)),
    };
    let whole = changed.as_ref().map_or(text, |changed| &changed.text);
    let mut read = faults::read::<CaseInput>(whole, (name, text), "", Some(("title", "")));
    if refused.is_some() {
        // nothing more is to be said of the track
        read.faults.retain(|fault| !fault.key().starts_with("track"));
        read.faults.extend(refused);
        read.spoilt.insert("track".into());
    }
    (changed, read)
}

impl Case {
    /// Reads and checks the case file at `path`, or the case stored in a `results.h5`.
    ///
    /// # Errors
    /// Everything wrong with it, at its line and key.
    pub fn load(path: &Path) -> Result<Self, CaseError> {
        let unreadable = |reason: String| {
            CaseError::Read {
            path: path.to_owned(),
            reason,
            help: "give the path of a case file (TOML) or of a results.h5; `groundwave new` writes one to start from".into(),
        }
        };
        if path.is_dir() {
            return Err(unreadable("it is a folder".into()));
        }
        if path.extension().is_some_and(|e| e == "h5") {
            let (text, files) = files::stored(path).map_err(unreadable)?;
            let open =
                |name: &str| files.get(name).cloned().ok_or_else(|| "not stored in the results".to_owned());
            return Self::parse(&text, &path.display().to_string(), &open);
        }
        let text = files::text(path).map_err(unreadable)?;
        let folder = path.parent().unwrap_or(Path::new("")).to_owned();
        let open = move |name: &str| files::text(&folder.join(name));
        Self::parse(&text, &path.display().to_string(), &open)
    }

    /// Checks the case `text`, called `name` in messages; `open` reads the files it names.
    ///
    /// # Errors
    /// Everything wrong with it that can be found at once, each fault at its line and key.
    pub fn parse(
        text: &str,
        name: &str,
        open: &dyn Fn(&str) -> Result<String, String>,
    ) -> Result<Self, CaseError> {
        let (changed, Read { said, spoilt, faults }) = read((text, name), open);
        let whole = changed.as_ref().map_or(text, |changed| &changed.text);
        let Some(mut input) = said else { return Err(CaseError::all(faults, name)) };
        input.track = input.track.filter(|_| !spoilt.contains("track"));
        let faults = RefCell::new(faults);
        let loader = Loader { read: whole, spoilt, faults, ..Loader::of(name, text, open) };
        changed.iter().for_each(|changed| loader.takes(changed));
        let ground = loader.support(&input);
        let track = loader.track(&input);
        let train = loader.train(&input);
        let wheels = train.as_ref().map(|train| train.as_ref().map(|(_, wheels)| wheels));
        let rails = track.as_ref().map_or(Rails::Two, |track| track.2);
        let (studies, faults) =
            studies::studies(&input, (wheels, rails), &loader.spoilt, &|name| loader.file(name));
        let heads = input.report.iter().flat_map(About::faults);
        let faults = faults.into_iter().chain(heads).map(|finding| loader.fault(finding));
        loader.faults.borrow_mut().extend(faults.collect::<Vec<_>>());
        let concerns = loader.review(&input);
        let study = input.study.as_ref().and_then(|study| loader.keep(loader.uncertain(study)));
        let railways = match (ground, track, train) {
            (Some((mut support, second)), Some((layout, contact, _)), Some(train)) => {
                if let Support::Ground(ground) = &mut support {
                    ground.contact = contact;
                }
                let train = train.map(|(train, _)| train);
                loader.railways(Railway::new(support, layout, train), second)
            }
            _ => None,
        };
        if let Some((railway, _)) = &railways {
            loader.questions(railway, &studies);
        }
        match (railways, loader.faults.borrow_mut().split_off(0)) {
            (Some((railway, witness)), faults) if faults.is_empty() => Ok(Self {
                title: input.title,
                source: input.source,
                about: input.report.unwrap_or_default(),
                text: text.to_owned(),
                files: loader.files.take(),
                references: loader.references.take(),
                railway,
                witness,
                studies,
                concerns,
                study,
            }),
            (_, faults) => Err(CaseError::all(faults, name)),
        }
    }
}
