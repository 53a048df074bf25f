//! Files that are read: each is remembered, so that nothing is written over it.

use std::fs::File;
use std::io::{self, Read};

use boundfit_exact::Foreign;
use boundfit_formats::{InputError, Source};

use crate::exit::Failure;
use crate::output;

/// The file in the words of messages.
pub(crate) fn named(file: &str) -> &str {
    if file == "-" { "standard input" } else { file }
}

/// Opens a table or a model, or standard input for `-`.
#[allow(clippy::disallowed_methods, reason = "this is what is to be called in its place")]
pub(crate) fn open(file: &str) -> Result<Source, InputError> {
    output::is_read(file);
    Source::open(file)
}

/// The text of a file, or of standard input for `-`, that has at most as many bytes as this option allows.
pub(crate) fn read_text(file: &str, largest: u64, option: &str) -> Result<String, Failure> {
    let bytes = read_at_most(file, largest.saturating_add(1))?;
    let fail = |problem: String| Failure::data(format_args!("{}: {problem}", Foreign::of(named(file))));
    if bytes.len() as u64 > largest {
        return Err(fail(format!("larger than {largest} bytes (the limit; {option} raises it)")));
    }
    String::from_utf8(bytes).map_err(|_| fail("this is no text in UTF-8".to_owned()))
}

fn read_at_most(file: &str, most: u64) -> Result<Vec<u8>, Failure> {
    let unreadable =
        |error: io::Error| Failure::data(format_args!("{}: cannot read: {error}", Foreign::of(named(file))));
    output::is_read(file);
    let mut bytes = Vec::new();
    let read = if file == "-" {
        io::stdin().take(most).read_to_end(&mut bytes)
    } else {
        File::open(file).map_err(unreadable)?.take(most).read_to_end(&mut bytes)
    };
    read.map_err(unreadable)?;
    Ok(bytes)
}
