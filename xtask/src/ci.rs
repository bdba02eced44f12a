//! `cargo xtask ci`: what a change must pass, in order; it stops at the first step that fails.

use std::process::Command;
use std::time::Instant;

use crate::failure::Failure;
use crate::workspace::{Package, ROOT, Workspace};

/// How to see a failed test alone.
const RERUN: &str = "cargo's last line says what to pass to `cargo test` to run that part alone";

/// One call of cargo.
#[derive(Debug)]
struct Step {
    name: &'static str,
    /// The arguments of cargo, separated by single spaces.
    arguments: String,
    /// A variable that the call needs.
    variable: Option<(&'static str, &'static str)>,
    /// What to run when the step fails.
    mend: &'static str,
}

impl Step {
    fn new(name: &'static str, arguments: impl Into<String>, mend: &'static str) -> Self {
        Self { name, arguments: arguments.into(), variable: None, mend }
    }

    fn with(self, name: &'static str, value: &'static str) -> Self {
        Self { variable: Some((name, value)), ..self }
    }

    /// The step as one would type it.
    fn command(&self) -> String {
        let variable = self.variable.map(|(name, value)| format!("{name}=\"{value}\" "));
        format!("{}cargo {}", variable.unwrap_or_default(), self.arguments)
    }

    fn run(&self) -> Result<(), Failure> {
        println!("\n== {}: {}", self.name, self.command());
        let start = Instant::now();
        let status = Command::new("cargo")
            .args(self.arguments.split(' '))
            .envs(self.variable)
            .current_dir(ROOT)
            .status()
            .map_err(|source| Failure::NotStarted { command: self.command(), source })?;
        if !status.success() {
            return Err(Failure::StepFailed { step: self.name, mend: self.mend });
        }
        println!("== {}: passed in {:.1} s", self.name, start.elapsed().as_secs_f64());
        Ok(())
    }
}

/// Runs every step.
pub(crate) fn run() -> Result<(), Failure> {
    let workspace = Workspace::load()?;
    for step in steps(&workspace.layered_libraries()) {
        step.run()?;
    }
    println!("\nall steps passed");
    Ok(())
}

/// The steps, in order. One profile and few sets of features, so that a dependency is built once
/// for the tests and once (without code) for everything that only checks.
fn steps(libraries: &[&Package]) -> Vec<Step> {
    let mut steps = vec![
        Step::new("fmt", "fmt --all -- --check", "cargo fmt --all"),
        Step::new(
            "clippy",
            "clippy --workspace --all-targets --all-features --locked -- -D warnings",
            "cargo clippy --workspace --all-targets --all-features --fix --allow-dirty",
        ),
        // The words of the README's test command, plus `--locked`: nothing is built again.
        Step::new("tests", "test --workspace --locked", RERUN),
        // All features as in clippy: the optional API is documented too, and what clippy has
        // checked of the dependencies serves again.
        Step::new(
            "docs",
            "doc --workspace --all-features --no-deps --locked",
            "RUSTDOCFLAGS=\"-D warnings\" cargo doc --no-deps --all-features -p THE_CRATE",
        )
        .with("RUSTDOCFLAGS", "-D warnings"),
        Step::new("tidy", "xtask tidy", "as each finding says, then cargo xtask tidy"),
        Step::new("paper", "xtask paper --check", "cargo xtask paper, and look at the change"),
        Step::new("guide", "xtask guide --check", "cargo xtask guide, and look at the change"),
        Step::new("browser", "xtask browser", "cargo xtask browser, which says what is missing"),
    ];
    steps.extend(libraries.iter().flat_map(|library| alone(library)));
    // `--benches` in the profile of the tests: `cargo bench` would build every dependency again.
    steps.push(Step::new(
        "benches",
        "build --workspace --benches --locked",
        "cargo build --workspace --benches",
    ));
    steps
}

/// A library that builds with the workspace may live on features that another member switched on
/// in a shared dependency. Selected alone it has only what its own manifest asks for. A missing
/// feature is a name or a type that is missing, which the compiler finds without making code; so
/// checking the library, then its tests (where dev-dependencies join), is enough. Documentation
/// needs no further call: rustdoc sees the same dependencies.
///
/// The tests of the whole workspace leave optional features off; a library that has some runs its
/// own tests once more with all of them.
fn alone(library: &Package) -> Vec<Step> {
    let name = &library.name;
    let mend = "name the missing feature or dependency in the manifest of that crate";
    let mut steps = vec![
        Step::new("alone", format!("check --package {name} --locked"), mend),
        Step::new("alone", format!("check --package {name} --tests --locked"), mend),
    ];
    if library.has_features() {
        let test = format!("test --package {name} --all-features --locked");
        steps.push(Step::new("alone", test, RERUN));
    }
    steps
}

#[cfg(test)]
mod tests {
    use super::{Step, steps};
    use crate::workspace::Workspace;
    use crate::workspace::tests::SOUND;

    fn sound_steps() -> Vec<Step> {
        steps(&Workspace::parse(SOUND).unwrap().layered_libraries())
    }

    #[test]
    fn steps_run_in_the_order_of_the_page_on_architecture() {
        let mut names: Vec<_> = sound_steps().iter().map(|step| step.name).collect();
        names.dedup();
        assert_eq!(
            names,
            [
                "fmt", "clippy", "tests", "docs", "tidy", "paper", "guide", "browser", "alone",
                "benches"
            ]
        );
    }

    #[test]
    fn each_library_is_checked_alone_and_tested_with_the_features_it_has() {
        let steps = sound_steps();
        let alone = steps.iter().filter(|step| step.name == "alone");
        assert_eq!(
            alone.map(Step::command).collect::<Vec<_>>(),
            [
                "cargo check --package low --locked",
                "cargo check --package low --tests --locked",
                "cargo check --package high --locked",
                "cargo check --package high --tests --locked",
                "cargo test --package high --all-features --locked",
            ]
        );
    }

    #[test]
    fn a_command_is_printed_with_its_variable_as_one_would_type_it() {
        let docs = sound_steps().into_iter().find(|step| step.name == "docs").unwrap();
        assert_eq!(
            docs.command(),
            "RUSTDOCFLAGS=\"-D warnings\" cargo doc --workspace --all-features --no-deps --locked"
        );
    }
}
