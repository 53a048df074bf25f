//! The solvers of this build, asked about a model in its plane.

use std::time::Duration;

use boundfit_exact::{Foreign, Rational};
use boundfit_judge::{
    Answer, Findings, Given, Ground, Plane, Solution, SolveError, SolverStatus, Tolerances,
};
use boundfit_lp::{
    Bounds, ExactOutcome, FloatProgram, Model, ModelColumn, ModelRow, Multiplier, Outcome, Printed, Program,
    Row, exact_simplex, solve_guarded, solvers,
};

/// The worth of a solver of this build on a model.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct JudgedSolver {
    /// The solver with its version; `exact-simplex` for the exact one.
    pub source: Foreign,
    /// Judged by the program as it is.
    pub as_read: Findings,
    /// Judged by the program whose rows and costs are rounded to binary64, which is what the solver received.
    pub received: Findings,
}

/// Asks every float solver of this build, each for at most `limit`, and the exact simplex. All receive the half-planes of the
/// plane as rows, columns without bounds, and a minimum. Judging is exact; cost: that of the solvers, and of solving the
/// program and the rounded one exactly.
///
/// # Errors
/// As [`Answer::of`] says.
pub fn judge_solvers(
    plane: &Plane,
    limit: Duration,
    tolerances: &Tolerances,
) -> Result<Vec<JudgedSolver>, SolveError> {
    let rows = plane.polyhedron().system().inequalities().iter();
    let rows: Vec<Row> = rows.map(|row| Row { a: row.a.clone(), b: row.b.clone() }).collect();
    let objective = plane.gain().each_ref().map(|gain| -gain);
    let program = Program { rows: &rows, objective };
    let float = FloatProgram::new(&program);
    let [model, rounded] = [Some(model_of(&rows, &program.objective)), rounded(&float)];
    let answered = |model: Option<&Model>| model.map(Answer::of).transpose();
    let (answer, rounded_answer) = (answered(model.as_ref())?, answered(rounded.as_ref())?);
    let ground = |model, answer| Some(Ground::new(Option::as_ref(model)?, Option::as_ref(answer)?));
    let as_read = ground(&model, &answer);
    let received = ground(&rounded, &rounded_answer);
    let judge = |ground: &Option<Ground<'_>>, solution: &Solution| {
        ground.as_ref().map(|ground| ground.judge(solution, tolerances))
    };
    let mut judged = Vec::new();
    for solver in solvers() {
        let solution = solution_of(&solve_guarded(solver.name(), &float, limit));
        let Some(as_read) = judge(&as_read, &solution) else { continue };
        let received = judge(&received, &solution).unwrap_or_else(|| as_read.clone());
        let source = format!("{} {}", solver.name(), solver.version());
        judged.push(JudgedSolver { source: source.into(), as_read, received });
    }
    let solution = exact_solution(&exact_simplex(&program), rows.len());
    if let Some(as_read) = judge(&as_read, &solution) {
        let source = "exact-simplex";
        judged.push(JudgedSolver { source: source.into(), received: as_read.clone(), as_read });
    }
    Ok(judged)
}

/// A program in two free variables as a model.
fn model_of(rows: &[Row], objective: &[Rational; 2]) -> Model {
    let column = |(place, cost): (usize, &Rational)| ModelColumn {
        name: format!("theta{}", place + 1).into(),
        cost: cost.clone(),
        bounds: Bounds::default(),
    };
    let row = |(place, row): (usize, &Row)| ModelRow {
        name: format!("row{}", place + 1).into(),
        coefficients: row.a.iter().cloned().enumerate().filter(|(_, value)| !value.is_zero()).collect(),
        bounds: Bounds { lower: None, upper: Some(row.b.clone()) },
    };
    Model {
        columns: objective.iter().enumerate().map(column).collect(),
        rows: rows.iter().enumerate().map(row).collect(),
        ..Model::default()
    }
}

/// The program that a solver receives, taken exactly; `None` where a number is beyond the range of doubles.
fn rounded(float: &FloatProgram) -> Option<Model> {
    let [first, second] = float.objective.map(Rational::from_f64);
    Some(model_of(&float.exact_rows()?, &[first?, second?]))
}

fn given(value: Rational) -> Given {
    Given { number: Printed::exact(value), line: 1 }
}

fn status_alone(status: SolverStatus) -> Solution {
    Solution {
        writer: "boundfit",
        status,
        status_line: 1,
        objective: None,
        point: None,
        duals: None,
        reduced_costs: None,
        ray: None,
        farkas: None,
        not_finite: Vec::new(),
        has_activities: false,
        other_rows: None,
    }
}

/// Returns what a float solver answers. Numbers that are not finite are none.
fn solution_of(outcome: &Outcome) -> Solution {
    let numbers = |values: &[f64]| -> Option<Vec<Given>> {
        values.iter().map(|value| Rational::from_f64(*value).map(given)).collect()
    };
    match outcome {
        Outcome::Optimal(optimum) => {
            let negated = |duals: &Vec<f64>| numbers(&duals.iter().map(|dual| -dual).collect::<Vec<f64>>());
            Solution {
                objective: Rational::from_f64(optimum.objective).map(given),
                point: numbers(&optimum.theta),
                // A row is at most its bound: a unit more of it makes the least value smaller.
                duals: optimum.duals.as_ref().and_then(negated),
                ..status_alone(SolverStatus::Optimal)
            }
        }
        Outcome::Infeasible => status_alone(SolverStatus::Infeasible),
        Outcome::Unbounded => status_alone(SolverStatus::Unbounded),
        Outcome::InfeasibleOrUnbounded => status_alone(SolverStatus::InfeasibleOrUnbounded),
        Outcome::Failed(reason) => status_alone(SolverStatus::Other(reason.clone())),
    }
}

/// Returns what the exact simplex answers about a program of so many rows.
fn exact_solution(outcome: &ExactOutcome, rows: usize) -> Solution {
    let prices = |multipliers: &[Multiplier]| {
        let mut prices = vec![Rational::zero(); rows];
        for Multiplier { row, value } in multipliers {
            prices.iter_mut().skip(*row).take(1).for_each(|price| *price = -value);
        }
        Some(prices.into_iter().map(given).collect())
    };
    let vector = |entries: &[Rational; 2]| Some(entries.iter().cloned().map(given).collect());
    match outcome {
        ExactOutcome::Optimal { theta, value, multipliers, .. } => Solution {
            objective: Some(given(value.clone())),
            point: vector(theta),
            duals: prices(multipliers),
            ..status_alone(SolverStatus::Optimal)
        },
        ExactOutcome::Infeasible { multipliers } => {
            Solution { farkas: prices(multipliers), ..status_alone(SolverStatus::Infeasible) }
        }
        ExactOutcome::Unbounded { ray, .. } => {
            Solution { ray: vector(ray), ..status_alone(SolverStatus::Unbounded) }
        }
    }
}
