//! The ground at depth: Boussinesq at rest, differences of its own displacements in motion, the surface's contour above it.

use groundwave::field::{COMPONENTS, GroundField, GroundLoad, Quantity, Underground, Window};
use groundwave::progress::Silent;
use groundwave::soil::{Base, Elastic, Layer, Material, Profile, Solver};
use groundwave::vehicle::{Axle, Train};
use num_complex::Complex64;
use std::f64::consts::PI;

fn material(young: f64, poisson: f64, density: f64, loss: f64) -> Material {
    Material::new(Elastic::YoungPoisson { young, poisson }, density, loss, loss).unwrap()
}

fn one(load: f64) -> Train {
    Train::new(vec![Axle { position: 0.0, load }]).unwrap()
}

fn layered() -> Profile {
    let top = Layer { thickness: 2.0, material: material(60e6, 0.35, 1500.0, 0.06) };
    Profile::new(vec![top], Base::HalfSpace(material(200e6, 0.35, 1800.0, 0.06))).unwrap()
}

/// All fifteen components under a point load P on a half-space at rest: Boussinesq 1885, as in Poulos & Davis 1974, table 2.1, with
/// σ_rr = P/2π ((1 − 2ν)/(R(R + z)) − 3r²z/R⁵), σ_θθ = (1 − 2ν)P/2π (z/R³ − 1/(R(R + z))), τ_rz = −3Prz²/2πR⁵, tension positive.
fn boussinesq(p: f64, m: &Material, (x, y, z): (f64, f64, f64)) -> [f64; 15] {
    let (mu, nu) = (m.shear_modulus(), m.poisson());
    let young = 2.0 * mu * (1.0 + nu);
    let r = x.hypot(y);
    let big = r.hypot(z);
    let (c, s) = if r == 0.0 { (1.0, 0.0) } else { (x / r, y / r) };
    let u_z = p / (4.0 * PI * mu * big) * (2.0 * (1.0 - nu) + z * z / (big * big));
    let u_r = p / (4.0 * PI * mu * big) * (r * z / (big * big) - (1.0 - 2.0 * nu) * r / (big + z));
    let sum = 1.0 / (big * (big + z));
    let rr = p / (2.0 * PI) * ((1.0 - 2.0 * nu) * sum - 3.0 * r * r * z / big.powi(5));
    let tt = (1.0 - 2.0 * nu) * p / (2.0 * PI) * (z / big.powi(3) - sum);
    let zz = -3.0 * p * z.powi(3) / (2.0 * PI * big.powi(5));
    let rz = -3.0 * p * r * z * z / (2.0 * PI * big.powi(5));
    let (xx, yy, xy) = (rr * c * c + tt * s * s, rr * s * s + tt * c * c, (rr - tt) * c * s);
    let strain = |a: f64, b: f64, c: f64| (a - nu * (b + c)) / young;
    [
        u_r * c,
        u_r * s,
        u_z,
        strain(xx, yy, zz),
        strain(yy, xx, zz),
        strain(zz, xx, yy),
        xy / mu,
        rz * c / mu,
        rz * s / mu,
        xx,
        yy,
        zz,
        xy,
        rz * c,
        rz * s,
    ]
}

#[test]
fn a_point_load_at_rest_is_boussinesq() {
    let m = material(50e6, 0.3, 1800.0, 0.04);
    let profile = Profile::new(vec![], Base::HalfSpace(m)).unwrap();
    let train = one(100e3);
    let field = Underground { profile: &profile, speed: 0.0, train: &train, load: GroundLoad::Point };
    let (x, y, z) = ([-1.5, 0.0, 2.0], [0.0, 1.0, -3.0], [0.5, 2.0, 6.0]);
    let found = field.compute((&x, &y, &z), 1e-8).unwrap();
    assert!(found.converged, "{:e}", found.error);
    for (d, &z) in z.iter().enumerate() {
        let exact = |j: usize, i: usize| boussinesq(100e3, &m, (x[i], y[j], z));
        for (c, component) in COMPONENTS.iter().enumerate() {
            let places = (0..3).flat_map(|j| (0..3).map(move |i| (j, i)));
            let largest = places.clone().map(|(j, i)| exact(j, i)[c].abs()).fold(0.0, f64::max);
            for (j, i) in places {
                let error = (found.values[(c, d, j, i)] - exact(j, i)[c]).abs() / largest;
                assert!(error < 1e-6, "{} at {z}, {j}, {i}: {error:e}", component.name);
            }
        }
    }
}

/// A strip load that outruns the waves of the upper layer: strains against Richardson's differences of the displacements.
#[test]
fn strains_are_differences_of_displacements() {
    let profile = layered();
    let train =
        Train::new(vec![Axle { position: 0.0, load: 100e3 }, Axle { position: 3.0, load: 60e3 }]).unwrap();
    let force = |beta: f64| Complex64::from((-0.5 * beta * beta).exp());
    let load = GroundLoad::Strip { force: &force, beta_max: 7.0, half_width: 1.25 };
    for speed in [0.0, 60.0, 140.0] {
        let field = Underground { profile: &profile, speed, train: &train, load };
        let h = 0.02;
        let about = |centre: f64| [-2.0, -1.0, 0.0, 1.0, 2.0].map(|i| centre + i * h);
        let (x, y, z) = (about(-1.0), about(0.8), about(1.2));
        let found = field.compute((&x, &y, &z), 1e-9).unwrap().values;
        // f′ ≈ (8(f₁ − f₋₁) − (f₂ − f₋₂))/12h, error h⁴f⁽⁵⁾/30
        let difference = |f: [f64; 5]| (8.0 * (f[3] - f[1]) - (f[4] - f[0])) / (12.0 * h);
        let dx = |c: usize| difference([0, 1, 2, 3, 4].map(|i| found[(c, 2, 2, i)]));
        let dy = |c: usize| difference([0, 1, 2, 3, 4].map(|i| found[(c, 2, i, 2)]));
        let dz = |c: usize| difference([0, 1, 2, 3, 4].map(|i| found[(c, i, 2, 2)]));
        let strains = [dx(0), dy(1), dz(2), dy(0) + dx(1), dz(0) + dx(2), dz(1) + dy(2)];
        let largest = strains.iter().fold(0.0f64, |m, v| m.max(v.abs()));
        for (c, strain) in strains.iter().enumerate() {
            let error = (found[(3 + c, 2, 2, 2)] - strain).abs() / largest;
            assert!(error < 1e-6, "{} at {speed} m/s: {error:e}", COMPONENTS[3 + c].name);
        }
        // equilibrium along x: ∂σ_xx/∂x + ∂τ_xy/∂y + ∂τ_xz/∂z = ρ v² ∂²u_x/∂x²
        let second = |c: usize| {
            let f = [0, 1, 2, 3, 4].map(|i| found[(c, 2, 2, i)]);
            (16.0 * (f[1] + f[3]) - f[0] - f[4] - 30.0 * f[2]) / (12.0 * h * h)
        };
        for (c, along, across, down) in [(0, 9, 12, 13), (1, 12, 10, 14), (2, 13, 14, 11)] {
            let terms = [dx(along), dy(across), dz(down), -1500.0 * speed * speed * second(c)];
            let largest = terms.iter().fold(0.0f64, |m, v| m.max(v.abs()));
            let rest = terms.iter().sum::<f64>().abs() / largest;
            assert!(rest < 1e-5, "{c} at {speed} m/s: {rest:e}");
        }
    }
}

/// The surface above, by a polynomial through five depths, against the contour by FFT.
#[test]
fn the_contour_lies_above() {
    let profile = layered();
    let train = one(150e3);
    let force = |beta: f64| Complex64::from((-0.5 * beta * beta).exp());
    let load = GroundLoad::Strip { force: &force, beta_max: 5.0, half_width: 1.25 };
    let depths = [1.0, 2.0, 3.0, 4.0, 5.0].map(|i| 0.06 * i);
    let quantities = [Quantity::Vertical, Quantity::Along, Quantity::Across];
    for speed in [60.0, 140.0] {
        let below = Underground { profile: &profile, speed, train: &train, load };
        let surface =
            GroundField { profile: &profile, solver: Solver::DirectStiffness, speed, train: &train, load };
        let window = Window { x: (-8.0, 4.0), y: (3.0, 6.0), spacing: 0.5 };
        let grid = surface.grid(&window, 400.0);
        let contour = surface.compute(&window, &grid, &quantities, &Silent).unwrap();
        let found = below.compute((&contour.x, &contour.y, &depths), 1e-6).unwrap().values;
        let worst = [(0, 2), (1, 0), (2, 1)].map(|(q, c)| {
            let values = &contour.values[q];
            let largest = values.iter().fold(0.0f64, |m, v| m.max(v.abs()));
            let gap = |((j, i), value): ((usize, usize), &f64)| {
                let at = |d: usize| found[(c, d, j, i)];
                let above = 5.0 * at(0) - 10.0 * at(1) + 10.0 * at(2) - 5.0 * at(3) + at(4);
                (above - value).abs() / largest
            };
            values.indexed_iter().map(gap).fold(0.0, f64::max)
        });
        println!("{speed} m/s: {worst:?} {:e} {:e}", contour.wrap_around, contour.aliasing);
        // measured 1.6e-3, 1.7e-4 and 1.4e-4 at 60 m/s: what the contour cuts off, 2e-3 by its own estimate, is vertical
        assert!(worst[0] < 3e-3 && worst[1].max(worst[2]) < 5e-4, "{worst:?}");
    }
}

/// The factors of a long train oscillate fast along β: integrated as such, they give what its axles give one by one.
#[test]
fn a_train_is_its_axles() {
    let profile = layered();
    let axles: Vec<Axle> = (0..20)
        .map(|i| Axle { position: 60.0 / 19.0 * f64::from(i), load: 100e3 + 5e3 * f64::from(i % 4) })
        .collect();
    let train = Train::new(axles.clone()).unwrap();
    let force = |beta: f64| Complex64::from((-0.5 * beta * beta).exp());
    let load = || GroundLoad::Strip { force: &force, beta_max: 7.0, half_width: 1.25 };
    let (x, y, z) = ([-61.0, -30.5, -2.0, 3.0], [0.0, 2.0], [0.7, 3.0]);
    for speed in [0.0, 60.0, 140.0] {
        let whole = Underground { profile: &profile, speed, train: &train, load: load() };
        let whole = whole.compute((&x, &y, &z), 1e-5).unwrap();
        assert!(whole.converged, "{speed}: {:e}", whole.error);
        let single = one(1.0);
        let single = Underground { profile: &profile, speed, train: &single, load: load() };
        // x′ of each axle's own
        let places: Vec<f64> = axles.iter().flat_map(|axle| x.map(|x| x + axle.position)).collect();
        let single = single.compute((&places, &y, &z), 1e-8).unwrap().values;
        let mut worst = 0.0f64;
        for c in 0..COMPONENTS.len() {
            for d in 0..z.len() {
                let (mut largest, mut apart) = (0.0f64, 0.0f64);
                for (j, i) in (0..y.len()).flat_map(|j| (0..x.len()).map(move |i| (j, i))) {
                    let term = |(n, axle): (usize, &Axle)| axle.load * single[(c, d, j, n * x.len() + i)];
                    let sum: f64 = axles.iter().enumerate().map(term).sum();
                    largest = largest.max(sum.abs());
                    apart = apart.max((whole.values[(c, d, j, i)] - sum).abs());
                }
                worst = worst.max(apart / largest);
            }
        }
        println!("{speed} m/s: {worst:.1e}");
        // measured 7.2e-7 at most; asked were 1e-5
        assert!(worst < 2e-6, "{speed}: {worst:e}");
    }
}
