//! A constant load moving below the Rayleigh speed: the closed form of THEORY 2.

use crate::common::soil;
use groundwave::field::{GroundField, GroundLoad, Quantity, Window};
use groundwave::progress::Silent;
use groundwave::soil::strip::sinc;
use groundwave::soil::{Base, Layer, Profile, Solver, half_space};
use groundwave::vehicle::{Axle, Train};
use num_complex::Complex64;

/// Ten positions, ahead, behind and beside [m]; on the grid of 0.5 m.
const POSITIONS: [(f64, f64); 10] = [
    (3.0, 0.0),
    (-3.0, 0.0),
    (0.0, 3.0),
    (0.0, -5.0),
    (4.0, 4.0),
    (-4.0, 4.0),
    (-7.0, -2.5),
    (8.0, 1.5),
    (1.0, 8.0),
    (-8.0, -8.0),
];
const LOAD: f64 = 150e3;

/// Layers of the half-space's own material: the ground is homogeneous, the solver does not know it. η = 1e-4.
fn ground() -> Profile {
    let material = soil(75e6, 0.35, 1800.0, 1e-4);
    let layers = [0.7, 2.3].map(|thickness| Layer { thickness, material }).to_vec();
    Profile::new(layers, Base::HalfSpace(material)).unwrap()
}

/// The largest difference over `POSITIONS`, relative to the exact value there.
fn worst(profile: &Profile, speed: f64, load: GroundLoad, exact: impl Fn(f64, f64) -> f64) -> f64 {
    let train = Train::new(vec![Axle { position: 0.0, load: LOAD }]).unwrap();
    let field = GroundField { profile, solver: Solver::DirectStiffness, speed, train: &train, load };
    let window = Window { x: (-9.0, 9.0), y: (-9.0, 9.0), spacing: 0.5 };
    let grid = field.grid(&window, 150.0);
    let result = field.compute(&window, &grid, &[Quantity::Vertical], &Silent).unwrap();
    let mut worst = 0.0f64;
    for (x, y) in POSITIONS {
        let got = result.values[0][(((y + 9.0) / 0.5) as usize, ((x + 9.0) / 0.5) as usize)];
        worst = worst.max((got / exact(x, y) - 1.0).abs());
    }
    worst
}

#[test]
fn point_load() {
    let profile = ground();
    for ratio in [0.5, 0.9] {
        let speed = ratio * profile.top().rayleigh_speed();
        let exact = |x: f64, y: f64| {
            half_space::moving_point_load(profile.top(), LOAD, speed, x.hypot(y), y.atan2(x))
        };
        let worst = worst(&profile, speed, GroundLoad::Point, exact);
        println!("point, {ratio} c_R: {worst:e}");
        // measured 5.2e-4 and 8.4e-4: here the closed-form parts carry all and the transform must add nothing
        assert!(worst < 0.01, "{worst:e}");
    }
}

/// The same load over a square of 2 m: the transform carries what the far field does not, and the exact field is the mean
/// of the point load's over the square.
#[test]
fn square_load() {
    const HALF: f64 = 1.0;
    // Gauss–Legendre, 5 points
    let nodes = [
        (0.0, 0.568_888_888_888_888_9),
        (0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
        (0.906_179_845_938_664, 0.236_926_885_056_189_1),
    ];
    let signed: Vec<(f64, f64)> = nodes
        .iter()
        .flat_map(|&(x, w)| if x == 0.0 { vec![(x, w)] } else { vec![(x, w), (-x, w)] })
        .collect();
    let profile = ground();
    for ratio in [0.5, 0.9] {
        let speed = ratio * profile.top().rayleigh_speed();
        let exact = |x: f64, y: f64| {
            let mut sum = 0.0;
            for (a, weight_a) in &signed {
                for (b, weight_b) in &signed {
                    let (x, y) = (x - HALF * a, y - HALF * b);
                    let (r, theta) = (x.hypot(y), y.atan2(x));
                    sum += 0.25
                        * weight_a
                        * weight_b
                        * half_space::moving_point_load(profile.top(), LOAD, speed, r, theta);
                }
            }
            sum
        };
        let force = |beta: f64| Complex64::from(sinc(beta * HALF));
        let load = GroundLoad::Strip { force: &force, beta_max: 31.4 / HALF, half_width: HALF };
        let worst = worst(&profile, speed, load, exact);
        println!("square, {ratio} c_R: {worst:e}");
        // measured 6.9e-4 and 5.3e-3: periodic images of what the far field leaves, 168 m away
        assert!(worst < 0.01, "{worst:e}");
    }
}
