//! Ctrl-C: the first asks the program to stop in good order, the second ends it.

use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::failure::Failure;
use crate::terminal::complain;

/// Code with which a program ends after Ctrl-C, as shells report it.
pub const EXIT_CODE: u8 = 130;

static ASKED: AtomicBool = AtomicBool::new(false);

/// Watches for Ctrl-C from now on; to be called before a march.
pub fn watch() -> Result<(), Failure> {
    static WATCHING: OnceLock<Result<(), String>> = OnceLock::new();
    let watching = WATCHING.get_or_init(|| {
        ctrlc::set_handler(|| {
            if ASKED.swap(true, Ordering::Relaxed) {
                std::process::exit(i32::from(EXIT_CODE));
            }
            complain("\nstopping after this step, with a checkpoint (Ctrl-C again to end at once)");
        })
        .map_err(|error| error.to_string())
    });
    watching
        .clone()
        .map_err(|error| Failure::new(format!("cannot watch for Ctrl-C: {error}")))
}

/// Whether Ctrl-C was pressed.
pub fn asked() -> bool {
    ASKED.load(Ordering::Relaxed)
}
