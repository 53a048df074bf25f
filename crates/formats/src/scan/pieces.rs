//! Pieces of text in one buffer.

/// One piece of text per row, in one buffer.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Pieces<B> {
    buffer: B,
    ends: Vec<usize>,
}

impl<B> Pieces<B> {
    /// Returns the number of pieces.
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// Returns whether there are none.
    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    #[allow(
        clippy::indexing_slicing,
        reason = "documented to panic where it is asked; ends are pushed in ascending order and within the buffer"
    )]
    fn range(&self, index: usize) -> std::ops::Range<usize> {
        let start = index.checked_sub(1).map_or(0, |before| self.ends[before]);
        start..self.ends[index]
    }
}

impl Pieces<String> {
    /// A piece.
    ///
    /// # Panics
    /// When there are not that many.
    pub fn get(&self, index: usize) -> &str {
        &self.buffer[self.range(index)]
    }

    pub(crate) fn push(&mut self, piece: &str) {
        self.buffer.push_str(piece);
        self.ends.push(self.buffer.len());
    }
}

impl Pieces<Vec<u8>> {
    /// A piece.
    ///
    /// # Panics
    /// When there are not that many.
    #[allow(clippy::indexing_slicing, reason = "the range is one of the buffer, by range()")]
    pub fn get(&self, index: usize) -> &[u8] {
        &self.buffer[self.range(index)]
    }

    pub(crate) fn push(&mut self, piece: &[u8]) {
        self.buffer.extend_from_slice(piece);
        self.ends.push(self.buffer.len());
    }
}
