//! Mistakes that a user can make with the water forces on a lifted object: each is reported at its place.

use kingpost::scenario::read;

const TEXT: &str = "version: 1
title: A load in the splash zone
simulation: {step_s: 0.05, duration_s: 60}
sea: {current_m_s: [0.2, 0]}
wind: {speed_m_s: 10, direction_rad: 0}
bodies:
  load:
    mass_kg: 20000
    shape: {point: {}}
    joint: {floating: {}}
forces:
  gravity: {gravity: {}}
  water:
    submerged:
      body: load
      shape: {box: {length_m: 4, width_m: 3, height_m: 2}}
      displaced_volume_m3: 20
      added_mass: {coefficients: [0.4, 0.6, 0.9], perforation: 0.1, growth: {shares: [0, 0.3, 1], factors: [0, 0.6, 1]}}
      drag: {coefficients: [1.1, 1.3, 1.8]}
      wind: {coefficients: [1, 1.1, 1]}
";

fn refused(from: &str, to: &str) -> String {
    assert!(TEXT.contains(from), "{from}");
    let text = TEXT.replacen(from, to, 1);
    let error = read(&text, "load.yaml", &[]).and_then(|scenario| scenario.setup()).expect_err("a mistake");
    error.to_string()
}

#[test]
fn every_mistake_is_reported_at_its_place() {
    let place = "forces.water.submerged";
    for (from, to, expected) in [
        ("body: load", "body: lode", "body: found lode, allowed: one of load"),
        ("length_m: 4", "length_m: 0", "shape.box.length_m: found 0"),
        (
            "displaced_volume_m3: 20",
            "displaced_volume_m3: 25",
            "displaced_volume_m3: found 25, allowed: at most the volume",
        ),
        ("coefficients: [0.4, 0.6, 0.9]", "coefficients: [0.4, -0.6, 0.9]", "added_mass.coefficients.1: found -0.6"),
        ("perforation: 0.1", "perforation: 0.6", "added_mass.perforation: found 0.6, allowed: a number from 0 to 0.5"),
        ("factors: [0, 0.6, 1]", "factors: [0, 0.6]", "added_mass.growth.factors: found 2 numbers, allowed: 3"),
        ("factors: [0, 0.6, 1]", "factors: [0.1, 0.6, 1]", "added_mass.growth.factors.0: found 0.1"),
        ("factors: [0, 0.6, 1]", "factors: [0, -0.6, 1]", "added_mass.growth.factors.1: found -0.6"),
        ("shares: [0, 0.3, 1]", "shares: [0, 0.3, 0.9]", "added_mass.growth.shares.2: found 0.9"),
        ("shares: [0, 0.3, 1]", "shares: [0, 1.3, 1]", "added_mass.growth.shares.2: found 1"),
        ("shares: [0, 0.3, 1]", "depths_m: [0.1, 0.3, 1]", "added_mass.growth.depths_m.0: found 0.1"),
        ("shares: [0, 0.3, 1]", "depths_m: [0, 3, 2]", "added_mass.growth.depths_m.2: found 2"),
        ("shares: [0, 0.3, 1]", "depths_m: [0, 0.3, 1]", "added_mass.growth.depths_m.2: found 1, allowed: increasing"),
        (
            "shares: [0, 0.3, 1]",
            "shares: [0, 0.3, 1], depths_m: [0, 1, 2]",
            "added_mass.growth: found shares and depths_m",
        ),
        ("shares: [0, 0.3, 1]", "shares: [0]", "added_mass.growth.shares: found 1 numbers"),
        ("drag: {coefficients: [1.1, 1.3, 1.8]}", "drag: {areas_m2: [1, 0, 2]}", "drag.areas_m2.1: found 0"),
        ("[1, 1.1, 1]}", "[1, 1.1, 1], height_m: 0}", "wind.height_m: found 0"),
    ] {
        let error = refused(from, to);
        assert!(error.contains(&format!("{place}.{expected}")), "{error}\n{expected}");
    }
}

#[test]
fn a_missing_part_of_the_world_is_reported() {
    let error = refused("wind: {speed_m_s: 10, direction_rad: 0}\n", "");
    assert!(error.contains("forces.water.submerged.wind: found wind drag, but no wind"), "{error}");
    let error = refused("gravity: {gravity: {}}", "gravity: {gravity: {enabled: false}}");
    assert!(error.contains("forces.water.submerged: found buoyancy, but no gravity"), "{error}");
    let error = refused("current_m_s: [0.2, 0]", "current_m_s: [0.2, 0], current_profile: {power_law: {}}");
    assert!(error.contains("sea.current_profile: found power_law, over infinite depth"), "{error}");
}
