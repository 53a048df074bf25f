//! Recognizes input that is not text by its first bytes: tables that boundfit reads, and other files with
//! advice on how to get their numbers.

use crate::error::{InputError, InputErrorKind, STANDARD_INPUT};
use crate::mat_kind::{self, is_octave};
use crate::packing::Packing;

/// The number of bytes at the start of a file that tell its format.
pub(crate) const START: u64 = mat_kind::START as u64;

/// A format of tables in binary.
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
    /// A zip archive, which workbooks are.
    Archive,
}

impl BinaryFormat {
    /// The format of a file that starts like this.
    pub(crate) fn of(start: &[u8]) -> Option<Self> {
        let magic: [(&[u8], BinaryFormat); 4] = [
            (b"PAR1", BinaryFormat::Parquet),
            (b"ARROW1", BinaryFormat::ArrowFile),
            // A continuation marker; no text in UTF-8 starts so.
            (b"\xff\xff\xff\xff", BinaryFormat::ArrowStream),
            (b"PK\x03\x04", BinaryFormat::Archive),
        ];
        let known = magic.iter().find(|(magic, _)| start.starts_with(magic)).map(|&(_, format)| format);
        known.or_else(|| mat_kind::kind_of(start).map(|_| BinaryFormat::Matlab))
    }

    /// Returns whether its columns stand one after the other, so that it is not read from front to back.
    pub(crate) fn is_columns(self) -> bool {
        matches!(self, BinaryFormat::Parquet | BinaryFormat::ArrowFile | BinaryFormat::ArrowStream)
    }

    /// The feature without which this build cannot read it.
    fn missing_feature(self) -> Option<&'static str> {
        match self {
            BinaryFormat::Archive if cfg!(not(feature = "spreadsheets")) => {
                Some("this build reads no workbooks (feature spreadsheets); save the sheet as CSV")
            }
            BinaryFormat::Parquet if cfg!(not(feature = "arrow")) => Some(
                "this build has no reader of it (feature arrow); save it as CSV: pandas.read_parquet('FILE').to_csv('FILE.csv', index=False)",
            ),
            BinaryFormat::ArrowFile if cfg!(not(feature = "arrow")) => Some(
                "this build has no reader of it (feature arrow); save it as CSV: pandas.read_feather('FILE').to_csv('FILE.csv', index=False)",
            ),
            BinaryFormat::ArrowStream if cfg!(not(feature = "arrow")) => Some(
                "this build has no reader of it (feature arrow); save it as CSV: pyarrow.ipc.open_stream('FILE').read_pandas().to_csv('FILE.csv', index=False)",
            ),
            BinaryFormat::Matlab if cfg!(not(feature = "matlab")) => Some(NO_MATLAB),
            _ => None,
        }
    }

    /// The name with its article.
    pub(crate) fn name(self) -> &'static str {
        match self {
            BinaryFormat::Parquet => "a Parquet file",
            BinaryFormat::ArrowFile => "an Arrow IPC file",
            BinaryFormat::ArrowStream => "an Arrow IPC stream",
            BinaryFormat::Matlab => "a MATLAB file",
            BinaryFormat::Archive => "a workbook or another zip archive",
        }
    }
}

/// Advice where variables of MATLAB and Octave are not read.
const NO_MATLAB: &str = "this build has no reader of it (feature matlab); save a matrix of it as CSV";
/// Advice where nothing is unpacked.
const NO_UNPACKING: &str = "this build unpacks nothing (feature packed); unpack it first";
/// Advice on saving a sheet.
const AS_SHEET: &str = "save it as .xlsx or CSV";
/// Advice on files in an archive.
const IN_ARCHIVE: &str = "unpack it and name the file that is in it";
/// The name of the container of old documents, and of encrypted new ones.
const OLE2: &str = "a file of Microsoft Office before 2007, such as .xls, or an .xlsx with a password";
/// Advice on saving a data frame of R.
const FROM_R: &str = "in R, save the data frame in it as CSV: write.csv(DATA, 'FILE.csv', row.names = FALSE)";
/// Advice for a picture.
const NO_NUMBERS: &str = "a picture has no table; give the numbers behind it as CSV";

/// First bytes of files that boundfit does not read, the names of their formats, and advice on getting their
/// numbers.
const FOREIGN: [(&[u8], &str, &str); 41] = [
    (b"%PDF-", "a PDF document", "copy its table into a spreadsheet and save that as .xlsx or CSV"),
    (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", OLE2, "save it as .xlsx without a password, or as CSV"),
    (b"$FL2", "an SPSS file (.sav)", "save it as CSV"),
    (b"$FL3", "an SPSS file (.zsav)", "save it as CSV"),
    (b"<stata_dta>", "a Stata file (.dta)", FROM_STATA),
    (b"RDX2\n", "an R workspace (.RData)", FROM_R),
    (b"RDX3\n", "an R workspace (.RData)", FROM_R),
    (b"X\n\0\0\0", "a file of R's saveRDS (.rds)", FROM_R),
    (
        b"\x93NUMPY",
        "a NumPy array (.npy)",
        "save it as text: numpy.savetxt('FILE.csv', array, delimiter=',', fmt='%s')",
    ),
    (
        b"SQLite format 3\0",
        "an SQLite database",
        "save a table of it as CSV: sqlite3 -header -csv FILE 'SELECT ...'",
    ),
    (b"BZh", "a bzip2 file", "unpack it with bunzip2, or pack it with gzip or zstd"),
    (b"\xfd7zXZ\0", "an xz file", "unpack it with unxz, or pack it with gzip or zstd"),
    (b"\x04\x22\x4d\x18", "an LZ4 file", "unpack it with unlz4, or pack it with gzip or zstd"),
    (b"]\0\0", "an LZMA file", "unpack it with unlzma, or pack it with gzip or zstd"),
    (b"\x1f\x9d", "a file of compress (.Z)", "unpack it with gunzip, or pack it with gzip or zstd"),
    (b"7z\xbc\xaf\x27\x1c", "a 7z archive", IN_ARCHIVE),
    (b"Rar!\x1a\x07", "a RAR archive", IN_ARCHIVE),
    (b"PK\x05\x06", "an empty zip archive", "there is no file in it to read"),
    (b"\x89PNG\r\n\x1a\n", "a PNG picture", NO_NUMBERS),
    (b"\xff\xd8\xff", "a JPEG picture", NO_NUMBERS),
    (b"GIF8", "a GIF picture", NO_NUMBERS),
    (b"II*\0", "a TIFF picture", NO_NUMBERS),
    (b"MM\0*", "a TIFF picture", NO_NUMBERS),
    (b"{\\rtf", "a document in RTF", "copy its table into a spreadsheet and save that as .xlsx or CSV"),
    (b"Obj\x01", "an Avro file", "save it as CSV or Parquet"),
    (b"ORC", "an ORC file", "save it as CSV or Parquet"),
    (b"\x80\x02", "a Python pickle", FROM_PICKLE),
    (b"\x80\x03", "a Python pickle", FROM_PICKLE),
    (b"\x80\x04", "a Python pickle", FROM_PICKLE),
    (b"\x80\x05", "a Python pickle", FROM_PICKLE),
    // Versions 8, 10 and 12 of the format, in either order of bytes.
    (b"\x71\x01\x01", "a Stata file (.dta)", FROM_STATA),
    (b"\x71\x02\x01", "a Stata file (.dta)", FROM_STATA),
    (b"\x72\x01\x01", "a Stata file (.dta)", FROM_STATA),
    (b"\x72\x02\x01", "a Stata file (.dta)", FROM_STATA),
    (b"\x73\x01\x01", "a Stata file (.dta)", FROM_STATA),
    (b"\x73\x02\x01", "a Stata file (.dta)", FROM_STATA),
    (
        b"Octave-1-",
        "a file of Octave's save -binary",
        "save it as text or for MATLAB: save -text FILE NAME, or save -v7 FILE.mat NAME",
    ),
    (b"TDSm", "a LabVIEW file (.tdms)", "open it in LabVIEW or Excel and save the channels as text or CSV"),
    (b"CDF\x01", "a NetCDF file", FROM_NETCDF),
    (b"CDF\x02", "a NetCDF file", FROM_NETCDF),
    (b"CDF\x05", "a NetCDF file", FROM_NETCDF),
];

/// Advice on saving the table in a pickle.
const FROM_PICKLE: &str = "save its table as CSV: pandas.read_pickle('FILE').to_csv('FILE.csv', index=False)";
/// Advice on saving the table in a Stata file.
const FROM_STATA: &str = "save it as CSV: export delimited using FILE.csv in Stata, pandas.read_stata('FILE').to_csv('FILE.csv', index=False) in Python";
/// Advice on saving the table in a NetCDF file.
const FROM_NETCDF: &str =
    "save it as CSV: xarray.open_dataset('FILE').to_dataframe().to_csv('FILE.csv') in Python";

/// Refuses text that is no table, but a document or the file of another program, and archives of such.
pub(crate) fn refuse_document(file: &str, start: &[u8]) -> Result<(), InputError> {
    if cfg!(not(feature = "matlab")) && is_octave(start) {
        let (format, instead) = ("what Octave's save -text writes", NO_MATLAB);
        return Err(InputError::of_file(file, InputErrorKind::BinaryTable { format, instead }));
    }
    if is_tar(start) {
        let (format, instead) = ("a tar archive", IN_ARCHIVE);
        return Err(InputError::of_file(file, InputErrorKind::BinaryTable { format, instead }));
    }
    if has_zero(start) {
        let (format, instead) =
            ("a file of no kind that is known here, and no text", "save its table as CSV");
        return Err(InputError::of_file(file, InputErrorKind::BinaryTable { format, instead }));
    }
    let start = String::from_utf8_lossy(start.get(..DOCUMENT_START).unwrap_or(start)).to_lowercase();
    let text = start.trim_start_matches('\u{feff}').trim_start();
    let has = |words: &str| text.contains(words);
    let begins = |words: &[&str]| words.iter().any(|words| text.starts_with(words));
    let first = |mark: char| {
        text.lines()
            .map(str::trim)
            .find(|line| !line.is_empty() && !line.starts_with(mark))
            .unwrap_or_default()
    };
    let touchstone: Vec<&str> = first('!').split_whitespace().collect();
    let (format, instead) = if begins(&["<?xml", "<office:document"]) && has("<office:document") {
        ("a flat OpenDocument sheet (.fods) or another document", AS_SHEET_OR_ODS)
    } else if begins(&["<?xml"]) && (has("excel.sheet") || has("office:spreadsheet")) {
        ("an XML spreadsheet of Excel 2003", AS_SHEET)
    } else if begins(&["<!doctype html", "<html", "<table"]) || begins(&["<?xml"]) && has("<html") {
        ("an HTML page", "copy its table into a spreadsheet and save that as .xlsx or CSV")
    } else if begins(&["<?xml", "<svg"]) {
        ("an XML document", "save its table as CSV")
    } else if is_marked_up(text) {
        ("an HTML or XML document", "copy its table into a spreadsheet and save that as .xlsx or CSV")
    } else if begins(&["\\begin{", "\\documentclass"]) {
        ("LaTeX", "copy its table into a spreadsheet and save that as .xlsx or CSV")
    } else if first('%').split_whitespace().next() == Some("@relation") {
        ("an ARFF file of Weka", "save it as CSV: Weka's Explorer does, under Preprocess, Save")
    } else if matches!(touchstone.as_slice(), ["#", "hz" | "khz" | "mhz" | "ghz", ..]) {
        ("a Touchstone file (.s1p, .s2p)", PASS_OVER_LINES)
    } else if begins(&["title:"]) && has("\nplotname:") {
        (
            "a SPICE raw file",
            "have the simulator write columns of text: wrdata FILE V(OUT) in ngspice, File, Export in LTspice",
        )
    } else {
        return Ok(());
    };
    Err(InputError::of_file(file, InputErrorKind::BinaryTable { format, instead }))
}

/// Returns whether the first line of a text is a tag or a comment and no more: "<DL" and "<b>x</b>" may be names.
fn is_marked_up(text: &str) -> bool {
    let line = text.lines().next().unwrap_or_default().trim_end();
    let mut letters = line.strip_prefix('<').into_iter().flat_map(str::chars);
    let is_tag =
        letters.next().is_some_and(|first| first.is_ascii_alphabetic() || matches!(first, '!' | '?'));
    let is_all = line.find('>') == line.len().checked_sub(1);
    is_tag && is_all && ["</", "/>", "-->", "?>"].iter().any(|end| text.contains(end))
}

/// Returns whether the first line that is not blank begins like no text.
fn has_zero(start: &[u8]) -> bool {
    const MARKS: usize = 64;
    let is_in_line = |byte: &&u8| !matches!(byte, b'\n' | b'\r');
    start.trim_ascii_start().iter().take(MARKS).take_while(is_in_line).any(|&byte| byte == 0)
}

/// The number of bytes that tell a document.
pub(crate) const DOCUMENT_START: usize = 4096;
/// Advice for a text whose first lines do not belong to its table.
const PASS_OVER_LINES: &str = "its numbers are read without its first lines and without a header (skip lines, header no), with columns by number";
/// Advice on saving a sheet that is open anyway.
const AS_SHEET_OR_ODS: &str = "save it as .ods, .xlsx or CSV";

/// Returns whether a file that starts like this is a tar archive, of any version (POSIX.1, pax). Behind a name in 100 bytes its first
/// header has the mode and both owners as octal digits.
fn is_tar(start: &[u8]) -> bool {
    let Some((name, numbers)) = start.split_at_checked(100) else { return false };
    let is_number = |field: &[u8]| {
        field.split_last().is_some_and(|(end, digits)| {
            matches!(end, 0 | b' ') && digits.iter().all(|digit| matches!(digit, b'0'..=b'7' | b' '))
        })
    };
    name.last() == Some(&0) && numbers.len() >= 24 && numbers.chunks(8).take(3).all(is_number)
}

/// Refuses what is not text where text is read.
pub(crate) fn refuse_binary(file: &str, start: &[u8]) -> Result<(), InputError> {
    let refused =
        |format, instead| Err(InputError::of_file(file, InputErrorKind::BinaryTable { format, instead }));
    if let Some(packing) = Packing::of(start).filter(|_| cfg!(not(feature = "packed"))) {
        return refused(packing.name(), NO_UNPACKING);
    }
    if let Some(format) = BinaryFormat::of(start) {
        let instead = match (format.missing_feature(), file) {
            (Some(missing), _) => missing,
            (None, STANDARD_INPUT) if format.is_columns() => {
                "it is read from a named file, not from standard input"
            }
            _ if format.is_columns() => {
                "it is read from a file of its own, not out of a compressed one or another stream"
            }
            _ => "only text is read here",
        };
        return refused(format.name(), instead);
    }
    // A start that is also a word of text decides only if bytes follow that no text has.
    let has_control =
        start.iter().take(START as usize).any(|byte| *byte < b' ' && !b"\t\n\r\x0b\x0c".contains(byte));
    let is_word = |magic: &[u8]| magic.is_ascii() && magic.iter().all(|byte| byte.is_ascii_alphanumeric());
    let is_it = |magic: &[u8]| start.starts_with(magic) && (has_control || !is_word(magic));
    match FOREIGN.iter().find(|(magic, ..)| is_it(magic)) {
        Some((_, format, instead)) => refused(format, instead),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use std::io;

    use crate::{ColumnSelector, ScanOptions, Source, TableOptions, read_table, scan};

    fn messages(start: &[u8]) -> [String; 2] {
        let columns = [ColumnSelector::name_or_number("x")];
        let source = || Source::new("table.csv", io::Cursor::new(start.to_vec()));
        let read = read_table(source(), &columns, &TableOptions::default()).map(|_| ());
        let scanned = scan(source(), &columns, &ScanOptions::default(), |_| (), |()| ()).map(|_| ());
        [read, scanned].map(|result| result.unwrap_err().to_string())
    }

    #[test]
    fn binary_tables_are_refused_by_name_where_text_is_read() {
        let instead = if cfg!(feature = "arrow") {
            "it is read from a file of its own, not out of a compressed one or another stream"
        } else {
            "this build has no reader of it (feature arrow); save it as CSV: "
        };
        for (start, format) in [
            (&b"PAR1\x15\x04"[..], "a Parquet file"),
            (b"ARROW1\0\0", "an Arrow IPC file"),
            (b"\xff\xff\xff\xff\x10\0\0\0", "an Arrow IPC stream"),
        ] {
            let message = format!("table.csv: this is {format}; {instead}");
            assert!(messages(start).iter().all(|own| own.starts_with(&message)), "{message}");
        }
        assert!(messages(b"PAR,x\n1,y\n").iter().all(|message| message.contains("not a number")));
    }

    #[test]
    fn documents_are_named_with_what_can_be_done() {
        for (text, words) in [
            ("<?xml version=\"1.0\"?>\n\n<office:document x=\"y\">", ["(.fods)", "save it as .ods"]),
            ("<?xml version=\"1.0\"?>\n<?mso-application progid=\"Excel.Sheet\"?>", ["Excel 2003", ".xlsx"]),
            ("\n<!DOCTYPE html>\n<p>x,y", ["an HTML page", "CSV"]),
            ("<table><tr><td>x</td></tr>\n", ["an HTML page", "CSV"]),
            ("<?xml version=\"1.0\"?>\n<rows>\n", ["an XML document", "CSV"]),
            ("<!-- saved -->\n<HTML><table>", ["an HTML or XML document", "CSV"]),
            ("<data>\n<row><x>1</x></row>\n</data>\n", ["an HTML or XML document", "CSV"]),
            ("<svg xmlns=\"a\"><path d=\"M1,1\"/></svg>\n", ["an XML document", "CSV"]),
            ("\\begin{tabular}{cc}\nx & y\n", ["LaTeX", "CSV"]),
            ("\x7fELF\x02\x01\x01\0\0x,y\n", ["of no kind that is known here", "CSV"]),
            ("% x\n\n@RELATION run\n@DATA\n1,2\n", ["an ARFF file", "CSV"]),
            ("! x\n# GHz S RI R 50\n1 2 3\n", ["a Touchstone file", "skip lines"]),
            ("Title: x\nDate: y\nPlotname: z\n", ["a SPICE raw file", "wrdata FILE"]),
        ] {
            let messages = messages(text.as_bytes());
            assert!(
                messages.iter().all(|message| words.iter().all(|words| message.contains(words))),
                "{messages:?}"
            );
        }
        for text in [
            "Title,x\nPlotname:,y\n",
            "# GHzx\n1\n",
            "<x,x\n1,y\n",
            "<DL,x\n1,y>\n",
            "<b>x</b>,<i>y</i>\n1,z\n",
            "@relations,x\n1,y\n",
        ] {
            assert!(messages(text.as_bytes()).iter().all(|message| !message.contains("this is")), "{text}");
        }
    }

    #[test]
    fn every_other_binary_is_named_with_what_can_be_done() {
        for (magic, format, instead) in super::FOREIGN {
            let content = [magic, b"\x01\x00\x02\xff rest"].concat();
            let message = format!("table.csv: this is {format}; {instead}");
            assert_eq!(messages(&content), [message.clone(), message]);
        }
        // A table whose first column is called like that is a table.
        for text in ["BZh,x\n1,y\n", "ORC,x\n1,y\n", "GIF8,x\n1,y\n"] {
            assert!(
                messages(text.as_bytes()).iter().all(|message| message.contains("not a number")),
                "{text}"
            );
        }
    }
}
