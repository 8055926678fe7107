//! Walls. Three things change near one:
//!
//! - the depth under the surface follows from the liquid and from the part of the wall that a surface
//!   at the contact angle would lie above ([`Wedge`](super::Wedge));
//! - n sums over the wall as well, whose particles have the pressure of the liquid: away from the
//!   contact line it vanishes;
//! - the surface goes on into the wall, mirrored in the contact line so that its normal is, there,
//!   at the contact angle. The regression and the means see these mirrored points too: where the
//!   angle is another one, the bend between the surface and its image is curvature,
//!   and the force on it adds up to sigma (cos theta - cos theta_now) along the wall, Young's.

use super::regression::{Moments, Point, Regression};
use crate::particles::Particles;
use crate::real::Real;
use crate::record;
use crate::term::{Pair, PairTerm};
use crate::vector::Vector;

/// The walls of a flow: columns of one row per particle, zero for the liquid. Empty without walls.
#[derive(Debug, Default)]
pub struct Wetting {
    /// V of a wall's particle, m^D.
    pub volume: Vec<f64>,
    /// Its contact angle, rad.
    pub angle: Vec<f64>,
}

/// Sums to what a particle sees of walls.
#[derive(Clone, Copy, Debug)]
pub struct WallCoverage<'a>(pub &'a Wetting);

record! {
    /// V, and V theta.
    pub struct Solid<R, D> {
        /// V, m^D
        volume: R,
        /// V theta
        angle: R,
    }
}

record! {
    /// c_w, n_w and c_w theta.
    pub struct WallCovered<R, D> {
        /// c_w
        filled: R,
        /// n_w, 1/m
        normal: Vector<R, D>,
        /// c_w theta, rad
        angle: R,
    }
}

impl<const D: usize> PairTerm<D> for WallCoverage<'_> {
    type Record<R: Real> = Solid<R, D>;
    type Sum<R: Real> = WallCovered<R, D>;
    const OFTEN: bool = false;

    fn record(&self, _: &Particles<D>, i: usize) -> Solid<f64, D> {
        let volume = self.0.volume[i];
        Solid {
            volume,
            angle: volume * self.0.angle[i],
        }
    }

    #[inline(always)]
    fn pair<R: Real>(
        &self,
        _: &Solid<R, D>,
        j: &Solid<R, D>,
        ij: &Pair<R, D>,
        sum: &mut WallCovered<R, D>,
    ) {
        sum.filled = sum.filled + j.volume * ij.w;
        sum.normal += ij.grad_w * j.volume;
        sum.angle = sum.angle + j.angle * ij.w;
    }
}

/// The image of a point of the surface at `position`, less its inset, in a contact line with a wall
/// whose normal `away` points into the liquid, `distance` m from the point, at a contact angle in rad.
/// It is given as an inset of the same particle. None where the surface lies along the wall.
pub(super) fn mirrored<const D: usize>(
    point: &Point<f64, D>,
    away: &Vector<f64, D>,
    distance: f64,
    angle: f64,
) -> Option<Point<f64, D>> {
    /// Sines of the angle with the wall: below, there is no contact line; the least that is
    /// divided by.
    const ALONG: f64 = 0.05;
    const LEAST: f64 = 0.2;
    let up = point.direction.dot(away);
    let side = point.direction - *away * up;
    let sine = side.norm();
    if sine < ALONG {
        return None;
    }
    let side = side * (1.0 / sine);
    let now = sine.atan2(-up);
    let behind = 2.0 * angle - now;
    // Down the surface to the wall, at the mean of the angles at either end.
    let tangent = |angle: f64| -(side * angle.cos() + *away * angle.sin());
    let way = (distance / now.sin().max(LEAST)).max(0.0);
    let there = (tangent(0.5 * (now + angle)) + tangent(0.5 * (behind + angle))) * way;
    Some(Point {
        inset: point.inset - there,
        direction: side * behind.sin() - *away * behind.cos(),
        weight: point.weight,
    })
}

/// Wendland's C2 shape, of the distance between points of the surface: what an image weighs.
#[inline(always)]
fn weight<R: Real>(offset: R, scale: f64) -> R {
    let q = offset.max(offset.tiny()).sqrt() * scale;
    let rest = (q * -0.5 + 1.0).positive();
    rest.square().square() * (q * 2.0 + 1.0)
}

/// [`Regression`] with the images of points as well.
#[derive(Clone, Copy, Debug)]
pub struct WettedRegression<'a, const D: usize> {
    /// One for each particle.
    pub points: &'a [Point<f64, D>],
    /// Their images; of weight zero where there is none.
    pub images: &'a [Point<f64, D>],
    /// 1/h, 1/m, and W at no distance, 1/m^D.
    pub kernel: (f64, f64),
}

impl<const D: usize> PairTerm<D> for WettedRegression<'_, D> {
    type Record<R: Real> = (Point<R, D>, Point<R, D>);
    type Sum<R: Real> = Moments<R, D>;
    const OFTEN: bool = false;

    fn record(&self, _: &Particles<D>, i: usize) -> (Point<f64, D>, Point<f64, D>) {
        (self.points[i], self.images[i])
    }

    #[inline(always)]
    fn pair<R: Real>(
        &self,
        i: &(Point<R, D>, Point<R, D>),
        j: &(Point<R, D>, Point<R, D>),
        ij: &Pair<R, D>,
        sum: &mut Moments<R, D>,
    ) {
        let points = &[];
        Regression { points }.pair(&i.0, &j.0, ij, sum);
        let along = i.0.inset - j.1.inset - ij.offset;
        let nearness = weight(along.norm_squared(), self.kernel.0) * self.kernel.1;
        sum.add(&i.0, &j.1, along, nearness);
    }
}

/// [`Mean`](super::Mean) with the images of points as well.
#[derive(Clone, Copy, Debug)]
pub struct WettedMean<'a, const D: usize> {
    /// Their weights are those of the mean.
    pub surface: WettedRegression<'a, D>,
    /// f of each particle.
    pub values: &'a [f64],
}

record! {
    /// A value, and where it counts.
    pub struct Imaged<R, D> {
        /// w
        weight: R,
        /// f
        value: R,
        /// Inset of the point, m.
        inset: Vector<R, D>,
        /// Inset of the image, m.
        image: Vector<R, D>,
        /// w of the image
        image_weight: R,
    }
}

impl<const D: usize> PairTerm<D> for WettedMean<'_, D> {
    type Record<R: Real> = Imaged<R, D>;
    type Sum<R: Real> = (R, R);
    const OFTEN: bool = false;

    fn record(&self, _: &Particles<D>, i: usize) -> Imaged<f64, D> {
        let (point, image) = (&self.surface.points[i], &self.surface.images[i]);
        Imaged {
            weight: point.weight,
            value: self.values[i],
            inset: point.inset,
            image: image.inset,
            image_weight: image.weight,
        }
    }

    #[inline(always)]
    fn pair<R: Real>(&self, i: &Imaged<R, D>, j: &Imaged<R, D>, ij: &Pair<R, D>, sum: &mut (R, R)) {
        let along = i.inset - j.image - ij.offset;
        let (scale, highest) = self.surface.kernel;
        let nearness = weight(along.norm_squared(), scale) * highest;
        let both = j.weight * ij.w + j.image_weight * nearness;
        sum.0 = sum.0 + both;
        sum.1 = both.mul_add(j.value, sum.1);
    }
}
