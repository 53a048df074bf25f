//! Decides if the first record of a table names its columns, and finds the columns that are asked for.

use boundfit_exact::english::split_unit;
use boundfit_exact::{Foreign, is_missing};

use crate::columns::{ColumnPlace, ColumnSelector, Header, decode};
use crate::dialect::MissingWords;
use crate::error::{InputError, InputErrorKind};

/// The information in the first record about the columns of a table.
pub(crate) struct Heading {
    /// Cells in every row.
    pub(crate) width: usize,
    /// The names, when the first record is a header.
    pub(crate) names: Option<Vec<Foreign>>,
    /// `true` if it could be a header as well as a reading.
    pub(crate) is_open: bool,
    /// `true` if numbers that are asked for are names where they can be.
    prefers_names: bool,
    /// The line of the record, or of the comment.
    pub(crate) line: u64,
}

/// The question about a table that tells whether its first record is a header.
#[derive(Clone, Copy)]
pub(crate) struct AskedColumns<'a> {
    /// The columns whose numbers are wanted.
    pub(crate) columns: &'a [ColumnSelector],
    /// The columns that are wanted for another purpose.
    pub(crate) others: &'a [&'a ColumnSelector],
    /// Further words for missing values, which name no column.
    pub(crate) missing_as: &'a MissingWords,
}

/// The look of a cell of the first record, by its own text and by the cells below it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct CellLook {
    /// `true` if a number stands below it.
    pub(crate) is_above_number: bool,
    /// `true` if a reading may have it: it is a number, or says that the number is missing.
    pub(crate) may_be_read: bool,
}

impl<'a> AskedColumns<'a> {
    fn all(self) -> impl Iterator<Item = &'a ColumnSelector> {
        self.columns.iter().chain(self.others.iter().copied())
    }

    /// Returns whether the question alone tells that a record with these cells is a header: names are asked for, or stand in the cells that
    /// numbers are wanted from.
    pub(crate) fn tell(self, cells: &[&[u8]]) -> bool {
        let asked = self.numbers_of(cells);
        self.all().any(ColumnSelector::is_name)
            || (!asked.is_empty() && asked.iter().all(|cell| self.is_name(cell)))
    }

    /// Returns those of the cells that numbers are wanted from.
    fn numbers_of<T: Copy>(self, cells: &[T]) -> Vec<T> {
        let place = |column: &ColumnSelector| column.position()?.checked_sub(1);
        self.columns.iter().filter_map(|column| cells.get(place(column)?).copied()).collect()
    }

    /// Returns whether a cell is a name rather than a word for a missing value.
    fn is_name(self, cell: &[u8]) -> bool {
        looks_like_name(cell) && !decode(cell).is_ok_and(|cell| self.missing_as.lists(cell))
    }

    /// Returns whether a number is asked for that can be nothing but one of these names.
    fn has_numbers_as_names(self, cells: &[&[u8]]) -> bool {
        self.all().any(|column| {
            column.is_number()
                && !is_column(column, cells.len())
                && cells.iter().any(|cell| is_text(cell, column))
        })
    }

    /// Returns whether every number that is asked for is one of these names, and one of them cannot be anything else.
    fn prefers_names(self, cells: &[&[u8]]) -> bool {
        let mut numbers = self.all().filter(|column| column.is_number());
        self.has_numbers_as_names(cells)
            && numbers.all(|column| cells.iter().any(|cell| is_text(cell, column)))
    }
}

/// Returns whether what is asked for is the number of a column.
fn is_column(column: &ColumnSelector, width: usize) -> bool {
    column.position().is_some_and(|position| (1..=width).contains(&position))
}

/// Returns whether a cell says what is asked for.
fn is_text(cell: &[u8], column: &ColumnSelector) -> bool {
    std::str::from_utf8(cell).is_ok_and(|cell| cell.trim() == column.text().raw())
}

impl Heading {
    /// Reads the cells of the first record, which starts on this line.
    pub(crate) fn new(
        file: &str,
        cells: &[&[u8]],
        line: u64,
        header: Header,
        asked: AskedColumns,
        looks: &[CellLook],
    ) -> Result<Self, InputError> {
        let (is_header, is_open) = match header {
            Header::Present => (true, false),
            Header::Absent => (false, false),
            Header::Auto if asked.tell(cells) => (true, false),
            Header::Auto => guess(cells, asked, looks),
        };
        let names = cells.iter().enumerate().map(|(index, &cell)| {
            decode(cell).map(|name| Foreign::from(name.trim())).map_err(|problem| {
                let place = ColumnPlace { position: index + 1, name: None };
                place.error(file, line, cell, problem)
            })
        });
        let names = if is_header { Some(names.collect::<Result<_, _>>()?) } else { None };
        let prefers_names = is_header && asked.prefers_names(cells);
        Ok(Heading { width: cells.len(), names, is_open, prefers_names, line })
    }

    /// Columns with these names, which a comment before the first record gives.
    pub(crate) fn of_comment(names: Vec<Foreign>, line: u64) -> Self {
        Heading { width: names.len(), names: Some(names), is_open: false, prefers_names: false, line }
    }

    /// Takes the comment mark off the first name of a header that begins with one and a blank: `# speed,dist`. Returns whether it does.
    pub(crate) fn take_mark(&mut self) -> bool {
        let first = self.names.as_mut().and_then(|names| names.first_mut());
        let Some(first) = first.filter(|name| without_mark(name.raw()) != name.raw()) else { return false };
        *first = without_mark(first.raw()).into();
        true
    }

    /// This heading of a table whose first column is the names of rows, and has none.
    pub(crate) fn after_row_names(mut self) -> Self {
        self.width += 1;
        self.names.iter_mut().for_each(|names| names.insert(0, Foreign::default()));
        self
    }

    /// The columns with the name that is asked for; else those whose name is that before a unit, or behind a comment mark.
    pub(crate) fn named(names: &[Foreign], wanted: &str) -> Vec<usize> {
        let indices = |is_meant: &dyn Fn(&str) -> bool| -> Vec<usize> {
            (0..).zip(names).filter(|(_, name)| is_meant(name.raw())).map(|(index, _)| index).collect()
        };
        let exact = indices(&|name| name == wanted);
        if !exact.is_empty() || wanted.is_empty() {
            return exact;
        }
        let wanted = behind_mark(wanted);
        indices(&|name| {
            [split_unit(name).0, name, split_unit(behind_mark(name)).0].contains(&wanted)
                && !wanted.is_empty()
        })
    }

    /// Returns the place of the column that is asked for.
    pub(crate) fn find(&self, file: &str, column: &ColumnSelector) -> Result<ColumnPlace, InputError> {
        let fail = |problem| InputError::of_line(file, self.line, problem);
        let wanted = column.text().clone();
        let names = self.names.as_deref().unwrap_or_default();
        let is_other = |index: usize| {
            column.is_number() && is_column(column, self.width) && column.position() != Some(index + 1)
        };
        let position = match Heading::named(names, wanted.raw()).as_slice() {
            [_, _, ..] => Err(fail(InputErrorKind::AmbiguousColumn { wanted })),
            [index] if is_other(*index) && !self.prefers_names => {
                Err(fail(InputErrorKind::NameOrNumber { wanted, named: index + 1, fits_header: true }))
            }
            [index] => Ok(index + 1),
            [] => column
                .position()
                .filter(|position| (1..=self.width).contains(position))
                .filter(|_| self.names.is_none() || column.is_number())
                .ok_or_else(|| {
                    let numbered = column.is_name() || column.is_number();
                    fail(InputErrorKind::UnknownColumn {
                        wanted,
                        available: names.to_vec(),
                        numbers: numbered.then_some(self.width),
                    })
                }),
        }?;
        Ok(ColumnPlace { position, name: names.get(position - 1).cloned() })
    }
}

/// Returns the number, from 1, of a column that is asked for among others in a table whose header has these names.
///
/// # Errors
/// There is no such column, or it could be several.
pub fn find_column(
    file: &str,
    names: &[Foreign],
    asked: &[ColumnSelector],
    column: &ColumnSelector,
) -> Result<usize, InputError> {
    let cells: Vec<&[u8]> = names.iter().map(|name| name.raw().as_bytes()).collect();
    let missing_as = &MissingWords::default();
    let prefers_names = AskedColumns { columns: asked, others: &[], missing_as }.prefers_names(&cells);
    let heading =
        Heading { width: names.len(), names: Some(names.to_vec()), is_open: false, prefers_names, line: 1 };
    Ok(heading.find(file, column)?.position)
}

/// Returns whether a record is a header by its own cells and those below, and whether it could be the other as well.
///
/// A word above numbers is a name. So is nothing above numbers, as in pandas' `,0,1`; but a reading may lack a number, and it may have a
/// word where nobody asks for a number. A number that is asked for and that no column has is a name.
fn guess(cells: &[&[u8]], asked: AskedColumns, looks: &[CellLook]) -> (bool, bool) {
    let is_above = |is_meant: &dyn Fn(&[u8]) -> bool| {
        cells.iter().zip(looks).any(|(cell, look)| look.is_above_number && is_meant(cell))
    };
    if is_above(&|cell| asked.is_name(cell)) {
        let may_be_reading = asked.numbers_of(looks).iter().all(|look| look.may_be_read);
        return (true, may_be_reading && !asked.has_numbers_as_names(cells));
    }
    let is_empty = |cell: &[u8]| cell.trim_ascii().is_empty();
    (asked.has_numbers_as_names(cells) || is_above(&is_empty), true)
}

/// A name without a comment mark in front of it, as in the header `# speed,dist`.
fn behind_mark(name: &str) -> &str {
    name.trim_start_matches(['#', '%']).trim_start()
}

/// A name without a comment mark and a blank in front of it; a mark alone is a name.
pub(crate) fn without_mark(name: &str) -> &str {
    let is_marked = name.starts_with("# ") || name.starts_with("% ");
    if is_marked { behind_mark(name) } else { name }
}

/// Returns whether a cell of the first row is a name rather than a number, a failed number or a missing one.
pub(crate) fn looks_like_name(cell: &[u8]) -> bool {
    let text = String::from_utf8_lossy(cell);
    let text = text.trim();
    let text = without_mark(text);
    text.starts_with(|first: char| first.is_alphabetic() || first == '_')
        && !is_missing(text)
        && !["inf", "infinity"].contains(&text.to_lowercase().as_str())
}
