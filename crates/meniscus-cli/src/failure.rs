//! What ends the program with an error, and the exit code that says which kind.

use std::fmt;
use std::process::ExitCode;

use meniscus::divergence::Diverged;
use meniscus_case::Diagnostics;
use meniscus_output::OutputError;

/// An error for the user.
#[derive(Debug)]
pub struct Failure {
    message: String,
    code: u8,
}

/// The case file, the files of a run, or the command line is wrong.
const WRONG_INPUT: u8 = 1;
/// The flow blew up.
pub const DIVERGED: u8 = 3;

impl Failure {
    /// An error with this message.
    pub fn new(message: String) -> Self {
        Self {
            message: format!("error: {message}"),
            code: WRONG_INPUT,
        }
    }

    /// A flow that blew up, with what to do about it.
    pub fn diverged(error: &Diverged, go_on: &str) -> Self {
        let advice: String = error
            .advice()
            .iter()
            .map(|line| format!("\n  - {line}"))
            .collect();
        Self {
            message: format!("error: {error}\nwhat may help:{advice}\n{go_on}"),
            code: DIVERGED,
        }
    }

    /// The code that the program exits with.
    pub fn exit_code(&self) -> ExitCode {
        ExitCode::from(self.code)
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl From<OutputError> for Failure {
    fn from(error: OutputError) -> Self {
        Failure::new(error.to_string())
    }
}

impl From<Diagnostics> for Failure {
    fn from(diagnostics: Diagnostics) -> Self {
        let colour = std::io::IsTerminal::is_terminal(&std::io::stderr());
        Self {
            message: diagnostics.render(colour),
            code: WRONG_INPUT,
        }
    }
}
