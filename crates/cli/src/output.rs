//! Writing files all or nothing, and reports to a pipe that may be closed.

use std::fs::{self, File, OpenOptions};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

use crate::failure::Failure;

/// Checks that files can be written at these `paths`, by files beside them that are removed at
/// once: what is to be written may take an hour to find. No two may be the same.
pub(crate) fn check_writable<'a>(paths: impl Iterator<Item = &'a Path>) -> Result<(), Failure> {
    let drafts: Vec<Draft<'_>> = paths.map(tried).collect::<Result<_, _>>()?;
    drop(drafts);
    Ok(())
}

/// Checks that writing `path` would not destroy the input file.
pub(crate) fn check_apart(path: &Path, input: &Path) -> Result<(), Failure> {
    let same = match (fs::canonicalize(path), fs::canonicalize(input)) {
        (Ok(path), Ok(input)) => path == input,
        _ => false,
    };
    if same { Err(Failure::SameFile { name: path.display().to_string() }) } else { Ok(()) }
}

/// Writes to standard output; a reader that has seen enough is no failure.
pub(crate) fn write_report(report: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    match out.write_all(report.as_bytes()).and_then(|()| out.flush()) {
        Err(e) if e.kind() != ErrorKind::BrokenPipe => Err(Failure::Output(e)),
        _ => Ok(()),
    }
}

/// A whole file that is still beside the one that it will replace, and is removed if it does not.
#[derive(Debug)]
pub(crate) struct Draft<'a> {
    path: &'a Path,
    /// The file that a link leads to is replaced, not the link.
    target: PathBuf,
    content: &'a str,
    /// None for a device or a pipe: they have no content to keep.
    beside: Option<PathBuf>,
}

impl<'a> Draft<'a> {
    /// Writes all but the name.
    pub(crate) fn new(path: &'a Path, content: &'a str) -> Result<Self, Failure> {
        let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
        let mut draft = Self { path, target, content, beside: None };
        draft.write().map_err(|source| draft.failure(source))?;
        Ok(draft)
    }

    /// Gives it its name.
    pub(crate) fn publish(mut self) -> Result<(), Failure> {
        let published = match &self.beside {
            Some(beside) => fs::rename(beside, &self.target),
            None => File::create(&self.target)
                .and_then(|mut device| device.write_all(self.content.as_bytes())),
        };
        published.map_err(|source| self.failure(source))?;
        self.beside = None;
        Ok(())
    }

    fn write(&mut self) -> io::Result<()> {
        let permissions = match fs::metadata(&self.target) {
            Ok(old) if old.is_dir() => return Err(ErrorKind::IsADirectory.into()),
            Ok(old) if !old.is_file() => return Ok(()),
            Ok(old) if old.permissions().readonly() => {
                return Err(ErrorKind::PermissionDenied.into());
            }
            Ok(old) => Some(old.permissions()),
            Err(_) => None,
        };
        let beside = beside(&self.target);
        let mut file = OpenOptions::new().write(true).create_new(true).open(&beside)?;
        let beside = self.beside.insert(beside);
        file.write_all(self.content.as_bytes())?;
        file.sync_all()?;
        permissions.map_or(Ok(()), |permissions| fs::set_permissions(beside, permissions))
    }

    fn failure(&self, source: io::Error) -> Failure {
        Failure::Unwritable { name: self.path.display().to_string(), source }
    }
}

impl Drop for Draft<'_> {
    fn drop(&mut self) {
        if let Some(beside) = &self.beside {
            // The first error is the one to report.
            let _ = fs::remove_file(beside);
        }
    }
}

/// What is written at `path` to see whether it can be.
fn tried(path: &Path) -> Result<Draft<'_>, Failure> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    if let Some(folder) = folder.filter(|folder| !folder.is_dir()) {
        let (name, folder) = (path.display().to_string(), folder.display().to_string());
        return Err(Failure::NoFolder { name, folder });
    }
    Draft::new(path, "")
}

/// A name in the same folder that nobody else uses.
fn beside(path: &Path) -> PathBuf {
    let mut name = std::ffi::OsString::from(".");
    name.push(path.file_name().unwrap_or_default());
    name.push(format!(".{}.part", std::process::id()));
    path.with_file_name(name)
}
