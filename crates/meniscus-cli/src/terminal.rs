//! Standard output and standard error, and how much is said there.
//!
//! The macros of the standard library end the program where nobody listens
//! (`meniscus schema | head -1`); what stands here does not.

use std::io::{ErrorKind, IsTerminal, Write};

use meniscus_case::Case;

use crate::failure::Failure;

/// Prints what the user asked for.
///
/// # Errors
/// If it cannot be written. A reader that has had enough is no error.
pub fn answer(text: &str) -> Result<(), Failure> {
    let mut out = std::io::stdout().lock();
    match writeln!(out, "{text}").and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(Failure::new(format!(
            "cannot write to standard output: {error}"
        ))),
        _ => Ok(()),
    }
}

/// Prints a line to standard error. If that fails, there is nobody to tell.
pub fn complain(text: &str) {
    let _ = writeln!(std::io::stderr().lock(), "{text}");
}

/// How much the program says beside its answers.
#[derive(Clone, Copy, Debug)]
pub struct Voice {
    /// Nothing but errors.
    pub quiet: bool,
    /// Every file as well.
    pub verbose: bool,
}

impl Voice {
    /// From the command line.
    pub fn new(quiet: bool, verbose: bool) -> Self {
        Self {
            quiet,
            verbose: verbose && !quiet,
        }
    }

    /// Says a line, unless quiet. A run goes on where nobody listens.
    pub fn say(self, line: &str) {
        if !self.quiet {
            let _ = writeln!(std::io::stdout().lock(), "{line}");
        }
    }

    /// Says what may not be as meant in a case.
    pub fn warn_of(self, case: &Case) {
        if !self.quiet && !case.warnings.is_empty() {
            complain(&case.warnings.render(std::io::stderr().is_terminal()));
        }
    }
}
