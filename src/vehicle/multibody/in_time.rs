//! What time stepping needs of a vehicle: its matrices, its weights, half of it.

use super::Multibody;
use crate::vehicle::{Axle, Freedom, GRAVITY, Motion};
use nalgebra::{DMatrix, DVector};

impl Multibody {
    /// M [kg, kg m²] of one copy.
    pub fn mass(&self) -> &DMatrix<f64> {
        &self.mass
    }

    /// C [N s/m, …] of one copy.
    pub fn damping(&self) -> &DMatrix<f64> {
        &self.damping
    }

    /// K [N/m, …] of one copy.
    pub fn stiffness(&self) -> &DMatrix<f64> {
        &self.stiffness
    }

    /// What each degree of freedom of one copy is, in the order of M, C and K.
    pub fn freedoms(&self) -> &[Freedom] {
        &self.freedoms
    }

    /// Which of them are the wheelsets, leading one first.
    pub fn wheels(&self) -> &[usize] {
        &self.wheels
    }

    /// How many copies stand in the row.
    pub fn copies(&self) -> usize {
        self.axles.len() / self.wheels.len()
    }

    /// Half of it, and half its loads: what one rail carries of wheelsets and bodies on two.
    #[must_use]
    pub fn per_rail(&self) -> Self {
        Self {
            mass: 0.5 * &self.mass,
            damping: 0.5 * &self.damping,
            stiffness: 0.5 * &self.stiffness,
            axles: self.axles.iter().map(|a| Axle { load: 0.5 * a.load, ..*a }).collect(),
            ..self.clone()
        }
    }

    /// The same wheelsets with static `loads` [N] of their own, in the order of [`Multibody::axles`]; loads beyond them are ignored.
    #[must_use]
    pub fn with_loads(&self, loads: &[f64]) -> Self {
        let mut heavier = self.clone();
        heavier.axles.iter_mut().zip(loads).for_each(|(axle, load)| axle.load = *load);
        heavier
    }

    /// w [N]: the weight on each degree of freedom of `copy`, from 0, which add up to the static loads of its wheelsets. Every body
    /// weighs g m; what the model leaves out stands on the bodies of the highest kind it has, in equal parts.
    pub fn weights(&self, copy: usize) -> DVector<f64> {
        let bounces = |f: &Freedom| f.motion == Motion::Bounce;
        let mut weights = DVector::from_fn(self.freedoms.len(), |i, _| match self.freedoms[i].motion {
            Motion::Bounce => GRAVITY * self.mass[(i, i)],
            Motion::Pitch => 0.0,
        });
        let (mut freedom, mut wheel) = (0, copy * self.wheels.len());
        for &(size, count) in &self.vehicles {
            let loads: f64 = self.axles[wheel..wheel + count].iter().map(|a| a.load).sum();
            let own = freedom..freedom + size;
            let highest = self.freedoms[own.clone()].last().map(|f| f.part);
            let is_top = |i: &usize| Some(self.freedoms[*i].part) == highest && bounces(&self.freedoms[*i]);
            let top: Vec<usize> = own.clone().filter(is_top).collect();
            let rest = (loads - weights.rows(freedom, size).sum()) / top.len() as f64;
            top.into_iter().for_each(|i| weights[i] += rest);
            (freedom, wheel) = (own.end, wheel + count);
        }
        weights
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vehicle::multibody::tests::ICE3;
    use num_complex::Complex64;

    #[test]
    fn weights_add_up_to_the_loads() {
        let unsprung = Multibody::unsprung(1800.0, ICE3.axle_loads()[0]);
        let two = Multibody::two(&ICE3);
        let others = [Multibody::four(&ICE3), Multibody::five(&ICE3), Multibody::ten(&ICE3)];
        for model in [unsprung, two].into_iter().chain(others).map(Result::unwrap) {
            let count = model.wheels().len();
            assert_eq!((model.copies(), model.wheelset_count()), (1, count));
            let row = model.row(&[0.0, 30.0]).unwrap();
            let loads: Vec<f64> = (0..2 * count).map(|i| if i < count { 100e3 } else { 150e3 }).collect();
            let row = row.with_loads(&loads);
            assert_eq!(row.copies(), 2);
            for (copy, load) in [(0, 100e3), (1, 150e3)] {
                // rounding
                assert!((row.weights(copy).sum() / (load * count as f64) - 1.0).abs() < 1e-14);
            }
            let half = row.per_rail();
            assert_eq!(half.weights(1), 0.5 * row.weights(1));
            assert_eq!(half.receptance(30.0), row.receptance(30.0) * Complex64::from(2.0));
        }
        // what stands on two: a quarter of the body, and half the bogie that is there
        let two = Multibody::two(&ICE3).unwrap();
        assert!((two.weights(0)[1] - 9.81 * (1750.0 + 11_950.0)).abs() < 1e-9);
        let names: Vec<String> =
            Multibody::ten(&ICE3).unwrap().freedoms().iter().map(ToString::to_string).collect();
        assert_eq!(
            names[3..8],
            ["wheelset 4, bounce", "bogie 1, bounce", "bogie 1, pitch", "bogie 2, bounce", "bogie 2, pitch"]
        );
        assert_eq!(names[9], "body 1, pitch");
    }
}
