//! The threads that files are read with: the only place that knows whose they are. Without the feature `parallel` there is the
//! calling thread alone, and no answer depends on it.

#[cfg(feature = "parallel")]
use std::sync::Mutex;
#[cfg(feature = "parallel")]
use std::sync::atomic::{AtomicU32, Ordering};

#[cfg(feature = "parallel")]
use rayon::prelude::*;

/// Returns true in a process that another one forked after its first use of the pool. A fork copies no thread: work for the pool would
/// wait for ever, so that such a process has the calling thread alone.
#[cfg(feature = "parallel")]
fn is_forked() -> bool {
    // No process has this number.
    const NOBODY: u32 = 0;
    static OWNER: AtomicU32 = AtomicU32::new(NOBODY);
    let own = std::process::id();
    let owner = OWNER.compare_exchange(NOBODY, own, Ordering::Relaxed, Ordering::Relaxed);
    owner.is_err_and(|owner| owner != own)
}

/// Returns the number of threads in the current pool, and one where there is none.
#[cfg(feature = "parallel")]
pub(crate) fn count() -> usize {
    if is_forked() { 1 } else { rayon::current_num_threads().max(1) }
}

/// One thread: this one.
#[cfg(not(feature = "parallel"))]
pub(crate) fn count() -> usize {
    1
}

/// The results for all items in their order, made on the threads of the current pool; a single one on this thread.
#[allow(clippy::expect_used, reason = "each slot is visited once, and a panic in it ends the visit of all")]
pub fn map<I: Send, T: Send>(items: Vec<I>, make: impl Fn(I) -> T + Sync + Send) -> Vec<T> {
    #[cfg(feature = "parallel")]
    if items.len() > 1 && !is_forked() {
        let slots: Vec<Mutex<(Option<I>, Option<T>)>> =
            items.into_iter().map(|item| Mutex::new((Some(item), None))).collect();
        for_each(slots.len(), &|index| {
            if let Some(Ok(mut slot)) = slots.get(index).map(Mutex::lock) {
                slot.1 = slot.0.take().map(&make);
            }
        });
        let made = slots.into_iter().map(|slot| slot.into_inner().ok().and_then(|(_, made)| made));
        return made.map(|made| made.expect("all slots are visited")).collect();
    }
    items.into_iter().map(make).collect()
}

/// Visits the indices below a count on the threads of the current pool. The visit is a trait object, so that a build compiles rayon's
/// part once and not for each use of [`map`].
#[cfg(feature = "parallel")]
fn for_each(count: usize, visit: &(dyn Fn(usize) + Sync)) {
    (0..count).into_par_iter().for_each(visit);
}

/// Does some work on a thread of the pool and, at the same time, some on this one.
#[cfg(feature = "parallel")]
#[allow(clippy::expect_used, reason = "a scope ends when what was given to the pool is done")]
pub fn beside<A: Send, B>(there: impl FnOnce() -> A + Send, here: impl FnOnce() -> B) -> (A, B) {
    if is_forked() {
        return (there(), here());
    }
    let mut result = None;
    let made_here = rayon::in_place_scope(|scope| {
        let result = &mut result;
        scope.spawn(move |_| *result = Some(there()));
        here()
    });
    (result.expect("the scope has ended"), made_here)
}

/// Does some work, and then some other.
#[cfg(not(feature = "parallel"))]
pub fn beside<A: Send, B>(there: impl FnOnce() -> A + Send, here: impl FnOnce() -> B) -> (A, B) {
    (there(), here())
}
