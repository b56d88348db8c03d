//! The models of a vehicle on bogies: a wheelset, a bogie, all of it.

use super::Multibody;
use crate::vehicle::{BodyError, BogieVehicle, Part};

impl Multibody {
    /// 2 degrees of freedom: wheelset, its part of a bogie on the primary suspension.
    ///
    /// # Errors
    /// Those of [`BogieVehicle::checked`], here and below.
    pub fn two(vehicle: &BogieVehicle) -> Result<Self, BodyError> {
        let v = vehicle.checked()?;
        let part = v.bogie.mass / v.bogie.wheelsets as f64;
        let mut model = Self::free(&[v.wheelset.mass], &[(Part::Bogie, part, None)]);
        model.join(v.primary, &[(0, 1.0), (1, -1.0)]);
        model.wheelsets(&[(0, 0.0)], v.axle_loads()[0]);
        Ok(model)
    }

    /// 4 degrees of freedom: two wheelsets, bounce and pitch of their bogie; 5 with three wheelsets.
    ///
    /// # Errors
    /// See [`Multibody::two`].
    pub fn four(vehicle: &BogieVehicle) -> Result<Self, BodyError> {
        Self::on_one_bogie(vehicle, None)
    }

    /// 5 degrees of freedom: two wheelsets, bounce and pitch of their bogie, bounce of half the body; 6 with three wheelsets.
    ///
    /// # Errors
    /// See [`Multibody::two`]; an articulated vehicle.
    pub fn five(vehicle: &BogieVehicle) -> Result<Self, BodyError> {
        if vehicle.body.count > 1 {
            return Err(BodyError::HalfBodies);
        }
        Self::on_one_bogie(vehicle, Some((Part::Body, 0.5 * vehicle.body.mass, None)))
    }

    /// One bogie, and above it `half` a body.
    fn on_one_bogie(
        vehicle: &BogieVehicle,
        half: Option<(Part, f64, Option<f64>)>,
    ) -> Result<Self, BodyError> {
        let v = vehicle.checked()?;
        let count = v.bogie.wheelsets;
        let bogie = (Part::Bogie, v.bogie.mass, Some(v.bogie.pitch_inertia));
        let bodies: Vec<_> = std::iter::once(bogie).chain(half).collect();
        let mut model = Self::free(&vec![v.wheelset.mass; count], &bodies);
        model.bogie(&v, 0, count);
        if half.is_some() {
            model.join(v.secondary, &[(count, 1.0), (count + 2, -1.0)]);
        }
        let wheels: Vec<(usize, f64)> = v.wheelset_places().into_iter().enumerate().collect();
        model.wheelsets(&wheels, v.axle_loads()[0]);
        Ok(model)
    }

    /// All degrees of freedom: wheelsets, bounce and pitch of bogies and bodies; 10 of a body on two bogies of two wheelsets.
    ///
    /// # Errors
    /// See [`Multibody::two`].
    pub fn ten(vehicle: &BogieVehicle) -> Result<Self, BodyError> {
        let v = vehicle.checked()?;
        let (per_bogie, bogies) = (v.bogie.wheelsets, v.bogies());
        let wheels = per_bogie * bogies;
        let bogie = (Part::Bogie, v.bogie.mass, Some(v.bogie.pitch_inertia));
        let body = (Part::Body, v.body.mass, Some(v.body.pitch_inertia));
        let bodies = [vec![bogie; bogies], vec![body; v.body.count]].concat();
        let mut model = Self::free(&vec![v.wheelset.mass; wheels], &bodies);
        for i in 0..bogies {
            model.bogie(&v, per_bogie * i, wheels + 2 * i);
        }
        // a body above the leading and the trailing one of its bogies moves by bounce ∓ pitch · half the distance
        let arm = 0.5 * v.body.bogie_centres;
        for i in 0..v.body.count {
            let (bogie, bounce) = (wheels + 2 * i, wheels + 2 * (bogies + i));
            model.join(v.secondary, &[(bogie, 1.0), (bounce, -1.0), (bounce + 1, arm)]);
            model.join(v.secondary, &[(bogie + 2, 1.0), (bounce, -1.0), (bounce + 1, -arm)]);
        }
        let places: Vec<(usize, f64)> = v.positions().into_iter().enumerate().collect();
        let loads = v.axle_loads();
        model.wheelsets(&places, loads[0]);
        Ok(model.with_loads(&loads))
    }

    /// Primary suspensions between the wheelsets of a bogie, from degree of freedom `first` on, and the bogie, which bounces in `bounce` and
    /// pitches in the one after it.
    fn bogie(&mut self, v: &BogieVehicle, first: usize, bounce: usize) {
        for (i, place) in v.wheelset_places().into_iter().enumerate() {
            let ahead = 0.5 * v.bogie.wheelbase - place;
            self.join(v.primary, &[(first + i, 1.0), (bounce, -1.0), (bounce + 1, ahead)]);
        }
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::super::tests::ICE3;
    use super::*;
    use crate::vehicle::{Body, Bogie, Freedom, Motion, VehicleModel};
    use num_complex::Complex64;

    /// A locomotive on two bogies of three wheelsets, and three bodies on four bogies of two.
    pub(in crate::vehicle::multibody) fn others() -> [BogieVehicle; 2] {
        [
            BogieVehicle { bogie: Bogie { wheelbase: 4.0, wheelsets: 3, ..ICE3.bogie }, ..ICE3 },
            BogieVehicle { body: Body { count: 3, ..ICE3.body }, ..ICE3 },
        ]
    }

    #[test]
    fn springs_are_where_bodies_hold_them() {
        // ½ uᵀKu of any motion is the energy of the springs by places along the vehicle, rigid bodies between them
        for v in others() {
            let model = Multibody::ten(&v).unwrap();
            let n = model.freedoms.len();
            let u: Vec<f64> = (0..n).map(|i| (1.7 * i as f64 + 0.3).sin()).collect();
            let of = |part, number, motion| {
                let place = model.freedoms.iter().position(|f| *f == Freedom { part, number, motion });
                u[place.unwrap()]
            };
            // displacement at x of a body whose centre is at x₀
            let at = |part, number, centre: f64, x: f64| {
                of(part, number, Motion::Bounce) + of(part, number, Motion::Pitch) * (x - centre)
            };
            let centre = |bogie: usize| bogie as f64 * v.body.bogie_centres + 0.5 * v.bogie.wheelbase;
            let mut energy = 0.0;
            for (i, x) in v.positions().into_iter().enumerate() {
                let bogie = i / v.bogie.wheelsets;
                let wheel = of(Part::Wheelset, i + 1, Motion::Bounce);
                energy += 0.5
                    * v.primary.stiffness
                    * (wheel - at(Part::Bogie, bogie + 1, centre(bogie), x)).powi(2);
            }
            for body in 0..v.body.count {
                for bogie in [body, body + 1] {
                    let middle = 0.5 * (centre(body) + centre(body + 1));
                    let end = at(Part::Body, body + 1, middle, centre(bogie));
                    let below = of(Part::Bogie, bogie + 1, Motion::Bounce);
                    energy += 0.5 * v.secondary.stiffness * (below - end).powi(2);
                }
            }
            let vector = nalgebra::DVector::from_vec(u.clone());
            let stored = 0.5 * (vector.transpose() * &model.stiffness * &vector)[(0, 0)];
            // rounding
            assert!((stored / energy - 1.0).abs() < 1e-13, "{stored} {energy}");
        }
    }

    #[test]
    fn forces_like_the_loads_lift_the_whole_vehicle() {
        // F_i = load/g accelerate every body alike: u = −1/ω² at all wheelsets, to ω²M/k, measured 4.0e-4 at 0.1 rad/s
        for v in others() {
            for model in [VehicleModel::Two, VehicleModel::Four, VehicleModel::Ten] {
                let whole = model.of(&v, None).unwrap();
                let loads: f64 = whole.axles().iter().map(|a| a.load).sum();
                assert!((loads / (9.81 * v.total_mass()) - 1.0).abs() < 1e-14);
                let weight: f64 = (0..whole.copies()).map(|copy| whole.weights(copy).sum()).sum();
                assert!((weight / loads - 1.0).abs() < 1e-14);
            }
            let model = Multibody::ten(&v).unwrap();
            let (omega, a) = (0.1, model.receptance(0.1));
            let forces = model.axles().iter().map(|axle| Complex64::from(axle.load / 9.81));
            let moved =
                &a * nalgebra::DVector::from_iterator(a.ncols(), forces) * Complex64::from(-omega * omega);
            assert!(moved.iter().all(|u| (u - 1.0).norm() < 6e-4), "{moved}");
            assert!((&a - a.transpose()).iter().all(|z| z.norm() < 1e-10 * a[(0, 0)].norm()));
        }
        // six axles carry a sixth each; bogies between bodies (47 800 + 3500)/2 + 1800 kg an axle, those at the ends half a body less
        let [six, articulated] = others();
        let sixth = 9.81 * six.total_mass() / 6.0;
        assert!(six.axle_loads().iter().all(|load| (load - sixth).abs() < 1e-9));
        let loads = articulated.axle_loads();
        assert_eq!(loads.len(), 8);
        assert!((loads[2] - 9.81 * 27_450.0).abs() < 1e-9 && (loads[0] - 9.81 * 15_500.0).abs() < 1e-9);
    }
}
