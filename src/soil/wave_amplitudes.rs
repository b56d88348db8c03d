//! The slow obvious method: all wave amplitudes of all layers from one dense system. The oracle of the others.
//!
//! Every layer carries down- and up-going P and S waves of unknown amplitude; displacements are continuous at every
//! interface and tractions jump by the load. Textbook expressions, LU with partial pivoting by faer. It knows nothing
//! of `layer_stiffness`; it loses (k c_s/ω)² digits as P and S waves merge, and is singular at ω = 0.

use super::strip::Outline;
use super::wave::Wave;
use super::{Base, Compliance, GroundSolver, PreparedGround, Profile, SoilError, SurfaceCompliance};
use crate::math::complex::I;
use faer::Mat;
use faer::linalg::solvers::Solve;
use num_complex::Complex64;

/// The dense system of wave amplitudes; for tests, ω ≠ 0.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WaveAmplitudes;

/// The dense system at one ω.
struct WaveAmplitudesAt {
    layers: Vec<(Wave, f64)>,
    half_space: Option<Wave>,
    interfaces: Vec<usize>,
    negative: bool,
    outline: Outline,
}

impl GroundSolver for WaveAmplitudes {
    fn prepare(
        &self,
        profile: &Profile,
        omega: f64,
        depths: &[f64],
    ) -> Result<Box<dyn PreparedGround>, SoilError> {
        // the surface is always wanted
        let mut all = vec![0.0];
        all.extend(depths);
        let (split, mut interfaces) = profile.split_at(&all)?;
        interfaces.remove(0);
        let wave = |material| Wave::new(material, omega.abs());
        Ok(Box::new(WaveAmplitudesAt {
            layers: split.layers().iter().map(|l| (wave(&l.material), l.thickness)).collect(),
            half_space: match split.base() {
                Base::HalfSpace(material) => Some(wave(&material)),
                Base::Rigid => None,
            },
            interfaces,
            negative: omega < 0.0,
            outline: Outline::new(profile, omega),
        }))
    }
}

/// (u, w, τ, σ) of P and S waves; `up` turns the sign of every vertical derivative.
fn in_plane_waves(wave: &Wave, k: f64, up: bool) -> [[Complex64; 4]; 2] {
    let (p, s) = wave.vertical(k);
    let sign = if up { 1.0 } else { -1.0 };
    let q = 2.0 * k * k - wave.ks2;
    [
        [Complex64::from(k), sign * p, sign * 2.0 * wave.mu * k * p, wave.mu * q],
        [sign * s, Complex64::from(k), wave.mu * q, sign * 2.0 * wave.mu * k * s],
    ]
}

/// (u_y, τ_yz) of SH waves.
fn anti_plane_waves(wave: &Wave, k: f64, up: bool) -> [[Complex64; 2]; 1] {
    let (_, s) = wave.vertical(k);
    [[Complex64::ONE, if up { wave.mu * s } else { -wave.mu * s }]]
}

impl WaveAmplitudesAt {
    /// The field at the top or the bottom of `layer`: columns of the wave amplitudes.
    fn face<const N: usize, const M: usize>(
        &self,
        k: f64,
        layer: usize,
        bottom: bool,
        waves: fn(&Wave, f64, bool) -> [[Complex64; M]; N],
        exponents: fn(&Wave, f64) -> [Complex64; N],
    ) -> Vec<(usize, [Complex64; M])> {
        let start = 2 * N * layer;
        let Some((wave, h)) = self.layers.get(layer) else {
            return self.half_space.map_or_else(Vec::new, |wave| {
                waves(&wave, k, false).into_iter().enumerate().map(|(j, f)| (start + j, f)).collect()
            });
        };
        let decay = exponents(wave, k).map(|x| (-x * h).exp());
        let mut columns = Vec::new();
        for (up, offset) in [(false, 0), (true, N)] {
            for (j, field) in waves(wave, k, up).into_iter().enumerate() {
                // down-going waves start at the top, up-going ones at the bottom
                let factor = if up == bottom { Complex64::ONE } else { decay[j] };
                columns.push((start + offset + j, field.map(|f| f * factor)));
            }
        }
        columns
    }

    /// Displacements at all interfaces per unit tractions at interface `source`: [interface][displacement][traction], for
    /// N kinds of waves with M = 2N field components, displacements first.
    fn solve<const N: usize, const M: usize>(
        &self,
        k: f64,
        source: usize,
        waves: fn(&Wave, f64, bool) -> [[Complex64; M]; N],
        exponents: fn(&Wave, f64) -> [Complex64; N],
    ) -> Vec<[[Complex64; N]; N]> {
        let n = self.layers.len();
        let size = 2 * N * n + if self.half_space.is_some() { N } else { 0 };
        let mut matrix: Mat<Complex64> = Mat::zeros(size, size);
        let mut load: Mat<Complex64> = Mat::zeros(size, N);
        let face = |layer, bottom| self.face(k, layer, bottom, waves, exponents);
        let mu = self.layers.first().map(|l| l.0).or(self.half_space).map_or(1.0, |w| w.mu.norm());
        let mut row = 0;
        for interface in 0..=n {
            let above = if interface > 0 { face(interface - 1, true) } else { Vec::new() };
            let below = face(interface, false);
            let rigid = interface == n && self.half_space.is_none();
            for component in 0..M {
                let displacement = component < N;
                // no continuity above the free surface, no equilibrium at a rigid base
                if (displacement && interface == 0) || (!displacement && rigid) {
                    continue;
                }
                // rows of like size: tractions over μk
                let scale = if displacement { 1.0 } else { 1.0 / (mu * k) };
                for (column, field) in &above {
                    matrix[(row, *column)] += field[component] * scale;
                }
                if !rigid {
                    for (column, field) in &below {
                        matrix[(row, *column)] -= field[component] * scale;
                    }
                }
                if !displacement && interface == source {
                    load[(row, component - N)] = Complex64::from(scale);
                }
                row += 1;
            }
        }
        let amplitudes = matrix.partial_piv_lu().solve(&load);
        (0..=n)
            .map(|interface| {
                let columns = if interface < n { face(interface, false) } else { face(n.max(1) - 1, true) };
                let columns = if n == 0 { face(0, false) } else { columns };
                std::array::from_fn(|i| {
                    std::array::from_fn(|j| columns.iter().map(|(c, f)| f[i] * amplitudes[(*c, j)]).sum())
                })
            })
            .collect()
    }

    fn at(&self, k: f64, source: usize) -> Vec<Compliance> {
        let p_and_s = |wave: &Wave, k: f64| {
            let (p, s) = wave.vertical(k);
            [p, s]
        };
        let in_plane = self.solve::<2, 4>(k, source, in_plane_waves, p_and_s);
        let anti_plane = self.solve::<1, 2>(k, source, anti_plane_waves, |wave, k| [wave.vertical(k).1]);
        let signed = |z: Complex64| if self.negative { z.conj() } else { z };
        in_plane
            .iter()
            .zip(&anti_plane)
            .map(|(g, sh)| Compliance {
                u_zz: signed(g[1][1]),
                u_xx: signed(g[0][0]),
                u_xz: I * signed(g[0][1]),
                u_zx: -I * signed(g[1][0]),
                u_yy: signed(sh[0][0]),
            })
            .collect()
    }
}

impl PreparedGround for WaveAmplitudesAt {
    fn surface(&self, k: f64) -> SurfaceCompliance {
        let g = self.at(k, 0)[0];
        SurfaceCompliance { u_zz: g.u_zz, u_xx: g.u_xx, u_xz: g.u_xz, u_yy: g.u_yy }
    }

    fn at_depths(&self, k: f64, source: usize) -> Vec<Compliance> {
        let all = self.at(k, self.interfaces[source]);
        self.interfaces.iter().map(|&i| all[i]).collect()
    }

    fn outline(&self) -> &Outline {
        &self.outline
    }
}
