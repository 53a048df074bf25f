//! The truth of a proof, as the engine sees it.

use std::collections::BTreeSet;
use std::fmt::Write;
use std::io::Cursor;

use boundfit_estimation::{Fit, fit};
use boundfit_exact::{Limits, Rational, Reading};
use boundfit_formats::{
    AskedDialect, ColumnSelector, CommentMark, Header, RowRange, RowSet, Source, TableOptions, read_table,
};
use boundfit_geometry::{Inequality, Polyhedron, Region, System};
use boundfit_report::proof_json;
use serde_json::{Value, json};

use super::{Question, sha256};

/// Returns whether every statement of a proof of the right shape is true: the same question is asked again.
pub fn is_true(proof: &Value, data: &[u8]) -> bool {
    let Some(question) = question(proof, data) else { return false };
    let Ok(problem) = question.problem() else { return false };
    let fit = fit(&problem).with_every_half_plane(&problem);
    let truth = proof_json(&problem, &fit, question.options.reading).expect("text");
    let truth: Value = serde_json::from_str(&truth).expect("JSON");
    proof["sha256"] == sha256(data)
        && vertices(proof) == vertices(&truth)
        && active(proof) == active(&truth)
        && bounds_are_true(proof, &truth, &fit)
        && sides_are_true(proof, &fit)
}

/// Returns what a proof is about, with its model computed: the columns φ1, φ2, y and ε as they are after the reading.
fn question(proof: &Value, data: &[u8]) -> Option<Question> {
    let ends = proof["rows"].as_array()?.iter().map(|end| usize::try_from(end.as_u64()?).ok());
    let ends: Vec<usize> = ends.collect::<Option<_>>()?;
    let ranges = ends.chunks(2).map(|range| RowRange::new(range[0], *range.get(1)?));
    let ranges: Vec<RowRange> = ranges.collect::<Option<_>>()?;
    // Every range ends before the next one begins.
    let is_ascending = ends.get(1..)?.chunks_exact(2).all(|gap| gap[0] < gap[1]);
    let rows = RowSet::new(&ranges, &[]).filter(|_| is_ascending)?;
    let options = TableOptions {
        header: if proof["header"] == json!(true) { Header::Present } else { Header::Absent },
        dialect: AskedDialect {
            delimiter: proof["delimiter"].as_str().map(|text| text.as_bytes()[0]),
            comment: CommentMark::None,
            ..AskedDialect::default()
        },
        rows: rows.clone(),
        reading: if proof["reading"] == "binary64" { Reading::Binary64 } else { Reading::Decimal },
        ..TableOptions::default()
    };
    let sources =
        proof["model"].as_array()?.iter().map(|source| Some((source[0].as_u64()?, number(&source[1]))));
    let sources: Vec<(u64, Rational)> = sources.collect::<Option<_>>()?;
    let mut columns: Vec<u64> =
        sources.iter().map(|(column, _)| *column).filter(|&column| column > 0).collect();
    columns.sort_unstable();
    columns.dedup();
    let selectors: Vec<_> =
        columns.iter().map(|&column| ColumnSelector::name_or_number(&column.to_string())).collect();
    let table = read_table(Source::new("data", Cursor::new(data.to_vec())), &selectors, &options).ok()?;
    // Rows keep their numbers: those that are not wanted are there, and not read.
    let mut text = "p,q,y,e\n".to_owned();
    let mut before = 0;
    for row in &table.rows {
        text.push_str(&"0,0,0,0\n".repeat(row.row - before - 1));
        before = row.row;
        let cells = sources.iter().map(|(column, factor)| {
            match columns.binary_search(column) {
                Ok(index) => &row.numbers[index] * factor,
                Err(_) => factor.clone(),
            }
            .to_string()
        });
        let _ = writeln!(text, "{}", cells.collect::<Vec<_>>().join(","));
    }
    let question = Question::line("again", text.as_bytes(), ["p", "y"], "0").regressors(["p", "q"]);
    let conditions = proof["conditions"].as_array()?.iter().map(condition).collect();
    let question = question.epsilon_column("e");
    let options = TableOptions { rows, ..question.options };
    Some(Question { conditions, options, ..question })
}

fn condition(condition: &Value) -> String {
    let [a1, a2, b] = [0, 1, 2].map(|part| number(&condition[part]));
    let sign = if a2.is_negative() { "-" } else { "+" };
    let relation = if condition[3] == "=" { "=" } else { "<=" };
    format!("{a1}*theta1 {sign} {}*theta2 {relation} {b}", a2.abs())
}

fn number(value: &Value) -> Rational {
    Reading::Decimal.read(value.as_str().expect("a text"), &Limits::default()).expect("a number")
}

fn pair(value: &Value) -> [Rational; 2] {
    [0, 1].map(|part| number(&value[part]))
}

/// The vertices in their order.
fn vertices(proof: &Value) -> Vec<[Rational; 2]> {
    proof["vertices"].as_array().expect("a list").iter().map(pair).collect()
}

/// Returns what is active at which vertex.
fn active(proof: &Value) -> BTreeSet<String> {
    proof["active"].as_array().expect("a list").iter().map(Value::to_string).collect()
}

fn named<'a>(fit: &'a Fit, name: &Value) -> Option<&'a Inequality> {
    let text = name.as_str()?;
    let index = fit.fps.names().iter().position(|name| name.to_string() == text)?;
    fit.fps.polyhedron().system().inequalities().get(index)
}

/// The sum of the multiples that a list of terms takes.
fn sum(terms: &Value, fit: &Fit) -> Option<([Rational; 2], Rational)> {
    let mut sum = ([Rational::zero(), Rational::zero()], Rational::zero());
    for term in terms.as_array()? {
        let (inequality, times) = (named(fit, &term[0])?, number(&term[1]));
        if !times.is_positive() {
            return None;
        }
        sum.0 = [0, 1].map(|part| &sum.0[part] + &inequality.a[part] * &times);
        sum.1 = sum.1 + &inequality.b * &times;
    }
    Some(sum)
}

fn bounds_are_true(proof: &Value, truth: &Value, fit: &Fit) -> bool {
    let [bounds, true_bounds] = [proof, truth].map(|proof| proof["bounds"].as_array().expect("a list"));
    if fit.pui.is_none() {
        let is_contradiction =
            |(a, b): ([Rational; 2], Rational)| a.iter().all(Rational::is_zero) && b.is_negative();
        return bounds.is_empty() && sum(&proof["farkas"], fit).is_some_and(is_contradiction);
    }
    let polyhedron = fit.fps.polyhedron();
    let is_true = |(index, (bound, truth)): (usize, (&Value, &Value))| {
        let is_finite = bound[0] != json!([]);
        let (point, ray, true_point) = (pair(&bound[1]), pair(&bound[2]), pair(&truth[1]));
        let sign = Rational::from(if index % 2 == 0 { -1 } else { 1 });
        let form =
            if index < 2 { [sign.clone(), Rational::zero()] } else { [Rational::zero(), sign.clone()] };
        let along = |ray: &[Rational; 2]| &form[0] * &ray[0] + &form[1] * &ray[1];
        let stays = |row: &Inequality| !(&row.a[0] * &ray[0] + &row.a[1] * &ray[1]).is_positive();
        let is_proved = if is_finite {
            point[index / 2] == true_point[index / 2]
                && ray.iter().all(Rational::is_zero)
                && sum(&bound[0], fit) == Some((form.clone(), along(&point)))
        } else {
            polyhedron.system().inequalities().iter().all(stays) && along(&ray).is_positive()
        };
        is_finite == (truth[0] != json!([])) && polyhedron.membership(&point).is_inside() && is_proved
    };
    bounds.len() == 4
        && bounds.iter().zip(true_bounds).enumerate().all(is_true)
        && proof["farkas"] == json!([])
}

/// Returns whether the sides are half-planes of the set that make it, each with the vertex where the next one begins.
fn sides_are_true(proof: &Value, fit: &Fit) -> bool {
    let sides = proof["sides"].as_array().expect("a list");
    if fit.pui.is_none() {
        return sides.is_empty();
    }
    let Some(own): Option<Vec<&Inequality>> = sides.iter().map(|side| named(fit, &side[0])).collect() else {
        return false;
    };
    let system: System = own.iter().map(|&side| side.clone()).collect();
    let of_sides = Polyhedron::intersect(system);
    let (region, whole) = (of_sides.region(), fit.fps.polyhedron().region());
    let points = |region: &Region| -> Vec<_> {
        region.vertices().iter().map(|vertex| vertex.point().coordinates()).collect()
    };
    let corner = |(index, side): (usize, &Value)| {
        let (this, next) = (own[index], own[(index + 1) % own.len()]);
        let turn = &this.a[0] * &next.a[1] - &this.a[1] * &next.a[0];
        match side[1].as_u64() {
            None => !turn.is_positive(),
            Some(vertex) => {
                let theta = pair(&proof["vertices"][vertex as usize]);
                turn.is_positive() && this.slack(&theta).is_zero() && next.slack(&theta).is_zero()
            }
        }
    };
    region.kind() == whole.kind()
        && points(region) == points(whole)
        && region.rays() == whole.rays()
        && region.lines() == whole.lines()
        && sides.iter().enumerate().all(corner)
}
