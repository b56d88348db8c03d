//! How the rail is carried along the track: without interruption, on equal supports, or by sections one after another.

use super::{Member, Stack};
use num_complex::Complex64;

/// What lies along the track.
#[derive(Clone, Debug, PartialEq)]
pub enum Layout {
    /// Everything is continuous: a stack per metre.
    Continuous(Stack),
    /// A rail on equal supports at x = nL.
    Discrete(Supports),
    /// Sections with supports, one after another.
    Varying(Vec<Section>),
}

/// A rail on equal supports at x = nL, n any integer.
#[derive(Clone, Debug, PartialEq)]
pub struct Supports {
    /// The rail.
    pub rail: Member,
    /// L [m]
    pub spacing: f64,
    /// What stands under the rail at each support, in N/m and kg, its first member the massless seat of the rail. What joins
    /// neighbouring supports is the tension [N/m] of a member.
    pub under: Stack,
}

/// Supports of one kind, over a length.
#[derive(Clone, Debug, PartialEq)]
pub struct Section {
    /// Bays; None for the first and the last section, which never end. Supports stand in the middle of their bays.
    pub bays: Option<usize>,
    /// The supports.
    pub supports: Supports,
}

impl Supports {
    /// Stiffness D [N/m] of one support under the rail on ground of stiffness `ground` [N/m] (infinite: rock) in a wave whose
    /// neighbouring bays have the phase βL, `c` = cos βL.
    ///
    /// Links between neighbours give k_w(2u_n − u_{n−1} − u_{n+1}) = 2k_w(1 − c)u_n.
    pub fn stiffness(&self, c: Complex64, omega: f64, ground: Complex64) -> Complex64 {
        1.0 / self.under.respond_at(2.0 * (1.0 - c), omega, ground).rail
    }

    /// Whether neighbouring supports are joined: D depends on c.
    pub fn joined(&self) -> bool {
        self.under.members().iter().any(Member::joins)
    }
}
