//! A van der Waals fluid: a liquid whose surface tension comes from its own cohesion, as the
//! molecules' does. Nugent and Posch (2000), Phys. Rev. E 62, 4968; Sigalotti, Daza and Donoso
//! (2006), Condens. Matter Phys. 9, 359, with corrections that the files name.
//!
//! The pressure is split in two. The repulsive part acts over the smoothing length h, as a stress
//! together with viscosity; the cohesive part acts over a longer range H, and is a potential
//! energy of pairs. Deep inside it is the pressure -a rho^2; at a surface it is also the tension.
//!
//! - [`substance`]: equation of state, in SI and by the critical point
//! - [`model`]: all that a scheme states of such a fluid
//! - [`gradient`]: gradients of velocity and temperature
//! - [`heat`]: what it warms, and conduction
//! - [`cohesion`]: the force between far pairs, and its energy
//! - [`flow`]: their order in a step

pub mod cohesion;
pub mod flow;
pub mod gradient;
pub mod heat;
pub mod model;
pub mod substance;

pub use flow::Flow;
pub use model::{Conduction, VanDerWaals};
pub use substance::Substance;
