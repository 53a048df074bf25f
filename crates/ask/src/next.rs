//! The place where the next reading certainly makes the set smaller, and the x of a range that leaves the least at
//! worst.

use boundfit_estimation::{Fit, Keep, Measurements, Problem, fit};
use boundfit_exact::{Limits, Rational};
use boundfit_formats::Source;
use boundfit_questions::{FurtherError, Goal, NextReading, times};
use boundfit_report::{NextReadingReport, next_reading_csv, next_reading_document, next_reading_json};
use serde::Deserialize;

use crate::asked::Asked;
use crate::form::{Form, Shows, Written};
use crate::given::Given;
use crate::misuse::Misuse;
use crate::paper::Paper;
use crate::question::Ask;
use crate::refusal::{Refusal, ValueProblem};

/// The question where the next reading of a line certainly makes the set smaller, and which x of a range makes its
/// worst outcome best.
#[derive(Debug, Clone, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct Next {
    /// The range of x in which the reading is to be taken, the lower end first; that of the readings unless it is said.
    pub within: Option<[Given; 2]>,
    /// The goal: `theta1` or `theta2`, the length of its interval, or `area`; all three unless it is said.
    pub goal: Option<String>,
    /// The error bound of the reading; that of the fitted ones unless it is said.
    pub new_eps: Option<Given>,
}

/// A problem, and the numbers of the question.
pub struct NextProblem {
    problem: Problem,
    epsilon: Rational,
    within: Option<[Rational; 2]>,
    goals: Vec<Goal>,
}

impl Next {
    fn goals(&self) -> Result<Vec<Goal>, Refusal> {
        let Some(text) = &self.goal else { return Ok(Goal::ALL.to_vec()) };
        let goal = Goal::ALL.into_iter().find(|goal| goal.name() == text);
        let problem = ValueProblem::Expected("expected theta1, theta2 or area");
        goal.map(|goal| vec![goal]).ok_or_else(|| Refusal::Value { key: "goal", text: text.clone(), problem })
    }

    fn range(&self, limits: &Limits) -> Result<Option<[Rational; 2]>, Refusal> {
        const EXPECTED: &str = "expected two numbers, the lower one first, such as -10 and 10";
        let Some([lower, upper]) = &self.within else { return Ok(None) };
        let ends = [lower.exact("within", EXPECTED, limits)?, upper.exact("within", EXPECTED, limits)?];
        if ends[0] > ends[1] {
            let text = format!("{}..{}", lower.text(), upper.text());
            return Err(Refusal::Value { key: "within", text, problem: ValueProblem::Expected(EXPECTED) });
        }
        Ok(Some(ends))
    }

    /// The error bound that was asked for.
    fn bound(&self, limits: &Limits) -> Result<Option<Rational>, Refusal> {
        const EXPECTED: &str = "expected one number for both sides that is not negative, such as 0.5";
        let Some(given) = &self.new_eps else { return Ok(None) };
        let number = given.exact("new_eps", EXPECTED, limits)?;
        match number.is_negative() {
            true => Err(given.refused("new_eps", ValueProblem::Expected(EXPECTED))),
            false => Ok(Some(number)),
        }
    }
}

/// The error bound that the fitted readings have in common.
///
/// # Errors
/// [`Refusal::NextError`] where they have none.
pub fn common_bound(problem: &Problem) -> Result<Rational, Refusal> {
    let error = FurtherError::of(&problem.measurements);
    let error = error.map_err(|reason| Refusal::NextError(reason.to_string()))?;
    let of_law = || {
        Refusal::NextError(
            "the readings do not all have one error bound, the same above and below".to_owned(),
        )
    };
    error.uniform().cloned().ok_or_else(of_law)
}

impl Ask for Next {
    const NAME: &'static str = "next";
    const FORMS: &'static [Form] = &[Form::Text, Form::Latex, Form::Markdown, Form::Json, Form::Csv];
    type Problem = NextProblem;
    type Answer = (Fit, Option<NextReading>);

    fn read(&self, asked: &Asked, source: Source, shows: Shows) -> Result<NextProblem, Refusal> {
        let limits = &asked.options.table.limits;
        let (goals, within, given) = (self.goals()?, self.range(limits)?, self.bound(limits)?);
        if asked.question.columns.second.is_some() {
            return Err(Refusal::Misuse(Misuse::NextOfTwoRegressors));
        }
        let keep = Keep { eui: false, ..Keep::DECIDING };
        let problem = asked.scanned(source, (Asked::ROW_COST, shows), keep)?;
        problem.check_work(times::NEXT, asked.most_work())?;
        let epsilon = given.map_or_else(|| common_bound(&problem), Ok)?;
        Ok(NextProblem { problem, epsilon, within, goals })
    }

    fn measurements<'a>(&self, asked: &'a NextProblem) -> Option<&'a Measurements> {
        Some(&asked.problem.measurements)
    }

    fn answer(&self, asked: &NextProblem) -> Result<(Fit, Option<NextReading>), Refusal> {
        let NextProblem { problem, epsilon, within, goals } = asked;
        let fit = fit(problem);
        let next = NextReading::of(problem, &fit, epsilon, within.as_ref(), goals);
        Ok((fit, next))
    }

    fn write(
        &self,
        asked: &NextProblem,
        (fit, next): &(Fit, Option<NextReading>),
        paper: &mut Paper<'_>,
    ) -> Result<Written, Refusal> {
        let Paper { origin, style, .. } = *paper;
        let report = NextReadingReport {
            problem: &asked.problem,
            fit,
            epsilon: &asked.epsilon,
            is_epsilon_given: self.new_eps.is_some(),
            is_range_given: asked.within.is_some(),
            next: next.as_ref(),
        };
        match paper.form {
            Form::Json => paper.put(next_reading_json(&report, &origin, &style)),
            Form::Csv => paper.put(next_reading_csv(&report)),
            _ => Self::report(paper, || next_reading_document(&report, &origin, &style)),
        }?;
        Ok(Written::of_set(fit.is_empty()))
    }
}
