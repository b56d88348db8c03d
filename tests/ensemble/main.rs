//! Samples of uncertain cases: the numbers of single runs, whatever the order, the shards and how often they were killed.

#[path = "../common/mod.rs"]
mod common;

mod command;
mod faults;
mod numbers;
mod sensitivities;

use common::cli::{LAYERS, TRACK, case};
use groundwave::Case;

/// Two layers of a study whose soil scatters, `samples` of them at `speeds`; `more` goes into `[study]`.
fn uncertain(speeds: &str, samples: usize, more: &str) -> String {
    let study = format!(
        "[critical_speed]\nspeeds = {speeds}\nline_speed = \"250 km/h\"\n[study]\nsamples = {samples}\nseed = 3\n{more}\n\
         [[study.vary]]\nkey = \"soil.layer[0].shear_speed\"\nkind = \"lognormal\"\nfactor = true\nmedian = 1.0\nsigma_ln = 0.2\n\
         [[study.vary]]\nkey = \"soil.half_space.young\"\nkind = \"uniform\"\nfrom = \"150 MPa\"\nto = 250e6\n\
         [[study.vary]]\nkey = \"soil.layer.0.thickness\"\nkind = \"triangular\"\nfrom = 1.0\nmode = 2.0\nto = 4.0\n"
    );
    case(LAYERS, &format!("{TRACK}{study}"))
}

/// The case `text`, beside which there is nothing.
fn parsed(text: &str) -> Case {
    Case::parse(text, "case.toml", &|_| Err("there is no such file".to_owned())).unwrap()
}

/// What is wrong with the case `text`.
fn wrong(text: &str) -> String {
    let error = Case::parse(text, "case.toml", &|_| Err("there is no such file".to_owned())).unwrap_err();
    let said = |fault: groundwave::case::CaseError| {
        let help = miette::Diagnostic::help(&fault).map(|help| help.to_string()).unwrap_or_default();
        format!("{fault}; {help}")
    };
    error.each().into_iter().map(said).collect::<Vec<_>>().join("\n")
}

/// Every file of the folder `of` of a study, with its bytes, in order.
fn files(of: &std::path::Path) -> Vec<(String, Vec<u8>)> {
    let read = |entry: std::io::Result<std::fs::DirEntry>| {
        let path = entry.unwrap().path();
        (path.file_name().unwrap().to_string_lossy().into_owned(), std::fs::read(&path).unwrap())
    };
    let mut all: Vec<_> = std::fs::read_dir(of).unwrap().map(read).collect();
    all.sort();
    all
}
