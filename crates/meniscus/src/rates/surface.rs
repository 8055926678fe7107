//! Forces by surface tension.

use super::Rates;
use crate::domain::Domain;
use crate::pairs::Pairs;
use crate::particles::Particles;
use crate::physics::surface_tension::SurfaceTension;
use crate::physics::surface_tension::balanced;
use crate::physics::surface_tension::bodies::Bodies;
use crate::physics::surface_tension::capillary_pressure::{
    self, CapillaryPressure, Closeness, Load, Order,
};
use crate::physics::surface_tension::continuum::{FlatLayer, Relist, Surroundings};
use crate::physics::surface_tension::mesh;
use crate::physics::surface_tension::surface::Surface;
use crate::physics::surface_tension::total_variation;
use crate::scheme::Bearing;
use crate::term::Sweep;
use crate::vector::Vector;
use crate::walls::Walls;

/// Which body each row belongs to, as of the last lists.
#[derive(Debug, Default)]
pub(super) struct FreeBodies {
    /// Of all rows.
    groups: Vec<u32>,
    /// Of those that no wall holds; for the others beyond `count`.
    of_row: Vec<u32>,
    count: usize,
    built: Option<u64>,
}

impl FreeBodies {
    /// Finds them anew where lists are new: those of the liquid, and of walls too where these `join` what
    /// they touch, and which of them no wall holds.
    fn find<const D: usize>(
        &mut self,
        pairs: &Pairs<D>,
        support: f64,
        particles: &Particles<D>,
        walls: &Walls<D>,
        join: bool,
    ) {
        if self.built.replace(pairs.builds()) == Some(pairs.builds()) {
            return;
        }
        let is_wall = |row: usize| walls.is_wall(particles.body[row]);
        (self.groups, self.count) = pairs.bodies(support, |row| join || !is_wall(row));
        self.of_row.clone_from(&self.groups);
        let mut held = vec![false; self.count];
        for (row, &of) in self.groups.iter().enumerate() {
            if let Some(held) = held.get_mut(of as usize) {
                *held |= is_wall(row);
            }
        }
        for of in &mut self.of_row {
            if held.get(*of as usize) == Some(&true) {
                *of = u32::MAX;
            }
        }
    }
}

impl<const D: usize> Rates<D> {
    /// Adds the acceleration by surface tension, m/s^2.
    pub(super) fn pull_surface(
        &mut self,
        particles: &mut Particles<D>,
        acceleration: &mut [Vector<f64, D>],
    ) {
        let smoothing_length = self.scheme.smoothing_length;
        match self.scheme.surface_tension {
            Some(SurfaceTension::JancikHyhlik(model)) => model.accelerate(
                &mut self.pairs,
                particles,
                smoothing_length,
                |i| self.fluids[particles.fluid[i] as usize].surface_tension,
                &mut self.surface,
                acceleration,
            ),
            Some(SurfaceTension::Continuum(model)) => {
                let surroundings = Surroundings {
                    fluids: &self.fluids,
                    smoothing_length,
                };
                if !self.surface.is_calibrated() {
                    let spacing = self.spacing;
                    let support = self.scheme.kernel.support() * smoothing_length;
                    let mut layer = FlatLayer::new(surroundings, support, spacing);
                    let periodic = layer.periodic;
                    let domain = Domain { periodic };
                    let mut pairs = self.pairs.sibling(smoothing_length, spacing, domain);
                    pairs.relist(&mut layer.particles);
                    model.calibrate(&mut pairs, &layer, surroundings, &mut self.surface);
                }
                model.accelerate(
                    &mut self.pairs,
                    &mut self.at_surface,
                    particles,
                    surroundings,
                    &mut self.surface,
                    acceleration,
                );
            }
            Some(SurfaceTension::Balanced(model)) => {
                let support = self.scheme.kernel.support() * smoothing_length;
                self.free
                    .find(&self.pairs, support, particles, &self.walls, false);
                let surroundings = balanced::Surroundings {
                    surface_tension: self.fluids[0].surface_tension,
                    kernel: self.scheme.kernel,
                    smoothing_length,
                    spacing: self.spacing,
                    bodies: Bodies {
                        of_row: &self.free.of_row,
                        count: self.free.count,
                        domain: self.pairs.domain(),
                    },
                    wetting: &self.wetting,
                };
                model.accelerate(
                    &mut self.pairs,
                    particles,
                    surroundings,
                    &mut self.surface,
                    acceleration,
                );
            }
            Some(SurfaceTension::TotalVariation(model)) => {
                self.on_mesh(
                    particles,
                    total_variation::REACH,
                    |surroundings, surface| {
                        model.accelerate(particles, surroundings, surface, acceleration);
                    },
                );
            }
            Some(SurfaceTension::CapillaryPressure(_)) => {
                self.surface.add_to(&particles.density, acceleration);
                let fluid = &self.fluids[0];
                let closeness = Closeness::new(
                    fluid.surface_tension,
                    fluid.density,
                    self.spacing,
                    self.walls.bodies(),
                );
                if let Some(near) = self.pairs.second() {
                    near.sweep(&closeness, particles, |_| true, &mut self.vectors);
                    for (a, push) in acceleration.iter_mut().zip(&self.vectors) {
                        *a += *push;
                    }
                }
            }
            Some(SurfaceTension::Pairwise(_)) | None => {}
        }
    }

    /// Calls for what a model on a mesh acts in, whose particles know of each other within `reach` spacings.
    fn on_mesh(
        &mut self,
        particles: &Particles<D>,
        reach: f64,
        act: impl FnOnce(&mesh::Surroundings<'_, D>, &mut Surface<D>),
    ) {
        let (spacing, walls) = (self.spacing, &self.walls);
        (self.free).find(&self.pairs, reach * spacing, particles, walls, true);
        let (count, domain) = (self.free.count, self.pairs.domain());
        let bodies = |of_row| Bodies {
            of_row,
            count,
            domain,
        };
        let surroundings = mesh::Surroundings {
            surface_tension: self.fluids[0].surface_tension,
            density: self.fluids[0].density,
            spacing,
            groups: bodies(&self.free.groups),
            free: bodies(&self.free.of_row),
            wall: &|row| walls.wetting(particles, row),
        };
        act(&surroundings, &mut self.surface);
    }

    /// Surface tension, N/m, where it is a capillary pressure.
    pub(super) fn capillary_tension(&self) -> Option<f64> {
        let Some(SurfaceTension::CapillaryPressure(_)) = self.scheme.surface_tension else {
            return None;
        };
        Some(self.fluids[0].surface_tension).filter(|&sigma| sigma != 0.0)
    }

    /// Finds kappa of capillary pressure, where the model does, into the surface's curvature. Returns sigma, N/m.
    pub(super) fn find_capillary_pressure(&mut self, particles: &Particles<D>) -> Option<f64> {
        let sigma = self.capillary_tension()?;
        self.on_mesh(
            particles,
            capillary_pressure::REACH,
            |surroundings, surface| CapillaryPressure.find(particles, surroundings, surface),
        );
        Some(sigma)
    }

    /// Keeps the pressure of walls, p - q, from what it does along them at contact lines.
    pub(super) fn slide(&mut self, particles: &Particles<D>, acceleration: &mut [Vector<f64, D>]) {
        let surface = &self.surface;
        let near = |rows| Order::is_beside_wall(surface, rows);
        self.walls
            .slide(&mut self.pairs, particles, near, acceleration);
    }

    /// Adds capillary pressure to what density gives, p - q, and what walls bear of it to their accelerations, m/s^2.
    pub(super) fn add_capillary_pressure(
        &mut self,
        sigma: f64,
        particles: &mut Particles<D>,
        acceleration: &mut [Vector<f64, D>],
    ) {
        for (pressure, curvature) in particles.pressure.iter_mut().zip(&self.surface.curvature) {
            *pressure += sigma * curvature;
        }
        if self.walls.is_empty() {
            return;
        }
        let load = Load {
            curvature: &self.surface.curvature,
            surface_tension: sigma,
            walls: self.walls.bodies(),
        };
        let walls = &self.walls;
        let of_wet_wall = |rows| walls.has_wet_wall(particles, rows);
        (self.pairs).sweep(&load, particles, of_wet_wall, &mut self.vectors);
        for (row, a) in acceleration.iter_mut().enumerate() {
            if walls.is_wall(particles.body[row]) {
                *a += self.vectors[row] * (1.0 / particles.density[row]);
                *a += self.surface.borne[row] * (1.0 / particles.mass[row]);
            }
        }
    }

    /// Adds to the pressure of walls what balances the forces of pairs on the fluid near them.
    pub(super) fn press_walls(&mut self, particles: &mut Particles<D>) {
        let Some(pull) = &mut self.pull else {
            return;
        };
        let builds = self.pairs.builds();
        let mut rows = std::mem::take(&mut self.bearing);
        for bearing in [Bearing::Adhesion, Bearing::Pairs] {
            self.walls.find_bearing(particles, bearing, &mut rows);
            if rows.is_empty() {
                continue;
            }
            pull.charge(&mut self.pairs, particles, builds);
            let cohesion = bearing == Bearing::Pairs;
            pull.press_walls(&mut self.pairs, particles, cohesion, &rows);
            for &row in &rows {
                let equation = self.equations_of_state[usize::from(particles.fluid[row])];
                particles.density[row] = equation.density(particles.pressure[row]);
            }
        }
        self.bearing = rows;
    }

    /// Adds the acceleration by forces of pairs, walls among them, m/s^2.
    pub(super) fn pull_pairs(
        &mut self,
        particles: &mut Particles<D>,
        acceleration: &mut [Vector<f64, D>],
    ) {
        let Some(pull) = &mut self.pull else {
            return;
        };
        let builds = self.pairs.builds();
        pull.charge(&mut self.pairs, particles, builds);
        if pull.has_curvature() {
            self.walls.hide(particles, |_| true);
            pull.find_normals(&mut self.pairs, particles);
            self.walls.show(particles);
        }
        pull.accelerate(&mut self.pairs, particles, &mut self.surface, acceleration);
    }

    /// The square of the largest frequency of stiff forces, 1/s^2, where the largest acceleration
    /// is `largest`, m/s^2.
    pub(crate) fn stiffness(&self, largest: f64) -> f64 {
        (self.pull.as_ref()).map_or(0.0, |pull| pull.stiffness(largest))
    }

    /// Part of the acceleration of row `i` that surface tension made, m/s^2.
    pub(crate) fn surface_acceleration(
        &self,
        particles: &Particles<D>,
        i: usize,
    ) -> Vector<f64, D> {
        let force = self.surface.force.get(i).copied().unwrap_or_default();
        force * (1.0 / particles.density[i])
    }
}

impl<const D: usize> Relist<D> for Pairs<D> {
    fn relist(&mut self, particles: &mut Particles<D>) {
        self.rebuild(particles);
    }
}
