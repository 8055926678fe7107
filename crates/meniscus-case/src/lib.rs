//! Case files: from TOML with units to plain values of the library.
//!
//! ```
//! let case = meniscus_case::Case::from_str("drop", r#"
//!     dimension = 2
//!     spacing = "0.05 mm"
//!     end_time = "10 ms"
//!
//!     [fluid.water]
//!     density = "998 kg/m^3"
//!     surface_tension = "72.8 mN/m"
//!
//!     [[body]]
//!     shape = { disc = { radius = "1 mm" } }
//! "#).unwrap();
//! assert_eq!(case.fluids[0].surface_tension, 0.0728);
//! assert_eq!(case.particles::<2>().len(), 1245);
//! ```
//!
//! A wrong file gives every mistake at once, each with its place, what was
//! found and what would be right:
//!
//! ```
//! let wrong = meniscus_case::Case::from_str("drop.toml", "dimension = 2\nspaceing = '0.05 mm'").unwrap_err();
//! assert!(wrong.to_string().contains("drop.toml:2:1"));
//! assert!(wrong.to_string().contains("did you mean `spacing`?"));
//! ```
//!
//! - `case`: the resolved case; `coefficients`: what it leaves to be measured
//! - `grammar`: what may stand in a file
//! - `read`: how a file is read, and its schema written, by one walk
//! - `resolve`, `bodies`, `walls`, `overlap`, `speed`, `memory`: from the file to particles, and whether they make sense
//! - `pairwise`, `adaptive_smoothing`, `van_der_waals`: what parts of it ask of the rest
//! - `doubts`: warnings about what can be run, but not believed
//! - `units`, `diagnostic`, `template`

mod adaptive_smoothing;
mod bodies;
mod case;
mod coefficients;
mod diagnostic;
mod doubts;
mod grammar;
mod memory;
mod overlap;
mod pairwise;
mod read;
mod resolve;
mod schema;
mod speed;
mod template;
mod units;
mod van_der_waals;
mod walls;

pub use case::{Body, Case};
pub use coefficients::{Coefficients, Given};
pub use diagnostic::{Diagnostic, Diagnostics, Severity};
pub use grammar::{
    Arc, Base, ContactAngle, Crown, Deformation, Hydrostatics, Jet, Measure, Oscillation, Output,
    Sensor, StaticPressure, TankSurface, Waist, Window,
};
pub use memory::BYTES_PER_PARTICLE;
pub use schema::schema;
pub use speed::{SpeedScales, default_sound_speed};
pub use template::template;
pub use walls::WallBody;
