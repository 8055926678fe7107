//! The resolved case.

use std::path::Path;

use meniscus::scheme::{Fluid, Scheme};
use meniscus::{Domain, Particle, Setup, Vector};

use crate::coefficients::{Coefficients, Given};
use crate::diagnostic::{Diagnostic, Diagnostics, Severity};
use crate::grammar::{Deformation, Measure, Output};
use crate::resolve::resolve;
use crate::speed::SpeedScales;
use crate::walls::WallBody;

/// A case file as read, with every default filled in. All SI.
#[derive(Clone, Debug)]
pub struct Case {
    /// Name of the file, without its ending.
    pub name: String,
    /// A line that names the case in reports.
    pub title: Option<String>,
    /// What the case is about.
    pub description: Option<String>,
    /// Dimensions of space: 2 or 3.
    pub dimension: usize,
    /// Distance between particles, m.
    pub spacing: f64,
    /// Simulated time, s.
    pub end_time: f64,
    /// What is solved, and how.
    pub scheme: Scheme,
    /// The liquids.
    pub fluids: Vec<Fluid>,
    /// The bodies of liquid at the start.
    pub bodies: Vec<Body>,
    /// The walls, in the order of the scheme's.
    pub walls: Vec<WallBody>,
    /// Lowest and highest coordinate, m, of each periodic direction.
    pub periodic: [Option<(f64, f64)>; 3],
    /// A change of shape on the way, if there is one.
    pub deformation: Option<Deformation>,
    /// How often results are written.
    pub output: Output,
    /// What is measured beside the usual.
    pub measure: Measure,
    /// The speeds that the case shows, from which sound speeds are chosen.
    pub speeds: SpeedScales,
    /// Which numbers the file states itself.
    pub given: Given,
    /// What may not be as meant.
    pub warnings: Diagnostics,
    pub(crate) particles: Vec<Particle<3>>,
    pub(crate) resolved: String,
}

/// A body of liquid at the start.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// Its name.
    pub name: String,
    /// Index of its fluid.
    pub fluid: usize,
    /// Number of its particles.
    pub particles: usize,
    /// Volume of its particles, m^3; in 2D their area, m^2.
    pub volume: f64,
    /// Mass, kg; in 2D per length, kg/m.
    pub mass: f64,
}

impl Case {
    /// Reads a case file.
    ///
    /// # Errors
    /// Everything that is wrong with the file, or that it cannot be read.
    pub fn from_file(path: &Path) -> Result<Self, Diagnostics> {
        Self::from_file_with(path, &Coefficients::default())
    }

    /// Reads a case file, with coefficients that were measured where it gives none.
    ///
    /// # Errors
    /// As [`from_file`](Self::from_file).
    pub fn from_file_with(path: &Path, measured: &Coefficients) -> Result<Self, Diagnostics> {
        let shown = path.display().to_string();
        let source = std::fs::read(path)
            .map_err(|error| error.to_string())
            .and_then(|bytes| {
                String::from_utf8(bytes).map_err(|error| format!("not UTF-8 text: {error}"))
            });
        match source {
            Ok(source) => Self::from_str_with(&shown, &source, measured),
            Err(reason) => {
                let problem = Diagnostic {
                    severity: Severity::Error,
                    message: format!("cannot read {shown}: {reason}"),
                    label: String::new(),
                    help: None,
                    span: None,
                };
                Err(Diagnostics::new(&shown, "", vec![problem]))
            }
        }
    }

    /// Reads a case from text; `name` is what diagnostics call the file.
    ///
    /// # Errors
    /// Everything that is wrong with the text.
    pub fn from_str(name: &str, source: &str) -> Result<Self, Diagnostics> {
        Self::from_str_with(name, source, &Coefficients::default())
    }

    /// Reads a case from text, with coefficients that were measured where it gives none.
    ///
    /// # Errors
    /// As [`from_str`](Self::from_str).
    pub fn from_str_with(
        name: &str,
        source: &str,
        measured: &Coefficients,
    ) -> Result<Self, Diagnostics> {
        resolve(name, source, measured)
    }

    /// The particles at the start, those of walls last. `D` is the case's dimension.
    pub fn particles<const D: usize>(&self) -> Vec<Particle<D>> {
        self.particles
            .iter()
            .map(|p| Particle {
                position: Vector::from_3d(p.position.0),
                velocity: Vector::from_3d(p.velocity.0),
                mass: p.mass,
                fluid: p.fluid,
                body: p.body,
            })
            .collect()
    }

    /// Everything that a simulation starts from. `D` is the case's dimension.
    pub fn setup<const D: usize>(&self) -> Setup<D> {
        Setup {
            scheme: self.scheme.clone(),
            fluids: self.fluids.clone(),
            particles: self.particles(),
            spacing: self.spacing,
            domain: Domain {
                periodic: std::array::from_fn(|d| self.periodic[d]),
            },
        }
    }

    /// Number of particles, of fluid and walls.
    pub fn particle_count(&self) -> usize {
        self.particles.len()
    }

    /// The case as TOML with every default written out: a case file that
    /// gives the same values.
    pub fn to_toml(&self) -> &str {
        &self.resolved
    }
}
