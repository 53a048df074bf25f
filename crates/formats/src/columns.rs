//! Which columns of a table are meant: names in a header, or numbers.

use boundfit_exact::Foreign;
use boundfit_exact::english::split_unit;

use crate::error::{InputError, InputErrorKind, Place};
use crate::roles::Role;

/// How a column is asked for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ColumnSelector {
    text: Foreign,
    /// Where the column is when there is no header, from 1.
    position: Option<usize>,
    role: Role,
}

impl ColumnSelector {
    /// A header name, or a number from 1.
    pub fn name_or_number(text: &str) -> Self {
        let mut selector = ColumnSelector { text: text.trim().into(), position: None, role: Role::default() };
        if selector.is_number() {
            selector.position = Some(selector.text.raw().parse().unwrap_or(usize::MAX));
        }
        selector
    }

    /// A header name, also where it looks like a number.
    pub fn name(text: &str) -> Self {
        ColumnSelector { text: text.trim().into(), position: None, role: Role::Number }
    }

    /// A header name, or a position from 1 in a table without a header.
    pub fn name_at(name: &str, position: usize) -> Self {
        ColumnSelector { text: name.into(), position: Some(position), role: Role::default() }
    }

    /// This column, with the demand that every number in it is at least 0.
    pub fn non_negative(self) -> Self {
        ColumnSelector { role: Role::NonNegative, ..self }
    }

    /// This column, with 0 for cells that have no number; see [`Role::Optional`].
    pub fn optional(self) -> Self {
        ColumnSelector { role: Role::Optional, ..self }
    }

    /// Where this column has numbers; see [`Role::Presence`].
    pub fn presence(self) -> Self {
        ColumnSelector { role: Role::Presence, ..self }
    }

    /// Half a unit of the last digit written in each cell of this column; see [`Role::HalfUnit`].
    pub fn half_unit(self) -> Self {
        ColumnSelector { role: Role::HalfUnit, ..self }
    }

    /// What is taken from the cells.
    pub fn role(&self) -> Role {
        self.role
    }

    /// Whether every number in the column must be at least 0.
    pub fn is_non_negative(&self) -> bool {
        self.role == Role::NonNegative
    }

    /// What was asked for.
    pub fn text(&self) -> &Foreign {
        &self.text
    }

    /// The column's number, when that is what was asked for.
    pub fn number(&self) -> Option<usize> {
        self.position.filter(|_| self.is_number())
    }

    fn is_number(&self) -> bool {
        !self.text.raw().is_empty() && self.text.raw().bytes().all(|byte| byte.is_ascii_digit())
    }
}

/// Whether the first row names the columns.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Header {
    /// It does when a column is asked for by name, or when the cells asked for look like names.
    #[default]
    Auto,
    /// It does.
    Present,
    /// It does not.
    Absent,
}

impl Header {
    /// All three.
    pub const ALL: [Header; 3] = [Header::Auto, Header::Present, Header::Absent];

    /// The answer to "does the first row name the columns?" on the command line: `auto`, `yes` or `no`.
    pub fn name(self) -> &'static str {
        match self {
            Header::Auto => "auto",
            Header::Present => "yes",
            Header::Absent => "no",
        }
    }
}

/// What the first record says about the columns of a table.
pub(crate) struct Heading {
    /// Cells in every row.
    pub(crate) width: usize,
    /// The names, when the first record is a header.
    pub(crate) names: Option<Vec<Foreign>>,
    line: u64,
}

/// A column of a table.
#[derive(Debug, Clone)]
pub(crate) struct ColumnPlace {
    /// Its number, from 1.
    pub(crate) position: usize,
    /// Its name, when there is a header.
    pub(crate) name: Option<Foreign>,
}

impl Heading {
    /// Reads the cells of the first record, which starts on this line. Numbers are wanted from `columns`, something else from
    /// `others`.
    pub(crate) fn new(
        file: &str,
        cells: &[&[u8]],
        line: u64,
        header: Header,
        columns: &[ColumnSelector],
        others: &[&ColumnSelector],
    ) -> Result<Self, InputError> {
        let is_header = match header {
            Header::Present => true,
            Header::Absent => false,
            Header::Auto => {
                let by_name =
                    columns.iter().chain(others.iter().copied()).any(|column| column.position.is_none());
                let asked: Vec<&[u8]> = columns
                    .iter()
                    .filter_map(|column| cells.get(column.position?.checked_sub(1)?).copied())
                    .collect();
                by_name || (!asked.is_empty() && asked.iter().all(|cell| looks_like_name(cell)))
            }
        };
        let names = cells.iter().enumerate().map(|(index, &cell)| {
            decode(cell).map(|name| Foreign::from(name.trim())).map_err(|problem| {
                let place = ColumnPlace { position: index + 1, name: None };
                place.error(file, line, cell, problem)
            })
        });
        let names = if is_header { Some(names.collect::<Result<_, _>>()?) } else { None };
        Ok(Heading { width: cells.len(), names, line })
    }

    /// Columns with these names, which a comment before the first record gives.
    pub(crate) fn of_comment(names: Vec<Foreign>, line: u64) -> Self {
        Heading { width: names.len(), names: Some(names), line }
    }

    /// This heading of a table whose first column is the names of rows, and has none.
    pub(crate) fn after_row_names(mut self) -> Self {
        self.width += 1;
        self.names.iter_mut().for_each(|names| names.insert(0, Foreign::default()));
        self
    }

    /// The columns with the name that is asked for; else those whose name is that before a unit, or behind a comment mark.
    fn named(names: &[Foreign], wanted: &str) -> Vec<usize> {
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

    /// Where the column asked for is.
    pub(crate) fn find(&self, file: &str, column: &ColumnSelector) -> Result<ColumnPlace, InputError> {
        let fail = |problem| InputError::of_line(file, self.line, problem);
        let names = self.names.as_deref().unwrap_or_default();
        let position = match Heading::named(names, column.text.raw()).as_slice() {
            [_, _, ..] => Err(fail(InputErrorKind::AmbiguousColumn { wanted: column.text.clone() })),
            [index] => Ok(index + 1),
            [] => column
                .position
                .filter(|position| (1..=self.width).contains(position))
                .filter(|_| self.names.is_none() || column.is_number())
                .ok_or_else(|| {
                    let numbered = column.position.is_none() || column.is_number();
                    fail(InputErrorKind::UnknownColumn {
                        wanted: column.text.clone(),
                        available: names.to_vec(),
                        numbers: numbered.then_some(self.width),
                    })
                }),
        }?;
        Ok(ColumnPlace { position, name: names.get(position - 1).cloned() })
    }
}

impl ColumnPlace {
    /// What to call the column: `col1` and so on where it has no name.
    pub(crate) fn title(&self) -> Foreign {
        let given = self.name.clone().filter(|name| !name.raw().is_empty());
        given.unwrap_or_else(|| format!("col{}", self.position).into())
    }

    /// The error for a problem with a cell of this column.
    pub(crate) fn error(&self, file: &str, line: u64, cell: &[u8], problem: InputErrorKind) -> InputError {
        let place = Place {
            line: Some(line),
            column: Some((self.position, self.name.clone())),
            text: Some(String::from_utf8_lossy(cell).into_owned().into()),
            ..Place::default()
        };
        InputError::new(file, place, problem)
    }
}

/// The text of a cell.
pub(crate) fn decode(cell: &[u8]) -> Result<&str, InputErrorKind> {
    std::str::from_utf8(cell).map_err(|_| InputErrorKind::NotUtf8 { position: readable(cell), unit: "cell" })
}

/// How many characters come before the first byte that belongs to none.
pub(crate) fn readable(bytes: &[u8]) -> usize {
    bytes.utf8_chunks().next().map_or(0, |chunk| chunk.valid().chars().count())
}

/// A name without a comment mark in front of it, as in the header `# speed,dist`.
fn behind_mark(name: &str) -> &str {
    name.trim_start_matches(['#', '%']).trim_start()
}

/// Whether a cell of the first row is a name rather than a number, a failed number or a missing one.
fn looks_like_name(cell: &[u8]) -> bool {
    let text = String::from_utf8_lossy(cell);
    let text = text.trim();
    let text = if text.starts_with("# ") || text.starts_with("% ") { behind_mark(text) } else { text };
    let missing = ["nan", "inf", "infinity", "na", "n/a", "null", "none"];
    text.starts_with(|first: char| first.is_alphabetic() || first == '_')
        && !missing.contains(&text.to_lowercase().as_str())
}
