//! Reports about lines under errors in x.

mod json;
#[cfg(feature = "files")]
mod proof;
mod reasons;
mod tables;

use boundfit_estimation::{Fit, Model, ParameterBound, ParameterInterval, Ties};
use boundfit_exact::english::list_of;
use boundfit_exact::{Interval, Rational};
use boundfit_questions::{Agreement, BoxBound, Side, SideSet, XBounds, XErrorFit, XErrorProblem};

use crate::document::{Block, Document, Facts, Inline, Operator, Symbol, THETA, Table, Text};
use crate::fit::{bounded_rows, fit_facts};
use crate::formula::products;
use crate::origin::Origin;
use crate::region::region_blocks;
use crate::scale::{Scale, scales};
use crate::slope_lines;
use crate::style::Style;

pub use json::x_error_json;
#[cfg(feature = "files")]
pub use proof::x_error_proof;
pub use tables::{x_error_csv, x_error_wkt};

/// The report of lines under errors in x. `plain` is the fit without these errors, of which least squares, which knows nothing of
/// them, is shown.
pub fn x_error_document<'a>(
    problem: &XErrorProblem,
    answer: &'a XErrorFit,
    plain: &Fit,
    origin: &Origin,
    style: &Style,
) -> Document<'a> {
    let pui = answer.pui();
    let report = XErrorReport::new(problem, answer, plain, pui.as_ref(), style);
    let mut blocks = vec![Block::Title("Set-membership fit with errors in x".into())];
    blocks.push(Block::Facts(Facts { width: 7, rows: report.facts(origin) }));
    if answer.is_empty() {
        blocks.push(Block::Title("Feasible parameter set (FPS): empty".into()));
        blocks.extend(report.emptiness().into_iter().map(Block::Paragraph));
    } else {
        blocks.push(Block::Title(report.title().into()));
        blocks.extend(report.estimates());
        answer.sides.iter().for_each(|side| blocks.extend(report.side(side)));
        let proofs = report.proofs();
        if !proofs.is_empty() {
            let header = Text::from("multiplier").operator(Operator::Times).words("(row and bound)");
            blocks.push(Block::Title("Proof of each end of the PUI".into()));
            blocks.push(Block::Table(Table::new([Text::new(), Text::new(), header], proofs)));
        }
    }
    blocks.push(Block::Results(report.results()));
    Document::new(blocks)
}

/// The lines of a side in words.
fn lines_of(side: Side) -> &'static str {
    match side {
        Side::Rising => "Rising and level lines",
        Side::Falling => "Falling and level lines",
        Side::Both => "Lines",
    }
}

/// Half-planes of a side by name, the first of them.
fn names(side: &SideSet, indices: &[usize]) -> String {
    let (names, more) = side.active(indices, Ties::MOST_LISTED);
    list_of(names.iter().map(BoxBound::to_string), more)
}

/// The material of all parts of a report.
struct XErrorReport<'a> {
    problem: &'a XErrorProblem,
    answer: &'a XErrorFit,
    plain: &'a Fit,
    style: &'a Style,
    pui: Option<&'a [Interval; 2]>,
    /// The scales that show the values of the two parameters.
    theta: [Scale; 2],
}

impl<'a> XErrorReport<'a> {
    fn new(
        problem: &'a XErrorProblem,
        answer: &'a XErrorFit,
        plain: &'a Fit,
        pui: Option<&'a [Interval; 2]>,
        style: &'a Style,
    ) -> Self {
        let estimates = [
            plain.least_squares.as_ref().ok().map(|own| &own.theta),
            answer.central.as_ref().map(|central| &central.theta),
        ];
        let estimates: Vec<&[Rational; 2]> = estimates.into_iter().flatten().collect();
        let vertices = || answer.sides.iter().flat_map(|side| side.polyhedron.homogeneous_vertices());
        let theta = scales(style, pui, &[], &estimates, vertices);
        XErrorReport { problem, answer, plain, style, pui, theta }
    }

    fn is_weak(&self) -> bool {
        self.problem.agreement() == Agreement::Weak
    }

    fn facts(&self, origin: &Origin) -> Vec<(Text, Text)> {
        let own = self.problem.problem();
        let mut facts = fit_facts(own, self.plain, origin, self.style).rows;
        let x = match own.measurements.model() {
            Model::Line { x } => x.clone(),
            Model::TwoRegressors { .. } => "x".into(),
        };
        let bounded = Text::new().mark("|").words("error of ").given(x).mark("|").operator(Operator::AtMost);
        let bound = match self.problem.bounds() {
            XBounds::Uniform(bound) => bounded.then(self.style.given(bound)),
            XBounds::PerRow { column, .. } => bounded.given(column).words(", one bound per row"),
        };
        let agreement = match self.problem.agreement() {
            Agreement::Weak => "weak: a line has to meet the box of each reading",
            Agreement::Strong => {
                "strong: a line has to keep, all along a box, between its lower and upper side"
            }
        };
        let place = facts.iter().position(|(label, _)| *label == Text::from("data")).unwrap_or(facts.len());
        facts.insert(place, ("x error".into(), bound));
        facts.insert(place + 1, ("asks".into(), agreement.into()));
        facts
    }

    /// The kind of the set, in one line.
    fn title(&self) -> String {
        let pieces = match (self.answer.pieces().len(), self.answer.are_joined()) {
            (2, Some(true)) => "two pieces joined at theta1 = 0",
            (2, _) => "two pieces with a gap between them",
            _ => "one piece",
        };
        format!("Feasible parameter set (FPS): {pieces}")
    }

    /// The table of estimates and intervals, and what its words mean.
    fn estimates(&self) -> Vec<Block<'static>> {
        let intervals = |label: &str, own: &[Interval; 2]| {
            vec![label.into(), self.theta[0].interval(&own[0]), self.theta[1].interval(&own[1])]
        };
        let numbers = |label: &str, own: &[Rational; 2]| {
            let number = |axis: usize| Text::new().number(self.theta[axis].value(&own[axis]));
            vec![label.into(), number(0), number(1)]
        };
        let mut rows: Vec<Vec<Text>> = self.pui.map(|pui| intervals("PUI", pui)).into_iter().collect();
        if self.answer.pieces().len() == 2 {
            for side in self.answer.pieces() {
                let label = if side.side == Side::Rising { "rising" } else { "falling" };
                let own = side.pui.as_ref().map(|pui| pui.each_ref().map(ParameterInterval::interval));
                rows.extend(own.map(|own| {
                    let mut row = intervals("", &own);
                    row[0] = Text::new().with(Inline::Indent).words(label);
                    row
                }));
            }
        }
        if let Some(central) = &self.answer.central {
            rows.extend(bounded_rows(
                "central",
                &central.theta,
                &central.guaranteed_error,
                self.style,
                &self.theta,
            ));
        }
        rows.extend(self.plain.least_squares.as_ref().ok().map(|own| numbers("least squares", &own.theta)));
        let header = [Text::new()].into_iter().chain(THETA.map(Text::from));
        let mut words: Vec<(Text, Text)> = vec![(
            "PUI".into(),
            "parameter uncertainty interval: all values in the feasible set (FPS)".into(),
        )];
        if self.answer.central.is_some() {
            words.push(("central".into(), "the mid-point of the PUI; guaranteed: to half its width".into()));
        }
        if self.plain.least_squares.is_ok() {
            words.push(("least squares".into(), "takes every x for exact".into()));
        }
        let note = if self.style.exact {
            "All numbers are exact."
        } else {
            "Ends and errors are rounded outward; short ones are exact. Estimates stop at the last place of their errors."
        };
        vec![
            Block::Space,
            Block::Table(Table::new(header, rows)),
            Block::Paragraph(note.into()),
            Block::Facts(Facts { width: 7, rows: words }),
        ]
    }

    /// The set of one side.
    fn side<'s>(&self, side: &'s SideSet) -> Vec<Block<'s>> {
        if side.is_empty() {
            let mut blocks = vec![Block::Title(format!("{}: none", lines_of(side.side)).into())];
            blocks.extend(self.contradiction(side).into_iter().map(Block::Paragraph));
            return blocks;
        }
        let names = |indices: &[usize]| names(side, indices);
        let mut blocks = region_blocks(lines_of(side.side), &side.polyhedron, &self.theta, names);
        if side.is_level_only() && self.answer.pieces().iter().all(|piece| piece.side != side.side) {
            let other = if side.side == Side::Rising { "falling" } else { "rising" };
            blocks.push(Block::Paragraph(
                format!("Level lines only (theta1 = 0), which are among the {other} and level ones.").into(),
            ));
        }
        blocks
    }

    /// The readings behind each end of the PUI of all pieces.
    fn proofs(&self) -> Vec<Vec<Text>> {
        let mut rows = Vec::new();
        for axis in [0, 1] {
            for (is_upper, relation) in [(false, Symbol::AtLeast), (true, Symbol::AtMost)] {
                let Some((side, ParameterBound::Bounded { value, proof })) = self.answer.end(axis, is_upper)
                else {
                    continue;
                };
                let terms = proof
                    .multipliers
                    .iter()
                    .map(|m| (self.style.proof(&m.value), side.names[m.index].to_string()));
                let label = Text::from(THETA[axis]).mark(" ").symbol(relation);
                rows.push(vec![label, self.theta[axis].end(relation, value), products(terms)]);
            }
        }
        rows
    }

    /// The remaining results, a line each.
    fn results(&self) -> Vec<(Text, Text)> {
        let mut lines = self.factor();
        if let Some(pui) = self.pui {
            let end = |is_upper| {
                let (side, bound) = self.answer.end(0, is_upper)?;
                Some((bound, |index: usize| side.names[index]))
            };
            lines.extend(slope_lines::of_ends(&pui[0], self.problem.problem(), &self.theta, end));
        }
        if let Some(central) = &self.answer.central
            && !self.answer.contains(&central.theta)
        {
            let said = "is not in the set itself: it lies between lines that agree";
            lines.push(("central".into(), said.into()));
        }
        match &self.plain.least_squares {
            Err(reason) => lines.push(("least squares".into(), format!("none: {reason}").into())),
            Ok(own) => {
                let is_inside = self.answer.contains(&own.theta);
                let said = if is_inside { "feasible" } else { "not feasible" };
                lines.push(("least squares".into(), said.into()));
            }
        }
        if let (Some(minimax), Some(_)) =
            (&self.plain.minimax, self.problem.problem().measurements.error_bound().uniform())
        {
            let text =
                Text::from("if every x were exact: ").then(self.style.upper_with_exact(&minimax.least));
            lines.push((Text::from(Symbol::LeastEpsilon), text));
        }
        lines
    }
}
