//! The data, read a second time, and the half-planes that they stand for (section 2).

use std::iter::from_fn;

use boundfit_exact::Limits;

use crate::{Falsehood, Proof, Source, Triple, holds};

/// The rows of delimited text that are not blank, as cells.
fn rows(data: &[u8], delimiter: u8) -> impl Iterator<Item = Vec<Vec<u8>>> {
    let mut bytes = data.iter().copied().peekable();
    let row = from_fn(move || {
        let mut cells = Vec::new();
        bytes.peek()?;
        loop {
            let (mut cell, mut in_quotes) = (Vec::new(), bytes.next_if_eq(&b'"').is_some());
            let end = loop {
                match bytes.next() {
                    Some(b'"') if in_quotes && bytes.next_if_eq(&b'"').is_none() => in_quotes = false,
                    Some(byte) if in_quotes || ![delimiter, b'\r', b'\n'].contains(&byte) => cell.push(byte),
                    end => break end,
                }
            };
            cells.push(cell);
            if end != Some(delimiter) {
                return Some(cells);
            }
        }
    });
    row.filter(|cells| !matches!(cells.as_slice(), [cell] if cell.trim_ascii().is_empty()))
}

impl Proof {
    /// The half-planes of each wanted row, and those of the conditions, with their names.
    pub(crate) fn half_planes<'a>(
        &'a self,
        data: &'a [u8],
        limits: &'a Limits,
    ) -> impl Iterator<Item = Result<Vec<(String, Triple)>, Falsehood>> {
        // A byte order mark, and one more.
        let data = [(); 2].iter().fold(data, |data, ()| data.strip_prefix(b"\xef\xbb\xbf").unwrap_or(data));
        let mut width = None;
        // A header counts as row 0. No byte is like a delimiter that is none.
        let rows = (usize::from(!self.header)..).zip(rows(data, u8::try_from(self.delimiter).unwrap_or(0)));
        let rows = rows.map(move |(row, cells)| {
            let is_even = cells.len() == *width.get_or_insert(cells.len());
            holds(is_even, format!("row {row}: has not as many cells as the first one"))?;
            let is_wanted = (self.rows[0].max(1)..=self.rows[1]).contains(&row);
            if is_wanted { self.of_row(row, &cells, limits) } else { Ok(Vec::new()) }
        });
        let conditions = (1..).zip(&self.conditions).map(|(k, row)| (format!("where:{k}"), row.clone()));
        rows.chain([Ok(conditions.collect())])
    }

    fn of_row(
        &self,
        row: usize,
        cells: &[Vec<u8>],
        limits: &Limits,
    ) -> Result<Vec<(String, Triple)>, Falsehood> {
        let [x1, x2, y, epsilon] = self.model.each_ref().map(|source| match source {
            Source::Constant(number) => Ok(number.clone()),
            Source::Column(column) => {
                let place = format!("row {row}, column {column}");
                let cell = column.checked_sub(1).and_then(|index| cells.get(index));
                let text = String::from_utf8_lossy(cell.ok_or(format!("{place}: is missing"))?);
                self.reading.read(&text, limits).map_err(|error| format!("{place}: {error}"))
            }
        });
        let (x1, x2, y, epsilon) = (x1?, x2?, y?, epsilon?);
        holds(!epsilon.is_negative(), format!("row {row}: the error bound is negative"))?;
        let lower = [-&x1, -&x2, &epsilon - &y];
        Ok(vec![(format!("{row} lower"), lower), (format!("{row} upper"), [x1, x2, y + epsilon])])
    }
}
