//! The report of a check.

use boundfit_check::{Approximation, AskedReadings, Check, Directions, JudgedAnswer, ProgramRows};
use boundfit_estimation::Measurements;
use boundfit_exact::english::counted;
use boundfit_exact::{Endpoint, Foreign, Interval, Rational, Reading, Rounding};
use boundfit_lp::{End, Judgement, Multiplier, PuiEnd, Refutation, RoundedTo, ToleranceUnit, Verdict};

use crate::document::{Block, Document, Inline, Table, Text};
use crate::feasible::{feasible_point, witness};
use crate::fit::assumption;
use crate::formula::{absurdity, pair, products};
use crate::style::Style;
use crate::table_json::{rows_left_out, table_words};

/// The report of a check about the readings of this file. `reading` is that of the data.
pub fn check_document(
    check: &Check,
    measurements: &Measurements,
    file: Foreign<&str>,
    reading: Reading,
    style: &Style,
) -> Document<'static> {
    let styles = resolving(check, reading, style);
    // A point that is feasible for the doubles of a solver may be infeasible for the data.
    let received = (reading != Reading::Binary64).then(|| check.rows.in_binary64()).flatten();
    let mut rows = Vec::new();
    let mut findings = Vec::new();
    for answer in &check.answers {
        let same_as_read = |other: &JudgedAnswer| {
            other.source == answer.source && other.reading == reading && verdicts(other) == verdicts(answer)
        };
        // The second reading is shown where it changes a verdict.
        if answer.reading != reading && check.answers.iter().any(same_as_read) {
            continue;
        }
        rows.push(answer_row(answer, &styles));
        findings.extend(rounded_ends(answer));
        for end in PuiEnd::ALL {
            let (judgement, name) = (end.of(&answer.bounds), heading(end));
            let judged_by = received.as_ref().filter(|_| answer.reading != reading).unwrap_or(&check.rows);
            if let Some(reason) = reason(judgement, end.axis(), judged_by, style) {
                let verdict = format!(", {}: {name}: {}: ", answer.reading.name(), judgement.verdict.name());
                findings.push(Text::new().given(&answer.source).words(verdict).then(reason));
            }
        }
    }
    rows.extend(exact_row(check, reading, &styles));
    let title = Text::from("LP answers about ").given(file).words(", judged exactly");
    let mut blocks = vec![Block::Lead(title)];
    blocks.extend(table_words(measurements).map(|words| Block::Paragraph(Text::from("Table: ").then(words))));
    blocks.extend(rows_left_out(measurements.rows_missing()).map(|words| Block::Paragraph(words.into())));
    blocks.extend(
        measurements
            .multiple_of_least()
            .map(|multiple| Block::Paragraph(Text::from("Assumed: ").then(assumption(multiple, style)))),
    );
    let AskedReadings { asked, fitted } = check.readings;
    if asked < fitted {
        let about =
            format!("About the {asked} of {fitted} readings that lie on a hull: no other can bound anything");
        blocks.push(Block::Paragraph(about.into()));
    }
    if !rows.is_empty() {
        let header = ["source", "judged by"].map(str::to_owned).into_iter().chain(PuiEnd::ALL.map(heading));
        blocks.extend([Block::Space, Block::Table(Table::new(header, rows))]);
    }
    if !findings.is_empty() {
        blocks.push(Block::Title("Reasons".into()));
        blocks.extend(findings.into_iter().map(Block::Paragraph));
    }
    blocks.extend(check.directions.iter().flat_map(|found| directions(found, style)));
    blocks.extend(worst_blocks(check, reading));
    Document::new(blocks)
}

/// The worst verdict, and what decides it: the reading of the data, as it decides the exit status.
fn worst_blocks(check: &Check, reading: Reading) -> Vec<Block<'static>> {
    let Some(worst) = check.worst(reading) else { return Vec::new() };
    let refuted = if worst.is_refutation() { "; refuted" } else { "" };
    let decides = match reading {
        Reading::Decimal => "The data as written (decimal) decide this and the exit status",
        Reading::Binary64 => "The data as doubles (binary64) decide this and the exit status",
    };
    let as_received = check.worst(Reading::Binary64).filter(|_| reading != Reading::Binary64);
    let as_received = as_received.map_or_else(String::new, |worst| {
        format!("; against the doubles that a solver receives (binary64) the worst is: {}", worst.name())
    });
    vec![
        Block::Lead(format!("Worst verdict: {}{refuted}", worst.name()).into()),
        Block::Paragraph(format!("{decides}{as_received}.").into()),
    ]
}

/// Returns the verdict on the first answer of a check in a few words, for the report of a fit: the deviation in
/// proportion, then its name.
pub fn verdict_line(check: &Check, reading: Reading) -> Option<String> {
    let answer = check.answers.iter().find(|answer| answer.reading == reading)?;
    let worst = answer.worst();
    let of_worst = answer.bounds.iter().flatten().filter(|judgement| judgement.verdict == worst);
    let error = Judgement::largest_error(of_worst).map(proportion);
    let named = || {
        let ends = PuiEnd::ALL.into_iter().filter(|end| end.of(&answer.bounds).verdict == worst);
        let names: Vec<String> = ends.map(heading).collect();
        format!("{} on {} (see boundfit check)", worst.name(), names.join(", "))
    };
    let detail = match (worst, error) {
        (Verdict::Exact, _) => "right on all four ends".to_owned(),
        (Verdict::Rounded | Verdict::WithinTolerance, Some(error)) => {
            format!("right to {error} ({})", worst.name())
        }
        (Verdict::Loose | Verdict::Unsafe, Some(error)) => format!("off by {error}: {}", named()),
        _ => named(),
    };
    Some(format!("{}: {detail}", answer.source))
}

/// An error in proportion: `1.6e-16 of the width`. Rounded up.
fn proportion((size, unit): (Rational, Option<ToleranceUnit>)) -> String {
    let size = size.to_decimal(2, Rounding::Up);
    match unit {
        Some(ToleranceUnit::Epsilon) => format!("{size} of eps"),
        Some(unit) => format!("{size} of the {}", unit.name()),
        None => size,
    }
}

fn verdicts(answer: &JudgedAnswer) -> Vec<&'static str> {
    answer.bounds.iter().flatten().map(|judgement| judgement.verdict.name()).collect()
}

/// The ends of an answer that are right up to rounding, in one sentence for each kind of rounding.
fn rounded_ends(answer: &JudgedAnswer) -> Vec<Text> {
    let mut kinds: Vec<(RoundedTo, Vec<PuiEnd>)> = Vec::new();
    for end in PuiEnd::ALL {
        let judgement = end.of(&answer.bounds);
        let Some(to) = judgement.rounded_to.filter(|_| judgement.verdict == Verdict::Rounded) else {
            continue;
        };
        match kinds.iter_mut().find(|(kind, _)| *kind == to) {
            Some((_, ends)) => ends.push(end),
            None => kinds.push((to, vec![end])),
        }
    }
    let sentence = |(to, ends): (RoundedTo, Vec<PuiEnd>)| {
        let judgements = ends.iter().map(|end| end.of(&answer.bounds));
        let largest = Judgement::largest_error(judgements.clone()).map(proportion);
        let ulps = judgements.filter_map(|judgement| judgement.excess_in_ulps.as_ref()).map(Rational::abs);
        let ulps = ulps.max().map(|ulps| format!(", {} ulp", ulps.to_decimal(2, Rounding::Up)));
        let names = match ends.as_slice() {
            [_, _, _, _] => "all four ends".to_owned(),
            _ => ends.into_iter().map(heading).collect::<Vec<_>>().join(", "),
        };
        Text::new().given(&answer.source).words(format!(
            ", {}: {names}: rounded to {}: right to {}{}",
            answer.reading.name(),
            rounding_name(to),
            largest.unwrap_or_default(),
            ulps.unwrap_or_default()
        ))
    };
    kinds.into_iter().map(sentence).collect()
}

/// The precision to which a number was rounded.
fn rounding_name(to: RoundedTo) -> String {
    match to {
        RoundedTo::Binary64 => "doubles".to_owned(),
        RoundedTo::Digits(0) => "zero".to_owned(),
        RoundedTo::Digits(digits) => counted(digits, "digit", "digits"),
    }
}

/// Styles that tell the true ends of each interval apart.
fn resolving(check: &Check, reading: Reading, style: &Style) -> [Style; 2] {
    let answer = check.answers.iter().find(|answer| answer.reading == reading);
    [0, 1].map(|axis| {
        let ends =
            answer.map(|answer| answer.bounds[axis].each_ref().map(|judgement| judgement.exact.clone()));
        let interval = match ends {
            Some([Some(lower), Some(upper)]) => {
                Interval::new(Endpoint::Finite(lower), Endpoint::Finite(upper))
            }
            _ => None,
        };
        interval.map_or(*style, |interval| style.resolving(&interval))
    })
}

fn answer_row(answer: &JudgedAnswer, styles: &[Style; 2]) -> Vec<Text> {
    let mut row = vec![Text::new().given(&answer.source), answer.reading.name().into()];
    for end in PuiEnd::ALL {
        let judgement = end.of(&answer.bounds);
        let verdict = match judgement.rounded_to.filter(|_| judgement.verdict == Verdict::Rounded) {
            Some(RoundedTo::Digits(digits @ 1..)) => {
                format!("rounded, {}", counted(digits, "digit", "digits"))
            }
            _ => judgement.verdict.name().to_owned(),
        };
        let verdict = match (&judgement.claimed, judgement.verdict) {
            (None, Verdict::Exact) => format!("{} {verdict}", without_end(judgement)),
            (None, _) => verdict,
            (Some(_), _) => format!(" {verdict}"),
        };
        let style = telling(&answer.bounds, end, &styles[end.axis()]);
        row.push(shown_end(&style, end, &answer.bounds, claimed).unwrap_or_default().words(verdict));
    }
    row
}

/// The most digits that a table shows to tell two numbers apart.
const MOST_DIGITS: usize = 40;

fn claimed(judgement: &Judgement) -> Option<&Rational> {
    judgement.claimed.as_ref()
}

fn exact(judgement: &Judgement) -> Option<&Rational> {
    judgement.exact.as_ref()
}

/// The ends of the interval that has this one.
fn both_ends(
    end: PuiEnd,
    bounds: &[[Judgement; 2]; 2],
    value: fn(&Judgement) -> Option<&Rational>,
) -> Option<(&Rational, &Rational)> {
    let [lower, upper] = &bounds[end.axis()];
    value(lower).zip(value(upper))
}

/// A style with the digits that tell a claim from the truth, unless it is right up to rounding, and from a claim that it crosses.
fn telling(bounds: &[[Judgement; 2]; 2], end: PuiEnd, style: &Style) -> Style {
    let judgement = end.of(bounds);
    let is_told = judgement.verdict >= Verdict::WithinTolerance;
    let truth = claimed(judgement).zip(exact(judgement)).filter(|_| is_told);
    let crossed = both_ends(end, bounds, claimed).filter(|(lower, upper)| lower >= upper);
    let first_different = |(one, other): (&Rational, &Rational)| {
        let size = one.abs().max(other.abs()).decimal_exponent()?;
        // One digit more, since one of them may be rounded outward and the other one to nearest.
        let more = if crossed.is_some() { 2 } else { 1 };
        usize::try_from(size - (one - other).decimal_exponent()? + more).ok()
    };
    match [truth, crossed].into_iter().flatten().filter_map(first_different).max() {
        Some(digits) => style.with_at_least(digits.min(MOST_DIGITS)),
        None => *style,
    }
}

/// An end in the head of a table: `theta1 min`.
fn heading(end: PuiEnd) -> String {
    end.name().replace('-', " ")
}

/// An end. Claimed and true ends are rounded alike, so that equal ones look equal. Ends with nothing between them are numbers:
/// rounded outward, equal ones would differ, and crossed ones would look right.
fn shown_end(
    style: &Style,
    end: PuiEnd,
    bounds: &[[Judgement; 2]; 2],
    value: fn(&Judgement) -> Option<&Rational>,
) -> Option<Text> {
    let is_number = both_ends(end, bounds, value).is_some_and(|(lower, upper)| lower >= upper);
    let value = value(end.of(bounds))?;
    Some(Text::new().number(match end.end() {
        _ if is_number => style.nearest(value),
        End::Lower => style.lower(value),
        End::Upper => style.upper(value),
    }))
}

/// Returns why there is no true end.
fn without_end(judgement: &Judgement) -> &'static str {
    if judgement.is_empty { "empty set" } else { "unbounded" }
}

/// The true ends.
fn exact_row(check: &Check, reading: Reading, styles: &[Style; 2]) -> Option<Vec<Text>> {
    let mut answers = check.answers.iter().filter(|answer| answer.reading == reading).peekable();
    let first = *answers.peek()?;
    let answers: Vec<&JudgedAnswer> = answers.collect();
    let mut row = vec!["true ends".into(), reading.name().into()];
    for end in PuiEnd::ALL {
        let styles = answers.iter().map(|answer| telling(&answer.bounds, end, &styles[end.axis()]));
        let style = styles.max_by_key(Style::significant).unwrap_or_default();
        let shown = shown_end(&style, end, &first.bounds, exact);
        row.push(shown.unwrap_or_else(|| without_end(end.of(&first.bounds)).into()));
    }
    Some(row)
}

/// Returns the reason why a claim is not simply right.
fn reason(judgement: &Judgement, axis: usize, rows: &ProgramRows, style: &Style) -> Option<Text> {
    let point_text = || violation_text(judgement, rows, style);
    let main = match judgement.verdict {
        Verdict::Exact | Verdict::Rounded if judgement.reason.is_none() => return None,
        Verdict::Exact | Verdict::Rounded | Verdict::NoAnswer => Text::new(),
        Verdict::InvertedInterval => "the lower end is above the upper end".into(),
        Verdict::WrongStatus => judgement.proof.as_ref().map(|proof| contrary(proof, rows, style))?,
        Verdict::Unsafe => {
            let (theta, claimed) = judgement.witness.as_ref().zip(claimed(judgement))?;
            let side = theta[axis].cmp(claimed);
            let is_beyond = |point: &[Rational; 2]| point[axis].cmp(claimed) == side;
            let witness = witness(theta, rows.rows(), is_beyond, style);
            error_text(judgement, style).words("; ").then(witness).words(" is feasible")
        }
        Verdict::Loose | Verdict::WithinTolerance | Verdict::InfeasiblePoint => error_text(judgement, style),
    };
    let mut reasons = vec![main];
    reasons.extend(point_text());
    if judgement.verdict.is_refutation() && judgement.repairable == Some(true) {
        reasons.push("its basis is right, only the digits are wrong (repairable)".into());
    }
    reasons.extend(judgement.reason.as_ref().map(|reason| Text::new().given(reason)));
    reasons.retain(|reason| !reason.is_empty());
    Some(Text::joined(reasons, &Inline::Words("; ".to_owned())))
}

/// The error of an end: its direction, its size in proportion, as it is and in units in the last place.
fn error_text(judgement: &Judgement, style: &Style) -> Text {
    let Some(excess) = judgement.excess.as_ref().filter(|excess| !excess.is_zero()) else {
        return Text::new();
    };
    let text = Text::from(if excess.is_negative() { "cuts off " } else { "too wide by " });
    let size = excess.abs();
    let (text, is_open) = match judgement.excess_in_units {
        Some(_) => {
            let proportion = judgement.error().map(proportion).unwrap_or_default();
            (text.words(format!("{proportion} (")).number(style.upper(&size)), true)
        }
        None => (text.number(style.upper(&size)), false),
    };
    let ulps = judgement.excess_in_ulps.as_ref().map(|ulps| ulps.abs().to_decimal(2, Rounding::Up));
    let text = text.words(ulps.map(|ulps| format!(", {ulps} ulp")).unwrap_or_default());
    if is_open { text.words(")") } else { text }
}

/// The bound that a claimed point violates most, and the ε that it needs.
fn violation_text(judgement: &Judgement, rows: &ProgramRows, style: &Style) -> Option<Text> {
    let violation = judgement.violation.as_ref()?;
    let exceeds = format!("the point exceeds {} by ", rows.name(violation.row));
    let exceeds = Text::from(exceeds).number(style.upper(&violation.by));
    Some(match (&judgement.tau, &judgement.tau_in_epsilon) {
        (Some(tau), Some(relative)) => {
            let needs = exceeds.words(": it needs eps + ").number(style.upper(tau));
            needs.words(" (").number(style.upper(relative)).words(" of eps)")
        }
        _ => exceeds,
    })
}

/// The proof that a status is wrong.
fn contrary(proof: &Refutation, rows: &ProgramRows, style: &Style) -> Text {
    let products_of = |multipliers: &[Multiplier]| {
        products(multipliers.iter().map(|m| (style.proof(&m.value), rows.name(m.row).to_string())))
    };
    match proof {
        Refutation::Infeasible(multipliers) => {
            let sum: Rational = multipliers.iter().map(|m| &rows.rows()[m.row].row.b * &m.value).sum();
            absurdity(Text::from("the set is empty: ").then(products_of(multipliers)), &sum, style)
        }
        Refutation::Bound(multipliers) => Text::from("it is bounded, by ").then(products_of(multipliers)),
        Refutation::FeasiblePoint(theta) => feasible_point(theta, rows.rows(), style).words(" is feasible"),
        Refutation::Ray { theta, ray } => {
            let from = Text::from("it is unbounded from ").then(feasible_point(theta, rows.rows(), style));
            // Rounded, it would be another direction.
            from.words(" in direction ").then(pair(&ray[0], &ray[1]))
        }
    }
}

/// The plane in which directions are spread evenly.
const DIRECTIONS_UNSCALED: &str = "The directions are spread evenly in the plane of theta1 and theta2.";
const DIRECTIONS_SCALED: &str = "The directions are spread evenly where the PUI box is a square.";

/// The set between its two approximations.
fn directions(found: &Directions, style: &Style) -> [Block<'static>; 3] {
    let row = |name: &str, approximation: Option<&Approximation>| {
        let Some(Approximation { vertices, area }) = approximation else {
            return [name, "-", "-"].map(Text::from).into();
        };
        let area = area.as_ref().map(|area| Text::new().number(style.nearest(area)));
        let count = match (vertices.len(), area.is_some()) {
            (0, true) => "none: empty".into(),
            (count, _) => Text::new().number(count),
        };
        vec![name.into(), count, area.unwrap_or("infinite".into())]
    };
    let rows = vec![
        row("inner: hull of the optimisers", found.inner.as_ref()),
        row("the set itself", Some(&found.exact)),
        row("outer: supporting half-planes", found.outer.as_ref()),
    ];
    let unbounded = match found.unbounded {
        0 => String::new(),
        count => format!(", {count} of them unbounded"),
    };
    let title = format!("The set seen from {} directions{unbounded}", found.count);
    let spread = if found.is_scaled { DIRECTIONS_SCALED } else { DIRECTIONS_UNSCALED };
    let table = Table::new(["", "vertices", "area"], rows);
    [Block::Title(title.into()), Block::Table(table), Block::Paragraph(spread.into())]
}
