//! `meniscus bench`: what the engine costs, beside what the machine can do.

use std::process::ExitCode;

use clap::{Args, ValueEnum};
use meniscus::pairs::Instructions;
use meniscus_bench::options::{Options, particle_count};
use meniscus_bench::{BenchError, Costs, Findings};
use meniscus_report::number::significant;

use crate::failure::Failure;
use crate::table::table;
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
    /// Instructions that the engine may use.
    #[arg(long, default_value = "best")]
    instructions: Allowed,
    /// Smaller sizes and fewer samples, in less than a minute.
    #[arg(long)]
    quick: bool,
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
    let findings = meniscus_bench::run(&what.options(), &mut progress)?;
    if what.json {
        let json = serde_json::to_string_pretty(&findings);
        answer(&json.map_err(|error| Failure::new(error.to_string()))?)?;
    } else {
        answer(&tables(&findings))?;
    }
    Ok(ExitCode::SUCCESS)
}

impl What {
    fn options(&self) -> Options {
        let threads = rayon::current_num_threads();
        let mut options = match self.quick {
            true => Options::quick(threads),
            false => Options::full(threads),
        };
        if let Some(sizes) = &self.sizes {
            options.sizes.clone_from(sizes);
        }
        if let Some(dimension) = self.dimension {
            options.dimensions = vec![dimension.into()];
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
}

fn tables(findings: &Findings) -> String {
    let mut text = vec![limits(findings)];
    text.extend(
        findings
            .splashes
            .iter()
            .map(|story| format!("splash in {story}")),
    );
    for costs in &findings.costs {
        text.push(sweeps(costs));
        text.push(steps(costs));
    }
    text.join("\n\n")
}

fn limits(findings: &Findings) -> String {
    let rows: Vec<_> = (findings.peaks.iter())
        .map(|peak| {
            vec![
                peak.threads.to_string(),
                significant(peak.gigaflops_f64, 3),
                significant(peak.gigaflops_f32, 3),
                significant(peak.gigabytes_per_second, 3),
            ]
        })
        .collect();
    let header = ["threads", "Gflop/s f64", "Gflop/s f32", "triad GB/s"];
    format!(
        "fused multiply-adds with {}, and memory\n{}",
        findings.instructions,
        table(&header, &rows)
    )
}

fn title(costs: &Costs) -> String {
    format!(
        "{}D, {} particles, {:?}, {} ({})",
        costs.dimension,
        costs.particles,
        costs.arrangement,
        costs.variant.precision,
        costs.variant.instructions
    )
    .to_lowercase()
}

fn sweeps(costs: &Costs) -> String {
    let still = &costs.still;
    let mut rows = Vec::new();
    for (threads, nanoseconds) in &still.yardstick {
        let mut row = vec!["yardstick".to_owned(), threads.to_string()];
        row.push(significant(*nanoseconds, 3));
        rows.push(row);
    }
    for sweep in &still.sweeps {
        let cost = sweep.cost;
        let mut row = vec![
            sweep.name.to_owned(),
            sweep.threads.to_string(),
            significant(cost.nanoseconds, 3),
            significant(cost.best, 3),
            significant(cost.yardsticks, 3),
            significant(sweep.speed_up, 3),
        ];
        if let Some(pair) = &sweep.pair {
            row.extend([
                significant(pair.nanoseconds, 3),
                significant(pair.rate * 1e-6, 3),
                pair.flops.to_string(),
                significant(100.0 * pair.share_of_peak, 3),
            ]);
        }
        rows.push(row);
    }
    let header = [
        "sweep",
        "threads",
        "ns/particle",
        "best",
        "yardsticks",
        "speed-up",
        "ns/pair",
        "M pairs/s",
        "flops",
        "% of peak",
    ];
    format!(
        "{}: {} neighbours, {} % of the lanes used, skin {} spacings\n{}",
        title(costs),
        significant(still.neighbours, 3),
        significant(100.0 * still.lane_use, 3),
        significant(still.skin, 2),
        table(&header, &rows)
    )
}

fn steps(costs: &Costs) -> String {
    let rows: Vec<_> = (costs.steps.iter())
        .map(|step| {
            vec![
                format!("{:?}", step.flow).to_lowercase(),
                step.threads.to_string(),
                significant(step.cost.nanoseconds, 3),
                significant(step.cost.best, 3),
                significant(step.cost.yardsticks, 3),
                significant(step.speed_up, 3),
                significant(step.rate * 1e-6, 3),
                significant(step.steps_per_list, 3),
                significant(100.0 * step.surface_active, 3),
                significant(step.mach_number, 2),
            ]
        })
        .collect();
    let header = [
        "step",
        "threads",
        "ns/particle",
        "best",
        "yardsticks",
        "speed-up",
        "M/s",
        "steps/list",
        "% surface",
        "Mach",
    ];
    table(&header, &rows)
}
