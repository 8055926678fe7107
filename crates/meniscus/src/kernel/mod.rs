//! Smoothing kernels.
//!
//! Every kernel is W(r, h) = C_D / h^D w(q) with q = r / h, zero from
//! q = [`SmoothingKernel::SUPPORT`] on. A kernel's file states its shape w(q),
//! its constants C_2 and C_3, and its source.

mod cubic_spline;
mod lucy_quartic;
mod quintic_spline;
#[cfg(test)]
mod tests;
mod truncated_gaussian;
mod wendland_c2;
mod wendland_c4;

pub use cubic_spline::CubicSpline;
pub use lucy_quartic::LucyQuartic;
pub use quintic_spline::QuinticSpline;
pub use truncated_gaussian::TruncatedGaussian;
pub use wendland_c2::WendlandC2;
pub use wendland_c4::WendlandC4;

use crate::real::Real;

/// The shape of a smoothing kernel, as formulas over any [`Real`].
pub trait SmoothingKernel: Copy + Send + Sync + 'static {
    /// The name in case files and tables.
    const NAME: &'static str;

    /// Radius of the support over the smoothing length h.
    const SUPPORT: f64;

    /// The constant C_D that makes the integral over 2 or 3 dimensions one.
    fn normalisation(dimension: usize) -> f64;

    /// w(q), for any q >= 0; zero outside the support.
    fn shape<R: Real>(q: R) -> R;

    /// (1/q) dw/dq, for any q >= 0, finite at q = 0; zero outside the support.
    fn slope_over_q<R: Real>(q: R) -> R;

    /// Whether w is better evaluated from q^2, without a root.
    const FROM_SQUARE: bool = false;

    /// w from q^2.
    #[inline(always)]
    fn shape_from_square<R: Real>(square: R) -> R {
        Self::shape(square.sqrt())
    }

    /// (1/q) dw/dq from q^2.
    #[inline(always)]
    fn slope_over_q_from_square<R: Real>(square: R) -> R {
        Self::slope_over_q(square.sqrt())
    }
}

/// The kernels on offer, chosen at run time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kernel {
    /// [`CubicSpline`]
    CubicSpline,
    /// [`QuinticSpline`]
    QuinticSpline,
    /// [`TruncatedGaussian`]
    TruncatedGaussian,
    /// [`LucyQuartic`]
    LucyQuartic,
    /// [`WendlandC2`]
    WendlandC2,
    /// [`WendlandC4`]
    WendlandC4,
}

/// Runs `$body` with the type `$K` bound to the kernel that `$kernel` names.
macro_rules! with_kernel {
    ($kernel:expr, $K:ident => $body:expr) => {
        match $kernel {
            $crate::kernel::Kernel::CubicSpline => {
                type $K = $crate::kernel::CubicSpline;
                $body
            }
            $crate::kernel::Kernel::QuinticSpline => {
                type $K = $crate::kernel::QuinticSpline;
                $body
            }
            $crate::kernel::Kernel::TruncatedGaussian => {
                type $K = $crate::kernel::TruncatedGaussian;
                $body
            }
            $crate::kernel::Kernel::LucyQuartic => {
                type $K = $crate::kernel::LucyQuartic;
                $body
            }
            $crate::kernel::Kernel::WendlandC2 => {
                type $K = $crate::kernel::WendlandC2;
                $body
            }
            $crate::kernel::Kernel::WendlandC4 => {
                type $K = $crate::kernel::WendlandC4;
                $body
            }
        }
    };
}
pub(crate) use with_kernel;

impl Kernel {
    /// Every kernel on offer.
    pub const ALL: [Kernel; 6] = [
        Kernel::CubicSpline,
        Kernel::QuinticSpline,
        Kernel::TruncatedGaussian,
        Kernel::LucyQuartic,
        Kernel::WendlandC2,
        Kernel::WendlandC4,
    ];

    /// The name in case files and tables, such as "cubic-spline".
    pub fn name(self) -> &'static str {
        with_kernel!(self, K => K::NAME)
    }

    /// Radius of the support over the smoothing length.
    pub fn support(self) -> f64 {
        with_kernel!(self, K => K::SUPPORT)
    }

    /// The constant C_D that makes the integral over 2 or 3 dimensions one.
    pub fn normalisation(self, dimension: usize) -> f64 {
        with_kernel!(self, K => K::normalisation(dimension))
    }

    /// W(r, h) in 1/m^D for a distance `r` and smoothing length `h` in metres.
    pub fn value(self, r: f64, h: f64, dimension: usize) -> f64 {
        with_kernel!(self, K => K::normalisation(dimension) / h.powi(dimension as i32) * K::shape(r / h))
    }

    /// dW/dr in 1/m^(D+1) for a distance `r` and smoothing length `h` in metres.
    pub fn slope(self, r: f64, h: f64, dimension: usize) -> f64 {
        let q = r / h;
        with_kernel!(self, K => {
            K::normalisation(dimension) / h.powi(dimension as i32 + 1) * K::slope_over_q(q) * q
        })
    }
}
