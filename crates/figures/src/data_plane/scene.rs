//! The material of a figure of the data plane: the readings to be seen, and the line that distances are taken from.

use std::borrow::Cow;
use std::collections::BTreeSet;

use boundfit_estimation::{BoundName, Fit, Measurement, Model, Problem};
use boundfit_exact::Rational;

use super::frames::frames;
use super::sample::{Floats, columns, may_be_seen};
use crate::axis::Axis;
use crate::extent::Extent;
use crate::figure::{Figure, PlotOptions};
use crate::labels::Conflict;
use crate::palette::{Dash, Stroke, style};

/// The number of readings above which a figure shows counts at places instead of each reading.
pub(super) const MOST_MARKS: usize = 1_000;
/// The number of readings above which each is drawn small.
pub(super) const MOST_LARGE_MARKS: usize = 125;
/// The number of rows above which the marks at one row would cover the marks at the next.
const MOST_ROWS: usize = 250;
/// The number of rows that fix the set and are kept whatever the columns say: a set may have a vertex for every
/// reading.
const MOST_KEPT_BY_NAME: usize = 100;

/// A line that others are compared with.
pub(crate) struct Reference {
    pub(crate) name: &'static str,
    pub(crate) theta: [Rational; 2],
    pub(crate) stroke: Stroke,
}

impl Reference {
    /// Returns the level of a reading less the line.
    fn distance(&self, reading: &Measurement) -> Rational {
        let [phi1, phi2] = &reading.regressor;
        level(reading) - (&self.theta[0] * phi1 + &self.theta[1] * phi2)
    }
}

/// Returns the level of a reading: y or the middle of its bounds, else its only bound.
pub(super) fn level(reading: &Measurement) -> Rational {
    let value = reading.value().map(Cow::into_owned);
    value.or_else(|| reading.lower()).or_else(|| reading.upper()).unwrap_or_default()
}

/// A reading that is to be seen.
pub(crate) struct Shown {
    /// x, or the number of the row.
    pub(crate) abscissa: Rational,
    pub(crate) measurement: Measurement,
    /// The level at which the reading stands.
    pub(crate) level: Rational,
    /// The level less that of the reference line.
    pub(crate) distance: Rational,
    pub(crate) fitted: bool,
    /// Kept when marks thin out.
    pub(crate) kept: bool,
    pub(crate) conflicting: bool,
}

/// The material of a figure, except its bands.
pub(crate) struct Scene<'a> {
    pub(crate) problem: &'a Problem,
    pub(crate) fit: &'a Fit,
    pub(crate) figure: Figure,
    pub(crate) options: &'a PlotOptions,
    pub(crate) conflict: Conflict,
    pub(crate) reference: Option<Reference>,
    /// All of them, or of very many those that may be seen.
    pub(crate) readings: Vec<Shown>,
    /// The number of readings there.
    pub(crate) count: usize,
    /// The fitted readings of a line as floats, where there are too many to be told apart.
    pub(super) floats: Option<Vec<Floats>>,
    /// The ends of the axis of x.
    pub(crate) abscissas: [Rational; 2],
}

impl<'a> Scene<'a> {
    pub(crate) fn new(problem: &'a Problem, fit: &'a Fit, figure: Figure, options: &'a PlotOptions) -> Self {
        let conflict = Conflict::of(problem, fit);
        let reference = reference(problem, fit, figure);
        let others = if figure == Figure::Corridor { &[] } else { problem.measurements.others() };
        let measurements = &problem.measurements;
        let asked = options.x_range.clone();
        // The readings on the hulls of all include the ends of x.
        let abscissas = asked.unwrap_or_else(|| abscissas([others, measurements.kept()], is_line(problem)));
        let frame = frames(options)[0];
        let columns = columns(if options.flip { frame.height } else { frame.width });
        let theta = reference.as_ref().map(|reference| &reference.theta);
        let is_crowded = measurements.shown() > MOST_MARKS;
        let floats = is_crowded.then(|| measurements.near_f64()).flatten();
        let are_same = |one: usize, other: usize| {
            let [one, other] = [one, other].map(|position| measurements.shown_at(position));
            let both = one.as_deref().zip(other.as_deref());
            both.is_some_and(|(one, other)| {
                (&one.regressor, &one.bounds) == (&other.regressor, &other.bounds)
            })
        };
        let seen = match (others, &floats) {
            // Only of a line they are beside each other.
            ([], Some(floats)) => may_be_seen(floats, are_same, theta, &abscissas, columns),
            _ => None,
        };
        let readings = readings(problem, fit, &conflict, others, reference.as_ref(), seen.as_deref());
        let count = others.len() + measurements.shown();
        Scene { problem, fit, figure, options, conflict, reference, readings, count, floats, abscissas }
    }

    /// Every fitted reading that can be shown.
    pub(crate) fn fitted(&self) -> impl Iterator<Item = Cow<'a, Measurement>> {
        let measurements = &self.problem.measurements;
        (0..measurements.shown()).filter_map(|position| measurements.shown_at(position))
    }

    /// Returns whether the model is a line.
    pub(crate) fn is_line(&self) -> bool {
        is_line(self.problem)
    }

    /// x of a reading, or the number of its row.
    pub(crate) fn abscissa(&self, reading: &Measurement) -> Rational {
        if self.is_line() { reading.regressor[0].clone() } else { Rational::from(reading.row) }
    }

    /// Returns whether each reading is drawn small, to leave room for the others.
    pub(crate) fn is_dense(&self) -> bool {
        self.count > MOST_LARGE_MARKS
    }

    /// Returns whether there are more readings than can be told apart.
    pub(crate) fn is_crowded(&self) -> bool {
        self.count > MOST_MARKS
    }

    /// The fitted rows, or as many of them, evenly spread, as have room side by side.
    pub(crate) fn rows_with_room(&self) -> impl Iterator<Item = &Shown> {
        let step = self.readings.len().div_ceil(MOST_ROWS).max(1);
        let kept = move |(index, shown): &(usize, &Shown)| shown.fitted && (index % step == 0 || shown.kept);
        self.readings.iter().enumerate().filter(kept).map(|(_, shown)| shown)
    }
}

fn is_line(problem: &Problem) -> bool {
    matches!(problem.measurements.model(), Model::Line { .. })
}

/// The ends of the axis of x: those of the readings, and a little more; never equal.
fn abscissas(readings: [&[Measurement]; 2], is_line: bool) -> [Rational; 2] {
    let mut extent = Extent::default();
    for reading in readings.into_iter().flatten() {
        match is_line {
            true => extent.include(&reading.regressor[0]),
            false => extent.include(&Rational::from(reading.row)),
        }
    }
    let [lower, upper] = if is_line {
        extent.padded(&Rational::ratio(1, 20)).into_ends()
    } else {
        // Rows are counted from 1: room for the whole band of the first and of the last one, and none for a row 0.
        let [first, last] = extent.into_ends();
        let half = Rational::ratio(3, 5);
        [first - &half, last + half]
    };
    // The axis widens what has no width; bands need to know how far.
    let axis = Axis::new(String::new(), &lower, &upper, 1);
    [axis.lower().clone(), axis.lower() + axis.width()]
}

/// The readings of a figure: those that are not fitted, too, but for [`Figure::Corridor`], which is about narrow
/// gaps. Among fitted readings it takes the ones that may be seen, and those to be kept anyway.
fn readings(
    problem: &Problem,
    fit: &Fit,
    conflict: &Conflict,
    others: &[Measurement],
    reference: Option<&Reference>,
    seen: Option<&[bool]>,
) -> Vec<Shown> {
    let active = active_rows(fit);
    let line = is_line(problem);
    let is_conflicting = |row: &usize| conflict.rows.contains(row);
    let shown = |measurement: &Measurement, fitted: bool| {
        let conflicting = fitted && is_conflicting(&measurement.row);
        Shown {
            abscissa: if line { measurement.regressor[0].clone() } else { Rational::from(measurement.row) },
            fitted,
            kept: fitted && (conflicting || active.contains(&measurement.row)),
            conflicting,
            distance: reference.map_or_else(Rational::zero, |reference| reference.distance(measurement)),
            level: level(measurement),
            measurement: measurement.clone(),
        }
    };
    let measurements = &problem.measurements;
    let positions: Vec<usize> = match seen {
        None => (0..measurements.shown()).collect(),
        Some(seen) => {
            let seen = seen.iter().enumerate().filter(|(_, is_seen)| **is_seen).map(|(position, _)| position);
            let kept = active.iter().chain(&conflict.rows).filter_map(|row| measurements.position_of(*row));
            let positions: BTreeSet<usize> = seen.chain(kept).collect();
            positions.into_iter().collect()
        }
    };
    let fitted = positions.into_iter().filter_map(|position| measurements.shown_at(position));
    others.iter().map(|row| shown(row, false)).chain(fitted.map(|reading| shown(&reading, true))).collect()
}

/// The rows whose bounds pass through a vertex: the first of each vertex, when there are many.
fn active_rows(fit: &Fit) -> BTreeSet<usize> {
    let vertices = fit.fps.polyhedron().region().vertices();
    // A row has two bounds.
    let first = |active| fit.fps.active(active, 2 * MOST_KEPT_BY_NAME).names;
    let bounds = vertices.iter().flat_map(|vertex| first(vertex.active()));
    let all: BTreeSet<usize> = bounds.filter_map(BoundName::row).collect();
    all.into_iter().take(MOST_KEPT_BY_NAME).collect()
}

/// The line that distances are taken from.
fn reference(problem: &Problem, fit: &Fit, figure: Figure) -> Option<Reference> {
    let least_squares = || {
        let theta = fit.least_squares.as_ref().ok()?.theta.clone();
        Some(Reference { name: named(problem, "least squares"), theta, stroke: style::LEAST_SQUARES })
    };
    let central = || {
        let theta = fit.central.as_ref()?.theta.clone();
        Some(Reference { name: named(problem, "central"), theta, stroke: style::CENTRAL })
    };
    let minimax = || {
        let theta = fit.minimax.as_ref()?.theta.clone();
        Some(Reference { name: named(problem, "minimax"), theta, stroke: style::MINIMAX })
    };
    let mut reference = match figure {
        Figure::Data | Figure::Eui => least_squares().or_else(central).or_else(minimax),
        _ => central().or_else(minimax).or_else(least_squares),
    }?;
    if let Model::TwoRegressors { .. } = problem.measurements.model() {
        // The stroke at a row is too short for dashes.
        reference.stroke.dash = Dash::Solid;
    }
    Some(reference)
}

/// An estimate as the thing that is drawn: a line, or one value per row.
fn named(problem: &Problem, estimate: &str) -> &'static str {
    match (problem.measurements.model(), estimate) {
        (Model::Line { .. }, "least squares") => "least-squares line",
        (Model::Line { .. }, "central") => "central line",
        (Model::Line { .. }, _) => "minimax line",
        (Model::TwoRegressors { .. }, "least squares") => "least-squares fit",
        (Model::TwoRegressors { .. }, "central") => "central fit",
        (Model::TwoRegressors { .. }, _) => "minimax fit",
    }
}
