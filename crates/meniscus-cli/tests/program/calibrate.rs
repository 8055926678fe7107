//! `calibrate`, and what `check` and `run` make of it.

use serde_json::Value;

use crate::workplace::{Workplace, has};

/// A small drop of pairwise forces, by this kernel, of spacings this long.
fn drop_of(kernel: &str, spacing: &str, more: &str) -> String {
    format!(
        "dimension = 2\nspacing = \"{spacing} mm\"\nend_time = \"10 us\"\nkernel = \"{kernel}\"\n\
         smoothing_length = \"1.5 dx\"\n\n[fluid.water]\ndensity = \"1 g/cm^3\"\n\
         surface_tension = \"72.7 mN/m\"\n{more}\n[[body]]\nshape = {{ disc = {{ radius = \"5 dx\" }} }}\n\n\
         [physics]\nsurface_tension = \"akinci\"\n"
    )
}

/// Films that differ in nothing but their scale are one; another kernel asks for others.
#[test]
fn a_calibration_is_stored_and_used_as_long_as_it_fits() {
    let place = Workplace::new("calibrate");
    place.write("drop.toml", &drop_of("wendland-c2", "0.1", ""));
    let before = place.run(&["check", "drop.toml"]).ok();
    has(&before.out, &["cohesion of water is not measured yet"]);
    let done = place.run(&["calibrate", "drop.toml", "--json"]).ok();
    let rows: Value = serde_json::from_str(&done.out).expect("JSON");
    let number = |key: &str| rows[0][key].as_f64().expect("a number");
    assert_eq!(rows[0]["name"], "water");
    // Films of evenly spread particles' strength show a third; one as strong as the factor shows all of it.
    let product = number("factor") * number("by_estimate") / number("asked");
    assert!((product - 1.0).abs() < 0.2, "{rows}");
    assert!(
        number("factor_half_width") < 0.15 * number("factor"),
        "{rows}"
    );

    place.write("drop.toml", &drop_of("wendland-c2", "0.2", ""));
    let known = place.run(&["check", "drop.toml"]).ok();
    has(
        &known.out,
        &["cohesion of water is", "drop.calibration.toml"],
    );
    let run = place.run(&["run", "drop.toml"]).ok();
    assert!(!run.out.contains("measuring"), "{}", run.out);
    let resolved = place.read("out/drop/case.toml");
    let factor = format!("cohesion_factor = {}", number("factor"));
    has(&resolved, &[&factor]);

    place.write("drop.toml", &drop_of("cubic-spline", "0.2", ""));
    let stale = place.run(&["check", "drop.toml"]).ok();
    has(&stale.out, &["cohesion of water is not measured yet"]);
}

#[test]
fn what_needs_no_films_or_cannot_be_read_is_said() {
    let place = Workplace::new("calibrate-not");
    let given = drop_of("wendland-c2", "0.1", "cohesion_factor = 3");
    place.write("drop.toml", &given);
    let refused = place.run(&["calibrate", "drop.toml"]).code(1);
    has(
        &refused.err,
        &["leaves nothing to be measured", "cohesion_factor"],
    );
    let run = place.run(&["run", "drop.toml"]).ok();
    assert!(!run.out.contains("measuring"), "{}", run.out);
    place.write("damaged.toml", &drop_of("wendland-c2", "0.1", ""));
    place.write("damaged.calibration.toml", "[[fluid]]\nname = 3\n");
    let damaged = place.run(&["run", "damaged.toml"]).code(1);
    has(&damaged.err, &["damaged.calibration.toml", "remove it"]);
}

/// A van der Waals liquid of this surface tension, density and temperature, of the shortest forces.
fn cohesive_drop(tension: &str, density: &str, reduced_temperature: f64) -> String {
    format!(
        "dimension = 2\nspacing = \"0.1 mm\"\nend_time = \"10 us\"\nsmoothing_length = \"1.5 dx\"\n\n\
         [fluid.argon]\ndensity = \"{density}\"\nsurface_tension = \"{tension}\"\n\n[fluid.argon.van_der_waals]\n\
         substance = {{ liquid = {{ reduced_temperature = {reduced_temperature} }} }}\ntemperature = \"90 K\"\n\
         cohesion_range = 1.25\n\n[[body]]\nshape = {{ disc = {{ radius = \"5 dx\" }} }}\n"
    )
}

/// Surface tension and density are the scale of its films; the temperature over the critical one is not.
#[test]
fn a_van_der_waals_liquid_is_calibrated_at_its_reduced_temperature() {
    let place = Workplace::new("calibrate-van-der-waals");
    place.write("drop.toml", &cohesive_drop("13 mN/m", "1.4 g/cm^3", 0.4));
    let done = place.run(&["calibrate", "drop.toml", "--json"]).ok();
    let rows: Value = serde_json::from_str(&done.out).expect("JSON");
    let number = |key: &str| rows[0][key].as_f64().expect("a number");
    // A soft surface has less than a sharp one of the same cohesion, and the strength is all of the scale.
    assert!(number("by_estimate") < number("asked"), "{rows}");
    let product = number("factor") * number("by_estimate") / number("asked");
    assert!((product - 1.0).abs() < 0.05, "{rows}");

    place.write("drop.toml", &cohesive_drop("2.8 N/m", "5 g/cm^3", 0.4));
    let known = place.run(&["check", "drop.toml"]).ok();
    has(&known.out, &["cohesion of argon is", "2.800 N/m asked for"]);
    let run = place.run(&["run", "drop.toml"]).ok();
    assert!(!run.out.contains("measuring"), "{}", run.out);

    place.write("drop.toml", &cohesive_drop("2.8 N/m", "5 g/cm^3", 0.5));
    let warmer = place.run(&["check", "drop.toml"]).ok();
    has(&warmer.out, &["cohesion of argon is not measured yet"]);
}
