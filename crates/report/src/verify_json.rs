//! The verdict on a proof as JSON of schema `boundfit/verify/1`.

use boundfit_exact::{Foreign, Rational};
use boundfit_verify::{About, Extent, Quantity, Statement};
use serde::Serialize;

use crate::json::to_text;
use crate::number::Number;
use crate::style::Style;
use crate::verify::{Verdict, condition};

#[derive(Serialize)]
struct VerifyJson<'a> {
    schema: &'static str,
    verified: bool,
    half_planes: Option<usize>,
    falsehood: Option<String>,
    differences: &'a [String],
    proof: Option<&'a str>,
    data: Option<&'a str>,
    about: AboutJson,
    set: Option<SetJson>,
}

/// Which question the proof answers.
#[derive(Serialize)]
struct AboutJson {
    rows: Vec<[u64; 2]>,
    rows_total: Option<u64>,
    reading: &'static str,
    header: bool,
    delimiter: char,
    phi1: SourceJson,
    phi2: SourceJson,
    y: SourceJson,
    epsilon: SourceJson,
    x_origin: Number,
    interval: Option<IntervalJson>,
    law: Option<LawJson>,
    conditions: Vec<String>,
}

/// A column, from 1, its name in the header, and how many times it is taken; column 0 holds 1 in every row.
#[derive(Serialize)]
struct SourceJson {
    column: u64,
    name: Option<Foreign>,
    times: Number,
}

#[derive(Serialize)]
struct IntervalJson {
    lower: Option<ColumnJson>,
    upper: Option<ColumnJson>,
}

#[derive(Serialize)]
struct ColumnJson {
    column: u64,
    name: Option<Foreign>,
}

#[derive(Serialize)]
struct LawJson {
    above: Vec<TermJson>,
    below: Vec<TermJson>,
}

#[derive(Serialize)]
struct TermJson {
    quantity: &'static str,
    column: u64,
    times: Number,
}

/// What is proved of the set.
#[derive(Serialize)]
struct SetJson {
    extent: &'static str,
    vertices: usize,
    sides: usize,
    ranges: Option<[EndsJson; 2]>,
}

#[derive(Serialize)]
struct EndsJson {
    lower: Option<Number>,
    upper: Option<Number>,
}

/// The verdict as JSON, with a line end: on the proof of these files, which is about this; `None` for standard input.
pub fn verify_json(verdict: &Verdict, about: &About, proof: Option<&str>, data: Option<&str>) -> String {
    let style = Style::default();
    let statement = verdict.found.as_ref().ok();
    let falsehood = verdict.found.as_ref().err().map(ToString::to_string);
    to_text(&VerifyJson {
        schema: "boundfit/verify/1",
        verified: statement.is_some() && verdict.differences.is_empty(),
        half_planes: statement.map(|statement| statement.half_planes),
        falsehood: falsehood.or_else(|| verdict.differences.first().cloned()),
        differences: &verdict.differences,
        proof,
        data,
        about: AboutJson::new(about, statement, &style),
        set: statement.map(|statement| SetJson::new(statement, &style)),
    })
}

impl AboutJson {
    fn new(about: &About, statement: Option<&Statement>, style: &Style) -> Self {
        let name = |column: u64| statement.and_then(|statement| statement.names.get(&column).cloned());
        let source = |(column, times): &(u64, Rational)| SourceJson {
            column: *column,
            name: name(*column),
            times: style.given_number(times),
        };
        let column = |column: Option<u64>| column.map(|column| ColumnJson { column, name: name(column) });
        let term = |(quantity, column, times): &(Quantity, u64, Rational)| TermJson {
            quantity: match quantity {
                Quantity::Number => "number",
                Quantity::Abs => "abs",
                Quantity::Written => "written",
            },
            column: *column,
            times: style.given_number(times),
        };
        let [phi1, phi2, y, epsilon] = about.model.each_ref().map(source);
        AboutJson {
            rows: about.rows.chunks(2).filter_map(|range| range.try_into().ok()).collect(),
            rows_total: statement.map(|statement| statement.rows_total),
            reading: about.reading.name(),
            header: about.header,
            delimiter: about.delimiter,
            phi1,
            phi2,
            y,
            epsilon,
            x_origin: style.given_number(&about.x_origin),
            interval: about
                .interval
                .map(|[lower, upper]| IntervalJson { lower: column(lower), upper: column(upper) }),
            law: about.law.as_ref().map(|[above, below]| LawJson {
                above: above.iter().map(term).collect(),
                below: below.iter().map(term).collect(),
            }),
            conditions: about.conditions.iter().map(condition).collect(),
        }
    }
}

impl SetJson {
    fn new(statement: &Statement, style: &Style) -> Self {
        let ends = |[lower, upper]: &[Option<Rational>; 2]| EndsJson {
            lower: lower.as_ref().map(|lower| style.lower_number(lower)),
            upper: upper.as_ref().map(|upper| style.upper_number(upper)),
        };
        SetJson {
            extent: match statement.extent {
                Extent::Empty => "empty",
                Extent::Bounded => "bounded",
                Extent::Unbounded => "unbounded",
            },
            vertices: statement.vertices,
            sides: statement.sides,
            ranges: statement.bounds.as_ref().map(|bounds| bounds.each_ref().map(ends)),
        }
    }
}
