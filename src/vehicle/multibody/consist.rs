//! Vehicles in a row: copies of one, the same the other way round, different ones.

use super::Multibody;
use crate::vehicle::{Axle, BodyError, Freedom, Motion, Train};
use nalgebra::DMatrix;
use std::cmp::Reverse;
use std::collections::BTreeMap;

impl Multibody {
    /// Unsprung masses [kg] of all wheelsets of a `train` of axle loads, at their places.
    ///
    /// # Errors
    /// A mass that is not positive.
    pub fn unsprung_train(mass: f64, train: &Train) -> Result<Self, BodyError> {
        let places: Vec<f64> = train.axles().iter().map(|a| a.position).collect();
        let loads: Vec<f64> = train.axles().iter().map(|a| a.load).collect();
        let heaviest = train.heaviest_axle().total_load();
        Ok(Self::unsprung(mass, heaviest)?.row(&places)?.with_loads(&loads))
    }

    /// This model again and again at `offsets` [m] behind the first, not coupled to one another: the four wheelsets of a
    /// vehicle of [`Multibody::two`], or a train of vehicles.
    ///
    /// # Errors
    /// An offset that is not finite.
    pub fn row(&self, offsets: &[f64]) -> Result<Self, BodyError> {
        let mut axles = Vec::with_capacity(offsets.len() * self.axles.len());
        for (i, &offset) in offsets.iter().enumerate() {
            if !offset.is_finite() {
                return Err(BodyError::Offset { index: i + 1, offset });
            }
            axles.extend(self.axles.iter().map(|a| Axle { position: a.position + offset, load: a.load }));
        }
        Ok(Self { axles, ..self.clone() })
    }

    /// The same running the other way: what stands at x comes to `end` − x [m].
    pub fn reversed(&self, end: f64) -> Self {
        let turned = |a: &Axle| Axle { position: end - a.position, ..*a };
        // vehicle by vehicle from the rear; of each kind of body the last one first
        let mut vehicle = Vec::new();
        for (i, &(size, _)) in self.vehicles.iter().enumerate() {
            vehicle.extend(std::iter::repeat_n(i, size));
        }
        let mut order: Vec<usize> = (0..self.freedoms.len()).collect();
        order.sort_by_key(|&i| {
            let Freedom { part, number, motion } = self.freedoms[i];
            (Reverse(vehicle[i]), part, Reverse(number), motion)
        });
        let rank = |i: usize| order.iter().position(|&old| old == i).unwrap_or(i);
        // what lay behind the centre of a body lies ahead of it
        let sign = |i: usize| if self.freedoms[i].motion == Motion::Pitch { -1.0 } else { 1.0 };
        let matrix = |old: &DMatrix<f64>| {
            DMatrix::from_fn(order.len(), order.len(), |i, j| {
                sign(order[i]) * sign(order[j]) * old[(order[i], order[j])]
            })
        };
        let mut bodies = BTreeMap::new();
        let freedoms = order.iter().map(|&i| {
            let Freedom { part, motion, .. } = self.freedoms[i];
            let number = bodies.entry(part).or_insert(0);
            *number += usize::from(motion == Motion::Bounce);
            Freedom { part, number: *number, motion }
        });
        Self {
            mass: matrix(&self.mass),
            damping: matrix(&self.damping),
            stiffness: matrix(&self.stiffness),
            freedoms: freedoms.collect(),
            wheels: self.wheels.iter().rev().map(|&wheel| rank(wheel)).collect(),
            vehicles: self.vehicles.iter().rev().copied().collect(),
            axles: self.axles.iter().rev().map(turned).collect(),
        }
    }

    /// Different `vehicles` in a row, each with its wheelsets where they are, not coupled to one another: one copy of them all. Those
    /// that differ in their places and loads alone stay copies of one.
    pub fn train(vehicles: &[Self]) -> Self {
        let same = |v: &Self, w: &Self| {
            (&v.mass, &v.damping, &v.stiffness, &v.vehicles)
                == (&w.mass, &w.damping, &w.stiffness, &w.vehicles)
        };
        let axles = vehicles.iter().flat_map(|vehicle| vehicle.axles.clone()).collect();
        if let Some(first) = vehicles.first().filter(|first| vehicles.iter().all(|v| same(v, first))) {
            return Self { axles, ..first.clone() };
        }
        // every copy for itself, on the diagonal
        let copies: Vec<&Self> = vehicles.iter().flat_map(|v| std::iter::repeat_n(v, v.copies())).collect();
        let n = copies.iter().map(|copy| copy.freedoms.len()).sum();
        let mut train = Self { axles, ..Self::free(&[], &[]) };
        for matrix in [&mut train.mass, &mut train.damping, &mut train.stiffness] {
            *matrix = DMatrix::zeros(n, n);
        }
        for copy in copies {
            let from = (train.freedoms.len(), train.freedoms.len());
            train.mass.view_mut(from, copy.mass.shape()).copy_from(&copy.mass);
            train.damping.view_mut(from, copy.mass.shape()).copy_from(&copy.damping);
            train.stiffness.view_mut(from, copy.mass.shape()).copy_from(&copy.stiffness);
            train.wheels.extend(copy.wheels.iter().map(|wheel| from.0 + wheel));
            train.vehicles.extend(&copy.vehicles);
            let before = train.freedoms.clone();
            let bodies =
                |part| before.iter().filter(|g| g.part == part && g.motion == Motion::Bounce).count();
            let numbered = copy.freedoms.iter().map(|f| Freedom { number: f.number + bodies(f.part), ..*f });
            train.freedoms.extend(numbered);
        }
        train
    }
}

#[cfg(test)]
mod tests {
    use super::super::on_bogies::tests::others;
    use super::super::tests::{ICE3, undamped};
    use super::*;
    use num_complex::Complex64;

    #[test]
    fn a_row_is_not_coupled() {
        let two = Multibody::two(&ICE3).unwrap();
        let row = two.row(&ICE3.positions()).unwrap();
        let a = row.receptance(30.0);
        assert_eq!(row.wheelset_count(), 4);
        assert_eq!(a[(2, 2)], two.receptance(30.0)[(0, 0)]);
        assert_eq!(a[(2, 1)], Complex64::ZERO);
        assert_eq!(row.axles(), Multibody::ten(&ICE3).unwrap().axles());
        let train = Multibody::ten(&ICE3).unwrap().row(&[0.0, 24.775]).unwrap();
        assert_eq!(train.axles()[5].position, 24.775 + 2.5);
        // rows of rows: eight vehicles of four wheelsets each
        let eight: Vec<f64> = (0..8).map(|i| 24.775 * f64::from(i)).collect();
        let train = row.row(&eight).unwrap();
        let a = train.receptance(30.0);
        assert_eq!((train.wheelset_count(), a.nrows()), (32, 32));
        assert_eq!(a[(31, 31)], a[(0, 0)]);
        assert_eq!(a[(31, 30)], Complex64::ZERO);
        let a = Multibody::ten(&ICE3).unwrap().row(&eight).unwrap().receptance(30.0);
        assert_eq!(a[(29, 30)], a[(1, 2)]);
        assert_eq!(a[(3, 4)], Complex64::ZERO);
        assert!(two.row(&[f64::NAN]).is_err());
    }

    #[test]
    fn a_vehicle_that_is_alike_in_front_and_behind_runs_both_ways() {
        let row = Multibody::ten(&ICE3).unwrap().row(&[1.0, 24.75]).unwrap();
        // the row reaches from 1 m to 24.75 + 19.875 m
        let turned = row.reversed(45.625);
        assert_eq!(
            (&turned.axles, &turned.freedoms, &turned.wheels),
            (&row.axles, &row.freedoms, &row.wheels)
        );
        assert_eq!((&turned.mass, &turned.vehicles), (&row.mass, &row.vehicles));
        for (a, b) in [(&turned.stiffness, &row.stiffness), (&turned.damping, &row.damping)] {
            assert!((a - b).norm() < 1e-15 * b.norm(), "{}", a - b);
        }
        let mixed =
            Multibody::train(&[row.clone(), Multibody::two(&undamped()).unwrap().row(&[60.0]).unwrap()]);
        let turned = mixed.reversed(61.0);
        assert_eq!((turned.axles()[0].position, turned.axles()[8].position), (1.0, 60.0));
        let (a, b) = (mixed.receptance(30.0), turned.receptance(30.0));
        let n = a.nrows();
        // measured 3e-16: the same bodies in another order
        assert!((0..n * n).all(
            |k| (a[(k / n, k % n)] - b[(n - 1 - k / n, n - 1 - k % n)]).norm() < 1e-14 * a[(0, 0)].norm()
        ));
        assert_eq!(turned.reversed(61.0), mixed);
    }

    #[test]
    fn articulated_vehicles_are_alike_both_ways() {
        let model = Multibody::ten(&others()[1]).unwrap();
        let end = model.axles().last().unwrap().position;
        let turned = model.reversed(end);
        assert_eq!((&turned.freedoms, &turned.wheels), (&model.freedoms, &model.wheels));
        assert!((&turned.stiffness - &model.stiffness).norm() < 1e-15 * model.stiffness.norm());
        assert!(
            turned.axles().iter().zip(model.axles()).all(|(a, b)| (a.position - b.position).abs() < 1e-12)
        );
        // a push at the front is felt at the rear, through every body between
        assert!(model.receptance(30.0)[(7, 0)].norm() > 0.0);
    }

    #[test]
    fn different_vehicles_stand_for_themselves() {
        let (ten, two) = (Multibody::ten(&ICE3).unwrap(), Multibody::two(&undamped()).unwrap());
        let (ahead, behind) = (ten.row(&[0.0, 24.775]).unwrap(), two.row(&[60.0]).unwrap());
        let train = Multibody::train(&[ahead.clone(), behind.clone(), ahead.clone()]);
        assert_eq!((train.copies(), train.wheelset_count(), train.freedoms().len()), (1, 17, 42));
        for omega in [0.0, 1.0, 30.0] {
            let (a, one, other) =
                (train.receptance(omega), ahead.receptance(omega), behind.receptance(omega));
            assert_eq!(a.view((0, 0), (8, 8)), one);
            assert_eq!((a[(8, 8)], a[(12, 10)]), (other[(0, 0)], one[(3, 1)]));
            assert_eq!(
                (a[(3, 4)], a[(7, 8)], a[(9, 3)]),
                (Complex64::ZERO, Complex64::ZERO, Complex64::ZERO)
            );
        }
        // each body weighs what it weighs alone
        let parts = [ahead.weights(0), ahead.weights(1), behind.weights(0)];
        let alone: Vec<f64> = parts.iter().flat_map(|w| w.iter().copied()).collect();
        assert_eq!(train.weights(0).rows(0, 22).iter().copied().collect::<Vec<_>>(), alone);
        assert_eq!(train.freedoms().last().unwrap().to_string(), "body 4, pitch");
        // alike but for their places: copies
        let alike = Multibody::train(&[ten.row(&[0.0]).unwrap(), ten.row(&[24.775, 50.0]).unwrap()]);
        assert_eq!(alike, ten.row(&[0.0, 24.775, 50.0]).unwrap());
    }
}
