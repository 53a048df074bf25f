//! The verdict on a proof as text: what was verified, and of which question it is the answer.

use std::fmt::Display;

use boundfit_exact::english::counted;
use boundfit_exact::{Foreign, Rational, Reading};
use boundfit_verify::{About, Extent, Falsehood, Found, Quantity, SetFound, Statement};

use crate::style::Style;
use crate::verify_claims::{extent, form_text, of_claims, range, rows};

/// The report about a proof.
#[derive(Debug)]
pub struct Verdict {
    /// The verdict of a checker: the statements of the proof, all true, or the first one that is false.
    pub found: Result<Statement, Falsehood>,
    /// The differences between the question that it answers and the question that was asked, a sentence for each.
    pub differences: Vec<String>,
}

/// The number of conditions that are listed.
const MOST_CONDITIONS: usize = 20;

/// The verdict on the proof and the data of these names; of a true proof also which question it answers, and what it states.
pub fn verify_text(verdict: &Verdict, proof: &str, data: &str) -> String {
    let (proof, data) = (Foreign::of(proof), Foreign::of(data));
    let statement = match &verdict.found {
        Ok(statement) => statement,
        Err(falsehood) => return format!("refuted: {proof} is not true of {data}\n  {falsehood}\n"),
    };
    if !verdict.differences.is_empty() {
        let differences = verdict.differences.iter().map(|sentence| format!("  {sentence}\n"));
        return format!(
            "refuted: {proof} is not true of {data} as asked\n{}",
            differences.collect::<String>()
        );
    }
    let mut lines = question(statement);
    lines.push(("from", counted(statement.half_planes, "half-plane", "half-planes")));
    lines.extend(match &statement.found {
        Found::Set(set) => of_set(set),
        Found::Claims(claims) => of_claims(claims),
        Found::Rows(count) => of_rows(*count),
    });
    let lines = lines.into_iter().map(|(label, line)| format!("  {label:<7} {line}\n"));
    let verdict = match &statement.found {
        Found::Rows(_) => format!("verified: {proof} is about {data}"),
        Found::Set(_) | Found::Claims(_) => format!("verified: {proof} is true of {data}"),
    };
    format!("{verdict}\n{}", lines.collect::<String>())
}

/// The proved facts about a set, as lines with labels.
fn of_set(set: &SetFound) -> Vec<(&'static str, String)> {
    let mut lines =
        vec![("proved", proved(set.extent).to_owned()), ("set", extent(set.extent, set.vertices, set.sides))];
    for (name, ends) in ["theta1", "theta2"].into_iter().zip(set.bounds.iter().flatten()) {
        lines.push((name, range(ends)));
    }
    lines
}

/// Returns what is known of a theorem.
fn of_rows(count: usize) -> Vec<(&'static str, String)> {
    let rows = counted(count, "row", "rows");
    vec![
        ("agrees", format!("{rows} and all conditions of the theorem, exactly")),
        ("", "only coqc checks what the theorem concludes".to_owned()),
    ]
}

/// The facts that the checks have shown.
fn proved(extent: Extent) -> &'static str {
    match extent {
        Extent::Empty => "no parameters agree with all of these rows and conditions",
        Extent::Bounded | Extent::Unbounded => "the set, the active bounds of each vertex, both intervals",
    }
}

/// The question that a proof answers, as lines with labels.
fn question(Statement { about, names, rows_total, .. }: &Statement) -> Vec<(&'static str, String)> {
    let named = |column: u64| match names.get(&column) {
        Some(name) => format!("column {column} ({})", name.borrowed().quoted()),
        None => format!("column {column}"),
    };
    let (form, regressors) = form(about, &named);
    let mut lines = Vec::new();
    match (&about.interval, &about.law) {
        (Some([lower, upper]), _) => {
            lines.push(("model", format!("lower <= {form} <= upper")));
            lines.extend(regressors);
            let side = |side: &Option<u64>| side.map_or_else(|| "none".to_owned(), named);
            lines.extend([("lower", side(lower)), ("upper", side(upper))]);
        }
        (None, None) => {
            lines.push(("model", format!("y = {form} + e")));
            lines.extend(regressors);
            lines.push(("y", response(about, &named)));
            lines.push(("error", format!("|e| <= {}", source(&about.model[3], &named))));
        }
        (None, Some([above, below])) => {
            lines.push(("model", format!("y - below <= {form} <= y + above")));
            lines.extend(regressors);
            lines.push(("y", response(about, &named)));
            lines.extend([("above", law(about, above)), ("below", law(about, below))]);
        }
    }
    if let Some(own) = &about.x_error {
        lines.push(("x error", format!("up to {}", source(own, &named))));
    }
    lines.extend(about.conditions.iter().take(MOST_CONDITIONS).map(|own| ("where", condition(own))));
    if let Some(more @ 1..) = about.conditions.len().checked_sub(MOST_CONDITIONS) {
        lines.push(("where", format!("and {more} more")));
    }
    lines.push(("rows", format!("{} of {rows_total}", rows(&about.rows))));
    lines.push(("read", reading(about)));
    lines
}

/// The sum that y is compared with, and what stands for its regressors.
fn form(about: &About, named: &impl Fn(u64) -> String) -> (String, Vec<(&'static str, String)>) {
    let [phi1, phi2, ..] = &about.model;
    let (one, is_line) = (Rational::one(), phi2.0 == 0);
    let mut first = source(phi1, named);
    if !about.x_origin.is_zero() {
        let origin = Style::default().given(&about.x_origin);
        first = match phi1 {
            (column, times) if *times == one => format!("{}, less {origin}", named(*column)),
            (column, times) => format!("{times} times the number in {} less {origin}", named(*column)),
        };
    }
    match (is_line, &phi2.1) {
        (true, times) if *times == one => ("theta1*x + theta2".to_owned(), vec![("x", first)]),
        (true, times) if times.is_zero() => ("theta1*x".to_owned(), vec![("x", first)]),
        (true, times) => (format!("theta1*x + {times}*theta2"), vec![("x", first)]),
        (false, _) => ("theta1*u + theta2*v".to_owned(), vec![("u", first), ("v", source(phi2, named))]),
    }
}

/// y: the sum of its columns.
fn response(about: &About, named: &impl Fn(u64) -> String) -> String {
    let terms = [&about.model[2]].into_iter().chain(&about.response).filter(|(_, times)| !times.is_zero());
    let terms: Vec<String> = terms.map(|own| source(own, named)).collect();
    if terms.is_empty() { source(&about.model[2], named) } else { terms.join(" + ") }
}

/// A number of each row: a column, so many times; or the same number in all of them.
fn source((column, times): &(u64, Rational), named: &impl Fn(u64) -> String) -> String {
    match column {
        0 => format!("{} in every row", exactly(times)),
        column if *times == Rational::one() => named(*column),
        column => format!("{times} times {}", named(*column)),
    }
}

/// A number with its decimal beside it where that is another text.
fn exactly(number: &Rational) -> String {
    let (exact, given) = (number.to_string(), Style::default().given(number).to_string());
    if exact == given { exact } else { format!("{exact} ({given})") }
}

fn law(about: &About, terms: &[(Quantity, u64, Rational)]) -> String {
    let (column, times) = &about.model[3];
    let constant = (Quantity::Number, *column, times.clone());
    let terms = [constant].into_iter().chain(terms.iter().cloned()).filter(|(.., times)| !times.is_zero());
    let term = |(quantity, column, times): (Quantity, u64, Rational)| match (quantity, column) {
        (Quantity::Number | Quantity::Abs, 0) => times.to_string(),
        (Quantity::Number, column) => format!("{times}*column {column}"),
        (Quantity::Abs, column) => format!("{times}*|column {column}|"),
        (Quantity::Written, column) => format!("{times}*half a unit of the last digit in column {column}"),
    };
    let terms: Vec<String> = terms.map(term).collect();
    if terms.is_empty() { "0".to_owned() } else { terms.join(" + ") }
}

/// `2*theta1 - theta2 <= 1/3`, or with `=`.
pub fn condition(([a1, a2, b], is_equation): &([Rational; 3], bool)) -> String {
    let relation = if *is_equation { "=" } else { "<=" };
    format!("{} {relation} {b}", form_text(&[a1.clone(), a2.clone()]))
}

fn reading(about: &About) -> String {
    let numbers = match about.reading {
        Reading::Decimal => "numbers as written (decimal)",
        Reading::Binary64 => "nearest doubles (binary64)",
    };
    let header = if about.header { "a header" } else { "no header" };
    format!("{numbers}, {} between cells, {header}", delimiter(about.delimiter))
}

/// The separator of cells, in a word.
pub(crate) fn delimiter(delimiter: char) -> impl Display {
    match delimiter {
        ';' => "semicolons",
        '\t' => "tabs",
        '|' => "bars",
        _ => "commas",
    }
}
