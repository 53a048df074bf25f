//! The linear range as CSV.

use boundfit_exact::Rational;
use boundfit_questions::{Contradiction, Run};

use super::{RangeReport, names};

/// Writes one row for each run, in order.
/// - Positions from 1, readings, rows of the file, exact x.
/// - Marks of the longest run, and of the runs that are one of the fewest.
/// - The bounds that stand against one more reading before and after it.
pub fn range_csv(report: &RangeReport<'_>) -> String {
    let mut text =
        "first,last,readings,first_row,last_row,x_least,x_largest,longest,fewest,before,after\n".to_owned();
    let longest = report.range.longest();
    let fewest = report.range.fewest();
    let mut chosen = fewest.into_iter().peekable();
    for run in &report.range.runs {
        let is_chosen = chosen.next_if(|next| *next == run).is_some();
        let [least, most] = match report.reach(run) {
            Some(ends) => ends.each_ref().map(exact),
            None => [String::new(), String::new()],
        };
        let (first_row, last_row) = (report.row(run.first), report.row(run.last));
        let Run { first, last, before, after } = run;
        let [before, after] = [before, after].map(|why| quoted(why.as_ref()));
        let is_longest = longest == Some(run);
        text += &format!(
            "{},{},{},{first_row},{last_row},{least},{most},{is_longest},{is_chosen},{before},{after}\n",
            first + 1,
            last + 1,
            run.len(),
        );
    }
    text
}

/// The names of bounds, which commas separate.
fn quoted(contradiction: Option<&Contradiction>) -> String {
    contradiction.map_or_else(String::new, |contradiction| format!("\"{}\"", names(contradiction)))
}

/// All digits, or the fraction where they do not end.
pub(crate) fn exact(value: &Rational) -> String {
    const DIGITS: usize = 40;
    value.exact_decimal(DIGITS).map_or_else(|| value.to_string(), |decimal| decimal.compact().to_string())
}
