//! The tests of the `clench` command, in one binary: each runs it on files of its own.

mod answers;
mod contacts;
mod documents;
mod fingers;
mod hostile;
mod meshes;
mod outputs;
mod parts;
mod references;
mod refusals;
mod run;
mod solids;
mod unanswered;
