//! Long work on a thread of its own, so that Ctrl-C ends the wait for it.

use std::panic::resume_unwind;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::Duration;

use boundfit::engine::formats::Progress;
use boundfit::files::ScanOptions;
use pyo3::prelude::*;

/// The time between two looks for a signal.
const PAUSE: Duration = Duration::from_millis(50);

/// The size of the stack, as Python's main thread has it on most systems.
const STACK_BYTES: usize = 8 << 20;

/// Tells a scan that nobody waits for its answer any more.
#[derive(Debug, Clone, Default)]
pub(crate) struct Stop(Arc<AtomicBool>);

impl Stop {
    /// Returns the same options for a scan that stops.
    pub(crate) fn in_options(&self, options: &ScanOptions) -> ScanOptions {
        ScanOptions { progress: Some(Arc::new(self.clone())), ..options.clone() }
    }
}

impl Progress for Stop {
    fn advanced(&self, _bytes: u64) {}

    fn is_cancelled(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

/// Works while the interpreter is free, and answers signals meanwhile. An exception of a signal handler ends the wait. A scan that got
/// the [`Stop`] ends soon after it; other work ends in the background, where nobody hears of it.
///
/// # Errors
/// The exception of a signal handler, such as `KeyboardInterrupt`, or that there is no further thread.
pub(crate) fn waiting<T: Send + 'static>(
    py: Python<'_>,
    work: impl FnOnce(&Stop) -> T + Send + 'static,
) -> PyResult<T> {
    let stop = Stop::default();
    let (working, ended) = channel::<()>();
    let own = stop.clone();
    let thread = thread::Builder::new().stack_size(STACK_BYTES).spawn(move || {
        // It is dropped, which ends the wait, even if the work panics.
        let _working = working;
        work(&own)
    })?;
    // A receiver belongs to one thread at a time.
    let mut ended = Mutex::new(ended);
    while py.detach(|| {
        ended.get_mut().is_ok_and(|ended| ended.recv_timeout(PAUSE) == Err(RecvTimeoutError::Timeout))
    }) {
        if let Err(raised) = py.check_signals() {
            stop.0.store(true, Ordering::Relaxed);
            return Err(raised);
        }
    }
    match py.detach(move || thread.join()) {
        Ok(answer) => Ok(answer),
        Err(panic) => resume_unwind(panic),
    }
}
