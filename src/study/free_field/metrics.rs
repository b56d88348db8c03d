//! What the histories of a pass are to people and to standards.

use crate::assessment::{
    Averaging, Band, Guide, PassageSpectrum, Weighting, WorkingRange, clock_maxima, clock_maximum_rms, kb_f,
    maximum_running_rms, passage_spectrum, peak_velocity, peak_velocity_within, vibration_dose,
    weighted_velocity,
};
use crate::dataset::Group;
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
    /// Of a velocity and its KB_F(t).
    of: fn(&History, &History, Direction) -> f64,
}

/// Of a velocity, for what weighs directions differently.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// Up and down.
    Vertical,
    /// Along the ground.
    Horizontal,
}

impl Direction {
    /// W_b or W_d, BS 6472-1.
    fn weighting(self) -> Weighting {
        match self {
            Self::Vertical => Weighting::Wb,
            Self::Horizontal => Weighting::Wd,
        }
    }
}

/// All [`MEASURES`] of a `velocity` [m/s] in one direction.
pub fn measures(velocity: &History, direction: Direction) -> Vec<f64> {
    let kb_f = kb_f(velocity);
    MEASURES.iter().map(|measure| (measure.of)(velocity, &kb_f, direction)).collect()
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
pub const V_W_SLOW_MAXIMUM: usize = 7;
pub const PEAK_TO_80: usize = 8;
pub const PEAK_TO_315: usize = 9;
pub const KB_CLOCK: usize = 10;
pub const KB_PASS: usize = 11;

/// Those a reader is told who asks for `guides`, of none the usual ones; the others are in the files.
pub fn told(guides: &[Guide]) -> Vec<usize> {
    if guides.is_empty() {
        return vec![PEAK_VELOCITY, V_SLOW_MAXIMUM, KB_F_MAXIMUM, VDV];
    }
    let of = |guide: &Guide| match guide {
        Guide::Din4150Part2 => vec![KB_F_MAXIMUM, KB_CLOCK],
        Guide::Din4150Part3 => vec![PEAK_TO_80, PEAK_TO_315],
        Guide::Bs6472Part1 => vec![VDV],
        Guide::Ns8176 => vec![V_W_SLOW_MAXIMUM],
        Guide::SbrB => vec![KB_F_MAXIMUM],
        Guide::Fta => vec![V_SLOW_MAXIMUM],
    };
    let mut told = vec![PEAK_VELOCITY];
    told.extend(guides.iter().flat_map(of));
    told.sort_unstable();
    told.dedup();
    told
}

/// What stands in the place of a place where it is the open ground and its three components.
pub const LARGEST: &str = "largest of three components";

/// ", floor, estimate"; nothing of the open ground.
pub fn estimated(place: &str) -> String {
    match place {
        "" => String::new(),
        LARGEST => format!(", {LARGEST}"),
        place => format!(", {place}, estimate"),
    }
}

/// Where something was found.
pub fn where_text(place: &str) -> String {
    match place {
        "" => "vertical, on the ground's surface without a building".to_owned(),
        LARGEST => format!("{LARGEST}, on the ground's surface without a building"),
        place => format!("vertical, on the {place}, estimated by table"),
    }
}

/// Root of the sum of squares of the clock maxima of one pass.
fn kb_pass(kb_f: &History) -> f64 {
    clock_maxima(kb_f).iter().map(|kb| kb * kb).sum::<f64>().sqrt()
}

/// The measures of one component of the velocity of the ground's surface.
pub const MEASURES: [Measure; 12] = [
    Measure {
        key: "peak_velocity",
        symbol: "PPV",
        units: "m s-1",
        what: "peak particle velocity, unweighted",
        of: |v, _, _| peak_velocity(v),
    },
    Measure {
        key: "v_fast_maximum",
        symbol: "v_F,max",
        units: "m s-1",
        what: "largest running r.m.s. velocity, FAST (0.125 s), unweighted",
        of: |v, _, _| maximum_running_rms(v, Averaging::Fast),
    },
    Measure {
        key: "v_slow_maximum",
        symbol: "v_S,max",
        units: "m s-1",
        what: "largest running r.m.s. velocity, SLOW (1 s), unweighted",
        of: |v, _, _| maximum_running_rms(v, Averaging::Slow),
    },
    Measure {
        key: "kb_f_maximum",
        symbol: "KB_Fmax",
        units: "1",
        what: "largest KB_F(t), DIN 45669-1, FAST",
        of: |_, kb_f, _| kb_f.peak(),
    },
    Measure {
        key: "a_wm_slow_maximum",
        symbol: "a_w,max",
        units: "m s-2",
        what: "largest running r.m.s. acceleration, W_m of ISO 2631-2, SLOW (1 s)",
        of: |v, _, _| maximum_running_rms(&Weighting::Wm.of_velocity(v), Averaging::Slow),
    },
    Measure {
        key: "vdv_wb",
        symbol: "VDV",
        // UDUNITS knows no broken powers: it reads m s-1.75 as 0.75 m/s, and refuses this
        units: "m/s^(7/4)",
        what: "vibration dose of one pass, W_b, BS 6472-1",
        of: |v, _, direction| vibration_dose(&direction.weighting().of_velocity(v)),
    },
    Measure {
        key: "exposure",
        symbol: "∫v² dt",
        units: "m2 s-1",
        what: "energy of the pass, unweighted",
        of: |v, _, _| v.energy(),
    },
    Measure {
        key: "v_w_slow_maximum",
        symbol: "V_S,max",
        units: "m s-1",
        what: "largest running r.m.s. of the weighted velocity, W_m of ISO 2631-2, SLOW (1 s), as of NS 8176",
        of: |v, _, _| maximum_running_rms(&weighted_velocity(v), Averaging::Slow),
    },
    Measure {
        key: "peak_velocity_1_80_hz",
        symbol: "PPV (1 to 80 Hz)",
        units: "m s-1",
        what: "peak particle velocity, 1 to 80 Hz of DIN 45669-1",
        of: |v, _, _| peak_velocity_within(v, WorkingRange::To80),
    },
    Measure {
        key: "peak_velocity_1_315_hz",
        symbol: "PPV (1 to 315 Hz)",
        units: "m s-1",
        what: "peak particle velocity, 1 to 315 Hz of DIN 45669-1",
        of: |v, _, _| peak_velocity_within(v, WorkingRange::To315),
    },
    Measure {
        key: "kb_ftm",
        symbol: "KB_FTm",
        units: "1",
        what: "r.m.s. of the clock maxima of the intervals of 30 s that the pass occupies, DIN 4150-2",
        of: |_, kb_f, _| clock_maximum_rms(&clock_maxima(kb_f)),
    },
    Measure {
        key: "kb_pass",
        symbol: "√ΣKB²_FTi",
        units: "1",
        what: "root of the sum of squares of the clock maxima of one pass, DIN 4150-2",
        of: |_, kb_f, _| kb_pass(kb_f),
    },
];

/// The measures of all histories of one component: for each of [`MEASURES`] profiles × receivers.
#[derive(Clone, Debug, PartialEq)]
pub struct Measured(Vec<Array2<f64>>);

/// What the vertical motion is to people and to standards.
pub struct Metrics {
    /// Its measures.
    pub measured: Measured,
    /// KB_F(t) for the first profile, receivers × times.
    pub kb_f: Array2<f64>,
    /// Third octaves of the first profile, for each receiver.
    pub spectra: Vec<PassageSpectrum>,
}

impl Measured {
    /// Of velocities [m/s], receivers × times, of each profile.
    ///
    /// # Errors
    /// A velocity that is not a number.
    pub fn of(histories: &[Array2<f64>], times: Times, direction: Direction) -> Result<Self, SignalError> {
        let receivers = histories[0].nrows();
        let rows: Vec<Vec<f64>> = (0..histories.len() * receivers)
            .into_par_iter()
            .map(|i| {
                let row = histories[i / receivers].row(i % receivers);
                let history = History::new(times.step, row.to_vec())?;
                Ok(measures(&history, direction))
            })
            .collect::<Result<_, SignalError>>()?;
        let shape = (histories.len(), receivers);
        let table = |m: usize| Array2::from_shape_fn(shape, |(i, r)| rows[i * receivers + r][m]);
        Ok(Self((0..MEASURES.len()).map(table).collect()))
    }

    /// The larger one of each, where directions are weighed as they should be.
    pub fn larger_of(mut self, other: &Self) -> Self {
        for (one, other) in self.0.iter_mut().zip(&other.0) {
            one.zip_mut_with(other, |a, b| *a = a.max(*b));
        }
        self
    }

    /// Adds them as variables along `dims`, profile and receiver or receiver alone; their names end in `suffix`.
    pub fn arrays(
        &self,
        mut group: Group,
        dims: &[&str],
        suffix: &str,
        direction: Direction,
        words: &str,
    ) -> Group {
        for (measure, values) in MEASURES.iter().zip(&self.0) {
            let values =
                if dims.len() == 2 { values.clone().into_dyn() } else { values.row(0).to_owned().into_dyn() };
            let what = match direction {
                Direction::Vertical => measure.what.to_owned(),
                Direction::Horizontal => measure.what.replace("W_b,", "W_d,"),
            };
            let what = format!("{what}, {words}");
            group = group.variable(&format!("{}{suffix}", measure.key), dims, values, measure.units, &what);
        }
        group
    }

    /// ⟨xⁿ⟩^{1/n} over the profiles, of measure number `m` at receiver number `r`.
    pub fn mean_of_powers(&self, m: usize, r: usize, n: i32) -> f64 {
        let column = self.0[m].column(r);
        (column.iter().map(|x| x.powi(n)).sum::<f64>() / column.len() as f64).powf(1.0 / f64::from(n))
    }

    /// Mean, least and largest over the profiles, of measure number `m` at receiver number `r`.
    pub fn spread(&self, m: usize, r: usize) -> (f64, f64, f64) {
        let column = self.0[m].column(r);
        let mean = column.iter().sum::<f64>() / column.len() as f64;
        let least = column.iter().copied().fold(f64::INFINITY, f64::min);
        (mean, least, column.iter().copied().fold(0.0, f64::max))
    }
}

impl Metrics {
    /// Of vertical velocities [m/s], receivers × times, of each profile, and their third octaves in `bands`.
    ///
    /// # Errors
    /// A velocity that is not a number.
    pub fn of(histories: &[Array2<f64>], times: Times, bands: &[Band]) -> Result<Self, SignalError> {
        let receivers = histories[0].nrows();
        let first: Vec<History> = histories[0]
            .rows()
            .into_iter()
            .map(|row| History::new(times.step, row.to_vec()))
            .collect::<Result<_, SignalError>>()?;
        let kb_f: Vec<History> = first.iter().map(kb_f).collect();
        Ok(Self {
            measured: Measured::of(histories, times, Direction::Vertical)?,
            kb_f: Array2::from_shape_fn((receivers, times.count), |(r, i)| kb_f[r].values()[i]),
            spectra: first.iter().map(|velocity| passage_spectrum(velocity, bands)).collect(),
        })
    }
}
