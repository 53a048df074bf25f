//! The groups of a fleet as text: one line each, aligned.

use boundfit_estimation::GroupFit;
use boundfit_exact::Foreign;
use boundfit_questions::Order;

use crate::align::{widths, write_line};
use crate::fleet_summary::shown_key;
use crate::style::Style;

/// The number of cells in a line.
const CELLS: usize = 6;
/// The number of lines that decide the widths of the columns.
const LINES_MEASURED: usize = 1000;

/// The cells of a line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct GroupCells([String; CELLS]);

impl GroupCells {
    /// The line of a group: key, rows, kind, PUI, ε_min.
    pub fn new(key: Foreign<&str>, group: &GroupFit, style: &Style) -> Self {
        let none = || "-".to_owned();
        let pui = group.pui.as_ref();
        let styles = style.resolving_both(pui);
        let interval =
            |axis: usize| pui.map_or_else(none, |pui| styles[axis].interval(&pui[axis]).to_string());
        GroupCells([
            shown_key(key),
            group.rows.to_string(),
            group.kind.name().to_owned(),
            interval(0),
            interval(1),
            group.least.as_ref().map_or_else(none, |least| style.upper(least).to_string()),
        ])
    }

    /// The names of the cells. `is_bounded_per_row`: whether each reading has its own error bound.
    fn header(is_bounded_per_row: bool) -> Self {
        let last = if is_bounded_per_row { "eps_min / eps" } else { "eps_min" };
        GroupCells(["group", "rows", "kind", "theta1", "theta2", last].map(ToOwned::to_owned))
    }
}

/// Returns what tells windows in this order apart.
pub(crate) fn places(order: Order) -> &'static str {
    match order {
        Order::Row => "rows",
        Order::X => "x",
    }
}

/// Lines under each other. The first thousand tell how wide the columns are; a later cell that is wider moves the rest of
/// its line.
#[derive(Debug)]
pub struct FleetTable {
    widths: Option<Vec<usize>>,
    waiting: Vec<GroupCells>,
}

impl FleetTable {
    /// A table with its header. `is_bounded_per_row`: whether each reading has its own error bound.
    pub fn new(is_bounded_per_row: bool) -> Self {
        FleetTable { widths: None, waiting: vec![GroupCells::header(is_bounded_per_row)] }
    }

    /// A table of windows in this order with its header.
    pub fn of_windows(order: Order) -> Self {
        let header =
            [places(order), "readings", "kind", "theta1", "theta2", "eps_min"].map(ToOwned::to_owned);
        FleetTable { widths: None, waiting: vec![GroupCells(header)] }
    }

    /// Appends a line to the text, or keeps it until it is known how wide the columns are.
    pub fn push(&mut self, cells: GroupCells, text: &mut String) {
        match &self.widths {
            Some(widths) => write_line(&cells.0, widths, text),
            None => {
                self.waiting.push(cells);
                if self.waiting.len() > LINES_MEASURED {
                    self.finish(text);
                }
            }
        }
    }

    /// Appends the lines that are still waiting.
    pub fn finish(&mut self, text: &mut String) {
        let waiting = std::mem::take(&mut self.waiting);
        let widths = self.widths.get_or_insert_with(|| widths(&waiting));
        for cells in &waiting {
            write_line(&cells.0, widths, text);
        }
    }
}

impl AsRef<[String]> for GroupCells {
    fn as_ref(&self) -> &[String] {
        &self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_as_wide_as_their_first_thousand_cells() {
        let cells =
            |key: &str| GroupCells([key, "3", "point", "[1, 1]", "[2, 2]", "0"].map(ToOwned::to_owned));
        let (mut table, mut text) = (FleetTable::new(false), String::new());
        for _ in 0..998 {
            table.push(cells("α"), &mut text);
        }
        table.push(cells("温度計"), &mut text);
        assert_eq!(text, "");
        table.push(cells("b"), &mut text);
        table.push(cells("much wider than the others"), &mut text);
        table.finish(&mut text);
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines.len(), 1002);
        assert_eq!(lines[0], "group   rows  kind   theta1  theta2  eps_min");
        assert_eq!(lines[1], "α       3     point  [1, 1]  [2, 2]  0");
        assert_eq!(lines[999], "温度計  3     point  [1, 1]  [2, 2]  0");
        assert_eq!(lines[1001], "much wider than the others  3     point  [1, 1]  [2, 2]  0");
    }
}
