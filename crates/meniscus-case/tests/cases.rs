//! Case files: good ones are read and written back, bad ones give the
//! diagnostic that they state, and no text makes the reader panic.

use std::fs;
use std::path::{Path, PathBuf};

use meniscus_case::{Case, Diagnostic, Diagnostics, Severity};

fn files(folder: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let mut files: Vec<_> = fs::read_dir(&folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|ending| ending == "toml"))
        .collect();
    files.sort();
    assert!(!files.is_empty(), "no case in {}", folder.display());
    files
}

/// The good cases, those that a user starts from, and those that the project reproduces papers with.
fn good() -> Vec<PathBuf> {
    let mut all = files("tests/cases/good");
    all.extend(files("../../cases"));
    all.extend(files("../../papers/jancik-hyhlik"));
    all.extend(files("../../papers/qiang-chen-gao"));
    all.extend(files("../../papers/sigalotti-daza-donoso"));
    // What a paper's folder is to reproduce is not a case.
    all.retain(|path| !path.ends_with("reproduction.toml"));
    all
}

fn assert_same(a: &Case, b: &Case) {
    assert_eq!(a.scheme, b.scheme);
    assert_eq!(a.fluids, b.fluids);
    assert_eq!((&a.bodies, &a.walls), (&b.bodies, &b.walls));
    assert_eq!(a.particles::<3>(), b.particles::<3>());
    assert_eq!(
        (a.spacing, a.end_time, a.periodic),
        (b.spacing, b.end_time, b.periodic)
    );
    assert_eq!(
        (&a.output, &a.measure, a.speeds),
        (&b.output, &b.measure, b.speeds)
    );
    assert_eq!(a.deformation, b.deformation);
    assert_eq!((&a.title, &a.description), (&b.title, &b.description));
}

#[test]
fn good_cases_are_read_without_a_warning() {
    for path in good() {
        let case = Case::from_file(&path).unwrap_or_else(|wrong| panic!("{wrong}"));
        // Cases that show the whole language hold what no one should simulate.
        let odd = case.name.starts_with("everything");
        // A paper's own speed of sound may be low.
        let published = path.components().any(|part| part.as_os_str() == "papers");
        let expected = |warning: &Diagnostic| {
            odd || published && warning.message.starts_with("the sound speed")
        };
        assert!(case.warnings.iter().all(expected), "{}", case.warnings);
        assert!(case.particle_count() > 0);
        assert_eq!(
            case.particle_count(),
            case.bodies.iter().map(|body| body.particles).sum::<usize>()
                + case.walls.iter().map(|wall| wall.particles).sum::<usize>()
        );
    }
}

#[test]
fn the_resolved_case_is_a_case_of_the_same_values_and_resolves_to_itself() {
    for path in good() {
        let case = Case::from_file(&path).unwrap();
        let again =
            Case::from_str("again", case.to_toml()).unwrap_or_else(|wrong| panic!("{wrong}"));
        assert_same(&case, &again);
        assert_eq!(case.to_toml(), again.to_toml());
    }
}

#[test]
fn density_by_summation_beside_a_free_surface_is_doubted() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases/good");
    let source = fs::read_to_string(folder.join("smallest.toml")).unwrap();
    let source = source + "[physics]\ndensity = 'summation'\n";
    let open = Case::from_str("open", &source).unwrap();
    assert!(
        open.warnings
            .to_string()
            .contains("density by summation is too low")
    );
}

/// A bad file starts with lines `#! line:column words | more words`: where its
/// diagnostics are, and what they say. All must be there, and no others.
#[test]
fn bad_cases_give_the_diagnostics_that_they_state() {
    let wrong: Vec<String> = files("tests/cases/bad")
        .iter()
        .filter_map(|path| surprise(path))
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
}

/// What a bad file gives beside what it states, or the other way round.
fn surprise(path: &Path) -> Option<String> {
    let source = fs::read_to_string(path).unwrap();
    let name = path.file_name()?.to_str()?;
    let expected: Vec<&str> = source
        .lines()
        .map_while(|line| line.strip_prefix("#! "))
        .collect();
    let (found, severity) = match Case::from_str(name, &source) {
        Ok(case) => (case.warnings, Severity::Warning),
        Err(wrong) => (wrong, Severity::Error),
    };
    let text = found.to_string();
    if expected.is_empty() || found.len() != expected.len() {
        return Some(format!(
            "{name} states {} and gives {}:\n{text}",
            expected.len(),
            found.len()
        ));
    }
    for (diagnostic, expected) in found.iter().zip(expected) {
        let (place, words) = expected.split_once(' ')?;
        let (line, column) = found.line_and_column(diagnostic).unwrap_or((0, 0));
        if format!("{line}:{column}") != place {
            return Some(format!("{name} should point to {place}:\n{text}"));
        }
        let (words, expected_severity) = match words.strip_prefix("warning ") {
            Some(words) => (words, Severity::Warning),
            None => (words, Severity::Error),
        };
        // Whoever reads it finds the place: the file, the line itself, a mark under it.
        let place = format!("{name}:{line}:{column}");
        let shown = source.lines().nth(line - 1).unwrap_or_default().trim_end();
        let missing = words
            .split(" | ")
            .chain([place.as_str(), shown, "^"])
            .find(|words| !text.contains(words));
        if severity != expected_severity || missing.is_some() {
            return Some(format!(
                "{name} should say {:?}:\n{text}",
                missing.unwrap_or("error or warning")
            ));
        }
    }
    None
}

#[test]
fn all_mistakes_of_a_file_are_reported_at_once() {
    let wrong = Case::from_str(
        "many.toml",
        "dimension = 2\nspaceing = '1 mm'\nend_time = '3 kg'\nkernel = 'cubic'\n\
         [fluid.water]\ndensity = '-1 kg/m^3'\n[[body]]\nshape = { disc = { radius = 'wide' } }\n",
    )
    .unwrap_err();
    let lines: Vec<_> = wrong
        .iter()
        .map(|d| wrong.line_and_column(d).unwrap().0)
        .collect();
    assert_eq!(lines, [2, 3, 4, 6, 8], "{wrong}");
}

#[test]
fn colour_marks_the_text_and_changes_no_word() {
    let wrong: Diagnostics = Case::from_str("x.toml", "dimension = 5").unwrap_err();
    let (plain, coloured) = (wrong.render(false), wrong.render(true));
    assert!(!plain.contains('\u{1b}') && coloured.contains('\u{1b}'));
    let mut stripped = String::new();
    for (i, part) in coloured.split('\u{1b}').enumerate() {
        stripped.push_str(if i == 0 {
            part
        } else {
            part.split_once('m').unwrap().1
        });
    }
    assert_eq!(stripped, plain);
}

#[test]
fn a_file_that_is_not_there_or_not_text_is_reported() {
    let missing = Case::from_file(Path::new("no/such/case.toml"))
        .unwrap_err()
        .to_string();
    assert!(
        missing.contains("cannot read no/such/case.toml"),
        "{missing}"
    );
    let binary = std::env::temp_dir().join(format!("meniscus-case-{}.toml", std::process::id()));
    fs::write(&binary, [0xff, 0xfe]).unwrap();
    let wrong = Case::from_file(&binary).unwrap_err().to_string();
    fs::remove_file(&binary).unwrap();
    assert!(wrong.contains("not UTF-8"), "{wrong}");
}

/// Cuts and single wrong characters at many places of good files. The result
/// may be right or wrong; it must be a value, and printable.
#[test]
fn no_cut_and_no_single_wrong_character_makes_the_reader_panic() {
    let mut tried = 0;
    for path in files("tests/cases/good") {
        let source = fs::read_to_string(&path).unwrap();
        let places: Vec<usize> = source.char_indices().map(|(place, _)| place).collect();
        let mut attempts = Vec::new();
        for (k, &place) in places.iter().enumerate() {
            let next = places.get(k + 1).copied().unwrap_or(source.len());
            let (before, after) = (&source[..place], &source[next..]);
            if k % 3 == 0 {
                attempts.push(before.to_string());
            }
            let wrong = [
                "", "\"", "'", "[", "]", "{", "}", "=", "-", "9", ".", "x", "\n", "\0", "µ", "#",
                ",", " ",
            ];
            attempts.push(format!("{before}{}{after}", wrong[k % wrong.len()]));
        }
        for text in attempts {
            tried += 1;
            match Case::from_str("fuzz.toml", &text) {
                Ok(case) => assert!(!case.to_toml().is_empty()),
                Err(wrong) => assert!(!wrong.is_empty() && !wrong.to_string().is_empty()),
            }
        }
    }
    assert!(tried > 1000, "{tried}");
    // So deep that a reader without a limit runs out of stack.
    for (open, close) in [("[", "]"), ("{a=", "}")] {
        let deep = format!(
            "spacing = {}1{}",
            open.repeat(100_000),
            close.repeat(100_000)
        );
        assert!(Case::from_str("deep.toml", &deep).is_err());
    }
}
