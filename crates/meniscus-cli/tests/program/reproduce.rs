//! `reproduce`: the numbers of a paper, from a small paper of one rod.

use serde_json::Value;

use crate::workplace::{ROD, Workplace, has, rod_of};

fn number(id: &str, case: &str, finding: &str, published: f64, tolerance: f64) -> String {
    format!(
        "[[number]]\nid = \"{id}\"\nabout = \"about {id}\"\ncase = \"{case}\"\nfinding = \"{finding}\"\n\
         published = {published}\ntheory = 1.0\ntolerance = {tolerance}\n\n"
    )
}

/// A paper whose rod runs for 0.2 ms; density changes by a per cent or so.
fn paper(test: &str, numbers: &[String]) -> Workplace {
    let place = Workplace::new(test);
    place.write("paper/rod.toml", &rod_of("0.2 ms"));
    let plan = format!("title = \"A small paper\"\n\n{}", numbers.concat());
    place.write("paper/reproduction.toml", &plan);
    place
}

fn keys(row: &Value) -> Vec<&str> {
    let mut keys: Vec<&str> = row
        .as_object()
        .unwrap()
        .keys()
        .map(String::as_str)
        .collect();
    keys.sort_unstable();
    keys
}

#[test]
fn json_is_an_array_of_rows_and_nothing_else() {
    let good = number("density", "rod.toml", "density-change", 1.0, 5.0);
    let place = paper("reproduce-json", &[good]);
    let reproduced = place.run(&["reproduce", "paper", "--json"]).ok();
    let rows: Value = serde_json::from_str(&reproduced.out).unwrap();
    let [row] = &rows.as_array().unwrap()[..] else {
        panic!("{rows}");
    };
    let promised = [
        "computed",
        "id",
        "published",
        "theory",
        "tolerance",
        "uncertainty",
        "verdict",
    ];
    assert_eq!(keys(row), promised);
    assert_eq!(
        (&row["id"], &row["verdict"]),
        (&"density".into(), &"reproduced".into())
    );
    assert_eq!(
        (row["published"].as_f64(), row["tolerance"].as_f64()),
        (Some(1.0), Some(5.0))
    );
    // The run is there to be looked at; its own folder is not mixed with another run's.
    let record: Value =
        serde_json::from_str(&place.read("out/reproduce/paper/rod/run.json")).unwrap();
    assert_eq!(record["findings"][0]["computed"], row["computed"]);
    has(
        &place.run(&["reproduce", "paper"]).code(1).err,
        &["--force"],
    );
}

#[test]
fn a_number_off_by_more_than_the_tolerance_differs() {
    let numbers = [
        number("near", "rod.toml", "density-change", 1.0, 5.0),
        number("far", "rod.toml", "density-change", 40.0, 5.0),
    ];
    let place = paper("reproduce-differs", &numbers);
    let reproduced = place.run(&["reproduce", "paper", "--out", "there"]).code(4);
    let line = |name: &str| {
        let line = reproduced.out.lines().find(|line| line.starts_with(name));
        line.unwrap_or_else(|| panic!("{}", reproduced.out))
            .to_owned()
    };
    has(
        &reproduced.out,
        &[
            "A small paper",
            "published",
            "theory",
            "computed",
            "tolerance",
        ],
    );
    assert!(line("about near").ends_with("reproduced"));
    assert!(line("about far").ends_with("differs"));
    assert!(place.path("there/rod/report.html").is_file());
}

#[test]
fn a_case_that_fails_costs_only_its_own_numbers() {
    let numbers = [
        number("good", "rod.toml", "density-change", 1.0, 5.0),
        number("torn", "torn.toml", "density-change", 1.0, 5.0),
        number("typo", "rod.toml", "density-chance", 1.0, 5.0),
    ];
    let place = paper("reproduce-fails", &numbers);
    let torn = ROD.replace("[measure]", "[physics]\ntime_step = \"100 us\"\n[measure]");
    place.write("paper/torn.toml", &torn);
    let reproduced = place.run(&["reproduce", "paper", "--json"]).code(4);
    let rows: Value = serde_json::from_str(&reproduced.out).unwrap();
    let verdicts: Vec<&str> = (0..3)
        .map(|i| rows[i]["verdict"].as_str().unwrap())
        .collect();
    assert_eq!(verdicts, ["reproduced", "not-computed", "not-computed"]);
    assert!(rows[0]["computed"].is_f64() && rows[1]["computed"].is_null());
    has(
        &reproduced.err,
        &[
            "torn: no value: torn: the run diverged at step",
            "typo: rod.toml found no \"density-chance\"",
            "density-change",
        ],
    );
}

#[test]
fn a_plan_or_case_that_cannot_be_read_runs_nothing() {
    let place = paper(
        "reproduce-wrong",
        &[number("a", "missing.toml", "period", 1.0, 1.0)],
    );
    has(
        &place.run(&["reproduce", "paper"]).code(1).err,
        &["missing.toml"],
    );
    place.write(
        "paper/reproduction.toml",
        "title = \"A paper\"\nnumbers = []\n",
    );
    has(
        &place.run(&["reproduce", "paper"]).code(1).err,
        &["reproduction.toml", "numbers"],
    );
    has(
        &place.run(&["reproduce", "nowhere"]).code(1).err,
        &["nowhere/reproduction.toml"],
    );
    assert_eq!(place.names("."), ["paper"]);
}
