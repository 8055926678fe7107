//! Where a jet breaks, and what drops it makes.

use std::f64::consts::TAU;

use meniscus::theory;
use meniscus_case::{Case, Jet, Window};
use meniscus_output::Series;

use super::{Findings, exact, mean, window};
use crate::numbers::effective_viscosity;

/// Speed, modulation and flow at the nozzle; with these, by theory, where the jet breaks, and how
/// large, how fast and how far apart its drops are.
pub fn measure(case: &Case, series: &Series, findings: &mut Findings) {
    let (Some(asked), Some(body)) = (&case.measure.jet, case.bodies.first()) else {
        return;
    };
    let fluid = &case.fluids[body.fluid];
    let Some(nozzle) = Nozzle::read(asked, series) else {
        let words =
            "no jet: the time in which it is measured has no whole period of its modulation";
        findings.complaints.push(words.into());
        return;
    };
    let in_space = |value: f64| if case.dimension == 3 { value } else { f64::NAN };
    let (sigma, density, radius) = (fluid.surface_tension, fluid.density, asked.radius);
    let viscosity = effective_viscosity(case, body.fluid);
    let Nozzle {
        speed,
        modulation,
        flow,
    } = nozzle;
    findings.add(
        "jet-speed",
        "speed of the jet at the nozzle",
        "m/s",
        None,
        exact(speed),
    );
    let name = "amplitude of that at its frequency, over it";
    findings.add("jet-modulation", name, "%", None, exact(100.0 * modulation));
    let unit = if case.dimension == 3 {
        "m^3/s"
    } else {
        "m^2/s"
    };
    findings.add(
        "jet-flow",
        "flow through the nozzle",
        unit,
        None,
        exact(flow),
    );

    let f = asked.frequency;
    let length =
        theory::jet_breakup_length(speed, modulation, f, sigma, density, viscosity, radius);
    let from = Some(("linear waves (Rayleigh, Weber)", in_space(length)));
    let found = exact(breakup_length(asked, series));
    findings.add(
        "breakup-length",
        "length at which the jet breaks",
        "m",
        from,
        found,
    );

    let of_drops = |column: &str| {
        let found = mean(series, column, &asked.window);
        found.unwrap_or(exact(f64::NAN))
    };
    let from = Some(("flow over frequency", flow / f));
    let unit = if case.dimension == 3 { "m^3" } else { "m^2" };
    let name = "volume of a drop";
    findings.add("drop-volume", name, unit, from, of_drops("drop volume"));
    let balance = theory::jet_drop_speed(speed, sigma, density, radius);
    let from = Some(("balance of momentum", in_space(balance)));
    let drop_speed = of_drops("drop speed");
    findings.add("drop-speed", "speed of the drops", "m/s", from, drop_speed);
    let from = Some(("their speed over frequency", drop_speed.value / f));
    let name = "distance from drop to drop";
    findings.add("drop-distance", name, "m", from, of_drops("drop distance"));
}

/// What comes through the nozzle.
struct Nozzle {
    speed: f64,
    /// Amplitude over speed.
    modulation: f64,
    flow: f64,
}

impl Nozzle {
    /// Over the last whole periods of the time; none where there is none.
    fn read(asked: &Jet, series: &Series) -> Option<Self> {
        let Window { from, to } = asked.window;
        let periods = ((to - from) * asked.frequency).floor();
        let start = to - periods / asked.frequency;
        let (time, speed) = window(series, "jet speed", start, to)?;
        let (_, volume) = window(series, "liquid beyond the nozzle", start, to)?;
        let (first, last) = (*time.first()?, *time.last()?);
        if periods < 1.0 || last <= first {
            return None;
        }
        // Rows a step apart from when they are due: by trapezoids.
        let integral = |of: &dyn Fn(usize) -> f64| {
            let parts =
                (1..time.len()).map(|k| 0.5 * (of(k) + of(k - 1)) * (time[k] - time[k - 1]));
            parts.sum::<f64>() / (last - first)
        };
        let turn = |k: usize| TAU * asked.frequency * time[k];
        let mean = integral(&|k| speed[k]);
        let cosine = integral(&|k| (speed[k] - mean) * turn(k).cos());
        let sine = integral(&|k| (speed[k] - mean) * turn(k).sin());
        Some(Self {
            speed: mean,
            modulation: 2.0 * cosine.hypot(sine) / mean,
            flow: (volume.last()? - volume.first()?) / (last - first),
        })
    }
}

/// Mean length of the jet when a drop has just come off, m: when it is shorter by more than a radius
/// than in the row before. NaN where none comes off.
fn breakup_length(asked: &Jet, series: &Series) -> f64 {
    let found = window(series, "jet length", asked.window.from, asked.window.to);
    let Some((_, length)) = found else {
        return f64::NAN;
    };
    let broken = |k: &usize| length[*k] < length[*k - 1] - asked.radius;
    let left: Vec<f64> = (1..length.len())
        .filter(broken)
        .map(|k| length[k])
        .collect();
    left.iter().sum::<f64>() / left.len() as f64
}

#[cfg(test)]
mod tests {
    use super::{Nozzle, breakup_length};
    use meniscus_case::{Jet, Window};
    use meniscus_output::{Column, Series};

    #[test]
    fn what_is_put_into_a_series_is_read_off() {
        let asked = Jet {
            at: [0.0; 3],
            direction: [1.0, 0.0, 0.0],
            radius: 0.5,
            frequency: 2.0,
            window: Window { from: 1.0, to: 3.2 },
        };
        let names = [
            ("time", "s"),
            ("jet speed", "m/s"),
            ("jet length", "m"),
            ("liquid beyond the nozzle", "m^3"),
        ];
        let columns: Vec<Column> = names
            .iter()
            .map(|(name, unit)| Column::new(name, unit))
            .collect();
        let rows: Vec<[f64; 4]> = (0..=320)
            .map(|k| {
                let t = f64::from(k) * 0.01;
                let speed = 4.0 + 0.2 * (4.0 * std::f64::consts::PI * t + 0.3).sin();
                // Grows at 4 m/s, and loses 2 m every half second, once a wave is 9 m out.
                [t, speed, 7.0 + 4.0 * (t % 0.5), 3.0 * t]
            })
            .collect();
        let values = (0..4)
            .map(|c| rows.iter().map(|row| row[c]).collect())
            .collect();
        let series = Series { columns, values };
        let nozzle = Nozzle::read(&asked, &series).unwrap();
        // Trapezoids of a fiftieth of a period, and both ends counted, err by a few per mille.
        assert!((nozzle.speed - 4.0).abs() < 0.01, "{}", nozzle.speed);
        assert!(
            (nozzle.modulation - 0.05).abs() < 1e-3,
            "{}",
            nozzle.modulation
        );
        assert!((nozzle.flow - 3.0).abs() < 1e-9);
        assert!((breakup_length(&asked, &series) - 7.0).abs() < 1e-9);
        let short = Jet {
            window: Window { from: 3.0, to: 3.2 },
            ..asked
        };
        assert!(Nozzle::read(&short, &series).is_none());
    }
}
