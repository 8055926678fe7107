//! Figures and the HTML report.
//!
//! - [`LinePlot`]: curves, points, theory lines and bands of uncertainty;
//! - [`ParticlePictures`]: the particles at chosen times, coloured by what
//!   they carry;
//! - [`Movie`]: the same, one after another;
//! - [`Report`]: one self-contained page with tables and figures.
//!
//! Everything works on plain numbers in SI units; axes and tables choose the
//! SI prefix. A [`Figure`] is a list of marks that is printed as SVG and drawn
//! as PNG, so both show the same. Text in the PNG is set in Arimo, whose
//! widths are Arial's, and which travels inside this crate: no font of the
//! system is needed. See `font/OFL.txt` for its licence.
//!
//! ```
//! use meniscus_report::{Axis, Curve, Figure, LinePlot};
//!
//! let time: Vec<f64> = (0..200).map(|i| f64::from(i) * 1e-5).collect();
//! let axis: Vec<f64> = time.iter().map(|t| 5e-5 + 1e-6 * (3e3 * t).cos()).collect();
//! let figure: Figure = LinePlot::new(Axis::new("Time", "s"), Axis::new("Semi-axis", "m"))
//!     .with(Curve::line("computed", &time, &axis))
//!     .figure("axes", "Semi-axis against time.");
//! assert!(figure.svg()?.contains("Time (ms)"));
//! # Ok::<(), meniscus_report::FigureError>(())
//! ```

mod colour;
mod figure;
mod movie;
pub mod number;
mod particles;
mod plot;
mod report;
mod scene;

pub use colour::{Colour, PALETTE};
pub use figure::{Figure, FigureError};
pub use movie::Movie;
pub use particles::{Direction, ParticlePictures, Snapshot, View};
pub use plot::{Axis, Curve, LinePlot, Scale};
pub use report::{Report, ResultRow};
