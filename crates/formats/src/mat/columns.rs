//! The columns that are asked for.

use std::io::{self, Read};

use super::elements::{ByteOrder, Damage, byte_order};
use super::file::MatFile;
use super::octave;
use super::search::{MatColumn, Search, Wanted};
use super::v4;
use crate::budget::HeldMemory;
use crate::columns::ColumnSelector;
use crate::error::InputErrorKind;
use crate::limits::SizeLimits;
use crate::mat_kind::{MatKind, START, is_octave, kind_of};
use crate::scan::Progress;

/// The name of such files in reports.
const FORMAT: &str = "a MATLAB file";

/// Advice on getting tables of HDF5 files.
const FROM_HDF5: &str = "save its table as CSV: in Python pandas.read_hdf('FILE').to_csv('FILE.csv') or numpy.savetxt('FILE.csv', h5py.File('FILE')['NAME'][:], delimiter=',', fmt='%s'), in Octave save -text FILE NAME";

/// Columns of one length out of a file.
pub(super) struct MatColumns {
    /// The columns asked for, in that order.
    pub(super) columns: Vec<MatColumn>,
    /// The number of numbers that each column has.
    pub(super) rows: usize,
    /// SHA-256 of the file's bytes, in hexadecimal, if it was wanted.
    pub(super) sha256: Option<String>,
    /// The number of bytes of the file.
    pub(super) bytes: u64,
    /// The memory of the numbers.
    pub(super) memory: HeldMemory,
}

impl MatColumns {
    /// Reads the columns that are asked for, and nothing of the other variables but their names.
    pub(super) fn read(
        file: Box<dyn Read>,
        selectors: &[&ColumnSelector],
        sizes: &SizeLimits,
        hash: bool,
        progress: Option<&dyn Progress>,
    ) -> Result<Self, InputErrorKind> {
        let mut file = MatFile::new(file, hash, progress);
        let (layout, first) = header(&mut file)?;
        let wanted: Vec<Wanted> = selectors.iter().map(|selector| Wanted::new(selector)).collect();
        let mut search = Search::new(&wanted, sizes);
        let mut first = first.as_slice();
        loop {
            file.go_on()?;
            let start = file.position() - first.len() as u64;
            let found = match layout {
                Layout::Octave => {
                    octave::read(&mut search, first, &mut file, sizes)?;
                    break;
                }
                Layout::V4 => v4::next(&mut search, &mut first.by_ref().chain(&mut file)),
                Layout::V5(order) => search.next(&mut file, order),
            };
            if !found.map_err(|damage| unreadable(start, damage))? {
                break;
            }
        }
        let (columns, rows) = search.columns()?;
        Ok(MatColumns { columns, rows, sha256: file.sha256(), bytes: file.position(), memory: search.memory })
    }
}

/// The layout of a file's variables.
enum Layout {
    /// Version 4, each variable in an order of bytes of its own.
    V4,
    /// Version 5, in this order of bytes.
    V5(ByteOrder),
    /// Octave's text.
    Octave,
}

/// Reads as much as tells how a file is written; gives what of that belongs to its first variable.
fn header(file: &mut MatFile) -> Result<(Layout, Vec<u8>), InputErrorKind> {
    let mut header = Vec::new();
    file.by_ref().take(START as u64).read_to_end(&mut header)?;
    if is_octave(&header) {
        return Ok((Layout::Octave, header));
    }
    let refused = |format, instead| Err(InputErrorKind::BinaryTable { format, instead });
    match kind_of(&header) {
        Some(MatKind::V73) => refused(
            "a MATLAB file of version 7.3, which is HDF5",
            "save it with -v7: save('FILE.mat', '-v7')",
        ),
        Some(MatKind::Hdf5) => refused("an HDF5 file", FROM_HDF5),
        Some(MatKind::V4) => Ok((Layout::V4, header)),
        Some(MatKind::V5) | None => match byte_order(&header) {
            Some(order) => Ok((Layout::V5(order), Vec::new())),
            None => {
                let reason = "its header of 128 bytes does not end with version and byte order".to_owned();
                Err(InputErrorKind::Unreadable { format: FORMAT, reason: reason.into() })
            }
        },
    }
}

/// The problem with the variable that starts at this byte.
fn unreadable(start: u64, damage: Damage) -> InputErrorKind {
    let reason = match damage {
        Damage::Refused(problem) => return problem,
        Damage::Format(reason) => format!("the variable at byte {start}: {reason}"),
        Damage::Io(error) => match error.kind() {
            io::ErrorKind::UnexpectedEof => format!("it stops within the variable at byte {start}"),
            io::ErrorKind::InvalidData | io::ErrorKind::InvalidInput => {
                format!("the variable at byte {start} cannot be inflated: {error}")
            }
            _ => return error.into(),
        },
    };
    InputErrorKind::Unreadable { format: FORMAT, reason: reason.into() }
}
