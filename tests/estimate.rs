//! Estimates of time against the time that is then taken, in the same process on the same threads.

use groundwave::case::Known;
use groundwave::{Case, Silent, Study};
use std::path::Path;
use std::time::{Duration, Instant};

/// A case of the repository, made longer.
fn case(name: &str, longer: impl Fn(&mut Study)) -> Case {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("soil_cases").join(name).join("case.toml");
    let mut case = Case::load(&path).unwrap();
    case.studies.iter_mut().for_each(longer);
    case
}

#[test]
fn what_takes_seconds_is_known_after_a_tenth() {
    let receivers = |study: &mut Study| {
        if let Study::FreeField(study) = study {
            study.receivers = (0..24).map(|i| 5.0 + 1.5 * f64::from(i)).collect();
        }
    };
    let speeds = |study: &mut Study| {
        if let Study::CriticalSpeed(study) = study {
            study.speeds = (0..4000).map(|i| 5.0 + 0.045 * f64::from(i)).collect();
        }
    };
    let cases = [
        ("free field", case("lamprea2022_free_field", receivers)),
        ("speed curve", case("lamprea2022_ballasted", speeds)),
    ];
    for (name, case) in cases {
        let study = &case.studies[0];
        let begun = Instant::now();
        study.run(&case.railway, &Silent).unwrap();
        let taken = begun.elapsed();
        let begun = Instant::now();
        let estimate = case.estimate(taken / 10).unwrap().remove(0);
        assert!(begun.elapsed() < taken, "{name}: the trial is as long as the work");
        let ratio = estimate.time.as_secs_f64() / taken.as_secs_f64();
        println!("{name}: {taken:.1?}, estimated {:.1?}, ratio {ratio:.2}", estimate.time);
        // other work on the machine comes and goes: a factor of two of the estimate, and as much of that
        assert!(estimate.known == Known::Estimated && (0.25..4.0).contains(&ratio), "{name}: {ratio}");
    }
}

#[test]
fn what_ends_is_no_estimate() {
    let case = case("lamprea2022_ballasted", |_| ());
    let times = case.estimate(Duration::from_secs(20)).unwrap();
    assert!(times.iter().all(|time| time.known == Known::Ended));
    assert_eq!(times.len(), case.studies.len());
}
