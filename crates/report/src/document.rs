//! A report as blocks, which Markdown and LaTeX write each in their way.

/// A part of a text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Piece {
    /// Words, numbers and formulas of the report.
    Own(String),
    /// What the user wrote: names of columns and files, conditions.
    Given(String),
}

/// A text, of which it is known what the user wrote.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(crate) struct Text(pub(crate) Vec<Piece>);

impl Text {
    /// A text of the report.
    pub(crate) fn own(text: impl Into<String>) -> Self {
        Text(vec![Piece::Own(text.into())])
    }

    /// A text of the user.
    pub(crate) fn given(text: impl Into<String>) -> Self {
        Text(vec![Piece::Given(text.into())])
    }

    /// The same with more behind it.
    pub(crate) fn then(mut self, other: Text) -> Self {
        for piece in other.0 {
            match (self.0.last_mut(), piece) {
                (Some(Piece::Own(before)), Piece::Own(more)) => before.push_str(&more),
                (_, piece) => self.0.push(piece),
            }
        }
        self
    }

    /// The text as it stands in a plain report.
    pub(crate) fn plain(&self) -> String {
        self.written(|own| own.to_owned(), |given| given.to_owned())
    }

    /// The pieces, each written in its way, together.
    pub(crate) fn written(&self, own: impl Fn(&str) -> String, given: impl Fn(&str) -> String) -> String {
        let pieces = self.0.iter().map(|piece| match piece {
            Piece::Own(text) => own(text),
            Piece::Given(text) => given(text),
        });
        pieces.collect()
    }
}

/// A part of a report.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Block {
    /// What follows is about this.
    Title(String),
    /// A paragraph.
    Paragraph(Text),
    /// Labels, some of them blank, and what belongs to each.
    Facts(Vec<(String, Text)>),
    /// A table: its header, and rows of as many cells.
    Table(Vec<String>, Vec<Vec<String>>),
}

impl Block {
    /// A table with a header in words.
    pub(crate) fn table(header: &[&str], rows: Vec<Vec<String>>) -> Self {
        Block::Table(header.iter().map(|cell| (*cell).to_owned()).collect(), rows)
    }

    /// Whether there is nothing in it.
    pub(crate) fn is_blank(&self) -> bool {
        match self {
            Block::Title(_) | Block::Paragraph(_) => false,
            Block::Facts(facts) => facts.is_empty(),
            Block::Table(_, rows) => rows.is_empty(),
        }
    }
}
