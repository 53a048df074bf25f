//! A set as a theorem for Coq's kernel: the rows, what they say, the vertices, and why the set is their convex hull.

mod bytes;
mod evidence;
mod left_out;
mod numbers;
mod parts;
mod prediction;
mod program;
mod rows;
mod runs;
mod statuses;
mod theorem;

use std::collections::HashMap;

use boundfit_estimation::{BoundName, Fit, Problem};
use boundfit_exact::Reading;
use boundfit_geometry::{Polyhedron, System};

use crate::proof_question::ProofQuestion;
pub use bytes::MOST_THEOREM_BYTES;
use bytes::the_bytes;
pub use left_out::kernel_outliers;
pub use prediction::kernel_prediction;
pub use program::kernel_program;
use rows::Statement;
pub use runs::kernel_range;
pub use statuses::kernel_status;
use theorem::{Head, Set, theorem};
pub use theorem::{THEORY, Theory};

/// The theorem about a fit. `None` when some of its readings are not in memory. Exact; its size is linear in the readings and
/// vertices. With the bytes of the data, of which at most [`MOST_THEOREM_BYTES`] are taken, it also says that the rows are read
/// from them where they are plain delimited text.
pub fn kernel_fit(
    problem: &Problem,
    fit: &Fit,
    reading: Reading,
    data: Option<&[u8]>,
    theory: Theory,
) -> Option<String> {
    let (statement, numbers) = Statement::of_problem(problem)?;
    let question = ProofQuestion::new(problem, reading);
    let bytes = question.zip(data).and_then(|(own, data)| the_bytes(&own, &statement.rows, data));
    let head = Head { bytes, ..Head::default() };
    theorem_of_fit((problem, fit), (&statement, &numbers), (reading, theory), head)
}

/// The theorem about a fit under a head that may say what follows.
fn theorem_of_fit(
    (problem, fit): (&Problem, &Fit),
    (statement, numbers): (&Statement, &HashMap<BoundName, usize>),
    (reading, theory): (Reading, Theory),
    head: Head<'static>,
) -> Option<String> {
    let polyhedron = fit.fps.polyhedron();
    let ranges = fit.pui_intervals();
    let number = |index: usize| numbers.get(&fit.fps.name(index)).copied();
    let set = Set { polyhedron, ranges, number: &number };
    let head = Head {
        sha256: problem.measurements.sha256(),
        rows: problem.measurements.fitted_rows(),
        question: ProofQuestion::new(problem, reading),
        ..head
    };
    theorem(statement, &set, head, theory)
}

/// The theorem about a set of half-planes, with the question by which their file is read, if it is delimited text. `None` never happens for the set of these half-planes.
pub fn kernel_half_planes(
    system: &System,
    polyhedron: &Polyhedron,
    sha256: Option<&str>,
    question: Option<ProofQuestion>,
    theory: Theory,
) -> Option<String> {
    let statement = Statement::of_half_planes(system);
    let set = Set { polyhedron, ranges: polyhedron.bounding_box(), number: &evidence::by_place };
    theorem(&statement, &set, Head { sha256, question, ..Head::default() }, theory)
}
