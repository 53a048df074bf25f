//! The family of sets over the error bound as JSON: part of `boundfit/fit/2`.

use std::sync::Arc;

use boundfit_estimation::{
    ActiveBounds, BoundName, Breakpoint, Family, Linear, MovingArea, MovingVertex, Piece, Problem, Section,
    SectionVertex, Ties,
};
use boundfit_exact::Rational;
use boundfit_geometry::{Direction, RegionKind};

use crate::answer::parts::{ActiveJson, ActiveListJson, RangeJson, VertexJson};
use crate::answer::sweep::{BoundaryJson, BreakpointJson, LinearJson, PieceJson, QuadraticJson, SweepJson};
use crate::number::Number;
use crate::style::Style;

impl SweepJson {
    /// The family between the factors that it was made for.
    pub fn new(problem: &Problem, family: &Family, style: &Style) -> Self {
        let breakpoints = family.breakpoints();
        let end = |breakpoint: Option<&Breakpoint>| {
            style.upper_number(breakpoint.map_or(&Rational::default(), |breakpoint| &breakpoint.s))
        };
        let areas = family.short_areas(style.longest_fraction);
        let breakpoint = |(own, area): (_, &Option<_>)| breakpoint_json(problem, own, area.as_ref(), style);
        let pieces = family.pieces().iter().zip(&areas.pieces);
        SweepJson {
            from: end(breakpoints.first()),
            to: end(breakpoints.last()),
            least: family.least().map(|least| style.upper_number(least)),
            breakpoints: breakpoints.iter().zip(&areas.breakpoints).map(breakpoint).collect(),
            pieces: pieces.map(|(piece, area)| piece_json(piece, area.as_ref(), style)).collect(),
        }
    }

    /// Returns whether the fraction of an area is too long to be written.
    pub(crate) fn lacks_fraction(&self) -> bool {
        let areas = self.breakpoints.iter().filter_map(|breakpoint| breakpoint.area.as_ref());
        let mut functions = self.pieces.iter().filter_map(|piece| piece.area.as_ref());
        areas.into_iter().any(Number::lacks_fraction) || functions.any(|area| area.decimals.is_some())
    }
}

fn breakpoint_json(
    problem: &Problem,
    breakpoint: &Breakpoint,
    area: Option<&Rational>,
    style: &Style,
) -> BreakpointJson {
    let vertex = |vertex: &SectionVertex| VertexJson {
        theta: style.numbers(&vertex.theta),
        active: listed(&vertex.active),
    };
    let vertices = breakpoint.section.vertices.iter().map(vertex).collect();
    BreakpointJson::new(problem, breakpoint, vertices, area, style)
}

fn piece_json(piece: &Piece, area: Option<&[Rational; 3]>, style: &Style) -> PieceJson {
    let vertex = |vertex: &Arc<MovingVertex>| VertexJson {
        theta: vertex.theta.each_ref().map(LinearJson::from),
        active: listed(&vertex.active),
    };
    PieceJson::new(piece, piece.vertices.iter().map(vertex).collect(), area, style)
}

impl<V> BreakpointJson<V> {
    /// A breakpoint with its vertices in the form of the caller, and its area where it is known already.
    pub fn new(
        problem: &Problem,
        breakpoint: &Breakpoint,
        vertices: Vec<V>,
        area: Option<&Rational>,
        style: &Style,
    ) -> Self {
        let Section { kind, vertices: _, rays, lines, boundaries, pui } = &breakpoint.section;
        let area = match area {
            Some(area) => Some(style.number(area)),
            None => {
                let measures = breakpoint.section.measures();
                let area = measures.area().filter(|_| *kind != RegionKind::Empty);
                area.map(|area| style.measure_number(&area))
            }
        };
        let epsilon = problem.measurements.error_bound().uniform();
        let epsilon = epsilon.map(|epsilon| style.upper_number(&(epsilon * &breakpoint.s)));
        BreakpointJson {
            s: style.upper_number(&breakpoint.s),
            epsilon,
            kind: kind.name(),
            vertices,
            rays: directions(rays),
            lines: directions(lines),
            boundaries: boundaries
                .iter()
                .map(|boundary| BoundaryJson {
                    normal: direction(&boundary.normal),
                    offset: style.number(&boundary.offset),
                    active: listed(&boundary.active),
                })
                .collect(),
            pui: pui.as_ref().map(|pui| RangeJson::both(pui, style)),
            area,
            entering: names(&breakpoint.entering),
            leaving: names(&breakpoint.leaving),
        }
    }
}

impl<V> PieceJson<V> {
    /// A piece with its vertices in the form of the caller, and its area where it is known already.
    pub fn new(piece: &Piece, vertices: Vec<V>, area: Option<&[Rational; 3]>, style: &Style) -> Self {
        let range = |[lower, upper]: &[Option<Linear>; 2]| RangeJson {
            lower: lower.as_ref().map(LinearJson::from),
            upper: upper.as_ref().map(LinearJson::from),
        };
        PieceJson {
            from: style.upper_number(&piece.from),
            to: style.upper_number(&piece.to),
            kind: piece.kind.name(),
            vertices,
            rays: directions(&piece.rays),
            lines: directions(&piece.lines),
            boundaries: piece
                .boundaries
                .iter()
                .map(|boundary| BoundaryJson {
                    normal: direction(&boundary.normal),
                    offset: LinearJson::from(&boundary.offset),
                    active: listed(&boundary.active),
                })
                .collect(),
            pui: piece.pui.as_ref().map(|pui| pui.each_ref().map(range)),
            area: match area {
                Some(area) => {
                    let [constant, slope, quadratic] = area.each_ref().map(|own| Some(own.to_string()));
                    Some(QuadraticJson { constant, slope, quadratic, decimals: None })
                }
                None => piece.area().map(|area| quadratic(&area, style)),
            },
        }
    }
}

impl From<&Linear> for LinearJson {
    fn from(Linear { constant, slope }: &Linear) -> Self {
        LinearJson { constant: constant.to_string(), slope: slope.to_string() }
    }
}

fn quadratic(area: &MovingArea, style: &Style) -> QuadraticJson {
    let coefficients = [area.constant(), area.slope(), area.quadratic()];
    let exact = coefficients.each_ref().map(|coefficient| coefficient.exact_within(style.longest_fraction));
    let decimal = |index: usize| coefficients[index].rounding_alike(style.significant());
    let lacks = exact.iter().any(Option::is_none);
    let decimals = lacks.then(|| [0, 1, 2].map(|index| style.nearest(&decimal(index)).compact().to_string()));
    let [constant, slope, quadratic] = exact.map(|exact| exact.map(|exact| exact.to_string()));
    QuadraticJson { constant, slope, quadratic, decimals }
}

fn listed(active: &ActiveBounds) -> ActiveListJson<ActiveJson> {
    (&active.clone().at_most(Ties::MOST_LISTED)).into()
}

fn names(names: &[BoundName]) -> Vec<ActiveJson> {
    names.iter().map(|&name| name.into()).collect()
}

fn direction(direction: &Direction) -> [String; 2] {
    [direction.dx().to_string(), direction.dy().to_string()]
}

fn directions(directions: &[Direction]) -> Vec<[String; 2]> {
    directions.iter().map(direction).collect()
}
