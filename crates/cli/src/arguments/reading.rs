//! From options to what the libraries take.

use boundfit_estimation::{
    AskedBound, Columns, Condition, EpsilonColumn, Keep, LineForm, Measurements, ParseBoundErrorKind,
    ParseConditionError, ParseConditionErrorKind, ParseTextError, Problem, TextProblem,
};
use boundfit_exact::{Foreign, Limits, ParseNumberError, ParseNumberErrorKind, Rational, Reading, Work};
use boundfit_formats::{
    AskedDialect, Header, InputError, InputErrorKind, MissingWords, ScanOptions, Source, TableOptions,
};
use boundfit_lesson::LessonError;
use boundfit_report::{Origin, Style};
use clap::ValueEnum;

use super::shared::{EpsilonArguments, LineArguments};
use super::values::number_problem;
use super::{
    DataArguments, LabelArguments, OutputArguments, ReduceArguments, RowArguments, TableArguments,
    ThreadArguments,
};
use crate::exit::Failure;
use crate::input;
use crate::memory;
use crate::progress::ReadingProgress;
use crate::work::{refuse_long, refuse_long_problem, times};

const LEAST_OF_FIXED: &str = "'--eps min' moves the error bounds, and the data are a reduction under bounds that are fixed: fit the \
                              table that it was made from";

impl DataArguments {
    /// The file in the words of reports.
    pub(crate) fn file_name(&self) -> Foreign<&str> {
        Foreign::of(if self.data == "-" { "standard input" } else { &self.data })
    }

    /// The file as it was named on the command line.
    pub(crate) fn path(&self) -> &str {
        &self.data
    }

    /// Whether the model has two regressors instead of x and a constant.
    pub(crate) fn has_two_regressors(&self) -> bool {
        self.x.second.is_some()
    }

    /// How this file is read in parts.
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

/// The data of a command. The file is opened before the options are understood, since it tells how numbers are read in
/// both; that it cannot be opened is said when it is to be read, after what is wrong with the options.
pub(crate) struct Data<'a> {
    arguments: &'a DataArguments,
    origin: Origin<'a>,
    source: Result<Source, Failure>,
    row_cost: usize,
    most_wanted: Option<usize>,
}

impl<'a> Data<'a> {
    /// Where the readings come from, for reports.
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

    /// The options that say which readings are fitted.
    pub(super) fn arguments(&self) -> &'a DataArguments {
        self.arguments
    }

    /// The file, if it could be opened.
    pub(super) fn source(self) -> Result<Source, Failure> {
        self.source
    }

    /// Reads the problem.
    pub(crate) fn problem(self) -> Result<Problem, Failure> {
        self.read(|table| table)
    }

    /// Reads the problem, and keeps the readings of the file that are not fitted.
    pub(crate) fn problem_with_others(self) -> Result<Problem, Failure> {
        self.read(|table| TableOptions { keep_others: true, ..table })
    }

    /// As [`Data::problem_with_others`], with the texts of the cells.
    pub(crate) fn problem_with_cells(self) -> Result<Problem, Failure> {
        self.read(|table| TableOptions { keep_others: true, keep_cells: true, ..table })
    }

    /// As [`Data::problem_with_others`], without the hash of the data: in less memory where no reading may be left out.
    pub(crate) fn shown_problem(self) -> Result<Problem, Failure> {
        let arguments = self.arguments;
        self.asked()?;
        let options = arguments.table.options(self.origin.reading, Some(&arguments.rows))?;
        if options.selects_rows() { self.problem_with_others() } else { self.whole_problem() }
    }

    /// Reads the problem in memory that does not grow with the file; with the hash of the data and the rows fitted if they
    /// will be shown. Where the bounds are going to move, all readings are kept unless those kept decide for every bound.
    pub(crate) fn scanned_problem(
        self,
        eui: bool,
        hash: bool,
        list_rows: bool,
        moving: bool,
    ) -> Result<Problem, Failure> {
        let asked = self.asked()?;
        let keeps_all = (moving || asked.multiple_of_least.is_some()) && !asked.columns.are_open();
        let keep = Keep { eui, ..if keeps_all { Keep::EVERY } else { Keep::default() } };
        self.scanned(asked, keep, |options| ScanOptions { hash, list_rows, ..options })
    }

    /// Whether the data are a file, which can be read once more.
    pub(crate) fn can_be_read_again(&self) -> bool {
        self.source.as_ref().is_ok_and(|source| source.path().is_some())
    }

    /// Reads the problem with the readings that can bound anything under some error bound, others too where they are few.
    pub(crate) fn supporting_problem(self) -> Result<Problem, Failure> {
        let asked = self.asked()?;
        let keep = if asked.columns.are_open() { Keep::default() } else { Keep::EVERY };
        self.scanned(asked, Keep { eui: false, ..keep }, |options| options)
    }

    /// Reads the problem with every reading, which takes less memory than [`Data::problem`] does, and has no hash of the data.
    pub(crate) fn whole_problem(self) -> Result<Problem, Failure> {
        self.every_reading(false, false)
    }

    /// Reads the problem with every reading, with the hash of the data and the rows fitted if they will be shown.
    pub(crate) fn every_reading(self, hash: bool, list_rows: bool) -> Result<Problem, Failure> {
        let asked = self.asked()?;
        let keep = Keep { eui: false, ..Keep::EVERY };
        self.scanned(asked, keep, |options| ScanOptions { hash, list_rows, ..options })
    }

    /// Reads the problem with every reading, of which equal ones are kept once where there are many; with the hash of the data and
    /// the rows fitted if they will be shown.
    pub(crate) fn counted_readings(self, hash: bool, list_rows: bool) -> Result<Problem, Failure> {
        if self.source.as_ref().is_ok_and(Source::is_reduction) {
            return self.every_reading(hash, list_rows);
        }
        let asked = self.asked()?;
        let arguments = self.arguments;
        let (source, options) = self.scan()?;
        asked.check(&source)?;
        let options = ScanOptions { hash, list_rows, ..options };
        let read = Measurements::read_counted(source, &asked.columns, &[], &options, Keep::MOST_ROWS);
        asked.short_problem(read.map_err(Failure::refused)?.0, arguments)
    }

    fn scanned(
        self,
        asked: Asked,
        keep: Keep,
        with: impl FnOnce(ScanOptions) -> ScanOptions,
    ) -> Result<Problem, Failure> {
        let arguments = self.arguments;
        let (source, options) = self.scan()?;
        asked.check(&source)?;
        let options = with(options);
        let conditions = asked.all_conditions();
        let measurements = Measurements::scan(source, &asked.columns, &conditions, &options, keep);
        asked.short_problem(measurements.map_err(Failure::refused)?, arguments)
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
        asked.check(&source)?;
        let measurements = Measurements::read(source, &asked.columns, &options).map_err(refused_reading)?;
        asked.short_problem(measurements, self.arguments)
    }

    /// The columns, conditions and error bound asked for.
    pub(crate) fn asked(&self) -> Result<Asked, Failure> {
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
        Ok(Asked { columns, conditions, multiple_of_least })
    }
}

/// Why readings cannot be had; of more than a lesson shows, what to do.
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
    /// Where x is counted from.
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
    /// What is asked for; `None` where nothing is said about it.
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

/// What is to be read, and what is to be fitted to it.
pub(crate) struct Asked {
    pub(crate) columns: Columns,
    conditions: Vec<Condition>,
    /// Of `--eps 1.2*min` the factor.
    multiple_of_least: Option<Rational>,
}

impl Asked {
    /// The conditions, with the one that belongs to lines through the origin.
    fn all_conditions(&self) -> Vec<Condition> {
        let no_intercept = self.columns.form.through_origin.then(Condition::no_intercept);
        self.conditions.iter().cloned().chain(no_intercept).collect()
    }

    /// Refuses a multiple of the least bound of readings that were reduced under others.
    fn check(&self, source: &Source) -> Result<(), Failure> {
        let is_fixed = source.is_reduction() && self.columns.second.is_some();
        match self.multiple_of_least.is_some() && is_fixed {
            true => Err(Failure::Usage(LEAST_OF_FIXED.to_owned())),
            false => Ok(()),
        }
    }

    /// Whether the error bound is a multiple of the least one.
    pub(super) fn is_multiple_of_least(&self) -> bool {
        self.multiple_of_least.is_some()
    }

    /// The problem of some readings, whose numbers are not too long for a fit.
    pub(super) fn short_problem(
        &self,
        measurements: Measurements,
        data: &DataArguments,
    ) -> Result<Problem, Failure> {
        let check = |problem: &Problem| {
            refuse_long_problem(data.file_name(), problem, times::FIT, &data.table.limits)
        };
        let every = self.work_of_every(measurements.kept().len());
        refuse_long(data.file_name(), &every, times::FIT, &data.table.limits)?;
        // A multiple of the least bound is work too.
        let stated = self.stated_problem(measurements);
        check(&stated)?;
        let problem = self.problem(stated.measurements);
        check(&problem)?;
        Ok(problem)
    }

    /// The problem of some readings under the bound that is stated, where that is no multiple of the least one.
    pub(crate) fn stated_problem(&self, measurements: Measurements) -> Problem {
        Problem { measurements, conditions: self.conditions.clone() }
    }

    /// The problem of some readings.
    pub(crate) fn problem(&self, measurements: Measurements) -> Problem {
        let problem = Problem { measurements, conditions: self.conditions.clone() };
        let problem = if self.columns.form.through_origin { problem.through_origin() } else { problem };
        match &self.multiple_of_least {
            Some(factor) => problem.with_multiple_of_least(factor),
            None => problem,
        }
    }

    /// Whether nothing is known of the parameters beside the readings and their error bound, which is given.
    pub(crate) fn is_plain(&self) -> bool {
        self.conditions.is_empty() && self.multiple_of_least.is_none() && !self.columns.form.through_origin
    }

    /// Whether a bound or an origin that is the same for all readings is so long that it counts in each.
    pub(crate) fn has_long_bound(&self) -> bool {
        let is_long = |number: &Rational| Work::of_numbers(&[number]).products(1) > 0;
        let is_long_bound =
            matches!(&self.columns.epsilon, EpsilonColumn::Uniform(epsilon) if is_long(epsilon));
        is_long_bound || is_long(&self.columns.form.x_origin)
    }

    /// The work on what each of so many readings gets beside its own numbers, estimated before memory is taken for it: the bound
    /// and the origin that are the same for all, and where the bound comes from the readings, what it may take from a condition.
    pub(crate) fn work_of_every(&self, readings: usize) -> Work {
        let right_sides = self.conditions.iter().map(|condition| &condition.inequality().b);
        let longest = right_sides.max_by_key(|number| number.bits());
        self.columns.work_of_every(readings, longest.filter(|_| self.multiple_of_least.is_some()))
    }

    /// What the answers about many groups stand and fall with, as a line; nothing where the error bound is given.
    pub(crate) fn assumption(&self) -> String {
        let times = |factor: &Rational| match *factor == Rational::one() {
            true => String::new(),
            false => format!("{factor} times "),
        };
        let factor = self.multiple_of_least.as_ref();
        factor.map_or_else(String::new, |factor| {
            format!(
                "Assumed: no error is larger than {}eps_min of its own group, a bound found from these very readings\n",
                times(factor)
            )
        })
    }
}

/// What `--eps` asks for.
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

/// What is wrong with a text; where that is a number in it, as it is said of numbers in every option.
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
    /// How a table is read, and which of its rows; all of them when that is left out.
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

    /// How a table is read in parts, which may be many.
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
