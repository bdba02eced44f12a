//! The tests of the `clench` command, in one binary: each runs it on files of its own.

mod answers;
mod contacts;
mod documents;
mod hostile;
mod outputs;
mod parts;
mod run;
mod unanswered;
