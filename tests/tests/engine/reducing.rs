//! Tables reduced whole and in parts, for other tests.

use boundfit_estimation::{Columns, ReducedTable};
use boundfit_formats::{InputError, ScanOptions, Source};
use rand::RngExt;
use rand::seq::SliceRandom;
use rand_chacha::ChaCha8Rng;

/// The reduction of a text.
pub(crate) fn try_reduced(
    text: &str,
    columns: &Columns,
    options: &ScanOptions,
) -> Result<String, InputError> {
    reduced_source(Source::new("table", std::io::Cursor::new(text.as_bytes().to_vec())), columns, options)
}

/// The reduction of a file.
pub(crate) fn reduced_source(
    source: Source,
    columns: &Columns,
    options: &ScanOptions,
) -> Result<String, InputError> {
    let mut reduced = Vec::new();
    ReducedTable::scan(source, columns, options)?.write(&mut reduced).unwrap();
    Ok(String::from_utf8(reduced).unwrap())
}

/// The reduction of a text that has one.
pub(crate) fn reduced(text: &str, columns: &Columns, options: &ScanOptions) -> String {
    try_reduced(text, columns, options).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// The reductions of parts of a table with a header, rows and parts in any order, one after the other.
pub(crate) fn shuffled_parts(
    text: &str,
    columns: &Columns,
    options: &ScanOptions,
    rng: &mut ChaCha8Rng,
) -> String {
    let (header, rows) = text.split_once('\n').unwrap();
    let mut rows: Vec<&str> = rows.lines().collect();
    rows.shuffle(rng);
    let mut together = String::new();
    let mut rest = rows.as_slice();
    while !rest.is_empty() {
        let (part, others) = rest.split_at(rng.random_range(1..=rest.len()));
        let options = ScanOptions { chunk_bytes: rng.random_range(1..=100), ..options.clone() };
        together += &reduced(&format!("{header}\n{}\n", part.join("\n")), columns, &options);
        rest = others;
    }
    together
}
