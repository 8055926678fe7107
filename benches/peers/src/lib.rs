//! The case that all codes run, and how they report: a cube of water, 1 cm
//! wide, particles on a square lattice, left to its surface tension.

/// Width of the cube, m.
pub const WIDTH: f64 = 0.01;
/// Density, kg/m^3.
pub const DENSITY: f64 = 1000.0;
/// Surface tension, N/m.
pub const SURFACE_TENSION: f64 = 0.0728;
/// Numerical speed of sound, m/s, of the weakly compressible codes: over ten times the fastest corner.
pub const SOUND_SPEED: f64 = 5.0;
/// Radius of the kernel's support over the spacing: about 75 neighbours inside.
pub const SUPPORT: f64 = 2.62;

/// What the command line asks for.
pub struct Case {
    /// Particles along an edge.
    pub edge: usize,
    /// Steps before the clock runs.
    pub warm_up: usize,
    /// Steps that are timed.
    pub steps: usize,
    /// Step, s.
    pub time_step: f64,
    /// All that follows.
    pub rest: Vec<String>,
}

impl Case {
    /// Reads `edge warm_up steps time_step`.
    pub fn from_arguments() -> Result<Self, String> {
        let mut arguments = std::env::args().skip(1);
        let mut number = |name: &str| -> Result<f64, String> {
            let text = arguments.next().ok_or(format!(
                "{name} is missing; wanted: edge warm_up steps time_step"
            ))?;
            text.parse()
                .map_err(|_| format!("{name} is '{text}', which is no number"))
        };
        Ok(Self {
            edge: number("edge")? as usize,
            warm_up: number("warm_up")? as usize,
            steps: number("steps")? as usize,
            time_step: number("time_step")?,
            rest: arguments.collect(),
        })
    }

    /// Distance of particles, m.
    pub fn spacing(&self) -> f64 {
        WIDTH / self.edge as f64
    }

    /// Places of the particles about the origin, m.
    pub fn lattice(&self) -> Vec<[f64; 3]> {
        let n = self.edge;
        let place = |k: usize| (k as f64 + 0.5) * self.spacing() - 0.5 * WIDTH;
        (0..n * n * n)
            .map(|k| [place(k / (n * n)), place(k / n % n), place(k % n)])
            .collect()
    }

    /// Prints the result, as JSON on one line: what `positions` (m, at the
    /// end) tell, and neighbours within `support` spacings.
    pub fn report(&self, version: &str, seconds: f64, support: f64, positions: &[[f64; 3]]) {
        let neighbours = neighbours(positions, support * self.spacing());
        let extent = |d: usize| {
            let along = || positions.iter().map(|x| x[d]);
            along().fold(f64::MIN, f64::max) - along().fold(f64::MAX, f64::min)
        };
        let far = positions
            .iter()
            .map(|x| x.iter().map(|x| x * x).sum::<f64>().sqrt())
            .fold(0.0, f64::max);
        println!(
            r#"{{"version": "{version}", "particles": {}, "steps": {}, "seconds": {seconds}, "time_step": {}, "neighbours": {neighbours}, "extent": {}, "farthest": {far}}}"#,
            positions.len(),
            self.steps,
            self.time_step,
            extent(0),
        );
    }
}

/// Mean number of other particles nearer than `support`.
pub fn neighbours(positions: &[[f64; 3]], support: f64) -> f64 {
    let cell = |x: &[f64; 3]| x.map(|x| (x / support).floor() as i64);
    let mut cells = std::collections::HashMap::<[i64; 3], Vec<usize>>::new();
    for (i, x) in positions.iter().enumerate() {
        cells.entry(cell(x)).or_default().push(i);
    }
    let near = |a: &[f64; 3], b: &[f64; 3]| {
        (0..3).map(|d| (a[d] - b[d]).powi(2)).sum::<f64>() < support * support
    };
    let mut pairs = 0;
    for x in positions {
        let home = cell(x);
        for k in 0..27 {
            let beside = [
                home[0] + k / 9 - 1,
                home[1] + k / 3 % 3 - 1,
                home[2] + k % 3 - 1,
            ];
            for &j in cells.get(&beside).map_or(&[][..], Vec::as_slice) {
                pairs += near(x, &positions[j]) as usize;
            }
        }
    }
    // Each particle has met itself.
    pairs as f64 / positions.len() as f64 - 1.0
}
