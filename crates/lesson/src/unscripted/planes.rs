//! The two pictures of the start.

use boundfit_estimation::{BoundName, Corridor, Measurement, Model};
use boundfit_exact::{Foreign, Rational};
use boundfit_geometry::{Inequality, Polyhedron, RegionKind};

use super::picture::{Picture, Range};
use super::{Facts, theta};
use crate::texts::{say, text};

/// Bars shorter than this share of the range of the heights, one over it, are too short to see.
const SHORT_BAR: i64 = 25;

/// Both pictures, side by side.
pub(super) fn pictures(facts: &Facts<'_>) -> String {
    let figure = |title: &str, picture: String| {
        format!("<figure><figcaption><h3>{}</h3></figcaption>{picture}</figure>", facts.say(&text!(title)))
    };
    let data = if facts.problem.measurements.kept().is_empty() {
        String::new()
    } else {
        figure("data-plane.title", data_plane(facts))
    };
    format!("<div class=\"pair\">{data}{}</div>", figure("parameter-plane.title", parameter_plane(facts)))
}

/// The part of the parameter plane that is shown.
fn view(facts: &Facts<'_>) -> [Range; 2] {
    let region = facts.fit.fps.polyhedron().region();
    let mut places: Vec<[Rational; 2]> =
        region.vertices().iter().map(|vertex| vertex.point().coordinates()).collect();
    let estimates = [
        facts.fit.least_squares.as_ref().ok().map(|estimate| &estimate.theta),
        facts.fit.minimax.as_ref().map(|minimax| &minimax.theta),
    ];
    if places.len() < 2 {
        places.extend(estimates.into_iter().flatten().cloned());
    }
    let margin = if region.is_bounded() && places.len() > 1 { 25 } else { 100 };
    [0, 1].map(|axis| {
        let numbers: Vec<Rational> = places.iter().map(|place| place[axis].clone()).collect();
        Range::around(&numbers, margin)
    })
}

/// The set within the part that is shown, its corners counter-clockwise.
fn corners(facts: &Facts<'_>, view: &[Range; 2]) -> Vec<[Rational; 2]> {
    let [one, none] = [Rational::one, Rational::zero];
    let [x, y] = view;
    let frame = [
        Inequality::new(one(), none(), x.end()),
        Inequality::new(-one(), none(), -&x.from),
        Inequality::new(none(), one(), y.end()),
        Inequality::new(none(), -one(), -&y.from),
    ];
    let own = facts.fit.fps.polyhedron().system().inequalities().iter().cloned();
    let shown = Polyhedron::intersect(own.chain(frame).collect());
    shown.region().vertices().iter().map(|vertex| vertex.point().coordinates()).collect()
}

fn parameter_plane(facts: &Facts<'_>) -> String {
    let polyhedron = facts.fit.fps.polyhedron();
    let mut picture = Picture::new(view(facts));
    let corners = corners(facts, &picture.ranges);
    let inequalities = polyhedron.system().inequalities();
    let shaping = crate::half_planes::irredundant(facts.problem, facts.fit);
    for inequality in shaping.iter().filter_map(|&index| Some((index, inequalities.get(index)?))) {
        let (index, Inequality { a, b }) = inequality;
        let class = match facts.fit.fps.name(index) {
            BoundName::Upper(_) => "upper",
            BoundName::Lower(_) => "lower",
            _ => "condition",
        };
        picture.line(class, a, b);
    }
    picture.path("region fill", &corners, true);
    if matches!(polyhedron.region().kind(), RegionKind::Polygon | RegionKind::Segment) {
        picture.path("region edge", &corners, true);
    }
    for (number, vertex) in (1..).zip(polyhedron.region().vertices()) {
        picture.vertex(number, &vertex.point().coordinates());
    }
    let region = polyhedron.region();
    let kind = text!(&format!("kind.{}", region.kind().name()), vertices: region.vertices().len());
    let label = say(&text!("parameter-plane.set", set: kind), facts.language());
    picture.svg("parameter-clip-still", &label, [&theta(facts, 0), &theta(facts, 1)], facts.language())
}

/// Where the bar of a reading ends; a side without a bound ends where the other one does.
fn ends(reading: &Measurement) -> Option<[Rational; 2]> {
    let (lower, upper) = (reading.lower(), reading.upper());
    let low = lower.clone().or_else(|| upper.clone())?;
    Some([low, upper.or(lower)?])
}

fn data_plane(facts: &Facts<'_>) -> String {
    let rows = facts.problem.measurements.kept();
    let reference = reference(facts, rows);
    let relative = |phi: &[Rational; 2], value: &Rational| match &reference {
        Some((theta, _)) => value - &at(phi, theta),
        None => value.clone(),
    };
    let across = |reading: &Measurement| {
        if facts.is_line() { reading.regressor[0].clone() } else { Rational::from(reading.row) }
    };
    let bars: Vec<(Rational, [Rational; 2], Option<Rational>)> = rows
        .iter()
        .filter_map(|reading| {
            let [lower, upper] = ends(reading)?.map(|end| relative(&reading.regressor, &end));
            let dot = reading.value().map(|value| relative(&reading.regressor, &value));
            Some((across(reading), [lower, upper], dot))
        })
        .collect();
    let heights: Vec<Rational> = bars.iter().flat_map(|(_, ends, _)| ends.clone()).collect();
    let xs: Vec<Rational> = bars.iter().map(|(x, _, _)| x.clone()).collect();
    let mut picture = Picture::new([Range::around(&xs, 5), Range::around(&heights, 8)]);
    if let Some(outline) = corridor(facts, &xs, &relative) {
        picture.path("corridor", &outline, true);
    }
    for (x, [lower, upper], dot) in &bars {
        picture.reading(x, lower, upper, dot.as_ref());
    }
    let language = facts.language();
    let count = text!("data-plane.readings", count: rows.len());
    let [x, y] = axes(facts);
    let y = match reference {
        Some((_, name)) => say(&text!(name, y: y), language),
        None => y,
    };
    picture.svg("data-clip-still", &say(&count, language), [&x, &y], language)
}

/// The names of both axes with their units.
fn axes(facts: &Facts<'_>) -> [String; 2] {
    let with_unit = |name: String, unit: &Option<Foreign>| match unit.as_ref().map(Foreign::to_string) {
        Some(unit)
            if !unit.is_empty()
                && !name.ends_with(&format!("({unit})"))
                && !name.ends_with(&format!("[{unit}]")) =>
        {
            format!("{name} ({unit})")
        }
        _ => name,
    };
    let measurements = &facts.problem.measurements;
    let x = match measurements.model() {
        Model::Line { x } => {
            with_unit(measurements.line_form().abscissa(x).to_string(), &facts.options.x_unit)
        }
        Model::TwoRegressors { .. } => say(&text!("readings.row"), facts.language()),
    };
    [x, with_unit(measurements.response().to_string(), &facts.options.y_unit)]
}

/// φ·θ.
fn at(phi: &[Rational; 2], theta: &[Rational; 2]) -> Rational {
    &(&phi[0] * &theta[0]) + &(&phi[1] * &theta[1])
}

/// The estimate that heights are relative to, where bars would be too short to see.
fn reference(facts: &Facts<'_>, rows: &[Measurement]) -> Option<([Rational; 2], &'static str)> {
    let ends: Vec<[Rational; 2]> = rows.iter().filter_map(ends).collect();
    let longest = ends.iter().map(|[lower, upper]| upper - lower).max()?;
    let lowest = ends.iter().map(|[lower, _]| lower).min()?;
    let highest = ends.iter().map(|[_, upper]| upper).max()?;
    if &longest * &Rational::from(SHORT_BAR) >= highest - lowest {
        return None;
    }
    let squares = facts
        .fit
        .least_squares
        .as_ref()
        .ok()
        .map(|estimate| (estimate.theta.clone(), "height.least-squares"));
    squares.or_else(|| facts.fit.minimax.as_ref().map(|minimax| (minimax.theta.clone(), "height.minimax")))
}

/// The outline of what all feasible lines of a bounded set cover, from the least to the greatest of the abscissas.
fn corridor(
    facts: &Facts<'_>,
    xs: &[Rational],
    relative: &impl Fn(&[Rational; 2], &Rational) -> Rational,
) -> Option<Vec<[Rational; 2]>> {
    let polyhedron = facts.fit.fps.polyhedron();
    if !facts.is_line() || !polyhedron.region().is_bounded() {
        return None;
    }
    let [least, greatest] = [xs.iter().min()?, xs.iter().max()?];
    let Corridor { upper, lower } = Corridor::new(polyhedron)?;
    let breakpoints = upper.breakpoints().iter().chain(lower.breakpoints());
    let mut at_x: Vec<Rational> = breakpoints.filter(|x| *x > least && *x < greatest).cloned().collect();
    at_x.extend([least.clone(), greatest.clone()]);
    at_x.sort();
    let edge = |edge: &boundfit_estimation::CorridorEdge, x: &Rational| {
        let height = edge.value(x)?;
        Some([x.clone(), relative(&[x.clone(), Rational::one()], &height)])
    };
    let above = at_x.iter().map(|x| edge(&upper, x));
    let below = at_x.iter().rev().map(|x| edge(&lower, x));
    above.chain(below).collect()
}
