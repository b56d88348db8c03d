//! What a study runs: its samples, then the case as it stands, then a step down and a step up of every parameter.

use crate::case::Uncertain;
use std::ops::Range;

/// Rows of one chunk: seconds of work, kilobytes of file.
pub const CHUNK: usize = 25;

/// Relative step of a parameter to either side: wide enough for a critical speed that is found to 0.1 m/s.
pub const STEP: f64 = 0.05;

/// What one row is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Sample number, from 0.
    Sample(usize),
    /// The case as it stands.
    Central,
    /// Parameter number times 1 − [`STEP`], or 1 + [`STEP`].
    Step {
        /// Number of the parameter.
        parameter: usize,
        /// Whether it is the larger one.
        up: bool,
    },
}

/// All rows of a study, in their order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rows {
    /// How many samples.
    pub samples: usize,
    /// By how many parameters answers are derived.
    pub parameters: usize,
}

impl Rows {
    /// Those of `study`.
    pub fn of(study: &Uncertain) -> Self {
        Self { samples: study.design.samples(), parameters: study.parameters.len() }
    }

    /// How many.
    pub fn count(&self) -> usize {
        self.samples + 1 + 2 * self.parameters
    }

    /// What row `number` is.
    pub fn kind(&self, number: usize) -> Kind {
        match number.checked_sub(self.samples) {
            None => Kind::Sample(number),
            Some(0) => Kind::Central,
            Some(step) => Kind::Step { parameter: (step - 1) / 2, up: (step - 1) % 2 == 1 },
        }
    }

    /// How many chunks they fill.
    pub fn chunks(&self) -> usize {
        self.count().div_ceil(CHUNK)
    }

    /// The rows of a chunk.
    pub fn of_chunk(&self, chunk: usize) -> Range<usize> {
        chunk * CHUNK..((chunk + 1) * CHUNK).min(self.count())
    }

    /// Values of all that varies, and the case, of row `number`.
    pub(super) fn case_of(&self, number: usize, study: &Uncertain) -> (Vec<f64>, String) {
        match self.kind(number) {
            Kind::Sample(i) => {
                let values = study.values(i);
                let text = study.text(&values);
                (values, text)
            }
            Kind::Central => {
                let values: Vec<f64> = study.varied.iter().map(|varied| varied.stands).collect();
                let text = study.text(&values);
                (values, text)
            }
            Kind::Step { parameter, up } => {
                (Vec::new(), study.scaled(parameter, if up { 1.0 + STEP } else { 1.0 - STEP }))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_row_has_its_place() {
        let rows = Rows { samples: 40, parameters: 6 };
        assert_eq!((rows.count(), rows.chunks()), (53, 3));
        assert_eq!([rows.kind(39), rows.kind(40)], [Kind::Sample(39), Kind::Central]);
        assert_eq!(rows.kind(41), Kind::Step { parameter: 0, up: false });
        assert_eq!(rows.kind(52), Kind::Step { parameter: 5, up: true });
        let all: Vec<usize> = (0..3).flat_map(|chunk| rows.of_chunk(chunk)).collect();
        assert_eq!(all, (0..53).collect::<Vec<_>>());
    }
}
