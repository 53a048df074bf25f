//! The groups of a fleet as CSV: one row of bounds and estimates each.

use std::fmt::{self, Write};

use boundfit_estimation::{GroupFit, GroupLine};
use boundfit_exact::{Endpoint, Foreign, PlacedDecimal, PlusMinus, Rational, Rounding, WideQuotient};
use boundfit_geometry::RegionKind;

use crate::csv_text::{csv_text, push_quoted};
use crate::style::{EndRounding, Shown, Style};

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
#[derive(Debug, Default)]
pub struct FleetCsv {
    text: String,
}

// Nothing can go wrong: memory takes whatever is written.
const WRITTEN: &str = "a row that memory does not take";

impl FleetCsv {
    /// Nothing yet.
    pub fn new() -> Self {
        FleetCsv::default()
    }

    /// Adds the header. The last column is `epsilon_min`, or `epsilon_factor` where each reading has its own bound.
    pub fn header(&mut self, is_bounded_per_row: bool) {
        let last = if is_bounded_per_row { "epsilon_factor" } else { "epsilon_min" };
        self.text.push_str(&COLUMNS.join(","));
        self.cell(last);
        self.text.push('\n');
    }

    /// Adds a group as [`FleetCsv::group`] does. Returns `false`, and adds nothing, where it takes the numbers themselves to tell their
    /// digits.
    pub fn line(&mut self, key: Foreign<&str>, line: &GroupLine, style: &Style) -> bool {
        let Some(LineCells { ends, central, least_squares, least }) = LineCells::new(line, style) else {
            return false;
        };
        self.start(key, line.rows, line.first_row, GroupLine::KIND);
        ends.into_iter().flatten().for_each(|end| self.decimal(end));
        for PlusMinus { centre, error } in central {
            self.decimal(centre);
            self.decimal(error);
        }
        least_squares.into_iter().for_each(|estimate| self.decimal(estimate));
        self.decimal(least);
        self.text.push('\n');
        true
    }

    /// Adds a group. Missing values are empty cells; an end that is not bounded is `-inf` or `inf`. Ends have the
    /// digits that their interval takes.
    pub fn group(&mut self, key: Foreign<&str>, group: &GroupFit, style: &Style) {
        self.start(key, group.rows, group.first_row, group.kind);
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
        self.text.push('\n');
    }

    /// The added lines, as text in UTF-8.
    pub fn into_bytes(self) -> Vec<u8> {
        self.text.into_bytes()
    }

    /// Begins a row with its first four cells.
    fn start(&mut self, key: Foreign<&str>, rows: usize, first_row: Option<usize>, kind: RegionKind) {
        push_quoted(&mut self.text, &csv_text(key));
        self.cell(rows);
        self.optional(first_row);
        self.cell(kind.name());
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

    /// Adds a cell without a formatter, which takes a third of the time.
    fn decimal(&mut self, decimal: PlacedDecimal) {
        self.text.push(',');
        decimal.compact().write_to(&mut self.text).expect(WRITTEN);
    }

    /// Adds a cell that needs no quotes behind others.
    fn cell(&mut self, content: impl fmt::Display) {
        self.text.push(',');
        write!(self.text, "{content}").expect(WRITTEN);
    }
}

/// The decimals of a polygon's line.
struct LineCells {
    ends: [[PlacedDecimal; 2]; 2],
    central: [PlusMinus; 2],
    least_squares: [PlacedDecimal; 2],
    least: PlacedDecimal,
}

impl LineCells {
    /// `None` where they do not follow from quotients that nobody has reduced.
    fn new(line: &GroupLine, style: &Style) -> Option<Self> {
        if style.exact || style.ends == EndRounding::Nearest {
            return None;
        }
        let digits = style.significant();
        let ends = |axis: usize| {
            let ends @ [lower, upper] = &line.pui[axis];
            match style.digits {
                Some(_) => {
                    Some([lower.decimal(digits, Rounding::Down)?, upper.decimal(digits, Rounding::Up)?])
                }
                None => WideQuotient::resolved(ends, digits),
            }
        };
        let central = |axis: usize| WideQuotient::middle(&line.pui[axis], digits);
        let least_squares = |axis: usize| line.least_squares[axis].decimal(digits, Rounding::Nearest);
        Some(LineCells {
            ends: [ends(0)?, ends(1)?],
            central: [central(0)?, central(1)?],
            least_squares: [least_squares(0)?, least_squares(1)?],
            least: line.least.decimal(digits, Rounding::Up)?,
        })
    }
}
