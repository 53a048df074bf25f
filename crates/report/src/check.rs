//! The report of a check, and the conformance table of many.

use boundfit_check::{Approximation, Check, Directions, JudgedAnswer, ProgramRows};
use boundfit_exact::english::counted;
use boundfit_exact::{Endpoint, Interval, Rational, Reading};
use boundfit_lp::{End, Judgement, Multiplier, PuiEnd, Refutation, Verdict};

use crate::document::{Block, Document, Inline, Table, Text};
use crate::formula::{absurdity, pair, products};
use crate::style::{Shown, Style};

/// The report of a check about the data of this file. `reading` is that of the data.
pub fn check_document(check: &Check, file: &str, reading: Reading, style: &Style) -> Document {
    let styles = resolving(check, reading, style);
    let mut rows = Vec::new();
    let mut reasons = Vec::new();
    for answer in &check.answers {
        let same_as_read = |other: &JudgedAnswer| {
            other.source == answer.source && other.reading == reading && verdicts(other) == verdicts(answer)
        };
        // The second reading is shown where it changes a verdict.
        if answer.reading != reading && check.answers.iter().any(same_as_read) {
            continue;
        }
        rows.push(answer_row(answer, &styles));
        for end in PuiEnd::ALL {
            let (judgement, name) = (end.of(&answer.bounds), heading(end));
            if let Some(reason) = reason(judgement, &check.rows, style) {
                let verdict = format!(", {}: {name}: {}: ", answer.reading.name(), judgement.verdict.name());
                reasons.push(Text::new().given(&answer.source).words(verdict).then(reason));
            }
        }
    }
    rows.extend(exact_row(check, reading, &styles));
    let title = Text::from("LP answers about ").given(file).words(", judged exactly");
    let mut blocks = vec![Block::Lead(title)];
    if !rows.is_empty() {
        let header = ["source", "judged by"].map(str::to_owned).into_iter().chain(PuiEnd::ALL.map(heading));
        blocks.extend([Block::Space, Block::Table(Table::new(header, rows))]);
    }
    if !reasons.is_empty() {
        blocks.push(Block::Title("Reasons".into()));
        blocks.extend(reasons.into_iter().map(Block::Paragraph));
    }
    blocks.extend(check.directions.iter().flat_map(|found| directions(found, style)));
    if let Some(worst) = check.worst(reading) {
        let refuted = if worst.is_refutation() { "; refuted" } else { "" };
        blocks.push(Block::Lead(format!("Worst verdict: {}{refuted}", worst.name()).into()));
    }
    Document::new(blocks)
}

/// What the first answer of a check is worth in a few words, for the report of a fit.
pub fn verdict_line(check: &Check, reading: Reading) -> Option<String> {
    let answer = check.answers.iter().find(|answer| answer.reading == reading)?;
    let worst = answer.worst();
    let detail = match worst {
        Verdict::Exact => "right on all four ends".to_owned(),
        Verdict::Rounded { ulps: 0 } => "right on all four ends, rounded".to_owned(),
        Verdict::Rounded { ulps } => {
            let units = counted(usize::try_from(ulps).unwrap_or(usize::MAX), "unit", "units");
            format!("right on all four ends to {units} in the last place")
        }
        _ => {
            let ends = PuiEnd::ALL.into_iter().filter(|end| end.of(&answer.bounds).verdict == worst);
            let names: Vec<String> = ends.map(heading).collect();
            format!("{} on {} (see boundfit check)", worst.name(), names.join(", "))
        }
    };
    Some(format!("{}: {detail}", answer.source))
}

/// A Markdown table of the worst verdict of each source on each case. Each case comes with its name and its check.
pub fn conformance_table(cases: &[(String, Check)]) -> String {
    let mut sources: Vec<&str> = Vec::new();
    for answer in cases.iter().flat_map(|(_, check)| &check.answers) {
        if !sources.contains(&answer.source.as_str()) {
            sources.push(&answer.source);
        }
    }
    let mut text = format!("| case | {} |\n|---|{}\n", sources.join(" | "), "---|".repeat(sources.len()));
    let mut right = vec![0; sources.len()];
    for (name, check) in cases {
        let mut cells = Vec::new();
        for (column, source) in sources.iter().enumerate() {
            let mut of_source = check.answers.iter().filter(|answer| answer.source == *source);
            let as_read = of_source.find(|answer| answer.reading == Reading::Decimal);
            let received = of_source.find(|answer| answer.reading == Reading::Binary64).or(as_read);
            let verdict = |answer: Option<&JudgedAnswer>| answer.map_or("-", |answer| answer.worst().name());
            right[column] += usize::from(as_read.is_some_and(|answer| !answer.worst().is_refutation()));
            cells.push(if verdict(as_read) == verdict(received) {
                verdict(as_read).to_owned()
            } else {
                format!("{} ({} for the doubles it received)", verdict(as_read), verdict(received))
            });
        }
        text.push_str(&format!("| `{name}` | {} |\n", cells.join(" | ")));
    }
    let totals: Vec<String> = right.iter().map(|count| format!("{count} of {}", cases.len())).collect();
    text.push_str(&format!("| not refuted | {} |\n", totals.join(" | ")));
    text
}

fn verdicts(answer: &JudgedAnswer) -> Vec<&'static str> {
    answer.bounds.iter().flatten().map(|judgement| judgement.verdict.name()).collect()
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
        let verdict = match judgement.verdict {
            Verdict::Rounded { ulps: ulps @ 1.. } => format!("rounded, {ulps} ulp"),
            verdict => verdict.name().to_owned(),
        };
        row.push(match &judgement.claimed {
            Some(claimed) => Text::new().number(shown_end(styles, end, claimed)).words(format!(" {verdict}")),
            None => verdict.into(),
        });
    }
    row
}

/// An end in the head of a table: `theta1 min`.
fn heading(end: PuiEnd) -> String {
    end.name().replace('-', " ")
}

/// An end. Claimed and true ends are rounded alike, so that equal ones look equal.
fn shown_end<'a>(styles: &[Style; 2], end: PuiEnd, value: &'a Rational) -> Shown<'a> {
    let style = &styles[end.axis()];
    match end.end() {
        End::Lower => style.lower(value),
        End::Upper => style.upper(value),
    }
}

/// The true ends.
fn exact_row(check: &Check, reading: Reading, styles: &[Style; 2]) -> Option<Vec<Text>> {
    let answer = check.answers.iter().find(|answer| answer.reading == reading)?;
    let mut row = vec!["true ends".into(), reading.name().into()];
    for end in PuiEnd::ALL {
        let exact = end.of(&answer.bounds).exact.as_ref();
        let shown = exact.map(|value| Text::new().number(shown_end(styles, end, value)));
        row.push(shown.unwrap_or("none".into()));
    }
    Some(row)
}

/// Why a claim is not simply right.
fn reason(judgement: &Judgement, rows: &ProgramRows, style: &Style) -> Option<Text> {
    let size = |words: &str, size: &Option<Rational>, after: &str| match size {
        Some(size) => Text::from(words).number(style.upper(&size.abs())).words(after),
        None => Text::new(),
    };
    let too_large = |words: &str| {
        let widths = size(", ", &judgement.excess_in_widths, " of the true width");
        Text::from(words).then(size("", &judgement.excess, "")).then(widths)
    };
    let main = match judgement.verdict {
        Verdict::Exact | Verdict::Rounded { .. } => return None,
        Verdict::NoAnswer => judgement.reason.clone().unwrap_or_default().into(),
        Verdict::InvertedInterval => "the lower end is above the upper end".into(),
        Verdict::WrongStatus => judgement.proof.as_ref().map(|proof| contrary(proof, rows, style))?,
        Verdict::Unsafe => {
            let witness = judgement.witness.as_ref().map(|theta| point(theta, style)).unwrap_or_default();
            too_large("cuts off ").words("; ").then(witness).words(" is feasible")
        }
        Verdict::Loose => too_large("too wide by "),
        Verdict::WithinTolerance | Verdict::InfeasiblePoint
            if judgement.excess.as_ref().is_some_and(Rational::is_positive) =>
        {
            too_large("too wide by ")
        }
        Verdict::WithinTolerance | Verdict::InfeasiblePoint => Text::new(),
    };
    let mut reasons = vec![main];
    if let Some(violation) = &judgement.violation
        && judgement.verdict >= Verdict::WithinTolerance
    {
        let exceeds = format!("the point exceeds {} by ", rows.name(violation.row));
        let exceeds = Text::from(exceeds).number(style.upper(&violation.by));
        reasons.push(match (&judgement.tau, &judgement.tau_in_epsilon) {
            (Some(tau), Some(relative)) => {
                let needs = exceeds.words(": it needs eps + ").number(style.upper(tau));
                needs.words(" (").number(style.upper(relative)).words(" of eps)")
            }
            _ => exceeds,
        });
    }
    if judgement.verdict.is_refutation() && judgement.repairable == Some(true) {
        reasons.push("its basis is right, only the digits are wrong (repairable)".into());
    }
    reasons.retain(|reason| !reason.is_empty());
    Some(Text::joined(reasons, &Inline::Words("; ".to_owned())))
}

/// What shows that a status is wrong.
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
        Refutation::FeasiblePoint(theta) => point(theta, style).words(" is feasible"),
        Refutation::Ray { theta, ray } => {
            let from = Text::from("it is unbounded from ").then(point(theta, style));
            from.words(" in direction ").then(point(ray, style))
        }
    }
}

fn point([theta1, theta2]: &[Rational; 2], style: &Style) -> Text {
    pair(style.nearest(theta1), style.nearest(theta2))
}

/// The set between its two approximations.
fn directions(found: &Directions, style: &Style) -> [Block; 2] {
    let row = |name: &str, approximation: Option<&Approximation>| {
        let Some(Approximation { vertices, area }) = approximation else {
            return [name, "-", "-"].map(Text::from).into();
        };
        let area = area.as_ref().map(|area| Text::new().number(style.nearest(area)));
        vec![name.into(), Text::new().number(vertices.len()), area.unwrap_or("infinite".into())]
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
    [Block::Title(title.into()), Block::Table(Table::new(["", "vertices", "area"], rows))]
}
