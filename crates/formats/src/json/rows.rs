//! The records of a JSON text, some at a time.

use std::collections::HashMap;
use std::io::Read;

use boundfit_exact::Foreign;

use super::tokens::Tokens;
use crate::budget::HeldMemory;
use crate::error::{InputError, InputErrorKind};
use crate::limits::SizeLimits;
use crate::memory_use::MemoryUse;

/// Bytes that a cell takes beside its text: its place in the record, and again in the column that it is read from, with what the
/// allocator adds. Measured as the largest memory of a process that read an array of 2·10⁶ empty texts.
const OF_A_CELL: usize = 144;

/// The place of the records.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Form {
    /// Nothing was read.
    Start,
    /// Records in an array; the flag tells if the first one is still to come.
    Array {
        is_first: bool,
    },
    /// One after the other, as in NDJSON.
    Lines,
    End,
}

/// Cells of a record by the number of their column, from 0, as they come.
pub(super) struct Record {
    pub(super) line: u64,
    pub(super) cells: Vec<(usize, String)>,
}

/// Records on their way.
pub(super) struct JsonRows<'a, R> {
    file: &'a str,
    pub(super) tokens: Tokens<'a, R>,
    form: Form,
    /// The names of the columns so far; none of rows without keys.
    names: Vec<Foreign>,
    columns: HashMap<String, usize>,
    /// `true` if columns may be added.
    is_open: bool,
    most_columns: usize,
    /// The memory of the records that were read together.
    memory: HeldMemory,
}

impl<'a, R: Read> JsonRows<'a, R> {
    pub(super) fn new(file: &'a str, input: R, sizes: &'a SizeLimits) -> Self {
        JsonRows {
            file,
            tokens: Tokens::new(file, input, sizes),
            form: Form::Start,
            names: Vec::new(),
            columns: HashMap::new(),
            is_open: true,
            most_columns: sizes.columns,
            memory: sizes.memory.nothing(),
        }
    }

    /// The names of the columns so far. Keys that come later are passed over.
    pub(super) fn close_names(&mut self) -> Vec<Foreign> {
        self.is_open = false;
        self.names.clone()
    }

    /// The records in about so many bytes, none at the end, and what stopped the reader before.
    pub(super) fn part(&mut self, bytes: usize) -> (Vec<Record>, Option<InputError>) {
        self.memory.give_back();
        let start = self.tokens.passed();
        let mut records = Vec::new();
        while self.tokens.passed() - start < bytes as u64 {
            match self.record() {
                Ok(Some(record)) => records.push(record),
                Ok(None) => break,
                Err(error) => return (records, Some(error)),
            }
        }
        (records, None)
    }

    /// The next record; nothing at the end.
    fn record(&mut self) -> Result<Option<Record>, InputError> {
        loop {
            match self.form {
                Form::Start => self.form = self.start()?,
                Form::Array { is_first } => {
                    if self.tokens.take(b']')? {
                        if self.tokens.next()?.is_some() {
                            return Err(self.tokens.wrong("nothing, behind the end of the array,"));
                        }
                        self.form = Form::End;
                        continue;
                    }
                    if !is_first {
                        self.tokens.must(b',', "',' or ']'")?;
                    }
                    self.form = Form::Array { is_first: false };
                    match self.row()? {
                        Some(record) => return Ok(Some(record)),
                        None => continue,
                    }
                }
                Form::Lines => match self.tokens.next()? {
                    None => self.form = Form::End,
                    Some(_) => {
                        if let Some(record) = self.row()? {
                            return Ok(Some(record));
                        }
                    }
                },
                Form::End => return Ok(None),
            }
        }
    }

    /// An array of records is one of objects or arrays; lines are objects.
    fn start(&mut self) -> Result<Form, InputError> {
        // A byte order mark of UTF-8.
        for byte in b"\xef\xbb\xbf" {
            self.tokens.take(*byte)?;
        }
        match self.tokens.next()? {
            Some(b'{') => Ok(Form::Lines),
            _ => {
                self.tokens.must(b'[', "'[' or '{'")?;
                Ok(Form::Array { is_first: true })
            }
        }
    }

    /// A record, unless it names the columns: an object with keys, or an array.
    fn row(&mut self) -> Result<Option<Record>, InputError> {
        self.tokens.begin_record();
        let first = self.tokens.next()?;
        let line = self.tokens.line();
        match first {
            Some(b'{') => self.object(line).map(Some),
            Some(b'[') => self.array(line),
            _ => Err(self.tokens.wrong("an object such as {\"x\": 1.5}")),
        }
    }

    fn object(&mut self, line: u64) -> Result<Record, InputError> {
        let mut cells = Vec::new();
        self.tokens.must(b'{', "'{'")?;
        if self.tokens.take(b'}')? {
            return Ok(Record { line, cells });
        }
        loop {
            let key = self.tokens.string()?;
            self.tokens.must(b':', "':'")?;
            let cell = self.tokens.cell()?;
            if let Some(column) = self.column(key, line)? {
                self.hold(&cells, &cell, line)?;
                cells.push((column, cell));
            }
            if self.tokens.take(b'}')? {
                return Ok(Record { line, cells });
            }
            self.tokens.must(b',', "',' or '}'")?;
        }
    }

    /// The number of the column with this name, from 0, if there is one.
    fn column(&mut self, key: String, line: u64) -> Result<Option<usize>, InputError> {
        if let Some(&column) = self.columns.get(&key) {
            return Ok(Some(column));
        }
        if !self.is_open {
            return Ok(None);
        }
        self.add_name(&key, line)?;
        self.columns.insert(key, self.names.len() - 1);
        Ok(Some(self.names.len() - 1))
    }

    /// Asks for memory for one more cell of a record with these, of which there may be as many as columns.
    fn hold(&self, cells: &[(usize, String)], cell: &str, line: u64) -> Result<(), InputError> {
        let limit = self.most_columns;
        let asked = match cells.len() < limit {
            true => self.memory.ask((OF_A_CELL + cell.len()) as u64, MemoryUse::Records),
            false => Err(InputErrorKind::TooManyColumns { limit }),
        };
        asked.map_err(|problem| InputError::of_line(self.file, line, problem))
    }

    fn add_name(&mut self, name: &str, line: u64) -> Result<(), InputError> {
        let limit = self.most_columns;
        if self.names.len() >= limit {
            return Err(InputError::of_line(self.file, line, InputErrorKind::TooManyColumns { limit }));
        }
        self.names.push(name.into());
        Ok(())
    }

    /// A row without keys. The first one names the columns if it has texts only.
    fn array(&mut self, line: u64) -> Result<Option<Record>, InputError> {
        let mut cells = Vec::new();
        let mut are_texts = true;
        self.tokens.must(b'[', "'['")?;
        let mut is_at_end = self.tokens.take(b']')?;
        while !is_at_end {
            are_texts &= self.tokens.next()? == Some(b'"');
            let cell = self.tokens.cell()?;
            self.hold(&cells, &cell, line)?;
            cells.push((cells.len(), cell));
            is_at_end = self.tokens.take(b']')?;
            if !is_at_end {
                self.tokens.must(b',', "',' or ']'")?;
            }
        }
        let is_header = self.is_open && self.names.is_empty() && are_texts && !cells.is_empty();
        while self.is_open && self.names.len() < cells.len() {
            let name = cells.get(self.names.len()).filter(|_| is_header);
            self.add_name(&name.map(|(_, name)| name.clone()).unwrap_or_default(), line)?;
        }
        Ok((!is_header).then_some(Record { line, cells }))
    }
}
