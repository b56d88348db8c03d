//! groundwave: moving trains on layered ground.
pub mod concern;
pub mod dataset;
pub mod figure;
pub mod foundation;
pub mod interaction;
pub mod math;
pub mod progress;
pub mod soil;
pub mod study;
pub mod track;
pub mod vehicle;
