//! The feasible sets of several fits, in one panel or in one each.

use boundfit_exact::Rational;
use boundfit_exact::english::counted;
use boundfit_geometry::{Inequality, Polyhedron, Region, RegionKind};

use super::fps::kind;
use super::layout::{main_frame, panel};
use super::view::{self, Window};
use super::{marks, region};
use crate::drawing::{Drawing, Frame, LegendEntry, Panel, Swatch};
use crate::figure::PlotOptions;
use crate::labels;
use crate::outside::{unseen_sets, without_end};
use crate::page::Page;
use crate::palette::{Mark, Shape, Stroke, style};
use crate::render::BOTTOM_LABELS;
use crate::series::{self, Series, SeriesLook};

/// The figure of several sets in one panel.
pub(crate) fn several(all: &[Series], options: &PlotOptions) -> Drawing {
    let names = names(all, options);
    let window = window(all).asked_for(options);
    let mut main = panel(main_frame(0, Page::of(options)), &window, &names);
    // The first one is drawn last, above the others.
    let looks: Vec<SeriesLook> = SeriesLook::all().take(all.len()).collect();
    for (own, look) in all.iter().zip(&looks).rev() {
        region::draw(&mut main, own.fit.fps.polyhedron(), look.fill(), look.edge);
    }
    for (own, look) in all.iter().zip(&looks).rev() {
        mark_set(&mut main, own, *look);
    }
    let legend = all.iter().zip(looks).map(|(own, look)| entry(own, look)).collect();
    let common = match series::have_one_unit(all, options) {
        true => common(all),
        false => Some("Units differ: whether any parameters are in all sets is not asked.".to_owned()),
    };
    let mut notes: Vec<String> = common.into_iter().collect();
    if all.iter().any(|own| own.fit.central.is_some()) {
        notes.push("Marks: central estimates.".to_owned());
    }
    notes.extend(unseen_sets(&main, all.iter().map(|own| own.fit.fps.polyhedron()), options));
    notes.extend(without_end(regions(all)));
    let title = "Feasible parameter sets, compared".to_owned();
    let described = self::names(all, &labels::described(options));
    let told: Vec<String> = all.iter().map(told).collect();
    Drawing {
        description: format!(
            "{title}. Horizontal axis: {}. Vertical axis: {}. {}. {}",
            described[0],
            described[1],
            told.join("; "),
            notes.join(" ")
        ),
        title,
        subtitle: series::subtitle(all, options),
        height: main.frame.top + main.frame.height + BOTTOM_LABELS + 8.0,
        panels: vec![main],
        legend,
        notes,
    }
}

/// The names of both axes.
fn names(all: &[Series], options: &PlotOptions) -> [String; 2] {
    [0, 1].map(|j| {
        series::axis_name(all, options, |problem, own| labels::axes_of_parameters(problem, own)[j].clone())
    })
}

/// Marks the place of a set that is too small to be seen, or is one point: the central estimate.
fn mark_set(panel: &mut Panel, own: &Series, look: SeriesLook) {
    let region = own.fit.fps.polyhedron().region();
    if let (Region::Point(_), [at]) = (region, region::places(panel, region).as_slice()) {
        panel.mark(*at, Mark::new(Shape::Ring, 8.0, look.mark.colour));
    }
    if let Some(central) = &own.fit.central {
        panel.mark(region::at(panel, &central.theta), look.mark);
    }
}

/// A line of the legend, also for a set that is empty.
fn entry(own: &Series, look: SeriesLook) -> LegendEntry {
    let swatch = match own.fit.fps.polyhedron().region().kind() {
        RegionKind::Point => Swatch::mark(look.mark),
        RegionKind::Empty => Swatch::area(crate::palette::Fill { opacity: 0.0, ..look.fill() }, look.edge),
        RegionKind::Segment | RegionKind::Ray | RegionKind::Line => Swatch::line(look.edge),
        _ => Swatch::area(look.fill(), look.edge),
    };
    let mark = own.fit.central.as_ref().map(|_| look.mark);
    LegendEntry::staying(Swatch { mark, ..swatch }, told(own))
}

/// Returns the kind of a set, or the reason why there is none.
fn told(own: &Series) -> String {
    let region = own.fit.fps.polyhedron().region();
    match region.is_empty() {
        true => format!("{}: empty, {}", own.name(), own.conflict()),
        false => format!("{}: {}", own.name(), kind(region)),
    }
}

/// Returns whether some parameters are in all sets that are not empty.
fn common(all: &[Series]) -> Option<String> {
    let sets: Vec<&Polyhedron> =
        all.iter().map(|own| own.fit.fps.polyhedron()).filter(|set| !set.region().is_empty()).collect();
    let empty = all.len() - sets.len();
    if sets.len() < 2 {
        return None;
    }
    let bounds = sets.iter().flat_map(|set| {
        let own = set.irredundant();
        own.into_iter().filter_map(|index| set.system().half_plane(index).map(region::inequality))
    });
    let bounds: Vec<Inequality> = bounds.collect();
    let which = if empty > 0 { "all sets that are not empty" } else { "all of these sets" };
    let common = Polyhedron::intersect(bounds.into_iter().collect());
    Some(match common.region().is_empty() {
        true => format!("No parameters are in {which}."),
        false => format!("In {which}: {}.", kind(common.region())),
    })
}

/// The sets that are not empty.
fn regions<'a>(all: &'a [Series<'a>]) -> impl Iterator<Item = &'a Region> {
    all.iter().map(|own| own.fit.fps.polyhedron().region()).filter(|own| !own.is_empty())
}

/// A window that shows all sets, or of none the estimates.
fn window(all: &[Series]) -> Window {
    if regions(all).next().is_some() {
        return view::of_regions(regions(all), regions(all).count() > 1);
    }
    let estimates = all.iter().flat_map(|own| {
        let least_squares = own.fit.least_squares.as_ref().ok().map(|estimate| estimate.theta.clone());
        least_squares.into_iter().chain(own.fit.minimax.as_ref().map(|minimax| minimax.theta.clone()))
    });
    Window::around(&estimates.collect::<Vec<_>>()).padded(&Rational::ratio(1, 4))
}

/// A panel for each set, with axes that all of them share, and what the legend and the notes say.
pub(crate) fn panels(
    all: &[Series],
    frames: &[Frame],
    options: &PlotOptions,
) -> (Vec<Panel>, Vec<LegendEntry>, Vec<String>) {
    let window = window(all).asked_for(options);
    let names = names(all, options);
    let panels = all.iter().zip(frames).map(|(own, frame)| {
        let mut panel = panel(*frame, &window, &names);
        let polyhedron = own.fit.fps.polyhedron();
        region::draw(&mut panel, polyhedron, style::SET_FILL, EDGE);
        if let Some(intervals) = own.fit.pui_intervals().filter(|_| polyhedron.region().is_bounded()) {
            marks::draw_box(&mut panel, &intervals, None, style::PUI_EDGE);
        }
        let least_squares = own.fit.least_squares.as_ref().ok().map(|estimate| &estimate.theta);
        let estimates = [
            (least_squares, style::LEAST_SQUARES_MARK),
            (own.fit.central.as_ref().map(|central| &central.theta), style::CENTRAL_MARK),
        ];
        for (theta, mark) in estimates {
            let mark = Mark { radius: mark.radius * 0.75, ..mark };
            if let Some(theta) = theta {
                panel.mark(region::at(&panel, theta), mark);
            }
        }
        panel.heading = own.name();
        panel.finding = if polyhedron.region().is_empty() { ": empty" } else { "" };
        panel
    });
    let legend = vec![
        LegendEntry::new(Swatch::area(style::SET_FILL, EDGE), "feasible parameter set (FPS)"),
        LegendEntry::new(Swatch::line(style::PUI_EDGE), "PUI box"),
        LegendEntry::new(Swatch::mark(style::LEAST_SQUARES_MARK), "least squares"),
        LegendEntry::new(Swatch::mark(style::CENTRAL_MARK), "central estimate"),
    ];
    let empty = all.iter().filter(|own| own.fit.is_empty()).count();
    let mut notes: Vec<String> = without_end(regions(all)).into_iter().collect();
    if empty > 0 {
        notes
            .push(format!("No parameters agree with all readings of {}.", counted(empty, "group", "groups")));
    }
    (panels.collect(), legend, notes)
}

/// Thinner than in a panel of its own.
const EDGE: Stroke = Stroke { width: 1.2, ..style::SET_EDGE };
