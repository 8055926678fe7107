//! The liquid's surface in a tank: its level, and how it meets the side walls.

use crate::theory::meniscus_height;
use crate::vector::Vector;

use super::base::{Base, Plane};
use super::estimate::{Estimate, student_t};
use super::foot::{DEPTH, DEPTH_UNKNOWN};
use super::surface::surface_particles;

/// The part of the tank's width, about its middle, over which the level is taken.
const MIDDLE: f64 = 0.25;
/// The part of its depth, about its middle, that counts in 3D.
const DEEP: f64 = 0.5;
/// The capillary length, in spacings, of a surface too level to show its own, and the deviation of a
/// surface particle from the surface, in spacings, that sets how level that is.
const ASSUMED: f64 = 5.0;
const ROUGHNESS: f64 = 0.3;
/// How much more a known capillary length counts than an assumed one.
const KNOWN: f64 = 100.0;
/// How far from the wall the rise is read, in spacings.
const BESIDE: f64 = 2.6;
/// How near above a particle of the surface another one may lie, sideways and upwards, in spacings.
const COVER: [f64; 2] = [0.75, 3.0];
/// What lies further from the fitted curve, in spacings, is none of the surface.
const STRAY: f64 = 1.5;

/// A free surface between two walls, the last axis upwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TankSurface {
    /// Mean height of the surface over the middle quarter of the width, m.
    pub level: Estimate,
    /// Of the surface beside the left and the right wall.
    pub menisci: [Meniscus; 2],
}

/// The exact meniscus at a vertical wall that fits a surface best.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Meniscus {
    /// How far above the level the surface meets the wall, m.
    pub rise: Estimate,
    /// At what angle, rad, through the liquid.
    pub contact_angle: Estimate,
    /// sqrt(sigma / (rho g)) as the shape shows it, m; five spacings where the surface is
    /// too level for that.
    pub capillary_length: Estimate,
}

impl TankSurface {
    /// Measures particles about `spacing` (m) apart between vertical walls at these coordinates
    /// along x, m; in 3D those of the middle half along y. `None` where too little of a surface is
    /// found. The tank should be eight capillary lengths wide.
    ///
    /// The rise is where the straight line along the particles within three spacings of a wall meets
    /// it. The particles of either half are fitted with [`meniscus_height`] for the angle. Of such
    /// surfaces, of a capillary length of five spacings, cut from lattices at any angle with and
    /// without disorder, one look at one side finds the rise within two spacings, and the angle
    /// within 11 degrees from 60 to 120 degrees, within 30 beyond, where the `capillary_length` (m) is
    /// given. Where the shape is to tell that too, the angle is not to be trusted.
    /// Averages over both sides and over time do better.
    pub fn measure<const D: usize>(
        positions: &[Vector<f64, D>],
        spacing: f64,
        [left, right]: [f64; 2],
        capillary_length: Option<f64>,
    ) -> Option<Self> {
        let profile = surface_profile(positions, spacing, [left, right]);
        let half = 0.5 * (right - left);
        let in_middle = |p: &&[f64; 2]| (p[0] - left - half).abs() < MIDDLE * half;
        let heights: Vec<f64> = profile.iter().filter(in_middle).map(|p| p[1]).collect();
        let count = heights.len() as f64;
        let mean = heights.iter().sum::<f64>() / count;
        let squares = heights.iter().map(|z| (z - mean).powi(2)).sum::<f64>();
        let error = student_t((count - 1.0).max(4.0)) * (squares / (count * (count - 1.0))).sqrt();
        // Away from the wall, and above the level of the particle centres.
        let beside = |wall: f64, side: f64| -> Vec<[f64; 2]> {
            let points = profile.iter().map(|p| [side * (p[0] - wall), p[1] - mean]);
            points.filter(|p| p[0] < half).collect()
        };
        let meniscus =
            |points: Vec<[f64; 2]>| Meniscus::fit(&points, spacing, error, capillary_length);
        let menisci = [meniscus(beside(left, 1.0))?, meniscus(beside(right, -1.0))?];
        (count >= 3.0).then(|| TankSurface {
            level: Estimate {
                value: mean + DEPTH * spacing,
                half_width: error.hypot(DEPTH_UNKNOWN * spacing),
            },
            menisci,
        })
    }
}

impl Meniscus {
    /// Through the centres of surface particles: distance from the wall, and height above those far
    /// from it, which is known within `error`.
    fn fit(points: &[[f64; 2]], spacing: f64, error: f64, known: Option<f64>) -> Option<Self> {
        let weight = if known.is_some() { KNOWN } else { 1.0 };
        let assumed = known.unwrap_or(ASSUMED * spacing);
        let freedom = points.len().checked_sub(2).filter(|&n| n >= 3)? as f64;
        // Distances across the surface, with half a spacing between it and the particles, less the
        // half that lies above those far away; last how far the capillary length is from the one
        // assumed. Parameters: contact angle, and the logarithm of the capillary length.
        let left = |[angle, length]: [f64; 2]| -> Vec<f64> {
            let a = length.exp();
            let distance = |&[x, z]: &[f64; 2]| {
                let height = meniscus_height(x.max(0.0), angle, a);
                let cosine = 1.0 - 0.5 * (height / a).powi(2);
                // Steeper than 70 degrees no particle is told from its neighbour.
                let across = (z - DEPTH * spacing - height) * cosine.max(0.35) + DEPTH * spacing;
                // Its slope vanishes with it, and a stray particle pulls no more.
                across.clamp(-STRAY * spacing, STRAY * spacing)
            };
            let astray = weight * ROUGHNESS * spacing * (length - assumed.ln());
            points.iter().map(distance).chain([astray]).collect()
        };
        let cost = |p: [f64; 2]| left(p).iter().map(|r| r * r).sum::<f64>();
        let starts = [0.3, 0.7, 1.0, 1.57, 2.1, 2.7]
            .into_iter()
            .flat_map(|angle| [0.5, 1.0, 2.5].map(|part: f64| [angle, (part * assumed).ln()]));
        let mut at = starts.min_by(|a, b| cost(*a).total_cmp(&cost(*b)))?;
        let mut inverse = [[f64::NAN; 2]; 2];
        for _ in 0..30 {
            let now = left(at);
            let slopes = [0, 1].map(|k| {
                let d = 1e-4;
                let mut there = at;
                there[k] += d;
                left(there)
                    .iter()
                    .zip(&now)
                    .map(|(b, a)| (b - a) / d)
                    .collect::<Vec<f64>>()
            });
            let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
            let [aa, ab, bb] =
                [(0, 0), (0, 1), (1, 1)].map(|(j, k)| product(&slopes[j], &slopes[k]));
            let determinant = aa * bb - ab * ab;
            inverse = [
                [bb / determinant, -ab / determinant],
                [-ab / determinant, aa / determinant],
            ];
            let pull = [0, 1].map(|k| -product(&slopes[k], &now));
            let full = inverse.map(|row| row[0] * pull[0] + row[1] * pull[1]);
            // Shorter, as long as it leads upwards or out of 0 to 180 degrees.
            let sum = product(&now, &now);
            let shares = (0..12).map(|halvings| 0.5_f64.powi(halvings));
            let steps = shares.map(|share| [at[0] + share * full[0], at[1] + share * full[1]]);
            let found = steps
                .into_iter()
                .find(|p| (0.0..=std::f64::consts::PI).contains(&p[0]) && cost(*p) < sum);
            let Some(better) = found else { break };
            let moved = (better[0] - at[0]).abs() + (better[1] - at[1]).abs();
            at = better;
            if moved < 1e-6 {
                break;
            }
        }
        let variance = cost(at) / freedom;
        let [angle, length] = at;
        let a = length.exp();
        let half_width = |gradient: [f64; 2]| {
            let square: f64 = (0..4)
                .map(|k| gradient[k / 2] * inverse[k / 2][k % 2] * gradient[k % 2])
                .sum();
            student_t(freedom.max(4.0)) * (variance * square).sqrt()
        };
        Some(Meniscus {
            rise: rise(points, spacing, error)?,
            contact_angle: Estimate {
                value: angle,
                half_width: half_width([1.0, 0.0]),
            },
            capillary_length: Estimate {
                value: a,
                half_width: a * half_width([0.0, 1.0]),
            },
        })
    }
}

/// How far above the level the straight line along the particles beside the wall meets it.
fn rise(points: &[[f64; 2]], spacing: f64, error: f64) -> Option<Estimate> {
    let mut near = points.to_vec();
    near.sort_by(|p, q| p[0].total_cmp(&q[0]));
    let end = near.first()?[0] + BESIDE * spacing;
    near.truncate(near.partition_point(|p| p[0] < end).max(4));
    let count = near.len() as f64;
    let middle = [0, 1].map(|d| near.iter().map(|p| p[d]).sum::<f64>() / count);
    let moment = |d: usize, e: usize| {
        let products = near.iter().map(|p| (p[d] - middle[d]) * (p[e] - middle[e]));
        products.sum::<f64>() / count
    };
    // The principal axis of the points, away from the wall.
    let lean = 0.5 * (2.0 * moment(0, 1)).atan2(moment(0, 0) - moment(1, 1));
    let across = moment(0, 0) * lean.sin().powi(2) + moment(1, 1) * lean.cos().powi(2)
        - 2.0 * moment(0, 1) * lean.sin() * lean.cos();
    let freedom = (count - 2.0).max(1.0);
    let scatter = (across.max(0.0) * count / freedom).sqrt();
    // Far from the wall the particles lie as far below the surface as they do here across it.
    let shift = DEPTH * spacing * (1.0 / lean.cos() - 1.0);
    let value = middle[1] - middle[0] * lean.tan() + shift;
    let spread =
        scatter * (1.0 / count + (middle[0] / (BESIDE * spacing)).powi(2) * 12.0 / count).sqrt();
    (near.len() >= 3).then(|| Estimate {
        value,
        half_width: (student_t(freedom.max(4.0)) * spread / lean.cos()).hypot(error),
    })
}

/// Particle centres of the free surface between vertical walls at these coordinates along x, m:
/// x and height of each, in no order. In 3D those of the middle half along y. The surface itself
/// lies half a spacing outside.
pub fn surface_profile<const D: usize>(
    positions: &[Vector<f64, D>],
    spacing: f64,
    walls: [f64; 2],
) -> Vec<[f64; 2]> {
    let low = |d: usize| positions.iter().map(|x| x[d]).fold(f64::INFINITY, f64::min);
    let high = |d: usize| {
        positions
            .iter()
            .map(|x| x[d])
            .fold(f64::NEG_INFINITY, f64::max)
    };
    let along = |d: usize, sign: f64| {
        let mut normal = Vector::ZERO;
        normal[d] = sign;
        normal
    };
    let mut planes = Vec::new();
    for (wall, sign) in walls.into_iter().zip([1.0, -1.0]) {
        let mut point = Vector::ZERO;
        point[0] = wall;
        planes.extend(Plane::new(point, along(0, sign)).map(Base::Plane));
    }
    // The bottom is none of it, wherever the lowest particles lie.
    let mut point = Vector::ZERO;
    point[D - 1] = low(D - 1) - 0.5 * spacing;
    planes.extend(Plane::new(point, along(D - 1, 1.0)).map(Base::Plane));
    let (front, back) = (low(1), high(1));
    let inside = |x: &Vector<f64, D>| {
        D == 2 || (x[1] - 0.5 * (front + back)).abs() <= 0.5 * DEEP * (back - front)
    };
    let found: Vec<[f64; 2]> = (surface_particles(positions, spacing, &planes).into_iter())
        .map(|i| positions[i])
        .filter(inside)
        .map(|x| [x[0], x[D - 1]])
        .collect();
    // What has the surface far above it lies beside a void.
    let covered = |p: &[f64; 2]| {
        let above = |q: &[f64; 2]| {
            (q[0] - p[0]).abs() < COVER[0] * spacing && q[1] - p[1] > COVER[1] * spacing
        };
        found.iter().any(above)
    };
    found.iter().filter(|p| !covered(p)).copied().collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::samples::cut;
    use crate::theory::meniscus_rise;

    const WALLS: [f64; 2] = [-25.0, 25.0];

    /// A liquid of capillary length 5 that meets both walls at this angle, its level at 14.
    fn tank<const D: usize>(degrees: f64, (turn, jitter): (f64, f64)) -> Vec<Vector<f64, D>> {
        let surface = move |x: f64| {
            let from = |wall: f64| meniscus_height((x - wall).abs(), degrees.to_radians(), 5.0);
            14.0 + WALLS.map(from).iter().sum::<f64>()
        };
        cut(36.0, turn, jitter, |x: &Vector<f64, D>| {
            let deep = D == 2 || x[1].abs() < 5.0;
            deep && x[0].abs() < 25.0 && x[D - 1] > 0.0 && x[D - 1] < surface(x[0])
        })
    }

    /// Rise and angle off in all menisci, at most: spacings and degrees.
    fn worst(degrees: f64, known: Option<f64>) -> [f64; 2] {
        let exact = meniscus_rise(degrees.to_radians(), 5.0);
        let mut worst = [0.0_f64; 2];
        let mut note = |found: Option<TankSurface>| {
            let found = found.unwrap();
            assert!(
                (found.level.value - 14.0).abs() < 0.35,
                "{degrees}: {found:?}"
            );
            for meniscus in found.menisci {
                let angle = meniscus.contact_angle.value.to_degrees();
                worst[0] = worst[0].max((meniscus.rise.value - exact).abs());
                worst[1] = worst[1].max((angle - degrees).abs());
            }
        };
        for lattice in [(0.0, 0.0), (0.3, 0.1), (0.8, 0.2)] {
            let plane = tank::<2>(degrees, lattice);
            note(TankSurface::measure(&plane, 1.0, WALLS, known));
        }
        let space = tank::<3>(degrees, (0.0, 0.1));
        note(TankSurface::measure(&space, 1.0, WALLS, known));
        worst
    }

    #[test]
    fn a_surface_between_walls_has_its_rise_and_angle() {
        for (degrees, most) in [
            (30.0, 1.6),
            (60.0, 1.0),
            (90.0, 1.0),
            (120.0, 1.7),
            (150.0, 1.9),
        ] {
            let [rise, angle] = worst(degrees, Some(5.0));
            assert!(rise < most, "{degrees}: {rise}");
            // Near 0 and 180 degrees the surface hardly changes with the angle.
            let flat = (60.0..=120.0).contains(&degrees);
            assert!(angle < if flat { 11.0 } else { 30.1 }, "{degrees}: {angle}");
        }
    }
}
