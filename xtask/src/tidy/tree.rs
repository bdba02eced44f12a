//! The files of the repository that the checks read.

use std::fs;
use std::path::{Path, PathBuf};

use crate::failure::Failure;
use crate::workspace::ROOT;

/// A text file and where it is.
#[derive(Debug)]
pub(super) struct Source {
    /// From the root of the repository, with `/`.
    pub(super) path: String,
    /// All of it.
    pub(super) text: String,
}

/// Everything the checks read, sorted by path.
#[derive(Debug, Default)]
pub(super) struct Tree {
    /// Every `.rs` file.
    pub(super) rust: Vec<Source>,
    /// Every `.md` file.
    pub(super) pages: Vec<Source>,
    /// Every `Cargo.toml`.
    pub(super) manifests: Vec<Source>,
}

impl Tree {
    /// Reads the repository, without hidden folders and what cargo builds.
    pub(super) fn read() -> Result<Self, Failure> {
        let mut tree = Self::default();
        tree.read_folder(Path::new(ROOT), "")?;
        Ok(tree)
    }

    /// The page at a path, as an empty one when it is missing: the checks then say what it lacks.
    pub(super) fn page<'a>(&'a self, path: &'a str) -> (&'a str, &'a str) {
        let page = self.pages.iter().find(|page| page.path == path);
        (path, page.map_or("", |page| &page.text))
    }

    fn read_folder(&mut self, folder: &Path, prefix: &str) -> Result<(), Failure> {
        for entry in sorted_entries(folder, prefix)? {
            let Some(name) = entry.file_name().and_then(|name| name.to_str()) else {
                continue;
            };
            let path = format!("{prefix}{name}");
            // A folder with a cache tag is a target folder, whatever its name.
            if name.starts_with('.') || entry.join("CACHEDIR.TAG").exists() {
                continue;
            }
            if entry.is_dir() {
                self.read_folder(&entry, &format!("{path}/"))?;
            } else if let Some(list) = self.list_for(name) {
                let text = fs::read_to_string(&entry)
                    .map_err(|source| Failure::Unreadable { path: path.clone(), source })?;
                list.push(Source { path, text });
            }
        }
        Ok(())
    }

    fn list_for(&mut self, name: &str) -> Option<&mut Vec<Source>> {
        match name.rsplit_once('.') {
            Some((_, "rs")) => Some(&mut self.rust),
            Some((_, "md")) => Some(&mut self.pages),
            Some(("Cargo", "toml")) => Some(&mut self.manifests),
            _ => None,
        }
    }
}

/// Whether the repository has this file or folder.
pub(super) fn exists(path: &str) -> bool {
    Path::new(ROOT).join(path).exists()
}

fn sorted_entries(folder: &Path, prefix: &str) -> Result<Vec<PathBuf>, Failure> {
    let unreadable = |source| Failure::Unreadable { path: format!("{prefix}."), source };
    let mut entries = fs::read_dir(folder)
        .map_err(unreadable)?
        .map(|entry| entry.map(|entry| entry.path()))
        .collect::<Result<Vec<_>, _>>()
        .map_err(unreadable)?;
    entries.sort();
    Ok(entries)
}
