//! The cube by salva: implicit pressure, and the surface tension of Akinci
//! et al. (2013), with coefficients and units of length (1 dm) and density of
//! its own example of a droplet. A fifth argument names the pressure solver,
//! dfsph (default) or iisph; a sixth the support in spacings, if not that of
//! the others.

use cpu_time::ThreadTime;
use nalgebra::Vector3;
use peers::{Case, DENSITY, SUPPORT};
use salva3d::LiquidWorld;
use salva3d::kernel::CubicSplineKernel;
use salva3d::object::{Fluid, interaction_groups::InteractionGroups};
use salva3d::solver::{Akinci2013SurfaceTension, ArtificialViscosity, DFSPHSolver, IISPHSolver};

/// Its units of length in a metre.
const UNIT: f64 = 10.0;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let case = Case::from_arguments()?;
    let radius = (0.5 * case.spacing() * UNIT) as f32;
    // Its kernel radius is this factor times the diameter of a particle.
    let support = case.rest.get(1).map_or(Ok(SUPPORT), |text| text.parse())?;
    let factor = support as f32;
    let mut world = match case.rest.first().map(String::as_str) {
        None | Some("dfsph") => LiquidWorld::new(
            DFSPHSolver::<CubicSplineKernel, CubicSplineKernel>::new(),
            radius,
            factor,
            1.0,
        ),
        Some("iisph") => LiquidWorld::new(
            IISPHSolver::<CubicSplineKernel, CubicSplineKernel>::new(),
            radius,
            factor,
            1.0,
        ),
        Some(other) => return Err(format!("solver is '{other}'; wanted: dfsph, iisph").into()),
    };
    let positions = (case.lattice().into_iter())
        .map(|x| Vector3::from(x.map(|x| (x * UNIT) as f32)))
        .collect();
    let mut fluid = Fluid::new(
        positions,
        radius,
        DENSITY as f32,
        InteractionGroups::default(),
    );
    fluid
        .nonpressure_forces
        .push(Box::new(Akinci2013SurfaceTension::new(1.0, 0.0)));
    fluid
        .nonpressure_forces
        .push(Box::new(ArtificialViscosity::new(0.01, 0.01)));
    let handle = world.add_fluid(fluid);
    let mut march = |steps: usize| {
        (0..steps).for_each(|_| world.step(case.time_step as f32, &Vector3::zeros()))
    };
    march(case.warm_up);
    let start = ThreadTime::now();
    march(case.steps);
    let seconds = start.elapsed().as_secs_f64();
    let fluid = world.fluids().get(handle).ok_or("salva lost its fluid")?;
    let positions: Vec<_> = (fluid.positions.iter())
        .map(|x| [x.x, x.y, x.z].map(|x| f64::from(x) / UNIT))
        .collect();
    case.report("0.11.0", seconds, support, &positions);
    Ok(())
}
