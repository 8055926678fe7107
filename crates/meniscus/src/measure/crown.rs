//! The crown that a drop throws up where it falls into a layer of liquid.

use std::f64::consts::{PI, TAU};

use crate::vector::Vector;

/// Sectors about the axis in 3D; in 2D there are two sides.
const SECTORS: usize = 8;

/// What a splash looks like at one time. The last axis points up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crown {
    /// Radius of the base, m: how far from the axis of impact the first particle lies at the level
    /// of the layer before the impact.
    pub base_radius: f64,
    /// Radius of the rim, m: how far from the axis the highest particle lies.
    pub rim_radius: f64,
    /// Height of the rim, m: that of the highest particle above the level before the impact.
    pub rim_height: f64,
}

impl Crown {
    /// Measures the splash about `impact`, the point (m) of the undisturbed surface that the drop
    /// falls on, from the particles of the `layer`, for the base, and those of all `liquid`, for
    /// the rim: the drop itself stays at the level for a while. What counts as being at its level lies within `reach` (m; a smoothing
    /// length in Gonzalez's thesis, sec. 4.6, half a spacing at least).
    ///
    /// All three are means over the two sides (2D) or eight sectors about the
    /// axis (3D). A single particle counts: where spray flies, the rim is that of the
    /// spray, and what it leaves in the cavity narrows the base. The base is about half a
    /// spacing wide of the surface of the cavity. `None` where nothing is at the level.
    pub fn measure<const D: usize>(
        layer: &[Vector<f64, D>],
        liquid: &[Vector<f64, D>],
        impact: Vector<f64, D>,
        reach: f64,
    ) -> Option<Self> {
        let sectors = if D == 2 { 2 } else { SECTORS };
        let mut base = vec![f64::INFINITY; sectors];
        // Height above the level, and distance from the axis.
        let mut rim = vec![(f64::NEG_INFINITY, 0.0); sectors];
        // Distance from the axis, height, and which sector.
        let place = |x: Vector<f64, D>| {
            let arm = x - impact;
            let [across, along] = [arm[0], if D == 2 { 0.0 } else { arm[1] }];
            let turned = (along.atan2(across) + PI) / TAU;
            let sector = if D == 2 {
                usize::from(across < 0.0)
            } else {
                ((turned * sectors as f64) as usize).min(sectors - 1)
            };
            (across.hypot(along), arm[D - 1], sector)
        };
        for &x in layer {
            let (radius, height, sector) = place(x);
            if height.abs() < reach {
                base[sector] = base[sector].min(radius);
            }
        }
        for &x in liquid {
            let (radius, height, sector) = place(x);
            if height > rim[sector].0 {
                rim[sector] = (height, radius);
            }
        }
        let mean = |values: &mut dyn Iterator<Item = f64>| {
            let (sum, count) = values
                .filter(|value| value.is_finite())
                .fold((0.0, 0), |(sum, count), value| (sum + value, count + 1));
            (count > 0).then(|| sum / f64::from(count))
        };
        let reached = rim.iter().filter(|(height, _)| height.is_finite());
        Some(Crown {
            base_radius: mean(&mut base.iter().copied())?,
            rim_radius: mean(&mut reached.clone().map(|(_, radius)| *radius))?,
            rim_height: mean(&mut reached.map(|(height, _)| *height))?,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::samples::cut;

    /// A layer down to -6, without a cavity of radius 10, with a sheet 1.5 thick that stands
    /// 8 high on its edge and leans outwards by 2.
    fn splash<const D: usize>(x: &Vector<f64, D>) -> bool {
        let radius = x.0[..D - 1].iter().map(|c| c * c).sum::<f64>().sqrt();
        let height = x[D - 1];
        let layer = (-6.0..0.0).contains(&height) && radius.hypot(height) > 10.0;
        let lean = radius - 0.25 * height;
        layer || ((0.0..8.0).contains(&height) && (10.0..11.5).contains(&lean))
    }

    #[test]
    fn a_cavity_with_a_sheet_is_measured_within_a_spacing() {
        for (angle, jitter) in [(0.0, 0.0), (0.4, 0.2)] {
            let impact = Vector([3.0, 40.0]);
            let mut x = cut(20.0, angle, jitter, splash::<2>);
            x.iter_mut().for_each(|x| *x += impact);
            let plane = Crown::measure(&x, &x, impact, 1.0).unwrap();
            let x = cut(16.0, angle, jitter, splash::<3>);
            let space = Crown::measure(&x, &x, Vector::ZERO, 1.0).unwrap();
            for found in [plane, space] {
                assert!((found.base_radius - 10.3).abs() < 0.5, "{found:?}");
                assert!((found.rim_height - 7.5).abs() < 0.5, "{found:?}");
                // Anywhere in the sheet's thickness.
                assert!((found.rim_radius - 12.6).abs() < 1.0, "{found:?}");
            }
        }
    }

    #[test]
    fn a_layer_below_its_level_has_no_base() {
        let x = [Vector([0.0, -3.0])];
        assert_eq!(Crown::measure(&x, &x, Vector::ZERO, 1.0), None);
        assert_eq!(Crown::measure::<3>(&[], &[], Vector::ZERO, 1.0), None);
    }
}
