//! How far a drop spreads that hits a dry wall: largest diameter over that of the drop.
//!
//! Correlations, with the Weber number We = rho v^2 D / sigma and the Reynolds number Re = rho v D / mu
//! of the impact. They differ from each other by some ten per cent: take them as a band.

/// Laan, de Bruin, Bartolo, Josserand and Bonn (2014), Phys. Rev. Applied 2, 044018: between capillary and
/// viscous spreading, with P = We / Re^(2/5), Re^(1/5) P^(1/2) / (1.24 + P^(1/2)).
///
/// ```
/// // Viscous drops approach Re^(1/5).
/// let wide = meniscus::theory::spreading_laan(1e9, 32.0);
/// assert!((wide - 2.0).abs() < 1e-3);
/// ```
pub fn spreading_laan(weber: f64, reynolds: f64) -> f64 {
    let root = (weber / reynolds.powf(0.4)).sqrt();
    reynolds.powf(0.2) * root / (1.24 + root)
}

/// Roisman (2009), Phys. Fluids 21, 052104: 0.87 Re^(1/5) - 0.40 Re^(2/5) We^(-1/2).
///
/// ```
/// assert!((meniscus::theory::spreading_roisman(100.0, 1024.0) - 2.84).abs() < 1e-9);
/// ```
pub fn spreading_roisman(weber: f64, reynolds: f64) -> f64 {
    0.87 * reynolds.powf(0.2) - 0.4 * reynolds.powf(0.4) / weber.sqrt()
}

/// Pasandideh-Fard, Qiao, Chandra and Mostaghimi (1996), Phys. Fluids 8, 650, by a balance of energy:
/// the root of (We + 12) / (3 (1 - cos(theta)) + 4 We / Re^(1/2)), theta (rad) the advancing contact angle.
///
/// ```
/// // Nothing moves, nothing is dissipated: on a wall of 180 degrees surface energy alone
/// // gives the factor sqrt(2).
/// let found = meniscus::theory::spreading_pasandideh_fard(0.0, 1.0, std::f64::consts::PI);
/// assert!((found - 2.0_f64.sqrt()).abs() < 1e-12);
/// ```
pub fn spreading_pasandideh_fard(weber: f64, reynolds: f64, contact_angle: f64) -> f64 {
    let lost = 3.0 * (1.0 - contact_angle.cos()) + 4.0 * weber / reynolds.sqrt();
    ((weber + 12.0) / lost).sqrt()
}
