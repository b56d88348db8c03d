//! A load that oscillates while it moves, and the line ω = ω̃ − βv on which it meets the waves.

/// e^{iω̃t} at constant speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drive {
    /// ω̃ [rad/s], seen by one who moves with it; 0 for a constant load.
    pub omega: f64,
    /// v [m/s]; 0 for a load that stands.
    pub speed: f64,
}

impl Drive {
    /// ω = ω̃ − βv [rad/s] at `beta` [rad/m].
    #[inline]
    pub fn at(self, beta: f64) -> f64 {
        self.omega - beta * self.speed
    }
}
