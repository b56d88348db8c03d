//! The vehicle of the Manchester benchmarks on one rigid rail (`tests/reference/track_fe_vehicle.json`).

use crate::common::manchester;
use groundwave::vehicle::{GRAVITY, Hertz, Multibody, Tread};
use nalgebra::{DMatrix, DVector};
use serde_json::Value;
use std::f64::consts::TAU;

fn reference() -> Value {
    serde_json::from_str(include_str!("../reference/track_fe_vehicle.json")).unwrap()
}

fn list(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect()
}

/// √λ/2π of K φ = λ M φ, M diagonal [Hz], ascending.
fn frequencies(stiffness: &DMatrix<f64>, mass: &DMatrix<f64>) -> Vec<f64> {
    let root = |i: usize| mass[(i, i)].sqrt();
    let n = mass.nrows();
    let scaled = DMatrix::from_fn(n, n, |i, j| stiffness[(i, j)] / (root(i) * root(j)));
    let mut all: Vec<f64> = scaled.symmetric_eigen().eigenvalues.iter().map(|l| l.sqrt() / TAU).collect();
    all.sort_by(f64::total_cmp);
    all
}

fn worst(got: &[f64], expected: &[f64]) -> f64 {
    assert_eq!(got.len(), expected.len());
    got.iter().zip(expected).map(|(g, e)| (g / e - 1.0).abs()).fold(0.0, f64::max)
}

/// Frequencies with the wheels held and on springs k_H, loads, and displacements at rest: K u = w − L P₀, wheels down by δ₀.
#[test]
fn on_a_rigid_rail() {
    let reference = reference();
    let (real, expected) = (manchester::manchester(&reference["inputs"]), &reference["expected"]);
    assert_eq!(reference["inputs"]["gravity"], GRAVITY);
    let heavy = manchester::heavy(real);
    let models = [
        ("2_dof", Multibody::two(&heavy), Multibody::two(&real)),
        ("4_dof", Multibody::four(&heavy), Multibody::four(&real)),
        ("5_dof", Multibody::five(&real), Multibody::five(&real)),
        ("10_dof", Multibody::ten(&real), Multibody::ten(&real)),
    ];
    let hertz = Hertz::new(Tread::Worn, 0.46).unwrap();
    for (name, moving, carrying) in models {
        let (row, moving) = (&expected[name], moving.unwrap().per_rail());
        let load = moving.axles()[0].load;
        let loads: Vec<f64> = moving.axles().iter().map(|a| a.load).collect();
        let (mass, stiffness, wheels) = (moving.mass(), moving.stiffness(), moving.wheels());
        let k_h = hertz.stiffness(load).unwrap();
        let held = (
            stiffness.clone().remove_rows_at(wheels).remove_columns_at(wheels),
            mass.clone().remove_rows_at(wheels).remove_columns_at(wheels),
        );
        let mut on_springs = stiffness.clone();
        wheels.iter().for_each(|w| on_springs[(*w, *w)] += k_h);
        let errors = [
            worst(&frequencies(&held.0, &held.1), &list(&row["eigenfrequencies_wheels_held"])),
            worst(&frequencies(&on_springs, mass), &list(&row["eigenfrequencies_on_hertz_springs"])),
            worst(&[k_h], &[row["k_H"].as_f64().unwrap()]),
            worst(&loads, &list(&row["wheel_loads"])),
        ];
        println!(
            "{name}: frequencies {:.1e} {:.1e}, k_H {:.1e}, loads {:.1e}",
            errors[0], errors[1], errors[2], errors[3]
        );
        // measured at most 4.6e-8: the file has eight digits
        assert!(errors.iter().all(|e| *e < 1e-7), "{errors:?}");
        for model in [moving, carrying.unwrap().per_rail()] {
            let at_rest = at_rest(&model, hertz.approach(load));
            let got: Vec<f64> =
                manchester::order(&model).into_iter().map(|(i, sign)| sign * at_rest[i]).collect();
            let exact = list(&row["static_displacement_rigid_rail"]);
            // the file has eight decimals: 5e-9 m
            for (got, exact) in got.iter().zip(&exact) {
                assert!((got - exact).abs() < 1e-8, "{name} {got} {exact}");
            }
        }
    }
}

/// u with the wheels `approach` [m] down on a rigid rail, after the reactions there are found to be the static loads.
fn at_rest(model: &Multibody, approach: f64) -> DVector<f64> {
    let (wheels, weights) = (model.wheels(), model.weights(0));
    let mut held = model.stiffness().clone();
    let mut pushed = weights.clone();
    for &wheel in wheels {
        held.row_mut(wheel).fill(0.0);
        held[(wheel, wheel)] = 1.0;
        pushed[wheel] = approach;
    }
    let u = held.lu().solve(&pushed).unwrap();
    let reactions = weights - model.stiffness() * &u;
    for (wheel, axle) in wheels.iter().zip(model.axles()) {
        // rounding of springs that cancel
        assert!((reactions[*wheel] / axle.load - 1.0).abs() < 1e-9, "{}", reactions[*wheel]);
    }
    u
}
