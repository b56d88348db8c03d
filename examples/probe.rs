use groundwave::soil::*;
fn soil(young: f64, poisson: f64, density: f64, eta: f64) -> Material {
    Material::new(Elastic::YoungPoisson { young, poisson }, density, eta, eta).unwrap()
}
fn main() {
    let p = Profile::new(
        vec![Layer { thickness: 2.0, material: soil(60e6, 0.35, 1500., 0.06) }],
        Base::HalfSpace(soil(200e6, 0.35, 1800., 0.06)),
    )
    .unwrap();
    let g = DirectStiffness.prepare(&p, 100.0, &[]).unwrap();
    let t = std::time::Instant::now();
    let mut s = num_complex::Complex64::ZERO;
    for i in 0..1000000 {
        s += g.u_zz(0.1 + 1e-5 * i as f64);
    }
    println!("{:?} per G {s}", t.elapsed() / 1000000);

    use groundwave::foundation::*;
    use groundwave::interaction::*;
    use groundwave::track::*;
    let rail = Member::beam(12.76e6, 120.46, 0.0).unwrap();
    let pad = Link::spring(7e8, 3.84e4, 0.0).unwrap();
    let slab = Member::beam(9.77e7, 1250.0, 0.0).unwrap();
    let stack = Slab { rail, pad, slab }.stack();
    let soil = LayeredSoil::new(
        p,
        Solver::DirectStiffness,
        Strip { half_width: 1.25, compatibility: Compatibility::Mean },
        1e-8,
    )
    .unwrap();
    let track = TrackOnFoundation::new(&stack, &soil, 0.0);
    for v in [15.0, 200.0, 220.0] {
        for b in [0.003, 0.01, 0.03, 0.1, 0.3] {
            let k = soil.stiffness(b, b * v).unwrap();
            println!("{v} {b} {} {}", k.value, k.converged);
        }
    }
}
