//! Levels of velocity, always with their reference.

use super::AssessmentError;
use schemars::JsonSchema;
use serde::Deserialize;

/// The velocity that has level zero.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
pub enum Reference {
    /// v₀ = 1e-9 m/s, ISO 1683.
    #[serde(rename = "1e-9 m/s")]
    Iso1683,
    /// v₀ = 5e-8 m/s, usual in Germany (DIN 45669, VDI 3837).
    #[serde(rename = "5e-8 m/s")]
    German,
    /// v₀ = 2.54e-8 m/s, one microinch per second: VdB of the Federal Transit Administration.
    #[serde(rename = "vdb")]
    VdB,
}

impl Reference {
    /// v₀ [m/s]
    pub fn velocity(self) -> f64 {
        match self {
            Self::Iso1683 => 1e-9,
            Self::German => 5e-8,
            Self::VdB => 2.54e-8,
        }
    }

    /// The unit with its reference, as printed behind a level: `dB re 1e-9 m/s`, `dB re 5e-8 m/s`, `VdB re 2.54e-8 m/s`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Iso1683 => "dB re 1e-9 m/s",
            Self::German => "dB re 5e-8 m/s",
            Self::VdB => "VdB re 2.54e-8 m/s",
        }
    }
}

/// A level L = 20 lg(v/v₀) that does not part from its reference.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Level {
    /// L [dB]
    pub decibels: f64,
    /// v₀
    pub reference: Reference,
}

impl Level {
    /// L = 20 lg(v/v₀) of a `velocity` [m/s], usually an r.m.s.
    ///
    /// # Errors
    /// A velocity that is not positive and finite.
    pub fn of(velocity: f64, reference: Reference) -> Result<Self, AssessmentError> {
        if velocity > 0.0 && velocity.is_finite() {
            Ok(Self { decibels: 20.0 * (velocity / reference.velocity()).log10(), reference })
        } else {
            Err(AssessmentError::Velocity { velocity })
        }
    }

    /// v = v₀ 10^{L/20} [m/s]
    pub fn velocity(self) -> f64 {
        self.reference.velocity() * 10f64.powf(self.decibels / 20.0)
    }

    /// The same velocity against another reference.
    pub fn against(self, reference: Reference) -> Self {
        let shift = 20.0 * (self.reference.velocity() / reference.velocity()).log10();
        Self { decibels: self.decibels + shift, reference }
    }
}

impl std::fmt::Display for Level {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{:.1} {}", self.decibels, self.reference.name())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_velocity_three_levels() {
        // 0.1 mm/s: 100 dB re 1e-9, 66.02 dB re 5e-8, 71.90 VdB
        let shown = [Reference::Iso1683, Reference::German, Reference::VdB]
            .map(|reference| Level::of(1e-4, reference).unwrap().to_string());
        assert_eq!(shown, ["100.0 dB re 1e-9 m/s", "66.0 dB re 5e-8 m/s", "71.9 VdB re 2.54e-8 m/s"]);
        let level = Level::of(1e-4, Reference::VdB).unwrap();
        assert!((level.velocity() / 1e-4 - 1.0).abs() < 1e-14);
        assert!((level.against(Reference::Iso1683).decibels - 100.0).abs() < 1e-13);
        for velocity in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(Level::of(velocity, Reference::German).is_err());
        }
    }
}
