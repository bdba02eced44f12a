//! `cargo xtask peers`: the library beside two programs of others, on the same questions.
//!
//! Prints Markdown: single combinations of edges beside SCIP, a global solver for nonconvex
//! programs, and whole polygons beside plain enumeration in `NumPy`. Writes nothing but
//! `target/peers`, since times belong to a machine. Never part of `cargo xtask ci`: it needs Python
//! 3 and, the first time, the network.

mod combinations;
mod failure;
mod outline;
mod polygons;
mod python;
mod stopwatch;

use std::env;
use std::process::Command;

pub(crate) use failure::PeersError;

use crate::failure::Failure;
use crate::workspace::ROOT;
use python::Python;

/// The peers use one thread, so the library does too.
const ONE_THREAD: (&str, &str) = ("RAYON_NUM_THREADS", "1");

/// What runs the task so that its times mean something.
const AGAIN: &str = "cargo run --release --package xtask -- peers";

const HEAD: &str = "\
# Peers

The library in a release build. Everything runs on one thread, and times are those of this machine
with all that runs on it beside.
";

/// Compares; starts itself anew when it is not optimized or would use several threads.
pub(crate) fn run() -> Result<(), Failure> {
    let (name, one) = ONE_THREAD;
    if cfg!(debug_assertions) || env::var(name).as_deref() != Ok(one) {
        return again();
    }
    compare().map_err(Failure::Peers)
}

fn again() -> Result<(), Failure> {
    let (name, one) = ONE_THREAD;
    eprintln!("building and measuring: {name}={one} {AGAIN}");
    let mut words = AGAIN.split(' ');
    let status = Command::new(words.next().unwrap_or_default())
        .args(words)
        .envs([ONE_THREAD])
        .current_dir(ROOT)
        .status()
        .map_err(|source| Failure::NotStarted { command: AGAIN.to_owned(), source })?;
    if status.success() { Ok(()) } else { Err(Failure::Peers(PeersError::Anew)) }
}

fn compare() -> Result<(), PeersError> {
    let python = Python::ready()?;
    println!("{HEAD}");
    let combinations = combinations::Comparison::compute(&python)?;
    println!("{}", combinations.section());
    let polygons = polygons::Comparison::compute(&python)?;
    print!("{}", polygons.section());
    match combinations.contradictions() + polygons.contradictions() {
        0 => Ok(()),
        count => Err(PeersError::Contradicted { count }),
    }
}
