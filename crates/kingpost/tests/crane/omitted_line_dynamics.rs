//! Warnings of ropes and mooring lines whose inertia and drag are left out and are not small.

use crate::common::gallery_files;
use kingpost::scenario::read;
use serde_json::json;

/// A wire of this length with an anchor of 80 t in the sea, whose added mass is 200 t; a swell of 8 s.
fn on_a_wire(length_m: f64, mass_kg_per_m: f64, sea: &str) -> Vec<String> {
    let depth = 10.0 - length_m;
    let text = format!(
        "version: 1
title: An anchor on a wire
simulation: {{step_s: 0.02, duration_s: 10}}
sea: {{{sea}}}
bodies:
  anchor:
    mass_t: 80
    shape: {{box: {{length_m: 4, width_m: 4, height_m: 1}}}}
    joint: {{floating: {{initial: {{position_m: [0, 0, {depth}]}}}}}}
forces:
  gravity: {{gravity: {{}}}}
  wire:
    rope:
      path: [{{point: {{body: world, position_m: [0, 0, 10]}}}}, {{point: {{body: anchor}}}}]
      axial_stiffness_N: 8e8
      mass_kg_per_m: {mass_kg_per_m}
  water:
    submerged:
      body: anchor
      shape: {{box: {{length_m: 4, width_m: 4, height_m: 1}}}}
      added_mass: {{coefficients: [0.25, 0.25, 1], reference_volume_m3: 195.122}}
"
    );
    read(&text, "wire.yaml", &[]).expect("it reads").describe().expect("it builds").warnings
}

const SWELL: &str = "waves: {swell: {regular: {height_m: 2, period_s: 8}}}";

#[test]
fn warns_of_a_heavy_rope_with_the_size_of_its_inertia() {
    // Closed form of a bar with a mass at its end: at 1500 m the top pulls with 300 kN per metre at 8 s, without inertia
    // with 255 kN.
    let found = on_a_wire(1500.0, 30.0, SWELL);
    let expected = "wire: the rope of 45 t has 56.2 % of the mass of its load (warned of beyond 5 %), and its inertia and drag are \
        left out; with its inertia the load has a vertical natural period of 4.67 s, without 4.55 s, and at the sea's median \
        period of 8 s the dynamic tension at the top is 300 kN per metre of motion of the top, without 255 kN";
    assert_eq!(found, [expected]);
}

#[test]
fn states_no_tension_without_waves() {
    let found = on_a_wire(1500.0, 30.0, "density_kg_m3: 1025");
    assert!(found[0].ends_with("natural period of 4.67 s, without 4.55 s"), "{found:?}");
}

#[test]
fn accepts_a_light_rope() {
    // 2.6 kg/m over 1500 m are 4.9 % of 80 t.
    assert!(on_a_wire(1500.0, 2.6, SWELL).is_empty());
}

#[test]
fn warns_of_chains_that_waves_excite() {
    let of = |set: &[(&str, serde_json::Value)]| {
        gallery_files::scenario("offshore_vessel_moored_quasi_static", set).describe().expect("it builds").warnings
    };
    let found = of(&[]);
    assert_eq!(found.len(), 4, "{found:?}");
    assert!(found.iter().all(|warning| warning.contains("its inertia and drag are left out")), "{found:?}");
    assert!(of(&[("waves", json!(false))]).is_empty());
}
