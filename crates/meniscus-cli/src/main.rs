//! The program `meniscus`: case files in, trusted answers out.
//!
//! - `run`, `resume`: march a case, write its folder
//! - `check`: what a case is, without running it
//! - `report`: the report of a folder, anew
//! - `reproduce`: the numbers of a paper, beside ours
//! - `new`, `schema`: help with writing cases

mod check;
mod failure;
mod findings;
mod numbers;
mod page;
mod progress;
mod reproduce;
mod runner;
mod sample;
mod table;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Args, Parser, Subcommand};
use failure::Failure;

/// Flows ruled by surface tension, by smoothed particle hydrodynamics.
#[derive(Parser)]
#[command(name = "meniscus", version, arg_required_else_help = true)]
struct Program {
    #[command(subcommand)]
    command: Command,
    /// Threads to use; all cores by default. The results do not depend on it.
    #[arg(long, global = true)]
    threads: Option<usize>,
    /// Print only errors.
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
    /// Write the report of a run's folder anew.
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
    },
    /// Write a commented case file to start from.
    New {
        /// Name of the case; the file is NAME.toml.
        name: String,
    },
    /// Print the JSON schema of case files, for editors.
    Schema,
}

/// Where results go.
#[derive(Args, Clone)]
struct Place {
    /// Folder of the results; out/NAME by default.
    #[arg(long)]
    out: Option<PathBuf>,
    /// Replace the results of an earlier run in that folder.
    #[arg(long)]
    force: bool,
}

fn main() -> ExitCode {
    let program = Program::parse();
    let threads = rayon::ThreadPoolBuilder::new()
        .num_threads(program.threads.unwrap_or(0))
        .build();
    let outcome = match threads {
        Ok(pool) => pool.install(|| dispatch(&program)),
        Err(error) => Err(Failure::new(format!("cannot start threads: {error}"))),
    };
    match outcome {
        Ok(code) => code,
        Err(failure) => {
            eprintln!("{failure}");
            failure.exit_code()
        }
    }
}

fn dispatch(program: &Program) -> Result<ExitCode, Failure> {
    let voice = progress::Voice::new(program.quiet, program.verbose);
    match &program.command {
        Command::Run { case, place } => runner::run(case, place.out.as_deref(), place.force, voice),
        Command::Resume { folder } => runner::resume(folder, voice),
        Command::Check { case } => check::check(case),
        Command::Report { folder } => page::rewrite(folder, voice),
        Command::Reproduce { paper, json, place } => {
            reproduce::reproduce(paper, *json, place.out.as_deref(), place.force, voice)
        }
        Command::New { name } => new_case(name),
        Command::Schema => {
            println!("{:#}", meniscus_case::schema());
            Ok(ExitCode::SUCCESS)
        }
    }
}

fn new_case(name: &str) -> Result<ExitCode, Failure> {
    let stem = name.strip_suffix(".toml").unwrap_or(name);
    let path = PathBuf::from(format!("{stem}.toml"));
    let text = meniscus_case::template(stem);
    let mut file = std::fs::File::create_new(&path)
        .map_err(|error| Failure::new(format!("cannot write {}: {error}", path.display())))?;
    std::io::Write::write_all(&mut file, text.as_bytes())
        .map_err(|error| Failure::new(format!("cannot write {}: {error}", path.display())))?;
    println!("wrote {0}; try: meniscus check {0}", path.display());
    Ok(ExitCode::SUCCESS)
}
