//! One run of the suite: a case in units of its own (density, surface tension and radius one), and
//! what is read from it.

use meniscus_case::{Case, Coefficients};
use meniscus_output::{FrameReader, RunFolder, Series};

use super::model::Model;
use crate::failure::Failure;
use crate::findings::Finding;

/// How the particles lie at first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Start {
    /// Close packed, rows along x; square or cubic beside walls, in rings or shells beside round ones.
    Lattice,
    /// The same turned by 17 degrees, in space about (1, 2, 3).
    Rotated,
    /// The lattice with each coordinate moved by up to a tenth of a spacing, by this seed.
    Jittered(u32),
}

impl Start {
    /// Its name in tables and files.
    pub fn name(self) -> String {
        match self {
            Start::Lattice => "lattice".into(),
            Start::Rotated => "rotated".into(),
            Start::Jittered(seed) => format!("jittered-{seed}"),
        }
    }

    /// The value of `arrangement`.
    fn arrangement(self, dimension: usize, beside: Beside) -> String {
        let (pattern, origin) = match (dimension, beside, self) {
            (2, Beside::Nothing, _) => ("triangular", ""),
            (_, Beside::Nothing, _) => ("hexagonal", ""),
            (2, Beside::Floor, Start::Lattice | Start::Jittered(_)) => {
                ("square", "origin = [\"0.5 dx\", \"0.5 dx\"]")
            }
            (_, Beside::Floor, Start::Lattice | Start::Jittered(_)) => {
                ("cubic", "origin = [\"0.5 dx\", \"0.5 dx\", \"0.5 dx\"]")
            }
            (2, Beside::Ball, Start::Lattice | Start::Jittered(_)) => ("rings", "origin = [0, 0]"),
            (_, Beside::Ball, Start::Lattice | Start::Jittered(_)) => {
                ("shells", "origin = [0, 0, 0]")
            }
            (2, ..) => ("square", ""),
            _ => ("cubic", ""),
        };
        let turned = match dimension {
            2 => "\"17 deg\"",
            _ => "{ axis = [1, 2, 3], angle = \"17 deg\" }",
        };
        match self {
            Start::Lattice if origin.is_empty() => format!("\"{pattern}\""),
            Start::Lattice => format!("{{ {pattern} = {{ {origin} }} }}"),
            Start::Rotated => format!("{{ {pattern} = {{ rotation = {turned} }} }}"),
            Start::Jittered(seed) => {
                let comma = if origin.is_empty() { "" } else { ", " };
                format!("{{ {pattern} = {{ {origin}{comma}jitter = 0.1, seed = {seed} }} }}")
            }
        }
    }
}

/// What a liquid starts beside.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Beside {
    /// It is free, and close packed.
    #[default]
    Nothing,
    /// Walls along the axes, which a square or cubic lattice fits.
    Walls,
    /// A floor at zero, on which the first row of a square or cubic lattice lies.
    Floor,
    /// A round wall about the origin, which rings or shells fit, but not where they are turned: then
    /// it is a square or cubic lattice.
    Ball,
}

/// A run to come.
pub struct Trial {
    /// Which test of the suite.
    pub test: &'static str,
    /// The model.
    pub model: Model,
    /// 2 or 3.
    pub dimension: usize,
    /// Spacings in the radius.
    pub resolution: u32,
    /// What else sets it apart, such as "La 1200"; empty where nothing does.
    pub variant: String,
    /// How it starts.
    pub start: Start,
    /// Liquid, walls, physics beyond the model, measurements: what the test adds to the case.
    pub flow: Flow,
    /// What is read from it.
    pub readings: Vec<Reading>,
}

/// What a test adds to a case file.
#[derive(Clone, Debug, Default)]
pub struct Flow {
    /// Dynamic viscosity.
    pub viscosity: f64,
    /// How long.
    pub end_time: f64,
    /// What it starts beside.
    pub beside: Beside,
    /// Shapes of the bodies, and further lines of each.
    pub bodies: Vec<(String, String)>,
    /// Lines of `[physics]`.
    pub physics: String,
    /// Tables to come last: walls, periodic axes, `[measure]`.
    pub rest: String,
    /// Numerical speed of sound, where the default would not do.
    pub sound_speed: Option<f64>,
}

/// A number that a run gives: zero is right, and the sign says which way it is wrong.
pub struct Reading {
    /// What it is.
    pub quantity: &'static str,
    /// Its unit: "%", "deg", or none.
    pub unit: &'static str,
    /// The size that it should stay below.
    pub bar: Option<f64>,
    /// How it is found.
    pub read: fn(&Evidence<'_>) -> Option<f64>,
}

/// What a run left.
pub struct Evidence<'a> {
    /// The case.
    pub case: &'a Case,
    /// Its numbers.
    pub findings: &'a [Finding],
    /// Its series.
    pub series: &'a Series,
    /// Its files.
    pub folder: &'a RunFolder,
}

impl Evidence<'_> {
    /// The finding of this identity.
    pub fn finding(&self, id: &str) -> Option<&Finding> {
        self.findings.iter().find(|found| found.id == id)
    }

    /// Per cent by which a finding is larger than what it is compared with.
    pub fn percent_above(&self, id: &str) -> Option<f64> {
        let found = self.finding(id)?;
        let (_, right) = found.reference.as_ref()?;
        Some(100.0 * (found.computed / right - 1.0))
    }

    /// The frames.
    pub fn frames(&self) -> Option<FrameReader> {
        FrameReader::open(&self.folder.frames_folder()).ok()
    }
}

impl Trial {
    /// A name that no other run has.
    pub fn name(&self) -> String {
        let variant = self.variant.replace([' ', ','], "-");
        [
            self.test.replace(' ', "-"),
            format!("{}d", self.dimension),
            variant,
            self.resolution.to_string(),
            self.start.name(),
            self.model.name.to_owned(),
        ]
        .into_iter()
        .filter(|part| !part.is_empty())
        .collect::<Vec<_>>()
        .join("-")
    }

    /// The case file.
    pub fn text(&self) -> String {
        let Flow {
            viscosity,
            end_time,
            beside,
            bodies,
            physics,
            rest,
            sound_speed,
        } = &self.flow;
        let bodies: String = bodies
            .iter()
            .map(|(shape, more)| {
                let arrangement = self.start.arrangement(self.dimension, *beside);
                format!("\n[[body]]\nshape = {shape}\narrangement = {arrangement}\n{more}")
            })
            .collect();
        let sound_speed = sound_speed.map_or_else(String::new, |c| format!("sound_speed = {c}\n"));
        format!(
            "# A run of `meniscus appraise`: density, surface tension and radius are one.\n\
             dimension = {}\nspacing = {}\nend_time = {end_time}\n\n\
             [fluid.liquid]\ndensity = 1\nsurface_tension = 1\nviscosity = {viscosity}\n{sound_speed}\
             {bodies}\n[physics]\n{}{physics}\n[output]\nframes = {end_time}\nseries = {}\n\
             checkpoints = {end_time}\n{rest}",
            self.dimension,
            1.0 / f64::from(self.resolution),
            self.model.physics(),
            end_time / 1000.0,
        )
    }

    /// The case, with these coefficients.
    ///
    /// # Errors
    /// If the model does not take it.
    pub fn case(&self, measured: &Coefficients) -> Result<Case, Failure> {
        let name = self.name();
        let mut case = Case::from_str_with(&format!("{name}.toml"), &self.text(), measured)?;
        case.name = name;
        Ok(case)
    }
}
