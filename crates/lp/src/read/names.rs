//! Names and their places.

use std::collections::HashMap;

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

/// Whether one letter more, less or another, or two neighbours exchanged, make one text the other. Names of one or two
/// letters are all alike and never one edit apart.
fn is_one_edit(first: &str, second: &str) -> bool {
    let (first, second): (Vec<char>, Vec<char>) = (first.chars().collect(), second.chars().collect());
    let start = first.iter().zip(&second).take_while(|(a, b)| a == b).count();
    let (first_rest, second_rest) = (first.iter().skip(start), second.iter().skip(start));
    let end = first_rest.rev().zip(second_rest.rev()).take_while(|(a, b)| a == b).count();
    let middle = |text: &[char]| text.get(start..text.len() - end).unwrap_or_default().to_vec();
    let is_swap = |a: &[char], b: &[char]| matches!((a, b), ([p, q], [r, s]) if p == s && q == r);
    let (a, b) = (middle(&first), middle(&second));
    first.len().min(second.len()) > 2 && (a.len() <= 1 && b.len() <= 1 || is_swap(&a, &b))
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
