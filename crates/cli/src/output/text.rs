//! Text that is written while it is made.

use std::fmt;

use super::{Output, Stop};

/// The number of bytes that are written at once.
const PART: usize = 1 << 16;

/// Text on its way to an output.
pub(crate) struct Text<'a> {
    output: &'a mut Output,
    waiting: String,
    stop: Option<Stop>,
}

impl Text<'_> {
    fn flush(&mut self) -> fmt::Result {
        let written = self.output.write(self.waiting.as_bytes());
        self.waiting.clear();
        written.map_err(|stop| {
            self.stop = Some(stop);
            fmt::Error
        })
    }
}

impl fmt::Write for Text<'_> {
    fn write_str(&mut self, piece: &str) -> fmt::Result {
        if self.waiting.len() + piece.len() > PART {
            self.flush()?;
        }
        self.waiting.push_str(piece);
        Ok(())
    }
}

/// Writes what a function makes, in parts.
pub(crate) fn written(
    output: &mut Output,
    make: impl FnOnce(&mut Text<'_>) -> fmt::Result,
) -> Result<(), Stop> {
    let mut text = Text { output, waiting: String::with_capacity(PART), stop: None };
    // It fails where the output did, which has said why.
    let _ = make(&mut text).and_then(|()| text.flush());
    text.stop.map_or(Ok(()), Err)
}
