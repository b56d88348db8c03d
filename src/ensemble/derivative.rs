//! How much an answer changes with one number of ground or track.

use super::rows::STEP;
use super::table::Table;
use crate::case::Parameter;

/// A logarithmic derivative, ∂ ln a/∂ ln p: per cent of the answer per per cent of the parameter.
///
/// Accuracy: 2e-3 of a critical speed, which is found to 0.1 m/s
/// (test `ensemble::sensitivities::derivatives_are_those_of_independent_runs`).
#[derive(Clone, Debug, PartialEq)]
pub struct Derivative {
    /// Path of the parameter's key.
    pub key: String,
    /// What stands in the case [SI].
    pub stands: f64,
    /// Its SI unit.
    pub unit: &'static str,
    /// ∂ ln a/∂ ln p ≈ ln(a₊/a₋)/ln((1 + h)/(1 − h)), exact for powers of p.
    pub value: f64,
}

/// The derivatives of `answer` by all `parameters`, largest first; those with an answer on one side only, or of another sign, are left out.
pub fn derivatives(table: &Table, parameters: &[Parameter], answer: &str) -> Vec<Derivative> {
    let width = ((1.0 + STEP) / (1.0 - STEP)).ln();
    let one = |(parameter, [down, up]): (&Parameter, &[super::table::Answers; 2])| {
        let value = (up.get(answer)? / down.get(answer)?).ln() / width;
        let Parameter { key, unit, stands } = parameter.clone();
        value.is_finite().then_some(Derivative { key, unit, stands, value })
    };
    let mut all: Vec<Derivative> = parameters.iter().zip(&table.steps).filter_map(one).collect();
    all.sort_by(|a, b| b.value.abs().total_cmp(&a.value.abs()));
    all
}
