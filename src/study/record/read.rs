//! A record from a CSV file: time, then velocity or acceleration in up to three directions.

use super::{Channel, MeasuredHistory};
use crate::columns::{self, ColumnsError};
use crate::signal::{History, SignalError};
use crate::study::Assessment;
use crate::study::free_field::metrics::Direction;
use num_complex::Complex64;
use std::f64::consts::{SQRT_2, TAU};
use thiserror::Error;

/// What a column of a record may be in.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Velocity(f64),
    Acceleration(f64),
}

const UNITS: [(&str, Kind); 9] = [
    ("m/s", Kind::Velocity(1.0)),
    ("cm/s", Kind::Velocity(1e-2)),
    ("mm/s", Kind::Velocity(1e-3)),
    ("um/s", Kind::Velocity(1e-6)),
    ("m/s2", Kind::Acceleration(1.0)),
    ("cm/s2", Kind::Acceleration(1e-2)),
    ("mm/s2", Kind::Acceleration(1e-3)),
    ("g", Kind::Acceleration(9.80665)),
    ("mg", Kind::Acceleration(9.80665e-3)),
];
const TIMES: [(&str, f64); 3] = [("s", 1.0), ("ms", 1e-3), ("min", 60.0)];

/// Share of the sampling step by which a time may miss its place: times are written with few digits.
const UNEVEN: f64 = 0.5;
/// Fewest samples.
const LEAST: usize = 64;
/// Corner below which integration leaves an acceleration alone [Hz], that of W_b.
const CORNER: f64 = 0.4;

/// Why a file is no record.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum RecordError {
    /// No table of numbers.
    #[error(transparent)]
    Columns(#[from] ColumnsError),
    /// Too few or too many columns.
    #[error("{found} columns: a record has time and one to three directions, as in t [s], v_z [mm/s]")]
    Width {
        /// How many there are.
        found: usize,
    },
    /// A column of which nobody knows what it holds.
    #[error(
        "line {line} names a column \"{name}\" without its unit: write m/s, mm/s, µm/s for velocity, m/s², mm/s², g for acceleration, as in {name} [mm/s]"
    )]
    NoUnit {
        /// Of the header.
        line: usize,
        /// As it stands.
        name: String,
    },
    /// Velocity and acceleration side by side.
    #[error("line {line} mixes velocities and accelerations: give one of them")]
    Mixed {
        /// Of the header.
        line: usize,
    },
    /// Times that fall, stand still or leave a gap.
    #[error(
        "line {line} stands at t = {t} s, not one step of {step:.6} s after the line before it at {before} s: samples must follow one another in equal steps"
    )]
    Uneven {
        /// From 1.
        line: usize,
        /// [s]
        t: f64,
        /// Of the line before [s].
        before: f64,
        /// The usual one [s].
        step: f64,
    },
    /// Too few samples.
    #[error("{found} samples: a record needs at least {LEAST}")]
    TooFew {
        /// How many there are.
        found: usize,
    },
    /// Nothing but one value.
    #[error("the column \"{name}\" holds one value alone: nothing moves")]
    Still {
        /// As it stands.
        name: String,
    },
    /// No history.
    #[error(transparent)]
    Signal(#[from] SignalError),
}

impl MeasuredHistory {
    /// The record in `csv`: a header with units, then time and one to three directions in each line ([`columns::table`]).
    ///
    /// A direction whose name has an x, y or h in it (v_x, horizontal) is horizontal. The mean of each is taken away. Accelerations are
    /// integrated as they are filtered, above 0.4 Hz (second-order Butterworth).
    ///
    /// # Errors
    /// No table; a direction without unit; times that do not follow one another in equal steps, to half a step; too few samples; a
    /// direction in which nothing moves. The line is named.
    pub fn parse(csv: &str, assessment: Assessment) -> Result<Self, RecordError> {
        let table = columns::table(csv)?;
        if !(2..=4).contains(&table.columns.len()) {
            return Err(RecordError::Width { found: table.columns.len() });
        }
        let line = table.header;
        let size = columns::unit(&table.names[0], line, &TIMES)?.unwrap_or(1.0);
        let times: Vec<f64> = table.columns[0].iter().map(|t| size * t).collect();
        let step = even_step(&times, &table.lines)?;
        let mut kinds = Vec::new();
        for name in &table.names[1..] {
            let kind = columns::unit(name, line, &UNITS)?;
            kinds.push(kind.ok_or_else(|| RecordError::NoUnit { line, name: name.clone() })?);
        }
        let integrated = matches!(kinds[0], Kind::Acceleration(_));
        if kinds.iter().any(|kind| matches!(kind, Kind::Acceleration(_)) != integrated) {
            return Err(RecordError::Mixed { line });
        }
        let channels = kinds.into_iter().zip(&table.names[1..]).zip(&table.columns[1..]);
        let channels = channels.map(|((kind, name), values)| channel(name, kind, values, step));
        Ok(Self { first: times[0], channels: channels.collect::<Result<_, _>>()?, integrated, assessment })
    }
}

/// The step of `times` [s].
fn even_step(times: &[f64], lines: &[usize]) -> Result<f64, RecordError> {
    if times.len() < LEAST {
        return Err(RecordError::TooFew { found: times.len() });
    }
    let mut steps: Vec<f64> = times.windows(2).map(|t| t[1] - t[0]).collect();
    steps.sort_by(f64::total_cmp);
    // the median bears single gaps, the mean of the middle bears rounding
    let usual = steps[steps.len() / 2];
    let kept: Vec<f64> = steps.iter().copied().filter(|s| (s - usual).abs() <= 0.5 * usual.abs()).collect();
    let step = kept.iter().sum::<f64>() / kept.len() as f64;
    for (i, pair) in times.windows(2).enumerate() {
        let place = times[0] + step * (i + 1) as f64;
        let follows = (pair[1] - pair[0] - step).abs() <= UNEVEN * step;
        if !(step > 0.0 && follows && (pair[1] - place).abs() <= UNEVEN * step) {
            return Err(RecordError::Uneven { line: lines[i + 1], t: pair[1], before: pair[0], step });
        }
    }
    Ok(step)
}

fn channel(name: &str, kind: Kind, values: &[f64], step: f64) -> Result<Channel, RecordError> {
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    let (size, integrate) = match kind {
        Kind::Velocity(size) => (size, false),
        Kind::Acceleration(size) => (size, true),
    };
    if values.iter().all(|v| *v == values[0]) {
        return Err(RecordError::Still { name: name.to_owned() });
    }
    let history = History::new(step, values.iter().map(|v| size * (v - mean)).collect())?;
    let velocity = if integrate { history.filtered(8.0 / CORNER, integral) } else { history };
    let short = name.split(['[', '(']).next().unwrap_or(name).trim().trim_end_matches(" in").to_owned();
    let lower = short.to_lowercase();
    let horizontal = lower.contains(['x', 'y']) || lower.contains("hor") || lower.ends_with("_h");
    let direction = if horizontal { Direction::Horizontal } else { Direction::Vertical };
    Ok(Channel { name: short, direction, velocity })
}

/// 1/(iω) above [`CORNER`]: s/(s² + √2 ω_c s + ω_c²), which is 0 at f = 0.
fn integral(f: f64) -> Complex64 {
    let (s, corner) = (Complex64::new(0.0, TAU * f), TAU * CORNER);
    s / (s * s + SQRT_2 * corner * s + corner * corner)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn csv(header: &str, samples: usize, of: impl Fn(f64) -> String) -> String {
        (0..samples).fold(format!("# site 4\n{header}\n"), |text, i| {
            let t = 0.004 * i as f64;
            text + &format!("{t:.4};{}\n", of(t))
        })
    }

    fn parse(text: &str) -> Result<MeasuredHistory, RecordError> {
        MeasuredHistory::parse(text, Assessment::default())
    }

    #[test]
    fn velocities_in_their_units_and_directions() {
        let text = csv("t [s];v_x [mm/s];v_z [µm/s]", 200, |t| {
            format!("{};{}", 1.0 + t.sin(), 2.0 * (9.0 * t).cos())
        });
        let record = parse(&text.replace('.', ",")).unwrap();
        let [x, z] = &record.channels[..] else { panic!("two directions") };
        assert_eq!((x.name.as_str(), x.direction), ("v_x", Direction::Horizontal));
        assert_eq!((z.name.as_str(), z.direction), ("v_z", Direction::Vertical));
        assert!((x.velocity.step() - 0.004).abs() < 1e-9);
        assert!(x.velocity.values().iter().sum::<f64>().abs() < 1e-12, "the mean is taken away");
        let difference = z.velocity.values()[30] - z.velocity.values()[0];
        assert!((difference - 2e-6 * ((9.0f64 * 0.12).cos() - 1.0)).abs() < 1e-12);
    }

    #[test]
    fn accelerations_are_integrated() {
        // a = ω A cos ωt, 10 Hz, under a bell: v = A sin ωt, less what the corner at 0.4 Hz turns: (0.4/10)² and a phase of
        // √2 · 0.04; measured 5.5e-2 of A at worst
        let (omega, size) = (TAU * 10.0, 2e-3);
        let bell = |t: f64| (-(t - 4.0).powi(2)).exp();
        let text =
            csv("t [s];a [m/s²]", 2000, |t| format!("{:.9}", omega * size * bell(t) * (omega * t).cos()));
        let record = parse(&text).unwrap();
        assert!(record.integrated);
        let worst = (0..2000).map(|i| {
            let t = 0.004 * i as f64;
            (record.channels[0].velocity.values()[i] - size * bell(t) * (omega * t).sin()).abs()
        });
        let worst = worst.fold(0.0, f64::max);
        assert!(worst < 0.065 * size && worst > 0.02 * size, "{}", worst / size);
    }

    #[test]
    fn faults_are_told_at_their_line() {
        let good = csv("t [s];v [mm/s]", 100, |t| format!("{}", t.sin()));
        let why = |text: &str| parse(text).unwrap_err().to_string();
        let lines: Vec<&str> = good.lines().collect();
        // the sample in line 40 is missing
        let gap = lines
            .iter()
            .enumerate()
            .filter(|(i, _)| *i != 39)
            .map(|(_, l)| format!("{l}\n"))
            .collect::<String>();
        assert!(why(&gap).starts_with("line 40 stands at t = 0.152"), "{}", why(&gap));
        let mut back = lines.clone();
        back.swap(49, 50);
        assert!(why(&back.join("\n")).starts_with("line 50 stands"), "{}", why(&back.join("\n")));
        assert!(why(&good.replace("v [mm/s]", "v")).contains("\"v\" without its unit"));
        assert!(why(&good.replace("v [mm/s]", "v [in/s]")).contains("\"in/s\""));
        assert!(why(&lines[..20].join("\n")).contains("18 samples"));
        assert!(why("t [s]\n1\n").contains("1 columns"));
        assert!(why(&csv("t [s];v [mm/s];a [m/s2]", 99, |t| format!("{t};{t}"))).contains("mixes"));
        assert!(why(&csv("t [s];v [mm/s]", 99, |_| "3".into())).contains("nothing moves"));
    }
}
