//! A case file → model and studies, everything checked before anything is computed.

use super::error::{CaseError, Finding, from_toml};
use super::schema::{AxleInput, CaseInput, SoilInput, TrainInput};
use super::values::Named;
use super::{ground, library, studies, track};
use crate::soil::{Profile, Solver};
use crate::study::{Model, Study, Support};
use crate::vehicle::{Axle, Train};
use serde::de::DeserializeOwned;
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
    /// The case file as it was read.
    pub text: String,
    /// Contents of every other file the case uses, by the name it uses: records and library entries.
    pub files: BTreeMap<String, String>,
    /// Sources of the library entries in use.
    pub references: Vec<String>,
    /// Ground, track, train.
    pub model: Model,
    /// The same with the solver that is to verify it (`soil.solver.verify`).
    pub witness: Option<Model>,
    /// What is asked.
    pub studies: Vec<Study>,
}

/// Reads TOML into `T` with the key path of any fault.
fn read<T: DeserializeOwned>(text: &str, name: &str) -> Result<T, CaseError> {
    let syntax = |error: &toml::de::Error| from_toml(error, "", name, text);
    let deserializer = toml::Deserializer::parse(text).map_err(|e| syntax(&e))?;
    serde_path_to_error::deserialize(deserializer).map_err(|error| {
        let path = error.path().to_string();
        from_toml(error.inner(), &path, name, text)
    })
}

/// A table in full, by library name, or from a TOML file beside the case: the table, the path prefix of its keys,
/// and the file they stand in.
struct Resolved<T> {
    table: T,
    prefix: String,
    name: String,
    text: String,
}

/// Longest train [m] and heaviest axle [N] a case may ask for.
const LONGEST_TRAIN: f64 = 2000.0;
const HEAVIEST_AXLE: f64 = 1e8;

struct Loader<'a> {
    name: &'a str,
    text: &'a str,
    /// Reads a file beside the case.
    open: &'a dyn Fn(&str) -> Result<String, String>,
    files: RefCell<BTreeMap<String, String>>,
    references: RefCell<Vec<String>>,
}

impl Loader<'_> {
    fn fault(&self, finding: Finding) -> CaseError {
        finding.at(self.name, self.text)
    }

    fn file(&self, name: &str) -> Result<String, String> {
        let text = (self.open)(name)?;
        self.files.borrow_mut().insert(name.to_owned(), text.clone());
        Ok(text)
    }

    fn resolve<T: DeserializeOwned + Clone>(
        &self,
        named: &Named<T>,
        key: &str,
        kind: &str,
    ) -> Result<Resolved<T>, CaseError> {
        let wanted = match named {
            Named::Table(table) => {
                return Ok(Resolved {
                    table: table.clone(),
                    prefix: key.to_owned(),
                    name: self.name.to_owned(),
                    text: self.text.to_owned(),
                });
            }
            Named::Name(wanted) => wanted,
        };
        let (name, text) = if wanted.ends_with(".toml") {
            let text = self.file(wanted).map_err(|reason| {
                self.fault(
                    Finding::new(key, format!("cannot read \"{wanted}\": {reason}"))
                        .help("the path is relative to the case file"),
                )
            })?;
            (wanted.clone(), text)
        } else {
            let entry = library::find(kind, wanted, key).map_err(|finding| self.fault(finding))?;
            let name = format!("library/{kind}/{wanted}.toml");
            self.files.borrow_mut().insert(name.clone(), entry.text.to_owned());
            let title = entry.text_of("title").unwrap_or_default();
            let source = entry.text_of("source").unwrap_or_default();
            self.references.borrow_mut().push(format!("{wanted}: {title}. {source}"));
            (name, entry.text.to_owned())
        };
        let table = read(&text, &name)?;
        Ok(Resolved { table, prefix: String::new(), name, text })
    }

    /// The ground, its solver and the one to verify it with.
    fn soil(&self, named: &Named<SoilInput>) -> Result<(Profile, Solver, Option<Solver>), CaseError> {
        let mut soil = self.resolve(named, "soil", "soils")?;
        let solver_path = |prefix: &str| [prefix, "solver"].join(if prefix.is_empty() { "" } else { "." });
        let mut solvers = ground::solvers(soil.table.solver.as_ref(), &solver_path(&soil.prefix))
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
                solvers = ground::solvers(soil.table.solver.as_ref(), "solver")
                    .map_err(|f| f.at(&soil.name, &soil.text))?;
            }
        }
        let profile = ground::profile(&soil.table, &soil.prefix).map_err(|f| f.at(&soil.name, &soil.text))?;
        Ok((profile, solvers.0, solvers.1))
    }

    fn train(&self, named: &Named<TrainInput>) -> Result<Train, CaseError> {
        let resolved = self.resolve(named, "train", "vehicles")?;
        let Resolved { table, prefix, name, text } = resolved;
        let at = |rest: &str| if prefix.is_empty() { rest.to_owned() } else { format!("{prefix}.{rest}") };
        let fault = |finding: Finding| finding.at(&name, &text);
        // `count` times the axles, one `length` behind the other
        let repeat = |axles: &[AxleInput],
                      count: Option<usize>,
                      length: Result<f64, &str>,
                      at: &dyn Fn(&str) -> String|
         -> Result<Vec<Axle>, CaseError> {
            let count = count.unwrap_or(1);
            if count == 0 || count > 1000 {
                let message = format!("found {count}: it must lie between 1 and 1000");
                return Err(fault(Finding::new(at("count"), message)));
            }
            let length = match (count, length) {
                (1, _) => 0.0,
                (_, Ok(length)) if length.is_finite() && length > 0.0 => length,
                (_, Ok(length)) => {
                    let message = format!("length is {length} m: it must be finite and above zero");
                    return Err(fault(Finding::new(at("length"), message)));
                }
                (_, Err(message)) => {
                    return Err(fault(
                        Finding::new(at("count"), message).help("add `length = …` [m], or use count = 1"),
                    ));
                }
            };
            Ok((0..count)
                .flat_map(|i| {
                    axles.iter().map(move |a| Axle { position: a.position + length * i as f64, load: a.load })
                })
                .collect())
        };
        let axles: Vec<Axle> = match (&table.axles, &table.vehicle) {
            (Some(_), Some(_)) => {
                return Err(fault(
                    Finding::new(at("vehicle"), "axles and vehicle are both given").help("give one of them"),
                ));
            }
            (Some(axles), None) => {
                let length = table.length.ok_or("the axles have no `length` to repeat them at");
                repeat(axles, table.count, length, &at)?
            }
            (None, Some(vehicle)) => {
                let inner =
                    self.resolve(&Named::<TrainInput>::Name(vehicle.clone()), "train.vehicle", "vehicles")?;
                let TrainInput { axles, vehicle: nested, count, reversed, length, .. } = inner.table;
                if nested.is_some() || count.is_some() || reversed || table.length.is_some() {
                    let message = "a vehicle brings its axles and length, nothing else";
                    return Err(fault(
                        Finding::new(at("vehicle"), message)
                            .help("say count and reversed in the case, length with the axles"),
                    ));
                }
                let length = length.ok_or("this vehicle has no `length` to repeat it at");
                repeat(&axles.unwrap_or_default(), table.count, length, &at)?
            }
            (None, None) => {
                return Err(fault(
                    Finding::new(prefix.clone(), "the train has neither axles nor a vehicle")
                        .help("add axles = [{ position = 0.0, load = … }] or vehicle = \"…\""),
                ));
            }
        };
        let mut axles = axles;
        if table.reversed {
            for axle in &mut axles {
                axle.position = -axle.position;
            }
        }
        // slips of unit, which would run for hours
        let reach = axles.iter().map(|a| a.position.abs()).fold(0.0, f64::max);
        if reach > LONGEST_TRAIN {
            let message = format!("an axle stands {reach} m from the first: more than {LONGEST_TRAIN} m");
            return Err(fault(Finding::new(at("axles"), message).help("positions are in metres")));
        }
        if let Some(i) = axles.iter().position(|a| a.load > HEAVIEST_AXLE) {
            let message =
                format!("axle {} has a load of {} N: more than {HEAVIEST_AXLE} N", i + 1, axles[i].load);
            return Err(fault(Finding::new(at("axles"), message).help("loads are in newtons")));
        }
        Train::new(axles).map_err(|error| {
            use crate::vehicle::VehicleError::{Load, NoLoad, Position};
            let path = match &error {
                NoLoad => at("axles"),
                Load { index, .. } => at(&format!("axles[{}].load", index - 1)),
                Position { index, .. } => at(&format!("axles[{}].position", index - 1)),
            };
            fault(Finding::new(path, error))
        })
    }
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
            let (text, files) = super::runner::stored_case(path).map_err(unreadable)?;
            let open =
                |name: &str| files.get(name).cloned().ok_or_else(|| "not stored in the results".to_owned());
            return Self::parse(&text, &path.display().to_string(), &open);
        }
        let text = std::fs::read_to_string(path).map_err(|e| unreadable(e.to_string()))?;
        let folder = path.parent().unwrap_or(Path::new("")).to_owned();
        let open = move |name: &str| std::fs::read_to_string(folder.join(name)).map_err(|e| e.to_string());
        Self::parse(&text, &path.display().to_string(), &open)
    }

    /// Checks the case `text`, called `name` in messages; `open` reads the files it names.
    ///
    /// # Errors
    /// Everything wrong with it, at its line and key.
    pub fn parse(
        text: &str,
        name: &str,
        open: &dyn Fn(&str) -> Result<String, String>,
    ) -> Result<Self, CaseError> {
        let input: CaseInput = read(text, name)?;
        let loader = Loader { name, text, open, files: RefCell::default(), references: RefCell::default() };
        let mut verify = None;
        let support = match (&input.soil, &input.foundation) {
            (Some(soil), None) => {
                let (profile, solver, second) = loader.soil(soil)?;
                verify = second;
                Support::Ground(profile, solver)
            }
            (None, Some(springs)) => Support::Winkler(ground::springs(springs).map_err(|f| loader.fault(f))?),
            (None, None) => {
                return Err(loader.fault(
                    Finding::new("", "the case has no ground")
                        .help("add [soil], or [foundation] for springs"),
                ));
            }
            (Some(_), Some(_)) => {
                return Err(loader.fault(
                    Finding::new("foundation", "soil and foundation are both given")
                        .help("remove one of them"),
                ));
            }
        };
        let on_ground = matches!(support, Support::Ground(..));
        let resolved = loader.resolve(&input.track, "track", "tracks")?;
        let (stack, contact) = track::track(&resolved.table, &resolved.prefix, on_ground)
            .map_err(|f| f.at(&resolved.name, &resolved.text))?;
        let train = input.train.as_ref().map(|train| loader.train(train)).transpose()?;
        let wheels = match (&input.train, &train) {
            (Some(Named::Table(table)), Some(train)) => {
                studies::wheels(table, train).map_err(|f| loader.fault(f))?
            }
            _ => None,
        };
        let model =
            Model::new(support, contact, stack, train).map_err(|e| loader.fault(Finding::new("track", e)))?;
        let witness = verify
            .map(|solver| model.with_solver(solver))
            .transpose()
            .map_err(|e| loader.fault(Finding::new("soil.solver.verify", e)))?;
        let studies = studies::studies(&input, wheels.as_ref(), &|name| loader.file(name))
            .map_err(|f| loader.fault(f))?;
        for study in &studies {
            study.check(&model).map_err(|e| loader.fault(Finding::new(study.name(), e)))?;
        }
        Ok(Self {
            title: input.title,
            source: input.source,
            text: text.to_owned(),
            files: loader.files.into_inner(),
            references: loader.references.into_inner(),
            model,
            witness,
            studies,
        })
    }
}
