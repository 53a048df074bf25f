//! The possible problems of an input file.

use std::io;

use boundfit_exact::english::{counted, size_text};
use boundfit_exact::{DecimalMark, Foreign, ParseNumberError, TooMuchWork};
use thiserror::Error;

use crate::block::{AskedBlock, Block, listed};
use crate::memory_use::MemoryUse;
use crate::packing::{ANY_FILE, ANY_WINDOW};
use crate::reduction::error::ReductionError;
use crate::row_range::RowRange;

use super::names::advice;
use super::words::{announced, count, named, other_sheets, others_missing, wanted_by};

/// The problem with an input file.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum InputErrorKind {
    /// The operating system reports an error.
    #[error("cannot read: {0}")]
    Io(#[source] io::Error),
    /// A file that is read twice has other readings the second time.
    #[error("the file changed while it was read")]
    Changed,
    /// Something is wrong with a reduction.
    #[error("{0}")]
    Reduction(#[from] ReductionError),
    /// A binary table where text belongs.
    #[error("this is {format}; {instead}")]
    BinaryTable {
        /// The format, with its article.
        format: &'static str,
        /// The ways out.
        instead: &'static str,
    },
    /// A binary table that its library cannot read.
    #[error("cannot read {format}: {reason}")]
    Unreadable {
        /// The format, with its article.
        format: &'static str,
        /// The library's words.
        reason: Foreign,
    },
    /// A cell of a binary table without a value.
    #[error("the cell is null")]
    Null,
    /// A column of a binary table that has no numbers, or no names where names are wanted.
    #[error("the column has the type {data_type}")]
    ColumnType {
        /// The type, as its library names it.
        data_type: Foreign,
        /// The use of the column.
        expected: &'static str,
    },
    /// A number of a binary table that is not finite.
    #[error("not a finite number")]
    NotFinite,
    /// An integer that no double has, where a text in binary64 is made.
    #[error("no double has this value")]
    NotBinary64,
    /// A variable of a MATLAB file that has no columns of numbers.
    #[error("the variable {variable:?} is {what}")]
    NoNumbers {
        /// The variable.
        variable: Foreign,
        /// The content.
        what: Foreign,
    },
    /// A matrix of a MATLAB file where one column is wanted.
    #[error("the variable {variable:?} is a matrix of {rows} rows and {columns} columns")]
    WholeMatrix {
        /// The variable.
        variable: Foreign,
        /// The number of rows of the variable.
        rows: u64,
        /// The number of columns of the variable.
        columns: u64,
    },
    /// Columns of a MATLAB file or in memory that do not make a table.
    #[error("the column {:?} has {}, but {:?} has {}", .first.0, count(.first.1, ["number", "numbers"]), .other.0, .other.1)]
    DifferentLengths {
        /// A column and how many numbers it has.
        first: (Foreign, u64),
        /// Another one.
        other: (Foreign, u64),
    },
    /// A variable of a MATLAB file beyond the limit.
    #[error("refused: the variable {variable:?} has {elements} elements, more than {limit} (the limit)")]
    TooManyElements {
        /// The variable.
        variable: Foreign,
        /// The number of elements that it announces.
        elements: u64,
        /// The most that are read.
        limit: usize,
    },
    /// A compressed file that unpacks to more than the limit.
    #[error("refused: it unpacks to more than {limit} bytes (the limit)")]
    TooMuchUnpacked {
        /// The most bytes.
        limit: u64,
    },
    /// A packed file that unpacks to more than the limit for its size.
    #[error("refused: it unpacks to more than {ANY_FILE} bytes and {ratio} times its size (the limit)")]
    UnpacksTooFar {
        /// The factor of its size up to which a file may unpack.
        ratio: u64,
    },
    /// A packed file of which more has to be held to unpack it than the limit for its size.
    #[error(
        "refused: unpacking it takes more than {ANY_WINDOW} bytes of memory and {ratio} times its size (the limit)"
    )]
    HoldsTooMuch {
        /// The factor of its size that may be held.
        ratio: u64,
    },
    /// A text that would be held in memory, beyond the limit.
    #[error("refused: the file has more than {limit} bytes (the limit)")]
    TextTooLarge {
        /// The most bytes.
        limit: u64,
    },
    /// A workbook beyond the limit.
    #[error("refused: the workbook has or unpacks to more than {limit} bytes (the limit)")]
    WorkbookTooLarge {
        /// The most bytes.
        limit: u64,
    },
    /// Numbers so long, or denominators so many, that exact arithmetic on them takes more than the limit.
    #[error("{0}")]
    TooMuchWork(#[from] TooMuchWork),
    /// A sheet that a workbook does not have.
    #[error("there is no sheet {wanted:?}")]
    UnknownSheet {
        /// The sheet asked for.
        wanted: Foreign,
        /// The sheets in their order.
        available: Vec<Foreign>,
    },
    /// A text that is the name of one sheet and the number of another.
    #[error("{wanted:?} is the name of sheet {named} and the number of another one")]
    SheetNameOrNumber {
        /// The sheet asked for.
        wanted: Foreign,
        /// The sheet with this name.
        named: usize,
    },
    /// A sheet without cells.
    #[error("the sheet is empty{}", other_sheets(.others))]
    EmptySheet {
        /// The other sheets of the workbook.
        others: Vec<Foreign>,
    },
    /// A sheet of what has none.
    #[error("a sheet is asked for, and this is no workbook (.xlsx, .ods)")]
    NoSheets,
    /// JSON that is none, or no records.
    #[error("read as JSON, where {expected} belongs here")]
    Json {
        /// The expected form.
        expected: &'static str,
    },
    /// JSON that ends too early.
    #[error("read as JSON, the file ends here, before {expected}")]
    JsonEnds {
        /// The expected form.
        expected: &'static str,
    },
    /// An object or array of JSON where a number belongs.
    #[error("an object or array, not a number")]
    NestedJson,
    /// A date or a time where a number belongs.
    #[error("a date or a time, not a number")]
    Time,
    /// A number with a unit in its cell.
    #[error("not a number: letters stand behind it, such as a unit")]
    UnitBehind,
    /// A formula of a sheet that was never computed.
    #[error("a formula without a stored value")]
    NoValue,
    /// A directory was named.
    #[error("is a directory")]
    IsDirectory,
    /// An empty file.
    #[error("the file is empty")]
    Empty,
    /// A file of no more lines than are to be passed over.
    #[error("the file has no row behind the first {}, which are passed over", count(*.0, ["line", "lines"]))]
    NothingBehind(u64),
    /// The file ends after its header.
    #[error("the file has a header but no data rows")]
    NoRows,
    /// The file is in an encoding with two bytes per character.
    #[error("the text is UTF-16")]
    Utf16,
    /// A cell or line is not valid UTF-8.
    #[error("invalid UTF-8 at character {} of the {unit}", position + 1)]
    NotUtf8 {
        /// The number of characters of the unit before this one.
        position: usize,
        /// `cell` or `line`.
        unit: &'static str,
    },
    /// The work was stopped from outside.
    #[error("interrupted")]
    Interrupted,
    /// A line without end.
    #[error("the line is longer than {limit} bytes (the limit)")]
    LineTooLong {
        /// The longest line that is read.
        limit: usize,
    },
    /// A row without end, because quotes are never closed.
    #[error("the row is longer than {limit} bytes (the limit); are its quotes closed?")]
    RowTooLong {
        /// The longest row that is read.
        limit: usize,
    },
    /// A table with too many columns.
    #[error("there are more than {limit} columns (the limit)")]
    TooManyColumns {
        /// The most columns that are read.
        limit: usize,
    },
    /// Input that could not be read since an open quote takes in all that follows.
    #[error("a quote that opens in this row is never closed")]
    OpenQuote,
    /// A row with more or fewer cells than the first one.
    #[error("the row has {} where the first row has {expected}", counted(*.found, "cell", "cells"))]
    RaggedRow {
        /// Cells in this row.
        found: usize,
        /// Cells in the first row.
        expected: usize,
    },
    /// A row of a table with commas between columns that has two cells for every one of the first row.
    #[error(
        "the row has {found} cells where the first row has {expected}: decimal commas and commas between columns?"
    )]
    CommasTwice {
        /// Cells in this row.
        found: usize,
        /// Cells in the first row.
        expected: usize,
    },
    /// Rows behind a comment or two blank lines, where no block is chosen.
    #[error("the file has {total} blocks of rows: {}", listed(.blocks, *.total))]
    SeveralBlocks {
        /// The number of all.
        total: usize,
        /// The first of them.
        blocks: Vec<Block>,
    },
    /// A block that a file does not have.
    #[error("there is no block {wanted}; the file has {total}: {}", listed(.blocks, *.total))]
    UnknownBlock {
        /// The block asked for.
        wanted: AskedBlock,
        /// `true` if it is asked for by a number that is the name of a block.
        is_name: bool,
        /// The number of all.
        total: usize,
        /// The first of them.
        blocks: Vec<Block>,
    },
    /// A name of several blocks.
    #[error("{name:?} is the name of {count} blocks")]
    AmbiguousBlock {
        /// The name.
        name: Foreign,
        /// The number of blocks with this name.
        count: usize,
    },
    /// A number of one block that is the name of another.
    #[error("\"{wanted}\" is the name of block {named} and the number of another one")]
    BlockNameOrNumber {
        /// The block asked for.
        wanted: usize,
        /// The block with this name.
        named: usize,
    },
    /// Another block begins: what the readers of rows say to each other.
    #[error("another block of rows begins here")]
    NextBlock,
    /// A word about how a table is written, where it can have no effect.
    #[error("{asked} asked for, and this is {}", if *.fits_sheets { "neither text nor a workbook" } else { "no text table" })]
    OnlyOfText {
        /// The word with its verb: `a block is`.
        asked: &'static str,
        /// `true` if the word is about workbooks as well.
        fits_sheets: bool,
    },
    /// A column that is asked for twice.
    #[error("the same column is asked for as {first:?} and as {second:?}")]
    SameColumn {
        /// The first meaning.
        first: Foreign,
        /// The second meaning.
        second: Foreign,
    },
    /// A text that is the name of one column and the number of another.
    #[error("{wanted:?} is the name of column {named} and the number of another one")]
    NameOrNumber {
        /// The column asked for.
        wanted: Foreign,
        /// The column with this name.
        named: usize,
        /// True if the table may be read as one without a header.
        fits_header: bool,
    },
    /// A column that the table does not have.
    #[error("there is no column {wanted:?}{}", advice(.wanted, .available, *.numbers))]
    UnknownColumn {
        /// The column asked for.
        wanted: Foreign,
        /// The names in the header; none without one.
        available: Vec<Foreign>,
        /// The number of columns, when a number may be given instead of a name.
        numbers: Option<usize>,
    },
    /// A column that a table of one column does not have, when nothing was found that separates columns.
    #[error("there is no column {wanted:?}, and nothing was found that separates columns in {}", .line.quoted())]
    NoDelimiter {
        /// The column asked for.
        wanted: Foreign,
        /// The first line of the table.
        line: Foreign,
    },
    /// A column name that occurs more than once.
    #[error("there are several columns {wanted:?}")]
    AmbiguousColumn {
        /// The column asked for.
        wanted: Foreign,
    },
    /// Rows beyond the last one.
    #[error("{} asked for, but the file has {total} data rows", named(*.rows))]
    RowsBeyondEnd {
        /// The named rows.
        rows: RowRange,
        /// Data rows in the file.
        total: usize,
    },
    /// Rows of which none is wanted.
    #[error("of the file's {total} data rows none {}", wanted_by(.conditions))]
    NoRowWanted {
        /// Data rows in the file.
        total: usize,
        /// The conditions for a row to be wanted.
        conditions: Vec<Foreign>,
    },
    /// A cell that is not a number, or one beyond a limit.
    #[error("{verdict}: {0}", verdict = if .0.kind.is_limit() { "refused" } else { "not a number" })]
    NotANumber(#[from] ParseNumberError),
    /// A comma in a text that a binary table has for a number.
    #[error("not a number: a comma, where the decimal mark of texts in such a file is a point")]
    Comma,
    /// A number with another decimal mark than the numbers before it.
    #[error("a number with a decimal {}, where those before have a decimal {}", .before.other().name(), .before.name())]
    AnotherDecimalMark {
        /// The mark before.
        before: DecimalMark,
    },
    /// The first row after the header has no number in any cell that is asked for.
    #[error("not a number, nor is any other cell of this row that is asked for")]
    NoNumberInFirstRow {
        /// True if a row of units was passed over before this row.
        behind_units: bool,
    },
    /// A cell that goes on behind its closing quote.
    #[error("text stands behind a closing quote")]
    BehindQuotes,
    /// A row of numbers that was said to be one of units.
    #[error("a row of units was asked for, but this one has numbers in all cells that are asked for")]
    NumbersAsUnits,
    /// A row that lacks a number.
    #[error("the value is missing{}", others_missing(*.rows, *.is_complete))]
    Missing {
        /// The number of rows without a number that is asked for.
        rows: usize,
        /// `true` if the whole file was looked at.
        is_complete: bool,
    },
    /// All wanted rows lack a number.
    #[error("the value is missing, and no row that is asked for has all its values ({rows} without)")]
    AllMissing {
        /// The number of rows without a number.
        rows: usize,
    },
    /// Blanks between groups of digits in a table whose columns blanks separate.
    #[error("blanks separate the columns, so that they cannot group digits as well")]
    BlanksTwice,
    /// An error bound below zero.
    #[error("the error bound is negative")]
    NegativeErrorBound,
    /// A row that bounds nothing.
    #[error("the row has neither a lower nor an upper bound")]
    NoBound,
    /// A fraction where half a unit of the last digit is wanted.
    #[error("a fraction has no last digit, of which 'written' is half a unit")]
    NoLastDigit,
    /// Numbers that were not written where half a unit of the last digit is wanted.
    #[error(
        "'written' is half a unit of the last digit written, and {format} stores numbers without their digits"
    )]
    NoDigits {
        /// The format, with its article.
        format: &'static str,
    },
    /// An H- or V-representation without its `begin` line.
    #[error("there is no line \"begin\"")]
    NoBegin,
    /// The line after `begin` is not of the form `rows columns type`.
    #[error("the size line is not understood")]
    BadSizeLine,
    /// A relation in a table of half-planes, whose rows all have the same one.
    #[error("a relation, and every row means a1*theta1 + a2*theta2 <= b")]
    Relation,
    /// A cell beside a1, a2 and b that no header names.
    #[error("a cell beside a1, a2 and b in a table without a header")]
    BesideHalfPlane,
    /// A polyhedron that is not in the plane.
    #[error("the matrix has {0} columns, so it is not about the plane")]
    NotThePlane(usize),
    /// A table of half-planes in more than two variables.
    #[error("there is a column {column:?}, so these are not half-planes of the plane")]
    MoreThanThePlane {
        /// The coefficient of another variable.
        column: Foreign,
    },
    /// More or fewer numbers than announced.
    #[error("{rows} rows of 3 numbers were announced, but there are {found} numbers before \"end\"")]
    CountMismatch {
        /// Rows announced.
        rows: usize,
        /// Numbers found.
        found: usize,
    },
    /// The file stops before `end`.
    #[error("the file stops before the line \"end\"; {}{found} numbers found", announced(*.rows))]
    NoEnd {
        /// Rows announced, if any number was.
        rows: Option<usize>,
        /// Numbers found.
        found: usize,
    },
    /// A `linearity` line that does not list rows of the matrix, or comes after it.
    #[error("this does not list rows of the matrix to come")]
    BadLinearity,
    /// More rows than the limit allows, announced or found.
    #[error("there are more than {limit} rows (the limit)")]
    TooManyRows {
        /// The most rows that are read.
        limit: usize,
    },
    /// Input that takes more memory than the budget has ([`MemoryBudget`](crate::MemoryBudget)).
    #[error("{what} {needed} of memory, more than {limit} (the limit)", needed = size_text(*.needed), limit = size_text(*.limit))]
    TooMuchMemory {
        /// The memory that was requested last.
        what: MemoryUse,
        /// The number of bytes that all input held takes at least.
        needed: u64,
        /// The most bytes that may be held.
        limit: u64,
    },
    /// More wanted rows than the caller takes.
    #[error("there are more than {limit} rows")]
    TooManyWanted {
        /// The number of rows that the caller takes.
        limit: usize,
    },
    /// A matrix of unknown size that ends within a row.
    #[error("the last row has {found} of 3 numbers")]
    PartOfARow {
        /// Numbers in the last row.
        found: usize,
    },
    /// An option of cdd or lrs that makes the set another one than that of the rows.
    #[error("this option makes the set another one")]
    OtherSet {
        /// The accepted form.
        instead: &'static str,
    },
    /// A matrix after the matrix.
    #[error("a second matrix begins here")]
    SecondMatrix,
    /// A row of a V-representation that starts with a negative number.
    #[error("the row starts with a negative number")]
    NegativeWeight,
    /// A point on a `linearity` line of a V-representation.
    #[error("the row is a point, but a linearity line lists it")]
    LinearPoint,
}
