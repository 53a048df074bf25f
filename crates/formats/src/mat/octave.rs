//! Reads the output of Octave's `save -text`: one variable after the other. Lines with its name, type and
//! size precede its numbers, which are text, row by row.
//!
//! Source: Octave, `libinterp/corefcn/ls-oct-text.cc` and the `save_ascii` of each type.

use std::io::{self, BufRead, BufReader, Read};

use super::elements::Damage;
use super::file::MatFile;
use super::numbers::Numbers;
use super::search::Search;
use super::variable::{Content, Variable};
use crate::budget::HeldMemory;
use crate::error::InputErrorKind;
use crate::limits::SizeLimits;
use crate::memory::MemoryNumbers;
use crate::memory_use::MemoryUse;

/// The name of such files in reports.
pub(super) const FORMAT: &str = "Octave's text";

/// The memory of a number beside its text: a [`String`], which is moved once when a matrix is complete, and what the allocator
/// adds. Measured as the largest memory of a process that read 2·10⁶ numbers.
const BYTES_PER_TEXT: u64 = 72;

/// Reads all variables of a file that starts with these bytes and goes on in this file.
pub(super) fn read(
    search: &mut Search,
    start: &[u8],
    file: &mut MatFile,
    sizes: &SizeLimits,
) -> Result<(), InputErrorKind> {
    let bytes = BufReader::new(start.chain(file));
    let mut text = Text { bytes, line: 0, read: 0, last: String::new(), is_ahead: false, sizes };
    let mut go_through = || -> Result<(), Damage> {
        while let Some(name) = text.name()? {
            text.variable(Some(&mut *search), name, sizes.nesting)?;
        }
        Ok(())
    };
    go_through().map_err(|damage| {
        let reason = match damage {
            Damage::Refused(problem) => return problem,
            Damage::Format(reason) => format!("line {}: {reason}", text.line),
            Damage::Io(error) if error.kind() == io::ErrorKind::UnexpectedEof => {
                format!("it stops within a variable, on line {}", text.line)
            }
            Damage::Io(error) => return error.into(),
        };
        InputErrorKind::Unreadable { format: FORMAT, reason: reason.into() }
    })
}

/// The lines of a file.
struct Text<'a, R> {
    bytes: R,
    /// The number of the last line, and what stands on it.
    line: u64,
    last: String,
    /// `true` if that line was only looked at: it is the next one again.
    is_ahead: bool,
    /// The number of bytes read.
    read: u64,
    sizes: &'a SizeLimits,
}

impl<R: BufRead> Text<'_, R> {
    /// Goes on to the next line; `false` at the end.
    fn next(&mut self) -> Result<bool, Damage> {
        if std::mem::take(&mut self.is_ahead) {
            return Ok(true);
        }
        let mut line = Vec::new();
        let most = (self.sizes.line as u64).saturating_add(1);
        let count = self.bytes.by_ref().take(most).read_until(b'\n', &mut line)?;
        if count > self.sizes.line {
            return Err(Damage::Refused(InputErrorKind::LineTooLong { limit: self.sizes.line }));
        }
        self.read += count as u64;
        self.line += u64::from(count > 0);
        self.last = String::from_utf8_lossy(&line).trim_end().to_owned();
        Ok(count > 0)
    }

    /// Goes on to the line that must follow.
    fn must(&mut self) -> Result<(), Damage> {
        if self.next()? { Ok(()) } else { Err(Damage::Io(io::ErrorKind::UnexpectedEof.into())) }
    }

    /// Refuses a line with more numbers of a variable than it says that it has.
    fn no_more(&mut self, name: &str) -> Result<(), Damage> {
        while self.next()? {
            if self.last.starts_with(['#', '%']) {
                self.is_ahead = true;
                break;
            }
            if !self.last.is_empty() {
                return Err(too_many(name));
            }
        }
        Ok(())
    }

    /// Returns the value that the last line has for this word, as `# rows: 3` has 3 for `rows`.
    fn said(&self, word: &str) -> Option<&str> {
        let text = self.last.strip_prefix(['#', '%'])?.trim_start();
        Some(text.strip_prefix(word)?.strip_prefix(':')?.trim())
    }

    /// The name of the next variable; nothing at the end.
    fn name(&mut self) -> Result<Option<String>, Damage> {
        while self.next()? {
            if let Some(name) = self.said("name") {
                return Ok(Some(name.to_owned()));
            }
        }
        Ok(None)
    }

    /// Reads the value that the next line must have for a word.
    fn value(&mut self, word: &str) -> Result<String, Damage> {
        self.must()?;
        match self.said(word) {
            Some(value) => Ok(value.to_owned()),
            None => Err(Damage::format(format!("{:?} where \"# {word}: ...\" belongs", self.last))),
        }
    }

    /// The number that the next line must say of a word.
    fn count(&mut self, word: &str) -> Result<u64, Damage> {
        let value = self.value(word)?;
        let count = value.parse().ok().filter(|count| *count <= i32::MAX as u64);
        count.ok_or_else(|| Damage::format(format!("{value:?} is no number of {word}")))
    }

    /// Reads a variable or what is in one, of which the name was read; `search` takes those that have a name of their own.
    fn variable(&mut self, search: Option<&mut Search>, name: String, nesting: usize) -> Result<(), Damage> {
        let kind = self.value("type")?;
        let before = self.read;
        let words: Vec<&str> = kind.strip_prefix("global ").unwrap_or(&kind).split(' ').collect();
        let is_number = |word: &str| {
            let bits = word.trim_start_matches('u').strip_prefix("int");
            word == "float" || bits.is_some_and(|bits| matches!(bits, "8" | "16" | "32" | "64"))
        };
        let content = match words.as_slice() {
            ["scalar"] | ["bool"] => Content::Numbers { rows: 1, columns: 1 },
            [kind, "scalar"] if is_number(kind) => Content::Numbers { rows: 1, columns: 1 },
            ["matrix"] | ["bool", "matrix"] => return self.matrix(search, name),
            [kind, "matrix"] if is_number(kind) => return self.matrix(search, name),
            ["range" | "double_range"] => return self.range(search, name),
            ["string" | "sq_string"] => {
                self.pass_strings()?;
                Content::Other("text".to_owned())
            }
            ["scalar", "struct"] => return self.fields(search, &name, nesting),
            ["struct"] => {
                self.fields(None, &name, nesting)?;
                Content::Other("an array of structs".to_owned())
            }
            ["cell"] => {
                self.cells(nesting)?;
                Content::Other("a cell array".to_owned())
            }
            _ => Content::Other(format!("of the type {kind:?}")),
        };
        let Some(search) = search else { return Ok(()) };
        search.add(Variable { name: name.clone(), content }, self.read - before, |_, memory| {
            self.must()?;
            self.hold(memory)?;
            let number = self.last.trim().to_owned();
            self.no_more(&name)?;
            Ok(texts(vec![number]))
        })?;
        Ok(())
    }

    /// Reads a matrix: with rows and columns, row by row, or with dimensions, column by column.
    fn matrix(&mut self, search: Option<&mut Search>, name: String) -> Result<(), Damage> {
        self.must()?;
        let dimensions = self.said("ndims").map(str::to_owned);
        let (content, is_by_row) = match (dimensions, self.said("rows")) {
            (Some(_), _) => {
                self.must()?;
                let sizes = self.last.split_whitespace().map(|size| size.parse::<u32>().ok());
                let sizes: Option<Vec<u32>> = sizes.collect();
                let content = match sizes.as_deref() {
                    Some(&[rows, columns]) => Content::Numbers { rows: rows.into(), columns: columns.into() },
                    Some(more) => Content::Other(format!("an array of {} dimensions", more.len())),
                    None => return Err(Damage::format(format!("{:?} are no dimensions", self.last))),
                };
                (content, false)
            }
            (None, Some(rows)) => {
                let rows = rows.parse::<u32>().map_err(|_| Damage::format("rows that are no number"))?;
                (Content::Numbers { rows: rows.into(), columns: self.count("columns")? }, true)
            }
            (None, None) => {
                return Err(Damage::format(format!("{:?} where \"# rows: ...\" belongs", self.last)));
            }
        };
        let content = match content {
            Content::Numbers { rows: 0, .. } | Content::Numbers { columns: 0, .. } => {
                Content::Other("empty".to_owned())
            }
            content => content,
        };
        let Some(search) = search else { return Ok(()) };
        let (rows, columns) = match content {
            Content::Numbers { rows, columns } => (rows, columns),
            _ => (0, 0),
        };
        // A number has a character and a blank or line end.
        let bytes = rows.saturating_mul(columns).saturating_mul(2);
        search.add(Variable { name: name.clone(), content }, bytes, |_, memory| match is_by_row {
            true => self.by_row(&name, rows, columns, memory),
            false => self.by_column(&name, rows.saturating_mul(columns), memory),
        })?;
        Ok(())
    }

    fn by_row(
        &mut self,
        name: &str,
        rows: u64,
        columns: u64,
        memory: &HeldMemory,
    ) -> Result<Numbers, Damage> {
        let mut found: Vec<Vec<String>> = Vec::new();
        for row in 1..=rows {
            self.must()?;
            self.hold(memory)?;
            let cells: Vec<&str> = self.last.split_whitespace().collect();
            if cells.len() as u64 != columns {
                let reason =
                    format!("row {row} of {name:?} has {} numbers, and {columns} are announced", cells.len());
                return Err(Damage::format(reason));
            }
            found.resize_with(cells.len(), Vec::new);
            found.iter_mut().zip(cells).for_each(|(column, cell)| column.push(cell.to_owned()));
        }
        self.no_more(name)?;
        Ok(texts(found.into_iter().flatten().collect()))
    }

    fn by_column(&mut self, name: &str, count: u64, memory: &HeldMemory) -> Result<Numbers, Damage> {
        let mut found: Vec<String> = Vec::new();
        while (found.len() as u64) < count {
            self.must()?;
            self.hold(memory)?;
            if self.last.starts_with('#') {
                let reason = format!("{name:?} has {} numbers, and {count} are announced", found.len());
                return Err(Damage::format(reason));
            }
            found.extend(self.last.split_whitespace().map(str::to_owned));
        }
        if found.len() as u64 > count {
            return Err(too_many(name));
        }
        self.no_more(name)?;
        Ok(texts(found))
    }

    /// Asks for memory for the numbers of the last line.
    fn hold(&self, memory: &HeldMemory) -> Result<(), Damage> {
        let numbers = self.last.split_whitespace().count() as u64;
        let bytes = self.last.len() as u64 + BYTES_PER_TEXT * numbers;
        memory.ask(bytes, MemoryUse::Variables).map_err(Damage::Refused)
    }

    /// Reads a range: its base, limit and increment, of which Octave makes doubles. They become the texts that Octave would write
    /// for a matrix of them.
    fn range(&mut self, search: Option<&mut Search>, name: String) -> Result<(), Damage> {
        self.must()?;
        if self.last.starts_with(['#', '%']) {
            self.must()?;
        }
        let numbers = self.last.split_whitespace().map(|number| number.parse::<f64>().ok());
        let numbers: Option<Vec<f64>> = numbers.collect();
        let Some(&[base, limit, increment]) = numbers.as_deref() else {
            let reason = format!("{:?} where base, limit and increment belong", self.last);
            return Err(Damage::format(reason));
        };
        let content = match elements_of_range(base, limit, increment) {
            elements if (1.0..=2_147_483_647.0).contains(&elements) => {
                Content::Numbers { rows: 1, columns: elements as u64 }
            }
            elements if elements > 1.0 => {
                Content::Other("a range of more elements than a matrix may have".to_owned())
            }
            _ => Content::Other("empty".to_owned()),
        };
        let Some(search) = search else { return Ok(()) };
        search.add(Variable { name, content }, self.last.len() as u64, |count, memory| {
            memory
                .ask(count.saturating_mul(BYTES_PER_TEXT), MemoryUse::Variables)
                .map_err(Damage::Refused)?;
            let last = count - 1;
            let number = |index: u64| base + index as f64 * increment;
            // The end is Octave's own as well (`xfinal_value` in its `Range.cc`).
            let end = match number(last) {
                end if (end > limit) == (increment > 0.0) => limit,
                end => end,
            };
            let is_whole = |number: f64| number == number.round();
            let are_whole = is_whole(base) && (last == 0 || is_whole(increment));
            let end = if are_whole { end.round() } else { end };
            Ok(texts((0..last).map(number).chain([end]).map(written).collect()))
        })?;
        Ok(())
    }

    /// Passes over texts, in which anything may stand.
    fn pass_strings(&mut self) -> Result<(), Damage> {
        for _ in 0..self.count("elements")? {
            let length = self.count("length")?;
            let passed = io::copy(&mut self.bytes.by_ref().take(length), &mut io::sink())?;
            self.read += passed;
            self.next()?;
        }
        Ok(())
    }

    /// Reads the fields of a struct, as variables with its name, a point and theirs.
    fn fields(&mut self, mut search: Option<&mut Search>, name: &str, nesting: usize) -> Result<(), Damage> {
        let nesting = self.deeper(nesting)?;
        self.count("ndims")?;
        self.must()?;
        for _ in 0..self.count("length")? {
            let Some(field) = self.name()? else {
                return Err(Damage::Io(io::ErrorKind::UnexpectedEof.into()));
            };
            self.variable(search.as_deref_mut(), format!("{name}.{field}"), nesting)?;
        }
        Ok(())
    }

    /// Passes over the cells of a cell array.
    fn cells(&mut self, nesting: usize) -> Result<(), Damage> {
        let nesting = self.deeper(nesting)?;
        self.must()?;
        let count = match self.said("rows").map(|rows| rows.parse::<u64>().ok()) {
            Some(rows) => {
                let rows = rows.ok_or_else(|| Damage::format("rows that are no number"))?;
                rows.saturating_mul(self.count("columns")?)
            }
            None => {
                self.must()?;
                let sizes = self.last.split_whitespace().map(|size| size.parse::<u64>().unwrap_or(u64::MAX));
                sizes.fold(1, u64::saturating_mul)
            }
        };
        for _ in 0..count {
            let Some(name) = self.name()? else {
                return Err(Damage::Io(io::ErrorKind::UnexpectedEof.into()));
            };
            self.variable(None, name, nesting)?;
        }
        Ok(())
    }

    fn deeper(&self, nesting: usize) -> Result<usize, Damage> {
        nesting.checked_sub(1).ok_or_else(|| Damage::format("a struct in a struct in a struct ..."))
    }
}

/// More numbers of a variable than it says that it has.
fn too_many(name: &str) -> Damage {
    Damage::format(format!("{name:?} has more numbers than are announced"))
}

/// A double as `save -text` writes it, with 17 significant digits.
fn written(number: f64) -> String {
    let text = format!("{number:.16e}");
    let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let digits = digits.trim_end_matches('0').trim_end_matches('.');
    if exponent == "0" { digits.to_owned() } else { format!("{digits}e{exponent}") }
}

/// Numbers as they are written.
fn texts(texts: Vec<String>) -> Numbers {
    Numbers::Texts(MemoryNumbers::Texts(texts))
}

/// The tolerance within which Octave compares numbers of a range (`xtfloor` and `xteq` in its `Range.cc`).
const TOLERANCE: f64 = 3.0 * f64::EPSILON;

/// Returns how many elements Octave gives a range, so that 0:0.1:1 ends with 1 (`xnumel_internal` in its `Range.cc`).
fn elements_of_range(base: f64, limit: f64, increment: f64) -> f64 {
    let is_limit = |steps: f64| {
        let end = base + steps * increment;
        (end - limit).abs() < end.abs().max(limit.abs()) * TOLERANCE
    };
    match tolerant_floor((limit - base + increment) / increment) {
        elements if elements < 1.0 || is_limit(elements - 1.0) => elements,
        elements if is_limit(elements - 2.0) => elements - 1.0,
        elements if is_limit(elements) => elements + 1.0,
        elements => elements,
    }
}

/// Returns the largest whole number that is not above x by more than the tolerance (Hagerty's FL5).
fn tolerant_floor(x: f64) -> f64 {
    let most = 1.0 / (2.0 - TOLERANCE);
    let near = (TOLERANCE * (1.0 + x.floor()).abs()).min(most).max(TOLERANCE);
    match (x + near).floor() {
        floor if x <= 0.0 || floor - x < most => floor,
        floor => floor - 1.0,
    }
}
