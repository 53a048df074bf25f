//! The feasible parameter set with its boxes and estimates.

use boundfit_estimation::{Fit, Problem};
use boundfit_exact::{Endpoint, Interval, Rational, Rounding};
use boundfit_geometry::{Region, RegionKind};

use super::layout::{finished, main_frame, panel, side_frame};
use super::marks::{self, Estimate};
use super::sliver::Sliver;
use super::view;
use super::{empty, region};
use crate::drawing::{Drawing, LegendEntry, Panel, Swatch};
use crate::figure::PlotOptions;
use crate::labels;
use crate::outside::{unseen_sets, without_end};
use crate::page::Page;
use crate::palette::{Mark, style};

/// The figure.
pub(crate) fn drawing(problem: &Problem, fit: &Fit, options: &PlotOptions) -> Drawing {
    let polyhedron = fit.fps.polyhedron();
    if polyhedron.region().is_empty() {
        return empty::drawing(problem, fit, options);
    }
    let page = Page::of(options);
    let names = labels::parameters(problem, options);
    let estimates = marks::estimates(problem, fit);
    let eui = fit.eui();
    let mut window = view::of_set(fit);
    let eui_corners = eui.and_then(view::corners).filter(|[lower, upper]| lower != upper);
    let eui_fits =
        eui_corners.as_ref().is_none_or(|corners| window.nearly_holds(corners, &Rational::ratio(1, 2)));
    if let Some([lower, upper]) = eui_corners.as_ref().filter(|_| eui_fits) {
        let part = Rational::ratio(1, 20);
        window = window.with(lower).with(upper).padded(&part);
    }
    let sliver = Sliver::of(polyhedron.region());
    let overview = eui_corners.clone().filter(|_| !eui_fits);
    let beside = usize::from(sliver.is_some()) + usize::from(overview.is_some());
    let axes = labels::axes_of_parameters(problem, options);
    let mut main = panel(main_frame(beside, page), &window.clone().asked_for(options), &axes);
    let numbered = sliver.is_none();
    let content = Content { eui: eui_fits && eui_corners.is_some(), main: true, numbered };
    let mut legend = contents(&mut main, fit, &estimates, content);
    let mut panels = vec![main];
    if let Some([lower, upper]) = overview {
        let around = window.with(&lower).with(&upper).padded(&Rational::ratio(1, 12));
        let mut side = panel(side_frame(0, page), &around, &names);
        side.heading = "EUI box".to_owned();
        contents(&mut side, fit, &estimates, Content { eui: true, main: false, numbered: false });
        panels.push(side);
        legend.push(LegendEntry::new(Swatch::area(style::EUI_FILL, style::EUI_EDGE), "EUI box"));
    }
    let mut notes: Vec<String> =
        fit.pui_intervals().and_then(|intervals| pui_note(&intervals, &names)).into_iter().collect();
    if let Some(sliver) = sliver {
        panels.push(thin(sliver.panel(panels.len() - 1, page), &sliver, fit, &estimates));
        notes.push(Sliver::note("the set"));
    }
    notes.extend(panels.first().and_then(|main| unseen_sets(main, [polyhedron].into_iter(), options)));
    notes.extend(marks::outside_note(&panels, &estimates));
    notes.extend(labels::why_no_eui(fit));
    if polyhedron.region().kind() == RegionKind::Plane {
        notes.push("Every parameter pair is feasible.".to_owned());
    } else {
        notes.extend(without_end([polyhedron.region()].into_iter()));
    }
    let title = format!("Feasible parameter set: {}", kind(polyhedron.region()));
    finished(problem, options, title, panels, legend, notes)
}

/// The content of a panel: the EUI box, and whether all vertices and estimates are marked, and numbered.
#[derive(Clone, Copy)]
struct Content {
    eui: bool,
    main: bool,
    numbered: bool,
}

/// Boxes, set and estimates on a panel; gives the legend.
fn contents(panel: &mut Panel, fit: &Fit, estimates: &[Estimate], content: Content) -> Vec<LegendEntry> {
    let Content { eui, main, numbered } = content;
    let polyhedron = fit.fps.polyhedron();
    let region_kind = polyhedron.region().kind();
    let mut legend = Vec::new();
    let set = match region_kind {
        RegionKind::Point if main => Swatch::mark(style::POINT),
        RegionKind::Point => Swatch::mark(style::VERTEX),
        RegionKind::Segment | RegionKind::Ray | RegionKind::Line => Swatch::line(style::SET_EDGE),
        _ => Swatch::area(style::SET_FILL, style::SET_EDGE),
    };
    legend.push(LegendEntry::new(set, "feasible parameter set (FPS)"));
    if let Some(intervals) = fit.eui().filter(|_| eui) {
        marks::draw_box(panel, intervals, Some(style::EUI_FILL), style::EUI_EDGE);
        legend.push(LegendEntry::new(Swatch::area(style::EUI_FILL, style::EUI_EDGE), "EUI box"));
    }
    region::draw(panel, polyhedron, style::SET_FILL, style::SET_EDGE);
    let pui = fit.pui_intervals().filter(|intervals| {
        intervals
            .iter()
            .any(|interval| interval.lower().value().is_some() || interval.upper().value().is_some())
    });
    if let Some(intervals) = pui.filter(|_| region_kind != RegionKind::Point) {
        marks::draw_box(panel, &intervals, None, style::PUI_EDGE);
        legend.push(LegendEntry::new(Swatch::line(style::PUI_EDGE), "PUI box"));
    }
    if main {
        marks::draw_vertices(panel, polyhedron.region(), numbered);
        legend.extend(marks::draw_estimates(panel, estimates));
        if let (RegionKind::Point, [at]) =
            (region_kind, region::places(panel, polyhedron.region()).as_slice())
        {
            panel.mark(*at, style::POINT);
        }
    } else {
        mark_if_tiny(panel, fit);
        let small: Vec<Estimate> = estimates
            .iter()
            .filter(|estimate| estimate.mark == style::LEAST_SQUARES_MARK)
            .map(|estimate| Estimate {
                theta: estimate.theta.clone(),
                mark: Mark { radius: estimate.mark.radius * 0.8, ..estimate.mark },
                name: estimate.name.clone(),
            })
            .collect();
        marks::draw_estimates(panel, &small);
    }
    legend
}

/// A set that is too small for a panel shows as a dot.
fn mark_if_tiny(panel: &mut Panel, fit: &Fit) {
    const LEAST: f64 = 6.0;
    let Some([lower, upper]) = fit.pui_intervals().as_ref().and_then(view::corners) else { return };
    let [from, to] = [region::at(panel, &lower), region::at(panel, &upper)];
    let across = (to[0] - from[0]) * panel.frame.width;
    let up = (to[1] - from[1]) * panel.frame.height;
    if across.max(up) < LEAST {
        panel.mark(from, style::VERTEX);
    }
}

/// A thin set in its principal axes.
fn thin(panel: Panel, sliver: &Sliver, fit: &Fit, estimates: &[Estimate]) -> Panel {
    let mut panel = marks::thin(panel, sliver, [fit.fps.polyhedron().region()].into_iter());
    for Estimate { theta, mark, .. } in estimates.iter().rev() {
        if let Some(at) = sliver.place(&panel, theta) {
            panel.mark(at, *mark);
        }
    }
    panel
}

/// The kind of a set in words: `polygon with 6 vertices`.
pub(super) fn kind(region: &Region) -> String {
    let name = region.kind().name();
    match region.kind() {
        RegionKind::Polygon | RegionKind::UnboundedPolygon => {
            let count = region.vertices().len();
            let noun = if count == 1 { "vertex" } else { "vertices" };
            format!("{} with {count} {noun}", name.replace('-', " "))
        }
        RegionKind::Empty => name.to_owned(),
        RegionKind::Plane => "the whole plane".to_owned(),
        _ => format!("a {name}"),
    }
}

/// Significant digits of the ends of intervals.
const DIGITS: usize = 5;

/// The parameter uncertainty intervals in words; nothing when they are unbounded on all sides.
pub(super) fn pui_note(intervals: &[Interval; 2], names: &[String; 2]) -> Option<String> {
    let ends = || {
        intervals.iter().flat_map(|interval| [interval.lower(), interval.upper()]).filter_map(Endpoint::value)
    };
    ends().next()?;
    let rounded = |end: &Rational| end.exact_decimal(DIGITS).is_none();
    let text = |end: &Endpoint, digits, rounding, unbounded: &str| {
        end.value().map_or_else(|| unbounded.to_owned(), |value| labels::number(value, digits, rounding))
    };
    let each = [0, 1].map(|j| {
        let digits = intervals[j].resolving_digits(DIGITS);
        let (symbol, unit) = names[j].split_once(' ').unwrap_or((&names[j], ""));
        let unit = unit.trim_matches(['[', ']']);
        if let Some((value, _)) = intervals[j].ends().filter(|(lower, upper)| lower == upper) {
            let sign = if rounded(value) { "≈" } else { "=" };
            let value = labels::number(value, DIGITS, Rounding::Nearest);
            return format!("{symbol} {sign} {value} {unit}").trim_end().to_owned();
        }
        let lower = text(intervals[j].lower(), digits, Rounding::Down, "−∞");
        let upper = text(intervals[j].upper(), digits, Rounding::Up, "∞");
        format!("{symbol} from {lower} to {upper} {unit}").trim_end().to_owned()
    });
    let has_width = |interval: &&Interval| interval.ends().is_none_or(|(lower, upper)| lower != upper);
    let outward =
        intervals.iter().filter(has_width).flat_map(|interval| [interval.lower(), interval.upper()]);
    let remark =
        if outward.filter_map(Endpoint::value).any(rounded) { " (ends rounded outward)" } else { "" };
    Some(format!("PUI: {}; {}{remark}.", each[0], each[1]))
}
