//! Readings of a file: what is asked of them, resolved, and reading them.

use std::sync::Arc;

use boundfit_ask::{Asked, Files, FitXErrors, Refusal, Shows, Subject, Tables};
use boundfit_estimation::{Keep, Problem};
use boundfit_exact::Foreign;
use boundfit_formats::{InputError, InputErrorKind, ScanOptions, Source, TableNotes, TableOptions};
use boundfit_lesson::LessonError;
use boundfit_questions::XErrorProblem;
use boundfit_report::Origin;

use crate::exit::Failure;
use crate::input;
use crate::memory;
use crate::options::Words;
use crate::progress::ReadingProgress;

/// A file, opened, and what is asked of which of its readings.
pub(crate) struct Data<'a> {
    /// The origin of the readings, for reports.
    pub(crate) origin: Origin<'a>,
    asked: Asked,
    source: Source,
    /// The file in the words of reports.
    name: Foreign<&'a str>,
}

impl<'a> Words<'a> {
    /// Opens the file of readings whose errors have bounds.
    pub(crate) fn open(&self) -> Result<Data<'a>, Failure> {
        Ok(self.open_for(Subject::BoundedReadings)?.holding(memory::OF_A_READING))
    }

    /// Opens the file, for a question with this subject. The file is opened first, since it tells how
    /// numbers are read in both it and the options. That it cannot be opened is said after what is wrong with the options.
    pub(crate) fn open_for(&self, subject: Subject) -> Result<Data<'a>, Failure> {
        let source = input::open(self.path).map_err(Failure::refused);
        // Half-planes and linear programs are read as written, whatever the file.
        let has_readings = matches!(subject, Subject::BoundedReadings | Subject::Readings);
        let is_stored = has_readings && source.as_ref().is_ok_and(Source::is_stored);
        let resolved = || {
            let (words, reading) = (&self.readings, self.readings.table.reading(is_stored)?);
            let mut asked = words.resolve_for(subject, reading)?;
            // One budget for all that the command reads.
            asked.options.table.sizes.memory = self.limits.sizes().memory;
            let table = TableOptions { reading: words.table.reading(false)?, ..asked.options.table.clone() };
            let beside = Files(ScanOptions { table, ..asked.options.clone() });
            Ok(Asked { tables: Some(Arc::new(FilesBeside(beside))), ..asked })
        };
        let name = self.file_name();
        let asked = resolved().map_err(|refusal| Failure::of(&refusal, name))?;
        let file = (self.path != "-").then_some(Foreign::of(self.path));
        let origin = Origin { file, reading: asked.options.table.reading, is_stored };
        Ok(Data { origin, asked, source: source?, name })
    }
}

/// Files beside the data, which are read in the same way.
struct FilesBeside(Files);

impl Tables for FilesBeside {
    fn open(&self, name: &str) -> Result<(Source, ScanOptions), Refusal> {
        let source = input::open(name)?;
        let options = with_progress(self.0.options(&source), &source);
        Ok((source, options))
    }

    fn was_read(&self, name: &str, table: Option<&TableNotes>, rows_missing: usize) {
        input::say_table_beside(Foreign::of(input::named(name)), table, rows_missing);
    }
}

/// Options of a scan that shows how far it is.
fn with_progress(options: ScanOptions, source: &Source) -> ScanOptions {
    ScanOptions { progress: Some(ReadingProgress::new(source.length())), ..options }
}

impl<'a> Data<'a> {
    /// Sets how many bytes the command holds for each reading, with all that it makes of the reading.
    pub(crate) fn holding(mut self, row_cost: usize) -> Self {
        self.asked.options.table.row_cost = row_cost;
        self
    }

    /// The data, which are refused as soon as they have more readings than this.
    pub(crate) fn at_most(mut self, most_wanted: usize) -> Self {
        self.asked.options.table.most_wanted = Some(most_wanted);
        self
    }

    /// The question, its readings, and the file that they stand in, which may be read in many parts.
    pub(crate) fn scan(self) -> (Asked, Source) {
        memory::keep_freed();
        let Data { asked, source, .. } = self;
        let options = with_progress(asked.options, &source);
        (Asked { options, ..asked }, source)
    }

    /// Reads the problem, and keeps the readings of the file that are not fitted.
    pub(crate) fn problem_with_others(self) -> Result<Problem, Failure> {
        self.read(|table| TableOptions { keep_others: true, ..table })
    }

    /// Reads what [`Data::problem_with_others`] does, with the texts of the cells.
    pub(crate) fn problem_with_cells(self) -> Result<Problem, Failure> {
        self.read(|table| TableOptions { keep_others: true, keep_cells: true, ..table })
    }

    /// Reads what [`Data::problem_with_others`] does, without the hash of the data: in less memory where no reading may be left out.
    /// If there are more than `most_plain` of a line under a uniform error bound, they stay in their columns.
    pub(crate) fn shown_problem(self, most_plain: usize) -> Result<Problem, Failure> {
        match self.asked.options.table.selects_rows() {
            true => self.problem_with_others(),
            false => self.scanned(Keep { most_plain, ..Keep::EVERY }, Shows::Nothing),
        }
    }

    /// Reads the problem for one look at each reading: those of a line under a uniform bound stay in their columns.
    pub(crate) fn problem_in_columns(self) -> Result<Problem, Failure> {
        self.scanned(Keep { most_rows: usize::MAX, ..Keep::DECIDING }, Shows::Nothing)
    }

    /// Reads the problem with every reading, and without the hash of the data.
    pub(crate) fn whole_problem(self) -> Result<Problem, Failure> {
        self.scanned(Keep::EVERY, Shows::Nothing)
    }

    /// Reads the readings with the bounds on the errors of x, and those that are not fitted, for pictures.
    pub(crate) fn x_error_problem(self) -> Result<XErrorProblem, Failure> {
        let name = self.name;
        let (asked, source) = self.scan();
        let problem = asked.x_error_problem(source, FitXErrors::ROW_COST, Shows::Nothing, true);
        problem.map_err(|refusal| Failure::of(&refusal, name))
    }

    fn scanned(self, keep: Keep, shows: Shows) -> Result<Problem, Failure> {
        let name = self.name;
        let (asked, source) = self.scan();
        let row_cost = asked.options.table.row_cost;
        let problem = asked.scanned(source, (row_cost, shows), Keep { eui: false, ..keep });
        problem.map_err(|refusal| Failure::of(&refusal, name))
    }

    fn read(self, with: impl FnOnce(TableOptions) -> TableOptions) -> Result<Problem, Failure> {
        let Data { asked, source, name, .. } = self;
        let table = with(asked.options.table.clone());
        asked.read(source, &table).map_err(|refusal| match refusal {
            Refusal::Input(error) => refused_reading(error),
            refusal => Failure::of(&refusal, name),
        })
    }
}

/// The reason why readings cannot be had; of more than a lesson shows, what to do.
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
