//! Thin layers: accuracy, order of convergence, modes against exact methods.

use crate::common::{named, rows};
use groundwave::soil::thin_layer::{BelowLayers, Element};
use groundwave::soil::{Compatibility, DirectStiffness, GroundSolver, PreparedGround, Strip, ThinLayer};
use num_complex::Complex64;
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// A prepared ground, its worst error and the wavenumber of it.
type Worst = (Box<dyn PreparedGround>, f64, f64);

#[test]
fn reference() {
    // worst error of the four components over all wavenumbers of a profile and frequency, relative to the largest |G|
    // of that wavenumber
    let text = include_str!("../reference/surface_compliance.csv");
    for (below, tolerance) in [(BelowLayers::Exact, 1e-5), (BelowLayers::Matched, 1e-5)] {
        let solver = ThinLayer::new(Element::Cubic, 1e-6, None, below).unwrap();
        let mut prepared: BTreeMap<(String, u64), Worst> = BTreeMap::new();
        for row in rows(text) {
            let number = |i: usize| row[i].parse::<f64>().unwrap();
            let (k, f) = (number(1), number(2));
            let pair = |i: usize| Complex64::new(number(i), number(i + 1));
            let expected = [pair(3), pair(5), pair(7), pair(9)];
            let largest = expected.iter().map(|z| z.norm()).fold(0.0, f64::max);
            // 200 Hz in 11 m of soft clay takes an eigenproblem of 1500 unknowns and 6 s
            if f > 100.0 && below == BelowLayers::Matched {
                continue;
            }
            let entry = prepared
                .entry((row[0].to_owned(), (1e3 * f) as u64))
                .or_insert_with(|| (solver.prepare(&named(row[0]), TAU * f, &[]).unwrap(), 0.0, 0.0));
            let g = entry.0.surface(k);
            let got = [g.u_zz, g.u_xx, g.u_xz, g.u_yy];
            let error = got.iter().zip(expected).map(|(a, b)| (a - b).norm() / largest).fold(0.0, f64::max);
            if error > entry.1 {
                (entry.1, entry.2) = (error, k);
            }
        }
        let worst = prepared.iter().max_by(|a, b| a.1.1.total_cmp(&b.1.1)).unwrap();
        let ((name, f), (_, error, k)) = worst;
        println!("{below:?}: worst {error:.1e} at {name}, {} Hz, k = {k}", *f as f64 / 1e3);
        // measured 3.4e-6 on the exact half-space, 2.7e-6 with matched layers
        assert!(*error < tolerance, "{error:e}");
    }
}

#[test]
fn k_eq() {
    let mut cache: BTreeMap<(String, u64), Box<dyn groundwave::soil::PreparedGround>> = BTreeMap::new();
    let mut worst = 0.0f64;
    for row in rows(include_str!("../reference/k_eq.csv")) {
        let number = |i: usize| row[i].parse::<f64>().unwrap();
        let strip = Strip {
            half_width: number(1),
            compatibility: if row[2] == "centre" { Compatibility::Centre } else { Compatibility::Mean },
        };
        let (beta, omega) = (number(3), number(4));
        let ground = cache.entry((row[0].to_owned(), omega.to_bits())).or_insert_with(|| {
            ThinLayer::default().resolving((0.0, 240.0), 1e-6).prepare(&named(row[0]), omega, &[]).unwrap()
        });
        let estimate = ground.strip(beta, strip, 1e-6);
        let expected = Complex64::new(number(5), number(6));
        let error = (1.0 / estimate.value - expected).norm() / expected.norm();
        assert!(estimate.converged && error.is_finite(), "{row:?}");
        worst = worst.max(error);
    }
    println!("k_eq: worst {worst:.1e}");
    // measured 1.6e-6
    assert!(worst < 1e-5, "{worst:e}");
}

/// Error of G_zz at eight wavenumbers, relative to the largest, on the exact half-space.
fn error(name: &str, element: Element, n: f64, omega: f64) -> f64 {
    let profile = named(name);
    let solver = ThinLayer::new(element, 0.1, Some(n), BelowLayers::Exact).unwrap();
    let (thin, exact) = (
        solver.prepare(&profile, omega, &[]).unwrap(),
        DirectStiffness.prepare(&profile, omega, &[]).unwrap(),
    );
    let (mut gap, mut largest) = (0.0f64, 0.0f64);
    for k in [0.1, 0.3, 0.7, 1.3, 2.0, 4.0] {
        let g = exact.u_zz(k);
        gap = gap.max((thin.u_zz(k) - g).norm());
        largest = largest.max(g.norm());
    }
    gap / largest
}

/// Errors shrink like h², h⁴ and h⁶. At 80 Hz, where waves and not the distance to the load rule the sublayers.
#[test]
fn order_of_convergence() {
    for name in ["paper_layered", "mezher2016_profile3"] {
        for (element, coarse, least) in
            [(Element::Linear, 120.0, 1.9), (Element::Quadratic, 16.0, 3.8), (Element::Cubic, 8.0, 5.7)]
        {
            let errors = [1.0, 2.0, 4.0].map(|m| error(name, element, coarse * m, TAU * 80.0));
            let orders = [(errors[0] / errors[1]).log2(), (errors[1] / errors[2]).log2()];
            println!("{name} {element:?}, {coarse} per wavelength: {:.1e}, orders {orders:.2?}", errors[0]);
            // measured 1.99–2.00, 3.89–4.00 and 5.95–5.99
            assert!(orders.iter().all(|order| *order >= least), "{name} {element:?} {orders:?}");
            // measured 7.3e-7 and 7.1e-7
            assert!(element != Element::Cubic || errors[0] <= 1e-6, "{name} {errors:?}");
        }
    }
}

/// Line, inside the strip, at its edge and far away: closed forms against quadrature of the exact compliance, relative
/// to the displacement under the centre line of the strip.
#[test]
fn receivers() {
    let mut worst = 0.0f64;
    for name in ["paper_layered", "paper_half_space"] {
        let profile = named(name);
        for (beta, omega) in [(0.2, -20.0), (0.05, 30.0), (0.6, 75.0), (0.3, 188.0)] {
            let exact = DirectStiffness.prepare(&profile, omega, &[]).unwrap();
            let thin =
                ThinLayer::default().resolving((0.0, 240.0), 1e-6).prepare(&profile, omega, &[]).unwrap();
            let strip = Strip { half_width: 1.25, compatibility: Compatibility::Centre };
            let centre = exact.strip(beta, strip, 1e-9).value;
            for (b, y) in [(1.25, 0.0), (1.25, 0.7), (1.25, 1.25), (1.25, 5.0), (1.25, 20.0), (0.0, 3.0)] {
                let (a, e) = (thin.receiver(beta, b, y, 1e-9), exact.receiver(beta, b, y, 1e-9));
                assert!(a.converged && a.value.is_finite());
                worst = worst.max((a.value - e.value).norm() / centre.norm());
            }
            // the centre line of a strip is a receiver
            assert!((exact.receiver(beta, 1.25, 0.0, 1e-9).value - centre).norm() < 2e-9 * centre.norm());
        }
    }
    println!("receivers: worst {worst:.1e}");
    // measured 5.8e-7
    assert!(worst < 5e-6, "{worst:e}");
}

#[test]
fn modes_are_the_waves() {
    // the poles of thin layers nearest the real axis are the roots of the compound matrix
    use groundwave::soil::dispersion::{SurfaceWave, modes};
    let profile = named("paper_layered");
    let mut worst = 0.0f64;
    for f in [5.0, 20.0, 50.0, 80.0] {
        let ground = ThinLayer::default().prepare(&profile, TAU * f, &[]).unwrap();
        let poles = ground.modes().unwrap();
        let found = modes(&profile, SurfaceWave::Rayleigh, TAU * f, 5);
        assert_eq!(found.modes.len(), found.count);
        for mode in found.modes.iter().flatten() {
            let k2 = mode.k * mode.k;
            let nearest = poles.iter().map(|p| (p.kappa - k2).norm()).fold(f64::INFINITY, f64::min);
            worst = worst.max(nearest / k2.norm());
        }
    }
    println!("modes: worst {worst:.1e} of k²");
    // measured 1.3e-6: 6e-7 of k
    assert!(worst < 2e-6, "{worst:e}");
}
