//! The options about errors in x.

use boundfit_exact::{Limits, Rational, Reading, Work};
use boundfit_formats::{ColumnSelector, ScanOptions, TableOptions};
use boundfit_questions::{Agreement, XBounds, XErrorProblem};
use clap::Args;

use boundfit_estimation::{Keep, Measurements};

use super::DataArguments;
use super::reading::Data;
use super::values::{number_problem, parse_column};
use crate::exit::Failure;
use crate::work::{refuse_long, times};

/// Errors in x.
#[derive(Debug, Args)]
pub(crate) struct XErrorArguments {
    /// Bound on the errors of x as well: a number, or else the column with the bound of each reading. A line then agrees
    /// with a reading if it meets its box
    #[arg(long, value_name = "NUM|COL", allow_hyphen_values = true, conflicts_with = "x_eps_column")]
    x_eps: Option<String>,
    /// Column with the bound on the error of each x, by name or by number
    #[arg(long, value_name = "COL", value_parser = parse_column)]
    x_eps_column: Option<ColumnSelector>,
    /// With errors in x, ask of a line to agree for every x that they allow, and not only for some
    #[arg(long)]
    strong: bool,
}

/// The bounds as they are asked for.
enum AskedXBounds {
    Uniform(Rational),
    Column(ColumnSelector),
}

impl XErrorArguments {
    /// Whether x has errors.
    ///
    /// # Errors
    /// When strong agreement is asked for without them.
    pub(crate) fn are_asked(&self) -> Result<bool, Failure> {
        let are_asked = self.x_eps.is_some() || self.x_eps_column.is_some();
        if self.strong && !are_asked {
            let problem = "'--strong' is about errors in x: say how large they may be with '--x-eps' or '--x-eps-column'";
            return Err(Failure::Usage(problem.to_owned()));
        }
        Ok(are_asked)
    }

    fn agreement(&self) -> Agreement {
        if self.strong { Agreement::Strong } else { Agreement::Weak }
    }

    /// A text that is a number is one, and any other the name of a column.
    fn asked(&self, reading: Reading, limits: &Limits) -> Result<AskedXBounds, Failure> {
        let Some(text) = &self.x_eps else {
            let column = self.x_eps_column.clone();
            return column
                .map(AskedXBounds::Column)
                .ok_or_else(|| Failure::Usage("'--x-eps' is missing".to_owned()));
        };
        let refuse = |problem: String| Failure::value("--x-eps <NUM|COL>", text, problem);
        match reading.read(text, limits) {
            Ok(number) if number.is_negative() => Err(refuse(
                "negative (expected a number that is at least 0, such as 0.15, or a column)".to_owned(),
            )),
            Ok(number) => Ok(AskedXBounds::Uniform(number)),
            Err(error) if error.kind.is_limit() => Err(refuse(number_problem(&error, ""))),
            Err(_) => parse_column(text).map(AskedXBounds::Column).map_err(refuse),
        }
    }
}

impl Data<'_> {
    /// Reads the readings with the bounds on the errors of x, and where it is asked for those that are not fitted, for pictures.
    pub(crate) fn x_error_problem(
        self,
        x_errors: &XErrorArguments,
        keep_others: bool,
    ) -> Result<XErrorProblem, Failure> {
        let arguments: &DataArguments = self.arguments();
        let reading = self.origin().reading;
        let asked = self.asked()?;
        if asked.columns.second.is_some() {
            return Err(Failure::Usage(
                "'--x-eps' is about a line: with two regressors it is not known how their errors go together"
                    .to_owned(),
            ));
        }
        if asked.is_multiple_of_least() {
            return Err(Failure::Usage(
                "'--eps min' is found as if every x were exact: with '--x-eps' give '--eps' as a number, and read from the \
                 report by which factor all bounds may shrink or have to grow"
                    .to_owned(),
            ));
        }
        let bounds = x_errors.asked(reading, &arguments.table.limits.number())?;
        let table = arguments.table.options(reading, Some(&arguments.rows))?;
        let options = self.limited(TableOptions { keep_others, ..table });
        let source = self.source()?;
        if source.is_reduction() {
            return Err(Failure::Usage(
                "'--x-eps' needs every reading, and the data are a reduction: fit the table that it was made from".to_owned(),
            ));
        }
        let beside: Vec<ColumnSelector> = match &bounds {
            AskedXBounds::Column(column) => vec![column.clone().non_negative()],
            AskedXBounds::Uniform(_) => Vec::new(),
        };
        let read = if keep_others {
            Measurements::read_beside(source, &asked.columns, &beside, &options)
        } else {
            let options = ScanOptions { table: options, ..arguments.scan_options(&source)? };
            Measurements::read_counted(source, &asked.columns, &beside, &options, Keep::MOST_ROWS)
        };
        let read = read.map_err(Failure::refused)?;
        let (measurements, mut further) = read;
        let bounds = match bounds {
            AskedXBounds::Uniform(bound) => XBounds::Uniform(bound),
            AskedXBounds::Column(column) => {
                XBounds::PerRow { column: column.text().clone(), bounds: further.pop().unwrap_or_default() }
            }
        };
        let problem = asked.short_problem(measurements, arguments)?;
        let problem = XErrorProblem::new(problem, bounds, x_errors.agreement()).map_err(Failure::data)?;
        let mut work = Work::default();
        for (row, width) in problem.readings() {
            let numbers = [row.lower(), row.upper()];
            work.add(row.row, row.regressor.iter().chain(numbers.iter().flatten()).chain([width]));
        }
        let limits = &arguments.table.limits;
        refuse_long(arguments.file_name(), &work, times::X_ERRORS, limits)?;
        refuse_long(arguments.file_name(), &work.of_every_word(), times::X_ERROR_STEPS, limits)?;
        Ok(problem)
    }
}
