//! The half-planes that are active at a vertex. At nearly every vertex these are two, which take no memory of their own.

use std::ops::Deref;

/// Indices of half-planes, ascending once they are settled.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Active {
    One([usize; 1]),
    Two([usize; 2]),
    /// None, or more than two.
    Others(Vec<usize>),
}

impl Active {
    /// No half-plane yet.
    pub(crate) fn none() -> Self {
        Active::Others(Vec::new())
    }

    /// Adds a half-plane.
    pub(crate) fn push(&mut self, index: usize) {
        match self {
            Active::One([one]) => *self = Active::Two([*one, index]),
            Active::Two([one, other]) => *self = Active::Others(vec![*one, *other, index]),
            Active::Others(all) if all.is_empty() => *self = Active::One([index]),
            Active::Others(all) => all.push(index),
        }
    }

    /// Sorts the half-planes, each once.
    pub(crate) fn settle(&mut self) {
        match self {
            Active::One(_) => {}
            Active::Two([one, other]) if one == other => *self = Active::One([*one]),
            Active::Two(two) => two.sort_unstable(),
            Active::Others(all) => {
                all.sort_unstable();
                all.dedup();
                *self = std::mem::take(all).into();
            }
        }
    }
}

impl From<Vec<usize>> for Active {
    fn from(all: Vec<usize>) -> Self {
        match all.as_slice() {
            [one] => Active::One([*one]),
            [one, other] => Active::Two([*one, *other]),
            _ => Active::Others(all),
        }
    }
}

impl Deref for Active {
    type Target = [usize];

    fn deref(&self) -> &[usize] {
        match self {
            Active::One(one) => one,
            Active::Two(two) => two,
            Active::Others(all) => all,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pushed_and_settled_they_are_those_of_a_list() {
        for pushed in [&[][..], &[4], &[4, 4], &[4, 1], &[1, 4], &[3, 3, 3], &[3, 1, 3], &[5, 2, 7, 2, 0]] {
            let mut active = Active::none();
            pushed.iter().for_each(|&index| active.push(index));
            assert_eq!(*active, *pushed);
            active.settle();
            let mut expected = pushed.to_vec();
            expected.sort_unstable();
            expected.dedup();
            assert_eq!((&*active, &active), (expected.as_slice(), &Active::from(expected.clone())));
        }
    }

    #[test]
    fn two_take_as_much_memory_as_a_list_without_its_elements() {
        assert_eq!(size_of::<Active>(), size_of::<Vec<usize>>());
    }
}
