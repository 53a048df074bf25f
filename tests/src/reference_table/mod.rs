//! A reader of delimited text that shares with the program only the numbers in cells and the words of messages. It
//! takes all bytes at once, records by the `csv` crate, and lines by counting.

mod cells;
mod names;
mod records;
mod text;

use std::io;

use boundfit_exact::{DecimalMark, Rational, is_missing};
use boundfit_formats::{
    AskedBlock, ColumnSelector, InputError, InputErrorKind, Missing, REDUCTION_MARK, ReductionError,
    RowRange, TableOptions,
};
use csv::ByteRecord;
use sha2::{Digest, Sha256};

use cells::{CellError, not_utf8, wrong, wrong_cell};
use names::find;
use records::Records;
use text::without_blank_lines;
pub use text::{detect, in_utf8, may_be_binary, may_be_records};

/// The name of the table in messages.
pub const NAME: &str = "data.csv";

const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

/// The result: the names, the number of rows, the hash, and the selected rows with their numbers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Found {
    /// The names of the columns asked for.
    pub names: Vec<String>,
    /// The number of data rows.
    pub rows_total: usize,
    /// SHA-256 of the bytes, in hexadecimal.
    pub sha256: String,
    /// The rows wanted, with their numbers.
    pub rows: Vec<(usize, Vec<Rational>)>,
    /// The rows that are not wanted but kept.
    pub others: Vec<(usize, Vec<Rational>)>,
}

/// Reads a table of these bytes, after which reading fails in these words, or does not fail.
///
/// # Errors
/// The message about the first thing wrong.
pub fn read(
    bytes: &[u8],
    failure: Option<&str>,
    columns: &[ColumnSelector],
    options: &TableOptions,
) -> Result<Found, String> {
    let reader = Reader { columns, options };
    reader.read(bytes, failure).map_err(|error| error.to_string())
}

struct Reader<'a> {
    columns: &'a [ColumnSelector],
    options: &'a TableOptions,
}

impl Reader<'_> {
    fn read(&self, bytes: &[u8], failure: Option<&str>) -> Result<Found, InputError> {
        let sha256 = Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect();
        let bytes = &*in_utf8(bytes);
        let limit = self.options.sizes.line;
        // Nothing is read beyond the limit of a line.
        let mut line_start = 0;
        let too_long = bytes.split_inclusive(|&byte| byte == b'\n').find_map(|line| {
            let start = line_start;
            line_start += line.len();
            (line.len() > limit).then_some(start + limit)
        });
        let (bytes, failure) = match too_long {
            Some(end) => (&bytes[..end], Some(InputErrorKind::LineTooLong { limit })),
            None => (bytes, failure.map(|words| InputErrorKind::Io(io::Error::other(words.to_owned())))),
        };
        let text = bytes.strip_prefix(BYTE_ORDER_MARK).unwrap_or(bytes);
        let fails_on = 1 + bytes.iter().filter(|&&byte| byte == b'\n').count() as u64;
        // Before the first line is there, nothing is known that could be wrong with it.
        let failure = match failure {
            Some(kind) if !text.trim_ascii_start().contains(&b'\n') => {
                return Err(wrong(Some(fails_on), kind));
            }
            failure => failure,
        };
        if bytes.starts_with(REDUCTION_MARK.as_bytes()) {
            return Err(wrong(None, InputErrorKind::Reduction(ReductionError::NotHere)));
        }
        let mut start =
            text.trim_ascii_start().iter().take_while(|&&byte| byte != b'\n' && byte != b'\r').take(64);
        if self.options.dialect.skip_lines == 0 && start.any(|&byte| byte == 0) {
            let format = "a file of no kind that is known here, and no text";
            return Err(wrong(
                None,
                InputErrorKind::BinaryTable { format, instead: "save its table as CSV" },
            ));
        }
        let text = without_blank_lines(text, self.options.dialect.delimiter);
        let text = &self.without_preamble(text);
        let delimiter = self.options.dialect.delimiter.unwrap_or_else(|| detect(text).unwrap_or(b','));
        let mut records = Records::new(text, failure.is_some(), delimiter, limit);
        let found = self.table(&mut records, sha256).map_err(|error| match error {
            Some(InputError {
                kind:
                    InputErrorKind::RowTooLong { .. }
                    | InputErrorKind::Missing { .. }
                    | InputErrorKind::AllMissing { .. },
                ..
            }) => error,
            Some(error) if error.place.line.is_some() && error.place.line == records.open_quotes => {
                Some(wrong(error.place.line, InputErrorKind::OpenQuote))
            }
            error => error,
        });
        match (found, failure) {
            (Err(None), Some(kind)) => Err(wrong(Some(fails_on), kind)),
            (Err(None), None) => Err(wrong(None, InputErrorKind::Io(io::Error::other("not said why")))),
            (Err(Some(error)), _) => Err(error),
            (Ok(found), _) => Ok(found),
        }
    }

    /// The table of these records. `None` for an error says that reading failed.
    fn table(&self, records: &mut Records, sha256: String) -> Result<Found, Option<InputError>> {
        let mut record = ByteRecord::new();
        if !records.next(&mut record)? {
            return Err(Some(wrong(None, InputErrorKind::Empty)));
        }
        let sizes = &self.options.sizes;
        if record.len() > sizes.columns {
            let kind = InputErrorKind::TooManyColumns { limit: sizes.columns };
            return Err(Some(wrong(Some(records.line), kind)));
        }
        let is_blank = |cell: &[u8]| cell.trim_ascii().is_empty();
        let filled = record.iter().filter(|cell| !is_blank(cell)).count();
        let last_filled = record.iter().rposition(|cell| !is_blank(cell)).map_or(1, |last| last + 1);
        let mut shape = [if filled == 0 { 1 } else { last_filled }, record.len()];
        let below = self.below(records, record.len());
        let mut header = self.header(&record, records.line, &below)?;
        let prefers_names = header.is_some() && self.prefers_names(&record);
        let header_line = records.line;
        let header_text = String::from_utf8_lossy(record.get(0).unwrap_or_default()).into_owned();
        let mut more = Ok(true);
        let repeated = header.clone().unwrap_or_default();
        if let Some(names) = &mut header {
            more = records.next(&mut record);
            // A header of R names every column but that of the row names.
            if matches!(more, Ok(true))
                && record.len() == names.len() + 1
                && !record.iter().next_back().is_some_and(is_blank)
            {
                names.insert(0, String::new());
                shape = shape.map(|cells| cells + 1);
            }
        }
        let names = header.clone().unwrap_or_default();
        let find = |column| find(column, &names, [header.is_some(), prefers_names], shape[1], header_line);
        let is_undivided =
            shape[1] == 1 && self.options.dialect.delimiter.is_none() && detect(records.text).is_none();
        let first = header_text.clone();
        let undivided = |error: InputError| match error.kind {
            InputErrorKind::UnknownColumn { wanted, .. } if is_undivided => InputError {
                kind: InputErrorKind::NoDelimiter { wanted, line: first.clone().into() },
                ..error
            },
            kind => InputError { kind, ..error },
        };
        let places = self.columns.iter().map(|column| find(column).map_err(&undivided));
        let places = places.collect::<Result<Vec<usize>, _>>()?;
        self.refuse_same(&places, &names, header_line)?;
        let looked_at = self.options.conditions.iter();
        let looked_at = looked_at.map(|condition| find(condition.column()).map_err(&undivided));
        let looked_at = looked_at.collect::<Result<Vec<usize>, _>>()?;
        let title = |place: &usize| match names.get(place - 1) {
            Some(name) if !name.is_empty() => name.clone(),
            _ => format!("col{place}"),
        };
        let titles = places.iter().map(title).collect();
        let found = Found { names: titles, rows_total: 0, sha256, rows: Vec::new(), others: Vec::new() };
        let columns = Columns { places, looked_at, names, has_header: header.is_some(), repeated, shape };
        let mut lacking = Lacking::default();
        let read = self.rows(records, record, more, &columns, found, &mut lacking);
        let Lacking { rows, first, .. } = lacking;
        let is_complete = read.is_ok();
        let found = match (first, self.options.missing, read) {
            (Some(place), Missing::Refuse, _) => {
                return Err(Some(InputError {
                    kind: InputErrorKind::Missing { rows, is_complete },
                    ..place
                }));
            }
            (Some(place), Missing::Skip, Ok(found)) if found.rows.is_empty() => {
                return Err(Some(InputError { kind: InputErrorKind::AllMissing { rows }, ..place }));
            }
            (_, _, read) => read?,
        };
        let total = found.rows_total;
        let named = self.options.rows.named().iter().chain(self.options.rows.without());
        // The last row that a range names, or its first where it has no end.
        let last = |range: &RowRange| {
            let text = range.to_string();
            let (first, last) = text.split_once("..").unwrap_or((&text, &text));
            if last.is_empty() { first } else { last }.parse::<usize>().expect("a row")
        };
        let beyond = named.copied().find(|range| last(range) > total);
        let kind = match beyond {
            _ if total == 0 => InputErrorKind::NoRows,
            Some(rows) => InputErrorKind::RowsBeyondEnd { rows, total },
            None if found.rows.is_empty() => {
                let conditions = self.options.conditions.iter().map(|condition| condition.text().to_owned());
                InputErrorKind::NoRowWanted { total, conditions: conditions.collect() }
            }
            None => return Ok(found),
        };
        Err(Some(wrong(None, kind)))
    }

    /// The rows from this record on, if there is one.
    fn rows(
        &self,
        records: &mut Records,
        mut record: ByteRecord,
        more: Result<bool, Option<InputError>>,
        columns: &Columns,
        mut found: Found,
        lacking: &mut Lacking,
    ) -> Result<Found, Option<InputError>> {
        let mut mark = self.options.dialect.decimal;
        let is_open = matches!(records.delimiter, b',' | b';' | b'\t' | b'|') && mark.is_none();
        let tells = (is_open, records.delimiter == b',');
        if !is_open {
            mark = mark.or(Some(DecimalMark::Point));
        }
        // Rows of empty cells after which nothing came yet, and those of them that are wanted.
        let mut tail = (0, Vec::new());
        let mut more = more?;
        while more {
            if self.options.block == Some(AskedBlock::All) && self.is_header(&record, &columns.repeated) {
                more = records.next(&mut record)?;
                continue;
            }
            let (line, [least, width]) = (records.line, columns.shape);
            let is_blank = |cell: &[u8]| cell.trim_ascii().is_empty();
            let needed = columns.places.iter().chain(&columns.looked_at).max().copied().unwrap_or(1);
            let is_short = record.len() < least && record.len() >= needed;
            if !is_short && (record.len() < least || !record.iter().skip(width).all(is_blank)) {
                let (found, expected) = (record.len(), width);
                let is_half = |cell: &[u8]| {
                    let text = String::from_utf8_lossy(cell);
                    let text = text.trim_matches(|blank: char| blank.is_ascii_whitespace());
                    let digits = text.strip_prefix('-').unwrap_or(text);
                    !digits.is_empty() && digits.chars().all(|digit| digit.is_ascii_digit())
                };
                let is_split =
                    records.delimiter == b',' && found == 2 * expected && record.iter().all(is_half);
                let kind = match is_split {
                    true => InputErrorKind::CommasTwice { found, expected },
                    false => InputErrorKind::RaggedRow { found, expected },
                };
                return Err(Some(wrong(Some(line), kind)));
            }
            found.rows_total += 1;
            let mut is_wanted = self.options.rows.contains(found.rows_total);
            if record.iter().all(is_blank) {
                let kind = InputErrorKind::Null;
                let (place, name) = (columns.places[0], columns.names.get(columns.places[0] - 1));
                let cell = record.get(place - 1).unwrap_or_default();
                tail.0 += 1;
                tail.1.extend(is_wanted.then(|| wrong_cell(line, place, name, cell, kind)));
            } else {
                tail.1.drain(..).for_each(|place| lacking.add(place));
                tail.0 = 0;
                let row = found.rows_total;
                let mut is_lacking = false;
                if is_wanted {
                    let (mut holds, mut lacks) = (true, None);
                    for (condition, &place) in self.options.conditions.iter().zip(&columns.looked_at) {
                        let (cell, name) =
                            (record.get(place - 1).unwrap_or_default(), columns.names.get(place - 1));
                        let wrong = |kind: CellError| wrong_cell(line, place, name, cell, kind);
                        if records.torn.contains(&(place - 1)) {
                            return Err(Some(wrong(InputErrorKind::BehindQuotes.into())));
                        }
                        let text = std::str::from_utf8(cell)
                            .map_err(|error| Some(wrong(not_utf8(cell, &error).into())))?;
                        match self.marked(text, &mut mark, tells) {
                            Ok(number) => holds &= condition.holds(&number),
                            Err(error) if is_missing(text) => lacks = lacks.or(Some(wrong(error))),
                            Err(error) => return Err(Some(wrong(error))),
                        }
                    }
                    is_wanted = holds;
                    is_lacking = holds && lacks.is_some();
                    lacks.into_iter().filter(|_| holds).for_each(|place| lacking.add(place));
                }
                if !is_lacking && (is_wanted || self.options.keep_others) {
                    match self.numbers((&record, &records.torn), columns, line, row, (&mut mark, tells)) {
                        Ok(Ok(numbers)) if is_wanted => found.rows.push((row, numbers)),
                        Ok(Ok(numbers)) => found.others.push((row, numbers)),
                        Ok(Err(place)) if is_wanted => lacking.add(place),
                        Err(error)
                            if is_wanted
                                || matches!(error.kind, InputErrorKind::AnotherDecimalMark { .. }) =>
                        {
                            return Err(Some(error));
                        }
                        _ => {}
                    }
                }
            }
            more = records.next(&mut record)?;
        }
        found.rows_total -= tail.0;
        Ok(found)
    }
}

impl Reader<'_> {
    /// Returns whether a record has these names and no number for each of them.
    fn is_header(&self, record: &ByteRecord, names: &[String]) -> bool {
        let cells: Option<Vec<&str>> = record.iter().map(|cell| str::from_utf8(cell).ok()).collect();
        let is_number = |cell: &&str| DecimalMark::ALL.iter().any(|mark| self.number(cell, *mark).is_ok());
        cells.is_some_and(|cells| {
            !names.is_empty()
                && cells.iter().map(|cell| cell.trim()).eq(names.iter().map(String::as_str))
                && !cells.iter().all(is_number)
        })
    }
}

/// The places of columns.
struct Columns {
    places: Vec<usize>,
    looked_at: Vec<usize>,
    names: Vec<String>,
    has_header: bool,
    /// The cells of the header, as it stands in the file.
    repeated: Vec<String>,
    /// The least and the most cells of a row, but for empty ones.
    shape: [usize; 2],
}

/// Rows that lack a number.
#[derive(Default)]
struct Lacking {
    rows: usize,
    first: Option<InputError>,
}

impl Lacking {
    fn add(&mut self, place: InputError) {
        self.rows += 1;
        self.first.get_or_insert(place);
    }
}
