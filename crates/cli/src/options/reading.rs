//! Turns options into readings as every surface says them.

use boundfit_ask::{Given, Readings, TableWords};
use boundfit_estimation::Measurements;
use boundfit_exact::Foreign;
use boundfit_report::Style;
use clap::ValueEnum;

use super::shared::{EpsilonArguments, LineArguments};
use super::{
    DataArguments, LabelArguments, LimitArguments, OutputArguments, TableArguments, ThreadArguments,
    XErrorArguments,
};
use crate::exit::Failure;
use crate::input;

/// Readings in the words of options, and the file that they stand in.
pub(crate) struct Words<'a> {
    /// The file as it was named on the command line.
    pub(crate) path: &'a str,
    /// The words.
    pub(crate) readings: Readings,
    /// The limits, with the memory that all share.
    pub(crate) limits: &'a LimitArguments,
}

impl<'a> Words<'a> {
    /// The file in the words of reports.
    pub(crate) fn file_name(&self) -> Foreign<&'a str> {
        Foreign::of(input::named(self.path))
    }
}

impl DataArguments {
    /// The file in the words of reports.
    pub(crate) fn file_name(&self) -> Foreign<&str> {
        Foreign::of(input::named(&self.data))
    }

    /// The file as it was named on the command line.
    pub(crate) fn path(&self) -> &str {
        &self.data
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

    /// The readings, whose x have no errors.
    pub(crate) fn words(&self) -> Words<'_> {
        let readings = Readings {
            x: Some(self.x.clone()),
            y: self.y.clone(),
            conditions: given(&self.conditions),
            rows: self.rows.words(),
            table: self.table.words(),
            ..self.line.beside(self.epsilon.words())
        };
        Words { path: &self.data, readings, limits: &self.table.limits }
    }

    /// The readings, with what is said of the errors of their x.
    pub(crate) fn words_with(&self, x_errors: &XErrorArguments) -> Words<'_> {
        let Words { path, readings, limits } = self.words();
        Words { path, readings: x_errors.beside(readings), limits }
    }
}

/// Numbers, or texts with numbers in them, that are read as the table's are.
pub(crate) fn given(texts: &[String]) -> Vec<Given> {
    texts.iter().cloned().map(Given::Read).collect()
}

impl EpsilonArguments {
    /// The error bound, and nothing else.
    pub(crate) fn words(&self) -> Readings {
        Readings {
            eps: self.eps.first().cloned().map(Given::Read),
            eps_column: self.eps_column.clone(),
            lower: self.lower.clone(),
            upper: self.upper.clone(),
            ..Readings::default()
        }
    }
}

impl LineArguments {
    /// Says which lines are fitted, beside what else is said.
    pub(crate) fn beside(&self, readings: Readings) -> Readings {
        Readings {
            through_origin: self.through_origin,
            x_origin: self.x_origin.clone().map(Given::Read),
            ..readings
        }
    }
}

impl TableArguments {
    /// Says how the table is read.
    pub(crate) fn words(&self) -> TableWords {
        TableWords {
            reading: self.reading.clone(),
            header: Some(self.header.clone()),
            encoding: Some(self.encoding.clone()),
            delimiter: Some(self.delimiter.clone()),
            decimal: Some(self.decimal.clone()),
            thousands: self.thousands.clone(),
            comment: Some(self.comment.clone()),
            skip_lines: self.skip_lines,
            units_row: self.units_row,
            missing: Some(self.missing.clone()),
            missing_as: self.missing_as.clone(),
            block: self.block.clone(),
            sheet: self.sheet.clone(),
            limits: self.limits.words(),
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
