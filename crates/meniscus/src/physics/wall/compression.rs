//! How a wall compresses the fluid that moves against it.
//!
//! The sum of continuity over a wall's particles, with the wall's own velocity, finds half of the
//! volume that the wall takes from the fluid. The other half goes with the pressure of the wall's
//! particles: that is the fluid's, by eq. 27 ([`super`]), so what it does in work must go
//! into the compression of the very particles that it was taken from:
//!
//! D rho_f / Dt += rho_f / V_f sum_w (W_fw / sum_k W_kw) V_w sum_k V_k (v_k - v_w) . grad W_kw
//!
//! over wall particles w and their fluid neighbours k. It is the adjoint of eq. 27: with it the
//! power of a wall's pressure is the rate of elastic energy. Doubling continuity's own sum, or
//! mirrored velocities, compress as much, but feed waves of sound and of the scale of particles
//! along a wall (found by trying both in a tank at rest). A wall that pushes alone, whose pressure has been cut off at zero,
//! does no such work.

use crate::particles::Particles;
use crate::physics::surface_tension::gradient::Smoothed;
use crate::term::Sweep;

/// Columns that the sum above needs on its way.
#[derive(Debug, Default)]
pub struct Compression {
    /// Per row: 1 for fluid, 0 for a wall; then what the wall has for the fluid.
    weighted: Vec<f64>,
    sums: Vec<f64>,
}

impl Compression {
    /// Completes (1/rho) D rho / Dt, 1/s, of the fluid by what the sums of continuity have for the
    /// rows of walls; those that `pull` do so whatever their pressure.
    pub fn complete<const D: usize>(
        &mut self,
        sweep: &mut impl Sweep<D>,
        particles: &Particles<D>,
        walls: &[u32],
        pull: bool,
        rates: &mut [f64],
    ) {
        let Self { weighted, sums } = self;
        weighted.clear();
        weighted.resize(particles.len(), 1.0);
        for &row in walls {
            weighted[row as usize] = 0.0;
        }
        // Every row of a wall is zero, and no other.
        let near_wall = |rows: std::ops::Range<usize>| weighted[rows].contains(&0.0);
        let fluid = Smoothed { weighted };
        sweep.sweep(&fluid, particles, near_wall, sums);
        weighted.fill(0.0);
        for &row in walls {
            let row = row as usize;
            if sums[row] > 0.0 && (pull || particles.pressure[row] > 0.0) {
                weighted[row] = rates[row] * particles.volume(row) / sums[row];
            }
        }
        sweep.sweep(&Smoothed { weighted }, particles, |_| true, sums);
        for (i, (rate, sum)) in rates.iter_mut().zip(&*sums).enumerate() {
            *rate += sum / particles.volume(i);
        }
    }
}
