//! Predictions as JSON, schema `boundfit/predict/1`.

use std::cell::Cell;
use std::collections::BTreeMap;
use std::io::{self, Write};

use boundfit_exact::Rational;
use boundfit_geometry::Support;
use boundfit_questions::{FurtherError, PossibleEnd, PossibleX, Predictor};
use serde::{Serialize, Serializer};

use super::{AskedValues, Prediction};
use crate::answer::input::InputJson;
use crate::answer::parts::{FeasibleSetJson, RangeJson, TermJson};
use crate::answer::predict::{
    NewReadingJson, PossibleJson, PredictedJson, PredictionJson, ProofEndJson, SourceEndJson, SourceJson,
    ValueJson,
};
use crate::style::Style;

/// A list that is made while it is written, once.
struct Each<I>(Cell<Option<I>>);

impl<I: Iterator<Item = T>, T: Serialize> Serialize for Each<I> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.0.take().into_iter().flatten())
    }
}

/// Writes predictions as indented JSON, with a line end. Each is made when it is written.
///
/// # Errors
/// Errors of the writer.
pub fn write_prediction_json(prediction: &Prediction, style: &Style, to: &mut dyn Write) -> io::Result<()> {
    let Prediction { problem, fit, origin, .. } = prediction;
    let predictor = prediction.predictor();
    let AskedValues { values: at, .. } = prediction.at;
    let AskedValues { values: from, .. } = prediction.from;
    let at =
        predictor.as_ref().map(|predictor| at().map(|value| at_json(prediction, predictor, &value, style)));
    let from = predictor.as_ref().map(|predictor| {
        let of = prediction.sources(predictor);
        from().map(move |[y, _]| SourceJson {
            x: of(&y).into_iter().map(|own| possible_json(prediction, predictor, &own, style)).collect(),
            y: style.number(&y),
        })
    });
    let mut reasons = BTreeMap::new();
    if predictor.is_none() {
        reasons.insert("at", "the FPS is empty".to_owned());
        reasons.insert("from", "the FPS is empty".to_owned());
    }
    if let Err(reason) = &prediction.error {
        reasons.insert("reading", reason.to_string());
    }
    let written = PredictionJson {
        schema: PredictionJson::SCHEMA,
        input: InputJson::new(problem, origin, style),
        fps: FeasibleSetJson::new(problem, fit, style),
        new_reading: prediction.error.as_ref().ok().map(|error| new_reading(prediction, error, style)),
        at: Each(Cell::new(Some(at.into_iter().flatten()))),
        from: Each(Cell::new(Some(from.into_iter().flatten()))),
        reasons,
    };
    serde_json::to_writer_pretty(&mut *to, &written)?;
    to.write_all(b"\n")
}

fn new_reading(prediction: &Prediction, error: &FurtherError, style: &Style) -> NewReadingJson {
    let law = prediction.given.as_ref().or_else(|| prediction.problem.measurements.law());
    NewReadingJson {
        epsilon: error.uniform().map(|epsilon| style.upper_number(epsilon)),
        law: law.filter(|_| error.uniform().is_none()).map(|law| law.text().to_owned()),
        given: prediction.given.is_some(),
    }
}

fn at_json(
    prediction: &Prediction,
    predictor: &Predictor,
    value: &[Rational; 2],
    style: &Style,
) -> PredictedJson {
    let form = prediction.form(value);
    let (line, reading) = prediction.at(predictor, &form);
    let [lower, upper] = predictor.ends(&form).map(|support| end_json(prediction, &support, style));
    let x = match prediction.is_line() {
        true => ValueJson::One(style.number(&value[0])),
        false => ValueJson::Two(style.numbers(value)),
    };
    PredictedJson {
        x,
        line: RangeJson::new(&line, style),
        reading: reading.map(|reading| RangeJson::new(&reading, style)),
        proof: RangeJson { lower, upper },
    }
}

fn end_json(prediction: &Prediction, support: &Support, style: &Style) -> Option<ProofEndJson> {
    Some(match support {
        Support::Empty(_) => return None,
        Support::Bounded { proof, .. } => ProofEndJson {
            theta: style.numbers(&proof.attained_at.coordinates()),
            active: TermJson::named(&proof.multipliers, |index| prediction.fit.fps.name(index), style),
            ray: None,
        },
        Support::Unbounded(proof) => ProofEndJson {
            theta: style.numbers(&proof.point.coordinates()),
            active: Vec::new(),
            ray: Some(style.numbers(&[proof.ray.dx(), proof.ray.dy()].map(Rational::from))),
        },
    })
}

fn possible_json(
    prediction: &Prediction,
    predictor: &Predictor,
    PossibleX { lower, upper }: &PossibleX,
    style: &Style,
) -> PossibleJson {
    let why = |end: &Option<PossibleEnd>| {
        let end = end.as_ref()?;
        let proof = end_json(prediction, &prediction.why(predictor, end), style)?;
        Some(SourceEndJson { line: if end.by_upper { "upper" } else { "lower" }, end: proof })
    };
    let included = |end: &Option<PossibleEnd>| end.as_ref().map(|end| end.included);
    PossibleJson {
        range: RangeJson {
            lower: lower.as_ref().map(|end| style.lower_number(&end.x)),
            upper: upper.as_ref().map(|end| style.upper_number(&end.x)),
        },
        lower_included: included(lower),
        upper_included: included(upper),
        proof: RangeJson { lower: why(lower), upper: why(upper) },
    }
}
