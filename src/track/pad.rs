//! Springs under rails, sleepers, ballast and slabs: per metre of track, by the piece, or by the bedding modulus of a mat.

use super::section::Rails;
use super::{Element, Link, TrackError};
use crate::quantity::{keyed, not_negative, positive};
use schemars::{JsonSchema, Schema};
use serde::Deserialize;
use serde::de::{Deserializer, Error};

/// Pads and mats as a case file says them, which become a [`Link`] per metre of track.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pad {
    /// Per metre of the rails a track's numbers stand for.
    Metre(Link),
    /// By the piece, in N/m.
    Piece {
        /// One of them.
        one: Element,
        /// From one to the next along the track [m]; that of the sleepers by default.
        spacing: Option<f64>,
        /// How many lie abreast under the whole track; by default what it lies under has of them.
        abreast: Option<f64>,
    },
    /// A mat all along the track, per metre of the whole of it.
    Mat(Element),
}

/// One piece.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Piece {
    /// k [N/m]
    stiffness: f64,
    /// c [N s/m]
    #[serde(default)]
    damping: f64,
    /// η
    #[serde(default)]
    loss_factor: f64,
}

/// Pads and mats as a case file says them: by one of stiffness, element, piece and bedding_modulus.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(transform = one_way)]
pub struct PadKeys {
    /// k per metre of track [N/m²]
    stiffness: Option<f64>,
    /// c per metre of track [N s/m²]; 0 by default
    damping: Option<f64>,
    /// η, of a stiffness or of a bedding modulus; 0 by default
    loss_factor: Option<f64>,
    /// Other arrangements of springs and dashpots per metre of track
    element: Option<Element>,
    /// One pad, in N/m
    piece: Option<Piece>,
    /// From one piece to the next along the track [m]; that of the sleepers by default
    spacing: Option<f64>,
    /// How many pieces lie abreast under the whole track; 2 under rails, 1 under sleepers, ballast and slabs by default
    abreast: Option<f64>,
    /// C [N/m³]: stiffness per area of a pad or mat
    bedding_modulus: Option<f64>,
    /// Width of a mat under the whole track [m], with its bedding modulus
    width: Option<f64>,
    /// Area of one pad [m²], with its bedding modulus
    area: Option<f64>,
}

const WAYS: [&str; 4] = ["stiffness", "element", "piece", "bedding_modulus"];

fn one_way(schema: &mut Schema) {
    let ways: Vec<_> = WAYS.iter().map(|key| serde_json::json!({ "required": [key] })).collect();
    schema.insert("oneOf".into(), ways.into());
}

impl<'de> Deserialize<'de> for Pad {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let keys = PadKeys::deserialize(deserializer)?;
        let given = [
            keys.stiffness.is_some(),
            keys.element.is_some(),
            keys.piece.is_some(),
            keys.bedding_modulus.is_some(),
        ];
        let ways: Vec<&str> =
            WAYS.iter().zip(given).filter_map(|(way, there)| there.then_some(*way)).collect();
        let [way] = ways[..] else {
            return Err(match ways.last() {
                None => D::Error::missing_field("stiffness"),
                Some(way) => {
                    let message = format!("{} are all given: one of them says it all", ways.join(" and "));
                    D::Error::custom(keyed(way, message))
                }
            });
        };
        if way == "element" && (keys.damping.is_some() || keys.loss_factor.is_some()) {
            let message = "an element has all its springs and dashpots in its own table: remove damping and loss_factor beside it";
            return Err(D::Error::custom(keyed("element", message)));
        }
        let unused = |key: &str, there: bool, of: &str| match there {
            true => Err(D::Error::custom(keyed(key, format!("it belongs to {of}: remove it beside {way}")))),
            false => Ok(()),
        };
        let area_or_width = keys.area.is_some() || keys.width.is_some();
        unused("damping", keys.damping.is_some() && way != "stiffness", "a stiffness per metre")?;
        let losing = keys.loss_factor.is_some() && !["stiffness", "bedding_modulus"].contains(&way);
        unused("loss_factor", losing, "a stiffness or a bedding modulus")?;
        unused("width", keys.width.is_some() && way != "bedding_modulus", "a bedding modulus")?;
        unused("area", keys.area.is_some() && way != "bedding_modulus", "a bedding modulus")?;
        let pieces = way == "piece" || (way == "bedding_modulus" && keys.area.is_some());
        unused("spacing", keys.spacing.is_some() && !pieces, "pieces")?;
        unused("abreast", keys.abreast.is_some() && !pieces, "pieces")?;
        if way == "bedding_modulus" && keys.area.is_some() == keys.width.is_some() {
            let message = match area_or_width {
                true => "area and width are both given: area is of one pad, width of a mat all along",
                false => "a bedding modulus is per area: add the width of the mat, or the area of one pad",
            };
            return Err(D::Error::custom(keyed("bedding_modulus", message)));
        }
        keys.pad().map_err(D::Error::custom)
    }
}

impl PadKeys {
    /// The pad that these keys say, each of them known to belong there.
    fn pad(self) -> Result<Pad, TrackError> {
        let loss_factor = not_negative("loss_factor", self.loss_factor.unwrap_or_default(), "")?;
        for (key, value, unit) in [
            ("spacing", self.spacing, "m"),
            ("abreast", self.abreast, ""),
            ("width", self.width, "m"),
            ("area", self.area, "m²"),
            ("bedding_modulus", self.bedding_modulus, "N/m³"),
        ] {
            value.map(|value| positive(key, value, unit)).transpose()?;
        }
        let Self { spacing, abreast, .. } = self;
        if let Some(Piece { stiffness, damping, loss_factor }) = self.piece {
            positive("piece.stiffness", stiffness, "N/m")?;
            not_negative("piece.damping", damping, "N s/m")?;
            not_negative("piece.loss_factor", loss_factor, "")?;
            return Ok(Pad::Piece {
                one: Element::spring(stiffness, damping, loss_factor)?,
                spacing,
                abreast,
            });
        }
        if let Some(element) = self.element {
            return Ok(Pad::Metre(Link::Element(element.checked()?)));
        }
        // stiffness of a spring of this area, or per metre of this width
        let bedded =
            |over: f64| Element::spring(self.bedding_modulus.unwrap_or_default() * over, 0.0, loss_factor);
        Ok(match (self.area, self.width) {
            (Some(area), _) => Pad::Piece { one: bedded(area)?, spacing, abreast },
            (None, Some(width)) => Pad::Mat(bedded(width)?),
            (None, None) => {
                let (stiffness, damping) =
                    (self.stiffness.unwrap_or_default(), self.damping.unwrap_or_default());
                Pad::Metre(Link::spring(stiffness, damping, loss_factor)?)
            }
        })
    }
}

impl From<Link> for Pad {
    fn from(link: Link) -> Self {
        Self::Metre(link)
    }
}

impl Pad {
    /// Per metre of `rails` rails; pieces lie `spacing` [m] from one another and `abreast` under the whole track, if they do not say
    /// themselves.
    ///
    /// # Errors
    /// Pieces without a spacing.
    pub fn link(self, rails: Option<Rails>, spacing: Option<f64>, abreast: f64) -> Result<Link, TrackError> {
        let share = 0.5 * rails.unwrap_or_default().count();
        Ok(match self {
            Self::Metre(link) => link,
            Self::Mat(element) => Link::Element(element.times(share)),
            Self::Piece { one, spacing: own, abreast: own_abreast } => {
                let spacing = own.or(spacing).ok_or(TrackError::SpacingMissing)?;
                Link::Element(one.times(share * own_abreast.unwrap_or(abreast) / spacing))
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_same_pad_by_every_way() {
        let pad = |text: &str| toml::from_str::<Pad>(text).unwrap();
        let stiffness =
            |pad: Pad, rails, abreast| pad.link(rails, Some(0.6), abreast).unwrap().stiffness(30.0).upper;
        // two pads of 150 kN/mm every 0.6 m: 500 MN/m²; measured 1e-16
        let metre = pad("stiffness = 5e8\ndamping = 1e5\nloss_factor = 0.1");
        let piece = pad("piece = { stiffness = 1.5e8, damping = 3e4, loss_factor = 0.1 }");
        let k = stiffness(metre, None, 2.0);
        assert!((stiffness(piece, None, 2.0) - k).norm() < 1e-15 * k.norm());
        assert!((stiffness(piece, Some(Rails::One), 2.0) - 0.5 * k).norm() < 1e-15 * k.norm());
        // every metre, three abreast
        let own = pad("piece.stiffness = 1e8\nspacing = 1.0\nabreast = 3");
        assert_eq!(stiffness(own, None, 2.0).re, 3e8);
        // C = 0.1 N/mm³ on 3 m, and on sleepers of 0.6 m² every 0.6 m; measured 1e-16
        let mat = pad("bedding_modulus = 1e8\nwidth = 3.0\nloss_factor = 0.2");
        assert!((stiffness(mat, Some(Rails::One), 1.0) - stiffness(mat, None, 1.0) * 0.5).norm() < 1e-8);
        assert!((stiffness(mat, None, 1.0).re / 3e8 - 1.0).abs() < 1e-15);
        let under = pad("bedding_modulus = 1e8\narea = 0.6");
        assert!((stiffness(under, None, 1.0).re / 1e8 - 1.0).abs() < 1e-15);
        assert_eq!(under.link(None, None, 1.0), Err(TrackError::SpacingMissing));
    }

    #[test]
    fn one_way_at_a_time() {
        let refused = |text: &str| toml::from_str::<Pad>(text).unwrap_err().to_string();
        for (text, said) in [
            ("loss_factor = 0.1", "missing field `stiffness`"),
            ("stiffness = 1e8\npiece.stiffness = 1e8", "stiffness and piece are all given"),
            (
                "piece.stiffness = 1e8\ndamping = 1.0",
                "it belongs to a stiffness per metre: remove it beside piece",
            ),
            ("bedding_modulus = 1e8", "a bedding modulus is per area"),
            ("bedding_modulus = 1e8\narea = 1.0\nwidth = 1.0", "area and width are both given"),
            ("stiffness = 1e8\nspacing = 0.6", "it belongs to pieces"),
            ("piece.stiffness = 0.0", "piece.stiffness is 0 N/m"),
            ("bedding_modulus = -1.0\nwidth = 3.0", "bedding_modulus is -1 N/m³"),
        ] {
            assert!(refused(text).contains(said), "{text}: {}", refused(text));
        }
    }
}
