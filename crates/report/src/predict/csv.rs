//! Predictions as CSV.

use std::io::{self, Write};

use boundfit_exact::{Interval, Rational};
use boundfit_questions::PossibleEnd;
use csv::Writer;

use super::Prediction;
use crate::fit_csv::shown;

/// Writes predictions as a table. Values asked for have a row each, with the interval of the line and the interval of
/// a further reading. Readings have a row for each interval of x that they may come from, or one row without ends and
/// with `none`. Ends are doubles rounded outward, `-inf` and `inf` where there are none; the last columns are exact.
/// An empty set has the header only.
///
/// # Errors
/// Errors of the writer.
pub fn write_prediction_csv(prediction: &Prediction, to: &mut dyn Write) -> io::Result<()> {
    let mut table = Writer::from_writer(to);
    match prediction.at.count {
        0 => sources(prediction, &mut table)?,
        _ => values(prediction, &mut table)?,
    }
    table.flush()
}

type Table<'a> = Writer<&'a mut dyn Write>;

fn values(prediction: &Prediction, table: &mut Table) -> io::Result<()> {
    let names: &[&str] = if prediction.is_line() { &["x"] } else { &["x1", "x2"] };
    let what = if prediction.is_line() { "line" } else { "model" };
    let ends =
        [format!("{what}_lower"), format!("{what}_upper"), "reading_lower".into(), "reading_upper".into()];
    let own = || names.iter().map(|name| (*name).to_owned()).chain(ends.iter().cloned());
    table.write_record(own().chain(own().map(|name| name + "_exact")))?;
    let Some(predictor) = prediction.predictor() else { return Ok(()) };
    for value in (prediction.at.values)() {
        let (line, reading) = prediction.at(&predictor, &prediction.form(&value));
        let value = value.get(..names.len()).unwrap_or_default();
        let doubles = value.iter().map(|value| shown(value.to_f64()));
        let [lower, upper] = doubles_of(&line);
        let [from, to] = reading.as_ref().map_or_else(Default::default, doubles_of);
        let exact = value.iter().map(Rational::to_string);
        let [exact_lower, exact_upper] = exact_of(&line);
        let [exact_from, exact_to] = reading.as_ref().map_or_else(Default::default, exact_of);
        let cells = doubles.chain([lower, upper, from, to]);
        table.write_record(cells.chain(exact).chain([exact_lower, exact_upper, exact_from, exact_to]))?;
    }
    Ok(())
}

fn sources(prediction: &Prediction, table: &mut Table) -> io::Result<()> {
    table.write_record([
        "y",
        "x_lower",
        "x_upper",
        "lower_end",
        "upper_end",
        "y_exact",
        "x_lower_exact",
        "x_upper_exact",
    ])?;
    let Some(predictor) = prediction.predictor() else { return Ok(()) };
    let of = prediction.sources(&predictor);
    for [y, _] in (prediction.from.values)() {
        let found = of(&y);
        let (double, exact) = (shown(y.to_f64()), y.to_string());
        if found.is_empty() {
            table.write_record([double.as_str(), "", "", "none", "none", exact.as_str(), "", ""])?;
        }
        for own in found {
            let double_of = |end: &Option<PossibleEnd>, of: fn(&Rational) -> f64, none: &str| {
                end.as_ref().map_or_else(|| none.to_owned(), |end| shown(of(&end.x)))
            };
            let exact_of =
                |end: &Option<PossibleEnd>| end.as_ref().map_or_else(String::new, |end| end.x.to_string());
            let (lower, upper) = (&own.lower, &own.upper);
            table.write_record([
                double.clone(),
                double_of(lower, Rational::floor_to_f64, "-inf"),
                double_of(upper, Rational::ceil_to_f64, "inf"),
                kind(lower).to_owned(),
                kind(upper).to_owned(),
                exact.clone(),
                exact_of(lower),
                exact_of(upper),
            ])?;
        }
    }
    Ok(())
}

/// Returns whether an end belongs to its interval.
fn kind(end: &Option<PossibleEnd>) -> &'static str {
    match end {
        None => "unbounded",
        Some(end) if end.included => "included",
        Some(_) => "excluded",
    }
}

fn doubles_of(interval: &Interval) -> [String; 2] {
    let lower = interval.lower().value().map_or_else(|| "-inf".to_owned(), |end| shown(end.floor_to_f64()));
    let upper = interval.upper().value().map_or_else(|| "inf".to_owned(), |end| shown(end.ceil_to_f64()));
    [lower, upper]
}

fn exact_of(interval: &Interval) -> [String; 2] {
    [interval.lower(), interval.upper()].map(|end| end.value().map_or_else(String::new, Rational::to_string))
}
