//! What the forces on a disordered drop add up to. For an exact force on a closed
//! surface that is nothing.

use meniscus::physics::surface_tension::continuum::{Continuum, Form};
use meniscus::rates::{Dimension, Space};
use meniscus::shape::Pattern;
use meniscus::{Simulation, Vector};

use crate::ball;

/// What the model makes of a drop jittered by a tenth of a spacing: the net force before
/// balancing, and that which acts, in units of sigma R^(D-2).
fn net_forces<const D: usize>(radius: f64, model: Continuum) -> (f64, f64)
where
    Space: Dimension<D>,
{
    let setup = ball::<D>(radius, Pattern::ClosePacked, 0.1, model);
    let simulation = Simulation::new(setup).expect("a sound setup");
    let p = simulation.particles();
    let mut acts = Vector::<f64, D>::ZERO;
    for i in 0..p.len() {
        acts += p.acceleration[i] * p.mass[i];
    }
    let unit = radius.powi(D as i32 - 2);
    (
        simulation.surface().net_force.norm() / unit,
        acts.norm() / unit,
    )
}

#[test]
fn a_disordered_drop_is_not_pulled_along() {
    // Forces add up to 2 pi sigma in magnitude (8 pi in 3D): rounding.
    let rounding = 1e-12;
    for form in [Form::Balanced, Form::Stress] {
        let model = Continuum {
            form,
            ..Continuum::default()
        };
        let (flat, solid) = (
            net_forces::<2>(13.4, model).1,
            net_forces::<3>(7.0, model).1,
        );
        assert!(
            flat < rounding && solid < rounding,
            "{form:?}: {flat:e}, {solid:e}"
        );
    }
}

#[test]
fn what_balancing_takes_off_is_little() {
    // Of forces that add up to 2 pi sigma, and 8 pi sigma R, in magnitude.
    let default = Continuum::default();
    let (flat, solid) = (
        net_forces::<2>(13.4, default).0,
        net_forces::<3>(7.0, default).0,
    );
    assert!(flat < 0.05 * 6.3 && solid < 0.01 * 25.1, "{flat}, {solid}");
}
