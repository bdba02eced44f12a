//! Readers of others that may panic.

use std::panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook};

/// What `read` returns; none if it panicked, without a word.
///
/// An overflow of the stack cannot be caught: how deep a file nests has to be limited before.
pub(super) fn shielded<R>(read: impl FnOnce() -> R) -> Option<R> {
    let hook = take_hook();
    set_hook(Box::new(|_| {}));
    // What was being read is dropped with all that refers to it.
    let result = catch_unwind(AssertUnwindSafe(read));
    set_hook(hook);
    result.ok()
}
