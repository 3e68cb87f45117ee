//! Lines with mass at rest: the elastic catenary, the seabed, and what hangs on them.

use kingpost::elements::lines::{Catenary, Span};
use kingpost::elements::{DynamicLine, LineGround, LinePart, LineSection};
use kingpost::scenario::read;
use kingpost::simulation::{Setup, Simulation};
use kingpost::spatial::{Frame, Vector3};

const G: f64 = 9.80665;

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

fn setup(more: &str) -> Setup {
    let text = format!(
        "version: 1
title: A line at rest
simulation: {{step_s: 0.05, duration_s: 10, record_every_s: 0.1}}
{more}"
    );
    read(&text, "line.yaml", &[]).expect("it reads").setup().expect("it builds")
}

const ALONE: &str = "forces: {gravity: {gravity: {}}}
bodies: {point: {mass_kg: 1, shape: {point: {}}, joint: {fixed: {}}}}
";

/// Returns tension at both ends and length on the ground of a line at rest between two points of the world.
pub fn at_rest([from, to]: [[f64; 3]; 2], parts: &[LinePart], ground: Option<LineGround>) -> [f64; 3] {
    let mut setup = setup(ALONE);
    let ends = [from, to].map(|point| setup.model.attachment(None, Frame::translation(Vector3(point))));
    let line = DynamicLine::new("chain", ends, parts);
    setup.elements.push(Box::new(match ground {
        Some(ground) => line.on(ground),
        None => line,
    }));
    let mut run = Simulation::new(setup);
    ["line_tension", "line_end_tension", "line_grounded_length"].map(|name| crate::common::values(&mut run, name)[0])
}

#[test]
fn a_hanging_line_is_an_elastic_catenary_to_fourth_order() {
    let catenary = Catenary { unstretched_length: 850.0, weight: 685.0 * G, axial_stiffness: 3.27e9, on_seabed: false };
    let force = catenary.force(&Span { across: 779.6, up: 186.0 });
    let [upper, lower, _] = catenary.tensions(&force);
    let errors = [10, 20, 40, 160].map(|elements| {
        let part = LinePart { unstretched_length: 850.0, section: CHAIN, elements };
        let [first, last, _] = at_rest([[0.0, 0.0, -14.0], [779.6, 0.0, -200.0]], &[part], None);
        (first / upper - 1.0).abs().max((last / lower - 1.0).abs())
    });
    assert!(errors[0] / errors[1] > 12.0 && errors[1] / errors[2] > 12.0, "{errors:?}");
    assert!(errors[3] < 1e-9, "{errors:?}");
}

#[test]
fn a_line_over_the_seabed_is_a_grounded_catenary() {
    // 200 m hang over 60 m of water, 300 m lie; the lying part sinks by w / k, a thousandth of the depth.
    let catenary = Catenary { unstretched_length: 430.0, weight: 685.0 * G, axial_stiffness: 3.27e9, on_seabed: true };
    let force = catenary.force(&Span { across: 400.0, up: 60.0 });
    let [upper, lower, lies] = catenary.tensions(&force);
    let ground = LineGround::level(60.0, 1e6);
    let part = LinePart { unstretched_length: 430.0, section: CHAIN, elements: 86 };
    let [first, last, grounded] = at_rest([[400.0, 0.0, 0.0], [0.0, 0.0, -60.0]], &[part], Some(ground));
    // The touchdown lies somewhere in an element of 5 m: a second-order error of its length over that of the hanging part.
    assert!((first / upper - 1.0).abs() < 2e-3, "{first} {upper}");
    assert!((last / lower - 1.0).abs() < 5e-3, "{last} {lower}");
    assert!((grounded - lies).abs() < 5.0, "{grounded} {lies}");
}

#[test]
fn a_line_that_is_longer_than_its_way_lies_slack_on_the_seabed() {
    // The hanging part is vertical, and its tension is its weight: z = V / w + V^2 / 2 EA w.
    let ground = LineGround::level(60.0, 1e6);
    let part = LinePart { unstretched_length: 430.0, section: CHAIN, elements: 86 };
    let [first, last, _] = at_rest([[330.0, 0.0, 0.0], [0.0, 0.0, -60.0]], &[part], Some(ground));
    // Half an element more or less hangs, and carries its weight.
    assert!((first / (685.0 * G * 60.0) - 1.0).abs() < 0.05, "{first}");
    assert!(last < 0.02 * first, "{last} {first}");
}

#[test]
fn sections_of_a_line_carry_what_hangs_below_them() {
    // A vertical line of two sections: the tension at the top is the weight of both.
    let wire = LineSection { mass_per_length: 30.0, axial_stiffness: 8e8, ..CHAIN };
    let parts = [
        LinePart { unstretched_length: 100.0, section: wire, elements: 3 },
        LinePart { unstretched_length: 50.0, section: CHAIN, elements: 2 },
    ];
    let pull = 2e5;
    // Stretch of each section under its load at the middle, which is exact.
    let of_wire = (pull + (685.0 * 50.0 + 30.0 * 50.0) * G) * 100.0 / 8e8;
    let of_chain = (pull + 685.0 * 25.0 * G) * 50.0 / 3.27e9;
    let bottom = -(150.0 + of_wire + of_chain);
    let [first, last, _] = at_rest([[0.0, 0.0, 0.0], [0.0, 0.0, bottom]], &parts, None);
    let weight = (30.0 * 100.0 + 685.0 * 50.0) * G;
    assert!((first - pull - weight).abs() < 1e-6 * weight, "{first}");
    assert!((last - pull).abs() < 1e-6 * weight, "{last}");
}

#[test]
fn a_moored_float_settles_where_its_lines_hold_it() {
    // A body of 20 t hangs on two equal lines; each carries half its weight and half of that of the line beyond.
    let more = "forces: {gravity: {gravity: {}}}
bodies:
  load: {mass_t: 20, shape: {point: {}}, joint: {floating: {hold_rotation: true, initial: {position_m: [0, 0, -60]}}}}
";
    let mut setup = setup(more);
    let wire = LineSection { mass_per_length: 30.0, axial_stiffness: 8e8, ..CHAIN };
    for (name, x) in [("left", -50.0), ("right", 50.0)] {
        let ends = [
            setup.model.attachment(None, Frame::translation(Vector3::new(x, 0.0, 0.0))),
            setup.model.attachment(Some(0), Frame::translation(Vector3::zero())),
        ];
        let part = LinePart { unstretched_length: 80.0, section: wire, elements: 8 };
        setup.elements.push(Box::new(DynamicLine::new(name, ends, &[part])));
    }
    let mut run = Simulation::new(setup);
    let found = run.settle().expect("there is an equilibrium");
    assert!(found.residual < 1e-9, "{found:?}");
    let before = run.state().q.clone();
    run.step(200).expect("it does not diverge");
    let moved = run.state().q.iter().zip(&before).map(|(now, then)| (now - then).abs()).fold(0.0, f64::max);
    // It stays at rest: Newton's method leaves 1e-9 of 80 m.
    assert!(moved < 8e-8, "{moved}");
    let [left, right] = [0, 1].map(|line| crate::common::values(&mut run, "line_tension")[line]);
    assert!((left / right - 1.0).abs() < 1e-9, "{left} {right}");
}

/// Returns the tensions at the ends of a chain of two sections of this length between two points 100 m under the surface,
/// with a clump weight between the sections.
fn with_clump(clump: &str, length: f64, across: f64) -> [f64; 2] {
    let section = format!(
        "unstretched_length_m: {length}, elements: 12, mass_kg_per_m: 20, diameter_m: 0.05, axial_stiffness_N: 4.0e8"
    );
    let mut run = Simulation::new(setup(&format!(
        "forces:
  gravity: {{gravity: {{}}}}
  chain:
    line:
      first: {{body: point, position_m: [{across}, 0, -100]}}
      second: {{body: world, position_m: [0, 0, -100]}}
      sections:
        - {{{section}, clump_weight: {clump}}}
        - {{{section}}}
bodies: {{point: {{mass_kg: 1, shape: {{point: {{}}}}, joint: {{fixed: {{}}}}}}}}
"
    )));
    ["line_tension", "line_end_tension"].map(|name| crate::common::values(&mut run, name)[0])
}

/// Returns a section as a catenary in water.
fn in_water(unstretched_length: f64) -> Catenary {
    let weight = (20.0 - 1025.0 * core::f64::consts::FRAC_PI_4 * 0.05 * 0.05) * G;
    Catenary { unstretched_length, weight, axial_stiffness: 4e8, on_seabed: false }
}

#[test]
fn a_clump_weight_hangs_where_two_catenaries_meet() {
    let tensions = with_clump("{mass_kg: 5000, volume_m3: 1}", 100.0, 150.0);
    // By symmetry it hangs in the middle, and each end carries half of everything. The deeper it hangs, the smaller the
    // horizontal force, so that the vertical one decreases.
    let section = in_water(100.0);
    let vertical = 0.5 * (5000.0 - 1025.0) * G + 100.0 * section.weight;
    let at = |up: f64| section.force(&Span { across: 75.0, up });
    let [mut high, mut low] = [1.0, 99.0];
    for _ in 0..60 {
        let middle = 0.5 * (high + low);
        *(if at(middle).vertical > vertical { &mut low } else { &mut high }) = middle;
    }
    let [expected, ..] = section.tensions(&at(0.5 * (high + low)));
    // Fourth order: elements of 8 m.
    for tension in tensions {
        assert!((tension / expected - 1.0).abs() < 1e-5, "{tension} {expected}");
    }
}

#[test]
fn a_submerged_buoy_carries_two_catenaries() {
    let tensions = with_clump("{mass_kg: 500, volume_m3: 8}", 100.0, 60.0);
    // Each part carries half of the net lift at the buoy: the higher it is, the tauter they are.
    let section = in_water(100.0);
    let vertical = 0.5 * (8.0 * 1025.0 - 500.0) * G;
    let at = |up: f64| section.force(&Span { across: 30.0, up });
    let [mut low, mut high] = [90.0, 95.5];
    for _ in 0..60 {
        let middle = 0.5 * (high + low);
        *(if at(middle).vertical > vertical { &mut high } else { &mut low }) = middle;
    }
    let [_, expected, ..] = section.tensions(&at(0.5 * (high + low)));
    // Fourth order: elements of 8 m.
    for tension in tensions {
        assert!((tension / expected - 1.0).abs() < 1e-5, "{tension} {expected}");
    }
}

#[test]
fn a_buoy_at_the_surface_carries_two_catenaries() {
    let tensions = with_clump("{mass_kg: 500, volume_m3: 8}", 120.0, 60.0);
    // Wet share of a body as high as the sphere of 8 m3, in equilibrium with its weight and two legs.
    let diameter = (8.0 * 6.0 / core::f64::consts::PI).cbrt();
    let (section, mut height) = (in_water(120.0), 0.0);
    for _ in 0..50 {
        let carried = 500.0 * G + 2.0 * section.force(&Span { across: 30.0, up: 100.0 + height }).vertical;
        height = diameter * (0.5 - carried / (1025.0 * G * 8.0));
    }
    let [_, expected, ..] = section.tensions(&section.force(&Span { across: 30.0, up: 100.0 + height }));
    // The chain has a radius of 11 m at its ends, where the elements are 10 m long.
    for tension in tensions {
        assert!((tension / expected - 1.0).abs() < 5e-3, "{tension} {expected}");
    }
}

#[test]
fn a_vertical_line_through_the_surface_is_found_at_rest_with_derivatives() {
    let text = "version: 1
title: A load on a wire
simulation: {step_s: 0.05, duration_s: 10, record_every_s: 0.1}
bodies:
  load:
    mass_kg: 100000
    shape: {box: {length_m: 2, width_m: 2, height_m: 2}}
    joint: {floating: {initial: {position_m: [0, 0, -90.2]}}}
forces:
  gravity: {gravity: {}}
  wire:
    line:
      first: {body: world, position_m: [0, 0, 10]}
      second: {body: load, position_m: [0, 0, 0]}
      sections:
        - {unstretched_length_m: 100, elements: 4, mass_kg_per_m: 30, diameter_m: 0.068, axial_stiffness_N: 8.0e8}
";
    let read = read(text, "line.yaml", &[]).expect("it reads");
    read.setup().expect("it builds");
    read.setup_over::<kingpost::plant::Number>().expect("it builds with derivatives");
}

/// A load of 80 t on 4000 m of wire, whose unstretched length ends `slack` m below it.
fn load_on_wire(slack: f64) -> Simulation {
    let more = format!(
        "bodies:
  load: {{mass_t: 80, shape: {{point: {{}}}}, joint: {{prismatic: {{axis: [0, 0, 1], position_m: [0, 0, {}]}}}}}}
forces:
  gravity: {{gravity: {{}}}}
  wire:
    line:
      first: {{body: world}}
      second: {{body: load}}
      sections: [{{unstretched_length_m: 4000, elements: 8, mass_kg_per_m: 30, diameter_m: 1.0e-6, axial_stiffness_N: 8.0e8}}]
",
        slack - 4000.0
    );
    Simulation::new(setup(&more))
}

#[test]
fn warns_of_a_wire_that_becomes_slack() {
    // Released 1 m above its rest, a fifth of the stretch by its weight, the load stays on its wire; 5 m above it falls.
    let stretch = 8e4 * 4000.0 * G / 8e8;
    let codes = [1.0, 5.0].map(|above| {
        let own = 30.0 * 4000.0 * 2000.0 * G / 8e8;
        let mut run = load_on_wire(above - own - stretch);
        run.run(|_| true).warnings.iter().map(|warning| warning.code).collect::<Vec<_>>()
    });
    assert!(codes[0].is_empty() && codes[1] == ["slack_line"], "{codes:?}");
}
