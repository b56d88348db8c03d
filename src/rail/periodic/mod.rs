//! A rail on equal supports: what repeats from bay to bay, by several methods that must agree.

mod cell;
mod dirac_comb;
mod floquet;
mod landmarks;
mod span;

pub use cell::{Cell, Ground, Support};
pub use dirac_comb::DiracComb;
pub use floquet::{Floquet, FreeWave, FreeWaves};
pub use landmarks::{Band, Landmark, Undamped, pinned_pinned};
