//! groundwave: moving trains on layered ground.
pub mod concern;
pub mod dataset;
pub mod figure;
pub mod output;
