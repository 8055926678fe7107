//! Lattices and rings, and filling a shape with them.

use std::f64::consts::{PI, SQRT_2};
use std::fmt;

use super::geometry::Shape;
use super::jitter::SplitMix64;
use super::rings::{visit_discs, visit_rings};
use super::rotation::Rotation;
use crate::particles::Particle;
use crate::vector::Vector;

/// How particles lie beside one another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pattern {
    /// Square in 2D, cubic in 3D; one spacing between neighbours along each axis.
    Cubic,
    /// Triangular in 2D, hexagonal close packed in 3D; one spacing between all
    /// nearest neighbours, rows along x, layers along z.
    ClosePacked,
    /// A particle at the centre, and rings or shells about it one spacing
    /// apart. In 2D ring k holds 6 k particles. In 3D shell k holds the whole
    /// number nearest 4 pi k^2, along a spiral that spreads them evenly.
    Concentric,
    /// Discs one spacing apart along the axis of a cylinder or of what is revolved, otherwise along x,
    /// the first half a spacing inside the shape. Ring k of a disc has the radius (k + 1/2) dx
    /// and as many particles as its circumference has spacings: a tube of whole spacings is
    /// filled up to half a spacing from its wall.
    Stacked,
}

/// Particles `spacing` apart in a [`Pattern`].
#[derive(Clone, Debug, PartialEq)]
pub struct Arrangement<const D: usize> {
    /// How particles lie beside one another.
    pub pattern: Pattern,
    /// Distance between neighbours, m.
    pub spacing: f64,
    /// How the pattern is turned about its origin.
    pub rotation: Rotation<D>,
    /// Where a particle of the lattice, or the centre of the rings, lies, m.
    ///
    /// Where none is given it is the shape's centre if it has one; a lattice then starts half a period
    /// inside of flat faces that half spaces cut. Otherwise
    /// rings centre on the middle of the shape's bounding box, and a lattice
    /// starts inside the low corner of that box, by half its period in each
    /// direction: so a block of n by m spacings holds n by m particles of a
    /// square lattice, and n in each row of a triangular one.
    pub origin: Option<Vector<f64, D>>,
    /// Each coordinate moves by a random part of up to this many spacings.
    pub jitter: f64,
    /// Which random displacements.
    pub seed: u64,
}

/// Why a shape could not be filled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FillError {
    /// No particle lies inside the shape.
    Empty,
    /// The shape has no end, or a size that is not a number.
    Unbounded,
    /// The spacing is zero, negative or not a number.
    Spacing(f64),
    /// More particles than allowed.
    TooMany {
        /// About how many the shape's bounding box would hold.
        estimate: f64,
        /// How many are allowed.
        limit: usize,
    },
}

impl fmt::Display for FillError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            FillError::Empty => write!(
                f,
                "the shape holds no particle; enlarge it or use a smaller spacing"
            ),
            FillError::Unbounded => {
                write!(f, "the shape has no end; intersect it with one that has")
            }
            FillError::Spacing(spacing) => {
                write!(f, "the spacing is {spacing} m; it must be above zero")
            }
            FillError::TooMany { estimate, limit } => {
                write!(
                    f,
                    "the shape holds up to {estimate:.2e} particles, above the limit of {limit}; use a larger spacing"
                )
            }
        }
    }
}

impl std::error::Error for FillError {}

impl<const D: usize> Arrangement<D> {
    /// The pattern as it is: not turned, no jitter, the origin fitted to the shape.
    pub fn new(pattern: Pattern, spacing: f64) -> Self {
        Self {
            pattern,
            spacing,
            rotation: Rotation::none(),
            origin: None,
            jitter: 0.0,
            seed: 0,
        }
    }

    /// Volume of one particle, m^3; in 2D its area, m^2.
    ///
    /// Square and cubic dx^D; triangular sqrt(3)/2 dx^2; close packed
    /// dx^3/sqrt(2). Rings pi/3 dx^2, the area of the ring between the radii
    /// (k - 1/2) dx and (k + 1/2) dx shared by its 6 k particles; shells dx^3,
    /// likewise up to 1/(12 k^2); stacked discs dx^3, up to a rounding in each ring.
    pub fn particle_volume(&self) -> f64 {
        let share = match (self.pattern, D) {
            (Pattern::Cubic, _) => 1.0,
            (Pattern::ClosePacked, 2) => 0.75_f64.sqrt(),
            (Pattern::ClosePacked, _) => 1.0 / SQRT_2,
            (Pattern::Concentric, 2) => PI / 3.0,
            (Pattern::Concentric | Pattern::Stacked, _) => 1.0,
        };
        share * self.spacing.powi(D as i32)
    }

    /// About how many particles the shape's bounding box holds: no fewer than
    /// the shape does, up to a layer at its surface. Infinite for an endless shape.
    pub fn estimate(&self, shape: &Shape<D>) -> f64 {
        let (low, high) = shape.bounding_box();
        let volume: f64 = (high - low).0.iter().map(|side| side.max(0.0)).product();
        volume / self.particle_volume()
    }

    /// A body at rest: particles of fluid and body 0 inside the shape, each with
    /// the mass of its volume at `density`, kg/m^3.
    ///
    /// # Errors
    /// As [`fill`](Self::fill).
    pub fn body(
        &self,
        shape: &Shape<D>,
        density: f64,
        limit: usize,
    ) -> Result<Vec<Particle<D>>, FillError> {
        let particle = |position| Particle {
            position,
            velocity: Vector::ZERO,
            mass: density * self.particle_volume(),
            fluid: 0,
            body: 0,
        };
        Ok(self.fill(shape, limit)?.into_iter().map(particle).collect())
    }

    /// Positions of the particles inside the shape, in the lattice's order.
    ///
    /// # Errors
    /// [`FillError`] for a shape that is empty, endless, or holds more than
    /// `limit` particles; memory is never asked for more than those.
    pub fn fill(&self, shape: &Shape<D>, limit: usize) -> Result<Vec<Vector<f64, D>>, FillError> {
        if !(self.spacing > 0.0 && self.spacing.is_finite()) {
            return Err(FillError::Spacing(self.spacing));
        }
        let (low, high) = shape.bounding_box();
        if (0..D).any(|d| low[d] >= high[d]) {
            return Err(FillError::Empty);
        }
        if (0..D).any(|d| !(low[d].is_finite() && high[d].is_finite())) {
            return Err(FillError::Unbounded);
        }
        let origin = self
            .origin
            .unwrap_or_else(|| self.fitted_origin(shape, low, high));
        let too_many = FillError::TooMany {
            estimate: self.estimate(shape),
            limit,
        };
        let (from, to) = self.reach(origin, low, high);
        // A slender shape fills little of its box: look at twenty sites for each
        // particle allowed, but not at endlessly many.
        if self.sites(from, to) > 20.0 * (limit as f64).max(1e4) {
            return Err(too_many);
        }

        let mut positions = Vec::new();
        let mut random = SplitMix64(self.seed);
        let mut visit = |site: [f64; 3]| {
            let mut x = origin + self.rotation.apply(&(Vector::from_3d(site) * self.spacing));
            if shape.contains(&x) && positions.len() <= limit {
                if self.jitter != 0.0 {
                    for d in 0..D {
                        x[d] += self.jitter * self.spacing * random.symmetric();
                    }
                }
                positions.push(x);
            }
        };
        match self.pattern {
            Pattern::Concentric => visit_rings::<D>(to[0] as i64, &mut visit),
            Pattern::Stacked => visit_discs(shape.axis(), to[0] as i64, &mut visit),
            _ => self.visit_lattice(from, to, &mut visit),
        }
        match positions.len() {
            0 => Err(FillError::Empty),
            n if n > limit => Err(too_many),
            _ => Ok(positions),
        }
    }

    /// Distances between lattice rows along x, y and z, in spacings.
    pub(super) fn periods(&self) -> [f64; 3] {
        match self.pattern {
            Pattern::ClosePacked => [1.0, 0.75_f64.sqrt(), (2.0_f64 / 3.0).sqrt()],
            _ => [1.0; 3],
        }
    }

    /// The first and last lattice indices that may lie in the box; for rings
    /// the last holds the number of rings.
    fn reach(
        &self,
        origin: Vector<f64, D>,
        low: Vector<f64, D>,
        high: Vector<f64, D>,
    ) -> ([f64; 3], [f64; 3]) {
        let mut from = [f64::INFINITY; 3];
        let mut to = [f64::NEG_INFINITY; 3];
        let mut farthest: f64 = 0.0;
        for corner in 0..1 << D {
            let corner = Vector(std::array::from_fn(|d| {
                if corner >> d & 1 == 0 {
                    low[d]
                } else {
                    high[d]
                }
            }));
            let r = self.rotation.undo(&(corner - origin)) * (1.0 / self.spacing);
            farthest = farthest.max(r.norm());
            let r = r.to_3d();
            for d in 0..3 {
                from[d] = from[d].min(r[d]);
                to[d] = to[d].max(r[d]);
            }
        }
        if matches!(self.pattern, Pattern::Concentric | Pattern::Stacked) {
            return ([0.0; 3], [farthest.ceil(); 3]);
        }
        let periods = self.periods();
        for d in 0..D {
            // One more on each side for rows that are set off.
            from[d] = (from[d] / periods[d]).floor() - 1.0;
            to[d] = (to[d] / periods[d]).ceil() + 1.0;
        }
        (from, to)
    }

    /// How many sites filling will look at.
    fn sites(&self, from: [f64; 3], to: [f64; 3]) -> f64 {
        match (self.pattern, D) {
            (Pattern::Concentric, 2) => 3.0 * to[0] * to[0],
            (Pattern::Concentric, _) => 4.2 * to[0].powi(3),
            (Pattern::Stacked, _) => 6.3 * to[0].powi(3),
            _ => (0..D).map(|d| to[d] - from[d] + 1.0).product(),
        }
    }

    fn visit_lattice(&self, from: [f64; 3], to: [f64; 3], visit: &mut impl FnMut([f64; 3])) {
        let periods = self.periods();
        let packed = self.pattern == Pattern::ClosePacked;
        for k in from[2] as i64..=to[2] as i64 {
            for j in from[1] as i64..=to[1] as i64 {
                let (row, layer) = if packed { ((j + k) & 1, k & 1) } else { (0, 0) };
                for i in from[0] as i64..=to[0] as i64 {
                    visit([
                        i as f64 + 0.5 * row as f64,
                        (j as f64 + layer as f64 / 3.0) * periods[1],
                        k as f64 * periods[2],
                    ]);
                }
            }
        }
    }
}
