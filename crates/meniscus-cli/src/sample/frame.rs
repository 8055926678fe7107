//! A frame: what is written of all particles at one time.

use meniscus::{Simulation, Vector};
use meniscus_output::{Field, Frame};

use super::van_der_waals;

/// A frame of all particles, in the order of their numbers.
pub fn frame<const D: usize>(simulation: &Simulation<D>) -> Frame {
    let p = simulation.particles();
    let mut order: Vec<usize> = (0..p.len()).collect();
    order.sort_unstable_by_key(|&i| p.id[i]);
    let scalar = |name: &str, unit: &str, value: &dyn Fn(usize) -> f64| {
        Field::scalar(name, unit, order.iter().map(|&i| value(i)).collect())
    };
    let vector = |name: &str, unit: &str, column: &[Vector<f64, D>]| {
        let values: Vec<_> = order.iter().map(|&i| column[i].to_3d()).collect();
        Field::vector(name, unit, &values)
    };
    let mut fields = vec![
        vector("velocity", "m/s", &p.velocity),
        vector("acceleration", "m/s^2", &p.acceleration),
        scalar("pressure", "Pa", &|i| p.pressure[i]),
        scalar("density", "kg/m^3", &|i| p.density[i]),
        scalar("speed", "m/s", &|i| p.velocity[i].norm()),
        scalar("fluid", "", &|i| f64::from(p.fluid[i])),
        scalar("body", "", &|i| f64::from(p.body[i])),
    ];
    if simulation.scheme().adaptive_smoothing.is_some() {
        fields.push(scalar("smoothing length", "m", &|i| p.smoothing_length[i]));
    }
    if !simulation.wall_loads().is_empty() {
        let is_wall = |i: usize| f64::from(u8::from(simulation.is_wall(p.body[i])));
        fields.push(scalar("wall", "", &is_wall));
    }
    let surface = simulation.surface();
    if surface.curvature.len() == p.len() {
        fields.push(scalar("curvature", "1/m", &|i| surface.curvature[i]));
        fields.push(scalar("colour", "", &|i| surface.colour[i]));
        fields.push(vector("normal", "1/m", &surface.normal));
        fields.push(scalar("normal length", "1/m", &|i| {
            surface.normal[i].norm()
        }));
    }
    fields.extend(van_der_waals::fields(simulation, &order));
    if surface.virial_pressure.len() == p.len() {
        fields.push(scalar("virial pressure", "Pa", &|i| {
            surface.virial_pressure[i]
        }));
    }
    Frame {
        time: simulation.time(),
        step: simulation.steps(),
        dimension: D,
        positions: order.iter().map(|&i| p.position[i].to_3d()).collect(),
        fields,
    }
}
