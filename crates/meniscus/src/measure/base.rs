//! The wall that a drop stands on.

use crate::physics::wall::layout::Side;
use crate::vector::Vector;

/// A flat wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane<const D: usize> {
    /// A point of its surface, m.
    pub point: Vector<f64, D>,
    /// Direction from the wall to the liquid, of length one.
    normal: Vector<f64, D>,
}

impl<const D: usize> Plane<D> {
    /// Through a point, m, with a normal of any length that points to the liquid; `None` if it
    /// has none.
    pub fn new(point: Vector<f64, D>, normal: Vector<f64, D>) -> Option<Self> {
        let length = normal.norm();
        (length > 0.0 && length.is_finite()).then(|| Self {
            point,
            normal: normal * (1.0 / length),
        })
    }

    /// Direction from the wall to the liquid, of length one.
    pub fn normal(&self) -> Vector<f64, D> {
        self.normal
    }

    /// Height of a point above the wall, m.
    pub fn height(&self, x: Vector<f64, D>) -> f64 {
        (x - self.point).dot(&self.normal)
    }
}

/// A wall, flat or round.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Base<const D: usize> {
    /// A flat one.
    Plane(Plane<D>),
    /// A disc or ball, or all around it.
    Ball {
        /// Its centre, m.
        centre: Vector<f64, D>,
        /// Its radius, m.
        radius: f64,
        /// On which side of its surface the wall is, and the liquid not.
        side: Side,
    },
}

impl<const D: usize> Base<D> {
    /// Height of a point above the wall, m: positive where the liquid is.
    pub fn height(&self, x: Vector<f64, D>) -> f64 {
        match self {
            Base::Plane(plane) => plane.height(x),
            Base::Ball {
                centre,
                radius,
                side: Side::Inside,
            } => (x - *centre).norm() - radius,
            Base::Ball { centre, radius, .. } => radius - (x - *centre).norm(),
        }
    }

    /// Direction from the wall to the liquid at the place nearest to `x`, of length one; any
    /// direction at the centre of a ball.
    pub fn normal(&self, x: Vector<f64, D>) -> Vector<f64, D> {
        let (arm, sign) = match self {
            Base::Plane(plane) => return plane.normal,
            Base::Ball { centre, side, .. } => match side {
                Side::Inside => (x - *centre, 1.0),
                Side::Outside => (x - *centre, -1.0),
            },
        };
        let length = arm.norm();
        if length > 0.0 {
            return arm * (sign / length);
        }
        let mut any = Vector::ZERO;
        any[0] = 1.0;
        any
    }

    /// 1 / radius, 1/m: positive where the wall bulges into the liquid, negative of a vessel.
    pub fn curvature(&self) -> f64 {
        match self {
            Base::Plane(_) => 0.0,
            Base::Ball {
                radius,
                side: Side::Inside,
                ..
            } => 1.0 / radius,
            Base::Ball { radius, .. } => -1.0 / radius,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heights_grow_along_normals_from_the_wall_into_the_liquid() {
        let centre = Vector([1.0, 2.0]);
        let plane = Plane::new(centre, Vector([0.0, 3.0])).unwrap();
        let ball = |side| Base::Ball {
            centre,
            radius: 2.0,
            side,
        };
        for (wall, foot, normal) in [
            (Base::Plane(plane), Vector([7.0, 2.0]), Vector([0.0, 1.0])),
            (ball(Side::Inside), Vector([3.0, 2.0]), Vector([1.0, 0.0])),
            (ball(Side::Outside), Vector([1.0, 0.0]), Vector([0.0, 1.0])),
        ] {
            let x = foot + normal * 0.25;
            assert!((wall.height(x) - 0.25).abs() < 1e-15);
            assert_eq!(wall.height(foot), 0.0);
            assert_eq!(wall.normal(x), normal);
        }
        assert_eq!(ball(Side::Outside).curvature(), -0.5);
        assert_eq!(Plane::new(centre, Vector::ZERO), None);
    }
}
