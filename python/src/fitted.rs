//! A fit, and what Python asks of it.

use std::sync::OnceLock;

use boundfit::ask::{self, Ask, Fittable, Form, NoProof, Refusal};
use boundfit::engine::estimation::{Measurements, least_squares_is_feasible};
use boundfit::engine::exact::Foreign;
use boundfit::report::{NextStep, Origin, Style};
use boundfit::{BoundName, Endpoint, Fit, Interval, Number as _, ParameterBound, Problem, Rational, Reading};
use pyo3::prelude::*;

use crate::data::IN_MEMORY;
use crate::forms::named;
use crate::numbers::{Given, Number, pair, refuse};
use crate::questions::in_words;
use crate::waiting::waiting;

/// A problem with its answer.
#[pyclass(frozen, module = "boundfit._boundfit")]
pub(crate) struct Fitted {
    /// The problem with the readings that decide, and its answer.
    pub(crate) deciding: Box<Answered>,
    /// The same of every reading, for what names each; made where it is asked for.
    pub(crate) whole: OnceLock<Option<Box<Answered>>>,
    pub(crate) reading: Reading,
    /// The meaning of a float.
    pub(crate) floats: Reading,
    pub(crate) file: Option<String>,
    pub(crate) is_stored: bool,
}

/// The row of a half-plane, if it is one of a reading, and which bound it is.
type Name = (Option<usize>, String);

fn name_of(name: BoundName) -> Name {
    let bound = match name {
        BoundName::Upper(_) => "upper".to_owned(),
        BoundName::Lower(_) => "lower".to_owned(),
        of_condition => of_condition.to_string(),
    };
    (name.row(), bound)
}

/// Both ends; `None` where there is none.
fn ends(interval: &Interval) -> (Option<Number<'_>>, Option<Number<'_>>) {
    (interval.lower().value().map(Number), interval.upper().value().map(Number))
}

type Ends<'a> = (Option<Number<'a>>, Option<Number<'a>>);
/// Both ends as Python has them.
type GivenEnds<'py> = (Option<Bound<'py, PyAny>>, Option<Bound<'py, PyAny>>);
/// The value of an end, and the half-planes with multipliers that prove it.
type ProvedEnd<'a> = (Option<Number<'a>>, Vec<(Name, Number<'a>)>);

/// A problem that is asked about, and the answer.
pub(crate) struct Answered {
    asked: Fittable,
    answer: ask::Fitted,
}

impl Answered {
    /// Answers what is asked of a problem.
    pub(crate) fn new(question: &ask::Fit, asked: Fittable) -> Result<Box<Self>, Refusal> {
        let mut answer = question.answer(&asked)?;
        answer.next_words = Some(next_words);
        // Python's objects move: both are some thousand bytes.
        Ok(Box::new(Answered { asked, answer }))
    }
}

impl Fitted {
    /// The problem and the answer with every reading.
    fn whole(&self) -> &Answered {
        let made = || Answered::new(&ask::Fit::default(), self.deciding.asked.whole()?).ok();
        self.whole.get_or_init(made).as_deref().unwrap_or(&self.deciding)
    }

    pub(crate) fn problem(&self) -> &Problem {
        &self.whole().asked.problem
    }

    pub(crate) fn fit(&self) -> &Fit {
        &self.whole().answer.fit
    }

    /// The answer, whose half-planes are those of the readings that decide.
    fn deciding(&self) -> &Fit {
        &self.deciding.answer.fit
    }

    fn measurements(&self) -> &Measurements {
        &self.deciding.asked.problem.measurements
    }

    /// The answer in a form.
    fn written(
        &self,
        question: &ask::Fit,
        form: Form,
        origin: Origin<'_>,
        style: Style,
    ) -> Result<String, Refusal> {
        let Answered { asked, answer } = self.whole();
        Ok(question.text(asked, answer, form, origin, style)?.text)
    }

    /// Returns the source as [`Fitted::origin`] does, for people: readings without a file do not come from standard
    /// input either.
    fn shown_origin(&self) -> Origin<'_> {
        Origin { file: Some(Foreign::of(self.file.as_deref().unwrap_or(IN_MEMORY))), ..self.origin() }
    }

    fn origin(&self) -> Origin<'_> {
        Origin {
            file: self.file.as_deref().map(Foreign::of),
            reading: self.reading,
            is_stored: self.is_stored,
        }
    }

    fn proved(&self, end: &ParameterBound) -> ProvedEndOwned {
        match end {
            ParameterBound::Unbounded(_) => (None, Vec::new()),
            ParameterBound::Bounded { value, proof } => {
                let term = |m: &boundfit::engine::geometry::Multiplier| {
                    (name_of(self.deciding().fps.name(m.index)), m.value.clone())
                };
                (Some(value.clone()), proof.multipliers.iter().map(term).collect())
            }
        }
    }
}

type ProvedEndOwned = (Option<Rational>, Vec<(Name, Rational)>);

#[pymethods]
impl Fitted {
    /// The number of readings that are fitted.
    #[getter]
    fn rows(&self) -> usize {
        self.measurements().fitted()
    }

    /// The number of rows, fitted or not.
    #[getter]
    fn rows_total(&self) -> usize {
        self.measurements().rows_total()
    }

    #[getter]
    fn kind(&self) -> &'static str {
        self.deciding().fps.polyhedron().region().kind().name()
    }

    #[getter]
    fn reading(&self) -> &'static str {
        self.floats.name()
    }

    /// The names of the regressors, and of y.
    #[getter]
    fn names(&self) -> (Vec<String>, String) {
        let model = self.measurements().model();
        let regressors = match model {
            boundfit::engine::estimation::Model::Line { x } => vec![x.raw().to_owned()],
            boundfit::engine::estimation::Model::TwoRegressors { regressors } => {
                regressors.iter().map(|own| own.raw().to_owned()).collect()
            }
        };
        (regressors, self.measurements().response().raw().to_owned())
    }

    fn vertices<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyAny>>> {
        self.deciding().vertices().iter().map(|theta| Ok(pair(theta).into_pyobject(py)?.into_any())).collect()
    }

    fn directions<'py>(&self, py: Python<'py>, lines: bool) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let region = self.deciding().fps.polyhedron().region();
        let directions = if lines { region.lines() } else { region.rays() };
        let numbers = directions.iter().map(|d| [d.dx(), d.dy()].map(Rational::from));
        numbers.map(|theta| Ok(pair(&theta).into_pyobject(py)?.into_any())).collect()
    }

    fn witness<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        let witness = self.deciding().fps.polyhedron().region().witness();
        witness.map(|point| Ok(pair(&point.coordinates()).into_pyobject(py)?.into_any())).transpose()
    }

    fn area<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        let area = self.deciding().fps.polyhedron().region().area();
        area.map(|area| Number(&area).into_pyobject(py)).transpose()
    }

    /// Both intervals, each of two ends with their proofs; nothing of an empty set.
    fn pui<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        let Some(pui) = &self.deciding().pui else { return Ok(None) };
        let owned = pui.each_ref().map(|own| [self.proved(&own.lower), self.proved(&own.upper)]);
        let shown = owned.each_ref().map(|own| {
            own.each_ref().map(|(value, terms)| -> ProvedEnd<'_> {
                let terms = terms.iter().map(|(name, times)| (name.clone(), Number(times))).collect();
                (value.as_ref().map(Number), terms)
            })
        });
        Ok(Some(shown.into_pyobject(py)?.into_any()))
    }

    fn eui(&self) -> Option<[Ends<'_>; 2]> {
        self.deciding().eui().map(|eui| eui.each_ref().map(ends))
    }

    fn central(&self) -> Option<[(Number<'_>, Number<'_>); 2]> {
        self.deciding()
            .central
            .as_ref()
            .map(|central| [pair(&central.theta), pair(&central.guaranteed_error)])
    }

    fn least_squares(&self) -> Option<(Number<'_>, Number<'_>)> {
        self.deciding().least_squares.as_ref().ok().map(|own| pair(&own.theta))
    }

    fn least_squares_is_feasible(&self) -> Option<bool> {
        least_squares_is_feasible(self.deciding())
    }

    /// ε_min or the least factor, a minimiser, and whether it is the only one.
    fn minimax(&self) -> Option<(Number<'_>, (Number<'_>, Number<'_>), bool)> {
        self.deciding().minimax.as_ref().map(|own| (Number(&own.least), pair(&own.theta), own.unique))
    }

    /// Returns the half-planes of an empty set that contradict each other.
    fn contradiction<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        let Some(terms) = self.fit().contradiction(self.problem().measurements.error_bound()) else {
            return Ok(None);
        };
        let terms: Vec<_> = terms.iter().map(|(name, times)| (name_of(*name), Number(times))).collect();
        Ok(Some(terms.into_pyobject(py)?.into_any()))
    }

    /// Returns whether a point belongs to the set.
    fn contains(&self, theta1: Given, theta2: Given) -> PyResult<bool> {
        let theta = [theta1.number(self.floats, "theta1")?, theta2.number(self.floats, "theta2")?];
        Ok(!self.deciding().is_empty() && self.deciding().fps.polyhedron().membership(&theta).is_inside())
    }

    /// The smallest and the largest φ·θ over the set; `None` for one that is not bounded, or both of an empty set.
    fn range<'py>(&self, py: Python<'py>, phi1: Given, phi2: Given) -> PyResult<Option<GivenEnds<'py>>> {
        let form = [phi1.number(self.floats, "x")?, phi2.number(self.floats, "x2")?];
        Ok(match self.range_of(&form) {
            None => None,
            Some([lower, upper]) => {
                let end =
                    |end: &Endpoint| end.value().map(|value| Number(value).into_pyobject(py)).transpose();
                Some((end(&lower)?, end(&upper)?))
            }
        })
    }

    /// Returns the ranges of many φ, as `range` does of one. Takes the numbers as they are, and rounds the ends outward to doubles.
    fn ranges(&self, py: Python<'_>, phi1: Vec<f64>, phi2: Vec<f64>) -> PyResult<(Vec<f64>, Vec<f64>)> {
        let rows = py.detach(|| {
            let row = |(phi1, phi2): (&f64, &f64)| {
                let form = [phi1.exact().ok()?, phi2.exact().ok()?];
                let [lower, upper] = self.range_of(&form)?;
                let lower = lower.value().map_or(f64::NEG_INFINITY, Rational::floor_to_f64);
                Some((lower, upper.value().map_or(f64::INFINITY, Rational::ceil_to_f64)))
            };
            phi1.iter().zip(&phi2).map(|own| row(own).unwrap_or((f64::NAN, f64::NAN))).unzip()
        });
        Ok(rows)
    }

    /// Recomputes every proof of the answer from the readings.
    fn verify(slf: &Bound<'_, Self>) -> PyResult<()> {
        let held = slf.clone().unbind();
        waiting(slf.py(), move |_| held.get().fit().verify(held.get().problem()))?.map_err(refuse)
    }

    /// The report of schema boundfit/fit/2.
    fn json(slf: &Bound<'_, Self>) -> PyResult<String> {
        let held = slf.clone().unbind();
        let json = waiting(slf.py(), move |_| {
            let own = held.get();
            own.written(&ask::Fit::default(), Form::Json, own.origin(), Style::default())
        })?;
        json.map_err(|refusal| refuse(in_words(&refusal, slf.get().file.is_some())))
    }

    /// The answer in another format.
    fn text(
        slf: &Bound<'_, Self>,
        format: &str,
        brief: bool,
        full: bool,
        digits: Option<usize>,
    ) -> PyResult<String> {
        let question = ask::Fit { brief, full, ..ask::Fit::default() };
        let style = Style { digits, ..Style::default() };
        let (form, held) = (named(format)?, slf.clone().unbind());
        let text = waiting(slf.py(), move |_| {
            let own = held.get();
            // A document for programs names no file where there is none.
            let origin = if form == Form::Json { own.origin() } else { own.shown_origin() };
            own.written(&question, form, origin, style)
        })?;
        text.map_err(|refusal| refuse(in_words(&refusal, slf.get().file.is_some())))
    }

    /// The proof, where the readings come from delimited text. Refuses to prove a reduction.
    fn proof(slf: &Bound<'_, Self>) -> PyResult<Option<String>> {
        let held = slf.clone().unbind();
        let proof = waiting(slf.py(), move |_| {
            let own = held.get();
            own.written(&ask::Fit::default(), Form::Proof, own.origin(), Style::default())
        })?;
        match proof {
            Err(refusal @ Refusal::NoProof(NoProof::Reduction)) => Err(refuse(in_words(&refusal, false))),
            proof => Ok(proof.ok()),
        }
    }
}

/// Says how a step is taken in Python.
pub(crate) fn next_words(step: &NextStep) -> Option<String> {
    Some(match step {
        NextStep::Outliers => "fit.outliers()".to_owned(),
        NextStep::Status => "fit.status()".to_owned(),
        NextStep::LeastBound(least) => format!("eps=\"{least}\""),
    })
}

impl Fitted {
    fn range_of(&self, form: &[Rational; 2]) -> Option<[Endpoint; 2]> {
        use boundfit::Support::{Bounded, Empty, Unbounded};
        let polyhedron = self.deciding().fps.polyhedron();
        let end = |form: &[Rational; 2], is_lower: bool| match polyhedron.support(form) {
            Empty(_) => None,
            Unbounded(_) => Some(Endpoint::Unbounded),
            Bounded { proof, .. } => {
                Some(Endpoint::Finite(if is_lower { -&proof.value } else { proof.value }))
            }
        };
        let [phi1, phi2] = form;
        Some([end(&[-phi1, -phi2], true)?, end(form, false)?])
    }
}
