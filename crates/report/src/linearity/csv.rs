//! The linearity of a calibration as CSV.

use boundfit_exact::Rational;
use boundfit_questions::Linearity;
use csv::Writer;

use super::{METHODS, lines};

const COLUMNS: [&str; 11] = [
    "characteristic",
    "method",
    "deviation",
    "percent",
    "slope",
    "intercept",
    "deviation_exact",
    "percent_exact",
    "slope_exact",
    "intercept_exact",
    "rows",
];

/// The linearity as a table: a row for each method of each characteristic (`average`, `up`, `down`), then `hysteresis` and
/// `repeatability` where they are known. Deviations and percentages are doubles rounded up, slopes and intercepts doubles to nearest.
/// The same numbers follow exactly, and the data rows, with blanks between, where the value is reached.
pub fn linearity_csv(linearity: &Linearity) -> String {
    let mut writer = Writer::from_writer(Vec::new());
    let mut row = |cells: [String; 11]| {
        // Writing to memory does not fail.
        let written = writer.write_record(&cells);
        debug_assert!(written.is_ok());
    };
    row(COLUMNS.map(str::to_owned));
    let parts = [
        ("average", Some(&linearity.average)),
        ("up", linearity.up.as_ref()),
        ("down", linearity.down.as_ref()),
    ];
    for (name, characteristic) in parts {
        let Some(characteristic) = characteristic else { continue };
        for ((method, _), line) in METHODS.iter().zip(lines(characteristic)) {
            let Ok(line) = line else { continue };
            let [slope, intercept] = line.theta.each_ref().map(Some);
            let numbers = [Some(&line.deviation), line.percent.as_ref(), slope, intercept];
            row(cells(name, method, numbers, &line.rows(characteristic)));
        }
    }
    let differences = [("hysteresis", &linearity.hysteresis), ("repeatability", &linearity.repeatability)];
    for (method, difference) in differences {
        let Some(difference) = difference else { continue };
        let percent = (&difference.value * Rational::from(100)).checked_div(&linearity.average.full_scale);
        let mut rows: Vec<usize> =
            difference.at.iter().flat_map(|point| point.rows.rows()).map(|row| row as usize).collect();
        rows.sort_unstable();
        rows.dedup();
        row(cells("", method, [Some(&difference.value), percent.as_ref(), None, None], &rows));
    }
    String::from_utf8(writer.into_inner().unwrap_or_default()).unwrap_or_default()
}

/// A row of the table.
fn cells(name: &str, method: &str, numbers: [Option<&Rational>; 4], rows: &[usize]) -> [String; 11] {
    let double = |number: Option<f64>| number.map_or_else(String::new, |number| format!("{number:?}"));
    let exact = |number: Option<&Rational>| number.map_or_else(String::new, ToString::to_string);
    let rows: Vec<String> = rows.iter().map(ToString::to_string).collect();
    let [deviation, percent, slope, intercept] = numbers;
    let [a, b] = [deviation, percent].map(|number| double(number.map(Rational::ceil_to_f64)));
    let [c, d] = [slope, intercept].map(|number| double(number.map(Rational::to_f64)));
    let [e, f, g, h] = numbers.map(exact);
    [name.to_owned(), method.replace(['-', ' '], "_"), a, b, c, d, e, f, g, h, rows.join(" ")]
}
