//! Settings of the thin-layer method: element, accuracy, what lies below, and what they ask of the sublayers.

use super::element::Element;
use super::mesh::Resolution;
use crate::quantity::keyed;
use crate::soil::SoilError;
use schemars::JsonSchema;
use serde::Deserialize;
use serde::de::{Deserializer, Error};

/// How the half-space below the layers is treated.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(rename_all = "kebab-case")]
pub enum BelowLayers {
    /// Matched layers, so that there are modes.
    #[default]
    Matched,
    /// Its exact stiffness: one system of equations for each wavenumber, no modes.
    Exact,
}

/// Settings of the thin-layer method.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(default, deny_unknown_fields, remote = "Self")]
#[schemars(rename = "ThinLayer")]
pub struct ThinLayer {
    /// Degree of the displacements in a sublayer.
    element: Element,
    /// Error of G(k, ω) relative to its largest value, 1e-9 to 0.1.
    pub(super) accuracy: f64,
    /// Sublayers to the shortest wave; by default as many as the accuracy needs.
    sublayers_per_wavelength: Option<f64>,
    /// How the half-space below the layers is treated.
    pub(super) half_space: BelowLayers,
    /// Wavenumbers for which the modes hold [rad/m].
    #[serde(skip)]
    pub(super) k: (f64, f64),
    /// Frequencies the same sublayers serve [rad/s]; None for the one prepared.
    #[serde(skip)]
    frequencies: Option<(f64, f64)>,
}

impl Default for ThinLayer {
    fn default() -> Self {
        Self {
            element: Element::Cubic,
            accuracy: 1e-6,
            sublayers_per_wavelength: None,
            half_space: BelowLayers::Matched,
            k: (0.0, 100.0),
            frequencies: None,
        }
    }
}

impl<'de> Deserialize<'de> for ThinLayer {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let key = |error: &SoilError| match error {
            SoilError::Accuracy { .. } => "accuracy",
            _ => "sublayers_per_wavelength",
        };
        Self::deserialize(deserializer)?.checked().map_err(|e| D::Error::custom(keyed(key(&e), e)))
    }
}

/// Sublayers per wavelength with which G is right to `accuracy` of its largest value on ordinary soil.
///
/// From the order of the element and one measured point each, doubled with ν = 0.495 in mind (test
/// `cross_solver::thin_layer`).
fn sublayers_for(element: Element, accuracy: f64) -> f64 {
    let (sublayers, at) = match element {
        Element::Linear => (30.0, 1e-2),
        Element::Quadratic => (8.0, 1e-4),
        Element::Cubic => (8.0, 1e-6),
    };
    sublayers * (at / accuracy).powf(0.5 / element.degree() as f64)
}

impl ThinLayer {
    /// Settings for compliances right to `accuracy` of their largest value, with `per_wavelength` sublayers to the
    /// shortest wave (as many as are needed, if None).
    ///
    /// # Errors
    /// An accuracy outside 1e-9 to 0.1; too few sublayers for it.
    pub fn new(
        element: Element,
        accuracy: f64,
        per_wavelength: Option<f64>,
        below: BelowLayers,
    ) -> Result<Self, SoilError> {
        let sublayers_per_wavelength = per_wavelength;
        Self { element, accuracy, sublayers_per_wavelength, half_space: below, ..Self::default() }.checked()
    }

    fn checked(self) -> Result<Self, SoilError> {
        let accuracy = self.accuracy;
        if !(1e-9..=0.1).contains(&accuracy) {
            return Err(SoilError::Accuracy { value: accuracy });
        }
        let needed = sublayers_for(self.element, accuracy);
        let given = self.per_wavelength();
        // written so that NaN is refused
        if !(given >= 0.99 * needed && given.is_finite()) {
            return Err(SoilError::Sublayers { given, needed: needed.ceil(), accuracy });
        }
        Ok(self)
    }

    fn per_wavelength(&self) -> f64 {
        self.sublayers_per_wavelength.unwrap_or_else(|| sublayers_for(self.element, self.accuracy))
    }

    /// The same with modes that hold for wavenumbers from `k.0` to `k.1` [rad/m], and no finer than `accuracy` asks. The
    /// larger `k.0`, the less deep must be looked.
    #[must_use]
    pub fn resolving(self, k: (f64, f64), accuracy: f64) -> Self {
        let accuracy = accuracy.max(self.accuracy);
        let coarser = (self.accuracy / accuracy).powf(0.5 / self.element.degree() as f64);
        // two sublayers to a wave at least
        let given = self.per_wavelength();
        Self { k, accuracy, sublayers_per_wavelength: Some((given * coarser).max(2.0).min(given)), ..self }
    }

    /// The same with one set of sublayers for all frequencies from `low` to `high` [rad/s], so that results are smooth in ω.
    #[must_use]
    pub fn for_frequencies(self, low: f64, high: f64) -> Self {
        Self { frequencies: Some((low, high)), ..self }
    }

    /// False where the exact half-space leaves none.
    pub fn has_modes(&self) -> bool {
        self.half_space == BelowLayers::Matched
    }

    /// The settings, in words.
    pub fn text(&self) -> String {
        let element = match self.element {
            Element::Linear => "linear",
            Element::Quadratic => "quadratic",
            Element::Cubic => "cubic",
        };
        let below = match self.half_space {
            BelowLayers::Matched => "matched layers for the half-space",
            BelowLayers::Exact => "exact half-space",
        };
        format!("{element} elements, {:.1} to a wavelength, {below}", self.per_wavelength())
    }

    pub(super) fn resolution(&self, omega: f64, k_max: f64) -> Resolution {
        Resolution {
            element: self.element,
            per_wavelength: self.per_wavelength(),
            accuracy: self.accuracy,
            k_min: 1e-8 * self.k.1,
            k_max,
            omega: self.frequencies.unwrap_or((omega, omega)),
        }
    }
}
