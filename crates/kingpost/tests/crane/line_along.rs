//! Results along lines with mass: tensions at points, touchdown and length.

use kingpost::elements::lines::{Catenary, Span};
use kingpost::elements::{DynamicLine, LineGround, LinePart, LineSection};
use kingpost::scenario::read;
use kingpost::simulation::Simulation;
use kingpost::spatial::{Frame, Vector3};

const G: f64 = 9.80665;
const POINTS: usize = 21;

/// Chain: 685 kg/m, without water.
const CHAIN: LineSection = LineSection {
    mass_per_length: 685.0,
    diameter: 1e-9,
    axial_stiffness: 3.27e9,
    damping_time: 0.0,
    bending_stiffness: 0.0,
    added_mass: [1.0, 0.0],
    drag: [1.2, 0.0],
};

const ALONE: &str = "version: 1
title: A line at rest
simulation: {step_s: 0.05, duration_s: 10, record_every_s: 0.1}
forces: {gravity: {gravity: {}}}
bodies: {point: {mass_kg: 1, shape: {point: {}}, joint: {fixed: {}}}}
";

/// A run with a line at rest between two points of the world, with results at this number of points.
fn run([from, to]: [[f64; 3]; 2], parts: &[LinePart], ground: Option<LineGround>, points: usize) -> Simulation {
    let mut setup = read(ALONE, "line.yaml", &[]).expect("it reads").setup().expect("it builds");
    let ends = [from, to].map(|point| setup.model.attachment(None, Frame::translation(Vector3(point))));
    let line = DynamicLine::new("chain", ends, parts).with_points_along(points);
    setup.elements.push(Box::new(match ground {
        Some(ground) => line.on(ground),
        None => line,
    }));
    Simulation::new(setup)
}

fn value(run: &mut Simulation, name: &str) -> f64 {
    crate::common::values(run, name)[0]
}

fn ground() -> LineGround {
    LineGround::level(60.0, 1e6)
}

#[test]
fn the_tension_along_a_vertical_line_is_the_weight_below() {
    // Quadratic elements with Simpson's masses carry a weight that is constant along them without error.
    let wire = LineSection { mass_per_length: 30.0, axial_stiffness: 8e8, ..CHAIN };
    let parts = [
        LinePart { unstretched_length: 100.0, section: wire, elements: 3 },
        LinePart { unstretched_length: 50.0, section: CHAIN, elements: 2 },
    ];
    let pull = 2e5;
    let of_wire = (pull + (685.0 * 50.0 + 30.0 * 50.0) * G) * 100.0 / 8e8;
    let of_chain = (pull + 685.0 * 25.0 * G) * 50.0 / 3.27e9;
    let ends = [[0.0; 3], [0.0, 0.0, -(150.0 + of_wire + of_chain)]];
    let mut run = run(ends, &parts, None, 31);
    let found = crate::common::values(&mut run, "line_tension_along");
    assert_eq!(found.len(), 31);
    for (k, tension) in found.iter().enumerate() {
        let s = 5.0 * k as f64;
        let below = 685.0 * (150.0 - s).min(50.0) + 30.0 * (100.0 - s).max(0.0);
        assert!((tension - pull - below * G).abs() < 1e-6 * pull, "{s} m: {tension}");
    }
    assert!((value(&mut run, "line_length") - 150.0).abs() < 1e-12);
}

#[test]
fn the_tension_along_a_hanging_line_is_that_of_the_elastic_catenary_to_second_order() {
    // T^2 = H^2 + (V - w s)^2; between the points at which the elements know it, it is interpolated linearly.
    let catenary = Catenary { unstretched_length: 850.0, weight: 685.0 * G, axial_stiffness: 3.27e9, on_seabed: false };
    let force = catenary.force(&Span { across: 779.6, up: 186.0 });
    let [upper, lower, _] = catenary.tensions(&force);
    let w = 685.0 * G;
    let vertical = (upper * upper - lower * lower + (w * 850.0).powi(2)) / (2.0 * w * 850.0);
    let horizontal = (upper * upper - vertical * vertical).sqrt();
    let errors = [10, 20, 40].map(|elements| {
        let part = LinePart { unstretched_length: 850.0, section: CHAIN, elements };
        let mut run = run([[0.0, 0.0, -14.0], [779.6, 0.0, -200.0]], &[part], None, POINTS);
        let found = crate::common::values(&mut run, "line_tension_along");
        assert_eq!(found[0], value(&mut run, "line_tension"));
        assert_eq!(found[POINTS - 1], value(&mut run, "line_end_tension"));
        let error = |(k, tension): (usize, &f64)| {
            let s = 850.0 * k as f64 / (POINTS - 1) as f64;
            (tension / horizontal.hypot(vertical - w * s) - 1.0).abs()
        };
        found.iter().enumerate().map(error).fold(0.0, f64::max)
    });
    assert!(errors[0] / errors[1] > 3.5 && errors[1] / errors[2] > 3.5, "{errors:?}");
    assert!(errors[2] < 1e-3, "{errors:?}");
}

#[test]
fn the_touchdown_is_where_the_hanging_part_of_the_catenary_ends() {
    let catenary = Catenary { unstretched_length: 430.0, weight: 685.0 * G, axial_stiffness: 3.27e9, on_seabed: true };
    let force = catenary.force(&Span { across: 400.0, up: 60.0 });
    let [.., lies] = catenary.tensions(&force);
    let errors = [86, 172].map(|elements| {
        let part = LinePart { unstretched_length: 430.0, section: CHAIN, elements };
        let mut run = run([[400.0, 0.0, 0.0], [0.0, 0.0, -60.0]], &[part], Some(ground()), 2);
        (value(&mut run, "line_touchdown") - (430.0 - lies)).abs()
    });
    // Within half an element, on which the nodes leave the ground.
    assert!(errors[0] < 2.5 && errors[1] < 1.25, "{errors:?}");
}

#[test]
fn a_line_that_hangs_free_of_the_seabed_touches_it_at_its_end_only() {
    let part = LinePart { unstretched_length: 410.0, section: CHAIN, elements: 20 };
    let mut run = run([[400.0, 0.0, 0.0], [0.0, 0.0, -20.0]], &[part], Some(ground()), 0);
    assert_eq!(value(&mut run, "line_touchdown"), 410.0);
    assert!(run.channels().iter().all(|channel| channel.variable != "line_tension_along"));
}

#[test]
fn the_channel_tells_line_and_place_of_each_point() {
    let part = LinePart { unstretched_length: 400.0, section: CHAIN, elements: 8 };
    let run = run([[400.0, 0.0, 0.0], [0.0, 0.0, -20.0]], &[part], None, 5);
    let channel = run.channels().iter().find(|channel| channel.variable == "line_tension_along").expect("it is there");
    let along = channel.along.as_ref().expect("it is along a line");
    assert_eq!(channel.dims, ["line_point"]);
    assert_eq!(channel.columns[4], "chain.point_5.line_tension_along");
    assert_eq!(along.lines, ["chain"; 5]);
    assert_eq!(along.shares, [0.0, 0.25, 0.5, 0.75, 1.0]);
    assert_eq!(along.length, "line_length");
    assert!(run.channels().iter().all(|other| other.along.is_none() || other.variable == channel.variable));
}
