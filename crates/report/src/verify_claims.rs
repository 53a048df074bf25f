//! The statements of a proof, in words.

use boundfit_exact::english::counted;
use boundfit_exact::{Endpoint, Interval, Rational};
use boundfit_verify::{Claim, ClaimKind, ErrorScale, Extent, Scope, Side};

use crate::style::Style;

/// The number of ranges of rows that are listed.
const MOST_RANGES: usize = 6;
/// The number of statements that are written in full.
const MOST_CLAIMS: usize = 12;
/// The number of rows of one statement.
const MOST_ROWS: usize = 6;

/// Returns the numbers of proved statements by kind, and the content of the first ones.
pub(crate) fn of_claims(claims: &[Claim]) -> Vec<(&'static str, String)> {
    let mut counts: Vec<((&'static str, &'static str), usize)> = Vec::new();
    for claim in claims {
        let words = words(&claim.kind);
        match counts.iter_mut().find(|(known, _)| *known == words) {
            Some((_, count)) => *count += 1,
            None => counts.push((words, 1)),
        }
    }
    let counts: Vec<String> =
        counts.into_iter().map(|((one, many), count)| counted(count, one, many)).collect();
    let counts = if counts.is_empty() { "nothing".to_owned() } else { counts.join(", ") };
    let mut lines = vec![("proved", counts)];
    for claim in claims.iter().take(MOST_CLAIMS) {
        let (label, text) = said(claim);
        lines.push((label, text + &scope(&claim.scope)));
    }
    if let Some(more @ 1..) = claims.len().checked_sub(MOST_CLAIMS) {
        lines.push(("", format!("and {more} more")));
    }
    lines
}

/// The name of a kind.
pub(crate) fn kind(kind: &ClaimKind) -> &'static str {
    match kind {
        ClaimKind::Form { .. } => "form",
        ClaimKind::Point(_) => "point",
        ClaimKind::Empty => "empty",
        ClaimKind::Least => "least",
        ClaimKind::Set { .. } => "set",
        ClaimKind::LeftOut { .. } => "left out",
        _ => "another",
    }
}

fn words(kind: &ClaimKind) -> (&'static str, &'static str) {
    match kind {
        ClaimKind::Form { .. } => ("range of a form", "ranges of forms"),
        ClaimKind::Point(_) => ("point", "points"),
        ClaimKind::Empty => ("contradiction", "contradictions"),
        ClaimKind::Least => ("least error bound", "least error bounds"),
        ClaimKind::Set { .. } => ("set", "sets"),
        ClaimKind::LeftOut { .. } => ("number of rows to leave out", "numbers of rows to leave out"),
        _ => ("other statement", "other statements"),
    }
}

/// A label, and what a statement says.
fn said(Claim { scope, kind }: &Claim) -> (&'static str, String) {
    match kind {
        ClaimKind::Form { form, range: ends } => ("range", format!("{} in {}", form_text(form), range(ends))),
        ClaimKind::Point([theta1, theta2]) => {
            ("point", format!("theta1 = {}, theta2 = {} agree", given(theta1), given(theta2)))
        }
        ClaimKind::Empty => ("empty", "no parameters agree".to_owned()),
        ClaimKind::Least => match &scope.errors {
            ErrorScale::Within(bound) => ("least", format!("the least error bound is {}", given(bound))),
            ErrorScale::Times(factor) => ("least", format!("the least factor is {}", given(factor))),
            ErrorScale::AsStated => ("least", String::new()),
        },
        ClaimKind::Set { extent: own, vertices, sides } => {
            ("set", format!("just this: {}", extent(*own, *vertices, *sides)))
        }
        ClaimKind::LeftOut { least, sets } => {
            let least = usize::try_from(*least).unwrap_or(usize::MAX);
            let sets = sets.as_ref().map(|sets| match sets.len() {
                0 => ", which are not enough".to_owned(),
                count => format!(", one of {}", counted(count, "set", "sets")),
            });
            let rows = counted(least, "row", "rows");
            ("leave", format!("at least {rows} out{}", sets.unwrap_or_default()))
        }
        _ => ("", String::new()),
    }
}

/// The rows, conditions, errors and side of a scope, as far as they are not all.
fn scope(Scope { rows: asked, without, conditions, errors, side }: &Scope) -> String {
    let mut parts = Vec::new();
    if let Some(asked) = asked {
        parts.push(format!("of rows {}", rows(asked)));
    }
    if !without.is_empty() {
        let shown: Vec<String> = without.iter().take(MOST_ROWS).map(u64::to_string).collect();
        let more = without.len().saturating_sub(MOST_ROWS);
        let more = if more > 0 { format!(" and {more} more") } else { String::new() };
        parts.push(format!("without {}{more}", shown.join(", ")));
    }
    if let Some(conditions) = conditions {
        let numbers: Vec<String> =
            conditions.iter().take(MOST_ROWS).map(|number| format!("where:{number}")).collect();
        let numbers = if numbers.is_empty() { "no condition".to_owned() } else { numbers.join(", ") };
        parts.push(format!("under {numbers}"));
    }
    match errors {
        ErrorScale::AsStated => {}
        ErrorScale::Times(factor) => parts.push(format!("at {} times the errors", given(factor))),
        ErrorScale::Within(bound) => parts.push(format!("at |e| <= {}", given(bound))),
    }
    match side {
        None => {}
        Some(Side::Rising) => parts.push("for some x, theta1 >= 0".to_owned()),
        Some(Side::Falling) => parts.push("for some x, theta1 <= 0".to_owned()),
        Some(Side::Strong) => parts.push("for every x".to_owned()),
    }
    if parts.is_empty() { String::new() } else { format!(" ({})", parts.join("; ")) }
}

fn given(number: &Rational) -> String {
    Style::default().given(number).to_string()
}

/// `bounded, with 6 vertices and 6 sides`.
pub(crate) fn extent(extent: Extent, vertices: usize, sides: usize) -> String {
    let parts =
        format!("{} and {}", counted(vertices, "vertex", "vertices"), counted(sides, "side", "sides"));
    match extent {
        Extent::Empty => "empty".to_owned(),
        Extent::Bounded => format!("bounded, with {parts}"),
        Extent::Unbounded => format!("unbounded, with {parts}"),
    }
}

/// An interval of which the ends are rounded outward.
pub(crate) fn range(ends: &[Option<Rational>; 2]) -> String {
    let [lower, upper] = ends.each_ref().map(|end| Endpoint::from(end.clone()));
    // Verified ends are in order.
    let style = Style::default();
    let interval = Interval::new(lower, upper).map(|range| style.resolving(&range).interval(&range));
    interval.unwrap_or_default().to_string()
}

/// `2*theta1 - theta2`.
pub(crate) fn form_text([a1, a2]: &[Rational; 2]) -> String {
    let times = |number: &Rational, name: &str| match *number == Rational::one() {
        true => name.to_owned(),
        false => format!("{number}*{name}"),
    };
    match (a1.is_zero(), a2.is_zero()) {
        (_, true) => times(a1, "theta1"),
        (true, false) => times(a2, "theta2"),
        (false, false) => {
            let sign = if a2.is_negative() { '-' } else { '+' };
            format!("{} {sign} {}", times(a1, "theta1"), times(&a2.abs(), "theta2"))
        }
    }
}

/// `14 to 36`, `1 to 22 and 24`; of many ranges the first ones, and how many rows there are.
pub fn rows(rows: &[u64]) -> String {
    let range = |range: &[u64]| match range {
        [first, last] if first < last => format!("{first} to {last}"),
        range => range.first().map_or_else(String::new, u64::to_string),
    };
    let mut ranges: Vec<String> = rows.chunks(2).take(MOST_RANGES).map(range).collect();
    let left = (rows.len() / 2).saturating_sub(MOST_RANGES);
    if left > 0 {
        let count: u64 =
            rows.chunks_exact(2).map(|range| range[1].saturating_sub(range[0]).saturating_add(1)).sum();
        return format!("{} and {left} more ranges, {count} rows", ranges.join(", "));
    }
    match ranges.pop() {
        Some(last) if !ranges.is_empty() => format!("{} and {last}", ranges.join(", ")),
        last => last.unwrap_or_default(),
    }
}
