//! The groups of a fleet as CSV: one row of bounds and estimates each.

use std::fmt::{self, Write};

use boundfit_estimation::GroupFit;
use boundfit_exact::{Endpoint, Foreign, Rational};
use csv::Writer;

use crate::csv_text::csv_text;
use crate::style::{Shown, Style};

/// The names of the columns but for the last, which says what it is about.
const COLUMNS: [&str; 14] = [
    "group",
    "rows",
    "first_row",
    "kind",
    "theta1_lower",
    "theta1_upper",
    "theta2_lower",
    "theta2_upper",
    "theta1_central",
    "theta1_error",
    "theta2_central",
    "theta2_error",
    "theta1_least_squares",
    "theta2_least_squares",
];

/// Rows of CSV that are put together in memory.
#[derive(Debug)]
pub struct FleetCsv {
    writer: Writer<Vec<u8>>,
    /// A cell on its way.
    cell: String,
}

// Nothing can go wrong: memory takes whatever is written, and every row has as many cells as the header.
const WRITTEN: &str = "a row that memory does not take";

impl FleetCsv {
    /// Nothing yet.
    pub fn new() -> Self {
        FleetCsv { writer: Writer::from_writer(Vec::new()), cell: String::new() }
    }

    /// Adds the header. The last column is `epsilon_min`, or `epsilon_factor` where each reading has its own bound.
    pub fn header(&mut self, is_bounded_per_row: bool) {
        let last = if is_bounded_per_row { "epsilon_factor" } else { "epsilon_min" };
        self.writer.write_record(COLUMNS.iter().chain([&last])).expect(WRITTEN);
    }

    /// Adds a group. Missing values are empty cells; an end that is not bounded is `-inf` or `inf`. Ends have the
    /// digits that their interval takes.
    pub fn group(&mut self, key: Foreign<&str>, group: &GroupFit, style: &Style) {
        self.writer.write_field(csv_text(key).as_bytes()).expect(WRITTEN);
        self.cell(group.rows);
        self.optional(group.first_row);
        self.cell(group.kind.name());
        let styles = style.resolving_both(group.pui.as_ref());
        for axis in 0..2 {
            match &group.pui {
                Some(pui) => {
                    self.end(pui[axis].lower(), "-inf", |value| styles[axis].lower(value).compact());
                    self.end(pui[axis].upper(), "inf", |value| styles[axis].upper(value).compact());
                }
                None => {
                    self.cell("");
                    self.cell("");
                }
            }
        }
        for (axis, alone) in styles.iter().enumerate() {
            let shown = group
                .central
                .as_ref()
                .map(|own| style.give_or_take(&own.theta[axis], &own.guaranteed_error[axis], alone));
            let (centre, error) = shown.map(|own| (own.centre, own.error)).unzip();
            self.optional(centre.map(Shown::compact));
            self.optional(error.map(Shown::compact));
        }
        for (axis, own) in styles.iter().enumerate() {
            let estimate = group.least_squares.as_ref();
            self.optional(estimate.map(|theta| own.nearest(&theta[axis]).compact()));
        }
        self.optional(group.least.as_ref().map(|least| style.upper(least).compact()));
        self.writer.write_record(None::<&[u8]>).expect(WRITTEN);
    }

    /// The added lines, as text in UTF-8.
    pub fn into_bytes(self) -> Vec<u8> {
        self.writer.into_inner().expect(WRITTEN)
    }

    fn end<'a, T: fmt::Display>(
        &mut self,
        end: &'a Endpoint,
        unbounded: &str,
        shown: impl Fn(&'a Rational) -> T,
    ) {
        match end {
            Endpoint::Finite(value) => self.cell(shown(value)),
            Endpoint::Unbounded => self.cell(unbounded),
        }
    }

    fn optional(&mut self, content: Option<impl fmt::Display>) {
        match content {
            Some(content) => self.cell(content),
            None => self.cell(""),
        }
    }

    fn cell(&mut self, content: impl fmt::Display) {
        self.cell.clear();
        write!(self.cell, "{content}").expect(WRITTEN);
        self.writer.write_field(&self.cell).expect(WRITTEN);
    }
}

impl Default for FleetCsv {
    fn default() -> Self {
        FleetCsv::new()
    }
}
