//! Solvers against reference numbers and against one another.

#[path = "../common/mod.rs"]
mod common;

mod beside;
mod contact_forces;
mod contour;
mod critical_speed;
mod depths;
mod free_field;
mod horizontal;
mod k_eq;
mod light_damping;
mod many_grounds;
mod passage;
mod periodic;
mod periodic_moving;
mod poles;
mod receptance;
mod sections;
mod sleepers_on_ground;
mod standing_field;
mod surface_compliance;
mod thin_layer;
mod underground;

/// So many draws, the same in every run.
fn drawn(cases: u32) -> proptest::prelude::ProptestConfig {
    proptest::prelude::ProptestConfig {
        cases,
        rng_seed: proptest::test_runner::RngSeed::Fixed(20_260_722),
        failure_persistence: None,
        ..Default::default()
    }
}
