//! Peak forces at dipped joints by the formulas of Jenkins.

use groundwave::irregularity::{JenkinsWheel, LumpedTrack};
use serde_json::Value;

/// P₂ of a dip of 10 mrad, damped and not (`tests/reference/track_fe_defects.json`), and P₁ of THEORY-TIME 6.
#[test]
fn jenkins() {
    let reference: Value = serde_json::from_str(include_str!("../reference/track_fe_defects.json")).unwrap();
    let (inputs, dips) = (&reference["inputs"], reference["expected"]["dips"].as_array().unwrap());
    let number = |value: &Value| value.as_f64().unwrap();
    let lumped = &inputs["lumped_static_shape"];
    let track = LumpedTrack {
        stiffness: number(&lumped["K"]),
        mass: number(&lumped["M"]),
        damping: number(&lumped["C"]),
    };
    let angle = number(&inputs["dip"]["al"]);
    let wheel =
        |speed| JenkinsWheel { load: number(&inputs["P0"]), unsprung_mass: number(&inputs["M"]), speed };
    let mut worst = 0.0f64;
    for row in dips {
        let wheel = wheel(number(&row["speed"]));
        let undamped = LumpedTrack { damping: 0.0, ..track };
        for (key, track) in [("jenkins_P2", track), ("jenkins_P2_undamped", undamped)] {
            worst = worst.max((wheel.p2(angle, &track) - number(&row[key])).abs());
        }
    }
    println!("P₂ {worst} N");
    // measured 0.44 N: the file has whole newtons, so that half of one is all it says
    assert!(worst < 0.5, "{worst}");
    // the formula once more, from the numbers as printed: P₂ − P₀ = 2αv M_u √(K/M)(1 − πC/(4√(KM))), M = M_u + M_t
    let (m_u, m) = (600.0, 600.0 + 170.590_29);
    let (k, c) = (161_826_140.0f64, 106_455.86);
    let exact = 75e3 + 0.4 * m_u * (k / m).sqrt() - 0.4 * m_u * std::f64::consts::PI * c / (4.0 * m);
    // measured 2e-16
    assert!((wheel(40.0).p2(angle, &track) / exact - 1.0).abs() < 1e-9);
    // 165.5 kN of the track with m_e = 36 kg; the formula gives 165.3
    let p1 = wheel(40.0).p1(angle, number(&inputs["k_H"]), 36.0);
    assert!((p1 - 165.5e3).abs() < 1.5e3, "{p1}");
}
