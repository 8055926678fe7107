//! `bench`: what it prints and writes. What it measures is the machine's affair.

use serde_json::Value;

use crate::workplace::{Workplace, has};

#[test]
fn bench_prints_tables_or_json_and_needs_no_file() {
    let place = Workplace::new("bench");
    let few = ["bench", "--quick", "--sizes", "300", "--dimension", "2"];
    let tables = place.run(&[&few[..], &["--threads", "1"]].concat()).ok();
    has(
        &tables.out,
        &[
            "triad GB/s",
            "2D, 300 particles, lattice, double (best)",
            "2D, 300 particles, splash, double (best)",
            "momentum",
            "surface force",
            "% of peak",
            "reached",
        ],
    );
    has(&tables.err, &["2D, 300 particles, splash, mixed: sweeps"]);

    let portable = [
        "--json",
        "--instructions",
        "portable",
        "--precision",
        "mixed",
    ];
    let json = place.run(&[&few[..], &portable].concat()).ok();
    let json: Value = serde_json::from_str(&json.out).unwrap();
    let variant = &json["costs"][0]["variant"];
    assert_eq!(variant["instructions"], "portable");
    assert_eq!(variant["precision"], "mixed");
    assert_eq!(json["costs"].as_array().unwrap().len(), 2);
    assert!(place.names(".").is_empty());

    let wrong = place.run(&["bench", "--sizes", "10x"]).code(2);
    has(&wrong.err, &["125k", "10x"]);
}

#[test]
fn cost_against_size_is_plotted() {
    let place = Workplace::new("bench-scaling");
    let few = ["--quick", "--sizes", "200,400", "--dimension", "2"];
    let run = place.run(&[&["bench", "--scaling", "plots"][..], &few].concat());
    has(&run.ok().out, &["2D plain, double, one thread", "400"]);
    let names = [
        "cost-against-size.csv",
        "cost-against-size.png",
        "cost-against-size.svg",
    ];
    assert_eq!(place.names("plots"), names);
    let numbers = place.read("plots/cost-against-size.csv");
    // Two sizes of two flows in two precisions, under a header.
    assert_eq!(numbers.lines().count(), 9);
}
