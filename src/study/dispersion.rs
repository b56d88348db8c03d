//! Which waves travel along the ground by themselves, which along the track, and where do the two meet?

use super::{Answer, Model, Outcome, StudyError, speed_text, trimmed};
use crate::concern::Concern;
use crate::dataset::Group;
use crate::figure::{Figure, LineFigure, MapFigure, Series, Stroke};
use crate::math::root;
use crate::progress::Observer;
use crate::soil::dispersion::{Mode, Modes, SurfaceWave, modes};
use crate::soil::{GroundSolver, Profile, Solver};
use crate::track::Stack;
use ndarray::{Array1, Array2, Axis};
use rayon::prelude::*;
use std::f64::consts::TAU;

/// Values of the map along frequency and along speed.
const GRID: (usize, usize) = (240, 240);
/// Share of the values at a frequency above which undamped ground, whose compliance has poles, is cut off.
const POLES: f64 = 0.04;
/// Accuracy of the crossing, relative.
const CROSSING: f64 = 1e-9;

/// The dispersion curves.
#[derive(Clone, Debug, PartialEq)]
pub struct Dispersion {
    /// f [Hz], above zero, ascending.
    pub frequencies: Vec<f64>,
    /// How many modes, the slowest first.
    pub modes: usize,
    /// Which waves.
    pub wave: SurfaceWave,
}

/// Where the free track's wave becomes faster than the ground's first mode.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Crossing {
    /// [Hz]
    frequency: f64,
    /// [m/s]
    speed: f64,
}

/// The phase velocity [m/s] of the free track at `omega` [rad/s].
fn track_speed(stack: &Stack, omega: f64) -> Option<f64> {
    Some(omega / stack.free_wave(omega)?)
}

/// Phase velocity [m/s] of the free track less that of the first mode of `elastic` ground; NaN where one is missing.
fn lead(stack: &Stack, elastic: &Profile, omega: f64) -> f64 {
    let ground = modes(elastic, SurfaceWave::Rayleigh, omega, 1).modes.first().copied().flatten();
    match (track_speed(stack, omega), ground) {
        (Some(track), Some(ground)) => track - ground.phase_velocity,
        _ => f64::NAN,
    }
}

impl Dispersion {
    /// Phase velocity, group velocity and attenuation of the slowest trapped modes (frequency, mode) of the ground with its
    /// damping; phase velocity of the free undamped track; their crossing, both undamped, refined to 1e-9.
    ///
    /// Accuracy: that of [`modes`] and [`Stack::free_wave`]; published curves to 5e-9, crossings to 1e-7, all the
    /// digits printed (test `papers::mezher`).
    ///
    /// # Errors
    /// A model on springs.
    pub fn run(&self, model: &Model, observer: &dyn Observer) -> Result<Outcome, StudyError> {
        let (profile, solver) = model.ground("dispersion")?;
        // a track moves the ground vertically: it has no part in waves across
        let stack = Some(model.stack()).filter(|_| self.wave == SurfaceWave::Rayleigh);
        let elastic = profile.with_loss_times(0.0);
        observer.begin("dispersion", self.frequencies.len() as u64);
        let found: Vec<(Modes, Option<f64>, f64)> = self
            .frequencies
            .par_iter()
            .map(|f| {
                let omega = TAU * f;
                let ground = modes(profile, self.wave, omega, self.modes);
                let track = stack.and_then(|stack| track_speed(stack, omega));
                let lead = stack.map_or(f64::NAN, |stack| lead(stack, &elastic, omega));
                observer.advance();
                (ground, track, lead)
            })
            .collect();
        let grounds: Vec<&Modes> = found.iter().map(|f| &f.0).collect();
        let track: Vec<Option<f64>> = found.iter().map(|f| f.1).collect();
        let leads: Vec<f64> = found.iter().map(|f| f.2).collect();
        let crossing = stack.and_then(|stack| self.crossing(stack, &elastic, &leads));
        let mut figures = self.map(profile, solver, (&grounds, &track), crossing)?;
        observer.end();
        figures.extend(self.lines(profile, &grounds));
        let mut answers = Vec::new();
        if let Some(Crossing { frequency, speed }) = crossing {
            answers = vec![
                Answer::new(
                    "crossing_speed",
                    "Crossing of track and ground, uncoupled: an estimate",
                    speed,
                    "m/s",
                    format!("{} (in full: the study critical_speed)", speed_text(speed)),
                ),
                Answer::new(
                    "crossing_frequency",
                    "Its frequency",
                    frequency,
                    "Hz",
                    format!("{frequency:.2} Hz"),
                ),
            ];
        }
        Ok(Outcome {
            group: self.group(&grounds, &track, crossing),
            figures,
            answers,
            concerns: self.concerns(&grounds, crossing.is_none().then_some(&leads)),
        })
    }

    /// The first place where the track's wave overtakes the ground's; a curve that leaps over the other does not meet it.
    fn crossing(&self, stack: &Stack, elastic: &Profile, leads: &[f64]) -> Option<Crossing> {
        let steps = leads.windows(2).zip(self.frequencies.windows(2));
        steps.filter(|(lead, _)| lead[0] <= 0.0 && lead[1] > 0.0).find_map(|(_, f)| {
            let difference = |omega| lead(stack, elastic, omega);
            let omega = root::bracketed(difference, TAU * f[0], TAU * f[1], CROSSING)?;
            let speed = track_speed(stack, omega)?;
            let met = difference(omega).abs() < 1e3 * CROSSING * speed;
            met.then_some(Crossing { frequency: omega / TAU, speed })
        })
    }

    fn group(&self, grounds: &[&Modes], track: &[Option<f64>], crossing: Option<Crossing>) -> Group {
        let table = |of: &dyn Fn(&Mode) -> f64| {
            Array2::from_shape_fn((grounds.len(), self.modes), |(i, j)| {
                grounds[i].modes.get(j).and_then(|m| m.as_ref()).map_or(f64::NAN, of)
            })
            .into_dyn()
        };
        let found = Array2::from_shape_fn((grounds.len(), self.modes), |(i, j)| {
            f64::from(u8::from(grounds[i].modes.get(j).is_some_and(Option::is_some)))
        });
        let column = |values: Vec<f64>| Array1::from(values).into_dyn();
        let numbers: Vec<f64> = (0..self.modes).map(|i| i as f64).collect();
        let (along, both) = (["frequency"], ["frequency", "mode"]);
        let mut group = Group::new("dispersion")
            .coordinate("frequency", &self.frequencies, "Hz", "frequency")
            .coordinate("mode", &numbers, "1", "number of the mode, the slowest first")
            .variable(
                "found",
                &both,
                found.into_dyn(),
                "1",
                "1 where the mode was found, 0 where its values are not a number",
            )
            .variable(
                "phase_velocity",
                &both,
                table(&|m| m.phase_velocity),
                "m s-1",
                "phase velocity of the mode; not a number where found is 0",
            )
            .variable(
                "group_velocity",
                &both,
                table(&|m| m.group_velocity),
                "m s-1",
                "group velocity of the mode; not a number where found is 0",
            )
            .variable(
                "attenuation",
                &both,
                table(&|m| m.attenuation),
                "m-1",
                "decay of the mode's amplitude per metre; not a number where found is 0",
            )
            .variable(
                "count",
                &along,
                column(grounds.iter().map(|g| g.count as f64).collect()),
                "1",
                "number of trapped modes of the undamped ground, counted independently",
            )
            .attribute(
                "wave",
                match self.wave {
                    SurfaceWave::Rayleigh => "rayleigh",
                    SurfaceWave::Love => "love",
                },
            );
        if track.iter().any(Option::is_some) {
            group = group
                .variable(
                    "track_found",
                    &along,
                    column(track.iter().map(|c| f64::from(u8::from(c.is_some()))).collect()),
                    "1",
                    "1 where the free track has a wave, 0 where track_phase_velocity is not a number",
                )
                .variable(
                    "track_phase_velocity",
                    &along,
                    column(track.iter().map(|c| c.unwrap_or(f64::NAN)).collect()),
                    "m s-1",
                    "phase velocity of the undamped track without ground; not a number where track_found is 0",
                );
        }
        match crossing {
            Some(Crossing { frequency, speed }) => {
                group.attribute("crossing_speed", speed).attribute("crossing_frequency", frequency)
            }
            None => group,
        }
    }

    /// `leads` where track and ground did not cross.
    fn concerns(&self, grounds: &[&Modes], leads: Option<&Vec<f64>>) -> Vec<Concern> {
        let mut concerns = Vec::new();
        let at =
            |of: &dyn Fn(&Modes) -> bool| self.intervals(&grounds.iter().map(|g| of(g)).collect::<Vec<_>>());
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
        if let Some(leads) = leads.filter(|l| l.len() > 1 && l.iter().all(|lead| lead.is_finite())) {
            let (slower, remedy) = if leads[0] <= 0.0 { ("slower", "higher") } else { ("faster", "lower") };
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
    fn curves(&self, grounds: &[&Modes], of: &dyn Fn(&Mode) -> f64) -> Vec<(usize, Vec<f64>)> {
        (0..self.modes)
            .map(|j| {
                let value = |g: &&Modes| g.modes.get(j).and_then(|m| m.as_ref()).map_or(f64::NAN, of);
                (j, grounds.iter().map(value).collect::<Vec<f64>>())
            })
            .filter(|(_, curve)| curve.iter().any(|v| v.is_finite()))
            .collect()
    }

    /// The compliance over frequency and phase speed, with the curves over it. None for a single frequency.
    fn map(
        &self,
        profile: &Profile,
        solver: Solver,
        (grounds, track): (&[&Modes], &[Option<f64>]),
        crossing: Option<Crossing>,
    ) -> Result<Vec<(Figure, String)>, StudyError> {
        let (first, last) = (self.frequencies[0], self.frequencies[self.frequencies.len() - 1]);
        if first == last {
            return Ok(Vec::new());
        }
        let curves = self.curves(grounds, &|m| m.phase_velocity);
        let shear = profile.materials().map(|m| m.c_s()).fold(0.0, f64::max);
        let speeds = || curves.iter().flat_map(|(_, curve)| curve).copied().filter(|c| c.is_finite());
        let slowest = speeds().fold(profile.slowest_rayleigh_speed(), f64::min);
        // on rock a mode begins infinitely fast
        let fastest = speeds().fold(0.0, f64::max).min(1.5 * shear);
        let fastest = if fastest > 0.0 { fastest } else { shear };
        let even = |low: f64, high: f64, n: usize| -> Vec<f64> {
            (0..n).map(|i| low + (high - low) * i as f64 / (n - 1) as f64).collect()
        };
        let x = even(first, last, GRID.0);
        let y = even(0.5 * slowest, 1.3 * fastest, GRID.1);
        let columns = x
            .par_iter()
            .map(|f| {
                let ground = solver.prepare(profile, TAU * f, &[])?;
                let modulus = |c: &f64| {
                    let u = ground.surface(TAU * f / c);
                    let u = if self.wave == SurfaceWave::Love { u.u_yy } else { u.u_zz };
                    if u.is_finite() { u.norm() } else { f64::INFINITY }
                };
                Ok(relative(y.iter().map(modulus).collect(), profile.is_undamped()))
            })
            .collect::<Result<Vec<_>, StudyError>>()?;
        let mut values = Array2::zeros((GRID.1, GRID.0));
        for (mut column, computed) in values.axis_iter_mut(Axis(1)).zip(columns) {
            column.assign(&Array1::from(computed));
        }
        // all modes as one series with gaps between them
        let mut overlay = Vec::new();
        if !curves.is_empty() {
            let (mut x, mut y) = (Vec::new(), Vec::new());
            for (_, curve) in &curves {
                x.extend(self.frequencies.iter().copied().chain([f64::NAN]));
                y.extend(curve.iter().copied().chain([f64::NAN]));
            }
            let name = if curves.len() == 1 { "the ground's first mode" } else { "modes of the ground" };
            overlay.push(Series { name: name.into(), x, y, stroke: Stroke::Solid });
        }
        if track.iter().any(Option::is_some) {
            overlay.push(Series {
                name: "free track".into(),
                x: self.frequencies.clone(),
                y: track.iter().map(|c| c.unwrap_or(f64::NAN)).collect(),
                stroke: Stroke::Dashed,
            });
        }
        if let Some(Crossing { frequency, speed }) = crossing {
            overlay.push(Series {
                name: format!("crossing, {speed:.1} m/s"),
                x: vec![frequency],
                y: vec![speed],
                stroke: Stroke::Points,
            });
        }
        let (component, waves) = match self.wave {
            SurfaceWave::Rayleigh => ("|u_zz|", "Rayleigh"),
            SurfaceWave::Love => ("|u_yy|", "Love"),
        };
        let cut = if profile.is_undamped() { "largest values cut off" } else { "relative to the largest" };
        let mut caption = format!(
            "Colours: modulus of the surface's compliance {component} at this frequency and phase speed, {cut}, for each \
             frequency on its own. Lines: trapped {waves} modes of the ground, slower than shear waves in its base; \
             faster, leaky waves lose energy downward and are left out."
        );
        if track.iter().any(Option::is_some) {
            caption += " Dashed: bending wave of the undamped track with nothing below it.";
            caption += match crossing {
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
            x,
            y,
            values,
            symmetric: false,
            equal_axes: false,
            overlay,
        };
        Ok(vec![(Figure::Map(figure), caption)])
    }

    /// Group velocity and, of damped ground, attenuation.
    fn lines(&self, profile: &Profile, grounds: &[&Modes]) -> Vec<(Figure, String)> {
        let figure = |name: &str, title: &str, y_label: &str, of: &dyn Fn(&Mode) -> f64| {
            let stroke = if self.frequencies.len() > 1 { Stroke::Solid } else { Stroke::Points };
            let curves = self.curves(grounds, of);
            let series = curves.into_iter().map(|(j, y)| Series {
                name: format!("mode {j}"),
                x: self.frequencies.clone(),
                y,
                stroke,
            });
            Figure::Lines(LineFigure {
                name: name.into(),
                title: title.into(),
                x_label: "frequency [Hz]".into(),
                y_label: y_label.into(),
                second_x: None,
                y_down: false,
                log_x: false,
                log_y: false,
                series: series.collect(),
                marks: Vec::new(),
            })
        };
        let mut figures = Vec::new();
        if grounds.iter().all(|g| g.modes.iter().all(Option::is_none)) {
            return figures;
        }
        figures.push((
            figure("group_velocity", "Group velocity of the modes", "group velocity [m/s]", &|m| {
                m.group_velocity
            }),
            "Speed at which each trapped mode carries its energy.".into(),
        ));
        if !profile.is_undamped() {
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

/// `values` over their largest one, or, where there are poles, over the one that a share [`POLES`] of them exceeds.
fn relative(values: Vec<f64>, poles: bool) -> Vec<f64> {
    let mut sorted = values.clone();
    sorted.sort_by(f64::total_cmp);
    let last = sorted.len() - 1;
    let place = if poles { ((1.0 - POLES) * last as f64) as usize } else { last };
    let reference = sorted[place];
    values.into_iter().map(|v| if v < reference { v / reference } else { 1.0 }).collect()
}
