//! What the histories of a pass are to people and to standards.

use crate::assessment::{
    Averaging, Weighting, kb_f, kb_f_maximum, maximum_running_rms, peak_velocity, vibration_dose,
};
use crate::field::Times;
use crate::signal::{History, SignalError};
use ndarray::Array2;
use rayon::prelude::*;

/// One measure of a velocity history.
pub struct Measure {
    /// Name of the variable.
    pub key: &'static str,
    /// Symbol.
    pub symbol: &'static str,
    pub units: &'static str,
    pub what: &'static str,
    of: fn(&History) -> f64,
}

/// Three digits of `value`, with a power of ten where it is small.
pub fn significant(value: f64) -> String {
    match value.abs() {
        0.0 => "0".into(),
        size if size < 1e-4 => format!("{value:.2e}"),
        size => format!("{value:.*}", (2 - size.log10().floor() as i32).max(0) as usize),
    }
}

impl Measure {
    /// A value of it in units a reader expects, as text without unit.
    pub fn number(&self, value: f64) -> String {
        significant(if self.units == "m s-1" { 1e3 * value } else { value })
    }

    /// The same with its unit.
    pub fn shown(&self, value: f64) -> String {
        match self.unit() {
            "m/s" => format!("{} mm/s", self.number(value)),
            "1" => self.number(value),
            unit => format!("{} {unit}", self.number(value)),
        }
    }

    /// Unit as readers write it.
    pub fn unit(&self) -> &'static str {
        match self.units {
            "m s-1" => "m/s",
            "m s-2" => "m/s²",
            "m/s^(7/4)" => "m/s^1.75",
            "m2 s-1" => "m²/s",
            _ => "1",
        }
    }
}

// places in MEASURES
pub const PEAK_VELOCITY: usize = 0;
pub const V_SLOW_MAXIMUM: usize = 2;
pub const KB_F_MAXIMUM: usize = 3;
pub const VDV: usize = 5;
/// Those a reader is told; the others are in the files.
pub const TOLD: [usize; 4] = [PEAK_VELOCITY, V_SLOW_MAXIMUM, KB_F_MAXIMUM, VDV];

/// The measures, all of the vertical velocity of the ground's surface.
pub const MEASURES: [Measure; 7] = [
    Measure {
        key: "peak_velocity",
        symbol: "PPV",
        units: "m s-1",
        what: "peak particle velocity, vertical, unweighted",
        of: peak_velocity,
    },
    Measure {
        key: "v_fast_maximum",
        symbol: "v_F,max",
        units: "m s-1",
        what: "largest running r.m.s. velocity, FAST (0.125 s), unweighted",
        of: |v| maximum_running_rms(v, Averaging::Fast),
    },
    Measure {
        key: "v_slow_maximum",
        symbol: "v_S,max",
        units: "m s-1",
        what: "largest running r.m.s. velocity, SLOW (1 s), unweighted",
        of: |v| maximum_running_rms(v, Averaging::Slow),
    },
    Measure {
        key: "kb_f_maximum",
        symbol: "KB_Fmax",
        units: "1",
        what: "largest KB_F(t), DIN 45669-1, FAST",
        of: kb_f_maximum,
    },
    Measure {
        key: "a_wm_slow_maximum",
        symbol: "a_w,max",
        units: "m s-2",
        what: "largest running r.m.s. acceleration, W_m of ISO 2631-2, SLOW (1 s)",
        of: |v| maximum_running_rms(&Weighting::Wm.of_velocity(v), Averaging::Slow),
    },
    Measure {
        key: "vdv_wb",
        symbol: "VDV",
        // UDUNITS knows no broken powers: it reads m s-1.75 as 0.75 m/s, and refuses this
        units: "m/s^(7/4)",
        what: "vibration dose of one pass, W_b, BS 6472-1",
        of: |v| vibration_dose(&Weighting::Wb.of_velocity(v)),
    },
    Measure {
        key: "exposure",
        symbol: "∫v² dt",
        units: "m2 s-1",
        what: "energy of the pass, unweighted",
        of: History::energy,
    },
];

/// The measures of all histories.
pub struct Metrics {
    /// One for each of [`MEASURES`]: profiles × receivers.
    pub values: Vec<Array2<f64>>,
    /// KB_F(t) for the first profile, receivers × times.
    pub kb_f: Array2<f64>,
}

impl Metrics {
    /// Of velocities [m/s], receivers × times, of each profile.
    ///
    /// # Errors
    /// A velocity that is not a number.
    pub fn of(histories: &[Array2<f64>], times: Times) -> Result<Self, SignalError> {
        let receivers = histories[0].nrows();
        let rows: Vec<Vec<f64>> = (0..histories.len() * receivers)
            .into_par_iter()
            .map(|i| {
                let row = histories[i / receivers].row(i % receivers);
                let history = History::new(times.step, row.to_vec())?;
                Ok(MEASURES.iter().map(|m| (m.of)(&history)).collect())
            })
            .collect::<Result<_, SignalError>>()?;
        let shape = (histories.len(), receivers);
        let table = |m: usize| Array2::from_shape_fn(shape, |(i, r)| rows[i * receivers + r][m]);
        let kb_f: Vec<History> = histories[0]
            .rows()
            .into_iter()
            .map(|row| Ok(kb_f(&History::new(times.step, row.to_vec())?)))
            .collect::<Result<_, SignalError>>()?;
        Ok(Self {
            values: (0..MEASURES.len()).map(table).collect(),
            kb_f: Array2::from_shape_fn((receivers, times.count), |(r, i)| kb_f[r].values()[i]),
        })
    }

    /// Mean, least and largest over the profiles, of measure number `m` at receiver number `r`.
    pub fn spread(&self, m: usize, r: usize) -> (f64, f64, f64) {
        let column = self.values[m].column(r);
        let mean = column.iter().sum::<f64>() / column.len() as f64;
        let least = column.iter().copied().fold(f64::INFINITY, f64::min);
        (mean, least, column.iter().copied().fold(0.0, f64::max))
    }
}
