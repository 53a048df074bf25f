//! The accepted forms of what an input file has instead.

use std::borrow::Cow;
use std::fmt::Display;

use boundfit_exact::{ParseNumberError, ParseNumberErrorKind};

use super::kind::InputErrorKind;
use super::names::are_no_names;
use super::words::first_names;

impl InputErrorKind {
    /// The accepted form, if it can be said.
    pub(super) fn expected(&self) -> Option<Cow<'static, str>> {
        let fixed = || self.in_files().or_else(|| self.in_cells()).or_else(|| self.in_half_planes());
        self.of_names().map(Cow::Owned).or_else(|| fixed().map(Cow::Borrowed))
    }

    /// The accepted form that names of the file or the question are in.
    fn of_names(&self) -> Option<String> {
        Some(match self {
            InputErrorKind::UnknownColumn { available, numbers, .. }
                if numbers.is_none() || !are_no_names(available) =>
            {
                let names = (!available.is_empty()).then(|| format!("one of {}", first_names(available)));
                let number = numbers.map(|numbers| format!("a number from 1 to {numbers}"));
                names.into_iter().chain(number).collect::<Vec<_>>().join(" or ")
            }
            InputErrorKind::UnknownSheet { available, .. } if !available.is_empty() => {
                format!("one of {} or a number from 1 to {}", first_names(available), available.len())
            }
            InputErrorKind::BlockNameOrNumber { wanted, .. } => name_or_number(wanted, "block"),
            InputErrorKind::NameOrNumber { wanted, .. } => name_or_number(wanted, "column"),
            InputErrorKind::SheetNameOrNumber { wanted, .. } => name_or_number(wanted, "sheet"),
            InputErrorKind::UnknownBlock { wanted, is_name: true, .. } => format!(
                "'\"{wanted}\"', with the quotes, for the name, or another block by its number or its name"
            ),
            InputErrorKind::WholeMatrix { variable, columns, .. } => {
                format!("one of its columns, \"{variable}(:,1)\" to \"{variable}(:,{columns})\"")
            }
            _ => return None,
        })
    }

    /// The accepted form of a file and its columns.
    fn in_files(&self) -> Option<&'static str> {
        Some(match self {
            InputErrorKind::IsDirectory => "a file",
            InputErrorKind::Empty
            | InputErrorKind::NothingBehind(_)
            | InputErrorKind::NoRows
            | InputErrorKind::EmptySheet { .. } => "at least one row of numbers",
            InputErrorKind::NotUtf8 { unit: "cell", .. } => "text in UTF-8, as the characters before it are",
            InputErrorKind::Utf16 | InputErrorKind::NotUtf8 { .. } => "text in UTF-8",
            InputErrorKind::UnknownSheet { .. } => "a workbook with sheets",
            InputErrorKind::AmbiguousBlock { .. } => "the number of a block",
            InputErrorKind::SeveralBlocks { .. } | InputErrorKind::UnknownBlock { .. } => {
                "a block by its number or its name"
            }
            InputErrorKind::SameColumn { .. } => "two columns",
            InputErrorKind::AmbiguousColumn { .. } => "a name that occurs once, or the column's number",
            InputErrorKind::Json { .. } => "JSON with an object for each row, or a table of text such as CSV",
            InputErrorKind::JsonEnds { .. } => "a complete file",
            InputErrorKind::NestedJson => {
                "JSON with an object for each row; in pandas table.to_json('FILE', orient='records')"
            }
            InputErrorKind::NoNumbers { .. } => {
                "a vector or matrix of real numbers: double, single, integer or logical, full"
            }
            InputErrorKind::DifferentLengths { .. } => "columns of one length",
            InputErrorKind::NoNumberInFirstRow { .. } => "a row of numbers",
            InputErrorKind::RaggedRow { .. } => "as many cells in every row, also where a value is missing",
            InputErrorKind::ColumnType { expected, .. } => expected,
            _ => return None,
        })
    }

    /// The accepted form of a cell.
    fn in_cells(&self) -> Option<&'static str> {
        Some(match self {
            InputErrorKind::NotANumber(error) if error.kind.is_limit() => return None,
            InputErrorKind::NotANumber(ParseNumberError { kind: ParseNumberErrorKind::Date, .. }) => {
                "a decimal, a fraction such as 7/19, or in place of dates a column of seconds or days"
            }
            InputErrorKind::Time => {
                "a number: give the cells the format of one, or add a column of seconds or days"
            }
            InputErrorKind::UnitBehind => {
                "the number alone: a unit belongs in the header, or in a row of units below it"
            }
            InputErrorKind::NoValue => "a value: open the workbook in a spreadsheet and save it",
            InputErrorKind::CommasTwice { .. } => {
                "semicolons or tabs between the columns, or quotes around numbers with commas"
            }
            InputErrorKind::Null => "a value",
            InputErrorKind::NotFinite => "a finite number",
            InputErrorKind::NotBinary64 => "a number that binary64 has: a reduction is text of such",
            InputErrorKind::NotANumber(ParseNumberError { kind: ParseNumberErrorKind::Comma, .. }) => "1.5",
            InputErrorKind::NotANumber(ParseNumberError { kind: ParseNumberErrorKind::Point, .. }) => "1,5",
            InputErrorKind::Comma => {
                "1.5, or a column of numbers: write the file with one, or as CSV with decimal commas"
            }
            InputErrorKind::NoDelimiter { .. } => "a column's number",
            InputErrorKind::AnotherDecimalMark { .. } => "one decimal mark",
            InputErrorKind::BehindQuotes => "a delimiter behind the quote, or no quotes",
            InputErrorKind::NumbersAsUnits => "units such as mm, or readings without a row of units",
            InputErrorKind::Missing { .. } => "a number in every row",
            InputErrorKind::AllMissing { .. } => "a row with all its numbers",
            InputErrorKind::BlanksTwice => "another character between groups of digits, or another delimiter",
            InputErrorKind::NotANumber(_) => "a decimal such as 1.30e-2 or a fraction such as 7/19",
            InputErrorKind::NegativeErrorBound => "a number that is at least 0",
            InputErrorKind::NoBound => "a number in a column of bounds, or the file without this row",
            InputErrorKind::NoLastDigit => "a decimal such as 1.30e-2",
            InputErrorKind::NoDigits { .. } => {
                "a bound as a number, such as 0.005, or a law without 'written'"
            }
            _ => return None,
        })
    }

    /// The accepted form of half-planes.
    fn in_half_planes(&self) -> Option<&'static str> {
        Some(match self {
            InputErrorKind::NoBegin => "an H- or V-representation: begin, rows, end",
            InputErrorKind::BadSizeLine => "\"ROWS 3 integer\", \"ROWS 3 rational\" or \"ROWS 3 real\"",
            InputErrorKind::MoreThanThePlane { .. } => "columns a1, a2 and b: a1*theta1 + a2*theta2 <= b",
            InputErrorKind::Relation => {
                "no such column: change all signs of a row with >=, and write a row with = both ways"
            }
            InputErrorKind::BesideHalfPlane => {
                "3 columns, or a header with the names a1, a2 and b: other columns are then ignored"
            }
            InputErrorKind::NotThePlane(_) => "3 columns: b, -a1, -a2 or 1, x, y",
            InputErrorKind::SecondMatrix => "one representation in a file",
            InputErrorKind::NegativeWeight => "1 for a point or 0 for a ray",
            InputErrorKind::LinearPoint => "0 x y for a line",
            InputErrorKind::BadLinearity => {
                "\"linearity COUNT ROW...\" before begin, with rows counted from 1"
            }
            InputErrorKind::OtherSet { instead } => instead,
            _ => return None,
        })
    }
}

/// A text that is the name of one thing and the number of another.
fn name_or_number(wanted: &impl Display, what: &str) -> String {
    format!("'\"{wanted}\"', with the quotes, for the name; for the number the name of that {what}")
}
