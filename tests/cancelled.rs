//! Long work ends within a second of being told to, whatever it is.

use groundwave::{Case, Observer, Study};
use std::collections::BTreeMap;
use std::path::Path;
use std::time::{Duration, Instant};

/// Has enough from a moment on.
struct Until(Instant);

impl Observer for Until {
    fn cancelled(&self) -> bool {
        Instant::now() > self.0
    }
}

/// The same study with so many items that it does not end by itself.
fn long(study: &mut Study) {
    let many = |list: &mut Vec<f64>| {
        let (from, to) = (list[0], list[list.len() - 1] + 1.0);
        *list = (0..200_000).map(|i| from + (to - from) * f64::from(i) / 2e5).collect();
    };
    match study {
        Study::CriticalSpeed(study) => many(&mut study.speeds),
        Study::Dispersion(study) => many(&mut study.frequencies),
        Study::Receptance(study) if study.map.is_none() => many(&mut study.frequencies),
        Study::DecayRate(study) => many(&mut study.frequencies),
        Study::Transition(study) => many(&mut study.frequencies),
        Study::EquivalentStiffness(study) => many(&mut study.frequencies),
        Study::SurfaceCompliance(study) => {
            many(&mut study.frequencies);
            study.k = (1..=1000).map(|i| 0.01 * f64::from(i)).collect();
        }
        Study::TrackResponse(study) => study.speeds = vec![study.speeds[0]; 10_000],
        Study::Contour(study) => study.speeds = vec![study.speeds[0]; 100],
        _ => {}
    }
}

/// Every study of every case, told to stop after a third of a second. The latest: 0.26 s, a map of receptances.
#[test]
fn every_study_stops_within_a_second() {
    let mut latest = BTreeMap::<&str, Duration>::new();
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let files = std::fs::read_dir(root.join("soil_cases")).unwrap();
    let cases = files.map(|entry| entry.unwrap().path().join("case.toml")).filter(|path| path.exists());
    for path in cases.chain([root.join("docs/jobs/field_export.toml")]) {
        let mut case = Case::load(&path).unwrap();
        for study in &mut case.studies {
            long(study);
            let stop = Instant::now() + Duration::from_secs_f64(0.3);
            if let Err(error) = study.run(&case.railway, &Until(stop)) {
                assert!(error.is_cancelled(), "{}: {error}", path.display());
                let slot = latest.entry(study.name()).or_default();
                *slot = stop.elapsed().max(*slot);
            }
        }
    }
    println!("{latest:#?}");
    let kinds = [
        "contour",
        "critical_speed",
        "decay_rate",
        "dispersion",
        "equivalent_stiffness",
        "free_field",
        "ground_at_depth",
        "passage",
        "receptance",
        "surface_compliance",
        "track_response",
        "transition",
    ];
    for kind in kinds {
        let late = latest.get(kind).unwrap_or_else(|| panic!("{kind} was never stopped"));
        assert!(*late < Duration::from_secs(1), "{kind} went on for {late:?}");
    }
}
