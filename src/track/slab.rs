//! Slab track: rails on pads on a slab that lies on the ground, or floats on a mat or on bearings, per metre of whole track.

use super::member::Beam;
use super::pad::PadKeys;
use super::section::{Rail, RailKeys, Rails};
use super::{Member, Pad, Stack, TrackError};
use schemars::JsonSchema;
use serde::Deserialize;

/// A slab track. Source: appendix A.4 (corrected).
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Slab {
    /// How many rails all numbers stand for; the whole track by default, and to be said of a section.
    pub rails: Option<Rails>,
    /// All of them.
    #[schemars(with = "RailKeys")]
    pub rail: Rail,
    /// Their pads.
    #[schemars(with = "PadKeys")]
    pub pad: Pad,
    /// The slab.
    #[schemars(with = "Beam")]
    pub slab: Member,
    /// What it floats on: a mat, or bearings by the piece.
    #[schemars(with = "Option<PadKeys>")]
    pub mat: Option<Pad>,
}

impl Slab {
    /// The whole track of `rail`s and `pad`s on a `slab`.
    pub fn new(rail: Rail, pad: Pad, slab: Member) -> Self {
        Self { rails: None, rail, pad, slab, mat: None }
    }

    /// The stack rail – pads – slab (– mat – base).
    ///
    /// # Errors
    /// Pieces without a spacing, a section without the number of rails.
    pub fn stack(&self) -> Result<Stack, TrackError> {
        let rails = self.rails;
        let mut links = vec![self.pad.link(rails, None, 2.0)?];
        links.extend(self.mat.map(|mat| mat.link(rails, None, 1.0)).transpose()?);
        Ok(Stack::new(vec![self.rail.member(rails)?, self.slab], links))
    }
}
