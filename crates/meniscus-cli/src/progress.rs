//! What the program says while it marches: a bar on a terminal, plain lines
//! elsewhere.

use std::io::IsTerminal;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// How much the program says.
#[derive(Clone, Copy, Debug)]
pub struct Voice {
    /// Nothing but errors.
    pub quiet: bool,
    /// Every file as well.
    pub verbose: bool,
}

impl Voice {
    /// From the command line.
    pub fn new(quiet: bool, verbose: bool) -> Self {
        Self {
            quiet,
            verbose: verbose && !quiet,
        }
    }

    /// Says a line, unless quiet.
    pub fn say(self, line: &str) {
        if !self.quiet {
            println!("{line}");
        }
    }
}

/// Time between plain lines where there is no terminal.
const LINE_EVERY: Duration = Duration::from_secs(10);
/// The rate that the remaining time is judged by covers about this long.
const MEMORY: f64 = 20.0;

/// Progress of one run.
pub struct Progress {
    bar: Option<ProgressBar>,
    voice: Voice,
    particles: u64,
    end: f64,
    last: (Instant, u64, f64),
    last_line: Instant,
    /// Steps and simulated seconds per second, smoothed.
    rates: Option<(f64, f64)>,
}

impl Progress {
    /// From the state at the start (or resume) of a run.
    pub fn new(voice: Voice, particles: usize, step: u64, time: f64, end: f64) -> Self {
        let now = Instant::now();
        let bar = (!voice.quiet && std::io::stderr().is_terminal()).then(|| {
            let bar = ProgressBar::with_draw_target(Some(1000), ProgressDrawTarget::stderr());
            if let Ok(style) = ProgressStyle::with_template("{bar:30} {percent:>3}%  {msg}") {
                bar.set_style(style);
            }
            bar
        });
        if bar.is_none() {
            voice.say(&format!("t = {} of {}", seconds(time), seconds(end)));
        }
        Self {
            bar,
            voice,
            particles: particles as u64,
            end,
            last: (now, step, time),
            last_line: now,
            rates: None,
        }
    }

    /// Tells that the run has come to `step` and `time`.
    pub fn update(&mut self, step: u64, time: f64) {
        let now = Instant::now();
        let elapsed = (now - self.last.0).as_secs_f64();
        let wait = if self.bar.is_some() { 0.1 } else { 0.5 };
        if elapsed < wait {
            return;
        }
        let rate = (
            (step - self.last.1) as f64 / elapsed,
            (time - self.last.2) / elapsed,
        );
        let weight = 1.0 - (-elapsed / MEMORY).exp();
        let rates = self.rates.map_or(rate, |old| {
            (
                old.0 + weight * (rate.0 - old.0),
                old.1 + weight * (rate.1 - old.1),
            )
        });
        self.rates = Some(rates);
        self.last = (now, step, time);
        let left = (self.end - time).max(0.0) / rates.1.max(f64::MIN_POSITIVE);
        let message = format!(
            "step {step}  t = {}  {:.2} M particle-steps/s  {} left",
            seconds(time),
            rates.0 * self.particles as f64 * 1e-6,
            duration(left),
        );
        match &self.bar {
            Some(bar) => {
                bar.set_position((1000.0 * (time / self.end).min(1.0)) as u64);
                bar.set_message(message);
            }
            None if now - self.last_line >= LINE_EVERY => {
                self.last_line = now;
                self.voice
                    .say(&format!("{:3.0} %  {message}", 100.0 * time / self.end));
            }
            None => {}
        }
    }

    /// Says a line without tearing the bar.
    pub fn say(&self, line: &str) {
        match &self.bar {
            Some(bar) => bar.suspend(|| self.voice.say(line)),
            None => self.voice.say(line),
        }
    }

    /// Takes the bar away.
    pub fn finish(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}

/// A time with an SI prefix.
pub fn seconds(time: f64) -> String {
    meniscus_report::number::with_unit(time, "s", 4)
}

/// A wall-clock time as a person says it.
pub fn duration(seconds: f64) -> String {
    if !seconds.is_finite() || seconds > 1e8 {
        return "unknown time".into();
    }
    let whole = seconds.round() as u64;
    match whole {
        0..60 => format!("{whole} s"),
        60..3600 => format!("{} min {:02} s", whole / 60, whole % 60),
        3600..172_800 => format!("{} h {:02} min", whole / 3600, whole / 60 % 60),
        _ => format!("{} d {:02} h", whole / 86_400, whole / 3600 % 24),
    }
}
