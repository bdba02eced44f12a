//! The workspace as `cargo metadata` tells it, with the tables of the root manifest.

use std::collections::{BTreeMap, BTreeSet};
use std::process::Command;

use serde::Deserialize;

use crate::failure::Failure;

/// The folder that holds the root manifest.
pub(crate) const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/..");

/// Packages and the tables of `[workspace.metadata]` that say how they may depend on each other.
#[derive(Debug, Deserialize)]
pub(crate) struct Workspace {
    /// Every package of the workspace.
    pub(crate) packages: Vec<Package>,
    /// The tables of the root manifest.
    #[serde(rename = "metadata")]
    pub(crate) tables: Tables,
    /// The folder of the root manifest, as cargo writes it in front of `manifest_path`.
    #[serde(rename = "workspace_root")]
    root: String,
}

/// `[workspace.metadata]` of the root manifest.
#[derive(Debug, Deserialize)]
pub(crate) struct Tables {
    /// Layer of each package that has one.
    pub(crate) layers: BTreeMap<String, u32>,
    /// Packages outside the layers.
    pub(crate) tools: BTreeMap<String, String>,
    /// The third parties that each layered package uses; `["*"]` for any.
    #[serde(rename = "third-parties")]
    pub(crate) third_parties: BTreeMap<String, BTreeSet<String>>,
}

/// One package of the workspace.
#[derive(Debug, Deserialize)]
pub(crate) struct Package {
    /// Its name.
    pub(crate) name: String,
    /// Its manifest; an absolute path, see [`Workspace::manifest_path`].
    manifest_path: String,
    /// What it depends on, for whatever purpose.
    pub(crate) dependencies: Vec<Dependency>,
    targets: Vec<Target>,
    /// What may be switched on in it.
    features: BTreeMap<String, Vec<String>>,
}

/// One line of a dependency table.
#[derive(Debug, Deserialize)]
pub(crate) struct Dependency {
    /// The package depended on.
    pub(crate) name: String,
    /// `dev`, `build`, or nothing for a normal one.
    kind: Option<String>,
}

#[derive(Debug, Deserialize)]
struct Target {
    kind: Vec<String>,
}

impl Workspace {
    /// Asks cargo, without resolving third parties: needs no network.
    pub(crate) fn load() -> Result<Self, Failure> {
        let arguments = ["metadata", "--no-deps", "--format-version", "1"];
        let answer =
            Command::new("cargo").args(arguments).current_dir(ROOT).output().map_err(|source| {
                Failure::NotStarted { command: format!("cargo {}", arguments.join(" ")), source }
            })?;
        if !answer.status.success() {
            let message = String::from_utf8_lossy(&answer.stderr).into_owned();
            return Err(Failure::WorkspaceRefused { message });
        }
        Self::parse(&String::from_utf8_lossy(&answer.stdout))
    }

    /// Reads the answer of `cargo metadata --no-deps --format-version 1`.
    pub(crate) fn parse(json: &str) -> Result<Self, Failure> {
        Ok(serde_json::from_str(json)?)
    }

    /// The manifest of a package, from the root of the repository.
    pub(crate) fn manifest_path<'a>(&self, package: &'a Package) -> &'a str {
        let path = package.manifest_path.as_str();
        path.strip_prefix(&self.root).unwrap_or(path).trim_start_matches('/')
    }

    /// Whether the name is a package of this workspace.
    pub(crate) fn has(&self, name: &str) -> bool {
        self.packages.iter().any(|package| package.name == name)
    }

    /// The layered packages that are libraries, lowest layer first.
    pub(crate) fn layered_libraries(&self) -> Vec<&Package> {
        let layer = |package: &Package| self.tables.layers.get(&package.name);
        let mut libraries: Vec<_> = self
            .packages
            .iter()
            .filter(|package| package.is_library() && layer(package).is_some())
            .collect();
        libraries.sort_by_key(|package| (layer(package), &package.name));
        libraries
    }
}

impl Package {
    /// Whether some of its code is off unless asked for.
    pub(crate) fn has_features(&self) -> bool {
        !self.features.is_empty()
    }

    fn is_library(&self) -> bool {
        self.targets.iter().any(|target| target.kind.iter().any(|kind| kind == "lib"))
    }
}

impl Dependency {
    /// Whether users of the package get it too: everything but a dev-dependency.
    pub(crate) fn ships(&self) -> bool {
        self.kind.as_deref() != Some("dev")
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::Workspace;

    /// A workspace of two libraries, a program and a tool that keeps every rule.
    pub(crate) const SOUND: &str = r#"{
        "workspace_root": "/somewhere",
        "metadata": {
            "layers": { "low": 0, "high": 1, "program": 2 },
            "tools": { "kit": "dev-dependency only" },
            "third-parties": { "low": ["robust"], "high": [], "program": ["*"] }
        },
        "packages": [
            { "name": "low", "manifest_path": "/somewhere/crates/low/Cargo.toml",
              "targets": [{ "kind": ["lib"] }], "features": {},
              "dependencies": [
                { "name": "robust", "kind": null }, { "name": "kit", "kind": "dev" }] },
            { "name": "high", "manifest_path": "/somewhere/crates/high/Cargo.toml",
              "targets": [{ "kind": ["lib"] }], "features": { "more": [] },
              "dependencies": [
                { "name": "low", "kind": null }, { "name": "proptest", "kind": "dev" }] },
            { "name": "program", "manifest_path": "/somewhere/crates/program/Cargo.toml",
              "targets": [{ "kind": ["bin"] }], "features": {},
              "dependencies": [
                { "name": "high", "kind": null }, { "name": "clap", "kind": null }] },
            { "name": "kit", "manifest_path": "/somewhere/crates/kit/Cargo.toml",
              "targets": [{ "kind": ["lib"] }], "features": {},
              "dependencies": [{ "name": "high", "kind": null }] }
        ]
    }"#;

    #[test]
    fn only_layered_libraries_are_listed_and_the_lowest_comes_first() {
        let workspace = Workspace::parse(SOUND).unwrap();
        let names: Vec<_> = workspace.layered_libraries().iter().map(|p| &*p.name).collect();
        assert_eq!(names, ["low", "high"]);
    }

    #[test]
    fn a_manifest_path_is_told_from_the_root() {
        let workspace = Workspace::parse(SOUND).unwrap();
        assert_eq!(workspace.manifest_path(&workspace.packages[0]), "crates/low/Cargo.toml");
    }

    #[test]
    fn a_root_manifest_without_a_layer_table_is_refused() {
        let error = Workspace::parse(&SOUND.replace("layers", "floors")).unwrap_err();
        assert!(error.to_string().contains("missing field `layers`"), "{error}");
    }
}
