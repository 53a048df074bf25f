//! The estimates and intervals of a fit as CSV.

use boundfit_estimation::{Central, Fit, InverseParameter, MultipleOfLeast, Problem};
use boundfit_exact::{Endpoint, Interval, Rational};
use csv::Writer;

const COLUMNS: [&str; 8] =
    ["quantity", "parameter", "lower", "upper", "value", "lower_exact", "upper_exact", "value_exact"];

/// Estimates and intervals as a table, one row for each quantity of each parameter.
///
/// The first row, `set,kind`, has the kind of the set as its `value_exact`, so that an empty set says that it is. A bound that
/// is a multiple of ε_min follows as `error_bound`. The quantities are `least_squares`, `eui`, `pui`, `central`,
/// `guaranteed_error` and `minimax`, as far as they exist.
/// The parameters are `theta1` and `theta2`, and for a line with an inverse also `gain` and `offset`. For gain and
/// offset, `pui` is the range over the box of both intervals, and `fps` the range over the feasible set. Each has
/// several rows if it has several parts. The last row is `least_error_bound`, or `least_factor` where the readings
/// have bounds of their own. `lower`, `upper` and `value` are doubles: ends rounded outward, `-inf` and `inf` where
/// there are none, errors and the least error bound up, values to nearest. The last columns are exact.
pub fn fit_csv(problem: &Problem, fit: &Fit) -> String {
    let mut table = Table::new();
    table.text("set", "kind", fit.fps.polyhedron().kind().name());
    if let Some(epsilon) = problem.measurements.multiple_of_least().map(MultipleOfLeast::bound) {
        table.value("error_bound", "", epsilon.ceil_to_f64(), &epsilon);
    }
    if let Ok(estimate) = &fit.least_squares {
        table.values("least_squares", &estimate.theta);
    }
    if let Some(eui) = fit.eui() {
        table.intervals("eui", eui);
    }
    if let Some(pui) = fit.pui_intervals() {
        table.intervals("pui", &pui);
    }
    if let Some(central) = &fit.central {
        table.central(central);
    }
    if let Some(minimax) = &fit.minimax {
        table.values("minimax", &minimax.theta);
    }
    if let Some(inverse) = fit.inverse(problem.measurements.model()) {
        table.inverse("gain", &inverse.gain);
        table.inverse("offset", &inverse.offset);
    }
    if let Some(minimax) = &fit.minimax {
        let is_uniform = problem.measurements.error_bound().is_uniform();
        let quantity = if is_uniform { "least_error_bound" } else { "least_factor" };
        table.value(quantity, "", minimax.least.ceil_to_f64(), &minimax.least);
    }
    table.into_text()
}

const PARAMETERS: [&str; 2] = ["theta1", "theta2"];

/// The table of a report.
pub(crate) struct Table {
    writer: Writer<Vec<u8>>,
}

impl Table {
    pub(crate) fn new() -> Self {
        let mut table = Table { writer: Writer::from_writer(Vec::new()) };
        table.row(COLUMNS.map(str::to_owned));
        table
    }

    pub(crate) fn into_text(self) -> String {
        String::from_utf8(self.writer.into_inner().unwrap_or_default()).unwrap_or_default()
    }

    fn row(&mut self, cells: [String; 8]) {
        // Writing to memory does not fail.
        let written = self.writer.write_record(&cells);
        debug_assert!(written.is_ok());
    }

    /// A text stands where the exact numbers do, which are texts: the other columns are numbers or empty.
    pub(crate) fn text(&mut self, quantity: &str, parameter: &str, text: &str) {
        let mut row = [const { String::new() }; 8];
        for (cell, text) in [(0, quantity), (1, parameter), (7, text)] {
            row[cell] = text.to_owned();
        }
        self.row(row);
    }

    pub(crate) fn value(&mut self, quantity: &str, parameter: &str, double: f64, exact: &Rational) {
        let [none, no_lower, no_upper, no_end] = [const { String::new() }; 4];
        let (quantity, parameter) = (quantity.to_owned(), parameter.to_owned());
        self.row([quantity, parameter, none, no_lower, shown(double), no_upper, no_end, exact.to_string()]);
    }

    pub(crate) fn values(&mut self, quantity: &str, values: &[Rational; 2]) {
        for (parameter, value) in PARAMETERS.iter().zip(values) {
            self.value(quantity, parameter, value.to_f64(), value);
        }
    }

    /// The central estimate and its guaranteed error, whose double covers the rounding of the estimate.
    pub(crate) fn central(&mut self, central: &Central) {
        self.values("central", &central.theta);
        for ((name, error), theta) in PARAMETERS.iter().zip(&central.guaranteed_error).zip(&central.theta) {
            self.value("guaranteed_error", name, error.ceil_to_f64_beside(theta), error);
        }
    }

    pub(crate) fn interval(&mut self, quantity: &str, parameter: &str, interval: &Interval) {
        let end = |end: &Endpoint, double: &dyn Fn(&Rational) -> f64, none: &str| {
            end.value()
                .map_or((none.to_owned(), String::new()), |value| (shown(double(value)), value.to_string()))
        };
        let (lower, lower_exact) = end(interval.lower(), &Rational::floor_to_f64, "-inf");
        let (upper, upper_exact) = end(interval.upper(), &Rational::ceil_to_f64, "inf");
        let names = [quantity, parameter].map(str::to_owned);
        let [quantity, parameter] = names;
        self.row([quantity, parameter, lower, upper, String::new(), lower_exact, upper_exact, String::new()]);
    }

    pub(crate) fn intervals(&mut self, quantity: &str, intervals: &[Interval; 2]) {
        for (parameter, interval) in PARAMETERS.iter().zip(intervals) {
            self.interval(quantity, parameter, interval);
        }
    }

    fn inverse(&mut self, parameter: &str, inverse: &InverseParameter) {
        if let Some(value) = &inverse.least_squares {
            self.value("least_squares", parameter, value.to_f64(), value);
        }
        for interval in inverse.eui_range.iter().flatten() {
            self.interval("eui", parameter, interval);
        }
        for interval in &inverse.box_range {
            self.interval("pui", parameter, interval);
        }
        for interval in &inverse.exact_range {
            self.interval("fps", parameter, interval);
        }
        if let Some(value) = &inverse.central {
            self.value("central", parameter, value.to_f64(), value);
        }
    }
}

/// The shortest text that is read as this double.
pub(crate) fn shown(double: f64) -> String {
    format!("{double:?}")
}
