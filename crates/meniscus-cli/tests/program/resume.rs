//! Runs that were stopped or killed, and go on as if nothing had happened.

use std::fs;
use std::sync::OnceLock;

use crate::workplace::{Files, Finished, Workplace, assert_same, has, rod_of};

/// What must be the same, byte for byte, however a run came to its end: the
/// series, every frame, and the state at the end.
fn result(place: &Workplace, folder: &str) -> Files {
    let checkpoints = place.names(&format!("{folder}/checkpoints"));
    let last = format!("{folder}/checkpoints/{}", checkpoints.last().unwrap());
    let mut files = place.content(&format!("{folder}/frames"));
    for name in [&format!("{folder}/series.csv"), &last] {
        files.push((name.clone(), fs::read(place.path(name)).unwrap()));
    }
    for (name, _) in &mut files {
        *name = name.trim_start_matches(folder).to_owned();
    }
    files
}

/// The result of the rod, run without a break on one thread.
fn unbroken() -> &'static Files {
    static RESULT: OnceLock<Files> = OnceLock::new();
    RESULT.get_or_init(|| {
        let place = Workplace::with_rod("resume-unbroken");
        place.run(&["run", "rod.toml", "--threads", "1"]).ok();
        result(&place, "out/rod")
    })
}

fn assert_equals_the_unbroken_run(place: &Workplace, folder: &str) {
    assert_same(&result(place, folder), unbroken());
}

/// A run that gets this signal after its first checkpoint.
fn stopped(place: &Workplace, threads: &str, signal: &str) -> Finished {
    let mut run = place.start(&["run", "rod.toml", "--threads", threads]);
    run.wait_for_a_checkpoint(&place.path("out/rod"));
    run.signal(signal);
    run.finish()
}

#[test]
fn the_number_of_threads_changes_no_bit() {
    let place = Workplace::with_rod("resume-two-threads");
    place.run(&["run", "rod.toml", "--threads", "2"]).ok();
    assert_equals_the_unbroken_run(&place, "out/rod");
}

#[test]
fn ctrl_c_stops_in_good_order_and_resume_gives_the_same_bits() {
    let place = Workplace::with_rod("resume-interrupted");
    let run = stopped(&place, "2", "INT").code(130);
    has(&run.err, &["Ctrl-C again to end at once"]);
    has(
        &run.out,
        &[
            "stopped at step",
            "meniscus resume out/rod",
            "report so far: out/rod/report.html",
        ],
    );
    let record: serde_json::Value = serde_json::from_str(&place.read("out/rod/run.json")).unwrap();
    assert_eq!(record["status"], "interrupted");
    let (step, wall) = (
        record["steps"].as_u64().unwrap(),
        record["wall_time"].as_f64(),
    );
    has(
        &place.read("out/rod/report.html"),
        &["was interrupted after t = ", "meniscus resume out/rod"],
    );

    let resumed = place.run(&["resume", "out/rod", "--threads", "1"]).ok();
    has(
        &resumed.out,
        &[&format!("going on from step {step}"), "72.70 mN/m"],
    );
    assert_equals_the_unbroken_run(&place, "out/rod");
    let record: serde_json::Value = serde_json::from_str(&place.read("out/rod/run.json")).unwrap();
    assert_eq!(record["status"], "complete");
    // The time of both sessions together.
    assert!(record["wall_time"].as_f64() > wall);
    assert!(!place.read("out/rod/report.html").contains("interrupted"));
}

#[test]
fn a_second_ctrl_c_ends_at_once() {
    let place = Workplace::with_rod("resume-twice-interrupted");
    let mut run = place.start(&["run", "rod.toml"]);
    run.wait_for_a_checkpoint(&place.path("out/rod"));
    // The report cannot be finished while nobody reads this pipe.
    let pipe = place.path("out/rod/report.html.partial");
    let made = std::process::Command::new("mkfifo").arg(&pipe).status();
    assert!(made.unwrap().success());
    run.signal("INT");
    run.wait_until("the record of the interruption", || {
        place.read("out/rod/run.json").contains("interrupted")
    });
    run.signal("INT");
    let run = run.finish().code(130);
    assert!(!run.out.contains("report so far"), "{}", run.out);
    fs::remove_file(pipe).unwrap();
    place.run(&["resume", "out/rod"]).ok();
    assert_equals_the_unbroken_run(&place, "out/rod");
}

#[test]
fn a_killed_run_goes_on_even_from_an_older_checkpoint_and_past_a_full_disk() {
    let place = Workplace::with_rod("resume-killed");
    assert_eq!(stopped(&place, "1", "KILL").code, None);
    // A report of what there is, which says so.
    place.run(&["report", "out/rod"]).ok();
    has(
        &place.read("out/rod/report.html"),
        &["ended before its time after t = "],
    );

    // The disk is full when the last frame is due.
    let frame = "out/rod/frames/frame-000008.vtu";
    let full = place.path(&format!("{frame}.partial"));
    if fs::metadata("/dev/full").is_ok() {
        std::os::unix::fs::symlink("/dev/full", &full).unwrap();
        let run = place.run(&["resume", "out/rod"]).code(1);
        has(&run.err, &[frame, "No space left"]);
    }

    // The latest checkpoint is damaged, the one before serves.
    let checkpoints = place.names("out/rod/checkpoints");
    let [older, latest] = &checkpoints[..] else {
        panic!("{checkpoints:?}");
    };
    let path = place.path(&format!("out/rod/checkpoints/{latest}"));
    let mut bytes = fs::read(&path).unwrap();
    let middle = bytes.len() / 2;
    bytes[middle] ^= 1;
    fs::write(&path, bytes).unwrap();
    let resumed = place.run(&["resume", "out/rod", "--threads", "2"]).ok();
    has(&resumed.err, &["warning", latest, "checksum"]);
    has(&resumed.out, &[older]);
    assert_equals_the_unbroken_run(&place, "out/rod");
}

#[test]
fn resume_of_a_complete_run_says_so_and_touches_nothing() {
    let place = Workplace::with_rod("resume-complete");
    place.write("rod.toml", &rod_of("0.1 ms"));
    place.run(&["run", "rod.toml"]).ok();
    let before = place.content("out/rod");
    let resumed = place.run(&["resume", "out/rod"]).ok();
    has(&resumed.out, &["the run is complete", "nothing to do"]);
    assert_same(&place.content("out/rod"), &before);
}

#[test]
fn a_folder_without_a_run_is_not_resumed() {
    let place = Workplace::with_rod("resume-nothing");
    has(
        &place.run(&["resume", "out/rod"]).code(1).err,
        &["out/rod", "holds no run"],
    );
    assert_eq!(place.names("."), ["rod.toml"]);
}

/// A van der Waals drop of 100 particles that is drawn out at `time`, with a checkpoint at 0.5 s.
fn drawn_out_at(time: &str) -> String {
    format!(
        r#"dimension = 2
spacing = "0.75 m"
end_time = "1 s"
kernel = "lucy-quartic"
smoothing_length = "3 dx"

[fluid.vdw]
density = "1.7 kg/m^3"
viscosity = "1 Pa s"

[fluid.vdw.van_der_waals]
substance = {{ constants = {{ gas_constant = "1 J/kg/K", cohesion = "2 Pa m^6/kg^2", excluded_volume = "0.5 m^3/kg" }} }}
temperature = "0.3 K"
conductivity = "5 W/m/K"

[[body]]
shape = {{ block = {{ low = ["-5 dx", "-5 dx"], high = ["5 dx", "5 dx"] }} }}

[physics]
adaptive_smoothing = {{ k = 0.9, epsilon = 0.6 }}
time_step = "10 ms"

[deformation]
time = "{time}"
aspect = 1.5
settling = "0.5 /s"

[output]
series = "0.1 s"
checkpoints = "0.5 s"

[measure]
drop_profile = {{}}
"#
    )
}

#[test]
fn a_drop_is_drawn_out_once_before_a_resume_or_after_it() {
    for time in ["0.3 s", "0.7 s"] {
        let place = Workplace::new("resume-drawn-out");
        place.write("drop.toml", &drawn_out_at(time));
        place.run(&["run", "drop.toml", "--threads", "1"]).ok();
        let whole = result(&place, "out/drop");
        // As if it had been killed after half the time.
        let checkpoints = place.names("out/drop/checkpoints");
        let last = format!("out/drop/checkpoints/{}", checkpoints.last().unwrap());
        fs::remove_file(place.path(&last)).unwrap();
        fs::remove_file(place.path("out/drop/run.json")).unwrap();
        let resumed = place.run(&["resume", "out/drop", "--threads", "2"]).ok();
        has(&resumed.out, &["going on from step 50"]);
        assert_same(&result(&place, "out/drop"), &whole);
    }
}
