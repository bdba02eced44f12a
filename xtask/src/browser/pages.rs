//! The pages that are looked at, one of each kind.

use std::fs;
use std::path::Path;
use std::process::Command;

use serde_json::Value;

use super::error::BrowserError;
use crate::workspace::ROOT;

/// Markup, and the ends of what a browser reads as text or as a script.
const HOSTILE: &str = "</script></pre><script>alert(1)</script><img src=x onerror=alert(1)>";

/// A page, and the command that makes it.
#[derive(Debug)]
pub(super) struct Page {
    pub(super) name: &'static str,
    /// Separated by single spaces.
    arguments: &'static str,
    /// The file it is about, if it is not in the repository.
    file: Option<String>,
    /// Whether it has a view that turns.
    pub(super) turns: bool,
}

/// A page that was made.
#[derive(Debug)]
pub(super) struct Made {
    /// Its address.
    pub(super) url: String,
    /// What the command reports.
    pub(super) report: Value,
    /// How large it is, in bytes.
    pub(super) size: usize,
}

/// All pages.
pub(super) fn all() -> Vec<Page> {
    let page = |name, arguments, turns| Page { name, arguments, file: None, turns };
    vec![
        page(
            "outline",
            "optimize parts/bracket.toml --fingers 4 --preload 200 --finger-radius 3 --top 3",
            false,
        ),
        page(
            "solid",
            "optimize parts/bearing-block.toml --fix parts/locators-321.toml --fingers 2 \
             --least-share 0.02 --nodes 300 --top 2",
            true,
        ),
        page("load-cases", "analyze parts/cube-grasp.toml", true),
        Page { file: Some(hostile()), ..page("hostile", "analyze FILE", false) },
    ]
}

/// A grasp whose names a browser would take for markup.
fn hostile() -> String {
    let sides = ["[7, 0]", "[20, 13]", "[13, 20]", "[0, 7]"];
    let contacts = sides.map(|at| format!("[[contacts]]\npoint = {at}\npreload = 10\n")).concat();
    format!(
        "units = {{ length = '{HOSTILE}', force = '{HOSTILE}' }}\n[part.planar]\n\
         outline = [[0, 0], [20, 0], [20, 20], [0, 20]]\nstiffness = 2000 # {HOSTILE}\n{contacts}\
         [[points]]\nname = '{HOSTILE}'\npoint = [9, 9]\n[[load_cases]]\nname = '{HOSTILE}'\n\
         force = [-4, 1]\npoint = [20, 16]\n"
    )
}

impl Page {
    /// Makes the page in a folder.
    pub(super) fn make(&self, folder: &Path) -> Result<Made, BrowserError> {
        let file = |source| BrowserError::File { source };
        let path = folder.join(format!("{}.html", self.name));
        let grasp = folder.join("hostile.toml");
        if let Some(text) = &self.file {
            fs::write(&grasp, text).map_err(file)?;
        }
        let arguments = self.arguments.replace("FILE", &grasp.display().to_string());
        let output = Command::new("cargo")
            .args(["run", "--quiet", "--package", "clench-cli", "--locked", "--"])
            .args(arguments.split(' '))
            .args(["--format", "json", "--report"])
            .arg(&path)
            .current_dir(ROOT)
            .output()
            .map_err(|source| BrowserError::Missing { program: "cargo", source })?;
        let not_made =
            |message: String| Err(BrowserError::NotMade { arguments: arguments.clone(), message });
        if !output.status.success() {
            return not_made(String::from_utf8_lossy(&output.stderr).into_owned());
        }
        let report = match serde_json::from_slice(&output.stdout) {
            Ok(report) => report,
            Err(error) => return not_made(error.to_string()),
        };
        let size = fs::read(&path).map_err(file)?.len();
        let path = fs::canonicalize(&path).map_err(file)?;
        Ok(Made { url: format!("file://{}", path.display()), report, size })
    }
}
