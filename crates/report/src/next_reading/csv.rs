//! The next reading as CSV.

use boundfit_exact::Rational;
use boundfit_questions::Best;

use super::{NextReadingReport, is_short};
use crate::fit_csv::shown;
use crate::range::exact;
use crate::style::Style;

/// Writes a row for each goal.
/// - The value before the reading and after the worst outcome, as doubles rounded up, `inf` where nothing bounds it.
/// - The best x, separated by blanks.
/// - Both values as fractions, if they are not too long.
///
/// An empty set has the header only.
pub fn next_reading_csv(report: &NextReadingReport<'_>) -> String {
    let mut text = "goal,now,worst,at,now_exact,worst_exact\n".to_owned();
    let double = |value: &Option<Rational>| {
        value.as_ref().map_or_else(|| "inf".to_owned(), |value| shown(value.ceil_to_f64()))
    };
    let style = Style::default();
    let own = |value: &Option<Rational>| {
        value.as_ref().filter(|value| is_short(value, &style)).map(Rational::to_string).unwrap_or_default()
    };
    for Best { goal, now, worst, at } in report.next.iter().flat_map(|next| &next.best) {
        let at: Vec<String> = at.iter().map(exact).collect();
        text += &format!(
            "{},{},{},{},{},{}\n",
            goal.name(),
            double(now),
            double(worst),
            at.join(" "),
            own(now),
            own(worst),
        );
    }
    text
}
