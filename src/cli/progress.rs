//! A progress bar for anything longer than a second.

use groundwave::progress::Observer;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// Draws on stderr; nothing if stderr is no terminal.
pub struct Bar {
    current: Mutex<Option<(ProgressBar, Instant)>>,
}

impl Bar {
    pub fn new() -> Self {
        Self { current: Mutex::new(None) }
    }
}

impl Observer for Bar {
    fn begin(&self, what: &str, steps: u64) {
        let bar = ProgressBar::with_draw_target(Some(steps), ProgressDrawTarget::hidden());
        if let Ok(style) = ProgressStyle::with_template("{msg:22} [{bar:40}] {pos}/{len} {eta}") {
            bar.set_style(style.progress_chars("=> "));
        }
        bar.set_message(what.to_owned());
        if let Ok(mut current) = self.current.lock() {
            *current = Some((bar, Instant::now()));
        }
    }

    fn advance(&self) {
        if let Ok(current) = self.current.lock()
            && let Some((bar, since)) = current.as_ref()
        {
            if bar.is_hidden() && since.elapsed() > Duration::from_secs(1) {
                bar.set_draw_target(ProgressDrawTarget::stderr());
            }
            bar.inc(1);
        }
    }

    fn end(&self) {
        if let Ok(mut current) = self.current.lock()
            && let Some((bar, _)) = current.take()
        {
            bar.finish_and_clear();
        }
    }
}
