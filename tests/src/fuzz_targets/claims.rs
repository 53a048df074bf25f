//! Claims from elsewhere.

use std::sync::LazyLock;
use std::time::Duration;

use boundfit_check::{Answer, CheckOptions, ClaimLimits, ClaimText, check, parse_claim_pui, read_claims};
use boundfit_estimation::Problem;
use boundfit_exact::{Limits, Rational, Reading};
use boundfit_judge::{Answer as ModelAnswer, Aspect, Ground, Solution, Tolerances, read_solution};
use boundfit_lp::{ExchangeFormat, Model, ModelLimits, read_model};

use crate::lp_cases::line_problem;

/// A fit with a bounded and one with an empty set.
static PROBLEMS: LazyLock<[Problem; 2]> = LazyLock::new(|| {
    let reading = |x: i64, y: i64| (Rational::from(x), Rational::from(y));
    let readings = [reading(0, 1), reading(1, 3), reading(3, 6)];
    [line_problem(&readings, &Rational::one()), line_problem(&readings, &Rational::ratio(1, 100))]
});

/// The smallest and the largest θ1 between 0 and 1 with 1 ≤ θ1 + θ2 ≤ 3, and one without a feasible point.
static MODELS: LazyLock<Vec<(Model, ModelAnswer)>> = LazyLock::new(|| {
    let row = |lower: i64, upper: i64| {
        format!(
            "ROWS\n N cost\n G row\nCOLUMNS\n theta1 cost 1 row 1\n theta2 row 1\nRHS\n RHS row {lower}\nRANGES\n RNG row {}\nBOUNDS\n UP BND theta1 1\n UP BND theta2 1\nENDATA\n",
            upper - lower
        )
    };
    let programs = [row(1, 3), format!("OBJSENSE\n    MAX\n{}", row(1, 3)), row(3, 4)];
    let solved = programs.iter().filter_map(|text| {
        let model = read_model(text, ExchangeFormat::Mps, &ModelLimits::default()).ok()?;
        let answer = ModelAnswer::of(&model).ok()?;
        Some((model, answer))
    });
    let solved: Vec<_> = solved.collect();
    assert_eq!(solved.len(), 3);
    solved
});

/// A claim, in JSON, as a solver's file or as four ends, is refused, or judged without a panic and the same way twice.
pub fn claim_files(data: &[u8]) {
    let Ok(text) = std::str::from_utf8(data) else { return };
    let file = ClaimText { file: "theta1-min.sol".into(), text: text.to_owned() };
    judge_as_solution(text);
    let claims = read_claims(&[file], &ClaimLimits::default()).unwrap_or_default();
    for problem in &*PROBLEMS {
        for answer in claims.clone().answers(problem).into_iter().chain(parse_claim_pui(text)) {
            judge(problem, answer);
        }
    }
}

/// The same text as a solution of a program of its own.
fn judge_as_solution(text: &str) {
    let Ok(file) = read_solution(text, &Limits::default()) else { return };
    for (model, answer) in &*MODELS {
        let Ok(solution) = Solution::new(&file, model) else { continue };
        let tolerances = Tolerances { relative: Rational::ratio(1, 1_000_000), digits_as_printed: true };
        let findings = || Ground::new(model, answer).judge(&solution, &tolerances);
        let found = findings();
        assert_eq!(found, findings());
        assert_eq!(found.about(Aspect::Status).map(|status| status.line), Some(file.status_line));
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
        all_rows: true,
    };
    let judged = || check(problem, Reading::Decimal, &options).map(|check| check.answers);
    let (one, other) = (judged(), judged());
    assert_eq!(one.ok(), other.ok());
}
