"""The cube by PySPH: weakly compressible, continuity, artificial viscosity, and
the surface tension of Morris (2000) by PySPH's own equations, for one liquid with
a free surface. Arguments as for the Rust programs: edge warm_up steps time_step.
The case itself is stated in src/lib.rs.
"""

import json
import sys
import time

import numpy as np
import pysph
from compyle.config import get_config
from pysph.base.kernels import WendlandQuintic
from pysph.base.nnps import LinkedListNNPS
from pysph.base.utils import get_particle_array_wcsph
from pysph.solver.solver import Solver
from pysph.sph.equation import Equation, Group
from pysph.sph.integrator import PECIntegrator
from pysph.sph.integrator_step import WCSPHStep
from pysph.sph.surface_tension import (
    CSFSurfaceTensionForce,
    InterfaceCurvatureFromDensity,
    MorrisColorGradient,
    SmoothedColor,
)
from pysph.sph.wc.basic import MomentumEquation, TaitEOS
from pysph.sph.basic_equations import ContinuityEquation

WIDTH, DENSITY, SURFACE_TENSION, SOUND_SPEED, SUPPORT = 0.01, 1000.0, 0.0728, 5.0, 2.62


class MoveWithVelocity(Equation):
    """What XSPH without its smoothing would be, at no cost per pair."""

    def post_loop(self, d_idx, d_ax, d_ay, d_az, d_u, d_v, d_w):
        d_ax[d_idx] = d_u[d_idx]
        d_ay[d_idx] = d_v[d_idx]
        d_az[d_idx] = d_w[d_idx]


def main():
    edge, warm_up, steps = map(int, sys.argv[1:4])
    time_step = float(sys.argv[4])
    get_config().use_openmp = False
    spacing = WIDTH / edge
    smoothing_length = 0.5 * SUPPORT * spacing
    along = (np.arange(edge) + 0.5) * spacing - 0.5 * WIDTH
    x, y, z = (a.ravel() for a in np.meshgrid(along, along, along, indexing="ij"))
    water = get_particle_array_wcsph(
        name="water", x=x, y=y, z=z, m=DENSITY * spacing**3, rho=DENSITY, h=smoothing_length
    )
    for name in "color scolor cx cy cz nx ny nz ddelta N V kappa wij_sum".split():
        water.add_property(name)
    water.color[:] = 1.0
    water.V[:] = spacing**-3

    def group(*equations):
        return Group(equations=list(equations), real=False)

    own, all_ = "water", ["water"]
    equations = [
        group(
            TaitEOS(own, None, rho0=DENSITY, c0=SOUND_SPEED, gamma=7.0),
            SmoothedColor(own, all_),
        ),
        group(MorrisColorGradient(own, all_, epsilon=0.1 / smoothing_length)),
        group(InterfaceCurvatureFromDensity(own, all_)),
        group(
            ContinuityEquation(own, all_),
            MomentumEquation(own, all_, c0=SOUND_SPEED, alpha=0.1, beta=0.0),
            CSFSurfaceTensionForce(own, None, sigma=SURFACE_TENSION),
            MoveWithVelocity(own, None),
        ),
    ]
    kernel = WendlandQuintic(dim=3)
    solver = Solver(
        dim=3, integrator=PECIntegrator(water=WCSPHStep()), kernel=kernel, dt=time_step, fixed_h=True
    )
    solver.set_disable_output(True)
    solver.set_parallel_manager(None)
    neighbours = LinkedListNNPS(
        dim=3, particles=[water], radius_scale=kernel.radius_scale, fixed_h=True, cache=True
    )
    solver.setup(particles=[water], equations=equations, nnps=neighbours, kernel=kernel, fixed_h=True)

    def march(until):
        solver.set_max_steps(until)
        solver.set_final_time(1.0)
        solver.solve(show_progress=False)

    clock = []
    solver.add_pre_step_callback(lambda solver: clock.append(time.thread_time()))
    march(warm_up + steps + 1)
    seconds = clock[warm_up + steps] - clock[warm_up]

    positions = np.stack([water.x, water.y, water.z], axis=1)
    print(
        json.dumps(
            {
                "version": pysph.__version__,
                "particles": len(positions),
                "steps": steps,
                "seconds": seconds,
                "time_step": time_step,
                "neighbours": mean_neighbours(neighbours, len(positions)),
                "extent": float(np.ptp(positions[:, 0])),
                "farthest": float(np.linalg.norm(positions, axis=1).max()),
            }
        )
    )


def mean_neighbours(neighbours, particles):
    """Mean number of other particles within the support."""
    from cyarray.api import UIntArray

    found, total = UIntArray(), 0
    for i in range(particles):
        neighbours.get_nearest_particles(0, 0, i, found)
        total += found.length
    # Each particle has met itself.
    return total / particles - 1.0


if __name__ == "__main__":
    main()
