//! Plots of one quantity against another.
//!
//! [`Axis`] says what is shown and how it is scaled, [`Curve`] what is drawn;
//! [`LinePlot`] lays both out. `ticks` finds round numbers for the axes.

mod axis;
mod curve;
mod line_plot;
pub(crate) mod ticks;

pub use axis::{Axis, Scale};
pub use curve::Curve;
pub use line_plot::LinePlot;
