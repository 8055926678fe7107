//! When lists are built, of what reach, and until when they hold.

use rayon::prelude::*;

use super::columns::Columns;
use super::{Pairs, bodies, images, lists};
use crate::particles::Particles;
use crate::smoothing::Smoothing;

impl<const D: usize> Pairs<D> {
    /// Sorts the particles and builds the lists anew.
    pub fn rebuild(&mut self, particles: &mut Particles<D>) {
        if self.domain.is_periodic() {
            for point in &mut particles.position {
                self.domain.wrap(point);
            }
        }
        self.columns.sort(&particles.position);
        particles.permute(self.columns.order(), &mut self.scratch);
        self.reference.clear();
        self.reference.extend_from_slice(&particles.position);
        self.list(particles);
    }

    /// Builds the lists again that [`rebuild`](Self::rebuild) made for sorted
    /// particles at `reference`, with these smoothing lengths; false if these are not sorted.
    pub(crate) fn restore(&mut self, particles: &Particles<D>) -> bool {
        self.columns.sort(&particles.position);
        self.reference.clone_from(&particles.position);
        let sorted = (0..).zip(self.columns.order()).all(|(k, &row)| k == row);
        if sorted {
            self.list(particles);
        }
        sorted
    }

    fn list(&mut self, particles: &Particles<D>) {
        self.list_sorted(None, particles);
        self.follow(particles);
    }

    /// Builds the lists of particles that are sorted into columns, if not into its own.
    pub(super) fn list_sorted(&mut self, columns: Option<&Columns<D>>, particles: &Particles<D>) {
        self.builds += 1;
        self.reference_smoothing_length.clear();
        if self.smoothing_varies() {
            (self.reference_smoothing_length).extend_from_slice(&particles.smoothing_length);
        }
        let mut reach = std::mem::take(&mut self.reach);
        let columns = columns.unwrap_or(&self.columns);
        if self.reach_varies() {
            let of_row = |i| self.support_share(particles, i) + 0.5 * self.skin;
            reach.fill(columns, (0..particles.len()).map(of_row));
        } else {
            reach.fill_same(self.support_share(particles, 0) + 0.5 * self.skin);
        }
        self.reach = reach;
        let farthest = 2.0 * self.reach.largest();
        images::collect(&self.domain, &self.reference, farthest, &mut self.images);
        self.image_points.clear();
        self.image_points.extend(
            (self.images.iter()).map(|image| self.reference[image.source as usize] + image.shift),
        );
        self.image_columns.sort(&self.image_points);
        let order = self.image_columns.order();
        self.sorted_images.clear();
        self.sorted_images
            .extend(order.iter().map(|&k| self.images[k as usize]));
        if let Some(same) = self.reach.same() {
            self.image_reach.fill_same(same);
        } else {
            let sources = self.sorted_images.iter().map(|image| image.source as usize);
            let of_image = sources.map(|source| self.reach.of(source));
            self.image_reach.fill(&self.image_columns, of_image);
        }
        lists::build(
            self.level,
            &mut self.chunks,
            (columns, &self.reach),
            (&self.image_columns, &self.image_reach),
        );
    }

    /// Whether some rows reach farther than others.
    fn reach_varies(&self) -> bool {
        let varies = |smoothing| matches!(smoothing, Smoothing::Mean { .. });
        varies(self.smoothing) || self.also.is_some_and(varies)
    }

    /// What row `i` adds to the support of its pairs, m.
    fn support_share(&self, particles: &Particles<D>, i: usize) -> f64 {
        let share = self.smoothing.share(particles, i);
        let also = self.also.map_or(share, |also| also.share(particles, i));
        self.kernel.support() * share.max(also)
    }

    /// Whether particles have moved so far, or smoothing lengths grown so much, that a pair may
    /// be missing from the lists.
    pub fn is_stale(&self, particles: &Particles<D>) -> bool {
        self.reference.len() != particles.len()
            || !self.is_within_skin(particles)
            || (self.second.as_ref()).is_some_and(|second| second.is_stale(particles))
    }

    /// Whether each particle's way from where it was, and what its reach has grown by, are
    /// together at most half the skin; what is not a number is not.
    fn is_within_skin(&self, particles: &Particles<D>) -> bool {
        let varies = self.reach_varies();
        (particles.position.par_iter(), &self.reference)
            .into_par_iter()
            .with_min_len(4096)
            .enumerate()
            .all(|(i, (now, reference))| {
                let left = if varies {
                    self.reach.of(i) - self.support_share(particles, i)
                } else {
                    0.5 * self.skin
                };
                left >= 0.0 && (*now - *reference).norm_squared() <= left * left
            })
    }

    /// For each row the body that it belongs to, and how many there are. Particles of two bodies
    /// have not been within each other's `support` (m) since the lists were built.
    /// Rows that do not take part have none.
    pub(crate) fn bodies(
        &self,
        support: f64,
        takes_part: impl Fn(usize) -> bool,
    ) -> (Vec<u32>, usize) {
        let rows: Vec<usize> = (0..self.reference.len())
            .filter(|&i| takes_part(i))
            .collect();
        let points: Vec<_> = rows.iter().map(|&i| self.reference[i]).collect();
        let (of, count) = bodies::connected(&points, support + self.skin, &self.domain);
        let mut of_row = vec![u32::MAX; self.reference.len()];
        for (row, of) in rows.into_iter().zip(of) {
            of_row[row] = of;
        }
        (of_row, count)
    }
}
