//! The fewest readings to leave out so that something is left.

use boundfit_estimation::{Fit, Measurements, Problem, fit};
use boundfit_formats::Source;
use boundfit_questions::{Growth, NoOutliers, OutlierLimits, times};
use boundfit_report::{
    NoOutliersProof, OutliersReport, kernel_outliers, outliers_csv, outliers_document, outliers_json,
    outliers_proof,
};
use serde::Deserialize;

use crate::asked::Asked;
use crate::form::{Form, Shows, Written};
use crate::misuse::{Misuse, NoProof};
use crate::paper::Paper;
use crate::question::{Ask, AskedTheorem};
use crate::refusal::Refusal;

/// The fewest readings to leave out so that some parameters agree with all others.
#[derive(Debug, Clone, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Outliers {
    /// The number of missed readings up to which the answer shows the growth of the set.
    pub most: Option<usize>,
    /// The number of sets of readings to leave out that are listed.
    pub max_sets: Option<usize>,
    /// The limit on the crossings of bounds that the search looks at.
    pub max_steps: Option<u64>,
}

/// The outliers, with the fit of all readings.
pub struct Found {
    fit: Fit,
    outliers: Result<boundfit_questions::Outliers, NoOutliers>,
    growth: Vec<Growth>,
}

impl Outliers {
    fn limits(&self) -> OutlierLimits {
        let usual = OutlierLimits::default();
        OutlierLimits {
            sets: self.max_sets.unwrap_or(usual.sets),
            steps: self.max_steps.unwrap_or(usual.steps),
        }
    }
}

impl Ask for Outliers {
    const NAME: &'static str = "outliers";
    const FORMS: &'static [Form] =
        &[Form::Text, Form::Latex, Form::Markdown, Form::Json, Form::Csv, Form::Proof];
    type Problem = Problem;
    type Answer = Found;

    fn read(&self, asked: &Asked, source: Source, shows: Shows) -> Result<Problem, Refusal> {
        /// Bytes that the budget counts for each reading (1,500 where the search stops early).
        const ROW_COST: usize = 2_000;
        let problem = asked.counted_readings(source, ROW_COST, shows, Self::NAME)?;
        times::check_outliers(&problem, asked.most_work())?;
        Ok(problem)
    }

    fn measurements<'a>(&self, problem: &'a Problem) -> Option<&'a Measurements> {
        Some(&problem.measurements)
    }

    fn answer(&self, problem: &Problem) -> Result<Found, Refusal> {
        let limits = self.limits();
        let refused = |why| Refusal::Outliers { why, steps: Some(limits.steps) };
        let fit = fit(problem);
        let outliers = match boundfit_questions::Outliers::new(problem, &limits) {
            Err(why) if !matches!(why, NoOutliers::Conditions(_)) => return Err(refused(why)),
            outliers => outliers,
        };
        let growth = match &outliers {
            Ok(outliers) => match outliers.growth(problem, self.most.unwrap_or(outliers.least), &limits) {
                // A part that the question did not ask for is omitted if it takes too much.
                Err(_) if self.most.is_none() => Vec::new(),
                growth => growth.map_err(refused)?,
            },
            Err(_) => Vec::new(),
        };
        Ok(Found { fit, outliers, growth })
    }

    fn write(&self, problem: &Problem, answer: &Found, paper: &mut Paper<'_>) -> Result<Written, Refusal> {
        let Found { fit, outliers, growth } = answer;
        let shows_growth = self.most.is_some() && outliers.is_ok();
        let report = OutliersReport { problem, fit, outliers: outliers.as_ref(), growth, shows_growth };
        let Paper { origin, style, .. } = *paper;
        match paper.form {
            Form::Json => paper.put(outliers_json(&report, &origin, &style)),
            Form::Csv => paper.put(outliers_csv(outliers.as_ref().ok())),
            Form::Proof => {
                paper.put(outliers_proof(&report, origin.reading).map_err(|why| no_proof(why, problem))?)
            }
            _ => Self::report(paper, || outliers_document(&report, &origin, &style)),
        }?;
        Ok(Written::of_set(outliers.is_err()))
    }

    fn refuse_vain(&self, form: Form) -> Result<(), Refusal> {
        match self.most.is_some() && form == Form::Csv {
            true => Err(Refusal::Misuse(Misuse::VainMost)),
            false => Ok(()),
        }
    }

    fn theorem(
        &self,
        problem: &Problem,
        answer: &Found,
        AskedTheorem { reading, theory, .. }: AskedTheorem<'_>,
    ) -> Result<String, Refusal> {
        let Found { fit, outliers, growth } = answer;
        let report =
            OutliersReport { problem, fit, outliers: outliers.as_ref(), growth, shows_growth: false };
        kernel_outliers(&report, reading, theory).map_err(|why| no_proof(why, problem))
    }
}

fn no_proof(why: NoOutliersProof, problem: &Problem) -> Refusal {
    Refusal::NoProof(match why {
        NoOutliersProof::NoText => NoProof::about(&problem.measurements),
        NoOutliersProof::NotInMemory => NoProof::Reduction,
        NoOutliersProof::TooMany(most) => NoProof::TooMany { most, of: "contradictions" },
    })
}
