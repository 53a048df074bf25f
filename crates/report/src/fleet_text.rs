//! The groups of a fleet as text: one line each, aligned.

use boundfit_estimation::GroupFit;
use boundfit_exact::Foreign;
use boundfit_questions::Order;

use crate::align::{columns, widths, write_line};
use crate::document::WIDTH;
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

/// Lines under each other that fit a page. The first thousand tell how wide the columns are. A name that is too wide has a line of its
/// own; intervals that are too wide stand under each other.
#[derive(Debug)]
pub struct FleetTable {
    layout: Option<Layout>,
    waiting: Vec<GroupCells>,
}

impl FleetTable {
    /// A table with its header. `is_bounded_per_row`: whether each reading has its own error bound.
    pub fn new(is_bounded_per_row: bool) -> Self {
        FleetTable { layout: None, waiting: vec![GroupCells::header(is_bounded_per_row)] }
    }

    /// A table of windows in this order with its header.
    pub fn of_windows(order: Order) -> Self {
        let header = [places(order), "count", "kind", "theta1", "theta2", "eps_min"].map(ToOwned::to_owned);
        FleetTable { layout: None, waiting: vec![GroupCells(header)] }
    }

    /// Appends a line to the text, or keeps it until it is known how wide the columns are.
    pub fn push(&mut self, cells: GroupCells, text: &mut String) {
        match &self.layout {
            Some(layout) => layout.write(&cells, text),
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
        let layout = self.layout.get_or_insert_with(|| Layout::of(&waiting));
        for cells in &waiting {
            layout.write(cells, text);
        }
    }
}

/// The widths of the columns.
#[derive(Debug)]
struct Layout {
    name: usize,
    /// The widths of all cells behind the name.
    others: Vec<usize>,
    /// `true` if the interval of θ2 stands under that of θ1.
    is_stacked: bool,
}

impl Layout {
    /// The layout of some lines; the first one is the header.
    fn of(lines: &[GroupCells]) -> Self {
        let head = lines.first().map_or(0, |GroupCells([name, ..])| columns(name));
        let behind = |is_stacked: bool| {
            widths(&lines.iter().flat_map(|line| line.behind(is_stacked)).collect::<Vec<_>>())
        };
        let is_too_wide = |others: &[usize]| head + taken(others) > WIDTH;
        let is_stacked = is_too_wide(&behind(false));
        let others = behind(is_stacked);
        let widest = lines.iter().map(|GroupCells([name, ..])| columns(name)).max().unwrap_or(head);
        let name = widest.min(WIDTH.saturating_sub(taken(&others)).max(head));
        Layout { name, others, is_stacked }
    }

    fn write(&self, line: &GroupCells, text: &mut String) {
        let GroupCells([name, ..]) = line;
        let mut name = name.as_str();
        // A wider name moves the rest of its line, as long as the page has room for it.
        if columns(name) > self.name && columns(name) + taken(&self.others) > WIDTH {
            text.push_str(name);
            text.push('\n');
            name = "";
        }
        let widths = [&[self.name], self.others.as_slice()].concat();
        for cells in line.behind(self.is_stacked) {
            write_line([&[name], cells.as_slice()].concat().iter(), &widths, text);
            name = "";
        }
    }
}

/// The number of columns that cells of these widths take behind another one.
fn taken(widths: &[usize]) -> usize {
    widths.iter().map(|width| width + 2).sum()
}

impl GroupCells {
    /// The cells behind the name, in one line or, with θ2 under θ1, in two.
    fn behind(&self, is_stacked: bool) -> Vec<Vec<&str>> {
        let [_, rows, kind, theta1, theta2, least] = self.0.each_ref().map(String::as_str);
        match is_stacked {
            // An empty set has no intervals.
            true if theta1 == "-" && theta2 == "-" => vec![vec![rows, kind, theta1, least]],
            true => vec![vec![rows, kind, theta1, least], vec!["", "", theta2, ""]],
            false => vec![vec![rows, kind, theta1, theta2, least]],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The table of these lines, in rows and in columns that no terminal breaks.
    fn table(lines: &[[&str; CELLS]]) -> Vec<String> {
        let (mut table, mut text) = (FleetTable::new(false), String::new());
        for line in lines {
            table.push(GroupCells(line.map(ToOwned::to_owned)), &mut text);
        }
        table.finish(&mut text);
        text.lines().map(ToOwned::to_owned).collect()
    }

    #[test]
    fn lines_fit_a_page() {
        let interval = "[-0.010503, 0.0146271234]";
        let long = "the name of a sensor";
        let lines = table(&[
            ["T1", "5", "polygon", interval, "[0.1, 0.22]", "0.0045013"],
            [long, "5", "strip", "-", "-", "0"],
        ]);
        assert_eq!(
            lines,
            [
                "group           rows  kind     theta1                     theta2       eps_min",
                "T1              5     polygon  [-0.010503, 0.0146271234]  [0.1, 0.22]  0.0045013",
                long,
                "                5     strip    -                          -            0",
            ]
        );
        let lines = table(&[
            ["T1", "5", "polygon", interval, interval, "0.0045013"],
            ["T2", "5", "strip", "-", "-", "0"],
        ]);
        assert_eq!(
            lines,
            [
                "group  rows  kind     theta1                     eps_min",
                "                      theta2",
                "T1     5     polygon  [-0.010503, 0.0146271234]  0.0045013",
                "                      [-0.010503, 0.0146271234]",
                "T2     5     strip    -                          0",
            ]
        );
    }

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
