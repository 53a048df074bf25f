//! A clean stop on Ctrl-C and on a request to terminate.

use std::io::Write;

use crate::{output, progress};

/// The status that a shell reports for a program that Ctrl-C ended: 128 and the number of the signal.
const INTERRUPTED: i32 = 130;

/// Makes sure that an interrupted program leaves no unfinished file and no progress bar behind.
pub(crate) fn leave_nothing_behind() {
    // Where no handler can be set, the system's own way of stopping remains.
    let _ = ctrlc::set_handler(|| {
        progress::clear();
        let _ = writeln!(std::io::stderr(), "interrupted");
        output::end_without_unfinished(INTERRUPTED);
    });
}
