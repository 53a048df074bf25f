//! Files and standard input, opened once and looked into: the only place that opens anything.

use std::fs::File;
#[cfg(feature = "arrow")]
use std::io::Seek;
use std::io::{self, Cursor, Read};
use std::sync::Arc;

#[cfg(feature = "arrow")]
use arrow_array::RecordBatchReader;
use boundfit_exact::Foreign;

use crate::binary::{self, BinaryFormat};
use crate::error::{InputError, InputErrorKind, STANDARD_INPUT};
use crate::json::is_json;
use crate::limits::SizeLimits;
use crate::mat_kind::is_octave;
use crate::memory::MemoryTable;
use crate::reduction::record::REDUCTION_MARK;
use crate::unpack::{Packed, Unpacked};

/// An input that has been opened.
pub struct Source {
    name: Foreign,
    content: Content,
    /// The packing of a compressed input, whose content is the unpacked bytes.
    packed: Option<Packed>,
    /// The number of bytes, where it is known.
    length: Option<u64>,
    is_file: bool,
    is_reduction: bool,
    /// The means to open the input once more, if it is no file.
    held: Option<Again>,
}

/// The means to open an input once more.
#[derive(Clone)]
pub struct Again(Held);

#[derive(Clone)]
enum Held {
    File(String),
    Bytes(Foreign, Arc<[u8]>),
    Table(Foreign, Arc<MemoryTable>),
}

impl Again {
    /// Opens the input once more.
    ///
    /// # Errors
    /// When it is a file that cannot be opened any more.
    pub fn open(&self) -> Result<Source, InputError> {
        match &self.0 {
            Held::File(path) => Source::open(path),
            Held::Bytes(name, bytes) => Ok(Source::of_bytes(name.clone(), Arc::clone(bytes))),
            Held::Table(name, table) => Ok(Source::of_table(name.clone(), Arc::clone(table))),
        }
    }
}

/// The kind of content, by its first bytes.
pub(crate) enum Content {
    /// Text, or what will be refused as such.
    Bytes(Box<dyn Read>),
    /// A MATLAB file.
    Matlab(Box<dyn Read>),
    /// Variables in Octave's text.
    Octave(Box<dyn Read>),
    /// A zip archive, which may be a workbook.
    #[cfg(feature = "spreadsheets")]
    Archive(Box<dyn Read>),
    /// Parquet or Arrow.
    #[cfg(feature = "arrow")]
    Columns(BinaryFormat, File),
    /// Record batches that are not from a file.
    #[cfg(feature = "arrow")]
    Batches(Box<dyn RecordBatchReader>),
    /// Records in JSON.
    Json(Box<dyn Read>),
    /// Columns in memory.
    Memory(Arc<MemoryTable>),
}

impl Content {
    /// Returns an input with this start and these bytes, which include the start.
    fn of(start: &[u8], bytes: Box<dyn Read>) -> Self {
        match BinaryFormat::of(start) {
            Some(BinaryFormat::Matlab) => Content::Matlab(bytes),
            None if is_octave(start) => Content::Octave(bytes),
            None if is_json(start) => Content::Json(bytes),
            #[cfg(feature = "spreadsheets")]
            Some(BinaryFormat::Archive) => Content::Archive(bytes),
            _ => Content::Bytes(bytes),
        }
    }

    /// The bytes, whatever they are.
    fn into_bytes(self) -> Box<dyn Read> {
        match self {
            Content::Bytes(bytes)
            | Content::Matlab(bytes)
            | Content::Octave(bytes)
            | Content::Json(bytes) => bytes,
            #[cfg(feature = "spreadsheets")]
            Content::Archive(bytes) => bytes,
            #[cfg(feature = "arrow")]
            Content::Columns(_, file) => Box::new(file),
            #[cfg(feature = "arrow")]
            Content::Batches(_) => Box::new(io::empty()),
            Content::Memory(_) => Box::new(io::empty()),
        }
    }
}

impl Source {
    /// Opens a file, or standard input for `-`. A file that grows while it is read has the content that it
    /// had when it was opened. Input compressed by gzip or Zstandard is unpacked as it is read.
    ///
    /// # Errors
    /// When the file cannot be opened or is a directory.
    pub fn open(path: &str) -> Result<Self, InputError> {
        if path == "-" {
            return Ok(Source::new(STANDARD_INPUT, io::stdin()));
        }
        let fail = |error: io::Error| InputError::of_file(path, error);
        let file = File::open(path).map_err(fail)?;
        let metadata = file.metadata().map_err(fail)?;
        if metadata.is_dir() {
            return Err(InputError::of_file(path, InputErrorKind::IsDirectory));
        }
        let is_file = metadata.is_file();
        // Pipes, devices and the files of /proc state no length.
        let length = (is_file && metadata.len() > 0).then_some(metadata.len());
        #[cfg(feature = "arrow")]
        if is_file {
            let mut file = file.try_clone().map_err(fail)?;
            if let Some(format) = columns_of(&mut file).map_err(fail)? {
                let content = Content::Columns(format, file);
                let name = path.into();
                let (packed, is_reduction, held) = (None, false, None);
                return Ok(Source { name, content, packed, length, is_file, is_reduction, held });
            }
        }
        let source = match length {
            Some(length) => Source::new(path, file.take(length)),
            None => Source::new(path, file),
        };
        // The unpacked size of a compressed file is not known.
        let length = length.filter(|_| source.packed.is_none());
        Ok(Source { length, is_file, ..source })
    }

    /// A stream of bytes with a name for messages. Input compressed by gzip or Zstandard is unpacked as it is
    /// read.
    pub fn new(name: impl Into<Foreign>, bytes: impl Read + 'static) -> Self {
        let (start, bytes) = peeked(Box::new(bytes));
        let (packed, start, bytes) = match Packed::unpacked(&start, bytes) {
            Err(bytes) => (None, start, bytes),
            Ok(Unpacked { packed, start: Some(start), bytes }) => (Some(packed), start, bytes),
            Ok(Unpacked { packed, start: None, bytes }) => {
                let (start, bytes) = peeked(bytes);
                (Some(packed), start, bytes)
            }
        };
        let is_reduction = start.starts_with(REDUCTION_MARK.as_bytes());
        let content = Content::of(&start, bytes);
        Source { name: name.into(), content, packed, length: None, is_file: false, is_reduction, held: None }
    }

    /// Bytes in memory with a name for messages, as [`Source::new`] reads them; they can be read as often as one likes.
    pub fn of_bytes(name: impl Into<Foreign>, bytes: impl Into<Arc<[u8]>>) -> Self {
        let (name, bytes) = (name.into(), bytes.into());
        let held = Some(Again(Held::Bytes(name.clone(), Arc::clone(&bytes))));
        Source { held, ..Source::new(name, Cursor::new(bytes)) }
    }

    /// Makes an input of record batches of Arrow in the given order, with a name for messages. The batches
    /// come from a reader of Parquet or of Arrow's streams, or from memory. They are read once, and read as
    /// those of a file are.
    ///
    /// ```
    /// use std::sync::Arc;
    ///
    /// use arrow_array::{ArrayRef, Float64Array, RecordBatch, RecordBatchIterator};
    /// use boundfit_formats::{ColumnSelector, Source, TableOptions, read_table};
    ///
    /// let column = |numbers: &[f64]| Arc::new(Float64Array::from(numbers.to_vec())) as ArrayRef;
    /// let first = RecordBatch::try_from_iter([("I", column(&[0.1])), ("U", column(&[1.5]))])?;
    /// let second = RecordBatch::try_from_iter([("I", column(&[0.2, 0.3])), ("U", column(&[3.0, 4.5]))])?;
    /// let schema = first.schema();
    /// let batches = RecordBatchIterator::new([Ok(first), Ok(second)], schema);
    /// let columns = ["U", "I"].map(ColumnSelector::name_or_number);
    /// let read = read_table(Source::of_batches("resistor", batches), &columns, &TableOptions::default())?;
    /// assert_eq!((read.rows.len(), read.rows[2].numbers[1].to_string()), (3, "3/10".to_owned()));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[cfg(feature = "arrow")]
    pub fn of_batches(name: impl Into<Foreign>, batches: impl RecordBatchReader + 'static) -> Self {
        let (name, content) = (name.into(), Content::Batches(Box::new(batches)));
        Source { name, content, packed: None, length: None, is_file: false, is_reduction: false, held: None }
    }

    /// A table in memory with a name for messages. One that is shared may be read as often as one likes.
    pub fn of_table(name: impl Into<Foreign>, table: impl Into<Arc<MemoryTable>>) -> Self {
        let (name, table) = (name.into(), table.into());
        let held = Some(Again(Held::Table(name.clone(), Arc::clone(&table))));
        let content = Content::Memory(table);
        Source { name, content, packed: None, length: None, is_file: false, is_reduction: false, held }
    }

    /// This source with something done to its bytes, within these limits, if they are text.
    pub(crate) fn with_text<T: Default>(
        self,
        sizes: &SizeLimits,
        change: impl FnOnce(&str, Box<dyn Read>) -> Result<(Box<dyn Read>, T), InputError>,
    ) -> Result<(Self, T), InputError> {
        match self.content {
            Content::Bytes(bytes) => {
                self.packed.iter().for_each(|packed| packed.set_limits(sizes));
                let (bytes, found) = change(self.name.raw(), bytes)?;
                Ok((Source { content: Content::Bytes(bytes), ..self }, found))
            }
            content => Ok((Source { content, ..self }, T::default())),
        }
    }

    /// This source, cut off after so many bytes of text.
    pub fn limited(self, most_bytes: u64) -> Self {
        let content = match self.content {
            Content::Bytes(bytes) => Content::Bytes(Box::new(bytes.take(most_bytes))),
            binary => binary,
        };
        Source { content, ..self }
    }

    /// The name that messages use.
    pub fn name(&self) -> &Foreign {
        &self.name
    }

    /// Returns the number of bytes of a file; `None` where that is not known before it is read.
    pub fn length(&self) -> Option<u64> {
        self.length
    }

    /// The path under which the same bytes can be read again; `None` unless this is a regular file.
    pub fn path(&self) -> Option<&str> {
        self.is_file.then_some(self.name.raw())
    }

    /// Returns the means to open the same input once more; `None` for input that is read once, as standard
    /// input and pipes are.
    pub fn again(&self) -> Option<Again> {
        self.path().map(|path| Again(Held::File(path.to_owned()))).or_else(|| self.held.clone())
    }

    /// Returns true if this is a reduction, or several of them: see
    /// [`open_reduction`](crate::open_reduction).
    pub fn is_reduction(&self) -> bool {
        self.is_reduction
    }

    /// Returns whether the numbers in this file are stored in binary, exactly, so that no reading of text applies: in
    /// a MATLAB file. Reports have the binary64 reading of such numbers.
    pub fn is_stored(&self) -> bool {
        matches!(self.content, Content::Matlab(_))
    }

    /// The name, what is in it, and what is known of it if it is compressed.
    pub(crate) fn into_parts(self) -> (Foreign, Content, Option<Packed>) {
        (self.name, self.content, self.packed)
    }

    /// The name and the bytes, whatever they are, and what is known of them if they were compressed.
    pub(crate) fn into_bytes(self) -> (Foreign, Box<dyn Read>, Option<Packed>) {
        (self.name, self.content.into_bytes(), self.packed)
    }
}

/// The first bytes of a stream, and the whole stream. An error that comes before them is kept for who reads on.
fn peeked(mut bytes: Box<dyn Read>) -> (Vec<u8>, Box<dyn Read>) {
    let mut start = Vec::new();
    let failure = bytes.by_ref().take(binary::START).read_to_end(&mut start).err();
    let rest = Failing(failure).chain(bytes);
    (start.clone(), Box::new(Cursor::new(start).chain(rest)))
}

/// A reader that fails once, if at all, and then is at its end.
struct Failing(Option<io::Error>);

impl Read for Failing {
    fn read(&mut self, _: &mut [u8]) -> io::Result<usize> {
        self.0.take().map_or(Ok(0), Err)
    }
}

/// The format of a table in columns that is read out of its order. The file is left at its start.
#[cfg(feature = "arrow")]
fn columns_of(file: &mut File) -> io::Result<Option<BinaryFormat>> {
    let mut start = Vec::new();
    file.by_ref().take(binary::START).read_to_end(&mut start)?;
    file.rewind()?;
    Ok(BinaryFormat::of(&start).filter(|format| format.is_columns()))
}
