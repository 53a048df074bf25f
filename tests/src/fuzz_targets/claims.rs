//! Claims from elsewhere.

use std::sync::LazyLock;
use std::time::Duration;

use boundfit_check::{Answer, CheckOptions, ClaimLimits, ClaimText, check, parse_claim_pui, read_claims};
use boundfit_estimation::Problem;
use boundfit_exact::{Rational, Reading};

use crate::lp_cases::line_problem;

/// A fit with a bounded and one with an empty set.
static PROBLEMS: LazyLock<[Problem; 2]> = LazyLock::new(|| {
    let reading = |x: i64, y: i64| (Rational::from(x), Rational::from(y));
    let readings = [reading(0, 1), reading(1, 3), reading(3, 6)];
    [line_problem(&readings, &Rational::one()), line_problem(&readings, &Rational::ratio(1, 100))]
});

/// A claim, in JSON, as a solver's file or as four ends, is refused, or judged without a panic and the same way twice.
pub fn claim_files(data: &[u8]) {
    let Ok(text) = std::str::from_utf8(data) else { return };
    let file = ClaimText { file: "theta1-min.sol".to_owned(), text: text.to_owned() };
    let answers = read_claims(&[file], &ClaimLimits::default()).unwrap_or_default();
    for answer in answers.into_iter().chain(parse_claim_pui(text)) {
        for problem in &*PROBLEMS {
            judge(problem, answer.clone());
        }
    }
}

fn judge(problem: &Problem, answer: Answer) {
    let options = CheckOptions {
        solvers: Vec::new(),
        answers: vec![answer],
        tolerance: Rational::ratio(1, 1_000_000),
        as_printed: true,
        time_limit: Duration::from_secs(1),
        directions: None,
    };
    let judged = || check(problem, Reading::Decimal, &options).map(|check| check.answers);
    let (one, other) = (judged(), judged());
    assert_eq!(one.ok(), other.ok());
}
