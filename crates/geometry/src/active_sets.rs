//! The half-planes that are active at the vertices of a set whose vertices need not be in memory.

use std::ops::Deref;

use crate::active::Active;
use crate::region::Vertex;

/// The half-planes that are active at each vertex of a set, counter-clockwise from the lexicographically smallest.
#[derive(Debug)]
pub struct ActiveSets<'a>(pub(crate) Sets<'a>);

#[derive(Debug)]
pub(crate) enum Sets<'a> {
    /// The vertices are in memory.
    Kept(&'a [Vertex]),
    /// The sides of a polygon, by angle: its vertices lie between them. The side at `first` leads away from the first vertex. `touching` has
    /// the other half-planes, each behind the number of its vertex, ascending.
    OfSides { sides: &'a [usize], first: usize, touching: Vec<(usize, usize)> },
}

impl ActiveSets<'_> {
    /// Indices of the half-planes that are active at a vertex, ascending. Cost: logarithmic in the number of half-planes that touch the
    /// set beside its sides.
    ///
    /// # Panics
    /// When there is no vertex with this number.
    pub fn of(&self, number: usize) -> impl Deref<Target = [usize]> + use<> {
        self.at(number)
    }

    pub(crate) fn at(&self, number: usize) -> Active {
        match &self.0 {
            Sets::Kept(vertices) => vertices[number].active.clone(),
            Sets::OfSides { sides, first, touching } => {
                let (count, place) = (sides.len(), first + number);
                let mut active = Active::Two([place + count - 1, place].map(|place| sides[place % count]));
                let start = touching.partition_point(|&(own, _)| own < number);
                let others = touching[start..].iter().take_while(|&&(own, _)| own == number);
                others.for_each(|&(_, index)| active.push(index));
                active.settle();
                active
            }
        }
    }
}
