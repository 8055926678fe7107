//! The energy of a node, and what it changes by with the colour there and its gradient.
//!
//! Lengths are in distances of nodes, energies in sigma times the area of a node's cell.

use crate::vector::Vector;

/// eps, the slope below which a surface costs little, in 1/dx.
pub(super) const LEAST_SLOPE: f64 = 0.05 / 8.0;
/// mu, the share of the second term.
const COMPRESSION: f64 = 0.1;

/// f(c) = 30 c^2 (1 - c)^2, of integral one, and its slope.
fn bell(c: f64) -> (f64, f64) {
    let rest = 1.0 - c;
    (30.0 * (c * rest).powi(2), 60.0 * c * rest * (1.0 - 2.0 * c))
}

/// c (1 - c)^2, and its slope.
fn well(c: f64) -> (f64, f64) {
    let rest = 1.0 - c;
    (c * rest * rest, rest * (1.0 - 3.0 * c))
}

/// What makes either term of a flat surface cost sigma.
#[derive(Clone, Copy, Debug)]
pub(super) struct Calibrated {
    /// k_T
    pub variation: f64,
    /// k_G
    pub compression: f64,
}

/// The two terms of a node without walls, before they are calibrated.
pub(super) fn terms(colour: f64, slope: f64) -> (f64, f64) {
    if !(0.0..1.0).contains(&colour) {
        return (0.0, 0.0);
    }
    let length = slope.hypot(LEAST_SLOPE) - LEAST_SLOPE;
    (bell(colour).0 * length, well(colour).0)
}

/// Colour and walls at a node.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node<const D: usize> {
    /// C, the liquid's, with its gradient
    pub liquid: f64,
    pub liquid_gradient: Vector<f64, D>,
    /// C_w, the walls', with its gradient, and that of the walls weighted with cos(theta)
    pub wall: f64,
    pub wall_gradient: Vector<f64, D>,
    pub wetting_gradient: Vector<f64, D>,
}

/// Derivatives of the energy with respect to C and its gradient.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slopes<const D: usize> {
    pub by_colour: f64,
    pub by_gradient: Vector<f64, D>,
}

/// How much of a node counts as outside of walls: one and zero but in the middle of their smoothed
/// surface, and a half there.
fn share(wall: f64) -> f64 {
    let u = ((wall - 0.3) / 0.4).clamp(0.0, 1.0);
    1.0 - u * u * (3.0 - 2.0 * u)
}

impl<const D: usize> Node<D> {
    /// Derivatives of the energy; none where it has none.
    ///
    /// Beside walls c = C / (1 - C_w): what the colour would be if the liquid went on behind them as it is
    /// before them. A wet wall gains cos(theta) F(c) per area, F' = f, over that half of the smoothed wall that
    /// lies before it.
    pub fn slopes(&self, calibrated: Calibrated) -> Option<Slopes<D>> {
        let share = share(self.wall);
        let widening = 1.0 / (1.0 - self.wall);
        let colour = self.liquid * widening;
        if share <= 0.0 || !(colour > 0.0 && colour < 1.0) {
            return None;
        }
        let walls_part = self.wall_gradient * (widening * widening);
        let gradient = self.liquid_gradient * widening + walls_part * self.liquid;
        let length = gradient.norm().hypot(LEAST_SLOPE);
        let ((f, f_slope), (_, well_slope)) = (bell(colour), well(colour));
        let variation = share * (1.0 - COMPRESSION) * calibrated.variation;
        let compression = share * COMPRESSION * calibrated.compression;
        let mut by_colour = variation * f_slope * (length - LEAST_SLOPE) + compression * well_slope;
        let steep = self.wall_gradient.norm();
        if steep > 0.0 && self.wall < 0.5 {
            let cosine = self.wetting_gradient.dot(&self.wall_gradient) / (steep * steep);
            by_colour -= cosine * steep * 2.0 * bell(2.0 * self.wall).0 * f;
        }
        let by_gradient = gradient * (variation * f / length);
        Some(Slopes {
            by_colour: by_colour * widening + by_gradient.dot(&walls_part),
            by_gradient: by_gradient * widening,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Derivatives against differences of the energy, with and without walls.
    #[test]
    fn slopes_are_those_of_the_energy() {
        let calibrated = Calibrated {
            variation: 1.03,
            compression: 2.0,
        };
        let energy = |node: &Node<2>| {
            let widening = 1.0 / (1.0 - node.wall);
            let colour = node.liquid * widening;
            let gradient = node.liquid_gradient * widening
                + node.wall_gradient * (widening * widening * node.liquid);
            let (variation, gap) = terms(colour, gradient.norm());
            let both = (1.0 - COMPRESSION) * calibrated.variation * variation
                + COMPRESSION * calibrated.compression * gap;
            let c = colour;
            let wet = c * c * c * (10.0 - 15.0 * c + 6.0 * c * c);
            let steep = node.wall_gradient.norm();
            let cosine = if steep > 0.0 {
                node.wetting_gradient.dot(&node.wall_gradient) / (steep * steep)
            } else {
                0.0
            };
            let area = if node.wall < 0.5 {
                steep * 2.0 * bell(2.0 * node.wall).0
            } else {
                0.0
            };
            share(node.wall) * both - cosine * area * wet
        };
        for wall in [0.0, 0.2, 0.45, 0.6] {
            let node = Node {
                liquid: 0.3,
                liquid_gradient: Vector([0.2, -0.05]),
                wall,
                wall_gradient: Vector([-0.02, -0.2]) * (wall / 0.3),
                wetting_gradient: Vector([-0.01, -0.1]) * (wall / 0.3),
            };
            let slopes = node.slopes(calibrated).unwrap();
            let step = 1e-6;
            let difference = |change: &dyn Fn(&mut Node<2>, f64)| {
                let (mut up, mut down) = (node, node);
                change(&mut up, step);
                change(&mut down, -step);
                (energy(&up) - energy(&down)) / (2.0 * step)
            };
            let by_colour = difference(&|node, step| node.liquid += step);
            assert!((slopes.by_colour - by_colour).abs() < 1e-8, "{wall}");
            for d in 0..2 {
                let by_gradient = difference(&|node, step| node.liquid_gradient[d] += step);
                assert!((slopes.by_gradient[d] - by_gradient).abs() < 1e-8, "{wall}");
            }
        }
    }
}
