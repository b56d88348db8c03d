//! Physics that every registered ground solver, foundation and track obeys, over randomly drawn valid inputs.
//!
//! A law is a function returning what it measured, or what is wrong: so that `wrong` can show that each of them
//! catches a model that breaks it. A new `Solver` variant enters `SOLVERS`, a new `FoundationModel` `springs::FOUNDATIONS`, a new track
//! `track::TRACKS`, and inherits every law.
//! `PROPTEST_CASES=5000 cargo test --release --test laws -- --nocapture` draws more and prints the worst value of each.

mod agreement;
mod batch;
#[path = "../common/mod.rs"]
mod common;
mod dispersion;
mod draw;
mod elements;
mod ground;
mod light_damping;
mod moving;
mod springs;
mod strip;
mod thin_layer;
mod track;
mod uniform;
mod wrong;

use groundwave::soil::Solver;
use proptest::strategy::Strategy;
use proptest::test_runner::{Config, RngSeed, TestCaseError, TestRunner};
use std::cell::Cell;
use std::fmt::Debug;

/// Every registered solver.
pub const SOLVERS: &[Solver] = &[Solver::DirectStiffness, Solver::TransferMatrix, Solver::Flexibility];

/// The measured error (0 is perfect), or what is wrong.
pub type Verdict = Result<f64, String>;

/// `error` if it is within `tolerance`.
pub fn within(error: f64, tolerance: f64, what: impl Fn() -> String) -> Verdict {
    // written so that NaN fails
    if error <= tolerance { Ok(error) } else { Err(format!("{error:e} above {tolerance:e}: {}", what())) }
}

/// Draws `cases` inputs, the same ones on every run, and asks `law` of each: the worst error, or the smallest
/// counterexample found.
pub fn ask<S: Strategy>(cases: u32, inputs: &S, law: impl Fn(&S::Value) -> Verdict) -> Verdict
where
    S::Value: Debug,
{
    let cases = std::env::var("PROPTEST_CASES").ok().and_then(|n| n.parse().ok()).unwrap_or(cases);
    let config = Config {
        cases,
        rng_seed: RngSeed::Fixed(20260722),
        failure_persistence: None,
        max_shrink_iters: 300,
        ..Config::default()
    };
    let worst = Cell::new(0.0f64);
    TestRunner::new(config)
        .run(inputs, |input| {
            worst.set(worst.get().max(law(&input).map_err(TestCaseError::fail)?));
            Ok(())
        })
        .map_err(|error| error.to_string())?;
    Ok(worst.get())
}

/// Prints the worst value of a law that holds; panics with the counterexample of one that does not.
pub fn report(name: &str, verdict: Verdict) {
    match verdict {
        Ok(worst) => println!("{name}: worst {worst:.1e}"),
        Err(reason) => panic!("{name}: {reason}"),
    }
}
