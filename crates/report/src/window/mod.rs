//! Windows that move on, a line each: JSON of schema `boundfit/window/1`, CSV, text.

mod json;

pub use json::write_window_json;

use std::sync::Arc;

use boundfit_estimation::{GroupFit, Model, ParameterInterval, Problem};
use boundfit_exact::english::counted;
use boundfit_exact::{Endpoint, Foreign, Rational};
use boundfit_geometry::RegionKind;
use boundfit_questions::{Extent, Moved, Moving, Order, Turn, WindowFit};

use crate::fleet_text::{GroupCells, places};
use crate::range::exact;
use crate::style::Style;

/// A window with its answer.
#[derive(Debug, Clone)]
pub struct WindowReport {
    /// The rows of its first and last reading.
    pub rows: [usize; 2],
    /// The order of the readings of all windows.
    pub order: Order,
    /// The number of readings of the window.
    pub readings: usize,
    /// x of its first and last reading, which are those of the data; `None` with two regressors.
    pub x: Option<[Rational; 2]>,
    /// The results of its readings.
    pub fit: Arc<WindowFit>,
    /// ε_min, where all readings are of a line under one bound and nothing else is known.
    pub least: Option<Rational>,
}

impl WindowReport {
    /// The report of a window that has its turn; `None` when it has no reading.
    pub fn new(turn: &Turn<'_>, problem: &Problem, order: Order) -> Option<Self> {
        let mut readings = turn.window.readings();
        let first = readings.next()?;
        let last = readings.next_back().unwrap_or(first);
        let measurements = &problem.measurements;
        let is_line = matches!(measurements.model(), Model::Line { .. });
        let origin = &measurements.line_form().x_origin;
        let x = is_line.then(|| [first, last].map(|reading| &reading.regressor[0] + origin));
        Some(WindowReport {
            rows: [first.row, last.row],
            order,
            readings: turn.window.len(),
            x,
            least: turn
                .window
                .fit()
                .least
                .clone()
                .filter(|_| is_line && measurements.error_bound().is_uniform()),
            fit: turn.window.fit(),
        })
    }

    /// The cells of its line of text.
    pub fn cells(&self, style: &Style) -> GroupCells {
        let fit = &self.fit;
        let pui = fit.pui.as_ref();
        let line = GroupFit {
            rows: self.readings,
            first_row: Some(self.rows[0]),
            kind: fit.kind,
            pui: pui.map(|pui| pui.each_ref().map(ParameterInterval::interval)),
            central: fit.central.clone(),
            least_squares: None,
            least: self.least.clone(),
        };
        GroupCells::new(Foreign::of(&self.extent(style)), &line, style)
    }

    /// The place of the window: its rows, or in the order of x, where other rows may stand between them, its first and last x.
    fn extent(&self, style: &Style) -> String {
        match (self.order, &self.x) {
            (Order::X, Some([first, last])) => format!("{}..{}", style.given(first), style.given(last)),
            _ => format!("{}..{}", self.rows[0], self.rows[1]),
        }
    }

    /// The names of the columns of CSV, with a line end.
    pub const CSV_HEADER: &'static str = "first_row,last_row,rows,x_first,x_last,kind,theta1_lower,theta1_upper,theta2_lower,\
                                          theta2_upper,theta1_central,theta1_error,theta2_central,theta2_error,epsilon_min\n";

    /// Returns the window's row of CSV, with a line end. Missing values are empty cells; an end that is not bounded
    /// is `-inf` or `inf`. Ends have the digits that their interval takes. Cells of an answer that stays are taken from the last
    /// window, where they are kept.
    pub fn csv(&self, style: &Style, last_answer: &mut Option<(Arc<WindowFit>, String)>) -> String {
        let [first, last] = self.rows;
        let [x_first, x_last] = self.x.as_ref().map(|x| x.each_ref().map(exact)).unwrap_or_default();
        let is_same = |(fit, _): &(Arc<WindowFit>, String)| is_same(fit, &self.fit);
        let (_, cells) = match last_answer.take().filter(is_same) {
            Some(same) => last_answer.insert(same),
            None => last_answer.insert((Arc::clone(&self.fit), self.cells_of_csv(style))),
        };
        format!("{first},{last},{},{x_first},{x_last},{cells}\n", self.readings)
    }

    /// The cells of the answer.
    fn cells_of_csv(&self, style: &Style) -> String {
        let fit = &self.fit;
        let mut cells = vec![fit.kind.name().to_owned()];
        let pui = fit.pui.as_ref().map(|pui| pui.each_ref().map(ParameterInterval::interval));
        let styles = style.resolving_both(pui.as_ref());
        for (axis, own) in styles.iter().enumerate() {
            let Some(interval) = pui.as_ref().map(|pui| &pui[axis]) else {
                cells.extend([String::new(), String::new()]);
                continue;
            };
            cells.push(match interval.lower() {
                Endpoint::Finite(value) => own.lower(value).compact().to_string(),
                Endpoint::Unbounded => "-inf".to_owned(),
            });
            cells.push(match interval.upper() {
                Endpoint::Finite(value) => own.upper(value).compact().to_string(),
                Endpoint::Unbounded => "inf".to_owned(),
            });
        }
        for (axis, own) in styles.iter().enumerate() {
            cells.extend(match &fit.central {
                Some(central) => {
                    let shown =
                        style.give_or_take(&central.theta[axis], &central.guaranteed_error[axis], own);
                    [shown.centre, shown.error].map(|number| number.compact().to_string())
                }
                None => [String::new(), String::new()],
            });
        }
        cells.push(
            self.least.as_ref().map_or_else(String::new, |least| style.upper(least).compact().to_string()),
        );
        cells.join(",")
    }
}

/// Returns whether two answers have the same numbers; `false` where that is not seen at once.
fn is_same(one: &Arc<WindowFit>, other: &Arc<WindowFit>) -> bool {
    // A middle and the distances from it are an interval.
    let has_equal = || one.central.is_some() && one.central == other.central;
    Arc::ptr_eq(one, other) || one.kind == other.kind && has_equal() && one.least == other.least
}

/// Counts over many windows.
#[derive(Debug, Clone, Default)]
pub struct WindowSummary {
    empty: usize,
    bounded: usize,
    unbounded: usize,
    /// The order of the windows, and the extent of the first one that is empty.
    first_empty: Option<(Order, String)>,
}

impl WindowSummary {
    /// Takes a window in.
    pub fn add(&mut self, window: &WindowReport, style: &Style) {
        match (window.fit.kind, window.fit.central.is_some()) {
            (RegionKind::Empty, _) => {
                self.empty += 1;
                self.first_empty.get_or_insert_with(|| (window.order, window.extent(style)));
            }
            (_, true) => self.bounded += 1,
            (_, false) => self.unbounded += 1,
        }
    }

    /// Returns whether a window has an empty set.
    pub fn has_empty(&self) -> bool {
        self.empty > 0
    }

    /// Returns the answer in words, with line ends.
    pub fn to_text(&self, moving: &Moving, moved: &Moved, style: &Style) -> String {
        let windows = counted(moved.windows, "window", "windows");
        let long = match &moving.extent {
            Extent::Readings(count) => counted(*count, "reading", "readings"),
            Extent::X(span) => format!("{} of x", style.given(span)),
        };
        let step = counted(moving.step, "reading", "readings");
        let mut text = format!(
            "{windows} of {long}, step {step}: {} bounded, {} unbounded, {} empty\n",
            self.bounded, self.unbounded, self.empty
        );
        if let Some((order, extent)) = &self.first_empty {
            text += &format!("The first empty one is that of {} {extent}\n", places(*order));
        }
        if moved.is_short {
            text += "All readings together do not fill a window: the only one has all of them\n";
        } else if moved.left > 0 {
            let readings = counted(moved.left, "reading comes", "readings come");
            text += &format!("{readings} after the last window\n");
        }
        text
    }
}
