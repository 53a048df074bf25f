//! The runs of readings that some parameters agree with.

use boundfit_estimation::{Fit, Measurements, Problem, fit};
use boundfit_formats::Source;
use boundfit_questions::{LinearRange, Order, times};
use boundfit_report::{RangeReport, kernel_range, range_csv, range_document, range_json, range_proof};
use serde::Deserialize;

use crate::asked::Asked;
use crate::form::{Form, Shows, Written};
use crate::misuse::{Misuse, NoProof};
use crate::paper::Paper;
use crate::question::{Ask, AskedTheorem};
use crate::refusal::{Refusal, ValueProblem};

/// Every run of readings that some parameters agree with: the linear range.
#[derive(Debug, Clone, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Range {
    /// The order in which readings are taken: `x`, those at the same x in order of rows, or `row`. Unless it is said, readings of a
    /// line are taken in order of x, and those of two regressors in order of rows.
    pub by: Option<String>,
}

/// The runs, with the fit of all readings and that of the longest run.
pub struct Runs {
    order: Order,
    range: LinearRange,
    all: Fit,
    longest: Option<(Problem, Fit)>,
}

impl Runs {
    fn report<'a>(&'a self, problem: &'a Problem) -> RangeReport<'a> {
        let Runs { order, range, all, longest } = self;
        let longest = longest.as_ref().map(|(problem, fit)| (problem, fit));
        RangeReport { problem, fit: all, order: *order, range, longest }
    }

    /// Refuses to prove what is said of too many runs.
    fn check_proof(&self) -> Result<(), Refusal> {
        NoProof::check(self.range.runs.len(), NoProof::MOST, "runs").map_err(Refusal::NoProof)
    }
}

impl Range {
    fn order(&self) -> Result<Option<Order>, Refusal> {
        match self.by.as_deref() {
            None => Ok(None),
            Some("x") => Ok(Some(Order::X)),
            Some("row") => Ok(Some(Order::Row)),
            Some(other) => {
                let problem = ValueProblem::Expected("expected x or row");
                Err(Refusal::Value { key: "by", text: other.to_owned(), problem })
            }
        }
    }
}

impl Ask for Range {
    const NAME: &'static str = "range";
    const FORMS: &'static [Form] =
        &[Form::Text, Form::Latex, Form::Markdown, Form::Json, Form::Csv, Form::Proof];
    type Problem = Problem;
    type Answer = Runs;

    fn read(&self, asked: &Asked, source: Source, shows: Shows) -> Result<Problem, Refusal> {
        /// Bytes that the budget counts for each reading (780).
        const ROW_COST: usize = 800;
        if self.order()? == Some(Order::X) && asked.question.columns.second.is_some() {
            return Err(Refusal::Misuse(Misuse::OrderOfX));
        }
        let problem = asked.every_reading(source, ROW_COST, shows, Self::NAME)?;
        problem.check_work(times::RANGE, asked.most_work())?;
        Ok(problem)
    }

    fn measurements<'a>(&self, problem: &'a Problem) -> Option<&'a Measurements> {
        Some(&problem.measurements)
    }

    fn answer(&self, problem: &Problem) -> Result<Runs, Refusal> {
        let order = self.order()?.unwrap_or_else(|| Order::natural(problem.measurements.model()));
        let (range, all) = (LinearRange::of(problem, order), fit(problem));
        let longest = range.longest().map(|run| {
            let own = range.problem_of(run, problem, false);
            let fit = fit(&own);
            (own, fit)
        });
        Ok(Runs { order, range, all, longest })
    }

    fn write(&self, problem: &Problem, answer: &Runs, paper: &mut Paper<'_>) -> Result<Written, Refusal> {
        let report = answer.report(problem);
        let Paper { origin, style, .. } = *paper;
        match paper.form {
            Form::Json => paper.put(range_json(&report, &origin, &style)),
            Form::Csv => paper.put(range_csv(&report)),
            Form::Proof => {
                answer.check_proof()?;
                let why = NoProof::about(&problem.measurements);
                paper.put(range_proof(&report, origin.reading).ok_or(Refusal::NoProof(why))?)
            }
            _ => Self::report(paper, || range_document(&report, &origin, &style)),
        }?;
        Ok(Written::of_set(answer.range.runs.is_empty()))
    }

    fn theorem(
        &self,
        problem: &Problem,
        answer: &Runs,
        AskedTheorem { reading, theory, .. }: AskedTheorem<'_>,
    ) -> Result<String, Refusal> {
        answer.check_proof()?;
        let theorem = kernel_range(&answer.report(problem), reading, theory);
        theorem.ok_or(Refusal::NoProof(NoProof::Reduction))
    }
}
