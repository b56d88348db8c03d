//! Loads and receivers at depth: the direct stiffness method against the dense system of wave amplitudes.

use crate::common::named;
use groundwave::soil::wave_amplitudes::WaveAmplitudes;
use groundwave::soil::{Base, Compliance, DirectStiffness, GroundSolver, Profile};
use num_complex::Complex64;

fn entries(g: &Compliance) -> [Complex64; 5] {
    [g.u_zz, g.u_xx, g.u_xz, g.u_zx, g.u_yy]
}

#[test]
fn direct_stiffness_against_wave_amplitudes() {
    let depths = [0.0, 0.7, 2.0, 3.1, 9.0];
    let mut worst = 0.0f64;
    for name in [
        "paper_layered",
        "paper_half_space",
        "mezher2016_profile3",
        "stiff_over_soft",
        "nearly_incompressible",
    ] {
        let profile = named(name);
        let rigid =
            Profile::new(profile.split_at(&[12.0]).unwrap().0.layers().to_vec(), Base::Rigid).unwrap();
        for profile in [profile, rigid] {
            for omega in [-90.0, 20.0, 300.0] {
                for k in [0.02, 0.3, 1.1, 4.0] {
                    let direct = DirectStiffness.prepare(&profile, omega, &depths).unwrap();
                    let dense = WaveAmplitudes.prepare(&profile, omega, &depths).unwrap();
                    for source in 0..depths.len() {
                        let (a, b) = (direct.at_depths(k, source), dense.at_depths(k, source));
                        let scale = b.iter().flat_map(entries).map(|z| z.norm()).fold(0.0, f64::max);
                        for (a, b) in a.iter().flat_map(entries).zip(b.iter().flat_map(entries)) {
                            worst = worst.max((a - b).norm() / scale);
                        }
                    }
                }
            }
        }
    }
    println!("worst {worst:e}");
    // the dense system loses (k c_s/ω)² ≤ 1e4 digits at k = 4, ω = 20
    assert!(worst < 1e-9, "{worst:e}");
}
