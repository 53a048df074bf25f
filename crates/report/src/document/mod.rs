//! Reports as documents: made once of blocks and typed text, and written as plain text, LaTeX or Markdown.

mod inline;
mod latex;
mod long;
mod markdown;
mod plain;
mod wrap;

use std::io::{self, Write};

pub(crate) use inline::{Inline, Operator, Symbol, THETA, Text};
pub(crate) use long::{Column, LongTable, Rows};
pub(crate) use wrap::WIDTH;
pub use wrap::in_page_width;

/// The title of the remaining results, where they have one.
const RESULTS: &str = "Further results";

/// A report, to be written in one of several languages. Its tables of vertices are made as they are written.
#[derive(Debug, Default)]
pub struct Document<'a>(Vec<Block<'a>>);

/// A part of a report.
#[derive(Debug)]
pub(crate) enum Block<'a> {
    /// The topic of the following blocks.
    Title(Text),
    /// A sentence that opens a part: plain text sets it like a title, markup like a paragraph.
    Lead(Text),
    Paragraph(Text),
    Facts(Facts),
    /// A line for each remaining result. Plain text sets them flush left, markup under a title.
    Results(Vec<(Text, Text)>),
    Table(Table),
    LongTable(LongTable<'a>),
    /// A blank line in plain text, where something begins that has no title.
    Space,
}

/// Labels, and what belongs to each.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Facts {
    /// Plain text gives the labels this much room.
    pub(crate) width: usize,
    pub(crate) rows: Vec<(Text, Text)>,
}

/// A table: its header, and rows of as many cells.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(crate) struct Table {
    pub(crate) header: Vec<Text>,
    pub(crate) rows: Vec<Vec<Text>>,
}

impl Table {
    pub(crate) fn new<T: Into<Text>>(header: impl IntoIterator<Item = T>, rows: Vec<Vec<Text>>) -> Self {
        Table { header: header.into_iter().map(Into::into).collect(), rows }
    }
}

impl<'a> Document<'a> {
    /// The most readings, values or runs that a report lists unless more are asked for. JSON and CSV have all.
    pub const MOST_LISTED: usize = 40;

    pub(crate) fn new(blocks: Vec<Block<'a>>) -> Self {
        Document(blocks)
    }

    /// Writes the report as plain text, in parts.
    ///
    /// # Errors
    /// The first error of what is written to.
    pub fn write_text(&self, out: &mut dyn Write) -> io::Result<()> {
        plain::write(&self.0, out)
    }

    /// The report as plain text.
    pub fn to_text(&self) -> String {
        let mut text = Vec::new();
        // Writing to memory does not fail.
        let written = self.write_text(&mut text);
        debug_assert!(written.is_ok());
        String::from_utf8(text).unwrap_or_default()
    }

    /// The report in LaTeX: a fragment to be read into a document that uses the package `booktabs`. Tables and lines keep
    /// within the width of the page: columns with much in them are broken into lines.
    pub fn to_latex(&self) -> String {
        latex::written(&self.0)
    }

    /// The report in Markdown, as GitHub and Pandoc read it.
    pub fn to_markdown(&self) -> String {
        markdown::written(&self.0)
    }

    /// Adds a report behind this one.
    pub fn append(&mut self, other: Document<'a>) {
        self.0.extend(other.0);
    }

    /// Adds a line to the remaining results at the end of a report.
    pub fn add_result(&mut self, label: &str, text: &str) {
        let line = (label.into(), text.into());
        match self.0.last_mut() {
            Some(Block::Results(lines)) => lines.push(line),
            _ => self.0.push(Block::Results(vec![line])),
        }
    }
}
