//! The parts of a file, and lines that are no data.

use super::super::text::Line;

/// A part of the file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Section {
    Name,
    ObjSense,
    ObjName,
    Rows,
    Columns,
    Rhs,
    Ranges,
    Bounds,
    End,
}

impl Section {
    pub(super) const ALL: [Section; 9] = [
        Section::Name,
        Section::ObjSense,
        Section::ObjName,
        Section::Rows,
        Section::Columns,
        Section::Rhs,
        Section::Ranges,
        Section::Bounds,
        Section::End,
    ];

    pub(super) fn name(self) -> &'static str {
        match self {
            Section::Name => "NAME",
            Section::ObjSense => "OBJSENSE",
            Section::ObjName => "OBJNAME",
            Section::Rows => "ROWS",
            Section::Columns => "COLUMNS",
            Section::Rhs => "RHS",
            Section::Ranges => "RANGES",
            Section::Bounds => "BOUNDS",
            Section::End => "ENDATA",
        }
    }

    pub(super) fn named(word: &str) -> Option<Self> {
        Section::ALL.into_iter().find(|section| section.name().eq_ignore_ascii_case(word))
    }

    /// The section that has to come before.
    pub(super) fn needs(self) -> Option<Self> {
        match self {
            Section::Name | Section::ObjSense | Section::ObjName | Section::Rows => None,
            Section::Columns => Some(Section::Rows),
            Section::Rhs | Section::Ranges | Section::Bounds | Section::End => Some(Section::Columns),
        }
    }
}

pub(super) fn is_comment(line: Line<'_>) -> bool {
    line.text.starts_with(['*', '$'])
}

/// Returns whether a comment says that the objective is to be maximized, as PuLP writes in place of `OBJSENSE`.
pub(super) fn is_maximize_comment(line: Line<'_>) -> bool {
    line.text.trim_end().eq_ignore_ascii_case("*SENSE:Maximize")
}

/// Returns whether a line begins or ends integer columns.
pub(super) fn is_marker(line: Line<'_>) -> bool {
    line.text.contains("'MARKER'")
}
