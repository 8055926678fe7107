//! A flat film of a case's liquid, and what it pulls with.
//!
//! Close packed, jittered out of order, brought to rest by a drag; it repeats along itself, and at
//! rest nothing presses across it. Where both its surfaces are free it pulls with twice its surface tension sigma. On
//! a flat wall the forces within the liquid pull with sigma (1 - cos(theta)), theta the contact angle: sigma of its
//! free surface, and at its foot, after Young, what a wall without and with liquid differ by, -sigma cos(theta).

use meniscus::measure::FilmStress;
use meniscus::rates::{Dimension, Space};
use meniscus::scheme::{Adhesion, Bearing, BodyForce, Fluid, Scheme, Slip, Wall};
use meniscus::shape::{Arrangement, Pattern, Shape};
use meniscus::{Domain, Particle, Setup, Simulation, Vector};
use meniscus_case::{Case, SpeedScales};

use super::liquid;
use crate::failure::Failure;

/// Time to come to rest, and that of the measurements after it, in sqrt(rho dx^3 / sigma), in the plane; in space,
/// where a particle has more neighbours to lose its motion to, it is half of that.
const REST: f64 = 60.0;
const MEASURED: f64 = 20.0;
/// How often it is measured.
const TIMES: usize = 5;
/// Rate of the drag times that unit.
const DRAG: f64 = 0.06;

/// Until when a film is held on its wall, in the same unit, and by what body force, over sigma / (rho dx^2): what its
/// disorder sets free at first must not throw it off.
const HELD: f64 = 25.0;
const HOLD: f64 = 0.05;

/// The body of the wall.
const WALL: u16 = 1;

/// How strong the forces of a film are, over those of sharp surfaces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strength {
    /// Within the liquid.
    pub cohesion: f64,
    /// Of the wall on it.
    pub adhesion: f64,
}

/// The wall that a film stands on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Foot {
    /// The contact angle that is asked for, rad.
    pub contact_angle: f64,
    pub(super) bearing: Bearing,
}

/// A film to be made of one fluid of a case.
#[derive(Clone, Debug)]
pub struct Film {
    /// Whose it is.
    pub fluid: Fluid,
    /// What it stands on; none where both surfaces are free.
    pub foot: Option<Foot>,
    pub(super) scheme: Scheme,
    pub(super) spacing: f64,
    /// 2 or 3.
    pub dimension: usize,
    /// The speeds of the case from which its sound speed follows; none where it is given.
    pub(super) speeds: Option<SpeedScales>,
}

impl Film {
    /// Of a fluid of a case, if its surface tension is its own cohesion, by pairwise forces or as that of a van der
    /// Waals fluid.
    pub fn new(case: &Case, index: usize) -> Option<Self> {
        let fluid = &case.fluids[index];
        let mut film = Self {
            fluid: Fluid {
                // Rest does not depend on it.
                viscosity: 0.0,
                cohesion_factor: 1.0,
                ..fluid.clone()
            },
            foot: None,
            scheme: liquid::scheme(case)?,
            spacing: case.spacing,
            dimension: case.dimension,
            speeds: (!case.given.sound_speed[index]).then_some(case.speeds),
        };
        film.scheme.damping = DRAG / film.time();
        Some(film)
    }

    /// The same on a wall of the case, if it asks for a contact angle that adhesion can give.
    pub fn on_wall(case: &Case, index: usize) -> Option<Self> {
        let (body, wall) = (case.walls.get(index)?, case.scheme.walls.get(index)?);
        let Adhesion::ContactAngle(contact_angle) = wall.adhesion else {
            return None;
        };
        // Without any attraction there is none that could be too weak.
        let attracts = contact_angle.cos() > -1.0 + 1e-6;
        let film = Self::new(case, body.fluid).filter(|_| attracts)?;
        Some(Self {
            foot: Some(Foot {
                contact_angle,
                bearing: wall.bearing,
            }),
            ..film
        })
    }

    /// sqrt(rho dx^3 / sigma), s; half of it in space.
    fn time(&self) -> f64 {
        let share = if self.dimension == 2 { 1.0 } else { 0.5 };
        share * (self.fluid.density * self.spacing.powi(3) / self.fluid.surface_tension).sqrt()
    }

    /// The tension, N/m, that it pulls along itself with; none where it has left its wall. `seed` says which film.
    ///
    /// # Errors
    /// If the film blows up.
    pub fn tension(&self, strength: Strength, seed: u64) -> Result<Option<f64>, Failure> {
        match self.dimension {
            2 => self.tension_in::<2>(strength, seed),
            _ => self.tension_in::<3>(strength, seed),
        }
    }

    fn tension_in<const D: usize>(
        &self,
        strength: Strength,
        seed: u64,
    ) -> Result<Option<f64>, Failure>
    where
        Space: Dimension<D>,
    {
        let mut simulation = Simulation::<D>::new(self.setup(strength, seed)?)
            .map_err(|error| Failure::new(error.to_string()))?;
        let time = self.time();
        let mut sum = 0.0;
        for part in 1..=TIMES {
            let until = REST + MEASURED * part as f64 / TIMES as f64;
            simulation.advance_to(until * time).map_err(|diverged| {
                Failure::diverged(&diverged, "a film of this liquid does not hold together")
            })?;
            let Some(tension) = pull(&simulation) else {
                return Ok(None);
            };
            sum += tension;
        }
        Ok(Some(sum / TIMES as f64))
    }

    fn setup<const D: usize>(&self, strength: Strength, seed: u64) -> Result<Setup<D>, Failure> {
        let domain = self.domain::<D>();
        let jittered = Arrangement {
            jitter: self.jitter(),
            seed,
            ..Arrangement::new(self.pattern(), self.spacing)
        };
        let reach = self.reach();
        let thickness = (self.thickness() * reach).max(12.0 * self.spacing);
        let mut particles = self.layer(&domain, jittered, (0.0, thickness))?;
        for particle in &mut particles {
            particle.position[D - 1] *= self.thinness();
        }
        let mut scheme = self.scheme_of(strength);
        if let Some(foot) = self.foot {
            let even = Arrangement::new(Pattern::Cubic, self.spacing);
            let depth = (reach / self.spacing).ceil() * self.spacing;
            let wall = self.layer(&domain, even, (-depth, 0.0))?;
            // What the jitter put behind it goes before it.
            for particle in &mut particles {
                let height = &mut particle.position[D - 1];
                *height = height.abs().max(0.1 * self.spacing);
            }
            particles.extend(wall.into_iter().map(|particle| Particle {
                body: WALL,
                ..particle
            }));
            let (time, fluid) = (self.time(), &self.fluid);
            let pull = fluid.surface_tension / (fluid.density * self.spacing.powi(2));
            let mut hold = [0.0; 3];
            hold[D - 1] = -HOLD * pull;
            scheme.body_force = Some(BodyForce::Table(vec![
                (0.0, hold),
                (0.5 * HELD * time, hold),
                (HELD * time, [0.0; 3]),
            ]));
            scheme.walls = vec![Wall {
                slip: Slip::FreeSlip,
                adhesion: Adhesion::ContactAngle(foot.contact_angle),
                adhesion_factor: strength.adhesion,
                bearing: foot.bearing,
                ..Wall::new(WALL)
            }];
        }
        Ok(Setup {
            scheme,
            fluids: vec![self.liquid(strength.cohesion)],
            particles,
            spacing: self.spacing,
            domain,
        })
    }

    /// The lattice that fits what bounds the film.
    fn pattern(&self) -> Pattern {
        match self.foot {
            Some(_) => Pattern::Cubic,
            None => Pattern::ClosePacked,
        }
    }

    /// As wide along each axis as the lattice fits into.
    fn domain<const D: usize>(&self) -> Domain<D> {
        let reach = self.reach() / self.spacing;
        let width = match D {
            2 => (6.0 * reach).max(24.0),
            _ => (self.breadth() * reach).max(10.0),
        };
        let periods = match self.pattern() {
            Pattern::ClosePacked => [1.0, 3.0_f64.sqrt()],
            _ => [1.0, 1.0],
        };
        let mut domain = Domain::default();
        for (axis, period) in domain.periodic[..D - 1].iter_mut().zip(periods) {
            let length = (width / period).ceil() * period * self.spacing;
            *axis = Some((0.0, length));
        }
        domain
    }

    /// Particles that fill the domain between two heights, m.
    fn layer<const D: usize>(
        &self,
        domain: &Domain<D>,
        arrangement: Arrangement<D>,
        (low, high): (f64, f64),
    ) -> Result<Vec<Particle<D>>, Failure> {
        let mut ends = [Vector::<f64, D>::ZERO; 2];
        for (axis, end) in domain.periodic.iter().zip(&mut ends[1].0) {
            *end = axis.map_or(high, |axis| axis.1);
        }
        ends[0][D - 1] = low;
        let [low, high] = ends;
        let block = Shape::Block { low, high };
        let limit = (2.0 * arrangement.estimate(&block)) as usize;
        let mut particles = (arrangement.body(&block, self.fluid.density, limit))
            .map_err(|error| Failure::new(format!("a film cannot be laid: {error}")))?;
        for particle in &mut particles {
            domain.wrap(&mut particle.position);
        }
        Ok(particles)
    }
}

/// The tension of the liquid, N/m; none where the wall has let go of it.
fn pull<const D: usize>(simulation: &Simulation<D>) -> Option<f64> {
    let (particles, scheme) = (simulation.particles(), simulation.scheme());
    let rows: Vec<usize> = (0..particles.len())
        .filter(|&row| !simulation.is_wall(particles.body[row]))
        .collect();
    let positions: Vec<_> = rows.iter().map(|&row| particles.position[row]).collect();
    let (kernel, h) = (scheme.kernel, scheme.smoothing_length);
    let flow = simulation.van_der_waals();
    let range = flow.map_or(kernel.support() * h, |flow| {
        flow.range(particles, kernel, h)
    });
    let lowest = positions
        .iter()
        .map(|x| x[D - 1])
        .fold(f64::INFINITY, f64::min);
    if !scheme.walls.is_empty() && lowest > range {
        return None;
    }
    let force = |i: usize, j: usize, offset: Vector<f64, D>| match flow {
        Some(flow) => {
            let r = offset.norm();
            offset * (flow.force_at_rest(particles, kernel, h, [rows[i], rows[j]], r) / r)
        }
        None => simulation.force_at_rest([rows[i], rows[j]], offset),
    };
    let width = 0.5 * simulation.spacing();
    let stress = FilmStress::measure(&positions, simulation.domain(), range, width, force)?;
    // At rest nothing presses across a free film, but it swings; on a wall it is the wall that may press.
    Some(if scheme.walls.is_empty() {
        stress.tension()
    } else {
        stress.pull_along()
    })
}
