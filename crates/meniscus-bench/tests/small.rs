//! A small run measures everything that it promises.

use meniscus_bench::options::{Effort, Options};
use serde_json::Value;

/// Too short to tell anything of the machine.
const HASTE: Effort = Effort {
    sample: 1e-4,
    samples: 2,
    fewest: 1,
    budget: 0.1,
    triad: 1000,
    splash: 300,
};

fn small() -> Options {
    Options {
        sizes: vec![500],
        effort: HASTE,
        ..Options::full(2)
    }
}

fn keys(value: &Value) -> Vec<&str> {
    value
        .as_object()
        .unwrap()
        .keys()
        .map(String::as_str)
        .collect()
}

fn is_positive(value: &Value) -> bool {
    value.as_f64().is_some_and(|number| number > 0.0)
}

#[test]
fn a_run_has_all_that_is_promised() {
    let mut said = Vec::new();
    let findings = meniscus_bench::run(&small(), &mut |line| said.push(line.to_owned())).unwrap();
    assert!(
        said.iter()
            .any(|line| line == "3D, 500 particles, splash, mixed: steps, surface force")
    );

    let json = serde_json::to_value(&findings).unwrap();
    let expected = [
        "costs",
        "instructions",
        "machine",
        "memory",
        "peaks",
        "splashes",
        "targets",
    ];
    assert_eq!(keys(&json), expected);
    for peak in json["peaks"].as_array().unwrap() {
        for limit in ["gigaflops_f64", "gigaflops_f32", "gigabytes_per_second"] {
            assert!(is_positive(&peak[limit]), "{limit} of {peak}");
        }
    }
    let costs = json["costs"].as_array().unwrap();
    // 2D and 3D, lattice and splash, double and mixed.
    assert_eq!(costs.len(), 8);
    for costs in costs {
        assert_eq!(costs["particles"], 500);
        let still = &costs["still"];
        for number in ["neighbours", "skin", "lane_use"] {
            assert!(is_positive(&still[number]), "{number} of {still}");
        }
        // Sums of some hundred rounded terms, in another order; in f32 rounding is 6e-8.
        let rounding = match costs["variant"]["precision"].as_str() {
            Some("mixed") => 6e-6,
            _ => 1e-13,
        };
        for difference in ["difference_of_continuity", "difference_of_momentum"] {
            assert!(
                still[difference].as_f64().unwrap() < rounding,
                "{difference}: {still}"
            );
        }
        // Lists and six sweeps, on one thread and on two; three flows, two more on a lattice.
        assert_eq!(still["sweeps"].as_array().unwrap().len(), 14);
        let flows = match costs["arrangement"].as_str() {
            Some("lattice") => 5,
            _ => 3,
        };
        assert_eq!(costs["steps"].as_array().unwrap().len(), 2 * flows);
        for sweep in still["sweeps"].as_array().unwrap() {
            assert!(is_positive(&sweep["cost"]["nanoseconds"]), "{sweep}");
            if sweep["name"] != "lists" {
                assert!(is_positive(&sweep["pair"]["share_of_peak"]), "{sweep}");
            }
        }
        for step in costs["steps"].as_array().unwrap() {
            assert!(is_positive(&step["rate"]), "{step}");
            assert!(is_positive(&step["cost"]["yardsticks"]), "{step}");
        }
    }
    let targets = json["targets"].as_array().unwrap();
    assert_eq!(targets.len(), 20);
    for target in targets {
        let measured = target["measured"].as_f64();
        assert_eq!(
            measured.is_some(),
            target["reached"].is_boolean(),
            "{target}"
        );
    }
}

#[test]
fn cost_against_size_has_a_point_for_each_size() {
    let options = Options {
        sizes: vec![200, 400],
        ..small()
    };
    let scaling = meniscus_bench::scaling::measure(&options, &mut |_| {}).unwrap();
    assert_eq!(scaling.curves.len(), 8);
    assert!(scaling.left_out.is_empty());
    for curve in &scaling.curves {
        let sizes: Vec<_> = curve.points.iter().map(|point| point.particles).collect();
        assert_eq!(sizes, [200, 400]);
    }
}
