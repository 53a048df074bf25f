//! The fits of the last readings as the window moves on.

use boundfit_estimation::{Measurements, MultipleOfLeast, Problem};
use boundfit_formats::Source;
use boundfit_questions::{Extent, Moving, Turn, times};
use boundfit_report::{
    FleetTable, LineInput, Style, TableJson, WindowReport, WindowSummary, in_page_width, table_line,
    write_window_json,
};
use serde::Deserialize;

use crate::asked::{Asked, assumed, remarks};
use crate::form::{Form, Shows, Written};
use crate::given::Given;
use crate::misuse::Misuse;
use crate::paper::Paper;
use crate::question::Ask;
use crate::refusal::{Refusal, ValueProblem};

/// The fits of the last readings, again and again as the window moves on.
#[derive(Debug, Clone, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Window {
    /// The number of readings in a window, in order of rows.
    pub window: Option<usize>,
    /// The reach of a window back in x from its newest reading, in order of x.
    pub window_x: Option<Given>,
    /// The number of readings that a window moves on; 1 by default.
    pub step: Option<usize>,
}

impl Window {
    /// Returns the reach of a window and its step, with numbers read like those of the table.
    ///
    /// # Errors
    /// When it is not said, said twice, or no number.
    pub fn moving(&self, asked: &Asked) -> Result<Moving, Refusal> {
        const EXPECTED: &str = "expected a number above 0, such as 60 or 0.5";
        let refuse = |key, text: String, problem| Refusal::Value { key, text, problem };
        let extent = match (self.window, &self.window_x) {
            (Some(_), Some(_)) => return Err(Refusal::Misuse(Misuse::TwoWindows)),
            (None, None) if self.step.is_some() => return Err(Refusal::Misuse(Misuse::StepAlone)),
            (None, None) => return Err(Refusal::Misuse(Misuse::NoWindow)),
            (Some(0), None) => {
                let problem = ValueProblem::Expected("expected how many readings a window has, at least 1");
                return Err(refuse("window", "0".to_owned(), problem));
            }
            (Some(count), None) => Extent::Readings(count),
            (None, Some(_)) if asked.question.columns.second.is_some() => {
                return Err(Refusal::Misuse(Misuse::WindowOfX));
            }
            (None, Some(given)) => {
                let (table, text) = (&asked.options.table, given.text());
                let span = match given.number(table.reading, &table.limits) {
                    Ok(span) => span,
                    Err(error) => {
                        let problem = ValueProblem::Number { error, expected: EXPECTED };
                        return Err(refuse("window_x", text, problem));
                    }
                };
                if !span.is_positive() {
                    return Err(refuse("window_x", text, ValueProblem::Expected(EXPECTED)));
                }
                Extent::X(span)
            }
        };
        match self.step {
            Some(0) => {
                let expected = "expected how many readings a window moves on, at least 1";
                Err(refuse("step", "0".to_owned(), ValueProblem::Expected(expected)))
            }
            step => Ok(Moving { extent, step: step.unwrap_or(1) }),
        }
    }
}

impl Ask for Window {
    const NAME: &'static str = "window";
    const FORMS: &'static [Form] = &[Form::Text, Form::Json, Form::Csv];
    type Problem = (Problem, Moving);
    /// Windows are written one by one, as they are found.
    type Answer = ();

    fn read(&self, asked: &Asked, source: Source, _: Shows) -> Result<(Problem, Moving), Refusal> {
        /// Bytes that the budget counts for each reading (390).
        const ROW_COST: usize = 400;
        let moving = self.moving(asked)?;
        let problem = asked.every_reading(source, ROW_COST, Shows::Nothing, Self::NAME)?;
        problem.check_work(times::RANGE, asked.most_work())?;
        Ok((problem, moving))
    }

    fn measurements<'a>(&self, (problem, _): &'a (Problem, Moving)) -> Option<&'a Measurements> {
        Some(&problem.measurements)
    }

    fn multiple_of_least<'a>(&self, _: &'a (Problem, Moving), _form: Form) -> Option<&'a MultipleOfLeast> {
        None
    }

    fn rows_missing(&self, _: &(Problem, Moving)) -> usize {
        0
    }

    fn answer(&self, _: &(Problem, Moving)) -> Result<(), Refusal> {
        Ok(())
    }

    fn refuse_vain_style(&self, _: Form, _: &Style) -> Result<(), Misuse> {
        // Lines of many sets are decimals in every form.
        Ok(())
    }

    fn write(
        &self,
        (problem, moving): &(Problem, Moving),
        (): &(),
        paper: &mut Paper<'_>,
    ) -> Result<Written, Refusal> {
        /// Bytes that are written at once.
        const READY: usize = 1 << 16;
        let Paper { form, style, .. } = *paper;
        let style = &style;
        let (mut summary, mut table) = (WindowSummary::default(), FleetTable::of_windows(moving.order()));
        let input = LineInput::new(TableJson::of_measurements(&problem.measurements));
        let mut last_answer = None;
        // A call of the system for each line would take longer than the line.
        let mut ready = Vec::new();
        if form == Form::Csv {
            ready.extend_from_slice(WindowReport::CSV_HEADER.as_bytes());
        }
        let take = |turn: Turn<'_>| {
            let Some(window) = WindowReport::new(&turn, problem, moving.order()) else { return Ok(()) };
            summary.add(&window, style);
            match form {
                Form::Json => write_window_json(&mut ready, &window, &input, style),
                Form::Csv => ready.extend_from_slice(window.csv(style, &mut last_answer).as_bytes()),
                Form::Text => {
                    let mut text = String::new();
                    table.push(window.cells(style), &mut text);
                    ready.extend_from_slice(text.as_bytes());
                }
                _ => return Err(Self::no_form(form)),
            }
            if ready.len() < READY {
                return Ok(());
            }
            paper.put(std::mem::take(&mut ready))
        };
        let moved = moving.each(problem, take);
        paper.put(ready)?;
        let moved = moved?;
        let measurements = &problem.measurements;
        let multiple = measurements.multiple_of_least();
        let assumed = multiple.map(|multiple| assumed(&multiple.factor, "all readings"));
        let bound = multiple.map(|multiple| format!(": {}", multiple.bound()));
        let remarks =
            remarks(measurements.rows_missing(), assumed.zip(bound).map(|(assumed, bound)| assumed + &bound));
        let to_text = summary.to_text(moving, &moved, style) + &remarks;
        let is_empty = summary.has_empty();
        if form != Form::Text {
            return Ok(Written { is_empty, summary: to_text, ..Written::default() });
        }
        let mut text = String::new();
        table.finish(&mut text);
        let below = to_text + &table_line(problem.measurements.table());
        paper.put(format!("{text}\n{}", in_page_width(&below)))?;
        Ok(Written::of_set(is_empty))
    }
}
