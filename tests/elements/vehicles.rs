//! Vehicles of 2, 4, 5 and 10 degrees of freedom over a dip (Manchester), and oscillators on a simply supported beam.

use crate::common::manchester::{heavy, manchester, order};
use crate::common::sleepers::{numbers, reference};
use crate::setup::{hertz, table};
use groundwave::contact::{Law, March, Rolling, Start};
use groundwave::irregularity::{Defect, Dip, Ramp, Unevenness};
use groundwave::rail::fem::{Column, Ends, Mesh, Model, Scheme};
use groundwave::track::Member;
use groundwave::vehicle::{Body, Bogie, BogieVehicle, GRAVITY, Multibody, Suspension, Wheelset};

#[test]
fn manchester_over_a_dip() {
    let file = reference("track_fe_vehicle");
    let real = manchester(&file["inputs"]);
    let models = [
        ("2_dof", Multibody::two(&heavy(real))),
        ("4_dof", Multibody::four(&heavy(real))),
        ("5_dof", Multibody::five(&real)),
        ("10_dof", Multibody::ten(&real)),
    ];
    let dip = Unevenness::default().in_rail(Defect::Dip(Dip::new(3e-3, 3.0).unwrap()), 36.0);
    let model = table("discrete", "EB", 130, 4, &[]);
    for (name, bodies) in models {
        let bodies = bodies.unwrap().per_rail();
        let order = order(&bodies);
        let count = bodies.wheelset_count();
        for row in file["expected"][name]["passages"].as_array().unwrap() {
            let (speed, run) = (row["speed"].as_f64().unwrap(), row["run"].as_f64().unwrap());
            let rolling = Rolling::Bodies(&bodies, vec![Law::Hertz(hertz()); count]);
            let scheme = Scheme::new(5e-5, 0.0).unwrap();
            let profile = |i: usize, x: f64| dip.under(i, x);
            let mut march =
                March::new(&model, scheme, rolling, speed, 30.0, &profile, Start::Static).unwrap();
            let n = order.len();
            let [mut f_max, mut rail_max] = [(); 2].map(|()| vec![f64::MIN; count]);
            let [mut u_max, mut a_max] = [(); 2].map(|()| vec![f64::MIN; n]);
            let [mut u_min, mut a_min] = [(); 2].map(|()| vec![f64::MAX; n]);
            let mut f_min = vec![f64::MAX; count];
            let start: Vec<f64> = march.forces().to_vec();
            loop {
                for i in 0..count {
                    f_max[i] = f_max[i].max(march.forces()[i]);
                    f_min[i] = f_min[i].min(march.forces()[i]);
                    rail_max[i] = rail_max[i].max(march.rail_under(i));
                }
                let state = march.vehicle(0).unwrap();
                for (j, &(i, sign)) in order.iter().enumerate() {
                    u_max[j] = u_max[j].max(sign * state.u[i]);
                    u_min[j] = u_min[j].min(sign * state.u[i]);
                    a_max[j] = a_max[j].max(sign * state.a[i]);
                    a_min[j] = a_min[j].min(sign * state.a[i]);
                }
                if speed * march.time() > run - 1e-9 {
                    break;
                }
                march.step().unwrap();
            }
            // relative to the largest of each list; the reference moves by up to 3e-4 (forces, accelerations 1e-3) with these steps
            let off_by = |found: &[f64], key: &str, least: f64| {
                let listed = numbers(&row[key]);
                let floor = least * listed.iter().fold(0.0f64, |most, b| most.max(b.abs()));
                found.iter().zip(&listed).map(|(a, b)| (a - b).abs() / b.abs().max(floor)).fold(0.0, f64::max)
            };
            let off = |found: &[f64], key: &str| off_by(found, key, 1e-3);
            let forces = off(&f_max, "F_max").max(off(&f_min, "F_min")).max(off(&start, "start_force"));
            let accelerations = off(&a_max, "acceleration_max").max(off(&a_min, "acceleration_min"));
            // their five digits are 2e-5 of the wheels', which move by a hundredth of the body's
            let displaced =
                off_by(&u_max, "displacement_max", 0.05).max(off_by(&u_min, "displacement_min", 0.05));
            let rail = off(&rail_max, "rail_max");
            println!("{name} {speed}: {forces:.1e} {accelerations:.1e} {displaced:.1e} {rail:.1e}");
            // tolerances of the reference, and half of the last of its five digits of displacements
            assert!(
                forces < 3e-4 && accelerations < 1e-3 && displaced < 2.4e-5 && rail < 1e-4,
                "{name} {speed}"
            );
        }
    }
}

/// One that stands in equilibrium stays there: v = 0.
#[test]
fn at_rest_nothing_moves() {
    let file = reference("track_fe_vehicle");
    let bodies = Multibody::ten(&manchester(&file["inputs"])).unwrap().per_rail();
    let model = table("discrete", "EB", 60, 8, &[]);
    let rolling = Rolling::Bodies(&bodies, vec![Law::Hertz(hertz()); 4]);
    let scheme = Scheme::new(1e-4, 0.0).unwrap();
    // some way past a sleeper, on a slope
    let profile = |_: usize, x: f64| 1e-4 * x;
    let mut march = March::new(&model, scheme, rolling, 0.0, 30.17, &profile, Start::Static).unwrap();
    let (first, rail, body) =
        (march.forces().to_vec(), march.rail_under(0), march.vehicle(0).unwrap().u.clone());
    (0..500).for_each(|_| march.step().unwrap());
    for (now, then) in march.forces().iter().zip(&first) {
        // measured 6e-13
        println!("{}", now / then - 1.0);
        assert!((now / then - 1.0).abs() < 1e-9, "{now} {then}");
    }
    assert!((march.rail_under(0) / rail - 1.0).abs() < 1e-9);
    for (now, then) in march.vehicle(0).unwrap().u.iter().zip(&body) {
        assert!((now - then).abs() < 1e-9 * body[0].abs(), "{now} {then}");
    }
}

#[test]
fn oscillators_on_a_beam() {
    let file = reference("track_fe_oscillator");
    for case in file["expected"]["cases"].as_array().unwrap() {
        let of = |key: &str| case[key].as_f64().unwrap();
        let beam = |key: &str| case["beam"][key].as_f64().unwrap();
        let (length, speed) = (beam("length"), of("speed"));
        let member = Member::beam(beam("EI"), beam("mass_per_m"), 0.0).unwrap();
        let elements = 40;
        let x = (0..=elements).map(|i| length * f64::from(i) / f64::from(elements)).collect();
        let mesh = Mesh::continuous(x, &[], &|_, _| Ok(Column::rail(member))).unwrap();
        let model = Model::new(mesh, Ends::Pinned);
        let load = GRAVITY * of("sprung_mass");
        let mass = Multibody::unsprung(of("sprung_mass"), load).unwrap();
        // the spring as contact, or a stiff one under the mass alone
        let stiffness = if of("unsprung_mass") > 0.0 { 1e11 } else { of("spring") };
        let law = Law::Linear { stiffness, load, approach: load / stiffness };
        let ramp = case["ramp_x1_x2_down"].as_array();
        let profile = |_: usize, x: f64| {
            ramp.map_or(0.0, |ramp| {
                let [from, to, down] = [0, 1, 2].map(|i| ramp[i].as_f64().unwrap());
                Defect::Ramp(Ramp::new(down, to - from).unwrap()).at(x - from)
            })
        };
        let t = numbers(&case["modal"]["t"]);
        let steps = 10_000;
        let step = t[t.len() - 1] / f64::from(steps);
        let scheme = Scheme::new(step, 0.0).unwrap();
        let rolling = Rolling::Bodies(&mass, vec![law]);
        let mut march = March::new(&model, scheme, rolling, speed, 0.0, &profile, Start::Static).unwrap();
        let [mut mid, mut z, mut force] = [(); 3].map(|()| Vec::new());
        let rest = load / stiffness;
        for i in 0..=steps {
            if i > 0 {
                march.step().unwrap();
            }
            if i % (steps / 10) == 0 {
                mid.push(march.rail(0.5 * length));
                z.push(march.vehicle(0).unwrap().u[0] - rest);
                force.push(march.forces()[0]);
            }
        }
        let mut errors = vec![crate::setup::off(&mid, &numbers(&case["modal"]["mid"]))];
        if of("unsprung_mass") == 0.0 {
            errors.push(crate::setup::off(&z, &numbers(&case["modal"]["z"])));
            errors.push(crate::setup::off(&force, &numbers(&case["modal"]["F"])));
        }
        println!("{}: {errors:?}", case["name"]);
        assert!(errors.iter().all(|e| *e < 5e-5), "{}: {errors:?}", case["name"]);
    }
}

/// The published benchmark of a body on a wheel over 50 m of the same beam.
#[test]
fn two_masses_on_a_beam() {
    let file = reference("track_fe_oscillator");
    let rose = &file["expected"]["rose"];
    let member = Member::beam(8.323e9, 2303.0, 0.0).unwrap();
    let x = (0..=40).map(|i| 50.0 * f64::from(i) / 40.0).collect();
    let model = Model::new(Mesh::continuous(x, &[], &|_, _| Ok(Column::rail(member))).unwrap(), Ends::Pinned);
    // the half bogie of a vehicle without body
    let vehicle = BogieVehicle {
        body: Body { mass: 1e-6, pitch_inertia: 1.0, bogie_centres: 10.0, count: 1 },
        bogie: Bogie { mass: 6000.0, pitch_inertia: 1.0, wheelbase: 1.0, wheelsets: 2 },
        wheelset: Wheelset { mass: 5750.0 },
        primary: Suspension { stiffness: 2.0 * 1.595e8, damping: 2000.0 },
        secondary: Suspension { stiffness: 1.0, damping: 0.0 },
    };
    let bodies = Multibody::two(&vehicle).unwrap();
    let load = bodies.axles()[0].load;
    let stiffness = 1.0 / 9.1e-8;
    let law = Law::Linear { stiffness, load, approach: load / stiffness };
    let scheme = Scheme::new(2.5e-5, 0.0).unwrap();
    let rolling = Rolling::Bodies(&bodies, vec![law]);
    let mut march =
        March::new(&model, scheme, rolling, 100.0 / 3.6, 0.0, &|_, _| 0.0, Start::Static).unwrap();
    let mut mid = Vec::new();
    for t in numbers(&rose["published"]["t"]) {
        while march.time() < t - 1e-9 {
            march.step().unwrap();
        }
        mid.push(1e3 * march.rail(25.0));
    }
    let (found, listed) = (&mid[..8], numbers(&rose["published"]["newmark"]));
    let ours = crate::setup::off(&mid, &numbers(&rose["fe_40"]["mid_mm"]));
    let published = crate::setup::off(found, &listed[..8]);
    println!("rose {ours:e} {published:e}");
    // published 2e-3, its value at 1.8 s left out, measured 1.0e-3; other elements with longer steps, measured 8e-5
    assert!(ours < 1.2e-4 && published < 2e-3, "{mid:?}");
}
