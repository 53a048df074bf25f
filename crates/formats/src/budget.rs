//! Bytes of memory that a command may hold, asked for before they are taken.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use crate::error::InputErrorKind;
use crate::memory_use::MemoryUse;

/// A budget of bytes of memory. Readers ask for memory before they take it and give it back when they drop
/// it. A caller that holds rows asks for their memory too, and gives it back when all rows are read
/// ([`HeldRows`](crate::HeldRows)). Clones share one budget, so that all that is read at a time has one
/// limit.
///
/// ```
/// use boundfit_formats::{ColumnSelector, MemoryBudget, SizeLimits, Source, TableOptions, read_table};
///
/// let sizes = SizeLimits { memory: MemoryBudget::new(1000), ..SizeLimits::default() };
/// let options = TableOptions { sizes, ..TableOptions::default() };
/// let columns = ["x", "y"].map(ColumnSelector::name_or_number);
/// let few = read_table(Source::new("few.csv", "x,y\n1,2\n".as_bytes()), &columns, &options)?;
/// assert_eq!((few.rows.len(), options.sizes.memory.held()), (1, 0));
///
/// let text = format!("x,y\n{}", "1,2\n".repeat(9));
/// let refused = read_table(Source::new("more.csv", std::io::Cursor::new(text)), &columns, &options).unwrap_err();
/// assert!(refused.to_string().ends_with("take 1.8 KiB of memory, more than 1000 bytes (the limit)"));
/// # Ok::<(), boundfit_formats::InputError>(())
/// ```
#[derive(Debug, Clone)]
pub struct MemoryBudget {
    limit: u64,
    held: Arc<AtomicU64>,
}

impl MemoryBudget {
    /// A budget of so many bytes, of which none are held.
    pub fn new(limit: u64) -> Self {
        MemoryBudget { limit, held: Arc::default() }
    }

    /// Returns the most bytes that may be held.
    pub fn limit(&self) -> u64 {
        self.limit
    }

    /// Returns the number of bytes that are held.
    pub fn held(&self) -> u64 {
        self.held.load(Ordering::Relaxed)
    }

    /// Memory of this budget of which nothing was taken yet.
    pub(crate) fn nothing(&self) -> HeldMemory {
        HeldMemory { budget: self.clone(), bytes: AtomicU64::new(0) }
    }
}

impl PartialEq for MemoryBudget {
    /// Returns whether as many bytes may be held.
    fn eq(&self, other: &Self) -> bool {
        self.limit == other.limit
    }
}

impl Eq for MemoryBudget {}

/// Memory of a budget, given back when this is dropped.
#[derive(Debug)]
pub(crate) struct HeldMemory {
    budget: MemoryBudget,
    bytes: AtomicU64,
}

impl HeldMemory {
    /// Asks for so many more bytes.
    ///
    /// # Errors
    /// [`InputErrorKind::TooMuchMemory`], and then they are not counted.
    pub(crate) fn ask(&self, bytes: u64, what: MemoryUse) -> Result<(), InputErrorKind> {
        let needed = self.add(bytes);
        let limit = self.budget.limit;
        if needed <= limit {
            return Ok(());
        }
        self.bytes.fetch_sub(bytes, Ordering::Relaxed);
        self.budget.held.fetch_sub(bytes, Ordering::Relaxed);
        Err(InputErrorKind::TooMuchMemory { what, needed, limit })
    }

    /// Asks for so many bytes in all, as long as it is not less than before.
    ///
    /// # Errors
    /// [`InputErrorKind::TooMuchMemory`].
    #[cfg_attr(
        not(any(feature = "packed", feature = "spreadsheets")),
        allow(dead_code, reason = "only what is unpacked grows in its place")
    )]
    pub(crate) fn ask_for_all(&self, bytes: u64, what: MemoryUse) -> Result<(), InputErrorKind> {
        match bytes.checked_sub(self.bytes.load(Ordering::Relaxed)) {
            None | Some(0) => Ok(()),
            Some(more) => self.ask(more, what),
        }
    }

    /// Counts so many more bytes, whether or not they may be held; gives how many are held of the budget.
    pub(crate) fn add(&self, bytes: u64) -> u64 {
        self.bytes.fetch_add(bytes, Ordering::Relaxed);
        self.budget.held.fetch_add(bytes, Ordering::Relaxed).saturating_add(bytes)
    }

    /// Gives all of it back.
    pub(crate) fn give_back(&self) {
        let bytes = self.bytes.swap(0, Ordering::Relaxed);
        self.budget.held.fetch_sub(bytes, Ordering::Relaxed);
    }

    /// The budget that it belongs to.
    pub(crate) fn budget(&self) -> &MemoryBudget {
        &self.budget
    }
}

impl Drop for HeldMemory {
    fn drop(&mut self) {
        self.give_back();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn memory_is_asked_for_and_given_back() {
        let budget = MemoryBudget::new(100);
        let (first, second) = (budget.nothing(), budget.nothing());
        assert!(first.ask(60, MemoryUse::Text).is_ok() && second.ask(40, MemoryUse::Cells).is_ok());
        let refused = second.ask(5, MemoryUse::Cells).unwrap_err();
        let message = "the cells of the sheet take 105 bytes of memory, more than 100 bytes (the limit)";
        assert_eq!((refused.to_string().as_str(), budget.held()), (message, 100));
        drop(first);
        assert!(
            second.ask_for_all(90, MemoryUse::Cells).is_ok()
                && second.ask_for_all(70, MemoryUse::Cells).is_ok()
        );
        assert_eq!(budget.held(), 90);
        second.give_back();
        assert_eq!(budget.held(), 0);
    }
}
