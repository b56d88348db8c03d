//! All rows of a study in memory: a column of every number over the samples.

use super::chunk::Chunk;
use super::error::EnsembleError;
use super::row::{Described, Row};
use super::rows::{Kind, Rows};
use ndarray::Array2;
use std::collections::BTreeMap;

/// Answers of one row [SI].
pub type Answers = BTreeMap<String, f64>;

/// A curve of every sample.
#[derive(Clone, Debug, PartialEq)]
pub struct Curves {
    /// Its coordinate: name and values.
    pub over: (String, Vec<f64>),
    /// What it is.
    pub described: Described,
    /// What its coordinate is.
    pub coordinate: Described,
    /// (sample, coordinate), NaN where a sample has none.
    pub values: Array2<f64>,
}

/// What all chunks hold.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// Numbers that vary, of every sample.
    pub values: Vec<Vec<f64>>,
    /// Samples without answers, and why.
    pub refused: Vec<(usize, String)>,
    /// Answers of all samples, NaN where one has none, and their units.
    pub answers: BTreeMap<String, (String, Vec<f64>)>,
    /// Curves by `<study>/<name>`.
    pub curves: BTreeMap<String, Curves>,
    /// How many samples have a concern, by its code.
    pub concerns: BTreeMap<String, usize>,
    /// Answers of the case as it stands, or why there are none.
    pub central: Result<Answers, String>,
    /// Answers of a step down and a step up of each parameter.
    pub steps: Vec<[Answers; 2]>,
}

impl Table {
    /// From the `chunks` in their order, one after another.
    ///
    /// # Errors
    /// Those of the chunks.
    pub(super) fn gather(
        rows: &Rows,
        chunks: impl Iterator<Item = Result<Chunk, EnsembleError>>,
    ) -> Result<Self, EnsembleError> {
        let mut table = Self {
            values: vec![Vec::new(); rows.samples],
            refused: Vec::new(),
            answers: BTreeMap::new(),
            curves: BTreeMap::new(),
            concerns: BTreeMap::new(),
            central: Err(String::new()),
            steps: vec![[Answers::new(), Answers::new()]; rows.parameters],
        };
        for chunk in chunks {
            let Chunk { described, rows: done, .. } = chunk?;
            for row in done {
                table.take(row, rows, &described);
            }
        }
        Ok(table)
    }

    fn take(&mut self, row: Row, rows: &Rows, described: &BTreeMap<String, Described>) {
        let some = |answers: BTreeMap<String, Option<f64>>| {
            answers.into_iter().filter_map(|(key, value)| Some((key, value?))).collect::<Answers>()
        };
        match rows.kind(row.number) {
            Kind::Sample(i) => self.sample(i, row, described),
            Kind::Central => self.central = row.refused.map_or(Ok(some(row.answers)), Err),
            Kind::Step { parameter, up } => self.steps[parameter][usize::from(up)] = some(row.answers),
        }
    }

    fn sample(&mut self, i: usize, row: Row, described: &BTreeMap<String, Described>) {
        let samples = self.values.len();
        self.values[i] = row.values;
        self.refused.extend(row.refused.map(|reason| (i, reason)));
        let mut codes = row.concerns;
        codes.sort_unstable();
        codes.dedup();
        codes.into_iter().for_each(|code| *self.concerns.entry(code).or_default() += 1);
        for (key, value) in row.answers {
            let unit = || described.get(&key).map(|of| of.unit.clone()).unwrap_or_default();
            let column = self.answers.entry(key.clone()).or_insert_with(|| (unit(), vec![f64::NAN; samples]));
            column.1[i] = value.unwrap_or(f64::NAN);
        }
        let gaps =
            |values: &[Option<f64>]| values.iter().map(|v| v.unwrap_or(f64::NAN)).collect::<Vec<f64>>();
        for (name, values) in &row.curves {
            let Some(of) = described.get(name) else { continue };
            let Some(over) = of.over.as_ref().filter(|over| *over != name) else { continue };
            let (Some(at), Some(coordinate)) = (row.curves.get(over), described.get(over)) else { continue };
            let (at, values) = (gaps(at), gaps(values));
            let curves = self.curves.entry(name.clone()).or_insert_with(|| Curves {
                values: Array2::from_elem((samples, at.len()), f64::NAN),
                over: (over.clone(), at.clone()),
                described: of.clone(),
                coordinate: coordinate.clone(),
            });
            // a sample with other abscissae has no place beside the others
            if curves.over.1 == at {
                curves.values.row_mut(i).iter_mut().zip(values).for_each(|(place, value)| *place = value);
            }
        }
    }

    /// Values of `answer` of the samples that have one, with their numbers.
    pub fn of(&self, answer: &str) -> Vec<(usize, f64)> {
        let column = self.answers.get(answer).map_or(&[][..], |(_, values)| values);
        column.iter().copied().enumerate().filter(|(_, value)| value.is_finite()).collect()
    }
}
