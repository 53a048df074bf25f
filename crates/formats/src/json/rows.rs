//! The records of a JSON text, some at a time.

use std::collections::HashMap;
use std::io::Read;

use boundfit_exact::Foreign;

use super::lane::Shape;
use super::records::Records;
use super::tokens::Tokens;
use crate::budget::HeldMemory;
use crate::columns::Header;
use crate::error::{InputError, InputErrorKind};
use crate::heading::looks_like_name;
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
    /// The words about the first row without keys.
    header: Header,
    /// `true` if that row is a reading of texts, and could be names as well.
    pub(super) may_be_names: bool,
    /// The cells of the first record, if it has no keys; `None` before the first record too.
    width: Option<usize>,
    most_columns: usize,
    /// The shape of the last object that was read token by token.
    shape: Option<Shape>,
    /// The memory of the records that were read together.
    memory: HeldMemory,
}

impl<'a, R: Read> JsonRows<'a, R> {
    pub(super) fn new(file: &'a str, input: R, header: Header, sizes: &'a SizeLimits) -> Self {
        JsonRows {
            file,
            tokens: Tokens::new(file, input, sizes),
            form: Form::Start,
            names: Vec::new(),
            columns: HashMap::new(),
            is_open: true,
            header,
            may_be_names: false,
            width: None,
            most_columns: sizes.columns,
            shape: None,
            memory: sizes.memory.nothing(),
        }
    }

    /// The names of the columns so far. Keys that come later are passed over.
    pub(super) fn close_names(&mut self) -> Vec<Foreign> {
        self.is_open = false;
        self.names.clone()
    }

    /// Returns whether the records that were read have keys, which name the columns.
    pub(super) fn has_keys(&self) -> bool {
        self.width.is_none()
    }

    /// The records in about so many bytes, none at the end, and what stopped the reader before.
    pub(super) fn part(&mut self, bytes: usize) -> (Records, Option<InputError>) {
        self.memory.give_back();
        let start = self.tokens.passed();
        let mut records = Records::default();
        while self.tokens.passed() - start < bytes as u64 {
            match self.record(&mut records) {
                Ok(true) => {}
                Ok(false) => break,
                Err(error) => {
                    records.drop_open();
                    return (records, Some(error));
                }
            }
        }
        (records, None)
    }

    /// Adds the next record; `false` at the end.
    fn record(&mut self, records: &mut Records) -> Result<bool, InputError> {
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
                    if self.row(records)? {
                        return Ok(true);
                    }
                }
                Form::Lines => match self.tokens.next()? {
                    None => self.form = Form::End,
                    Some(_) => {
                        if self.row(records)? {
                            return Ok(true);
                        }
                    }
                },
                Form::End => return Ok(false),
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

    /// Adds a record, an object with keys or an array, unless it names the columns.
    fn row(&mut self, records: &mut Records) -> Result<bool, InputError> {
        self.tokens.begin_record();
        let first = self.tokens.next()?;
        let line = self.tokens.line();
        let is_record = match first {
            Some(b'{') if self.width.is_some() => {
                return Err(self.tokens.wrong("an array, as the first record is,"));
            }
            Some(b'[') if self.width.is_none() && !self.names.is_empty() => {
                return Err(self.tokens.wrong("an object, as the first record is,"));
            }
            Some(b'{') if self.like_the_last(records) => true,
            Some(b'{') => {
                records.drop_open();
                self.object(line, records)?;
                true
            }
            Some(b'[') => self.array(line, records)?,
            _ => return Err(self.tokens.wrong("an object such as {\"x\": 1.5}")),
        };
        if is_record {
            records.close(line);
        }
        Ok(is_record)
    }

    /// Adds the cells of an object like the last one, if it is one. Otherwise nothing has been passed over.
    fn like_the_last(&mut self, records: &mut Records) -> bool {
        let Some(passed) = self.shape.as_ref().and_then(|shape| shape.read(self.tokens.at_hand(), records))
        else {
            return false;
        };
        let bytes = (OF_A_CELL * records.open_cells() + records.open_bytes()) as u64;
        // Reading token by token tells which cell is too much.
        passed.held <= self.tokens.longest_record()
            && self.memory.ask(bytes, MemoryUse::Records).is_ok()
            && self.tokens.advance(passed)
    }

    fn object(&mut self, line: u64, records: &mut Records) -> Result<(), InputError> {
        let mut keys = Vec::new();
        self.tokens.must(b'{', "'{'")?;
        let mut is_at_end = self.tokens.take(b'}')?;
        while !is_at_end {
            let key = self.tokens.string()?;
            self.tokens.must(b':', "':'")?;
            let cell = self.tokens.cell()?;
            let column = self.column(&key, line)?;
            if let Some(column) = column {
                self.hold(records, &cell, line)?;
                records.push(column, cell.as_bytes());
            }
            keys.push((key, column));
            is_at_end = self.tokens.take(b'}')?;
            if !is_at_end {
                self.tokens.must(b',', "',' or '}'")?;
            }
        }
        self.shape = Shape::new(keys);
        Ok(())
    }

    /// The number of the column with this name, from 0, if there is one.
    fn column(&mut self, key: &str, line: u64) -> Result<Option<usize>, InputError> {
        if let Some(&column) = self.columns.get(key) {
            return Ok(Some(column));
        }
        if !self.is_open {
            return Ok(None);
        }
        self.add_name(key, line)?;
        self.columns.insert(key.to_owned(), self.names.len() - 1);
        Ok(Some(self.names.len() - 1))
    }

    /// Asks for memory for one more cell of a record, of which there may be as many as columns.
    fn hold(&self, records: &Records, cell: &str, line: u64) -> Result<(), InputError> {
        let limit = self.most_columns;
        let asked = match records.open_cells() < limit {
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

    /// Adds a row without keys. The first one names the columns if that is asked for, or if it has texts only and one of them is a
    /// word.
    fn array(&mut self, line: u64, records: &mut Records) -> Result<bool, InputError> {
        let mut are_texts = true;
        self.tokens.must(b'[', "'['")?;
        let mut is_at_end = self.tokens.take(b']')?;
        while !is_at_end {
            are_texts &= self.tokens.next()? == Some(b'"');
            let cell = self.tokens.cell()?;
            self.hold(records, &cell, line)?;
            records.push(records.open_cells(), cell.as_bytes());
            is_at_end = self.tokens.take(b']')?;
            if !is_at_end {
                self.tokens.must(b',', "',' or ']'")?;
            }
        }
        let cells = records.open_cells();
        let is_first = self.width.is_none();
        let width = *self.width.get_or_insert(cells);
        if cells > width && records.open().skip(width).any(|cell| !cell.is_empty()) {
            let problem = InputErrorKind::RaggedRow { found: cells, expected: width };
            return Err(InputError::of_line(self.file, line, problem));
        }
        let is_header = is_first
            && cells > 0
            && match self.header {
                Header::Present => true,
                Header::Absent => false,
                Header::Auto => are_texts && records.open().any(|name| looks_like_name(name.as_bytes())),
            };
        self.may_be_names |= is_first && self.header == Header::Auto && are_texts && !is_header;
        if self.is_open && self.names.len() < cells {
            for name in records.open().skip(self.names.len()) {
                self.add_name(if is_header { name } else { "" }, line)?;
            }
        }
        if is_header {
            records.drop_open();
        }
        Ok(!is_header)
    }
}
