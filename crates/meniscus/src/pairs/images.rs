//! Periodic images: copies of particles near a periodic face, shifted by the
//! box, which take part as neighbours only.

use crate::domain::Domain;
use crate::vector::Vector;

/// One image: whose, and by how much shifted.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Image<const D: usize> {
    pub(crate) source: u32,
    pub(crate) shift: Vector<f64, D>,
}

/// Fills `images` with all images within `reach` of the box.
pub(crate) fn collect<const D: usize>(
    domain: &Domain<D>,
    points: &[Vector<f64, D>],
    reach: f64,
    images: &mut Vec<Image<D>>,
) {
    images.clear();
    for d in 0..D {
        let Some((low, high)) = domain.periodic[d] else {
            continue;
        };
        let period = high - low;
        let copies = (reach / period).ceil() as i64;
        let (near_low, near_high) = (low - reach, high + reach);
        let so_far = images.len();
        let add = |source: u32, shift: Vector<f64, D>, x: f64, out: &mut Vec<Image<D>>| {
            for k in (-copies..=copies).filter(|&k| k != 0) {
                let moved = x + k as f64 * period;
                if near_low <= moved && moved <= near_high {
                    let mut shift = shift;
                    shift[d] += k as f64 * period;
                    out.push(Image { source, shift });
                }
            }
        };
        for (i, point) in points.iter().enumerate() {
            add(i as u32, Vector::ZERO, point[d], images);
        }
        for k in 0..so_far {
            let Image { source, shift } = images[k];
            let x = points[source as usize][d] + shift[d];
            add(source, shift, x, images);
        }
    }
}
