//! Cost against size as a plot and as numbers.

use std::fs;
use std::path::Path;

use meniscus_bench::scaling::{Scaling, ScalingCurve};
use meniscus_report::{Axis, Curve, FigureError, LinePlot, PALETTE, Scale};

use super::tables::name_of;
use crate::failure::Failure;

const NAME: &str = "cost-against-size";

impl From<FigureError> for Failure {
    fn from(error: FigureError) -> Self {
        Failure::new(error.to_string())
    }
}

/// Writes the plot (SVG, PNG) and its numbers (CSV) into `folder`.
pub fn write(scaling: &Scaling, folder: &Path) -> Result<(), Failure> {
    let mut plot = LinePlot::new(
        Axis::new("Particles", "").scale(Scale::Logarithmic),
        Axis::new("Time per particle and step", "s"),
    );
    let mut numbers = "curve,particles,median ns,best ns,yardsticks,samples\n".to_owned();
    for curve in &scaling.curves {
        let name = name_of(curve);
        let particles: Vec<f64> = curve.points.iter().map(|p| p.particles as f64).collect();
        let seconds: Vec<f64> = (curve.points.iter())
            .map(|point| 1e-9 * point.cost.nanoseconds)
            .collect();
        // The same colour for the same flow, whatever the precision.
        let same_flow = |c: &ScalingCurve| (c.dimension, c.flow) == (curve.dimension, curve.flow);
        let first = (scaling.curves.iter()).position(same_flow).unwrap_or(0);
        let drawn = match curve.variant.precision {
            "mixed" => Curve::points(&name, &particles, &seconds),
            _ => Curve::line(&name, &particles, &seconds),
        };
        plot = plot.with(drawn.colour(PALETTE[first % PALETTE.len()]));
        for point in &curve.points {
            let cost = point.cost;
            numbers.push_str(&format!(
                "\"{name}\",{},{:.2},{:.2},{:.4},{}\n",
                point.particles, cost.nanoseconds, cost.best, cost.yardsticks, cost.samples
            ));
        }
    }
    let caption = "Time of a step, one thread, for each particle.";
    let figure = plot.figure(NAME, caption);
    let put = |name: &str, bytes: &[u8]| {
        let path = folder.join(name);
        fs::write(&path, bytes)
            .map_err(|error| Failure::new(format!("cannot write {}: {error}", path.display())))
    };
    fs::create_dir_all(folder)
        .map_err(|error| Failure::new(format!("cannot make {}: {error}", folder.display())))?;
    put(&format!("{NAME}.svg"), figure.svg()?.as_bytes())?;
    put(&format!("{NAME}.png"), &figure.png()?)?;
    put(&format!("{NAME}.csv"), numbers.as_bytes())
}
