//! What the machine says of itself. Linux tells; elsewhere little is known.

use std::fs;

use serde::Serialize;

/// The machine.
#[derive(Clone, Debug, Serialize)]
pub struct Machine {
    /// Name of the processor, if it is told.
    pub processor: Option<String>,
    /// Threads that may run at once.
    pub cores: usize,
    /// Data caches of the first core, from the smallest.
    pub caches: Vec<Cache>,
}

/// A data cache.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Cache {
    /// 1, 2, 3.
    pub level: u8,
    /// Size, B.
    pub bytes: usize,
}

impl Machine {
    /// This one.
    pub fn here() -> Self {
        let processor = fs::read_to_string("/proc/cpuinfo").ok().and_then(|text| {
            let line = text.lines().find(|line| line.starts_with("model name"))?;
            Some(line.split_once(':')?.1.trim().to_owned())
        });
        Self {
            processor,
            cores: std::thread::available_parallelism().map_or(1, usize::from),
            caches: (0..8).filter_map(cache).collect(),
        }
    }

    /// Size of the largest cache, B.
    pub fn largest_cache(&self) -> Option<usize> {
        self.caches.iter().map(|cache| cache.bytes).max()
    }
}

/// Cache `index` of the first core, if there is one and it holds data.
fn cache(index: usize) -> Option<Cache> {
    let read = |what: &str| {
        let path = format!("/sys/devices/system/cpu/cpu0/cache/index{index}/{what}");
        Some(fs::read_to_string(path).ok()?.trim().to_owned())
    };
    if read("type")? == "Instruction" {
        return None;
    }
    let kibibytes: usize = read("size")?.strip_suffix('K')?.parse().ok()?;
    Some(Cache {
        level: read("level")?.parse().ok()?,
        bytes: 1024 * kibibytes,
    })
}

/// Memory that is free for use, B, if it is told.
pub fn free_memory() -> Option<f64> {
    kibibytes("/proc/meminfo", "MemAvailable:")
}

/// Memory that this process has now, and has had at most, B, if it is told.
pub fn resident() -> Option<(f64, f64)> {
    let status = "/proc/self/status";
    Some((kibibytes(status, "VmRSS:")?, kibibytes(status, "VmHWM:")?))
}

fn kibibytes(path: &str, name: &str) -> Option<f64> {
    let text = fs::read_to_string(path).ok()?;
    let line = text.lines().find(|line| line.starts_with(name))?;
    let number: f64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(1024.0 * number)
}
