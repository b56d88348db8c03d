//! Progress of anything longer than a second: a bar on a terminal, plain lines into a log.

use groundwave::progress::Observer;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal;
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// Between two lines of a log.
const EVERY: Duration = Duration::from_secs(10);

/// Draws on stderr.
pub struct Bar {
    current: Mutex<Option<Running>>,
    terminal: bool,
}

struct Running {
    bar: ProgressBar,
    since: Instant,
    /// When the last line was written.
    told: Instant,
}

/// "critical speed: 40 of 100, about 12 s left"
fn line(what: &str, done: u64, steps: u64, elapsed: Duration) -> String {
    let left = elapsed.as_secs_f64() * steps.saturating_sub(done) as f64 / done.max(1) as f64;
    format!("{what}: {done} of {steps}, about {left:.0} s left")
}

impl Bar {
    pub fn new() -> Self {
        Self { current: Mutex::new(None), terminal: std::io::stderr().is_terminal() }
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
            let now = Instant::now();
            *current = Some(Running { bar, since: now, told: now });
        }
    }

    fn advance(&self) {
        if let Ok(mut current) = self.current.lock()
            && let Some(Running { bar, since, told }) = current.as_mut()
        {
            bar.inc(1);
            if self.terminal {
                if bar.is_hidden() && since.elapsed() > Duration::from_secs(1) {
                    bar.set_draw_target(ProgressDrawTarget::stderr());
                }
            } else if told.elapsed() >= EVERY {
                *told = Instant::now();
                let steps = bar.length().unwrap_or(0);
                eprintln!("{}", line(&bar.message(), bar.position(), steps, since.elapsed()));
            }
        }
    }

    fn end(&self) {
        if let Ok(mut current) = self.current.lock()
            && let Some(Running { bar, .. }) = current.take()
        {
            bar.finish_and_clear();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_says_how_long_it_takes() {
        assert_eq!(
            line("contours", 25, 100, Duration::from_secs(20)),
            "contours: 25 of 100, about 60 s left"
        );
        assert!(line("contours", 0, 4, Duration::from_secs(5)).ends_with("about 20 s left"));
    }
}
