//! The forces of a model in a step.

use super::Pairwise;
use super::estimate::Resolution;
use super::term::{Charge, Head, PairwiseTerm, Pulled, VolumeGradient};
use crate::fluid::Fluid;
use crate::particles::Particles;
use crate::physics::surface_tension::gradient::Smoothed;
use crate::physics::surface_tension::surface::Surface;
use crate::physics::wall::{Adhesion, Wall};
use crate::term::{Pair, PairTerm, Record, Sweep};
use crate::vector::Vector;

/// A model made ready for the fluids and walls of a flow.
#[derive(Debug)]
pub(crate) struct Pull<const D: usize> {
    model: Pairwise,
    resolution: Resolution,
    /// Root of G, and density at rest, of each fluid.
    fluids: Vec<(f64, f64)>,
    /// Of each body, for a wall: B, and whether Psi is of how densely it is sampled, or the mass.
    walls: Vec<Option<(f64, bool)>>,
    charges: Vec<Charge>,
    /// Of how many lists the charges are.
    built: Option<u64>,
    weights: Vec<f64>,
    normals: Vec<Vector<f64, D>>,
    sums: Vec<Pulled<f64, D>>,
    /// Whether these are of all forces, with the particles where they are.
    summed: bool,
    heads: Vec<(f64, f64)>,
}

impl<const D: usize> Pull<D> {
    pub(crate) fn new(
        model: Pairwise,
        resolution: Resolution,
        fluids: &[Fluid],
        walls: &[Wall],
        particles: &Particles<D>,
    ) -> Self {
        let charge = |fluid| (model.strength(fluid, &resolution).sqrt(), fluid.density);
        let bodies = walls.iter().map(|wall| usize::from(wall.body) + 1).max();
        let mut of_walls = vec![None; bodies.unwrap_or(0)];
        for wall in walls {
            let first = particles.body.iter().position(|&body| body == wall.body);
            let fluid = &fluids[first.map_or(0, |row| usize::from(particles.fluid[row]))];
            let strength =
                wall.adhesion_factor * model.adhesion_strength(wall.adhesion, fluid, &resolution);
            let sampled = matches!(wall.adhesion, Adhesion::Coefficient(_));
            of_walls[usize::from(wall.body)] = Some((strength, sampled));
        }
        Self {
            fluids: fluids.iter().map(charge).collect(),
            model,
            resolution,
            walls: of_walls,
            charges: Vec::new(),
            built: None,
            weights: Vec::new(),
            normals: Vec::new(),
            sums: Vec::new(),
            summed: false,
            heads: Vec::new(),
        }
    }

    /// B and Psi of a particle's wall; none for a fluid.
    fn wall(&self, particles: &Particles<D>, row: usize) -> Option<(f64, bool)> {
        let wall = self.walls.get(usize::from(particles.body[row]));
        wall.copied().flatten()
    }

    /// What each particle brings, where particles were sorted anew: `builds` counts their lists.
    pub(crate) fn charge(
        &mut self,
        sweep: &mut impl Sweep<D>,
        particles: &Particles<D>,
        builds: u64,
    ) {
        if self.built.replace(builds) == Some(builds) {
            return;
        }
        let rows = 0..particles.len();
        if self.walls.iter().flatten().any(|wall| wall.1) {
            let is_wall: Vec<f64> = (rows.clone())
                .map(|row| f64::from(u8::from(self.wall(particles, row).is_some())))
                .collect();
            let term = Smoothed { weighted: &is_wall };
            let near = |rows: std::ops::Range<usize>| is_wall[rows].contains(&1.0);
            sweep.sweep(&term, particles, near, &mut self.weights);
        } else {
            self.weights.clear();
        }
        let mut charges = std::mem::take(&mut self.charges);
        charges.clear();
        charges.extend(rows.map(|row| {
            let (cohesion, rest_density) = self.fluids[usize::from(particles.fluid[row])];
            let Some((strength, sampled)) = self.wall(particles, row) else {
                return Charge {
                    cohesion,
                    is_fluid: 1.0,
                    wetting: 0.0,
                    rest_density,
                };
            };
            let share = match self.weights.get(row) {
                Some(weight) if sampled => rest_density / (weight * particles.mass[row]),
                _ => 1.0,
            };
            Charge {
                wetting: strength * share,
                rest_density,
                ..Charge::default()
            }
        }));
        self.charges = charges;
    }

    /// Whether normals are part of the model.
    pub(crate) fn has_curvature(&self) -> bool {
        self.model.curvature_of_one(&self.resolution) != (0.0, 0.0)
    }

    /// n of each particle, from the fluid alone: walls must be hidden.
    pub(crate) fn find_normals(&mut self, sweep: &mut impl Sweep<D>, particles: &Particles<D>) {
        sweep.sweep(&VolumeGradient, particles, |_| true, &mut self.normals);
        let support = self.resolution.support();
        self.normals.iter_mut().for_each(|n| *n = *n * support);
    }

    fn term(&self) -> PairwiseTerm<'_, D> {
        PairwiseTerm {
            model: self.model,
            support: self.resolution.support(),
            cohesion: true,
            deficiency: self.model.akinci().is_some(),
            curvature: self.model.curvature_of_one(&self.resolution),
            charges: &self.charges,
            normals: &self.normals,
        }
    }

    /// Adds to the pressure of the wall particles in `rows` what balances the adhesion of the fluid
    /// near them, after Gonzalez, eq. 4.7, and its `cohesion` too if asked for:
    /// sum_f rho_f a_f . x_wf W_wf / sum_f W_wf, where a_f, the fluid's acceleration by these
    /// forces, belongs inside the sum. The print has it outside, and as a force. No pressure is
    /// below zero.
    pub(crate) fn press_walls(
        &mut self,
        sweep: &mut impl Sweep<D>,
        particles: &mut Particles<D>,
        cohesion: bool,
        rows: &[usize],
    ) {
        let mut sums = std::mem::take(&mut self.sums);
        let term = PairwiseTerm {
            cohesion,
            curvature: (0.0, 0.0),
            normals: &[],
            ..self.term()
        };
        sweep.sweep(&term, particles, |_| true, &mut sums);
        // A wall's pressure and density change none of them.
        self.summed = cohesion && !self.has_curvature();
        let term = Head {
            model: self.model,
            charges: &self.charges,
            pulled: &sums,
        };
        let near_wall =
            |rows: std::ops::Range<usize>| self.charges[rows].iter().any(|c| c.is_fluid == 0.0);
        sweep.sweep(&term, particles, near_wall, &mut self.heads);
        for &row in rows {
            let (head, weight) = self.heads[row];
            if weight > 0.0 {
                let pressure = &mut particles.pressure[row];
                *pressure = (*pressure + head / weight).max(0.0);
            }
        }
        self.sums = sums;
    }

    /// Adds the acceleration by all forces, m/s^2; the virial pressure goes to `surface`.
    pub(crate) fn accelerate(
        &mut self,
        sweep: &mut impl Sweep<D>,
        particles: &Particles<D>,
        surface: &mut Surface<D>,
        acceleration: &mut [Vector<f64, D>],
    ) {
        let mut sums = std::mem::take(&mut self.sums);
        if !std::mem::take(&mut self.summed) {
            sweep.sweep(&self.term(), particles, |_| true, &mut sums);
        }
        surface.force.clear();
        surface.virial_pressure.clear();
        for (row, sum) in sums.iter().enumerate() {
            let share = self.model.share(particles.mass[row]);
            let (pull, density) = (sum.acceleration * share, particles.density[row]);
            acceleration[row] += pull;
            // The force on a wall is what it bears; its density is no fluid's.
            let fluid = self.charges[row].is_fluid;
            surface.force.push(pull * (density * fluid));
            let virial = sum.virial * share * density / (2.0 * D as f64);
            surface.virial_pressure.push(fluid * virial);
        }
        surface.net_force = surface.sum_of_forces(particles);
        self.sums = sums;
    }

    /// The force of row `j` on row `i`, N, by what pairs have drawn in the last sums.
    pub(crate) fn force_between(
        &self,
        particles: &Particles<D>,
        [i, j]: [usize; 2],
        pair: &Pair<f64, D>,
    ) -> Vector<f64, D> {
        let term = self.term();
        let (own, other) = (term.record(particles, i), term.record(particles, j));
        let mut sum = Pulled::<f64, D>::read(&mut || 0.0);
        term.pair(&own, &other, pair, &mut sum);
        let share = self.model.share(particles.mass[i]);
        sum.acceleration * (share * particles.mass[i])
    }

    /// The square of the largest frequency, 1/s^2, of particles that swing by these forces, where
    /// it is not slow against the sound that the particles carry; zero else.
    pub(crate) fn stiffness(&self, largest_acceleration: f64) -> f64 {
        let Pairwise::LennardJones(model) = self.model else {
            return 0.0;
        };
        let strongest = (self.fluids.iter())
            .map(|(root, density)| root * root * density * self.resolution.spacing.powi(D as i32))
            .fold(0.0, f64::max);
        model.stiffness(strongest, largest_acceleration, D)
    }
}
