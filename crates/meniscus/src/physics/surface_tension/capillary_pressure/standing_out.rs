//! How strongly a particle that stands out of the surface is drawn back, along the gradient of the colour: by
//! (c_0 - c)/c_0^2, sigma / dx^2 per volume, below a colour c_0 = 0.4. Those of a flat surface have more than a half.
//!
//! On a wall the last particle of a row, one spacing thick as at the foot of a drop that wets well, has 0.3, and does not stand out: drawn back,
//! by 0.02 sigma, it held drops of 30 degrees at 32.4. So c_0 falls to 0.2 half a spacing from a wall; one alone there has 0.15 in two dimensions, 0.05 in three.

use super::push;

/// c_0
const LEAST: f64 = 0.4;
/// The same half a spacing from a wall.
const LEAST_ON_WALL: f64 = 0.2;

/// For a particle with this colour, where a wall has that.
pub(super) fn pull(colour: f64, wall: f64) -> f64 {
    let beside = (wall / push::AT_WALL).min(1.0);
    let least = LEAST + beside * (LEAST_ON_WALL - LEAST);
    (least - colour).max(0.0) / (least * least)
}

#[cfg(test)]
mod tests {
    use super::super::exact_drops::{found, grid};
    use super::pull;
    use crate::vector::Vector;

    /// What draws a particle back that lies at `last`, beyond those of a unit lattice that `inside` picks, over a wall that fills z < 0
    /// or lies far below.
    fn drawn<const D: usize>(
        inside: impl Fn(&Vector<f64, D>) -> bool,
        last: Vector<f64, D>,
        wall: f64,
    ) -> f64 {
        let lattice = grid(10.0, 1.0).filter(inside);
        let liquid: Vec<_> = lattice.chain([last]).map(|x| (x, 1.0)).collect();
        let below = |x: &Vector<f64, D>| (wall - 4.0..wall).contains(&x[D - 1]);
        let (mesh, nodes) = found(&liquid, grid(20.0, 1.0).filter(below).map(|x| (x, 0.5)));
        let wall = nodes
            .beside_walls()
            .map_or(0.0, |beside| mesh.feel_at(beside.wall, &last).0);
        pull(mesh.feel_at(&nodes.colour, &last).0, wall)
    }

    fn row<const D: usize>(thick: f64) -> impl Fn(&Vector<f64, D>) -> bool {
        move |x| x[0] < 0.0 && (0.0..thick).contains(&x[D - 1])
    }

    #[test]
    fn the_last_of_a_row_on_a_wall_is_not_drawn_back() {
        for thick in [1.0, 2.0, 5.0] {
            assert_eq!(
                drawn(row::<2>(thick), Vector([0.5, 0.5]), 0.0),
                0.0,
                "{thick}"
            );
            // One of those that end it.
            let last = Vector([0.5, 0.5, 0.5]);
            let edge = |x: &Vector<f64, 3>| x[0] < 1.0 && (0.0..1.0).contains(&x[2]);
            let others = |x: &Vector<f64, 3>| *x != last && (row::<3>(thick)(x) || edge(x));
            assert_eq!(drawn(others, last, 0.0), 0.0, "{thick}");
        }
    }

    #[test]
    fn one_that_left_is_drawn_back() {
        let off = 2.5;
        assert!(drawn(row::<2>(5.0), Vector([off, 0.5]), 0.0) > 0.5);
        assert!(drawn(row::<3>(5.0), Vector([off, 0.5, 0.5]), 0.0) > 0.5);
        // Far from walls, over a flat surface.
        let over = |x: &Vector<f64, 2>| x[1] < 0.0;
        assert!(drawn(over, Vector([0.5, 1.5]), -30.0) > 0.5);
        assert_eq!(drawn(over, Vector([0.5, -0.5]), -30.0), 0.0);
    }
}
