//! The family of sets under a common factor on all error bounds.

use boundfit_estimation::{Breakpoint, Family, Fit, Linear, MovingVertex, Piece, Problem};
use boundfit_exact::Rational;
use boundfit_report::Number;
use boundfit_report::answer::{BreakpointJson, LinearJson, PieceJson};
use serde::Serialize;

use crate::number::STYLE;
use crate::numbered::Numbered;

/// The family. Sets share most of their vertices: each is written once, as functions of the factor, and the sets refer
/// to them by index.
#[derive(Debug, Serialize)]
pub(crate) struct SweepJson {
    least: Option<Number>,
    vertices: Vec<[LinearJson; 2]>,
    breakpoints: Vec<BreakpointJson<usize>>,
    pieces: Vec<PieceJson<usize>>,
}

/// The sets from factor 0 up to 2, or to twice the factor at which the set is born when that is more.
pub(crate) fn sweep(problem: &Problem, fit: &Fit) -> SweepJson {
    let two = Rational::from(2);
    let error_bound = problem.measurements.error_bound();
    let least = fit.minimax.as_ref().and_then(|minimax| minimax.least_factor(error_bound));
    let to = two.clone().max(least.unwrap_or_default() * &two);
    let family = Family::new(problem, Rational::zero(), to);
    let mut paths = Paths::default();
    let moving: Vec<Vec<usize>> = family.pieces().iter().map(|piece| paths.of_piece(piece)).collect();
    let areas = family.short_areas(STYLE.longest_fraction);
    let pieces = family.pieces().iter().zip(&moving).zip(&areas.pieces);
    let breakpoint = |(number, breakpoint): (usize, &Breakpoint)| {
        // Sets grow with the factor: below the first one that is not empty there are no vertices.
        let above = number.min(moving.len().saturating_sub(1));
        let beside = family.pieces().get(above).zip(moving.get(above));
        let vertices = beside.map_or_else(Vec::new, |(piece, moving)| met(breakpoint, piece, moving));
        BreakpointJson::new(problem, breakpoint, vertices, areas.breakpoints[number].as_ref(), &STYLE)
    };
    SweepJson {
        least: family.least().map(|least| STYLE.upper_number(least)),
        breakpoints: family.breakpoints().iter().enumerate().map(breakpoint).collect(),
        pieces: pieces
            .map(|((piece, moving), area)| PieceJson::new(piece, moving.clone(), area.as_ref(), &STYLE))
            .collect(),
        vertices: paths.written,
    }
}

/// The ways of vertices, each kept once.
#[derive(Debug, Default)]
struct Paths<'a> {
    known: Numbered<&'a [Linear; 2]>,
    written: Vec<[LinearJson; 2]>,
}

impl<'a> Paths<'a> {
    fn of_piece(&mut self, piece: &'a Piece) -> Vec<usize> {
        piece.vertices.iter().map(|vertex| self.index(&vertex.theta)).collect()
    }

    fn index(&mut self, path: &'a [Linear; 2]) -> usize {
        let (index, is_new) = self.known.number(&path);
        if is_new {
            self.written.push(path.each_ref().map(LinearJson::from));
        }
        index
    }
}

/// For each vertex at a breakpoint, one of a piece beside it that arrives there: all that is active on its way is active at
/// the vertex.
fn met(breakpoint: &Breakpoint, piece: &Piece, moving: &[usize]) -> Vec<usize> {
    let mut next = 0;
    let arrives = |way: &MovingVertex, names: &[_]| {
        way.active.names.iter().all(|name| names.binary_search(name).is_ok())
    };
    let vertices = breakpoint.section.vertices.iter();
    vertices
        .filter_map(|vertex| {
            let around = (next..next + moving.len()).map(|number| number % moving.len());
            let found =
                around.into_iter().find(|&number| arrives(&piece.vertices[number], &vertex.active.names))?;
            next = found + 1;
            Some(moving[found])
        })
        .collect()
}
