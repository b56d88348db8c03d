//! Estimates of what a building makes of the motion of its ground, by tables of third octaves.

use super::PassVelocities;
use super::metrics::{Direction, LARGEST, Measured};
use super::pictures::{band_figure, band_ticks, figure, steps};
use crate::assessment::{Band, Transfer, a_weighted_level};
use crate::concern::Concern;
use crate::dataset::Group;
use crate::field::Times;
use crate::figure::{Figure, Series, Stroke};
use crate::signal::{History, SignalError};
use crate::study::{Answer, speed_text};
use ndarray::Array2;

/// p₀ of levels of sound [Pa].
pub const SOUND: f64 = 2e-5;

/// Tables from the ground to a foundation, from there to a floor, and from its velocity to the sound of the room.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Building {
    /// v of the foundation over v of the open ground.
    pub foundation: Option<Transfer>,
    /// v of the floor over v of the foundation, or of the ground where that has no table.
    pub floor: Option<Transfer>,
    /// Sound pressure in the room over the velocity of the last of them [Pa s/m].
    pub noise: Option<Transfer>,
}

/// What is estimated at one place.
pub struct Estimate {
    /// `foundation`, `floor`.
    pub place: &'static str,
    /// Measures of the histories there.
    pub measured: Measured,
}

impl Building {
    /// The places it estimates, each with its tables from the ground on.
    fn places(&self) -> Vec<(&'static str, Vec<&Transfer>)> {
        let foundation: Vec<&Transfer> = self.foundation.iter().collect();
        let floor: Vec<&Transfer> = self.foundation.iter().chain(&self.floor).collect();
        let mut places = Vec::new();
        if self.foundation.is_some() {
            places.push(("foundation", foundation));
        }
        if self.floor.is_some() {
            places.push(("floor", floor));
        }
        places
    }

    /// Measures at each place, of `histories` [m/s] on the open ground, receivers × times of each profile.
    ///
    /// # Errors
    /// A velocity that is not a number.
    pub(super) fn estimates(
        &self,
        histories: &[Array2<f64>],
        times: Times,
    ) -> Result<Vec<Estimate>, SignalError> {
        let estimate = |(place, tables): (&'static str, Vec<&Transfer>)| {
            let there = histories.iter().map(|profile| through(&tables, profile, times));
            let there = there.collect::<Result<Vec<_>, SignalError>>()?;
            Ok(Estimate { place, measured: Measured::of(&there, times, Direction::Vertical)? })
        };
        self.places().into_iter().map(estimate).collect()
    }

    /// Factor from the ground to a place, band by band.
    fn factors(tables: &[&Transfer], bands: &[Band]) -> Vec<f64> {
        bands.iter().map(|band| tables.iter().map(|table| table.factor(*band)).product()).collect()
    }

    /// A concern where `bands` reach beyond the tables.
    pub(super) fn concerns(&self, bands: &[Band]) -> Vec<Concern> {
        let tables = [("foundation", &self.foundation), ("floor", &self.floor), ("noise", &self.noise)];
        let (Some(first), Some(last)) = (bands.first(), bands.last()) else { return Vec::new() };
        let short = tables.into_iter().filter_map(|(name, table)| {
            let (from, to) = table.as_ref()?.range();
            (*first < from || *last > to).then(|| {
                Concern::new(
                    "transfer-range",
                    format!(
                        "free_field.transfer.{name} reaches from {} to {} Hz, the bands from {} to {} Hz: beyond it the factor at its end is taken",
                        from.label(),
                        to.label(),
                        first.label(),
                        last.label()
                    ),
                    "give more of the table, or narrow free_field.frequencies",
                )
            })
        });
        short.collect()
    }
}

/// One profile's velocities behind `tables`.
fn through(tables: &[&Transfer], profile: &Array2<f64>, times: Times) -> Result<Array2<f64>, SignalError> {
    let mut there = profile.clone();
    for mut row in there.rows_mut() {
        let mut history = History::new(times.step, row.to_vec())?;
        for table in tables {
            history = table.of(&history);
        }
        row.iter_mut().zip(history.values()).for_each(|(to, from)| *to = *from);
    }
    Ok(there)
}

impl PassVelocities<'_> {
    /// The place that days are judged at, and its measures: the last one in the building, or the open ground, where the largest of
    /// three components is taken if they are known.
    pub(super) fn judged(&self) -> (&'static str, &Measured) {
        match (self.estimates.last(), &self.three) {
            (Some(estimate), _) => (estimate.place, &estimate.measured),
            (None, Some(three)) => (LARGEST, &three.largest),
            (None, None) => ("", &self.metrics.measured),
        }
    }

    /// r.m.s. velocity in bands at each place [m/s], receivers × bands.
    fn velocities_in_building(&self, total: &Array2<f64>) -> Vec<(&'static str, Array2<f64>)> {
        let bands = &self.study.bands;
        let of = |(place, tables): (&'static str, Vec<&Transfer>)| {
            let factors = Building::factors(&tables, bands);
            (place, Array2::from_shape_fn(total.dim(), |(r, b)| total[(r, b)] * factors[b]))
        };
        self.study.building.places().into_iter().map(of).collect()
    }

    /// Sound pressure levels in bands [dB re 20 µPa], receivers × bands; None without a table of noise.
    fn noise(&self, total: &Array2<f64>) -> Option<Array2<f64>> {
        let table = self.study.building.noise.as_ref()?;
        let places = self.velocities_in_building(total);
        let velocity = places.last().map_or(total, |(_, v)| v);
        let level = |(r, b): (usize, usize)| {
            20.0 * (velocity[(r, b)] * table.factor(self.study.bands[b]) / SOUND).log10()
        };
        Some(Array2::from_shape_fn(total.dim(), level))
    }

    /// Adds what is estimated in the building.
    pub(super) fn building_arrays(&self, mut group: Group, total: &Array2<f64>) -> Group {
        let dims = ["receiver", "band"];
        for (place, velocity) in self.velocities_in_building(total) {
            let what = format!("r.m.s. velocity over the passage time, estimated by table: {place}");
            group = group.variable(&format!("v_rms_{place}"), &dims, velocity.into_dyn(), "m s-1", &what);
        }
        if let Some(levels) = self.noise(total) {
            let what = "ground-borne noise estimated by table, dB re 20 µPa, unweighted";
            group = group.variable("noise_level", &dims, levels.into_dyn(), "1", what);
        }
        group
    }

    /// The A-weighted level of the ground-borne noise at receiver number `r`, `y` m from the track.
    pub(super) fn noise_answer(&self, total: &Array2<f64>, r: usize, y: f64) -> Option<Answer> {
        let levels = self.noise(total)?;
        let level = a_weighted_level(&self.study.bands, &levels.row(r).to_vec());
        let what =
            format!("Ground-borne noise at {y} m, estimate by table, mean over {:.2} s", self.passage_time);
        let answer = Answer::new(&format!("noise_{y}"), what, level, "dB", format!("{level:.1} dB(A)"));
        let columns = [("noise, estimate [dB(A)]", format!("{level:.1}"))];
        Some(answer.in_table(Self::row(self.velocities_table(), y, columns)))
    }

    /// Bands on the ground and in the building, and noise.
    pub(super) fn building_figures(&self, total: &Array2<f64>) -> Vec<(Figure, String)> {
        let study = self.study;
        let (at, levels) = (speed_text(study.speed), study.assessment.levels);
        let places = self.velocities_in_building(total);
        let mut figures = Vec::new();
        for (r, y) in study.receivers.iter().enumerate().filter(|_| !places.is_empty()) {
            let title = format!("Estimate in a building at {y} m, {at}");
            let mut picture = band_figure(format!("free_field_building_{y}"), title, &study.bands, levels);
            let most = places.iter().fold(0.0f64, |m, (_, v)| v.row(r).iter().fold(m, |m, v| m.max(*v)));
            let mut add = |name: &str, v: &Array2<f64>, stroke| {
                let row = v.row(r).to_vec();
                picture.series.push(steps(name.into(), &study.bands, &row, (stroke, levels, most)));
            };
            add("open ground", total, Stroke::Solid);
            for ((place, velocity), stroke) in places.iter().zip([Stroke::Dashed, Stroke::Points]) {
                add(place, velocity, stroke);
            }
            let caption = "Estimate: the bands of the open ground times the tables of free_field.transfer.";
            figures.push((Figure::Lines(picture), caption.into()));
        }
        if let Some(levels) = self.noise(total) {
            let labels = ("one-third-octave band [Hz]", "sound pressure level [dB re 20 µPa]");
            let title = format!("Ground-borne noise, estimate, {at}");
            let mut picture = figure("free_field_noise".into(), title, labels, true);
            picture.log_y = false;
            picture.x_ticks = band_ticks(&study.bands);
            picture.series = (study.receivers.iter().enumerate())
                .map(|(r, y)| {
                    let bands = study.bands.iter().zip(levels.row(r));
                    let level = |l: &f64| if l.is_finite() { *l } else { f64::NAN };
                    let (x, y_values) =
                        bands.flat_map(|(b, l)| [(b.lower(), level(l)), (b.upper(), level(l))]).unzip();
                    Series { name: format!("{y} m"), x, y: y_values, stroke: Stroke::Solid }
                })
                .collect();
            let caption =
                "Estimate: levels of velocity plus the table of free_field.transfer.noise; unweighted.";
            figures.push((Figure::Lines(picture), caption.into()));
        }
        figures
    }
}

#[cfg(test)]
mod tests {
    use super::super::metrics::MEASURES;
    use super::*;

    #[test]
    fn unity_is_the_free_field() {
        let bands = Band::range(1.0, 80.0).unwrap();
        let centres: Vec<f64> = bands.iter().map(|b| b.centre()).collect();
        let unity = || Transfer::new(&centres, &vec![1.0; bands.len()]).ok();
        let building = Building { foundation: unity(), floor: unity(), noise: None };
        let times = Times { first: 0.0, step: 1.0 / 320.0, count: 2000 };
        let pulse = |t: f64| 1e-3 * (-(t - 3.0).powi(2)).exp() * (50.0 * t).sin();
        let ground =
            Array2::from_shape_fn((2, 2000), |(r, i)| pulse(times.step * i as f64) / (1.0 + r as f64));
        let here = Measured::of(std::slice::from_ref(&ground), times, Direction::Vertical).unwrap();
        let estimates = building.estimates(&[ground], times).unwrap();
        assert_eq!(estimates.iter().map(|e| e.place).collect::<Vec<_>>(), ["foundation", "floor"]);
        // to rounding, through two transforms; measured 2e-14
        for there in &estimates {
            for (m, r) in (0..MEASURES.len()).flat_map(|m| [(m, 0), (m, 1)]) {
                let [a, b] = [&here, &there.measured].map(|measured| measured.spread(m, r).0);
                assert!((a - b).abs() <= 1e-11 * a.abs(), "{a} {b}");
            }
        }
        for (_, tables) in building.places() {
            assert!(Building::factors(&tables, &bands).iter().all(|f| *f == 1.0));
        }
        assert!(building.concerns(&bands).is_empty());
        assert_eq!(building.concerns(&Band::range(0.8, 80.0).unwrap()).len(), 2);
    }

    #[test]
    fn places_follow_one_another() {
        let table = |factor: f64| Transfer::new(&[8.0, 10.0], &[factor, factor]).ok();
        let bands = Band::range(8.0, 10.0).unwrap();
        let both = Building { foundation: table(0.5), floor: table(3.0), noise: None };
        assert_eq!(Building::factors(&both.places()[1].1, &bands), [1.5, 1.5]);
        let floor = Building { floor: table(3.0), ..Building::default() };
        assert_eq!(floor.places()[0].0, "floor");
        assert_eq!(Building::factors(&floor.places()[0].1, &bands), [3.0, 3.0]);
    }
}
