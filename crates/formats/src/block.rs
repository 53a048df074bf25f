//! One block of rows: as it is asked for, and as a message lists it.

use std::fmt;

use boundfit_exact::Foreign;

use crate::quoted_name::in_quotes;

/// The block to read from a file with several blocks.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum AskedBlock {
    /// All rows, as if there were one.
    All,
    /// The block with this number, from 1.
    Number(usize),
    /// The block behind a comment with this text.
    Name(Foreign),
}

impl AskedBlock {
    /// Reads `all`, a number from 1 or a name; 0 is no number of a block. A text in quotes is a name.
    pub fn parse(text: &str) -> Option<Self> {
        let text = text.trim();
        if let Some(name) = in_quotes(text) {
            return Some(AskedBlock::Name(name.trim().into()));
        }
        match text.parse() {
            Ok(0) => None,
            Ok(number) => Some(AskedBlock::Number(number)),
            Err(_) if text.is_empty() => None,
            Err(_) if text == "all" => Some(AskedBlock::All),
            Err(_) => Some(AskedBlock::Name(text.into())),
        }
    }
}

impl fmt::Display for AskedBlock {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            AskedBlock::All => f.write_str("all"),
            AskedBlock::Number(number) => write!(f, "{number}"),
            AskedBlock::Name(name) => write!(f, "{name:?}"),
        }
    }
}

/// A block as a message lists it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Block {
    /// The comment before it.
    pub name: Option<Foreign>,
    /// The block's first and last line.
    pub lines: [u64; 2],
    /// The number of its rows that have a number.
    pub rows: usize,
}

/// The blocks in a message: `1 (run 1), lines 2 to 4, 3 rows; 2, …`.
pub(crate) fn listed(blocks: &[Block], total: usize) -> String {
    let block = |(number, block): (usize, &Block)| {
        let Block { name, lines: [first, last], rows } = block;
        let name = name.as_ref().filter(|name| !name.is_empty());
        let name = name.map(|name| format!(" ({name})")).unwrap_or_default();
        let lines = if first == last { format!("line {first}") } else { format!("lines {first} to {last}") };
        let rows = format!("{rows} {}", if *rows == 1 { "row" } else { "rows" });
        format!("{number}{name}, {lines}, {rows}")
    };
    let mut list: Vec<String> = (1..).zip(blocks).map(block).collect();
    if total > blocks.len() {
        list.push(format!("and {} more", total - blocks.len()));
    }
    list.join("; ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_are_asked_for_by_number_or_name() {
        assert_eq!(AskedBlock::parse("2"), Some(AskedBlock::Number(2)));
        assert_eq!(AskedBlock::parse(" run 2 "), Some(AskedBlock::Name("run 2".into())));
        assert_eq!(AskedBlock::parse("all"), Some(AskedBlock::All));
        assert_eq!(["0", " "].map(AskedBlock::parse), [None, None]);
        let named = ["\"2\"", "'2'", " \" 2\" "].map(AskedBlock::parse);
        assert_eq!(named, [(); 3].map(|()| Some(AskedBlock::Name("2".into()))));
        assert_eq!(AskedBlock::parse("\"all\""), Some(AskedBlock::Name("all".into())));
        assert_eq!(AskedBlock::parse("\"\""), Some(AskedBlock::Name("\"\"".into())));
    }
}
