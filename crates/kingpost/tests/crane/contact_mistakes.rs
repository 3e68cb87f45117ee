//! Mistakes that a user can make with a contact: each is reported at its place.

use crate::common;

use common::{simulation, values};
use kingpost::scenario::read;

const TEXT: &str = "version: 1
title: A crate on a deck
simulation: {step_s: 0.002, duration_s: 60}
bodies:
  platform:
    mass_t: 50
    shape: {box: {length_m: 10, width_m: 10, height_m: 1}}
    joint: {prismatic: {name: heave, axis: [0, 0, 1], spring: {stiffness_N_per_m: 1e9}}}
  crate:
    mass_kg: 500
    shape: {box: {length_m: 2, width_m: 1, height_m: 1}}
    joint: {floating: {initial: {position_m: [0, 0, 1.01]}}}
forces:
  gravity: {gravity: {}}
  deck:
    contact:
      load: {body: crate, shape: {box: {length_m: 2, width_m: 1, height_m: 1}}}
      surface: {body: platform, shape: {box: {length_m: 10, width_m: 10, height_m: 1}}}
      stiffness_N_per_m: 1e6
      friction_coefficient: 0.4
";

fn refused(from: &str, to: &str) -> String {
    assert!(TEXT.contains(from), "{from}");
    let text = TEXT.replacen(from, to, 1);
    let error = read(&text, "deck.yaml", &[]).and_then(|scenario| scenario.setup()).expect_err("a mistake");
    error.to_string()
}

#[test]
fn an_invalid_contact_is_refused_at_its_place() {
    let cases = [
        (
            "load: {body: crate",
            "load: {body: crat",
            "forces.deck.contact.load.body: found crat, allowed: one of platform, crate",
        ),
        (
            "surface: {body: platform",
            "surface: {body: deck",
            "forces.deck.contact.surface.body: found deck, allowed: one of platform, crate, world",
        ),
        (
            "surface: {body: platform",
            "surface: {body: crate",
            "forces.deck.contact.surface.body: found crate, allowed: another body than load.body, crate",
        ),
        ("load: {body: crate", "load: {body: world", "forces.deck.contact.load.body: found world"),
        (
            "shape: {box: {length_m: 2, width_m: 1, height_m: 1}}}\n      surface",
            "shape: {cone: {half_angle_deg: 90, length_m: 1}}}\n      surface",
            "forces.deck.contact.load.shape.cone.half_angle_rad: found 1.5707963267948966, allowed: 0.0017 to 1.5691 rad",
        ),
        (
            "shape: {box: {length_m: 2, width_m: 1, height_m: 1}}}\n      surface",
            "shape: {cone: {half_angle_deg: 0, length_m: 1}}}\n      surface",
            "forces.deck.contact.load.shape.cone.half_angle_deg: found 0",
        ),
        (
            "shape: {box: {length_m: 2, width_m: 1, height_m: 1}}}\n      surface",
            "shape: {ring: {radius_m: 0, bar_radius_m: 0.1}}}\n      surface",
            "forces.deck.contact.load.shape.ring.radius_m: found 0",
        ),
        (
            "shape: {box: {length_m: 2, width_m: 1, height_m: 1}}}\n      surface",
            "shape: {ring: {radius_m: 0.2, bar_radius_m: 0.2}}}\n      surface",
            "forces.deck.contact.load.shape.ring.bar_radius_m: found 0.2, allowed: less than radius_m, 0.2",
        ),
        (
            "shape: {box: {length_m: 2, width_m: 1, height_m: 1}}}\n      surface",
            "shape: {convex: {positions_m: [[0, 0, 0], [1, 0, 1], [0, 1, 1], [1, 1, 2]]}}}\n      surface",
            "forces.deck.contact.load.shape.convex.positions_m: found points without a convex hull, allowed: points that are not in one plane",
        ),
        (
            "shape: {box: {length_m: 2, width_m: 1, height_m: 1}}}\n      surface",
            "shape: {convex: {positions_m: [[0, 0, 0], [1, 0, 1], [0, 1, 1]]}}}\n      surface",
            "forces.deck.contact.load.shape.convex.positions_m: found 3 points, allowed: 4 to 32 points",
        ),
        (
            "shape: {box: {length_m: 10, width_m: 10, height_m: 1}}}\n      stiff",
            "shape: {ring: {radius_m: 1, bar_radius_m: 1}}}\n      stiff",
            "forces.deck.contact.surface.shape.ring.bar_radius_m: found 1, allowed: less than radius_m, 1",
        ),
        (
            "shape: {box: {length_m: 2, width_m: 1, height_m: 1}}}\n      surface",
            "shape: {points: {positions_m: []}}}\n      surface",
            "forces.deck.contact.load.shape.points.positions_m: found 0 points, allowed: 1 to 64 points",
        ),
        (
            "friction_coefficient: 0.4",
            "friction_coefficient: 0.4\n      restitution: 0.05",
            "forces.deck.contact.restitution: found 0.05, allowed: a number from 0.1 to 1",
        ),
        ("friction_coefficient: 0.4", "friction_coefficient: -1", "forces.deck.contact.friction_coefficient: found -1"),
        (
            "stiffness_N_per_m: 1e6\n      fr",
            "stiffness_N_per_m: 0\n      fr",
            "forces.deck.contact.stiffness_N_per_m: found 0",
        ),
        (
            "position_m: [0, 0, 1.01]",
            "position_m: [0, 0, 0.9]",
            "forces.deck.contact.load: found a load 0.1000 m inside its surface, allowed: at most its penetration_tolerance_m, \
             0.02 m, where the run begins",
        ),
    ];
    for (from, to, expected) in cases {
        let error = refused(from, to);
        assert!(error.contains(expected), "{error}");
        assert!(error.starts_with("deck.yaml:"), "{error}");
    }
}

/// Load and surface of the crate's contact.
fn refused_pair(load: &str, surface: &str) -> String {
    let text = TEXT.replace("load: {body: crate, shape: {box: {length_m: 2, width_m: 1, height_m: 1}}}", load);
    let text =
        text.replace("surface: {body: platform, shape: {box: {length_m: 10, width_m: 10, height_m: 1}}}", surface);
    read(&text, "deck.yaml", &[]).and_then(|scenario| scenario.setup()).expect_err("a mistake").to_string()
}

/// The error says why, and what serves instead.
#[test]
fn shapes_that_cannot_touch_are_refused_with_what_serves_instead() {
    let (ring, cone) = ("ring: {radius_m: 1, bar_radius_m: 0.1}", "cone: {half_angle_deg: 30, length_m: 1}");
    let disc = "cylinder: {radius_m: 1, length_m: 1}";
    let on_ring = "load.shape: found ring, allowed: one of sphere, box, convex, cylinder, capsule, cone, on a ring: the nearest \
                   points of two rings come in pairs";
    let on_cone = "load.shape: found cone, allowed: one of points, sphere, box, convex, cylinder, capsule, ring, on a cone: sides";
    let disc_on_cone = "load.shape.cylinder.length_m: found a disc, allowed: more than the diameter, on a cone";
    let cone_on_disc = "surface.shape.cylinder.length_m: found a disc, allowed: more than the diameter, on a cone";
    for (load, surface, expected) in
        [(ring, ring, on_ring), (cone, cone, on_cone), (disc, cone, disc_on_cone), (cone, disc, cone_on_disc)]
    {
        let error = refused_pair(
            &format!("load: {{body: crate, shape: {{{load}}}}}"),
            &format!("surface: {{body: platform, shape: {{{surface}}}}}"),
        );
        assert!(error.contains(&format!("forces.deck.contact.{expected}")), "{error}");
    }
}

/// 500 kg on four points of 20 kN/m would rest at a penetration of 61 mm.
#[test]
fn a_deck_that_is_too_soft_for_its_load_is_refused() {
    let text = TEXT.replace("stiffness_N_per_m: 1e6\n      fr", "stiffness_N_per_m: 2e4\n      fr");
    let text = text.replace("duration_s: 60", "duration_s: 60, begin_at_equilibrium: true");
    let error = read(&text, "deck.yaml", &[]).and_then(|scenario| scenario.setup()).expect_err("too soft").to_string();
    assert!(error.contains("forces.deck.contact.load: found a load 0.0613 m inside"), "{error}");
    assert!(error.contains("at rest: make the contact stiffer"), "{error}");
}

/// 500 kg that fall from 0.51 m penetrate 4 MN/m by about 10 mm: v sqrt(m / 4 k) = 35 mm without damping.
#[test]
fn a_run_warns_of_a_load_with_excessive_penetration() {
    let text = TEXT.replace("1.01]", "1.52]").replace("duration_s: 60", "duration_s: 2");
    let text = text.replace("coefficient: 0.4\n", "coefficient: 0.4\n      penetration_tolerance_m: 0.004\n");
    let run = simulation(&text).run(|_| true);
    let warning = run.warnings.iter().find(|warning| warning.name == "deck").expect("a warning");
    assert!(warning.text.contains("more than its penetration_tolerance_m of 0.004 m"), "{warning:?}");
}

/// With the contact disabled nothing touches, and the load falls through.
#[test]
fn a_disabled_contact_does_not_exist() {
    let off = TEXT.replace("contact:\n", "contact:\n      enabled: false\n");
    let mut falling = simulation(&off);
    falling.step(500).expect("it falls");
    assert!(falling.channels().iter().all(|channel| channel.variable != "contact_force"));
    assert!(values(&mut falling, "kinetic_energy")[0] > 1e4);
}
