//! Rayleigh speeds: the pole of u_zz of the solver, found without its cubic.

use groundwave::soil::{Base, DirectStiffness, Elastic, GroundSolver, Layer, Material, Profile};

/// (ν, c_R/c_s): "half-space closed forms" (Kausel 2006, evaluated to 8 digits; listed as 0.333333 there, the third value is that of ⅓), whose first six
/// digits are those of THEORY 2 for ν = 0, ¼, ⅓, .35, .40, .45.
pub const SPEEDS: [(f64, f64); 10] = [
    (0.0, 0.87403205),
    (0.1, 0.89310601),
    (0.2, 0.91099589),
    (0.25, 0.91940169),
    (0.3, 0.92741271),
    (1.0 / 3.0, 0.93252591),
    (0.35, 0.93501313),
    (0.4, 0.94219543),
    (0.45, 0.9489597),
    (0.49, 0.95407435),
];
/// THEORY 2.
const SIX_DIGITS: [(f64, f64); 6] = [
    (0.0, 0.874032),
    (0.25, 0.919402),
    (1.0 / 3.0, 0.932526),
    (0.35, 0.935013),
    (0.40, 0.942195),
    (0.45, 0.948960),
];

const C_S: f64 = 120.0;

fn undamped(poisson: f64) -> Material {
    Material::new(Elastic::ShearPoisson { shear: C_S, poisson }, 1800.0, 0.0, 0.0).unwrap()
}

/// c_R/c_s from the zero of 1/u_zz at ω = 40 rad/s between 0.6 c_s and c_s.
fn from_pole(profile: &Profile) -> f64 {
    let omega = 40.0;
    let ground = DirectStiffness.prepare(profile, omega, &[]).unwrap();
    let inverse = |ratio: f64| {
        let u_zz = ground.u_zz(omega / (ratio * C_S));
        if !u_zz.is_finite() {
            // the pole itself
            return 0.0;
        }
        let value = 1.0 / u_zz;
        // slower than every body wave an undamped ground dissipates nothing
        assert!(value.im.abs() <= 1e-9 * value.re.abs().max(1e6), "{value}");
        value.re
    };
    let (mut low, mut high) = (0.6, 1.0 - 1e-9);
    assert!(inverse(low) > 0.0 && inverse(high) < 0.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if inverse(middle) > 0.0 { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

#[test]
fn pole_of_the_solver() {
    let mut worst = 0.0f64;
    for (poisson, exact) in SPEEDS.into_iter().chain(SIX_DIGITS) {
        let material = undamped(poisson);
        let layers = [1.0, 3.0].map(|thickness| Layer { thickness, material }).to_vec();
        for layers in [vec![], layers] {
            let got = from_pole(&Profile::new(layers, Base::HalfSpace(material)).unwrap());
            worst = worst.max((got - exact).abs());
            // measured 4.8e-7 against six printed digits, 4.5e-9 against eight: their rounding
            assert!((got - exact).abs() < 1e-6, "ν = {poisson}: {got} {exact}");
        }
    }
    println!("worst {worst:e}");
}

#[test]
fn cubic_of_the_material() {
    let mut worst = 0.0f64;
    for (poisson, exact) in SPEEDS {
        let got = undamped(poisson).rayleigh_speed() / C_S;
        worst = worst.max((got - exact).abs());
        // measured 4.9e-9: the rounding of eight printed digits
        assert!((got - exact).abs() < 1e-8, "ν = {poisson}: {got} {exact}");
    }
    println!("worst {worst:e}");
    for (poisson, exact) in SIX_DIGITS {
        assert!((undamped(poisson).rayleigh_speed() / C_S - exact).abs() < 1e-6, "ν = {poisson}");
    }
    // and the two ways agree beyond the printed digits; measured 1e-12
    for poisson in [-0.2, 0.0, 0.25, 0.45, 0.495] {
        let material = undamped(poisson);
        let pole = from_pole(&Profile::new(vec![], Base::HalfSpace(material)).unwrap());
        assert!((pole - material.rayleigh_speed() / C_S).abs() < 1e-10, "ν = {poisson}");
    }
}
