//! The region without some of its inequalities, for many such questions about one region.

use std::ops::Range;

use boundfit_exact::{Endpoint, Interval, Rational};

use crate::active::Active;
use crate::envelope;
use crate::fan::normal_of;
use crate::polyhedron::Polyhedron;
use crate::predicates::{Turn, normal_turn};
use crate::region::{Region, Vertex, from_chain};
use crate::system::System;

/// A polyhedron with its redundant half-planes by angle. A redundant half-plane matters only for the irredundant ones
/// next to it by angle, so that a polygon without one of these is another one in that place alone.
#[derive(Debug)]
pub struct LeavingOut<'a> {
    polyhedron: &'a Polyhedron,
    bounding_box: Option<[Interval; 2]>,
    /// For each irredundant half-plane, by angle, the redundant ones from its normal on up to the next one.
    behind: Vec<Vec<usize>>,
}

impl<'a> LeavingOut<'a> {
    /// Looks up where the redundant half-planes are. Cost: O(n log n).
    pub fn new(polyhedron: &'a Polyhedron) -> Self {
        let spokes = polyhedron.irredundant_by_angle();
        let mut places = vec![None; polyhedron.system().len()];
        spokes.iter().enumerate().for_each(|(place, &spoke)| places[spoke] = Some(place));
        let mut behind = vec![Vec::new(); spokes.len()];
        for index in (0..places.len()).filter(|&index| places[index].is_none()) {
            if let Some(place) = polyhedron.neighbours(index).and_then(|(before, _)| places[before]) {
                behind[place].push(index);
            }
        }
        LeavingOut { polyhedron, bounding_box: polyhedron.bounding_box(), behind }
    }

    /// The region without some inequalities that follow each other, and its box unless it is empty. Exact: they are those of
    /// [`System::without`]. Cost for a polygon: the number of its vertices, and O(k log k) for k half-planes that become
    /// neighbours; for other regions O(n log n).
    ///
    /// # Panics
    /// When an index is out of range.
    pub fn without(&self, indices: Range<usize>) -> (Region, Option<[Interval; 2]>) {
        self.polygon_without(&indices).unwrap_or_else(|| {
            let rest = Polyhedron::intersect(self.polyhedron.system().without(indices));
            (rest.region().clone(), rest.bounding_box())
        })
    }

    /// The same of a polygon that remains one; `None` of other regions.
    fn polygon_without(&self, indices: &Range<usize>) -> Option<(Region, Option<[Interval; 2]>)> {
        let Region::Polygon(polygon) = self.polyhedron.region() else { return None };
        let spokes = self.polyhedron.irredundant_by_angle();
        let (system, count) = (self.polyhedron.system(), spokes.len());
        let is_left_out = |place: usize| indices.contains(&spokes[place]);
        if (0..count).all(is_left_out) {
            return None;
        }
        let first = self.polyhedron.fan().first_side(system);
        let (mut vertices, mut bounding_box) = (Vec::with_capacity(count), self.bounding_box.clone()?);
        for (number, vertex) in polygon.vertices.iter().enumerate() {
            let [before, after] = [first + number + count - 1, first + number].map(|place| place % count);
            if is_left_out(before) {
                continue;
            }
            if !is_left_out(after) {
                let active = remaining(&vertex.active, indices);
                vertices.push(Vertex { point: vertex.point.clone(), active });
                continue;
            }
            let next = (1..count).map(|step| (before + step) % count).find(|&place| !is_left_out(place))?;
            let sides = [before, next].map(|place| normal_of(system, spokes[place]));
            if normal_turn(sides[0], sides[1]) != Turn::Left {
                return None;
            }
            for vertex in self.chain(before, next, indices)? {
                bounding_box = widened(bounding_box, &vertex.point.coordinates())?;
                vertices.push(vertex);
            }
        }
        Some((from_chain(vertices, None), Some(bounding_box)))
    }

    /// The vertices between two sides that are less than half a turn apart and become neighbours.
    fn chain(&self, before: usize, next: usize, indices: &Range<usize>) -> Option<Vec<Vertex>> {
        let (spokes, system) = (self.polyhedron.irredundant_by_angle(), self.polyhedron.system());
        let between = (0..spokes.len()).map(|step| (before + step) % spokes.len());
        let mut members: Vec<usize> = between
            .take_while(|&place| place != next)
            .flat_map(|place| &self.behind[place])
            .copied()
            .collect();
        let side = normal_of(system, spokes[next]);
        let is_parallel = |index: &&usize| normal_turn(side, normal_of(system, **index)) == Turn::None;
        members.extend(self.behind[next].iter().filter(is_parallel));
        members.retain(|index| !indices.contains(index));
        members.extend([spokes[before], spokes[next]]);
        let local = members.iter().map(|&index| system.inequality(index).into_owned()).collect::<System>();
        let Region::UnboundedPolygon(own) = envelope::intersect(&local) else { return None };
        let vertex = |vertex: &Vertex| {
            let mut active: Vec<usize> = vertex.active.iter().map(|&index| members[index]).collect();
            active.sort_unstable();
            Vertex { point: vertex.point.clone(), active: remaining(&active, indices) }
        };
        Some(own.chain().map(vertex).collect())
    }
}

/// Active half-planes without those left out, by their indices in what remains.
fn remaining(active: &[usize], left_out: &Range<usize>) -> Active {
    let kept = active.iter().filter(|index| !left_out.contains(index));
    let moved_up = |&index: &usize| if index < left_out.start { index } else { index - left_out.len() };
    kept.map(moved_up).collect::<Vec<_>>().into()
}

/// The box of a box and a point.
fn widened([one, other]: [Interval; 2], [theta1, theta2]: &[Rational; 2]) -> Option<[Interval; 2]> {
    let widened = |interval: &Interval, value: &Rational| {
        let (lower, upper) = interval.ends()?;
        let [lower, upper] = [lower.min(value), upper.max(value)].map(|end| Endpoint::Finite(end.clone()));
        Interval::new(lower, upper)
    };
    Some([widened(&one, theta1)?, widened(&other, theta2)?])
}
