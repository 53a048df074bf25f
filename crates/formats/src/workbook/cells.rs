//! The cells of a sheet out of a workbook, by the library for both kinds.

use std::fmt::Display;
use std::io::Cursor;

use boundfit_exact::Foreign;
use calamine::{Data, ExcelDateTime, Ods, Reader, SheetType, Xlsx};

use super::text::Lines;
use super::{Kind, Sheet, unreadable};
use crate::error::InputErrorKind;
use crate::mat::double_text;

/// The sheet that is wanted, by its name or its number from 1, or the first one, as text of at most so many bytes.
pub(super) fn sheet_text(
    kind: Kind,
    content: Vec<u8>,
    wanted: Option<&str>,
    limit: u64,
) -> Result<Sheet, InputErrorKind> {
    let content = Cursor::new(content);
    let mut lines = Lines::new(limit);
    let name = match kind {
        Kind::Xlsx => {
            let mut workbook = Xlsx::new(content).map_err(unreadable)?;
            let name = sheet_name(&workbook, wanted)?;
            let mut cells = workbook.worksheet_cells_reader(&name).map_err(unreadable)?;
            while let Some(cell) = cells.next_cell().map_err(unreadable)? {
                let ((row, column), text) =
                    (cell.get_position(), text_of(&Data::from(cell.get_value().clone())));
                if let Some(text) = text {
                    lines.push(row, column, &text)?;
                }
            }
            name
        }
        Kind::Ods => {
            let mut workbook = Ods::new(content).map_err(unreadable)?;
            let name = sheet_name(&workbook, wanted)?;
            let range = workbook.worksheet_range(&name).map_err(unreadable)?;
            let (first_row, first_column) = range.start().unwrap_or_default();
            for (row, column, value) in range.used_cells() {
                let at =
                    |first: u32, index: usize| first.saturating_add(u32::try_from(index).unwrap_or(u32::MAX));
                if let Some(text) = text_of(value) {
                    lines.push(at(first_row, row), at(first_column, column), &text)?;
                }
            }
            name
        }
    };
    Ok(Sheet { name, text: lines.finish()? })
}

/// The name of the sheet that is wanted.
fn sheet_name<R: Reader<Cursor<Vec<u8>>>>(
    workbook: &R,
    wanted: Option<&str>,
) -> Result<String, InputErrorKind>
where
    R::Error: Display,
{
    let sheets = workbook.sheets_metadata().iter().filter(|sheet| sheet.typ == SheetType::WorkSheet);
    let names: Vec<String> = sheets.map(|sheet| sheet.name.clone()).collect();
    let found = match wanted {
        None => names.first(),
        Some(wanted) => names.iter().find(|name| *name == wanted).or_else(|| {
            let number: usize = wanted.parse().ok()?;
            names.get(number.checked_sub(1)?)
        }),
    };
    let unknown = || InputErrorKind::UnknownSheet {
        wanted: wanted.unwrap_or("1").into(),
        available: names.iter().map(Foreign::from).collect(),
    };
    found.cloned().ok_or_else(unknown)
}

/// A cell as a table of text has it; nothing where it is empty.
fn text_of(value: &Data) -> Option<String> {
    Some(match value {
        Data::Int(integer) => integer.to_string(),
        Data::Float(double) => double_text(*double),
        Data::String(text) | Data::DateTimeIso(text) | Data::DurationIso(text) => text.clone(),
        Data::Bool(value) => truth(*value),
        Data::DateTime(time) => time_text(time),
        Data::Error(error) => error.to_string(),
        Data::Empty => return None,
    })
}

fn truth(value: bool) -> String {
    if value { "TRUE" } else { "FALSE" }.to_owned()
}

/// A date, a date with its time, or a duration in days, hours, minutes and seconds.
fn time_text(time: &ExcelDateTime) -> String {
    if time.is_duration() {
        let seconds = (time.as_f64() * 86_400.0).round() as i64;
        return format!("{}:{:02}:{:02}", seconds / 3600, (seconds / 60 % 60).abs(), (seconds % 60).abs());
    }
    let (year, month, day, hour, minute, second, _) = time.to_ymd_hms_milli();
    let date = format!("{year:04}-{month:02}-{day:02}");
    if (hour, minute, second) == (0, 0, 0) {
        date
    } else {
        format!("{date} {hour:02}:{minute:02}:{second:02}")
    }
}
