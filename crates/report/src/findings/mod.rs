//! Findings about solutions of a linear program, as text, JSON, SARIF and JUnit.

mod json;
mod junit;
mod sarif;
mod sentence;

use boundfit_exact::english::counted;
use boundfit_judge::{Aspect, JudgedSolution, Worth};
use boundfit_lp::Model;

use crate::document::{Block, Document, Facts, Text};

pub use json::solutions_json;
pub use junit::solutions_junit;
pub use sarif::solutions_sarif;
use sentence::{bounded, sentence};

/// The findings about solutions, to stand behind the report of the answer: for each file its worst verdict, then a line for
/// each aspect, the size of the error first.
pub fn solutions_document(model: &Model, solutions: &[JudgedSolution]) -> Document<'static> {
    let mut blocks = Vec::new();
    for judged in solutions {
        let title = Text::new().given(&judged.file).words(format!(
            ", in {} format: {}",
            judged.solution.writer,
            summary(judged)
        ));
        let findings = judged.findings.findings.iter();
        let rows = findings.map(|finding| {
            let said = Text::from(format!("{}: {}", finding.worth.name(), sentence(model, finding)));
            (Text::from(label(finding.aspect)), said)
        });
        let rows = rows.chain(not_judged(model, judged).map(|reason| (Text::from(""), reason.into())));
        let width = Aspect::ALL.iter().map(|aspect| label(*aspect).len()).max().unwrap_or_default() + 2;
        blocks.extend([Block::Title(title), Block::Facts(Facts { width, rows: rows.collect() })]);
    }
    if solutions.iter().any(has_excuse) {
        blocks.push(Block::Space);
        blocks.push(Block::Paragraph(NAMED.into()));
    }
    Document::new(blocks)
}

/// The part of a file that is not judged, and why.
fn not_judged(model: &Model, judged: &JudgedSolution) -> Option<String> {
    let duals = judged.solution.other_rows.map(|found| {
        let [found, rows] = [found, model.rows.len()].map(|count| counted(count, "row", "rows"));
        format!("the duals are not looked at: the file lists {found}, the model has {rows}")
    });
    let solution = &judged.solution;
    let is_alone =
        solution.reduced_costs.is_some() && solution.duals.is_none() && solution.other_rows.is_none();
    let reduced_costs = is_alone.then(|| REDUCED_COSTS.to_owned());
    let activities = judged.solution.has_activities.then(|| ACTIVITIES.to_owned());
    let parts: Vec<String> = duals.into_iter().chain(reduced_costs).chain(activities).collect();
    (!parts.is_empty()).then(|| parts.join("; "))
}

/// The note on the values of rows, which the point decides.
const ACTIVITIES: &str = "the row activities are not looked at: the point decides";

/// The note on reduced costs, which duals decide.
const REDUCED_COSTS: &str = "the reduced costs are not looked at: there are no duals";

/// The source of the tolerances.
const NAMED: &str = "Tolerances: absolute as HiGHS (primal_feasibility_tolerance, dual_feasibility_tolerance), Gurobi (FeasibilityTol, OptimalityTol) and SoPlex (feastol, opttol) test rows and bounds; relative as SCIP tests them (numerics/feastol); scaled as solvers test them once each row is divided by its largest coefficient.";

fn has_excuse(judged: &JudgedSolution) -> bool {
    judged
        .findings
        .findings
        .iter()
        .any(|finding| finding.worth >= Worth::WithinTolerance && finding.excuse.is_some())
}

/// A whole solution in a few words.
fn summary(judged: &JudgedSolution) -> String {
    match judged.findings.worst() {
        Worth::Exact => "right, exactly".to_owned(),
        Worth::Rounded => "right, but for rounding".to_owned(),
        Worth::WithinTolerance => {
            let relative = judged.findings.findings.iter().filter(|own| own.worth == Worth::WithinTolerance);
            let largest = relative.filter_map(|finding| finding.relative.as_ref()).max();
            largest.map_or_else(String::new, |largest| format!("right to {}", bounded(largest)))
        }
        Worth::NoAnswer => "no answer".to_owned(),
        Worth::Refuted => {
            let refuted = judged.findings.findings.iter().filter(|own| own.worth == Worth::Refuted);
            let names: Vec<&str> = refuted.map(|finding| label(finding.aspect)).collect();
            format!("refuted ({})", names.join(", "))
        }
    }
}

/// The name of an aspect for people.
fn label(aspect: Aspect) -> &'static str {
    match aspect {
        Aspect::ComplementarySlackness => "slackness",
        Aspect::DualityGap => "gap",
        other => other.name(),
    }
}
