//! A constant load on its way: exact residues, sums over supports, order of convergence, energy.

use crate::common::sleepers::{self, Loss, numbers, reference};
use crate::setup::{D, LOAD, load, off, rock, table};
use groundwave::rail::fem::{Ends, Form, Mesh, Model};
use groundwave::track::Layout;

/// Rail and sleepers beside the load when it stands over bay 50, or half a bay and more away from it.
#[test]
fn continuous_track_against_residues() {
    let file = reference("track_fe_moving_load");
    for speed in [40.0, 80.0] {
        let expected = &file["expected"][format!("speed_{speed:.0}")];
        let exact = &expected["continuous_exact"];
        let x = numbers(&exact["x_from_load"]);
        let mut errors = Vec::new();
        for (ne, n) in [(2, 200), (4, 200), (8, 400)] {
            let model = table("continuous", "EB", 100, ne, &[]);
            let mut march = load(&model, &LOAD, speed, n, (10.0 * D, 20.0 * D));
            (0..40 * n).for_each(|_| march.step().unwrap());
            assert!((march.x(0) - 50.0 * D).abs() < 1e-9);
            let found: Vec<f64> = x.iter().map(|x| march.rail(march.x(0) + x)).collect();
            let rail = off(&found, &numbers(&exact["rail"]));
            let below = |x: &f64| {
                let shape = model.mesh.below_at(1, 50.0 * D + x);
                shape.iter().map(|&(i, n)| n * march.track().u[i]).sum::<f64>()
            };
            let sleeper = off(&x.iter().map(below).collect::<Vec<_>>(), &numbers(&exact["sleeper"]));
            errors.push((rail, sleeper, march.rail_under(0) / march.rail(march.x(0)) - 1.0));
        }
        println!("{speed} {errors:?} {:?}", expected["continuous_fe"]);
        assert!(errors[2].0 < 1e-5 && errors[2].1 < 1e-5, "{speed}: {errors:?}");
    }
}

#[test]
fn discrete_supports_against_the_sum_over_supports() {
    let file = reference("track_fe_moving_load");
    for (speed, beam, ne, n, bound) in
        [(40.0, "EB", 8, 400, 1e-5), (80.0, "EB", 8, 400, 1e-5), (40.0, "T", 16, 800, 3e-4)]
    {
        let exact = &file["expected"][format!("speed_{speed:.0}")][format!("discrete_{beam}")];
        let places = numbers(&exact["load_from_sleeper_bays"]);
        let model = table("discrete", beam, 100, ne, &[]);
        let mut march = load(&model, &LOAD, speed, n, (10.0 * D, 20.0 * D));
        let [mut over, mut half, mut sleeper, mut under] = [(); 4].map(|()| Vec::new());
        for place in &places {
            let until = ((50.0 + place - 10.0) * n as f64).round() as usize;
            while march.steps() < until {
                march.step().unwrap();
            }
            over.push(march.rail(50.0 * D));
            half.push(march.rail(50.5 * D));
            sleeper.push(march.track().u[model.mesh.below_at(1, 50.0 * D)[0].0]);
            under.push(march.rail_under(0));
        }
        let errors = [
            (&over, "rail_at_sleeper"),
            (&half, "rail_half_bay_on"),
            (&sleeper, "sleeper"),
            (&under, "under_load"),
        ]
        .map(|(found, key)| off(found, &numbers(&exact[key])));
        let infinite = [(&over, "rail_at_sleeper"), (&sleeper, "sleeper")]
            .map(|(found, key)| off(found, &numbers(&exact["infinite_track_fourier"][key])));
        println!("{beam} {speed}: {errors:?} {infinite:?}");
        assert!(
            errors.iter().chain(&infinite).all(|e| *e < bound),
            "{beam} {speed}: {errors:?} {infinite:?}"
        );
    }
}

#[test]
fn energy_of_the_rail_closes_to_rounding() {
    let file = reference("track_fe_moving_load");
    for speed in [40.0, 80.0] {
        let expected = &file["expected"][format!("speed_{speed:.0}")];
        let model = table("continuous", "EB", 100, 4, &[]);
        // to bay 51.5
        let mut march = load(&model, &LOAD, speed, 200, (10.0 * D, 20.0 * D));
        march.keep_ledger();
        (0..83 * 100).for_each(|_| march.step().unwrap());
        let ledger = march.ledger().unwrap();
        let account = ledger.track;
        // measured 4e-15 and 3e-14 of the work
        assert!(account.rest().abs() < 1e-12 * account.work, "{}", account.rest());
        let listed = expected["continuous_fe"].as_array().unwrap();
        let energy =
            &listed.iter().find(|row| row["ne"] == 4 && row["steps_per_bay"] == 200).unwrap()["energy"];
        let found = [account.kinetic, account.strain, account.dissipated, account.work];
        for (found, key) in found.iter().zip(["kin", "strain", "diss", "load"]) {
            // the same elements and steps; measured 1e-7, its digits
            assert!((found / energy[key].as_f64().unwrap() - 1.0).abs() < 1e-6, "{key}: {found}");
        }
        // at the end, steady: what the drive pays, −vPu_r′
        let before = ledger.drive;
        (0..200).for_each(|_| march.step().unwrap());
        let power = -(march.ledger().unwrap().drive - before) / (march.time() * 200.0 / march.steps() as f64);
        // 53.117 and 218.34 W of the residues; measured 6.1e-5 and 6.9e-5 off, four elements a bay
        let exact = expected["continuous_exact"]["power"].as_f64().unwrap();
        println!("{power} {exact}");
        assert!((power / exact - 1.0).abs() < 1e-3, "{power} {exact}");
    }
}

/// Histories of the frequency domain: sums over supports, `boef_moving_load`.
#[test]
fn histories_of_constant_loads_over_supports() {
    let file = reference("boef_moving_load");
    let places = numbers(&file["inputs"]["x_prime_m"]);
    for row in file["expected"]["constant_load"].as_array().unwrap() {
        if row["beam"] != "EB" {
            continue;
        }
        let (layers, speed) = (row["layers"].as_u64().unwrap() as usize, row["speed"].as_f64().unwrap());
        let supports = sleepers::layers(sleepers::rail("EB", 0.0), layers, 1.8e8, Loss::Viscous);
        let range = (0.0, 100.0 * D - 1e-6);
        let mesh = Mesh::of(&Layout::Discrete(supports), &rock(), range, (D, 8), Form::Time, &[]).unwrap();
        let model = Model::new(mesh, Ends::Pinned);
        // x′ = x − vt in steps of 0.25 m, of D/240 each
        for (key, x) in [("over_support", 50.0 * D), ("mid_span", 50.5 * D)] {
            let mut march = load(&model, &LOAD, speed, 240, (10.0 * D, 20.0 * D));
            let found: Vec<f64> = places
                .iter()
                .rev()
                .map(|place| {
                    while march.x(0) < x - place - 0.5 * D / 240.0 {
                        march.step().unwrap();
                    }
                    march.rail(x) / 75e3
                })
                .collect();
            let exact: Vec<f64> = numbers(&row[key]).into_iter().rev().collect();
            let error = off(&found, &exact);
            println!("{layers} {speed} {key}: {error:e}");
            assert!(error < 1e-5, "{layers} {speed} {key}: {error}");
        }
    }
}
