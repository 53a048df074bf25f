//! The lines that agree with readings whose x have errors, too.

use boundfit_estimation::{Fit, Measurements, fit};
use boundfit_formats::Source;
use boundfit_questions::{XErrorFit, XErrorProblem};
use boundfit_report::{x_error_csv, x_error_document, x_error_json, x_error_proof, x_error_wkt};
use serde::Deserialize;

use crate::asked::Asked;
use crate::form::{Form, Shows, Written};
use crate::misuse::NoProof;
use crate::paper::Paper;
use crate::question::Ask;
use crate::refusal::Refusal;

/// The lines that agree with every reading where x has errors, too.
#[derive(Debug, Clone, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct FitXErrors {}

impl FitXErrors {
    /// Bytes that the budget counts for each reading (2,400).
    pub const ROW_COST: usize = 2_700;
}

impl Ask for FitXErrors {
    const NAME: &'static str = "fit-x-errors";
    const FORMS: &'static [Form] =
        &[Form::Text, Form::Latex, Form::Markdown, Form::Json, Form::Csv, Form::Wkt, Form::Proof];
    const LOOKS_AT_X_ERRORS: bool = true;
    type Problem = XErrorProblem;
    /// The sets, and the fit as if x had no errors.
    type Answer = (XErrorFit, Fit);

    fn read(&self, asked: &Asked, source: Source, shows: Shows) -> Result<XErrorProblem, Refusal> {
        asked.x_error_problem(source, Self::ROW_COST, shows, false)
    }

    fn measurements<'a>(&self, problem: &'a XErrorProblem) -> Option<&'a Measurements> {
        Some(&problem.problem().measurements)
    }

    fn answer(&self, problem: &XErrorProblem) -> Result<(XErrorFit, Fit), Refusal> {
        Ok((problem.fit(), fit(problem.problem())))
    }

    fn write(
        &self,
        problem: &XErrorProblem,
        (answer, plain): &(XErrorFit, Fit),
        paper: &mut Paper<'_>,
    ) -> Result<Written, Refusal> {
        let Paper { origin, style, .. } = *paper;
        match paper.form {
            Form::Json => paper.put(x_error_json(problem, answer, plain, &origin, &style)),
            Form::Csv => paper.put(x_error_csv(answer, plain)),
            Form::Wkt => paper.put(x_error_wkt(answer, &style).map_err(Refusal::Wkt)?),
            Form::Proof => {
                let why = NoProof::about(&problem.problem().measurements);
                paper.put(x_error_proof(problem, answer, origin.reading).ok_or(Refusal::NoProof(why))?)
            }
            _ => Self::report(paper, || x_error_document(problem, answer, plain, &origin, &style)),
        }?;
        Ok(Written::of_set(answer.is_empty()))
    }
}
