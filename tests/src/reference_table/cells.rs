//! The numbers in cells, and what is wrong with them.

use boundfit_exact::{DecimalMark, Foreign, Notation, ParseNumberError, Rational, is_missing};
use boundfit_formats::{InputError, InputErrorKind, Place};
use csv::ByteRecord;

use super::{Columns, NAME, Reader};

impl Reader<'_> {
    /// The numbers of a row, or the place of the first one that is missing.
    pub(super) fn numbers(
        &self,
        (record, torn): (&ByteRecord, &[usize]),
        columns: &Columns,
        line: u64,
        row: usize,
        (mark, tells): (&mut Option<DecimalMark>, (bool, bool)),
    ) -> Result<Result<Vec<Rational>, InputError>, InputError> {
        let (mut numbers, mut lacks) = (Vec::new(), None);
        let cell_at = |place: usize| record.get(place - 1).unwrap_or_default();
        let texts = columns.places.iter().map(|&place| std::str::from_utf8(cell_at(place)));
        let is_text = |text: Result<&str, _>| match text {
            Ok(text) => DecimalMark::ALL.into_iter().all(|mark| self.number(text, mark).is_err()),
            Err(_) => true,
        };
        let is_units = columns.has_header && row == 1;
        let is_units = is_units.then(|| texts.map(is_text).collect::<Vec<_>>());
        for (&place, column) in columns.places.iter().zip(self.columns) {
            let (cell, name) = (cell_at(place), columns.names.get(place - 1));
            let wrong = |kind: CellError| wrong_cell(line, place, name, cell, kind);
            if torn.contains(&(place - 1)) {
                return Err(wrong(InputErrorKind::BehindQuotes.into()));
            }
            let text = std::str::from_utf8(cell)
                .map_err(|error| wrong_cell(line, place, name, cell, not_utf8(cell, &error)))?;
            let read = self.marked(text, mark, tells);
            match read {
                Ok(number) if column.is_non_negative() && number.is_negative() => {
                    return Err(wrong(InputErrorKind::NegativeErrorBound.into()));
                }
                Ok(number) => numbers.push(number),
                Err(error) if is_missing(text) => lacks = lacks.or(Some(wrong(error))),
                Err(CellError(InputErrorKind::NotANumber(_)))
                    if is_units.as_ref().is_some_and(|texts| texts.iter().all(|&is_text| is_text))
                        && !columns.places.iter().all(|&place| begins_with_digits(cell_at(place))) =>
                {
                    return Err(wrong(InputErrorKind::NoNumberInFirstRow { behind_units: false }.into()));
                }
                Err(error) => return Err(wrong(error)),
            }
        }
        Ok(lacks.map_or(Ok(numbers), Err))
    }

    /// The number of a text, under the decimal mark that is known, or that it tells. Two things are told of the table: whether cells
    /// tell it, and whether a comma may group digits unless one before was a decimal mark.
    pub(super) fn marked(
        &self,
        text: &str,
        mark: &mut Option<DecimalMark>,
        (is_open, may_group): (bool, bool),
    ) -> Result<Rational, CellError> {
        match *mark {
            Some(own) => self.number(text, own).map_err(|error| {
                let is_other = is_open
                    && self.number(text, own.other()).is_ok()
                    && !(may_group && own == DecimalMark::Point && is_grouped(text));
                let another = InputErrorKind::AnotherDecimalMark { before: own };
                if is_other { another.into() } else { CellError::from(error) }
            }),
            None => match DecimalMark::ALL.map(|mark| self.number(text, mark)) {
                [Ok(number), _] => {
                    *mark = text.contains('.').then_some(DecimalMark::Point);
                    Ok(number)
                }
                [Err(_), Ok(number)] if !(may_group && is_grouped(text)) => {
                    *mark = Some(DecimalMark::Comma);
                    Ok(number)
                }
                [Err(error), _] => Err(error.into()),
            },
        }
    }

    pub(super) fn number(&self, text: &str, decimal: DecimalMark) -> Result<Rational, ParseNumberError> {
        let notation = Notation { decimal, thousands: self.options.dialect.thousands };
        self.options.reading.read_written(text, notation, &self.options.limits)
    }
}

/// Returns whether commas may stand between groups of three digits.
fn is_grouped(text: &str) -> bool {
    let text = boundfit_exact::trim_number(text);
    let text = text.strip_prefix(['+', '-', '\u{2212}']).unwrap_or(text);
    let whole = text.split(['.', 'e', 'E', 'd', 'D']).next().unwrap_or_default();
    let groups: Vec<&str> = whole.split(',').collect();
    !whole.starts_with('0')
        && (1..=3).contains(&groups[0].len())
        && groups[1..].iter().all(|group| group.len() == 3)
}

/// Returns what is wrong, and on which line.
pub(super) fn wrong(line: Option<u64>, kind: InputErrorKind) -> InputError {
    InputError { file: NAME.into(), place: Box::new(Place { line, ..Place::default() }), kind }
}

/// Returns what is wrong with a cell.
pub(super) fn wrong_cell(
    line: u64,
    place: usize,
    name: Option<&String>,
    cell: &[u8],
    kind: impl Into<CellError>,
) -> InputError {
    let place = Place {
        line: Some(line),
        column: Some((place, name.cloned().map(Foreign::from))),
        text: Some(String::from_utf8_lossy(cell).into_owned().into()),
        ..Place::default()
    };
    InputError { file: NAME.into(), place: Box::new(place), kind: kind.into().0 }
}

/// The mistake in a cell.
pub(super) struct CellError(pub(super) InputErrorKind);

impl From<InputErrorKind> for CellError {
    fn from(kind: InputErrorKind) -> Self {
        CellError(kind)
    }
}

/// Returns what is wrong with a cell that is no text.
pub(super) fn not_utf8(cell: &[u8], error: &std::str::Utf8Error) -> InputErrorKind {
    let position = String::from_utf8_lossy(&cell[..error.valid_up_to()]).chars().count();
    InputErrorKind::NotUtf8 { position, unit: "cell" }
}

impl From<ParseNumberError> for CellError {
    fn from(error: ParseNumberError) -> Self {
        CellError(InputErrorKind::NotANumber(error))
    }
}

/// Returns whether a cell begins as a number does.
fn begins_with_digits(cell: &[u8]) -> bool {
    let text = String::from_utf8_lossy(cell);
    text.trim().trim_start_matches(['+', '-', '.', ',']).starts_with(|first: char| first.is_ascii_digit())
}
