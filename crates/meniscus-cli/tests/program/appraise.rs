//! `appraise`: the comparison of models, its files and its words.

use serde_json::Value;

use crate::workplace::{Workplace, has};

const FEW: [&str; 4] = ["appraise", "--quick", "--dimension", "2"];

#[test]
fn models_are_compared_as_a_page_and_as_json() {
    let place = Workplace::new("appraise");
    let few = [&FEW[..], &["--models", "continuum", "--tests", "swing"]].concat();
    let page = place.run(&few).ok();
    has(
        &page.out,
        &[
            "## Swing",
            "Frequency, %",
            "| continuum |",
            "over plain",
            "Time to solution",
            "figures/swing-2d.png",
        ],
    );
    has(
        &page.err,
        &["4 of 4: swing-2d-", "out/appraise/appraisal.md"],
    );
    assert_eq!(
        place.read("out/appraise/appraisal.md").trim(),
        page.out.trim()
    );
    // Every run is a case of its own.
    let case = "out/appraise/runs/swing-2d-7-lattice-continuum/case.toml";
    has(&place.run(&["check", case]).ok().out, &["La"]);

    let refused = place.run(&few).code(1);
    has(&refused.err, &["--force"]);

    // One run was killed, one is lost, and the others are taken as they are.
    let runs = place.path("out/appraise/runs");
    let killed = "out/appraise/runs/swing-2d-7-lattice-continuum/run.json";
    let record = place.read(killed).replace("\"complete\"", "\"running\"");
    std::fs::write(place.path(killed), record).unwrap();
    std::fs::remove_dir_all(runs.join("swing-2d-7-jittered-1-continuum")).unwrap();
    let kept = runs.join("swing-2d-13-lattice-continuum/frames");
    let written = || std::fs::metadata(&kept).unwrap().modified().unwrap();
    let before = written();
    let whole = |text: &str| text[..text.find("## Time to solution").unwrap()].to_owned();
    let continued = place.run(&[&few[..], &["--continue"]].concat()).ok();
    assert_eq!(whole(&continued.out), whole(&page.out));
    assert_eq!(written(), before);
    let other = format!("# another\n{}", place.read(case));
    std::fs::write(place.path(case), other).unwrap();
    let refused = place.run(&[&few[..], &["--continue"]].concat()).code(1);
    has(&refused.err, &["another case", "--force"]);
    let again = [&few[..], &["--force", "--json", "--quiet"]].concat();
    let json: Value = serde_json::from_str(&place.run(&again).ok().out).unwrap();
    let scores = json["scores"].as_array().unwrap();
    let frequency = |score: &&Value| score["quantity"] == "frequency";
    // Two resolutions, a lattice and a jittered start.
    assert_eq!(scores.iter().filter(frequency).count(), 4);
    assert!(scores.iter().filter(frequency).all(|s| s["value"].is_f64()));
    assert!(json["costs"][0]["over_plain"].as_f64().unwrap() > 0.0);
}

#[test]
fn unknown_models_and_tests_are_told_what_there_is() {
    let place = Workplace::new("appraise-unknown");
    let model = place
        .run(&[&FEW[..], &["--models", "magic"]].concat())
        .code(2);
    has(&model.err, &["magic", "continuum"]);
    let test = place
        .run(&[&FEW[..], &["--tests", "swim"]].concat())
        .code(1);
    has(&test.err, &["swim", "laplace", "swing"]);
    assert_eq!(test.err.matches("puddle").count(), 1, "{}", test.err);
    let nothing = place
        .run(&["appraise", "--tests", "cap", "--dimension", "3", "--quick"])
        .code(1);
    has(&nothing.err, &["no such run", "without --quick"]);
    assert!(!place.path("out").exists());
}

#[test]
fn a_suite_that_is_stopped_ends_in_good_order_and_is_run_anew() {
    let place = Workplace::new("appraise-interrupted");
    let few = [&FEW[..], &["--models", "continuum", "--tests", "swing"]].concat();
    let mut run = place.start(&few);
    let first = place.path("out/appraise/runs/swing-2d-13-jittered-1-continuum/series.csv");
    // Steps have been made.
    run.wait_until("a run that is on its way", || {
        std::fs::read_to_string(&first).is_ok_and(|series| series.lines().count() > 9)
    });
    run.signal("INT");
    let stopped = run.finish().code(130);
    has(&stopped.err, &["stopping after this step"]);
    assert!(stopped.out.is_empty());
    assert!(!place.path("out/appraise/appraisal.md").exists());
    has(&place.run(&few).code(1).err, &["--force"]);
    let again = place.run(&[&few[..], &["--force"]].concat()).ok();
    has(&again.out, &["## Swing"]);
    assert!(!again.out.contains("Runs without a number"));
}
