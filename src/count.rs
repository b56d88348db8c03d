//! How often what costs most is done, counted with the cargo feature `count`; without it nothing is compiled.
//!
//! Counts grow when an integral asks more often than it has to, whatever the machine does besides. `tests/counts` holds them against
//! the numbers of `counts.json`.

#[cfg(feature = "count")]
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

/// What is counted.
#[derive(Clone, Copy, Debug)]
pub enum Work {
    /// Compliances of the ground's surface, G(k, ω), at one k.
    Compliances,
    /// Equivalent stiffnesses k(β, ω) of layered ground.
    Stiffnesses,
    /// Waves e^{iβx} of a response times positions x at which they are summed.
    NodePositions,
    /// Rayleigh and Love functions.
    Secular,
    /// Counts of modes at one k.
    ModeCounts,
}

/// All of [`Work`], with the names they have in `counts.json`.
#[cfg(feature = "count")]
const NAMES: [&str; 5] = ["compliances", "stiffnesses", "node_positions", "secular", "mode_counts"];

#[cfg(feature = "count")]
static DONE: [AtomicU64; NAMES.len()] = [const { AtomicU64::new(0) }; NAMES.len()];

/// Adds `times` to the count of `work`; nothing without the feature.
#[inline(always)]
#[cfg_attr(not(feature = "count"), allow(unused_variables))]
pub fn add(work: Work, times: usize) {
    #[cfg(feature = "count")]
    DONE[work as usize].fetch_add(times as u64, Relaxed);
}

/// What has been done since the last time this was asked, by name.
#[cfg(feature = "count")]
pub fn take() -> [(&'static str, u64); NAMES.len()] {
    std::array::from_fn(|i| (NAMES[i], DONE[i].swap(0, Relaxed)))
}
