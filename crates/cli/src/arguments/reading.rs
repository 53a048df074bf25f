//! From options to what the libraries take.

use boundfit_estimation::{Columns, Condition, EpsilonColumn, Keep, Measurements, Problem};
use boundfit_exact::{Limits, Rational, Reading};
use boundfit_formats::{Header, RowRange, ScanOptions, Source, TableOptions};
use boundfit_report::{EndRounding, Style};
use clap::ValueEnum;

use super::{
    DataArguments, DelimiterName, HeaderName, OutputArguments, ReadingName, RoundingName, TableArguments,
    ThreadArguments,
};
use crate::exit::Failure;
use crate::progress::ReadingProgress;

impl DataArguments {
    /// The file in the words of reports.
    pub(crate) fn file_name(&self) -> &str {
        if self.data == "-" { "standard input" } else { &self.data }
    }

    /// The row range in the user's words.
    pub(crate) fn rows_asked(&self) -> Option<&str> {
        self.rows.as_ref().map(|rows| rows.text.as_str())
    }

    /// Reads the problem.
    pub(crate) fn problem(&self) -> Result<Problem, Failure> {
        self.read(false)
    }

    /// Reads the problem, and keeps the readings of the file that are not fitted.
    pub(crate) fn problem_with_others(&self) -> Result<Problem, Failure> {
        self.read(true)
    }

    /// Reads the problem in memory that does not grow with the file, where the model allows it; with the hash of the data
    /// if it will be shown.
    pub(crate) fn scanned_problem(&self, eui: bool, hash: bool) -> Result<Problem, Failure> {
        let (columns, conditions) = self.asked()?;
        let options = self.table.scan_options(&self.data, self.rows.as_ref().map(|rows| rows.range));
        let options = ScanOptions { hash, ..options };
        let keep = Keep { eui, ..Keep::default() };
        let measurements = Measurements::scan(&self.data, &columns, &options, keep).map_err(Failure::data)?;
        Ok(Problem { measurements, conditions })
    }

    /// Opens the file.
    pub(crate) fn source(&self) -> Result<Source, Failure> {
        Source::open(&self.data).map_err(Failure::data)
    }

    /// How the file is read in parts.
    pub(crate) fn scan_options(&self) -> ScanOptions {
        self.table.scan_options(&self.data, self.rows.as_ref().map(|rows| rows.range))
    }

    fn read(&self, keep_others: bool) -> Result<Problem, Failure> {
        let (columns, conditions) = self.asked()?;
        let rows = self.rows.as_ref().map(|rows| rows.range);
        let options = TableOptions { keep_others, ..self.table.options(rows) };
        let source = Source::open(&self.data).map_err(Failure::data)?;
        let measurements = Measurements::read(source, &columns, &options).map_err(Failure::data)?;
        Ok(Problem { measurements, conditions })
    }

    /// The columns and conditions asked for.
    pub(crate) fn asked(&self) -> Result<(Columns, Vec<Condition>), Failure> {
        let reading = self.table.reading();
        let limits = Limits::default();
        let epsilon = match (&self.epsilon.eps, &self.epsilon.eps_column) {
            (Some(eps), _) => EpsilonColumn::Uniform(error_bound(eps, reading, &limits)?),
            (None, Some(column)) => EpsilonColumn::Column(column.clone()),
            (None, None) => return Err(Failure::Usage("'--eps' or '--eps-column' is missing".to_owned())),
        };
        let condition = |text: &String| {
            Condition::parse(text, reading, &limits)
                .map_err(|error| Failure::value("--where <CONDITION>", text, error))
        };
        let conditions = self.conditions.iter().map(condition).collect::<Result<_, _>>()?;
        let columns = Columns {
            first: self.x.first.clone(),
            second: self.x.second.clone(),
            response: self.y.clone(),
            epsilon,
        };
        Ok((columns, conditions))
    }
}

fn error_bound(text: &str, reading: Reading, limits: &Limits) -> Result<Rational, Failure> {
    let expected = "expected a number that is at least 0, such as 0.5e-3 or 1/2000";
    let refuse =
        |problem: String| Failure::value("--eps <NUM>", text, format_args!("{problem} ({expected})"));
    let value = reading.read(text, limits).map_err(|error| refuse(format!("not a number: {error}")))?;
    if value.is_negative() { Err(refuse("negative".to_owned())) } else { Ok(value) }
}

impl TableArguments {
    fn options(&self, rows: Option<RowRange>) -> TableOptions {
        TableOptions {
            header: self.header(),
            delimiter: self.delimiter(),
            rows,
            keep_others: false,
            reading: self.reading(),
            limits: Limits::default(),
        }
    }

    /// How the table at a path is read in parts.
    pub(crate) fn scan_options(&self, path: &str, rows: Option<RowRange>) -> ScanOptions {
        ScanOptions {
            table: self.options(rows),
            progress: Some(ReadingProgress::new(path)),
            ..ScanOptions::default()
        }
    }

    pub(crate) fn reading(&self) -> Reading {
        match self.reading {
            ReadingName::Decimal => Reading::Decimal,
            ReadingName::Binary64 => Reading::Binary64,
        }
    }

    pub(crate) fn header(&self) -> Header {
        match self.header {
            HeaderName::Auto => Header::Auto,
            HeaderName::Yes => Header::Present,
            HeaderName::No => Header::Absent,
        }
    }

    pub(crate) fn delimiter(&self) -> Option<u8> {
        match self.delimiter {
            DelimiterName::Auto => None,
            DelimiterName::Comma => Some(b','),
            DelimiterName::Semicolon => Some(b';'),
            DelimiterName::Tab => Some(b'\t'),
        }
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

impl<F: ValueEnum + Default + Send + Sync + 'static> OutputArguments<F> {
    pub(crate) fn style(&self) -> Style {
        let ends = match self.rounding {
            RoundingName::Outward => EndRounding::Outward,
            RoundingName::Nearest => EndRounding::Nearest,
        };
        Style { digits: usize::from(self.digits), ends, exact: self.exact }
    }
}
