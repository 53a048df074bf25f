//! The set between what linear programs in many directions see of it: the hull of the optimisers inside, the polygon of
//! the supporting half-planes outside.

use boundfit_check::{AskedDirections, Directions};
use boundfit_estimation::{Fit, Problem};
use boundfit_exact::english::counted;
use boundfit_exact::{Rational, Rounding};
use boundfit_geometry::{Inequality, Polyhedron, Region, Support, System};

use super::layout::{finished, main_frame, panel};
use super::sliver::Sliver;
use super::view::{self, Window};
use super::{empty, region};
use crate::clip::Place;
use crate::drawing::{Drawing, LegendEntry, Panel, Swatch};
use crate::figure::PlotOptions;
use crate::labels;
use crate::outside::unseen_sets;
use crate::page::Page;
use crate::palette::{Dash, FAINT_INK, Fill, GREY, INK, Mark, Shape, Stroke, VERMILLION, style};

const EXACT_FILL: Fill = Fill { colour: GREY, opacity: 0.28 };
const EXACT_EDGE: Stroke = Stroke::new(FAINT_INK, 1.2, Dash::Solid);
const INNER_EDGE: Stroke = Stroke { width: 1.8, ..style::SET_EDGE };
const INNER_FILL: Fill = Fill { opacity: 0.18, ..style::SET_FILL };
const OUTER_EDGE: Stroke = Stroke::new(VERMILLION, 1.5, Dash::Short);
const OUTER_FILL: Fill = Fill { colour: VERMILLION, opacity: 0.07 };
const EXACT_POINT: Mark = Mark::new(Shape::Diamond, 6.0, GREY);
const OPTIMISER: Mark = Mark::new(Shape::Disc, 3.4, INK);

/// The figure.
pub(crate) fn drawing(problem: &Problem, fit: &Fit, options: &PlotOptions) -> Drawing {
    let polyhedron = fit.fps.polyhedron();
    if polyhedron.region().is_empty() {
        return empty::drawing(problem, fit, options);
    }
    let asked = AskedDirections { count: options.directions, is_scaled: options.are_directions_scaled };
    let objectives = asked.objectives(polyhedron);
    let found = boundfit_check::directions_along(polyhedron, &objectives);
    let outer = outer(polyhedron, &objectives.coefficients);
    let page = Page::of(options);
    let names = labels::axes_of_parameters(problem, options);
    let sliver = Sliver::of(polyhedron.region());
    let mut main = panel(
        main_frame(usize::from(sliver.is_some()), page),
        &window(fit, &outer).asked_for(options),
        &names,
    );
    if !matches!(outer.region(), Region::Plane) {
        region::draw(&mut main, &outer, OUTER_FILL, OUTER_EDGE);
    }
    region::draw(&mut main, polyhedron, EXACT_FILL, EXACT_EDGE);
    if let ([point], Region::Point(_)) =
        (region::places(&main, polyhedron.region()).as_slice(), polyhedron.region())
    {
        main.mark(*point, EXACT_POINT);
    }
    let hull = found.inner.as_ref().map(|inner| inner.vertices.as_slice()).unwrap_or_default();
    let places: Vec<Place> = hull.iter().map(|theta| region::at(&main, theta)).collect();
    inner(&mut main, &places);
    let outside = places.iter().filter(|place| !main.shows(**place)).count();
    let mut panels = vec![main];
    let mut notes = notes(&found);
    if outside > 0 {
        let optimisers = counted(places.len(), "optimiser", "optimisers");
        notes.push(format!("Outside this view: {outside} of {optimisers}."));
    }
    notes.push(match found.is_scaled {
        true => "The directions are spread evenly where the PUI box is a square.".to_owned(),
        false => "The directions are spread evenly in the plane of θ₁ and θ₂.".to_owned(),
    });
    notes.extend(panels.first().and_then(|main| unseen_sets(main, [polyhedron].into_iter(), options)));
    if let Some(sliver) = sliver {
        panels.push(thin(sliver.panel(0, page), &sliver, polyhedron, &outer, hull));
        notes.push(Sliver::note("the exact set"));
    }
    let title = if hull.is_empty() && matches!(outer.region(), Region::Plane) {
        format!("The set is unbounded in each of {} directions", options.directions)
    } else {
        format!("The set between its inner and outer approximation from {} directions", options.directions)
    };
    finished(problem, options, title, panels, legend(options.directions), notes)
}

/// The intersection of the supporting half-planes of the set in all directions in which linear programs are solved.
fn outer(polyhedron: &Polyhedron, objectives: &[[Rational; 2]]) -> Polyhedron {
    let supporting = objectives.iter().filter_map(|objective| {
        let [c1, c2] = objective.each_ref().map(|c| -c);
        match polyhedron.support(&[c1.clone(), c2.clone()]) {
            Support::Bounded { proof, .. } => Some(Inequality::new(c1, c2, proof.value)),
            Support::Unbounded(_) | Support::Empty(_) => None,
        }
    });
    Polyhedron::intersect(System::new(supporting))
}

/// The set and, where it does not dwarf it, the outer polygon.
fn window(fit: &Fit, outer: &Polyhedron) -> Window {
    let window = view::of_set(fit);
    let corners = outer.bounding_box().as_ref().and_then(view::corners);
    match corners.filter(|corners| window.nearly_holds(corners, &Rational::one())) {
        Some([lower, upper]) => window.with(&lower).with(&upper).padded(&Rational::ratio(1, 25)),
        None => window,
    }
}

/// The hull of the optimisers with a mark on each.
fn inner(panel: &mut Panel, hull: &[Place]) {
    panel.area(hull, INNER_FILL);
    panel.outline(hull, INNER_EDGE);
    for place in hull {
        panel.mark(*place, OPTIMISER);
    }
}

fn thin(
    mut panel: Panel,
    sliver: &Sliver,
    exact: &Polyhedron,
    outer: &Polyhedron,
    hull: &[[Rational; 2]],
) -> Panel {
    let places = |panel: &Panel, points: &[[Rational; 2]]| -> Vec<Place> {
        points.iter().filter_map(|theta| sliver.place(panel, theta)).collect()
    };
    let vertices = |polyhedron: &Polyhedron| -> Vec<[Rational; 2]> {
        polyhedron.region().vertices().iter().map(|vertex| vertex.point().coordinates()).collect()
    };
    if outer.region().is_bounded() {
        let outline = places(&panel, &vertices(outer));
        panel.area(&outline, OUTER_FILL);
        panel.outline(&outline, OUTER_EDGE);
    }
    let outline = places(&panel, &vertices(exact));
    panel.area(&outline, EXACT_FILL);
    panel.outline(&outline, EXACT_EDGE);
    let hull = places(&panel, hull);
    inner(&mut panel, &hull);
    panel
}

fn legend(count: usize) -> Vec<LegendEntry> {
    vec![
        LegendEntry::new(Swatch::area(EXACT_FILL, EXACT_EDGE), "exact set"),
        LegendEntry::new(Swatch::mark(EXACT_POINT), "exact set"),
        LegendEntry::new(Swatch::area(INNER_FILL, INNER_EDGE), "inner: hull of the optimisers"),
        LegendEntry::new(Swatch::mark(OPTIMISER), "optimiser"),
        LegendEntry::new(
            Swatch::area(OUTER_FILL, OUTER_EDGE),
            format!("outer: {count} supporting half-planes"),
        ),
    ]
}

fn notes(found: &Directions) -> Vec<String> {
    let mut notes = Vec::new();
    // No set within the exact one is said to be as large, and none around it to be no larger.
    let part = |area: Option<&Rational>, rounding| {
        let part = area?.checked_div(found.exact.area.as_ref()?)?;
        Some(labels::number(&(part * Rational::from(100)), 4, rounding))
    };
    let inner = part(found.inner.as_ref().and_then(|inner| inner.area.as_ref()), Rounding::Down);
    let outer = part(found.outer.as_ref().and_then(|outer| outer.area.as_ref()), Rounding::Up);
    if let (Some(inner), Some(outer)) = (inner, outer) {
        notes.push(format!("Inner area: {inner} % of the exact one. Outer area: {outer} %."));
    }
    if found.unbounded > 0 && found.unbounded < found.count {
        notes.push(format!("The set is unbounded in {} of the {} directions.", found.unbounded, found.count));
    }
    notes
}
