//! The verdict on a proof, as text and as JSON of schema `boundfit/verify/1`.

use boundfit_exact::english::{counted, listed};
use boundfit_exact::{Endpoint, Interval};
use boundfit_verify::{Extent, Falsehood, Statement};
use serde::Serialize;

use crate::json::to_text;
use crate::style::Style;

/// What a checker found: what the proof states, all of it true, or the first statement that is false.
type Verdict = Result<Statement, Falsehood>;

#[derive(Serialize)]
struct VerifyJson {
    schema: &'static str,
    verified: bool,
    half_planes: Option<usize>,
    falsehood: Option<String>,
}

/// The verdict as JSON, with a line end.
pub fn verify_json(verdict: &Verdict) -> String {
    to_text(&VerifyJson {
        schema: "boundfit/verify/1",
        verified: verdict.is_ok(),
        half_planes: verdict.as_ref().ok().map(|statement| statement.half_planes),
        falsehood: verdict.as_ref().err().map(ToString::to_string),
    })
}

/// The verdict on the proof and the data of these names, and what a true proof states.
pub fn verify_text(verdict: &Verdict, proof: &str, data: &str) -> String {
    let statement = match verdict {
        Ok(statement) => statement,
        Err(falsehood) => return format!("refuted: {proof} is not true of {data}\n  {falsehood}\n"),
    };
    let Statement { extent, vertices, sides, half_planes, rows, bounds } = statement;
    let parts =
        || format!("{} and {}", counted(*vertices, "vertex", "vertices"), counted(*sides, "side", "sides"));
    let set = match extent {
        Extent::Empty => "empty".to_owned(),
        Extent::Bounded => format!("bounded, with {}", parts()),
        Extent::Unbounded => format!("unbounded, with {}", parts()),
    };
    let style = Style::default();
    let mut text = format!(
        "verified: {proof} is true of {data}\n  set     {set}\n  from    {half_planes} half-planes, {}\n",
        rows_read(rows)
    );
    for (parameter, [lower, upper]) in (1..).zip(bounds.iter().flatten()) {
        let ends = [lower, upper].map(|end| Endpoint::from(end.clone()));
        let [lower, upper] = ends;
        // What is verified is in order.
        let interval = Interval::new(lower, upper).map(|range| style.resolving(&range).interval(&range));
        text.push_str(&format!("  theta{parameter}  {}\n", interval.unwrap_or_default()));
    }
    text
}

/// `rows 14 to 36`, `rows 1 to 22 and 24`; of many ranges, how many there are.
fn rows_read(rows: &[usize]) -> String {
    let range = |range: &[usize]| match range {
        [first, last] if first < last => format!("{first} to {last}"),
        range => range.first().map_or_else(String::new, usize::to_string),
    };
    let ranges: Vec<String> = rows.chunks(2).map(range).collect();
    match ranges.as_slice() {
        [only] if !only.contains(' ') => format!("row {only}"),
        ranges => format!("rows {}", listed(ranges)),
    }
}
