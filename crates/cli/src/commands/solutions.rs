//! The solutions that `boundfit judge` judges.

use boundfit_exact::{Limits, Rational, Reading};
use boundfit_judge::{Answer, Findings, Ground, JudgedSolution, Solution, Tolerances, read_solution};
use boundfit_lp::Model;

use crate::arguments::{LimitArguments, SolutionArguments, Switch, number_problem};
use crate::exit::Failure;
use crate::input::read_text;

/// Reads and judges all of them.
pub(super) fn judged(
    arguments: &SolutionArguments,
    limits: &LimitArguments,
    model: &Model,
    answer: &Answer,
) -> Result<Vec<JudgedSolution>, Failure> {
    let tolerances = Tolerances {
        relative: tolerance(arguments, &limits.number())?,
        digits_as_printed: arguments.digits_as_printed == Switch::On,
    };
    if arguments.solutions.is_empty() {
        return Ok(Vec::new());
    }
    let ground = Ground::new(model, answer);
    let one = |file: &String| {
        let text = read_text(file, arguments.max_solution_size, "--max-solution-size")?;
        let fail = |error| Failure::data(format_args!("{file}: {error}"));
        let solution = Solution::new(&read_solution(&text, &limits.number()).map_err(fail)?, model);
        let solution = solution.map_err(fail)?;
        let findings = ground.judge(&solution, &tolerances);
        Ok(JudgedSolution { file: file.clone(), solution, findings })
    };
    arguments.solutions.iter().map(one).collect()
}

/// Whether one of them is refuted.
pub(super) fn is_refuted(judged: &[JudgedSolution]) -> bool {
    judged.iter().any(|judged| Findings::is_refuted(&judged.findings))
}

/// How much may be wrong. Limits that are lower than usual are meant for the files: they leave this alone.
fn tolerance(arguments: &SolutionArguments, asked: &Limits) -> Result<Rational, Failure> {
    if arguments.strict {
        return Ok(Rational::zero());
    }
    let refuse = |problem: String| Failure::value("--tolerance <NUM>", &arguments.tolerance, problem);
    let usual = Limits::default();
    let limits =
        Limits { digits: asked.digits.max(usual.digits), exponent: asked.exponent.max(usual.exponent) };
    let expected = "expected a number that is at least 0, such as 1e-6";
    let tolerance = Reading::Decimal.read(&arguments.tolerance, &limits);
    let tolerance = tolerance.map_err(|error| refuse(number_problem(&error, expected)))?;
    if tolerance.is_negative() { Err(refuse("negative".to_owned())) } else { Ok(tolerance) }
}
