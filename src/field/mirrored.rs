//! Fields that are even or odd across the track.

/// Positions that mirror each other need one answer.
pub(super) struct Mirrored {
    /// The different |position|, ascending.
    pub distances: Vec<f64>,
    /// Which of them each position has.
    pub places: Vec<usize>,
}

impl Mirrored {
    pub fn new(positions: &[f64]) -> Self {
        let mut distances: Vec<f64> = positions.iter().map(|p| p.abs()).collect();
        distances.sort_by(f64::total_cmp);
        // −20 + 41 × 0.5 is not 0.5 to the last digit
        let same = 1e-9 * distances.last().copied().unwrap_or(0.0);
        distances.dedup_by(|a, b| *a - *b <= same);
        let place = |p: &f64| distances.partition_point(|d| *d < p.abs() - 2.0 * same);
        let places = positions.iter().map(place).collect();
        Self { distances, places }
    }

    /// For each distance the number of the first position that has it.
    pub fn first(&self) -> Vec<usize> {
        let mut first = vec![usize::MAX; self.distances.len()];
        for (number, place) in self.places.iter().enumerate().rev() {
            first[*place] = number;
        }
        first
    }
}

#[cfg(test)]
mod tests {
    use super::Mirrored;

    #[test]
    fn mirrored_positions_are_one() {
        let positions: Vec<f64> = (0..9).map(|i| -0.6 + 0.2 * f64::from(i)).collect();
        let mirrored = Mirrored::new(&positions);
        assert_eq!(mirrored.distances.len(), 6);
        assert_eq!(mirrored.places, [3, 2, 1, 0, 1, 2, 3, 4, 5]);
        assert_eq!(mirrored.first(), [3, 2, 1, 0, 7, 8]);
        // none mirrored
        let mirrored = Mirrored::new(&[-0.3, 0.1, 0.5]);
        assert_eq!(mirrored.places, [1, 0, 2]);
        assert_eq!(mirrored.first(), [1, 0, 2]);
    }
}
