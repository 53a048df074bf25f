//! Names and their places.

use std::collections::HashMap;

use strsim::osa_distance;

/// The longest name that may be meant by another one.
const LONGEST: usize = 255;

/// Names in their order, each once.
#[derive(Debug, Default)]
pub(super) struct Names<'a> {
    order: Vec<&'a str>,
    places: HashMap<&'a str, usize>,
}

impl<'a> Names<'a> {
    /// The place of a name.
    pub(super) fn find(&self, name: &str) -> Option<usize> {
        self.places.get(name).copied()
    }

    /// The place of a name that was not there before.
    ///
    /// # Errors
    /// With the place of one that was.
    pub(super) fn add(&mut self, name: &'a str) -> Result<usize, usize> {
        if let Some(place) = self.find(name) {
            return Err(place);
        }
        let place = self.order.len();
        self.order.push(name);
        self.places.insert(name, place);
        Ok(place)
    }

    /// All names.
    pub(super) fn into_order(self) -> impl Iterator<Item = &'a str> {
        self.order.into_iter()
    }

    /// The name that differs from the wanted one in upper and lower case only, or by one letter; of each kind the first.
    /// Cost: linear in all names.
    pub(super) fn nearest(&self, wanted: &str) -> Option<&'a str> {
        let same = self.order.iter().find(|name| name.to_lowercase() == wanted.to_lowercase());
        same.or_else(|| self.order.iter().find(|name| is_one_edit(name, wanted))).copied()
    }
}

/// Returns whether one letter more, less or another, or two neighbours exchanged, make one text the other. Names of one or two
/// letters are all alike and never one edit apart.
fn is_one_edit(first: &str, second: &str) -> bool {
    // The distance takes the product of both lengths: only names of about the same length are asked for it, and no endless ones.
    let [first_length, second_length] = [first, second].map(|name| name.chars().count());
    (3..=LONGEST).contains(&first_length.min(second_length))
        && first_length.abs_diff(second_length) <= 1
        && osa_distance(first, second) <= 1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_near_that_differ_by_case_or_a_letter() {
        let mut names = Names::default();
        for name in ["demand", "supply", "x1", "X2", "rows"] {
            names.add(name).unwrap();
        }
        for (wanted, meant) in [
            ("Demand", Some("demand")),
            ("demnd", Some("demand")),
            ("demandd", Some("demand")),
            ("dmeand", Some("demand")),
            ("dermand", Some("demand")),
            ("ddeman", None),
            ("x2", Some("X2")),
            ("x3", None),
            ("rowss", Some("rows")),
            ("", None),
        ] {
            assert_eq!(names.nearest(wanted), meant, "{wanted}");
        }
        assert_eq!((names.add("x1"), names.find("X2")), (Err(2), Some(3)));
    }
}
