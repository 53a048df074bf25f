//! The command line.

use boundfit_exact::Reading;
use boundfit_formats::{ColumnSelector, Header, RowRange};
use boundfit_report::{EndRounding, Style};
use clap::{Args, Parser, Subcommand, ValueEnum};
use clap_complete::Shell;

/// Exact bounded-error (set-membership) estimation in two parameters, and exact polygons from half-planes.
///
/// All results are exact rational numbers with proofs; decimals are only how they are shown.
#[derive(Debug, Parser)]
#[command(name = "boundfit", bin_name = "boundfit", version, max_term_width = 100)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    pub(crate) command: Command,
}

#[derive(Debug, Subcommand)]
#[allow(clippy::large_enum_variant, reason = "one per run")]
pub(crate) enum Command {
    Fit(FitArguments),
    Polygon(PolygonArguments),
    /// Print a completion script for a shell
    #[command(after_help = "Example:\n  boundfit completions bash > /etc/bash_completion.d/boundfit")]
    Completions {
        /// The shell
        shell: Shell,
    },
    /// Print the manual page (roff) of the program or of one of its commands
    #[command(after_help = "Example:\n  boundfit man fit > boundfit-fit.1")]
    Man {
        /// A command; the program itself when left out
        topic: Option<String>,
    },
}

const FIT_EXAMPLES: &str = "\
Examples:
  A line through columns Vz and z, data rows 14 to 36, every z known to 0.5 mm:
    boundfit fit transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3
  One error bound per row, and a slope that is known not to be negative:
    boundfit fit steam.csv --x x --y y --eps-column eps --where 'theta1 >= 0'
  Two regressors without a constant, from standard input, as JSON:
    boundfit fit - --x 1,2 --y 3 --eps 1/100 --format json < readings.csv

Exit status:
  0  an answer was found
  1  bad data, or a file that cannot be read or written
  2  bad usage
  3  the feasible parameter set is empty; the proof is printed";

/// Fit y = theta1*x + theta2 + e with |e| <= eps: every parameter pair that agrees with all readings
///
/// The feasible parameter set (FPS) is the polygon of all (theta1, theta2) whose line stays within the error bound of
/// every reading. Reported are its vertices, the parameter uncertainty intervals (PUI) with the readings that prove
/// them, the central estimate, least squares with its uncertainty intervals (EUI), and the smallest error bound that
/// leaves anything.
#[derive(Debug, Args)]
#[command(after_help = FIT_EXAMPLES)]
pub(crate) struct FitArguments {
    /// A table of readings (separated by commas, semicolons or tabs), or - for standard input
    pub(crate) data: String,
    /// Column of x by header name or number from 1; two for the model y = theta1*COL + theta2*COL2 + e
    #[arg(long, value_name = "COL[,COL2]", value_parser = parse_regressors, required = true)]
    pub(crate) x: Regressors,
    /// Column of y
    #[arg(long, value_name = "COL", value_parser = parse_column, required = true)]
    pub(crate) y: ColumnSelector,
    #[command(flatten)]
    pub(crate) epsilon: EpsilonArguments,
    /// Use data rows A to B only, counted from 1 without the header
    #[arg(long, value_name = "A..B", value_parser = parse_rows)]
    pub(crate) rows: Option<AskedRows>,
    /// A linear inequality that the parameters are known to satisfy, such as '2*theta1 - theta2 <= 1/3'
    #[arg(long = "where", value_name = "CONDITION", allow_hyphen_values = true)]
    pub(crate) conditions: Vec<String>,
    #[command(flatten)]
    pub(crate) table: TableArguments,
    #[command(flatten)]
    pub(crate) output: OutputArguments,
}

/// The error bound.
#[derive(Debug, Args)]
#[group(required = true, multiple = false)]
pub(crate) struct EpsilonArguments {
    /// Error bound of every reading: a decimal or a fraction
    #[arg(long, value_name = "NUM", allow_hyphen_values = true)]
    pub(crate) eps: Option<String>,
    /// Column with the error bound of each reading
    #[arg(long, value_name = "COL", value_parser = parse_column)]
    pub(crate) eps_column: Option<ColumnSelector>,
}

const POLYGON_EXAMPLES: &str = "\
Examples:
  Half-planes in cdd's H-representation:
    boundfit polygon square.ine
  A table with columns a1,a2,b, each row meaning a1*theta1 + a2*theta2 <= b:
    printf 'a1,a2,b\\n-1,0,0\\n0,-1,0\\n2,3,6\\n' | boundfit polygon -

Exit status:
  0  an answer was found
  1  bad data, or a file that cannot be read or written
  2  bad usage
  3  the region is empty; the proof is printed";

/// Intersect any half-planes: vertices, rays, bounds, area, and which half-planes are redundant
#[derive(Debug, Args)]
#[command(after_help = POLYGON_EXAMPLES)]
pub(crate) struct PolygonArguments {
    /// FILE.ine (cdd H-representation) or FILE.csv (columns a1,a2,b), or - for standard input
    pub(crate) file: String,
    #[command(flatten)]
    pub(crate) table: TableArguments,
    #[command(flatten)]
    pub(crate) output: OutputArguments,
}

/// How the input is read.
#[derive(Debug, Args)]
pub(crate) struct TableArguments {
    /// Take numbers exactly as written, or as the nearest double, exactly
    #[arg(long, value_enum, default_value_t = ReadingName::Decimal)]
    reading: ReadingName,
    /// Whether the first row names the columns
    #[arg(long, value_enum, default_value_t = HeaderName::Auto)]
    header: HeaderName,
    /// What separates the columns
    #[arg(long, value_enum, default_value_t = DelimiterName::Auto)]
    delimiter: DelimiterName,
}

/// How the answer is written.
#[derive(Debug, Args)]
pub(crate) struct OutputArguments {
    /// Text for people or JSON for programs
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub(crate) format: Format,
    /// Write to this file instead of standard output: whole or not at all
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<String>,
    /// Significant digits of decimals
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u16).range(1..=1000))]
    digits: u16,
    /// Round interval ends outward, or to nearest as papers print them
    #[arg(long, value_enum, default_value_t = RoundingName::Outward)]
    rounding: RoundingName,
    /// Show exact fractions in place of decimals (JSON always has both)
    #[arg(long)]
    exact: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    Text,
    Json,
}

#[derive(Debug, Clone, Copy, ValueEnum)]
enum ReadingName {
    Decimal,
    Binary64,
}

#[derive(Debug, Clone, Copy, ValueEnum)]
enum HeaderName {
    Auto,
    Yes,
    No,
}

#[derive(Debug, Clone, Copy, ValueEnum)]
enum DelimiterName {
    Auto,
    Comma,
    Semicolon,
    Tab,
}

#[derive(Debug, Clone, Copy, ValueEnum)]
enum RoundingName {
    Outward,
    Nearest,
}

/// The columns of one or two regressors.
#[derive(Debug, Clone)]
pub(crate) struct Regressors {
    pub(crate) first: ColumnSelector,
    pub(crate) second: Option<ColumnSelector>,
}

/// A row range with the words it was asked for in.
#[derive(Debug, Clone)]
pub(crate) struct AskedRows {
    pub(crate) text: String,
    pub(crate) range: RowRange,
}

impl TableArguments {
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

impl OutputArguments {
    pub(crate) fn style(&self) -> Style {
        let ends = match self.rounding {
            RoundingName::Outward => EndRounding::Outward,
            RoundingName::Nearest => EndRounding::Nearest,
        };
        Style { digits: usize::from(self.digits), ends, exact: self.exact }
    }
}

fn parse_column(text: &str) -> Result<ColumnSelector, String> {
    if text.trim().is_empty() {
        return Err("expected a header name or a column number".to_owned());
    }
    Ok(ColumnSelector::name_or_number(text))
}

fn parse_regressors(text: &str) -> Result<Regressors, String> {
    match text.split(',').collect::<Vec<_>>().as_slice() {
        [first] => Ok(Regressors { first: parse_column(first)?, second: None }),
        [first, second] => {
            Ok(Regressors { first: parse_column(first)?, second: Some(parse_column(second)?) })
        }
        _ => Err("expected one column, or two separated by a comma".to_owned()),
    }
}

fn parse_rows(text: &str) -> Result<AskedRows, String> {
    let range = text
        .split_once("..")
        .and_then(|(first, last)| RowRange::new(first.trim().parse().ok()?, last.trim().parse().ok()?));
    match range {
        Some(range) => Ok(AskedRows { text: text.to_owned(), range }),
        None => Err("expected FIRST..LAST with 1 <= FIRST <= LAST, such as 14..36".to_owned()),
    }
}
