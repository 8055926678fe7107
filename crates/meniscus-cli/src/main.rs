//! The program `meniscus`: case files in, trusted answers out.
//!
//! - `runner` (`run`, `resume`) starts the [`march`], which writes the files
//!   of a run; `due` says when, `interrupt` when to stop, `record` how it stands
//! - `conclude` (`report`): what was found (`findings`, beside what is
//!   `expected`), on the terminal, in the report's `page` and `figures`
//! - `appraise`: every model of surface tension through one suite of tests; `batch`: many cases side by side
//! - `bench`: what the engine costs on this machine
//! - `calibrate`: how strong cohesion and adhesion must be for a case
//! - `check`: what a case is, without running it; `numbers` that tell of it
//! - `reproduce`: the numbers of a paper beside ours, with a `verdict`
//! - `starter` (`new`): help with writing cases
//! - `terminal`, `table`, `progress`, `failure`: what is said, and how

#![deny(clippy::print_stdout, clippy::print_stderr)]

mod appraise;
mod batch;
mod bench;
mod calibrate;
mod check;
mod conclude;
mod convergence;
mod due;
mod expected;
mod failure;
mod figures;
mod findings;
mod interrupt;
mod march;
mod numbers;
mod page;
mod progress;
mod record;
mod regression;
mod reproduce;
mod runner;
mod sample;
mod side_by_side;
mod starter;
mod table;
mod terminal;
mod verdict;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Args, Parser, Subcommand};
use failure::{EXIT_CODES, Failure};

/// Flows ruled by surface tension, by smoothed particle hydrodynamics.
#[derive(Parser)]
#[command(name = "meniscus", version, arg_required_else_help = true, after_help = EXIT_CODES)]
struct Program {
    #[command(subcommand)]
    command: Command,
    /// Threads to use; all cores by default. The results do not depend on it.
    #[arg(long, global = true, value_parser = clap::value_parser!(u16).range(1..))]
    threads: Option<u16>,
    /// Print only errors, and what was asked for.
    #[arg(short, long, global = true)]
    quiet: bool,
    /// Print each frame and checkpoint as it is written.
    #[arg(short, long, global = true)]
    verbose: bool,
}

#[derive(Subcommand)]
enum Command {
    /// Run a case file.
    Run {
        /// The case file (TOML).
        case: PathBuf,
        #[command(flatten)]
        place: Place,
    },
    /// Go on with a run that was stopped, or that died.
    Resume {
        /// The run's folder, such as out/rod-649.
        folder: PathBuf,
    },
    /// Say what a case is and what it will cost, without running it.
    Check {
        /// The case file (TOML).
        case: PathBuf,
    },
    /// Write the report of a run's folder anew, also of a run that was stopped.
    Report {
        /// The run's folder, such as out/rod-649.
        folder: PathBuf,
    },
    /// Run the cases of a paper and print its numbers beside ours.
    Reproduce {
        /// The paper's folder, such as papers/jancik-hyhlik.
        paper: PathBuf,
        /// Print JSON instead of a table.
        #[arg(long)]
        json: bool,
        #[command(flatten)]
        place: Place,
        #[command(flatten)]
        before: Before,
    },
    /// Compare all models of surface tension by one suite of tests.
    Appraise {
        #[command(flatten)]
        what: appraise::What,
        #[command(flatten)]
        place: Place,
        #[command(flatten)]
        before: Before,
    },
    /// Measure how strong the cohesion of a fluid must be for the surface tension of a case, and store it.
    Calibrate {
        /// The case file (TOML).
        case: PathBuf,
        /// Print JSON instead of a table.
        #[arg(long)]
        json: bool,
    },
    /// Measure what the pair engine costs here, beside what the machine can do.
    Bench {
        #[command(flatten)]
        what: bench::What,
    },
    /// Write a commented case file to start from.
    New {
        /// Name of the case; the file is NAME.toml.
        name: PathBuf,
    },
    /// Print the JSON schema of case files, for editors.
    Schema,
}

/// Where results go.
#[derive(Args, Clone)]
struct Place {
    /// Folder of the results; by default out/CASE, out/reproduce/PAPER, or out/appraise.
    #[arg(long)]
    out: Option<PathBuf>,
    /// Replace the results of an earlier run in that folder.
    #[arg(long)]
    force: bool,
}

/// Of many cases, what was done before.
#[derive(Args, Clone, Copy)]
struct Before {
    /// Go on with what was stopped, or died: runs of the same cases that came to their end are taken as they are.
    #[arg(long = "continue", conflicts_with = "force")]
    go_on: bool,
}

impl Before {
    fn earlier(self, place: &Place) -> batch::Earlier {
        match (self.go_on, place.force) {
            (true, _) => batch::Earlier::Continued,
            (false, true) => batch::Earlier::Replaced,
            (false, false) => batch::Earlier::Refused,
        }
    }
}

fn main() -> ExitCode {
    let program = Program::parse();
    let threads = rayon::ThreadPoolBuilder::new()
        .num_threads(program.threads.unwrap_or(0).into())
        .build();
    let outcome = match threads {
        Ok(pool) => pool.install(|| dispatch(&program)),
        Err(error) => Err(Failure::new(format!("cannot start threads: {error}"))),
    };
    match outcome {
        Ok(code) => code,
        Err(failure) => {
            terminal::complain(&failure.to_string());
            failure.exit_code()
        }
    }
}

fn dispatch(program: &Program) -> Result<ExitCode, Failure> {
    let voice = terminal::Voice::new(program.quiet, program.verbose);
    match &program.command {
        Command::Run { case, place } => runner::run(case, place.out.as_deref(), place.force, voice),
        Command::Resume { folder } => runner::resume(folder, voice),
        Command::Check { case } => check::check(case, voice),
        Command::Report { folder } => conclude::rewrite(folder, voice),
        Command::Reproduce {
            paper,
            json,
            place,
            before,
        } => {
            let out = place.out.as_deref();
            reproduce::reproduce(paper, *json, out, before.earlier(place), voice)
        }
        Command::Appraise {
            what,
            place,
            before,
        } => {
            let out = place.out.as_deref();
            appraise::appraise(what, out, before.earlier(place), voice)
        }
        Command::Calibrate { case, json } => calibrate::calibrate(case, *json, voice),
        Command::Bench { what } => bench::bench(what, voice),
        Command::New { name } => starter::write(name, voice),
        Command::Schema => {
            terminal::answer(&format!("{:#}", meniscus_case::schema()))?;
            Ok(ExitCode::SUCCESS)
        }
    }
}
