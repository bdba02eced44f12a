//! Ctrl-C: the first one ends a search, which then says what it has; the next one the program.

use std::process;
use std::sync::Once;
use std::sync::atomic::{AtomicU8, Ordering};

/// No search runs: Ctrl-C ends the program.
const IDLE: u8 = 0;

/// A search runs.
const SEARCHING: u8 = 1;

/// A search runs, and was told to stop.
const STOPPING: u8 = 2;

/// What a shell says of a program that Ctrl-C ended.
const INTERRUPTED: i32 = 130;

static STATE: AtomicU8 = AtomicU8::new(IDLE);
static HANDLER: Once = Once::new();

/// A search that Ctrl-C ends, until this is dropped.
#[derive(Debug)]
pub(crate) struct Interrupt(());

impl Interrupt {
    /// From now on Ctrl-C is for the search.
    pub(crate) fn awaited() -> Self {
        HANDLER.call_once(|| {
            // Without a handler Ctrl-C ends the program, as it does any other.
            let _ = ctrlc::set_handler(|| {
                let (searching, order) = (SEARCHING, Ordering::SeqCst);
                if STATE.compare_exchange(searching, STOPPING, order, order).is_err() {
                    process::exit(INTERRUPTED);
                }
            });
        });
        STATE.store(SEARCHING, Ordering::SeqCst);
        Self(())
    }

    /// Whether it came.
    #[expect(clippy::unused_self, reason = "only a search that awaits it may ask")]
    pub(crate) fn came(&self) -> bool {
        STATE.load(Ordering::SeqCst) == STOPPING
    }
}

impl Drop for Interrupt {
    fn drop(&mut self) {
        STATE.store(IDLE, Ordering::SeqCst);
    }
}
