//! The judgement of answers to the linear programs of a fit.

use std::time::Duration;

use boundfit_check::{
    self as engine, Answer, AskedDirections, CheckOptions, ClaimFileError, ClaimLimits, ClaimText, Claims,
    parse_claim_pui, read_claims, source_names,
};
use boundfit_estimation::{Keep, Measurements, Problem, fit};
use boundfit_exact::{Foreign, Limits, Rational, Reading};
use boundfit_formats::{Source, TableOptions};
use boundfit_report::{check_document, check_json};
use serde::Deserialize;

use crate::asked::Asked;
use crate::fit;
use crate::form::{Form, Shows, Written};
use crate::given::Given;
use crate::misuse::Misuse;
use crate::paper::Paper;
use crate::question::{Ask, AskedTheorem};
use crate::refusal::{Refusal, ValueProblem};

/// The question which ends of the intervals of both parameters are right, of those that solvers find and others claim.
#[derive(Debug, Clone, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct Check {
    /// The solvers to judge, by name. Without solvers, claims and directions these are all solvers that there are.
    pub solver: Vec<String>,
    /// The files of claims to judge: JSON, or solutions of the linear programs of the fit.
    pub claim: Vec<ClaimFile>,
    /// The claimed ends to judge: each text is `LO1,HI1,LO2,HI2`, where `-inf` and `inf` claim that there is no end.
    pub claim_pui: Vec<String>,
    /// The distance by which an end may be off, in widths of its interval, and a point outside, in units of ε; 1e-6 by
    /// default.
    pub tolerance: Option<Given>,
    /// `false` takes numbers in texts for exact; otherwise they are as precise as printed.
    pub digits_as_printed: Option<bool>,
    /// `true` gives solvers the rows of all readings, also of those that cannot bound the set.
    pub all_rows: bool,
    /// The number of directions in which optimal points are compared with the set, from 3 to 10000.
    pub directions: Option<u16>,
    /// `true` spreads the directions evenly after the box of both intervals is scaled to a square.
    pub scaled: bool,
    /// The seconds that a solver may spend on one program, from 1 to 86400; 60 by default.
    pub time_limit: Option<u64>,
}

/// A file of claims, or of a solution.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct ClaimFile {
    /// The name, which tells `check` the program that a solution answers: `theta1-min`, `theta1-max`, `theta2-min` or
    /// `theta2-max`.
    pub file: String,
    /// The content.
    pub text: String,
}

/// A problem, and whose answers about it are judged.
pub struct Checkable {
    problem: Problem,
    reading: Reading,
    options: CheckOptions,
}

/// Returns the distance by which an answer may be off: at least 0, and 1e-6 unless it is said. Limits lower than usual are
/// meant for the data and leave it alone.
pub(crate) fn tolerance(given: Option<&Given>, asked: &Limits) -> Result<Rational, Refusal> {
    const EXPECTED: &str = "expected a number that is at least 0, such as 1e-6";
    let Some(given) = given else { return Ok(Rational::ratio(1, 1_000_000)) };
    let usual = Limits::default();
    let limits =
        Limits { digits: asked.digits.max(usual.digits), exponent: asked.exponent.max(usual.exponent) };
    let tolerance = given.exact("tolerance", EXPECTED, &limits)?;
    match tolerance.is_negative() {
        true => Err(given.refused("tolerance", ValueProblem::Expected(EXPECTED))),
        false => Ok(tolerance),
    }
}

impl Check {
    fn claims(&self, asked: &Asked) -> Result<Claims, Refusal> {
        let table = &asked.options.table;
        let limits =
            ClaimLimits { number: table.limits, nesting: table.sizes.nesting, work: table.sizes.work };
        let texts =
            self.claim.iter().map(|own| ClaimText { file: Foreign::from(&own.file), text: own.text.clone() });
        read_claims(&texts.collect::<Vec<_>>(), &limits).map_err(|ClaimFileError { file, problem }| {
            let why = Refusal::Claim { limit: problem.limit(), problem: problem.to_string() };
            Refusal::OfFile { file, why: Box::new(why) }
        })
    }

    /// All options but the answers in files.
    fn options(&self, claims: &Claims, limits: &Limits) -> Result<CheckOptions, Refusal> {
        let ends = |text: &String| {
            parse_claim_pui(text).map_err(|error| {
                let problem = ValueProblem::Other(error.to_string());
                Refusal::Value { key: "claim_pui", text: text.clone(), problem }
            })
        };
        let answers = self.claim_pui.iter().map(ends).collect::<Result<Vec<Answer>, _>>()?;
        let tolerance = tolerance(self.tolerance.as_ref(), limits)?;
        let ranges = [
            ("directions", self.directions.map(u64::from), 3..=10_000, "expected an integer from 3 to 10000"),
            ("time_limit", self.time_limit, 1..=86_400, "expected an integer from 1 to 86400"),
        ];
        for (key, given, range, expected) in ranges {
            if let Some(number) = given.filter(|number| !range.contains(number)) {
                let problem = ValueProblem::Expected(expected);
                return Err(Refusal::Value { key, text: number.to_string(), problem });
            }
        }
        if self.scaled && self.directions.is_none() {
            return Err(Refusal::Misuse(Misuse::ScaledAlone));
        }
        // Without a word about whom to judge, everybody is.
        let is_open = self.solver.is_empty()
            && answers.is_empty()
            && self.claim.is_empty()
            && self.directions.is_none();
        Ok(CheckOptions {
            solvers: if is_open { source_names() } else { self.solver.clone() },
            answers,
            tolerance,
            as_printed: self.digits_as_printed.unwrap_or(true),
            time_limit: Duration::from_secs(self.time_limit.unwrap_or(60)),
            directions: self
                .directions
                .map(|count| AskedDirections { count: count.into(), is_scaled: self.scaled }),
            all_rows: self.all_rows || claims.have_duals(),
        })
    }
}

impl Ask for Check {
    const NAME: &'static str = "check";
    const FORMS: &'static [Form] = &[Form::Text, Form::Json];
    type Problem = Checkable;
    type Answer = engine::Check;

    fn read(&self, asked: &Asked, source: Source, shows: Shows) -> Result<Checkable, Refusal> {
        /// The cost of linear programs, and of the exact simplex that judges their answers, relative to a fit.
        const TIMES: u64 = 4;
        let table = &asked.options.table;
        let claims = self.claims(asked)?;
        let mut options = self.options(&claims, &table.limits)?;
        let problem = if options.all_rows || shows >= Shows::Readings {
            asked.read(source, &TableOptions { row_cost: Asked::ROW_COST, ..table.clone() })?
        } else {
            // Readings that can bound nothing under any error bound are no rows of a program.
            let keep = if asked.question.columns.are_open() { Keep::default() } else { Keep::EVERY };
            asked.scanned(source, (Asked::ROW_COST, Shows::Rows), Keep { eui: false, ..keep })?
        };
        options.answers.splice(..0, claims.answers(&problem));
        problem.check_work(TIMES, asked.most_work())?;
        Ok(Checkable { problem, reading: table.reading, options })
    }

    fn measurements<'a>(&self, asked: &'a Checkable) -> Option<&'a Measurements> {
        Some(&asked.problem.measurements)
    }

    fn answer(&self, asked: &Checkable) -> Result<engine::Check, Refusal> {
        engine::check(&asked.problem, asked.reading, &asked.options)
            .map_err(|no_solver| Refusal::Request(no_solver.to_string()))
    }

    fn write(
        &self,
        Checkable { problem, reading, .. }: &Checkable,
        answer: &engine::Check,
        paper: &mut Paper<'_>,
    ) -> Result<Written, Refusal> {
        let Paper { origin, style, .. } = &*paper;
        let measurements = &problem.measurements;
        let text = match paper.form {
            Form::Json => check_json(answer, measurements, origin.file, *reading, style),
            Form::Text => check_document(answer, measurements, origin.name(), *reading, style).to_text(),
            form => return Err(Self::no_form(form)),
        };
        paper.put(text)?;
        let is_refuted = answer.worst(*reading).is_some_and(|worst| worst.is_refutation());
        Ok(Written { is_refuted, ..Written::default() })
    }

    /// The theorem about the set, which states its four ends.
    fn theorem(
        &self,
        Checkable { problem, .. }: &Checkable,
        _: &engine::Check,
        told: AskedTheorem<'_>,
    ) -> Result<String, Refusal> {
        fit::theorem(problem, &fit(problem), told)
    }
}
