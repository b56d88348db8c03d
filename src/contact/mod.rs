//! Wheels and rails pressing on one another.

mod account;
mod contact_forces;
mod equilibrium;
mod law;
mod ledger;
mod march;
mod vehicles;
mod wheel_rail;

pub use account::{Account, Ledger};
pub use contact_forces::ContactForces;
pub use law::Law;
pub use march::{March, MarchError, Rolling, Rough, Start};
pub use wheel_rail::{COUPLED, WheelRail};
