//! Numerical ground floor: quadrature, Fourier transforms, special functions, decimals, small complex helpers.

pub mod banded;
pub mod bessel;
pub mod complex;
pub mod decimal;
pub mod error_function;
pub mod expression;
pub mod filon;
pub mod fourier;
pub(crate) mod gridding;
pub mod interpolation;
pub(crate) mod lanes;
pub mod many;
pub mod maximum;
pub mod normal;
pub mod oscillating;
pub mod polynomial;
pub mod quadrature;
pub mod rational;
pub mod root;
pub mod scaling;
