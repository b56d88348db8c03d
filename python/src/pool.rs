//! Work on threads of our own: without the lock of the interpreter, stopped by Ctrl-C, whole after `fork`.

use groundwave::progress::Observer;
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// Between two looks at signals.
const LOOK: Duration = Duration::from_millis(50);
/// How long work that was told to stop is waited for; it ends by itself at its next step.
const PATIENCE: Duration = Duration::from_millis(300);

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The threads of this process: those of a parent do not survive `fork`.
fn pool() -> PyResult<Arc<ThreadPool>> {
    static POOL: Mutex<Option<(u32, Arc<ThreadPool>)>> = Mutex::new(None);
    let mut kept = lock(&POOL);
    let own = std::process::id();
    if let Some((_, pool)) = kept.as_ref().filter(|(process, _)| *process == own) {
        return Ok(pool.clone());
    }
    let made = ThreadPoolBuilder::new().build();
    let pool =
        Arc::new(made.map_err(|e| PyRuntimeError::new_err(format!("no threads can be started: {e}")))?);
    // of a parent: to drop it would be to wait for threads that are not there
    std::mem::forget(kept.replace((own, pool.clone())));
    Ok(pool)
}

/// How far work has come, and whether it is to stop.
#[derive(Default)]
struct Watch {
    stop: AtomicBool,
    at: Mutex<(String, u64, u64)>,
}

impl Observer for Watch {
    fn begin(&self, what: &str, steps: u64) {
        *lock(&self.at) = (what.to_owned(), 0, steps);
    }
    fn advance(&self) {
        lock(&self.at).1 += 1;
    }
    fn cancelled(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }
}

/// What `work` finds, an error of it as `told`; `progress` is told of it as `(what, done, steps)`. KeyboardInterrupt, or an error of `progress`, ends it
/// within a second.
pub fn run<T: Send + 'static, E: Send + 'static>(
    py: Python<'_>,
    progress: Option<&Bound<'_, PyAny>>,
    told: impl FnOnce(Python<'_>, E) -> PyErr,
    work: impl FnOnce(&dyn Observer) -> Result<T, E> + Send + 'static,
) -> PyResult<T> {
    let pool = pool()?;
    let watch = Arc::new(Watch::default());
    let (send, receive) = channel();
    let receive = Mutex::new(receive);
    let watched = watch.clone();
    pool.spawn(move || {
        // nobody listens any more after an interrupt
        let _ = send.send(work(watched.as_ref()));
    });
    let mut last = (String::new(), 0, 0);
    let mut interrupted: Option<(PyErr, Instant)> = None;
    loop {
        match py.detach(|| lock(&receive).recv_timeout(LOOK)) {
            Ok(_) | Err(RecvTimeoutError::Disconnected) if interrupted.is_some() => break,
            Ok(answer) => return answer.map_err(|failed| told(py, failed)),
            Err(RecvTimeoutError::Disconnected) => {
                return Err(PyRuntimeError::new_err("the computation broke off: please report the case"));
            }
            Err(RecvTimeoutError::Timeout) => {}
        }
        match &interrupted {
            Some((_, since)) if since.elapsed() > PATIENCE => break,
            Some(_) => {}
            None => {
                let now = lock(&watch.at).clone();
                let tell = || match progress.filter(|_| now != last) {
                    Some(progress) => progress.call1((&now.0, now.1, now.2)).map(drop),
                    None => Ok(()),
                };
                if let Err(error) = py.check_signals().and_then(|()| tell()) {
                    watch.stop.store(true, Ordering::Relaxed);
                    interrupted = Some((error, Instant::now()));
                }
                last = now;
            }
        }
    }
    Err(interrupted.map_or_else(|| PyRuntimeError::new_err("cancelled"), |(error, _)| error))
}
