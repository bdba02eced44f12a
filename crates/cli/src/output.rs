//! Writing files all or nothing, and reports to a pipe that may be closed.

use std::fs::{self, File, OpenOptions};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

use crate::failure::Failure;

/// Checks that writing `path` would not destroy the input file.
pub(crate) fn check_apart(path: &Path, input: &Path) -> Result<(), Failure> {
    let same = match (fs::canonicalize(path), fs::canonicalize(input)) {
        (Ok(path), Ok(input)) => path == input,
        _ => false,
    };
    if same { Err(Failure::SameFile { name: path.display().to_string() }) } else { Ok(()) }
}

/// Writes the whole file, or leaves what was there.
pub(crate) fn write_file(path: &Path, content: &str) -> Result<(), Failure> {
    replace(path, content)
        .map_err(|source| Failure::Unwritable { name: path.display().to_string(), source })
}

/// Writes to standard output; a reader that has seen enough is no failure.
pub(crate) fn write_report(report: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    match out.write_all(report.as_bytes()).and_then(|()| out.flush()) {
        Err(e) if e.kind() != ErrorKind::BrokenPipe => Err(Failure::Output(e)),
        _ => Ok(()),
    }
}

fn replace(path: &Path, content: &str) -> io::Result<()> {
    // The file that a link leads to is replaced, not the link.
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    let permissions = match fs::metadata(&target) {
        Ok(old) if old.is_dir() => return Err(ErrorKind::IsADirectory.into()),
        Ok(old) if !old.is_file() => {
            // A device or a pipe has no content to keep.
            return File::create(&target)?.write_all(content.as_bytes());
        }
        Ok(old) if old.permissions().readonly() => {
            return Err(ErrorKind::PermissionDenied.into());
        }
        Ok(old) => Some(old.permissions()),
        Err(_) => None,
    };
    let beside = beside(&target);
    let written = write_new(&beside, content).and_then(|()| {
        permissions.map_or(Ok(()), |p| fs::set_permissions(&beside, p))?;
        fs::rename(&beside, &target)
    });
    if written.is_err() {
        // The first error is the one to report.
        let _ = fs::remove_file(&beside);
    }
    written
}

/// A name in the same folder that nobody else uses.
fn beside(path: &Path) -> PathBuf {
    let mut name = std::ffi::OsString::from(".");
    name.push(path.file_name().unwrap_or_default());
    name.push(format!(".{}.part", std::process::id()));
    path.with_file_name(name)
}

fn write_new(path: &Path, content: &str) -> io::Result<()> {
    let mut file = OpenOptions::new().write(true).create_new(true).open(path)?;
    file.write_all(content.as_bytes())?;
    file.sync_all()
}
