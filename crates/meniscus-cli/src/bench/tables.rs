//! What `meniscus bench` prints for people.

use meniscus_bench::machine::Machine;
use meniscus_bench::memory::Memory;
use meniscus_bench::scaling::{Scaling, ScalingCurve};
use meniscus_bench::targets::Target;
use meniscus_bench::{Costs, Findings};
use meniscus_report::number::significant;

use crate::table::table;

/// Everything that was measured.
pub fn findings(findings: &Findings) -> String {
    let mut text = vec![machine(&findings.machine), limits(findings)];
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
    text.extend(findings.memory.iter().map(memory));
    text.push(targets(&findings.targets));
    text.join("\n\n")
}

/// Cost against size.
pub fn scaling(scaling: &Scaling) -> String {
    let mut text = vec![machine(&scaling.machine)];
    for curve in &scaling.curves {
        let rows: Vec<_> = (curve.points.iter())
            .map(|point| {
                vec![
                    point.particles.to_string(),
                    significant(point.cost.nanoseconds, 3),
                    significant(point.cost.best, 3),
                    significant(point.cost.yardsticks, 3),
                    point.cost.samples.to_string(),
                ]
            })
            .collect();
        let header = ["particles", "ns/particle", "best", "yardsticks", "samples"];
        text.push(format!(
            "{}, one thread\n{}",
            name_of(curve),
            table(&header, &rows)
        ));
    }
    for size in &scaling.left_out {
        text.push(format!(
            "{size} particles left out: too little memory is free"
        ));
    }
    text.join("\n\n")
}

/// The name of a curve.
pub fn name_of(curve: &ScalingCurve) -> String {
    format!(
        "{}D {}, {}",
        curve.dimension,
        curve.flow.name(),
        curve.variant.precision
    )
}

fn machine(machine: &Machine) -> String {
    let processor = machine.processor.as_deref().unwrap_or("unknown processor");
    let caches: Vec<_> = (machine.caches.iter())
        .map(|cache| format!("L{} {} KiB", cache.level, cache.bytes / 1024))
        .collect();
    format!(
        "{processor}, {} threads; {}",
        machine.cores,
        caches.join(", ")
    )
}

fn memory(memory: &Memory) -> String {
    format!(
        "memory of {} particles in {}D with surface force, {}: {} B/particle while it runs, \
         {} of them lists and packed records; {} at most since it was set up",
        memory.particles,
        memory.dimension,
        memory.variant.precision,
        significant(memory.held, 3),
        significant(memory.lists, 3),
        significant(memory.peak, 3)
    )
}

fn targets(targets: &[Target]) -> String {
    let rows: Vec<_> = (targets.iter())
        .map(|target| {
            let measured = target
                .measured
                .map_or("not measured".into(), |m| significant(m, 3));
            let reached = match target.reached {
                Some(true) => "yes",
                Some(false) => "no",
                None => "",
            };
            vec![
                target.what.clone(),
                target.precision.to_owned(),
                target.unit.to_owned(),
                significant(target.wanted, 3),
                measured,
                reached.to_owned(),
            ]
        })
        .collect();
    let header = [
        "target",
        "precision",
        "unit",
        "wanted",
        "measured",
        "reached",
    ];
    table(&header, &rows)
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
        "{}D, {} particles, {}, {} ({})",
        costs.dimension,
        costs.particles,
        costs.arrangement.name(),
        costs.variant.precision,
        costs.variant.instructions
    )
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
        "{}: {} neighbours, {} % of the lanes used, skin {} spacings, \
         within {} (continuity) and {} (momentum) of the yardstick\n{}",
        title(costs),
        significant(still.neighbours, 3),
        significant(100.0 * still.lane_use, 3),
        significant(still.skin, 2),
        significant(still.difference_of_continuity, 2),
        significant(still.difference_of_momentum, 2),
        table(&header, &rows)
    )
}

fn steps(costs: &Costs) -> String {
    let rows: Vec<_> = (costs.steps.iter())
        .map(|step| {
            vec![
                step.flow.name().to_owned(),
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
