//! `[study]` checked: which numbers of a case vary, and the case of every sample.

use super::distribution::{distribution, refused};
use super::error::{CaseError, Finding, spelling};
use super::key_path;
use super::keys;
use super::loader::Loader;
use super::study_table::{CorrelationInput, ProfileInput, StudyInput, VaryInput};
use super::values::Named;
use crate::sampling::{Correlation, Design, Distribution, Likeness, SamplingMethod};
use std::collections::{BTreeMap, BTreeSet};
use toml::{Table, Value};

/// A number that varies.
#[derive(Clone, Debug)]
pub struct Varied {
    /// Path of its key.
    pub key: String,
    /// SI unit, empty of a plain number.
    pub unit: &'static str,
    /// What stands in the case [SI].
    pub stands: f64,
    /// Of the number, or of the factor on it.
    distribution: Distribution,
    factor: bool,
}

impl Varied {
    /// Its value [SI] at the probability `p`.
    pub fn quantile(&self, p: f64) -> f64 {
        let drawn = self.distribution.quantile(p);
        if self.factor { drawn * self.stands } else { drawn }
    }

    /// Its distribution in words.
    pub fn text(&self) -> String {
        if self.factor { format!("factor: {}", self.distribution) } else { self.distribution.to_string() }
    }
}

/// A number of ground or track by which answers are derived.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Path of its key.
    pub key: String,
    /// SI unit, empty of a plain number.
    pub unit: &'static str,
    /// What stands in the case [SI].
    pub stands: f64,
}

/// What of a case is uncertain.
#[derive(Clone, Debug)]
pub struct Uncertain {
    /// Which samples are taken.
    pub design: Design,
    /// What varies.
    pub varied: Vec<Varied>,
    /// By what answers are derived; empty where that is not asked.
    pub parameters: Vec<Parameter>,
    /// The case without `[study]`, its named ground and track written out.
    case: Value,
    /// The same with shear wave speeds instead of moduli: derivatives by density leave them as they are.
    by_speeds: Value,
}

impl Uncertain {
    /// The numbers that vary [SI], of sample `i`, counted from 0.
    pub fn values(&self, i: usize) -> Vec<f64> {
        let probabilities = self.design.probabilities(i);
        self.varied.iter().zip(probabilities).map(|(varied, p)| varied.quantile(p)).collect()
    }

    /// The case of a sample with the `values` of all that varies.
    pub fn text(&self, values: &[f64]) -> String {
        with(&self.case, self.varied.iter().map(|varied| varied.key.as_str()).zip(values.iter().copied()))
    }

    /// The case with number `k` of the parameters times `factor`.
    pub fn scaled(&self, k: usize, factor: f64) -> String {
        let Parameter { key, stands, .. } = &self.parameters[k];
        with(&self.by_speeds, [(key.as_str(), factor * stands)].into_iter())
    }
}

/// The text of `case` with numbers put in at their paths.
fn with<'a>(case: &Value, numbers: impl Iterator<Item = (&'a str, f64)>) -> String {
    let mut case = case.clone();
    for (path, number) in numbers {
        if let Some(place) = key_path::at(&mut case, path) {
            *place = Value::Float(number);
        }
    }
    // a value would be written as an inline table
    case.as_table().map(Table::to_string).unwrap_or_default()
}

/// The unit of the number at `path`.
fn unit(path: &str) -> &'static str {
    keys::unit(path).map_or("", |unit| unit.name)
}

impl Loader<'_> {
    /// The case with its named ground and track in their places, without `[study]`.
    fn written_out(&self) -> Result<Value, CaseError> {
        let mut case: Table = self.read.parse().unwrap_or_default();
        case.remove("study");
        for (key, shelf) in [("soil", "soils"), ("track", "tracks")] {
            let (name, own) = match case.get(key) {
                Some(Value::String(name)) => (name.clone(), Table::new()),
                Some(Value::Table(table)) => match table.get("library") {
                    Some(Value::String(name)) => (name.clone(), table.clone()),
                    _ => continue,
                },
                _ => continue,
            };
            let mut table = self.resolve::<Table>(&Named::Name(name), key, shelf)?.table;
            table.remove("title");
            table.remove("source");
            table.extend(own.into_iter().filter(|(own, _)| own != "library"));
            case.insert(key.to_owned(), Value::Table(table));
        }
        Ok(Value::Table(case))
    }

    /// `[study]` as the rest of the program goes by it.
    ///
    /// # Errors
    /// Every key that is not there, distribution that cannot be, correlation of what does not vary.
    pub fn uncertain(&self, input: &StudyInput) -> Result<Uncertain, CaseError> {
        let mut case = self.written_out()?;
        let mut by_speeds = case.clone();
        layers(&mut by_speeds).into_iter().for_each(|layer| by_shear_speed(&mut by_speeds, &layer));
        let profile = input.shear_speed_profile.is_some();
        for layer in layers(&mut case) {
            let key = format!("{layer}.shear_speed");
            if profile || input.vary.iter().any(|vary| key_path::meant(&vary.key, &case) == key) {
                by_shear_speed(&mut case, &layer);
            }
        }
        let numbers = key_path::numbers(&case);
        let could: BTreeSet<String> =
            numbers.keys().cloned().chain(key_path::numbers(&by_speeds).into_keys()).collect();
        let faults =
            |faults: Vec<Finding>| CaseError::all(faults.into_iter().map(|f| self.fault(f)), self.name);
        let mut varied = varied(input, &case, (&numbers, &could)).map_err(faults)?;
        let mut pairs = Vec::new();
        if let Some(profile) = &input.shear_speed_profile {
            let (speeds, likeness) = speeds(profile, &numbers).map_err(|f| self.fault(f))?;
            let first = varied.len();
            pairs.extend(likeness.into_iter().map(|(i, j, rho)| (first + i, first + j, rho)));
            varied.extend(speeds);
        }
        let correlated = |f| self.fault(f);
        pairs.extend(correlations(input, &case, &varied).map_err(correlated)?);
        let design = design(input, &varied, &pairs).map_err(|f| self.fault(f))?;
        let parameters = if input.derivatives == Some(false) { Vec::new() } else { parameters(&by_speeds) };
        Ok(Uncertain { design, varied, parameters, case, by_speeds })
    }
}

/// Paths of all materials of the ground.
fn layers(case: &mut Value) -> Vec<String> {
    let count = key_path::at(case, "soil.layer").and_then(|list| list.as_array()).map_or(0, Vec::len);
    let half_space = key_path::at(case, "soil.half_space").map(|_| "soil.half_space".to_owned());
    (0..count).map(|i| format!("soil.layer[{i}]")).chain(half_space).collect()
}

/// The layer at `path` with c_s = √(E/(2(1 + ν)ρ)) instead of E, where it has that.
fn by_shear_speed(case: &mut Value, path: &str) {
    let numbers = key_path::numbers(case);
    let of = |key: &str| numbers.get(&format!("{path}.{key}")).copied();
    let (Some(young), Some(poisson), Some(density)) = (of("young"), of("poisson"), of("density")) else {
        return;
    };
    if let Some(Value::Table(layer)) = key_path::at(case, path) {
        layer.remove("young");
        layer.insert("shear_speed".into(), Value::Float((young / (2.0 * (1.0 + poisson) * density)).sqrt()));
    }
}

/// `[[study.vary]]`, each at one of the `numbers` of the case; messages name what `could` vary.
fn varied(
    input: &StudyInput,
    case: &Value,
    (numbers, could): (&BTreeMap<String, f64>, &BTreeSet<String>),
) -> Result<Vec<Varied>, Vec<Finding>> {
    let mut taken = BTreeSet::new();
    let one = |(i, vary): (usize, &VaryInput)| {
        let (path, key) = (format!("study.vary[{i}]"), key_path::meant(&vary.key, case));
        let at = format!("{path}.key");
        let (Some(stands), Some(unit)) = (numbers.get(&key), keys::unit(&key)) else {
            let same = |other: &&str| other.split(['.', '[']).next() == key.split(['.', '[']).next();
            let all: Vec<&str> = could.iter().map(String::as_str).collect();
            let near: Vec<&str> = all.iter().copied().filter(|other| same(other)).collect();
            let help = spelling(&key, if near.is_empty() { &all } else { &near });
            return Err(Finding::new(at, format!("the case has no number at `{}`", vary.key)).help(help));
        };
        if !taken.insert(key.clone()) {
            return Err(Finding::new(at, format!("`{key}` varies twice")).help("remove one of both"));
        }
        if vary.points.is_some() && input.method != Some(SamplingMethod::Grid) {
            let finding = Finding::new(format!("{path}.points"), "points belong to a grid");
            return Err(finding.help("remove the key, or choose method = \"grid\""));
        }
        let distribution = distribution(vary, unit, &path)?;
        Ok(Varied { key, unit: unit.name, stands: *stands, distribution, factor: vary.factor })
    };
    let (mut found, mut faults) = (Vec::new(), Vec::new());
    for one in input.vary.iter().enumerate().map(one) {
        match one {
            Ok(varied) => found.push(varied),
            Err(fault) => faults.push(fault),
        }
    }
    if faults.is_empty() { Ok(found) } else { Err(faults) }
}

/// Speeds of all layers and of the half-space, and how like they are, two by two.
type Profile = (Vec<Varied>, Vec<(usize, usize, f64)>);

/// `[study.shear_speed_profile]`: the middle of a layer stands for it, its surface for the half-space.
fn speeds(input: &ProfileInput, numbers: &BTreeMap<String, f64>) -> Result<Profile, Finding> {
    const PATH: &str = "study.shear_speed_profile";
    let lacking = |what: &str| {
        Finding::new(PATH, format!("{what} is missing"))
            .help(format!("add {what}, or site with what is published"))
    };
    let sigma = input.sigma_ln.or(input.site.map(|site| site.sigma())).ok_or_else(|| lacking("sigma_ln"))?;
    let likeness = match (input.correlation_length, input.site) {
        (Some(length), _) => {
            let length = crate::quantity::positive("correlation_length", length, "m");
            Likeness::Length(length.map_err(|e| Finding::out_of_range(PATH, e))?)
        }
        (None, Some(site)) => Likeness::Toro(site),
        (None, None) => return Err(lacking("correlation_length")),
    };
    let (mut depths, mut speeds, mut top) = (Vec::new(), Vec::new(), 0.0);
    let half_space = "soil.half_space".to_owned();
    let layers = (0..)
        .map(|i| format!("soil.layer[{i}]"))
        .take_while(|layer| numbers.contains_key(&format!("{layer}.density")));
    for layer in layers.chain([half_space]) {
        let Some(stands) = numbers.get(&format!("{layer}.shear_speed")) else { continue };
        let thickness = numbers.get(&format!("{layer}.thickness")).copied().unwrap_or(0.0);
        depths.push(top + 0.5 * thickness);
        top += thickness;
        let distribution = Distribution::lognormal(1.0, sigma).and_then(|whole| {
            let end = |sign: f64| input.limit.map(|limit| (sign * limit * sigma).exp());
            whole.truncated(end(-1.0), end(1.0))
        });
        let distribution = distribution.map_err(|error| refused(PATH, error))?;
        speeds.push(Varied {
            key: format!("{layer}.shear_speed"),
            unit: "m/s",
            stands: *stands,
            distribution,
            factor: true,
        });
    }
    if speeds.is_empty() {
        return Err(Finding::new(PATH, "the case has no layered ground").help("remove it, or add [soil]"));
    }
    Ok((speeds, likeness.pairs(&depths)))
}

/// `[[study.correlation]]` by the places of its keys.
fn correlations(
    input: &StudyInput,
    case: &Value,
    varied: &[Varied],
) -> Result<Vec<(usize, usize, f64)>, Finding> {
    let names: Vec<&str> = varied.iter().map(|varied| varied.key.as_str()).collect();
    let one = |(i, of): (usize, &CorrelationInput)| {
        let path = format!("study.correlation[{i}]");
        let [a, b] = of.keys.as_slice() else {
            let message = format!("{} keys: a correlation is of two", of.keys.len());
            return Err(
                Finding::new(format!("{path}.keys"), message).help("give one table for every two keys")
            );
        };
        let place = |k: usize, written: &str| {
            let key = key_path::meant(written, case);
            let found = names.iter().position(|name| *name == key);
            found.ok_or_else(|| {
                let finding = Finding::new(format!("{path}.keys[{k}]"), format!("`{written}` does not vary"));
                finding.help(spelling(&key, &names))
            })
        };
        let (first, second) = (place(0, a)?, place(1, b)?);
        if first == second {
            return Err(Finding::new(format!("{path}.keys"), "a number and itself").help("name two keys"));
        }
        crate::quantity::between("value", of.value, "", (-1.0, 1.0))
            .map_err(|e| Finding::out_of_range(&path, e))?;
        Ok((first, second, of.value))
    };
    input.correlation.iter().enumerate().map(one).collect()
}

/// Which samples are taken.
fn design(input: &StudyInput, varied: &[Varied], pairs: &[(usize, usize, f64)]) -> Result<Design, Finding> {
    if varied.is_empty() {
        let help = "add [[study.vary]] with key, kind and its parameters, or [study.shear_speed_profile]";
        return Err(Finding::new("study", "nothing varies").help(help));
    }
    let keys: Vec<String> = varied.iter().map(|varied| varied.key.clone()).collect();
    let method = input.method.unwrap_or_default();
    if !matches!(method, SamplingMethod::Grid | SamplingMethod::OneAtATime) {
        let Some(samples) = input.samples else {
            return Err(Finding::new("study", "missing key `samples`")
                .help("add `samples = 1000`")
                .lacking("samples"));
        };
        let correlation =
            Correlation::new(keys.len(), pairs).map_err(|error| refused("study.correlation", error))?;
        let design = Design::random(method, (samples, input.seed.unwrap_or(1)), keys, correlation);
        return design.map_err(|error| refused("study.samples", error));
    }
    let given = [
        ("samples", input.samples.is_some()),
        ("seed", input.seed.is_some()),
        ("correlation", !input.correlation.is_empty()),
        ("shear_speed_profile", input.shear_speed_profile.is_some()),
    ];
    if let Some((key, _)) = given.iter().find(|(_, given)| *given) {
        let finding = Finding::new(
            format!("study.{key}"),
            "this method draws nothing: it counts its samples by itself",
        );
        return Err(finding.help("remove the key, or choose method = \"latin-hypercube\""));
    }
    let points = |i: usize| input.vary.get(i).and_then(|vary| vary.points).unwrap_or(3);
    let levels =
        || varied.iter().enumerate().map(|(i, varied)| varied.distribution.levels(points(i))).collect();
    let design = match method {
        SamplingMethod::Grid => Design::grid(keys, levels()),
        _ => Design::one_at_a_time(keys),
    };
    design.map_err(|error| refused("study", error))
}

/// Every number of ground and track that is not zero; not Poisson's ratio, whose range is narrow.
fn parameters(case: &Value) -> Vec<Parameter> {
    let is_one = |key: &str| {
        let root = ["soil.layer[", "soil.half_space.", "foundation.", "track."];
        root.iter().any(|root| key.starts_with(root)) && !key.ends_with(".poisson")
    };
    let numbers = key_path::numbers(case).into_iter();
    let ours = numbers.filter(|(key, stands)| is_one(key) && *stands != 0.0);
    ours.map(|(key, stands)| Parameter { unit: unit(&key), key, stands }).collect()
}
