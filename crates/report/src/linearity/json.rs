//! The linearity of a calibration as JSON, schema `boundfit/linearity/1`.

use std::collections::BTreeMap;

use boundfit_exact::{Foreign, Rational};
use boundfit_geometry::Tally;
use boundfit_questions::{
    AlternatingPoint, Characteristic, Difference, Linearity, LinearityInput, LinearityLine, LinearityOptions,
    ResponseColumns,
};

use super::NO_PERCENT;
use crate::answer::linearity::{
    AlternatingJson, CalibrationJson, CharacteristicJson, DirectionJson, LinearityJson, LinearityLineJson,
    PlaceJson,
};
use crate::answer::table::TableJson;
use crate::input_json::{fractions, selection};
use crate::json::to_text;
use crate::origin::Origin;
use crate::style::Style;

/// The linearity as indented JSON, with a line end.
pub fn linearity_json(
    linearity: &Linearity,
    options: &LinearityOptions,
    input: &LinearityInput,
    origin: &Origin,
    style: &Style,
) -> String {
    let average = &linearity.average;
    let percent = |difference: Option<&Difference>| {
        let percent = (&difference?.value * Rational::from(100)).checked_div(&average.full_scale)?;
        Some(style.upper_number(&percent))
    };
    let value = |difference: Option<&Difference>| Some(style.upper_number(&difference?.value));
    let at = |difference: Option<&Difference>| {
        let places = difference.into_iter().flat_map(|difference| &difference.at);
        places.map(|point| PlaceJson { x: style.number(&point.x), rows: rows_of(&point.rows) }).collect()
    };
    let [hysteresis, repeatability] = [linearity.hysteresis.as_ref(), linearity.repeatability.as_ref()];
    to_text(&LinearityJson {
        schema: LinearityJson::SCHEMA,
        input: input_json(linearity, options, input, origin),
        average: characteristic(average, style),
        hysteresis: value(hysteresis),
        repeatability: value(repeatability),
        hysteresis_percent: percent(hysteresis),
        repeatability_percent: percent(repeatability),
        hysteresis_at: at(hysteresis),
        repeatability_at: at(repeatability),
        proof: average.proof.iter().filter_map(|point| proof(average, point, style)).collect(),
        through: style.numbers(&options.through),
        up: linearity.up.as_ref().map(|up| characteristic(up, style)),
        down: linearity.down.as_ref().map(|down| characteristic(down, style)),
        reasons: reasons(linearity, input),
    })
}

/// The data rows of a point.
fn rows_of(rows: &Tally) -> Vec<usize> {
    rows.rows().map(|row| row as usize).collect()
}

fn characteristic(characteristic: &Characteristic, style: &Style) -> CharacteristicJson {
    let line = |line: &LinearityLine| LinearityLineJson {
        deviation: style.upper_number(&line.deviation),
        percent: line.percent.as_ref().map(|percent| style.upper_number(percent)),
        theta: style.numbers(&line.theta),
        rows: line.rows(characteristic),
        unique: line.unique,
    };
    CharacteristicJson {
        full_scale: style.number(&characteristic.full_scale),
        span: style.number(&characteristic.span),
        independent: line(&characteristic.independent),
        terminal: characteristic.terminal.as_ref().ok().map(line),
        zero_based: line(&characteristic.zero_based),
        least_squares: characteristic.least_squares.as_ref().ok().map(line),
    }
}

fn proof(average: &Characteristic, point: &AlternatingPoint, style: &Style) -> Option<AlternatingJson> {
    let place = average.points.get(point.position)?;
    Some(AlternatingJson {
        x: style.number(&place.x),
        y: style.number(&place.y),
        rows: rows_of(&place.rows),
        residual: style.number(&point.deviation),
        weight: style.number(&point.weight),
    })
}

fn input_json(
    linearity: &Linearity,
    options: &LinearityOptions,
    input: &LinearityInput,
    origin: &Origin,
) -> CalibrationJson {
    let (y, up, down, direction) = match input.response.clone() {
        ResponseColumns::One(y) => (Some(y), None, None, None),
        ResponseColumns::Two { up, down } => (None, Some(up), Some(down), None),
        ResponseColumns::Directed { y, direction, words: [up, down] } => {
            (Some(y), None, None, Some(DirectionJson { column: direction, up, down }))
        }
    };
    CalibrationJson {
        file: origin.file.map(Foreign::from),
        rows: input.rows,
        rows_total: input.rows_total,
        selection: selection(&input.selection),
        rows_missing: input.rows_missing,
        table: TableJson::of_input(input),
        fractions: input.fractions.iter().cloned().map(fractions).collect(),
        reading: origin.reading.name(),
        sha256: input.sha256.clone(),
        x: input.x.clone(),
        y,
        up,
        down,
        direction,
        points: linearity.average.count(),
        full_scale: if options.full_scale.is_some() { "given" } else { "span" },
    }
}

/// Returns the reason why each null part is null.
fn reasons(linearity: &Linearity, input: &LinearityInput) -> BTreeMap<&'static str, String> {
    let mut reasons = BTreeMap::new();
    if let Err(no_line) = &linearity.average.terminal {
        reasons.insert("terminal", no_line.to_string());
        reasons.insert("least_squares", no_line.to_string());
    }
    if linearity.average.full_scale.is_zero() {
        reasons.insert("percent", NO_PERCENT.to_owned());
    }
    if linearity.hysteresis.is_none() {
        let reason = match input.response {
            ResponseColumns::One(_) => "no direction is told",
            _ => "no x was read in both directions",
        };
        reasons.insert("hysteresis", reason.to_owned());
    }
    if linearity.repeatability.is_none() {
        reasons.insert("repeatability", "no x was read twice in one direction".to_owned());
    }
    reasons
}
