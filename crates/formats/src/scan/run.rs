//! A scan under way.

use super::batch::ScanOptions;
use super::consumer::Consumer;
use crate::error::{InputError, InputErrorKind};

/// A scan under way.
pub(super) struct Run<'a, 'b> {
    pub(super) file: &'a str,
    pub(super) options: &'a ScanOptions,
    pub(super) consumer: &'a mut Consumer<'b>,
}

impl Run<'_, '_> {
    pub(super) fn is_cancelled(&self) -> bool {
        self.options.progress.as_ref().is_some_and(|progress| progress.is_cancelled())
    }

    /// Tells that so many more bytes are done, and stops if that is asked for.
    pub(super) fn advance(&self, bytes: u64) -> Result<(), InputError> {
        if self.is_cancelled() {
            return Err(InputError::of_file(self.file, InputErrorKind::Interrupted));
        }
        if let Some(progress) = &self.options.progress {
            progress.advanced(bytes);
        }
        Ok(())
    }
}
