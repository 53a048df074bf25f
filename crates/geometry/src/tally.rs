//! How many readings one of them stands for, and the first of their numbers.

/// Readings that are told as one: how many they are, and the smallest of their numbers. Exact.
///
/// One reading takes no memory beside its number.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Tally {
    first: u64,
    others: Option<Box<Others>>,
}

/// What there is beside the first number.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Default)]
struct Others {
    /// How many readings, beside the first.
    count: u64,
    /// Their numbers as far as they are listed, ascending.
    rows: Vec<u64>,
}

impl Tally {
    /// The reading with this number, alone.
    pub fn one(row: u64) -> Self {
        Tally { first: row, others: None }
    }

    /// The smallest number.
    pub fn first(&self) -> u64 {
        self.first
    }

    /// How many readings there are.
    pub fn count(&self) -> u64 {
        1 + self.others.as_ref().map_or(0, |others| others.count)
    }

    /// The numbers that are listed, ascending.
    pub fn rows(&self) -> impl Iterator<Item = u64> + '_ {
        [self.first].into_iter().chain(self.others.iter().flat_map(|others| others.rows.iter().copied()))
    }

    /// How many numbers are listed.
    pub fn listed(&self) -> usize {
        1 + self.others.as_ref().map_or(0, |others| others.rows.len())
    }

    /// Adds a reading with a greater number than all so far, listed as one of at most so many. `row` tells the number, and is
    /// asked only where it is listed.
    #[inline]
    pub fn push(&mut self, row: impl FnOnce() -> u64, most: usize) {
        let others = self.others.get_or_insert_default();
        others.count += 1;
        if others.rows.len() + 1 < most {
            others.rows.push(row());
        }
    }

    /// The readings of all, of which at most so many are listed. The first of all of them are, if the first of each are.
    /// Cost: O(n log n) in the numbers listed.
    ///
    /// # Panics
    /// Without any.
    pub fn merged(tallies: impl Iterator<Item = Self>, most: usize) -> Self {
        let (mut count, mut rows) = (0, Vec::new());
        for tally in tallies {
            count += tally.count();
            rows.extend(tally.rows());
        }
        rows.sort_unstable();
        rows.truncate(most.max(1));
        let first = rows.remove(0);
        let others = (count > 1).then(|| Box::new(Others { count: count - 1, rows }));
        Tally { first, others }
    }

    /// The readings, each of which stands for so many. Those that are not listed stand for nothing.
    pub fn weighted(self, weight: impl Fn(u64) -> u64) -> Self {
        let count: u64 = self.rows().map(weight).fold(0, u64::saturating_add);
        let rows: Vec<u64> = self.rows().skip(1).collect();
        let others = (count > 1).then(|| Box::new(Others { count: count - 1, rows }));
        Tally { others, ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_are_counted_and_the_first_are_listed() {
        let mut tally = Tally::one(3);
        assert_eq!((tally.count(), tally.listed()), (1, 1));
        for row in 4..9 {
            tally.push(|| row, 3);
        }
        assert_eq!((tally.count(), tally.rows().collect::<Vec<_>>()), (6, vec![3, 4, 5]));
        let merged = Tally::merged([tally.clone(), Tally::one(1)].into_iter(), 3);
        assert_eq!((merged.count(), merged.first()), (7, 1));
        assert_eq!(merged.rows().collect::<Vec<_>>(), [1, 3, 4]);
        assert_eq!(Tally::merged([Tally::one(1), tally].into_iter(), 3), merged);
        assert_eq!(merged.weighted(|row| 10 * row).count(), 80);
    }
}
