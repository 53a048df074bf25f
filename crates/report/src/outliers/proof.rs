//! The proof of outliers.

use std::collections::{BTreeMap, BTreeSet};

use boundfit_estimation::{BoundName, Fps, Measurements, Problem};
use boundfit_exact::{Rational, Reading};

use super::OutliersReport;
use crate::answer::proof::StatedJson;
use crate::proof_question::ProofQuestion;
use crate::statements::{Scope, Statement, of_bounds, sorted, statements_json};

/// Sets of readings left out of which a proof has a contradiction each.
const MOST_CONTRADICTIONS: usize = 1_000;

/// The reason why outliers have no proof.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NoOutliersProof {
    /// The readings are not those of plain delimited text.
    NoText,
    /// Memory does not hold every reading.
    NotInMemory,
    /// The proof needs more contradictions than this.
    TooMany(usize),
}

/// Returns the proof of outliers, schema `boundfit/proof/2`. It proves that fewer readings are not enough, that a
/// complete list of sets is complete, and what remains without each set. If conditions contradict each other, it
/// proves that no parameters remain. Cost: a fit for each of at most a thousand sets of readings left out.
///
/// # Errors
/// When there is none.
pub fn outliers_proof(report: &OutliersReport, reading: Reading) -> Result<String, NoOutliersProof> {
    let question = ProofQuestion::new(report.problem, reading).ok_or(NoOutliersProof::NoText)?;
    let of = |fps: &Fps, scope: Scope| {
        Statement::set(scope, fps.polyhedron(), &|index: usize| fps.name(index).into())
    };
    let Ok(outliers) = report.outliers else {
        return Ok(statements_json(&question, &[of(&report.fit.fps, Scope::default())]));
    };
    let sets: Vec<Vec<usize>> = outliers.pieces.iter().map(|piece| sorted(&piece.rows)).collect();
    let sets = outliers.is_complete.then_some(sets);
    let contradictions = contradictions(report.problem, outliers.least, sets.as_deref())?;
    let contradictions = contradictions.into_iter().map(|(rows, own)| (rows, of_bounds(&own))).collect();
    let claim = StatedJson::LeftOut { least: outliers.least, sets, contradictions };
    let least = Statement { scope: Scope::default(), claim };
    let pieces = outliers.pieces.iter().map(|piece| of(&piece.left, Scope::without(&piece.rows)));
    let statements: Vec<Statement> = [least].into_iter().chain(pieces).collect();
    Ok(statements_json(&question, &statements))
}

/// Half-planes with their multiples.
type NamedMultiples = Vec<(BoundName, Rational)>;

/// Rows left out, and half-planes of others that contradict each other.
type Contradictions = Vec<(Vec<usize>, NamedMultiples)>;

/// Returns, starting with no row left out, a contradiction of the other rows, of which one has to be left out as
/// well.
pub(crate) fn contradictions(
    problem: &Problem,
    least: usize,
    sets: Option<&[Vec<usize>]>,
) -> Result<Contradictions, NoOutliersProof> {
    let is_listed =
        |rows: &BTreeSet<usize>| sets.is_none_or(|sets| sets.iter().any(|set| set.iter().eq(rows.iter())));
    let mut found: BTreeMap<BTreeSet<usize>, NamedMultiples> = BTreeMap::new();
    let mut next = vec![BTreeSet::new()];
    while let Some(rows) = next.pop() {
        let is_enough = rows.len() >= least;
        if found.contains_key(&rows) || is_enough && is_listed(&rows) {
            continue;
        }
        let contradiction = contradiction(problem, &rows);
        if !is_enough {
            let own = contradiction.iter().filter_map(|(name, _)| name.row());
            next.extend(own.map(|row| rows.iter().copied().chain([row]).collect()));
        }
        found.insert(rows, contradiction);
        if found.len() > MOST_CONTRADICTIONS {
            return Err(NoOutliersProof::TooMany(MOST_CONTRADICTIONS));
        }
    }
    Ok(found.into_iter().map(|(rows, own)| (rows.into_iter().collect(), own)).collect())
}

/// Half-planes of the other rows and the conditions that contradict each other; none where they do not.
fn contradiction(problem: &Problem, without: &BTreeSet<usize>) -> NamedMultiples {
    let measurements = &problem.measurements;
    let rows = measurements.without(without);
    let (model, response) = (measurements.model().clone(), measurements.response().to_owned());
    let others = Measurements::new(model, response, measurements.error_bound().clone(), rows);
    let fps = Fps::new(&others, &problem.conditions);
    let multipliers = fps.polyhedron().region().certificate().map(|own| own.multipliers().to_vec());
    multipliers.unwrap_or_default().into_iter().map(|own| (fps.name(own.index), own.value)).collect()
}
