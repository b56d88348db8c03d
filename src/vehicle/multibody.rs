//! Rigid bodies on suspensions: how wheels give way to the forces of the rail.
//!
//! Displacements positive down, e^{iωt}; bounce of a body is the displacement of its centre, pitch is positive where it
//! carries what lies behind the centre down. The contact spring is not part of a vehicle ([`super::Hertz`]).
//!
//! | model | wheelsets | bodies | Fig. 9 |
//! |---|---|---|---|
//! | [`Multibody::unsprung`] | 1 | wheelset | a |
//! | [`Multibody::two`] | 1 | wheelset, its part of a bogie | b |
//! | [`Multibody::four`] | 2 | wheelsets, bogie (bounce, pitch) | c |
//! | [`Multibody::five`] | 2 | wheelsets, bogie (bounce, pitch), half the body (bounce) | d |
//! | [`Multibody::ten`] | all | wheelsets, bogies and bodies (bounce, pitch) | e |
//!
//! What a model leaves out stands on it as a static load: every model has the axle loads of the whole vehicle.
//!
//! In frequency a vehicle answers through [`Multibody::receptance`]; in time through M ü + C u̇ + K u = w − L P of each copy, w its
//! [`Multibody::weights`], L its [`Multibody::wheels`], on one rail as [`Multibody::per_rail`].

mod consist;
mod in_time;
mod on_bogies;

use super::{Axle, BodyError, Freedom, Motion, Part, Suspension};
use crate::quantity::positive;
use nalgebra::DMatrix;
use num_complex::Complex64;

/// Bodies with masses, dashpots and springs, free above the wheels; one or several equal copies in a row.
#[derive(Clone, Debug, PartialEq)]
pub struct Multibody {
    /// M [kg, kg m²] of one copy, as C, K and the wheelsets below.
    mass: DMatrix<f64>,
    /// C [N s/m, …]
    damping: DMatrix<f64>,
    /// K [N/m, …]
    stiffness: DMatrix<f64>,
    /// What each degree of freedom is.
    freedoms: Vec<Freedom>,
    /// Degrees of freedom of the wheelsets, leading one first.
    wheels: Vec<usize>,
    /// Degrees of freedom and wheelsets of each vehicle of one copy: no two are coupled.
    vehicles: Vec<(usize, usize)>,
    /// Places and static loads of the wheelsets of all copies, one copy after the other.
    axles: Vec<Axle>,
}

impl Multibody {
    /// 1 degree of freedom: an unsprung `mass` [kg] under a static axle `load` [N].
    ///
    /// # Errors
    /// A mass or a load that is not positive.
    pub fn unsprung(mass: f64, load: f64) -> Result<Self, BodyError> {
        let mut model = Self::free(&[positive("unsprung_mass", mass, "kg")?], &[]);
        model.wheelsets(&[(0, 0.0)], positive("load", load, "N")?);
        Ok(model)
    }

    /// Number of wheelsets.
    pub fn wheelset_count(&self) -> usize {
        self.axles.len()
    }

    /// Places [m, behind the leading one] and static loads [N] of the wheelsets, in the order of the receptance.
    pub fn axles(&self) -> &[Axle] {
        &self.axles
    }

    /// A(ω) [m/N], wheelsets × wheelsets, at `omega` ≠ 0 [rad/s]: displacement of wheelset i per unit force on wheelset j, both
    /// positive down; (K + iωC − ω²M)⁻¹ at the wheelsets. One unsprung mass: −1/(Mω²).
    ///
    /// The force of the rail on the wheel is the opposite of the wheel's force P on the rail: the wheel moves by −A P, and
    /// (A + A_rail + I/k_H) P = −r.
    ///
    /// Copies of a row are not coupled: their blocks are equal, and zero between them. At ω = 0 a vehicle is free, and every entry
    /// of its block is infinite.
    ///
    /// Accuracy: closed forms by symmetry to 2e-13 from 1 to 1000 rad/s, 1e-11 at 0.1 rad/s (test `ten_is_three_chains`): 1e-16 k/(ω²M),
    /// rounding of the springs against the inertia.
    /// Source: Eqs (85)–(87), Fig. 9.
    pub fn receptance(&self, omega: f64) -> DMatrix<Complex64> {
        // vehicle by vehicle of one copy, which are not coupled: blocks, and the block and the place in it of each wheelset
        let (mut blocks, mut places) = (Vec::new(), Vec::new());
        let (mut freedom, mut wheel) = (0, 0);
        for &(size, count) in &self.vehicles {
            let dynamic = DMatrix::from_fn(size, size, |i, j| {
                let at = (freedom + i, freedom + j);
                Complex64::new(self.stiffness[at] - omega * omega * self.mass[at], omega * self.damping[at])
            });
            let wheels: Vec<usize> = self.wheels[wheel..wheel + count].iter().map(|w| w - freedom).collect();
            let mut forces = DMatrix::zeros(size, count);
            wheels.iter().enumerate().for_each(|(j, &w)| forces[(w, j)] = Complex64::ONE);
            // the exactly singular matrix of rest is not left to rounding
            let moved = if omega == 0.0 { None } else { dynamic.lu().solve(&forces) };
            places.extend((0..count).map(|k| (blocks.len(), k)));
            blocks.push((wheels, moved));
            (freedom, wheel) = (freedom + size, wheel + count);
        }
        let (count, all) = (self.wheels.len(), self.axles.len());
        DMatrix::from_fn(all, all, |i, j| {
            let ((block, i_in), (other, j_in)) = (places[i % count], places[j % count]);
            match &blocks[block] {
                _ if i / count != j / count || block != other => Complex64::ZERO,
                (wheels, Some(moved)) => moved[(wheels[i_in], j_in)],
                (_, None) => Complex64::new(f64::INFINITY, 0.0),
            }
        })
    }

    /// Free `wheelsets` [kg] and, above them, `bodies` of a mass [kg] and, where they pitch, an inertia [kg m²].
    fn free(wheelsets: &[f64], bodies: &[(Part, f64, Option<f64>)]) -> Self {
        let (mut masses, mut freedoms) = (Vec::new(), Vec::<Freedom>::new());
        let wheelsets = wheelsets.iter().map(|mass| (Part::Wheelset, *mass, None));
        for (part, mass, inertia) in wheelsets.chain(bodies.iter().copied()) {
            let same = freedoms.iter().filter(|f| f.part == part && f.motion == Motion::Bounce).count();
            for (motion, inertia) in [(Motion::Bounce, Some(mass)), (Motion::Pitch, inertia)] {
                masses.extend(inertia);
                freedoms.extend(inertia.map(|_| Freedom { part, number: same + 1, motion }));
            }
        }
        let n = masses.len();
        Self {
            mass: DMatrix::from_fn(n, n, |i, j| if i == j { masses[i] } else { 0.0 }),
            damping: DMatrix::zeros(n, n),
            stiffness: DMatrix::zeros(n, n),
            freedoms,
            wheels: Vec::new(),
            vehicles: Vec::new(),
            axles: Vec::new(),
        }
    }

    /// A suspension whose extension is Σ factor · displacement: adds k ggᵀ and c ggᵀ.
    fn join(&mut self, suspension: Suspension, extension: &[(usize, f64)]) {
        for &(i, g_i) in extension {
            for &(j, g_j) in extension {
                self.stiffness[(i, j)] += suspension.stiffness * g_i * g_j;
                self.damping[(i, j)] += suspension.damping * g_i * g_j;
            }
        }
    }

    /// Wheelsets by degree of freedom and place [m], all under the same load [N].
    fn wheelsets(&mut self, wheels: &[(usize, f64)], load: f64) {
        self.wheels = wheels.iter().map(|w| w.0).collect();
        self.vehicles = vec![(self.freedoms.len(), wheels.len())];
        self.axles = wheels.iter().map(|w| Axle { position: w.1, load }).collect();
    }
}

#[cfg(test)]
mod tests {
    use super::on_bogies::tests::others;
    use super::*;
    use crate::vehicle::{Body, Bogie, BogieVehicle, VehicleModel, Wheelset};

    /// ICE 3 after Goicolea 2014.
    pub(super) const ICE3: BogieVehicle = BogieVehicle {
        body: Body { mass: 47_800.0, pitch_inertia: 1.957_888e6, bogie_centres: 17.375, count: 1 },
        bogie: Bogie { mass: 3500.0, pitch_inertia: 1715.0, wheelbase: 2.5, wheelsets: 2 },
        wheelset: Wheelset { mass: 1800.0 },
        primary: Suspension { stiffness: 2.4e6, damping: 20e3 },
        secondary: Suspension { stiffness: 0.7e6, damping: 40e3 },
    };

    pub(super) fn undamped() -> BogieVehicle {
        let still = |s: Suspension| Suspension { damping: 0.0, ..s };
        BogieVehicle { primary: still(ICE3.primary), secondary: still(ICE3.secondary), ..ICE3 }
    }

    fn all(v: &BogieVehicle) -> Vec<Multibody> {
        let unsprung = Multibody::unsprung(v.wheelset.mass, v.axle_loads()[0]);
        [unsprung, Multibody::two(v), Multibody::four(v), Multibody::five(v), Multibody::ten(v)]
            .map(Result::unwrap)
            .into()
    }

    /// Masses in a row, the first one pushed, joined by suspensions: eliminated from the far end.
    fn chain(omega: f64, masses: &[f64], springs: &[Suspension]) -> Complex64 {
        let inertia = |m: f64| Complex64::from(-omega * omega * m);
        let mut stiffness = inertia(masses[masses.len() - 1]);
        for (s, m) in springs.iter().zip(masses).rev() {
            let k = Complex64::new(s.stiffness, omega * s.damping);
            stiffness = inertia(*m) + k * stiffness / (k + stiffness);
        }
        1.0 / stiffness
    }

    #[test]
    fn one_mass() {
        let one = Multibody::unsprung(2003.0, 150e3).unwrap();
        for omega in [0.1f64, 10.0, 1e3] {
            let exact = -1.0 / (2003.0 * omega * omega);
            assert!((one.receptance(omega)[(0, 0)] / exact - 1.0).norm() < 1e-15);
        }
        assert!(one.receptance(0.0)[(0, 0)].re.is_infinite());
        assert_eq!(one.axles(), [Axle { position: 0.0, load: 150e3 }]);
    }

    #[test]
    fn reciprocal_passive_and_real_in_time() {
        for model in all(&ICE3) {
            for i in 0..60 {
                let omega = 0.1 * 1.2f64.powi(i);
                let a = model.receptance(omega);
                let scale = a.iter().map(|z| z.norm()).fold(0.0, f64::max);
                let rounding = if omega < 1.0 { 1e-10 } else { 1e-12 } * scale;
                // of the largest entry, measured 1.3e-11 near 0.1 rad/s, where springs dwarf the inertia, and 2e-13 above 1 rad/s
                assert!((&a - a.transpose()).iter().all(|z| z.norm() < rounding));
                for wheel in 0..model.wheelset_count() {
                    // measured below −1e-9 of it with dampers, zero without
                    assert!(a[(wheel, wheel)].im <= 0.0, "{omega} {}", a[(wheel, wheel)]);
                }
                assert_eq!(a, model.receptance(-omega).conjugate());
            }
        }
    }

    #[test]
    fn fast_wheels_are_alone() {
        for model in all(&ICE3) {
            let omega = 1e5;
            let a = model.receptance(omega) * Complex64::from(-1800.0 * omega * omega);
            for ((i, j), z) in
                (0..a.nrows()).flat_map(|i| (0..a.nrows()).map(move |j| (i, j))).map(|at| (at, a[at]))
            {
                // c/(Mω) = 1.1e-4 of the primary dampers
                assert!((z - if i == j { 1.0 } else { 0.0 }).norm() < 1.2e-4, "{z}");
            }
        }
    }

    #[test]
    fn slow_wheels_carry_everything_above() {
        // equal forces on all wheelsets: each moves as −1/(ω² · its share of the mass), to ω²M/k; measured 3.1e-4 at 0.1 rad/s
        let shares = [1800.0, 3550.0, 3550.0, 15_500.0, 15_500.0];
        for (model, share) in all(&ICE3).iter().zip(shares) {
            let omega = 0.1;
            let a = model.receptance(omega);
            for i in 0..model.wheelset_count() {
                let moved = a.row(i).sum() * (-omega * omega * share);
                assert!((moved - 1.0).norm() < 5e-4, "{share} {moved}");
            }
        }
    }

    #[test]
    fn natural_frequencies_of_two() {
        // free: √(k (1/M_w + 2/M_b))/2π = 8.277 Hz; wheel held: √(2k/M_b)/2π = 5.894 Hz
        let two = Multibody::two(&undamped()).unwrap();
        let a = |f: f64| two.receptance(std::f64::consts::TAU * f)[(0, 0)].re;
        assert!(a(5.893) < 0.0 && a(5.895) > 0.0);
        assert!(a(8.276) > 1e-6 && a(8.278) < -1e-6);
    }

    #[test]
    fn two_is_four_bouncing() {
        let (two, four) = (Multibody::two(&ICE3).unwrap(), Multibody::four(&ICE3).unwrap());
        for omega in [0.5, 20.0, 52.0, 400.0] {
            // measured 3e-15
            let a = four.receptance(omega);
            assert!(((a[(0, 0)] + a[(0, 1)]) / two.receptance(omega)[(0, 0)] - 1.0).norm() < 1e-12);
        }
    }

    #[test]
    fn five_is_ten_pushed_alike_in_front_and_behind() {
        let (five, ten) = (Multibody::five(&ICE3).unwrap(), Multibody::ten(&ICE3).unwrap());
        for omega in [0.5, 6.0, 40.0, 400.0] {
            let (a5, a10) = (five.receptance(omega), ten.receptance(omega));
            // forces (p, q, q, p) move (u, w, w, u); measured 7e-14
            for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                let pair = a10[(i, j)] + a10[(i, 3 - j)];
                assert!((pair - a5[(i, j)]).norm() < 1e-12 * a5[(0, 0)].norm(), "{omega} {i} {j}");
            }
        }
    }

    #[test]
    fn ten_is_three_chains() {
        // bounce, pitch of the body and pitch of the bogies are masses in a row, per wheelset: inertias count as J/arm²
        let ten = Multibody::ten(&ICE3).unwrap();
        let half = Suspension { stiffness: 0.35e6, damping: 20e3 };
        let (arm, body_arm) = (1.25f64, 8.6875f64);
        for i in 0..=200 {
            let omega = 0.1 * 10f64.powf(f64::from(i) / 50.0);
            let a = ten.receptance(omega);
            let bounce = chain(omega, &[1800.0, 1750.0, 11_950.0], &[ICE3.primary, half]);
            let body_pitch = ICE3.body.pitch_inertia / (4.0 * body_arm.powi(2));
            let pitch = chain(omega, &[1800.0, 1750.0, body_pitch], &[ICE3.primary, half]);
            let bogie_pitch = ICE3.bogie.pitch_inertia / (2.0 * arm.powi(2));
            let rock = chain(omega, &[1800.0, bogie_pitch], &[ICE3.primary]);
            for (p, q) in (0..4).flat_map(|p| (0..4).map(move |q| (p, q))) {
                let same_bogie = p / 2 == q / 2;
                let body = if same_bogie { pitch } else { -pitch };
                let bogie = if !same_bogie {
                    Complex64::ZERO
                } else if p == q {
                    2.0 * rock
                } else {
                    -2.0 * rock
                };
                let exact = 0.25 * (bounce + body + bogie);
                let error = (a[(p, q)] - exact).norm() / a[(0, 0)].norm();
                // measured 1e-11 at 0.11 rad/s, 1.2e-13 above 1 rad/s
                assert!(error < if omega < 1.0 { 1e-10 } else { 1e-12 }, "{omega} {p} {q} {error}");
            }
        }
    }

    #[test]
    fn axles_carry_a_quarter_of_the_weight() {
        // 62 000 kg · 9.81/4 = 152.055 kN
        for model in all(&ICE3) {
            assert!(model.axles().iter().all(|a| (a.load - 152_055.0).abs() < 1e-9));
        }
        let positions: Vec<f64> = Multibody::ten(&ICE3).unwrap().axles().iter().map(|a| a.position).collect();
        assert_eq!(positions, [0.0, 2.5, 17.375, 19.875]);
    }

    #[test]
    fn refuses_what_cannot_roll() {
        let wrong = BogieVehicle { bogie: Bogie { mass: -1.0, ..ICE3.bogie }, ..ICE3 };
        let error = Multibody::four(&wrong).unwrap_err();
        assert_eq!(error.to_string(), "bogie.mass is -1 kg: it must be finite and above zero");
        assert!(
            Multibody::ten(&BogieVehicle { bogie: Bogie { wheelbase: 20.0, ..ICE3.bogie }, ..ICE3 }).is_err()
        );
        assert!(Multibody::unsprung(0.0, 1.0).is_err());
        let [mut six, mut articulated] = others();
        assert_eq!(VehicleModel::Five.of(&articulated, None), Err(BodyError::HalfBodies));
        (six.bogie.wheelsets, articulated.body.count) = (4, 0);
        let text = |v: &BogieVehicle| v.checked().unwrap_err().to_string();
        assert_eq!(text(&six), "bogie.wheelsets is 4: it must lie between 2 and 3");
        assert_eq!(text(&articulated), "body.count is 0: it must lie between 1 and 100");
    }
}
