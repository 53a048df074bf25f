//! Tables that are not text, told by their first bytes.

use crate::error::{InputError, InputErrorKind, STANDARD_INPUT};
use crate::mat::kind;

/// How many bytes at the start of a file tell its format.
pub(crate) const START: u64 = kind::START as u64;

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
    pub(crate) fn of(start: &[u8]) -> Option<Self> {
        let magic: [(&[u8], BinaryFormat); 3] = [
            (b"PAR1", BinaryFormat::Parquet),
            (b"ARROW1", BinaryFormat::ArrowFile),
            // A continuation marker; no text in UTF-8 starts so.
            (b"\xff\xff\xff\xff", BinaryFormat::ArrowStream),
        ];
        let arrow = magic.iter().find(|(magic, _)| start.starts_with(magic)).map(|&(_, format)| format);
        arrow.or_else(|| kind::kind_of(start).map(|_| BinaryFormat::Matlab))
    }

    /// Whether this build can read it.
    pub(crate) fn is_readable(self) -> bool {
        cfg!(feature = "arrow") || self == BinaryFormat::Matlab
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

/// Refuses a binary table where text is read.
pub(crate) fn refuse_binary(file: &str, start: &[u8]) -> Result<(), InputError> {
    let Some(format) = BinaryFormat::of(start) else { return Ok(()) };
    let instead = match file {
        _ if !format.is_readable() => "this build reads text tables only (build with --features arrow)",
        STANDARD_INPUT => "it is read from a named file, not from standard input",
        _ => "only text is read here",
    };
    Err(InputError::of_file(file, InputErrorKind::BinaryTable { format: format.name(), instead }))
}

#[cfg(test)]
mod tests {
    use std::io;

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
