//! Answers of linear-programming solvers, judged exactly.
//!
//! Each end of a parameter's interval is the optimum of a linear program. A referee that shares no code with the polygon
//! engine says what a claim about it is worth:
//!
//! ```
//! use boundfit::check::{Verdict, check};
//! use boundfit::Observations;
//!
//! let problem = Observations::line(&[0, 1, 2], &["0", "1.5", "2"])?.error_bound("1/2")?;
//! // 1/2 ≤ theta1 ≤ 3/2 and -1/2 ≤ theta2 ≤ 1/2. The first claim cuts off a part of the set, the last one is too wide.
//! let judged = check(&problem, &[[0.6, 1.5], [-0.5, 0.7]])?;
//! let verdicts = judged.map(|ends| ends.map(|end| end.verdict));
//! assert_eq!(verdicts, [[Verdict::Unsafe, Verdict::Exact], [Verdict::Exact, Verdict::Loose]]);
//! # Ok::<(), boundfit::Error>(())
//! ```

use boundfit_check::ProgramRows;
use boundfit_estimation::Problem;
use boundfit_exact::Rational;
use boundfit_lp::Referee;
pub use boundfit_lp::{
    BoundClaim, Claimed, Judgement, NumberFormat, Precision, Printed, PuiEnd, RoundedTo, ToleranceUnit,
    Verdict,
};

use crate::number::Number;
use crate::observations::Error;

/// Judges claimed intervals of both parameters, each from its lower to its upper end. Exact: the numbers are taken for what they
/// are, texts as precise to their last digit ([`Printed::typed`]). A claim is within tolerance if it is off by at most 10⁻⁶ of the
/// interval's width, to either side. Cost: four programs of as many rows as twice the readings.
///
/// # Errors
/// When a claim has no exact value.
pub fn check<N: Number>(problem: &Problem, claimed: &[[N; 2]; 2]) -> Result<[[Judgement; 2]; 2], Error> {
    let claims = PuiEnd::try_each(|end| {
        let number = end.of(claimed);
        let value = number.exact().map_err(|problem| Error::Claim { end: end.name(), problem })?;
        let printed = match number.text() {
            Some(text) => Printed::typed(text, value),
            None => Printed::exact(value),
        };
        Ok::<_, Error>(BoundClaim::bare(Claimed::Value(printed)))
    })?;
    Ok(judge(problem, &claims))
}

/// Judges claims of any kind, as [`check`](fn@check) does. Further claims say that a parameter has no bound or that
/// there is no feasible point, with the point or the multipliers of a solver. Numbers may have the precision with
/// which they were printed ([`Printed`]).
pub fn judge(problem: &Problem, claims: &[[BoundClaim; 2]; 2]) -> [[Judgement; 2]; 2] {
    let rows = ProgramRows::new(problem);
    let referee = Referee::new(rows.rows().to_vec(), Rational::ratio(1, 1_000_000));
    let [theta1, theta2] = claims;
    [referee.judge_interval(0, theta1), referee.judge_interval(1, theta2)]
}
