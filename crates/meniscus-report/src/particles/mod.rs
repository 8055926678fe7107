//! Pictures of the particles at chosen times.
//!
//! Each particle is a disc of its true size, coloured by what it carries; all
//! panels share one extent and one colour scale. [`view`] says from where the
//! particles are seen, [`panels`] how the panels are laid out, [`legend`]
//! draws the scale bar and the colour bar.

mod arrows;
mod legend;
mod panels;
mod view;

pub use view::{Direction, View};

use crate::colour::{Colour, PALETTE, viridis};
use crate::figure::Figure;
use crate::movie::Movie;
use crate::number::{exponent, fixed, in_reach, scaled_unit};
use crate::scene::{Anchor, Disc, Mark, Scene};
use panels::Panels;
use view::Seen;

const TITLE_SIZE: f64 = 13.0;
/// Height of the line above a panel that tells its time.
const TITLE: f64 = 22.0;
/// Width of the rim that parts discs behind one another, in radii.
const RIM: f64 = 0.16;

/// The particles at one time.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    /// Time, s.
    pub time: f64,
    /// Positions, m; in two dimensions the third component is zero.
    pub positions: Vec<[f64; 3]>,
    /// Diameter of the discs, m: the spacing of the particles.
    pub diameter: f64,
    /// What colours each particle; grey where it is missing or not finite.
    pub values: Vec<f64>,
}

/// Pictures of the particles at several times, coloured alike.
#[derive(Clone, Debug)]
pub struct ParticlePictures {
    quantity: String,
    unit: String,
    view: View,
    limits: Option<[f64; 2]>,
    names: Vec<String>,
    /// Of the panels, where times do not tell them apart.
    titles: Vec<String>,
    snapshots: Vec<Snapshot>,
    /// Of each panel.
    arrows: Vec<Vec<[f64; 3]>>,
}

impl ParticlePictures {
    /// Pictures coloured by a quantity given in its plain unit.
    pub fn new(quantity: &str, unit: &str) -> Self {
        ParticlePictures {
            quantity: quantity.to_owned(),
            unit: unit.to_owned(),
            view: View::Whole(Direction::Z),
            limits: None,
            names: Vec::new(),
            titles: Vec::new(),
            snapshots: Vec::new(),
            arrows: Vec::new(),
        }
    }

    /// The same seen otherwise than along z.
    pub fn view(self, view: View) -> Self {
        ParticlePictures { view, ..self }
    }

    /// The same with a colour scale from `low` to `high`. Without, it holds
    /// 99 of 100 values; arrows at its ends tell of values beyond.
    pub fn limits(self, low: f64, high: f64) -> Self {
        ParticlePictures {
            limits: Some([low, high]),
            ..self
        }
    }

    /// The same with a title for each panel instead of its time.
    pub fn titled(self, titles: Vec<String>) -> Self {
        Self { titles, ..self }
    }

    /// The same with values that are no measure but count these names, from zero: each has a
    /// colour of its own, up to the sixth, and stands beside it below the panels.
    pub fn named(self, names: &[&str]) -> Self {
        ParticlePictures {
            names: names.iter().map(|name| (*name).to_owned()).collect(),
            ..self
        }
    }

    /// The same with arrows: for each panel, where its particles go, in any unit. Few enough
    /// are drawn to tell them apart, in one scale for all panels.
    pub fn arrows(self, arrows: Vec<Vec<[f64; 3]>>) -> Self {
        ParticlePictures { arrows, ..self }
    }

    /// The same with one more panel.
    pub fn with(mut self, snapshot: Snapshot) -> Self {
        self.snapshots.push(snapshot);
        self
    }

    /// The finished figure: all panels side by side.
    pub fn figure(&self, name: &str, caption: &str) -> Figure {
        let seen = self.seen();
        let style = Style::new(self, &seen, seen.len());
        let panels: Vec<_> = seen.iter().zip(self.times()).collect();
        Figure::new(name, caption, style.scene(&panels))
    }

    /// The panels one after another.
    pub fn movie(&self, name: &str, caption: &str) -> Movie {
        let seen = self.seen();
        let style = Style::new(self, &seen, 1);
        let scenes = seen
            .iter()
            .zip(self.times())
            .map(|panel| style.scene(&[panel]));
        Movie::new(name, caption, scenes.collect())
    }

    fn seen(&self) -> Vec<Vec<Seen>> {
        let arrows = |i: usize| self.arrows.get(i).map_or(&[][..], Vec::as_slice);
        let snapshots = self.snapshots.iter().enumerate();
        snapshots
            .map(|(i, s)| self.view.see(s, arrows(i)))
            .collect()
    }

    /// Titles: those given, or the times, in one unit and with the digits that tell them apart.
    fn times(&self) -> Vec<String> {
        if self.titles.len() == self.snapshots.len() {
            return self.titles.clone();
        }
        let times: Vec<f64> = self.snapshots.iter().map(|s| s.time).collect();
        let latest = times.iter().fold(0.0, |a: f64, t| a.max(t.abs()));
        let unit = scaled_unit("s", latest);
        let gaps = times.windows(2).map(|t| (t[1] - t[0]).abs());
        let gap = gaps.filter(|&g| in_reach(g)).fold(latest, f64::min) / unit.factor;
        let places = if in_reach(gap) { 1 - exponent(gap) } else { 0 };
        let decimals = usize::try_from(places.clamp(0, 6)).unwrap_or(0);
        let title = |t: &f64| format!("t = {} {}", fixed(t / unit.factor, decimals), unit.unit);
        times.iter().map(title).collect()
    }
}

/// The colour of what has this number.
fn of_name(number: f64) -> Colour {
    if number >= 0.0 {
        PALETTE[number as usize % PALETTE.len()]
    } else {
        Colour::NO_VALUE
    }
}

/// What the panels have in common.
struct Style<'a> {
    pictures: &'a ParticlePictures,
    colours: ColourScale,
    panels: Panels,
    edge: f64,
    /// Pixels to the unit of the arrows.
    arrow: f64,
}

impl<'a> Style<'a> {
    /// For `count` panels at a time.
    fn new(pictures: &'a ParticlePictures, seen: &[Vec<Seen>], count: usize) -> Self {
        let all = || seen.iter().flatten();
        // In two dimensions no disc hides another: no rim needed.
        let depths = all().map(|p| p.depth);
        let (near, far) = depths.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), d| {
            (a.min(d), b.max(d))
        });
        Self {
            pictures,
            colours: ColourScale::new(pictures.limits, all().map(|p| p.value)),
            panels: Panels::new(seen, count),
            edge: if far > near { RIM } else { 0.0 },
            arrow: arrows::scale(all()),
        }
    }

    fn colour(&self, value: f64) -> Colour {
        match self.pictures.names.is_empty() {
            true => self.colours.colour(value),
            false => of_name(value),
        }
    }

    /// These panels with their times, and the scales.
    fn scene(&self, shown: &[(&Vec<Seen>, String)]) -> Scene {
        let (panels, names) = (&self.panels, &self.pictures.names);
        let mut marks = Vec::new();
        for (i, (particles, time)) in shown.iter().enumerate() {
            let window = panels.window(i);
            let at = [
                window.left + 0.5 * window.width,
                window.top - TITLE + 1.1 * TITLE_SIZE,
            ];
            marks.push(Mark::text(at, Anchor::Middle, TITLE_SIZE, time));
            let disc = |particle: &Seen| Disc {
                centre: panels.place(i, particle.at),
                radius: particle.radius * panels.scale,
                fill: self.colour(particle.value),
            };
            marks.push(Mark::Discs {
                discs: particles.iter().map(disc).collect(),
                edge: self.edge,
            });
            if self.arrow > 0.0 {
                arrows::draw(&mut marks, panels, i, particles, self.arrow);
            }
        }
        let bottom = panels.bottom();
        legend::scale_bar(&mut marks, panels, bottom);
        if names.is_empty() {
            let title = (&*self.pictures.quantity, &*self.pictures.unit);
            legend::colour_bar(&mut marks, &self.colours, title, panels.width, bottom);
        } else {
            let names = (names.iter().enumerate()).map(|(i, name)| (of_name(i as f64), name));
            legend::names(&mut marks, names, panels.width, bottom);
        }
        Scene {
            width: panels.width,
            height: bottom + legend::HEIGHT,
            marks,
        }
    }
}

/// Whether a value has a place on a scale.
fn shows(value: f64) -> bool {
    value == 0.0 || in_reach(value)
}

/// From values to colours.
struct ColourScale {
    low: f64,
    high: f64,
    /// Whether values lie below and above.
    beyond: [bool; 2],
}

impl ColourScale {
    fn new(limits: Option<[f64; 2]>, values: impl Iterator<Item = f64>) -> Self {
        let mut values: Vec<f64> = values.filter(|v| shows(*v)).collect();
        values.sort_by(f64::total_cmp);
        let quantile = |share: f64| {
            let i = (share * values.len().saturating_sub(1) as f64).round() as usize;
            values.get(i).copied().unwrap_or(0.0)
        };
        let given = limits.filter(|[low, high]| low < high && shows(*low) && shows(*high));
        let [mut low, mut high] = given.unwrap_or([quantile(0.005), quantile(0.995)]);
        if low == high {
            // One value everywhere: put it in the middle.
            let room = if low == 0.0 { 1.0 } else { 0.05 * low.abs() };
            (low, high) = (low - room, high + room);
        }
        ColourScale {
            low,
            high,
            beyond: [quantile(0.0) < low, quantile(1.0) > high],
        }
    }

    fn colour(&self, value: f64) -> Colour {
        if shows(value) {
            viridis((value - self.low) / (self.high - self.low))
        } else {
            Colour::NO_VALUE
        }
    }
}
