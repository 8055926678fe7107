//! The report needs nothing beside it, says what it was given, and lets no
//! text of a case become markup.

use meniscus_report::{Axis, Curve, LinePlot, ParticlePictures, Report, ResultRow, Snapshot};

fn row(reference: Option<(&str, f64)>, computed: f64, uncertainty: Option<f64>) -> ResultRow {
    ResultRow {
        quantity: "Surface tension".to_owned(),
        unit: "N/m".to_owned(),
        reference: reference.map(|(source, value)| (source.to_owned(), value)),
        computed,
        uncertainty,
    }
}

/// A picture shorter as PNG than as SVG: thousands of particles at few places.
fn picture() -> meniscus_report::Figure {
    let positions: Vec<[f64; 3]> = (0..5000)
        .map(|i| [f64::from(i % 10), 0.0, f64::from(i)])
        .collect();
    ParticlePictures::new("Speed", "m/s")
        .with(Snapshot {
            time: 0.0,
            values: vec![1.0; positions.len()],
            positions,
            diameter: 1.0,
        })
        .figure("speed", "Speed of the particles.")
}

fn plot() -> meniscus_report::Figure {
    LinePlot::new(Axis::new("Time", "s"), Axis::new("Energy", "J"))
        .with(Curve::line("kinetic", &[0.0, 1.0], &[1.0, 0.5]))
        .figure("energy", "Energy against time.")
}

#[test]
fn the_page_tells_what_it_was_given() {
    let report = Report::new("Rod")
        .summary("The answer.")
        .warning("Mind the step.")
        .result(row(Some(("given", 0.0727)), 0.0741, Some(4.5e-4)))
        .parameter("Spacing", "3.5 µm")
        .dimensionless("La", 3634.2, "surface tension to viscosity")
        .run_information("Seed", "1")
        .reproduce("meniscus run rod.toml")
        .figure(plot())
        .figure(picture());
    let html = report.html().unwrap();
    for expected in [
        "<title>Rod</title>",
        "The answer.",
        "Mind the step.",
        "72.70 mN/m",
        "given",
        "74.10 ± 0.45 mN/m",
        "+1.93 %",
        "3.5 µm",
        "3634",
        "meniscus run rod.toml",
        "Energy against time.",
        "Speed of the particles.",
    ] {
        assert!(html.contains(expected), "{expected}");
    }
    let names: Vec<&str> = report.figures().iter().map(|f| f.name()).collect();
    assert_eq!(names, ["energy", "speed"]);
    assert!(html.contains("<svg") && html.contains("data:image/png;base64,"));
}

#[test]
fn nothing_is_fetched_from_elsewhere() {
    let html = Report::new("Rod")
        .figure(plot())
        .figure(picture())
        .html()
        .unwrap();
    let name_space = "xmlns=\"http://www.w3.org/2000/svg\"";
    let rest = html.replace(name_space, "");
    for reference in [
        "http:", "https:", "//cdn", "@import", "url(", "<link", "<script",
    ] {
        assert!(!rest.contains(reference), "{reference}");
    }
    for attribute in ["src=\"", "href=\""] {
        for (i, _) in rest.match_indices(attribute) {
            assert!(rest[i + attribute.len()..].starts_with("data:"));
        }
    }
}

#[test]
fn text_stays_text() {
    let evil = "<script>alert('x')</script> & \"quoted\" \u{1}";
    let figure = LinePlot::new(Axis::new(evil, evil), Axis::new("y", ""))
        .with(Curve::line(evil, &[0.0, 1.0], &[1.0, 0.5]))
        .figure(evil, evil);
    roxmltree::Document::parse(&figure.svg().unwrap()).unwrap();
    let html = Report::new(evil)
        .summary(evil)
        .warning(evil)
        .result(ResultRow {
            quantity: evil.to_owned(),
            unit: evil.to_owned(),
            reference: Some((evil.to_owned(), 1.0)),
            computed: 1.0,
            uncertainty: Some(0.1),
        })
        .parameter(evil, evil)
        .dimensionless(evil, 1.0, evil)
        .run_information(evil, evil)
        .reproduce(evil)
        .figure(figure)
        .html()
        .unwrap();
    assert!(!html.contains("<script"));
    assert!(!html.contains("\"quoted\""));
    assert!(
        html.contains("&lt;script&gt;alert(&#39;x&#39;)&lt;/script&gt; &amp; &quot;quoted&quot;")
    );
}

#[test]
fn a_difference_needs_a_reference_and_is_relative_only_to_one_that_is_not_zero() {
    let cell = |row| Report::new("").result(row).html().unwrap();
    assert!(cell(row(None, 0.07, None)).contains("<td class=\"number\">–</td>"));
    assert!(cell(row(Some(("theory", 0.0)), 2e-3, None)).contains("+2.0 mN/m"));
    assert!(cell(row(Some(("theory", -1.0)), -1.5, None)).contains("−50.0 %"));
    assert!(cell(row(Some(("theory", 1.0)), f64::NAN, None)).contains("not a number"));
}
