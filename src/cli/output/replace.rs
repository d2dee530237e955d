//! A file that appears whole or not at all: written beside its place, then renamed into it.

use std::fs::{self, File, OpenOptions};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use tempfile::NamedTempFile;

use super::target::folder_of;

/// The files that are being written now, for a second Ctrl-C to remove.
static UNFINISHED: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// Whether a file can be made or replaced: its folder takes new files, and it is not read-only.
pub(super) fn check(path: &Path) -> io::Result<()> {
    match OpenOptions::new().write(true).open(path) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(error),
        Ok(_) | Err(_) => {}
    }
    // Only creating one shows whether that is possible: permissions are not all that may forbid it. The lock is held
    // until it is removed again, so that the process does not end before.
    let _unfinished = lock();
    create_beside(path).map(drop)
}

/// Writes a file with the permissions of the one it replaces, or with those of any new file.
pub(super) fn replace(path: &Path, body: impl FnOnce(&File) -> io::Result<()>) -> io::Result<()> {
    let file = Unfinished::create(path)?;
    body(file.temporary.as_file())?;
    if let Ok(replaced) = fs::metadata(path) {
        keep_permissions(file.temporary.as_file(), &replaced)?;
    }
    // A rename may reach the disk before what was written; after a crash the file would be empty.
    file.temporary.as_file().sync_all()?;
    file.finish(path)
}

/// Removes what is being written, and ends the process.
pub(crate) fn abandon_and_exit(code: i32) -> ! {
    // The lock is held until the end, so that no other file begins or ends meanwhile.
    let unfinished = lock();
    for path in unfinished.iter() {
        let _ = fs::remove_file(path);
    }
    std::process::exit(code)
}

/// A temporary file that a second Ctrl-C removes too. It is removed when dropped.
struct Unfinished {
    temporary: NamedTempFile,
}

impl Unfinished {
    fn create(path: &Path) -> io::Result<Self> {
        let mut unfinished = lock();
        let temporary = create_beside(path)?;
        unfinished.push(temporary.path().to_owned());
        Ok(Self { temporary })
    }

    /// Renames it into its place.
    fn finish(self, path: &Path) -> io::Result<()> {
        let mut unfinished = lock();
        let own = self.temporary.path().to_owned();
        self.temporary.persist(path).map_err(|error| error.error)?;
        unfinished.retain(|other| *other != own);
        Ok(())
    }
}

fn lock() -> MutexGuard<'static, Vec<PathBuf>> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A new file in the same folder, so that the rename cannot cross file systems.
fn create_beside(path: &Path) -> io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".srt-").suffix(".tmp");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // The mode of any program's new file; the system subtracts the process's umask.
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    builder.tempfile_in(folder_of(path)).map_err(without_path)
}

/// tempfile's errors name the temporary file, which nobody typed. The system's own error stands before
/// that name, and is available as text alone.
fn without_path(error: io::Error) -> io::Error {
    let text = error.to_string();
    match text.rsplit_once(" at path ") {
        Some((own, _)) => io::Error::new(error.kind(), own),
        None => error,
    }
}

/// Gives a file the permissions of the one it replaces, and its owner where the system allows it.
fn keep_permissions(file: &File, replaced: &fs::Metadata) -> io::Result<()> {
    #[cfg(unix)]
    {
        use std::os::unix::fs::{MetadataExt, fchown};
        // Only root may do this, and only root often replaces files of other users. The owner comes
        // first, because a change of it may remove permissions.
        let _ = fchown(file, Some(replaced.uid()), Some(replaced.gid()));
    }
    file.set_permissions(replaced.permissions())
}
