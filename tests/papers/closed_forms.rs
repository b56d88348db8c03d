//! What textbooks say, asked through case files: a beam on Winkler springs under a moving load, Rayleigh speeds.

use crate::compute;
use groundwave::{Case, Elastic, Material, Member, Springs, Stack, TrackOnFoundation};

/// (damping ratio ζ, α = v/v_cr, largest downward, largest upward deflection over static), an independent inversion.
const WINKLER: &[(f64, f64, f64, f64)] = &[
    (0.05, 0.0, 1.0, 0.043214),
    (0.05, 0.25, 1.0326, 0.055926),
    (0.05, 0.5, 1.1536, 0.10682),
    (0.05, 0.75, 1.504, 0.30139),
    (0.05, 0.9, 2.2237, 0.8365),
    (0.05, 1.0, 3.7821, 2.478),
    (0.05, 1.25, 1.7809, 1.4694),
    (0.05, 1.5, 1.3337, 1.1242),
    (0.05, 2.0, 0.94765, 0.80662),
    (0.1, 0.0, 1.0, 0.043214),
    (0.1, 0.25, 1.0321, 0.057825),
    (0.1, 0.5, 1.1503, 0.11196),
    (0.1, 0.75, 1.4815, 0.31037),
    (0.1, 0.9, 2.0604, 0.78156),
    (0.1, 1.0, 2.6465, 1.4966),
    (0.1, 1.25, 1.6242, 1.1056),
    (0.1, 1.5, 1.2329, 0.87502),
    (0.1, 2.0, 0.88048, 0.63715),
    (0.3, 0.0, 1.0, 0.043214),
    (0.3, 0.25, 1.0265, 0.065084),
    (0.3, 0.5, 1.1173, 0.12787),
    (0.3, 0.75, 1.3059, 0.29999),
    (0.3, 0.9, 1.44, 0.49797),
    (0.3, 1.0, 1.4485, 0.60325),
    (0.3, 1.25, 1.1662, 0.46326),
    (0.3, 1.5, 0.93439, 0.32164),
    (0.3, 2.0, 0.68078, 0.24767),
    (1.1, 0.0, 1.0, 0.043214),
    (1.1, 0.25, 0.95907, 0.085824),
    (1.1, 0.5, 0.85915, 0.12928),
    (1.1, 0.75, 0.7386, 0.15971),
    (1.1, 0.9, 0.66815, 0.16803),
    (1.1, 1.0, 0.6241, 0.16911),
    (1.1, 1.25, 0.5273, 0.15816),
    (1.1, 1.5, 0.45014, 0.13493),
    (1.1, 2.0, 0.34286, 0.085155),
];

#[test]
fn winkler_amplification() {
    let (bending, mass, stiffness, load) = (1.276e7f64, 120.46f64, 5e7f64, 150e3);
    let critical = (4.0 * bending * stiffness / (mass * mass)).powf(0.25);
    let at_rest = load * (stiffness / (4.0 * bending)).powf(0.25) / (2.0 * stiffness);
    let mut worst = 0.0f64;
    for zeta in [0.05, 0.1, 0.3, 1.1] {
        let rows: Vec<_> = WINKLER.iter().filter(|row| row.0 == zeta).collect();
        let speeds: Vec<f64> = rows.iter().map(|row| row.1 * critical).collect();
        let damping = 2.0 * zeta * (stiffness * mass).sqrt();
        let text = format!(
            "title = \"Beam on springs\"\nfoundation = {{ kind = \"winkler\", stiffness = {stiffness:?}, damping = {damping:?} }}\n\
             [track]\nkind = \"beam\"\nbeam.bending_stiffness = {bending:?}\nbeam.mass = {mass:?}\n\
             [train]\naxles = [{{ position = 0.0, load = {load:?} }}]\n[critical_speed]\nspeeds = {speeds:?}\n"
        );
        let run = compute(Case::parse(&text, "winkler", &|_| Err(String::new())).unwrap());
        // more than critically damped, the beam moves most at rest: no critical speed, and the study says so
        let concerns: Vec<_> = run.outcome("critical_speed").concerns.iter().map(|c| c.code).collect();
        assert_eq!(concerns, if zeta > 1.0 { vec!["maximum-at-end"] } else { vec![] });
        let (down, up) = (run.values("critical_speed", "max_down"), run.values("critical_speed", "max_up"));
        for (i, row) in rows.iter().enumerate() {
            for (got, wanted) in [(down[i] / at_rest, row.2), (up[i] / at_rest, row.3)] {
                let error = (got / wanted - 1.0).abs();
                println!("ζ {zeta}, α {}: {got:.5}, wanted {wanted}, {error:.1e}", row.1);
                worst = worst.max(error);
            }
        }
        // Pλ/(2k)
        let rest = run.answer("critical_speed", "reference_deflection");
        assert!((rest / at_rest - 1.0).abs() < 1e-4, "{rest} {at_rest}");
    }
    println!("worst {worst:e}");
    // measured 8.9e-5, the fifth digit of the table
    assert!(worst < 2e-4, "{worst}");
}

/// Residues of the four poles, evaluated every 0.1 mm by an independent script, against the shape every 5 mm.
#[test]
fn winkler_shapes() {
    let (bending, mass, stiffness, load) = (1.276e7f64, 120.46f64, 5e7f64, 150e3);
    let critical = (4.0 * bending * stiffness / (mass * mass)).powf(0.25);
    let at_rest = load * (stiffness / (4.0 * bending)).powf(0.25) / (2.0 * stiffness);
    let mut worst = 0.0f64;
    for (zeta, alpha, down, up) in [
        (1.1, 0.25, 0.959_073_07, 0.085_825_12),
        (1.1, 1.25, 0.527_298_85, 0.158_174_11),
        (0.05, 0.5, 1.153_582_96, 0.106_824_05),
        (0.05, 1.0, 3.782_206_28, 2.478_044_56),
    ] {
        let springs = Springs::winkler(stiffness, 2.0 * zeta * (stiffness * mass).sqrt(), 0.0).unwrap();
        let stack = Stack::new(vec![Member::beam(bending, mass, 0.0).unwrap()], vec![]);
        let response = TrackOnFoundation::new(&stack, &springs, 0.0).moving(alpha * critical, 60.0).unwrap();
        let rail = response.shape(-30.0, 0.005, 9001).rail;
        let largest = |sign: f64| rail.iter().fold(0.0f64, |m, w| m.max(sign * load * w / at_rest));
        for (got, wanted) in [(largest(1.0), down), (largest(-1.0), up)] {
            println!("ζ {zeta}, α {alpha}: {got:.7}, wanted {wanted}");
            worst = worst.max((got - wanted).abs() / down);
        }
    }
    println!("worst {worst:e}");
    // 8.3e-6 of the largest deflection, as the integral promises (1e-5)
    assert!(worst < 3e-5, "{worst}");
}

#[test]
fn rayleigh_speeds() {
    // eight printed digits
    for (nu, wanted) in [
        (0.0, 0.874_032_05),
        (0.1, 0.893_106_01),
        (0.2, 0.910_995_89),
        (0.25, 0.919_401_69),
        (0.3, 0.927_412_71),
        (0.35, 0.935_013_13),
        (0.4, 0.942_195_43),
        (0.45, 0.948_959_7),
        (0.49, 0.954_074_35),
    ] {
        let soil = Material::new(Elastic::ShearPoisson { shear: 1.0, poisson: nu }, 1.0, 0.0, 0.0).unwrap();
        assert!((soil.rayleigh_speed() - wanted).abs() < 1e-8, "{nu}");
    }
}
