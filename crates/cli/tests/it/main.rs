//! The tests of the `clench` command, in one binary: each runs it on files of its own.

mod answers;
mod balanced_preloads;
mod conditions;
mod contacts;
mod couplings;
mod documents;
mod examples;
mod fingers;
mod holes;
mod hostile;
mod load_cases;
mod measures;
mod meshes;
mod outputs;
mod pages;
mod parts;
mod reference_numbers;
mod references;
mod refusals;
mod run;
mod searches;
mod solids;
mod spatial_optima;
mod spatial_pictures;
mod spatial_refusals;
mod unanswered;
