//! The diagram of statuses: residual across, leverage up, with its regions.

use std::collections::BTreeSet;

use boundfit_estimation::{Fit, Measurement, Problem};
use boundfit_exact::Rational;
use boundfit_exact::english::counted;
use boundfit_questions::{RowStatus, Standing, Status, Statuses};

use crate::axis::Axis;
use crate::clip::Place;
use crate::drawing::{Anchor, Drawing, Frame, LegendEntry, Panel, Swatch};
use crate::figure::PlotOptions;
use crate::labels;
use crate::page::Page;
use crate::palette::{
    BLUE, Colour, Dash, FAINT_INK, Fill, GREEN, INK, Mark, ORANGE, PURPLE, SKY, Shape, Stroke, VERMILLION,
};
use crate::render::{BOTTOM_LABELS, LEFT_LABELS};

// Each region is darker than the one before it, in greys too.
const INNER: Fill = Fill { colour: GREEN, opacity: 0.06 };
const OUTER: Fill = Fill { colour: SKY, opacity: 0.2 };
const STRICTLY: Fill = Fill { colour: ORANGE, opacity: 0.32 };
const OUTLYING: Fill = Fill { colour: PURPLE, opacity: 0.38 };
const BORDER: Stroke = Stroke::new(FAINT_INK, 1.1, Dash::Long);
const OTHERS: Mark = Mark::new(Shape::Disc, 2.6, INK);
const DECIDING: Mark = Mark::new(Shape::Diamond, 4.6, BLUE);
const MENDING: Mark = Mark::new(Shape::Diamond, 4.6, VERMILLION);
const FAR: Mark = Mark::new(Shape::Triangle, 5.2, VERMILLION);
/// The view goes no farther than this. A reading beyond it is shown at the edge of the region of its status.
const FARTHEST: [i64; 2] = [6, 4];
/// The distance from the edge of the view to the middle of a mark there, in pixels.
const FAR_MARGIN: i64 = 7;
/// The number of readings that get a label where there is room.
const MOST_LABELS: usize = 24;
/// The approximate room of a letter, in pixels of the nominal size.
const LETTER: f64 = 7.0;
const LINE: f64 = 14.0;

/// A reading in the diagram.
struct Spot {
    row: usize,
    at: [Rational; 2],
    mark: Mark,
}

/// The figure: every reading against the set of the others, and of a set that is empty those without which it is not.
pub(crate) fn drawing(problem: &Problem, fit: &Fit, options: &PlotOptions) -> Drawing {
    let judged = judged(problem, fit);
    let (spots, unplaced) = spots(&judged, fit.is_empty());
    let mut panel = panel(&spots, options);
    let mut taken = regions(&mut panel);
    let far = mark(&mut panel, &spots, &mut taken);
    let line = |fill: Fill, text: &str| LegendEntry::new(Swatch::area(fill, BORDER), text);
    let legend = vec![
        line(INNER, "inner: |r| < 1 − l"),
        line(OUTER, "outer: 1 − l < |r| ≤ 1 + l, it cuts the set"),
        line(STRICTLY, "strictly outer: and l > 1"),
        line(OUTLYING, "outlier: |r| > 1 + l, it leaves nothing"),
        LegendEntry::new(Swatch::mark(OTHERS), "reading that can go: the set stays the same"),
        LegendEntry::new(Swatch::mark(DECIDING), "reading that decides the set"),
        LegendEntry::new(Swatch::mark(MENDING), "reading without which alone something is left"),
        LegendEntry::new(Swatch::mark(FAR), "farther out than shown"),
    ];
    let title = match fit.is_empty() {
        true => "Statuses: no parameters agree with all readings".to_owned(),
        false => "Statuses of readings against the set of the others".to_owned(),
    };
    let mut notes = notes(&judged, far, unplaced, fit.is_empty());
    if fit.is_empty() {
        notes.insert(0, labels::Conflict::of(problem, fit).sentence());
    }
    Drawing {
        description: format!(
            "{title}. Horizontal axis: residual r. Vertical axis: leverage. {}",
            notes.join(" ")
        ),
        title,
        subtitle: labels::subtitle(problem, options),
        height: panel.frame.top + panel.frame.height + BOTTOM_LABELS + 8.0,
        panels: vec![panel],
        legend,
        notes,
    }
}

/// Every reading with its status, in the order of rows; none where not all are in memory.
fn judged(problem: &Problem, fit: &Fit) -> Vec<(RowStatus, bool)> {
    let Some(statuses) = Statuses::of(problem, fit) else { return Vec::new() };
    let deciding: BTreeSet<usize> = statuses.deciding().collect();
    let judged = |reading: &Measurement| (statuses.status(reading), deciding.contains(&reading.row));
    problem.measurements.kept().iter().map(judged).collect()
}

/// Returns the places of readings, the most important first, and the number of readings without a place.
fn spots(judged: &[(RowStatus, bool)], is_empty: bool) -> (Vec<Spot>, usize) {
    let mut spots: Vec<(Status, Option<Rational>, Spot)> = Vec::new();
    let mut unplaced = 0;
    for (status, is_deciding) in judged {
        let Some(standing) = &status.without else { continue };
        let Standing { leverage: Some(leverage), residual: Some(residual), .. } = standing else {
            unplaced += 1;
            continue;
        };
        let mark = match is_deciding {
            true if is_empty => MENDING,
            true => DECIDING,
            false => OTHERS,
        };
        let at = [residual.clone(), leverage.clone()];
        spots.push((standing.status, standing.margin(), Spot { row: status.row, at, mark }));
    }
    spots.sort_by(|one, other| other.0.cmp(&one.0).then_with(|| one.1.cmp(&other.1)));
    (spots.into_iter().map(|(_, _, spot)| spot).collect(), unplaced)
}

/// Axes that show the corners of all regions, and readings that are not too far.
fn panel(spots: &[Spot], options: &PlotOptions) -> Panel {
    let reach = |axis: usize, least: Rational| {
        let values = spots.iter().map(|spot| spot.at[axis].abs());
        let most = values.filter(|value| *value <= Rational::from(FARTHEST[axis])).max().unwrap_or_default();
        least.max(most * Rational::ratio(11, 10))
    };
    let up = reach(1, Rational::ratio(7, 5));
    // Outliers have their region at every height, also those at the edge.
    let across = reach(0, &up + Rational::one());
    let lower = -(&up * Rational::ratio(1, 40));
    let page = Page::of(options);
    let width = page.width - LEFT_LABELS - 38.0;
    let frame = Frame { left: LEFT_LABELS + 16.0, top: 24.0, width, height: page.height(430.0) };
    let [residual, leverage] = labels::asked_for(options, ["residual r".to_owned(), "leverage l".to_owned()]);
    let axes = [
        Axis::new(residual, &-&across, &across, (frame.width / 75.0) as usize),
        Axis::new(leverage, &lower, &up, (frame.height / 40.0) as usize),
    ];
    Panel::new(frame, axes, false)
}

/// Returns the place of a point of whole numbers.
fn at(panel: &Panel, across: i64, up: i64) -> Place {
    panel.place([&Rational::from(across), &Rational::from(up)])
}

/// Fills the regions, draws what lies between them and names them; gives the room that names take.
fn regions(panel: &mut Panel) -> Vec<[f64; 4]> {
    const FAR_OUT: i64 = 50;
    let place = |across: i64, up: i64| at(panel, across, up);
    let (top, left, right) = (place(0, 1), place(-1, 0), place(1, 0));
    let [high_left, high_right] = [place(-1 - FAR_OUT, FAR_OUT), place(1 + FAR_OUT, FAR_OUT)];
    let [one_left, one_right] = [place(-2, 1), place(2, 1)];
    let [corner_left, corner_right] = [place(-FAR_OUT, 0), place(FAR_OUT, 0)];
    panel.area(&[left, right, top], INNER);
    panel.area(&[right, one_right, top], OUTER);
    panel.area(&[left, top, one_left], OUTER);
    panel.area(&[one_left, one_right, high_right, high_left], STRICTLY);
    panel.area(&[right, corner_right, high_right], OUTLYING);
    panel.area(&[left, high_left, corner_left], OUTLYING);
    panel.line(&[left, top, right], BORDER);
    panel.line(&[left, high_left], BORDER);
    panel.line(&[right, high_right], BORDER);
    panel.line(&[one_left, one_right], Stroke::new(FAINT_INK, 1.1, Dash::Dots));
    panel.line(&[corner_left, corner_right], Stroke::new(FAINT_INK, 0.8, Dash::Solid));
    let half = |one: Place, other: Place| [(one[0] + other[0]) / 2.0, (one[1] + other[1]) / 2.0];
    let middle_top = [top[0], (top[1] + 1.0) / 2.0];
    let names = [
        (half(top, half(left, right)), "inner"),
        (half(half(right, one_right), top), "outer"),
        (half(half(left, one_left), top), "outer"),
        (middle_top, "strictly outer"),
        ([0.96 - 0.02, right[1] + 0.12], "outlier"),
        ([0.06, right[1] + 0.12], "outlier"),
    ];
    let mut taken = Vec::new();
    for (place, name) in names {
        panel.text(place, name, Anchor { across: 0.0, up: 0.0 }, FAINT_INK);
        taken.push(room(panel.frame, place, name, [0.0, 0.0]));
    }
    taken
}

/// The room of a text in pixels: left, bottom, right, top.
fn room(frame: Frame, place: Place, text: &str, towards: [f64; 2]) -> [f64; 4] {
    let (width, height) = (LETTER * text.chars().count() as f64, LINE);
    let x = place[0] * frame.width + towards[0] * (width / 2.0 + 6.0);
    let y = place[1] * frame.height + towards[1] * (height / 2.0 + 6.0);
    [x - width / 2.0, y - height / 2.0, x + width / 2.0, y + height / 2.0]
}

/// The largest residual and leverage at which a mark is wholly on the panel.
fn farthest(panel: &Panel) -> [Rational; 2] {
    let lengths = [panel.frame.width, panel.frame.height];
    let [across, up] = panel.coordinates();
    [(across, lengths[0]), (up, lengths[1])].map(|(axis, length)| {
        let margin = axis.width() * Rational::ratio(FAR_MARGIN, (length as i64).max(1));
        axis.lower() + axis.width() - margin
    })
}

/// Moves a residual and a leverage as near as these largest ones, within the region of their status. Only outliers and strictly outer
/// readings are far: the other regions are bounded, and wholly in view.
fn drawn_in([residual, leverage]: &[Rational; 2], [across, up]: &[Rational; 2]) -> [Rational; 2] {
    let one = Rational::one();
    if residual.abs() > leverage + &one {
        // Outliers have their region at every height: below the border of strictly outer readings.
        let size = residual.abs().min(across.clone());
        let border = &size - &one;
        let height = leverage.min(up).min(&(border * Rational::ratio(9, 10))).clone();
        return [if residual.is_negative() { -size } else { size }, height];
    }
    // Towards the corner of all regions a reading stays strictly outer.
    let shorter = |most: &Rational, own: &Rational| {
        most.checked_div(own).unwrap_or_else(Rational::one).min(Rational::one())
    };
    let part = shorter(across, &residual.abs()).min(shorter(&(up - &one), &(leverage - &one)));
    [residual * &part, (leverage - &one) * part + one]
}

/// Marks readings, those that matter most last and with their rows where there is room; gives how many are too far out.
fn mark(panel: &mut Panel, spots: &[Spot], taken: &mut Vec<[f64; 4]>) -> usize {
    let frame = panel.frame;
    let mut far = 0;
    let mut seen: BTreeSet<(i64, i64, bool)> = BTreeSet::new();
    let mut placed: Vec<(Place, Mark, usize)> = Vec::new();
    let most = farthest(panel);
    for spot in spots {
        let place = panel.place([&spot.at[0], &spot.at[1]]);
        let is_far = !panel.shows(place);
        far += usize::from(is_far);
        let place = match is_far {
            true => {
                let [residual, leverage] = drawn_in(&spot.at, &most);
                panel.place([&residual, &leverage])
            }
            false => place,
        };
        let mark = if is_far { FAR } else { spot.mark };
        // Points that no pixel shows are omitted.
        let pixel = |coordinate: f64, length: f64| (coordinate * length * 2.0) as i64;
        let cell = (pixel(place[0], frame.width), pixel(place[1], frame.height), mark == OTHERS);
        if seen.insert(cell) {
            placed.push((place, mark, spot.row));
        }
    }
    for (place, mark, _) in placed.iter().rev() {
        panel.mark(*place, *mark);
        let [x, y] = [place[0] * frame.width, place[1] * frame.height];
        taken.push([x - mark.radius, y - mark.radius, x + mark.radius, y + mark.radius]);
    }
    for (place, mark, row) in placed.iter().take(MOST_LABELS) {
        label(panel, *place, &row.to_string(), if *mark == OTHERS { INK } else { mark.colour }, taken);
    }
    far
}

/// Writes the row of a reading beside its mark, if there is room on some side.
fn label(panel: &mut Panel, place: Place, text: &str, colour: Colour, taken: &mut Vec<[f64; 4]>) {
    const SIDES: [[f64; 2]; 4] = [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]];
    let overlap = |one: &[f64; 4], other: &[f64; 4]| {
        one[0] < other[2] && other[0] < one[2] && one[1] < other[3] && other[1] < one[3]
    };
    let frame = panel.frame;
    let is_inside = |own: &[f64; 4]| {
        own[0] >= 2.0 && own[1] >= 2.0 && own[2] <= frame.width - 2.0 && own[3] <= frame.height - 2.0
    };
    let free = SIDES.into_iter().find(|&towards| {
        let own = room(frame, place, text, towards);
        is_inside(&own) && !taken.iter().any(|other| overlap(&own, other))
    });
    if let Some(towards) = free {
        taken.push(room(frame, place, text, towards));
        panel.text(place, text, Anchor { across: towards[0], up: towards[1] }, colour);
    }
}

/// Returns notes on the parts that the picture does not show.
fn notes(judged: &[(RowStatus, bool)], far: usize, unplaced: usize, is_empty: bool) -> Vec<String> {
    let mut notes = Vec::new();
    if is_empty {
        let nothing = judged.iter().filter(|(status, _)| status.without.is_none()).count();
        let readings = counted(nothing, "reading", "readings");
        notes.push(format!("The set is empty; without any single one of {readings} it is empty still."));
    } else {
        let count = |status: Status| {
            judged
                .iter()
                .filter(|(own, _)| own.without.as_ref().map(|own| own.status) == Some(status))
                .count()
        };
        let all = Status::ALL.into_iter().rev().map(|status| (count(status), status.name()));
        let words: Vec<String> =
            all.filter(|(count, _)| *count > 0).map(|(count, name)| format!("{count} {name}")).collect();
        notes.push(format!("{}.", words.join(", ")));
    }
    if far > 0 {
        notes.push(format!("{} farther out, shown at the edge.", counted(far, "reading", "readings")));
    }
    if unplaced > 0 {
        let readings = counted(unplaced, "reading", "readings");
        notes.push(format!(
            "Not shown: {readings} without leverage (one bound, no width, or values without an end)."
        ));
    }
    notes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn readings_far_out_are_drawn_in_the_region_of_their_status() {
        let number = |n: i64, d: i64| Rational::ratio(n, d);
        let [across, up] = [number(118, 50), number(68, 50)];
        let is_outlier = |[r, l]: &[Rational; 2]| r.abs() > l + Rational::one();
        for (residual, leverage) in
            [(-5, 8), (9, 8), (10, 8), (-40, 8), (7, 0), (-7, 1), (0, 99), (100, 99), (101, 99)]
        {
            let own = [Rational::from(residual), Rational::from(leverage)];
            let drawn = drawn_in(&own, &[across.clone(), up.clone()]);
            assert!(
                drawn[0].abs() <= across && drawn[1] <= up && !drawn[1].is_negative(),
                "{own:?}: {drawn:?}"
            );
            assert_eq!(is_outlier(&drawn), is_outlier(&own), "{own:?}: {drawn:?}");
            assert!(is_outlier(&own) || drawn[1] > Rational::one(), "{own:?}: {drawn:?}");
        }
    }

    #[test]
    fn regions_differ_in_greys() {
        let greys = [INNER, OUTER, STRICTLY, OUTLYING].map(Fill::grey_on_paper);
        assert!(greys.windows(2).all(|pair| pair[0] - pair[1] >= 8.0), "{greys:?}");
    }
}
