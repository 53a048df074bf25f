//! Lines of data: what stands where, in free MPS and in the columns of the fixed one.

use super::super::error::{ModelError, ModelErrorKind};
use super::super::names::Names;
use super::super::text::{Field, Line, lines};
use super::section::{Section, is_comment, is_marker};
use crate::read::ModelLimits;

/// The way in which the pieces of a line are told apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Layout {
    /// Blanks and tabs.
    Free,
    /// Columns 2-3, 5-12, 15-22, 25-36, 40-47 and 50-61: names may contain blanks.
    Fixed,
}

/// The fields of the fixed format as characters from and before which they stand, counted from 0.
const FIELDS: [(usize, usize); 6] = [(1, 3), (4, 12), (14, 22), (24, 36), (39, 47), (49, 61)];

/// A line of data.
#[derive(Debug, Clone, Copy)]
pub(super) struct Record<'a> {
    /// The type of a row or a bound.
    pub(super) code: Option<Field<'a>>,
    /// A column, or the name of a vector.
    pub(super) name: Option<Field<'a>>,
    /// Names of rows or columns, and numbers.
    pub(super) pairs: [Option<(Field<'a>, Option<Field<'a>>)>; 2],
}

/// Returns what a line of a section has to be.
fn expected(section: Section) -> &'static str {
    match section {
        Section::Rows => "a type and a name: N, L, G or E, then a row",
        Section::Columns => "a column, then one or two rows, each with its coefficient",
        Section::Rhs => "perhaps a name for all of them, then one or two rows, each with its right-hand side",
        Section::Ranges => "perhaps a name for all of them, then one or two rows, each with its range",
        Section::Bounds => {
            "a type, perhaps a name for all of them, a column, and the bound unless the type says it"
        }
        Section::Name | Section::ObjSense | Section::ObjName | Section::End => "one word",
    }
}

impl<'a> Record<'a> {
    /// The record of a line of data in ROWS, COLUMNS, RHS, RANGES or BOUNDS.
    pub(super) fn new(
        line: Line<'a>,
        section: Section,
        layout: Layout,
        columns: &Names<'_>,
    ) -> Result<Self, ModelError> {
        let record = match layout {
            Layout::Free => free(line, section, columns),
            Layout::Fixed => {
                let fields = cut(line).ok_or_else(|| line.whole().error(ModelErrorKind::FixedColumns))?;
                fixed(fields, section)
            }
        };
        let refused = || {
            let kind = ModelErrorKind::Record { section: section.name(), expected: expected(section) };
            line.whole().error(kind)
        };
        record.ok_or_else(refused)
    }
}

fn free<'a>(line: Line<'a>, section: Section, columns: &Names<'_>) -> Option<Record<'a>> {
    // From a word with a $ on that is not the first one, nor the name of a row, a line is a comment.
    let words: Vec<Field<'a>> = line
        .words()
        .enumerate()
        .take_while(|(place, word)| {
            *place < if section == Section::Rows { 2 } else { 1 } || !word.text.starts_with('$')
        })
        .map(|(_, word)| word)
        .take(7)
        .collect();
    let empty = Record { code: None, name: None, pairs: [None; 2] };
    let pair = |row, number| Some((row, Some(number)));
    Some(match (section, words.as_slice()) {
        (Section::Rows, &[code, name]) => Record { code: Some(code), name: Some(name), ..empty },
        (Section::Columns | Section::Rhs | Section::Ranges, &[name, row, number]) => {
            Record { name: Some(name), pairs: [pair(row, number), None], ..empty }
        }
        (Section::Columns | Section::Rhs | Section::Ranges, &[name, row, number, row2, number2]) => {
            Record { name: Some(name), pairs: [pair(row, number), pair(row2, number2)], ..empty }
        }
        (Section::Rhs | Section::Ranges, &[row, number]) => {
            Record { pairs: [pair(row, number), None], ..empty }
        }
        (Section::Rhs | Section::Ranges, &[row, number, row2, number2]) => {
            Record { pairs: [pair(row, number), pair(row2, number2)], ..empty }
        }
        (Section::Bounds, &[code, column]) => {
            Record { code: Some(code), pairs: [Some((column, None)), None], ..empty }
        }
        (Section::Bounds, &[code, first, second]) => {
            let needs_number = ["UP", "LO", "FX"].iter().any(|known| code.text.eq_ignore_ascii_case(known));
            if needs_number || columns.find(second.text).is_none() && columns.find(first.text).is_some() {
                Record { code: Some(code), pairs: [pair(first, second), None], ..empty }
            } else {
                let pairs = [Some((second, None)), None];
                Record { code: Some(code), name: Some(first), pairs }
            }
        }
        (Section::Bounds, &[code, name, column, number]) => {
            Record { code: Some(code), name: Some(name), pairs: [pair(column, number), None] }
        }
        _ => return None,
    })
}

/// The six fields of a line; `None` where something stands between them.
fn cut(line: Line<'_>) -> Option<[Option<Field<'_>>; 6]> {
    let mut fields = [None; 6];
    let mut before = 0;
    for (field, (from, to)) in fields.iter_mut().zip(FIELDS) {
        let [gap, start, end] = [before, from, to].map(|place| byte_of(line.text, place));
        before = to;
        let piece = line.piece(start, end);
        if !line.piece(gap, start).text.is_empty() || piece.text.contains('\t') {
            return None;
        }
        // In the third and the fifth field a $ begins a comment.
        if [14, 39].contains(&from) && line.text.get(start..).is_some_and(|rest| rest.starts_with('$')) {
            return Some(fields);
        }
        *field = Some(piece).filter(|piece| !piece.text.is_empty());
    }
    let rest = line.piece(byte_of(line.text, before), line.text.len());
    rest.text.is_empty().then_some(fields)
}

/// Returns where a character of a text begins; where the text ends, if it has fewer.
fn byte_of(text: &str, character: usize) -> usize {
    // Most lines are ASCII.
    if text.get(..character).is_some_and(str::is_ascii) {
        return character;
    }
    text.char_indices().nth(character).map_or(text.len(), |(start, _)| start)
}

fn fixed(fields: [Option<Field<'_>>; 6], section: Section) -> Option<Record<'_>> {
    let [code, name, first, first_number, second, second_number] = fields;
    let is_row = section == Section::Rows;
    let is_bound = section == Section::Bounds;
    let pairs = [(first, first_number), (second, second_number)];
    let shape_is_right = code.is_some() == (is_row || is_bound)
        && (name.is_some() || !(is_row || section == Section::Columns))
        && first.is_some() != is_row
        && (!is_row || first_number.is_none())
        && (!(is_row || is_bound) || second.is_none())
        && pairs.iter().all(|(name, number)| name.is_some() == number.is_some() || is_bound);
    let pairs = pairs.map(|(name, number)| name.map(|name| (name, number)));
    shape_is_right.then_some(Record { code, name, pairs })
}

/// The blanks in the fields of the fixed format.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Blanks {
    /// No field contains one, up to the first line out of the columns.
    None,
    /// A field contains one, and every line of data is in the columns.
    InFixedLines,
    /// A field contains one, but a later line is not in the columns.
    BeforeOtherLines,
}

/// Looks for blanks in fields of the fixed format.
pub(super) fn fields_with_blanks(text: &str, limits: &ModelLimits) -> Blanks {
    let mut found = false;
    let mut is_cut = false;
    let otherwise = |found| if found { Blanks::BeforeOtherLines } else { Blanks::None };
    for line in lines(text, limits) {
        let Ok(line) = line else { return otherwise(found) };
        if is_comment(line) || line.text.trim().is_empty() || is_marker(line) {
            continue;
        }
        if !line.text.starts_with([' ', '\t']) {
            let section = line.words().next().and_then(|word| Section::named(word.text));
            is_cut = !matches!(section, None | Some(Section::Name | Section::ObjSense | Section::ObjName));
            if section == Some(Section::End) {
                break;
            }
        } else if is_cut {
            let Some(fields) = cut(line) else { return otherwise(found) };
            found |= fields.iter().flatten().any(|field| field.text.contains(' '));
        }
    }
    if found { Blanks::InFixedLines } else { Blanks::None }
}
