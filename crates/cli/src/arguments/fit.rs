//! The arguments of `boundfit fit`.

use boundfit_ask::{Fit, Given, Window};
use boundfit_exact::Limit;
use clap::builder::NonEmptyStringValueParser;
use clap::{Args, value_parser};

use super::notes::{BAD_DATA, BAD_USAGE, Notes};
use super::values::column_text;
use super::{DataArguments, OutputArguments, ReportFormat, ThreadArguments, XErrorArguments, limits};

pub(super) const NOTES: Notes = Notes {
    examples: &[
        (
            "A line through columns Vz and z, data rows 14 to 36, every z known to 0.5 mm",
            "boundfit fit transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3",
        ),
        (
            "One error bound per row, and a slope that is known not to be negative",
            "boundfit fit steam.csv --x x --y y --eps-column eps --where 'theta1 >= 0'",
        ),
        (
            "How the set grows with the error bound, from half of eps to twice eps",
            "boundfit fit transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --sweep 0.5..2",
        ),
        (
            "Two regressors without a constant, from standard input, as JSON",
            "boundfit fit - --x 1,2 --y 3 --eps 1/100 --format json < readings.csv",
        ),
        (
            "Vectors of a MATLAB file; the vertices as a script for MATLAB and Octave (or csv, wkt, latex, markdown)",
            "boundfit fit transducer.mat --x Vz --y z --rows 14..36 --eps 0.5e-3 --format m -o vertices.m",
        ),
        (
            "Beside the report a proof, for somebody who does not trust it",
            "boundfit fit transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --proof proof.json",
        ),
        (
            "A theorem that the kernel of Coq checks, without anything of boundfit",
            "boundfit fit transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --proof answer.v\n\
             coqc answer.v",
        ),
        (
            "At least which share of further readings the band of eps_min holds, with confidence 0.99",
            "boundfit fit transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --confidence 0.99",
        ),
        (
            "Errors in x as well: lines that meet every box U +- 0.2, I +- 2",
            "boundfit fit current.csv --x U --y I --eps 2 --x-eps 0.2",
        ),
        (
            "Every sensor of a fleet on its own, one line each (--format json or csv for programs)",
            "boundfit fit fleet.csv --by sensor --x V --y level --eps 0.03",
        ),
        (
            "The last 10 readings, each time 5 more have come",
            "boundfit fit transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --window 10 --step 5",
        ),
    ],
    statuses: &[
        (0, "an answer was found"),
        BAD_DATA,
        BAD_USAGE,
        (
            3,
            "the feasible parameter set is empty, with --by that of at least one group; the proof is printed (of windows too)",
        ),
    ],
};

/// Fit y = theta1*x + theta2 + e with |e| <= eps: every parameter pair that agrees with all readings
///
/// The feasible parameter set (FPS) is the polygon of all (theta1, theta2) whose line stays within the error bound of
/// every reading. The report lists its vertices, the interval of each parameter (PUI), the central estimate, least
/// squares with its interval (EUI), and the smallest possible error bound.
#[derive(Debug, Args)]
#[command(after_help = NOTES.to_string(), mut_arg("limit", limits::with(&[Limit::Fraction])))]
pub(crate) struct FitArguments {
    #[command(flatten)]
    pub(crate) data: DataArguments,
    #[command(flatten)]
    pub(crate) x_errors: XErrorArguments,
    /// Also report the sets FPS(s*eps) for all factors s from FROM to TO: the factors at which the set begins and
    /// changes its shape, and each vertex and PUI end as an exact function of s
    #[arg(long, value_name = "FROM..TO")]
    pub(crate) sweep: Option<String>,
    /// Fit each group of rows with the same text in this column separately: one line of text, JSON or CSV per group in
    /// order of first occurrence, and a summary (with JSON and CSV on standard error)
    #[arg(long, value_name = "COL", value_parser = column_text, conflicts_with = "sweep")]
    pub(crate) by: Option<String>,
    /// Fit the last N readings in order of rows, repeatedly: one line of text, JSON or CSV per whole window
    #[arg(long, value_name = "N", value_parser = value_parser!(u64).range(1..),
          conflicts_with_all = ["window_x", "by", "sweep", "brief", "vertices", "inverse", "proof"])]
    pub(crate) window: Option<u64>,
    /// Fit the readings whose x is at most NUM below the x of the newest, in order of x, repeatedly: one line per
    /// window
    #[arg(long, value_name = "NUM", allow_hyphen_values = true,
          conflicts_with_all = ["by", "sweep", "brief", "vertices", "inverse", "proof"])]
    pub(crate) window_x: Option<String>,
    /// Number of readings by which a window moves each time [default: 1]
    #[arg(long, value_name = "K", value_parser = value_parser!(u64).range(1..))]
    pub(crate) step: Option<u64>,
    /// Report everything: also the proof of each PUI end, all estimates of the inverse line, area, centroid, least squares in
    /// doubles, and the answer of an LP solver
    #[arg(long, conflicts_with_all = ["by", "brief", "window", "window_x"])]
    pub(crate) full: bool,
    /// With --full: do not ask an LP solver
    #[arg(long)]
    pub(crate) no_lp: bool,
    /// Skip results that need a second pass over files of more than 10000 rows: the estimate uncertainty intervals (EUI), and
    /// eps_min unless the model is a line under a uniform error bound
    #[arg(long)]
    pub(crate) no_eui: bool,
    /// Report ten lines only: model, data, kind of set, PUI, central estimate, smallest error bound
    #[arg(long, conflicts_with_all = ["by", "sweep", "inverse"])]
    pub(crate) brief: bool,
    /// With --format csv: write the vertices, rays and lines of the set instead of intervals and estimates
    #[arg(long, conflicts_with = "by")]
    pub(crate) vertices: bool,
    /// Also report the inverse line x = gain*y + offset if the PUI of theta1 contains 0
    #[arg(long, conflicts_with = "by")]
    pub(crate) inverse: bool,
    /// Also report a guaranteed share of further readings in the band of eps_min, with this confidence between 0 and 1,
    /// such as 0.99. It assumes that all readings are independent draws from one source
    #[arg(long, value_name = "NUM", allow_hyphen_values = true, conflicts_with_all = ["by", "brief"])]
    pub(crate) confidence: Option<String>,
    /// Also write a proof of the answer to this file, whole or not at all. The proof is JSON that 'boundfit verify', or
    /// anybody else, checks against the data by arithmetic alone; in FILE.v it is a theorem for the kernel of Coq instead.
    /// - means standard output if the report goes to a file
    #[arg(long, value_name = "FILE", value_parser = NonEmptyStringValueParser::new())]
    pub(crate) proof: Option<String>,
    /// Let the theorem of '--proof FILE.v' require the installed theory 'Boundfit' instead of holding it
    #[arg(long, requires = "proof")]
    pub(crate) proof_library: bool,
    #[command(flatten)]
    pub(crate) threads: ThreadArguments,
    #[command(flatten)]
    pub(crate) output: OutputArguments<ReportFormat>,
}

impl FitArguments {
    /// The question about the fit of all readings.
    pub(crate) fn question(&self) -> Fit {
        Fit {
            no_eui: self.no_eui,
            sweep: self.sweep.clone(),
            confidence: self.confidence.clone().map(Given::Read),
            brief: self.brief,
            full: self.full,
            inverse: self.inverse,
        }
    }

    /// The windows that are asked for, if they are.
    pub(crate) fn window(&self) -> Option<Window> {
        let is_asked = self.window.is_some() || self.window_x.is_some() || self.step.is_some();
        is_asked.then(|| Window {
            window: self.window.map(limits::size),
            window_x: self.window_x.clone().map(Given::Read),
            step: self.step.map(limits::size),
        })
    }
}
