//! A reader of delimited text that shares nothing with the one of the program but the numbers in cells and the words of
//! messages: all bytes at once, records by the `csv` crate, lines by counting.

use std::io::{self, Read};

use boundfit_exact::{DecimalMark, Notation, ParseNumberError, Rational, is_missing};
use boundfit_formats::{
    ColumnSelector, Header, InputError, InputErrorKind, Missing, Place, REDUCTION_MARK, ReductionError,
    RowRange, TableOptions,
};
use csv::{ByteRecord, ReaderBuilder};
use sha2::{Digest, Sha256};

/// What messages call the table.
pub const NAME: &str = "data.csv";

const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

/// What was found: the names, the number of rows, the hash, and the rows wanted with their numbers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Found {
    /// The names of the columns asked for.
    pub names: Vec<String>,
    /// How many data rows there are.
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

/// Whether bytes may be those of a binary table, which is refused in words of its own, or UTF-16.
pub fn may_be_binary(bytes: &[u8]) -> bool {
    let starts: [&[u8]; 7] =
        [b"\xff\xfe", b"\xfe\xff", b"PAR1", b"ARROW1", b"\xff\xff\xff\xff", b"\x89HDF", b"MATLAB"];
    let start = &bytes[..bytes.len().min(128)];
    starts.iter().any(|format| bytes.starts_with(format)) || start.contains(&0)
}

/// A table whose first lines are empty where they were blank; tabs that are known to separate cells are not.
fn without_blank_lines(text: &[u8], delimiter: Option<u8>) -> Vec<u8> {
    // The library passes over a byte order mark of its own.
    let (mark, text) =
        text.split_at(if text.starts_with(BYTE_ORDER_MARK) { BYTE_ORDER_MARK.len() } else { 0 });
    let is_blank = |byte: &u8| byte.is_ascii_whitespace() && !(*byte == b'\t' && delimiter == Some(b'\t'));
    let is_line_end = |byte: &u8| matches!(byte, b'\r' | b'\n');
    let filled = text.iter().position(|byte| !is_blank(byte)).unwrap_or(text.len());
    let start = match text[..filled].iter().rposition(is_line_end) {
        _ if filled == text.len() => filled,
        last => last.map_or(0, |last| last + 1),
    };
    let line_ends = text[..start].iter().copied().filter(is_line_end);
    let mark = if start == 0 { mark } else { &[] };
    mark.iter().copied().chain(line_ends).chain(text[start..].iter().copied()).collect()
}

struct Reader<'a> {
    columns: &'a [ColumnSelector],
    options: &'a TableOptions,
}

/// Fails when it is read.
struct Failing(Option<String>);

impl Read for Failing {
    fn read(&mut self, _: &mut [u8]) -> io::Result<usize> {
        self.0.take().map_or(Ok(0), |words| Err(io::Error::other(words)))
    }
}

impl Reader<'_> {
    fn read(&self, bytes: &[u8], failure: Option<&str>) -> Result<Found, InputError> {
        let sha256 = Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect();
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
        let text = &without_blank_lines(text, self.options.dialect.delimiter);
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
        let mut header = self.header(&record, records.line)?;
        let header_line = records.line;
        let header_text = String::from_utf8_lossy(record.get(0).unwrap_or_default()).into_owned();
        let mut more = Ok(true);
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
        let find = |column| find(column, &names, header.is_some(), shape[1], header_line);
        let is_undivided =
            shape[1] == 1 && self.options.dialect.delimiter.is_none() && detect(records.text).is_none();
        let first = header_text.clone();
        let undivided = |error: InputError| match error.kind {
            InputErrorKind::UnknownColumn { wanted, .. } if is_undivided => {
                InputError { kind: InputErrorKind::NoDelimiter { wanted, line: first.clone() }, ..error }
            }
            kind => InputError { kind, ..error },
        };
        let places = self.columns.iter().map(|column| find(column).map_err(&undivided));
        let places = places.collect::<Result<Vec<usize>, _>>()?;
        let looked_at = self.options.conditions.iter();
        let looked_at = looked_at.map(|condition| find(condition.column()).map_err(&undivided));
        let looked_at = looked_at.collect::<Result<Vec<usize>, _>>()?;
        let title = |place: &usize| match names.get(place - 1) {
            Some(name) if !name.is_empty() => name.clone(),
            _ => format!("col{place}"),
        };
        let titles = places.iter().map(title).collect();
        let found = Found { names: titles, rows_total: 0, sha256, rows: Vec::new(), others: Vec::new() };
        let columns = Columns { places, looked_at, names, has_header: header.is_some(), shape };
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
        let is_open = matches!(records.delimiter, b';' | b'\t' | b'|') && mark.is_none();
        if !is_open {
            mark = mark.or(Some(DecimalMark::Point));
        }
        // Rows of empty cells after which nothing came yet, and those of them that are wanted.
        let mut tail = (0, Vec::new());
        let mut more = more?;
        while more {
            let (line, [least, width]) = (records.line, columns.shape);
            let is_blank = |cell: &[u8]| cell.trim_ascii().is_empty();
            if record.len() < least || !record.iter().skip(width).all(is_blank) {
                let kind = InputErrorKind::RaggedRow { found: record.len(), expected: width };
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
                        let text = std::str::from_utf8(cell)
                            .map_err(|error| Some(wrong(not_utf8(cell, &error).into())))?;
                        match self.marked(text, &mut mark, is_open) {
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
                    match self.numbers(&record, columns, line, row, (&mut mark, is_open)) {
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

    /// The names in the first record, if it is a header.
    fn header(&self, record: &ByteRecord, line: u64) -> Result<Option<Vec<String>>, InputError> {
        let is_header = match self.options.header {
            Header::Present => true,
            Header::Absent => false,
            Header::Auto => {
                let conditions = self.options.conditions.iter().map(|condition| condition.column().number());
                let numbers = self.columns.iter().map(ColumnSelector::number);
                let cells = numbers.clone().flatten().filter_map(|number| record.get(number.checked_sub(1)?));
                let cells: Vec<&[u8]> = cells.collect();
                numbers.clone().chain(conditions).any(|number| number.is_none())
                    || (!cells.is_empty() && cells.into_iter().all(is_name))
            }
        };
        if !is_header {
            return Ok(None);
        }
        let name = |(index, cell): (usize, &[u8])| {
            let text = std::str::from_utf8(cell)
                .map_err(|error| wrong_cell(line, index + 1, None, cell, not_utf8(cell, &error)))?;
            Ok(text.trim().to_owned())
        };
        record.iter().enumerate().map(name).collect::<Result<_, _>>().map(Some)
    }

    /// The numbers of a row, or the place of the first one that is missing.
    fn numbers(
        &self,
        record: &ByteRecord,
        columns: &Columns,
        line: u64,
        row: usize,
        (mark, is_open): (&mut Option<DecimalMark>, bool),
    ) -> Result<Result<Vec<Rational>, InputError>, InputError> {
        let (mut numbers, mut lacks) = (Vec::new(), None);
        let cell_at = |place: usize| record.get(place - 1).unwrap_or_default();
        let texts = columns.places.iter().map(|&place| std::str::from_utf8(cell_at(place)));
        let is_text = |text: Result<&str, _>| match text {
            Ok(text) => {
                let marks = mark.map_or(DecimalMark::ALL.to_vec(), |mark| vec![mark]);
                !is_missing(text) && marks.into_iter().all(|mark| self.number(text, mark).is_err())
            }
            Err(_) => true,
        };
        let is_units = columns.has_header && row == 1;
        let is_units = is_units.then(|| texts.map(is_text).collect::<Vec<_>>());
        for (&place, column) in columns.places.iter().zip(self.columns) {
            let (cell, name) = (cell_at(place), columns.names.get(place - 1));
            let text = std::str::from_utf8(cell)
                .map_err(|error| wrong_cell(line, place, name, cell, not_utf8(cell, &error)))?;
            let wrong = |kind: CellError| wrong_cell(line, place, name, cell, kind);
            let read = self.marked(text, mark, is_open);
            match read {
                Ok(number) if column.is_non_negative() && number.is_negative() => {
                    return Err(wrong(InputErrorKind::NegativeErrorBound.into()));
                }
                Ok(number) => numbers.push(number),
                Err(error) if is_missing(text) => lacks = lacks.or(Some(wrong(error))),
                Err(CellError(InputErrorKind::NotANumber(_)))
                    if is_units.as_ref().is_some_and(|texts| texts.iter().all(|&is_text| is_text)) =>
                {
                    return Err(wrong(InputErrorKind::NoNumberInFirstRow.into()));
                }
                Err(error) => return Err(wrong(error)),
            }
        }
        Ok(lacks.map_or(Ok(numbers), Err))
    }

    /// The number of a text, under the decimal mark that is known, or that it tells.
    fn marked(
        &self,
        text: &str,
        mark: &mut Option<DecimalMark>,
        is_open: bool,
    ) -> Result<Rational, CellError> {
        match *mark {
            Some(own) => self.number(text, own).map_err(|error| {
                let is_other = is_open && self.number(text, own.other()).is_ok();
                let another = InputErrorKind::AnotherDecimalMark { before: own };
                if is_other { another.into() } else { CellError::from(error) }
            }),
            None => match DecimalMark::ALL.map(|mark| self.number(text, mark)) {
                [Ok(number), _] => {
                    *mark = text.contains('.').then_some(DecimalMark::Point);
                    Ok(number)
                }
                [_, Ok(number)] => {
                    *mark = Some(DecimalMark::Comma);
                    Ok(number)
                }
                [Err(error), _] => Err(error.into()),
            },
        }
    }

    fn number(&self, text: &str, decimal: DecimalMark) -> Result<Rational, ParseNumberError> {
        let notation = Notation { decimal, thousands: self.options.dialect.thousands };
        self.options.reading.read_written(text, notation, &self.options.limits)
    }
}

/// Where columns are.
struct Columns {
    places: Vec<usize>,
    looked_at: Vec<usize>,
    names: Vec<String>,
    has_header: bool,
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

/// Records that are not blank, with the lines on which they start.
struct Records<'a> {
    text: &'a [u8],
    reader: csv::Reader<io::Chain<&'a [u8], Failing>>,
    limit: usize,
    /// Up to here line ends are counted.
    counted: usize,
    line: u64,
    /// The line of the last record, if the text ends within its quotes.
    open_quotes: Option<u64>,
    delimiter: u8,
}

impl<'a> Records<'a> {
    fn new(text: &'a [u8], fails: bool, delimiter: u8, limit: usize) -> Self {
        let failing = Failing(fails.then(String::new));
        let mut builder = ReaderBuilder::new();
        let reader = builder.has_headers(false).flexible(true).delimiter(delimiter);
        Records {
            text,
            reader: reader.from_reader(text.chain(failing)),
            limit,
            counted: 0,
            line: 1,
            open_quotes: None,
            delimiter,
        }
    }

    fn next(&mut self, record: &mut ByteRecord) -> Result<bool, Option<InputError>> {
        loop {
            let from = self.reader.position().byte() as usize;
            let is_line_end = |byte: &&u8| matches!(byte, b'\r' | b'\n');
            // The library passes over a byte order mark.
            let from = if from == 0 && self.text.starts_with(BYTE_ORDER_MARK) { 3 } else { from };
            let start = from + self.text[from..].iter().take_while(is_line_end).count();
            self.line += line_ends(self.text, self.counted, start);
            self.counted = start;
            let read = self.reader.read_byte_record(record);
            let end = if read.is_ok() { self.reader.position().byte() as usize } else { self.text.len() };
            if end.saturating_sub(start) > self.limit {
                return Err(Some(wrong(Some(self.line), InputErrorKind::RowTooLong { limit: self.limit })));
            }
            let more = read.map_err(|_| None)?;
            // Behind the last record it is still that of the last record.
            if more {
                let is_open =
                    end == self.text.len() && ends_within_quotes(&self.text[start..], self.delimiter);
                self.open_quotes = is_open.then_some(self.line);
            }
            let is_blank = record.len() == 1 && record[0].trim_ascii().is_empty();
            if !(more && is_blank) {
                return Ok(more);
            }
        }
    }
}

/// Whether a record stops before its quotes do.
fn ends_within_quotes(record: &[u8], delimiter: u8) -> bool {
    let (mut is_inside, mut is_start) = (false, true);
    let mut bytes = record.iter().peekable();
    while let Some(&byte) = bytes.next() {
        if is_inside {
            is_inside = byte != b'"' || bytes.next_if(|&&next| next == b'"').is_some();
            is_start = false;
        } else {
            (is_inside, is_start) = (is_start && byte == b'"', byte == delimiter);
        }
    }
    is_inside
}

/// How many lines end in a range: a carriage return and a line feed right after it are one end.
fn line_ends(text: &[u8], start: usize, end: usize) -> u64 {
    let ends = |&at: &usize| match text[at] {
        b'\n' => at == 0 || text[at - 1] != b'\r',
        byte => byte == b'\r',
    };
    (start..end).filter(ends).count() as u64
}

/// A semicolon, tab, comma or bar, if there is one outside quotes in the first line that is not blank.
pub fn detect(text: &[u8]) -> Option<u8> {
    let line =
        text.trim_ascii_start().split(|&byte| matches!(byte, b'\r' | b'\n')).next().unwrap_or_default();
    let outside = line.split(|&byte| byte == b'"').step_by(2).collect::<Vec<_>>().concat();
    [b';', b'\t', b',', b'|'].into_iter().find(|delimiter| outside.contains(delimiter))
}

fn is_name(cell: &[u8]) -> bool {
    let text = String::from_utf8_lossy(cell).trim().to_lowercase();
    let missing = ["nan", "inf", "infinity", "na", "n/a", "null", "none"];
    text.starts_with(|first: char| first.is_alphabetic() || first == '_') && !missing.contains(&text.as_str())
}

/// The number of the column that is meant, from 1.
fn find(
    column: &ColumnSelector,
    names: &[String],
    has_header: bool,
    width: usize,
    line: u64,
) -> Result<usize, InputError> {
    let wanted = column.text().to_owned();
    let named: Vec<usize> = (1..=names.len()).filter(|&place| names[place - 1] == wanted).collect();
    match (named.as_slice(), column.number()) {
        ([place], _) => Ok(*place),
        ([], Some(number)) if (1..=width).contains(&number) => Ok(number),
        ([], _) => {
            let available = if has_header { names.to_vec() } else { Vec::new() };
            let kind = InputErrorKind::UnknownColumn { wanted, available, numbers: Some(width) };
            Err(wrong(Some(line), kind))
        }
        _ => Err(wrong(Some(line), InputErrorKind::AmbiguousColumn { wanted })),
    }
}

fn wrong(line: Option<u64>, kind: InputErrorKind) -> InputError {
    InputError { file: NAME.to_owned(), place: Box::new(Place { line, ..Place::default() }), kind }
}

fn wrong_cell(
    line: u64,
    place: usize,
    name: Option<&String>,
    cell: &[u8],
    kind: impl Into<CellError>,
) -> InputError {
    let place = Place {
        line: Some(line),
        column: Some((place, name.cloned())),
        text: Some(String::from_utf8_lossy(cell).into_owned()),
        ..Place::default()
    };
    InputError { file: NAME.to_owned(), place: Box::new(place), kind: kind.into().0 }
}

/// What can be wrong with a cell.
struct CellError(InputErrorKind);

impl From<InputErrorKind> for CellError {
    fn from(kind: InputErrorKind) -> Self {
        CellError(kind)
    }
}

/// What is wrong with a cell that is no text.
fn not_utf8(cell: &[u8], error: &std::str::Utf8Error) -> InputErrorKind {
    let position = String::from_utf8_lossy(&cell[..error.valid_up_to()]).chars().count();
    InputErrorKind::NotUtf8 { position, unit: "cell" }
}

impl From<ParseNumberError> for CellError {
    fn from(error: ParseNumberError) -> Self {
        CellError(InputErrorKind::NotANumber(error))
    }
}
