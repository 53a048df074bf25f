//! The verdict on a proof as JSON of schema `boundfit/verify/1`.

use boundfit_exact::{Foreign, Rational};
use boundfit_verify::{
    About, Claim, ClaimKind, ErrorScale, Extent, Found, Quantity, SetFound, Side, Statement,
};
use serde::Serialize;

use crate::json::to_text;
use crate::number::Number;
use crate::style::Style;
use crate::verify::{Verdict, condition};
use crate::verify_claims::kind;

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
    statements: Option<Vec<ClaimJson>>,
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
    x_error: Option<SourceJson>,
    response: Vec<SourceJson>,
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

/// A statement: its scope, and what is proved of it.
#[derive(Default, Serialize)]
struct ClaimJson {
    kind: &'static str,
    rows: Option<Vec<[u64; 2]>>,
    without: Vec<u64>,
    #[serde(rename = "where")]
    conditions: Option<Vec<u64>>,
    factor: Option<Number>,
    epsilon: Option<Number>,
    side: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    form: Option<[Number; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    range: Option<EndsJson>,
    #[serde(skip_serializing_if = "Option::is_none")]
    point: Option<[Number; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    extent: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    vertices: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    sides: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    least: Option<u64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    sets: Option<Vec<Vec<u64>>>,
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
        set: match statement.map(|statement| &statement.found) {
            Some(Found::Set(set)) => Some(SetJson::new(set, &style)),
            _ => None,
        },
        statements: match statement.map(|statement| &statement.found) {
            Some(Found::Claims(claims)) => {
                Some(claims.iter().map(|claim| ClaimJson::new(claim, &style)).collect())
            }
            _ => None,
        },
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
            x_error: about.x_error.as_ref().map(source),
            response: about.response.iter().map(source).collect(),
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
    fn new(set: &SetFound, style: &Style) -> Self {
        SetJson {
            extent: extent_name(set.extent),
            vertices: set.vertices,
            sides: set.sides,
            ranges: set
                .bounds
                .as_ref()
                .map(|bounds| bounds.each_ref().map(|ends| EndsJson::new(ends, style))),
        }
    }
}

impl EndsJson {
    fn new([lower, upper]: &[Option<Rational>; 2], style: &Style) -> Self {
        EndsJson {
            lower: lower.as_ref().map(|lower| style.lower_number(lower)),
            upper: upper.as_ref().map(|upper| style.upper_number(upper)),
        }
    }
}

fn extent_name(extent: Extent) -> &'static str {
    match extent {
        Extent::Empty => "empty",
        Extent::Bounded => "bounded",
        Extent::Unbounded => "unbounded",
    }
}

impl ClaimJson {
    fn new(Claim { scope, kind: own }: &Claim, style: &Style) -> Self {
        let numbers = |numbers: &[Rational; 2]| numbers.each_ref().map(|number| style.given_number(number));
        let (factor, epsilon) = match &scope.errors {
            ErrorScale::AsStated => (None, None),
            ErrorScale::Times(factor) => (Some(style.given_number(factor)), None),
            ErrorScale::Within(bound) => (None, Some(style.given_number(bound))),
        };
        let mut json = ClaimJson {
            kind: kind(own),
            rows: scope
                .rows
                .as_ref()
                .map(|rows| rows.chunks(2).filter_map(|range| range.try_into().ok()).collect()),
            without: scope.without.iter().copied().collect(),
            conditions: scope.conditions.as_ref().map(|numbers| numbers.iter().copied().collect()),
            factor,
            epsilon,
            side: scope.side.map(|side| match side {
                Side::Rising => "+",
                Side::Falling => "-",
                Side::Strong => "strong",
            }),
            ..ClaimJson::default()
        };
        match own {
            ClaimKind::Form { form, range } => {
                json.form = Some(numbers(form));
                json.range = Some(EndsJson::new(range, style));
            }
            ClaimKind::Point(point) => json.point = Some(numbers(point)),
            ClaimKind::Set { extent, vertices, sides } => {
                json.extent = Some(extent_name(*extent));
                json.vertices = Some(*vertices);
                json.sides = Some(*sides);
            }
            ClaimKind::LeftOut { least, sets } => {
                json.least = Some(*least);
                json.sets =
                    sets.as_ref().map(|sets| sets.iter().map(|set| set.iter().copied().collect()).collect());
            }
            _ => {}
        }
        json
    }
}
