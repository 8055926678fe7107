//! Contact angles, from a start at 90 degrees.

use meniscus::scheme::Slip;

use crate::common::angle_on_a_plate;
use crate::liquid;

/// The angle at which half a disc of ten spacings comes to rest.
fn angle(degrees: f64, slip: Slip) -> f64 {
    let radius = 10.0;
    let mut setup = liquid::<2>(radius, 0.0, 0.8, |x| x[1] > 0.0 && x.norm() < radius);
    setup.scheme.artificial_viscosity = 0.1;
    angle_on_a_plate(setup, degrees, slip, 300.0)
}

/// Smoothing of 1.7 spacings in a drop of ten: some degrees.
#[test]
fn a_drop_comes_to_stand_at_the_angle_of_its_wall() {
    for (degrees, slip) in [
        (60.0, Slip::NoSlip),
        (90.0, Slip::FreeSlip),
        (120.0, Slip::FreeSlip),
    ] {
        let found = angle(degrees, slip);
        assert!((found - degrees).abs() < 6.0, "{degrees}: {found}");
    }
}
