//! The verdict on a proof as JSON of schema `boundfit/verify/1`.

use boundfit_exact::Rational;
use boundfit_verify::{
    About, Claim, ClaimKind, ErrorScale, Extent, Found, Quantity, SetFound, Side, Statement,
};

use crate::answer::parts::RangeJson;
use crate::answer::verify::{
    AboutJson, BoundColumnJson, ColumnTimesJson, LawJson, LawTermJson, ProvedJson, ProvedSetJson, VerifyJson,
};
use crate::json::to_text;
use crate::style::Style;
use crate::verify::{Verdict, condition};
use crate::verify_claims::kind;

/// The verdict as JSON, with a line end: on the proof of these files, which is about this; `None` for standard input.
pub fn verify_json(verdict: &Verdict, about: &About, proof: Option<&str>, data: Option<&str>) -> String {
    let style = Style::default();
    let statement = verdict.found.as_ref().ok();
    let falsehood = verdict.found.as_ref().err().map(ToString::to_string);
    to_text(&VerifyJson {
        schema: VerifyJson::SCHEMA,
        verified: statement.is_some() && verdict.differences.is_empty(),
        half_planes: statement.map(|statement| statement.half_planes),
        falsehood: falsehood.or_else(|| verdict.differences.first().cloned()),
        differences: &verdict.differences,
        proof,
        data,
        about: AboutJson::new(about, statement, &style),
        set: match statement.map(|statement| &statement.found) {
            Some(Found::Set(set)) => Some(ProvedSetJson::new(set, &style)),
            _ => None,
        },
        theorem_rows: match statement.map(|statement| &statement.found) {
            Some(Found::Rows(count)) => Some(*count),
            _ => None,
        },
        statements: match statement.map(|statement| &statement.found) {
            Some(Found::Claims(claims)) => {
                Some(claims.iter().map(|claim| ProvedJson::new(claim, &style)).collect())
            }
            _ => None,
        },
    })
}

impl AboutJson {
    fn new(about: &About, statement: Option<&Statement>, style: &Style) -> Self {
        let name = |column: u64| statement.and_then(|statement| statement.names.get(&column).cloned());
        let source = |(column, times): &(u64, Rational)| ColumnTimesJson {
            column: *column,
            name: name(*column),
            times: style.given_number(times),
        };
        let column =
            |column: Option<u64>| column.map(|column| BoundColumnJson { column, name: name(column) });
        let term = |(quantity, column, times): &(Quantity, u64, Rational)| LawTermJson {
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
                .map(|[lower, upper]| RangeJson { lower: column(lower), upper: column(upper) }),
            law: about.law.as_ref().map(|[above, below]| LawJson {
                above: above.iter().map(term).collect(),
                below: below.iter().map(term).collect(),
            }),
            conditions: about.conditions.iter().map(condition).collect(),
        }
    }
}

impl ProvedSetJson {
    fn new(set: &SetFound, style: &Style) -> Self {
        ProvedSetJson {
            extent: extent_name(set.extent),
            vertices: set.vertices,
            sides: set.sides,
            ranges: set.bounds.as_ref().map(|bounds| bounds.each_ref().map(|ends| range(ends, style))),
        }
    }
}

fn range([lower, upper]: &[Option<Rational>; 2], style: &Style) -> RangeJson {
    RangeJson {
        lower: lower.as_ref().map(|lower| style.lower_number(lower)),
        upper: upper.as_ref().map(|upper| style.upper_number(upper)),
    }
}

fn extent_name(extent: Extent) -> &'static str {
    match extent {
        Extent::Empty => "empty",
        Extent::Bounded => "bounded",
        Extent::Unbounded => "unbounded",
    }
}

impl ProvedJson {
    fn new(Claim { scope, kind: own }: &Claim, style: &Style) -> Self {
        let numbers = |numbers: &[Rational; 2]| numbers.each_ref().map(|number| style.given_number(number));
        let (factor, epsilon) = match &scope.errors {
            ErrorScale::AsStated => (None, None),
            ErrorScale::Times(factor) => (Some(style.given_number(factor)), None),
            ErrorScale::Within(bound) => (None, Some(style.given_number(bound))),
        };
        let mut json = ProvedJson {
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
            ..ProvedJson::default()
        };
        match own {
            ClaimKind::Form { form, range: ends } => {
                json.form = Some(numbers(form));
                json.range = Some(range(ends, style));
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
