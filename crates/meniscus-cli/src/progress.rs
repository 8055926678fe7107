//! What the program says while it marches: a bar on a terminal, plain lines
//! elsewhere.

use std::io::IsTerminal;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::terminal::Voice;

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
    begin: Instant,
    last: (Instant, u64, f64),
    last_line: Instant,
    /// Steps and simulated seconds per second: the mean so far, later the recent mean.
    rates: (f64, f64),
}

impl Progress {
    /// From the state at the start (or resume) of a run.
    pub fn new(voice: Voice, particles: usize, step: u64, time: f64, end: f64) -> Self {
        let now = Instant::now();
        let bar = (!voice.quiet && std::io::stderr().is_terminal()).then(|| {
            let bar = ProgressBar::with_draw_target(Some(1000), ProgressDrawTarget::stderr());
            if let Ok(style) = ProgressStyle::with_template("{bar:10} {wide_msg}") {
                bar.set_style(style);
            }
            bar
        });
        Self {
            bar,
            voice,
            particles: particles as u64,
            end,
            begin: now,
            last: (now, step, time),
            last_line: now,
            rates: (0.0, 0.0),
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
        let so_far = (now - self.begin).as_secs_f64();
        let weight = (1.0 - (-elapsed / MEMORY).exp()).max(elapsed / so_far);
        self.rates.0 += weight * (rate.0 - self.rates.0);
        self.rates.1 += weight * (rate.1 - self.rates.1);
        self.last = (now, step, time);
        let left = (self.end - time).max(0.0) / self.rates.1.max(f64::MIN_POSITIVE);
        // What matters most stands first: a narrow terminal cuts the end off.
        let message = format!(
            "{:3.0} %  {} left  t = {}  step {step}  {:.2} M particle-steps/s",
            (100.0 * time / self.end).floor().min(100.0),
            duration(left),
            seconds(time),
            self.rates.0 * self.particles as f64 * 1e-6,
        );
        match &self.bar {
            Some(bar) => {
                bar.set_position((1000.0 * (time / self.end).min(1.0)) as u64);
                bar.set_message(message);
            }
            None if now - self.last_line >= LINE_EVERY => {
                self.last_line = now;
                self.voice.say(&message);
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
}

impl Drop for Progress {
    /// Takes the bar away.
    fn drop(&mut self) {
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
    if !seconds.is_finite() {
        return "unknown time".into();
    }
    if seconds > 1e8 {
        return format!("{:.0} years", seconds / 31_556_952.0);
    }
    let whole = seconds.round() as u64;
    match whole {
        0..10 => format!("{seconds:.1} s"),
        10..60 => format!("{whole} s"),
        60..3600 => format!("{} min {:02} s", whole / 60, whole % 60),
        3600..172_800 => format!("{} h {:02} min", whole / 3600, whole / 60 % 60),
        _ => format!("{} d {:02} h", whole / 86_400, whole / 3600 % 24),
    }
}

#[cfg(test)]
mod tests {
    use super::duration;

    #[test]
    fn durations_read_as_a_person_says_them() {
        let said = [
            (0.04, "0.0 s"),
            (2.34, "2.3 s"),
            (59.4, "59 s"),
            (59.7, "1 min 00 s"),
            (3599.0, "59 min 59 s"),
            (7260.0, "2 h 01 min"),
            (200_000.0, "2 d 07 h"),
            (f64::INFINITY, "unknown time"),
        ];
        for (seconds, words) in said {
            assert_eq!(duration(seconds), words);
        }
    }
}
