//! The page without readings, for those that are typed or pasted into it.

use boundfit_estimation::{ErrorBound, Measurements, Model, Problem};
use boundfit_exact::{Rational, Reading};

use crate::data;
use crate::options::{LessonError, LessonOptions};
use crate::template;
use crate::texts::Language;

/// The lesson about no readings, as one HTML file without outside parts: whoever opens it types, pastes or drops a table, and the engine in
/// the page fits it. Every run gives the same bytes.
///
/// # Errors
/// Where the page cannot be written, and in a build without the engine.
pub fn playground(language: Language) -> Result<String, LessonError> {
    if !cfg!(feature = "engine") {
        return Err(LessonError::NoEngine);
    }
    let model = Model::Line { x: "x".into() };
    let bound = ErrorBound::Uniform(Rational::one());
    let readings = Measurements::new(model, "y".into(), bound, Vec::new());
    // Whoever knows a bound states it; this one leaves something of any readings, and the page says where it comes from.
    let problem = Problem::new(readings).with_multiple_of_least(&Rational::from(2));
    let options = LessonOptions { file: "readings.csv".into(), language, ..LessonOptions::default() };
    let data = data::build(&problem, &problem.fit(), Reading::Decimal, &options)?;
    Ok(template::page("boundfit", &serde_json::to_string(&data)?, language, None)?)
}
