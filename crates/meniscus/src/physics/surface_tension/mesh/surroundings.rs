//! What a model on a mesh acts in.

use super::{Layered, Mesh};
use crate::particles::Particles;
use crate::physics::surface_tension::bodies::Bodies;

/// One fluid with a free surface, and walls.
pub struct Surroundings<'a, const D: usize> {
    /// sigma, N/m
    pub surface_tension: f64,
    /// rho_0, kg/m^3
    pub density: f64,
    /// dx, m
    pub spacing: f64,
    /// Which particles know of each other, walls among them.
    pub groups: Bodies<'a, D>,
    /// Those that no wall holds.
    pub free: Bodies<'a, D>,
    /// cos(theta) of the wall that a row belongs to; none for the liquid.
    pub wall: &'a (dyn Fn(usize) -> Option<f64> + Sync),
}

impl<const D: usize> Surroundings<'_, D> {
    /// The rows of each group.
    pub(in crate::physics::surface_tension) fn list_rows(&self, rows: &mut Vec<Vec<u32>>) {
        rows.iter_mut().for_each(Vec::clear);
        rows.resize(self.groups.count, Vec::new());
        for (row, &group) in (0..).zip(self.groups.of_row) {
            rows[group as usize].push(row);
        }
    }

    /// The mesh that reaches `margin` nodes beyond the liquid among `rows`, its nodes `beyond` spacings from whole multiples, with what these spread: liquid its
    /// volume at rest in cells of the mesh, walls one, and the cosine of their contact angle. None without liquid, or
    /// with some at no place.
    pub(in crate::physics::surface_tension) fn mesh(
        &self,
        particles: &Particles<D>,
        rows: &[u32],
        beyond: f64,
        margin: i64,
        liquid: &mut Layered<D>,
        walls: &mut Layered<D>,
    ) -> Option<Mesh<D>> {
        let row_of_liquid = |row: &&u32| (self.wall)(**row as usize).is_none();
        let position = |row: &u32| particles.position[*row as usize];
        let places = rows.iter().filter(row_of_liquid).map(position);
        let mesh = Mesh::around(places, self.spacing, beyond, margin)?;
        liquid.clear();
        walls.clear();
        let volume = self.density * self.spacing.powi(D as i32);
        let reach = margin as f64 * self.spacing;
        for row in rows {
            let i = *row as usize;
            let mut put = |x| match (self.wall)(i) {
                _ if !mesh.holds(&x) => {}
                None => liquid.push(x, [particles.mass[i] / volume, 0.0]),
                Some(cosine) => walls.push(x, [1.0, cosine]),
            };
            (self.groups.domain).for_each_image(particles.position[i], reach, &mut put);
        }
        Some(mesh)
    }
}
