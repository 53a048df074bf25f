//! Claims about the intervals of a fit, judged exactly.

use boundfit::Rational;
use boundfit::check::{BoundClaim, Claimed, PuiEnd, judge};
use boundfit::engine::lp::Printed;
use pyo3::prelude::*;

use crate::fitted::Fitted;
use crate::numbers::{Number, exact, refuse};

/// The judgement of a claimed end: the end, the verdict, the true end, the claimed one, and the distance outside.
type Judged<'py> = (
    &'static str,
    &'static str,
    Option<Bound<'py, PyAny>>,
    Option<Bound<'py, PyAny>>,
    Option<Bound<'py, PyAny>>,
);

/// Judges claimed ends: lower and upper of θ1, then of θ2. A text is as precise as its last digit, all else is meant exactly, and `None` is no end.
#[pyfunction]
pub(crate) fn check<'py>(
    py: Python<'py>,
    fitted: &Fitted,
    claims: Vec<Bound<'py, PyAny>>,
) -> PyResult<Vec<Judged<'py>>> {
    let mut given = claims.iter();
    let claims = PuiEnd::try_each(|_| {
        let claim = given.next().ok_or_else(|| refuse("a claim has four ends"))?;
        if claim.is_none() {
            return Ok(BoundClaim::bare(Claimed::Unbounded));
        }
        let value = exact(claim, "claim")?;
        let printed = match claim.extract::<String>() {
            Ok(text) => Printed::typed(&text, value),
            Err(_) => Printed::exact(value),
        };
        Ok::<_, PyErr>(BoundClaim::bare(Claimed::Value(printed)))
    })?;
    let judged = py.detach(|| judge(fitted.problem(), &claims));
    let number =
        |value: &Option<Rational>| value.as_ref().map(|value| Number(value).into_pyobject(py)).transpose();
    let shown = PuiEnd::ALL.into_iter().map(|end| {
        let judgement = end.of(&judged);
        let (exact, claimed) = (number(&judgement.exact)?, number(&judgement.claimed)?);
        Ok((end.name(), judgement.verdict.name(), exact, claimed, number(&judgement.excess)?))
    });
    shown.collect()
}
