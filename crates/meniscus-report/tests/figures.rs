//! Figures: well-formed SVG with what it must say, PNG with the same picture,
//! particles of true size and colour, and no input that breaks them.

use meniscus_report::{
    Axis, Colour, Curve, Direction, Figure, LinePlot, ParticlePictures, Scale, Snapshot, View,
};
use roxmltree::{Document, Node};
use tiny_skia::{Pixmap, PremultipliedColorU8};

/// The ends of viridis, as published with matplotlib.
const DARK: &str = "#440154";
const LIGHT: &str = "#fde725";

fn texts(svg: &str) -> Vec<String> {
    let document = Document::parse(svg).unwrap();
    let texts = document.descendants().filter(|n| n.has_tag_name("text"));
    texts.map(|n| n.text().unwrap().to_owned()).collect()
}

fn number(node: &Node, name: &str) -> f64 {
    node.attribute(name).unwrap().parse().unwrap()
}

/// Circles of an SVG: centre, radius, fill.
fn circles(svg: &str) -> Vec<([f64; 2], f64, String)> {
    let document = Document::parse(svg).unwrap();
    let circles = document.descendants().filter(|n| n.has_tag_name("circle"));
    circles
        .map(|n| {
            let centre = [number(&n, "cx"), number(&n, "cy")];
            (
                centre,
                number(&n, "r"),
                n.attribute("fill").unwrap().to_owned(),
            )
        })
        .collect()
}

fn decoded(figure: &Figure) -> Pixmap {
    Pixmap::decode_png(&figure.png().unwrap()).unwrap()
}

fn at(pixmap: &Pixmap, [x, y]: [f64; 2]) -> PremultipliedColorU8 {
    pixmap.pixel((2.0 * x) as u32, (2.0 * y) as u32).unwrap()
}

fn oscillation() -> LinePlot {
    let time: Vec<f64> = (0..100).map(|i| f64::from(i) * 4e-6).collect();
    let axis: Vec<f64> = time.iter().map(|t| 5e-5 + 5e-6 * (6e4 * t).cos()).collect();
    let low: Vec<f64> = axis.iter().map(|a| a - 1e-6).collect();
    let high: Vec<f64> = axis.iter().map(|a| a + 1e-6).collect();
    LinePlot::new(Axis::new("Time", "s"), Axis::new("Semi-axis", "m"))
        .with(Curve::line("a & b", &time, &axis))
        .with(Curve::band("interval", &time, &low, &high))
        .with(Curve::dashed("Rayleigh <1879>", &time, &axis))
        .with(Curve::points("samples", &time, &axis))
}

#[test]
fn a_plot_names_its_axes_with_prefixed_units_and_its_curves() {
    let svg = oscillation().figure("axes", "Semi-axes.").svg().unwrap();
    let texts = texts(&svg);
    for expected in [
        "Time (µs)",
        "Semi-axis (µm)",
        "a & b",
        "interval",
        "Rayleigh <1879>",
        "samples",
        "100",
        "300",
        "50",
    ] {
        assert!(texts.iter().any(|t| t == expected), "{expected}: {texts:?}");
    }
}

#[test]
fn the_png_shows_the_same_picture_at_twice_the_size() {
    let figure = oscillation().figure("axes", "");
    let pixmap = decoded(&figure);
    let (width, height) = figure.size();
    assert_eq!(f64::from(pixmap.width()), (2.0 * width).round());
    assert_eq!(f64::from(pixmap.height()), (2.0 * height).round());
    // Where the SVG has a mark of the samples, the PNG has its colour.
    let colour = Colour([0xd5, 0x5e, 0x00]);
    let svg = figure.svg().unwrap();
    let marks = circles(&svg);
    assert_eq!(marks.len(), 101, "100 samples and the legend");
    for (centre, _, fill) in marks {
        assert_eq!(fill, "#d55e00");
        let dot = at(&pixmap, centre);
        assert_eq!([dot.red(), dot.green(), dot.blue()], colour.0);
    }
    let dark = pixmap.pixels().iter().filter(|p| p.red() < 0x40).count();
    assert!(dark > 1000, "letters and axes are drawn: {dark}");
}

#[test]
fn a_gap_breaks_the_line_and_a_logarithmic_axis_leaves_out_what_it_cannot_show() {
    let lines = |scale| {
        let y = [1.0, 2.0, f64::NAN, 3.0, -1.0, 10.0, 100.0];
        let x = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
        let figure = LinePlot::new(Axis::new("x", ""), Axis::new("y", "").scale(scale))
            .with(Curve::line("", &x, &y))
            .figure("gap", "");
        let svg = figure.svg().unwrap();
        svg.matches("stroke=\"#0072b2\"").count()
    };
    assert_eq!(lines(Scale::Linear), 2);
    assert_eq!(lines(Scale::Logarithmic), 3);
}

#[test]
fn a_long_series_keeps_its_peaks_and_loses_its_weight() {
    let x: Vec<f64> = (0..200_000).map(f64::from).collect();
    let mut y = vec![0.0; x.len()];
    (y[77_777], y[123_456]) = (5.0, -5.0);
    let figure = LinePlot::new(Axis::new("x", ""), Axis::new("y", ""))
        .with(Curve::line("", &x, &y))
        .figure("long", "");
    let svg = figure.svg().unwrap();
    assert!(svg.len() < 100_000, "{}", svg.len());
    let document = Document::parse(&svg).unwrap();
    let line = document
        .descendants()
        .find(|n| n.attribute("stroke") == Some("#0072b2"))
        .unwrap();
    let heights: Vec<f64> = line
        .attribute("d")
        .unwrap()
        .split(['M', 'L'])
        .filter_map(|p| p.split_once(' ')?.1.parse().ok())
        .collect();
    let (top, bottom) = heights
        .iter()
        .fold((f64::MAX, f64::MIN), |(a, b), &y| (a.min(y), b.max(y)));
    // The peaks reach to the margins of 6 % of the range at both ends.
    assert!((bottom - top) / 300.0 > 0.85, "{top} to {bottom}");
}

fn two_times() -> ParticlePictures {
    let snapshot = |time: f64, stretch: f64| Snapshot {
        time,
        positions: vec![
            [-4e-5 * stretch, 0.0, 0.0],
            [4e-5 * stretch, 1e-5, 0.0],
            [0.0; 3],
        ],
        diameter: 1e-5,
        values: vec![100.0, 300.0, f64::NAN],
    };
    ParticlePictures::new("Pressure", "Pa")
        .limits(100.0, 300.0)
        .with(snapshot(0.0, 1.0))
        .with(snapshot(2.5e-4, 0.5))
}

#[test]
fn particles_have_true_size_true_distance_and_the_colour_of_their_value() {
    let figure = two_times().figure("pressure", "");
    let svg = figure.svg().unwrap();
    let circles = circles(&svg);
    assert_eq!(circles.len(), 6);
    let diameter = 2.0 * circles[0].1;
    let distance = |i: usize, j: usize| {
        let [a, b] = [circles[i].0, circles[j].0];
        (a[0] - b[0]).hypot(a[1] - b[1])
    };
    // Eight diameters apart along x, one along y; coordinates are printed to
    // a hundredth of a pixel.
    let expected = 65_f64.sqrt() * diameter;
    assert!((distance(0, 1) - expected).abs() < 0.1);
    // One scale and one extent for all times: half the stretch at half the distance.
    assert!((distance(3, 4) - 17_f64.sqrt() * diameter).abs() < 0.1);
    let fills: Vec<&str> = circles.iter().map(|c| c.2.as_str()).collect();
    assert_eq!(fills[..2], [DARK, LIGHT]);
    assert_eq!(fills[2], "#b4b4b4");

    // The scale bar: the only horizontal line of ink, between its two ends.
    let document = Document::parse(&svg).unwrap();
    let bar = document
        .descendants()
        .find(|n| n.attribute("stroke") == Some("#222222"))
        .unwrap();
    let x: Vec<f64> = bar
        .attribute("d")
        .unwrap()
        .split(['M', 'L'])
        .filter_map(|p| p.split_once(' ')?.0.parse().ok())
        .collect();
    let texts = texts(&svg);
    let length = texts.iter().find(|t| t.ends_with(" µm")).unwrap();
    let length: f64 = length.trim_end_matches(" µm").parse().unwrap();
    assert!(((x[1] - x[0]) / diameter - length / 10.0).abs() < 0.01);
    assert!(texts.iter().any(|t| t == "t = 250 µs"), "{texts:?}");
    assert!(texts.iter().any(|t| t == "Pressure (Pa)"), "{texts:?}");

    let pixmap = decoded(&figure);
    let dot = at(&pixmap, circles[0].0);
    assert_eq!([dot.red(), dot.green(), dot.blue()], [0x44, 0x01, 0x54]);
}

#[test]
fn near_particles_hide_those_behind_and_a_slice_leaves_out_the_rest() {
    let snapshot = Snapshot {
        time: 0.0,
        positions: vec![[0.0, 0.0, 1.0], [0.0, 0.0, 3.0], [0.0, 2.0, 2.0]],
        diameter: 1.0,
        values: vec![1.0, 2.0, 3.0],
    };
    let seen = |view| {
        let pictures = ParticlePictures::new("Label", "").view(view);
        let figure = pictures.limits(1.0, 3.0).with(snapshot.clone());
        let svg = figure.figure("order", "").svg().unwrap();
        let fills = circles(&svg).into_iter().map(|c| c.2);
        fills.collect::<Vec<String>>()
    };
    let along_z = seen(View::Whole(Direction::Z));
    assert_eq!(along_z.len(), 3);
    assert_eq!((along_z[0].as_str(), along_z[1].as_str()), (DARK, LIGHT));
    // Looking along y the particle at y = 2 is the farthest.
    assert_eq!(seen(View::Whole(Direction::Y))[0], LIGHT);
    let slice = |direction, at| {
        seen(View::Slice {
            direction,
            at,
            thickness: 0.5,
        })
    };
    assert_eq!(slice(Direction::Y, 2.0), [LIGHT]);
    assert_eq!(slice(Direction::Z, 1.0), [DARK]);
    assert_eq!(slice(Direction::X, 0.1).len(), 3);
    assert_eq!(slice(Direction::X, 1.0).len(), 0);
}

#[test]
fn a_large_cloud_goes_into_the_svg_as_an_image() {
    let positions: Vec<[f64; 3]> = (0..25_000)
        .map(|i| [f64::from(i % 200), f64::from(i / 200), 0.0])
        .collect();
    let figure = ParticlePictures::new("Speed", "m/s")
        .with(Snapshot {
            time: 0.0,
            values: positions.iter().map(|p| p[0]).collect(),
            positions,
            diameter: 1.0,
        })
        .figure("large", "");
    let svg = figure.svg().unwrap();
    assert!(circles(&svg).is_empty());
    assert!(svg.contains("<image") && svg.contains("Speed (m/s)"));
}

#[test]
fn no_values_break_a_figure() {
    let edges = [
        0.0,
        5e-324,
        1e-299,
        1.0,
        1.0 + f64::EPSILON,
        f64::MAX,
        -f64::MAX,
        f64::INFINITY,
        f64::NAN,
    ];
    for a in edges {
        for b in edges {
            for scale in [Scale::Linear, Scale::Logarithmic] {
                let axis = |name: &str| Axis::new(name, "m").scale(scale);
                let figure = LinePlot::new(axis("x").limits(a, b), axis("y"))
                    .with(Curve::line("line", &[a, b], &[b, a]))
                    .with(Curve::band("band", &[a, b], &[a, a], &[b, b]))
                    .with(Curve::points("points", &[b, a], &[a]))
                    .figure("edges", "");
                Document::parse(&figure.svg().unwrap()).unwrap();
            }
            let figure = ParticlePictures::new("Pressure", "Pa")
                .with(Snapshot {
                    time: a,
                    positions: vec![[a, b, 0.0], [b, b, a], [0.0; 3]],
                    diameter: b,
                    values: vec![a, b],
                })
                .with(Snapshot {
                    time: b,
                    positions: vec![],
                    diameter: a,
                    values: vec![],
                })
                .figure("edges", "");
            Document::parse(&figure.svg().unwrap()).unwrap();
            figure.png().unwrap();
        }
    }
    let plot = LinePlot::new(Axis::new("x", "s"), Axis::new("y", ""));
    assert!(!decoded(&plot.figure("empty", "")).data().is_empty());
    let none = ParticlePictures::new("Pressure", "Pa").figure("empty", "");
    assert!(!decoded(&none).data().is_empty());
}

#[test]
fn particles_of_different_origin_have_colours_with_names() {
    let snapshot = Snapshot {
        time: 0.0,
        positions: (0..4).map(|i| [f64::from(i), 0.0, 0.0]).collect(),
        diameter: 1.0,
        values: vec![0.0, 1.0, 1.0, f64::NAN],
    };
    let figure = ParticlePictures::new("Body", "")
        .named(&["drop", "film"])
        .with(snapshot)
        .figure("body", "Origin.");
    let svg = figure.svg().unwrap();
    let texts = texts(&svg);
    assert!(texts.iter().any(|t| t == "drop") && texts.iter().any(|t| t == "film"));
    let fills: Vec<String> = circles(&svg).into_iter().map(|circle| circle.2).collect();
    assert_eq!(fills[1], fills[2]);
    assert!(fills[0] != fills[1] && fills[3] != fills[0] && fills[3] != fills[1]);
}
