//! Closed forms: half-spaces, layers on rock, moving point loads, beams on springs.

#[path = "../common/mod.rs"]
mod common;

mod beam;
mod column;
mod continuous;
mod decay_rates;
mod defects;
mod dispersion;
mod ground_at_depth;
mod half_space;
mod line_speed;
mod moving_point;
mod periodic;
mod periodic_bands;
mod periodic_moving;
mod quadrature;
mod rayleigh;
mod springs;
mod strip;
mod transition;
mod vehicles;
