//! Laying panels of one size side by side.

use super::TITLE;
use super::view::Seen;
use crate::number::in_reach;
use crate::scene::Rect;

/// Widest and highest that the panels together become, pixels.
const WIDTH: f64 = 720.0;
const HEIGHT: f64 = 520.0;
/// Narrowest figure in which the colour bar finds room.
const NARROWEST: f64 = 440.0;
const GAP: f64 = 12.0;
/// Empty border at the sides.
const SIDE: f64 = 8.0;

/// Panels of common extent and scale.
pub(super) struct Panels {
    /// Width of the figure, pixels.
    pub width: f64,
    /// Pixels to the metre.
    pub scale: f64,
    /// Extent of a panel, m: left, bottom, width, height.
    extent: [f64; 4],
    columns: usize,
    rows: usize,
}

impl Panels {
    /// Room for `count` panels, each of which may show any of `seen`.
    pub fn new(seen: &[Vec<Seen>], count: usize) -> Self {
        let extent = extent(seen);
        let count = count.max(1);
        let fit = |columns: usize| {
            let rows = count.div_ceil(columns);
            let width = (WIDTH - GAP * (columns - 1) as f64) / columns as f64;
            let height = HEIGHT / rows as f64 - TITLE - GAP;
            (columns, rows, (width / extent[2]).min(height / extent[3]))
        };
        let best = (1..=count).map(fit).max_by(|a, b| a.2.total_cmp(&b.2));
        // Very many panels would leave no room for any; they stay visible.
        let (columns, rows, scale) = best.unwrap_or_else(|| fit(1));
        let scale = scale.max(20.0 / extent[2].max(extent[3]));
        let columns_width = columns as f64 * (extent[2] * scale + GAP) - GAP;
        Panels {
            width: columns_width.max(NARROWEST) + 2.0 * SIDE,
            scale,
            extent,
            columns,
            rows,
        }
    }

    /// The area of panel `i`, below its title.
    pub fn window(&self, i: usize) -> Rect {
        let (row, column) = (i / self.columns, i % self.columns);
        let [_, _, width, height] = self.extent.map(|x| x * self.scale);
        let used = self.columns as f64 * (width + GAP) - GAP;
        Rect {
            left: 0.5 * (self.width - used) + column as f64 * (width + GAP),
            top: TITLE + row as f64 * (height + TITLE + GAP),
            width,
            height,
        }
    }

    /// Where a point of panel `i` lies in the figure.
    pub fn place(&self, i: usize, [x, y]: [f64; 2]) -> [f64; 2] {
        let window = self.window(i);
        [
            window.left + (x - self.extent[0]) * self.scale,
            window.bottom() - (y - self.extent[1]) * self.scale,
        ]
    }

    /// Where the panels end.
    pub fn bottom(&self) -> f64 {
        self.window((self.rows - 1) * self.columns).bottom()
    }
}

/// The rectangle that holds all discs at all times, with a little room.
fn extent(seen: &[Vec<Seen>]) -> [f64; 4] {
    let mut low = [f64::INFINITY; 2];
    let mut high = [f64::NEG_INFINITY; 2];
    for particle in seen.iter().flatten() {
        for d in 0..2 {
            low[d] = low[d].min(particle.at[d] - particle.radius);
            high[d] = high[d].max(particle.at[d] + particle.radius);
        }
    }
    let largest = (high[0] - low[0]).max(high[1] - low[1]);
    if !in_reach(largest) {
        return [-0.5, -0.5, 1.0, 1.0];
    }
    let room = 0.02 * largest;
    // A single row of points would otherwise be a panel without height.
    let size = |d: usize| (high[d] - low[d]).max(0.02 * largest) + 2.0 * room;
    [low[0] - room, low[1] - room, size(0), size(1)]
}
