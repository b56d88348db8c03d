//! What is heard of the ground beside the track.

use crate::soil::Motion;

/// One motion of one receiver.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Channel {
    /// Distance from the centre line of the track [m].
    pub y: f64,
    /// Direction.
    pub motion: Motion,
}

impl Channel {
    /// The `motions` of all `receivers` [m], one motion after the other.
    pub fn all(receivers: &[f64], motions: &[Motion]) -> Vec<Self> {
        motions.iter().flat_map(|&motion| receivers.iter().map(move |&y| Self { y, motion })).collect()
    }
}
