//! Flows between walls, against what is known of them.

#[path = "../common/mod.rs"]
mod common;

mod budget;
mod channel;
mod density_diffusion;
mod energy;
mod hydrostatics;
mod layout;
mod march;
mod mesh;
mod piston;
mod setups;
