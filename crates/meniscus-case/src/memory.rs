//! How many particles this machine has room for.

/// Memory that one particle takes in a run, B: state, neighbour lists and
/// scratch. Measured: 655 for a million particles in 3D with surface tension and the
/// default kernel; less in 2D.
pub const BYTES_PER_PARTICLE: f64 = 700.0;

/// Most particles that fit into the memory that is free, and that memory in
/// bytes. Where the machine does not tell, what 32-bit numbers can count.
pub(crate) fn room() -> (usize, f64) {
    let most = f64::from(u32::MAX) * BYTES_PER_PARTICLE;
    let free = std::fs::read_to_string("/proc/meminfo")
        .ok()
        .and_then(|text| {
            let line = text
                .lines()
                .find(|line| line.starts_with("MemAvailable:"))?;
            line.split_whitespace().nth(1)?.parse::<f64>().ok()
        })
        .map_or(most, |kibibytes| (1024.0 * kibibytes).min(most));
    ((free / BYTES_PER_PARTICLE) as usize, free)
}
