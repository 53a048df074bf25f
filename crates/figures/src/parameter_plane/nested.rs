//! The feasible sets under growing error bounds, one in another.

use boundfit_estimation::{Family, Problem, Section};
use boundfit_exact::english::listed;
use boundfit_exact::{Rational, Rounding};
use boundfit_geometry::{Generator, Generators, Inequality, Point, Polyhedron, RegionKind};

use super::layout::{finished, main_frame, panel};
use super::{marks, region, view};
use crate::drawing::{Anchor, Drawing, LegendEntry, Panel, Swatch};
use crate::figure::PlotOptions;
use crate::labels;
use crate::outside::{unseen_sets, without_end};
use crate::page::Page;
use crate::palette::{BLUE, Dash, Fill, INK, Stroke};

/// The number of sets that are drawn, evenly spread, beside the set of the bounds as given.
const SETS: i64 = 5;
/// Light enough for one set to be seen through others.
pub(crate) const FILL: Fill = Fill { colour: BLUE, opacity: 0.16 };
pub(crate) const EDGE: Stroke = Stroke::new(BLUE, 1.0, Dash::Solid);
/// The set of the bounds as given: darker than the sets around it, in greys too.
pub(crate) const GIVEN: Stroke = Stroke::new(INK, 2.2, Dash::Long);
/// Significant digits of factors.
const DIGITS: usize = 4;

/// A set of the family.
pub(crate) struct Nested {
    pub(crate) factor: Rational,
    pub(crate) set: Polyhedron,
}

/// The figure; `None` where no factor of the family leaves any parameters.
pub(crate) fn drawing(problem: &Problem, family: &Family, options: &PlotOptions) -> Option<Drawing> {
    let names = labels::axes_of_parameters(problem, options);
    let sets = sets(family);
    let largest = sets.last()?;
    // Sets grow with the factor: the last one has all others in it.
    let window = view::of_region(largest.set.region(), None, &[]).asked_for(options);
    let mut panel = panel(main_frame(0, Page::of(options)), &window, &names);
    for nested in sets.iter().rev() {
        let is_given = nested.factor == Rational::one();
        region::draw(&mut panel, &nested.set, FILL, if is_given { GIVEN } else { EDGE });
        marks::draw_vertices(&mut panel, nested.set.region(), false);
    }
    let named = sets.iter().filter(|nested| name(&mut panel, nested)).count();
    let mut legend = vec![LegendEntry::new(
        Swatch::area(FILL, EDGE),
        "feasible parameters when all error bounds grow by this factor",
    )];
    if sets.iter().any(|nested| nested.factor == Rational::one()) {
        legend.push(LegendEntry::new(Swatch::area(FILL, GIVEN), "with error bounds as given"));
    }
    let mut notes: Vec<String> = Vec::new();
    if named < sets.len() {
        notes.push(in_order(&sets));
    }
    notes.extend(nothing_below(family));
    notes.extend(unseen_sets(&panel, sets.iter().map(|nested| &nested.set), options));
    notes.extend(without_end(sets.iter().map(|nested| nested.set.region())));
    let title = "Feasible parameter sets under growing error bounds".to_owned();
    Some(finished(problem, options, title, vec![panel], legend, notes))
}

/// Returns the factor below which nothing is left.
pub(crate) fn nothing_below(family: &Family) -> Option<String> {
    let least = family.least().filter(|least| least.is_positive())?;
    Some(format!("Below the factor {} nothing is left.", shown("", least, Rounding::Up)))
}

/// The factors of sets, each of which is in the next one.
pub(crate) fn in_order(sets: &[Nested]) -> String {
    let factors = sets.iter().map(|own| shown("×", &own.factor, Rounding::Nearest));
    format!("From inside to outside: {}.", listed(&factors.collect::<Vec<_>>()))
}

/// The sets to be drawn, from the smallest factor on.
pub(crate) fn sets(family: &Family) -> Vec<Nested> {
    let ends = || family.breakpoints().iter().map(|breakpoint| &breakpoint.s);
    let (Some(least), Some(from), Some(to)) = (family.least(), ends().next(), ends().next_back()) else {
        return Vec::new();
    };
    let from = from.max(least);
    if from > to {
        return Vec::new();
    }
    let step = (to - from) * Rational::ratio(1, SETS - 1);
    let mut factors: Vec<Rational> = (0..SETS).map(|k| from + &step * Rational::from(k)).collect();
    factors.push(Rational::one());
    factors.retain(|factor| from <= factor && factor <= to);
    factors.sort();
    factors.dedup();
    let set = |factor: Rational| Some(Nested { set: polyhedron(&family.at(&factor)?), factor });
    factors.into_iter().filter_map(set).collect()
}

/// The set of a section: of its vertices and rays, and without a vertex of its boundaries.
fn polyhedron(section: &Section) -> Polyhedron {
    if section.vertices.is_empty() {
        let below = section.boundaries.iter().map(|boundary| {
            let [a1, a2] =
                [boundary.normal.dx(), boundary.normal.dy()].map(|part| Rational::from(part.clone()));
            Inequality::new(a1, a2, boundary.offset.clone())
        });
        let below: Vec<Inequality> = below.collect();
        // A line is the boundary of the half-planes on both of its sides.
        let is_line = section.kind == RegionKind::Line;
        let other_sides: Vec<Inequality> = below
            .iter()
            .filter(|_| is_line)
            .map(|own| Inequality { a: own.a.each_ref().map(|a| -a), b: -&own.b })
            .collect();
        return Polyhedron::intersect(below.into_iter().chain(other_sides).collect());
    }
    let points = section.vertices.iter().map(|vertex| Point::new(&vertex.theta[0], &vertex.theta[1]));
    let rays = section.rays.iter().cloned().map(Generator::Ray);
    points.map(Generator::Point).chain(rays).collect::<Generators>().polyhedron()
}

/// Writes the factor at the highest vertex; gives whether there is one to be seen.
fn name(panel: &mut Panel, nested: &Nested) -> bool {
    let places = region::places(panel, nested.set.region());
    let shows = |place: &[f64; 2]| place.iter().all(|coordinate| (0.0..=1.0).contains(coordinate));
    let highest = places.into_iter().filter(shows).max_by(|one, other| one[1].total_cmp(&other[1]));
    let Some(at) = highest else { return false };
    panel.text(at, shown("×", &nested.factor, Rounding::Nearest), Anchor { across: 0.4, up: 1.0 }, INK);
    true
}

/// A factor behind a sign, and another sign where digits are left out.
pub(crate) fn shown(sign: &str, factor: &Rational, rounding: Rounding) -> String {
    let about = if factor.exact_decimal(DIGITS).is_some() { "" } else { "≈ " };
    format!("{about}{sign}{}", labels::number(factor, DIGITS, rounding))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_set_as_given_is_seen_in_greys() {
        // The darkest area is that of all sets, one on another.
        let light = (1.0 - FILL.opacity).powi(SETS as i32 + 1);
        let paper = Fill { opacity: 1.0 - light, ..FILL }.grey_on_paper();
        let edge = Fill { colour: GIVEN.colour, opacity: 1.0 }.grey_on_paper();
        assert!(paper - edge >= 80.0, "{paper} {edge}");
    }
}
