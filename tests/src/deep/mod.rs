//! The differential run: generated sets through every algorithm that computes them, all answers compared with `==`.
//!
//! Case `n` of seed `s` is the same on every machine and for any number of threads.

mod families;
mod half_planes;
mod large;
mod placement;
mod readings;
mod simplex;

use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};

use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

use crate::generate::seeded;

pub use families::Family;
pub use half_planes::{PlacedCase, h_representation};
pub use large::LargeCase;
pub use placement::Placement;
pub use readings::{ReadingsCase, ReadingsFamily};

/// A set, judged by every algorithm.
pub trait Case {
    /// The kind of the region, if all agree; else what differs.
    ///
    /// # Errors
    /// The first difference, in words.
    fn check(&self) -> Result<&'static str, String>;

    /// The same set without its row with this index, or `None` when there is none.
    fn without(&self, index: usize) -> Option<Box<dyn Case>>;

    /// A file with the set, which boundfit reads.
    fn fixture(&self) -> String;
}

/// The number of times that each kind of region came up, by family of sets.
pub type Counts = BTreeMap<&'static str, BTreeMap<&'static str, u64>>;

/// A case about which two algorithms differ.
#[derive(Debug)]
pub struct Difference {
    /// The number of the case, from 0.
    pub number: u64,
    /// The family of the set.
    pub family: &'static str,
    /// The difference, in the case and in its smallest version.
    pub messages: [String; 2],
    /// The smallest version that was found, as a file that boundfit reads.
    pub fixture: String,
}

/// One case in so many is a large system, which costs as much as all the others together.
const LARGE_EVERY: u64 = 4_000;

/// The family and the case with this number.
pub fn case(seed: u64, number: u64) -> (&'static str, Box<dyn Case>) {
    let mut rng = rng_of(seed, number);
    if number % LARGE_EVERY == LARGE_EVERY - 1 {
        return ("large", Box::new(LargeCase::generated(&mut rng)));
    }
    if number % 5 == 4 {
        let family = ReadingsFamily::ALL[(number / 5) as usize % ReadingsFamily::ALL.len()];
        return (family.name(), Box::new(family.case(&mut rng)));
    }
    let family = Family::ALL[(number % 5 + 4 * (number / 5)) as usize % Family::ALL.len()];
    (family.name(), Box::new(family.case(&mut rng)))
}

/// A generator for one case: seeds and numbers that are neighbours give unrelated ones.
fn rng_of(seed: u64, number: u64) -> ChaCha8Rng {
    let mut rng = seeded(seed);
    rng.set_stream(number);
    rng
}

/// Judges the cases with these numbers on all threads of the current pool.
///
/// # Errors
/// The difference in the case with the smallest number.
pub fn run(seed: u64, numbers: std::ops::Range<u64>) -> Result<Counts, Box<Difference>> {
    let judged = |number: u64| -> Result<Counts, Box<Difference>> {
        let (family, case) = case(seed, number);
        match check(&*case) {
            Ok(kind) => Ok([(family, [(kind, 1)].into())].into()),
            Err(message) => {
                let (smallest, last) = shrunk(case, &message);
                let fixture = smallest.fixture();
                Err(Box::new(Difference { number, family, messages: [message, last], fixture }))
            }
        }
    };
    numbers.into_par_iter().map(judged).reduce(|| Ok(Counts::new()), merged)
}

fn merged(
    one: Result<Counts, Box<Difference>>,
    other: Result<Counts, Box<Difference>>,
) -> Result<Counts, Box<Difference>> {
    match (one, other) {
        (Ok(mut counts), Ok(more)) => {
            for (family, kinds) in more {
                let own = counts.entry(family).or_default();
                kinds.into_iter().for_each(|(kind, count)| *own.entry(kind).or_default() += count);
            }
            Ok(counts)
        }
        (Err(one), Err(other)) => Err(if one.number <= other.number { one } else { other }),
        (Err(difference), Ok(_)) | (Ok(_), Err(difference)) => Err(difference),
    }
}

/// The check of a case; a panic is a difference too.
fn check(case: &dyn Case) -> Result<&'static str, String> {
    catch_unwind(AssertUnwindSafe(|| case.check())).unwrap_or_else(|panic| {
        let text = panic.downcast_ref::<String>().cloned();
        let text = text.or_else(|| panic.downcast_ref::<&str>().map(|&text| text.to_owned()));
        Err(format!("panic: {}", text.unwrap_or_default()))
    })
}

/// The case without every row that the difference does not need, and its message.
fn shrunk(case: Box<dyn Case>, message: &str) -> (Box<dyn Case>, String) {
    let (mut case, mut message) = (case, message.to_owned());
    let mut index = 0;
    while let Some(smaller) = case.without(index) {
        match check(&*smaller) {
            Err(last) => (case, message) = (smaller, last),
            Ok(_) => index += 1,
        }
    }
    (case, message)
}

/// Fails with a message unless two answers are equal.
pub(crate) fn same<T: PartialEq + std::fmt::Debug>(what: &str, one: &T, other: &T) -> Result<(), String> {
    if one == other { Ok(()) } else { Err(format!("{what}: {one:?} but {other:?}")) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Differs as long as it has both an even row and the row 7.
    struct Odd(Vec<u64>);

    impl Case for Odd {
        fn check(&self) -> Result<&'static str, String> {
            let has_even = self.0.iter().any(|row| row % 2 == 0);
            if has_even && self.0.contains(&7) { Err(format!("{:?}", self.0)) } else { Ok("odd") }
        }

        fn without(&self, index: usize) -> Option<Box<dyn Case>> {
            let mut rows = self.0.clone();
            (index < rows.len()).then(|| rows.remove(index))?;
            Some(Box::new(Odd(rows)))
        }

        fn fixture(&self) -> String {
            format!("{:?}", self.0)
        }
    }

    #[test]
    fn a_difference_is_shrunk_to_the_rows_that_it_needs() {
        let (smallest, message) = shrunk(Box::new(Odd(vec![1, 2, 3, 7, 8, 7])), "first");
        assert_eq!((smallest.fixture(), message), ("[8, 7]".to_owned(), "[8, 7]".to_owned()));
    }

    #[test]
    fn the_counts_do_not_depend_on_the_number_of_threads() {
        let counts = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| run(3, 0..300)).unwrap()
        };
        let alone = counts(1);
        assert_eq!(alone, counts(4));
        assert_eq!(alone.values().flat_map(BTreeMap::values).sum::<u64>(), 300);
    }
}
