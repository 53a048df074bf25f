//! Files that are read: each is remembered, so that nothing is written over it.

use std::fs::File;
use std::io::{self, Read, Write};

use boundfit_estimation::MultipleOfLeast;
use boundfit_exact::{Foreign, Limit};
use boundfit_formats::{InputError, Source, TableNotes};
use boundfit_report::{bound_found, rows_left_out};

use crate::exit::{Failure, raises};
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

/// Says on standard error what a table was taken for where something was guessed, and how many rows were left out. The answer has no
/// place for it.
pub(crate) fn say_table(file: Foreign<&str>, table: Option<&TableNotes>, rows_missing: usize) {
    let guessed = table.filter(|table| table.has_guesses());
    say(file, guessed.and_then(TableNotes::words), rows_missing);
}

/// Says on standard error which bound on the errors was found from the readings. The answer has no place for it.
pub(crate) fn say_bound(file: Foreign<&str>, multiple: Option<&MultipleOfLeast>) {
    say_note(file, multiple.map(bound_found));
}

/// Says something about a file on standard error. The answer is the same, whether or not somebody reads it.
pub(crate) fn say_note(file: Foreign<&str>, note: Option<String>) {
    if let Some(note) = note {
        let _ = writeln!(io::stderr(), "note: {file}: {note}");
    }
}

/// Says so of a table beside the data, with everything that is unusual about it.
pub(crate) fn say_table_beside(file: Foreign<&str>, table: Option<&TableNotes>, rows_missing: usize) {
    say(file, table.and_then(TableNotes::words), rows_missing);
}

fn say(file: Foreign<&str>, table: Option<String>, rows_missing: usize) {
    let words: Vec<String> = table.into_iter().chain(rows_left_out(rows_missing)).collect();
    say_note(file, (!words.is_empty()).then(|| words.join(", ")));
}

/// The text of a file, or of standard input for `-`, that has at most as many bytes as this option allows.
pub(crate) fn read_text(file: &str, largest: u64) -> Result<String, Failure> {
    let bytes = read_at_most(file, largest.saturating_add(1))?;
    let fail = |problem: String| Failure::data(format_args!("{}: {problem}", Foreign::of(named(file))));
    if bytes.len() as u64 > largest {
        return Err(fail(format!("larger than {largest} bytes (the limit; {})", raises(Limit::Text))));
    }
    let text = String::from_utf8(bytes).ok().filter(|text| !text.contains('\0'));
    text.ok_or_else(|| fail("this is no text in UTF-8".to_owned()))
}

/// The number of bytes that tell whether a file is text.
const START: u64 = 1 << 16;

fn read_at_most(file: &str, most: u64) -> Result<Vec<u8>, Failure> {
    let unreadable =
        |error: io::Error| Failure::data(format_args!("{}: cannot read: {error}", Foreign::of(named(file))));
    output::is_read(file);
    let input: Box<dyn Read> =
        if file == "-" { Box::new(io::stdin()) } else { Box::new(File::open(file).map_err(unreadable)?) };
    let mut input = input.take(most);
    let mut bytes = Vec::new();
    input.by_ref().take(START).read_to_end(&mut bytes).map_err(unreadable)?;
    // A device, or a file in binary, of any size.
    if !bytes.contains(&0) {
        input.read_to_end(&mut bytes).map_err(unreadable)?;
    }
    Ok(bytes)
}
