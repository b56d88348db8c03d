//! Horizontally layered ground, valid once built.

use super::{Material, SoilError};
use crate::quantity::positive;

/// A horizontal layer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layer {
    /// h [m]
    pub thickness: f64,
    /// What it is made of.
    pub material: Material,
}

/// What the lowest layer stands on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Base {
    /// A homogeneous half-space.
    HalfSpace(Material),
    /// Rigid rock: no displacement at the bottom of the lowest layer.
    Rigid,
}

/// Layers, top first, over a half-space or a rigid base.
#[derive(Clone, Debug, PartialEq)]
pub struct Profile {
    layers: Vec<Layer>,
    base: Base,
}

impl Profile {
    /// A profile from `layers`, top first, and its `base`.
    ///
    /// # Errors
    /// A thickness that is not finite and positive; a rigid base without a layer on it.
    pub fn new(layers: Vec<Layer>, base: Base) -> Result<Self, SoilError> {
        for layer in &layers {
            positive("thickness", layer.thickness, "m")?;
        }
        if layers.is_empty() && base == Base::Rigid {
            return Err(SoilError::NoGround);
        }
        Ok(Self { layers, base })
    }

    /// Layers, top first.
    pub fn layers(&self) -> &[Layer] {
        &self.layers
    }

    /// What the lowest layer stands on.
    pub fn base(&self) -> Base {
        self.base
    }

    /// All materials, top first, the half-space last.
    pub fn materials(&self) -> impl Iterator<Item = &Material> {
        let half_space = match &self.base {
            Base::HalfSpace(material) => Some(material),
            Base::Rigid => None,
        };
        self.layers.iter().map(|l| &l.material).chain(half_space)
    }

    /// The material at the surface.
    pub fn top(&self) -> &Material {
        match (self.layers.first(), &self.base) {
            (Some(layer), _) => &layer.material,
            (None, Base::HalfSpace(material)) => material,
            (None, Base::Rigid) => unreachable!("refused by Profile::new"),
        }
    }

    /// How deep the material at the surface reaches [m], through however many layers of it; None where nothing else lies below.
    pub fn top_thickness(&self) -> Option<f64> {
        let other = self.layers.iter().position(|l| l.material != *self.top());
        let count = other.unwrap_or(self.layers.len());
        let ends = other.is_some() || self.base != Base::HalfSpace(*self.top());
        ends.then(|| self.layers[..count].iter().map(|l| l.thickness).sum())
    }

    /// Depth of the base [m].
    pub fn depth(&self) -> f64 {
        self.layers.iter().map(|l| l.thickness).sum()
    }

    /// True if no layer dissipates: every pole of the compliance is real.
    pub fn is_undamped(&self) -> bool {
        self.materials().all(|m| m.loss_factor() == 0.0 && m.loss_factor_pressure() == 0.0)
    }

    /// The same ground with every loss factor × `factor`, 0 to 1.
    pub fn with_loss_times(&self, factor: f64) -> Self {
        self.of(|material| material.with_loss_times(factor))
    }

    /// The same ground with every loss factor `loss` ≥ 0.
    pub fn with_loss(&self, loss: f64) -> Self {
        self.of(|material| material.with_loss(loss))
    }

    /// The same geometry of other materials.
    fn of(&self, other: impl Fn(&Material) -> Material) -> Self {
        let layer = |l: &Layer| Layer { material: other(&l.material), ..*l };
        Self {
            layers: self.layers.iter().map(layer).collect(),
            base: match &self.base {
                Base::HalfSpace(material) => Base::HalfSpace(other(material)),
                Base::Rigid => Base::Rigid,
            },
        }
    }

    /// Smallest Rayleigh speed of the materials [m/s]: no surface wave of the profile is slower.
    pub fn slowest_rayleigh_speed(&self) -> f64 {
        self.materials().map(Material::rayleigh_speed).fold(f64::INFINITY, f64::min)
    }

    /// The same ground with every interface also at `depths` [m], and for each depth the index of its interface
    /// counted from the surface (0).
    ///
    /// # Errors
    /// A depth that is negative, not finite, or below a rigid base.
    pub fn split_at(&self, depths: &[f64]) -> Result<(Self, Vec<usize>), SoilError> {
        let mut interfaces = vec![0.0];
        for layer in &self.layers {
            interfaces.push(interfaces[interfaces.len() - 1] + layer.thickness);
        }
        let bottom = self.depth();
        for &depth in depths {
            if !(depth.is_finite() && depth >= 0.0) || (self.base == Base::Rigid && depth > bottom) {
                return Err(SoilError::Depth { depth, bottom, rigid: self.base == Base::Rigid });
            }
            // closer than rounding to an interface is that interface
            if !interfaces.iter().any(|z| (z - depth).abs() <= 1e-9 * depth) {
                interfaces.push(depth);
            }
        }
        interfaces.sort_by(f64::total_cmp);
        let mut layers = Vec::with_capacity(interfaces.len());
        let mut below = self.layers.iter();
        let mut current = below.next();
        let mut current_bottom = current.map_or(f64::INFINITY, |l| l.thickness);
        for pair in interfaces.windows(2) {
            if pair[0] >= current_bottom * (1.0 - 1e-12) {
                current = below.next();
                current_bottom = current.map_or(f64::INFINITY, |l| current_bottom + l.thickness);
            }
            let material = match (current, self.base) {
                (Some(layer), _) => layer.material,
                (None, Base::HalfSpace(material)) => material,
                (None, Base::Rigid) => unreachable!("depths below a rigid base are refused above"),
            };
            layers.push(Layer { thickness: pair[1] - pair[0], material });
        }
        let index =
            |depth: f64| interfaces.iter().position(|z| (z - depth).abs() <= 1e-9 * depth).unwrap_or(0);
        let indices = depths.iter().map(|&d| index(d)).collect();
        Ok((Self { layers, base: self.base }, indices))
    }
}

#[cfg(test)]
mod tests {
    use super::super::Elastic;
    use super::*;

    fn material(young: f64) -> Material {
        Material::new(Elastic::YoungPoisson { young, poisson: 0.3 }, 1800.0, 0.0, 0.0).unwrap()
    }

    #[test]
    fn splitting_keeps_the_ground() {
        let layers = vec![
            Layer { thickness: 2.0, material: material(1e7) },
            Layer { thickness: 3.0, material: material(2e7) },
        ];
        let profile = Profile::new(layers, Base::HalfSpace(material(3e7))).unwrap();
        let (split, index) = profile.split_at(&[0.0, 1.0, 2.0, 7.0, 4.0]).unwrap();
        assert_eq!(index, [0, 1, 2, 5, 3]);
        let young: Vec<f64> =
            split.layers().iter().map(|l| (l.material.shear_modulus() * 2.6).round()).collect();
        assert_eq!(young, [1e7, 1e7, 2e7, 2e7, 3e7]);
        assert!((split.depth() - 7.0).abs() < 1e-12);
    }

    #[test]
    fn refuses_what_is_no_ground() {
        assert!(Profile::new(vec![], Base::Rigid).is_err());
        assert!(Profile::new(vec![Layer { thickness: 0.0, material: material(1e7) }], Base::Rigid).is_err());
        let rigid =
            Profile::new(vec![Layer { thickness: 2.0, material: material(1e7) }], Base::Rigid).unwrap();
        assert!(rigid.split_at(&[3.0]).is_err());
    }
}
