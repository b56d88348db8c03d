//! Progress as the library tells it; the command draws it.

/// Listens to long computations. Called from several threads.
pub trait Observer: Sync {
    /// A piece of work of `steps` equal steps begins.
    fn begin(&self, _what: &str, _steps: u64) {}
    /// One step is done.
    fn advance(&self) {}
    /// Whether long work is to stop at the next step: its study then ends with [`crate::study::StudyError::Cancelled`].
    fn cancelled(&self) -> bool {
        false
    }
    /// The piece of work is done.
    fn end(&self) {}
}

/// Listens to nothing.
pub struct Silent;

impl Observer for Silent {}
