//! The text report of a check, and the conformance table of many.

use boundfit_check::{Approximation, Check, Directions, JudgedAnswer, ProgramRows};
use boundfit_exact::{Endpoint, Interval, Rational, Reading};
use boundfit_lp::{End, Judgement, Multiplier, PuiEnd, Refutation, Verdict};

use crate::style::Style;
use crate::text::{counted, table};

/// The report as text. `reading` is that of the data.
pub fn check_text(check: &Check, file: &str, reading: Reading, style: &Style) -> String {
    let mut text = format!("LP answers about {file}, judged exactly\n");
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
                let source = format!("{}, {}", answer.source, answer.reading.name());
                reasons.push(format!("  {source}: {name}: {}: {reason}\n", judgement.verdict.name()));
            }
        }
    }
    if let Some(exact) = exact_row(check, reading, &styles) {
        rows.push(exact);
    }
    if !rows.is_empty() {
        text.push('\n');
    }
    let header = PuiEnd::ALL.map(heading);
    let [theta1_min, theta1_max, theta2_min, theta2_max] = header.each_ref().map(String::as_str);
    let header = ["source", "judged by", theta1_min, theta1_max, theta2_min, theta2_max];
    text.push_str(&table(&header, rows));
    if !reasons.is_empty() {
        text.push_str(&format!("\nReasons\n{}", reasons.concat()));
    }
    if let Some(found) = &check.directions {
        text.push_str(&format!("\n{}", directions(found, style)));
    }
    if let Some(worst) = check.worst(reading) {
        let refuted = if worst.is_refutation() { "; refuted" } else { "" };
        text.push_str(&format!("\nWorst verdict: {}{refuted}\n", worst.name()));
    }
    text
}

/// One line about the first answer of a check, for the report of a fit.
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
    Some(format!("{:<14} {}: {detail}\n", "LP solver", answer.source))
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
        interval.map_or_else(|| style.clone(), |interval| style.resolving(&interval))
    })
}

fn answer_row(answer: &JudgedAnswer, styles: &[Style; 2]) -> Vec<String> {
    let mut row = vec![answer.source.clone(), answer.reading.name().to_owned()];
    for end in PuiEnd::ALL {
        let judgement = end.of(&answer.bounds);
        let claimed = judgement.claimed.as_ref().map(|value| end_text(styles, end, value));
        let verdict = match judgement.verdict {
            Verdict::Rounded { ulps: ulps @ 1.. } => format!("rounded, {ulps} ulp"),
            verdict => verdict.name().to_owned(),
        };
        row.push(claimed.map_or(verdict.clone(), |claimed| format!("{claimed} {verdict}")));
    }
    row
}

/// An end in the head of a table: `theta1 min`.
fn heading(end: PuiEnd) -> String {
    end.name().replace('-', " ")
}

/// An end as text. Claimed and true ends are rounded alike, so that equal ones look equal.
fn end_text(styles: &[Style; 2], end: PuiEnd, value: &Rational) -> String {
    let style = &styles[end.axis()];
    match end.end() {
        End::Lower => style.lower_text(value),
        End::Upper => style.upper_text(value),
    }
}

/// The true ends.
fn exact_row(check: &Check, reading: Reading, styles: &[Style; 2]) -> Option<Vec<String>> {
    let answer = check.answers.iter().find(|answer| answer.reading == reading)?;
    let mut row = vec!["true ends".to_owned(), reading.name().to_owned()];
    for end in PuiEnd::ALL {
        let exact = end.of(&answer.bounds).exact.as_ref();
        row.push(exact.map_or("none".to_owned(), |value| end_text(styles, end, value)));
    }
    Some(row)
}

/// Why a claim is not simply right.
fn reason(judgement: &Judgement, rows: &ProgramRows, style: &Style) -> Option<String> {
    let widths = judgement.excess_in_widths.as_ref().map(|widths| style.upper_text(&widths.abs()));
    let widths = widths.map(|widths| format!(", {widths} of the true width")).unwrap_or_default();
    let excess =
        || judgement.excess.as_ref().map(|excess| style.upper_text(&excess.abs())).unwrap_or_default();
    let mut reason = match judgement.verdict {
        Verdict::Exact | Verdict::Rounded { .. } => return None,
        Verdict::NoAnswer => judgement.reason.clone().unwrap_or_default(),
        Verdict::InvertedInterval => "the lower end is above the upper end".to_owned(),
        Verdict::WrongStatus => judgement.proof.as_ref().map(|proof| contrary(proof, rows, style))?,
        Verdict::Unsafe => {
            let witness = judgement.witness.as_ref().map(|theta| point(theta, style)).unwrap_or_default();
            format!("cuts off {}{widths}; {witness} is feasible", excess())
        }
        Verdict::Loose => format!("too wide by {}{widths}", excess()),
        Verdict::WithinTolerance | Verdict::InfeasiblePoint => String::new(),
    };
    let mut also = |text: String| {
        let separator = if reason.is_empty() { "" } else { "; " };
        reason.push_str(&format!("{separator}{text}"));
    };
    if matches!(judgement.verdict, Verdict::WithinTolerance | Verdict::InfeasiblePoint)
        && let Some(excess) = judgement.excess.as_ref().filter(|excess| excess.is_positive())
    {
        also(format!("too wide by {}{widths}", style.upper_text(excess)));
    }
    if let Some(violation) = &judgement.violation
        && judgement.verdict >= Verdict::WithinTolerance
    {
        let name = rows.name(violation.row);
        also(match (&judgement.tau, &judgement.tau_in_epsilon) {
            (Some(tau), Some(relative)) => format!(
                "the point exceeds {name} by {}: it needs eps + {} ({} of eps)",
                style.upper_text(&violation.by),
                style.upper_text(tau),
                style.upper_text(relative)
            ),
            _ => format!("the point exceeds {name} by {}", style.upper_text(&violation.by)),
        });
    }
    if judgement.verdict.is_refutation() && judgement.repairable == Some(true) {
        also("its basis is right, only the digits are wrong (repairable)".to_owned());
    }
    Some(reason)
}

/// What shows that a status is wrong.
fn contrary(proof: &Refutation, rows: &ProgramRows, style: &Style) -> String {
    let products = |multipliers: &[Multiplier]| {
        let products: Vec<String> = multipliers
            .iter()
            .map(|m| format!("{} * ({})", style.proof_text(&m.value), rows.name(m.row)))
            .collect();
        products.join(" + ")
    };
    match proof {
        Refutation::Infeasible(multipliers) => {
            let sum: Rational = multipliers.iter().map(|m| &rows.rows()[m.row].row.b * &m.value).sum();
            format!("the set is empty: {} gives 0 <= {}", products(multipliers), style.upper_text(&sum))
        }
        Refutation::Bound(multipliers) => format!("it is bounded, by {}", products(multipliers)),
        Refutation::FeasiblePoint(theta) => format!("{} is feasible", point(theta, style)),
        Refutation::Ray { theta, ray } => {
            format!("it is unbounded from {} in direction {}", point(theta, style), point(ray, style))
        }
    }
}

fn point(theta: &[Rational; 2], style: &Style) -> String {
    format!("({}, {})", style.text(&theta[0]), style.text(&theta[1]))
}

/// The set between its two approximations.
fn directions(found: &Directions, style: &Style) -> String {
    let row = |name: &str, approximation: Option<&Approximation>| {
        let vertices = approximation.map_or("-".to_owned(), |found| found.vertices.len().to_string());
        let area = approximation.map_or("-".to_owned(), |found| {
            found.area.as_ref().map_or("infinite".to_owned(), |area| style.text(area))
        });
        vec![name.to_owned(), vertices, area]
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
    format!(
        "The set seen from {} directions{unbounded}\n{}",
        found.count,
        table(&["", "vertices", "area"], rows)
    )
}
