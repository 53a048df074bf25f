//! Consumers of the batches of a scan.

use std::any::Any;

use super::batch::Batch;
use crate::fractions::Fractions;
use crate::selection::RowNumbers;

/// The result of the caller's work on a batch, of whatever type. The readers of all formats do not know it, so that a program has
/// each of them once.
type Result = Box<dyn Any + Send>;

/// Works on batches, on any thread.
#[derive(Clone, Copy)]
pub(crate) struct Worker<'a> {
    work: &'a (dyn Fn(Batch) -> Result + Sync),
    lists_rows: bool,
}

impl Worker<'_> {
    pub(crate) fn work(&self, mut batch: Batch) -> Made {
        let wanted = Wanted::of(&mut batch, self.lists_rows);
        Made { wanted, result: (self.work)(batch) }
    }
}

/// A batch after the work on it.
pub(crate) struct Made {
    wanted: Wanted,
    result: Result,
}

/// Works on batches and takes the results, in the order of the file.
pub(crate) struct Consumer<'a> {
    pub(crate) worker: Worker<'a>,
    take: &'a mut dyn FnMut(Result),
    wanted: Wanted,
}

impl<'a> Consumer<'a> {
    pub(crate) fn new(
        work: &'a (dyn Fn(Batch) -> Result + Sync),
        take: &'a mut dyn FnMut(Result),
        lists_rows: bool,
    ) -> Self {
        Consumer { worker: Worker { work, lists_rows }, take, wanted: Wanted::default() }
    }

    pub(crate) fn take(&mut self, made: Made) {
        self.wanted.append(made.wanted);
        (self.take)(made.result);
    }

    /// Works on a batch on this thread, and takes the result.
    pub(crate) fn consume(&mut self, batch: Batch) {
        self.take(self.worker.work(batch));
    }

    /// Returns the wanted rows of all batches.
    pub(crate) fn into_wanted(self) -> Wanted {
        self.wanted
    }
}

/// The wanted rows of a batch, or of all so far.
#[derive(Default)]
pub(crate) struct Wanted {
    pub(crate) count: usize,
    /// The numbers of the rows, if they are asked for.
    pub(crate) rows: RowNumbers,
    pub(crate) fractions: Vec<Fractions>,
}

impl Wanted {
    fn of(batch: &mut Batch, list: bool) -> Self {
        let rows = if list { batch.rows.clone() } else { RowNumbers::default() };
        Wanted { count: batch.rows.len(), rows, fractions: std::mem::take(&mut batch.fractions) }
    }

    fn append(&mut self, later: Wanted) {
        self.count += later.count;
        self.rows.append(&later.rows);
        self.fractions.resize(self.fractions.len().max(later.fractions.len()), Fractions::default());
        self.fractions.iter_mut().zip(later.fractions).for_each(|(own, later)| own.append(later));
    }
}
