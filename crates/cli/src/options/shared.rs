//! The arguments of several commands.

use boundfit_ask::{Form, Refusal, Regressors};
use boundfit_exact::{DecimalMark, Foreign, Reading};
use boundfit_formats::{DELIMITERS, Header, Missing};
use boundfit_report::EndRounding;
use clap::builder::{NonEmptyStringValueParser, PossibleValuesParser};
use clap::{ArgAction, Args, ValueEnum};

use crate::exit::Failure;
use crate::output::Guard;

use super::endings::{Format, NamedFormat, told_by_name};
use super::values::{named, parse_regressors, whole, words_or_auto};
use super::{LimitArguments, RowArguments};

/// The place where a text goes.
#[derive(Debug, Args)]
pub(crate) struct FileArguments {
    /// Write to this file instead of standard output: whole or not at all
    #[arg(short, long, value_name = "FILE", value_parser = NonEmptyStringValueParser::new())]
    pub(crate) output: Option<String>,
    #[command(flatten)]
    pub(crate) replace: ReplaceArguments,
}

/// The losses that writing may bring.
#[derive(Debug, Args)]
pub(crate) struct ReplaceArguments {
    /// Replace an existing file even if boundfit did not write it; never an input file or a read-only one
    #[arg(long)]
    force: bool,
}

impl ReplaceArguments {
    /// Keeps these inputs, and what else may not be replaced, from being written over.
    pub(crate) fn guard<'a>(&self, inputs: impl IntoIterator<Item = &'a str>) -> Guard {
        Guard::new(inputs, self.force)
    }
}

/// The share of the machine that is used.
#[derive(Debug, Args)]
pub(crate) struct ThreadArguments {
    /// Threads that read and reduce the data [default: all processors]. The answer does not depend on it
    #[arg(long, value_name = "N", value_parser = whole::<u16>(1, 1024))]
    pub(super) threads: Option<u16>,
}

/// The readings that are fitted, and their bounds.
#[derive(Debug, Clone, Args)]
pub(crate) struct DataArguments {
    /// A table of readings (delimited text, JSON, a workbook .xlsx or .ods, or a .mat file, plain or packed), or - for
    /// standard input
    pub(super) data: String,
    /// Column of x by header name or number from 1 (in a .mat file a vector's name, or 'M(:,2)'); two for the model
    /// y = theta1*COL + theta2*COL2 + e
    #[arg(long, value_name = "COL[,COL2]", value_parser = parse_regressors, required = true)]
    pub(super) x: Regressors,
    /// Column of y; optional beside --lower or --upper, where only least squares uses it
    #[arg(long, value_name = "COL", required_unless_present_any = ["lower", "upper"])]
    pub(super) y: Option<String>,
    #[command(flatten)]
    pub(super) epsilon: EpsilonArguments,
    #[command(flatten)]
    pub(super) rows: RowArguments,
    /// A linear inequality or equation that the parameters satisfy, such as '2*theta1 - theta2 <= 1/3' or 'theta2 = 0';
    /// repeatable
    #[arg(long = "where", value_name = "CONDITION", allow_hyphen_values = true)]
    pub(super) conditions: Vec<String>,
    #[command(flatten)]
    pub(super) line: LineArguments,
    #[command(flatten)]
    pub(crate) table: TableArguments,
}

/// The kind of lines that are fitted.
#[derive(Debug, Clone, Args)]
pub(crate) struct LineArguments {
    /// Fit y = theta1*x + e, a line without an offset: theta2 = 0 becomes the last condition, and least squares has one
    /// parameter
    #[arg(long)]
    pub(super) through_origin: bool,
    /// Fit y = theta1*(x - NUM) + theta2 + e: theta2 is the value at NUM, and reports have x - NUM for x
    #[arg(long, value_name = "NUM", allow_hyphen_values = true)]
    pub(super) x_origin: Option<String>,
}

/// The error bound.
#[derive(Debug, Clone, Args)]
#[group(required = true, multiple = true)]
pub(crate) struct EpsilonArguments {
    /// Error bound of every reading: a number such as 0.5e-3, or a law such as '0.05%*|y| + 2e-3' or '1%*range(y)'.
    /// 'written' is half a unit of the last digit written. '+0.2/-0.1' says that the truth lies in [y - 0.1, y +
    /// 0.2]. 'min' or '1.2*min' is a multiple of eps_min, the smallest bound with a non-empty set, computed from
    /// these readings
    // Some of no more than one; figures take several.
    #[arg(long, value_name = "NUM", action = ArgAction::Set, num_args = 1, allow_hyphen_values = true)]
    pub(crate) eps: Vec<String>,
    /// Column with the error bound of each reading
    #[arg(long, value_name = "COL")]
    pub(crate) eps_column: Option<String>,
    /// Column with the smallest value that the model may have at each reading, instead of an error bound; a missing
    /// cell is no bound
    #[arg(long, value_name = "COL")]
    pub(crate) lower: Option<String>,
    /// Column with the largest value that the model may have at each reading
    #[arg(long, value_name = "COL")]
    pub(crate) upper: Option<String>,
}

/// The words of pictures and pages that do not follow from the data.
#[derive(Debug, Args)]
pub(crate) struct LabelArguments {
    /// Unit of x, such as V; with two regressors, of both
    #[arg(long, value_name = "UNIT")]
    pub(crate) x_unit: Option<Foreign>,
    /// Unit of y, such as m
    #[arg(long, value_name = "UNIT")]
    pub(crate) y_unit: Option<Foreign>,
    /// Title. Default: a plain one
    #[arg(long, value_name = "TEXT")]
    pub(crate) title: Option<Foreign>,
}

/// The way the input is read.
#[derive(Debug, Clone, Args)]
pub(crate) struct TableArguments {
    /// Read numbers exactly as written, or as the nearest double, exactly [default: decimal, of .mat files binary64]
    #[arg(long, value_parser = PossibleValuesParser::new(Reading::ALL.map(Reading::name)))]
    pub(super) reading: Option<String>,
    /// Say whether the first row names the columns
    #[arg(long, default_value = Header::Auto.name(),
          value_parser = PossibleValuesParser::new(Header::ALL.map(Header::name)))]
    pub(super) header: String,
    /// Encoding of a text: utf-8, windows-1252, iso-8859-1, iso-8859-15, utf-16le or utf-16be; auto: UTF-8 or UTF-16,
    /// otherwise Windows-1252, as the report then says
    #[arg(long, value_name = "NAME", default_value = "auto", help_heading = TEXT)]
    pub(super) encoding: String,
    /// Separator of columns (space: runs of blanks and tabs)
    #[arg(long, default_value = "auto", value_parser = words_or_auto(DELIMITERS.map(|(name, _)| name)),
          help_heading = TEXT)]
    pub(super) delimiter: String,
    /// Decimal mark; auto detects it, unless commas separate the columns
    #[arg(long, default_value = "auto", value_parser = words_or_auto(DecimalMark::ALL.map(DecimalMark::name)),
          help_heading = TEXT)]
    pub(super) decimal: String,
    /// Mark between groups of three digits: ',' '.' ' ' or "'"
    #[arg(long, value_name = "MARK", help_heading = TEXT)]
    pub(super) thousands: Option<String>,
    /// Skip lines that start with this character; auto: # and % before the table; none
    #[arg(long, value_name = "MARK", default_value = "auto", help_heading = TEXT)]
    pub(super) comment: String,
    /// Skip the first N lines
    #[arg(long, value_name = "N", default_value_t = 0, help_heading = TEXT)]
    pub(super) skip_lines: u64,
    /// The row after the header has units
    #[arg(long, help_heading = TEXT)]
    pub(super) units_row: bool,
    /// Read one block of a file, by its number or by the comment before it; all: the rows of all blocks together.
    /// Comments or two blank lines between rows begin another block
    #[arg(long, value_name = "N|NAME", help_heading = TEXT)]
    pub(super) block: Option<String>,
    /// Treatment of rows with a missing number in a used column: empty, NA, N/A, #N/A, NaN, null, none, - -- . or ?, or
    /// a spreadsheet's error such as #DIV/0!
    #[arg(long, default_value = Missing::Refuse.name(), help_heading = TEXT,
          value_parser = PossibleValuesParser::new(Missing::ALL.map(Missing::name)))]
    pub(super) missing: String,
    /// Also treat cells with this text, or the same number, as missing, such as -999 or OVLD; repeatable
    #[arg(long, value_name = "TEXT", allow_hyphen_values = true, help_heading = TEXT)]
    pub(super) missing_as: Vec<String>,
    /// Sheet of an .xlsx or .ods workbook, by name or number. Default: the first
    #[arg(long, value_name = "NAME|N", value_parser = NonEmptyStringValueParser::new())]
    pub(super) sheet: Option<String>,
    #[command(flatten)]
    pub(crate) limits: LimitArguments,
}

/// The heading of what tells how a table is written.
const TEXT: &str = "Tables";

/// The way the answer is written.
#[derive(Debug, Args)]
pub(crate) struct OutputArguments<F: ValueEnum + Send + Sync + 'static = Format> {
    /// Format of the answer. Default: the ending of the output file's name (r.json, r.txt ...), else text
    #[arg(long, value_enum)]
    format: Option<F>,
    #[command(flatten)]
    pub(crate) file: FileArguments,
    /// Significant digits of decimals. Default: 5, in text more if an interval or vertices need more
    #[arg(long, value_name = "N", value_parser = whole::<u16>(1, 1000))]
    pub(super) digits: Option<u16>,
    /// Round interval ends outward, or to nearest as papers print them
    #[arg(long, default_value = EndRounding::Outward.name(),
          value_parser = named(EndRounding::ALL.map(|rounding| (rounding.name(), rounding))))]
    pub(super) rounding: EndRounding,
    /// Show exact fractions instead of decimals (JSON always has both)
    #[arg(long)]
    pub(super) exact: bool,
}

impl<F: NamedFormat + ValueEnum + Send + Sync> OutputArguments<F> {
    /// The format that is asked for, or told by the name of the output file.
    pub(crate) fn format(&self) -> Result<F, Failure> {
        self.file.format(self.format)
    }

    /// Refuses options about decimals where an answer in this form has none.
    pub(crate) fn check_decimals(&self, form: Form) -> Result<(), Failure> {
        let vain = |misuse| Failure::misused(Refusal::Misuse(misuse));
        form.refuse_vain_style(&self.style()).map_err(vain)
    }
}

impl FileArguments {
    /// The format asked for, or else told by the name of the output file.
    pub(crate) fn format<F: NamedFormat>(&self, asked: Option<F>) -> Result<F, Failure> {
        let told = || told_by_name(self.output.as_deref(), F::ENDINGS, Some("'--format'"));
        Ok(match asked {
            Some(format) => format,
            None => told()?.unwrap_or_default(),
        })
    }
}
