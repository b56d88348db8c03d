//! Ballasted tracks: rails, pads, sleepers, ballast in one layer or two, mats, per metre of whole track (both rails), or of one rail and
//! its share.

use super::pad::PadKeys;
use super::section::{Rail, RailKeys, Rails};
use super::{Ballast, Link, Member, Pad, Stack, TrackError};
use crate::quantity::{keyed, not_negative, positive};
use schemars::{JsonSchema, Schema};
use serde::Deserialize;
use serde::de::{Deserializer, Error};

/// A ballasted track. Source: appendix A.2 (corrected) and A.3; with a mass of ballast on a second layer, Zhai, Wang & Lin 2004, J. Sound
/// Vib. 270.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Ballasted {
    /// How many rails all numbers stand for; the whole track by default, and to be said of a section.
    pub rails: Option<Rails>,
    /// All of them.
    #[schemars(with = "RailKeys")]
    pub rail: Rail,
    /// Their pads.
    #[schemars(with = "PadKeys")]
    pub pad: Pad,
    /// Sleepers.
    #[schemars(with = "SleeperKeys")]
    pub sleeper: Sleeper,
    /// Pads under the sleepers.
    #[schemars(with = "Option<PadKeys>")]
    pub under_sleeper_pad: Option<Pad>,
    /// Ballast.
    pub ballast: Ballast,
    /// What the ballast lies on: sub-ballast, or more ballast.
    pub sub_ballast: Option<Ballast>,
    /// A mat under all of it.
    #[schemars(with = "Option<PadKeys>")]
    pub mat: Option<Pad>,
}

/// Sleepers as a continuous mass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sleeper {
    /// How heavy they are.
    pub mass: SleeperMass,
    /// From one to the next [m], where something is counted by the piece.
    pub spacing: Option<f64>,
}

/// Of sleepers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SleeperMass {
    /// [kg/m], of the rails a track's numbers stand for.
    Metre(f64),
    /// Of a whole one [kg].
    Piece(f64),
}

/// One sleeper.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct SleeperPiece {
    /// Under both rails [kg]
    mass: f64,
}

/// Sleepers as a case file says them.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(transform = mass_or_piece)]
pub struct SleeperKeys {
    /// Per metre of track [kg/m]
    mass: Option<f64>,
    /// One sleeper, instead of the mass per metre
    piece: Option<SleeperPiece>,
    /// From one to the next [m], for what is counted by the piece; that of the supports by default
    spacing: Option<f64>,
}

fn mass_or_piece(schema: &mut Schema) {
    let ways = serde_json::json!([{ "required": ["mass"] }, { "required": ["piece"] }]);
    schema.insert("oneOf".into(), ways);
}

impl<'de> Deserialize<'de> for Sleeper {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let SleeperKeys { mass, piece, spacing } = SleeperKeys::deserialize(deserializer)?;
        let mass = match (mass, piece) {
            (Some(mass), None) => not_negative("mass", mass, "kg/m").map(SleeperMass::Metre),
            (None, Some(piece)) => not_negative("piece.mass", piece.mass, "kg").map(SleeperMass::Piece),
            (None, None) => return Err(D::Error::missing_field("mass")),
            (Some(_), Some(_)) => {
                return Err(D::Error::custom(keyed(
                    "piece",
                    "mass and piece are both given: remove one of them",
                )));
            }
        };
        let mass = mass.map_err(D::Error::custom)?;
        spacing.map(|spacing| positive("spacing", spacing, "m")).transpose().map_err(D::Error::custom)?;
        Ok(Self { mass, spacing })
    }
}

impl Sleeper {
    /// Sleepers of `mass` [kg/m].
    pub fn per_metre(mass: f64) -> Self {
        Self { mass: SleeperMass::Metre(mass), spacing: None }
    }

    /// The same per metre of `rails` rails.
    fn member(self, rails: Option<Rails>) -> Result<Member, TrackError> {
        Member::mass(match self.mass {
            SleeperMass::Metre(mass) => not_negative("sleeper.mass", mass, "kg/m")?,
            SleeperMass::Piece(mass) => {
                let spacing = self.spacing.ok_or(TrackError::SpacingMissing)?;
                0.5 * rails.unwrap_or_default().count() * mass / spacing
            }
        })
    }
}

impl Ballasted {
    /// The whole track of `rail`s, `pad`s, `sleeper`s and `ballast`, without what may lie under them.
    pub fn new(rail: Rail, pad: Pad, sleeper: Sleeper, ballast: Ballast) -> Self {
        Self {
            rails: None,
            rail,
            pad,
            sleeper,
            under_sleeper_pad: None,
            ballast,
            sub_ballast: None,
            mat: None,
        }
    }

    /// The stack rail – pads – sleepers (– pads under them) – ballast (– sub-ballast, – mat) – base; bars are as wide as the contact with
    /// the ground, 2 × `half_width` [m].
    ///
    /// # Errors
    /// A quantity out of its range; bars without a width, without a wave speed, or with two; pieces without a spacing; a section without
    /// the number of rails.
    pub fn stack(&self, half_width: Option<f64>) -> Result<Stack, TrackError> {
        let Self { rails, sleeper, .. } = *self;
        let link = |pad: Pad, abreast| pad.link(rails, sleeper.spacing, abreast);
        let mut members = vec![self.rail.member(rails)?, sleeper.member(rails)?];
        let mut links = vec![link(self.pad, 2.0)?];
        let mut lay = |below: Link, foot: Option<Member>| -> Result<(), TrackError> {
            // nothing that weighs lies between two links
            if links.len() == members.len() {
                members.push(Member::mass(0.0)?);
            }
            links.push(below);
            members.extend(foot);
            Ok(())
        };
        if let Some(pad) = self.under_sleeper_pad {
            lay(link(pad, 1.0)?, None)?;
        }
        lay(self.ballast.link(half_width)?, self.ballast.foot()?)?;
        if let Some(layer) = &self.sub_ballast {
            let below = |error| TrackError::SubBallast(Box::new(error));
            lay(layer.link(half_width).map_err(below)?, layer.foot().map_err(below)?)?;
        }
        if let Some(mat) = self.mat {
            lay(link(mat, 1.0)?, None)?;
        }
        Ok(Stack::new(members, links))
    }
}
