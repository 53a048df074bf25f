//! The statuses of readings as CSV.

use boundfit_exact::Rational;
use boundfit_questions::{RowStatus, Standing};

/// Rows of CSV, each with its line end: `of` is `data`, or `new` for a further reading; numbers are doubles to nearest and
/// exact, and empty where there are none.
#[derive(Debug)]
pub struct StatusCsv;

impl StatusCsv {
    /// The names of the columns.
    pub const HEADER: &'static str = "of,row,status,leverage,residual,without,without_leverage,without_residual,\
                                      leverage_exact,residual_exact,without_leverage_exact,without_residual_exact\n";

    /// A reading of the set.
    pub fn row(status: &RowStatus) -> String {
        StatusCsv::line("data", status.row, status.all.as_ref(), status.without.as_ref())
    }

    /// A further reading, which the set stands without.
    pub fn new_row(row: usize, standing: Option<&Standing>) -> String {
        StatusCsv::line("new", row, standing, None)
    }

    fn line(of: &str, row: usize, all: Option<&Standing>, without: Option<&Standing>) -> String {
        let name = |own: Option<&Standing>| own.map_or("", |own| own.status.name());
        let numbers = |own: Option<&Standing>| -> [Option<Rational>; 2] {
            own.map_or([None, None], |own| [own.leverage.clone(), own.residual.clone()])
        };
        let double = |number: &Option<Rational>| {
            number.as_ref().map_or_else(String::new, |number| number.to_f64().to_string())
        };
        let exact = |number: &Option<Rational>| number.as_ref().map_or_else(String::new, ToString::to_string);
        let texts = |own: Option<&Standing>| {
            let numbers = numbers(own);
            [numbers.each_ref().map(double), numbers.each_ref().map(exact)]
        };
        let [doubles, fractions] = texts(all);
        // Few readings decide. To all others both sets are alike, and digits are most of the work.
        let [other_doubles, other_fractions] =
            if all == without { [doubles.clone(), fractions.clone()] } else { texts(without) };
        let mut cells = vec![of.to_owned(), row.to_string(), name(all).to_owned()];
        cells.extend(doubles);
        cells.push(name(without).to_owned());
        cells.extend(other_doubles.into_iter().chain(fractions).chain(other_fractions));
        cells.join(",") + "\n"
    }
}
