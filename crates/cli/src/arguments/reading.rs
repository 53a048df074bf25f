//! The way from options to the arguments of the libraries.

use boundfit_ask::{Asked, FitXErrors, Misuse, Shows};
use boundfit_estimation::{
    AskedBound, Columns, Condition, EpsilonColumn, Keep, LineForm, Measurements, ParseBoundErrorKind,
    ParseConditionError, ParseConditionErrorKind, ParseTextError, Problem, Question, TextProblem,
};
use boundfit_exact::{Foreign, Limits, ParseNumberError, ParseNumberErrorKind, Rational, Reading};
use boundfit_formats::{
    AskedDialect, Header, InputError, InputErrorKind, MissingWords, ScanOptions, Source, TableOptions,
};
use boundfit_lesson::LessonError;
use boundfit_questions::XErrorProblem;
use boundfit_report::{Origin, Style};
use clap::ValueEnum;

use super::shared::{EpsilonArguments, LineArguments};
use super::values::number_problem;
use super::{
    DataArguments, LabelArguments, OutputArguments, ReduceArguments, RowArguments, TableArguments,
    ThreadArguments, XErrorArguments,
};
use crate::exit::Failure;
use crate::input;
use crate::memory;
use crate::progress::ReadingProgress;

impl DataArguments {
    /// The file in the words of reports.
    pub(crate) fn file_name(&self) -> Foreign<&str> {
        Foreign::of(if self.data == "-" { "standard input" } else { &self.data })
    }

    /// The file as it was named on the command line.
    pub(crate) fn path(&self) -> &str {
        &self.data
    }

    /// Returns the options for reading this file in parts.
    pub(crate) fn scan_options(&self, source: &Source) -> Result<ScanOptions, Failure> {
        self.table.scan_options(source, Some(&self.rows))
    }

    /// The error bounds of `--eps`.
    pub(crate) fn bounds(&self) -> &[String] {
        &self.epsilon.eps
    }

    /// The options for another file, and if it is given under this one of several bounds.
    pub(crate) fn with(&self, file: &str, bound: Option<&String>) -> Self {
        let mut own = DataArguments { data: file.to_owned(), ..self.clone() };
        if let Some(bound) = bound {
            own.epsilon.eps = vec![bound.clone()];
        }
        own
    }

    /// Opens the file.
    pub(crate) fn open(&self) -> Data<'_> {
        let source = input::open(&self.data).map_err(Failure::refused);
        let is_stored = source.as_ref().is_ok_and(Source::is_stored);
        let reading = if is_stored { Reading::Binary64 } else { self.table.reading() };
        let origin =
            Origin { file: (self.data != "-").then_some(Foreign::of(&self.data)), reading, is_stored };
        Data { arguments: self, origin, source, row_cost: memory::OF_A_READING, most_wanted: None }
    }
}

/// The data of a command. The file is opened before the options are read, since it tells how numbers are read in
/// both. A file that cannot be opened is reported when it is read, after the faults of the options.
pub(crate) struct Data<'a> {
    arguments: &'a DataArguments,
    origin: Origin<'a>,
    source: Result<Source, Failure>,
    row_cost: usize,
    most_wanted: Option<usize>,
}

impl<'a> Data<'a> {
    /// Returns the source of the readings, for reports.
    pub(crate) fn origin(&self) -> Origin<'a> {
        self.origin
    }

    /// The data, of which the command holds every reading in so many bytes, with all that it makes of it.
    pub(crate) fn holding(self, row_cost: usize) -> Self {
        Data { row_cost, ..self }
    }

    /// The data, which are refused as soon as they have more readings than this.
    pub(crate) fn at_most(self, most_wanted: usize) -> Self {
        Data { most_wanted: Some(most_wanted), ..self }
    }

    /// These options of a table with what is held of it.
    pub(super) fn limited(&self, options: TableOptions) -> TableOptions {
        TableOptions { row_cost: self.row_cost, most_wanted: self.most_wanted, ..options }
    }

    /// Reads the problem.
    pub(crate) fn problem(self) -> Result<Problem, Failure> {
        self.read(|table| table)
    }

    /// Reads the problem, and keeps the readings of the file that are not fitted.
    pub(crate) fn problem_with_others(self) -> Result<Problem, Failure> {
        self.read(|table| TableOptions { keep_others: true, ..table })
    }

    /// Reads as [`Data::problem_with_others`] does, with the texts of the cells.
    pub(crate) fn problem_with_cells(self) -> Result<Problem, Failure> {
        self.read(|table| TableOptions { keep_others: true, keep_cells: true, ..table })
    }

    /// Reads as [`Data::problem_with_others`] does, without the hash of the data: in less memory if every reading is
    /// needed.
    pub(crate) fn shown_problem(self) -> Result<Problem, Failure> {
        let arguments = self.arguments;
        self.asked()?;
        let options = arguments.table.options(self.origin.reading, Some(&arguments.rows))?;
        if options.selects_rows() { self.problem_with_others() } else { self.whole_problem() }
    }

    /// Reads the problem with the readings that can bound anything under some error bound, others too where they are few.
    pub(crate) fn supporting_problem(self) -> Result<Problem, Failure> {
        let asked = self.asked()?;
        let keep = if asked.columns.are_open() { Keep::default() } else { Keep::EVERY };
        self.scanned(asked, Keep { eui: false, ..keep }, |options| options)
    }

    /// Reads the problem with every reading, which takes less memory than [`Data::problem`] does, and has no hash of the data.
    pub(crate) fn whole_problem(self) -> Result<Problem, Failure> {
        let asked = self.asked()?;
        let keep = Keep { eui: false, ..Keep::EVERY };
        self.scanned(asked, keep, |options| ScanOptions { hash: false, list_rows: false, ..options })
    }

    /// Returns the question with its readings, and the file that has them.
    pub(crate) fn asked_with(self, x_errors: Option<&XErrorArguments>) -> Result<(Asked, Source), Failure> {
        let question = self.asked()?;
        let limits = self.arguments.table.limits.number();
        let x_errors = x_errors.map(|own| own.asked(self.origin.reading, &limits)).transpose()?.flatten();
        let (source, options) = self.scan()?;
        Ok((Asked { x_errors, options, ..Asked::new(question) }, source))
    }

    /// Reads the readings with the bounds on the errors of x, and those that are not fitted, for pictures.
    pub(crate) fn x_error_problem(self, x_errors: &XErrorArguments) -> Result<XErrorProblem, Failure> {
        let file = self.arguments.file_name();
        let (asked, source) = self.asked_with(Some(x_errors))?;
        asked
            .x_error_problem(source, FitXErrors::ROW_COST, Shows::Nothing, true)
            .map_err(|refusal| Failure::of(&refusal, file))
    }

    fn scanned(
        self,
        asked: Question,
        keep: Keep,
        with: impl FnOnce(ScanOptions) -> ScanOptions,
    ) -> Result<Problem, Failure> {
        let arguments = self.arguments;
        let (source, options) = self.scan()?;
        refuse_moving(&asked, &source)?;
        let measurements = asked.measurements(source, &with(options), keep);
        short_problem(&asked, measurements.map_err(Failure::refused)?, arguments)
    }

    /// The file, and how it is read in parts.
    pub(crate) fn scan(self) -> Result<(Source, ScanOptions), Failure> {
        let (row_cost, most_wanted) = (self.row_cost, self.most_wanted);
        let source = self.source?;
        let mut options = self.arguments.scan_options(&source)?;
        (options.table.row_cost, options.table.most_wanted) = (row_cost, most_wanted);
        Ok((source, options))
    }

    fn read(self, with: impl FnOnce(TableOptions) -> TableOptions) -> Result<Problem, Failure> {
        let asked = self.asked()?;
        let table = self.arguments.table.options(self.origin.reading, Some(&self.arguments.rows))?;
        let options = self.limited(with(table));
        let source = self.source?;
        refuse_moving(&asked, &source)?;
        let measurements = Measurements::read(source, &asked.columns, &options).map_err(refused_reading)?;
        short_problem(&asked, measurements, self.arguments)
    }

    /// The columns, conditions and error bound asked for.
    pub(crate) fn asked(&self) -> Result<Question, Failure> {
        let (arguments, reading) = (self.arguments, self.origin.reading);
        let limits = arguments.table.limits.number();
        let asked = arguments.epsilon.asked(reading, &limits, arguments.x.second.is_some())?;
        let AskedEpsilon { column: epsilon, multiple_of_least } =
            asked.ok_or_else(|| Failure::Usage("'--eps' or '--eps-column' is missing".to_owned()))?;
        let conditions = conditions(&arguments.conditions, reading, &limits)?;
        let columns = Columns {
            first: arguments.x.first.clone(),
            second: arguments.x.second.clone(),
            response: arguments.y.clone(),
            epsilon,
            form: arguments.line.form(reading, &limits, arguments.x.second.is_some())?,
        };
        Ok(Question { columns, conditions, multiple_of_least })
    }
}

/// Refuses a multiple of the least bound of readings that were reduced under others.
fn refuse_moving(asked: &Question, source: &Source) -> Result<(), Failure> {
    match asked.moves_fixed_bounds(source) {
        true => Err(Failure::misuse(Misuse::LeastOfFixed)),
        false => Ok(()),
    }
}

/// The problem of some readings, whose numbers are not too long for a fit.
fn short_problem(
    asked: &Question,
    measurements: Measurements,
    data: &DataArguments,
) -> Result<Problem, Failure> {
    let problem = asked.problem_within(measurements, data.table.limits.sizes().work);
    problem.map_err(|error| Failure::of(&error.into(), data.file_name()))
}

/// Returns the reason why readings are not available; if a lesson has too many readings, also the remedy.
fn refused_reading(error: InputError) -> Failure {
    match error.kind {
        InputErrorKind::TooManyWanted { limit } => Failure::data(format_args!(
            "{}: {}; choose some with --rows FIRST..LAST, or raise it with --limit readings=N",
            error.file,
            LessonError::TooManyRows { rows: limit.saturating_add(1), limit }
        )),
        _ => Failure::refused(error),
    }
}

impl LineArguments {
    /// Returns the x from which x is counted.
    pub(super) fn form(
        &self,
        reading: Reading,
        limits: &Limits,
        two_regressors: bool,
    ) -> Result<LineForm, Failure> {
        const EXPECTED: &str = "expected a number such as 1980 or -2.5";
        if two_regressors {
            if self.through_origin {
                return Err(Failure::Usage(
                    "'--through-origin' is about a line: with two regressors there is no offset, and the model passes \
                     through the origin as it is"
                        .to_owned(),
                ));
            }
            if self.x_origin.is_some() {
                return Err(Failure::Usage(
                    "'--x-origin' is about a line: with two regressors there is no x to count from an origin"
                        .to_owned(),
                ));
            }
        }
        let number = |text: &String| {
            reading
                .read(text, limits)
                .map_err(|error| Failure::value("--x-origin <NUM>", text, number_problem(&error, EXPECTED)))
        };
        let x_origin = self.x_origin.as_ref().map(number).transpose()?.unwrap_or_default();
        Ok(LineForm { x_origin, through_origin: self.through_origin })
    }
}

/// The conditions that are asked for.
pub(super) fn conditions(
    texts: &[String],
    reading: Reading,
    limits: &Limits,
) -> Result<Vec<Condition>, Failure> {
    let condition = |text: &String| {
        Condition::parse(text, reading, limits)
            .map_err(|error| Failure::value("--where <CONDITION>", text, condition_problem(&error)))
    };
    texts.iter().map(condition).collect()
}

/// The bounds on errors that are asked for.
pub(super) struct AskedEpsilon {
    pub(super) column: EpsilonColumn,
    /// The factor of the least bound, which is not known yet, and has no say in what it follows from: 0 stands for it.
    pub(super) multiple_of_least: Option<Rational>,
}

impl EpsilonArguments {
    /// Returns the setting that was asked for; `None` if no option states it.
    pub(super) fn asked(
        &self,
        reading: Reading,
        limits: &Limits,
        two_regressors: bool,
    ) -> Result<Option<AskedEpsilon>, Failure> {
        let mut multiple_of_least = None;
        let column = match (self.eps.first(), &self.eps_column) {
            (Some(eps), _) => match asked_bound(eps, reading, limits, two_regressors)? {
                AskedBound::TimesLeast(factor) => {
                    multiple_of_least = Some(factor);
                    EpsilonColumn::Uniform(Rational::zero())
                }
                AskedBound::Law(law) => EpsilonColumn::Law(*law),
                AskedBound::Number(number) => EpsilonColumn::Uniform(number),
            },
            (None, Some(column)) => EpsilonColumn::Column(column.clone()),
            (None, None) if self.lower.is_none() && self.upper.is_none() => return Ok(None),
            (None, None) => EpsilonColumn::Interval { lower: self.lower.clone(), upper: self.upper.clone() },
        };
        Ok(Some(AskedEpsilon { column, multiple_of_least }))
    }
}

impl ReduceArguments {
    /// The columns of the table, and the bounds under which the rows to keep decide.
    pub(crate) fn columns(&self, reading: Reading) -> Result<Columns, Failure> {
        let limits = self.table.limits.number();
        let two_regressors = self.x.second.is_some();
        let asked = self.epsilon.asked(reading, &limits, two_regressors)?;
        let stated = asked.filter(|asked| asked.multiple_of_least.is_none()).map(|asked| asked.column);
        let epsilon = match stated {
            Some(epsilon) => epsilon,
            None if !two_regressors => EpsilonColumn::Uniform(Rational::zero()),
            None => {
                return Err(Failure::Usage(
                    "which readings of two regressors decide depends on their bounds: say them with '--eps', as a number \
                     or a law, '--eps-column' or '--lower' and '--upper'"
                        .to_owned(),
                ));
            }
        };
        Ok(Columns {
            first: self.x.first.clone(),
            second: self.x.second.clone(),
            response: self.y.clone(),
            epsilon,
            form: LineForm::default(),
        })
    }
}

/// Returns the bound that `--eps` asks for.
fn asked_bound(
    text: &str,
    reading: Reading,
    limits: &Limits,
    two_regressors: bool,
) -> Result<AskedBound, Failure> {
    let refuse = |problem: String| Failure::value("--eps <NUM>", text, problem);
    let bound = AskedBound::parse(text, reading, limits).map_err(|error| {
        let number = match &error.kind {
            ParseBoundErrorKind::NotANumber(kind) => Some(kind),
            _ => None,
        };
        refuse(text_problem(&error, number))
    })?;
    match &bound {
        AskedBound::Law(law) if two_regressors && law.needs_x() => {
            Err(refuse("two regressors have no |x| (expected a law of |y|, range(y) and written)".to_owned()))
        }
        _ => Ok(bound),
    }
}

/// Returns the fault of a text; if the fault is in a number, in the words that every option uses for numbers.
fn text_problem<K: TextProblem>(error: &ParseTextError<K>, number: Option<&ParseNumberErrorKind>) -> String {
    match (number.cloned(), error.kind.expected()) {
        (Some(kind), expected) => {
            let error = ParseNumberError { position: error.position, kind };
            number_problem(&error, &format!("expected {}", expected.unwrap_or_default()))
        }
        (None, _) => error.to_string(),
    }
}

fn condition_problem(error: &ParseConditionError) -> String {
    let number = match &error.kind {
        ParseConditionErrorKind::NotANumber(kind) => Some(kind),
        _ => None,
    };
    text_problem(error, number)
}

impl TableArguments {
    /// Returns the options for reading a table and its rows; by default all rows.
    pub(crate) fn options(
        &self,
        reading: Reading,
        rows: Option<&RowArguments>,
    ) -> Result<TableOptions, Failure> {
        let limits = self.limits.number();
        let dialect = self.dialect();
        if let (Some(decimal), Some(thousands)) = (dialect.decimal, dialect.thousands)
            && thousands.mark().as_bytes() == [decimal.byte()]
        {
            return Err(Failure::Usage(format!(
                "'--thousands {:?}' and '--decimal {}' name one mark: it cannot both group digits and come before decimals",
                thousands.mark(),
                decimal.name()
            )));
        }
        Ok(TableOptions {
            header: self.header(),
            dialect,
            missing: self.missing,
            block: self.block.clone(),
            missing_as: MissingWords::new(self.missing_as.iter().cloned()),
            sheet: self.sheet.clone(),
            rows: rows.map(RowArguments::set).transpose()?.unwrap_or_default(),
            conditions: rows.map(|rows| rows.conditions(reading, &limits)).transpose()?.unwrap_or_default(),
            keep_others: false,
            keep_cells: false,
            reading,
            limits,
            sizes: self.limits.sizes(),
            ..TableOptions::default()
        })
    }

    /// Returns the options for reading a table in parts, which may be many.
    pub(crate) fn scan_options(
        &self,
        source: &Source,
        rows: Option<&RowArguments>,
    ) -> Result<ScanOptions, Failure> {
        memory::keep_freed();
        let reading = if source.is_stored() { Reading::Binary64 } else { self.reading() };
        Ok(ScanOptions {
            table: self.options(reading, rows)?,
            progress: Some(ReadingProgress::new(source.length())),
            ..ScanOptions::default()
        })
    }

    pub(crate) fn reading(&self) -> Reading {
        self.reading
    }

    pub(crate) fn header(&self) -> Header {
        self.header
    }

    fn dialect(&self) -> AskedDialect {
        AskedDialect {
            encoding: self.encoding.0,
            delimiter: self.delimiter.0,
            decimal: self.decimal.0,
            thousands: self.thousands,
            comment: self.comment,
            skip_lines: self.skip_lines,
            units_row: self.units_row,
        }
    }
}

impl LabelArguments {
    /// The units of x, which two regressors share, and of y: those asked for, else those that the file states.
    pub(crate) fn units(&self, measurements: &Measurements) -> [Option<Foreign>; 2] {
        let [x, y] = measurements.plane_units();
        [self.x_unit.clone().or(x.cloned()), self.y_unit.clone().or(y.cloned())]
    }
}

impl ThreadArguments {
    /// Sets the number of threads for the rest of the program.
    pub(crate) fn set(&self) -> Result<(), Failure> {
        let Some(threads) = self.threads else { return Ok(()) };
        let builder = rayon::ThreadPoolBuilder::new().num_threads(threads.into());
        builder.build_global().map_err(Failure::data)
    }
}

impl<F: ValueEnum + Send + Sync + 'static> OutputArguments<F> {
    pub(crate) fn style(&self) -> Style {
        let digits = self.digits.map(usize::from);
        Style { digits, ends: self.rounding, exact: self.exact, ..Style::default() }
    }
}
