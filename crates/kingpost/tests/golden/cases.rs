//! The golden runs: gallery scenarios in every mode that changes the numbers.

use kingpost::scenario::Files;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value, json};
use std::collections::HashMap;

/// A golden run: its settings, number of steps, and the row of all channels at the end.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
pub struct Golden {
    pub name: String,
    pub overrides: Map<String, Value>,
    pub steps: usize,
    pub row: Vec<f64>,
}

/// A scenario with the files that it names.
struct Source {
    text: &'static str,
    files: &'static [(&'static str, &'static str)],
}

const PAPER: Source = Source { text: include_str!("../../../../scenarios/paper.yaml"), files: &[] };
const BARGE: Source = Source {
    text: include_str!("../../../../scenarios/barge.yaml"),
    files: &[
        ("gallery:parts/barge_hull.yaml", include_str!("../../../../scenarios/parts/barge_hull.yaml")),
        ("gallery:parts/paper_crane.yaml", include_str!("../../../../scenarios/parts/paper_crane.yaml")),
        ("gallery:hydro/barge.hydro.json", include_str!("../../../../scenarios/hydro/barge.hydro.json")),
    ],
};
const LIFT: Source =
    Source { text: include_str!("../../../../scenarios/lift_off_from_barge.yaml"), files: OFFSHORE_AND_BARGE };
const LOWERING: Source =
    Source { text: include_str!("../../../../scenarios/lowering_by_winch.yaml"), files: OFFSHORE_AND_BARGE };
const OFFSHORE_AND_BARGE: &[(&str, &str)] = &[
    ("gallery:parts/offshore_hull.yaml", include_str!("../../../../scenarios/parts/offshore_hull.yaml")),
    ("gallery:parts/pedestal_crane.yaml", include_str!("../../../../scenarios/parts/pedestal_crane.yaml")),
    ("gallery:parts/barge_hull.yaml", include_str!("../../../../scenarios/parts/barge_hull.yaml")),
    (
        "gallery:hydro/offshore_vessel.hydro.json",
        include_str!("../../../../scenarios/hydro/offshore_vessel.hydro.json"),
    ),
    ("gallery:hydro/barge.hydro.json", include_str!("../../../../scenarios/hydro/barge.hydro.json")),
];

/// Computes all of them, by scenario.
pub fn compute() -> [(&'static str, Vec<Golden>); 4] {
    let paper = [
        ("truth", 500, json!({"crane_x_m": 0, "crane_y_m": 0})),
        ("page", 2000, json!({"load": true, "torque_history": "pulse"})),
        ("both_motors_damped", 1000, json!({"motor_2": true, "damping": true, "crane_x_m": 0, "crane_y_m": 0})),
        ("free_with_gravity", 500, json!({"hold_centre": false, "gravity": true, "load": true, "motor_2": true})),
        ("forward_euler", 1000, json!({"simulation.integrator": "forward_euler", "crane_z_m": 2.5})),
        ("midpoint_euler", 1000, json!({"simulation.integrator": "midpoint_euler", "motor_2": true})),
        ("cut_steps", 300, json!({"torque_history": "pulse", "simulation.step_s": 0.007, "load": true})),
    ];
    // The sea at its height from the start; the crane slews and the load swings.
    let barge = [
        ("calm_water", 250, json!({})),
        ("sea", 250, json!({"waves": true, "sea.ramp_s": 0})),
        (
            "sea_on_the_mesh",
            100,
            json!({"waves": true, "sea.ramp_s": 0, "hydrostatics": "mesh", "wave_direction_deg": 130}),
        ),
    ];
    // The rope becomes taut at 3.8 s, the load slides and leaves the deck, and the step ends at its height.
    let until_off = json!({
        "sea.ramp_s": 0,
        "operation.steps.0.until.after_s": 0.5,
        "operation.steps.1.set.0.to": -24,
        "operation.steps.1.set.0.in_s": 5,
        "operation.steps.1.until.value.above": 4.56,
    });
    // A fastening holds the load on the deck, is cut, and engages again where the load then is.
    let fastening = json!({
        "first": {"body": "barge_ship", "position_m": [0, 0, 2.5]},
        "second": {"body": "lift", "position_m": [0, 0, -1.25]},
        "constraints": ["x", "y", "z", "roll", "pitch", "yaw"],
        "connection": {"engages": "where_it_is"},
    });
    let cut = json!({
        "sea.ramp_s": 0,
        "loops": {"fastening": fastening},
        "operation.steps": [
            {"name": "held", "until": {"after_s": 0.5}},
            {"name": "cut", "set": [{"input": "fastening", "to": 1}], "until": {"after_s": 1}},
            {"name": "held again", "set": [{"input": "fastening", "to": 0}]},
        ],
    });
    let lift = [("timeline_until_the_load_is_off", 500, until_off), ("fastening_cut_and_engaged", 200, cut)];
    // The inputs of the user form an operation of one step.
    let by_hand = [("hoist", -10.0, 1.0), ("hoist", 3.3, 4.05), ("hoist", 0.0, 7.0)];
    let set = by_hand.map(|(input, to, at_s)| json!({"input": input, "to": to, "at_s": at_s}));
    let operation = json!({"steps": [{"name": "by hand", "set": set}]});
    let lowering = [("by_hand", 200, json!({"waves": true, "sea.ramp_s": 0, "operation": operation}))];
    [
        ("paper", runs(&PAPER, paper)),
        ("barge", runs(&BARGE, barge)),
        ("lift_off_from_barge", runs(&LIFT, lift)),
        ("lowering_by_winch", runs(&LOWERING, lowering)),
    ]
}

fn runs<const N: usize>(source: &Source, cases: [(&str, usize, Value); N]) -> Vec<Golden> {
    cases.into_iter().map(|(name, steps, overrides)| run(source, name, steps, overrides)).collect()
}

fn run(source: &Source, name: &str, steps: usize, overrides: Value) -> Golden {
    let overrides = overrides.as_object().cloned().unwrap_or_default();
    let list: Vec<(String, Value)> = overrides.iter().map(|(k, v)| (k.clone(), v.clone())).collect();
    let files: HashMap<String, String> =
        source.files.iter().map(|(name, text)| ((*name).to_owned(), (*text).to_owned())).collect();
    let scenario = kingpost::scenario::read_with(source.text, "gallery.yaml", &list, &Files::new(files))
        .expect("the gallery reads");
    let mut simulation = kingpost::Simulation::new(scenario.setup().expect("the gallery builds"));
    simulation.step(steps).expect("a golden run does not diverge");
    let mut row = Vec::new();
    simulation.write_row(&mut row);
    Golden { name: name.to_owned(), overrides, steps, row }
}
