//! Runs a case and leaves its results, whole or not at all.

use super::folder::{self, FolderError, check_output};
use super::sketch::sketch;
use super::solved::{Solved, StudyFailed, name_answers};
use super::{Case, Verification, answers, report};
use crate::concern::Concern;
use crate::dataset::{Attribute, Dataset, Group};
use crate::output::plot::Picture;
use crate::output::{OutputError, Report, ReportTable, csv, hdf5, json, save, vti};
use crate::progress::Observer;
use crate::study::{Answer, Outcome};
use rayon::prelude::*;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// The file with all arrays of a case.
const RESULTS: &str = "results.h5";

/// Where and how.
#[derive(Clone, Debug)]
pub struct RunOptions {
    /// Output folder; it appears when everything in it is written.
    pub out: PathBuf,
    /// Replace an existing folder.
    pub overwrite: bool,
    /// Draw the pictures, which takes longer than most answers do.
    pub pictures: bool,
    /// Write maps as CSV tables too, not to `results.h5` alone.
    pub csv_maps: bool,
    /// Write fields over the ground as `.vti` too, for ParaView.
    pub vti: bool,
}

/// What a run found.
#[derive(Clone, Debug)]
pub struct Summary {
    /// Answers by study.
    pub answers: Vec<(&'static str, Vec<Answer>)>,
    /// What another solver says to them, where the case asks.
    pub verification: Option<Verification>,
    /// Every concern.
    pub concerns: Vec<Concern>,
    /// Maps that stand in `results.h5` alone, by group and name.
    pub only_in_hdf5: Vec<String>,
    /// Files written, relative to the output folder.
    pub files: Vec<String>,
}

/// Why a run has no result.
#[derive(Debug, Error)]
pub enum RunError {
    /// The output folder is in the way, or cannot be made.
    #[error(transparent)]
    Folder(#[from] FolderError),
    /// A study failed.
    #[error(transparent)]
    Study(#[from] StudyFailed),
    /// A file could not be written.
    #[error(transparent)]
    Output(#[from] OutputError),
}

/// Computes every study of `case`, a second time where it is to be verified, and writes HDF5, CSV, JSON, pictures and report.
///
/// # Errors
/// A folder that cannot be made, a study that fails; then nothing is left behind. A figure that holds nothing to draw is a concern.
pub fn run(case: &Case, options: &RunOptions, observer: &dyn Observer) -> Result<Summary, RunError> {
    check_output(&options.out, options.overwrite)?;
    keep(case, Solved::of(case, observer)?, options, observer)
}

/// Writes what [`run`] writes of a `case` that is `solved`.
///
/// # Errors
/// A folder that cannot be made; then nothing is left behind.
pub fn keep(
    case: &Case,
    solved: Solved,
    options: &RunOptions,
    observer: &dyn Observer,
) -> Result<Summary, RunError> {
    let out = check_output(&options.out, options.overwrite)?;
    let Solved { mut outcomes, verification } = solved;
    let drawings = if options.pictures {
        model(case).into_iter().chain(draw(&mut outcomes)).collect()
    } else {
        Vec::new()
    };
    let solved = Solved { outcomes, verification };
    let concerns = solved.concerns(case);
    let staging = folder::stage(&out)?;
    observer.begin("writing", 1);
    write(case, &solved, &concerns, drawings, options, staging.path())?;
    let files = folder::sign(staging.path())?;
    folder::install(staging, &out)?;
    observer.advance();
    observer.end();
    let Solved { outcomes, verification } = solved;
    let only_in_hdf5 = if options.csv_maps { Vec::new() } else { maps(&outcomes) };
    let answers = outcomes.into_iter().map(|(name, o)| (name, o.answers)).collect();
    Ok(Summary { answers, verification, concerns, only_in_hdf5, files })
}

/// Every map as `<group>/<name>`.
fn maps(outcomes: &[(&'static str, Outcome)]) -> Vec<String> {
    let of =
        |group: &Group| group.maps().map(|map| format!("{}/{}", group.name, map.name)).collect::<Vec<_>>();
    outcomes.iter().flat_map(|(_, outcome)| of(&outcome.group)).collect()
}

/// A picture with its title and its caption.
struct Drawing {
    title: String,
    caption: String,
    picture: Picture,
}

/// Train, track and ground, drawn.
fn model(case: &Case) -> Option<Drawing> {
    let (figure, caption) = sketch(&case.railway);
    let picture = Picture::of(&figure).ok()?;
    Some(Drawing { title: figure.title().to_owned(), caption, picture })
}

/// Every figure, drawn once for its files and the report; one that cannot be drawn is a concern of its study.
fn draw(outcomes: &mut [(&'static str, Outcome)]) -> Vec<Drawing> {
    let drawn: Vec<Vec<Result<Picture, OutputError>>> = outcomes
        .par_iter()
        .map(|(_, outcome)| outcome.figures.par_iter().map(|(figure, _)| Picture::of(figure)).collect())
        .collect();
    let mut drawings = Vec::new();
    for ((_, outcome), drawn) in outcomes.iter_mut().zip(drawn) {
        for ((figure, caption), picture) in outcome.figures.iter().zip(drawn) {
            match picture {
                Ok(picture) => drawings.push(Drawing {
                    title: figure.title().to_owned(),
                    caption: caption.clone(),
                    picture,
                }),
                Err(error) => outcome.concerns.push(Concern::new(
                    "no-picture",
                    error.to_string(),
                    "see the numbers in the tables: all of them zero, or none to be had",
                )),
            }
        }
    }
    drawings
}

fn write(
    case: &Case,
    solved: &Solved,
    concerns: &[Concern],
    drawings: Vec<Drawing>,
    options: &RunOptions,
    folder: &Path,
) -> Result<(), RunError> {
    let Solved { outcomes, verification } = solved;
    let verification = verification.as_ref();
    write_arrays((RESULTS, solved.attributes(case, concerns)), outcomes, &drawings, options, folder)?;
    json::write(&summary(case, outcomes, verification, concerns), &folder.join("summary.json"))?;
    let figures = drawings.into_iter().map(|d| (d.title, d.caption, d.picture)).collect();
    let html = report::report(case, outcomes, verification, concerns, figures).html();
    Ok(save(&folder.join("report.html"), html.as_bytes())?)
}

/// All arrays in the file `name` with `attributes`, a table of each group, fields for ParaView, the pictures.
fn write_arrays(
    (name, attributes): (&str, Vec<(String, Attribute)>),
    outcomes: &[(&'static str, Outcome)],
    drawings: &[Drawing],
    options: &RunOptions,
    folder: &Path,
) -> Result<(), RunError> {
    let groups = outcomes.iter().map(|(_, o)| &o.group).collect();
    let tables = |(_, outcome): &(_, Outcome)| {
        csv::write(&outcome.group, folder, options.csv_maps)?;
        if options.vti { vti::write(&outcome.group, folder) } else { Ok(()) }
    };
    let (arrays, tables) = rayon::join(
        || hdf5::write(&Dataset { attributes, groups }, &folder.join(name)),
        || outcomes.par_iter().try_for_each(tables),
    );
    arrays.and(tables)?;
    // drawing a PNG takes longer than most answers
    Ok(drawings.par_iter().try_for_each(|drawing| drawing.picture.write(folder))?)
}

/// What stands in the report of something that is no case: a record, a comparison, a study.
pub(crate) struct Page {
    /// Title of the report.
    pub title: String,
    /// What it was made of.
    pub input: String,
    /// What is taken for granted.
    pub assumptions: Vec<String>,
    /// Tables.
    pub tables: Vec<ReportTable>,
}

/// What stands beside its report.
pub(crate) struct Beside {
    /// Name of the file with all arrays.
    pub arrays: &'static str,
    /// Head of the report, as rows.
    pub about: Vec<(String, String)>,
    /// Attributes of that file, besides title and version.
    pub attributes: Vec<(String, Attribute)>,
    /// Other files: names and texts.
    pub files: Vec<(String, String)>,
}

impl Default for Beside {
    fn default() -> Self {
        Self { arrays: RESULTS, about: Vec::new(), attributes: Vec::new(), files: Vec::new() }
    }
}

/// Leaves `outcomes`, which are of no case, in a folder as [`run`] leaves a case.
///
/// # Errors
/// A folder that cannot be made, a file that cannot be written; then nothing is left behind.
pub(crate) fn leave(
    mut outcomes: Vec<(&'static str, Outcome)>,
    page: Page,
    beside: Beside,
    options: &RunOptions,
) -> Result<Summary, RunError> {
    let out = check_output(&options.out, options.overwrite)?;
    let drawings = if options.pictures { draw(&mut outcomes) } else { Vec::new() };
    outcomes.iter_mut().for_each(|(_, outcome)| name_answers(outcome));
    let concerns: Vec<Concern> = outcomes.iter().flat_map(|(_, outcome)| outcome.concerns.clone()).collect();
    let mut attributes: Vec<(String, Attribute)> = vec![
        ("Conventions".into(), "CF-1.8".into()),
        ("title".into(), page.title.clone().into()),
        ("program".into(), "groundwave".into()),
        ("version".into(), env!("CARGO_PKG_VERSION").into()),
        ("concerns".into(), serde_json::json!(concerns).to_string().into()),
    ];
    attributes.extend(beside.attributes);
    let staging = folder::stage(&out)?;
    let folder = staging.path();
    write_arrays((beside.arrays, attributes), &outcomes, &drawings, options, folder)?;
    for (name, text) in &beside.files {
        save(&folder.join(name), text.as_bytes())?;
    }
    let mut root = serde_json::Map::new();
    root.insert("program".into(), "groundwave".into());
    root.insert("version".into(), env!("CARGO_PKG_VERSION").into());
    root.insert("title".into(), page.title.clone().into());
    insert_answers(&mut root, &outcomes);
    root.insert("concerns".into(), serde_json::json!(concerns));
    json::write(&root.into(), &folder.join("summary.json"))?;
    let only_in_hdf5 = if options.csv_maps { Vec::new() } else { maps(&outcomes) };
    let answers: Vec<(&'static str, Vec<Answer>)> =
        outcomes.into_iter().map(|(name, outcome)| (name, outcome.answers)).collect();
    let all = || answers.iter().flat_map(|(_, answers)| answers);
    let html = Report {
        title: page.title,
        about: beside.about,
        version: env!("CARGO_PKG_VERSION").into(),
        answers: answers::list(all()),
        answer_tables: answers::tables(all()),
        figures: drawings.into_iter().map(|d| (d.title, d.caption, d.picture)).collect(),
        tables: page.tables,
        case_text: page.input,
        assumptions: page.assumptions,
        concerns: concerns.clone(),
        ..Report::default()
    };
    save(&folder.join("report.html"), html.html().as_bytes())?;
    let files = folder::sign(folder)?;
    folder::install(staging, &out)?;
    Ok(Summary { answers, verification: None, concerns, only_in_hdf5, files })
}

/// The answers of each study, and their units, as `summary.json` has them.
fn insert_answers(
    root: &mut serde_json::Map<String, serde_json::Value>,
    outcomes: &[(&'static str, Outcome)],
) {
    let mut units = serde_json::Map::new();
    for (name, outcome) in outcomes {
        let numbers: serde_json::Map<_, _> =
            outcome.answers.iter().map(|a| (a.key.clone(), a.value.into())).collect();
        let of: serde_json::Map<_, _> =
            outcome.answers.iter().map(|a| (a.key.clone(), a.unit.into())).collect();
        root.insert((*name).into(), numbers.into());
        units.insert((*name).into(), of.into());
    }
    root.insert("units".into(), units.into());
}

/// `summary.json`: one object per study with its answers as plain SI numbers, their units beside them.
fn summary(
    case: &Case,
    outcomes: &[(&'static str, Outcome)],
    verification: Option<&Verification>,
    concerns: &[Concern],
) -> serde_json::Value {
    let mut root = serde_json::Map::new();
    root.insert("program".into(), "groundwave".into());
    root.insert("version".into(), env!("CARGO_PKG_VERSION").into());
    root.insert("title".into(), case.title.clone().into());
    if let Some(source) = &case.source {
        root.insert("source".into(), source.clone().into());
    }
    insert_answers(&mut root, outcomes);
    if let Some(verification) = verification {
        root.insert("verification".into(), verification.json());
    }
    root.insert("concerns".into(), serde_json::json!(concerns));
    let maps = maps(outcomes);
    if !maps.is_empty() {
        root.insert("maps_in_results_h5".into(), serde_json::json!(maps));
    }
    root.into()
}
