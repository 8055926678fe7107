//! The particles of a wall whose surface is a mesh: the points of a cubic lattice that are behind
//! the surface, no deeper than the layers reach.
//!
//! So a wall has no gap at edges and corners of any kind, and its particles are as dense as those
//! of the fluid. A side along the axes has its first layer half a spacing behind it; the layers of
//! others are as rough as the lattice. Where an open mesh ends, the wall ends.

use std::collections::HashMap;

use super::{Layers, Side, some};
use crate::shape::{FillError, Mesh, Nearest, bounds};
use crate::vector::Vector;

/// A point over a rim is still over the surface if it is less than this part of a spacing beyond.
const ON_THE_RIM: f64 = 1e-6;

impl Layers {
    /// A mesh, whose triangles face the liquid where the wall is an obstacle, [`Side::Inside`] it,
    /// and the wall where it is a vessel.
    ///
    /// # Errors
    /// As [`Arrangement::fill`](crate::shape::Arrangement::fill).
    pub fn mesh(&self, mesh: &Mesh, side: Side) -> Result<Vec<Vector<f64, 3>>, FillError> {
        self.allow(mesh.area() / self.spacing.powi(2) * self.count as f64)?;
        let (low, high) = mesh.bounding_box();
        // As in a tank, a whole number of particles along each axis.
        let step: Vector<f64, 3> = Vector(std::array::from_fn(|d| {
            let length = high[d] - low[d];
            let parts = (length / self.spacing).round();
            if parts > 0.0 {
                length / parts
            } else {
                self.spacing
            }
        }));
        let place = |site: [i64; 3]| {
            let coordinate = |d: usize| low[d] + (site[d] as f64 + 0.5) * step[d];
            Vector(std::array::from_fn(coordinate))
        };
        let reach = self.thickness() * (1.0 - 1e-9);
        let mut sites: HashMap<[i64; 3], Nearest> = HashMap::new();
        for facet in mesh.facets() {
            let (from, to) = bounds(facet.corners);
            let site = |x: f64, d: usize| ((x - low[d]) / step[d] - 0.5).floor() as i64;
            let range = |d: usize| site(from[d] - reach, d)..=site(to[d] + reach, d) + 1;
            for i in range(0) {
                for j in range(1) {
                    for k in range(2) {
                        let site = [i, j, k];
                        let nearest = facet.nearest(place(site));
                        if nearest.distance_squared > reach * reach {
                            continue;
                        }
                        let best = sites.entry(site).or_insert(nearest);
                        if nearest.distance_squared < best.distance_squared {
                            *best = nearest;
                        }
                    }
                }
            }
        }
        let mut behind: Vec<[i64; 3]> = sites
            .into_iter()
            .filter(|(_, nearest)| {
                let depth = match side {
                    Side::Inside => -nearest.height,
                    Side::Outside => nearest.height,
                };
                depth > 0.0 && nearest.beyond < ON_THE_RIM * self.spacing
            })
            .map(|(site, _)| site)
            .collect();
        behind.sort_unstable_by_key(|&[i, j, k]| [k, j, i]);
        some(behind.into_iter().map(place).collect())
    }
}
