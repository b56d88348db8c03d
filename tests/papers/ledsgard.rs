//! Ledsgård (Kaynia, Madshus & Zackrisson 2000; Madshus & Kaynia 2000): measured records and the speed curve of the X2000.
//!
//! Nothing is fitted. The record shows the power car leading. In that order the model finds the shape of the record
//! and overstates its peak; in the other order it finds the published critical speed. Both are asserted as measured.

use crate::{Run, near, relative, run, run_with};
use groundwave::study::TrackResponse;
use groundwave::{Railway, Silent};
use std::sync::LazyLock;

pub const CASES: &[&str] =
    &["kaynia2000_ledsgard_185", "kaynia2000_ledsgard_70", "kaynia2000_ledsgard_power_car_last"];

static SLOW: LazyLock<Run> = LazyLock::new(|| run("kaynia2000_ledsgard_70"));
static LEADING: LazyLock<Run> = LazyLock::new(|| run_with("kaynia2000_ledsgard_185", &["other-maxima"]));
static LAST: LazyLock<Run> =
    LazyLock::new(|| run_with("kaynia2000_ledsgard_power_car_last", &["train-above-critical"]));

const KM_H: f64 = 1.0 / 3.6;

fn mm(run: &Run, key: &str) -> f64 {
    1e3 * run.answer("track_response", key)
}

/// Pairs (x′, deflection) of the record of a run.
fn record(run: &Run) -> Vec<(f64, f64)> {
    let x = run.values("track_response", "record_1_x");
    x.into_iter().zip(run.values("track_response", "record_1")).collect()
}

/// Largest correlation of the record with the computed rail over shifts of the record's origin up to `most` [m], and the shift.
fn correlation(model: &Railway, speed: f64, record: &[(f64, f64)], most: f64) -> (f64, f64) {
    let study = TrackResponse { speeds: vec![speed], x: Some((-200.0, 40.0)), ..TrackResponse::default() };
    let outcome = study.run(model, &Silent).unwrap();
    let rail = outcome.group.get("rail").unwrap().to_vec();
    let at = |x: f64| {
        let place = (x + 200.0) / 0.1;
        let i = (place as usize).min(rail.len() - 2);
        rail[i] + (place - i as f64) * (rail[i + 1] - rail[i])
    };
    let steps = (most / 0.1).round() as i32;
    let mut best = (-1.0, 0.0);
    for step in -steps..=steps {
        let shift = 0.1 * f64::from(step);
        let n = record.len() as f64;
        let computed: Vec<f64> = record.iter().map(|(x, _)| at(x - shift)).collect();
        let (a, b) = (computed.iter().sum::<f64>() / n, record.iter().map(|r| r.1).sum::<f64>() / n);
        let (mut ab, mut aa, mut bb) = (0.0, 0.0, 0.0);
        for (u, (_, w)) in computed.iter().zip(record) {
            ab += (u - a) * (w - b);
            aa += (u - a).powi(2);
            bb += (w - b).powi(2);
        }
        let value = ab / (aa * bb).sqrt();
        if value > best.0 {
            best = (value, shift);
        }
    }
    best
}

#[test]
fn at_70_km_h() {
    let case = &*SLOW;
    let down = mm(case, "max_down_19.44");
    // 5.007 against 6.37 measured: −21 %
    relative("down, measured", down, 6.37, 0.25);
    relative("down", down, 5.007, 5e-3);
    // 0.02 against 0.05: nothing rises
    assert!(mm(case, "max_up_19.44").abs() < 0.1);
    let (value, shift) = correlation(&case.case.railway, 70.0 * KM_H, &record(case), 10.0);
    // 0.986 at 1.4 m
    near("correlation", value, 0.986, 0.01);
    near("shift", shift, 1.4, 0.3);
}

#[test]
fn at_185_km_h_the_peak_is_overstated() {
    let case = &*LEADING;
    let (down, up) = (mm(case, "max_down_51.39"), mm(case, "max_up_51.39"));
    // 13.995 against 10.86 measured: +29 %, more than the quarter one would like. The embankment is a beam here, and
    // the strain-reduced moduli were not chosen for this model
    near("down over measured", down / 10.86, 1.289, 0.01);
    // 6.987 against 6.5 measured: +7.5 %
    relative("up, measured", up, 6.5, 0.10);
    // on the same curve: 13.995 in both studies
    relative("curve", case.curve_mm(185.0 * KM_H), down, 1e-3);
}

#[test]
fn the_record_shows_the_power_car_leading() {
    let record = record(&LEADING);
    let speed = 185.0 * KM_H;
    let (leading, shift) = correlation(&LEADING.case.railway, speed, &record, 10.0);
    let (last, other) = correlation(&LAST.case.railway, speed, &record, 10.0);
    println!("leading {leading:.3} at {shift:.1} m, last {last:.3} at {other:.1} m");
    // 0.843 at 4.0 m, 0.534 at 6.6 m
    near("power car leading", leading, 0.843, 0.01);
    near("shift", shift, 4.0, 0.3);
    near("power car last", last, 0.534, 0.02);
}

#[test]
fn power_car_leading_has_a_flat_speed_curve() {
    let case = &*LEADING;
    // 171.5 km/h, 14.512, static 6.693
    near("largest at [km/h]", 3.6 * case.answer("critical_speed", "train_largest_speed"), 171.5, 2.0);
    relative("largest deflection", case.critical_mm("max_down"), 14.512, 5e-3);
    relative("static", case.critical_mm("reference_deflection"), 6.693, 5e-3);
    // humps at 210 and 235 km/h: 13.58 and 13.47, with 13.44 at 200 and 12.58 at 220 between
    let at = |speed: f64| case.curve_mm(speed * KM_H);
    assert!(at(210.0) > at(200.0) && at(210.0) > at(220.0));
    assert!(at(235.0) > at(220.0) && at(235.0) > at(250.0));
    // flat: within 8 % of the maximum at both
    assert!(at(210.0).min(at(235.0)) > 0.92 * case.critical_mm("max_down"));
}

#[test]
fn power_car_last_meets_the_published_critical_speed() {
    let case = &*LAST;
    // published, as critical speed of the train, 230 to 235 km/h; its largest deflection is at 231.9
    let speed = 3.6 * case.answer("critical_speed", "train_largest_speed");
    assert!((225.0..240.0).contains(&speed), "{speed}");
    near("published [km/h]", speed, 235.0, 15.0);
    // 16.990; independent script 16.97
    relative("largest deflection", case.critical_mm("max_down"), 16.97, 5e-3);
    // at 185 km/h, 11.67 and 8.19: +7.5 % and +26 % of the record, which has the other order
    let (down, up) = (mm(case, "max_down_51.39"), mm(case, "max_up_51.39"));
    relative("down, measured", down, 10.9, 0.25);
    relative("up, measured", up, 6.5, 0.40);
    // the independent script has this order: 11.67, 8.19
    relative("down, independent", down, 11.67, 5e-3);
    relative("up, independent", up, 8.19, 5e-3);
    // and its curve: within 0.5 %
    for (speed, wanted) in [
        (100.0, 7.91),
        (120.0, 8.63),
        (140.0, 10.09),
        (160.0, 12.51),
        (170.0, 12.93),
        (180.0, 12.2),
        (190.0, 11.36),
        (200.0, 11.88),
        (210.0, 11.88),
        (220.0, 15.1),
        (230.0, 16.97),
        (235.0, 16.9),
        (240.0, 16.34),
        (250.0, 14.57),
        (260.0, 12.85),
        (280.0, 10.43),
        (300.0, 9.42),
    ] {
        relative(&format!("{speed} km/h"), case.curve_mm(speed * KM_H), wanted, 8e-3);
    }
}

#[test]
fn one_axle_is_critical_at_a_lower_speed() {
    let single = |case: &Run, key: &str| case.answer("critical_speed", key);
    for case in [&*LEADING, &*LAST] {
        // 165.8 km/h, 8.794, static 4.071; the independent script's grid of 10 km/h says 170
        near("one axle [km/h]", 3.6 * case.critical_speed(), 170.0, 6.0);
        assert_eq!(single(case, "single_axle_critical_speed"), case.critical_speed());
        relative("its deflection", 1e3 * single(case, "single_axle_max_down"), 8.794, 5e-3);
    }
    let (a, b) = (single(&LEADING, "single_axle_max_down"), single(&LAST, "single_axle_max_down"));
    // the direction means nothing to one axle
    assert!((a / b - 1.0).abs() < 1e-6, "{a} {b}");
}
