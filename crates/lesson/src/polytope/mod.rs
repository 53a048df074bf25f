//! Half-planes without readings: what the page shows of them, schema `boundfit/polytope/1`, whose types are in
//! `page/js/polytope/polytope.d.ts`.

mod lines;
mod objective;
mod path;
mod set;

use boundfit_exact::{Limits, Rational, Reading};
use boundfit_geometry::clipping::{Step, steps};
use boundfit_geometry::{Multiplier, Polyhedron, Redundancy, System};
use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::redundancy::RedundantJson;
use lines::{HalfPlaneLine, LineError, read};
use objective::ObjectiveJson;
use path::PathJson;
use set::{SetJson, theta};

/// The most half-planes that are taken; an equation has two.
pub const MOST_HALF_PLANES: usize = 60;

/// The longest text that is read, in bytes.
pub const LONGEST_TEXT: usize = 20_000;

/// Limits on one number: whoever draws half-planes reads them.
const NUMBERS: Limits = Limits { digits: 30, exponent: 30 };

/// The questions about half-planes besides their set.
#[derive(Debug, Clone, Default, PartialEq, Eq, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct PolytopeOptions {
    /// The coefficients of the form that is maximised, as numbers in text.
    pub objective: Option<[String; 2]>,
    /// The vertex from which the simplex method starts, from 0 in the order of the set; where the objective is least when `None`.
    pub start: Option<usize>,
}

/// The reason why there is no answer about half-planes. Faults in a line of half-planes are part of the answer.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum PolytopeError {
    /// More text than half-planes by hand.
    #[error("{0} bytes of half-planes are too many (the limit is {LONGEST_TEXT})")]
    TooLong(usize),
    /// More half-planes than a picture can show.
    #[error(
        "{0} half-planes are too many for a picture (the limit is {MOST_HALF_PLANES}; an equation has two)"
    )]
    TooMany(usize),
    /// A coefficient that is not a number.
    #[error("objective: {text:?}: {problem}")]
    Objective {
        /// The coefficient as it was given.
        text: String,
        /// The problem with it.
        problem: String,
    },
    /// A vertex that is not there.
    #[error("start: there is no vertex {start} (the set has {vertices}, counted from 0)")]
    Start {
        /// The request.
        start: usize,
        /// The number of vertices.
        vertices: usize,
    },
    /// An answer that cannot be written.
    #[error("cannot write an answer: {0}")]
    Json(String),
}

/// The answer, in the order of schema `boundfit/polytope/1`; every number is a fraction.
#[derive(Debug, Serialize)]
struct PolytopeJson {
    schema: &'static str,
    errors: Vec<LineError>,
    half_planes: Vec<HalfPlaneJson>,
    steps: Vec<StepJson>,
    set: Option<SetJson>,
    objective: Option<ObjectiveJson>,
    simplex: Option<PathJson>,
}

#[derive(Debug, Serialize)]
struct HalfPlaneJson {
    #[serde(flatten)]
    line: HalfPlaneLine,
    a: [String; 2],
    b: String,
    redundant: Option<RedundantJson<String>>,
}

/// One half-plane more, and the set after it.
#[derive(Debug, Serialize)]
struct StepJson {
    half_plane: usize,
    set: SetJson,
    born: Vec<[String; 2]>,
    lost: Vec<[String; 2]>,
    redundant: Option<RedundantJson<String>>,
}

/// Returns the facts about half-planes, one a line as [`boundfit_estimation::Condition::parse_in_plane`] reads them,
/// as JSON of schema `boundfit/polytope/1`.
/// - The effect of each on the set of those before it.
/// - The set of all with the half-planes and the normal cone of each vertex.
/// - The redundant half-planes, with reasons.
/// - The support of an objective with its face and multipliers.
/// - The path of the simplex method.
///
/// Empty lines and those that begin with `#` are left out. Where lines cannot be read, the answer says which and why,
/// and nothing else.
///
/// Exact. Cost: that of [`steps`], for at most [`MOST_HALF_PLANES`] with numbers of at most 30 digits.
///
/// ```
/// use boundfit_lesson::{PolytopeOptions, polytope};
///
/// let options = PolytopeOptions { objective: Some(["1".into(), "1".into()]), start: None };
/// let answer = polytope("x >= 0\ny >= 0\n2x + 3y <= 6", &options)?;
/// assert!(answer.contains(r#""value":"3","proof":[{"half_plane":1,"multiplier":"1/2"},{"half_plane":2,"multiplier":"1/2"}]"#));
/// # Ok::<(), boundfit_lesson::PolytopeError>(())
/// ```
///
/// # Errors
/// For more text or half-planes than a picture can show, an objective that is no number, and a start that is no vertex.
pub fn polytope(text: &str, options: &PolytopeOptions) -> Result<String, PolytopeError> {
    let answer = answer(text, options)?;
    serde_json::to_string(&answer).map_err(|error| PolytopeError::Json(error.to_string()))
}

fn answer(text: &str, options: &PolytopeOptions) -> Result<PolytopeJson, PolytopeError> {
    if text.len() > LONGEST_TEXT {
        return Err(PolytopeError::TooLong(text.len()));
    }
    let form =
        options.objective.as_ref().map(|[c1, c2]| Ok([coefficient(c1)?, coefficient(c2)?])).transpose()?;
    let read = read(text, &NUMBERS);
    if !read.errors.is_empty() {
        return Ok(PolytopeJson {
            schema: SCHEMA,
            errors: read.errors,
            half_planes: Vec::new(),
            steps: Vec::new(),
            set: None,
            objective: None,
            simplex: None,
        });
    }
    if read.system.len() > MOST_HALF_PLANES {
        return Err(PolytopeError::TooMany(read.system.len()));
    }
    let polyhedron = Polyhedron::intersect(read.system);
    let vertices = polyhedron.region().vertices().len();
    if let Some(start) = options.start.filter(|start| *start >= vertices) {
        return Err(PolytopeError::Start { start, vertices });
    }
    let system = polyhedron.system();
    let order: Vec<usize> = (0..system.len()).collect();
    Ok(PolytopeJson {
        schema: SCHEMA,
        errors: Vec::new(),
        half_planes: half_planes(read.lines, &polyhedron),
        steps: steps(system, &order).iter().map(|step| step_json(system, step)).collect(),
        set: Some(SetJson::new(system, polyhedron.region())),
        objective: form.as_ref().map(|form| ObjectiveJson::new(&polyhedron, form)),
        simplex: form.as_ref().and_then(|form| PathJson::new(&polyhedron, form, options.start)),
    })
}

const SCHEMA: &str = "boundfit/polytope/1";

fn coefficient(text: &str) -> Result<Rational, PolytopeError> {
    Reading::Decimal.read(text, &NUMBERS).map_err(|error| PolytopeError::Objective {
        // Long enough to be recognised.
        text: text.chars().take(40).collect(),
        problem: error.to_string(),
    })
}

fn half_planes(lines: Vec<HalfPlaneLine>, polyhedron: &Polyhedron) -> Vec<HalfPlaneJson> {
    let inequalities = polyhedron.system().inequalities();
    let given = lines.into_iter().zip(inequalities).zip(polyhedron.redundancies());
    given
        .map(|((line, inequality), redundancy)| HalfPlaneJson {
            line,
            a: inequality.a.each_ref().map(ToString::to_string),
            b: inequality.b.to_string(),
            redundant: redundancy.as_ref().map(redundant),
        })
        .collect()
}

fn redundant(redundancy: &Redundancy) -> RedundantJson<String> {
    let by = |why, terms: &[Multiplier], slack| RedundantJson::by(why, terms, slack, Rational::to_string);
    match redundancy {
        Redundancy::Always => RedundantJson::alone("always"),
        Redundancy::EmptyWithout => RedundantJson::alone("empty-without"),
        Redundancy::SameAs(index) => {
            let itself = Multiplier { index: *index, value: Rational::one() };
            by("same-as", &[itself], &Rational::zero())
        }
        Redundancy::Dominated { by: terms, slack } => by("dominated", terms, slack),
    }
}

fn step_json(system: &System, step: &Step) -> StepJson {
    StepJson {
        half_plane: step.index,
        set: SetJson::new(system, &step.after),
        born: step.born.iter().map(theta).collect(),
        lost: step.lost.iter().map(theta).collect(),
        redundant: step.redundant.as_ref().map(|own| RedundantJson::of_step(own, Rational::to_string)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refused(text: &str, options: &PolytopeOptions) -> String {
        polytope(text, options).unwrap_err().to_string()
    }

    #[test]
    fn what_is_too_much_is_refused() {
        let options = PolytopeOptions::default();
        assert_eq!(
            refused(&"x<=1\n".repeat(61), &options),
            "61 half-planes are too many for a picture (the limit is 60; an equation has two)"
        );
        assert_eq!(
            refused(&"x=1\n".repeat(31), &options),
            "62 half-planes are too many for a picture (the limit is 60; an equation has two)"
        );
        assert!(polytope(&"x=1\n".repeat(30), &options).is_ok());
        assert_eq!(
            refused(&" ".repeat(20_001), &options),
            "20001 bytes of half-planes are too many (the limit is 20000)"
        );
    }

    #[test]
    fn what_is_no_objective_and_no_start_is_refused() {
        let asked = |c1: &str, start| PolytopeOptions { objective: Some([c1.into(), "0".into()]), start };
        assert_eq!(
            refused("x<=1", &asked("one", None)),
            "objective: \"one\": unexpected character 'o' at character 1"
        );
        assert!(refused("x<=1", &asked(&"1".repeat(31), None)).contains("30 digits"));
        assert_eq!(
            refused("x<=1", &asked("1", Some(0))),
            "start: there is no vertex 0 (the set has 0, counted from 0)"
        );
    }
}
