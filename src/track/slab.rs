//! Slab track: rails on pads on a slab that lies on the ground, per metre of whole track.

use super::{Link, Member, Stack};

/// A slab track. Source: appendix A.4 (corrected).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slab {
    /// Both rails.
    pub rail: Member,
    /// Pads of both rails.
    pub pad: Link,
    /// The slab.
    pub slab: Member,
}

impl Slab {
    /// The stack rail – pads – slab.
    pub fn stack(&self) -> Stack {
        Stack::new(vec![self.rail, self.slab], vec![self.pad])
    }
}
