//! What a reader sees of a train passing over supports: histories, harmonics, spectra.

use super::over_supports::OverSupports;
use super::tag;
use crate::concern::Concern;
use crate::dataset::Group;
use crate::figure::{Figure, LineFigure, Series, Stroke};
use crate::study::{Answer, Beside, Outcome, Verified, speed_text, trimmed};
use ndarray::{Array2, Axis};

/// Error of histories, relative to the largest deflection, that is no concern.
const TOLERABLE: f64 = 1e-4;

impl OverSupports {
    /// Everything a run leaves; `beside` its spectra what others say.
    pub(super) fn shown(&self, beside: &[Beside]) -> Outcome {
        let rows = 0..self.speeds.len();
        let spectra = rows.clone().filter(|_| !self.frequencies.is_empty());
        Outcome {
            group: self.group(),
            figures: rows
                .clone()
                .map(|row| self.history_figure(row))
                .chain(spectra.map(|row| self.spectrum_figure(row, beside)))
                .collect(),
            answers: rows
                .flat_map(|row| self.answers(row))
                .chain(self.verified.as_ref().and_then(Verified::answer))
                .collect(),
            concerns: self
                .concern()
                .into_iter()
                .chain(self.verified.as_ref().and_then(Verified::concern))
                .collect(),
        }
    }

    fn answers(&self, row: usize) -> Vec<Answer> {
        let (speed, name) = (self.speeds[row], tag(self.speeds[row]));
        let at = speed_text(speed);
        let largest = self.rail.index_axis(Axis(0), row).iter().fold(0.0f64, |m, u| m.max(*u));
        let mean = self.harmonics[(row, self.harmonics.ncols() / 2)].norm();
        let first = self.harmonics[(row, self.harmonics.ncols() / 2 + 1)].norm();
        let passing = self.passing_frequency(row);
        vec![
            Answer::new(
                &format!("max_down_{name}"),
                format!("Largest downward rail deflection at {at}"),
                largest,
                "m",
                format!("{:.3} mm", 1e3 * largest),
            ),
            Answer::new(
                &format!("passing_frequency_{name}"),
                format!("Supports pass at {at} with"),
                passing,
                "Hz",
                format!("{passing:.2} Hz"),
            ),
            Answer::new(
                &format!("under_load_{name}"),
                format!("Rail under one unit load at {at}, mean over a bay"),
                mean,
                "m/N",
                format!("{mean:.4e} m/N"),
            ),
            Answer::new(
                &format!("parametric_{name}"),
                format!("Its first harmonic of the supports at {at}, of the mean"),
                first / mean,
                "1",
                format!("{:.2} %", 100.0 * first / mean),
            ),
        ]
    }

    fn group(&self) -> Group {
        let time = Array2::from_shape_fn((self.speeds.len(), self.distance.len()), |(v, i)| {
            self.distance[i] / self.speeds[v]
        });
        let orders: Vec<f64> = self.orders.iter().map(|order| f64::from(*order)).collect();
        let sidebands = Array2::from_shape_fn(self.harmonics.raw_dim(), |(v, j)| {
            self.harmonic + orders[j] * self.passing_frequency(v)
        });
        let group = Group::new("track_response")
            .attribute("method", "dirac-comb")
            .attribute("load_frequency", self.harmonic)
            .coordinate("speed", &self.speeds, "m s-1", "train speed")
            .coordinate("at", &self.at, "m", "place on the rail, from a support")
            .coordinate("distance", &self.distance, "m", "how far the leading axle is past the place")
            .variable(
                "time",
                &["speed", "distance"],
                time.into_dyn(),
                "s",
                "since the leading axle passed the place",
            )
            .variable(
                "rail",
                &["speed", "at", "distance"],
                self.rail.clone().into_dyn(),
                "m",
                "rail displacement, positive down",
            )
            .coordinate("order", &orders, "1", "order j of the harmonic under the load")
            .variable(
                "sidebands",
                &["speed", "order"],
                sidebands.into_dyn(),
                "Hz",
                "its frequency, f + j v/L",
            )
            .complex(
                "sideband",
                &["speed", "order"],
                &self.harmonics.clone().into_dyn(),
                "m N-1",
                "W_j of the rail under a unit load, u(vt, t) = e^{i omega t} sum W_j e^{2 pi i j v t/L}",
            );
        if self.frequencies.is_empty() {
            return group;
        }
        group.coordinate("frequency", &self.frequencies, "Hz", "frequency").variable(
            "spectrum",
            &["speed", "at", "frequency"],
            self.spectra.clone().into_dyn(),
            "m s",
            "modulus of the spectrum of the rail displacement under the leading axle",
        )
    }

    fn load(&self) -> String {
        match self.harmonic {
            0.0 => "constant loads".to_owned(),
            f => format!("loads that oscillate at {} Hz", trimmed(f)),
        }
    }

    fn history_figure(&self, row: usize) -> (Figure, String) {
        let at = speed_text(self.speeds[row]);
        let curve = |(i, x): (usize, &f64)| Series {
            name: format!("at {} m", trimmed(*x)),
            x: self.distance.clone(),
            y: self.rail.index_axis(Axis(0), row).row(i).iter().map(|u| 1e3 * u).collect(),
            stroke: Stroke::Solid,
        };
        let picture = LineFigure {
            y_down: true,
            series: self.at.iter().enumerate().map(curve).collect(),
            ..LineFigure::new(
                format!("track_response_{}", tag(self.speeds[row])),
                format!("Rail as the train passes at {at}"),
                "leading axle past the place [m]",
                "deflection [mm], positive down",
            )
        };
        let caption = format!(
            "Deflection of the rail at places of a bay of {} m (0: over a support) while the train passes at {at}, {}.",
            self.spacing,
            self.load()
        );
        (Figure::Lines(picture), caption)
    }

    fn spectrum_figure(&self, row: usize, beside: &[Beside]) -> (Figure, String) {
        let at = speed_text(self.speeds[row]);
        let curve = |(i, x): (usize, &f64)| Series {
            name: format!("at {} m", trimmed(*x)),
            x: self.frequencies.clone(),
            y: self.spectra.index_axis(Axis(0), row).row(i).iter().map(|u| 1e6 * u).collect(),
            stroke: Stroke::Solid,
        };
        let picture = LineFigure {
            log_y: true,
            series: self
                .at
                .iter()
                .enumerate()
                .map(curve)
                .chain(beside.iter().map(|b| b.series(1e6)))
                .collect(),
            ..LineFigure::new(
                format!("track_spectrum_{}", tag(self.speeds[row])),
                format!("Spectrum of the rail's deflection at {at}"),
                "frequency [Hz]",
                "|û| [µm s]",
            )
        };
        let caption = format!(
            "Modulus of the Fourier transform ∫u e^(−iωt) dt of the rail's deflection under the leading axle alone, {}; supports pass with {:.2} Hz.",
            self.load(),
            self.passing_frequency(row)
        );
        (Figure::Lines(picture), caption)
    }

    fn concern(&self) -> Option<Concern> {
        let missed = self.error.is_nan() || self.error > TOLERABLE;
        missed.then(|| {
            Concern::new(
                "history-accuracy",
                format!("histories are known to {:.0e} of the largest deflection (wanted {TOLERABLE:.0e})", self.error),
                "viscous damping instead of loss factors: the loss of hysteretic springs jumps at 0 Hz, which a constant load meets",
            )
        })
    }
}
