//! Warnings of ropes whose `carries` is not the load that hangs on them.

use crate::common;

use common::{simulation, values};
use kingpost::scenario::read;

const GRAVITY: f64 = 9.80665;
const STIFFNESS: f64 = 2e7;

/// A load of 6 t and a block of 2 t, 20 m below the world on this number of falls of a rope that carries `on_rope` of
/// their weight, and more forces.
fn hoist(falls: u32, carries: &str, on_rope: f64, more: &str) -> String {
    let tension = 8000.0 * GRAVITY * on_rope / f64::from(falls);
    let length = 20.0 * f64::from(falls) / (1.0 + tension / STIFFNESS);
    format!(
        "version: 1
title: A load on falls
simulation: {{step_s: 0.002, duration_s: 2}}
bodies:
  block: {{mass_t: 2, shape: {{sphere: {{radius_m: 0.5}}}}, joint: {{floating: {{initial: {{position_m: [0, 0, -20]}}}}}}}}
  load: {{parent: block, mass_t: 6, shape: {{sphere: {{radius_m: 0.5}}}}, joint: {{fixed: {{}}}}}}
forces:
  gravity: {{gravity: {{acceleration_m_s2: {GRAVITY}}}}}
  hoist:
    rope:
      path: [{{point: {{body: world}}}}, {{point: {{body: block, falls: {falls}}}}}]
      unstretched_length_m: {length}
      axial_stiffness_N: {STIFFNESS}
      carries: {carries}
{more}"
    )
}

fn warnings(text: &str) -> Vec<String> {
    read(text, "hoist.yaml", &[]).unwrap_or_else(|error| panic!("{error}")).describe().expect("it builds").warnings
}

#[test]
fn a_share_is_of_all_falls_together_and_rope_daf_is_one_at_rest() {
    for falls in [1, 2, 8] {
        let text = hoist(falls, "[{body: block}, {body: load, share: 1}]", 1.0, "");
        assert!((values(&mut simulation(&text), "rope_daf")[0] - 1.0).abs() < 1e-9, "{falls}");
        assert_eq!(warnings(&text), Vec::<String>::new(), "{falls}");
    }
}

/// Half of the load hangs on each of two ropes of four falls.
#[test]
fn half_a_load_on_each_of_two_ropes_gives_no_warning() {
    let half = "[{body: block, share: 0.5}, {body: load, share: 0.5}]";
    let text = hoist(4, half, 0.5, "");
    let (head, rope) = text.split_once("  hoist:\n").expect("a rope");
    let text = format!("{head}  hoist:\n{rope}  other:\n{rope}");
    assert_eq!(values(&mut simulation(&text), "rope_daf").len(), 2);
    assert_eq!(warnings(&text), Vec::<String>::new());
}

/// The share of one fall: 8 t on 8 falls then count as 1 t.
#[test]
fn the_share_of_one_fall_gives_a_warning_with_both_weights() {
    let found = warnings(&hoist(8, "[{body: block, share: 0.125}, {body: load, share: 0.125}]", 1.0, ""));
    let [warning] = found.as_slice() else { panic!("{found:?}") };
    let expected = "hoist: rope_daf is 8 with its load hanging at rest, where it should be 1 (warned of beyond 10 %): the rope \
                    pulls with 78.5 kN on 8 falls, and forces.hoist.rope.carries gives 9.81 kN;";
    assert!(warning.starts_with(expected), "{warning}");
}

#[test]
fn a_block_that_carries_leaves_out_gives_a_warning() {
    let found = warnings(&hoist(4, "[{body: load}]", 1.0, ""));
    let [warning] = found.as_slice() else { panic!("{found:?}") };
    assert!(warning.contains("rope_daf is 1.33 with its load hanging at rest"), "{warning}");
}

/// A rope with slack; a load that a floor carries by half; a load that falls.
#[test]
fn a_load_that_does_not_hang_at_rest_gives_no_warning() {
    let all = "[{body: block}, {body: load}]";
    assert_eq!(warnings(&hoist(4, all, -100.0, "")), Vec::<String>::new());
    let half = 4000.0 * GRAVITY;
    let floor = |height: f64| {
        format!(
            "  floor: {{contact: {{load: {{body: block, shape: {{sphere: {{radius_m: 0.5}}}}}}, friction_coefficient: 0, \
             stiffness_N_per_m: 1e7, surface: {{body: world, position_m: [0, 0, {height}], shape: {{plane: {{}}}}}}}}}}\n"
        )
    };
    assert_eq!(warnings(&hoist(4, all, 0.5, &floor(-20.5 + half / 1e7))), Vec::<String>::new());
    assert_eq!(warnings(&hoist(4, all, 0.5, "")), Vec::<String>::new());
}
