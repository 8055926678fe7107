//! The figures of a report: [`pictures`] of the particles, [`curves`] over
//! time, the pressure [`profile`] of a round body, and [`van_der_waals`] fluids.

mod along;
mod curves;
mod pictures;
mod profile;
mod tank;
mod van_der_waals;

use meniscus_case::Case;
use meniscus_output::{Frame, FrameReader, RunFolder, Series};
use meniscus_report::{Figure, Movie};

use crate::failure::Failure;
use crate::findings::Findings;

/// All figures that a case can have.
pub fn of(
    case: &Case,
    folder: &RunFolder,
    series: &Series,
    measured: &Findings,
) -> Result<Vec<Figure>, Failure> {
    let frames = FrameReader::open(&folder.frames_folder())?;
    let mut figures = pictures::figures(case, &frames, measured)?;
    figures.extend(curves::axes(case, series, measured));
    if case.scheme.van_der_waals.is_some() {
        figures.extend(van_der_waals::curves(case, series));
    } else {
        figures.extend(curves::energies(case, series));
    }
    figures.extend(curves::budget(case, series));
    figures.extend(curves::loads(case, series));
    figures.extend(along::figure(case, &frames)?);
    figures.extend(tank::figure(case, &frames, series)?);
    figures.extend(profile::figure(case, &frames, measured)?);
    figures.extend(van_der_waals::profiles(case, &frames)?);
    Ok(figures)
}

/// The movie that the case asks for, if it does.
pub fn movie(case: &Case, folder: &RunFolder) -> Result<Option<Movie>, Failure> {
    pictures::movie(case, &FrameReader::open(&folder.frames_folder())?)
}

/// Whether a particle of a frame is of a wall.
fn walls(frame: &Frame) -> impl Fn(usize) -> bool {
    let field = frame.fields.iter().find(|field| field.name == "wall");
    move |i| field.is_some_and(|field| field.values[i] != 0.0)
}

/// The `count` indices of `times` nearest to evenly spaced instants from one
/// time to another, each once.
fn evenly(times: &[f64], from: f64, to: f64, count: usize) -> Vec<usize> {
    let nearest = |wanted: f64| {
        let distance = |k: &usize| (times[*k] - wanted).abs();
        (0..times.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)))
    };
    let mut chosen: Vec<usize> = (0..count)
        .filter_map(|k| nearest(from + (to - from) * k as f64 / (count.max(2) - 1) as f64))
        .collect();
    chosen.dedup();
    chosen
}

#[cfg(test)]
mod tests {
    use super::evenly;

    #[test]
    fn frames_are_chosen_nearest_to_even_instants_and_once() {
        let times = [0.0, 1.1, 2.0, 2.9, 4.0, 5.0];
        assert_eq!(evenly(&times, 0.0, 4.0, 3), [0, 2, 4]);
        assert_eq!(evenly(&times, 0.0, 1.0, 6), [0, 1]);
        assert_eq!(evenly(&times, 3.0, 9.0, 1), [3]);
        assert!(evenly(&[], 0.0, 1.0, 6).is_empty());
    }
}
