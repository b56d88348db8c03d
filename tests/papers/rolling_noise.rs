//! Rails on supports that stand apart, and on the same spread along them: application 1 of Lamprea-Pineda, Connolly & Hussein 2022, the
//! test track of the package rolland, sleepers on layered ground.

use crate::{Run, compute, folder, near, relative};
use groundwave::{Case, Study};

pub const CASES: &[&str] = &[
    "discrete_sleepers_on_layered_ground",
    "lamprea2022_noise_continuous_1layer",
    "lamprea2022_noise_continuous_2layer",
    "lamprea2022_noise_discrete_2layer",
    "lamprea2022_noise_discrete_2layer_viscous",
    "rolland_mobility",
];

/// The case at the frequencies of the curves it is compared with.
fn at_known_frequencies(name: &str) -> Run {
    let mut case = Case::load(&folder().join(name).join("case.toml")).unwrap();
    for study in &mut case.studies {
        let (frequencies, beside) = match study {
            Study::Receptance(study) => (&mut study.frequencies, &study.beside),
            Study::DecayRate(study) => (&mut study.frequencies, &study.beside),
            _ => continue,
        };
        if let Some(curve) = beside.first() {
            *frequencies = curve.x.clone();
        }
    }
    compute(case)
}

/// Frequency, modulus computed and known, of the first curve under the force, of a second one at the last x.
fn moduli(run: &Run, curve: usize) -> Vec<(f64, f64, f64)> {
    let study = run.case.studies.iter().find_map(|study| match study {
        Study::Receptance(study) => Some(study),
        _ => None,
    });
    let beside = &study.unwrap().beside[curve];
    let (re, im) = (run.values("receptance", "rail_re"), run.values("receptance", "rail_im"));
    let places = re.len() / beside.x.len();
    let at = if curve == 0 { 0 } else { places - 1 };
    let computed = |i: usize| re[i * places + at].hypot(im[i * places + at]);
    (0..beside.x.len()).map(|i| (beside.x[i], computed(i), beside.values[i])).collect()
}

/// Frequency, decay rate computed and known.
fn rates(run: &Run) -> Vec<(f64, f64, f64)> {
    let study = run.case.studies.iter().find_map(|study| match study {
        Study::DecayRate(study) => Some(study),
        _ => None,
    });
    let beside = &study.unwrap().beside[0];
    let computed = run.values("decay_rate", "decay");
    (0..beside.x.len()).map(|i| (beside.x[i], computed[i], beside.values[i])).collect()
}

fn all_within(what: &str, rows: &[(f64, f64, f64)], tolerance: f64) {
    for (frequency, computed, known) in rows {
        let difference = (computed / known - 1.0).abs();
        assert!(
            difference <= tolerance,
            "{what} at {frequency} Hz: {computed} is not {known}: {difference:.1e}"
        );
    }
}

/// Cut-ons and antiresonance of the track without loss as printed; receptances and decay rates to the digits known.
#[test]
fn one_rail_on_a_continuous_support() {
    for (name, landmarks) in [
        ("lamprea2022_noise_continuous_1layer", &[("undamped_cut_on_1", 435.0)][..]),
        // the printed 122 Hz is a rule of thumb
        (
            "lamprea2022_noise_continuous_2layer",
            &[
                ("undamped_cut_on_1", 121.5),
                ("undamped_antiresonance_1", 234.0),
                ("undamped_cut_on_2", 433.0),
            ],
        ),
    ] {
        let run = at_known_frequencies(name);
        for (key, published) in landmarks {
            // measured 435.0; 120.9, 234.1, 432.9 Hz
            near(key, run.answer("receptance", key), *published, 1.0);
        }
        // measured 3.1e-11, 4.4e-11 and 4.3e-11, half of the last digit written
        all_within(name, &moduli(&run, 0), 1e-10);
        all_within(name, &moduli(&run, 1), 1e-10);
        all_within(name, &rates(&run), 1e-10);
    }
}

/// The same on sleepers, with loss factors over a support and with dashpots between two.
#[test]
fn one_rail_on_sleepers() {
    for (name, factor) in [
        ("lamprea2022_noise_discrete_2layer", 1.0),
        // the known rates of EN 15461 have its rounded 4.343 for 10/ln 10
        ("lamprea2022_noise_discrete_2layer_viscous", 4.343 * std::f64::consts::LN_10 / 10.0),
    ] {
        let run = at_known_frequencies(name);
        // measured to all digits
        relative(name, run.answer("receptance", "pinned_pinned"), 1057.2920269634, 1e-12);
        // measured 3.2e-11, 3.6e-11 and 3.6e-11
        all_within(name, &moduli(&run, 0), 1e-10);
        all_within(name, &moduli(&run, 1), 1e-10);
        let rates: Vec<_> =
            rates(&run).iter().map(|(f, computed, known)| (*f, factor * computed, *known)).collect();
        all_within(name, &rates, 1e-10);
    }
}

/// 61 moduli of the test data of the package rolland, whose 241 supports have ends.
#[test]
fn mobility_of_rolland() {
    let run = at_known_frequencies("rolland_mobility");
    let rows = moduli(&run, 0);
    // measured 2.0e-6 at 1042 Hz, where what comes back from the ends has lost least
    all_within("rolland", &rows, 4e-6);
    let far: Vec<_> = rows.into_iter().filter(|(f, ..)| !(900.0..1080.0).contains(f)).collect();
    assert_eq!(far.len(), 51);
    // measured 4.6e-14 at most
    all_within("rolland, ends out of hearing", &far, 1e-12);
}

/// Sleepers that touch, closer and closer, become the track spread along the rail; narrow ones sink deeper.
#[test]
fn sleepers_on_layered_ground() {
    let name = "discrete_sleepers_on_layered_ground";
    let text = std::fs::read_to_string(folder().join(name).join("case.toml")).unwrap();
    let moduli = |supports: &str| {
        let old = "support.spacing = 0.6                     # each sleeper carries 0.6 m of pads, sleeper and ballast\nsupport.width = 0.25\n";
        assert!(text.contains(old));
        let text = text.replace(old, supports).replace(
            "{ from = 2.0, to = 100.0, step = 2.0 }\nx = [0.0, 0.3]",
            "[5.0, 18.0, 50.0]\nx = [0.0]",
        );
        // a continuous track has no point sources
        let text = text.replace("verify = \"point-source\"\n", "");
        let run = compute(Case::parse(&text, name, &|file| Err(format!("{file}: not wanted"))).unwrap());
        let (re, im) = (run.values("receptance", "rail_re"), run.values("receptance", "rail_im"));
        re.iter().zip(im).map(|(re, im)| 1e9 * re.hypot(im)).collect::<Vec<f64>>()
    };
    let continuous = moduli("");
    let close = moduli("support.spacing = 0.1\nsupport.width = 0.1\n");
    for (close, continuous) in close.iter().zip(&continuous) {
        // measured 3.5e-4, 5e-4 and 2e-4, of which 4e-4 belong to the continuous track
        relative("sleepers 0.1 m apart", *close, *continuous, 1e-3);
    }
    let narrow = moduli("support.spacing = 0.6\nsupport.width = 0.25\n");
    // measured 8.577 and 14.06 nm/N
    relative("5 Hz, 0.25 m wide", narrow[0], 1.067 * continuous[0], 5e-3);
    assert!(narrow[1] > 1.05 * continuous[1] && narrow[1] > 14.0, "{narrow:?}");
}
