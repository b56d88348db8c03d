//! Finite elements of a track, at one frequency and in time, against `reference/track_fe_*.json`.

#[path = "../common/mod.rs"]
mod common;

mod energy;
mod length;
mod moving_load;
mod receptance;
mod setup;
mod transition;
mod vehicles;
mod wheel;
