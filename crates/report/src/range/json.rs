//! The linear range as JSON, schema `boundfit/range/1`.

use boundfit_estimation::{Fit, Problem};
use boundfit_questions::{Contradiction, Order, Run};

use crate::answer::input::InputJson;
use crate::answer::parts::TermJson;
use crate::answer::range::{AloneJson, LinearRangeJson, LongestJson, RunJson};
use crate::fit_json::{central, pui, uniform_minimum};
use crate::json::to_text;
use crate::origin::Origin;
use crate::range::RangeReport;
use crate::style::Style;

/// The report as indented JSON, with a line end.
pub fn range_json(report: &RangeReport<'_>, origin: &Origin, style: &Style) -> String {
    let RangeReport { problem, range, order, longest, .. } = report;
    let ends = |run: &Run| [run.first + 1, run.last + 1];
    let terms = |why: &Contradiction| TermJson::all(&why.terms, style);
    let part = |run: &Run| RunJson {
        first: run.first + 1,
        last: run.last + 1,
        rows: [report.row(run.first), report.row(run.last)],
        x: report.reach(run).map(|ends| ends.map(|end| style.number(&end))),
        before: run.before.as_ref().map(terms),
        after: run.after.as_ref().map(terms),
    };
    let alone = |(position, why): &(usize, Contradiction)| AloneJson {
        position: position + 1,
        row: report.row(*position),
        farkas: terms(why),
    };
    to_text(&LinearRangeJson {
        schema: LinearRangeJson::SCHEMA,
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
        kind: fit.fps.polyhedron().kind().name(),
        pui: pui(fit, style),
        central: central(fit, style),
        epsilon_min: uniform_minimum(own, fit).map(|epsilon| style.upper_number(epsilon)),
    }
}
