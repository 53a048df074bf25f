//! Linear programs of two variables, and what solvers answer about them.

use boundfit::ask::{Readings, Request};
use boundfit::engine::exact::Foreign;
use boundfit::engine::lp::Printed;
use boundfit::files::Source;
use boundfit::judge::{
    Answer, Bounds, Given, Ground, Model, ModelColumn, ModelRow, ObjectiveSense, Solution, SolverStatus,
    Tolerances,
};
use boundfit::report::{Origin, Style};
use boundfit::{Rational, Reading};
use pyo3::prelude::*;

use crate::forms::named;
use crate::numbers::{Number, exact, refuse};
use crate::questions::refused;
use crate::waiting::waiting;

/// A row of a program: its coefficients and both bounds.
type Row<'py> = (Vec<Bound<'py, PyAny>>, Option<Bound<'py, PyAny>>, Option<Bound<'py, PyAny>>);
/// Both bounds of a column.
type Ends<'py> = (Option<Bound<'py, PyAny>>, Option<Bound<'py, PyAny>>);

/// An aspect, its worth, and its error.
type Found<'py> = (&'static str, &'static str, Option<Bound<'py, PyAny>>);
/// The status of a program, its optimum, the vertices where it is attained, and what was found about a claim.
type Judged<'py> = (&'static str, Option<Bound<'py, PyAny>>, Vec<Bound<'py, PyAny>>, Vec<Found<'py>>);

/// The answer of a solver, in the words of this package.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Claimed<'py> {
    solver: String,
    status: String,
    objective: Option<Bound<'py, PyAny>>,
    point: Option<Vec<Bound<'py, PyAny>>>,
    duals: Option<Vec<Bound<'py, PyAny>>>,
    reduced_costs: Option<Vec<Bound<'py, PyAny>>>,
}

/// The answer about the linear program in a file: `request` is what JSON says, such as `{"ask": "judge"}`.
#[pyfunction]
pub(crate) fn judge_file(py: Python<'_>, path: String, request: String, form: &str) -> PyResult<String> {
    let form = named(form)?;
    let answer = waiting(py, move |_| {
        let request = Request::parse(&request)?;
        request.refuse_vain(form, &Style::default())?;
        let asked = request.resolve(&Readings::default(), Reading::Decimal)?;
        let origin = Origin { file: Some(Foreign::of(&path)), reading: Reading::Decimal, is_stored: false };
        request.answer(&asked, Source::open(&path)?, form, Some(origin), &Style::default())
    })?;
    Ok(answer.map_err(|refusal| refused(py, &refusal, false))?.text)
}

/// The exact answer, and what was found about each aspect of a claimed one. This is no request: the program and the claim are numbers of
/// arrays, which were never a text.
#[pyfunction]
#[pyo3(signature = (costs, rows, bounds, claimed, tolerance))]
pub(crate) fn judge<'py>(
    py: Python<'py>,
    costs: Vec<Bound<'py, PyAny>>,
    rows: Vec<Row<'py>>,
    bounds: Vec<Ends<'py>>,
    claimed: Option<Claimed<'py>>,
    tolerance: &Bound<'py, PyAny>,
) -> PyResult<Judged<'py>> {
    let model = model(&costs, &rows, &bounds)?;
    let tolerances = Tolerances { relative: exact(tolerance, "tolerance")?, digits_as_printed: false };
    let solution = claimed.map(|claimed| claimed.solution(&model)).transpose()?;
    let judged = waiting(py, move |_| {
        let answer = Answer::of(&model)?;
        let findings = solution.map(|solution| Ground::new(&model, &answer).judge(&solution, &tolerances));
        Ok::<_, boundfit::judge::SolveError>((answer, findings))
    })?;
    let (answer, findings) = judged.map_err(refuse)?;
    let number = |value: &Rational| Number(value).into_pyobject(py);
    let (status, value, points) = match &answer {
        Answer::Optimal { value, face, .. } => {
            let vertices = face.vertices.iter();
            let points = vertices.map(|point| Ok(numbers(point).into_pyobject(py)?.into_any()));
            ("optimal", Some(number(value)?), points.collect::<PyResult<_>>()?)
        }
        Answer::Infeasible { .. } => ("infeasible", None, Vec::new()),
        Answer::Unbounded { .. } => ("unbounded", None, Vec::new()),
    };
    let findings = findings.iter().flat_map(|own| &own.findings).map(|finding| {
        let error = finding.error.as_ref().map(number).transpose()?;
        Ok((finding.aspect.name(), finding.worth.name(), error))
    });
    Ok((status, value, points, findings.collect::<PyResult<_>>()?))
}

fn numbers(values: &[Rational]) -> Vec<Number<'_>> {
    values.iter().map(Number).collect()
}

fn model(costs: &[Bound<'_, PyAny>], rows: &[Row<'_>], bounds: &[Ends<'_>]) -> PyResult<Model> {
    let side = |value: &Option<Bound<'_, PyAny>>, name: String| {
        value.as_ref().map(|value| exact(value, &name)).transpose()
    };
    let columns = costs.iter().zip(bounds).enumerate().map(|(index, (cost, (lower, upper)))| {
        Ok(ModelColumn {
            name: format!("x[{index}]").into(),
            cost: exact(cost, &format!("c[{index}]"))?,
            bounds: Bounds {
                lower: side(lower, format!("bounds[{index}]"))?,
                upper: side(upper, format!("bounds[{index}]"))?,
            },
        })
    });
    let row = |(index, (coefficients, lower, upper)): (usize, &Row<'_>)| {
        let mut own = Vec::new();
        for (column, value) in coefficients.iter().enumerate() {
            let value = exact(value, &format!("row {} of A", index + 1))?;
            if !value.is_zero() {
                own.push((column, value));
            }
        }
        Ok(ModelRow {
            name: format!("row[{index}]").into(),
            coefficients: own,
            bounds: Bounds {
                lower: side(lower, format!("row {} of b", index + 1))?,
                upper: side(upper, format!("row {} of b", index + 1))?,
            },
        })
    };
    Ok(Model {
        sense: ObjectiveSense::Minimize,
        columns: columns.collect::<PyResult<_>>()?,
        rows: rows.iter().enumerate().map(row).collect::<PyResult<_>>()?,
        ..Model::default()
    })
}

impl Claimed<'_> {
    fn solution(&self, model: &Model) -> PyResult<Solution> {
        let given = |value: &Bound<'_, PyAny>| {
            Ok::<_, PyErr>(Given { number: Printed::exact(exact(value, "result")?), line: 1 })
        };
        let all = |values: &Option<Vec<Bound<'_, PyAny>>>| -> PyResult<Option<Vec<Given>>> {
            values.as_ref().map(|values| values.iter().map(given).collect()).transpose()
        };
        let status = SolverStatus::of_words(&self.status);
        // Numbers of a status other than optimal mean nothing.
        let is_optimal = status == SolverStatus::Optimal;
        let objective = self.objective.as_ref().filter(|_| is_optimal).map(given).transpose()?;
        let reduced_costs = all(&self.reduced_costs)?.filter(|_| is_optimal);
        let solution = Solution {
            writer: if self.solver == "HiGHS" { "HiGHS" } else { "SciPy" },
            status,
            status_line: 1,
            objective,
            point: all(&self.point)?.filter(|_| is_optimal),
            duals: all(&self.duals)?.filter(|_| is_optimal),
            reduced_costs: reduced_costs.map(|all| all.into_iter().map(Some).collect()),
            ray: None,
            farkas: None,
            not_finite: Vec::new(),
            has_activities: false,
            other_rows: None,
        };
        solution.of_size(model).map_err(|error| refuse(format_args!("result: {error}")))
    }
}
