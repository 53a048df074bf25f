//! Files and standard input, opened once and looked into: the only place that opens anything.

use std::fs::File;
use std::io::{self, Read, Seek};

use crate::binary::{self, BinaryFormat};
use crate::error::{InputError, InputErrorKind, STANDARD_INPUT};

/// An input that has been opened.
pub struct Source {
    name: String,
    content: Content,
    /// How many bytes there are, where that is known.
    length: Option<u64>,
    is_file: bool,
}

/// What an input holds, as its first bytes tell.
pub(crate) enum Content {
    /// Text, or what will be refused as such.
    Bytes(Box<dyn Read>),
    /// A binary table that this build can read.
    Binary(BinaryFormat, File),
}

impl Source {
    /// Opens a file, or standard input for `-`. Of a file that grows while it is read, what was there when it was opened
    /// is seen.
    ///
    /// # Errors
    /// When the file cannot be opened or is a directory.
    pub fn open(path: &str) -> Result<Self, InputError> {
        if path == "-" {
            return Ok(Source::new(STANDARD_INPUT, io::stdin()));
        }
        let fail = |error: io::Error| InputError::of_file(path, error);
        let mut file = File::open(path).map_err(fail)?;
        let metadata = file.metadata().map_err(fail)?;
        if metadata.is_dir() {
            return Err(InputError::of_file(path, InputErrorKind::IsDirectory));
        }
        let format = if metadata.is_file() { format_of(&mut file).map_err(fail)? } else { None };
        // Pipes, devices and the files of /proc state no length.
        let length = (metadata.is_file() && metadata.len() > 0).then_some(metadata.len());
        let content = match format {
            Some(format) => Content::Binary(format, file),
            None => Content::Bytes(match length {
                Some(length) => Box::new(file.take(length)),
                None => Box::new(file),
            }),
        };
        Ok(Source { name: path.to_owned(), content, length, is_file: metadata.is_file() })
    }

    /// A stream of bytes with a name for messages.
    pub fn new(name: impl Into<String>, bytes: impl Read + 'static) -> Self {
        Source::with_content(name.into(), Content::Bytes(Box::new(bytes)))
    }

    pub(crate) fn with_content(name: String, content: Content) -> Self {
        Source { name, content, length: None, is_file: false }
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
    pub fn name(&self) -> &str {
        &self.name
    }

    /// How many bytes a file has; `None` where that is not known before it is read.
    pub fn length(&self) -> Option<u64> {
        self.length
    }

    /// The path under which the same bytes can be read again; `None` unless this is a regular file.
    pub fn path(&self) -> Option<&str> {
        self.is_file.then_some(&self.name)
    }

    /// Whether the numbers in this file are stored in binary, exactly, so that no reading of text applies: in a MATLAB
    /// file. What is reported of them is the binary64 reading.
    pub fn is_stored(&self) -> bool {
        matches!(self.content, Content::Binary(BinaryFormat::Matlab, _))
    }

    pub(crate) fn into_content(self) -> (String, Content) {
        (self.name, self.content)
    }

    /// The name and the bytes, whatever they are.
    pub(crate) fn into_bytes(self) -> (String, Box<dyn Read>) {
        let bytes = match self.content {
            Content::Bytes(bytes) => bytes,
            Content::Binary(_, file) => Box::new(file),
        };
        (self.name, bytes)
    }
}

/// The format of a binary table that this build can read. The file is left at its start.
fn format_of(file: &mut File) -> io::Result<Option<BinaryFormat>> {
    let mut start = Vec::new();
    file.by_ref().take(binary::START).read_to_end(&mut start)?;
    file.rewind()?;
    Ok(BinaryFormat::of(&start).filter(|format| format.is_readable()))
}
