//! The names of groups, each kept once.

use std::hash::BuildHasher;

use hashbrown::{DefaultHashBuilder, HashTable};

/// Distinct texts, numbered in the order in which they were first seen.
#[derive(Debug, Clone, Default)]
pub(super) struct Keys {
    /// All texts, one after the other.
    text: String,
    /// The end of each text.
    ends: Vec<usize>,
    /// The texts by their hashes.
    entries: HashTable<Entry>,
    hasher: DefaultHashBuilder,
}

/// A text with its number and its place: a look-up in the list of ends would fetch memory twice more.
#[derive(Debug, Clone, Copy)]
struct Entry {
    start: usize,
    length: u32,
    number: u32,
}

impl Entry {
    fn of(self, text: &str) -> &str {
        text.get(self.start..self.start + self.length as usize).unwrap_or_default()
    }
}

impl Keys {
    /// Returns how many there are.
    pub(super) fn len(&self) -> usize {
        self.ends.len()
    }

    /// The text with a number.
    pub(super) fn get(&self, number: usize) -> &str {
        let start = number.checked_sub(1).map_or(0, |before| self.ends[before]);
        &self.text[start..self.ends[number]]
    }

    /// Returns whether a text is among them.
    pub(super) fn has(&self, key: &str) -> bool {
        let hash = self.hasher.hash_one(key);
        self.entries.find(hash, |entry| entry.of(&self.text) == key).is_some()
    }

    /// The number of a text, a new one for a new text; `None` when there are no numbers left.
    pub(super) fn number_of(&mut self, key: &str) -> Option<u32> {
        let Keys { text, ends, entries, hasher } = self;
        let hash = hasher.hash_one(key);
        if let Some(entry) = entries.find(hash, |entry| entry.of(text) == key) {
            return Some(entry.number);
        }
        let number = u32::try_from(ends.len()).ok()?;
        let entry = Entry { start: text.len(), length: u32::try_from(key.len()).ok()?, number };
        text.push_str(key);
        ends.push(text.len());
        entries.insert_unique(hash, entry, |entry| hasher.hash_one(entry.of(text)));
        Some(number)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_are_numbered_as_they_come() {
        let mut keys = Keys::default();
        let texts = ["b", "", "a", "b", "", "ba", "a", "ab"];
        let numbers: Vec<u32> = texts.iter().map(|text| keys.number_of(text).unwrap()).collect();
        assert_eq!(numbers, [0, 1, 2, 0, 1, 3, 2, 4]);
        assert_eq!(
            (0..keys.len()).map(|number| keys.get(number)).collect::<Vec<_>>(),
            ["b", "", "a", "ba", "ab"]
        );
        let many: Vec<u32> = (0..10_000).map(|k| keys.number_of(&format!("sensor {k}")).unwrap()).collect();
        assert!(many.iter().zip(5..).all(|(&number, expected)| number == expected));
        assert_eq!(keys.number_of("sensor 77"), Some(82));
    }
}
