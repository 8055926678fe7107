//! Contact angles, from a start at 90 degrees.

use meniscus::scheme::Slip;
use meniscus::{Setup, Simulation};

use crate::common::{angle_on_a_plate, put_on_a_plate};
use crate::liquid;

/// Half a disc of ten spacings.
fn half_disc() -> Setup<2> {
    let radius = 10.0;
    liquid::<2>(radius, 0.1, 0.8, |x| x[1] > 0.0 && x.norm() < radius)
}

/// A drop stands at its angle within what a circle through the outermost particles of ten spacings tells: half a spacing
/// in the height of its middle over its radius is 3 to 4 degrees.
#[test]
fn a_drop_comes_to_stand_at_the_angle_of_its_wall() {
    for (degrees, slip) in [
        (60.0, Slip::NoSlip),
        (90.0, Slip::FreeSlip),
        (120.0, Slip::NoSlip),
        (120.0, Slip::FreeSlip),
    ] {
        let found = angle_on_a_plate(half_disc(), degrees, slip, 300.0);
        assert!((found - degrees).abs() < 5.0, "{degrees}: {found}");
    }
}

/// A drop that draws itself together opens no voids: what lies well inside of it, five spacings to either side and up
/// to eight, is as full as at first. And it comes to rest, where theory has no motion: what is left is below a hundredth of
/// sqrt(sigma / (rho R)).
#[test]
fn a_drop_that_recedes_stays_whole() {
    let mut setup = half_disc();
    put_on_a_plate(&mut setup, 50.0, 120.0, Slip::NoSlip);
    let mut simulation = Simulation::new(setup).expect("a sound setup");
    simulation.advance_to(300.0).expect("a drop at rest");
    let p = simulation.particles();
    let middle = p.position.iter().map(|x| x[0]).zip(&p.body);
    let middle: Vec<f64> = middle
        .filter(|(_, body)| **body == 0)
        .map(|(x, _)| x)
        .collect();
    let middle = middle.iter().sum::<f64>() / middle.len() as f64;
    let inside = (p.position.iter().zip(&p.body))
        .filter(|(x, body)| **body == 0 && (x[0] - middle).abs() < 5.0 && x[1] < 8.0);
    // Eighty cells; what the four sides cut off of a row of eight or ten is a half of one.
    let count = inside.count();
    assert!((75..=85).contains(&count), "{count}");
    let speeds = p
        .velocity
        .iter()
        .zip(&p.body)
        .filter(|(_, body)| **body == 0);
    let fastest = speeds.map(|(v, _)| v.norm()).fold(0.0, f64::max);
    assert!(fastest < 0.01 * 0.1_f64.sqrt(), "{fastest}");
}
