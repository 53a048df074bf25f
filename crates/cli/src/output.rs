//! Writing the answer: to standard output, or to a file whole or not at all.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use tempfile::Builder;

use crate::exit::Failure;

/// Writes an answer to a file, or to standard output without one or for `-`. A reader of standard output that has gone
/// away is no error.
pub(crate) fn write(answer: impl AsRef<[u8]>, file: Option<&str>) -> Result<(), Failure> {
    let bytes = answer.as_ref();
    match file.filter(|file| *file != "-") {
        Some(file) => write_file(bytes, Path::new(file))
            .map_err(|error| Failure::data(format_args!("{file}: cannot write: {error}"))),
        None => match io::stdout().write_all(bytes).and_then(|()| io::stdout().flush()) {
            Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
                Err(Failure::data(format_args!("standard output: cannot write: {error}")))
            }
            _ => Ok(()),
        },
    }
}

/// Writes to a temporary file beside the target and renames it, so that the target is never half written.
fn write_file(bytes: &[u8], file: &Path) -> io::Result<()> {
    // A link is written through, and a device or pipe is written to: neither may be replaced.
    let target = resolved(file);
    let existing = fs::metadata(&target).ok();
    if existing.as_ref().is_some_and(fs::Metadata::is_dir) {
        return Err(io::Error::other("is a directory"));
    }
    if existing.as_ref().is_some_and(|metadata| !metadata.is_file()) {
        return fs::OpenOptions::new().write(true).open(&target)?.write_all(bytes);
    }
    let directory = match target.parent() {
        Some(parent) if parent != Path::new("") => parent.to_owned(),
        _ => PathBuf::from("."),
    };
    let mut builder = Builder::new();
    if let Some(permissions) = new_file_permissions() {
        builder.permissions(permissions);
    }
    // The library's message goes on with the name of the temporary file, which says nothing to the user.
    let plain = |error: io::Error| {
        let message = error.to_string();
        io::Error::new(error.kind(), message.split(" at path ").next().unwrap_or_default().to_owned())
    };
    let mut temporary = builder.prefix(".boundfit-").tempfile_in(directory).map_err(plain)?;
    temporary.write_all(bytes)?;
    if let Some(metadata) = existing {
        // The user's mask was applied on creation; a file that is replaced keeps what it had.
        temporary.as_file().set_permissions(metadata.permissions())?;
    }
    temporary.as_file().sync_all()?;
    temporary.persist(&target).map_err(|error| plain(error.error))?;
    Ok(())
}

/// The file behind any links, which need not exist yet.
fn resolved(file: &Path) -> PathBuf {
    /// As many links as the kernel follows.
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

/// What any program asks for when it creates a file; the user's mask applies.
#[cfg(unix)]
fn new_file_permissions() -> Option<fs::Permissions> {
    use std::os::unix::fs::PermissionsExt;
    Some(fs::Permissions::from_mode(0o666))
}

#[cfg(not(unix))]
fn new_file_permissions() -> Option<fs::Permissions> {
    None
}
