//! Wheels and rails pressing on one another.

mod contact_forces;
mod wheel_rail;

pub use contact_forces::ContactForces;
pub use wheel_rail::{COUPLED, WheelRail};
