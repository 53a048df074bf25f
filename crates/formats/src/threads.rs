//! The threads that files are read with: the only place that knows whose they are. Without the feature `parallel` there is the
//! calling thread alone, and no answer depends on it.

#[cfg(feature = "parallel")]
use rayon::prelude::*;

/// Returns the number of threads in the current pool.
#[cfg(feature = "parallel")]
pub(crate) fn count() -> usize {
    rayon::current_num_threads().max(1)
}

/// One thread: this one.
#[cfg(not(feature = "parallel"))]
pub(crate) fn count() -> usize {
    1
}

/// The results for all items in their order, made on the threads of the current pool; a single one on this thread.
pub fn map<I: Send, T: Send>(items: Vec<I>, make: impl Fn(I) -> T + Sync + Send) -> Vec<T> {
    #[cfg(feature = "parallel")]
    if items.len() > 1 {
        return items.into_par_iter().map(make).collect();
    }
    items.into_iter().map(make).collect()
}

/// Does some work on a thread of the pool and, at the same time, some on this one.
#[cfg(feature = "parallel")]
#[allow(clippy::expect_used, reason = "a scope ends when what was given to the pool is done")]
pub fn beside<A: Send, B>(there: impl FnOnce() -> A + Send, here: impl FnOnce() -> B) -> (A, B) {
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
