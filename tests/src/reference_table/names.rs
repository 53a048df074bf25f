//! Which columns are meant.

use boundfit_exact::Foreign;
use boundfit_formats::{ColumnSelector, Header, InputError, InputErrorKind};
use csv::ByteRecord;

use super::Reader;
use super::cells::{not_utf8, wrong, wrong_cell};

impl Reader<'_> {
    /// The names in the first record, if it is a header.
    pub(super) fn header(&self, record: &ByteRecord, line: u64) -> Result<Option<Vec<String>>, InputError> {
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
}

/// Whether a cell may be a name. A comment mark before a blank is none of it.
fn is_name(cell: &[u8]) -> bool {
    let text = String::from_utf8_lossy(cell).trim().to_lowercase();
    let name = match text.split_once(' ') {
        Some(("#" | "%", _)) => unmarked(&text),
        _ => &text,
    };
    let missing = ["nan", "inf", "infinity", "na", "n/a", "null", "none"];
    name.starts_with(|first: char| first.is_alphabetic() || first == '_') && !missing.contains(&name)
}

/// A name without comment marks, and the blanks behind them, in front of it.
fn unmarked(name: &str) -> &str {
    let start = name.find(|character| !matches!(character, '#' | '%')).unwrap_or(name.len());
    name[start..].trim_start()
}

/// A name without a unit in brackets at its end, or in parentheses behind a blank; a number in them is no unit.
fn before_unit(name: &str) -> &str {
    let open = match name.trim_end().chars().next_back() {
        Some(')') => '(',
        Some(']') => '[',
        _ => return name,
    };
    let Some(start) = name.rfind(open) else { return name };
    let (before, unit) = (&name[..start], name[start + 1..].trim_end());
    let unit = unit[..unit.len() - 1].trim();
    let is_apart = open == '[' || before.chars().next_back().is_some_and(char::is_whitespace);
    let is_number = unit.chars().all(|character| character.is_ascii_digit());
    if is_apart && !is_number && !before.trim().is_empty() { before.trim() } else { name }
}

/// The number of the column that is meant, from 1.
pub(super) fn find(
    column: &ColumnSelector,
    names: &[String],
    has_header: bool,
    width: usize,
    line: u64,
) -> Result<usize, InputError> {
    let wanted = column.text().to_owned();
    let named = |is_meant: &dyn Fn(&str) -> bool| -> Vec<usize> {
        (1..=names.len()).filter(|&place| is_meant(&names[place - 1])).collect()
    };
    let mut places = named(&|name| wanted == name);
    let bare = unmarked(wanted.raw());
    if places.is_empty() && !bare.is_empty() {
        places =
            named(&|name| name == bare || before_unit(name) == bare || before_unit(unmarked(name)) == bare);
    }
    match (places.as_slice(), column.number()) {
        ([place], _) => Ok(*place),
        ([], Some(number)) if (1..=width).contains(&number) => Ok(number),
        ([], _) => {
            let available = if has_header { names.iter().map(Foreign::from).collect() } else { Vec::new() };
            let kind = InputErrorKind::UnknownColumn { wanted, available, numbers: Some(width) };
            Err(wrong(Some(line), kind))
        }
        _ => Err(wrong(Some(line), InputErrorKind::AmbiguousColumn { wanted })),
    }
}
