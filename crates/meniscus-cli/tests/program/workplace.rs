//! A folder for each test, the program started in it, and what it left there.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

/// A rod of 287 particles that swings once and a half in 4 ms, about a thousand steps.
pub const ROD: &str = r#"title = "Small rod"
dimension = 2
spacing = "0.05 mm"
end_time = "4 ms"

[fluid.water]
density = "1000 kg/m^3"
surface_tension = "72.7 mN/m"
sound_speed = "6 m/s"

[[body]]
shape = { ellipse = { semi_axes = ["10 dx", "8 dx"] } }
arrangement = "triangular"

[output]
frames = "0.5 ms"
series = "20 us"
checkpoints = "0.4 ms"

[measure]
oscillation = { mode = 2 }
"#;

/// The rod, but only this long.
pub fn rod_of(end_time: &str) -> String {
    ROD.replace("end_time = \"4 ms\"", &format!("end_time = \"{end_time}\""))
}

/// Files by name and content.
pub type Files = Vec<(String, Vec<u8>)>;

/// Asserts that files are the same, byte for byte, naming those that are not.
pub fn assert_same(ours: &Files, expected: &Files) {
    let names = |files: &Files| -> Vec<String> { files.iter().map(|f| f.0.clone()).collect() };
    assert_eq!(names(ours), names(expected));
    for ((name, ours), (_, expected)) in ours.iter().zip(expected) {
        assert!(ours == expected, "{name} is not what it should be");
    }
}

/// A folder of its own for one test, removed after it.
pub struct Workplace {
    root: PathBuf,
}

impl Workplace {
    /// Empty.
    pub fn new(test: &str) -> Self {
        let root = Path::new(env!("CARGO_TARGET_TMPDIR")).join(test);
        let _ = fs::remove_dir_all(&root);
        fs::create_dir_all(&root).unwrap();
        Self { root }
    }

    /// With [`ROD`] as `rod.toml`.
    pub fn with_rod(test: &str) -> Self {
        let place = Self::new(test);
        place.write("rod.toml", ROD);
        place
    }

    /// A path in it.
    pub fn path(&self, name: &str) -> PathBuf {
        self.root.join(name)
    }

    /// Writes a file in it, with the folders on the way.
    pub fn write(&self, name: &str, text: &str) {
        let path = self.path(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }

    /// Reads a text in it.
    pub fn read(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    /// The program in this folder, not yet started.
    pub fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_meniscus"));
        command.args(arguments).current_dir(&self.root);
        command
    }

    /// Runs the program to its end.
    pub fn run(&self, arguments: &[&str]) -> Finished {
        Finished::of(self.command(arguments).output().unwrap())
    }

    /// Starts the program, its output caught.
    pub fn start(&self, arguments: &[&str]) -> Started {
        let (out, err) = (Stdio::piped(), Stdio::piped());
        let child = self
            .command(arguments)
            .stdout(out)
            .stderr(err)
            .spawn()
            .unwrap();
        Started { child }
    }

    /// Names in a folder of it, sorted.
    pub fn names(&self, folder: &str) -> Vec<String> {
        let mut names: Vec<String> = fs::read_dir(self.path(folder))
            .unwrap_or_else(|error| panic!("{folder}: {error}"))
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    }

    /// Every file of a folder and the folders in it, but for locks: name and content.
    pub fn content(&self, folder: &str) -> Files {
        let mut files = Vec::new();
        for name in self.names(folder) {
            let name = format!("{folder}/{name}");
            if self.path(&name).is_dir() {
                files.extend(self.content(&name));
            } else if !name.ends_with(".lock") {
                files.push((name.clone(), fs::read(self.path(&name)).unwrap()));
            }
        }
        files
    }
}

impl Drop for Workplace {
    fn drop(&mut self) {
        // What is left of a failed test may be looked at.
        if !std::thread::panicking() {
            let _ = fs::remove_dir_all(&self.root);
        }
    }
}

/// What a finished program said.
#[derive(Debug)]
pub struct Finished {
    /// Exit code; none if a signal ended it.
    pub code: Option<i32>,
    /// Standard output.
    pub out: String,
    /// Standard error.
    pub err: String,
}

impl Finished {
    fn of(output: Output) -> Self {
        let finished = Self {
            code: output.status.code(),
            out: String::from_utf8(output.stdout).unwrap(),
            err: String::from_utf8(output.stderr).unwrap(),
        };
        assert!(!finished.err.contains("panicked"), "{finished:#?}");
        finished
    }

    /// The same, if it ended well.
    pub fn ok(self) -> Self {
        self.code(0)
    }

    /// The same, if it ended with this code.
    pub fn code(self, code: i32) -> Self {
        assert_eq!(self.code, Some(code), "{}\n{}", self.out, self.err);
        self
    }
}

/// Asserts that each of these stands in a text.
pub fn has(text: &str, parts: &[&str]) {
    for part in parts {
        assert!(text.contains(part), "no {part:?} in:\n{text}");
    }
}

/// A program on its way.
pub struct Started {
    child: Child,
}

impl Started {
    /// Waits until `ready`, while the program runs.
    pub fn wait_until(&mut self, what: &str, mut ready: impl FnMut() -> bool) {
        let begin = Instant::now();
        while !ready() {
            let ended = self.child.try_wait().unwrap();
            assert!(ended.is_none(), "the program ended before {what}");
            assert!(begin.elapsed() < Duration::from_secs(60), "no {what}");
            std::thread::sleep(Duration::from_millis(1));
        }
    }

    /// Waits for a checkpoint after the first.
    pub fn wait_for_a_checkpoint(&mut self, folder: &Path) {
        let later = |name: &std::ffi::OsStr| {
            let name = name.to_string_lossy();
            name.ends_with(".checkpoint") && name != "step-000000000000.checkpoint"
        };
        self.wait_until("a checkpoint", || {
            fs::read_dir(folder.join("checkpoints"))
                .is_ok_and(|names| names.flatten().any(|entry| later(&entry.file_name())))
        });
    }

    /// Sends a signal, such as INT.
    pub fn signal(&self, name: &str) {
        let command = format!("kill -{name} {}", self.child.id());
        let status = Command::new("sh").args(["-c", &command]).status().unwrap();
        assert!(status.success(), "{command}");
    }

    /// Waits for its end.
    pub fn finish(self) -> Finished {
        Finished::of(self.child.wait_with_output().unwrap())
    }
}
