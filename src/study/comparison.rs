//! One study by two solvers: how far apart are they?

use super::Outcome;
use crate::concern::Concern;
use crate::dataset::{Group, Variable};

/// Largest relative difference that is no concern.
pub const TOLERABLE: f64 = 1e-3;

/// Datasets on how the answer came about, not the answer: estimates of errors, periods of a transform.
const ASIDE: [&str; 5] = ["relative_error", "wrap_around", "aliasing", "period_x", "period_y"];

/// The largest difference of one dataset, or of one answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// Name of the dataset (a complex pair without `_re`, `_im`), or key of the answer.
    pub name: String,
    /// max |a − b| in `unit`
    pub absolute: f64,
    /// The same over the largest value of its kind: same unit and dimensions.
    pub relative: f64,
    /// SI unit.
    pub unit: String,
}

/// What two solvers say to one question.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Comparison {
    /// One for every dataset or complex pair.
    pub datasets: Vec<Difference>,
    /// One for every answer.
    pub answers: Vec<Difference>,
    /// What could not be compared, and why.
    pub skipped: Vec<String>,
}

/// Values to be compared, real ones with an imaginary part of 0.
struct Quantity<'a> {
    name: &'a str,
    /// Shape and values, of both solvers.
    re: [&'a Variable; 2],
    im: Option<[&'a Variable; 2]>,
}

impl Quantity<'_> {
    /// Largest |a| or |b|, and largest |a − b|; None where a value of one only is finite.
    fn measure(&self) -> Option<(f64, f64)> {
        let values = |pair: &[&Variable; 2]| -> Vec<(f64, f64)> {
            pair[0].values.iter().copied().zip(pair[1].values.iter().copied()).collect()
        };
        let re = values(&self.re);
        let im = self.im.as_ref().map_or_else(|| vec![(0.0, 0.0); re.len()], values);
        let (mut largest, mut gap) = (0.0f64, 0.0f64);
        for ((a, b), (c, d)) in re.into_iter().zip(im) {
            match (a.is_finite() && c.is_finite(), b.is_finite() && d.is_finite()) {
                (true, true) => {}
                // masked by both
                (false, false) => continue,
                _ => return None,
            }
            largest = largest.max(a.hypot(c)).max(b.hypot(d));
            gap = gap.max((a - b).hypot(c - d));
        }
        Some((largest, gap))
    }
}

/// The quantities of two groups that have the same name and shape; the others go to `skipped`.
fn quantities<'a>(a: &'a Group, b: &'a Group, skipped: &mut Vec<String>) -> Vec<Quantity<'a>> {
    let mut found = Vec::new();
    let mut other = |name: &str| -> Option<[&'a Variable; 2]> {
        let first = a.get(name)?;
        let Some(second) = b.get(name) else {
            skipped.push(format!("{name}: missing in the second solution"));
            return None;
        };
        if first.values.shape() != second.values.shape() {
            let (one, two) = (first.values.shape(), second.values.shape());
            skipped.push(format!("{name}: shape {one:?} in the first solution, {two:?} in the second"));
            return None;
        }
        // a value belongs to its coordinate
        let moved = |d: &&String| a.get(d).map(|v| &v.values) != b.get(d).map(|v| &v.values);
        if let Some(dimension) = first.dims.iter().find(moved) {
            skipped.push(format!("{name}: the solutions differ in {dimension}"));
            return None;
        }
        Some([first, second])
    };
    let data = a.variables.iter().filter(|v| !v.is_coordinate() && !ASIDE.contains(&v.name.as_str()));
    for variable in data {
        let name = variable.name.as_str();
        let partner = |from: &str, to: &str| {
            let stem = name.strip_suffix(from)?;
            let partner = format!("{stem}{to}");
            a.get(&partner).map(|_| (stem, partner))
        };
        if partner("_im", "_re").is_some() {
            continue;
        }
        let Some(re) = other(name) else { continue };
        let (name, im) = match partner("_re", "_im") {
            Some((stem, partner)) => match other(&partner) {
                Some(im) => (stem, Some(im)),
                None => continue,
            },
            None => (name, None),
        };
        found.push(Quantity { name, re, im });
    }
    skipped.extend(
        b.variables
            .iter()
            .filter(|v| a.get(&v.name).is_none())
            .map(|v| format!("{}: missing in the first solution", v.name)),
    );
    found
}

/// What was measured of one quantity.
struct Measured<'a> {
    name: &'a str,
    unit: &'a str,
    dims: &'a [String],
    largest: f64,
    gap: f64,
}

/// Differences relative to the largest value of the same unit and dimensions.
fn relative_to_kind(measured: &[Measured]) -> Vec<Difference> {
    let scale = |of: &Measured| {
        let kin = measured.iter().filter(|m| m.unit == of.unit && m.dims == of.dims);
        kin.map(|m| m.largest).fold(0.0, f64::max)
    };
    measured
        .iter()
        .map(|m| Difference {
            name: m.name.to_owned(),
            absolute: m.gap,
            relative: if m.gap == 0.0 { 0.0 } else { m.gap / scale(m) },
            unit: m.unit.to_owned(),
        })
        .collect()
}

impl Comparison {
    /// Compares what two solvers left for the same study.
    ///
    /// For every dataset of the same name, shape and coordinates, and for every answer of the same key, the largest |a − b|
    /// relative to the largest value of the same unit and dimensions: an upward deflection of a nanometre beside a downward one of a
    /// millimetre is no disagreement of 100 %. Complex pairs are judged by modulus; coordinates and what tells of the
    /// computation only, such as estimates of errors, are left out.
    pub fn new(a: &Outcome, b: &Outcome) -> Self {
        let mut skipped = Vec::new();
        let mut measured = Vec::new();
        for quantity in quantities(&a.group, &b.group, &mut skipped) {
            match quantity.measure() {
                Some((largest, gap)) => {
                    let Variable { units, dims, .. } = quantity.re[0];
                    measured.push(Measured { name: quantity.name, unit: units, dims, largest, gap });
                }
                None => skipped.push(format!("{}: not finite in one of the solutions", quantity.name)),
            }
        }
        let mut answers = Vec::new();
        for one in &a.answers {
            match b.answers.iter().find(|other| other.key == one.key) {
                Some(other) if !(one.value.is_finite() && other.value.is_finite()) => {
                    skipped.push(format!("{}: not finite in one of the solutions", one.key));
                }
                Some(other) => {
                    let largest = one.value.abs().max(other.value.abs());
                    let gap = (one.value - other.value).abs();
                    answers.push(Measured { name: &one.key, unit: one.unit, dims: &[], largest, gap });
                }
                None => skipped.push(format!("{}: no such answer in the second solution", one.key)),
            }
        }
        Self { datasets: relative_to_kind(&measured), answers: relative_to_kind(&answers), skipped }
    }

    /// Nothing could be compared.
    pub fn none(reason: String) -> Self {
        Self { skipped: vec![reason], ..Self::default() }
    }

    /// The largest relative difference, of a dataset rather than of an answer.
    pub fn largest(&self) -> Option<&Difference> {
        self.datasets.iter().chain(&self.answers).reduce(|a, b| if b.relative > a.relative { b } else { a })
    }

    /// What `study` must be doubted for, answered by the solvers called `first` and `second`.
    pub fn concerns(&self, study: &str, first: &str, second: &str) -> Vec<Concern> {
        let mut concerns = Vec::new();
        if let Some(worst) = self.largest().filter(|d| d.relative > TOLERABLE) {
            concerns.push(Concern::new(
                "solvers-disagree",
                format!(
                    "{study}: {first} and {second} differ by {:.1e} in {}, relative to the largest value (limit {TOLERABLE:.0e})",
                    worst.relative, worst.name
                ),
                "ask a third solver; refine the settings of an approximate one; look for very thin layers, very little damping \
                 or a flat maximum",
            ));
        }
        if !self.skipped.is_empty() {
            concerns.push(Concern::new(
                "not-verified",
                format!("{study} by {second}: {}", self.skipped.join("; ")),
                "verify with another solver, or change the settings of this one",
            ));
        }
        concerns
    }
}

impl std::fmt::Display for Comparison {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.largest() {
            Some(worst) if worst.relative == 0.0 => write!(f, "no difference")?,
            Some(worst) => write!(f, "largest difference {:.1e} of {}", worst.relative, worst.name)?,
            None => write!(f, "nothing compared")?,
        }
        if self.skipped.is_empty() {
            Ok(())
        } else {
            write!(f, "; not compared: {}", self.skipped.join("; "))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::Answer;
    use ndarray::{ArrayD, arr1};
    use num_complex::Complex64;

    fn outcome(down: &[f64], g: Complex64, peak: f64) -> Outcome {
        let x: Vec<f64> = (0..down.len()).map(|i| i as f64).collect();
        let g = ArrayD::from_elem(vec![1], g);
        let group = Group::new("study")
            .coordinate("x", &x, "m", "position")
            .coordinate("k", &[1.0], "rad m-1", "wavenumber")
            .variable("down", &["x"], arr1(down).into_dyn(), "m", "down")
            .variable("up", &["x"], arr1(down).into_dyn() * 1e-9, "m", "up")
            .scalar("length", 1e3, "m", "of another kind than deflections")
            .variable("aliasing", &["x"], arr1(down).into_dyn(), "1", "an estimate")
            .complex("g", &["k"], &g, "m Pa-1", "compliance");
        let answers = vec![Answer::new("peak", "Peak", peak, "m", String::new())];
        Outcome { group, answers, ..Outcome::default() }
    }

    #[test]
    fn differences_are_relative_to_the_largest_of_their_kind() {
        let (a, b) = (Complex64::new(3.0, 4.0), Complex64::new(3.0, 4.5));
        let (mut one, two) = (outcome(&[1.0, -2.0], a, 2.0), outcome(&[1.0, -2.002], b, 2.0));
        let comparison = Comparison::new(&one, &two);
        let of: Vec<(&str, f64)> =
            comparison.datasets.iter().map(|d| (d.name.as_str(), d.relative)).collect();
        assert_eq!(of.iter().map(|d| d.0).collect::<Vec<_>>(), ["down", "up", "length", "g"]);
        assert!((of[0].1 - 0.002 / 2.002).abs() < 1e-12 && of[1].1 < 1e-11);
        assert!((of[3].1 - 0.5 / b.norm()).abs() < 1e-12);
        assert_eq!(comparison.answers[0].relative, 0.0);
        assert_eq!(comparison.largest().unwrap().name, "g");
        assert_eq!(comparison.concerns("study", "one", "two")[0].code, "solvers-disagree");
        // against itself nothing differs, whatever it holds
        one.group.variables[2].values[[0]] = f64::NAN;
        let itself = Comparison::new(&one, &one);
        assert!(
            itself.largest().unwrap().relative == 0.0 && itself.concerns("study", "one", "two").is_empty()
        );
    }

    #[test]
    fn what_cannot_be_compared_is_told() {
        let one = Complex64::ONE;
        let (mut a, b) = (outcome(&[1.0, 2.0], one, 1.0), outcome(&[1.0, 2.0, 3.0], one, f64::NAN));
        a.answers.push(Answer::new("more", "More", 0.0, "1", String::new()));
        let comparison = Comparison::new(&a, &b);
        assert_eq!(comparison.datasets.len(), 2);
        for part in
            ["down: shape [2] in the first solution, [3]", "up: shape", "peak: not finite", "more: no such"]
        {
            assert!(
                comparison.skipped.iter().any(|s| s.starts_with(part)),
                "{part}: {:?}",
                comparison.skipped
            );
        }
        assert_eq!(comparison.concerns("study", "one", "two")[0].code, "not-verified");
        // the same length at other places, and masked in one only
        let mut moved = a.clone();
        moved.group.variables[0].values[[1]] = 7.0;
        assert!(Comparison::new(&a, &moved).skipped[0].contains("differ in x"));
        let mut masked = a.clone();
        masked.group.variables[2].values[[1]] = f64::NAN;
        assert!(Comparison::new(&a, &masked).skipped[0].contains("not finite"));
        assert_eq!(Comparison::default().to_string(), "nothing compared");
    }
}
