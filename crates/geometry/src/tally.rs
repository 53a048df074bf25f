//! The number of readings that one of them stands for, and the first of their numbers.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Readings that are told as one: how many they are, and the smallest of their numbers. Exact.
///
/// One reading takes no memory beside its number.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Tally {
    first: u64,
    others: Option<Box<Others>>,
}

/// The readings beside the first number.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
struct Others {
    /// The number of readings, beside the first.
    count: u64,
    /// The listed numbers of these readings, ascending.
    rows: Steps,
}

/// Ascending numbers behind one that is known, as the steps between them. Most steps take a byte; a run of
/// consecutive numbers takes a few bytes, however long it is.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Default)]
struct Steps {
    /// One more than each step in groups of seven bits, the lowest first; behind a 0 stands a number of steps of 1.
    bytes: Vec<u8>,
    count: usize,
    last: u64,
    /// The number of steps of 1 that are not in the bytes yet.
    run: u64,
}

impl Steps {
    /// None yet, behind this number.
    fn behind(first: u64) -> Self {
        Steps { last: first, ..Steps::default() }
    }

    /// Adds a number that is not less than the last.
    fn push(&mut self, row: u64) {
        let step = row.saturating_sub(self.last);
        self.last = row;
        self.count += 1;
        if step == 1 {
            self.run += 1;
            return;
        }
        self.settle();
        self.write(step.saturating_add(1));
    }

    /// Writes the steps of 1.
    fn settle(&mut self) {
        match std::mem::take(&mut self.run) {
            0 => {}
            run @ 1..=2 => self.bytes.extend((0..run).map(|_| 2)),
            run => {
                self.bytes.push(0);
                self.write(run);
            }
        }
    }

    fn write(&mut self, mut number: u64) {
        while number >> 7 != 0 {
            self.bytes.push((number & 0x7F) as u8 | 0x80);
            number >>= 7;
        }
        self.bytes.push(number as u8);
    }

    /// The numbers behind `first`.
    fn numbers(&self, first: u64) -> impl Iterator<Item = u64> + '_ {
        let mut bytes = self.bytes.iter().copied();
        let (mut last, mut run, mut rest) = (first, 0, self.run);
        let mut read = move || {
            let (mut number, mut shift) = (0, 0);
            for byte in bytes.by_ref() {
                number |= u64::from(byte & 0x7F) << shift;
                shift += 7;
                if byte & 0x80 == 0 {
                    return Some(number);
                }
            }
            None
        };
        std::iter::from_fn(move || {
            let step = if run > 0 {
                run -= 1;
                1
            } else {
                match read() {
                    Some(0) => {
                        run = read()?.checked_sub(1)?;
                        1
                    }
                    Some(more) => more - 1,
                    None => {
                        rest = rest.checked_sub(1)?;
                        1
                    }
                }
            };
            last += step;
            Some(last)
        })
    }
}

impl Tally {
    /// The reading with this number, alone.
    pub fn one(row: u64) -> Self {
        Tally { first: row, others: None }
    }

    /// Returns so many readings, at least one, of which the smallest number alone is listed.
    pub fn counted(first: u64, count: u64) -> Self {
        Tally::of_rows(count, &[first])
    }

    /// The smallest number.
    pub fn first(&self) -> u64 {
        self.first
    }

    /// The number of readings there are.
    pub fn count(&self) -> u64 {
        1 + self.others.as_ref().map_or(0, |others| others.count)
    }

    /// The numbers that are listed, ascending.
    pub fn rows(&self) -> impl Iterator<Item = u64> + '_ {
        let others = self.others.iter().flat_map(|others| others.rows.numbers(self.first));
        [self.first].into_iter().chain(others)
    }

    /// Returns how many numbers are listed.
    pub fn listed(&self) -> usize {
        1 + self.others.as_ref().map_or(0, |others| others.rows.count)
    }

    /// Adds a reading with a greater number than all so far, listed as one of at most so many. `row` tells the number, and is
    /// asked only where it is listed.
    #[inline]
    pub fn push(&mut self, row: impl FnOnce() -> u64, most: usize) {
        let first = self.first;
        let none = || Box::new(Others { count: 0, rows: Steps::behind(first) });
        let others = self.others.get_or_insert_with(none);
        others.count += 1;
        if others.rows.count + 1 < most {
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
            rows.extend(tally.rows().take(most.max(1)));
        }
        rows.sort_unstable();
        rows.truncate(most.max(1));
        Tally::of_rows(count, &rows)
    }

    /// All numbers that are listed, each once; `None` without any. Cost: O(n log k) in the numbers of k tallies, in memory for what they
    /// come to.
    pub fn union<'a>(tallies: impl Iterator<Item = &'a Self>) -> Option<Self> {
        let mut numbers: Vec<_> = tallies.map(Tally::rows).collect();
        let first = numbers.iter_mut().enumerate().filter_map(|(of, rows)| Some(Reverse((rows.next()?, of))));
        let mut next: BinaryHeap<Reverse<(u64, usize)>> = first.collect();
        let mut all: Option<(Self, u64)> = None;
        while let Some(Reverse((row, of))) = next.pop() {
            next.extend(numbers[of].next().map(|row| Reverse((row, of))));
            match &mut all {
                None => all = Some((Tally::one(row), row)),
                Some((_, last)) if *last == row => {}
                Some((own, last)) => {
                    own.push(|| row, usize::MAX);
                    *last = row;
                }
            }
        }
        all.map(|(own, _)| own)
    }

    /// These readings, at least two, but for one that is not the first.
    #[must_use]
    pub fn without(&self, row: u64) -> Self {
        let rows: Vec<u64> = self.rows().filter(|&own| own != row).collect();
        Tally::of_rows(self.count() - 1, &rows)
    }

    /// Returns so many readings, at least one, with their numbers as far as they are listed, ascending.
    fn of_rows(count: u64, rows: &[u64]) -> Self {
        let (first, rows) = (rows[0], &rows[1..]);
        let others = || {
            let mut steps = Steps::behind(first);
            rows.iter().for_each(|&row| steps.push(row));
            Box::new(Others { count: count - 1, rows: steps })
        };
        Tally { first, others: (count > 1).then(others) }
    }

    /// Adds the readings of one whose numbers are all greater; at most so many numbers are listed. Cost: linear in the numbers that
    /// come in.
    pub fn append(&mut self, later: &Self, most: usize) {
        let count = self.count() + later.count();
        let room = most.saturating_sub(self.listed());
        later.rows().take(room).for_each(|row| self.push(|| row, most));
        let first = self.first;
        let none = || Box::new(Others { count: 0, rows: Steps::behind(first) });
        self.others.get_or_insert_with(none).count = count - 1;
    }

    /// Bytes beside its own.
    pub fn heap_bytes(&self) -> usize {
        self.others.as_ref().map_or(0, |others| size_of::<Others>() + others.rows.bytes.capacity())
    }

    /// The readings, each of which stands for so many. Numbers that are not listed stand for nothing.
    pub fn weighted(self, weight: impl Fn(u64) -> u64) -> Self {
        let count: u64 = self.rows().map(weight).fold(0, u64::saturating_add);
        let rows: Vec<u64> = self.rows().collect();
        Tally::of_rows(count, &rows)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_come_back_whatever_the_steps_are() {
        let mut seed = 7_u64;
        for round in 0..200 {
            let mut rows = vec![round];
            for _ in 0..round % 40 {
                seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                let step = [1, 1, 1, 2, 5, 126, 127, 128, 70_000, 1 << 40][(seed >> 33) as usize % 10];
                rows.push(rows[rows.len() - 1] + step);
            }
            let mut pushed = Tally::one(rows[0]);
            rows[1..].iter().for_each(|&row| pushed.push(|| row, usize::MAX));
            assert_eq!(pushed.rows().collect::<Vec<_>>(), rows);
            let merged = Tally::merged(rows.iter().rev().map(|&row| Tally::one(row)), usize::MAX);
            assert_eq!(merged, pushed);
            let parts = [0, 1, 2].map(|part| {
                let own = rows.iter().enumerate().filter(|(k, _)| k % 3 == part || k % 5 == 0);
                own.map(|(_, &row)| Tally::one(row)).collect::<Vec<Tally>>()
            });
            let parts = parts.into_iter().filter(|part| !part.is_empty());
            let parts: Vec<Tally> = parts.map(|part| Tally::merged(part.into_iter(), usize::MAX)).collect();
            assert_eq!(Tally::union(parts.iter()), Some(pushed));
            for most in [1, 3, usize::MAX] {
                let (front, back) = rows.split_at(rows.len() / 2);
                let [Some(mut all), Some(back)] = [front, back].map(|rows| {
                    (!rows.is_empty()).then(|| Tally::merged(rows.iter().map(|&row| Tally::one(row)), most))
                }) else {
                    continue;
                };
                all.append(&back, most);
                assert_eq!(all, Tally::merged(rows.iter().map(|&row| Tally::one(row)), most));
            }
        }
        let mut long = Tally::one(1);
        (2..=1_000_000).for_each(|row| long.push(|| row, usize::MAX));
        assert_eq!((long.count(), long.rows().last()), (1_000_000, Some(1_000_000)));
        assert!(long.heap_bytes() < 200);
    }

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
