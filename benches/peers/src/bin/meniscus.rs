//! The cube by Meniscus: weakly compressible, continuity, artificial
//! viscosity, and the free-surface CSF force of Jancik and Hyhlik.
//! A fifth argument names the instructions: best (default), avx2, portable.

use cpu_time::ThreadTime;
use meniscus::pairs::Instructions;
use meniscus::scheme::TimeStep;
use meniscus::{Domain, Fluid, Particle, Scheme, Setup, Simulation, SurfaceTension, Vector};
use peers::{Case, DENSITY, SOUND_SPEED, SUPPORT, SURFACE_TENSION};

fn main() -> Result<(), Box<dyn std::error::Error + Send + Sync>> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
    pool.install(run)
}

fn run() -> Result<(), Box<dyn std::error::Error + Send + Sync>> {
    let case = Case::from_arguments()?;
    let spacing = case.spacing();
    let mut water = Fluid::new("water", DENSITY);
    water.surface_tension = SURFACE_TENSION;
    water.sound_speed = SOUND_SPEED;
    let particles = (case.lattice().into_iter())
        .map(|position| Particle {
            position: Vector(position),
            velocity: Vector([0.0; 3]),
            mass: DENSITY * spacing.powi(3),
            fluid: 0,
            body: 0,
        })
        .collect();
    let mut scheme = Scheme::new(0.5 * SUPPORT * spacing);
    scheme.surface_tension = Some(SurfaceTension::default());
    scheme.time_step = TimeStep::Fixed(case.time_step);
    let mut simulation = Simulation::new(Setup {
        scheme,
        fluids: vec![water],
        particles,
        spacing,
        domain: Domain::default(),
    })?;
    let instructions = match case.rest.first().map(String::as_str) {
        None | Some("best") => Instructions::Best,
        Some("avx2") => Instructions::Avx2,
        Some("portable") => Instructions::Portable,
        Some(other) => {
            return Err(format!("instructions are '{other}'; wanted: best, avx2, portable").into());
        }
    };
    simulation.set_instructions(instructions);
    for _ in 0..case.warm_up {
        simulation.step().map_err(|error| error.to_string())?;
    }
    let start = ThreadTime::now();
    for _ in 0..case.steps {
        simulation.step().map_err(|error| error.to_string())?;
    }
    let seconds = start.elapsed().as_secs_f64();
    let positions: Vec<_> = simulation
        .particles()
        .position
        .iter()
        .map(|x| x.0)
        .collect();
    case.report("in this repository", seconds, SUPPORT, &positions);
    Ok(())
}
