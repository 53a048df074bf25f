//! The claim of a solver's file about one of the four programs.

use boundfit_exact::Limits;
use boundfit_judge::{
    Entry, Figure, Reference, SolutionError, SolutionFile, SolverStatus, quoted, read_solution,
};
use boundfit_lp::{BoundClaim, Claimed, Printed, PuiEnd};

use super::programs::Programs;

/// Reads a solver's own file about θ1 and θ2.
///
/// # Errors
/// An error for a faulty text, or for a file about other columns.
pub(super) fn parse_solution(text: &str, limits: &Limits) -> Result<SolutionFile, SolutionError> {
    let file = read_solution(text, limits)?;
    match &file.announced {
        Some(announced) if announced.columns != 2 => Err(SolutionError::Line {
            format: file.writer,
            line: announced.line,
            text: quoted(&announced.text),
            expected: "2 variables, theta1 and theta2".into(),
        }),
        _ if file.status == SolverStatus::Optimal => point(&file).map(|_| file),
        _ => Ok(file),
    }
}

/// The program that the content names.
pub(super) fn target(file: &SolutionFile) -> Option<PuiEnd> {
    file.about.iter().find_map(|name| PuiEnd::find(name)).map(|(_, target, _)| target)
}

/// Returns what the file claims about the end that its program is about.
pub(super) fn claim(file: &SolutionFile, target: PuiEnd, programs: Option<&Programs>) -> BoundClaim {
    match (&file.status, point(file)) {
        (SolverStatus::Infeasible, _) => BoundClaim::bare(Claimed::Infeasible),
        (SolverStatus::Unbounded, _) => BoundClaim::bare(Claimed::Unbounded),
        (SolverStatus::InfeasibleOrUnbounded, _) => BoundClaim::bare(Claimed::InfeasibleOrUnbounded),
        (SolverStatus::Other(words), _) => {
            BoundClaim::nothing(&format!("the solver's status is {}", quoted(words)))
        }
        (SolverStatus::Optimal, Ok(Some(point))) => {
            BoundClaim::attained(target, point, duals(file, programs))
        }
        (SolverStatus::Optimal, _) => BoundClaim::nothing("an optimum that is not finite"),
    }
}

/// θ1 and θ2; `None` where one is infinite or not a number. Others are passed over.
///
/// # Errors
/// When one is missing, and the writer does not leave zeros out.
fn point(file: &SolutionFile) -> Result<Option<[Printed; 2]>, SolutionError> {
    let value = |place, name, missing| {
        let is_own = |entry: &&Entry| match &entry.of {
            Reference::Name(own) => own == name,
            Reference::Place(own) => *own == place,
        };
        match file.columns.iter().rev().find(is_own).and_then(|entry| entry.value.as_ref()) {
            Some(Figure::Finite(printed)) => Ok(Some(printed.clone())),
            Some(Figure::NotFinite) => Ok(None),
            None => match &file.left_out {
                Some(largest) => Ok(Some(Printed::left_out(largest.clone()))),
                None => Err(SolutionError::End { format: file.writer, missing }),
            },
        }
    };
    let theta1 = value(0, "theta1", "a value of theta1")?;
    let theta2 = value(1, "theta2", "a value of theta2")?;
    Ok(theta1.zip(theta2).map(|(theta1, theta2)| [theta1, theta2]))
}

/// The size of each row's dual, in the order of the file, an equation with its two sides. Signs differ between solvers and are left
/// out elsewhere: each row is a bound on one side only. Only which is larger matters.
fn duals(file: &SolutionFile, programs: Option<&Programs>) -> Option<Vec<f64>> {
    let dual =
        |row: &Entry| row.price.as_ref().and_then(Figure::finite).map_or(0.0, |dual| dual.value.to_f64());
    let duals: Vec<f64> = file.has_duals.then(|| file.rows.iter().map(dual).collect())?;
    let by_side = programs.and_then(|programs| programs.by_side(&duals));
    Some(by_side.unwrap_or_else(|| duals.into_iter().map(f64::abs).collect()))
}
