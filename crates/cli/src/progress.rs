//! Progress on standard error: only on a terminal, and only of what takes longer than a second.

use std::io::IsTerminal as _;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::sync::{Arc, Mutex, OnceLock};
use std::thread;
use std::time::{Duration, Instant};

use boundfit_formats::Progress;
use indicatif::{ProgressBar, ProgressStyle};

/// The time below which work shows no progress.
const PATIENCE: Duration = Duration::from_secs(1);

/// The bar on the terminal, if there is one.
static SHOWN: Mutex<Option<ProgressBar>> = Mutex::new(None);

/// Takes the bar off the terminal.
pub(crate) fn clear() {
    if let Some(bar) = SHOWN.lock().ok().and_then(|mut shown| shown.take()) {
        bar.finish_and_clear();
    }
}

/// Remembers the bar that is about to appear.
fn showing(bar: ProgressBar) -> ProgressBar {
    if let Ok(mut shown) = SHOWN.lock() {
        *shown = Some(bar.clone());
    }
    bar
}

/// The progress of reading a file.
pub(crate) struct ReadingProgress {
    started: Instant,
    bytes: AtomicU64,
    total: Option<u64>,
    bar: OnceLock<ProgressBar>,
}

impl ReadingProgress {
    /// Progress through so many bytes, where that is known.
    pub(crate) fn new(total: Option<u64>) -> Arc<Self> {
        Arc::new(ReadingProgress {
            started: Instant::now(),
            bytes: AtomicU64::new(0),
            total,
            bar: OnceLock::new(),
        })
    }

    fn bar(&self) -> &ProgressBar {
        self.bar.get_or_init(|| {
            showing(match self.total {
                Some(total) => {
                    // The bar itself shows nothing unless standard error is a terminal.
                    let template = "reading {bar:30} {bytes} of {total_bytes}";
                    ProgressBar::new(total).with_style(style(template))
                }
                None => ProgressBar::no_length().with_style(style("reading {spinner} {bytes}")),
            })
        })
    }
}

impl Progress for ReadingProgress {
    fn advanced(&self, bytes: u64) {
        let sum = self.bytes.fetch_add(bytes, Ordering::Relaxed) + bytes;
        if self.started.elapsed() >= PATIENCE {
            // A file that is read once more starts again.
            let position = |total: u64| (sum.max(1) - 1) % total.max(1) + 1;
            self.bar().set_position(self.total.map_or(sum, position));
        }
    }
}

impl Drop for ReadingProgress {
    fn drop(&mut self) {
        if self.bar.get().is_some() {
            clear();
        }
    }
}

/// Does some work, with a sign of life and its name once it takes long.
pub(crate) fn while_working<T>(name: &'static str, work: impl FnOnce() -> T) -> T {
    /// The time between turns of a spinner.
    const TURN: Duration = Duration::from_millis(100);
    // A thread costs as much as a fit of some dozen readings.
    if !std::io::stderr().is_terminal() {
        return work();
    }
    let (done, is_done) = mpsc::channel::<()>();
    thread::scope(|scope| {
        scope.spawn(move || {
            if is_done.recv_timeout(PATIENCE) == Err(RecvTimeoutError::Timeout) {
                let bar = ProgressBar::new_spinner().with_style(style("{msg} {spinner}")).with_message(name);
                showing(bar).enable_steady_tick(TURN);
                // Until the work is done.
                let _ = is_done.recv();
                clear();
            }
        });
        let result = work();
        drop(done);
        result
    })
}

/// The templates are constants; a plain bar takes the place of one that is wrong.
fn style(template: &str) -> ProgressStyle {
    ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar())
}
