//! The rows of each group.

use std::ops::Range;

/// The rows of each group, ascending.
#[derive(Debug, Clone)]
pub(super) struct Groups {
    /// The start of each group's rows in the order of groups, and the end of the last.
    starts: Vec<u32>,
    /// The rows in the order of groups; `None` when they already are.
    order: Option<Vec<u32>>,
}

impl Groups {
    /// Sorts rows by counting, from the group of each row. Cost: linear.
    pub(super) fn new(group_of: &[u32], count: usize) -> Self {
        let mut starts = vec![0; count + 1];
        for &group in group_of {
            starts[group as usize + 1] += 1;
        }
        for group in 0..count {
            starts[group + 1] += starts[group];
        }
        if group_of.is_sorted() {
            return Groups { starts, order: None };
        }
        let mut order = vec![0; group_of.len()];
        let mut next = starts.clone();
        for (row, &group) in (0..).zip(group_of) {
            let place = &mut next[group as usize];
            order[*place as usize] = row;
            *place += 1;
        }
        Groups { starts, order: Some(order) }
    }

    /// The number of groups there are.
    pub(super) fn len(&self) -> usize {
        self.starts.len() - 1
    }

    /// The rows of a group, from 0, ascending; at least one.
    pub(super) fn rows(&self, group: usize) -> impl ExactSizeIterator<Item = usize> + Clone + '_ {
        self.rows_at(group, 0..self.places(group).len())
    }

    /// Returns the rows of a group that are at these places among them.
    pub(super) fn rows_at(
        &self,
        group: usize,
        among: Range<usize>,
    ) -> impl ExactSizeIterator<Item = usize> + Clone + '_ {
        let Range { start, end } = self.places(group);
        let places = end.min(start + among.start)..end.min(start + among.end);
        places.map(|place| self.order.as_ref().map_or(place, |order| order[place] as usize))
    }

    /// The rows of a group, if all groups are one after the other.
    pub(super) fn run(&self, group: usize) -> Option<Range<usize>> {
        self.order.is_none().then(|| self.places(group))
    }

    fn places(&self, group: usize) -> Range<usize> {
        self.starts[group] as usize..self.starts[group + 1] as usize
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_gathered_in_their_order() {
        let rows = |group_of: &[u32], count| {
            let groups = Groups::new(group_of, count);
            (0..groups.len()).map(|group| groups.rows(group).collect()).collect::<Vec<Vec<usize>>>()
        };
        assert_eq!(rows(&[0, 1, 0, 2, 1, 0], 3), [vec![0, 2, 5], vec![1, 4], vec![3]]);
        assert_eq!(rows(&[0, 0, 1, 2, 2], 3), [vec![0, 1], vec![2], vec![3, 4]]);
        assert!(rows(&[], 0).is_empty());
    }
}
