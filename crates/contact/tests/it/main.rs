//! The tests of clench-contact, in one binary.

mod laws;
mod limits;
mod parry;
