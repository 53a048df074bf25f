//! Writing the answer: to standard output, or to a file whole or not at all, and never over what is not ours to replace.

mod guard;
mod marks;
mod text;

use std::fs;
use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::process;
use std::sync::{Mutex, PoisonError};

use boundfit_exact::Foreign;
use tempfile::{Builder, NamedTempFile};

use crate::exit::Failure;

pub(crate) use guard::{Guard, is_read};
pub(crate) use text::written;

/// Refuses to print on a terminal what no person reads there, such as a PNG or a page of a megabyte.
pub(crate) fn refuse_terminal(kind: &str, file: Option<&str>) -> Result<(), Failure> {
    match file.is_none() && io::stdout().is_terminal() {
        true => Err(Failure::Usage(format!(
            "a {kind} is nothing for a terminal: name a file with '--output', or pipe it on"
        ))),
        false => Ok(()),
    }
}

/// Writes several answers, each to its own file that the guard lets be written, or to standard output without one or
/// for `-`. All files are written whole and are on the disk before the first of them appears, and an interruption
/// waits until the last one has. So a new proof never stands beside an old report, unless the program is killed or
/// the power fails between two renamings. Standard output comes last.
pub(crate) fn write_together(parts: &[(&[u8], Option<&str>)], guard: &mut Guard) -> Result<(), Failure> {
    let (mut files, mut streams) = (Vec::new(), Vec::new());
    for &(bytes, file) in parts {
        let mut output = Output::open(file, guard)?;
        if !matches!(output.target, Target::Temporary { .. }) {
            streams.push((output, bytes));
            continue;
        }
        match output.write(bytes) {
            Ok(()) => files.push(output.prepared()?),
            Err(Stop::Closed) => {}
            Err(Stop::Failed(failure)) => return Err(failure),
        }
    }
    let mut unfinished = UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner);
    for file in files {
        // Two names of a file that was not there when they were compared are found out here.
        guard.check(Some(&file.name))?;
        let name = file.name.clone();
        file.appear(&mut unfinished)?;
        guard.keep_written(&name);
    }
    drop(unfinished);
    for (mut output, bytes) in streams {
        match output.write(bytes) {
            Ok(()) => output.finish()?,
            Err(Stop::Closed) => {}
            Err(Stop::Failed(failure)) => return Err(failure),
        }
    }
    Ok(())
}

/// Writes an answer to a file that the guard lets be written, or to standard output without one or for `-`. A reader of
/// standard output that has gone away is no error.
pub(crate) fn write(answer: impl AsRef<[u8]>, file: Option<&str>, guard: &Guard) -> Result<(), Failure> {
    write_parts(|output| output.write(answer.as_ref()), file, guard)
}

/// Writes an answer that is not in memory as a whole.
pub(crate) fn write_parts(
    write: impl FnOnce(&mut Output) -> Result<(), Stop>,
    file: Option<&str>,
    guard: &Guard,
) -> Result<(), Failure> {
    let mut output = Output::open(file, guard)?;
    match write(&mut output) {
        Ok(()) => output.finish(),
        Err(Stop::Closed) => Ok(()),
        Err(Stop::Failed(failure)) => Err(failure),
    }
}

/// Writes files, by their names, into a folder, which is made where there is none. All of them or, where it can be told
/// beforehand that one cannot be written, none.
pub(crate) fn write_all<W>(folder: &str, files: &[(String, W)], guard: &Guard) -> Result<(), Failure>
where
    W: Fn(&mut Output) -> Result<(), Stop>,
{
    guard.check_all(folder, files.iter().map(|(name, _)| name.clone()))?;
    let made: Vec<&Path> = Path::new(folder)
        .ancestors()
        .take_while(|path| *path != Path::new("") && fs::symlink_metadata(path).is_err())
        .collect();
    let not_made = |error: io::Error| {
        let name = Foreign::of(folder);
        match Path::new(folder).is_file() {
            true => Failure::data(format_args!(
                "{name}: cannot create: a file is there, and several files need a folder"
            )),
            false => Failure::data(format_args!("{name}: cannot create: {error}")),
        }
    };
    let written =
        fs::create_dir_all(folder).map_err(not_made).and_then(|()| write_into(folder, files, guard));
    if written.is_err() {
        // Folders that hold files stay.
        made.iter().take_while(|path| fs::remove_dir(path).is_ok()).count();
    }
    written
}

/// Writes files into a folder that is there.
fn write_into<W>(folder: &str, files: &[(String, W)], guard: &Guard) -> Result<(), Failure>
where
    W: Fn(&mut Output) -> Result<(), Stop>,
{
    let path = |(name, _): &(String, _)| Path::new(folder).join(name).to_string_lossy().into_owned();
    let paths: Vec<String> = files.iter().map(path).collect();
    if let Some(path) = paths.iter().find(|path| Path::new(path).is_dir()) {
        return Err(Failure::data(format_args!("{}: cannot write: is a directory", Foreign::of(path))));
    }
    tempfile::tempfile_in(folder).map_err(|error| {
        Failure::data(format_args!("{}: cannot write: {}", Foreign::of(folder), error.kind()))
    })?;
    for (done, (path, (_, content))) in paths.iter().zip(files).enumerate() {
        write_parts(content, Some(path), guard).map_err(|failure| match failure {
            Failure::Data(message) if done > 0 => {
                let written = paths.iter().take(done).map(|path| Foreign::of(path).to_string());
                let written: Vec<String> = written.collect();
                Failure::Data(format!("{message} (already written: {})", written.join(", ")))
            }
            other => other,
        })?;
    }
    Ok(())
}

/// The temporary files that would be left behind if the program ended now.
static UNFINISHED: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// Ends the program now, and lets no temporary file remain or come into being.
pub(crate) fn end_without_unfinished(status: i32) -> ! {
    // Held until the end. Nothing panics while it holds the lock; if it did, there would be no more file to come.
    let unfinished = UNFINISHED.lock();
    for path in unfinished.as_deref().map(Vec::as_slice).unwrap_or_default() {
        // Nothing is left to do when it cannot be removed.
        let _ = fs::remove_file(path);
    }
    process::exit(status)
}

/// The reason why writing ends before everything is written.
pub(crate) enum Stop {
    /// The reader of standard output has gone away; that is no error.
    Closed,
    /// The output cannot be written.
    Failed(Failure),
}

/// An answer that is written in parts. A file appears whole when it is finished, or not at all.
pub(crate) struct Output {
    /// The name of the file in messages.
    name: String,
    target: Target,
}

#[allow(clippy::large_enum_variant, reason = "one per run")]
enum Target {
    Standard,
    /// A device or a pipe, which may not be replaced.
    Device(fs::File),
    /// A file beside the final one.
    Temporary {
        temporary: NamedTempFile,
        becomes: PathBuf,
        existing: Option<fs::Metadata>,
    },
}

impl Output {
    /// Gets ready to write to a file, or to standard output without one or for `-`. The guard is asked again: since it was
    /// asked before the work began, a file may have come to be there.
    pub(crate) fn open(file: Option<&str>, guard: &Guard) -> Result<Self, Failure> {
        guard.check(file)?;
        let Some(file) = file.filter(|file| *file != "-") else {
            return Ok(Output { name: "standard output".to_owned(), target: Target::Standard });
        };
        let target = Target::open(Path::new(file)).map_err(|error| cannot_write(file, &error))?;
        Ok(Output { name: file.to_owned(), target })
    }

    /// Writes the next part.
    pub(crate) fn write(&mut self, bytes: &[u8]) -> Result<(), Stop> {
        let written = match &mut self.target {
            Target::Standard => io::stdout().write_all(bytes),
            Target::Device(device) => device.write_all(bytes),
            Target::Temporary { temporary, .. } => temporary.as_file_mut().write_all(bytes),
        };
        written.map_err(|error| self.stop(&error))
    }

    /// Lets the file appear.
    pub(crate) fn finish(self) -> Result<(), Failure> {
        match self.target {
            Target::Standard => flush(),
            Target::Device(_) => Ok(()),
            Target::Temporary { .. } => {
                let prepared = self.prepared()?;
                prepared.appear(&mut UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner))
            }
        }
    }

    /// Has everything on the disk that is to appear, and nothing appear.
    fn prepared(self) -> Result<Self, Failure> {
        if let Target::Temporary { temporary, existing, .. } = &self.target {
            // The user's mask was applied on creation; a file that is replaced keeps what it had.
            let permissions = existing.as_ref().map(fs::Metadata::permissions);
            let kept = permissions.map_or(Ok(()), |own| temporary.as_file().set_permissions(own));
            kept.and_then(|()| temporary.as_file().sync_all())
                .map_err(|error| cannot_write(&self.name, &error))?;
        }
        Ok(self)
    }

    /// Renames the temporary file, which is prepared, so that its target is never half written, not even when the power fails.
    fn appear(self, unfinished: &mut Vec<PathBuf>) -> Result<(), Failure> {
        let Target::Temporary { temporary, becomes, .. } = self.target else { return Ok(()) };
        let path = temporary.path().to_owned();
        let renamed = temporary.persist(&becomes).map_err(|error| error.error);
        renamed.map_err(|error| cannot_write(&self.name, &error))?;
        unfinished.retain(|other| *other != path);
        sync_folder_of(&becomes);
        Ok(())
    }

    fn stop(&self, error: &io::Error) -> Stop {
        let is_closed = matches!(self.target, Target::Standard) && error.kind() == io::ErrorKind::BrokenPipe;
        if is_closed { Stop::Closed } else { Stop::Failed(cannot_write(&self.name, error)) }
    }
}

fn flush() -> Result<(), Failure> {
    match io::stdout().flush() {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err(cannot_write("standard output", &error))
        }
        _ => Ok(()),
    }
}

fn cannot_write(name: &str, error: &io::Error) -> Failure {
    let folder = Path::new(name).parent().filter(|folder| !folder.as_os_str().is_empty() && !folder.exists());
    match folder {
        Some(folder) if error.kind() == io::ErrorKind::NotFound => {
            let folder = folder.to_string_lossy();
            Failure::data(format_args!(
                "{}: cannot write: there is no folder {}",
                Foreign::of(name),
                Foreign::of(&folder)
            ))
        }
        _ => Failure::data(format_args!("{}: cannot write: {error}", Foreign::of(name))),
    }
}

impl Target {
    fn open(file: &Path) -> io::Result<Self> {
        // A link is written through, and a device or pipe is written to: neither may be replaced. A link that leads nowhere makes
        // the file that it names; links in a circle name none.
        let existing = match fs::metadata(file) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(error),
            found => found.ok(),
        };
        if existing.as_ref().is_some_and(fs::Metadata::is_dir) {
            return Err(io::Error::other("is a directory"));
        }
        if existing.as_ref().is_some_and(|metadata| !metadata.is_file()) {
            return Ok(Target::Device(fs::OpenOptions::new().write(true).open(file)?));
        }
        let becomes = resolved(file);
        let directory = match becomes.parent() {
            Some(parent) if parent != Path::new("") => parent.to_owned(),
            _ => PathBuf::from("."),
        };
        let mut unfinished = UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner);
        // The temporary file is created here and not by the library. So it gets the permissions of any new file, less
        // the user's mask, and no error names the temporary file, whose name means nothing to the user.
        let temporary =
            Builder::new().prefix(".boundfit-").make_in(directory, |path| fs::File::create_new(path))?;
        unfinished.push(temporary.path().to_owned());
        drop(unfinished);
        Ok(Target::Temporary { temporary, becomes, existing })
    }
}

/// Has the new name on the disk before the program says that all is well.
#[cfg(unix)]
fn sync_folder_of(file: &Path) {
    let folder = file.parent().filter(|folder| *folder != Path::new("")).unwrap_or(Path::new("."));
    // Not every file system can, and the file is there all the same.
    let _ = fs::File::open(folder).and_then(|folder| folder.sync_all());
}

/// Does nothing: this system cannot open a folder like a file, and keeps names in a journal.
#[cfg(not(unix))]
fn sync_folder_of(_: &Path) {}

/// Returns whether two names mean one file, which need not exist yet.
pub(crate) fn is_one_file(first: &str, second: &str) -> bool {
    let whole = |file: &str| {
        let resolved = resolved(Path::new(file));
        let folder = resolved.parent().filter(|folder| *folder != Path::new("")).unwrap_or(Path::new("."));
        match (fs::canonicalize(folder), resolved.file_name()) {
            (Ok(folder), Some(name)) => folder.join(name),
            _ => resolved,
        }
    };
    let is_same = |first: &str, second: &str| same_file::is_same_file(first, second).unwrap_or(false);
    let is_file = |file: &str| fs::metadata(file).is_ok_and(|metadata| metadata.is_file());
    whole(first) == whole(second) || (is_file(first) && is_file(second) && is_same(first, second))
}

/// The file behind any links, which need not exist yet.
fn resolved(file: &Path) -> PathBuf {
    /// The number of links that the kernel follows.
    const MOST_LINKS: usize = 40;
    if let Ok(target) = fs::canonicalize(file) {
        return target;
    }
    let mut target = file.to_owned();
    for _ in 0..MOST_LINKS {
        let Ok(next) = fs::read_link(&target) else { break };
        target = target.parent().map_or_else(|| next.clone(), |folder| folder.join(&next));
    }
    target
}

/// Refuses options that would write to one file, or to standard output like the report without a file of its own.
pub(crate) fn files_apart(report: Option<&str>, others: &[(&str, Option<&str>)]) -> Result<(), Failure> {
    let report = ("--output", Some(report.unwrap_or("-")));
    let all: Vec<_> = [report].into_iter().chain(others.iter().copied()).collect();
    for (index, (option, file)) in all.iter().enumerate() {
        for (other, other_file) in all.iter().skip(index + 1) {
            let (Some(file), Some(other_file)) = (file, other_file) else { continue };
            match (*file, *other_file) {
                ("-", "-") => {
                    let both = if index == 0 {
                        format!("'{other} -' and the report")
                    } else {
                        format!("'{option} -' and '{other} -'")
                    };
                    let problem = "would both go to standard output: give one of them a file";
                    return Err(Failure::Usage(format!("{both} {problem}")));
                }
                (file, other_file) if file != "-" && other_file != "-" && is_one_file(file, other_file) => {
                    return Err(Failure::Usage(format!("'{other}' and '{option}' name the same file")));
                }
                _ => {}
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folders_that_were_made_for_nothing_are_taken_away() {
        let directory = tempfile::tempdir().unwrap();
        let folder = directory.path().join("a/b");
        let guard = Guard::new([], false);
        let fails = |_: &mut Output| Err(Stop::Failed(Failure::data("no room")));
        let files = vec![("c.txt".to_owned(), fails)];
        assert!(write_all(folder.to_str().unwrap(), &files, &guard).is_err());
        assert!(!directory.path().join("a").exists() && directory.path().exists());
        // Earlier folders stay, and so do folders that hold files.
        fs::create_dir_all(&folder).unwrap();
        assert!(write_all(folder.to_str().unwrap(), &files, &guard).is_err());
        assert!(folder.exists());
    }
}
