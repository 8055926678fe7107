//! The comparison as plots.

use std::path::Path;

use meniscus_output::Series;
use meniscus_report::{Axis, Curve, Figure, LinePlot, Scale};

use super::page::groups;
use super::score::{Cell, Score};
use crate::failure::Failure;

/// Tests whose error falls with resolution, and the number that shows it.
const CONVERGING: [(&str, &str); 2] = [("laplace", "pressure"), ("swing", "frequency")];

/// All figures, drawn into `root/figures`; gives their files' names and captions.
pub fn draw(root: &Path, scores: &[Score]) -> Result<Vec<(String, String)>, Failure> {
    let mut figures = Vec::new();
    for (test, quantity) in CONVERGING {
        for dimension in [2, 3] {
            figures.extend(convergence(scores, test, quantity, dimension));
        }
    }
    for laplace_number in ["120", "1200", "12000"] {
        figures.extend(currents(root, scores, laplace_number));
    }
    let folder = root.join("figures");
    let broken = |what: &str, error: &dyn std::fmt::Display| {
        Failure::new(format!("cannot {what} a figure: {error}"))
    };
    std::fs::create_dir_all(&folder).map_err(|error| broken("write", &error))?;
    (figures.into_iter())
        .map(|(figure, caption)| {
            let file = format!("{}.png", figure.name());
            let png = figure.png().map_err(|error| broken("draw", &error))?;
            meniscus_output::replace_file(&folder.join(&file), |out| {
                std::io::Write::write_all(out, &png)
            })
            .map_err(|error| broken("write", &error))?;
            Ok((file, caption))
        })
        .collect()
}

/// The worst error of any start over resolution, a curve for each model.
fn convergence(
    scores: &[Score],
    test: &str,
    quantity: &str,
    dimension: usize,
) -> Option<(Figure, String)> {
    let mut plot = LinePlot::new(
        Axis::new("R / dx", "").scale(Scale::Logarithmic),
        Axis::new("Error (%)", "").scale(Scale::Logarithmic),
    );
    let chosen = (scores.iter())
        .filter(|s| s.test == test && s.quantity == quantity && s.dimension == dimension);
    let mut curves = 0;
    for (model, of_model) in groups(chosen, |score| score.model) {
        let points: Vec<(f64, f64)> = groups(of_model.into_iter(), |score| score.resolution)
            .into_iter()
            .filter_map(|(n, cell)| Some((f64::from(n), Cell(cell).worst()?.abs())))
            .collect();
        if points.len() > 1 {
            let (x, y): (Vec<f64>, Vec<f64>) = points.into_iter().unzip();
            plot = plot.with(Curve::line(model, &x, &y));
            curves += 1;
        }
    }
    let caption =
        format!("Error of the {quantity} ({test}, {dimension}D): the worst of all starts.");
    let name = format!("{test}-{dimension}d");
    (curves > 0).then(|| (plot.figure(&name, &caption), caption))
}

/// The largest speed in a drop at rest over time, jittered start, a curve for each model.
fn currents(root: &Path, scores: &[Score], laplace_number: &str) -> Option<(Figure, String)> {
    let mut plot = LinePlot::new(
        Axis::new("Time over sqrt(rho D^3 / sigma)", ""),
        Axis::new("U sqrt(rho D / sigma)", "").scale(Scale::Logarithmic),
    );
    let variant = format!("La {laplace_number}");
    let mut curves = 0;
    let chosen = (scores.iter()).filter(|score| {
        score.test == "parasitic currents"
            && score.quantity == "speed"
            && score.variant == variant
            && score.start == "jittered-1"
            && (score.dimension, score.resolution) == (2, 10)
    });
    for score in chosen {
        let file = root.join("runs").join(&score.run).join("series.csv");
        let Ok(series) = Series::read(&file) else {
            continue;
        };
        let (Some(time), Some(speed)) = (series.column("time"), series.column("largest speed"))
        else {
            continue;
        };
        let scaled: Vec<f64> = time.iter().map(|t| t / 8.0_f64.sqrt()).collect();
        let speed: Vec<f64> = speed.iter().map(|u| u * 2.0_f64.sqrt()).collect();
        plot = plot.with(Curve::line(score.model, &scaled, &speed));
        curves += 1;
    }
    let caption = format!("Largest speed in a jittered disc at rest, {variant}, R / dx = 10.");
    (curves > 0).then(|| {
        (
            plot.figure(&format!("parasitic-{laplace_number}"), &caption),
            caption,
        )
    })
}
