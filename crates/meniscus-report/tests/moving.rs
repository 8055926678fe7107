//! Arrows and movies of particles: that they point and move as the flow does.

use meniscus_report::{ParticlePictures, Snapshot};

/// One particle at x (m) and two at the corners of the picture.
fn snapshot(time: f64, x: f64) -> Snapshot {
    Snapshot {
        time,
        positions: vec![[x, 0.0, 0.0], [-1e-4, -1e-4, 0.0], [1e-4, 1e-4, 0.0]],
        diameter: 1e-5,
        values: vec![1.0, 2.0, 3.0],
    }
}

fn pictures() -> ParticlePictures {
    ParticlePictures::new("Speed", "m/s")
        .with(snapshot(0.0, -5e-5))
        .with(snapshot(1e-3, 5e-5))
}

#[test]
fn arrows_point_where_particles_go_and_not_where_there_is_no_speed() {
    let still = vec![[0.0; 3]; 3];
    let moving = vec![[0.3, 0.3, 0.0], [0.0; 3], [0.0; 3]];
    let plain = pictures().figure("speed", "").svg().unwrap();
    let none = pictures().arrows(vec![still.clone(), still.clone()]);
    assert_eq!(none.figure("speed", "").svg().unwrap(), plain);
    let one = pictures()
        .arrows(vec![moving, still])
        .figure("speed", "")
        .svg()
        .unwrap();
    let lines = |svg: &str| svg.matches("<polyline").count() + svg.matches("<path").count();
    assert!(lines(&one) > lines(&plain), "{one}");
}

#[test]
fn a_movie_is_an_animated_png_of_all_pictures_which_differ() {
    let bytes = pictures().movie("movie", "").png().unwrap();
    let mut reader = png::Decoder::new(std::io::Cursor::new(&bytes))
        .read_info()
        .unwrap();
    let animation = *reader.info().animation_control().unwrap();
    assert_eq!((animation.num_frames, animation.num_plays), (2, 0));
    let mut frame = || {
        let mut dots = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut dots).unwrap();
        dots
    };
    let (first, second) = (frame(), frame());
    assert_ne!(first, second);
    assert!(
        ParticlePictures::new("Speed", "m/s")
            .movie("movie", "")
            .png()
            .is_err()
    );
}
