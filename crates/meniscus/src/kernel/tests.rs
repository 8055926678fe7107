//! What every kernel promises, in two and three dimensions.

use std::f64::consts::PI;

use super::Kernel;

/// Composite Simpson's rule over [0, support], with every knot of every kernel
/// (whole q) on a node: error about (1e-3)^4.
fn integral(kernel: Kernel, dimension: usize) -> f64 {
    let per_unit = 1000;
    let n = per_unit * kernel.support() as usize;
    let step = 1.0 / per_unit as f64;
    let f = |i: usize| {
        let q = i as f64 * step;
        let sphere = if dimension == 2 {
            2.0 * PI * q
        } else {
            4.0 * PI * q * q
        };
        // A smoothing length other than one, so that its powers are tested too.
        let h = 0.3;
        kernel.value(q * h, h, dimension) * h.powi(dimension as i32) * sphere
    };
    (0..n)
        .step_by(2)
        .map(|i| step / 3.0 * (f(i) + 4.0 * f(i + 1) + f(i + 2)))
        .sum()
}

fn each() -> impl Iterator<Item = (Kernel, usize)> {
    Kernel::ALL
        .into_iter()
        .flat_map(|kernel| [(kernel, 2), (kernel, 3)])
}

#[test]
fn integrates_to_one() {
    for (kernel, dimension) in each() {
        // The Gaussian keeps the constant of the whole Gaussian; what lies beyond
        // q = 3 is exp(-9) in 2D, erfc(3) + 6 exp(-9) / sqrt(pi) in 3D.
        let missing = match (kernel, dimension) {
            (Kernel::TruncatedGaussian, 2) => (-9.0_f64).exp(),
            (Kernel::TruncatedGaussian, _) => {
                2.209_049_699_858_544e-5 + 6.0 * (-9.0_f64).exp() / PI.sqrt()
            }
            _ => 0.0,
        };
        let error = integral(kernel, dimension) - (1.0 - missing);
        assert!(
            error.abs() < 1e-11,
            "{}, {dimension}D: {error:e}",
            kernel.name()
        );
    }
}

#[test]
fn slope_is_the_derivative_of_the_value() {
    // A central difference over 2e-5 h errs by about 1e-10 w''' and 1e-11 of
    // rounding, in units of the kernel's height; w''' of the steepest is below 100.
    // At the knots of a cubic w''' jumps, which changes the factor only.
    let (h, d) = (0.3, 1e-5);
    for (kernel, dimension) in each() {
        let height = kernel.value(0.0, h, dimension) / h;
        for i in 1..400 {
            let q = f64::from(i) * 0.01 * kernel.support() / 3.99;
            if q + d >= kernel.support() {
                continue;
            }
            let difference = (kernel.value((q + d) * h, h, dimension)
                - kernel.value((q - d) * h, h, dimension))
                / (2.0 * d * h);
            let error = (kernel.slope(q * h, h, dimension) - difference) / height;
            assert!(
                error.abs() < 2e-9,
                "{}, {dimension}D, q = {q}: {error:e}",
                kernel.name()
            );
        }
    }
}

#[test]
fn slope_over_q_is_finite_and_exact_towards_the_centre() {
    // w is even and smooth at the centre: (1/q) dw/dq tends to w''(0), and departs
    // from it by at most w'''(0) q, below 100 q.
    for kernel in Kernel::ALL {
        super::with_kernel!(kernel, K => {
            use super::SmoothingKernel;
            let at_centre = K::slope_over_q(0.0_f64);
            let second = 2.0 * (K::shape(1e-4_f64) - K::shape(0.0_f64)) / 1e-8;
            assert!((at_centre / second - 1.0).abs() < 1e-3, "{}", K::NAME);
            for exponent in 6..300 {
                let q = 10.0_f64.powi(-exponent);
                let relative = K::slope_over_q(q) / at_centre - 1.0;
                assert!(relative.abs() <= 100.0 * q + 1e-15, "{}, q = {q:e}", K::NAME);
            }
        });
    }
}

#[test]
fn zero_at_and_beyond_the_support_and_continuous_there() {
    for (kernel, dimension) in each() {
        let h = 1.0;
        for beyond in [1.0 + 1e-9, 1.5, 4.0, 1e3, 1e8] {
            let r = kernel.support() * beyond;
            assert_eq!(
                kernel.value(r, h, dimension),
                0.0,
                "{} at {r}",
                kernel.name()
            );
            assert_eq!(
                kernel.slope(r, h, dimension),
                0.0,
                "{} at {r}",
                kernel.name()
            );
        }
        // The Gaussian is cut where it has fallen to exp(-9): a jump, as documented.
        let height = kernel.value(0.0, h, dimension);
        let jump = if kernel == Kernel::TruncatedGaussian {
            (-9.0_f64).exp()
        } else {
            0.0
        };
        let just_inside = kernel.support() * (1.0 - 1e-6);
        let value = kernel.value(just_inside, h, dimension) / height;
        let slope = kernel.slope(just_inside, h, dimension) / height;
        assert!((value - jump).abs() < 1e-8, "{}: {value:e}", kernel.name());
        assert!(
            (slope + 6.0 * jump).abs() < 1e-7,
            "{}: {slope:e}",
            kernel.name()
        );
    }
}

#[test]
fn positive_and_falling_all_the_way() {
    for (kernel, dimension) in each() {
        let mut before = kernel.value(0.0, 1.0, dimension);
        for i in 1..1000 {
            let r = kernel.support() * f64::from(i) * 1e-3;
            let value = kernel.value(r, 1.0, dimension);
            assert!(value > 0.0 && value < before, "{} at {r}", kernel.name());
            assert!(
                kernel.slope(r, 1.0, dimension) < 0.0,
                "{} at {r}",
                kernel.name()
            );
            before = value;
        }
    }
}

#[test]
fn names_are_distinct() {
    let mut names: Vec<_> = Kernel::ALL.iter().map(|kernel| kernel.name()).collect();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), Kernel::ALL.len());
}
