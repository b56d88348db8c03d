//! Rails by the names of their sections, and how many of them a track's numbers stand for.

use super::member::Beam;
use super::{Member, TrackError};
use crate::quantity::keyed;
use schemars::{JsonSchema, Schema};
use serde::Deserialize;
use serde::de::{Deserializer, Error};

/// E [Pa], G [Pa] and ρ [kg/m³] of rail steel, and κ of a rail's section. Source: Thompson 2009, Table 3.1; κ also Lamprea-Pineda et al.
/// 2022, Table 3.
const STEEL: (f64, f64, f64, f64) = (2.1e11, 7.7e10, 7850.0, 0.4);

/// Vignole rails. Source: EN 13674-1:2011, annex A; UIC 860 for the older names; AREMA, Manual for Railway Engineering, chapter 4, figures
/// 4-1-1 to 4-1-3, as printed by railtrackfastener.com, "Design of steel rail", for those of America.
#[derive(Clone, Copy, Debug, Deserialize, Eq, JsonSchema, PartialEq)]
pub enum Section {
    /// 49 kg/m
    #[serde(rename = "49E1")]
    E49,
    /// 51 kg/m
    #[serde(rename = "50E6")]
    E50,
    /// 55 kg/m
    #[serde(rename = "54E1")]
    E54,
    /// 60 kg/m
    #[serde(rename = "60E1")]
    E60,
    /// 60 kg/m, its head a little lower
    #[serde(rename = "60E2")]
    E60Two,
    /// 54E1 as UIC 860 drew it
    #[serde(rename = "UIC54")]
    Uic54,
    /// 60E1 as UIC 860 drew it
    #[serde(rename = "UIC60")]
    Uic60,
    /// 115 lb/yd, 57 kg/m
    #[serde(rename = "115RE")]
    Re115,
    /// 119 lb/yd, 59 kg/m
    #[serde(rename = "119RE")]
    Re119,
    /// 132 lb/yd, 65 kg/m
    #[serde(rename = "132RE")]
    Re132,
}

impl Section {
    /// A [m²] and I about the horizontal axis [m⁴], from cm² and cm⁴, or from in² and in⁴.
    fn area(self) -> (f64, f64) {
        const INCH: f64 = 2.54;
        let inches = |area: f64, second: f64| (INCH.powi(2) * area, INCH.powi(4) * second);
        let (area, second) = match self {
            Self::Re115 => inches(11.2171, 65.5),
            Self::Re119 => inches(11.6378, 71.4),
            Self::Re132 => inches(12.9124, 87.9),
            Self::E49 => (62.92, 1816.0),
            Self::E50 => (64.84, 2017.8),
            Self::E54 => (69.77, 2337.9),
            Self::E60 => (76.70, 3038.3),
            Self::E60Two => (76.48, 3021.5),
            Self::Uic54 => (69.34, 2346.0),
            Self::Uic60 => (76.86, 3055.0),
        };
        (1e-4 * area, 1e-8 * second)
    }

    /// One new rail, a Timoshenko beam of EI, m = ρA, κGA and ρI; nothing is lost in it.
    ///
    /// # Errors
    /// None of these sections.
    pub fn rail(self, loss_factor: f64) -> Result<Member, TrackError> {
        let ((area, second), (young, shear, density, kappa)) = (self.area(), STEEL);
        Member::timoshenko(
            young * second,
            density * area,
            kappa * shear * area,
            density * second,
            loss_factor,
        )
    }
}

/// How many rails the numbers of a track stand for: all of them, per metre.
#[derive(Clone, Copy, Debug, Default, Deserialize, Eq, PartialEq)]
#[serde(try_from = "f64")]
pub enum Rails {
    /// One rail and its share of what lies under it.
    One,
    /// The whole track.
    #[default]
    Two,
}

impl Rails {
    /// 1 or 2.
    pub fn count(self) -> f64 {
        match self {
            Self::One => 1.0,
            Self::Two => 2.0,
        }
    }
}

impl TryFrom<f64> for Rails {
    type Error = TrackError;

    fn try_from(found: f64) -> Result<Self, TrackError> {
        match found {
            1.0 => Ok(Self::One),
            2.0 => Ok(Self::Two),
            _ => Err(TrackError::Rails { found }),
        }
    }
}

impl JsonSchema for Rails {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Rails".into()
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> Schema {
        schemars::json_schema!({ "description": "How many rails the numbers of a track stand for", "enum": [1, 2] })
    }
}

/// `rail` of a case file: numbers that stand for all rails together, or a section, of which there are as many as `rails` says.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Rail {
    /// All rails as one beam.
    Together(Member),
    /// Each of them.
    Each(Member),
}

/// A rail as a case file says it.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(transform = numbers_or_section)]
pub struct RailKeys {
    /// A published section, per rail, instead of the numbers; says the number of rails too
    section: Option<Section>,
    /// EI [N m²]
    bending_stiffness: Option<f64>,
    /// [kg/m]
    mass: Option<f64>,
    /// κGA [N]; with it a Timoshenko beam
    shear_stiffness: Option<f64>,
    /// ρI [kg m]
    rotary_inertia: Option<f64>,
    /// η of EI and κGA
    #[serde(default)]
    loss_factor: f64,
}

fn numbers_or_section(schema: &mut Schema) {
    let numbers = serde_json::json!({ "required": ["bending_stiffness", "mass"] });
    schema.insert("oneOf".into(), serde_json::json!([numbers, { "required": ["section"] }]));
}

impl<'de> Deserialize<'de> for Rail {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let RailKeys { section, bending_stiffness, mass, shear_stiffness, rotary_inertia, loss_factor } =
            RailKeys::deserialize(deserializer)?;
        let Some(section) = section else {
            let bending_stiffness =
                bending_stiffness.ok_or_else(|| D::Error::missing_field("bending_stiffness"))?;
            let mass = mass.ok_or_else(|| D::Error::missing_field("mass"))?;
            let rotary_inertia = rotary_inertia.unwrap_or_default();
            let beam = Beam { bending_stiffness, mass, shear_stiffness, rotary_inertia, loss_factor };
            return Member::try_from(beam).map(Self::Together).map_err(D::Error::custom);
        };
        if [bending_stiffness, mass, shear_stiffness, rotary_inertia].iter().any(Option::is_some) {
            let more = "a section has its numbers: remove bending_stiffness, mass, shear_stiffness and rotary_inertia beside it";
            return Err(D::Error::custom(keyed("section", more)));
        }
        section.rail(loss_factor).map(Self::Each).map_err(D::Error::custom)
    }
}

impl From<Member> for Rail {
    fn from(rail: Member) -> Self {
        Self::Together(rail)
    }
}

impl Rail {
    /// All rails as one beam.
    ///
    /// # Errors
    /// A section without the number of `rails`.
    pub fn member(self, rails: Option<Rails>) -> Result<Member, TrackError> {
        match self {
            Self::Together(rail) => Ok(rail),
            Self::Each(rail) => Ok(rail.times(rails.ok_or(TrackError::RailsMissing)?.count())),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rails_of_america_weigh_what_is_printed() {
        // lb/yd of figures 4-1-1 to 4-1-3, of a steel of 7840 kg/m³
        for (section, pounds) in
            [(Section::Re115, 114.3757), (Section::Re119, 118.6657), (Section::Re132, 131.6622)]
        {
            let mass = section.area().0 * 7840.0;
            // measured 2e-4: pounds, yards and the printed density
            assert!((mass / (pounds * 0.453_592_37 / 0.9144) - 1.0).abs() < 3e-4, "{section:?} {mass}");
        }
    }

    #[test]
    fn a_rail_of_60_kg_is_that_of_the_papers() {
        // Table 3: EI 6.38e6, m 60.23, κGA 0.4 × 5.91e8, ρI 0.239, of which the first digits are those of 60E1
        let rail = Section::E60.rail(0.0).unwrap();
        let paper = Member::timoshenko(6.38e6, 60.23, 0.4 * 5.91e8, 0.239, 0.0).unwrap();
        for (beta2, omega, bound) in [(30.0, 0.0, 1e-3), (0.0, 100.0, 1e-3), (3.0, 2e4, 5e-3)] {
            let (a, b) = (rail.stiffness(f64::into(beta2), omega), paper.stiffness(f64::into(beta2), omega));
            // measured 6e-4 (κGA), 3e-4 (m), 6e-4
            assert!((a - b).norm() < bound * b.norm(), "{a} {b}");
        }
        // two of them
        let two = Rail::Each(rail).member(Some(Rails::Two)).unwrap();
        let (one, two) = (rail.stiffness(3.0.into(), 2e4), two.stiffness(3.0.into(), 2e4));
        assert!((two - 2.0 * one).norm() < 1e-14 * two.norm());
        assert_eq!(Rail::Each(rail).member(None), Err(TrackError::RailsMissing));
        assert_eq!(Rail::Together(rail).member(None), Ok(rail));
        assert!(Rails::try_from(3.0).is_err() && Rails::try_from(1.0) == Ok(Rails::One));
    }
}
