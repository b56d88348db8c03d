//! What is kept of a passage while it marches: memory goes with the track and with what is shown, not with the steps.

use super::plan::Plan;
use crate::assessment::{Band, rms};
use crate::rail::fem::Mesh;
use crate::signal::{EnergySpectrum, History};
use crate::study::StudyError;
use ndarray::Array2;

/// Most samples of a history, and most values of all histories together; fewer are kept of longer passages.
const SAMPLES: usize = 20_000;
const VALUES: usize = 20_000_000;
/// Rows and columns of a waterfall.
const FALL: (usize, usize) = (200, 400);
/// Way behind a joint over which its peaks are looked for [m].
const PEAKS: f64 = 0.6;

/// Largest, smallest, mean force of one wheel.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Wheel {
    /// Static load [N].
    pub load: f64,
    /// Behind the leading one [m].
    pub behind: f64,
    /// Where it stood [m], and its force [N].
    pub max: (f64, f64),
    pub min: (f64, f64),
    /// [N]
    pub mean: f64,
    /// Off the rail [s].
    pub lost: f64,
}

/// Peaks of the leading wheel behind a dipped joint.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Peaks {
    /// Where the joint lies [m].
    pub at: f64,
    /// Distance behind it [m] and force [N] of the first, and of the largest later one.
    pub first: Option<(f64, f64)>,
    pub second: Option<(f64, f64)>,
    /// P₂ by the formula of Jenkins [N].
    pub jenkins: f64,
}

/// The rail over place and time.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Fall {
    pub time: Vec<f64>,
    pub x: Vec<f64>,
    /// [m], (time, x)
    pub values: Array2<f64>,
}

/// One passage at one speed; forces are those of one wheel, not of a wheelset.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    pub(super) speed: f64,
    /// Where the leading axle stood at first [m].
    pub(super) from: f64,
    pub(super) step: f64,
    pub(super) steps: usize,
    /// Ends of the track [m].
    pub(super) track: (f64, f64),
    /// Of the samples kept [s].
    pub(super) time: Vec<f64>,
    /// (wheel, time) [N], [m]
    pub(super) force: Array2<f64>,
    pub(super) under: Array2<f64>,
    /// Watched places [m], and rail and sleepers there (at, time) [m].
    pub(super) at: Vec<f64>,
    pub(super) rail: Array2<f64>,
    pub(super) sleeper: Array2<f64>,
    /// Numbers of sleepers that hang, and the force of the bed on each (hanging, time) [N].
    pub(super) hanging: Vec<f64>,
    pub(super) bed: Array2<f64>,
    /// Names of the degrees of freedom, and (freedom, time).
    pub(super) freedoms: Vec<String>,
    pub(super) vehicle: Array2<f64>,
    pub(super) acceleration: Array2<f64>,
    pub(super) wheels: Vec<Wheel>,
    pub(super) peaks: Vec<Peaks>,
    /// Nodes [m] and the largest displacement there [m] down and up.
    pub(super) x: Vec<f64>,
    pub(super) down: Vec<f64>,
    pub(super) up: Vec<f64>,
    pub(super) fall: Fall,
    /// Frequencies [Hz] and energy densities of the dynamic force (wheel, frequency) [N² s/Hz].
    pub(super) frequencies: Vec<f64>,
    pub(super) spectra: Array2<f64>,
    /// Centres [Hz] and (wheel, band) [N].
    pub(super) bands: Vec<f64>,
    pub(super) third_octaves: Array2<f64>,
}

impl Run {
    /// Places of the leading axle [m] at the samples kept.
    pub(super) fn ways(&self) -> Vec<f64> {
        self.time.iter().map(|t| self.from + self.speed * t).collect()
    }
}

/// The railway at one instant.
pub(super) struct Moment<'a> {
    /// Since the start [s].
    pub time: f64,
    /// Displacements of the track's unknowns.
    pub track: &'a [f64],
    /// Place [m], force of one wheel [N], displacement of the rail under it [m].
    pub wheels: Vec<(f64, f64, f64)>,
    /// Force of the bed on each sleeper that hangs [N].
    pub hanging: Vec<f64>,
    /// Displacement and acceleration of each degree of freedom.
    pub vehicle: Vec<(f64, f64)>,
}

/// A displacement by the unknowns it is made of.
type Sum = Vec<(usize, f64)>;

fn sum(of: &Sum, u: &[f64]) -> f64 {
    if of.is_empty() { f64::NAN } else { of.iter().map(|&(i, n)| n * u[i]).sum() }
}

/// Keeps what is shown of the passage at one speed.
pub(super) struct Recorder {
    run: Run,
    nodes: Vec<usize>,
    places: Vec<(Sum, Sum)>,
    columns: Vec<Sum>,
    /// Steps per sample, samples per row of the waterfall.
    stride: (usize, usize),
    /// Step, sample.
    now: (usize, usize),
    /// Place and force of the leading wheel one and two steps ago.
    before: [(f64, f64); 2],
}

impl Recorder {
    /// Of a passage by `plan` at `speed` from `from` over `mesh`, its wheels by their loads [N] and how far behind the leading one [m].
    pub(super) fn new(
        (speed, from): (f64, f64),
        plan: &Plan,
        mesh: &Mesh,
        (loads, freedoms): (Vec<(f64, f64)>, Vec<String>),
        (at, hanging, joints): (&[f64], &[i64], &[(f64, f64)]),
    ) -> Self {
        let (wheels, moving) = (loads.len(), freedoms.len());
        let channels = 2 * (wheels + at.len() + moving) + hanging.len();
        let most = (VALUES / channels.max(1)).clamp(FALL.0, SAMPLES);
        let stride = plan.count.div_ceil(most).max(1);
        let samples = plan.count / stride + 1;
        let rows = samples.div_ceil(FALL.0).max(1);
        let of = |rows: usize| Array2::zeros((rows, samples));
        let track = (mesh.x[0], mesh.x[mesh.x.len() - 1]);
        let grid = |i: usize| track.0 + (track.1 - track.0) * i as f64 / (FALL.1 - 1) as f64;
        let x: Vec<f64> = (0..FALL.1).map(grid).collect();
        let rail = |x: &f64| mesh.rail_at(*x).0.to_vec();
        let fall =
            Fall { time: Vec::new(), x: x.clone(), values: Array2::zeros((samples.div_ceil(rows), FALL.1)) };
        let peaks = joints.iter().map(|&(at, jenkins)| Peaks { at, first: None, second: None, jenkins });
        let run = Run {
            speed,
            from,
            step: plan.step,
            steps: plan.count,
            track,
            time: Vec::with_capacity(samples),
            force: of(wheels),
            under: of(wheels),
            at: at.to_vec(),
            rail: of(at.len()),
            sleeper: of(at.len()),
            hanging: hanging.iter().map(|n| *n as f64).collect(),
            bed: of(hanging.len()),
            freedoms,
            vehicle: of(moving),
            acceleration: of(moving),
            wheels: loads.into_iter().map(Wheel::under).collect(),
            peaks: peaks.collect(),
            x: mesh.x.clone(),
            down: vec![0.0; mesh.x.len()],
            up: vec![0.0; mesh.x.len()],
            fall,
            frequencies: Vec::new(),
            spectra: Array2::zeros((wheels, 0)),
            bands: Vec::new(),
            third_octaves: Array2::zeros((wheels, 0)),
        };
        Self {
            run,
            nodes: mesh.rail.clone(),
            places: at.iter().map(|x| (rail(x), mesh.below_at(1, *x))).collect(),
            columns: x.iter().map(rail).collect(),
            stride: (stride, rows),
            now: (0, 0),
            before: [(f64::NAN, f64::NAN); 2],
        }
    }

    /// Takes the next instant in: the start, then the end of every step.
    pub(super) fn take(&mut self, moment: &Moment) {
        let step = self.run.step;
        let run = &mut self.run;
        for (wheel, &(x, force, _)) in run.wheels.iter_mut().zip(&moment.wheels) {
            if force > wheel.max.1 {
                wheel.max = (x, force);
            }
            if force < wheel.min.1 {
                wheel.min = (x, force);
            }
            wheel.mean += force / (run.steps + 1) as f64;
            wheel.lost += if force == 0.0 { step } else { 0.0 };
        }
        for ((down, up), &node) in run.down.iter_mut().zip(&mut run.up).zip(&self.nodes) {
            *down = down.max(moment.track[node]);
            *up = up.max(-moment.track[node]);
        }
        if let Some(&(x, force, _)) = moment.wheels.first() {
            let [last, one_before] = self.before;
            if last.1 > one_before.1 && last.1 >= force {
                run.peaks.iter_mut().for_each(|peaks| peaks.take(last));
            }
            self.before = [(x, force), last];
        }
        if self.now.0.is_multiple_of(self.stride.0) {
            self.keep(moment);
        }
        self.now.0 += 1;
    }

    /// Keeps a sample.
    fn keep(&mut self, moment: &Moment) {
        let (run, i) = (&mut self.run, self.now.1);
        run.time.push(moment.time);
        for (wheel, &(_, force, under)) in moment.wheels.iter().enumerate() {
            run.force[(wheel, i)] = force;
            run.under[(wheel, i)] = under;
        }
        for (place, (rail, sleeper)) in self.places.iter().enumerate() {
            run.rail[(place, i)] = sum(rail, moment.track);
            run.sleeper[(place, i)] = sum(sleeper, moment.track);
        }
        for (sleeper, &force) in moment.hanging.iter().enumerate() {
            run.bed[(sleeper, i)] = force;
        }
        for (freedom, &(u, a)) in moment.vehicle.iter().enumerate() {
            run.vehicle[(freedom, i)] = u;
            run.acceleration[(freedom, i)] = a;
        }
        if i.is_multiple_of(self.stride.1) {
            run.fall.time.push(moment.time);
            for (column, of) in self.columns.iter().enumerate() {
                run.fall.values[(i / self.stride.1, column)] = sum(of, moment.track);
            }
        }
        self.now.1 += 1;
    }

    /// The run, with the third octaves between two `frequencies` [Hz].
    ///
    /// # Errors
    /// A history that is too short to have a spectrum.
    pub(super) fn finish(self, frequencies: (f64, f64)) -> Result<Run, StudyError> {
        let Self { mut run, stride, .. } = self;
        let step = run.step * stride.0 as f64;
        let known = |band: &Band| 2.0 * band.upper() * step < 1.0;
        let bands: Vec<Band> = Band::range(frequencies.0, frequencies.1)?.into_iter().filter(known).collect();
        run.bands = bands.iter().map(|band| band.centre()).collect();
        run.third_octaves = Array2::zeros((run.wheels.len(), bands.len()));
        for (i, wheel) in run.wheels.iter().enumerate() {
            let dynamic = run.force.row(i).iter().map(|force| force - wheel.mean).collect();
            let history = History::new(step, dynamic)?;
            let spectrum = EnergySpectrum::of(&history);
            let first = spectrum.frequencies().partition_point(|f| *f < frequencies.0);
            let last = spectrum.frequencies().partition_point(|f| *f <= frequencies.1);
            if i == 0 {
                run.frequencies = spectrum.frequencies()[first..last].to_vec();
                run.spectra = Array2::zeros((run.wheels.len(), last - first));
            }
            let density = spectrum.density()[first..last].iter();
            run.spectra.row_mut(i).iter_mut().zip(density).for_each(|(s, density)| *s = *density);
            for (j, band) in bands.iter().enumerate() {
                run.third_octaves[(i, j)] = rms(band.energy(&spectrum)?, history.duration())?;
            }
        }
        Ok(run)
    }
}

impl Wheel {
    /// One that has not moved yet, under its load [N] and so far behind the leading one [m].
    fn under((load, behind): (f64, f64)) -> Self {
        Self { load, behind, max: (0.0, f64::NEG_INFINITY), min: (0.0, f64::INFINITY), mean: 0.0, lost: 0.0 }
    }
}

impl Peaks {
    /// Takes a peak in: place and force.
    fn take(&mut self, (x, force): (f64, f64)) {
        let behind = x - self.at;
        if !(0.0..=PEAKS).contains(&behind) {
            return;
        }
        if self.first.is_none() {
            self.first = Some((behind, force));
        } else if self.second.is_none_or(|second| force > second.1) {
            self.second = Some((behind, force));
        }
    }
}
