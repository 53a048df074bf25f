//! `boundfit reduce`.

use boundfit_ask::{Readings, Regressors, Subject};
use boundfit_estimation::{Question, ReducedTable};
use boundfit_formats::ScanOptions;
use clap::Args;

use crate::exit::{CommandResult, Exit, Failure};
use crate::input;
use crate::options::{
    BAD_DATA, BAD_USAGE, EpsilonArguments, FileArguments, Notes, RowArguments, TableArguments,
    ThreadArguments, Words, parse_regressors, told_by_name,
};
use crate::output;

pub(super) const NOTES: Notes = Notes {
    examples: &[
        (
            "A million rows become a few dozen that give the same feasible set",
            "boundfit reduce readings.csv --x x --y y -o reduced.csv\n\
             boundfit fit reduced.csv --x x --y y --eps 0.01",
        ),
        (
            "Reductions of two parts, joined and reduced again",
            "cat monday.csv tuesday.csv | boundfit reduce - --x x --y y -o both.csv",
        ),
        (
            "Readings between bounds of their own; a fit of the reduction takes the same columns",
            "boundfit reduce clocks.csv --x t --lower earliest --upper latest -o reduced.csv",
        ),
    ],
    statuses: &[(0, "the reduction is written"), BAD_DATA, BAD_USAGE],
};

/// Keep only the rows that decide: for a line under one error bound, those on the convex hull of the readings
///
/// The output has the same columns, each number as it stood, below a line with the number of readings and the sums
/// for least squares. 'boundfit fit' reads it like the whole file: feasible set, PUI and least squares are the same
/// under all conditions, from any --x-origin and through the origin. Only the EUI is missing, since it needs every
/// reading. Without a bound, or with one number, the reduction of a line is valid for every uniform bound. With
/// --eps-column it is valid for every multiple of the bounds. In both cases eps_min is the same as well. With two
/// regressors, a law, or --lower and --upper it is valid for these bounds only. Several reductions joined by 'cat'
/// are a reduction of all their readings, and can be reduced again.
#[derive(Debug, Args)]
#[command(after_help = NOTES.to_string(), mut_group("EpsilonArguments", |group| group.required(false)))]
pub(crate) struct ReduceArguments {
    /// A table of readings or reductions, or - for standard input
    data: String,
    /// Column of x by header name or number from 1; two for the model y = theta1*COL + theta2*COL2 + e
    #[arg(long, value_name = "COL[,COL2]", value_parser = parse_regressors, required = true)]
    x: Regressors,
    /// Column of y; optional beside --lower or --upper, where only least squares uses it
    #[arg(long, value_name = "COL", required_unless_present_any = ["lower", "upper"])]
    y: Option<String>,
    #[command(flatten)]
    epsilon: EpsilonArguments,
    #[command(flatten)]
    rows: RowArguments,
    #[command(flatten)]
    table: TableArguments,
    #[command(flatten)]
    threads: ThreadArguments,
    #[command(flatten)]
    file: FileArguments,
}

impl ReduceArguments {
    /// The readings.
    fn words(&self) -> Words<'_> {
        let readings = Readings {
            x: Some(self.x.clone()),
            y: self.y.clone(),
            rows: self.rows.words(),
            table: self.table.words(),
            ..self.epsilon.words()
        };
        Words { path: &self.data, readings, limits: &self.table.limits }
    }
}

/// The refusal of readings of two regressors.
const NO_BOUNDS: &str = "which readings of two regressors decide depends on their bounds: say them with '--eps', as a number or a \
                         law, '--eps-column' or '--lower' and '--upper'";

/// Reads the data and writes those rows that decide every fit.
pub(super) fn run(arguments: &ReduceArguments) -> CommandResult {
    arguments.threads.set()?;
    let output = arguments.file.output.as_deref();
    let guard = arguments.file.replace.guard([arguments.data.as_str()]);
    guard.check(output)?;
    told_by_name(output, &[("csv", ()), ("tsv", ()), ("txt", ())], None)?;
    let words = arguments.words();
    let has_bounds = words.readings.has_bounds();
    let subject = if has_bounds { Subject::BoundedReadings } else { Subject::Readings };
    let (asked, source) = words.open_for(subject)?.scan();
    let Question { columns, multiple_of_least, .. } = &asked.question;
    if columns.second.is_some() && (!has_bounds || multiple_of_least.is_some()) {
        return Err(Failure::Usage(NO_BOUNDS.to_owned()));
    }
    let options = ScanOptions { list_rows: false, ..asked.options.clone() };
    let reduced = ReducedTable::scan(source, columns, &options).map_err(Failure::refused)?;
    input::say_table(words.file_name(), reduced.table(), reduced.rows_missing());
    let mut text = Vec::new();
    // Writing to memory cannot fail.
    reduced.write(&mut text).map_err(Failure::data)?;
    output::write(&text, output, &guard)?;
    Ok(Exit::Answer)
}
