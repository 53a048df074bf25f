//! What linear programs make of the same data: the set seen from several directions, and the ends of the intervals as
//! solvers report them, judged exactly.

use std::time::Duration;

use boundfit_check::{
    Approximation, Directions, EXACT_SIMPLEX, ProgramRows, answer_of, directions, source_names,
};
use boundfit_estimation::Problem;
use boundfit_exact::{Rational, Reading, Rounding};
use boundfit_lp::{BoundClaim, End, Judgement, PuiEnd, Referee, Refutation, ToleranceUnit, Verdict};
use boundfit_report::{Number, Style};
use serde::Serialize;

use crate::leave_one_out::PARAMETERS;
use crate::number::{STYLE, point, with_minus};
use crate::points::Points;

/// How many directions the set is looked at from.
const DIRECTIONS: usize = 16;

/// The longest that a solver may work on one program.
const TIME_LIMIT: Duration = Duration::from_secs(10);

/// What a solver claims about the four ends, and what the claims are worth against the data as read.
#[derive(Debug)]
pub(crate) struct LpAnswer {
    /// The solver with its version.
    pub(crate) source: String,
    /// Whether it is the exact simplex.
    pub(crate) is_exact: bool,
    /// By parameter, then lower and upper end.
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
    reason: Option<String>,
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
pub(crate) fn proportion((size, unit): (Rational, Option<ToleranceUnit>)) -> String {
    let size = with_minus(&size.to_decimal(2, Rounding::Up));
    match unit {
        Some(ToleranceUnit::Width) => format!("{size} of the width"),
        Some(ToleranceUnit::Value) => format!("{size} of its value"),
        Some(ToleranceUnit::Epsilon) => format!("{size} of ε"),
        None => size,
    }
}

/// Why a claim is not simply right, in a sentence, proportion first.
pub(crate) fn reason(judgement: &Judgement) -> Option<String> {
    let size = || judgement.error().map(proportion).unwrap_or_default();
    let is_inside = judgement.excess.as_ref().is_some_and(Rational::is_negative);
    let direction = if is_inside { "cuts off" } else { "is too wide by" };
    let outside = || match &judgement.violation {
        Some(violation) => {
            format!(
                "Its point violates a bound by {}.",
                with_minus(&violation.by.to_decimal(2, Rounding::Up))
            )
        }
        None => String::new(),
    };
    match judgement.verdict {
        Verdict::Exact => None,
        Verdict::Rounded => Some(format!("It is right to {}, which is rounding.", size())),
        Verdict::WithinTolerance => Some(format!("It {direction} {}, which is little.", size())),
        Verdict::Loose => Some(format!("It {direction} {}.", size())),
        Verdict::NoAnswer => judgement.reason.as_ref().map(|reason| format!("It gave none: {reason}.")),
        Verdict::InfeasiblePoint => Some(outside()),
        Verdict::Unsafe => Some(format!("It cuts off feasible parameters, by {}.", size())),
        Verdict::InvertedInterval => Some("The lower end is above the upper end.".to_owned()),
        Verdict::WrongStatus => Some(wrong_status(judgement)),
    }
}

fn wrong_status(judgement: &Judgement) -> String {
    let truth = match &judgement.proof {
        Some(Refutation::Infeasible(_)) => "the set is empty",
        Some(Refutation::FeasiblePoint(_)) => "the set is not empty",
        Some(Refutation::Bound(_)) => "the parameter is bounded on this side",
        Some(Refutation::Ray { .. }) => "the parameter is not bounded on this side",
        None => "that is not so",
    };
    format!("In truth {truth}.")
}
