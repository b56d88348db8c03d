//! Where energy goes while a train passes: what is kept of it.

/// Account of one system [J]: what was done to it, what it holds more than at first, what it lost.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Account {
    /// Σ Δt v̄ᵀ(f + f⁺)/2, the work of forces on what they touch.
    pub work: f64,
    /// ½vᵀMv now.
    pub kinetic: f64,
    /// ½uᵀKu now.
    pub strain: f64,
    /// Σ Δt v̄ᵀCv̄
    pub dissipated: f64,
    /// ½vᵀMv + ½uᵀKu at first.
    pub(super) first: f64,
}

impl Account {
    /// work − kinetic − strain − dissipated, less what was there at first: zero to rounding for average acceleration.
    pub fn rest(&self) -> f64 {
        self.work - (self.kinetic + self.strain - self.first) - self.dissipated
    }
}

/// Accounts of track, vehicles and contact since it is kept.
///
/// Accuracy: track and vehicles each to rounding with average acceleration, whatever their damping; all together, with what lies in the
/// contacts and what drives the train, as Δt² (test `elements::energy`).
#[derive(Clone, Debug)]
pub struct Ledger {
    /// The track under the forces of wheels and hanging supports.
    pub track: Account,
    /// All vehicles under their weights and the forces of the rail.
    pub vehicles: Account,
    /// ∫ P dδ of all contacts, and of the elements held at their nodes under them, now [J].
    pub contact: f64,
    /// The same at first.
    pub(super) first: f64,
    /// Σ Δt v P(u_r′ + r′) [J]: less it is what drives the train up the slope it stands on.
    pub drive: f64,
}

impl Ledger {
    /// Everything together: Δ(track, vehicles, contact) + dissipation − work of the weights + drive; zero but for Δt².
    pub fn rest(&self, weights: f64) -> f64 {
        let stored = |a: &Account| a.kinetic + a.strain - a.first + a.dissipated;
        stored(&self.track) + stored(&self.vehicles) + self.contact - self.first - weights + self.drive
    }
}
