//! Contact angles, from a start at 90 degrees.

use meniscus::scheme::Slip;

use crate::common::angle_on_a_plate;
use crate::liquid;

/// The angle at which half a disc of ten spacings comes to rest.
fn angle(degrees: f64, slip: Slip) -> f64 {
    let radius = 10.0;
    let setup = liquid::<2>(radius, 0.1, 0.8, |x| x[1] > 0.0 && x.norm() < radius);
    angle_on_a_plate(setup, degrees, slip, 300.0)
}

/// A wetting drop stands at its angle within what a circle through the outermost particles of ten spacings tells; one that
/// does not wet stands too steep, by up to twenty degrees on a jittered lattice.
#[test]
fn a_drop_comes_to_stand_at_the_angle_of_its_wall() {
    for (degrees, slip, within) in [
        (60.0, Slip::NoSlip, 8.0),
        (90.0, Slip::FreeSlip, 8.0),
        (120.0, Slip::FreeSlip, 22.0),
    ] {
        let found = angle(degrees, slip);
        assert!((found - degrees).abs() < within, "{degrees}: {found}");
    }
}
