//! Figures of the data plane: above, readings and bands of lines; below, the residuals of one line. The residuals
//! show an error bound that is small against the range of the readings.

mod bands;
mod boxes;
mod density;
mod frames;
mod readings;
mod runs;
mod sample;
mod scene;
mod several;
#[cfg(test)]
mod tests;
mod view;

use boundfit_estimation::{ErrorBound, Family, Fit, Problem};
use boundfit_exact::Rational;
use boundfit_exact::english::counted;

use crate::drawing::{Drawing, Frame, LegendEntry, Panel, Swatch};
use crate::figure::{Figure, PlotOptions};
use crate::labels::{self, Conflict};
use crate::outside::Outside;
use crate::palette::{Dash, FAINT_INK, Stroke, style};
use crate::parameter_plane::nested;
use crate::render::BOTTOM_LABELS;
use bands::Bands;
pub(crate) use boxes::boxes;
use frames::{are_side_by_side, frames};
pub(crate) use runs::runs;
use scene::{Reference, Scene};
pub(crate) use several::{panels, several};
use view::View;

/// A figure of the data plane.
pub(crate) fn drawing(problem: &Problem, fit: &Fit, figure: Figure, options: &PlotOptions) -> Drawing {
    let scene = Scene::new(problem, fit, figure, options);
    let bands = Bands::new(&scene);
    let notes = notes(&scene, &bands);
    drawing_of(&scene, &bands, title(&scene), notes)
}

/// The corridors of the sets of a family, one in another; `None` where no factor of it leaves any parameters.
pub(crate) fn nested(
    problem: &Problem,
    fit: &Fit,
    family: &Family,
    options: &PlotOptions,
) -> Option<Drawing> {
    let sets = nested::sets(family);
    let (first, last) = (sets.first()?, sets.last()?);
    let scene = Scene::new(problem, fit, Figure::Corridor, options);
    let bands = Bands::nested(&scene, sets.iter().map(|own| (&own.set, own.factor == Rational::one())));
    let mut notes = notes(&scene, &bands);
    notes.push(nested::in_order(&sets));
    notes.extend(nested::nothing_below(family));
    let title = match first.factor == last.factor {
        true => "Corridor under a multiple of all error bounds",
        false => "Corridors under growing error bounds",
    };
    Some(drawing_of(&scene, &bands, title.to_owned(), notes))
}

/// Both panels and what stands around them.
fn drawing_of(scene: &Scene, bands: &Bands, title: String, mut notes: Vec<String>) -> Drawing {
    let (problem, options) = (scene.problem, scene.options);
    let frames = frames(options);
    let names = [labels::abscissa(problem, options), labels::response(problem, options)];
    let whole = View { scene, reference: None };
    let mut panels = vec![panel(&whole, bands, frames[0], names)];
    // Where residuals stand beside them, the readings have the first panel.
    let first = if scene.reference.is_some() { "the first panel" } else { "this view" };
    notes.extend(whole.outside(&panels[0]).and_then(|found| found.note(&panels[0], first)));
    if let Some(reference) = &scene.reference {
        let view = View { scene, reference: Some(reference) };
        let names = [labels::abscissa(problem, options), labels::residual(options)];
        let mut distances = panel(&view, bands, frames[1], names);
        if let Some(Outside { outside, count, .. }) = view.outside(&distances)
            && outside > 0
            && scene.options.x_range.is_none()
        {
            let of = counted(count, "residual", "residuals");
            notes.push(format!("Outside the panel of residuals: {outside} of {of}."));
        }
        if bands.go_beyond(&view, &distances) {
            notes.push("The band goes on beyond this view.".to_owned());
        }
        distances.heading = format!("residuals of the {}", reference.name);
        panels.push(distances);
        match options.flip {
            false => panels[0].labelled[0] = false,
            true if are_side_by_side(options) => panels[1].labelled[1] = false,
            true => {}
        }
    }
    let last = panels.last().map_or(frames[0], |panel| panel.frame);
    Drawing {
        title,
        subtitle: labels::subtitle(problem, options),
        description: description(scene, &notes),
        height: last.top + last.height + BOTTOM_LABELS + 8.0,
        panels,
        legend: legend(scene, bands),
        notes,
    }
}

/// One panel with everything on it, from the back to the front.
fn panel(view: &View, bands: &Bands, frame: Frame, names: [String; 2]) -> Panel {
    let scene = view.scene;
    let axes = view.axes(frame, names, &bands.extent(view));
    let mut panel = Panel::new(frame, axes, scene.options.flip);
    view.interval_of_fitted_rows(&mut panel);
    let bars = readings::bars(view, &panel);
    readings::shade(view, &mut panel, &bars);
    density::draw(view, &mut panel);
    // Readings that are as dense as a wall would hide the lines behind it.
    let is_wall = scene.is_dense() && !scene.is_crowded();
    if is_wall {
        readings::draw(view, &mut panel, &bars, &[false]);
    }
    bands.draw(view, &mut panel);
    view.lines(&mut panel);
    readings::draw(view, &mut panel, &bars, if is_wall { &[true] } else { &[false, true] });
    panel
}

fn title(scene: &Scene) -> String {
    let empty = scene.fit.fps.polyhedron().region().is_empty();
    let line = scene.is_line();
    let text = match scene.figure {
        Figure::Data if empty => return title_of_empty(scene),
        Figure::Data => {
            let reference =
                scene.reference.as_ref().map(|reference| format!("Readings and {}", reference.name));
            return reference.unwrap_or_else(|| "Readings".to_owned());
        }
        Figure::Eui if scene.fit.eui().is_none() => "No EUI",
        Figure::Eui if line => "Lines with parameters in the EUI box",
        Figure::Eui => "Fits with parameters in the EUI box",
        Figure::Pui if empty => "No PUI: the feasible parameter set is empty",
        Figure::Pui if line => "Lines with parameters in the PUI box",
        Figure::Pui => "Fits with parameters in the PUI box",
        _ if empty => "No corridor: the feasible parameter set is empty",
        _ if line => "Corridor of all feasible lines inside the band of the PUI box",
        _ => "Range of all feasible fits inside that of the PUI box",
    };
    text.to_owned()
}

/// Returns the title when no parameters are left: the bounds that contradict each other.
fn title_of_empty(scene: &Scene) -> String {
    let Conflict { rows, conditions, .. } = &scene.conflict;
    let nothing = if scene.is_line() { "no line" } else { "no parameters" };
    match (rows.is_empty(), conditions.len()) {
        (true, 1) => format!("Readings, and a condition that {nothing} can meet"),
        (true, _) => "Readings, and conditions that contradict each other".to_owned(),
        (false, 0) => format!("Readings that {nothing} can explain"),
        (false, _) => format!("Readings and conditions that {nothing} can meet together"),
    }
}

fn description(scene: &Scene, notes: &[String]) -> String {
    let Scene { problem, options, .. } = scene;
    let options = &labels::described(options);
    let [up, across] = [labels::response(problem, options), labels::abscissa(problem, options)];
    let mut sentences = vec![format!("First panel: {up} against {across}.")];
    if let Some(reference) = &scene.reference {
        sentences.push(format!("Second panel: the residuals of the {}.", reference.name));
    }
    let measurements = &problem.measurements;
    let drawn = if measurements.is_of_reductions() { measurements.shown() } else { measurements.fitted() };
    let fitted = counted(drawn, "reading", "readings");
    sentences.push(match problem.measurements.others().len() {
        others if others > 0 && scene.figure != Figure::Corridor => {
            format!("Fitted, with error bars: {fitted}. Not fitted: {others}.")
        }
        _ => format!("Fitted, with error bars: {fitted}."),
    });
    sentences.extend(notes.iter().cloned());
    sentences.join(" ")
}

/// Returns the meaning of the bar of a reading.
fn bar_name(problem: &Problem) -> &'static str {
    match problem.measurements.error_bound() {
        ErrorBound::Uniform(epsilon) if epsilon.is_zero() => "reading (ε = 0)",
        ErrorBound::Interval { .. } => "bounds of a reading",
        bound if bound.has_middles() => "reading with its bounds",
        _ => "reading ± ε",
    }
}

fn legend(scene: &Scene, bands: &Bands) -> Vec<LegendEntry> {
    let mut entries = Vec::new();
    let dense = scene.is_dense();
    let (bar, mark) = readings::style_of_fitted(dense);
    entries.push(LegendEntry::new(Swatch::bar(bar, mark), bar_name(scene.problem)));
    let all = "from the lowest to the highest reading, with ε";
    entries.push(LegendEntry::new(Swatch::inside(style::ALL_READINGS), all));
    entries.extend(density::legend());
    if !scene.conflict.rows.is_empty() {
        let text = format!("contradicting: {}", scene.conflict.names());
        entries.push(LegendEntry::new(Swatch::bar(style::CONFLICT_BAR, style::CONFLICT), text));
    }
    if scene.readings.iter().any(|shown| !shown.fitted) {
        entries.push(LegendEntry::new(
            Swatch::mark(readings::style_of_other(dense)),
            "reading that is not fitted",
        ));
        let interval = Stroke::new(FAINT_INK, 0.9, Dash::Short);
        entries.push(LegendEntry::new(Swatch::line(interval), "interval of the fitted rows"));
    }
    if let Some(Reference { name, stroke, .. }) = &scene.reference {
        entries.push(LegendEntry::new(Swatch::line(*stroke), *name));
    }
    entries.extend(bands.legend(scene));
    entries
}

/// Remarks on what cannot be seen.
fn notes(scene: &Scene, bands: &Bands) -> Vec<String> {
    let mut notes = Vec::new();
    if !scene.conflict.bounds.is_empty() {
        notes.push(scene.conflict.sentence());
    }
    if scene.figure == Figure::Eui {
        notes.extend(labels::why_no_eui(scene.fit));
    }
    notes.extend(bands.notes());
    let measurements = &scene.problem.measurements;
    if measurements.is_of_reductions() {
        let all = counted(measurements.fitted(), "reading", "readings");
        notes.push(format!(
            "Drawn are {} of {all}: the data are a reduction, which keeps no others.",
            measurements.shown()
        ));
    }
    if scene.is_crowded() {
        let others = if scene.readings.iter().all(|shown| shown.fitted) {
            ""
        } else {
            ", and of those not fitted the extreme ones of every three pixels"
        };
        notes.push(format!(
            "{}, counted in squares of 3 pixels; marked are those that fix the set{others}.",
            counted(scene.count, "reading", "readings")
        ));
    }
    notes
}
