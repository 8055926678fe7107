//! Plots of one quantity against another.
//!
//! [`Axis`] says what is shown and how it is scaled, [`Curve`] what is drawn;
//! [`LinePlot`] lays both out. `frame` draws the axes, `ticks` finds round
//! numbers for them.

mod axis;
mod curve;
mod frame;
mod line_plot;
pub(crate) mod ticks;

pub use axis::{Axis, Scale};
pub use curve::Curve;
pub use line_plot::LinePlot;
