//! Reads a variable's own description, which stands before its numbers.

use std::io::Read;

use super::elements::{Damage, Elements, Tag};

/// MATLAB's names have up to 63 characters.
pub(super) const LONGEST_NAME: u64 = 255;
/// More dimensions than anybody uses.
const MOST_DIMENSIONS: u64 = 64;
/// Element types of the parts.
const INT8: u32 = 1;
const INT32: u32 = 5;
const UINT32: u32 = 6;
/// The class of structs.
const STRUCT: u32 = 2;
/// More bytes than the names of all fields of a struct have.
const LONGEST_FIELDS: u64 = 1 << 20;

/// A variable of a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Variable {
    pub(super) name: String,
    pub(super) content: Content,
}

/// The content of a variable.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Content {
    /// A full matrix of real numbers, at least one, column after column.
    Numbers { rows: u64, columns: u64 },
    /// One struct, whose fields follow.
    Struct,
    /// Something else, with its article.
    Other(String),
}

impl Content {
    /// Returns the number of columns of a table that the variable makes: a vector is one, lying or standing.
    pub(super) fn columns(&self) -> u64 {
        match self {
            Content::Numbers { rows: 1, .. } => 1,
            Content::Numbers { columns, .. } => *columns,
            Content::Struct | Content::Other(_) => 0,
        }
    }

    /// Returns the number of rows of these columns.
    pub(super) fn rows(&self) -> u64 {
        match self {
            Content::Numbers { rows: 1, columns } => *columns,
            Content::Numbers { rows, .. } => *rows,
            Content::Struct | Content::Other(_) => 0,
        }
    }
}

impl Variable {
    /// The name of one of its columns, counted from 1.
    pub(super) fn column_name(&self, column: u64) -> String {
        if self.content.columns() == 1 { self.name.clone() } else { format!("{}(:,{column})", self.name) }
    }

    /// Reads everything up to the numbers; a variable without a name is MATLAB's own.
    pub(super) fn read<R: Read>(elements: &mut Elements<R>) -> Result<Self, Damage> {
        let flags = part(elements, UINT32, 8, "the flags of a variable")?;
        let flags = flags.as_chunks().0.first().map(|&word| elements.number(word));
        let flags = flags.ok_or_else(|| Damage::format("a variable has no flags"))?;
        let class = flags & 0xff;
        // An object goes on with its name.
        let dimensions = match class {
            17 => Vec::new(),
            _ => part(elements, INT32, 4 * MOST_DIMENSIONS, "the list of dimensions")?,
        };
        let dimensions: Vec<u32> =
            dimensions.as_chunks().0.iter().map(|&word| elements.number(word)).collect();
        if dimensions.iter().any(|&dimension| dimension > i32::MAX as u32) {
            return Err(Damage::format("a dimension is negative"));
        }
        let name = part(elements, INT8, LONGEST_NAME, "the name of a variable")?;
        let name = String::from_utf8_lossy(&name).trim_end_matches('\0').to_owned();
        let content = match (name_of(class), &dimensions[..]) {
            (Some(_), dimensions) if class == STRUCT => {
                match dimensions.iter().map(|&size| u64::from(size)).product() {
                    1 => Content::Struct,
                    0 => Content::Other("an empty struct".to_owned()),
                    elements => Content::Other(format!("an array of {elements} structs")),
                }
            }
            (Some(other), _) => Content::Other(other.to_owned()),
            (None, _) if flags & 0x800 != 0 => Content::Other("complex".to_owned()),
            (None, []) | (None, [_]) => return Err(Damage::format("a variable has no dimensions")),
            (None, dimensions) if dimensions.contains(&0) => Content::Other("empty".to_owned()),
            (None, &[rows, columns]) => Content::Numbers { rows: rows.into(), columns: columns.into() },
            (None, more) => Content::Other(format!("an array of {} dimensions", more.len())),
        };
        Ok(Variable { name, content })
    }
}

/// The names of the fields of a struct, which stand behind its own name.
pub(super) fn fields<R: Read>(elements: &mut Elements<R>) -> Result<Vec<String>, Damage> {
    let length = part(elements, INT32, 4, "the length of the names of fields")?;
    let length = length.as_chunks().0.first().map(|&word| elements.number(word));
    let length = length.and_then(|length| usize::try_from(length).ok()).filter(|length| *length > 0);
    let length = length.ok_or_else(|| Damage::format("the names of fields have no length"))?;
    let names = part(elements, INT8, LONGEST_FIELDS, "the names of fields")?;
    let name = |name: &[u8]| {
        let end = name.iter().position(|&byte| byte == 0).unwrap_or(name.len());
        String::from_utf8_lossy(name.get(..end).unwrap_or_default()).into_owned()
    };
    Ok(names.chunks(length).map(name).collect())
}

/// A part of a known type.
fn part<R: Read>(elements: &mut Elements<R>, kind: u32, most: u64, what: &str) -> Result<Vec<u8>, Damage> {
    let tag: Tag = elements.some_tag()?;
    if tag.kind != kind {
        return Err(Damage::format(format!("{what} has the element type {}, not {kind}", tag.kind)));
    }
    elements.short(tag, most, what)
}

/// Returns the name, with its article, of a class that is not one of numbers.
fn name_of(class: u32) -> Option<&'static str> {
    Some(match class {
        1 => "a cell array",
        2 => "a struct",
        3 | 17 => "an object (a table, a string or the like)",
        4 => "text",
        5 => "sparse",
        6..=15 => return None,
        16 => "a function handle",
        _ => "of an unknown class",
    })
}
