//! What ends the program with an error, and the exit code that says which kind.

use std::fmt;
use std::io::IsTerminal;
use std::process::ExitCode;

use meniscus::divergence::Diverged;
use meniscus_case::Diagnostics;
use meniscus_output::OutputError;

/// The case file or the files of a run are wrong.
const WRONG_INPUT: u8 = 1;
/// The flow blew up.
const DIVERGED: u8 = 3;
/// A number of a paper was not reproduced. (2 is a wrong command line.)
pub const NOT_REPRODUCED: u8 = 4;

/// What `--help` tells of them.
pub const EXIT_CODES: &str = "Exit codes: 0 all is well, 1 a wrong case file or folder, \
2 a wrong command line, 3 the flow diverged, 4 a number of a paper was not reproduced, \
130 stopped by Ctrl-C.";

/// An error for the user.
#[derive(Debug)]
pub struct Failure {
    message: String,
    code: u8,
    /// Whether the message says by itself what it is, as diagnostics do.
    titled: bool,
}

impl Failure {
    /// An error with this message.
    pub fn new(message: String) -> Self {
        Self {
            message,
            code: WRONG_INPUT,
            titled: false,
        }
    }

    /// A flow that blew up, with what to do about it and `rest`, lines on what is left of it.
    pub fn diverged(error: &Diverged, rest: &str) -> Self {
        let advice: String = error
            .advice()
            .iter()
            .map(|line| format!("\n  - {line}"))
            .collect();
        Self {
            message: format!("{error}\nwhat may help:{advice}\n{rest}"),
            code: DIVERGED,
            titled: false,
        }
    }

    /// The message without a title before it.
    pub fn message(&self) -> &str {
        &self.message
    }

    /// The code that the program exits with.
    pub fn exit_code(&self) -> ExitCode {
        ExitCode::from(self.code)
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let title = if self.titled { "" } else { "error: " };
        write!(f, "{title}{}", self.message)
    }
}

impl From<OutputError> for Failure {
    fn from(error: OutputError) -> Self {
        Failure::new(error.to_string())
    }
}

impl From<Diagnostics> for Failure {
    fn from(diagnostics: Diagnostics) -> Self {
        Self {
            message: diagnostics.render(std::io::stderr().is_terminal()),
            code: WRONG_INPUT,
            titled: true,
        }
    }
}
