//! The walls of a simulation on their way: where their particles are, what these take from
//! the fluid before each force, and what the fluid exerts on them.
//!
//! - here: where they are, and what they take from the fluid
//! - `edge`: what they do to its density, and do not do at its edge
//! - `load`: what it exerts on them
//! - `meeting`: where they meet it

mod edge;
mod load;
mod meeting;

pub use load::WallLoad;

use std::f64::consts::FRAC_PI_2;

use crate::domain::Domain;
use crate::fluid::Fluid;
use crate::pairs::Pairs;
use crate::particles::Particles;
use crate::physics::equation_of_state::Tait;
use crate::physics::surface_tension::balanced::Wetting;
use crate::physics::wall::{
    Adhesion, Bearing, Compression, Extrapolation, Motion, Moved, Neighbourhood, Slip, Wall,
    WallBodies, Walled, normals,
};
use crate::term::Sweep;
use crate::vector::Vector;

/// The walls, and columns with an entry for each of their particles.
#[derive(Debug, Default)]
pub(crate) struct Walls<const D: usize> {
    walls: Vec<Wall>,
    /// Per body: which of the walls it is.
    wall_of: Vec<Option<u16>>,
    is_wall: Vec<bool>,
    slip: Vec<f64>,
    /// How far below zero the pressure of walls may fall, Pa.
    tension: f64,
    /// Places at t = 0, by number of the particle; none where nothing moves.
    start: Vec<Vector<f64, D>>,
    /// Rows of the wall particles, and how many lists had been built then.
    rows: Vec<u32>,
    built: Option<u64>,
    mass: Vec<f64>,
    /// Neighbours of the other kind, and how many lists had been built then.
    meets: Vec<f64>,
    met_at_build: Option<u64>,
    sums: Vec<Neighbourhood<f64, D>>,
    compression: Compression,
    /// Unit normals of wall particles at t = 0, by number of the particle.
    normal: Vec<Vector<f64, D>>,
    /// Forces over sums of W that pressure is kept from, and what comes of them.
    kept: Vec<Vector<f64, D>>,
    shares: Vec<Vector<f64, D>>,
    loads: Vec<WallLoad>,
    /// Work on the liquid per time, W.
    power: f64,
    /// Of the last force, s.
    time: f64,
    /// Of the step that is under way, s.
    step: f64,
}

impl<const D: usize> Walls<D> {
    /// Walls of particles at the start, in the order of their numbers. Liquid whose
    /// pressure is below zero they hold by up to this `tension`, Pa.
    pub(crate) fn new(
        walls: &[Wall],
        particles: &Particles<D>,
        tension: f64,
        spacing: f64,
        support: f64,
        domain: &Domain<D>,
    ) -> Self {
        let bodies = walls.iter().map(|wall| usize::from(wall.body) + 1).max();
        let bodies = bodies.unwrap_or(0);
        let mut new = Self {
            walls: walls.to_vec(),
            wall_of: vec![None; bodies],
            is_wall: vec![false; bodies],
            slip: vec![0.0; bodies],
            tension,
            loads: vec![WallLoad::default(); walls.len()],
            ..Self::default()
        };
        for (wall, index) in walls.iter().zip(0..) {
            let body = usize::from(wall.body);
            new.wall_of[body] = Some(index);
            new.is_wall[body] = true;
            new.slip[body] = match wall.slip {
                Slip::NoSlip => 1.0,
                Slip::FreeSlip => 2.0,
            };
        }
        let of_walls = (0..particles.len()).filter(|&i| new.is_wall(particles.body[i]));
        let of_walls: Vec<usize> = of_walls.collect();
        let places: Vec<_> = of_walls.iter().map(|&i| particles.position[i]).collect();
        new.normal.resize(particles.len(), Vector::ZERO);
        for (i, normal) in of_walls
            .into_iter()
            .zip(normals(&places, spacing, support, domain))
        {
            new.normal[particles.id[i] as usize] = normal;
        }
        if walls.iter().any(|wall| wall.motion != Motion::Rest) {
            new.start.clone_from(&particles.position);
        }
        new
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.walls.is_empty()
    }

    /// The material of the flow.
    pub(crate) fn material<'a>(&'a self, fluids: &'a [Fluid]) -> Walled<'a> {
        Walled {
            fluids,
            slip: &self.slip,
        }
    }

    /// Whether a body is a wall.
    pub(crate) fn is_wall(&self, body: u16) -> bool {
        self.bodies().hold(body)
    }

    /// Which bodies are walls.
    pub(crate) fn bodies(&self) -> WallBodies<'_> {
        WallBodies(&self.is_wall)
    }

    /// Whether any of these rows is of a wall with liquid beside it.
    pub(crate) fn has_wet_wall(
        &self,
        particles: &Particles<D>,
        mut rows: std::ops::Range<usize>,
    ) -> bool {
        rows.any(|row| self.is_wall(particles.body[row]) && self.sums[row].weight > 0.0)
    }

    /// Takes up a march that had come to `time`, s.
    pub(crate) fn resume(&mut self, time: f64) {
        self.time = time;
    }

    /// The wall that a row belongs to.
    fn wall_of(&self, particles: &Particles<D>, row: usize) -> Option<usize> {
        let wall = self.wall_of.get(usize::from(particles.body[row]));
        wall.copied().flatten().map(usize::from)
    }

    /// Finds the rows again where particles were sorted anew.
    fn find_rows(&mut self, particles: &Particles<D>, builds: u64) {
        if self.built == Some(builds) {
            return;
        }
        self.built = Some(builds);
        let rows = (0..particles.len()).filter(|&row| self.wall_of(particles, row).is_some());
        let rows: Vec<u32> = rows.map(|row| row as u32).collect();
        self.mass.clear();
        self.mass
            .extend(rows.iter().map(|&row| particles.mass[row as usize]));
        self.rows = rows;
    }

    /// The middle of a step of `dt` seconds.
    pub(crate) fn go_halfway(&mut self, pairs: &Pairs<D>, particles: &mut Particles<D>, dt: f64) {
        self.step = dt;
        self.place(pairs, particles, self.time + 0.5 * dt);
    }

    /// Finds what the fluid near walls is like.
    fn look(&mut self, pairs: &mut Pairs<D>, particles: &Particles<D>) {
        self.meet(pairs, particles);
        let mut sums = std::mem::take(&mut self.sums);
        let near = Extrapolation {
            walls: self.bodies(),
        };
        let wet = |rows| self.may_be_wet(particles, rows);
        pairs.sweep(&near, particles, wet, &mut sums);
        self.sums = sums;
    }

    /// Puts the particles where they are at `time`, s, with their velocities.
    pub(crate) fn place(&mut self, pairs: &Pairs<D>, particles: &mut Particles<D>, time: f64) {
        if self.is_empty() {
            return;
        }
        self.find_rows(particles, pairs.builds());
        if self.start.is_empty() {
            return;
        }
        let domain = pairs.domain();
        for &row in &self.rows {
            let row = row as usize;
            let Some(moved) = self.moved(particles, row, time) else {
                continue;
            };
            let there = &mut particles.position[row];
            *there = image_near(&domain, moved.position, *there);
            particles.velocity[row] = moved.velocity;
        }
    }

    /// How the particle of a row moves at `time`; none for a wall at rest.
    fn moved(&self, particles: &Particles<D>, row: usize, time: f64) -> Option<Moved<D>> {
        let wall = &self.walls[self.wall_of(particles, row)?];
        if wall.motion == Motion::Rest {
            return None;
        }
        let start = self.start[particles.id[row] as usize];
        Some(wall.motion.at(start, time))
    }

    /// Before the forces at `time`, s, in a body force of `gravity`, m/s^2, of walls in their places: pressure,
    /// density, and the velocity that viscous forces see.
    pub(crate) fn prepare(
        &mut self,
        pairs: &mut Pairs<D>,
        particles: &mut Particles<D>,
        equations_of_state: &[Tait],
        gravity: Vector<f64, D>,
        time: f64,
    ) {
        if self.is_empty() {
            return;
        }
        self.time = time;
        self.loads.fill(WallLoad::default());
        self.power = 0.0;
        self.look(pairs, particles);
        for &row in &self.rows {
            let row = row as usize;
            let sum = &self.sums[row];
            let own = equations_of_state[usize::from(particles.fluid[row])];
            let mut pressure = own.background;
            if sum.weight > 0.0 {
                let moved = self.moved(particles, row, time);
                let pull = gravity - moved.map_or(Vector::ZERO, |moved| moved.acceleration);
                // A wall pulls no more than the liquid beside it: above a water line the line goes on below zero,
                // and would draw particles in.
                let beside = sum.pressure / sum.weight;
                let least = beside.min(0.0).max(-self.tension);
                pressure = ((sum.pressure + pull.dot(&sum.head)) / sum.weight).max(least);
                let share = 1.0 / sum.weight;
                let wall = self.wall_of(particles, row).map(|wall| &self.walls[wall]);
                let shear = wall.map_or(Vector::ZERO, |wall| wall.motion.shear(sum.arm * share));
                let v = &mut particles.velocity[row];
                *v = *v * 2.0 - shear - sum.velocity * share;
            }
            particles.pressure[row] = pressure;
            particles.density[row] = own.density(pressure);
        }
    }

    /// What the walls do on the liquid by the last forces, W.
    pub(crate) fn power(&self) -> f64 {
        self.power
    }

    /// Finds the rows of the walls whose pressure balances these forces of pairs.
    pub(crate) fn find_bearing(
        &self,
        particles: &Particles<D>,
        what: Bearing,
        found: &mut Vec<usize>,
    ) {
        let bears = |row: &usize| {
            let wall = self.wall_of(particles, *row).map(|wall| &self.walls[wall]);
            wall.is_some_and(|wall| wall.bearing == what)
        };
        let rows = self.rows.iter().map(|&row| row as usize);
        found.clear();
        found.extend(rows.filter(bears));
    }

    /// Whether any of these rows feels, or exerts, a force.
    pub(crate) fn is_wet(
        &self,
        particles: &Particles<D>,
        mut rows: std::ops::Range<usize>,
    ) -> bool {
        rows.any(|row| self.wall_of(particles, row).is_none() || self.sums[row].weight > 0.0)
    }

    /// Finds volume and contact angle of the wall particles: a right angle where none is given.
    pub(crate) fn find_wetting(&self, particles: &Particles<D>, found: &mut Wetting) {
        if self.is_empty() {
            return;
        }
        for column in [&mut found.volume, &mut found.angle] {
            column.clear();
            column.resize(particles.len(), 0.0);
        }
        for &row in &self.rows {
            let row = row as usize;
            let wall = self.wall_of(particles, row).map(|wall| &self.walls[wall]);
            found.volume[row] = particles.volume(row);
            found.angle[row] = match wall.map(|wall| wall.adhesion) {
                Some(Adhesion::ContactAngle(angle)) => angle,
                _ => FRAC_PI_2,
            };
        }
    }

    /// Makes walls that `which` holds for invisible to sums with the volume of neighbours.
    pub(crate) fn hide(&self, particles: &mut Particles<D>, which: impl Fn(&Wall) -> bool) {
        for &row in &self.rows {
            let row = row as usize;
            if (self.wall_of(particles, row)).is_some_and(|wall| which(&self.walls[wall])) {
                particles.mass[row] = 0.0;
            }
        }
    }

    /// The cosine of the contact angle of a row's wall; none where it is no wall.
    pub(crate) fn wetting(&self, particles: &Particles<D>, row: usize) -> Option<f64> {
        let wall = self.wall_of(particles, row)?;
        Some(match self.walls[wall].adhesion {
            Adhesion::ContactAngle(angle) => angle.cos(),
            Adhesion::None | Adhesion::Coefficient(_) => 0.0,
        })
    }

    /// Undoes [`hide`](Self::hide).
    pub(crate) fn show(&self, particles: &mut Particles<D>) {
        for (&row, &mass) in self.rows.iter().zip(&self.mass) {
            particles.mass[row as usize] = mass;
        }
    }

    /// Takes the walls out of what moves, or accelerates, all particles.
    pub(crate) fn keep(&self, column: &mut [Vector<f64, D>]) {
        for &row in &self.rows {
            column[row as usize] = Vector::ZERO;
        }
    }

    /// After the forces: accelerations, and velocities with which the step's last kick, with
    /// a drag of `damping` (1/s), ends at the wall's own.
    pub(crate) fn finish(
        &self,
        particles: &mut Particles<D>,
        acceleration: &mut [Vector<f64, D>],
        damping: f64,
    ) {
        let recovery = (0.5 * damping * self.step).exp();
        for &row in &self.rows {
            let row = row as usize;
            let (velocity, a) = self
                .moved(particles, row, self.time)
                .map_or((Vector::ZERO, Vector::ZERO), |moved| {
                    (moved.velocity, moved.acceleration)
                });
            acceleration[row] = a;
            particles.velocity[row] = (velocity - a * (0.5 * self.step)) * recovery;
        }
    }
}

/// The image of `point` that is nearest to `near` in a periodic box.
fn image_near<const D: usize>(
    domain: &Domain<D>,
    mut point: Vector<f64, D>,
    near: Vector<f64, D>,
) -> Vector<f64, D> {
    for d in 0..D {
        if let Some((low, high)) = domain.periodic[d] {
            let period = high - low;
            point[d] += ((near[d] - point[d]) / period).round() * period;
        }
    }
    point
}
