//! `run`: the files of a run, and what it does about files that are there.

use meniscus_output::{FrameReader, Series};

use crate::workplace::{ROD, Workplace, assert_same, has, rod_of};

#[test]
fn a_run_leaves_every_file_that_is_promised_and_says_what_it_found() {
    let place = Workplace::with_rod("run-files");
    let run = place.run(&["run", "rod.toml"]).ok();
    let kept = place.names("out/rod");
    let promised = [
        "case.toml",
        "checkpoints",
        "figures",
        "frames",
        "report.html",
        "run.json",
        "series.csv",
    ];
    has(&kept.join(" "), &promised);
    // The results: measured beside given, and where to look.
    has(
        &run.out,
        &[
            "287 particles",
            "surface tension by axis x (moments)",
            "72.70 mN/m",
            "given",
            "Rayleigh",
            "out/rod/report.html",
            "out/rod/frames/frames.pvd",
        ],
    );
    // Nothing but plain lines where no terminal listens, and none too long for one.
    assert!(!run.out.contains('\u{1b}') && !run.out.contains('\r'));
    let widest = run.out.lines().map(|line| line.chars().count()).max();
    assert!(widest <= Some(120), "{}", run.out);
    assert!(!run.err.contains("error"), "{}", run.err);

    // A row every 20 us, the first at the start and the last at the end.
    let series = Series::read(&place.path("out/rod/series.csv")).unwrap();
    let header = place.read("out/rod/series.csv");
    has(
        header.lines().next().unwrap(),
        &[
            "time [s]",
            "kinetic energy [J/m]",
            "compression energy [J/m]",
            "surface energy [J/m]",
            "momentum x [kg m/s/m]",
            "centre of mass y [m]",
            "semi-axis x [m]",
            "tip semi-axis y [m]",
            "least density [kg/m^3]",
            "largest speed [m/s]",
            "surface-active particles",
        ],
    );
    let time = series.column("time").unwrap();
    assert_eq!((time[0], series.len()), (0.0, 201));
    assert!((time[200] - 4e-3).abs() < 5e-6, "{}", time[200]);
    assert!(time.windows(2).all(|pair| pair[1] > pair[0]));

    // A frame every 0.5 ms, both ends too, with all particles and their pressure.
    let frames = FrameReader::open(&place.path("out/rod/frames")).unwrap();
    assert_eq!(frames.times().len(), 9);
    let last = frames.read(8).unwrap();
    assert_eq!(last.positions.len(), 287);
    let pressure = last.fields.iter().find(|f| f.name == "pressure").unwrap();
    assert_eq!((pressure.values.len(), pressure.unit.as_str()), (287, "Pa"));
    assert_eq!(last.time, time[200]);

    for name in [
        "pressure",
        "speed",
        "semi-axes",
        "energies",
        "pressure-profile",
    ] {
        let png = std::fs::read(place.path(&format!("out/rod/figures/{name}.png"))).unwrap();
        assert!(png.starts_with(b"\x89PNG"), "{name}");
        has(
            &place.read(&format!("out/rod/figures/{name}.svg")),
            &["<svg"],
        );
    }
    has(
        &place.read("out/rod/report.html"),
        &[
            "Small rod",
            "Measured surface tension by axis x",
            "Rayleigh",
        ],
    );
    let record: serde_json::Value = serde_json::from_str(&place.read("out/rod/run.json")).unwrap();
    assert_eq!(record["status"], "complete");
    assert_eq!(record["particles"], 287);
    assert_eq!(record["findings"][0]["id"], "sigma-oscillation");
    // The case as resolved runs like the one it came from.
    place
        .run(&["run", "out/rod/case.toml", "--out", "again"])
        .ok();
    assert_eq!(
        place.read("again/series.csv"),
        place.read("out/rod/series.csv")
    );
}

#[test]
fn a_folder_that_holds_a_run_is_left_alone_unless_forced() {
    let place = Workplace::new("run-force");
    place.write("rod.toml", &rod_of("0.1 ms"));
    place.run(&["run", "rod.toml"]).ok();
    place.write("out/rod/notes.txt", "mine");
    place.write("out/rod/figures/mine.png", "mine");
    let before = place.content("out/rod");

    place.write("rod.toml", &rod_of("0.05 ms"));
    let refused = place.run(&["run", "rod.toml"]).code(1);
    has(
        &refused.err,
        &["out/rod", "already holds a run", "--force", "--out"],
    );
    assert_eq!(refused.out, "");
    assert_same(&place.content("out/rod"), &before);

    place.run(&["run", "rod.toml", "--force"]).ok();
    assert_eq!(place.read("out/rod/notes.txt"), "mine");
    assert_eq!(place.read("out/rod/figures/mine.png"), "mine");
    let series = Series::read(&place.path("out/rod/series.csv")).unwrap();
    assert!(*series.column("time").unwrap().last().unwrap() < 0.06e-3);
}

#[test]
fn out_names_the_folder_and_quiet_says_nothing() {
    let place = Workplace::new("run-out");
    place.write("rod.toml", &rod_of("0.1 ms"));
    let run = place
        .run(&["run", "rod.toml", "--out", "some/where", "--quiet"])
        .ok();
    assert_eq!((run.out.as_str(), run.err.as_str()), ("", ""));
    assert!(place.path("some/where/report.html").is_file());
    assert!(!place.path("out").exists());
    // Each frame and checkpoint on demand.
    let run = place.run(&["run", "rod.toml", "-v", "--out", "there"]).ok();
    has(
        &run.out,
        &["wrote there/frames/frame-000001.vtu", ".checkpoint"],
    );
}

#[test]
fn a_wrong_case_is_pointed_at_and_nothing_is_left_behind() {
    let place = Workplace::new("run-wrong-case");
    place.write("rod.toml", &ROD.replace("\"0.05 mm\"", "\"3 kg\""));
    let run = place.run(&["run", "rod.toml"]).code(1);
    has(&run.err, &["rod.toml:3:11", "3 kg"]);
    assert_eq!(run.out, "");
    let missing = place.run(&["run", "rood.toml"]).code(1);
    has(&missing.err, &["rood.toml"]);
    assert_eq!(place.names("."), ["rod.toml"]);
}

#[test]
fn a_folder_that_cannot_be_made_is_named() {
    let place = Workplace::new("run-no-folder");
    place.write("rod.toml", &rod_of("0.1 ms"));
    let run = place
        .run(&["run", "rod.toml", "--out", "rod.toml/results"])
        .code(1);
    has(
        &run.err,
        &["rod.toml/results", "could not create the folder"],
    );
}

#[test]
fn a_run_goes_on_where_nobody_listens() {
    let place = Workplace::new("run-deaf");
    place.write("rod.toml", &rod_of("0.1 ms"));
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    let status = place
        .command(&["run", "rod.toml"])
        .stdout(writer.try_clone().unwrap())
        .stderr(writer)
        .status()
        .unwrap();
    assert_eq!(status.code(), Some(0));
    assert!(place.path("out/rod/report.html").is_file());
}

#[test]
fn bodies_and_sensors_may_be_called_anything() {
    let place = Workplace::new("run-names");
    let bodies = r#"
[[body]]
name = "drop, \"left\""
shape = { disc = { radius = "4 dx", centre = ["-20 dx", "0 dx"] } }
[[body]]
name = "drop"
shape = { disc = { radius = "4 dx", centre = ["0 dx", "0 dx"] } }
[[body]]
name = "drop"
shape = { disc = { radius = "4 dx", centre = ["20 dx", "0 dx"] } }
[measure]
sensors = [{ name = "in, \"left\"", at = ["-20 dx", "0 dx"] }]
"#;
    let (before, _) = ROD.split_once("[[body]]").unwrap();
    place.write(
        "drops.toml",
        &(before.replace("\"4 ms\"", "\"50 us\"") + bodies),
    );
    place.run(&["run", "drops.toml"]).ok();
    let series = Series::read(&place.path("out/drops/series.csv")).unwrap();
    for name in ["body 1 semi-axis x", "body 3 inner pressure"] {
        assert!(series.column(name).is_some(), "{name}");
    }
    assert!(
        series
            .columns
            .iter()
            .any(|c| c.name.starts_with("pressure at in"))
    );
}
