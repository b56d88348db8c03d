//! Progress as the library tells it; the command draws it.

/// Long work was told to stop.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("cancelled")]
pub struct Cancelled;

/// Listens to long computations. Called from several threads.
pub trait Observer: Sync {
    /// A piece of work of `steps` equal steps begins.
    fn begin(&self, _what: &str, _steps: u64) {}
    /// One step is done.
    fn advance(&self) {}
    /// Whether long work is to stop at the next step.
    fn cancelled(&self) -> bool {
        false
    }
    /// One step is done, and another may be begun.
    ///
    /// # Errors
    /// [`Cancelled`] where long work is to stop.
    fn done(&self) -> Result<(), Cancelled> {
        self.advance();
        if self.cancelled() { Err(Cancelled) } else { Ok(()) }
    }
    /// The piece of work is done.
    fn end(&self) {}
}

/// Listens to nothing.
pub struct Silent;

impl Observer for Silent {}
