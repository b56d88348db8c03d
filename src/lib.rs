#![doc = include_str!("../README.md")]
//!
//! ---
//!
//! # Map of the crate
//!
//! A module uses only modules of lower rank.
//!
//! | rank | module | what |
//! |---|---|---|
//! | 0 | [`math`] | quadrature, Fourier transforms with their signs and scales, interpolation, maxima |
//! | 0 | [`columns`] | two columns of lengths from a CSV file, in the units of its header |
//! | 0 | [`memory`] | how much is free |
//! | 0 | [`quantity`] | numbers that must lie in their range, by their keys in case files |
//! | 0 | [`concern`], [`dataset`], [`figure`], [`progress`] | what studies hand on: doubts, arrays, pictures, progress |
//! | 1 | [`soil`] | material → profile → compliance G(k, ω); the integral over a loaded strip; surface waves |
//! | 1 | [`track`] | members (beams, masses) and links (springs, bars) in a vertical stack |
//! | 1 | [`signal`] | histories, their energy spectrum, filters |
//! | 1 | [`vehicle`] | axle loads, bodies on springs, wheel–rail contact |
//! | 1 | [`irregularity`] | published spectra of the rail's profile, profiles as sums of sinusoids |
//! | 1 | [`sampling`] | distributions, how numbers vary together, Monte Carlo, Latin hypercubes, grids |
//! | 2 | [`foundation`] | what a track stands on: k(β, ω), of springs or of layered ground |
//! | 2 | [`assessment`] | third octaves, levels, KB, weighted acceleration and dose, guide values |
//! | 2 | [`output`] | HDF5, CSV, JSON, pictures, report |
//! | 3 | [`rail`] | how the rail of a track on its foundation answers loads that stand or move |
//! | 4 | [`field`], [`contact`] | the ground beside the track; wheels and rails pressing on one another |
//! | 5 | [`railway`] | ground or springs, track, train |
//! | 5 | [`study`] | one folder per question: critical speed, dispersion, track response, contour, receptance, free field, tables |
//! | 6 | [`case`](mod@case) | case files, their checks, the library of parameter sets, the runner |
//! | 7 | [`ensemble`] | samples of an uncertain case, run in chunks, gathered |
//!
//! # Symbols
//!
//! | in the code | symbol | meaning | unit |
//! |---|---|---|---|
//! | `x`, `y`, `z` | x, y, z | along the track, across it, down; in results `x` is x′ = x − vt | m |
//! | `beta` | β | wavenumber along the track | rad/m |
//! | `k` (in `soil`) | k | radial wavenumber √(β_x² + β_y²) | rad/m |
//! | `k_eq`, `stiffness` | k_eq | stiffness of the ground or a foundation per metre of track | N/m² |
//! | `omega`, `frequency` | ω, f | angular frequency, frequency | rad/s, Hz |
//! | `speed` | v | of the train; ω = −βv | m/s |
//! | `u_zz`, `u_xx`, `u_xz`, `u_yy` | G | displacement per unit traction wave | m/Pa |
//! | `c_s`, `c_p` | c_s, c_p | shear and pressure wave speed | m/s |
//! | `young`, `poisson`, `density` | E, ν, ρ | of a material | Pa, 1, kg/m³ |
//! | `shear_modulus` | μ | shear modulus | Pa |
//! | `loss_factor` | η | hysteretic damping, M(1 + iη sgn ω) | 1 |
//! | `damping_ratio` | ξ | η/2 | 1 |
//! | `damping` | c | viscous damping, k + iωc | N s/m² |
//! | `bending_stiffness` | EI | of a beam | N m² |
//! | `shear`, `tension` | G, T | of a shear layer, a membrane: G β² | N |
//! | `half_width` | b | half the contact width | m |
//! | `alpha` | α | share of the contact width that carries the ballast | 1 |
//! | `wave_speed` | C_b | of compression waves in the ballast | m/s |
//! | `load` | P | axle load, positive down | N |

// Units stand in brackets all over the documentation: [m] and [N] are no links.
#![allow(rustdoc::broken_intra_doc_links)]

pub mod assessment;
pub mod case;
pub mod columns;
pub mod concern;
pub mod contact;
pub mod count;
pub mod dataset;
#[cfg(all(feature = "files", feature = "pictures"))]
pub mod ensemble;
pub mod field;
pub mod figure;
pub mod foundation;
pub mod irregularity;
pub mod math;
pub mod memory;
pub mod output;
pub mod progress;
pub mod quantity;
pub mod rail;
pub mod railway;
pub mod sampling;
pub mod signal;
pub mod soil;
pub mod study;
pub mod track;
pub mod vehicle;

pub use case::Case;
pub use concern::Concern;
pub use foundation::{Foundation, FoundationModel, LayeredSoil, Springs};
pub use irregularity::{Realisation, Spectrum};
pub use progress::{Observer, Silent};
pub use rail::TrackOnFoundation;
pub use railway::{Ground, Railway};
pub use soil::{
    Base, Compatibility, DirectStiffness, Elastic, GroundSolver, Layer, Material, Profile, Solver, Strip,
};
pub use study::{Outcome, Study};
pub use track::{Ballast, Ballasted, Link, Member, Slab, Sleeper, Stack, Track};
pub use vehicle::{Axle, Train};
