//! `check`, `new`, `schema`, `report`, and the command line itself.

use crate::workplace::{ROD, Workplace, has, rod_of};

#[test]
fn check_tells_everything_of_a_case_without_running_it() {
    let place = Workplace::new("check");
    let falling = r#"
[physics]
body_force = ["0 m/s^2", "-9.81 m/s^2"]
artificial_viscosity = 0.1
[measure]"#;
    let rod = ROD
        .replace("[measure]", falling)
        .replace("sound_speed = \"6 m/s\"", "viscosity = \"1 mPa s\"")
        .replace(
            "arrangement",
            "velocity = [\"0.2 m/s\", \"0 m/s\"]\narrangement",
        );
    place.write("rod.toml", &rod);
    let check = place.run(&["check", "rod.toml"]).ok();
    has(
        &check.out,
        &[
            "Small rod",
            "287 particles of water",
            "area 6.21", // 287 of 0.05^2 sqrt(3)/2 mm^2
            "mass 0.000621",
            " La ",
            " Oh ",
            " We ",
            " Re ",
            " La laminar ",
            " Re laminar ",
            " Bo ",
            "sound speed",
            "density error",
            "acoustic",
            "force",
            "viscous",
            "capillary",
            "<- governs",
            "adaptive",
            "steps",
            "memory",
            " MB",
            "time ",
            "particle-steps/s",
        ],
    );
    assert_eq!(check.out.matches("<- governs").count(), 1);
    assert_eq!(place.names("."), ["rod.toml"]);
    // Quiet is about what nobody asked for.
    has(
        &place.run(&["check", "rod.toml", "-q"]).ok().out,
        &["287 particles"],
    );
}

#[test]
fn a_new_case_checks_and_runs_and_is_never_overwritten() {
    let place = Workplace::new("new");
    has(
        &place.run(&["new", "my-drop"]).ok().out,
        &["my-drop.toml", "meniscus check"],
    );
    place.run(&["check", "my-drop.toml"]).ok();
    let text = place.read("my-drop.toml");
    has(&text, &["title = \"my-drop\"", "# "]);
    // As it stands, but not to its end.
    place.write(
        "short.toml",
        &text.replace("end_time = \"20 ms\"", "end_time = \"50 us\""),
    );
    place.run(&["run", "short.toml"]).ok();

    place.write("my-drop.toml", "mine");
    let refused = place.run(&["new", "my-drop.toml"]).code(1);
    has(&refused.err, &["my-drop.toml exists already"]);
    assert_eq!(place.read("my-drop.toml"), "mine");
    has(
        &place.run(&["new", "no/such/folder"]).code(1).err,
        &["no/such/folder.toml"],
    );
    has(
        &place.run(&["new", ".."]).code(1).err,
        &["not the name of a case"],
    );
}

#[test]
fn the_schema_is_json_and_a_closed_pipe_no_reason_to_panic() {
    let place = Workplace::new("schema");
    let schema: serde_json::Value = serde_json::from_str(&place.run(&["schema"]).ok().out).unwrap();
    assert!(schema["properties"]["spacing"].is_object());
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    let output = place.command(&["schema"]).stdout(writer).output().unwrap();
    assert_eq!(output.status.code(), Some(0));
    assert_eq!(String::from_utf8(output.stderr).unwrap(), "");
}

#[test]
#[cfg(target_os = "linux")]
fn an_answer_that_cannot_be_written_is_an_error() {
    let place = Workplace::new("schema-full");
    let full = std::fs::File::create("/dev/full").unwrap();
    let output = place.command(&["schema"]).stdout(full).output().unwrap();
    assert_eq!(output.status.code(), Some(1));
    has(
        &String::from_utf8(output.stderr).unwrap(),
        &["standard output", "No space left"],
    );
}

#[test]
fn a_report_is_written_anew_and_the_same() {
    let place = Workplace::new("report");
    place.write("rod.toml", &rod_of("0.2 ms"));
    let run = place.run(&["run", "rod.toml"]).ok();
    let before = place.read("out/rod/report.html");
    std::fs::remove_dir_all(place.path("out/rod/figures")).unwrap();
    std::fs::remove_file(place.path("out/rod/report.html")).unwrap();
    let report = place.run(&["report", "out/rod"]).ok();
    assert_eq!(place.read("out/rod/report.html"), before);
    assert!(place.path("out/rod/figures/energies.svg").is_file());
    // The same table too, and the same reason why there is no period in it.
    let table = |out: &str| out[out.find("\nresult").unwrap()..].to_owned();
    assert_eq!(table(&report.out), table(&run.out));
    has(&report.out, &["no oscillation was fitted"]);
    has(&place.run(&["report", "."]).code(1).err, &["holds no run"]);
}

#[test]
fn the_command_line_explains_itself() {
    let place = Workplace::new("command-line");
    let help = place.run(&["--help"]).ok().out;
    has(
        &help,
        &[
            "run",
            "resume",
            "check",
            "report",
            "reproduce",
            "new",
            "schema",
        ],
    );
    has(&help, &["Exit codes", "130"]);
    has(&place.run(&["rum"]).code(2).err, &["run"]);
    place.run(&["check", "x.toml", "--threads", "0"]).code(2);
}
