//! Bands: how far the values of a set of parameters reach at every x, or at every row.

use std::borrow::Cow;

use boundfit_estimation::{Corridor, CorridorEdge, Measurement};
use boundfit_exact::{Endpoint, Interval, Rational};
use boundfit_geometry::{Polyhedron, Support};

use super::scene::Scene;
use super::view::View;
use crate::clip::Place;
use crate::drawing::{LegendEntry, Panel, Swatch};
use crate::extent::Extent;
use crate::figure::Figure;
use crate::palette::{BLUE, Dash, Fill, Mark, Shape, Stroke, style};
use crate::parameter_plane::nested;

/// The bands of a figure, from the back to the front.
#[derive(Default)]
pub(crate) struct Bands(Vec<Band>);

/// One band.
struct Band {
    name: Cow<'static, str>,
    fill: Fill,
    edge: Stroke,
    shape: BandShape,
}

enum BandShape {
    /// Bands between lines, piece by piece along x.
    Lines(Vec<BandPiece>),
    /// Bands between values, row by row.
    Rows(Vec<RowRange>),
}

/// A band between two lines (θ1, θ2) for x in [from, to]; `None` where nothing bounds it.
struct BandPiece {
    from: Rational,
    to: Rational,
    lower: Option<[Rational; 2]>,
    upper: Option<[Rational; 2]>,
}

/// The values of φ·θ at one row.
struct RowRange {
    measurement: Measurement,
    lower: Option<Rational>,
    upper: Option<Rational>,
}

impl Bands {
    /// The bands of a figure, along its whole axis of x.
    pub(crate) fn new(scene: &Scene) -> Self {
        let eui = || scene.fit.eui().cloned();
        let pui = || scene.fit.pui_intervals();
        let boxed = |name: &'static str, intervals: Option<[Interval; 2]>, fill, edge| {
            let shape = of_box(scene, &intervals?);
            Some(Band { name: name.into(), fill, edge, shape })
        };
        let bands = match scene.figure {
            Figure::Eui => vec![boxed("band of the EUI box", eui(), style::EUI_FILL, style::EUI_EDGE)],
            Figure::Pui => vec![boxed("band of the PUI box", pui(), style::PUI_FILL, style::PUI_EDGE)],
            Figure::Corridor => vec![
                boxed("band of the PUI box", pui(), style::PUI_FILL, style::PUI_EDGE),
                of_set(scene, scene.fit.fps.polyhedron()).map(|shape| Band {
                    name: match scene.is_line() {
                        true => "corridor of all feasible lines".into(),
                        false => "range of all feasible fits".into(),
                    },
                    fill: style::SET_FILL,
                    edge: style::SET_EDGE,
                    shape,
                }),
            ],
            _ => Vec::new(),
        };
        Bands::in_rows(scene, bands.into_iter().flatten().collect())
    }

    /// The corridors of sets, each in the next one, from the smallest on; `is_given` tells the one that is not a multiple.
    pub(crate) fn nested<'b>(
        scene: &Scene,
        sets: impl DoubleEndedIterator<Item = (&'b Polyhedron, bool)>,
    ) -> Self {
        let band = |(polyhedron, is_given): (&Polyhedron, bool)| {
            let (name, edge) = match is_given {
                true => ("corridor with error bounds as given", nested::GIVEN),
                false => ("corridor when all error bounds grow by a factor", nested::EDGE),
            };
            let shape = of_set(scene, polyhedron)?;
            Some(Band { name: name.into(), fill: nested::FILL, edge, shape })
        };
        Bands::in_rows(scene, sets.rev().filter_map(band).collect())
    }

    fn in_rows(scene: &Scene, mut bands: Vec<Band>) -> Self {
        if !scene.is_line() {
            // The edge at a row is too short for dashes.
            bands.iter_mut().for_each(|band| band.edge.dash = Dash::Solid);
        }
        Bands(bands)
    }

    /// Returns the extent of the bands where they are bounded.
    pub(crate) fn extent(&self, view: &View) -> Extent {
        let mut extent = Extent::default();
        for band in &self.0 {
            match &band.shape {
                BandShape::Lines(pieces) => {
                    for piece in pieces {
                        for line in [&piece.lower, &piece.upper].into_iter().flatten() {
                            let [slope, offset] = view.relative(line);
                            extent.include(&(&slope * &piece.from + &offset));
                            extent.include(&(&slope * &piece.to + &offset));
                        }
                    }
                }
                BandShape::Rows(rows) => {
                    for row in rows {
                        let reference = view.reference_at(&row.measurement);
                        let ends = [&row.lower, &row.upper].into_iter().flatten();
                        ends.for_each(|end| extent.include(&(end - &reference)));
                    }
                }
            }
        }
        extent
    }

    /// Returns whether a band goes on beyond the panel of a view.
    pub(crate) fn go_beyond(&self, view: &View, panel: &Panel) -> bool {
        let [_, up] = panel.coordinates();
        let upper = up.lower() + up.width();
        let extent = self.extent(view);
        extent.ends().is_some_and(|[least, greatest]| least < up.lower() || *greatest > upper)
    }

    /// Draws the bands of a view.
    pub(crate) fn draw(&self, view: &View, panel: &mut Panel) {
        for band in &self.0 {
            match &band.shape {
                BandShape::Lines(pieces) => {
                    pieces.iter().for_each(|piece| draw_piece(panel, view, piece, band.fill));
                    draw_edge(panel, view, pieces, |piece| piece.upper.as_ref(), band.edge);
                    draw_edge(panel, view, pieces, |piece| piece.lower.as_ref(), band.edge);
                }
                BandShape::Rows(rows) => {
                    rows.iter().for_each(|row| draw_row(panel, view, row, band));
                }
            }
        }
        if has_breakpoints(view.scene) {
            self.mark_breakpoints(view, panel);
        }
    }

    /// Marks the places where the edges of the corridor pass from one line to the next.
    fn mark_breakpoints(&self, view: &View, panel: &mut Panel) {
        let Some(corridor) = Corridor::new(view.scene.fit.fps.polyhedron()) else { return };
        for envelope in [&corridor.upper, &corridor.lower] {
            for (x, line) in envelope.breakpoints().iter().zip(envelope.lines()) {
                let [slope, offset] = view.relative(line);
                let place = panel.place([x, &(slope * x + offset)]);
                panel.mark(place, BREAKPOINT);
            }
        }
    }

    pub(crate) fn legend(&self, scene: &Scene) -> Vec<LegendEntry> {
        let mut entries: Vec<LegendEntry> = Vec::new();
        for band in &self.0 {
            let entry = LegendEntry::new(Swatch::area(band.fill, band.edge), band.name.clone());
            if !entries.contains(&entry) {
                entries.push(entry);
            }
        }
        if has_breakpoints(scene) {
            entries.push(LegendEntry::new(Swatch::line_and_mark(style::SET_EDGE, BREAKPOINT), "breakpoint"));
        }
        entries
    }

    /// Remarks on bands that go on without end.
    pub(crate) fn notes(&self) -> Vec<String> {
        let unbounded = |band: &&Band| match &band.shape {
            BandShape::Lines(pieces) => {
                pieces.iter().any(|piece| piece.lower.is_none() || piece.upper.is_none())
            }
            BandShape::Rows(rows) => rows.iter().any(|row| row.lower.is_none() || row.upper.is_none()),
        };
        let mut notes: Vec<String> = Vec::new();
        for band in self.0.iter().filter(unbounded) {
            let note = format!("Where it has no edge, the {} is unbounded.", band.name);
            if !notes.contains(&note) {
                notes.push(note);
            }
        }
        notes
    }
}

/// Returns whether the corridor of a figure has breakpoints to mark.
fn has_breakpoints(scene: &Scene) -> bool {
    scene.figure == Figure::Corridor
        && scene.is_line()
        && Corridor::new(scene.fit.fps.polyhedron()).is_some_and(|corridor| {
            [corridor.upper, corridor.lower].iter().any(|edge| !edge.breakpoints().is_empty())
        })
}

const BREAKPOINT: Mark = Mark::new(Shape::Disc, 3.2, BLUE);

/// The band of all θ in a box: at x > 0 its upper edge has the largest θ1, at x < 0 the smallest, always the largest θ2.
fn of_box(scene: &Scene, [first, second]: &[Interval; 2]) -> BandShape {
    let [start, end] = &scene.abscissas;
    let value = |end: &Endpoint| end.value().cloned();
    let line = |slope: &Endpoint, offset: &Endpoint| Some([value(slope)?, value(offset)?]);
    if !scene.is_line() {
        let ranges = scene.rows_with_room().map(|shown| {
            let phi = &shown.measurement.regressor;
            let reach = |upper: bool| {
                let part = |phi: &Rational, interval: &Interval| {
                    let end = if phi.is_negative() != upper { interval.upper() } else { interval.lower() };
                    if phi.is_zero() { Some(Rational::zero()) } else { Some(phi * &value(end)?) }
                };
                Some(part(&phi[0], first)? + part(&phi[1], second)?)
            };
            RowRange { measurement: shown.measurement.clone(), lower: reach(false), upper: reach(true) }
        });
        return BandShape::Rows(ranges.collect());
    }
    let zero = Rational::zero();
    let cuts = if start < &zero && end > &zero { vec![start, &zero, end] } else { vec![start, end] };
    let piece = |ends: &[&Rational]| {
        let left = ends[1] <= &zero;
        let (least, greatest) =
            if left { (first.upper(), first.lower()) } else { (first.lower(), first.upper()) };
        BandPiece {
            from: ends[0].clone(),
            to: ends[1].clone(),
            lower: line(least, second.lower()),
            upper: line(greatest, second.upper()),
        }
    };
    BandShape::Lines(cuts.windows(2).map(piece).collect())
}

/// The band of all θ of a set; `None` when there are none.
fn of_set(scene: &Scene, polyhedron: &Polyhedron) -> Option<BandShape> {
    let [start, end] = &scene.abscissas;
    if !scene.is_line() {
        if polyhedron.region().is_empty() {
            return None;
        }
        let reach = |form: &[Rational; 2]| match polyhedron.support(form) {
            Support::Bounded { proof, .. } => Some(proof.value),
            Support::Unbounded(_) | Support::Empty(_) => None,
        };
        let ranges = scene.rows_with_room().map(|shown| {
            let phi = &shown.measurement.regressor;
            let lower = reach(&phi.each_ref().map(|phi| -phi)).map(|value| -value);
            RowRange { measurement: shown.measurement.clone(), lower, upper: reach(phi) }
        });
        return Some(BandShape::Rows(ranges.collect()));
    }
    let corridor = Corridor::new(polyhedron)?;
    let mut cuts = vec![start.clone(), end.clone()];
    for envelope in [&corridor.upper, &corridor.lower] {
        cuts.extend(envelope.breakpoints().iter().cloned());
        let ends = envelope.domain().into_iter().flat_map(|domain| [domain.lower(), domain.upper()]);
        cuts.extend(ends.filter_map(|end| end.value().cloned()));
    }
    cuts.retain(|cut| start <= cut && cut <= end);
    cuts.sort();
    cuts.dedup();
    let piece = |ends: &[Rational]| BandPiece {
        from: ends[0].clone(),
        to: ends[1].clone(),
        lower: line_between(&corridor.lower, ends),
        upper: line_between(&corridor.upper, ends),
    };
    Some(BandShape::Lines(cuts.windows(2).map(piece).collect()))
}

/// The line that an edge of the corridor follows between two neighbouring cuts.
fn line_between(edge: &CorridorEdge, ends: &[Rational]) -> Option<[Rational; 2]> {
    let middle = (&ends[0] + &ends[1]).half();
    if !edge.domain()?.contains(&middle) {
        return None;
    }
    let index = edge.breakpoints().partition_point(|breakpoint| breakpoint < &middle);
    edge.lines().get(index).cloned()
}

/// The edge of a band that has none: just outside of every panel.
const BELOW: f64 = -0.01;
const ABOVE: f64 = 1.01;

fn draw_piece(panel: &mut Panel, view: &View, piece: &BandPiece, fill: Fill) {
    let [across, up] = panel.coordinates();
    let (from, to) = (across.fraction(&piece.from), across.fraction(&piece.to));
    let at = |line: &Option<[Rational; 2]>, x: &Rational, otherwise: f64| match line {
        None => otherwise,
        Some(line) => {
            let [slope, offset] = view.relative(line);
            up.fraction(&(slope * x + offset))
        }
    };
    let corners: [Place; 4] = [
        [from, at(&piece.lower, &piece.from, BELOW)],
        [to, at(&piece.lower, &piece.to, BELOW)],
        [to, at(&piece.upper, &piece.to, ABOVE)],
        [from, at(&piece.upper, &piece.from, ABOVE)],
    ];
    panel.area(&corners.map(|corner| panel.oriented(corner)), fill);
}

/// One edge of a band, in as few strokes as it has gaps.
fn draw_edge<'a>(
    panel: &mut Panel,
    view: &View,
    pieces: &'a [BandPiece],
    edge: impl Fn(&'a BandPiece) -> Option<&'a [Rational; 2]>,
    stroke: Stroke,
) {
    let mut run: Vec<Place> = Vec::new();
    for piece in pieces {
        let Some(line) = edge(piece) else {
            panel.line(&std::mem::take(&mut run), stroke);
            continue;
        };
        let [slope, offset] = view.relative(line);
        let at = |x: &Rational| panel.place([x, &(&slope * x + &offset)]);
        let ends = [at(&piece.from), at(&piece.to)];
        if run.is_empty() {
            run.push(ends[0]);
        }
        run.push(ends[1]);
    }
    panel.line(&run, stroke);
}

fn draw_row(panel: &mut Panel, view: &View, row: &RowRange, band: &Band) {
    let reference = view.reference_at(&row.measurement);
    let [across, up] = panel.coordinates();
    let half = view.half_row(panel);
    let number = Rational::from(row.measurement.row);
    let (from, to) = (across.fraction(&(&number - &half)), across.fraction(&(&number + &half)));
    let at = |end: &Option<Rational>, otherwise: f64| {
        end.as_ref().map_or(otherwise, |end| up.fraction(&(end - &reference)))
    };
    let (low, high) = (at(&row.lower, BELOW), at(&row.upper, ABOVE));
    let corners = [[from, low], [to, low], [to, high], [from, high]].map(|corner| panel.oriented(corner));
    panel.area(&corners, band.fill);
    if row.lower.is_some() {
        panel.line(&corners[..2], band.edge);
    }
    if row.upper.is_some() {
        panel.line(&corners[2..], band.edge);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::PlotOptions;
    use crate::samples::problem;

    /// Ends of a band at an abscissa, read off the pieces around it.
    fn at(bands: &Bands, index: usize, x: i64) -> Vec<[Option<Rational>; 2]> {
        let x = Rational::from(x);
        let BandShape::Lines(pieces) = &bands.0[index].shape else { unreachable!("a line model") };
        let value = |line: &Option<[Rational; 2]>| line.as_ref().map(|[slope, offset]| slope * &x + offset);
        let around = pieces.iter().filter(|piece| piece.from <= x && x <= piece.to);
        around.map(|piece| [value(&piece.lower), value(&piece.upper)]).collect()
    }

    #[test]
    fn bands_of_a_box_have_a_kink_at_zero() {
        // FPS: the diamond around θ = (0, 0) with PUI [-1, 1] for both.
        let problem = problem("line", &["-1 0 1", "1 0 1"], &[]);
        let fit = boundfit_estimation::fit(&problem);
        let options = PlotOptions::default();
        let bands = Bands::new(&Scene::new(&problem, &fit, Figure::Corridor, &options));
        for (x, reach) in [(-1, 2), (0, 1), (1, 2)] {
            let expected = [Some(Rational::from(-reach)), Some(Rational::from(reach))];
            for piece in at(&bands, 0, x) {
                assert_eq!(piece, expected, "PUI box at {x}");
            }
            for piece in at(&bands, 1, x) {
                assert_eq!(piece, [Some(Rational::from(-1)), Some(Rational::one())], "corridor at {x}");
            }
        }
        assert_eq!(at(&bands, 0, 0).len(), 2);
    }

    #[test]
    fn bands_of_unbounded_sets_have_no_edge_where_they_go_on() {
        // 0 ≤ θ1 alone: at x > 0 nothing bounds a line from above or, θ2 being free, from below.
        let problem = problem("line", &["0 0 1"], &["theta1 >= 0"]);
        let fit = boundfit_estimation::fit(&problem);
        let options = PlotOptions::default();
        let bands = Bands::new(&Scene::new(&problem, &fit, Figure::Corridor, &options));
        // θ2 in [-1, 1], θ1 ≥ 0: the abscissas shown reach from -1/2 to 1/2.
        let BandShape::Lines(pieces) = &bands.0[1].shape else { unreachable!("a line model") };
        assert_eq!(pieces.len(), 2);
        assert_eq!((pieces[0].lower.is_none(), pieces[0].upper.is_some()), (true, true));
        assert_eq!((pieces[1].lower.is_some(), pieces[1].upper.is_none()), (true, true));
        assert!(!bands.notes().is_empty());
    }
}
