//! The start of a table: byte order mark and delimiter.

use crate::error::InputErrorKind;
use crate::reduction::record::{REDUCTION_MARK, ReductionError};

const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

/// Looks for the first line that is not blank in a start that grows.
#[derive(Default)]
pub(crate) struct FirstLine {
    /// How many bytes of the start are known to come before it.
    before: usize,
}

impl FirstLine {
    /// Whether the line and its end are in the start, to which so many bytes were added since the last call.
    pub(crate) fn is_in(&mut self, start: &[u8], added: usize) -> bool {
        if self.before == 0 {
            self.before = start.len() - without_mark(start).len();
        }
        let rest = start.get(self.before..).unwrap_or_default().trim_ascii_start();
        self.before = start.len() - rest.len();
        let fresh = rest.len().min(added);
        rest.iter().rev().take(fresh).any(|&byte| byte == b'\n')
    }
}

/// The bytes without a byte order mark.
pub(crate) fn without_mark(start: &[u8]) -> &[u8] {
    start.strip_prefix(BYTE_ORDER_MARK).unwrap_or(start)
}

/// Refuses what is no table: text in two bytes per character, and reductions where nothing is known of them.
pub(crate) fn refuse_other(start: &[u8]) -> Result<(), InputErrorKind> {
    if [[0xff, 0xfe], [0xfe, 0xff]].iter().any(|mark| start.starts_with(mark)) {
        return Err(InputErrorKind::Utf16);
    }
    if start.starts_with(REDUCTION_MARK.as_bytes()) {
        return Err(ReductionError::NotHere.into());
    }
    Ok(())
}

/// The separator of the first line that is not blank: a semicolon or tab if there is one outside quotes, else a comma.
pub(crate) fn detect_delimiter(start: &[u8]) -> u8 {
    let line = start.trim_ascii_start().split(|&byte| byte == b'\n').next().unwrap_or_default();
    let mut quoted = false;
    let mut seen = [false; 2];
    for &byte in line {
        match byte {
            b'"' => quoted = !quoted,
            b';' if !quoted => seen[0] = true,
            b'\t' if !quoted => seen[1] = true,
            _ => {}
        }
    }
    match seen {
        [true, _] => b';',
        [_, true] => b'\t',
        _ => b',',
    }
}
