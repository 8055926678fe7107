//! A flow that blows up.

use crate::workplace::{ROD, Workplace, has};

/// The rod, until a body force of 10^13 m/s^2 tears at it after 1 ms.
fn torn_rod() -> String {
    let row = |time: &str, x: &str| {
        format!("{{ time = \"{time}\", acceleration = [\"{x} m/s^2\", \"0 m/s^2\"] }}")
    };
    let rows = [row("1 ms", "0"), row("1.001 ms", "1e13")].join(", ");
    ROD.replace(
        "[measure]",
        &format!("[physics]\nbody_force = {{ table = [{rows}] }}\n[measure]"),
    )
}

#[test]
fn it_stops_with_particle_term_step_advice_and_the_last_good_checkpoint() {
    let place = Workplace::new("divergence");
    place.write("rod.toml", &torn_rod());
    let run = place.run(&["run", "rod.toml"]).code(3);
    has(
        &run.err,
        &[
            "diverged at step",
            "particle ",
            "the strongest term there is the body force",
            "what may help",
            "check the body force",
            "last good checkpoint: out/rod/checkpoints/step-",
            "report of the run so far: out/rod/report.html",
        ],
    );
    let record: serde_json::Value = serde_json::from_str(&place.read("out/rod/run.json")).unwrap();
    assert_eq!(record["status"], "diverged");
    has(
        &place.read("out/rod/report.html"),
        &["The run diverged after t = 1.0"],
    );

    // The checkpoint named is there, and good: from it the run takes the same course.
    let (_, after) = run.err.split_once("last good checkpoint: ").unwrap();
    let named = after.lines().next().unwrap();
    assert!(place.path(named).is_file());
    assert!(!named.ends_with("000000.checkpoint"), "{named}");
    let again = place.run(&["resume", "out/rod"]).code(3);
    has(&again.out, &[named]);
    let what = |text: &str| text[text.find("error: ").unwrap()..].to_owned();
    assert_eq!(what(&again.err), what(&run.err));
}

#[test]
fn check_tells_of_a_case_that_blows_up_at_once() {
    let place = Workplace::new("divergence-check");
    place.write(
        "rod.toml",
        &ROD.replace("[measure]", "[physics]\ntime_step = \"100 us\"\n[measure]"),
    );
    let check = place.run(&["check", "rod.toml"]).code(3);
    has(&check.out, &["times the shortest limit"]);
    has(&check.err, &["diverged at step", "shorten the time step"]);
}
