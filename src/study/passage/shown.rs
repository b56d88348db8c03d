//! What a reader sees of a passage: histories, extremes, envelopes, pictures.

use super::Passed;
use super::run::{Run, Wheel};
use crate::dataset::Group;
use crate::figure::{Figure, LineFigure, MapFigure, Series, Stroke};
use crate::study::{Answer, Outcome, speed_text, tag, trimmed};
use ndarray::Array1;

/// Curves in a picture, beyond which it is a web.
const CURVES: usize = 8;

/// `values` along one dimension.
fn row(values: &[f64]) -> ndarray::ArrayD<f64> {
    Array1::from(values.to_vec()).into_dyn()
}

impl Passed {
    /// Everything a run leaves.
    pub(super) fn shown(&self) -> Outcome {
        let mut outcome =
            Outcome { group: self.group(), concerns: self.concerns.clone(), ..Outcome::default() };
        for run in &self.runs {
            outcome.answers.extend(self.answers(run));
            outcome.figures.push(self.force_figure(run));
            outcome.figures.extend(self.close_figure(run));
            outcome.figures.extend((!run.at.is_empty()).then(|| places_figure(run)));
            outcome.figures.push(envelope_figure(run));
            outcome.figures.push(waterfall(run));
            outcome.figures.extend((!run.bands.is_empty()).then(|| bands_figure(run)));
        }
        outcome
    }

    /// What the names of arrays at one speed end with: nothing where there is one speed only.
    fn suffix(&self, run: &Run) -> String {
        if self.runs.len() == 1 { String::new() } else { format!("_{}", tag(run.speed)) }
    }

    fn group(&self) -> Group {
        let first = &self.runs[0];
        let wheels: Vec<f64> = (1..=first.wheels.len()).map(|i| i as f64).collect();
        let mut group = Group::new("passage")
            .attribute("contact", self.law)
            .attribute("start", self.start)
            .attribute("track_from", first.track.0)
            .attribute("track_to", first.track.1)
            .coordinate("wheel", &wheels, "1", "wheel, from the leading one")
            .coordinate("x", &first.x, "m", "position along the track");
        if !first.at.is_empty() {
            group = group.coordinate("at", &first.at, "m", "watched places of the track");
        }
        if !first.hanging.is_empty() {
            group = group.coordinate("hanging", &first.hanging, "1", "numbers of sleepers that hang");
        }
        if !first.freedoms.is_empty() {
            let numbers: Vec<f64> = (1..=first.freedoms.len()).map(|i| i as f64).collect();
            group = group.attribute("freedoms", first.freedoms.join("; ")).coordinate(
                "freedom",
                &numbers,
                "1",
                "degree of freedom of the vehicles, named in the attribute freedoms",
            );
        }
        self.runs.iter().fold(group, |group, run| arrays(group, run, &self.suffix(run)))
    }

    fn answers(&self, run: &Run) -> Vec<Answer> {
        let (name, at) = (tag(run.speed), speed_text(run.speed));
        let mut answers = if self.rolls { forces(run) } else { Vec::new() };
        let down = run.down.iter().copied().fold(0.0, f64::max);
        answers.push(Answer::new(
            &format!("max_down_{name}"),
            format!("Largest downward rail deflection at {at}"),
            down,
            "m",
            format!("{:.4} mm", 1e3 * down),
        ));
        let (length, steps) = (run.track.1 - run.track.0, run.steps);
        answers.push(Answer::new(
            &format!("step_{name}"),
            format!("Step of time at {at}, {steps} steps on {length:.1} m of track"),
            run.step,
            "s",
            format!("{:.3e} s", run.step),
        ));
        answers
    }

    /// The force that departs most from its static load, around that place.
    fn close_figure(&self, run: &Run) -> Option<(Figure, String)> {
        if !self.rolls {
            return None;
        }
        let departs = |(wheel, i): (usize, usize)| (run.force[(wheel, i)] - run.wheels[wheel].load).abs();
        let samples = (0..run.wheels.len()).flat_map(|wheel| (0..run.time.len()).map(move |i| (wheel, i)));
        let (wheel, at) = samples.max_by(|a, b| departs(*a).total_cmp(&departs(*b)))?;
        let ways = run.ways();
        let near = |x: f64| (ways[at] - CLOSE.0..=ways[at] + CLOSE.1).contains(&x);
        // from where this wheel stands
        let behind = run.wheels[wheel].behind;
        let seen: Vec<usize> = (0..ways.len()).filter(|i| near(ways[*i])).collect();
        if seen.len() < 20 || seen.len() == ways.len() {
            return None;
        }
        let x: Vec<f64> = seen.iter().map(|i| ways[*i] - behind).collect();
        let y = seen.iter().map(|i| 1e-3 * run.force[(wheel, *i)]).collect();
        let (first, last) = (x[0], x[x.len() - 1]);
        let load = vec![1e-3 * run.wheels[wheel].load; 2];
        let name = format!("wheel {}", wheel + 1);
        let marks = self.marks.iter().filter(|mark| (first..=last).contains(&mark.0)).cloned();
        let picture = LineFigure {
            marks: marks.collect(),
            series: vec![
                Series { name, x, y, stroke: Stroke::Solid },
                Series { name: "static load".into(), x: vec![first, last], y: load, stroke: Stroke::Dashed },
            ],
            ..LineFigure::new(
                format!("passage_force_close_{}", tag(run.speed)),
                format!("Contact force where it departs most at {}", speed_text(run.speed)),
                "wheel at x [m]",
                "force of one wheel [kN]",
            )
        };
        let caption = format!(
            "Force of wheel {} at {}, over its own place, around the largest difference from its static load (dashed).",
            wheel + 1,
            speed_text(run.speed)
        );
        Some((Figure::Lines(picture), caption))
    }

    /// Forces of the first wheels over the way of the leading axle, with the static load.
    fn force_figure(&self, run: &Run) -> (Figure, String) {
        let at = speed_text(run.speed);
        let x = run.ways();
        let curve = |wheel: usize| Series {
            name: format!("wheel {}", wheel + 1),
            x: x.clone(),
            y: run.force.row(wheel).iter().map(|force| 1e-3 * force).collect(),
            stroke: Stroke::Solid,
        };
        let still = run.wheels[0].load;
        let line = Series {
            name: "static load".into(),
            x: vec![x[0], x[x.len() - 1]],
            y: vec![1e-3 * still; 2],
            stroke: Stroke::Dashed,
        };
        let picture = LineFigure {
            series: (0..run.wheels.len().min(CURVES)).map(curve).chain([line]).collect(),
            marks: self.marks.clone(),
            ..LineFigure::new(
                format!("passage_force_{}", tag(run.speed)),
                format!("Contact forces at {at}"),
                "leading axle at x [m]",
                "force of one wheel [kN]",
            )
        };
        let more = run.wheels.len().saturating_sub(CURVES);
        let more =
            if more == 0 { String::new() } else { format!(" {more} more wheels stand in results.h5.") };
        let caption = format!(
            "Force between each wheel and its rail at {at}, over the place of the leading axle; dashed the static load of the leading wheel.{more}"
        );
        (Figure::Lines(picture), caption)
    }
}

/// Way before and behind its largest change over which a force is drawn once more [m].
const CLOSE: (f64, f64) = (0.25, 0.75);

/// Largest and smallest force of all wheels, time off the rail, peaks behind joints.
fn forces(run: &Run) -> Vec<Answer> {
    let (name, at) = (tag(run.speed), speed_text(run.speed));
    let kilo = |key: &str, what: String, value: f64, more: String| {
        Answer::new(&format!("{key}_{name}"), what, value, "N", format!("{:.2} kN{more}", 1e-3 * value))
    };
    let place = |(wheel, (x, _)): (usize, (f64, f64))| format!(" (wheel {} at {x:.3} m)", wheel + 1);
    let by_force = |a: &(usize, (f64, f64)), b: &(usize, (f64, f64))| a.1.1.total_cmp(&b.1.1);
    let high = run.wheels.iter().map(|wheel| wheel.max).enumerate().max_by(by_force);
    let low = run.wheels.iter().map(|wheel| wheel.min).enumerate().min_by(by_force);
    let mut answers: Vec<Answer> = [("max_force", "Largest", high), ("min_force", "Smallest", low)]
        .into_iter()
        .filter_map(|(key, word, found)| {
            let found = found?;
            Some(kilo(key, format!("{word} contact force at {at}"), found.1.1, place(found)))
        })
        .collect();
    let lost = run.wheels.iter().map(|wheel| wheel.lost).fold(0.0, f64::max);
    answers.push(Answer::new(
        &format!("lost_contact_{name}"),
        format!("Longest time a wheel is off the rail at {at}, in all"),
        lost,
        "s",
        format!("{:.3} ms", 1e3 * lost),
    ));
    for peaks in &run.peaks {
        let near = format!("after the joint at {} m, at {at}", trimmed(peaks.at));
        let jenkins = Some((f64::NAN, peaks.jenkins));
        for (key, what, peak) in [
            ("p1", "First peak", peaks.first),
            ("p2", "Largest later peak", peaks.second),
            ("p2_jenkins", "P2 by the formula of Jenkins, a support force,", jenkins),
        ] {
            let more =
                |x: f64| if x.is_nan() { String::new() } else { format!(" ({:.1} mm behind it)", 1e3 * x) };
            answers.extend(peak.map(|(x, force)| kilo(key, format!("{what} {near}"), force, more(x))));
        }
    }
    answers
}

/// The arrays of one speed.
fn arrays(mut group: Group, run: &Run, suffix: &str) -> Group {
    let named = |name: &str| format!("{name}{suffix}");
    let time = named("time");
    group = group.coordinate(&time, &run.time, "s", "time since the start");
    group = group.variable(&named("position"), &[&time], row(&run.ways()), "m", "place of the leading axle");
    let down = "rail displacement, positive down";
    let bodies = "of the bodies, positive down; rotations in radians";
    let (moved, speeding) = (format!("displacement {bodies}"), format!("acceleration, unfiltered, {bodies}"));
    for (name, over, values, unit, what) in [
        ("contact_force", "wheel", &run.force, "N", "force between wheel and rail, of one wheel"),
        ("rail_under_wheel", "wheel", &run.under, "m", "rail displacement under the wheel, positive down"),
        ("rail", "at", &run.rail, "m", down),
        ("sleeper", "at", &run.sleeper, "m", "displacement of the nearest sleeper, positive down"),
        ("bed_force", "hanging", &run.bed, "N", "force of the bed on the sleeper"),
        ("vehicle", "freedom", &run.vehicle, "m", &moved),
        ("vehicle_acceleration", "freedom", &run.acceleration, "m s-2", &speeding),
    ] {
        if values.nrows() > 0 {
            group = group.variable(&named(name), &[over, &time], values.clone().into_dyn(), unit, what);
        }
    }
    let of = |f: fn(&Wheel) -> f64| run.wheels.iter().map(f).collect::<Vec<_>>();
    for (name, over, values, unit, what) in [
        ("rail_max_down", "x", run.down.clone(), "m", "largest rail displacement, positive down"),
        ("rail_max_up", "x", run.up.clone(), "m", "largest rail displacement upward, positive up"),
        ("max_force", "wheel", of(|w| w.max.1), "N", "largest contact force"),
        ("min_force", "wheel", of(|w| w.min.1), "N", "smallest contact force"),
        ("mean_force", "wheel", of(|w| w.mean), "N", "mean contact force"),
        ("lost_contact", "wheel", of(|w| w.lost), "s", "time off the rail"),
    ] {
        group = group.variable(&named(name), &[over], row(&values), unit, what);
    }
    if !run.frequencies.is_empty() {
        let (frequency, values) = (named("frequency"), run.spectra.clone().into_dyn());
        let what = "energy density of the dynamic contact force over frequency";
        group = group.coordinate(&frequency, &run.frequencies, "Hz", "frequency").variable(
            &named("force_spectrum"),
            &["wheel", &frequency],
            values,
            "N2 s Hz-1",
            what,
        );
    }
    if run.bands.is_empty() {
        return group;
    }
    let (band, values) = (named("band"), run.third_octaves.clone().into_dyn());
    let what = "r.m.s. of the dynamic contact force over the passage";
    group.coordinate(&band, &run.bands, "Hz", "centre of the third-octave band").variable(
        &named("force_third_octave"),
        &["wheel", &band],
        values,
        "N",
        what,
    )
}

/// Rail and sleepers at the watched places.
fn places_figure(run: &Run) -> (Figure, String) {
    let at = speed_text(run.speed);
    let curve = |what: &str, values: &ndarray::Array2<f64>, i: usize, stroke| Series {
        name: format!("{what} at {} m", trimmed(run.at[i])),
        x: run.time.clone(),
        y: values.row(i).iter().map(|u| 1e3 * u).collect(),
        stroke,
    };
    let rails = (0..run.at.len().min(CURVES / 2)).map(|i| curve("rail", &run.rail, i, Stroke::Solid));
    let sleepers: Vec<Series> = (0..run.at.len().min(CURVES / 2))
        .map(|i| curve("sleeper", &run.sleeper, i, Stroke::Dashed))
        .filter(|curve| curve.y.iter().all(|u| u.is_finite()))
        .collect();
    let (title, caption) = if sleepers.is_empty() {
        ("Rail", "Rail")
    } else {
        ("Rail and sleepers", "Rail (solid) and nearest sleeper (dashed)")
    };
    let picture = LineFigure {
        y_down: true,
        series: rails.chain(sleepers).collect(),
        ..LineFigure::new(
            format!("passage_places_{}", tag(run.speed)),
            format!("{title} at {at}"),
            "time [s]",
            "displacement [mm], positive down",
        )
    };
    (Figure::Lines(picture), format!("{caption} while the train passes at {at}."))
}

fn envelope_figure(run: &Run) -> (Figure, String) {
    let at = speed_text(run.speed);
    let curve = |name: &str, values: Vec<f64>| Series {
        name: name.into(),
        x: run.x.clone(),
        y: values.iter().map(|u| 1e3 * u).collect(),
        stroke: Stroke::Solid,
    };
    let up = run.up.iter().map(|u| -u).collect();
    let picture = LineFigure {
        y_down: true,
        series: vec![curve("largest", run.down.clone()), curve("smallest", up)],
        ..LineFigure::new(
            format!("passage_envelope_{}", tag(run.speed)),
            format!("Envelope of the rail at {at}"),
            "x along the track [m]",
            "displacement [mm], positive down",
        )
    };
    (
        Figure::Lines(picture),
        format!("Largest and smallest displacement of the rail along the track during the passage at {at}."),
    )
}

fn waterfall(run: &Run) -> (Figure, String) {
    let at = speed_text(run.speed);
    let map = MapFigure {
        name: format!("passage_waterfall_{}", tag(run.speed)),
        title: format!("Rail in space and time at {at}"),
        x_label: "x along the track [m]".into(),
        y_label: "time [s]".into(),
        value_label: "rail [mm], positive down".into(),
        x: run.fall.x.clone(),
        y: run.fall.time.clone(),
        values: run.fall.values.mapv(|u| 1e3 * u),
        holds: None,
        symmetric: true,
        equal_axes: false,
        overlay: Vec::new(),
    };
    (Figure::Map(map), format!("Displacement of the rail over place and time as the train passes at {at}."))
}

fn bands_figure(run: &Run) -> (Figure, String) {
    let at = speed_text(run.speed);
    let curve = |wheel: usize| Series {
        name: format!("wheel {}", wheel + 1),
        x: run.bands.clone(),
        y: run.third_octaves.row(wheel).iter().map(|force| 1e-3 * force).collect(),
        stroke: Stroke::Solid,
    };
    let picture = LineFigure {
        log_x: true,
        log_y: true,
        series: (0..run.wheels.len().min(CURVES)).map(curve).collect(),
        ..LineFigure::new(
            format!("passage_bands_{}", tag(run.speed)),
            format!("Third octaves of the contact force at {at}"),
            "frequency [Hz]",
            "r.m.s. force [kN]",
        )
    };
    (
        Figure::Lines(picture),
        format!("Third octaves of the force of each wheel less its mean, r.m.s. over the passage at {at}."),
    )
}
