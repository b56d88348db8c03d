//! What a reader sees of dispersion curves: arrays, answers, pictures, concerns.

use super::map::Compliance;
use super::{Crossing, DispersionCurves};
use crate::concern::Concern;
use crate::dataset::Group;
use crate::figure::{Figure, LineFigure, MapFigure, Series, Stroke};
use crate::soil::dispersion::{Mode, Modes, SurfaceWave};
use crate::study::{Answer, Outcome, speed_text, trimmed};
use ndarray::{Array1, Array2};

impl DispersionCurves {
    /// Everything a run leaves, with the `compliance` behind the curves.
    pub(super) fn shown(&self, compliance: Option<Compliance>) -> Outcome {
        let mut figures: Vec<_> = compliance.map(|compliance| self.map(compliance)).into_iter().collect();
        figures.extend(self.lines());
        figures.extend(self.ellipticity());
        let mut group = self.group();
        if let Some(shapes) = &self.shapes {
            group = shapes.with(group);
            figures.extend(shapes.figures());
        }
        Outcome { group, figures, answers: self.answers(), concerns: self.concerns() }
    }

    fn answers(&self) -> Vec<Answer> {
        let Some(Crossing { frequency, speed }) = self.crossing else { return Vec::new() };
        let estimate = "Crossing of track and ground, uncoupled: an estimate";
        let shown = format!("{} (in full: the study critical_speed)", speed_text(speed));
        vec![
            Answer::new("crossing_speed", estimate, speed, "m/s", shown),
            Answer::new("crossing_frequency", "Its frequency", frequency, "Hz", format!("{frequency:.2} Hz")),
        ]
    }

    fn group(&self) -> Group {
        let group = Group::new("dispersion").coordinate("frequency", &self.frequencies, "Hz", "frequency");
        let group = self.with_track(self.with_modes(group));
        match self.crossing {
            Some(Crossing { frequency, speed }) => {
                group.attribute("crossing_speed", speed).attribute("crossing_frequency", frequency)
            }
            None => group,
        }
    }

    fn with_modes(&self, group: Group) -> Group {
        let table = |of: fn(&Mode) -> f64| {
            Array2::from_shape_fn((self.grounds.len(), self.count), |(i, j)| {
                self.grounds[i].modes.get(j).and_then(|m| m.as_ref()).map_or(f64::NAN, of)
            })
            .into_dyn()
        };
        let there = Array2::from_shape_fn((self.grounds.len(), self.count), |(i, j)| {
            f64::from(u8::from(self.grounds[i].modes.get(j).is_some_and(Option::is_some)))
        });
        let numbers: Vec<f64> = (0..self.count).map(|i| i as f64).collect();
        let counts: Array1<f64> = self.grounds.iter().map(|g| g.count as f64).collect();
        let both = ["frequency", "mode"];
        let found = "1 where the mode was found, 0 where its values are not a number";
        let phase = "phase velocity of the mode; not a number where found is 0";
        let energy = "group velocity of the mode; not a number where found is 0";
        let decay = "decay of the mode's amplitude per metre; not a number where found is 0";
        let count = "number of trapped modes of the undamped ground, counted independently";
        let wave = match self.wave {
            SurfaceWave::Rayleigh => "rayleigh",
            SurfaceWave::Love => "love",
        };
        let group = group
            .coordinate("mode", &numbers, "1", "number of the mode, the slowest first")
            .variable("found", &both, there.into_dyn(), "1", found)
            .variable("phase_velocity", &both, table(|m| m.phase_velocity), "m s-1", phase)
            .variable("group_velocity", &both, table(|m| m.group_velocity), "m s-1", energy)
            .variable("attenuation", &both, table(|m| m.attenuation), "m-1", decay)
            .variable("count", &["frequency"], counts.into_dyn(), "1", count)
            .attribute("wave", wave);
        if self.wave == SurfaceWave::Love {
            return group;
        }
        let turning = Array2::from_shape_fn((self.grounds.len(), self.count), |(i, j)| {
            self.ellipticities[i].get(j).copied().unwrap_or(f64::NAN)
        });
        let what = "horizontal over vertical axis of the surface's motion in the mode without damping, positive where it turns \
                    backward (retrograde); not a number where there is no such mode";
        group.variable("ellipticity", &both, turning.into_dyn(), "1", what)
    }

    fn with_track(&self, group: Group) -> Group {
        if self.track.iter().all(Option::is_none) {
            return group;
        }
        let column =
            |of: fn(&Option<f64>) -> f64| self.track.iter().map(of).collect::<Array1<f64>>().into_dyn();
        let found = "1 where the free track has a wave, 0 where track_phase_velocity is not a number";
        let phase =
            "phase velocity of the undamped track without ground; not a number where track_found is 0";
        group
            .variable("track_found", &["frequency"], column(|c| f64::from(u8::from(c.is_some()))), "1", found)
            .variable(
                "track_phase_velocity",
                &["frequency"],
                column(|c| c.unwrap_or(f64::NAN)),
                "m s-1",
                phase,
            )
    }

    fn concerns(&self) -> Vec<Concern> {
        let mut concerns = Vec::new();
        let at =
            |of: &dyn Fn(&Modes) -> bool| self.intervals(&self.grounds.iter().map(of).collect::<Vec<_>>());
        if let Some(where_) = at(&|g| g.count == 0) {
            concerns.push(Concern::new(
                "no-trapped-mode",
                format!("the ground has no trapped mode at {where_}: its waves lose energy downward (leaky)"),
                "so it is with stiff ground over soft, and with a layer on rock below its first resonance: read leaky waves from the map, or ask for other frequencies",
            ));
        }
        if let Some(where_) = at(&|g| g.modes.iter().any(Option::is_none)) {
            concerns.push(Concern::new(
                "mode-lost",
                format!("a mode of the undamped ground could not be followed as damping was turned on, at {where_}"),
                "it stands close to its cut-off or to another mode: see the map, or lower the loss factors",
            ));
        }
        if let Some(where_) = at(&|g| g.modes.iter().flatten().any(|m| m.group_velocity < 0.0)) {
            concerns.push(Concern::new(
                "backward-wave",
                format!("a mode carries its energy backward at {where_}"),
                "such modes come and go in pairs: `count` is not their number there, and a pair may be missing",
            ));
        }
        let apart = self.crossing.is_none() && self.leads.len() > 1;
        if apart && self.leads.iter().all(|lead| lead.is_finite()) {
            let (slower, remedy) =
                if self.leads[0] <= 0.0 { ("slower", "higher") } else { ("faster", "lower") };
            concerns.push(Concern::new(
                "no-crossing",
                format!(
                    "the free track's wave is {slower} than the ground's first mode at every frequency asked"
                ),
                format!("ask {remedy} dispersion.frequencies to see where the curves cross"),
            ));
        }
        concerns
    }

    /// "1 to 3 Hz, 7 Hz": the frequencies at which `flags` hold.
    fn intervals(&self, flags: &[bool]) -> Option<String> {
        let mut parts: Vec<(usize, usize)> = Vec::new();
        for i in (0..flags.len()).filter(|i| flags[*i]) {
            match parts.last_mut() {
                Some((_, last)) if *last + 1 == i => *last = i,
                _ => parts.push((i, i)),
            }
        }
        let f = |i: usize| trimmed(self.frequencies[i]);
        let shown = parts
            .iter()
            .take(5)
            .map(|&(a, b)| if a == b { format!("{} Hz", f(a)) } else { format!("{} to {} Hz", f(a), f(b)) });
        let text = shown.collect::<Vec<_>>().join(", ") + if parts.len() > 5 { " and more" } else { "" };
        (!parts.is_empty()).then_some(text)
    }

    /// Number and values against frequency of every mode found, with gaps.
    fn curves(&self, of: &dyn Fn(&Mode) -> f64) -> Vec<(usize, Vec<f64>)> {
        (0..self.count)
            .map(|j| {
                let value = |g: &Modes| g.modes.get(j).and_then(|m| m.as_ref()).map_or(f64::NAN, of);
                (j, self.grounds.iter().map(value).collect::<Vec<f64>>())
            })
            .filter(|(_, curve)| curve.iter().any(|v| v.is_finite()))
            .collect()
    }

    /// The compliance over frequency and phase speed, with the curves over it.
    fn map(&self, compliance: Compliance) -> (Figure, String) {
        let (component, waves) = match self.wave {
            SurfaceWave::Rayleigh => ("|u_zz|", "Rayleigh"),
            SurfaceWave::Love => ("|u_yy|", "Love"),
        };
        let cut = if self.undamped { "largest values cut off" } else { "relative to the largest" };
        let mut caption = format!(
            "Colours: modulus of the surface's compliance {component} at this frequency and phase speed, {cut}, for each \
             frequency on its own. Lines: trapped {waves} modes of the ground, slower than shear waves in its base; \
             faster, leaky waves lose energy downward and are left out."
        );
        if self.track.iter().any(Option::is_some) {
            caption += " Dashed: bending wave of the undamped track with nothing below it.";
            caption += match self.crossing {
                Some(_) => {
                    " Where it meets the first mode of the undamped ground, each taken without the other, one expects \
                     the critical speed of a single axle: an estimate only. The study critical_speed computes it \
                     with track and ground joined."
                }
                None => " It does not meet the first mode of the ground at the frequencies asked.",
            };
        }
        let figure = MapFigure {
            name: "dispersion".into(),
            title: format!("{waves} waves of the ground"),
            x_label: "frequency [Hz]".into(),
            y_label: "phase speed [m/s]".into(),
            value_label: format!("{component}, {cut} [-]"),
            x: compliance.frequencies,
            y: compliance.speeds,
            values: compliance.values,
            holds: None,
            symmetric: false,
            equal_axes: false,
            overlay: self.overlay(),
        };
        (Figure::Map(figure), caption)
    }

    /// Modes of the ground, wave of the track, their crossing.
    fn overlay(&self) -> Vec<Series> {
        let mut overlay = Vec::new();
        let curves = self.curves(&|m| m.phase_velocity);
        // all modes as one series with gaps between them
        if !curves.is_empty() {
            let (mut x, mut y) = (Vec::new(), Vec::new());
            for (_, curve) in &curves {
                x.extend(self.frequencies.iter().copied().chain([f64::NAN]));
                y.extend(curve.iter().copied().chain([f64::NAN]));
            }
            let name = if curves.len() == 1 { "the ground's first mode" } else { "modes of the ground" };
            overlay.push(Series { name: name.into(), x, y, stroke: Stroke::Solid });
        }
        if self.track.iter().any(Option::is_some) {
            overlay.push(Series {
                name: "free track".into(),
                x: self.frequencies.clone(),
                y: self.track.iter().map(|c| c.unwrap_or(f64::NAN)).collect(),
                stroke: Stroke::Dashed,
            });
        }
        if let Some(Crossing { frequency, speed }) = self.crossing {
            overlay.push(Series {
                name: format!("crossing, {speed:.1} m/s"),
                x: vec![frequency],
                y: vec![speed],
                stroke: Stroke::Points,
            });
        }
        overlay
    }

    /// H/V over frequency.
    fn ellipticity(&self) -> Option<(Figure, String)> {
        let curve = |j: usize| -> Vec<f64> {
            // on a logarithmic axis what vanishes has no place
            self.ellipticities.iter().map(|e| e.get(j).map_or(f64::NAN, |e| e.abs())).collect()
        };
        let series: Vec<Series> = (0..self.count)
            .map(|j| Series {
                name: format!("mode {j}"),
                x: self.frequencies.clone(),
                y: curve(j),
                stroke: if self.frequencies.len() > 1 { Stroke::Solid } else { Stroke::Points },
            })
            .filter(|series| series.y.iter().any(|v| v.is_finite()))
            .collect();
        let figure = LineFigure {
            log_y: true,
            series,
            ..LineFigure::new(
                "ellipticity",
                "Ellipticity of the Rayleigh modes",
                "frequency [Hz]",
                "horizontal over vertical |H/V| [1]",
            )
        };
        let caption = "Axes of the ellipse on which the surface moves, without damping: peaks where it moves sideways alone, as near \
                       the resonance of a soft layer, dips where it moves up and down alone.";
        (!figure.series.is_empty()).then_some((Figure::Lines(figure), caption.into()))
    }

    /// Group velocity and, of damped ground, attenuation.
    fn lines(&self) -> Vec<(Figure, String)> {
        let figure = |name: &str, title: &str, y_label: &str, of: &dyn Fn(&Mode) -> f64| {
            let stroke = if self.frequencies.len() > 1 { Stroke::Solid } else { Stroke::Points };
            let curves = self.curves(of);
            let series = curves.into_iter().map(|(j, y)| Series {
                name: format!("mode {j}"),
                x: self.frequencies.clone(),
                y,
                stroke,
            });
            let series = series.collect();
            Figure::Lines(LineFigure { series, ..LineFigure::new(name, title, "frequency [Hz]", y_label) })
        };
        let mut figures = Vec::new();
        if self.grounds.iter().all(|g| g.modes.iter().all(Option::is_none)) {
            return figures;
        }
        figures.push((
            figure("group_velocity", "Group velocity of the modes", "group velocity [m/s]", &|m| {
                m.group_velocity
            }),
            "Speed at which each trapped mode carries its energy.".into(),
        ));
        if !self.undamped {
            figures.push((
                figure("attenuation", "Attenuation of the modes", "attenuation [1/m]", &|m| m.attenuation),
                "Decay of each trapped mode by material damping: its amplitude falls as e^(−attenuation × distance), \
                 besides its spreading."
                    .into(),
            ));
        }
        figures
    }
}
