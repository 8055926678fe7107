//! What is measured.

mod read;
mod wetting;

use meniscus::physics::wall::layout::Side;

pub(super) use read::measure;

/// What is measured beside the usual time series.
#[derive(Clone, Debug, PartialEq)]
pub struct Measure {
    /// The fit of a damped oscillation.
    pub oscillation: Option<Oscillation>,
    /// The pressure inside a drop at rest.
    pub static_pressure: Option<StaticPressure>,
    /// How round the first body is, and how dense.
    pub roundness: Option<Window>,
    /// What a round drop is like from its centre to its surface.
    pub drop_profile: Option<Window>,
    /// Pressure against depth.
    pub hydrostatics: Option<Hydrostatics>,
    /// The crown of a splash.
    pub crown: Option<Crown>,
    /// The angle at which a drop meets a wall.
    pub contact_angle: Option<ContactAngle>,
    /// The surface between the side walls of a tank.
    pub meniscus: Option<TankSurface>,
    /// Whether the largest extent of the first body, and the time until it is back, are read off.
    pub extremes: bool,
    /// The neck of the first body, where two drops merge or a thread thins.
    pub waist: Option<Waist>,
    /// The way the first body goes, by which its breakup is described: a vector of any length.
    pub breakup: Option<[f64; 3]>,
    /// How wide the first body spreads: the direction across which its width is taken, a vector of any
    /// length, such as the normal of a wall.
    pub spreading: Option<[f64; 3]>,
    /// Whether drops are counted: pieces of all liquid.
    pub drops: bool,
    /// A jet from a nozzle, and its drops.
    pub jet: Option<Jet>,
    /// Whether the pairs of particles across the surface of the first body are counted.
    pub mixing: bool,
    /// Pressure sensors.
    pub sensors: Vec<Sensor>,
    /// Places where the curvature of the surface is read.
    pub curvature: Vec<Sensor>,
    /// A round part of the surface, along which curvature is compared with 1 / R.
    pub curvature_along: Option<Arc>,
}

/// A damped cosine fitted to the semi-axes; its frequency gives the surface tension.
#[derive(Clone, Debug, PartialEq)]
pub struct Oscillation {
    /// Number of lobes of the mode; 2 is the ellipse.
    pub mode: u32,
    /// Start of the fit, s.
    pub from: f64,
    /// End of the fit, s.
    pub to: f64,
}

/// Time-averaged pressure inside a drop at rest; by Laplace it gives the surface tension.
#[derive(Clone, Debug, PartialEq)]
pub struct StaticPressure {
    /// When it is averaged.
    pub window: Window,
    /// Where the pressure around the drop is read, m; none for a void.
    pub outside: Option<[f64; 3]>,
}

/// Pressure against depth in a liquid at rest; the last axis points up.
#[derive(Clone, Debug, PartialEq)]
pub struct Hydrostatics {
    /// Height of the surface, m.
    pub level: f64,
    /// Depth of the liquid, m.
    pub depth: f64,
    /// Over which time it is averaged.
    pub window: Window,
}

/// A part of the run, over which something is averaged or fitted.
#[derive(Clone, Debug, PartialEq)]
pub struct Window {
    /// Its start, s.
    pub from: f64,
    /// Its end, s.
    pub to: f64,
}

/// The shape of the first body as a drop on a wall.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactAngle {
    /// The wall's surface.
    pub base: Base,
    /// What to compare with, rad.
    pub expected: Option<f64>,
    /// Over which time it is averaged.
    pub window: Window,
}

/// A wall that a drop stands on.
#[derive(Clone, Debug, PartialEq)]
pub enum Base {
    /// A flat one.
    Plane {
        /// A point of its surface, m; in 2D the third component is zero.
        point: [f64; 3],
        /// Direction from the wall to the liquid, of any length.
        normal: [f64; 3],
    },
    /// A disc or sphere, or all around it.
    Ball {
        /// Its centre, m; in 2D the third component is zero.
        centre: [f64; 3],
        /// Its radius, m.
        radius: f64,
        /// The side of the wall, which the liquid is not on.
        side: Side,
    },
}

/// The surface of all liquid between two vertical walls, the last axis upwards.
#[derive(Clone, Debug, PartialEq)]
pub struct TankSurface {
    /// Where the left and the right wall are along x, m.
    pub walls: [f64; 2],
    /// The contact angle to compare with, rad.
    pub expected: Option<f64>,
    /// sqrt(sigma / (rho g)), m; none where the shape is to tell it.
    pub capillary_length: Option<f64>,
    /// Over which time it is averaged.
    pub window: Window,
}

/// The crown that a drop throws up, with power laws fitted to its radii.
#[derive(Clone, Debug, PartialEq)]
pub struct Crown {
    /// The point of the undisturbed surface that the drop falls on, m; in 2D the third
    /// component is zero.
    pub impact: [f64; 3],
    /// Index of the body that is the layer, whose cavity is measured; none for all liquid.
    pub layer: Option<usize>,
    /// When the drop touches it, s: the start of the power laws.
    pub start: f64,
    /// Where power laws are fitted.
    pub window: Window,
}

/// A round part of a surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Arc {
    /// Its centre, m; in 2D the third component is zero.
    pub centre: [f64; 3],
    /// Radius of the outermost particles, m.
    pub radius: f64,
    /// Where it begins: the angle from the x axis, in 3D about it, rad.
    pub from: f64,
    /// Where it ends, rad.
    pub to: f64,
}

/// A plane that cuts a body.
#[derive(Clone, Debug, PartialEq)]
pub struct Waist {
    /// A point of it, m.
    pub at: [f64; 3],
    /// Its normal, of any length.
    pub normal: [f64; 3],
    /// The radius whose time is wanted, m.
    pub reaches: Option<f64>,
    /// The time at which the radius is wanted, s.
    pub time: Option<f64>,
}

/// A jet whose speed is modulated where it leaves its nozzle.
#[derive(Clone, Debug, PartialEq)]
pub struct Jet {
    /// A point of the plane in which the nozzle ends, m; in 2D the third component is zero.
    pub at: [f64; 3],
    /// The way it goes, a vector of any length.
    pub direction: [f64; 3],
    /// Radius of the nozzle, m.
    pub radius: f64,
    /// Frequency of the modulation, Hz.
    pub frequency: f64,
    /// When it is measured.
    pub window: Window,
}

/// A place where something is read.
#[derive(Clone, Debug, PartialEq)]
pub struct Sensor {
    /// Its name in the time series.
    pub name: String,
    /// Where it is, m; in 2D the third component is zero.
    pub at: [f64; 3],
}
