//! The distance of a sensor from a straight line.

use boundfit_estimation::{Keep, Measurements};
use boundfit_exact::{Limits, Rational, Reading, Work};
use boundfit_formats::{Again, ColumnSelector, Source, TableNotes, TableOptions};
use boundfit_questions::{
    Calibration, CalibrationColumns, CalibrationError, CalibrationResponse, LinearityOptions, times,
};
use boundfit_report::{
    linearity_csv, linearity_document, linearity_json, linearity_proof, linearity_question,
};
use serde::Deserialize;

use crate::asked::Asked;
use crate::form::{Form, Shows, Written};
use crate::given::Given;
use crate::misuse::{Misuse, NoProof};
use crate::paper::Paper;
use crate::question::{Ask, Subject};
use crate::refusal::{Refusal, ValueProblem};

/// Independent, terminal, zero-based and least-squares linearity of readings y, or of those in two columns, up and down.
///
/// The bounds on the errors have no say in it.
#[derive(Debug, Clone, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Linearity {
    /// The column of readings while x was rising.
    pub up: Option<String>,
    /// The column of readings while x was falling.
    pub down: Option<String>,
    /// The column that says whether x was rising, beside y.
    pub direction: Option<String>,
    /// The full scale of percents; the span of y by default.
    pub full_scale: Option<Given>,
    /// The point that the line of zero-based linearity goes through; 0,0 unless it is said.
    pub through: Option<Through>,
    /// `true` keeps every reading, for a picture.
    #[serde(skip)]
    pub keeps_every: bool,
}

/// A point: `"2.5,-1/3"`, or a list of both numbers.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(untagged, expecting = "two numbers, as \"2.5,-1/3\" or a list")]
pub enum Through {
    /// `"2.5,-1/3"`.
    Text(String),
    /// Both numbers.
    Point([Given; 2]),
}

/// A calibration, and what is asked of it.
pub struct Calibrated {
    calibration: Calibration,
    columns: CalibrationColumns,
    options: LinearityOptions,
    table: TableOptions,
    again: Option<Again>,
}

impl Calibrated {
    /// The names and units of the columns, and what they were read from.
    pub fn input(&self) -> &boundfit_questions::LinearityInput {
        &self.calibration.input
    }
}

impl Linearity {
    fn columns(&self, asked: &Asked) -> Result<CalibrationColumns, Refusal> {
        let columns = &asked.question.columns;
        let named = |key: &Option<String>| key.as_deref().map(ColumnSelector::name_or_number);
        let given = (columns.response.clone(), named(&self.up), named(&self.down), named(&self.direction));
        let response = match given {
            (Some(y), None, None, None) => CalibrationResponse::One(y),
            (Some(y), None, None, Some(direction)) => CalibrationResponse::Directed { y, direction },
            (None, Some(up), Some(down), None) => CalibrationResponse::Two { up, down },
            _ => return Err(Refusal::Misuse(Misuse::Response)),
        };
        let misuses = [
            (columns.second.is_some(), Misuse::LinearityOfTwoRegressors),
            (!asked.question.conditions.is_empty(), Misuse::LinearityUnderConditions),
            (columns.form.through_origin, Misuse::LinearityThroughOrigin),
            (!columns.form.x_origin.is_zero(), Misuse::LinearityFromOrigin),
        ];
        if let Some((_, misuse)) = misuses.into_iter().find(|(is_there, _)| *is_there) {
            return Err(Refusal::Misuse(misuse));
        }
        Ok(CalibrationColumns { x: columns.first.clone(), response })
    }

    fn options(&self, limits: &Limits) -> Result<LinearityOptions, Refusal> {
        const FULL: &str = "expected a number above 0, such as 4 or 153/40";
        const POINT: &str = "expected two numbers X,Y such as 0,0 or 2.5,-1/3";
        let full_scale = match &self.full_scale {
            None => None,
            Some(given) => Some(given.exact("full_scale", FULL, limits)?),
        };
        if let (Some(given), Some(number)) = (&self.full_scale, &full_scale)
            && !number.is_positive()
        {
            return Err(given.refused("full_scale", ValueProblem::Expected(FULL)));
        }
        let through = match &self.through {
            None => <[Rational; 2]>::default(),
            Some(Through::Point([x, y])) => {
                [x.exact("through", POINT, limits)?, y.exact("through", POINT, limits)?]
            }
            Some(Through::Text(text)) => {
                let refuse = |problem| Refusal::Value { key: "through", text: text.clone(), problem };
                let (x, y) = text.split_once(',').ok_or_else(|| refuse(ValueProblem::Expected(POINT)))?;
                let number = |text: &str| {
                    let number = Reading::Decimal.read(text.trim(), limits);
                    number.map_err(|error| refuse(ValueProblem::Number { error, expected: POINT }))
                };
                [number(x)?, number(y)?]
            }
        };
        Ok(LinearityOptions { full_scale, through })
    }
}

impl Ask for Linearity {
    const NAME: &'static str = "linearity";
    const FORMS: &'static [Form] =
        &[Form::Text, Form::Latex, Form::Markdown, Form::Json, Form::Csv, Form::Proof];
    const SUBJECT: Subject = Subject::Readings;
    type Problem = Calibrated;
    type Answer = boundfit_questions::Linearity;

    fn read(&self, asked: &Asked, source: Source, shows: Shows) -> Result<Calibrated, Refusal> {
        /// Bytes that the budget counts for each reading (850).
        const ROW_COST: usize = 900;
        const MOST_USUAL_BITS: u64 = 1_000;
        let columns = self.columns(asked)?;
        let options = self.options(&asked.options.table.limits)?;
        let again = source.again();
        if shows >= Shows::Rows && again.is_none() {
            return Err(Refusal::NoProof(NoProof::ReadOnce));
        }
        let given = [options.full_scale.as_ref(), Some(&options.through[0]), Some(&options.through[1])];
        // Beside usual numbers, readings that do not decide make no work that is counted.
        let is_usual = given.iter().flatten().map(|given| given.bits()).sum::<u64>() <= MOST_USUAL_BITS;
        let held = asked.held(ROW_COST, shows);
        let calibration = match is_usual && !self.keeps_every {
            true => Calibration::read(source, &columns, &held),
            false => Calibration::read_counted(source, &columns, &held, Keep::MOST_ROWS),
        };
        let calibration = calibration.map_err(|error| match error {
            CalibrationError::Input(error) => Refusal::Input(error),
            CalibrationError::Row { problem, .. } => Refusal::Readings(problem),
        })?;
        let mut work = Work::default();
        for reading in &calibration.readings {
            work.add(reading.row, [&reading.x, &reading.y].into_iter().chain(given.into_iter().flatten()));
        }
        work.check(times::LINEARITY, asked.most_work())?;
        Ok(Calibrated { calibration, columns, options, table: asked.options.table.clone(), again })
    }

    fn measurements<'a>(&self, _: &'a Calibrated) -> Option<&'a Measurements> {
        None
    }

    fn table<'a>(&self, problem: &'a Calibrated) -> Option<&'a TableNotes> {
        problem.input().table.as_ref()
    }

    fn rows_missing(&self, problem: &Calibrated) -> usize {
        problem.input().rows_missing
    }

    fn answer(&self, problem: &Calibrated) -> Result<Self::Answer, Refusal> {
        let found = problem.calibration.linearity(&problem.options);
        found.ok_or_else(|| Refusal::Readings("there are no readings".to_owned()))
    }

    fn write(
        &self,
        problem: &Calibrated,
        answer: &Self::Answer,
        paper: &mut Paper<'_>,
    ) -> Result<Written, Refusal> {
        let Paper { origin, style, .. } = *paper;
        let (options, input) = (&problem.options, problem.input());
        match paper.form {
            Form::Json => paper.put(linearity_json(answer, options, input, &origin, &style)),
            Form::Csv => paper.put(linearity_csv(answer)),
            Form::Proof => {
                // A proof is about rows, which are read once more: a calibration keeps their readings only.
                let again = problem.again.as_ref().ok_or(Refusal::NoProof(NoProof::ReadOnce))?;
                let (columns, table) = (&problem.columns, &problem.table);
                let question = linearity_question(columns, table, origin.reading, || again.open())?;
                let proof = question.and_then(|question| linearity_proof(answer, &question));
                paper.put(proof.ok_or(Refusal::NoProof(NoProof::Points))?)
            }
            _ => Self::report(paper, || linearity_document(answer, options, input, &origin, &style)),
        }?;
        Ok(Written::default())
    }
}
