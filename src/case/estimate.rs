//! How long a case takes, by trying: every study runs for a moment, and what it has not done by then is reckoned from what it has.

use super::Case;
use super::solved::StudyFailed;
use crate::progress::Observer;
use crate::railway::Railway;
use crate::study::{Study, StudyError};
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// What one study takes.
#[derive(Clone, Debug, PartialEq)]
pub struct StudyTime {
    /// Which.
    pub study: &'static str,
    /// Whether it is the second time, by the solver of `verify`.
    pub verifying: bool,
    /// Of the wall clock.
    pub time: Duration,
    /// How it is known.
    pub known: Known,
}

/// How a time is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Known {
    /// The study ended within its trial.
    Ended,
    /// By what part of it was done.
    Estimated,
    /// It takes more: nothing that can be counted was done.
    More,
}

/// A stage of a study as it was seen.
#[derive(Clone, Debug, PartialEq)]
struct Stage {
    what: String,
    steps: u64,
    done: u64,
}

impl Stage {
    /// What of it is done.
    fn share(&self) -> f64 {
        (self.done as f64 / self.steps.max(1) as f64).min(1.0)
    }
}

/// Counts stages and steps, and has enough from a moment on.
struct Trial {
    until: Instant,
    stages: Mutex<Vec<Stage>>,
}

impl Observer for Trial {
    fn begin(&self, what: &str, steps: u64) {
        if let Ok(mut stages) = self.stages.lock() {
            stages.push(Stage { what: what.to_owned(), steps, done: 0 });
        }
    }

    fn advance(&self) {
        if let Ok(mut stages) = self.stages.lock()
            && let Some(stage) = stages.last_mut()
        {
            stage.done += 1;
        }
    }

    fn cancelled(&self) -> bool {
        Instant::now() > self.until
    }
}

/// A stage, its share of a study's time, and the shares of its rounds, where it is gone through several times.
type Share = (&'static str, f64, &'static [f64]);

/// Of a free field on a rough rail. Measured: with one wheelset, ten profiles and four receivers 3, 54, 11, 16 and 17 %, with 32 wheelsets, one
/// profile and three receivers 1, 33, 32, 14 and 20 %; rounds of the ground 24 to 23, 26 to 25, 36 to 42, 13 to 10 %.
const ROUGH: [Share; 5] = [
    ("quasi-static", 0.02, &[1.0]),
    ("ground", 0.43, &[0.24, 0.26, 0.38, 0.12]),
    ("contact forces", 0.2, &[0.15, 0.15, 0.15, 0.2, 0.2, 0.15]),
    ("dynamic", 0.15, &[1.0]),
    ("bands", 0.2, &[1.0]),
];

/// The share of its work that a study has done by its `stages`: of the last one as many steps as it has, all of those before; at most
/// all of it.
fn done(shares: &[Share], stages: &[Stage]) -> f64 {
    let Some(last) = stages.last() else { return 0.0 };
    let within = last.share();
    let Some(place) = shares.iter().position(|share| share.0 == last.what) else { return within };
    let rounds = shares[place].2;
    let before = stages.iter().filter(|stage| stage.what == last.what).count() - 1;
    let over: f64 = rounds.iter().take(before).sum();
    let now = rounds.get(before).copied().unwrap_or(0.0) * within;
    let earlier: f64 = shares[..place].iter().map(|share| share.1).sum();
    (earlier + shares[place].1 * (over + now)).min(1.0)
}

impl Case {
    /// What every study takes on the threads there are, each tried for as long as `trial` and no more than a second longer; without pictures and
    /// files.
    ///
    /// Accuracy: within a factor of two for what takes some seconds (`tests/estimate.rs`).
    ///
    /// # Errors
    /// A study that fails: it would fail as well when the case is run.
    pub fn estimate(&self, trial: Duration) -> Result<Vec<StudyTime>, StudyFailed> {
        let mut times = Vec::new();
        for study in &self.studies {
            let name = study.name();
            let failed = |source| StudyFailed { study: name, source };
            times.push(tried(study, &self.railway, trial).map_err(failed)?);
            // what has no second answer is a concern of the run, no failure
            let again = self.witness.iter().filter_map(|witness| tried(study, witness, trial).ok());
            let otherwise = study.witness(&self.railway);
            let otherwise = otherwise.and_then(|(second, _)| tried(&second, &self.railway, trial).ok());
            times.extend(again.chain(otherwise).map(|time| StudyTime { verifying: true, ..time }));
        }
        Ok(times)
    }
}

/// What `study` takes, tried for as long as `trial`.
fn tried(study: &Study, railway: &Railway, trial: Duration) -> Result<StudyTime, StudyError> {
    let begun = Instant::now();
    let observer = Trial { until: begun + trial, stages: Mutex::default() };
    let result = study.run(railway, &observer);
    let elapsed = begun.elapsed();
    let of = |time, known| StudyTime { study: study.name(), verifying: false, time, known };
    match result {
        Ok(_) => return Ok(of(elapsed, Known::Ended)),
        Err(error) if !error.is_cancelled() => return Err(error),
        Err(_) => {}
    }
    let stages = observer.stages.into_inner().unwrap_or_default();
    let share = match study {
        // a stage for each
        Study::Contour(contour) => {
            let over = stages.len().saturating_sub(1) as f64;
            (over + stages.last().map_or(0.0, Stage::share)) / contour.speeds.len() as f64
        }
        _ => done(&ROUGH, &stages),
    };
    let known = if share > 0.0 { Known::Estimated } else { Known::More };
    Ok(of(if share > 0.0 { elapsed.div_f64(share.min(1.0)) } else { elapsed }, known))
}

/// A time in words, rounded as an estimate is: "less than a second", "about 20 s", "about 3 min", "about 2 h".
pub fn about(time: Duration) -> String {
    let rounded = |value: f64| {
        let steps = [1.0, 2.0, 3.0, 4.0, 5.0, 7.0, 10.0, 15.0, 20.0, 30.0, 40.0, 50.0];
        steps
            .into_iter()
            .min_by(|a, b| (a / value).ln().abs().total_cmp(&(b / value).ln().abs()))
            .unwrap_or(value)
    };
    match time.as_secs_f64() {
        seconds if seconds < 0.75 => "less than a second".into(),
        seconds if seconds < 55.0 => format!("about {} s", rounded(seconds)),
        seconds if seconds < 3300.0 => format!("about {} min", rounded(seconds / 60.0)),
        seconds if seconds < 180_000.0 => format!("about {} h", rounded(seconds / 3600.0)),
        seconds => format!("about {:.0} days", seconds / 86_400.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_done_by_stages() {
        let stage = |what: &str, steps, done| Stage { what: what.into(), steps, done };
        assert_eq!(done(&ROUGH, &[]), 0.0);
        // a study of one stage
        assert_eq!(done(&ROUGH, &[stage("contour", 100, 25)]), 0.25);
        assert_eq!(done(&ROUGH, &[stage("contour", 0, 3)]), 1.0);
        let shares: [Share; 2] = [("a", 0.2, &[1.0]), ("b", 0.8, &[0.25, 0.75])];
        let (first, second) = (stage("a", 4, 4), stage("b", 9, 9));
        assert!((done(&shares, &[first.clone(), stage("b", 10, 5)]) - 0.3).abs() < 1e-12);
        assert!((done(&shares, &[first.clone(), second.clone(), stage("b", 10, 5)]) - 0.7).abs() < 1e-12);
        // more rounds than are known say nothing more
        assert!((done(&shares, &[first, second.clone(), second, stage("b", 9, 1)]) - 1.0).abs() < 1e-12);
        assert!(ROUGH.iter().all(|share| (share.2.iter().sum::<f64>() - 1.0).abs() < 1e-12));
    }

    #[test]
    fn times_are_rounded_as_estimates_are() {
        let of = |seconds| about(Duration::from_secs_f64(seconds));
        assert_eq!(
            [0.3, 1.2, 12.0, 26.0].map(of),
            ["less than a second", "about 1 s", "about 10 s", "about 30 s"]
        );
        assert_eq!([55.0, 200.0, 3300.0].map(of), ["about 1 min", "about 3 min", "about 1 h"]);
        assert_eq!([36_000.0, 400_000.0].map(of), ["about 10 h", "about 5 days"]);
    }
}
