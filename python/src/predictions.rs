//! What readings say of further ones: predictions, and what every reading says of the others.

use boundfit::engine::estimation::{AskedBound, Law, Measurement};
use boundfit::engine::exact::{Foreign, Work};
use boundfit::engine::formats::read_table;
use boundfit::files::{
    ColumnSelector, Columns, EpsilonColumn, Keep, Measurements, ScanOptions, Source, TableOptions,
};
use boundfit::files::{Limits, MemoryNumbers, MemoryTable};
use boundfit::questions::{
    FurtherError, NoFurtherError, Ranking, Repair, RowStatus, Standing, Statuses, times,
};
use boundfit::report::{
    AskedValues, NewReadings, Prediction, StatusCsv, StatusJson, StatusReport, Style, prediction_document,
    prediction_proof, status_document, status_proof, write_prediction_csv, write_prediction_json,
};
use boundfit::{Problem, Rational, Reading};
use pyo3::prelude::*;

use crate::asked::in_words;
use crate::cells::{NamedColumn, numbers};
use crate::forms::{self, Form, NO_TEXT, asked};
use crate::numbers::{Given, refuse};
use crate::readings::{Readings, check_work};

/// Values, and readings that decide, that a proof may be about.
const MOST_PROVED: usize = 1_000;

/// Readings that the text lists.
const MOST_LISTED: usize = 40;

/// What is to be predicted.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct AskedPrediction<'py> {
    at: Vec<NamedColumn<'py>>,
    from_: Option<NamedColumn<'py>>,
    new_eps: Option<Given>,
    proofs: bool,
}

/// Where the line runs, where further readings lie, and where readings may come from.
#[pyfunction]
#[pyo3(signature = (readings, prediction, form, digits))]
pub(crate) fn predict(
    py: Python<'_>,
    readings: &Readings,
    prediction: AskedPrediction<'_>,
    form: &str,
    digits: Option<usize>,
) -> PyResult<String> {
    let is_line = readings.asked.question.columns.second.is_none();
    let law = prediction.new_eps.as_ref().map(|given| further_law(given, readings.floats, is_line));
    let law = law.transpose()?;
    let columns = prediction.at.iter().map(|own| values(own, readings.floats));
    let mut columns = columns.collect::<PyResult<Vec<Vec<Rational>>>>()?.into_iter();
    let first = columns.next().unwrap_or_default();
    let at: Vec<[Rational; 2]> = match columns.next() {
        Some(second) => first.into_iter().zip(second).map(<[Rational; 2]>::from).collect(),
        None => first.into_iter().map(|x| [x, Rational::one()]).collect(),
    };
    let from = prediction.from_.as_ref().map(|own| values(own, readings.floats)).transpose()?;
    let from: Vec<[Rational; 2]> =
        from.unwrap_or_default().into_iter().map(|y| [y, Rational::zero()]).collect();
    let question = Predicted { law, at, from, proofs: prediction.proofs };
    asked(py, readings, form, digits, |readings, form, style| question.of(readings, form, style))
}

/// What is to be predicted, in numbers.
struct Predicted {
    law: Option<Law>,
    at: Vec<[Rational; 2]>,
    from: Vec<[Rational; 2]>,
    proofs: bool,
}

impl Predicted {
    fn of(&self, readings: &Readings, form: Form, style: &Style) -> Result<String, String> {
        let problem = readings.problem(Keep { eui: false, ..Keep::default() })?;
        let bits = times::bits_of_corner(&problem);
        let mut work = Work::default();
        for (row, value) in (1..).zip(self.at.iter().chain(&self.from)) {
            work.add_products(row, value.iter(), bits);
        }
        check_work(&work, times::PREDICT, &readings.asked.options)?;
        let fit = problem.fit();
        let error = match &self.law {
            None => FurtherError::of(&problem.measurements),
            Some(law) => FurtherError::by_law(law, &problem.measurements),
        };
        self.check(&error)?;
        let origin = if matches!(form, Form::Json | Form::Csv | Form::Proof) {
            readings.origin()
        } else {
            readings.shown_origin()
        };
        let prediction = Prediction {
            problem: &problem,
            fit: &fit,
            origin,
            error,
            given: self.law.clone(),
            at: AskedValues { count: self.at.len(), values: &|| Box::new(self.at.iter().cloned()) },
            from: AskedValues { count: self.from.len(), values: &|| Box::new(self.from.iter().cloned()) },
        };
        let mut bytes = Vec::new();
        match form {
            Form::Json => write_prediction_json(&prediction, style, &mut bytes),
            Form::Csv if !self.at.is_empty() && !self.from.is_empty() => {
                return Err(
                    "format=\"csv\" writes one table: ask at and from_ in calls of their own".to_owned()
                );
            }
            Form::Csv => write_prediction_csv(&prediction, &mut bytes),
            Form::Proof if self.at.len() + self.from.len() > MOST_PROVED => {
                return Err(format!("a proof is about {MOST_PROVED} values at most"));
            }
            Form::Proof => {
                return prediction_proof(&prediction, readings.reading).ok_or_else(|| NO_TEXT.to_owned());
            }
            _ => return Ok(forms::of(form, &prediction_document(&prediction, self.proofs, style))),
        }
        .map_err(|error| error.to_string())?;
        String::from_utf8(bytes).map_err(|error| error.to_string())
    }

    /// Refuses to ask where a reading comes from of which nothing is known.
    fn check(&self, error: &Result<FurtherError, NoFurtherError>) -> Result<(), String> {
        match error {
            Err(reason) if self.law.is_some() => {
                Err(format!("new_eps: {reason} (expected a number such as 0.5)"))
            }
            Err(reason) if !self.from.is_empty() => {
                Err(format!("from_ needs the error bound of the reading, and {reason}: say it with new_eps"))
            }
            _ => Ok(()),
        }
    }
}

/// What is stated of the error of a further reading.
fn further_law(given: &Given, floats: Reading, is_line: bool) -> PyResult<Law> {
    let limits = Limits::default();
    let (number, text) = (given.text(floats), &given.shown);
    let law = Law::parse(&number, Reading::Decimal, &limits);
    let law = law.map_err(|error| match AskedBound::parse(&number, Reading::Decimal, &limits) {
        Ok(AskedBound::TimesLeast(_)) => refuse(format_args!(
            "new_eps={text:?}: a multiple of the least bound says nothing of a further reading (expected a number such as 0.5, or \
             a law)"
        )),
        _ => refuse(format_args!("new_eps={text:?}: {error}")),
    })?;
    if law.needs_x() && !is_line {
        return Err(refuse("new_eps: two regressors have no |x| (expected a law of |y| and range(y))"));
    }
    Ok(law)
}

/// The numbers of a column: floats mean what they mean in the readings, all else is exactly as it is written.
fn values((name, column): &NamedColumn<'_>, floats: Reading) -> PyResult<Vec<Rational>> {
    let cells = numbers(name, column, floats)?;
    let reading = match cells {
        MemoryNumbers::Doubles(_) | MemoryNumbers::Floats(_) => floats,
        _ => Reading::Decimal,
    };
    let mut table = MemoryTable::default();
    table.push(name.as_str(), cells);
    let options = TableOptions { reading, ..TableOptions::default() };
    let read = read_table(Source::of_table("values", table), &[ColumnSelector::name(name)], &options);
    let rows = read.map_err(|error| refuse(in_words(&error)))?.rows;
    Ok(rows.into_iter().flat_map(|row| row.numbers).collect())
}

/// Further readings that are judged: columns in the order of their roles, or a file.
#[derive(FromPyObject)]
pub(crate) enum Further<'py> {
    File(String),
    Columns(Vec<Bound<'py, PyAny>>),
}

/// What every reading and the set of all, and that of the others, say of each other.
#[pyfunction]
#[pyo3(signature = (readings, repair, new, form, digits))]
pub(crate) fn status(
    py: Python<'_>,
    readings: &Readings,
    repair: bool,
    new: Option<Further<'_>>,
    form: &str,
    digits: Option<usize>,
) -> PyResult<String> {
    let new = match new {
        None => None,
        Some(Further::File(path)) => Some(New::File(path)),
        Some(Further::Columns(columns)) if columns.len() == readings.names.len() => {
            let columns: Vec<NamedColumn<'_>> = readings.names.iter().cloned().zip(columns).collect();
            let (table, reading) = crate::cells::table(&columns, &readings.names, readings.floats)?;
            Some(New::Columns(table.into(), reading))
        }
        Some(Further::Columns(columns)) => {
            return Err(refuse(format_args!(
                "new has {} columns: expected {}",
                columns.len(),
                readings.names.join(", ")
            )));
        }
    };
    let ask =
        |readings: &Readings, form, style: &Style| status_of(readings, repair, new.as_ref(), form, style);
    asked(py, readings, form, digits, ask)
}

/// Further readings, to be read.
enum New {
    File(String),
    /// Columns in memory, and how their numbers are read.
    Columns(std::sync::Arc<MemoryTable>, Reading),
}

impl New {
    fn file(&self) -> Option<Foreign<&str>> {
        match self {
            New::File(path) => Some(Foreign::of(path.as_str())),
            New::Columns(..) => None,
        }
    }

    /// All of them, under the bounds that the fitted readings have.
    fn read(&self, readings: &Readings, problem: &Problem) -> Result<Vec<Measurement>, String> {
        let source = match self {
            New::File(path) => Source::open(path).map_err(|error| in_words(&error))?,
            New::Columns(table, _) => Source::of_table("new", std::sync::Arc::clone(table)),
        };
        let columns = match problem.measurements.error_bound().uniform() {
            Some(epsilon) => Columns {
                epsilon: EpsilonColumn::Uniform(epsilon.clone()),
                ..readings.asked.question.columns.clone()
            },
            None => readings.asked.question.columns.clone(),
        };
        if matches!(&columns.epsilon, EpsilonColumn::Law(law) if law.needs_range()) {
            return Err("new is about readings with bounds of their own, and a law with range(y) takes them from all of a table: \
                        give the number that it comes to"
                .to_owned());
        }
        if source.is_reduction() {
            return Err("new is about every reading, and the file is a reduction: judge the table that it was made from".to_owned());
        }
        let mut options = ScanOptions { hash: false, list_rows: false, ..readings.asked.options.clone() };
        (options.table.rows, options.table.conditions) = Default::default();
        if let New::Columns(_, reading) = self {
            options.table.reading = *reading;
        }
        let mut all = Vec::new();
        let see = |readings: &mut dyn Iterator<Item = Measurement>| readings.collect::<Vec<_>>();
        let keep = Keep { eui: false, ..Keep::default() };
        let seen = |part: Vec<Measurement>| all.extend(part);
        Measurements::scan_and_see(source, &columns, &problem.conditions, &options, keep, see, seen)
            .map_err(|error| in_words(&error))?;
        Ok(all)
    }
}

fn status_of(
    readings: &Readings,
    repair: bool,
    new: Option<&New>,
    form: Form,
    style: &Style,
) -> Result<String, String> {
    let problem = readings.every_reading("'status' is")?;
    readings.check_problem(&problem, times::STATUS)?;
    let fit = problem.fit();
    let all = problem.measurements.all().ok_or("not every reading is in memory")?;
    let repair = repair.then(|| Repair::of(&problem, &fit));
    let statuses = Statuses::of(&problem, &fit).ok_or("not every reading is in memory")?;
    let further = match new {
        Some(new) => new.read(readings, &problem)?,
        None => Vec::new(),
    };
    let standing = |reading: &Measurement| Standing::against(reading, statuses.set());
    match form {
        Form::Json => {
            let mut text = StatusJson::head(&problem, &fit, statuses.deciding(), &readings.origin(), style);
            let rows = all.iter().map(|reading| StatusJson::row(&statuses.status(reading), style));
            text.push_str(&rows.collect::<Vec<_>>().join(StatusJson::BETWEEN));
            text.push_str(StatusJson::END_OF_ROWS);
            if let Some(new) = new {
                text.push_str(&StatusJson::new_head(new.file()));
                let rows =
                    further.iter().map(|own| StatusJson::new_row(own.row, standing(own).as_ref(), style));
                text.push_str(&rows.collect::<Vec<_>>().join(StatusJson::BETWEEN));
                text.push_str(StatusJson::END_OF_NEW);
            }
            text.extend(repair.iter().map(|repair| StatusJson::repair(repair, style)));
            text.push_str(StatusJson::TAIL);
            Ok(text)
        }
        Form::Csv => {
            let rows = all.iter().map(|reading| StatusCsv::row(&statuses.status(reading)));
            let new = further.iter().map(|own| StatusCsv::new_row(own.row, standing(own).as_ref()));
            Ok([StatusCsv::HEADER.to_owned()].into_iter().chain(rows).chain(new).collect())
        }
        Form::Proof => {
            let (count, most) = (statuses.deciding().count(), MOST_PROVED);
            if count > most {
                return Err(format!(
                    "a proof is about sets that at most {most} readings decide, and these are {count}"
                ));
            }
            let leaving = problem.work(&[]).of_leaving_out_each(problem.measurements.kept().len() as u64);
            check_work(&leaving, times::FIT, &readings.asked.options)?;
            status_proof(&problem, &statuses, readings.reading).ok_or_else(|| NO_TEXT.to_owned())
        }
        _ => {
            let mut ranking = Ranking::listing(MOST_LISTED);
            all.iter().for_each(|reading| ranking.add(reading.clone(), statuses.status(reading)));
            let new = new.map(|new| {
                let mut ranking = Ranking::listing(MOST_LISTED);
                for reading in further {
                    let all = standing(&reading);
                    let status = RowStatus { row: reading.row, without: all.clone(), all };
                    ranking.add(reading, status);
                }
                let file = new.file().or(Some(Foreign::of("columns in memory")));
                NewReadings { file, ranking }
            });
            let report = StatusReport { problem: &problem, fit: &fit, ranking, new, repair };
            Ok(forms::of(form, &status_document(report, &readings.shown_origin(), style)))
        }
    }
}
