//! Largest deflection against speed: its peak, its other maxima, its plateau.

use super::extremes::Extremes;
use crate::math::maximum::by_parabolas;

/// Width of the bracket at which the search for the maximum stops [m/s].
const SPEED_WIDTH: f64 = 0.1;
/// Share of the largest deflection from which another maximum matters.
const NEAR: f64 = 0.9;
/// Share of the largest deflection by which a curve dips between maxima that are two.
const DIP: f64 = 0.005;
/// Share of the largest deflection above which a curve is level, and the width of such a range over the speed of the
/// peak from which it is a plateau: measured 2.5 to 7.5 % for the peaks of `soil_cases` and of trains on six soft layers.
const LEVEL: f64 = 0.98;
const WIDE: f64 = 0.15;

/// The maximum of a curve, bracketed by its speeds and refined.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peak {
    /// [m/s]
    pub speed: f64,
    /// Downward rail deflection [m].
    pub down: f64,
    /// True at the first or last speed: the maximum lies beyond, or there is none.
    pub at_end: bool,
}

/// Another maximum of a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hump {
    /// One of the speeds of the curve [m/s].
    pub speed: f64,
    /// Its deflection over that of the peak.
    pub share: f64,
}

/// A range of speeds in which the deflection hardly changes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plateau {
    /// [m/s]
    pub from: f64,
    /// [m/s]
    pub to: f64,
}

/// Largest rail deflections over all positions against speed, under one load.
#[derive(Clone, Debug, PartialEq)]
pub struct SpeedCurve {
    /// v [m/s], ascending.
    pub speeds: Vec<f64>,
    /// Downward [m].
    pub down: Vec<f64>,
    /// Upward, positive up [m].
    pub up: Vec<f64>,
    /// Downward at rest, the static limit ω = 0 [m].
    pub at_rest: f64,
    /// Downward as v → 0 [m]: not the same with hysteretic damping, which acts however slowly a load moves.
    pub slow: f64,
    /// Where `down` is largest.
    pub peak: Peak,
}

impl SpeedCurve {
    /// From the `extremes` at `speeds`, those at rest and as v → 0, and `down` at any speed.
    pub(super) fn new<E>(
        speeds: &[f64],
        extremes: &[Extremes],
        (at_rest, slow): (f64, f64),
        down: impl FnMut(f64) -> Result<f64, E>,
    ) -> Result<Self, E> {
        let values: Vec<f64> = extremes.iter().map(|e| e.down).collect();
        Ok(Self {
            speeds: speeds.to_vec(),
            peak: refine(speeds, &values, down)?,
            down: values,
            up: extremes.iter().map(|e| e.up).collect(),
            at_rest,
            slow,
        })
    }

    /// Largest downward deflection over that at rest, for every speed.
    pub fn amplification(&self) -> Vec<f64> {
        self.down.iter().map(|down| down / self.at_rest).collect()
    }

    /// Maxima within 10 % of the peak, apart from it by a dip of at least 0.5 %, an end that rises included.
    pub fn humps(&self) -> Vec<Hump> {
        let top = largest(&self.down);
        let at = |i: Option<usize>| i.and_then(|i| self.down.get(i)).copied().unwrap_or(f64::NEG_INFINITY);
        let is_one = |&i: &usize| {
            let between = &self.down[i.min(top)..=i.max(top)];
            let dip = self.down[i] - between.iter().copied().fold(f64::INFINITY, f64::min);
            self.down[i] > at(i.checked_sub(1))
                && self.down[i] > at(Some(i + 1))
                && self.down[i] >= NEAR * self.peak.down
                && dip >= DIP * self.peak.down
        };
        let hump = |i: usize| Hump { speed: self.speeds[i], share: self.down[i] / self.peak.down };
        (0..self.down.len()).filter(is_one).map(hump).collect()
    }

    /// The range of speeds around a peak inside the range with at least 98 % of its deflection, where it is wider than 15 % of the
    /// peak's speed.
    pub fn plateau(&self) -> Option<Plateau> {
        if self.peak.at_end {
            return None;
        }
        let level = LEVEL * self.peak.down;
        let top = largest(&self.down);
        let low = |i: &usize| self.down[*i] < level;
        // v at which the chord from i, below the level, to j, above it, crosses it
        let cross = |i: usize, j: usize| {
            let share = (level - self.down[i]) / (self.down[j] - self.down[i]);
            self.speeds[i] + share * (self.speeds[j] - self.speeds[i])
        };
        let last = self.speeds.len() - 1;
        let from = (0..top).rev().find(low).map_or(self.speeds[0], |i| cross(i, i + 1));
        let to = (top..=last).find(low).map_or(self.speeds[last], |i| cross(i, i - 1));
        (to - from > WIDE * self.peak.speed).then_some(Plateau { from, to })
    }
}

/// Place of the largest of `values`.
fn largest(values: &[f64]) -> usize {
    (0..values.len()).max_by(|&a, &b| values[a].total_cmp(&values[b])).unwrap_or(0)
}

fn refine<E>(speeds: &[f64], values: &[f64], down: impl FnMut(f64) -> Result<f64, E>) -> Result<Peak, E> {
    let top = largest(values);
    let at_end = top == 0 || top + 1 == speeds.len();
    if at_end {
        return Ok(Peak { speed: speeds[top], down: values[top], at_end });
    }
    let (speed, down) =
        by_parabolas(down, [top - 1, top, top + 1].map(|i| (speeds[i], values[i])), SPEED_WIDTH)?;
    Ok(Peak { speed, down, at_end })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Speeds 10 to 100 m/s in steps of 1 with `shape` as downward deflection.
    fn curve(shape: impl Fn(f64) -> f64) -> SpeedCurve {
        let speeds: Vec<f64> = (10..=100).map(f64::from).collect();
        let extremes: Vec<Extremes> =
            speeds.iter().map(|v| Extremes { down: shape(*v), up: 0.0, at_edge: false }).collect();
        SpeedCurve::new(&speeds, &extremes, (1.0, 1.0), |v| Ok::<_, ()>(shape(v))).unwrap()
    }

    /// A bell of the given height around `at`, `width` wide.
    fn bell(v: f64, height: f64, at: f64, width: f64) -> f64 {
        height * (-((v - at) / width).powi(2)).exp()
    }

    #[test]
    fn one_peak_has_neither_humps_nor_a_plateau() {
        let one = curve(|v| 1.0 + bell(v, 1.0, 60.3, 10.0));
        assert!((one.peak.speed - 60.3).abs() < 0.1 && !one.peak.at_end);
        assert_eq!((one.humps(), one.plateau()), (vec![], None));
    }

    #[test]
    fn maxima_within_a_tenth_are_humps() {
        let two = |height: f64| curve(move |v| bell(v, 1.0, 80.0, 8.0) + bell(v, height, 40.0, 8.0));
        let humps = two(0.93).humps();
        assert_eq!(humps.len(), 1);
        assert!(humps[0].speed == 40.0 && (humps[0].share - 0.93).abs() < 1e-3, "{humps:?}");
        assert_eq!(two(0.85).humps(), []);
        // a ripple of 0.2 % is none, an end that rises to 91 % is one
        let ripple = curve(|v| bell(v, 1.0, 60.0, 30.0) + 0.002 * (v * 1.5).sin());
        assert_eq!(ripple.humps(), []);
        let end = curve(|v| bell(v, 1.0, 40.0, 10.0) + bell(v, 0.97, 105.0, 20.0));
        assert_eq!(end.humps().iter().map(|h| h.speed).collect::<Vec<_>>(), [100.0]);
    }

    #[test]
    fn a_level_range_is_a_plateau_with_its_ends() {
        // 2 % of 2 are lost 12 m/s past the ends of the level
        let level = |v: f64| {
            let past = (50.0 - v).max(v - 70.0).max(0.0);
            2.0 - 0.04 * (past / 12.0).powi(2) - 1e-5 * (v - 60.0).powi(2)
        };
        let plateau = curve(level).plateau().unwrap();
        // 1e-5 (v − 60)² takes 0.005 of the 0.04 there: 11.2 m/s past the ends
        assert!((plateau.from - 38.7).abs() < 0.3 && (plateau.to - 81.3).abs() < 0.3, "{plateau:?}");
    }
}
