//! The text of each row that says to which group the row belongs.

use super::pieces::Pieces;

/// One text per row, kept once for rows that follow each other and for two groups that take turns.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct RowKeys {
    texts: Pieces<String>,
    text_of: Vec<u32>,
}

impl RowKeys {
    /// Returns the number of rows.
    pub fn len(&self) -> usize {
        self.text_of.len()
    }

    /// Returns whether there are none.
    pub fn is_empty(&self) -> bool {
        self.text_of.is_empty()
    }

    /// The text of a row.
    ///
    /// # Panics
    /// When there are not that many.
    #[allow(clippy::indexing_slicing, reason = "documented to panic")]
    pub fn get(&self, row: usize) -> &str {
        self.texts.get(self.text_of[row] as usize)
    }

    /// All texts. Some may be equal.
    pub fn texts(&self) -> impl ExactSizeIterator<Item = &str> {
        (0..self.texts.len()).map(|text| self.texts.get(text))
    }

    /// The position of the text of each row among [`RowKeys::texts`].
    pub fn text_of(&self) -> &[u32] {
        &self.text_of
    }

    /// The texts of some rows.
    ///
    /// # Panics
    /// When there are not that many.
    #[must_use]
    pub fn at(&self, rows: &[usize]) -> Self {
        let mut some = RowKeys::default();
        for &row in rows {
            some.push(self.get(row));
        }
        some
    }

    /// Adds the text of a row, and returns its position among the texts.
    pub(crate) fn push(&mut self, text: &str) -> u32 {
        let count = self.texts.len();
        let mut recent = (count.saturating_sub(2)..count).rev();
        let known = recent.find(|&own| self.texts.get(own) == text).unwrap_or_else(|| {
            self.texts.push(text);
            count
        });
        self.text_of.push(known as u32);
        known as u32
    }

    /// Adds the text of a row by the position that [`RowKeys::push`] returned.
    #[inline]
    pub(crate) fn push_known(&mut self, text: u32) -> u32 {
        self.text_of.push(text);
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_are_kept_once_while_one_or_two_take_turns() {
        let mut keys = RowKeys::default();
        assert!(keys.is_empty());
        let rows = ["a", "b", "a", "b", "b", "c", "b", "a", ""];
        let last = rows.map(|text| keys.push(text))[8];
        keys.push_known(last);
        assert_eq!(keys.texts().collect::<Vec<_>>(), ["a", "b", "c", "a", ""]);
        assert_eq!(keys.text_of(), [0, 1, 0, 1, 1, 2, 1, 3, 4, 4]);
        assert_eq!((0..9).map(|row| keys.get(row)).collect::<Vec<_>>(), rows);
        let some = keys.at(&[2, 5, 7]);
        assert_eq!((0..some.len()).map(|row| some.get(row)).collect::<Vec<_>>(), ["a", "c", "a"]);
    }
}
