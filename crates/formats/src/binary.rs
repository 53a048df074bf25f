//! Tables that are not text, told by their first bytes.

use std::fs::File;
use std::io::{self, Read, Seek};

use crate::error::{InputError, InputErrorKind};
use crate::mat::{START, kind_of};
use crate::source::STANDARD_INPUT;

/// A format of columns in binary.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum BinaryFormat {
    /// Apache Parquet.
    Parquet,
    /// Apache Arrow IPC with a footer, also known as Feather version 2.
    ArrowFile,
    /// Apache Arrow IPC as a sequence of messages.
    ArrowStream,
    /// MATLAB's `.mat`, of any version.
    Matlab,
}

impl BinaryFormat {
    /// The format of a file that starts like this.
    fn of(start: &[u8]) -> Option<Self> {
        let magic: [(&[u8], BinaryFormat); 3] = [
            (b"PAR1", BinaryFormat::Parquet),
            (b"ARROW1", BinaryFormat::ArrowFile),
            // A continuation marker; no text in UTF-8 starts so.
            (b"\xff\xff\xff\xff", BinaryFormat::ArrowStream),
        ];
        let arrow = magic.iter().find(|(magic, _)| start.starts_with(magic)).map(|&(_, format)| format);
        arrow.or_else(|| kind_of(start).map(|_| BinaryFormat::Matlab))
    }

    /// Whether this is MATLAB's, which every build reads.
    pub(crate) fn is_matlab(self) -> bool {
        self == BinaryFormat::Matlab
    }

    /// The name with its article.
    pub(crate) fn name(self) -> &'static str {
        match self {
            BinaryFormat::Parquet => "a Parquet file",
            BinaryFormat::ArrowFile => "an Arrow IPC file",
            BinaryFormat::ArrowStream => "an Arrow IPC stream",
            BinaryFormat::Matlab => "a MATLAB file",
        }
    }
}

/// A file in a binary format that this build can read.
pub(crate) struct BinaryTable {
    pub(crate) format: BinaryFormat,
    pub(crate) file: File,
}

impl BinaryTable {
    /// The table in a file that stands at its start and is left there. Only a regular file is looked into: nothing else
    /// can be read from its start again.
    pub(crate) fn of(mut file: &File) -> io::Result<Option<Self>> {
        if !file.metadata()?.is_file() {
            return Ok(None);
        }
        let mut start = Vec::new();
        file.take(START as u64).read_to_end(&mut start)?;
        file.rewind()?;
        let is_read = |format: &BinaryFormat| cfg!(feature = "arrow") || format.is_matlab();
        let table = |format| Ok(BinaryTable { format, file: file.try_clone()? });
        BinaryFormat::of(&start).filter(is_read).map(table).transpose()
    }
}

/// Refuses a binary table where text is read.
pub(crate) fn refuse_binary(file: &str, start: &[u8]) -> Result<(), InputError> {
    let Some(format) = BinaryFormat::of(start) else { return Ok(()) };
    let instead = match file {
        _ if !cfg!(feature = "arrow") && !format.is_matlab() => {
            "this build reads text tables only (build with --features arrow)"
        }
        STANDARD_INPUT => "it is read from a named file, not from standard input",
        _ => "only text is read here",
    };
    Err(InputError::of_file(file, InputErrorKind::BinaryTable { format: format.name(), instead }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{ColumnSelector, ScanOptions, Source, TableOptions, read_table, scan};

    #[test]
    fn binary_tables_are_refused_by_name_where_text_is_read() {
        let columns = [ColumnSelector::name_or_number("x")];
        let messages = |start: &[u8]| {
            let source = || Source::new("table.csv", io::Cursor::new(start.to_vec()));
            let read = read_table(source(), &columns, &TableOptions::default()).map(|_| ());
            let scanned = scan(source(), &columns, &ScanOptions::default(), |_| (), |()| ()).map(|_| ());
            [read, scanned].map(|result| result.unwrap_err().to_string())
        };
        let instead = if cfg!(feature = "arrow") {
            "only text is read here"
        } else {
            "this build reads text tables only (build with --features arrow)"
        };
        for (start, format) in [
            (&b"PAR1\x15\x04"[..], "a Parquet file"),
            (b"ARROW1\0\0", "an Arrow IPC file"),
            (b"\xff\xff\xff\xff\x10\0\0\0", "an Arrow IPC stream"),
        ] {
            let message = format!("table.csv: this is {format}; {instead}");
            assert_eq!(messages(start), [message.clone(), message]);
        }
        assert!(messages(b"PAR,x\n1,y\n").iter().all(|message| message.contains("not a number")));
    }
}
