//! Things by number, each kept once.

use std::collections::HashMap;
use std::hash::Hash;

/// Different things, numbered in the order in which they first came up. Sets share long runs of their vertices: a thing is
/// looked for first where the one before it was followed the last time, which takes no hash.
#[derive(Debug)]
pub(crate) struct Numbered<T> {
    all: Vec<T>,
    numbers: HashMap<T, usize>,
    /// The number that followed each thing the last time.
    followers: Vec<usize>,
    last: usize,
}

impl<T> Default for Numbered<T> {
    fn default() -> Self {
        Numbered { all: Vec::new(), numbers: HashMap::new(), followers: Vec::new(), last: 0 }
    }
}

impl<T: Clone + Eq + Hash> Numbered<T> {
    /// The number of a thing, and whether it is new.
    pub(crate) fn number(&mut self, thing: &T) -> (usize, bool) {
        let count = self.all.len();
        let guess = self.followers.get(self.last).copied();
        let is = |number: &usize| self.all[*number] == *thing;
        let known = guess.filter(is).or_else(|| self.numbers.get(thing).copied());
        let number = known.unwrap_or_else(|| {
            self.all.push(thing.clone());
            self.numbers.insert(thing.clone(), count);
            self.followers.push(0);
            count
        });
        self.followers[self.last] = number;
        self.last = number;
        (number, number == count)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_those_of_the_first_time() {
        let (mut numbered, mut seen) = (Numbered::default(), Vec::new());
        for thing in "abcabcacbdabdcbaddabcd".chars() {
            let is_new = !seen.contains(&thing);
            seen.extend(is_new.then_some(thing));
            let number = seen.iter().position(|other| *other == thing).unwrap();
            assert_eq!(numbered.number(&thing), (number, is_new), "{thing} after {seen:?}");
        }
    }
}
