//! Spellings, and what they mean.

use std::f64::consts::PI;

use super::kind::KINDS;
use super::*;

#[track_caller]
fn is(text: &str, kind: &Kind, value: f64) {
    assert_eq!(
        parse(text, Some(2e-5)),
        Ok(Quantity {
            value,
            dimension: kind.dimension
        }),
        "{text}"
    );
}

#[test]
fn every_kind_reads_its_own_example_and_si_unit() {
    for kind in KINDS {
        for text in [kind.example.to_string(), format!("1 {}", kind.si)] {
            assert_eq!(
                parse(&text, None).unwrap().dimension,
                kind.dimension,
                "{text}"
            );
        }
        assert_eq!(parse(&format!("1 {}", kind.si), None).unwrap().value, 1.0);
    }
}

#[test]
fn decimal_prefixes_round_once() {
    // Each is the double nearest the decimal fraction, as if written in SI.
    is("0.05 mm", &LENGTH, 5e-5);
    is("72.7 mN/m", &SURFACE_TENSION, 0.0727);
    is("6us", &TIME, 6e-6);
    is("1e3 mm", &LENGTH, 1.0);
    is("75 µm", &LENGTH, 75e-6);
    is("75 μm", &LENGTH, 75e-6);
    is("998.2 kg/m³", &DENSITY, 998.2);
    is("0.9982 g/cm^3", &DENSITY, 998.2);
    is("-9.81 m/s²", &ACCELERATION, -9.81);
    is("9.81 m s^-2", &ACCELERATION, 9.81);
    is("9.81 m s⁻²", &ACCELERATION, 9.81);
    is(".5 bar", &PRESSURE, 5e4);
    is("20 dyn/cm", &SURFACE_TENSION, 0.02);
}

#[test]
fn one_viscosity_in_many_spellings() {
    for text in [
        "1 mPa s",
        "1 mPa.s",
        "1 mPa·s",
        "1 mPa*s",
        "1 cP",
        "0.001 Pa s",
        "1e-3 kg/m/s",
        "1e-2 P",
    ] {
        is(text, &VISCOSITY, 1e-3);
    }
}

#[test]
fn rates_angles_and_spacings() {
    is("4000 /s", &RATE, 4000.0);
    is("4000 1/s", &RATE, 4000.0);
    is("4 kHz", &RATE, 4000.0);
    is("180 deg", &ANGLE, PI);
    is("60 rpm", &ANGULAR_VELOCITY, 2.0 * PI);
    is("1.5 dx", &LENGTH, 1.5 * 2e-5);
    is("3 dx^2", &AREA, 3.0 * (2e-5_f64).powi(2));
    assert_eq!(parse("1 dx", None), Err(QuantityError::Spacing));
    assert_eq!(
        parse("3", None),
        Ok(Quantity {
            value: 3.0,
            dimension: NUMBER.dimension
        })
    );
}

#[test]
fn nonsense_is_refused_with_its_reason() {
    let nearest = |text: &str| match parse(text, None) {
        Err(QuantityError::Unit { nearest, .. }) => nearest,
        other => panic!("{text}: {other:?}"),
    };
    assert_eq!(nearest("1 Mn"), Some("MN".into()));
    assert_eq!(nearest("1 pa"), Some("Pa".into()));
    assert_eq!(nearest("1 hz"), Some("Hz".into()));
    assert_eq!(nearest("1 furlong"), None);
    for text in ["", "mm", "abc", "- 3 m", "."] {
        assert_eq!(parse(text, None), Err(QuantityError::Number), "{text}");
    }
    for text in ["inf", "nan m", "-inf s", "1e999 m"] {
        assert_eq!(parse(text, None), Err(QuantityError::NotFinite), "{text}");
    }
    for text in [
        "1 m/", "1 /", "1 m//s", "1 m^", "1 m^99", "1 m*/s", "1 m,", "1,5 m", "1 m^2.5", "1 (m)",
    ] {
        assert!(
            matches!(parse(text, None), Err(QuantityError::Syntax(_))),
            "{text}: {:?}",
            parse(text, None)
        );
    }
}
