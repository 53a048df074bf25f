//! Running and judging all answers.

use std::time::Duration;

use boundfit_estimation::Problem;
use boundfit_exact::{Foreign, Rational, Reading};
use boundfit_lp::{Judgement, Referee, Verdict};

use crate::answer::Answer;
use crate::directions::{AskedDirections, Directions, directions};
use crate::rows::ProgramRows;
use crate::sources::{SourceError, answer_of};

/// The answers to check, and the way to do it.
#[derive(Debug, Clone)]
pub struct CheckOptions {
    /// Solvers to run, by name.
    pub solvers: Vec<String>,
    /// Answers from elsewhere.
    pub answers: Vec<Answer>,
    /// The error that still counts as within tolerance: of bounds in widths of the interval, of points in units of ε.
    pub tolerance: Rational,
    /// Says whether numbers in texts are judged as precise as they are printed, or exactly as they are spelt.
    pub as_printed: bool,
    /// The longest that a solver may work on one program.
    pub time_limit: Duration,
    /// The directions in which the set is compared; none when `None`.
    pub directions: Option<AskedDirections>,
    /// True if the programs have the rows of all readings. Otherwise the programs may have only the rows of the
    /// readings on a hull. That holds for more than [`MOST_READINGS`] readings of a line under a uniform error bound,
    /// of which most cannot bound anything.
    pub all_rows: bool,
}

/// The number of readings up to which the programs have all rows in any case.
pub const MOST_READINGS: usize = 1_000;

/// The number of readings that the linear programs are about.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct AskedReadings {
    /// The readings whose rows the programs have.
    pub asked: usize,
    /// All that are fitted.
    pub fitted: usize,
}

/// One answer, judged against one reading of the data.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct JudgedAnswer {
    /// The source of the answer.
    pub source: Foreign,
    /// The data that it is judged against.
    pub reading: Reading,
    /// The judgements, by parameter, then lower and upper end.
    pub bounds: [[Judgement; 2]; 2],
}

impl JudgedAnswer {
    /// The worst of the four verdicts.
    pub fn worst(&self) -> Verdict {
        self.bounds.iter().flatten().map(|judgement| judgement.verdict).max().unwrap_or(Verdict::NoAnswer)
    }
}

/// Everything that was found.
#[derive(Debug, Clone)]
pub struct Check {
    /// Every answer, judged against the data as read, then against the binary64 numbers that a solver receives. The
    /// second judgement is missing if these numbers overflow or are the same, or if the source did not work with
    /// them.
    pub answers: Vec<JudgedAnswer>,
    /// The set beside its approximations by linear programs.
    pub directions: Option<Directions>,
    /// The rows, for their names.
    pub rows: ProgramRows,
    /// The tolerance that was asked for.
    pub tolerance: Rational,
    /// Says whether numbers in texts were judged as precise as they are printed.
    pub as_printed: bool,
    /// The number of readings that the programs are about.
    pub readings: AskedReadings,
}

impl Check {
    /// The worst verdict against the data read like this; `None` without answers. That against the data as read decides the
    /// exit status.
    pub fn worst(&self, reading: Reading) -> Option<Verdict> {
        self.answers.iter().filter(|answer| answer.reading == reading).map(JudgedAnswer::worst).max()
    }
}

/// Runs the solvers and judges their answers and those from elsewhere. The answers are floating point, the judgement is
/// exact. `reading` says how the problem's numbers were read.
///
/// # Errors
/// When this build lacks a solver asked for.
pub fn check(problem: &Problem, reading: Reading, options: &CheckOptions) -> Result<Check, SourceError> {
    let measurements = &problem.measurements;
    let kept = measurements.kept();
    let is_large = measurements.fitted() > MOST_READINGS && !options.all_rows;
    let supporting = is_large.then(|| measurements.supporting()).flatten();
    let asked = supporting.as_deref().unwrap_or(kept);
    let readings = AskedReadings { asked: asked.len(), fitted: measurements.fitted() };
    let rows = ProgramRows::of(asked, problem);
    let mut answers = options.answers.clone();
    for name in &options.solvers {
        answers.push(answer_of(name, &rows, options.time_limit)?);
    }
    if !options.as_printed {
        answers = answers.into_iter().map(Answer::without_precision).collect();
    }
    let as_read = Referee::new(rows.rows().to_vec(), options.tolerance.clone());
    let rounded =
        rows.in_binary64().filter(|rounded| reading == Reading::Decimal && rounded.rows() != rows.rows());
    let received = rounded.map(|rounded| Referee::new(rounded.rows().to_vec(), options.tolerance.clone()));
    let judged = |answer: &Answer, referee: &Referee, reading: Reading| JudgedAnswer {
        source: answer.source.clone(),
        reading,
        bounds: {
            let [theta1, theta2] = &answer.claims;
            [referee.judge_interval(0, theta1), referee.judge_interval(1, theta2)]
        },
    };
    let mut judged_answers = Vec::new();
    for answer in &answers {
        judged_answers.push(judged(answer, &as_read, reading));
        let received = received.as_ref().filter(|_| !answer.exact_input);
        judged_answers.extend(received.map(|referee| judged(answer, referee, Reading::Binary64)));
    }
    let directions = options.directions.map(|asked| directions(problem, &rows, asked));
    let CheckOptions { tolerance, as_printed, .. } = options;
    Ok(Check {
        answers: judged_answers,
        directions,
        rows,
        tolerance: tolerance.clone(),
        as_printed: *as_printed,
        readings,
    })
}
