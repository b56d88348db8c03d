//! groundwave
pub mod case;
pub mod concern;
pub mod dataset;
pub mod figure;
pub mod foundation;
pub mod interaction;
pub mod math;
pub mod output;
pub mod progress;
pub mod soil;
pub mod study;
pub mod track;
pub mod vehicle;
