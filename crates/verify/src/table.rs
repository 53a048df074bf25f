//! Reading the data (section 2), without the program's own reader.

use std::mem;

use boundfit_exact::{Limits, ParseNumberErrorKind, Rational, Reading, trim_number};

use crate::falsehood::Falsehood;

/// The rows of delimited text that are not blank, as cells.
pub(crate) struct Table<'a> {
    rest: &'a [u8],
    delimiter: char,
}

impl<'a> Table<'a> {
    pub(crate) fn new(data: &'a [u8], delimiter: char) -> Self {
        const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";
        // One of the file, and one more that a program which does not know it may have put before it.
        let data = data.strip_prefix(BYTE_ORDER_MARK).unwrap_or(data);
        Table { rest: data.strip_prefix(BYTE_ORDER_MARK).unwrap_or(data), delimiter }
    }

    fn take_byte(&mut self) -> Option<u8> {
        let (&byte, rest) = self.rest.split_first()?;
        self.rest = rest;
        Some(byte)
    }

    /// Steps over a quote if one comes next.
    fn take_quote(&mut self) -> bool {
        let after = self.rest.strip_prefix(b"\"");
        self.rest = after.unwrap_or(self.rest);
        after.is_some()
    }

    /// The next row, blank or not. CRLF ends a row and makes a blank one.
    fn take_row(&mut self) -> Option<Vec<Vec<u8>>> {
        if self.rest.is_empty() {
            return None;
        }
        let (mut cells, mut cell) = (Vec::new(), Vec::new());
        let mut in_quotes = self.take_quote();
        while let Some(byte) = self.take_byte() {
            if in_quotes {
                // A quote ends them, unless it is doubled.
                if byte == b'"' && !self.take_quote() {
                    in_quotes = false;
                } else {
                    cell.push(byte);
                }
            } else if char::from(byte) == self.delimiter {
                cells.push(mem::take(&mut cell));
                in_quotes = self.take_quote();
            } else if byte == b'\r' || byte == b'\n' {
                break;
            } else {
                cell.push(byte);
            }
        }
        cells.push(cell);
        Some(cells)
    }
}

impl Iterator for Table<'_> {
    type Item = Vec<Vec<u8>>;

    fn next(&mut self) -> Option<Self::Item> {
        loop {
            let cells = self.take_row()?;
            let is_blank = matches!(cells.as_slice(), [only] if only.trim_ascii().is_empty());
            if !is_blank {
                return Some(cells);
            }
        }
    }
}

/// The number in a cell of a row; both are counted from 1. Column 0 holds 1.
pub(crate) fn number_at(
    row: usize,
    column: usize,
    cells: &[Vec<u8>],
    reading: Reading,
    limits: &Limits,
) -> Result<Rational, Falsehood> {
    let Some(index) = column.checked_sub(1) else { return Ok(Rational::one()) };
    let cell = cells.get(index).ok_or(Falsehood::MissingCell { row, column })?;
    reading.read(&String::from_utf8_lossy(cell), limits).map_err(|error| match error.kind {
        ParseNumberErrorKind::TooManyDigits(_) | ParseNumberErrorKind::ExponentTooLarge(_) => {
            Falsehood::BeyondLimit { row, column, error }
        }
        _ => Falsehood::NotANumber { row, column, error },
    })
}

/// The number in a cell of a row, if it holds one and not nothing or a word for that.
pub(crate) fn side_at(
    row: usize,
    column: usize,
    cells: &[Vec<u8>],
    reading: Reading,
    limits: &Limits,
) -> Result<Option<Rational>, Falsehood> {
    const WORDS: [&str; 10] = ["NA", "N/A", "#N/A", "NaN", "null", "none", "-", "--", ".", "?"];
    let text =
        column.checked_sub(1).and_then(|index| cells.get(index)).map(|cell| String::from_utf8_lossy(cell));
    let text = text.as_deref().unwrap_or("0").trim();
    if text.is_empty() || WORDS.iter().any(|word| word.eq_ignore_ascii_case(text)) {
        return Ok(None);
    }
    number_at(row, column, cells, reading, limits).map(Some)
}

/// Half a unit of the last digit written of the decimal in a cell of a row.
pub(crate) fn half_unit_at(
    row: usize,
    column: usize,
    cells: &[Vec<u8>],
    limits: &Limits,
) -> Result<Rational, Falsehood> {
    // That it is a number within the limits.
    number_at(row, column, cells, Reading::Decimal, limits)?;
    let cell = column.checked_sub(1).and_then(|index| cells.get(index));
    let text =
        String::from_utf8_lossy(cell.ok_or(Falsehood::NoLastDigit { row, column })?).replace('\u{2212}', "-");
    if text.contains('/') {
        return Err(Falsehood::NoLastDigit { row, column });
    }
    let (mantissa, exponent) =
        trim_number(&text).split_once(['e', 'E', 'd', 'D']).unwrap_or((trim_number(&text), "0"));
    let places = mantissa.rsplit_once('.').map_or(0, |(_, places)| places.len());
    let places = i64::try_from(places).unwrap_or(i64::MAX);
    let exponent: i64 = exponent.parse().map_err(|_| Falsehood::NoLastDigit { row, column })?;
    Ok(Rational::scientific(5, exponent - places - 1))
}
