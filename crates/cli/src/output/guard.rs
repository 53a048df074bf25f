//! The files that an answer may replace: no input, no read-only file, and without a further option only files that
//! this program wrote.

use std::fs::{self, File, OpenOptions};
use std::io::{self, Read};
use std::path::Path;
use std::sync::{Mutex, PoisonError};

use boundfit_exact::Foreign;
use same_file::Handle;

use super::marks::{START, is_ours};
use crate::exit::Failure;

/// The files that this run has opened to read them. The list covers a file that a command forgets to name to its
/// guard.
static OPENED: Mutex<Vec<String>> = Mutex::new(Vec::new());

/// Remembers that a file is read, so that nothing is written over it.
pub(crate) fn is_read(file: &str) {
    if file != "-" {
        OPENED.lock().unwrap_or_else(PoisonError::into_inner).push(file.to_owned());
    }
}

/// Stands between what a command writes and what is there already.
#[derive(Default)]
pub(crate) struct Guard {
    /// The files that are read, or were written by this very run, each with what messages say of it.
    kept: Vec<(Handle, String)>,
    force: bool,
}

impl Guard {
    /// Keeps these inputs, of which `-` is standard input, from being replaced; with `force` nothing else but what is
    /// read-only. An input that cannot be opened is passed over: that is said when it is read.
    pub(crate) fn new<'a>(inputs: impl IntoIterator<Item = &'a str>, force: bool) -> Self {
        let mut guard = Guard { kept: Vec::new(), force };
        for input in inputs {
            match input {
                "-" => guard.keep(Handle::stdin(), "standard input, which is read"),
                // A pipe that is opened twice loses what is in it.
                file if fs::metadata(file).is_ok_and(|metadata| metadata.is_file()) => {
                    guard.keep(Handle::from_path(file), &format!("{}, which is read", Foreign::of(file)));
                }
                _ => {}
            }
        }
        guard
    }

    fn keep(&mut self, handle: io::Result<Handle>, name: &str) {
        self.kept.extend(handle.map(|handle| (handle, name.to_owned())));
    }

    /// Keeps a file that was written from being replaced by what is written next.
    pub(crate) fn keep_written(&mut self, file: &str) {
        if fs::metadata(file).is_ok_and(|metadata| metadata.is_file()) {
            self.keep(Handle::from_path(file), &format!("{}, which was just written", Foreign::of(file)));
        }
    }

    /// Refuses to write to a file, or to standard output without one or for `-`, where that would destroy something.
    pub(crate) fn check(&self, file: Option<&str>) -> Result<(), Failure> {
        match file.filter(|file| *file != "-") {
            Some(file) => self.check_file(file),
            None => Ok(()),
        }
    }

    /// Refuses to write files of these names into a folder where one of them may not be written.
    pub(crate) fn check_all(
        &self,
        folder: &str,
        names: impl IntoIterator<Item = String>,
    ) -> Result<(), Failure> {
        let paths = names.into_iter().map(|name| Path::new(folder).join(name).to_string_lossy().into_owned());
        paths.into_iter().try_for_each(|path| self.check(Some(&path)))
    }

    fn check_file(&self, file: &str) -> Result<(), Failure> {
        let refuse =
            |why: String| Err(Failure::data(format_args!("{}: not written: {why}", Foreign::of(file))));
        // Devices and pipes are written to and stay what they are.
        let Some(metadata) = fs::metadata(file).ok().filter(fs::Metadata::is_file) else { return Ok(()) };
        if let Ok(handle) = Handle::from_path(file) {
            if let Some((_, name)) = self.kept.iter().find(|(kept, _)| *kept == handle) {
                return refuse(format!("it is {name}"));
            }
            let is_it = |opened: &&String| {
                fs::metadata(opened).is_ok_and(|metadata| metadata.is_file())
                    && Handle::from_path(opened).is_ok_and(|opened| opened == handle)
            };
            let opened = OPENED.lock().unwrap_or_else(PoisonError::into_inner);
            if let Some(opened) = opened.iter().find(is_it) {
                return refuse(format!("it is {}, which is read", Foreign::of(opened)));
            }
        }
        if metadata.permissions().readonly() || is_denied(file) {
            return refuse("it is read-only (--force does not change that)".to_owned());
        }
        if self.force || metadata.len() == 0 || start_of(file).is_ok_and(|start| is_ours(&start)) {
            return Ok(());
        }
        refuse("it is there and does not look as if boundfit wrote it (--force replaces it)".to_owned())
    }
}

/// Returns whether the system keeps this user from writing to a file.
fn is_denied(file: &str) -> bool {
    OpenOptions::new()
        .append(true)
        .open(file)
        .is_err_and(|error| error.kind() == io::ErrorKind::PermissionDenied)
}

/// The first bytes of a file.
fn start_of(file: &str) -> io::Result<Vec<u8>> {
    let mut start = Vec::new();
    File::open(file)?.take(START).read_to_end(&mut start)?;
    Ok(start)
}
