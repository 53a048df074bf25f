//! The values of the line, the places of further readings, and the places that readings may come from.

mod values;

use std::io::{BufWriter, Write};

use boundfit_estimation::{AskedBound, Fit, Keep, Law, Measurements, Problem, fit};
use boundfit_exact::{Limits, Rational, Reading};
use boundfit_formats::Source;
use boundfit_questions::{FurtherError, NoFurtherError, times};
use boundfit_report::{
    AskedValues, Origin, Prediction, kernel_prediction, prediction_document, prediction_proof,
    write_prediction_csv, write_prediction_json,
};
use serde::Deserialize;

use crate::asked::Asked;
use crate::form::{Form, Shows, Written};
use crate::misuse::{Misuse, NoProof};
use crate::paper::Paper;
use crate::question::{Ask, AskedTheorem};
use crate::refusal::{Refusal, ValueProblem};
use crate::value_problem::no_law_of_x;
use values::{ValueKey, Values};

/// Values that a theorem may be about: Coq's time for its last step grows with their square, and these take some ten seconds.
const MOST_IN_THEOREM: usize = 200;

/// The question for the line at an x, for the place of a further reading there, and for the x that a reading may come
/// from.
#[derive(Debug, Clone, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct Predict {
    /// The x in question: each text is numbers, `3.7,9/2`, or a column of a table, `FILE:COL`. Two regressors have
    /// pairs, `1;2,3;4`, or `FILE:COL;COL2`.
    pub at: Vec<String>,
    /// The readings whose possible x are asked for, as in `at`.
    pub from: Vec<String>,
    /// Values of x in equal steps, `FROM..TO/N` such as `0..10/5`, before those of `at`.
    pub grid: Option<String>,
    /// The error bound of a further reading, where it is not that of the fitted ones: a number, or a law.
    pub new_eps: Option<String>,
    /// `true` shows in reports the readings that prove each end.
    pub proofs: bool,
}

/// A problem, and the values that are asked about.
pub struct Predicted {
    problem: Problem,
    error: Result<FurtherError, NoFurtherError>,
    law: Option<Law>,
    at: Values,
    from: Values,
}

/// Gives values anew each time.
type Given<'a> = &'a (dyn Fn() -> Box<dyn Iterator<Item = [Rational; 2]> + 'a> + 'a);

impl Predicted {
    /// The material of what is written.
    fn prediction<'a>(
        &'a self,
        fit: &'a Fit,
        origin: Origin<'a>,
        [at, from]: [Given<'a>; 2],
    ) -> Prediction<'a> {
        Prediction {
            problem: &self.problem,
            fit,
            origin,
            error: self.error.clone(),
            given: self.law.clone(),
            at: AskedValues { count: self.at.len(), values: at },
            from: AskedValues { count: self.from.len(), values: from },
        }
    }

    /// Refuses to prove statements about too many values.
    fn check_proof(&self, most: usize) -> Result<(), Refusal> {
        NoProof::check(self.at.len() + self.from.len(), most, "values").map_err(Refusal::NoProof)
    }
}

impl Predict {
    /// Returns the law that is stated for the error of a further reading.
    fn law(&self, limits: &Limits, is_line: bool) -> Result<Option<Law>, Refusal> {
        let Some(text) = &self.new_eps else { return Ok(None) };
        let refuse = |problem| Refusal::Value { key: "new_eps", text: text.clone(), problem };
        let law = Law::parse(text, Reading::Decimal, limits);
        let law = law.map_err(|error| match AskedBound::parse(text, Reading::Decimal, limits) {
            Ok(AskedBound::TimesLeast(_)) => refuse(ValueProblem::Expected(
                "a multiple of the least bound says nothing of a further reading (expected a number such as 0.5, or a law)",
            )),
            _ => refuse(ValueProblem::Bound(error)),
        })?;
        if law.needs_x() && !is_line {
            return Err(refuse(ValueProblem::Other(no_law_of_x("|y| and range(y)"))));
        }
        Ok(Some(law))
    }

    /// The values, at which it is predicted and where readings come from.
    fn values(&self, asked: &Asked, is_line: bool) -> Result<[Values; 2], Refusal> {
        if !is_line && (!self.from.is_empty() || self.grid.is_some()) {
            let is_grid = self.from.is_empty();
            let misuse = if is_grid { Misuse::GridOfTwoRegressors } else { Misuse::FromOfTwoRegressors };
            return Err(Refusal::Misuse(misuse));
        }
        if self.at.is_empty() && self.from.is_empty() && self.grid.is_none() {
            return Err(Refusal::Misuse(Misuse::NothingToPredict));
        }
        let at = ValueKey { key: "at", numbers: if is_line { 1 } else { 2 }, second: 1 };
        let from = ValueKey { key: "from", numbers: 1, second: 0 };
        let (at, from) = (Values::read(at, &self.at, asked)?, Values::read(from, &self.from, asked)?);
        let at = match &self.grid {
            Some(grid) => at.with_grid(grid, asked)?,
            None => at,
        };
        Ok([at, from])
    }

    /// Refuses to ask where a reading comes from of which nothing is known.
    fn check(&self, error: &Result<FurtherError, NoFurtherError>) -> Result<(), Refusal> {
        match (error, &self.new_eps) {
            (Err(reason), Some(text)) => {
                let problem = ValueProblem::Other(format!("{reason} (expected a number such as 0.5)"));
                Err(Refusal::Value { key: "new_eps", text: text.clone(), problem })
            }
            (Err(reason), None) if !self.from.is_empty() => Err(Refusal::FurtherError(reason.clone())),
            _ => Ok(()),
        }
    }
}

impl Ask for Predict {
    const NAME: &'static str = "predict";
    const FORMS: &'static [Form] =
        &[Form::Text, Form::Latex, Form::Markdown, Form::Json, Form::Csv, Form::Proof];
    type Problem = Predicted;
    type Answer = Fit;

    fn read(&self, asked: &Asked, source: Source, shows: Shows) -> Result<Predicted, Refusal> {
        let is_line = asked.question.columns.second.is_none();
        let law = self.law(&asked.options.table.limits, is_line)?;
        let [at, from] = self.values(asked, is_line)?;
        // A law may take the range of all readings.
        let usual = if law.is_some() { Keep::default() } else { Keep::DECIDING };
        let keep = Keep { eui: false, ..if shows >= Shows::Readings { Keep::EVERY } else { usual } };
        let problem = asked.scanned(source, (Asked::ROW_COST, shows), keep)?;
        let bits = times::bits_of_corner(&problem);
        for values in [&at, &from] {
            values.work(bits).check(times::PREDICT, asked.most_work())?;
        }
        let error = match &law {
            None => FurtherError::of(&problem.measurements),
            Some(law) => FurtherError::by_law(law, &problem.measurements),
        };
        self.check(&error)?;
        Ok(Predicted { problem, error, law, at, from })
    }

    fn measurements<'a>(&self, asked: &'a Predicted) -> Option<&'a Measurements> {
        Some(&asked.problem.measurements)
    }

    fn answer(&self, asked: &Predicted) -> Result<Fit, Refusal> {
        Ok(fit(&asked.problem))
    }

    fn write(&self, asked: &Predicted, fit: &Fit, paper: &mut Paper<'_>) -> Result<Written, Refusal> {
        let Predicted { problem, at, from, .. } = asked;
        let Paper { form, origin, style, .. } = *paper;
        let (at_values, from_values) = (|| at.iter(), || from.iter());
        let prediction = asked.prediction(fit, origin, [&at_values, &from_values]);
        match form {
            Form::Csv if at.len() > 0 && from.len() > 0 => return Err(Refusal::Misuse(Misuse::TwoTables)),
            // There may be a million of them.
            Form::Csv | Form::Json => {
                let mut buffer = BufWriter::with_capacity(1 << 16, &mut *paper.out);
                match form {
                    Form::Csv => write_prediction_csv(&prediction, &mut buffer)?,
                    _ => write_prediction_json(&prediction, &style, &mut buffer)?,
                }
                buffer.flush()?;
            }
            Form::Proof => {
                asked.check_proof(NoProof::MOST)?;
                let why = NoProof::about(&problem.measurements);
                paper.put(prediction_proof(&prediction, origin.reading).ok_or(Refusal::NoProof(why))?)?;
            }
            _ => Self::report(paper, || prediction_document(&prediction, self.proofs, &style))?,
        }
        Ok(Written::of_set(fit.is_empty()))
    }

    fn refuse_vain(&self, form: Form) -> Result<(), Refusal> {
        match self.proofs && matches!(form, Form::Csv | Form::Json) {
            true => Err(Refusal::Misuse(Misuse::VainProofs)),
            false => Ok(()),
        }
    }

    fn theorem(
        &self,
        asked: &Predicted,
        fit: &Fit,
        AskedTheorem { reading, theory, .. }: AskedTheorem<'_>,
    ) -> Result<String, Refusal> {
        asked.check_proof(MOST_IN_THEOREM)?;
        let (at, from) = (|| asked.at.iter(), || asked.from.iter());
        let origin = Origin { file: None, reading, is_stored: false };
        let prediction = asked.prediction(fit, origin, [&at, &from]);
        kernel_prediction(&prediction, reading, theory).ok_or(Refusal::NoProof(NoProof::Reduction))
    }
}
