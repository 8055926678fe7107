//! Particles of two bodies at the same place.

use meniscus::Particle;

/// The first two particles of different bodies closer than `distance`, also
/// across a periodic boundary.
pub(crate) fn closest_of_two_bodies(
    particles: &[Particle<3>],
    periodic: &[Option<(f64, f64)>; 3],
    distance: f64,
) -> Option<(usize, usize)> {
    // Sorted into cells as wide as the distance, so that only neighbouring cells count.
    let cell = |x: [f64; 3]| x.map(|x| (x / distance).floor() as i64);
    let mut places: Vec<([i64; 3], [f64; 3], usize)> = Vec::with_capacity(particles.len());
    for (i, particle) in particles.iter().enumerate() {
        let mut images = vec![particle.position.0];
        for d in 0..3 {
            let Some((low, high)) = periodic[d] else {
                continue;
            };
            for k in 0..images.len() {
                let mut image = images[k];
                // One that has crossed the low face meets those at the high face.
                if image[d] < low + distance {
                    image[d] += high - low;
                    images.push(image);
                }
            }
        }
        places.extend(images.into_iter().map(|x| (cell(x), x, i)));
    }
    places.sort_unstable_by_key(|place| (place.0, place.2));
    for &(home, x, i) in &places {
        for offset in 0..9 {
            // A run of three cells along the last axis is contiguous.
            let row = [home[0] + offset / 3 - 1, home[1] + offset % 3 - 1];
            let start = places.partition_point(|place| place.0 < [row[0], row[1], home[2] - 1]);
            let near = places[start..]
                .iter()
                .take_while(|place| place.0 <= [row[0], row[1], home[2] + 1]);
            for &(_, y, j) in near {
                let square: f64 = (0..3).map(|d| (x[d] - y[d]).powi(2)).sum();
                if particles[i].body < particles[j].body && square < distance * distance {
                    return Some((i, j));
                }
            }
        }
    }
    None
}
