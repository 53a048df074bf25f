//! The command line.

mod convert;
mod reading;
mod values;

use boundfit_formats::ColumnSelector;
use clap::builder::NonEmptyStringValueParser;
use clap::{Args, Parser, Subcommand, ValueEnum, value_parser};
use clap_complete::Shell;

pub(crate) use convert::{ConvertArguments, ObjectiveName, ProgramFormat};
use values::{AskedRows, Regressors, parse_column, parse_regressors, parse_rows};
pub(crate) use values::{FactorRange, number_problem};

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
    Reduce(ReduceArguments),
    Check(CheckArguments),
    Convert(ConvertArguments),
    Verify(VerifyArguments),
    BenchSolvers(BenchSolversArguments),
    Polygon(PolygonArguments),
    Plot(PlotArguments),
    Lesson(LessonArguments),
    /// Print a completion script for a shell
    #[command(after_help = "Example:\n  boundfit completions bash > /etc/bash_completion.d/boundfit")]
    Completions {
        /// The shell
        shell: Shell,
        #[command(flatten)]
        file: FileArguments,
    },
    /// Print the manual page (roff) of the program or of one of its commands
    #[command(after_help = "Example:\n  boundfit man fit > boundfit-fit.1")]
    Man {
        /// A command; the program itself when left out
        topic: Option<String>,
        #[command(flatten)]
        file: FileArguments,
    },
}

/// Where a text goes.
#[derive(Debug, Args)]
pub(crate) struct FileArguments {
    /// Write to this file instead of standard output: whole or not at all
    #[arg(short, long, value_name = "FILE", value_parser = NonEmptyStringValueParser::new())]
    pub(crate) output: Option<String>,
}

const FIT_EXAMPLES: &str = "\
Examples:
  A line through columns Vz and z, data rows 14 to 36, every z known to 0.5 mm:
    boundfit fit transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3
  One error bound per row, and a slope that is known not to be negative:
    boundfit fit steam.csv --x x --y y --eps-column eps --where 'theta1 >= 0'
  How the set grows with the error bound, from half of eps to twice eps:
    boundfit fit transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --sweep 0.5..2
  Two regressors without a constant, from standard input, as JSON:
    boundfit fit - --x 1,2 --y 3 --eps 1/100 --format json < readings.csv
  Vectors of a MATLAB file; the vertices as a script for MATLAB and Octave (or csv, wkt, latex, markdown):
    boundfit fit transducer.mat --x Vz --y z --rows 14..36 --eps 0.5e-3 --format m -o vertices.m
  Beside the report a proof, for somebody who does not trust it:
    boundfit fit transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --proof proof.json
  Every sensor of a fleet on its own, one line each (--format json or csv for programs):
    boundfit fit fleet.csv --by sensor --x V --y level --eps 0.03

Exit status:
  0  an answer was found
  1  bad data, or a file that cannot be read or written
  2  bad usage
  3  the feasible parameter set is empty, with --by that of at least one group; the proof is printed";

/// Fit y = theta1*x + theta2 + e with |e| <= eps: every parameter pair that agrees with all readings
///
/// The feasible parameter set (FPS) is the polygon of all (theta1, theta2) whose line stays within the error bound of
/// every reading. Reported are its vertices, the parameter uncertainty intervals (PUI) with the readings that prove
/// them, the central estimate, least squares with its uncertainty intervals (EUI), and the smallest error bound that
/// leaves anything.
#[derive(Debug, Args)]
#[command(after_help = FIT_EXAMPLES)]
pub(crate) struct FitArguments {
    #[command(flatten)]
    pub(crate) data: DataArguments,
    /// Also report the sets FPS(s*eps) for all factors s from FROM to TO: where the set is born and changes its shape,
    /// and every vertex and PUI end as an exact function of s
    #[arg(id = "sweep", long = "sweep", value_name = "FROM..TO")]
    asked_factors: Option<String>,
    /// The same as numbers, within the limits that other options set.
    #[arg(skip)]
    pub(crate) sweep: Option<FactorRange>,
    /// Fit each group of rows with the same text in this column on its own: one line of text, JSON or CSV per group, in the
    /// order in which they first occur, and a summary (with JSON and CSV on standard error)
    #[arg(long, value_name = "COL", value_parser = parse_column, conflicts_with = "sweep")]
    pub(crate) by: Option<ColumnSelector>,
    /// Leave out the line about what an LP solver makes of the same data
    #[arg(long)]
    pub(crate) no_lp: bool,
    /// Leave out the estimate uncertainty intervals (EUI) where they would take a second look at more readings than
    /// are kept in memory (10000)
    #[arg(long)]
    pub(crate) no_eui: bool,
    /// Also write a proof of the answer to this file, whole or not at all: JSON that 'boundfit verify', or anybody else,
    /// checks against the data by arithmetic alone; - for standard output when the report goes to a file
    #[arg(long, value_name = "FILE", value_parser = NonEmptyStringValueParser::new())]
    pub(crate) proof: Option<String>,
    #[command(flatten)]
    pub(crate) threads: ThreadArguments,
    #[command(flatten)]
    pub(crate) output: OutputArguments<ReportFormat>,
}

const REDUCE_EXAMPLES: &str = "\
Examples:
  A million rows become a few dozen that give the same feasible set:
    boundfit reduce readings.csv --x x --y y -o reduced.csv
    boundfit fit reduced.csv --x x --y y --eps 0.01
  Parts reduced apart, put together, and reduced again:
    cat monday.csv tuesday.csv | boundfit reduce - --x x --y y -o both.csv

Exit status:
  0  the reduction is written
  1  bad data, or a file that cannot be read or written
  2  bad usage";

/// Keep only the rows that decide every fit of a line: those that touch the convex hull of the readings
///
/// Written are the same columns, each number as it stood, after a line that says how many readings these stand for and
/// the sums that least squares needs. 'boundfit fit' reads the result like the whole: feasible set, PUI, eps_min and
/// least squares are the same for every error bound; only the EUI needs every reading and is left out. Several
/// reductions one after the other, as 'cat' writes them, are a reduction of all their readings, and can be reduced again.
#[derive(Debug, Args)]
#[command(after_help = REDUCE_EXAMPLES)]
pub(crate) struct ReduceArguments {
    /// A table of readings (text or a MATLAB .mat file), or reductions of such, or - for standard input
    pub(crate) data: String,
    /// Column of x by header name or number from 1
    #[arg(long, value_name = "COL", value_parser = parse_column)]
    pub(crate) x: ColumnSelector,
    /// Column of y
    #[arg(long, value_name = "COL", value_parser = parse_column)]
    pub(crate) y: ColumnSelector,
    /// Column with the error bound of each reading: keep the rows that touch the hull of those with the same bound
    #[arg(long, value_name = "COL", value_parser = parse_column)]
    pub(crate) eps_column: Option<ColumnSelector>,
    #[command(flatten)]
    pub(crate) table: TableArguments,
    #[command(flatten)]
    pub(crate) threads: ThreadArguments,
    #[command(flatten)]
    pub(crate) file: FileArguments,
}

/// How much of the machine is used.
#[derive(Debug, Args)]
pub(crate) struct ThreadArguments {
    /// Threads that read and reduce the data; as many as there are processors when left out. The answer is the same
    #[arg(long, value_name = "N", value_parser = value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
}

const CHECK_EXAMPLES: &str = "\
Examples:
  Every solver of this build against the exact answer:
    boundfit check transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3
  The PUI that some other program printed:
    boundfit check transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 \\
      --claim-pui 1.7909e-3,1.8484e-3,2.2596e-2,2.2807e-2
  What a solver wrote about the programs of 'boundfit convert', four files in a folder:
    boundfit check transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --claim solutions
  The hull of 16 LP optimisers, the set itself, and the half-planes behind the 16 optima:
    boundfit check transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --directions 16

Exit status:
  0  no claim is refuted
  1  bad data, or a file that cannot be read or written
  2  bad usage
  4  a claim is refuted";

/// Judge LP answers about the same fit: is each end of the parameter uncertainty intervals right?
///
/// Solvers of this build and claims from elsewhere are compared with the exact answer. A verdict is exact, rounded (the
/// nearest double, give or take 4 units in the last place), within tolerance, loose (too wide), infeasible point, unsafe
/// (cuts off feasible parameters), wrong status or inverted interval, judged against the data as written and against the
/// doubles that a solver receives.
#[derive(Debug, Args)]
#[command(after_help = CHECK_EXAMPLES)]
pub(crate) struct CheckArguments {
    #[command(flatten)]
    pub(crate) data: DataArguments,
    /// Judge this solver; repeatable. All of this build when neither this nor a claim is given
    #[arg(long = "solver", value_name = "NAME")]
    pub(crate) solvers: Vec<String>,
    /// Judge the claims in this file: JSON, or the solution that GLPK, HiGHS, CPLEX (XML), CBC or SCIP wrote about one of the
    /// programs of 'boundfit convert', which its name tells (theta1-min ...); of a folder, the solutions in it; repeatable
    #[arg(long = "claim", value_name = "FILE|DIR")]
    pub(crate) claims: Vec<String>,
    /// Bytes that a claims file may have
    #[arg(long, value_name = "BYTES", default_value_t = 1 << 28, help_heading = "Limits")]
    pub(crate) max_claim_size: u64,
    /// Judge these ends of the intervals; inf and -inf claim an unbounded end; repeatable
    #[arg(long = "claim-pui", value_name = "LO1,HI1,LO2,HI2", allow_hyphen_values = true)]
    pub(crate) claimed_pui: Vec<String>,
    /// Compare the set with the optimisers of linear programs in N directions
    #[arg(long, value_name = "N", num_args = 0..=1, default_missing_value = "16",
          value_parser = value_parser!(u16).range(3..=10000))]
    pub(crate) directions: Option<u16>,
    /// How much too wide a bound may be, in widths of the interval, and how far outside a point, in units of eps
    #[arg(long, value_name = "NUM", default_value = "1e-6", allow_hyphen_values = true)]
    pub(crate) tolerance: String,
    /// Seconds that a solver may work on one program
    #[arg(long, value_name = "SECONDS", default_value_t = 60, value_parser = value_parser!(u64).range(1..=86400))]
    pub(crate) time_limit: u64,
    #[command(flatten)]
    pub(crate) output: OutputArguments,
}

const VERIFY_EXAMPLES: &str = "\
Examples:
  A proof that somebody made, against the data that it is about:
    boundfit fit transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --proof proof.json
    boundfit verify proof.json transducer.csv
  The same without boundfit:
    python3 tests/verify.py proof.json transducer.csv

Exit status:
  0  every statement of the proof is true of these data
  1  a file that cannot be read or written, or is not a proof
  2  bad usage
  4  a statement is false; the first one is named";

/// Check a proof that 'boundfit fit --proof' wrote: is every statement in it true of these data?
///
/// The data are read anew and every statement is checked by exact arithmetic, with nothing of the program that found the
/// answer but its numbers. docs/proof.md says what a proof states and why the checks suffice.
#[derive(Debug, Args)]
#[command(after_help = VERIFY_EXAMPLES)]
pub(crate) struct VerifyArguments {
    /// The proof, or - for standard input
    pub(crate) proof: String,
    /// The data, or - for standard input
    pub(crate) data: String,
    /// Text for people or JSON for programs
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub(crate) format: Format,
    #[command(flatten)]
    pub(crate) limits: LimitArguments,
    /// Bytes that a proof may have
    #[arg(long, value_name = "BYTES", default_value_t = 1 << 28, help_heading = "Limits")]
    pub(crate) max_proof_size: u64,
    #[command(flatten)]
    pub(crate) file: FileArguments,
}

/// Run every solver over a folder of cases and print who is right on which, as a Markdown table
///
/// A case is NAME.csv with columns x and y, and NAME.json with the error bound as text under "eps".
#[derive(Debug, Args)]
#[command(after_help = "Example:\n  boundfit bench-solvers fixtures/hard-lp")]
pub(crate) struct BenchSolversArguments {
    /// The folder
    pub(crate) folder: String,
    /// A Markdown table, or JSON with the verdicts of every case
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub(crate) format: Format,
    #[command(flatten)]
    pub(crate) file: FileArguments,
    #[command(flatten)]
    pub(crate) limits: LimitArguments,
}

/// Which readings are fitted, and how.
#[derive(Debug, Args)]
pub(crate) struct DataArguments {
    /// A table of readings (separated by commas, semicolons or tabs, or a MATLAB .mat file), or - for standard input
    data: String,
    /// Column of x by header name or number from 1 (in a .mat file a vector's name, or 'M(:,2)'); two for the model
    /// y = theta1*COL + theta2*COL2 + e
    #[arg(long, value_name = "COL[,COL2]", value_parser = parse_regressors, required = true)]
    x: Regressors,
    /// Column of y
    #[arg(long, value_name = "COL", value_parser = parse_column, required = true)]
    y: ColumnSelector,
    #[command(flatten)]
    epsilon: EpsilonArguments,
    /// Use data rows A to B only, counted from 1 without the header
    #[arg(long, value_name = "A..B", value_parser = parse_rows)]
    rows: Option<AskedRows>,
    /// A linear inequality that the parameters are known to satisfy, such as '2*theta1 - theta2 <= 1/3'
    #[arg(long = "where", value_name = "CONDITION", allow_hyphen_values = true)]
    conditions: Vec<String>,
    #[command(flatten)]
    pub(crate) table: TableArguments,
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
  Half-planes in an H-representation of cdd or lrs:
    boundfit polygon square.ine
  To a V-representation, whose rows are points and rays; the report on it; and back:
    boundfit polygon square.ine --format ext -o corners.ext
    boundfit polygon corners.ext
    boundfit polygon corners.ext --format ine
  A table with columns a1,a2,b, each row meaning a1*theta1 + a2*theta2 <= b:
    printf 'a1,a2,b\\n-1,0,0\\n0,-1,0\\n2,3,6\\n' | boundfit polygon -

Exit status:
  0  an answer was found
  1  bad data, or a file that cannot be read or written
  2  bad usage
  3  the region is empty; the proof is printed";

/// Intersect any half-planes: vertices, rays, bounds, area, and which half-planes are redundant
///
/// The set may also be given by its generators, a V-representation of cdd or lrs: rows '1 x y' are points, '0 x y' rays,
/// or lines where a linearity line lists them. Then its half-planes are reported (facets), the rows active at a vertex
/// are the points that equal it, and the redundant rows are the generators that are not needed. 'W x y' with W > 0 is the
/// point (x/W, y/W); rays without a point start at the origin; without any row the set is empty, all as in cdd. Options
/// that only ask for other output (maximize, verbose, ...) are passed over; those that mean another set (nonnegative,
/// project, hull in an H-representation, ...) are refused.
#[derive(Debug, Args)]
#[command(after_help = POLYGON_EXAMPLES)]
pub(crate) struct PolygonArguments {
    /// FILE.ine or FILE.ext (H- or V-representation of cdd and lrs) or FILE.csv (columns a1,a2,b), or - for standard input
    pub(crate) file: String,
    #[command(flatten)]
    pub(crate) table: TableArguments,
    #[command(flatten)]
    pub(crate) output: OutputArguments<ReportFormat>,
}

const PLOT_EXAMPLES: &str = "\
Examples:
  The feasible parameter set of a line, as SVG and as PNG:
    boundfit plot transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --figure fps -o fps.svg
    boundfit plot transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --figure fps -o fps.png
  All figures into a folder, with units on the axes:
    boundfit plot transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --x-unit V --y-unit m \\
      --figure all --format png -o figures

Exit status:
  0  the figure is drawn
  1  bad data, or a file that cannot be read or written
  2  bad usage
  3  the feasible parameter set is empty; the figure shows the readings that contradict each other";

/// Draw the readings, the intervals and the feasible parameter set as SVG or PNG
///
/// Figures of the data plane: data (readings with error bars and the least-squares line), eui and pui (the band of
/// lines with parameters at the corners of the EUI or PUI box), corridor (the band that all feasible lines really
/// cover, inside the one of the PUI box). Figures of the parameter plane: fps (the feasible parameter set with its
/// boxes and estimates), directions (the hull of the optimisers of linear programs and the polygon of their supporting
/// half-planes, beside the set).
#[derive(Debug, Args)]
#[command(after_help = PLOT_EXAMPLES)]
pub(crate) struct PlotArguments {
    #[command(flatten)]
    pub(crate) data: DataArguments,
    /// What to draw
    #[arg(long, value_enum, default_value_t = FigureName::Fps)]
    pub(crate) figure: FigureName,
    #[command(flatten)]
    pub(crate) labels: LabelArguments,
    /// Draw the response y along the horizontal axis and x along the vertical one
    #[arg(long)]
    pub(crate) flip: bool,
    /// How many directions the figure 'directions' has
    #[arg(long, value_name = "N", default_value_t = 16, value_parser = value_parser!(u16).range(3..=1000))]
    pub(crate) directions: u16,
    /// SVG or PNG; told by the name of the output file when left out, else SVG
    #[arg(long, value_enum)]
    pub(crate) format: Option<PictureFormat>,
    /// Write to this .svg or .png file, or for all figures into this folder, instead of standard output; each file
    /// whole or not at all
    #[arg(short, long, value_name = "FILE|DIR", value_parser = NonEmptyStringValueParser::new())]
    pub(crate) output: Option<String>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum FigureName {
    /// Readings with error bars and the least-squares line
    Data,
    /// Band of the lines at the corners of the EUI box
    Eui,
    /// Band of the lines at the corners of the PUI box
    Pui,
    /// The feasible parameter set
    Fps,
    /// Band of all feasible lines, inside that of the PUI box
    Corridor,
    /// Inner and outer approximation from linear programs
    Directions,
    /// Each of them
    All,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum PictureFormat {
    Svg,
    Png,
}

const LESSON_EXAMPLES: &str = "\
Example:
  boundfit lesson transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 -o lesson.html

Exit status:
  0  the page is written
  1  bad data, or a file that cannot be read or written
  2  bad usage
  3  the feasible parameter set is empty; the page shows why, and from which error bound on there is one";

/// Write a web page that explains the polygon of feasible parameters on these very readings
///
/// One file without any outside parts, for every browser: the readings and the parameter plane side by side, clipping
/// step by step, the error bound as a slider, what each reading contributes, and questions with answers. All numbers
/// on it are exact and computed when it is written.
#[derive(Debug, Args)]
#[command(after_help = LESSON_EXAMPLES)]
pub(crate) struct LessonArguments {
    #[command(flatten)]
    pub(crate) data: DataArguments,
    #[command(flatten)]
    pub(crate) labels: LabelArguments,
    /// The most readings that a page is written for: its size and the time for it grow with their square
    #[arg(long, value_name = "N", default_value_t = MOST_READINGS, value_parser = value_parser!(u16).range(1..=2000),
          help_heading = "Limits")]
    pub(crate) max_readings: u16,
    #[command(flatten)]
    pub(crate) file: FileArguments,
}

/// The most readings of a lesson, unless more are asked for.
const MOST_READINGS: u16 = boundfit_lesson::MOST_ROWS as u16;

/// What pictures and pages say besides what follows from the data.
#[derive(Debug, Args)]
pub(crate) struct LabelArguments {
    /// Unit of x, such as V; with two regressors, of both
    #[arg(long, value_name = "UNIT")]
    pub(crate) x_unit: Option<String>,
    /// Unit of y, such as m
    #[arg(long, value_name = "UNIT")]
    pub(crate) y_unit: Option<String>,
    /// Title; a plain one when left out
    #[arg(long, value_name = "TEXT")]
    pub(crate) title: Option<String>,
}

/// How the input is read.
#[derive(Debug, Args)]
pub(crate) struct TableArguments {
    /// Take numbers exactly as written, or as the nearest double, exactly; with a .mat file it is binary64
    #[arg(long, value_enum, default_value_t = ReadingName::Decimal)]
    reading: ReadingName,
    /// Whether the first row names the columns
    #[arg(long, value_enum, default_value_t = HeaderName::Auto)]
    header: HeaderName,
    /// What separates the columns
    #[arg(long, value_enum, default_value_t = DelimiterName::Auto)]
    delimiter: DelimiterName,
    #[command(flatten)]
    pub(crate) limits: LimitArguments,
}

/// What an input may ask for at most, so that a hostile one costs neither memory nor time.
#[derive(Debug, Args)]
#[command(next_help_heading = "Limits")]
pub(crate) struct LimitArguments {
    /// Digits of one number, of a fraction above and below its bar
    #[arg(long, value_name = "N", default_value_t = 10_000, value_parser = value_parser!(u64).range(1..=1_000_000))]
    max_digits: u64,
    /// Absolute value of a decimal exponent
    #[arg(long, value_name = "N", default_value_t = 10_000, value_parser = value_parser!(u32).range(0..=1_000_000))]
    max_exponent: u32,
    /// Bytes of one line, and of one row that goes over several
    #[arg(long, value_name = "BYTES", default_value_t = 1 << 24, value_parser = value_parser!(u64).range(1..=1 << 32))]
    max_line: u64,
    /// Columns of a table of text
    #[arg(long, value_name = "N", default_value_t = 100_000, value_parser = value_parser!(u64).range(1..=1 << 32))]
    max_columns: u64,
    /// Rows that an .ine or .ext file announces
    #[arg(long, value_name = "N", default_value_t = 10_000_000, value_parser = value_parser!(u64).range(1..=1 << 32))]
    max_rows: u64,
    /// Elements of one array in a .mat file
    #[arg(long, value_name = "N", default_value_t = 100_000_000, value_parser = value_parser!(u64).range(1..=1 << 32))]
    max_elements: u64,
    /// Depth of arrays and objects in a JSON file
    #[arg(long, value_name = "N", default_value_t = 64, value_parser = value_parser!(u8).range(1..=120))]
    max_nesting: u8,
}

/// How the answer is written.
#[derive(Debug, Args)]
pub(crate) struct OutputArguments<F: ValueEnum + Default + Send + Sync + 'static = Format> {
    /// Text for people or JSON for programs
    #[arg(long, value_enum, default_value_t = F::default())]
    pub(crate) format: F,
    #[command(flatten)]
    pub(crate) file: FileArguments,
    /// Significant digits of decimals
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = value_parser!(u16).range(1..=1000))]
    digits: u16,
    /// Round interval ends outward, or to nearest as papers print them
    #[arg(long, value_enum, default_value_t = RoundingName::Outward)]
    rounding: RoundingName,
    /// Show exact fractions in place of decimals (JSON always has both)
    #[arg(long)]
    exact: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub(crate) enum Format {
    #[default]
    Text,
    Json,
}

/// Formats of a fit or a region.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub(crate) enum ReportFormat {
    /// A report for people
    #[default]
    Text,
    /// Everything, for programs
    Json,
    /// The report's tables in LaTeX (booktabs)
    Latex,
    /// The report's tables in Markdown
    Markdown,
    /// The vertices as a table; with --by, bounds and estimates of each group
    Csv,
    /// The set as well-known text, in decimals of at least 17 digits; bounded sets only
    Wkt,
    /// A MATLAB or Octave script that defines the vertices
    M,
    /// The irredundant half-planes as cdd's and lrs's H-representation
    Ine,
    /// The vertices, rays and lines as cdd's and lrs's V-representation
    Ext,
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
