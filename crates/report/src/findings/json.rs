//! The findings about solutions, for the schema `boundfit/judge/1`.

use boundfit_judge::{Excuse, Fault, Finding, Item, JudgedSolution, Side, SolverStatus};
use boundfit_lp::Model;

use super::not_judged;
use super::sentence::sentence;
use crate::answer::judge::{FindingJson, SolutionJson, ToleranceJson};
use crate::style::Style;

/// All solutions, in their order.
pub fn solutions_json(model: &Model, solutions: &[JudgedSolution], style: &Style) -> Vec<SolutionJson> {
    let one = |judged: &JudgedSolution| SolutionJson {
        file: judged.file.clone(),
        writer: judged.solution.writer,
        status: match &judged.solution.status {
            SolverStatus::Optimal => "optimal".to_owned(),
            SolverStatus::Infeasible => "infeasible".to_owned(),
            SolverStatus::Unbounded => "unbounded".to_owned(),
            SolverStatus::InfeasibleOrUnbounded => "infeasible-or-unbounded".to_owned(),
            SolverStatus::Other(words) => words.clone(),
        },
        verdict: judged.findings.worst().name(),
        findings: judged.findings.findings.iter().map(|finding| one_finding(model, finding, style)).collect(),
        not_judged: not_judged(model, judged),
    };
    solutions.iter().map(one).collect()
}

fn one_finding(model: &Model, finding: &Finding, style: &Style) -> FindingJson {
    let number = |value: &boundfit_exact::Rational| Some(style.number(value));
    let (side, claimed, exact) = match &finding.fault {
        None | Some(Fault::Status { .. }) => (None, None, None),
        Some(Fault::NotFinite { item, .. }) => {
            (item.map(|item| Side { item, end: boundfit_lp::End::Lower }), None, None)
        }
        Some(Fault::Value { claimed, exact, .. }) => (None, number(claimed), number(exact)),
        Some(Fault::Beyond { side, bound, value }) => (Some(*side), number(value), number(bound)),
        Some(Fault::NoSuchBound { side, price } | Fault::Slack { side, price, .. }) => {
            (Some(*side), number(price), None)
        }
        Some(Fault::ReducedCost { column, claimed, exact }) => {
            let side = Side { item: Item::Column(*column), end: boundfit_lp::End::Lower };
            (Some(side), number(claimed), number(exact))
        }
        Some(Fault::Leaves { side, change }) => (Some(*side), number(change), None),
        Some(Fault::DoesNotImprove { change: value } | Fault::NoContradiction { total: value }) => {
            (None, number(value), None)
        }
    };
    let row = side.and_then(|side| match side.item {
        Item::Row(row) => model.rows.get(row).map(|row| row.name.clone()),
        Item::Column(_) => None,
    });
    let column = side.and_then(|side| match side.item {
        Item::Row(_) => None,
        Item::Column(column) => model.columns.get(column).map(|column| column.name.clone()),
    });
    let has_end = !matches!(finding.fault, Some(Fault::ReducedCost { .. } | Fault::NotFinite { .. }));
    FindingJson {
        aspect: finding.aspect.name(),
        verdict: finding.worth.name(),
        line: finding.line,
        error: finding.error.as_ref().map(|error| style.upper_number(error)),
        relative: finding.relative.as_ref().map(|error| style.upper_number(error)),
        row,
        column,
        bound: side.filter(|_| has_end).map(|side| side.end.name()),
        claimed,
        exact,
        tolerance: finding.excuse.as_ref().map(|excuse| tolerance(excuse, style)),
        message: sentence(model, finding),
    }
}

fn tolerance(excuse: &Excuse, style: &Style) -> ToleranceJson {
    ToleranceJson {
        absolute: style.upper_number(&excuse.absolute),
        relative: style.upper_number(&excuse.relative),
        scaled: style.upper_number(&excuse.scaled),
    }
}
