//! `meniscus bench`: what the engine costs, beside what the machine can do.
//!
//! - `tables`: for people
//! - `scaling`: cost against size as a plot

mod scaling;
mod tables;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Args, ValueEnum};
use meniscus::pairs::{Instructions, Precision};
use meniscus_bench::BenchError;
use meniscus_bench::options::{Effort, Options, particle_count};
use serde::Serialize;

use crate::failure::Failure;
use crate::terminal::{Voice, answer, complain};

/// What to measure.
#[derive(Args, Clone, Debug)]
pub struct What {
    /// Numbers of particles, such as 10k,125k,1M.
    #[arg(long, value_delimiter = ',', value_parser = particle_count)]
    sizes: Option<Vec<usize>>,
    /// Only this dimension.
    #[arg(long, value_parser = clap::value_parser!(u8).range(2..=3))]
    dimension: Option<u8>,
    /// Only this precision.
    #[arg(long)]
    precision: Option<Numbers>,
    /// Instructions that the engine may use.
    #[arg(long, default_value = "best")]
    instructions: Allowed,
    /// Smaller sizes and fewer samples, in less than a minute.
    #[arg(long)]
    quick: bool,
    /// Measure the cost of a step from 10^3 to 10^7 particles instead, on one
    /// thread, and plot it in this folder.
    #[arg(long, value_name = "FOLDER")]
    scaling: Option<PathBuf>,
    /// Print JSON instead of tables.
    #[arg(long)]
    json: bool,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Allowed {
    /// The best that the processor has.
    Best,
    /// At most AVX2.
    Avx2,
    /// What every processor of the architecture has.
    Portable,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Numbers {
    /// f64 throughout.
    Double,
    /// State in f64, pairs in f32.
    Mixed,
}

impl From<BenchError> for Failure {
    fn from(error: BenchError) -> Self {
        Failure::new(error.to_string())
    }
}

/// Measures and prints.
pub fn bench(what: &What, voice: Voice) -> Result<ExitCode, Failure> {
    let mut progress = |line: &str| {
        if !voice.quiet {
            complain(line);
        }
    };
    let options = what.options();
    if let Some(folder) = &what.scaling {
        let scaling = meniscus_bench::scaling::measure(&options, &mut progress)?;
        scaling::write(&scaling, folder)?;
        what.print(&scaling, tables::scaling)?;
    } else {
        let findings = meniscus_bench::run(&options, &mut progress)?;
        what.print(&findings, tables::findings)?;
    }
    Ok(ExitCode::SUCCESS)
}

impl What {
    fn options(&self) -> Options {
        let threads = rayon::current_num_threads();
        let mut options = match (&self.scaling, self.quick) {
            (Some(_), true) => Options::scaling(Effort::QUICK),
            (Some(_), false) => Options::scaling(Effort::FULL),
            (None, true) => Options::quick(threads),
            (None, false) => Options::full(threads),
        };
        if let Some(sizes) = &self.sizes {
            options.sizes.clone_from(sizes);
        }
        if let Some(dimension) = self.dimension {
            options.dimensions = vec![dimension.into()];
        }
        if let Some(numbers) = self.precision {
            let wanted = match numbers {
                Numbers::Double => Precision::Double,
                Numbers::Mixed => Precision::Mixed,
            };
            options
                .variants
                .retain(|variant| variant.precision == wanted);
        }
        for variant in &mut options.variants {
            variant.instructions = match self.instructions {
                Allowed::Best => Instructions::Best,
                Allowed::Avx2 => Instructions::Avx2,
                Allowed::Portable => Instructions::Portable,
            };
        }
        options
    }

    fn print<T: Serialize>(&self, found: &T, table: fn(&T) -> String) -> Result<(), Failure> {
        let text = if self.json {
            let json = serde_json::to_string_pretty(found);
            json.map_err(|error| Failure::new(error.to_string()))?
        } else {
            table(found)
        };
        answer(&text)
    }
}
