//! Walls from a mesh of triangles.

use std::f64::consts::PI;

use meniscus::physics::wall::layout::Side;
use meniscus::scheme::{BodyForce, DensityDiffusion, DiffusionForm, PressureForm, Scheme, Wall};
use meniscus::shape::{Arrangement, FillError, Mesh, MeshError, Pattern, Shape};
use meniscus::{Domain, Fluid, Setup, Simulation, Vector};

use crate::setups::{layers, tank, wall_particles};

type Triangle = [Vector<f64, 3>; 3];

/// A cube of this side with a corner at the origin, open at the top, facing outward.
fn open_box(side: f64) -> Vec<Triangle> {
    let corner = |x: u8, y: u8, z: u8| Vector([x, y, z].map(f64::from)) * side;
    let squares = [
        [(0, 0, 0), (0, 1, 0), (1, 1, 0), (1, 0, 0)],
        [(0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1)],
        [(1, 1, 0), (0, 1, 0), (0, 1, 1), (1, 1, 1)],
        [(0, 1, 0), (0, 0, 0), (0, 0, 1), (0, 1, 1)],
        [(1, 0, 0), (1, 1, 0), (1, 1, 1), (1, 0, 1)],
    ];
    (squares.iter())
        .flat_map(|square| {
            let [a, b, c, d] = square.map(|(x, y, z)| corner(x, y, z));
            [[a, b, c], [a, c, d]]
        })
        .collect()
}

/// A sphere about the origin, facing outward.
fn sphere(radius: f64, rings: usize) -> Vec<Triangle> {
    let point = |ring: usize, k: usize| {
        let (polar, turn) = (
            PI * ring as f64 / rings as f64,
            PI * (k % (2 * rings)) as f64 / rings as f64,
        );
        // The poles are one point, to the bit.
        let across = if ring.is_multiple_of(rings) {
            0.0
        } else {
            polar.sin()
        };
        Vector([across * turn.cos(), across * turn.sin(), polar.cos()]) * radius
    };
    let mut triangles = Vec::new();
    for ring in 0..rings {
        for k in 0..2 * rings {
            let (a, b) = (point(ring, k), point(ring + 1, k));
            let (c, d) = (point(ring + 1, k + 1), point(ring, k + 1));
            if ring + 1 < rings {
                triangles.push([a, b, c]);
            }
            if ring > 0 {
                triangles.push([a, c, d]);
            }
        }
    }
    triangles
}

fn binary_stl(triangles: &[Triangle]) -> Vec<u8> {
    // A header that lies, as some programs write.
    let mut bytes = b"solid, but binary".to_vec();
    bytes.resize(80, 0);
    bytes.extend((triangles.len() as u32).to_le_bytes());
    for triangle in triangles {
        bytes.extend([0; 12]);
        for x in triangle.iter().flat_map(|corner| corner.0) {
            bytes.extend((x as f32).to_le_bytes());
        }
        bytes.extend([0; 2]);
    }
    bytes
}

fn ascii_stl(triangles: &[Triangle]) -> String {
    let facet = |corners: &Triangle| {
        let corners = corners.map(|Vector([x, y, z])| format!("vertex {x} {y} {z}\n"));
        format!(
            "facet normal 0 0 0\nouter loop\n{}endloop\nendfacet\n",
            corners.concat()
        )
    };
    let facets: String = triangles.iter().map(facet).collect();
    format!("solid box\n{facets}endsolid box\n")
}

#[test]
fn ascii_and_binary_files_hold_the_same_mesh() {
    let triangles = open_box(3.0);
    let mesh = Mesh::new(&triangles).unwrap();
    assert_eq!(mesh.area(), 45.0);
    assert_eq!(mesh, Mesh::from_stl(&binary_stl(&triangles), 1.0).unwrap());
    let text = ascii_stl(&triangles);
    assert_eq!(mesh, Mesh::from_stl(text.as_bytes(), 1.0).unwrap());
    let small = Mesh::from_stl(text.as_bytes(), 1e-3).unwrap();
    assert!((small.area() / 45e-6 - 1.0).abs() < 1e-12);
}

#[test]
fn meshes_of_no_use_say_which_triangle() {
    let mut triangles = open_box(1.0);
    assert_eq!(Mesh::new(&[]), Err(MeshError::Empty));
    let flipped = [triangles[0], triangles[1], {
        let [a, b, c] = triangles[2];
        [a, c, b]
    }];
    assert_eq!(Mesh::new(&flipped), Err(MeshError::Flipped(2, 3)));
    triangles[4][1] = triangles[4][0];
    assert_eq!(Mesh::new(&triangles), Err(MeshError::Degenerate(5)));
    triangles[3][0][2] = f64::NAN;
    assert_eq!(Mesh::new(&triangles), Err(MeshError::NotFinite(4)));
    for bytes in [
        &b""[..],
        b"no solid at all, but long enough for the header of a binary file, which has eighty-four bytes",
        b"solid\nvertex 1 2\n",
        b"solid\nvertex 1 2 3\n",
    ] {
        assert!(matches!(
            Mesh::from_stl(bytes, 1.0),
            Err(MeshError::NotStl(_))
        ));
    }
    let mut cut = binary_stl(&open_box(1.0));
    cut.pop();
    assert!(matches!(
        Mesh::from_stl(&cut, 1.0),
        Err(MeshError::NotStl(_))
    ));
}

#[test]
fn a_box_of_triangles_holds_water_as_the_tank_does() {
    let spacing = 0.1;
    let mut scheme = Scheme::new(1.5 * spacing);
    scheme.pressure = PressureForm::OverDensityProduct;
    scheme.body_force = Some(BodyForce::Constant([0.0, 0.0, -9.81]));
    let mut liquid = Fluid::new("liquid", 1000.0);
    liquid.sound_speed = 30.0;
    let built_in = tank::<3>(0.8, 0.8, 0.4, spacing, scheme, liquid);
    let mesh = Mesh::new(&open_box(0.8)).unwrap();
    let layers = layers(&built_in.scheme, spacing);
    let wall = layers.mesh(&mesh, Side::Outside).unwrap();
    let mut setup = built_in.clone();
    setup.particles.retain(|p| p.body == 0);
    setup
        .particles
        .extend(wall_particles(wall, 1, 1000.0, spacing));
    // What is missing is in the corners, beyond the reach of any liquid.
    assert!(setup.particles.len() < built_in.particles.len());
    let mut both = [built_in, setup].map(|setup| Simulation::new(setup).unwrap());
    for simulation in &mut both {
        simulation.advance_to(0.1).unwrap();
    }
    let pressures = both.each_ref().map(|simulation| {
        let p = simulation.particles();
        let mut fluid: Vec<(u32, f64)> = (0..p.len())
            .filter(|&i| p.body[i] == 0)
            .map(|i| (p.id[i], p.pressure[i]))
            .collect();
        fluid.sort_unstable_by_key(|(id, _)| *id);
        fluid
    });
    for ((_, a), (_, b)) in pressures[0].iter().zip(&pressures[1]) {
        // Sums in another order; rounding grows as particles move.
        assert!((a - b).abs() < 1e-6 * 1000.0 * 9.81 * 0.4, "{a} {b}");
    }
    let loads = both
        .each_ref()
        .map(|simulation| simulation.wall_loads()[0].force[2]);
    assert!((loads[0] / loads[1] - 1.0).abs() < 1e-6, "{loads:?}");
}

#[test]
fn a_sphere_of_triangles_holds_water() {
    let (spacing, radius) = (0.1, 0.5);
    let mut scheme = Scheme::new(1.5 * spacing);
    scheme.pressure = PressureForm::OverDensityProduct;
    scheme.body_force = Some(BodyForce::Constant([0.0, 0.0, -9.81]));
    scheme.damping = 10.0;
    scheme.density_diffusion = Some(DensityDiffusion {
        form: DiffusionForm::Antuono,
        strength: 0.1,
    });
    let mut liquid = Fluid::new("liquid", 1000.0);
    liquid.sound_speed = 25.0;
    let mesh = Mesh::new(&sphere(radius, 24)).unwrap();
    let wall = layers(&scheme, spacing).mesh(&mesh, Side::Outside).unwrap();
    assert!(wall.iter().all(|x| x.norm() > 0.99 * radius));
    // The lower half of the sphere, on the lattice of its wall.
    let lower = Shape::Intersection(vec![
        Shape::Ball {
            centre: Vector::ZERO,
            radius,
        },
        Shape::HalfSpace {
            point: Vector::ZERO,
            normal: Vector([0.0, 0.0, 1.0]),
        },
    ]);
    let mut lattice = Arrangement::new(Pattern::Cubic, spacing);
    lattice.origin = Some(Vector([0.5 * spacing; 3]));
    let mut particles = lattice.body(&lower, 1000.0, 10_000).unwrap();
    let weight = 9.81 * particles.iter().map(|p| p.mass).sum::<f64>();
    particles.extend(wall_particles(wall, 1, 1000.0, spacing));
    scheme.walls = vec![Wall::new(1)];
    let mut simulation = Simulation::new(Setup {
        scheme,
        fluids: vec![liquid],
        particles,
        spacing,
        domain: Domain::default(),
    })
    .unwrap();
    simulation.advance_to(1.5).unwrap();
    let p = simulation.particles();
    for i in (0..p.len()).filter(|&i| p.body[i] == 0) {
        let r = p.position[i].norm();
        assert!(r < radius + 0.5 * spacing, "{r}");
    }
    let load = simulation.wall_loads()[0].force;
    // Slowly it settles further.
    assert!((load[2] / -weight - 1.0).abs() < 0.01, "{load:?} {weight}");
}

#[test]
fn the_wall_of_an_open_mesh_ends_where_the_mesh_does() {
    let [a, b, c, d] =
        [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|[x, y]| Vector([x, y, 0.0]));
    let square = Mesh::new(&[[a, b, c], [a, c, d]]).unwrap();
    let scheme = Scheme::new(0.15);
    let layers = layers(&scheme, 0.1);
    let wall = layers.mesh(&square, Side::Inside).unwrap();
    let plane = layers
        .plane(Vector([0.5, 0.5, 0.0]), Vector([0.0, 0.0, 1.0]), 1.0)
        .unwrap();
    assert_eq!(wall.len(), plane.len());
    for place in wall {
        assert!(plane.iter().any(|other| (*other - place).norm() < 1e-9));
    }
    // A closed obstacle is filled as deep as the kernel reaches.
    let ball = Mesh::new(&sphere(0.5, 24)).unwrap();
    let obstacle = layers.mesh(&ball, Side::Inside).unwrap();
    assert!(obstacle.iter().all(|x| x.norm() < 0.5));
    let volume = obstacle.len() as f64 * 1e-3;
    let shell = 4.0 / 3.0 * PI * (0.5_f64.powi(3) - 0.2_f64.powi(3));
    // A surface of 3 m^2 cuts a lattice of 0.1 m.
    assert!((volume / shell - 1.0).abs() < 0.1, "{volume} for {shell}");
    let few = meniscus::physics::wall::layout::Layers::new(0.1, 0.3, 10);
    assert!(matches!(
        few.mesh(&ball, Side::Inside),
        Err(FillError::TooMany { .. })
    ));
}
