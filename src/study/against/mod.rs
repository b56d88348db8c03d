//! What did a change do? The results of one case against those of another.

mod shown;

use super::comparison::Comparison;
use super::{Answer, Outcome};
use crate::dataset::{Group, Variable};
use ndarray::Array2;

/// One number of one of the two.
#[derive(Clone, Debug, PartialEq)]
pub struct Told {
    /// Key in `summary.json`.
    pub key: String,
    /// What it is, in words; the key where nothing else is known.
    pub what: String,
    /// SI
    pub value: f64,
    /// SI unit.
    pub unit: String,
}

impl From<&Answer> for Told {
    fn from(answer: &Answer) -> Self {
        let Answer { key, what, value, unit, .. } = answer.clone();
        Self { key, what, value, unit: unit.to_owned() }
    }
}

/// What one study left.
#[derive(Clone, Debug, PartialEq)]
pub struct Left {
    /// Its name.
    pub study: String,
    /// Its arrays.
    pub group: Group,
    /// Its answers.
    pub answers: Vec<Told>,
}

/// What one case left.
#[derive(Clone, Debug, PartialEq)]
pub struct Results {
    /// Title of the case.
    pub title: String,
    /// Study after study.
    pub studies: Vec<Left>,
}

/// One answer of both.
#[derive(Clone, Debug, PartialEq)]
pub struct AnswerChange {
    /// Whose.
    pub study: String,
    /// As the first has it.
    pub of: Told,
    /// Value of the second.
    pub second: f64,
}

/// One curve of both.
#[derive(Clone, Debug, PartialEq)]
pub struct CurveChange {
    /// Whose.
    pub study: String,
    /// As the first has it: name, dimensions, units, values.
    pub first: Variable,
    /// As the second has it, of the same shape and coordinates.
    pub second: Variable,
    /// The coordinates of its dimensions.
    pub coordinates: Vec<Variable>,
}

/// D = 20 lg(v_A/v_B) [dB] of third octaves of the free field.
#[derive(Clone, Debug, PartialEq)]
pub struct InsertionLoss {
    /// [m]
    pub receivers: Vec<f64>,
    /// Exact centres [Hz].
    pub bands: Vec<f64>,
    /// Receivers × bands; NaN where one of the two is zero.
    pub bandwise: Array2<f64>,
    /// Of all bands together, for each receiver.
    pub overall: Vec<f64>,
}

/// The results of `second` against those of `first`.
#[derive(Clone, Debug, PartialEq)]
pub struct Against {
    /// Titles of the two.
    pub titles: [String; 2],
    /// Answers that both have.
    pub answers: Vec<AnswerChange>,
    /// Curves that both have.
    pub curves: Vec<CurveChange>,
    /// Of the free field, where both have one at the same receivers and bands.
    pub insertion_loss: Option<InsertionLoss>,
    /// Largest differences, study by study.
    pub largest: Vec<(String, Comparison)>,
    /// What one of them alone has.
    pub skipped: Vec<String>,
}

impl Against {
    /// What `second` is against `first`.
    pub fn new(first: &Results, second: &Results) -> Self {
        let mut against = Self {
            titles: [first.title.clone(), second.title.clone()],
            answers: Vec::new(),
            curves: Vec::new(),
            insertion_loss: None,
            largest: Vec::new(),
            skipped: Vec::new(),
        };
        for a in &first.studies {
            match second.studies.iter().find(|b| b.study == a.study) {
                Some(b) => against.add(a, b),
                None => against.skipped.push(format!("{}: missing in the second case", a.study)),
            }
        }
        let only = second.studies.iter().filter(|b| first.studies.iter().all(|a| a.study != b.study));
        against.skipped.extend(only.map(|b| format!("{}: missing in the first case", b.study)));
        against
    }

    fn add(&mut self, a: &Left, b: &Left) {
        for of in &a.answers {
            match b.answers.iter().find(|other| other.key == of.key) {
                Some(other) => self.answers.push(AnswerChange {
                    study: a.study.clone(),
                    of: of.clone(),
                    second: other.value,
                }),
                None => self.skipped.push(format!("{}: no answer {} in the second case", a.study, of.key)),
            }
        }
        let only = b.answers.iter().filter(|other| a.answers.iter().all(|of| of.key != other.key));
        self.skipped.extend(only.map(|o| format!("{}: no answer {} in the first case", b.study, o.key)));
        let outcome = |group: &Group| Outcome { group: group.clone(), ..Outcome::default() };
        let comparison = Comparison::new(&outcome(&a.group), &outcome(&b.group));
        self.skipped.extend(comparison.skipped.iter().map(|s| format!("{}: {s}", a.study)));
        self.largest.push((a.study.clone(), comparison));
        for one in a.group.variables.iter().filter(|v| !v.is_coordinate() && !v.dims.is_empty()) {
            if let Some(curve) = curve(a, b, one) {
                self.curves.push(curve);
            }
        }
        if a.study == "free_field" {
            self.insertion_loss = insertion_loss(&a.group, &b.group);
        }
    }
}

/// The curve `first` of `a` with that of `b`, where it has the same shape over the same coordinates.
fn curve(a: &Left, b: &Left, first: &Variable) -> Option<CurveChange> {
    let second = b.group.get(&first.name).filter(|s| s.values.shape() == first.values.shape())?;
    let coordinates: Vec<Variable> = first.dims.iter().filter_map(|d| a.group.get(d)).cloned().collect();
    let same = |c: &Variable| b.group.get(&c.name).is_some_and(|other| other.values == c.values);
    let whole = coordinates.len() == first.dims.len() && coordinates.iter().all(same);
    whole.then(|| CurveChange {
        study: a.study.clone(),
        first: first.clone(),
        second: second.clone(),
        coordinates,
    })
}

fn insertion_loss(a: &Group, b: &Group) -> Option<InsertionLoss> {
    let of = |group: &Group| {
        let v = group.get("v_rms_total")?.values.clone().into_dimensionality::<ndarray::Ix2>().ok()?;
        Some((v, group.get("receiver")?.to_vec(), group.get("band")?.to_vec()))
    };
    let ((v_a, receivers, bands), (v_b, other_receivers, other_bands)) = (of(a)?, of(b)?);
    if receivers != other_receivers || bands != other_bands {
        return None;
    }
    let loss = |a: f64, b: f64| if a > 0.0 && b > 0.0 { 20.0 * (a / b).log10() } else { f64::NAN };
    let all = |v: &Array2<f64>, r: usize| v.row(r).iter().map(|v| v * v).sum::<f64>().sqrt();
    Some(InsertionLoss {
        bandwise: Array2::from_shape_fn(v_a.dim(), |at| loss(v_a[at], v_b[at])),
        overall: (0..receivers.len()).map(|r| loss(all(&v_a, r), all(&v_b, r))).collect(),
        receivers,
        bands,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use ndarray::arr2;

    fn results(scale: f64) -> Results {
        let group = Group::new("free_field")
            .coordinate("receiver", &[8.0, 16.0], "m", "distance")
            .coordinate("band", &[10.0, 12.589, 15.849], "Hz", "centre")
            .variable(
                "v_rms_total",
                &["receiver", "band"],
                arr2(&[[1e-3, 2e-3, 0.0], [4e-4, 5e-4, 6e-4]]).into_dyn() * scale,
                "m s-1",
                "both",
            );
        let told = |key: &str, value| Told { key: key.into(), what: key.into(), value, unit: "m/s".into() };
        let answers = vec![told("v_rms_8", 1e-3 * scale), told("v_rms_16", 2e-4 * scale)];
        Results { title: "x".into(), studies: vec![Left { study: "free_field".into(), group, answers }] }
    }

    #[test]
    fn a_case_against_itself_is_nothing() {
        let against = Against::new(&results(1.0), &results(1.0));
        assert!(against.skipped.is_empty());
        assert!(against.answers.len() == 2 && against.answers.iter().all(|c| c.second == c.of.value));
        let loss = against.insertion_loss.as_ref().unwrap();
        assert_eq!(loss.overall, [0.0, 0.0]);
        assert!(loss.bandwise.iter().all(|d| *d == 0.0 || d.is_nan()));
        assert!(against.largest.iter().all(|(_, c)| c.largest().unwrap().relative == 0.0));
        let outcome = against.shown();
        let differences = outcome.group.variables.iter().filter(|v| v.name.ends_with("_difference"));
        assert!(differences.flat_map(|v| v.values.iter()).all(|v| *v == 0.0));
        assert!(outcome.answers.iter().all(|a| a.value == 0.0));
    }

    #[test]
    fn half_the_velocity_is_a_loss_of_six_decibels() {
        let against = Against::new(&results(1.0), &results(0.5));
        let loss = against.insertion_loss.as_ref().unwrap();
        // 20 lg 2 = 6.0206
        assert!(loss.overall.iter().all(|d| (d - 6.0206).abs() < 1e-4));
        assert!((loss.bandwise[(1, 2)] - 6.0206).abs() < 1e-4 && loss.bandwise[(0, 2)].is_nan());
        let outcome = against.shown();
        let of = |key: &str| outcome.answers.iter().find(|a| a.key == key).unwrap();
        assert!((of("free_field_v_rms_8").value + 5e-4).abs() < 1e-18);
        assert!(of("free_field_v_rms_8").shown.contains("-50"), "{}", of("free_field_v_rms_8").shown);
    }

    #[test]
    fn what_one_of_them_lacks_is_told() {
        let (mut a, mut b) = (results(1.0), results(1.0));
        a.studies[0].answers.pop();
        b.studies[0].group.variables[0].values[[1]] = 20.0;
        let mut more = b.studies[0].clone();
        more.study = "contour".into();
        b.studies.push(more);
        let against = Against::new(&a, &b);
        assert!(against.insertion_loss.is_none() && against.curves.is_empty());
        for said in ["no answer v_rms_16 in the first", "differ in receiver", "contour: missing in the first"]
        {
            assert!(against.skipped.iter().any(|s| s.contains(said)), "{said}: {:?}", against.skipped);
        }
        assert_eq!(against.shown().concerns[0].code, "not-compared");
    }
}
