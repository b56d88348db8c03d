//! What a march must keep whatever the numbers: energy, orders of convergence, uniformity.

use crate::common::sleepers::rail;
use crate::setup::{D, LOAD, changing, hertz, layers, load, table};
use groundwave::contact::{Law, March, Rolling, Start};
use groundwave::math::banded::Banded;
use groundwave::rail::fem::{Column, Ends, Mesh, Model, Newmark, Scheme, State};
use groundwave::track::{Caughey, Link, Member, Stack};
use groundwave::vehicle::{Body, Bogie, BogieVehicle, GRAVITY, Multibody, Suspension, Wheelset};
use nalgebra::DMatrix;

/// ICE 3 after Goicolea 2014, with dampers or without.
fn five(damped: f64) -> Multibody {
    let vehicle = BogieVehicle {
        body: Body { mass: 47_800.0, pitch_inertia: 1.957_888e6, bogie_centres: 17.375, count: 1 },
        bogie: Bogie { mass: 3500.0, pitch_inertia: 1715.0, wheelbase: 2.5, wheelsets: 2 },
        wheelset: Wheelset { mass: 1800.0 },
        primary: Suspension { stiffness: 2.4e6, damping: damped * 20e3 },
        secondary: Suspension { stiffness: 0.7e6, damping: damped * 40e3 },
    };
    Multibody::five(&vehicle).unwrap().per_rail()
}

fn wave(_: usize, x: f64) -> f64 {
    2e-5 * (9.0 * x).sin()
}

#[test]
fn ledgers_of_rail_and_vehicle_close_to_rounding_the_contact_as_the_square_of_the_step() {
    let undamped = |_: f64| {
        let springs = [3.5e8, 1.8e8].map(|k| Link::spring(k, 0.0, 0.0).unwrap());
        Stack::new(vec![rail("EB", 0.0), Member::mass(245.0).unwrap()], springs.to_vec())
    };
    for damped in [1.0, 0.0] {
        let model = if damped > 0.0 {
            table("discrete", "EB", 60, 4, &[])
        } else {
            changing("continuous", 60, 4, None, &undamped)
        };
        let bodies = five(damped);
        let mut rests = Vec::new();
        for step in [1e-4, 5e-5, 2.5e-5] {
            let rolling = Rolling::Bodies(&bodies, vec![Law::Hertz(hertz()); 2]);
            let scheme = Scheme::new(step, 0.0).unwrap();
            let mut march = March::new(&model, scheme, rolling, 40.0, 12.0, &wave, Start::Static).unwrap();
            let weights = |march: &March| {
                let u = &march.vehicle(0).unwrap().u;
                bodies.weights(0).iter().zip(u).map(|(w, u)| w * u).sum::<f64>()
            };
            let first = weights(&march);
            march.keep_ledger();
            // 8 m, in contact all the time
            for _ in 0..(0.2 / step).round() as usize {
                march.step().unwrap();
                assert!(march.forces().iter().all(|p| *p > 0.0));
            }
            let ledger = march.ledger().unwrap();
            for account in [ledger.track, ledger.vehicles] {
                let turned = account.work.abs().max(account.kinetic).max(account.strain);
                // measured 3e-13 of what is turned over
                println!("{damped} {step} {:e}", account.rest() / turned);
                assert!(account.rest().abs() < 1e-9 * turned, "{account:?} {}", account.rest());
                assert!(damped > 0.0 || account.dissipated == 0.0);
            }
            rests.push(ledger.rest(weights(&march) - first) / ledger.drive.abs());
        }
        let orders: Vec<f64> = rests.windows(2).map(|r| (r[0] / r[1]).abs().log2()).collect();
        println!("{rests:?} {orders:?}");
        // Δt², corners of the elements aside
        assert!(rests[2].abs() < 1e-3 && orders[1] > 1.7, "{rests:?} {orders:?}");
    }
}

/// A force that swells and fades in the middle of a simply supported beam.
#[test]
fn orders_in_step_and_element() {
    let (length, bending, mass) = (6.0, 6.38e6, 60.23);
    let omega = (std::f64::consts::PI / length).powi(2) * f64::sqrt(bending / mass);
    let period = std::f64::consts::TAU / omega;
    let swing = |elements: usize, steps: usize| {
        let x = (0..=elements).map(|i| length * i as f64 / elements as f64).collect();
        let beam = Member::beam(bending, mass, 0.0).unwrap();
        let model =
            Model::new(Mesh::continuous(x, &[], &|_, _| Ok(Column::rail(beam))).unwrap(), Ends::Pinned);
        let shape = model.mesh.rail_at(0.5 * length).0;
        let mut newmark = Newmark::new(&model, Scheme::new(period / steps as f64, 0.0).unwrap()).unwrap();
        let unit = newmark.unit(&shape);
        let mut state = State::at_rest(vec![0.0; model.mesh.size()]);
        for i in 1..=steps * 3 / 5 {
            newmark.free(&mut state, &[]);
            let t = i as f64 / steps as f64;
            newmark.press(&mut state, &unit, 1e4 * (std::f64::consts::PI * t).sin().powi(4));
        }
        shape.iter().map(|&(i, n)| n * state.u[i]).sum::<f64>()
    };
    let of_step = [100, 200, 400usize].map(|steps| (swing(8, steps) / swing(8, 6400) - 1.0).abs());
    let of_element = [2, 4, 8].map(|elements| (swing(elements, 1600) / swing(32, 1600) - 1.0).abs());
    println!("{of_step:?} {of_element:?}");
    let order = |errors: [f64; 3]| (errors[1] / errors[2]).log2();
    // measured 2.004 and 3.985
    assert!(
        (order(of_step) - 2.0).abs() < 0.1 && (order(of_element) - 4.0).abs() < 0.3,
        "{of_step:?} {of_element:?}"
    );
}

/// A "change" of support by nothing is the uniform track.
#[test]
fn a_change_by_nothing_changes_nothing() {
    let uniform = table("continuous", "EB", 60, 4, &[]);
    let changed = changing("continuous", 60, 4, Some(30.5 * D), &|_| layers(rail("EB", 0.0), 1.0));
    let run = |model: &Model| {
        let mut march = load(model, &LOAD, 60.0, 50, (5.0 * D, 10.0 * D));
        let mut found = Vec::new();
        for _ in 0..45 * 50 {
            march.step().unwrap();
            found.push(march.rail_under(0));
        }
        found
    };
    let error = crate::setup::off(&run(&changed), &run(&uniform));
    println!("{error:e}");
    // measured 1.1e-13: the layer's unknowns are doubled at the change, its slope may break there
    assert!(error < 1e-9, "{error}");
}

/// On supports the mean force over whole bays is the static load.
#[test]
fn mean_force_is_the_static_load() {
    let model = table("discrete", "EB", 80, 4, &[]);
    let bodies = Multibody::unsprung(600.0, 75e3).unwrap();
    assert!((bodies.weights(0)[0] - 75e3).abs() < 1e-9 && GRAVITY > 9.8);
    let rolling = Rolling::Bodies(&bodies, vec![Law::Hertz(hertz())]);
    let scheme = Scheme::new(D / 40.0 / 200.0, 0.0).unwrap();
    let mut march = March::new(&model, scheme, rolling, 40.0, 10.0 * D, &|_, _| 0.0, Start::Static).unwrap();
    (0..30 * 200).for_each(|_| march.step().unwrap());
    let mut sum = 0.0;
    for _ in 0..20 * 200 {
        march.step().unwrap();
        sum += march.forces()[0];
    }
    let mean = sum / (20.0 * 200.0) / 75e3 - 1.0;
    println!("mean {mean:e}");
    // measured −6.6e-10: what is left of the start
    assert!(mean.abs() < 1e-5, "{mean}");
}

/// Modes of a simply supported beam get the damping asked for: φᵀCφ = 2ζω φᵀMφ.
#[test]
fn rayleigh_and_caughey() {
    let (length, elements, pi) = (6.0, 24, std::f64::consts::PI);
    let beam = Member::beam(6.38e6, 60.23, 0.0).unwrap();
    let omega = [1.0, 2.0, 3.0].map(|n| (n * pi / length).powi(2) * f64::sqrt(6.38e6 / 60.23));
    let ratios = [0.02, 0.05, 0.01];
    for modes in [2, 3] {
        let x = (0..=elements).map(|i| length * f64::from(i) / f64::from(elements)).collect();
        let mesh = Mesh::continuous(x, &[], &|_, _| Ok(Column::rail(beam))).unwrap();
        let caughey = Caughey::of_modes(&omega[..modes], &ratios[..modes]).unwrap();
        let model = Model::new(mesh, Ends::Pinned).damped(&caughey).unwrap();
        // M = LLᵀ, modes of L⁻¹KL⁻ᵀ
        let size = model.mesh.size();
        let dense = |matrix: &Banded<f64>| DMatrix::from_fn(size, size, |i, j| matrix.get(i, j));
        let l = dense(&model.mass).cholesky().unwrap().l();
        let scaled = |matrix: &DMatrix<f64>| {
            let half = l.solve_lower_triangular(matrix).unwrap();
            l.solve_lower_triangular(&half.transpose()).unwrap()
        };
        let eigen = scaled(&dense(&model.stiffness)).symmetric_eigen();
        let damping = scaled(&dense(&model.damping));
        for (omega, ratio) in omega.iter().zip(ratios).take(modes) {
            let distance = |i: &usize| (eigen.eigenvalues[*i].sqrt() / omega - 1.0).abs();
            let nearest = (0..size).min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap();
            let mode = eigen.eigenvectors.column(nearest);
            // at the frequency the elements give it, 1.6e-5 off for the third
            let omega = eigen.eigenvalues[nearest].sqrt();
            let found = (mode.transpose() * &damping * mode)[(0, 0)] / (2.0 * omega);
            println!("{modes} {}", found / caughey.ratio(omega) - 1.0);
            // measured 2.7e-7: rounding of K M⁻¹ K
            assert!((found / caughey.ratio(omega) - 1.0).abs() < 1e-5, "{modes} modes: {found}");
            // three modes: steep in ω; measured 3.8e-4
            assert!((found / ratio - 1.0).abs() < 1e-3, "{modes} modes: {found} {ratio}");
        }
    }
    // more than two modes couple everything
    let long = table("discrete", "EB", 250, 4, &[]);
    let caughey = Caughey::of_modes(&omega, &ratios).unwrap();
    assert!(long.damped(&caughey).map(|_| ()).unwrap_err().to_string().contains("Rayleigh"));
}

/// A wheel on a sinusoid: what the drive pays is what the track dissipates.
#[test]
fn the_drive_pays_for_what_the_track_loses() {
    let drive = &crate::common::sleepers::reference("track_fe_length")["expected"]["drive"];
    let wheel = crate::setup::wheel();
    let model = table("continuous", "EB", 80, 8, &[]);
    let tau = std::f64::consts::TAU;
    let rough =
        |_: usize, x: f64| 1e-3 * (tau * x).sin() * crate::wheel::smooth_step((x - 22.0 * D) / (8.0 * D));
    let scheme = Scheme::new(1.0 / 512.0 / 40.0, 0.0).unwrap();
    let rolling = Rolling::Bodies(&wheel, vec![Law::Hertz(hertz())]);
    let start = Start::Ramp(10.0 * D / 40.0);
    let mut march = March::new(&model, scheme, rolling, 40.0, 10.0 * D, &rough, start).unwrap();
    (0..24 * 512).for_each(|_| march.step().unwrap());
    march.keep_ledger();
    (0..3 * 512).for_each(|_| march.step().unwrap());
    let (ledger, time) = (march.ledger().unwrap(), 3.0 / 40.0);
    let expected = drive["mean_dissipation_W"].as_f64().unwrap();
    for power in [ledger.track.dissipated, ledger.track.work, -ledger.drive].map(|energy| energy / time) {
        println!("{power} {expected}");
        // measured 8e-7, 8e-7, 2.6e-5: Δt²
        assert!((power / expected - 1.0).abs() < 1e-3, "{power} {expected}");
    }
}

/// Without dashpots the energy of the load stays in the track.
#[test]
fn without_dashpots_nothing_is_lost() {
    let undamped = |_: f64| {
        let springs = [3.5e8, 1.8e8].map(|k| Link::spring(k, 0.0, 0.0).unwrap());
        Stack::new(vec![rail("EB", 0.0), Member::mass(245.0).unwrap()], springs.to_vec())
    };
    let model = changing("discrete", 100, 4, None, &undamped);
    let mut march = load(&model, &LOAD, 40.0, 200, (10.0 * D, 20.0 * D));
    march.keep_ledger();
    (0..83 * 100).for_each(|_| march.step().unwrap());
    let track = march.ledger().unwrap().track;
    let expected = &crate::common::sleepers::reference("track_fe_length")["expected"]["undamped_energy"];
    for (found, key) in [(track.kinetic, "kin"), (track.strain, "strain"), (track.work, "load")] {
        // measured 1.2e-5 of the smallest, its steps
        assert!((found / expected[key].as_f64().unwrap() - 1.0).abs() < 1e-4, "{key}: {found}");
    }
    // measured 1e-14 of the work
    assert!(track.rest().abs() < 1e-9 * track.work && track.dissipated == 0.0);
}
