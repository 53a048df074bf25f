//! The end of a piece and the shape behind it, without another intersection.

use boundfit_geometry::RegionKind;

use super::piece::Piece;
use super::section::Section;
use super::shape::{Shape, around};

/// The end of a piece whose sets are polygons.
pub(super) struct Crossing {
    /// The set there.
    pub(super) section: Section,
    /// The half-planes that shape the sets behind it, by angle.
    pub(super) spokes: Vec<usize>,
}

impl Crossing {
    /// Returns the end of a piece with these half-planes by angle. `None` unless each vertex takes part in one change
    /// at most: one redundant half-plane meets it, or one of its edges shrinks to nothing.
    ///
    /// Every other function that holds the shape is positive at the end, and therefore for a while behind it.
    pub(super) fn new(shape: &mut Shape, piece: &Piece, spokes: &[usize]) -> Option<Self> {
        if piece.kind != RegionKind::Polygon {
            return None;
        }
        let (count, end) = (spokes.len(), Some(&piece.to));
        let mut section = piece.at(&piece.to);
        let mut behind = spokes.to_vec();
        let mut changes = vec![0; count];
        let mut shrunk = Vec::new();
        // The edge along a half-plane starts at the vertex with its number.
        for (number, [before, spoke, next]) in around(spokes).enumerate() {
            let neighbours = shape.neighbours(before, spoke);
            if neighbours.reach.to.as_ref() == end {
                let [index] = *neighbours.met.as_slice() else { return None };
                section.vertices[number].active = shape.system.active(&[before, spoke, index]);
                changes[number] += 1;
                behind.push(index);
            }
            if shape.edge(before, spoke, next).to.as_ref() == end {
                // The first of all vertices remains the first.
                let vertices = [number, (number + 1) % count];
                let [kept, lost] = if vertices[1] == 0 { [0, number] } else { vertices };
                section.vertices[kept].active = shape.system.active(&[before, spoke, next]);
                vertices.into_iter().for_each(|vertex| changes[vertex] += 1);
                shrunk.push(lost);
                behind.retain(|&other| other != spoke);
            }
        }
        for ([before, spoke, _], &changes) in around(spokes).zip(&changes) {
            if changes > 1 || changes == 1 && !shape.neighbours(before, spoke).is_simple {
                return None;
            }
        }
        shrunk.sort_unstable();
        shrunk.iter().rev().for_each(|&vertex| drop(section.vertices.remove(vertex)));
        shape.sort(&mut behind);
        Some(Crossing { section, spokes: behind })
    }
}
