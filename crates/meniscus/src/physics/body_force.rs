//! Acceleration of gravity, or of a shaken frame, as a function of time.

/// Acceleration of the frame or of gravity, m/s^2. In 2D the third component is ignored.
#[derive(Clone, Debug, PartialEq)]
pub enum BodyForce {
    /// The same at all times.
    Constant([f64; 3]),
    /// mean + amplitude sin(2 pi frequency t + phase); Hz, rad.
    Oscillating {
        /// Constant part.
        mean: [f64; 3],
        /// Oscillating part.
        amplitude: [f64; 3],
        /// Frequency, Hz.
        frequency: f64,
        /// Phase at t = 0, rad.
        phase: f64,
    },
    /// Straight lines between (time in s, acceleration); constant before the first and after the last.
    Table(Vec<(f64, [f64; 3])>),
}

impl BodyForce {
    /// Acceleration in m/s^2 at `time` in s.
    ///
    /// ```
    /// use meniscus::scheme::BodyForce;
    /// let ramp = BodyForce::Table(vec![(0.0, [0.0; 3]), (2.0, [0.0, -10.0, 0.0])]);
    /// assert_eq!(ramp.at(1.0), [0.0, -5.0, 0.0]);
    /// assert_eq!(ramp.at(9.0), [0.0, -10.0, 0.0]);
    /// ```
    pub fn at(&self, time: f64) -> [f64; 3] {
        match self {
            BodyForce::Constant(g) => *g,
            BodyForce::Oscillating {
                mean,
                amplitude,
                frequency,
                phase,
            } => {
                let factor = (std::f64::consts::TAU * frequency * time + phase).sin();
                std::array::from_fn(|d| mean[d] + factor * amplitude[d])
            }
            BodyForce::Table(rows) => interpolate(rows, time),
        }
    }

    /// Whether all its numbers are finite and the times of a table do not fall.
    pub(crate) fn is_sound(&self) -> bool {
        let finite = |numbers: &[f64]| numbers.iter().all(|x| x.is_finite());
        match self {
            BodyForce::Constant(g) => finite(g),
            BodyForce::Oscillating {
                mean,
                amplitude,
                frequency,
                phase,
            } => finite(mean) && finite(amplitude) && finite(&[*frequency, *phase]),
            BodyForce::Table(rows) => {
                rows.iter().all(|(t, a)| t.is_finite() && finite(a))
                    && rows.is_sorted_by_key(|row| row.0)
            }
        }
    }
}

fn interpolate(rows: &[(f64, [f64; 3])], time: f64) -> [f64; 3] {
    let after = rows.partition_point(|row| row.0 <= time);
    match (after.checked_sub(1).map(|k| rows[k]), rows.get(after)) {
        (Some((t0, a)), Some(&(t1, b))) => {
            let weight = (time - t0) / (t1 - t0);
            std::array::from_fn(|d| a[d] + weight * (b[d] - a[d]))
        }
        (Some((_, a)), None) => a,
        (None, Some(&(_, b))) => b,
        (None, None) => [0.0; 3],
    }
}
