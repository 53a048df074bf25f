//! The results of linear programs for the same data: the set seen from several directions, and the ends of the
//! intervals as solvers report them, judged exactly.

use std::time::Duration;

use boundfit_check::{
    Approximation, AskedDirections, Directions, EXACT_SIMPLEX, ProgramRows, answer_of, directions,
    source_names,
};
use boundfit_estimation::Problem;
use boundfit_exact::{Rational, Reading, Rounding};
use boundfit_lp::{BoundClaim, End, Judgement, PuiEnd, Referee, Refutation, ToleranceUnit, Verdict};
use boundfit_report::{Number, Style};
use serde::Serialize;

use crate::leave_one_out::PARAMETERS;
use crate::number::{STYLE, point, with_minus};
use crate::points::Points;
use crate::texts::{Message, Value, text};

/// The number of directions that the set is seen from.
const DIRECTIONS: AskedDirections = AskedDirections { count: 16, is_scaled: false };

/// The longest that a solver may work on one program.
const TIME_LIMIT: Duration = Duration::from_secs(10);

/// The claims of a solver about the four ends, and what the claims are worth against the data as read.
#[derive(Debug)]
pub(crate) struct LpAnswer {
    /// The solver with its version.
    pub(crate) source: String,
    /// `true` if it is the exact simplex.
    pub(crate) is_exact: bool,
    /// The claims by parameter, then lower and upper end.
    pub(crate) claims: [[BoundClaim; 2]; 2],
    /// Likewise.
    pub(crate) judgements: [[Judgement; 2]; 2],
}

/// Everything that linear programs say.
#[derive(Debug)]
pub(crate) struct Programs {
    /// The set between its inner and its outer approximation.
    pub(crate) directions: Directions,
    /// One answer of every solver of this build.
    pub(crate) answers: Vec<LpAnswer>,
}

/// Runs all solvers of this build. Their answers are binary64, the judgement is exact.
pub(crate) fn programs(problem: &Problem) -> Programs {
    let rows = ProgramRows::new(problem);
    let referee = Referee::new(rows.rows().to_vec(), Rational::ratio(1, 1_000_000));
    // A name from the list of this build is known to it.
    let answers = source_names().into_iter().filter_map(|name| {
        let answer = answer_of(&name, &rows, TIME_LIMIT).ok()?;
        Some(LpAnswer {
            source: answer.source.to_string(),
            is_exact: name == EXACT_SIMPLEX,
            judgements: [0, 1].map(|axis| referee.judge_interval(axis, &answer.claims[axis])),
            claims: answer.claims,
        })
    });
    Programs { answers: answers.collect(), directions: directions(problem, &rows, DIRECTIONS) }
}

#[derive(Debug, Serialize)]
pub(crate) struct LayersJson {
    directions: DirectionsJson,
    lp: Vec<LpJson>,
}

/// Corners and areas of the approximations; no outer one when the set is unbounded.
#[derive(Debug, Serialize)]
struct DirectionsJson {
    count: usize,
    inner: Option<Vec<usize>>,
    outer: Option<Vec<usize>>,
    inner_area: Option<Number>,
    outer_area: Option<Number>,
}

#[derive(Debug, Serialize)]
struct LpJson {
    source: String,
    reading: &'static str,
    claims: Vec<ClaimJson>,
}

#[derive(Debug, Serialize)]
struct ClaimJson {
    parameter: &'static str,
    end: &'static str,
    verdict: &'static str,
    claimed: Option<Number>,
    point: Option<[Number; 2]>,
    reason: Option<Message>,
}

/// The layers as JSON. `reading` is that of the data.
pub(crate) fn to_json(
    programs: &Programs,
    reading: Reading,
    styles: &[Style; 2],
    points: &mut Points,
) -> LayersJson {
    let lp = programs.answers.iter().map(|answer| LpJson {
        source: answer.source.clone(),
        reading: reading.name(),
        claims: PuiEnd::ALL.map(|end| claim(answer, end, styles)).into(),
    });
    LayersJson { lp: lp.collect(), directions: directions_json(&programs.directions, points) }
}

fn directions_json(found: &Directions, points: &mut Points) -> DirectionsJson {
    let inner = found.inner.as_ref().filter(|inner| !inner.vertices.is_empty());
    let outer = found.outer.as_ref().filter(|_| found.unbounded == 0);
    let mut corners = |approximation: Option<&Approximation>| -> Option<Vec<usize>> {
        Some(approximation?.vertices.iter().map(|theta| points.index_of(theta)).collect())
    };
    let area =
        |approximation: Option<&Approximation>| approximation?.area.as_ref().map(|area| STYLE.number(area));
    DirectionsJson {
        count: found.count,
        inner: corners(inner),
        outer: corners(outer),
        inner_area: area(inner),
        outer_area: area(outer),
    }
}

fn claim(answer: &LpAnswer, end: PuiEnd, styles: &[Style; 2]) -> ClaimJson {
    let judgement = end.of(&answer.judgements);
    let style = &styles[end.axis()];
    let claimed = |value: &Rational| match end.end() {
        End::Lower => style.lower_number(value),
        End::Upper => style.upper_number(value),
    };
    ClaimJson {
        parameter: PARAMETERS[end.axis()],
        end: end.end().name(),
        verdict: judgement.verdict.name(),
        claimed: judgement.claimed.as_ref().map(claimed),
        point: end
            .of(&answer.claims)
            .point
            .as_ref()
            .map(|theta| point(styles, &theta.each_ref().map(|coordinate| coordinate.value.clone()))),
        reason: reason(judgement),
    }
}

/// An error in proportion: `1.6e-16 of the width`. Rounded up.
pub(crate) fn proportion((size, unit): (Rational, Option<ToleranceUnit>)) -> Message {
    let size = Value::number(with_minus(&size.to_decimal(2, Rounding::Up)));
    let of = match unit {
        Some(ToleranceUnit::Width) => "proportion.width",
        Some(ToleranceUnit::Value) => "proportion.value",
        Some(ToleranceUnit::Epsilon) => "proportion.epsilon",
        None => "proportion.none",
    };
    text!(of, size: size)
}

/// The key of a verdict's name.
pub(crate) fn verdict_key(verdict: Verdict) -> String {
    format!("verdict.{}", verdict.name().replace(' ', "-"))
}

/// Returns the reason why a claim is not simply right, in a sentence, proportion first.
pub(crate) fn reason(judgement: &Judgement) -> Option<Message> {
    let sized = |key: &str| judgement.error().map(|error| text!(key, size: proportion(error)));
    let is_inside = judgement.excess.as_ref().is_some_and(Rational::is_negative);
    let by = |violated: &Rational| Value::number(with_minus(&violated.to_decimal(2, Rounding::Up)));
    match judgement.verdict {
        Verdict::Exact => None,
        Verdict::Rounded => sized("claim.rounded"),
        Verdict::WithinTolerance => {
            sized(if is_inside { "claim.little-inside" } else { "claim.little-outside" })
        }
        Verdict::Loose => sized(if is_inside { "claim.inside" } else { "claim.outside" }),
        Verdict::NoAnswer => {
            judgement.reason.as_ref().map(|reason| text!("claim.none", reason: reason.to_string()))
        }
        Verdict::InfeasiblePoint => Some(match &judgement.violation {
            Some(violation) => text!("claim.infeasible-by", size: by(&violation.by)),
            None => text!("claim.infeasible"),
        }),
        Verdict::Unsafe => sized("claim.unsafe"),
        Verdict::InvertedInterval => Some(text!("claim.inverted")),
        Verdict::WrongStatus => Some(wrong_status(judgement)),
    }
}

fn wrong_status(judgement: &Judgement) -> Message {
    text!(match &judgement.proof {
        Some(Refutation::Infeasible(_)) => "claim.in-truth-empty",
        Some(Refutation::FeasiblePoint(_)) => "claim.in-truth-not-empty",
        Some(Refutation::Bound(_)) => "claim.in-truth-bounded",
        Some(Refutation::Ray { .. }) => "claim.in-truth-unbounded",
        None => "claim.in-truth-not",
    })
}
