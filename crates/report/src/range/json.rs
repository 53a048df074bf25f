//! The linear range as JSON, schema `boundfit/range/1`.

use boundfit_estimation::{Fit, Problem};
use boundfit_questions::{Contradiction, Order, Run};
use serde::Serialize;

use crate::fit_json::{CentralJson, central, pui, uniform_minimum};
use crate::input_json::InputJson;
use crate::json::{IntervalJson, TermJson, to_text};
use crate::number::Number;
use crate::origin::Origin;
use crate::range::RangeReport;
use crate::style::Style;

#[derive(Debug, Serialize)]
struct ReportJson {
    schema: &'static str,
    input: InputJson,
    by: &'static str,
    order: Vec<usize>,
    runs: Vec<Ends>,
    longest: Option<Ends>,
    widest: Option<Ends>,
    fewest: Vec<Ends>,
    parts: Vec<PartJson>,
    alone: Vec<AloneJson>,
    longest_fit: Option<LongestJson>,
}

/// First and last position, from 1.
type Ends = [usize; 2];

/// A run with what stops it.
#[derive(Debug, Serialize)]
struct PartJson {
    first: usize,
    last: usize,
    rows: [usize; 2],
    x: Option<[Number; 2]>,
    before: Option<Vec<TermJson>>,
    after: Option<Vec<TermJson>>,
}

/// A reading that is in no run.
#[derive(Debug, Serialize)]
struct AloneJson {
    position: usize,
    row: usize,
    farkas: Vec<TermJson>,
}

/// What the readings of the longest run say.
#[derive(Debug, Serialize)]
struct LongestJson {
    kind: &'static str,
    pui: Option<[IntervalJson; 2]>,
    central: Option<CentralJson>,
    epsilon_min: Option<Number>,
}

/// The report as indented JSON, with a line end.
pub fn range_json(report: &RangeReport<'_>, origin: &Origin, style: &Style) -> String {
    let RangeReport { problem, range, order, longest, .. } = report;
    let ends = |run: &Run| [run.first + 1, run.last + 1];
    let terms = |why: &Contradiction| -> Vec<TermJson> {
        why.terms.iter().map(|(name, multiplier)| TermJson::new(*name, multiplier, style)).collect()
    };
    let part = |run: &Run| PartJson {
        first: run.first + 1,
        last: run.last + 1,
        rows: [report.row(run.first), report.row(run.last)],
        x: report.reach(run).map(|ends| ends.map(|end| style.number(end))),
        before: run.before.as_ref().map(terms),
        after: run.after.as_ref().map(terms),
    };
    let alone = |(position, why): &(usize, Contradiction)| AloneJson {
        position: position + 1,
        row: report.row(*position),
        farkas: terms(why),
    };
    to_text(&ReportJson {
        schema: "boundfit/range/1",
        input: InputJson::new(problem, origin, style),
        by: order.name(),
        order: (0..range.order.len()).map(|position| report.row(position)).collect(),
        runs: range.runs.iter().map(ends).collect(),
        longest: range.longest().map(ends),
        widest: range.widest(problem).filter(|_| *order == Order::X && report.x(0).is_some()).map(ends),
        fewest: range.fewest().into_iter().map(ends).collect(),
        parts: range.runs.iter().map(part).collect(),
        alone: range.alone.iter().map(alone).collect(),
        longest_fit: longest.as_ref().map(|(own, fit)| longest_json(own, fit, style)),
    })
}

fn longest_json(own: &Problem, fit: &Fit, style: &Style) -> LongestJson {
    LongestJson {
        kind: fit.fps.polyhedron().region().kind().name(),
        pui: pui(fit, style),
        central: central(fit, style),
        epsilon_min: uniform_minimum(own, fit).map(|epsilon| style.upper_number(epsilon)),
    }
}
