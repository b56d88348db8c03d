//! Solvers against reference numbers and against one another.

#[path = "../common/mod.rs"]
mod common;

mod contour;
mod critical_speed;
mod k_eq;
mod surface_compliance;
