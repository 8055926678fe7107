//! A van der Waals fluid in the march. The temperature is kicked as velocity is, with half a
//! step's heat at either end: the heat of the mean velocity of the kick, so that what the stress
//! takes from the motion it gives to the heat, to rounding, at any time step. Cohesion has a
//! potential; its share of the energy returns as that of any symplectic march does.
//!
//! The stress is worked out with the velocity and temperature that the end of the step will have,
//! foretold from half of it by the last rates. Pressure that lagged behind temperature would make
//! sound grow.

use super::cohesion::{Cohesion, Surrounding};
use super::gradient::{GradientSums, Gradients};
use super::heat::{Heat, Warmth};
use super::model::{Conduction, VanDerWaals};
use crate::kernel::Kernel;
use crate::particles::Particles;
use crate::physics::stress_divergence::{StressDivergence, Weight};
use crate::physics::surface_tension::matrix::Matrix;
use crate::term::Sweep;
use crate::vector::Vector;

/// The fluid and the columns that a step needs.
#[derive(Debug)]
pub struct Flow<const D: usize> {
    model: VanDerWaals,
    /// eta, Pa s
    viscosity: f64,
    velocity: Vec<Vector<f64, D>>,
    temperature: Vec<f64>,
    surroundings: Vec<Surrounding<f64, D>>,
    gradients: Vec<GradientSums<f64, D>>,
    stress: Vec<Matrix<f64, D>>,
    flux: Vec<Vector<f64, D>>,
    pushes: Vec<Vector<f64, D>>,
    warmth: Vec<Warmth<f64, D>>,
    /// What is left of the step to kick, s
    half_step: f64,
}

/// The largest of what limits a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stiffness {
    /// Speed of short sound waves, m/s
    pub sound_speed: f64,
    /// Diffusion of momentum, m^2/s
    pub viscous_diffusivity: f64,
    /// Diffusion of heat, m^2/s
    pub thermal_diffusivity: f64,
}

impl<const D: usize> Flow<D> {
    /// Of a fluid with this shear viscosity, Pa s.
    pub fn new(model: VanDerWaals, viscosity: f64) -> Self {
        Self {
            model,
            viscosity,
            velocity: Vec::new(),
            temperature: Vec::new(),
            surroundings: Vec::new(),
            gradients: Vec::new(),
            stress: Vec::new(),
            flux: Vec::new(),
            pushes: Vec::new(),
            warmth: Vec::new(),
            half_step: 0.0,
        }
    }

    /// Cohesion, and the pressure at the end of a step of `dt` seconds, of which half is left to
    /// kick; `far` sums over the range of cohesion.
    pub fn prepare(&mut self, far: &mut impl Sweep<D>, particles: &mut Particles<D>, dt: f64) {
        far.sweep(&Cohesion, particles, |_| true, &mut self.surroundings);
        self.half_step = 0.5 * dt;
        self.foretell_velocity(particles, &particles.acceleration);
        self.temperature.clear();
        self.temperature.extend(
            (particles.temperature.iter().zip(&particles.heating))
                .map(|(temperature, rate)| temperature + self.half_step * rate),
        );
        let substance = &self.model.substance;
        let state = particles.density.iter().zip(&self.temperature);
        for (pressure, (&density, &temperature)) in particles.pressure.iter_mut().zip(state) {
            *pressure = substance.pressure(density, temperature);
        }
    }

    fn foretell_velocity(&mut self, particles: &Particles<D>, acceleration: &[Vector<f64, D>]) {
        self.velocity.clear();
        self.velocity.extend(
            (particles.velocity.iter().zip(acceleration))
                .map(|(v, a)| v.add_scaled(*a, self.half_step)),
        );
    }

    /// Acceleration, m/s^2, as [`prepare`](Self::prepare) left the particles.
    pub fn accelerate(
        &mut self,
        near: &mut impl Sweep<D>,
        particles: &Particles<D>,
        acceleration: &mut Vec<Vector<f64, D>>,
    ) {
        let term = Gradients {
            velocity: &self.velocity,
            temperature: &self.temperature,
        };
        near.sweep(&term, particles, |_| true, &mut self.gradients);
        self.find_stress(particles);
        let term = StressDivergence {
            stress: &self.stress,
            weight: Weight::Mass,
        };
        near.sweep(&term, particles, |_| true, &mut self.pushes);
        let strength = 2.0 * self.model.substance.cohesion;
        acceleration.clear();
        acceleration.extend(
            (self.pushes.iter().zip(&self.surroundings))
                .map(|(push, far)| push.add_scaled(far.gradient, strength)),
        );
    }

    /// Heating, K/s, and what a change of velocity adds to it, K/s^2, once the whole
    /// acceleration is known.
    pub fn heat(
        &mut self,
        near: &mut impl Sweep<D>,
        particles: &mut Particles<D>,
        acceleration: &[Vector<f64, D>],
    ) {
        self.foretell_velocity(particles, acceleration);
        let pairwise = self.model.conduction == Conduction::Brookshaw;
        let term = Heat {
            stress: &self.stress,
            flux: &self.flux,
            velocity: &self.velocity,
            acceleration,
            temperature: &self.temperature,
            conductivity: if pairwise {
                self.model.conductivity
            } else {
                0.0
            },
        };
        near.sweep(&term, particles, |_| true, &mut self.warmth);
        let per_heat = 1.0 / self.model.substance.heat_capacity();
        let rates = (particles.heating.iter_mut()).zip(&mut particles.heating_gain);
        for ((heating, gain), sum) in rates.zip(&self.warmth) {
            *heating = sum.heat * per_heat;
            *gain = sum.gain * per_heat;
        }
    }

    /// S / rho^2 and q / rho^2 of each particle (Sigalotti, Daza and Donoso, eqs. 3 and 5), with the repulsive
    /// part p of the pressure alone: S = -p I + eta (G + G^T) + (zeta - 2/D eta) trace(G) I.
    fn find_stress(&mut self, particles: &Particles<D>) {
        let VanDerWaals {
            substance,
            conductivity,
            bulk_viscosity,
            conduction,
            ..
        } = self.model;
        let expansion = bulk_viscosity - 2.0 / D as f64 * self.viscosity;
        let printed = conduction == Conduction::DoubleSum;
        self.stress.clear();
        self.flux.clear();
        for (i, sum) in self.gradients.iter().enumerate() {
            let density = particles.density[i];
            let pressure = substance.repulsion(density, self.temperature[i]);
            let square = 1.0 / (density * density);
            let per_gradient = square / density;
            let gradient = &sum.velocity;
            let diagonal = expansion * gradient.trace() * per_gradient - pressure * square;
            let mut stress = Matrix::diagonal(diagonal);
            for d in 0..D {
                for e in 0..D {
                    let shear = gradient.0[d][e] + gradient.0[e][d];
                    stress.0[d][e] += self.viscosity * shear * per_gradient;
                }
            }
            self.stress.push(stress);
            self.flux.push(if printed {
                sum.temperature * (-conductivity * per_gradient)
            } else {
                Vector::ZERO
            });
        }
    }

    /// What the fluid is.
    pub fn model(&self) -> &VanDerWaals {
        &self.model
    }

    /// Internal energy of row `i`, J/kg: xi/2 R T - a rho^H.
    pub fn internal_energy(&self, particles: &Particles<D>, i: usize) -> f64 {
        let heat = self.model.substance.heat_capacity() * particles.temperature[i];
        heat + self.cohesion_energy(i)
    }

    /// Its part -a rho^H, J/kg.
    pub fn cohesion_energy(&self, i: usize) -> f64 {
        -self.model.substance.cohesion * self.surroundings[i].density
    }

    /// The parts of the acceleration of row `i`, m/s^2: by the stress, and by cohesion.
    pub fn parts(&self, i: usize) -> [Vector<f64, D>; 2] {
        let strength = 2.0 * self.model.substance.cohesion;
        let far = self.surroundings[i].gradient * strength;
        [self.pushes[i], far]
    }

    /// The force between two rows at rest that are `r` metres apart, N, positive where they repel each other, by this
    /// kernel and the scheme's smoothing length, m; without grad-h terms.
    pub fn force_at_rest(
        &self,
        particles: &Particles<D>,
        kernel: Kernel,
        smoothing_length: f64,
        [i, j]: [usize; 2],
        r: f64,
    ) -> f64 {
        let own = 0.5 * (particles.smoothing_length[i] + particles.smoothing_length[j]);
        let of_cohesion = if self.model.cohesion_adapts {
            own
        } else {
            smoothing_length
        };
        let substance = &self.model.substance;
        let over_square = |i: usize| {
            let density = particles.density[i];
            substance.repulsion(density, particles.temperature[i]) / (density * density)
        };
        let near = (over_square(i) + over_square(j)) * kernel.slope(r, own, D);
        let long = self.model.cohesion_range * of_cohesion;
        let far = 2.0 * substance.cohesion * kernel.slope(r, long, D);
        particles.mass[i] * particles.mass[j] * (far - near)
    }

    /// No forces act beyond this, m, by this kernel and the scheme's smoothing length, m.
    pub fn range(&self, particles: &Particles<D>, kernel: Kernel, smoothing_length: f64) -> f64 {
        let lengths = particles.smoothing_length.iter().copied();
        kernel.support() * self.model.cohesion_range * lengths.fold(smoothing_length, f64::max)
    }

    /// What limits the next step.
    pub fn stiffness(&self, particles: &Particles<D>) -> Stiffness {
        let model = &self.model;
        let substance = &model.substance;
        let mut least = f64::INFINITY;
        let mut sound_speed: f64 = 0.0;
        for (&density, &temperature) in particles.density.iter().zip(&particles.temperature) {
            least = least.min(density);
            sound_speed = sound_speed.max(substance.stiff_sound_speed(density, temperature));
        }
        Stiffness {
            sound_speed,
            viscous_diffusivity: (2.0 * self.viscosity + model.bulk_viscosity) / least,
            thermal_diffusivity: model.conductivity / (least * substance.heat_capacity()),
        }
    }
}
