//! What moves in a vehicle, and how.

use std::fmt;

/// A body of a vehicle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Part {
    /// Wheels and what moves with them.
    Wheelset,
    /// A frame on two wheelsets, or half of one.
    Bogie,
    /// What passengers sit in, or half of it.
    Body,
}

/// How a body moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Motion {
    /// Displacement of its centre [m], positive down.
    Bounce,
    /// Rotation [rad], positive where it carries what lies behind the centre down.
    Pitch,
}

/// One degree of freedom of a vehicle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Freedom {
    /// Which body.
    pub part: Part,
    /// Which of its kind in one copy, from 1, the leading one first.
    pub number: usize,
    /// How it moves.
    pub motion: Motion,
}

impl fmt::Display for Part {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(match self {
            Self::Wheelset => "wheelset",
            Self::Bogie => "bogie",
            Self::Body => "body",
        })
    }
}

impl fmt::Display for Motion {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(match self {
            Self::Bounce => "bounce",
            Self::Pitch => "pitch",
        })
    }
}

/// "bogie 2, pitch"
impl fmt::Display for Freedom {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{} {}, {}", self.part, self.number, self.motion)
    }
}
