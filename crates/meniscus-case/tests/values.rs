//! What a case means: particles, masses, motion, sound speeds.

use std::path::Path;

use meniscus::scheme::{SurfaceTension, TimeStep};
use meniscus_case::{Case, Coefficients};

fn read(text: &str) -> Case {
    Case::from_str("case.toml", text).unwrap_or_else(|wrong| panic!("{wrong}"))
}

const HEAD: &str = "dimension = 2\nspacing = '0.1 mm'\nend_time = '10 ms'\n\
    [fluid.water]\ndensity = '1000 kg/m^3'\nsurface_tension = '72.7 mN/m'\n";

#[test]
fn the_rods_of_jancik_and_hyhlik_are_those_of_the_paper() {
    // Their table 1: particles, and the diameter in mm of the circle of the same area.
    for (count, diameter) in [(649, 1.338), (1165, 1.792), (2259, 2.495)] {
        for kind in ["rod", "static"] {
            let path = format!(
                "{}/../../papers/jancik-hyhlik/{kind}-{count}.toml",
                env!("CARGO_MANIFEST_DIR")
            );
            let case = Case::from_file(Path::new(&path)).unwrap_or_else(|wrong| panic!("{wrong}"));
            assert_eq!(case.particle_count(), count);
            let found = 2e3 * meniscus::theory::equivalent_radius(case.bodies[0].volume, 2);
            // The paper prints three decimals.
            assert!((found - diameter).abs() < 6e-4, "{found} for {diameter}");
            assert_eq!(case.scheme.time_step, TimeStep::Fixed(6e-6));
            assert!(matches!(
                case.scheme.surface_tension,
                Some(SurfaceTension::JancikHyhlik(_))
            ));
            // Centred on the origin, and as long as it is said to be wide.
            let sum = case.particles::<2>().iter().fold([0.0; 2], |s, p| {
                [s[0] + p.position[0], s[1] + p.position[1]]
            });
            let off = sum[0].hypot(sum[1]) / count as f64;
            assert!(off < 1e-6 * case.spacing, "off by {off}");
            assert!(case.setup::<2>().particles.len() == count);
        }
    }
}

#[test]
fn every_good_case_starts_a_simulation() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases/good");
    for entry in std::fs::read_dir(folder).unwrap() {
        let case = Case::from_file(&entry.unwrap().path()).unwrap();
        match case.dimension {
            2 => assert!(
                meniscus::Simulation::new(case.setup::<2>()).is_ok(),
                "{}",
                case.name
            ),
            _ => assert!(
                meniscus::Simulation::new(case.setup::<3>()).is_ok(),
                "{}",
                case.name
            ),
        }
    }
}

#[test]
fn mass_is_density_times_volume() {
    let case = read(&format!(
        "{HEAD}[[body]]\nshape = {{ block = {{ low = [0, 0], high = ['1 mm', '2 mm'] }} }}\n"
    ));
    // 2 mm^2 of water: 2 g per metre of length.
    assert!((case.bodies[0].mass - 2e-3).abs() < 1e-15);
    assert_eq!(case.particle_count(), 200);
    let total: f64 = case
        .particles::<2>()
        .iter()
        .map(|particle| particle.mass)
        .sum();
    assert!((total - 2e-3).abs() < 1e-15);
}

#[test]
fn a_turning_body_has_the_momentum_and_the_spin_that_were_asked_for() {
    let case = read(&format!(
        "{HEAD}[[body]]\nshape = {{ disc = {{ radius = '2 mm', centre = ['5 mm', '1 mm'] }} }}\n\
         velocity = ['2 m/s', '1 m/s']\nangular_velocity = '100 rad/s'\n"
    ));
    let particles = case.particles::<2>();
    let n = particles.len() as f64;
    let mean = |d: usize| particles.iter().map(|p| p.velocity[d]).sum::<f64>() / n;
    assert!((mean(0) - 2.0).abs() < 1e-12 && (mean(1) - 1.0).abs() < 1e-12);
    for p in &particles {
        let (x, y) = (p.position[0] - 5e-3, p.position[1] - 1e-3);
        // Anticlockwise about the centre.
        assert!((p.velocity[0] - 2.0 + 100.0 * y).abs() < 1e-9);
        assert!((p.velocity[1] - 1.0 - 100.0 * x).abs() < 1e-9);
    }
}

#[test]
fn the_sound_speed_is_ten_times_the_speed_that_the_case_shows() {
    let disc = "shape = { disc = { radius = '1.05 mm' } }\n";
    let at_rest = read(&format!("{HEAD}[[body]]\n{disc}"));
    // sqrt(2 * 0.0727 / (1000 * 1.05e-3)) = 0.372 m/s; the ragged edge changes R by a few per cent.
    assert!((at_rest.fluids[0].sound_speed / 3.72 - 1.0).abs() < 0.03);
    let moving = read(&format!(
        "{HEAD}[[body]]\n{disc}velocity = ['3 m/s', '4 m/s']\n"
    ));
    assert_eq!(moving.fluids[0].sound_speed, 50.0);
    let falling = read(&format!(
        "{HEAD}[[body]]\nshape = {{ block = {{ low = [0, 0], high = ['0.2 mm', '10.1 mm'] }} }}\n\
         [physics]\nbody_force = ['0 m/s^2', '-1000 m/s^2']\n"
    ));
    // 10 mm from the lowest to the highest particle: sqrt(1000 * 0.01) = 3.162.
    assert!((falling.fluids[0].sound_speed - 31.62).abs() < 0.01);
    // Nothing moves and nothing pulls.
    let idle = read(&format!(
        "{}[[body]]\n{disc}",
        HEAD.replace("surface_tension = '72.7 mN/m'\n", "")
    ));
    assert_eq!(idle.fluids[0].sound_speed, 1.0);
    assert_eq!(idle.scheme.surface_tension, None);
}

#[test]
fn bodies_that_touch_do_not_overlap() {
    let two = |gap: &str| {
        format!(
            "{HEAD}[[body]]\nshape = {{ block = {{ low = [0, 0], high = ['1 mm', '1 mm'] }} }}\n\
             [[body]]\nshape = {{ block = {{ low = ['{gap}', '0 mm'], high = ['3 mm', '1 mm'] }} }}\n"
        )
    };
    read(&two("1 mm"));
    read(&two("0.96 mm"));
    assert!(Case::from_str("x", &two("0.94 mm")).is_err());
}

#[test]
fn fluids_keep_the_order_of_the_file() {
    let case = read(
        "dimension = 2\nspacing = '0.1 mm'\nend_time = '1 s'\n[fluid.water]\ndensity = 1000\n\
         [fluid.air]\ndensity = 1.2\n[[body]]\nfluid = 'air'\nshape = { disc = { radius = '1 mm' } }\n",
    );
    let names: Vec<_> = case
        .fluids
        .iter()
        .map(|fluid| fluid.name.as_str())
        .collect();
    assert_eq!(names, ["water", "air"]);
    assert_eq!(case.bodies[0].fluid, 1);
    assert!(
        case.particles::<2>()
            .iter()
            .all(|particle| particle.fluid == 1)
    );
}

/// What is measured takes the place of what the file leaves open, and of nothing else; the sound speed follows it.
#[test]
fn coefficients_are_those_measured_where_the_file_gives_none() {
    let text = |more: &str| {
        format!(
            "dimension = 2\nspacing = 0.1\nend_time = 1\n[fluid.a]\ndensity = 1\nsurface_tension = 1\n{more}\n\
             [[body]]\nshape = {{ block = {{ low = [-1, 0], high = [1, 1] }} }}\n[[wall]]\n\
             shape = {{ plane = {{ point = [0, 0], normal = [0, 1], width = 4 }} }}\ncontact_angle = \"60 deg\"\n\
             [physics]\nsurface_tension = \"akinci\"\npressure = \"over-density-product\"\n"
        )
    };
    let measured = Coefficients {
        cohesion: [("a".to_owned(), 4.0)].into(),
        adhesion: [(0, 0.5)].into(),
    };
    let plain = Case::from_str("case.toml", &text("")).unwrap();
    assert!(!plain.given.is_complete());
    let case = Case::from_str_with("case.toml", &text(""), &measured).unwrap();
    assert_eq!(case.fluids[0].cohesion_factor, 4.0);
    assert_eq!(case.scheme.walls[0].adhesion_factor, 0.5);
    // Four times the cohesion pressure, and c^2 in proportion to it.
    let ratio = case.fluids[0].sound_speed / plain.fluids[0].sound_speed;
    assert!((ratio - 2.0).abs() < 1e-12, "{ratio}");
    let again = Case::from_str("case.toml", case.to_toml()).unwrap();
    assert!(again.given.is_complete());
    assert_eq!((&again.fluids, &again.scheme), (&case.fluids, &case.scheme));
    let own = Case::from_str_with("case.toml", &text("cohesion_factor = 2"), &measured).unwrap();
    assert_eq!(own.fluids[0].cohesion_factor, 2.0);
}

/// A cohesion as strong as was measured, or stated, and temperatures over the critical one as they were asked for.
#[test]
fn a_van_der_waals_liquid_is_as_strong_as_its_surface_tension_asks() {
    let text = |tension: f64, more: &str| {
        format!(
            "dimension = 2\nspacing = 0.1\nend_time = 1\n[fluid.a]\ndensity = 2\nsurface_tension = {tension}\n{more}\n\
             [fluid.a.van_der_waals]\nsubstance = {{ liquid = {{ reduced_temperature = 0.4 }} }}\ntemperature = 200\n\
             [[body]]\nshape = {{ disc = {{ radius = 1 }} }}\n"
        )
    };
    let measured = Coefficients {
        cohesion: [("a".to_owned(), 1.5)].into(),
        ..Coefficients::default()
    };
    let substance = |case: &Case| case.scheme.van_der_waals.unwrap().substance;
    let plain = read(&text(1.0, ""));
    assert!(!plain.given.is_complete() && plain.warnings.is_empty());
    let sharp = meniscus::theory::step_surface_tension(
        substance(&plain).cohesion,
        2.0,
        plain.scheme.kernel,
        2.0 * plain.scheme.smoothing_length,
        2,
    );
    assert!((sharp - 1.0).abs() < 1e-12, "{sharp}");
    let case = Case::from_str_with("x", &text(4.0, ""), &measured).unwrap();
    let (own, other) = (substance(&case), substance(&plain));
    assert!((own.cohesion / other.cohesion - 6.0).abs() < 1e-12);
    assert_eq!(own.excluded_volume, other.excluded_volume);
    assert!((own.critical_point().temperature / 500.0 - 1.0).abs() < 1e-12);
    let ratio = case.fluids[0].sound_speed / plain.fluids[0].sound_speed;
    assert!((ratio * ratio - 6.0).abs() < 1e-12, "{ratio}");
    let again = Case::from_str("x", case.to_toml()).unwrap();
    assert!(again.given.is_complete());
    assert_eq!((&again.fluids, &again.scheme), (&case.fluids, &case.scheme));
    let stated = Case::from_str_with("x", &text(4.0, "cohesion_factor = 3"), &measured).unwrap();
    assert!((substance(&stated).cohesion / own.cohesion - 2.0).abs() < 1e-12);
}
