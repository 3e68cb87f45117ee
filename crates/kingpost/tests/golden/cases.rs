//! The golden runs: the paper's scenario in every mode that changes the numbers.

use serde::{Deserialize, Serialize};
use serde_json::{Map, Value, json};

/// One run: what is set, how many steps, and the row of all channels at the end.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
pub struct Golden {
    pub name: String,
    pub overrides: Map<String, Value>,
    pub steps: usize,
    pub row: Vec<f64>,
}

/// Computes all of them.
pub fn compute() -> Vec<Golden> {
    let cases = [
        ("truth", 500, json!({"crane_x_m": 0, "crane_y_m": 0})),
        ("page", 2000, json!({"load": true, "torque_history": "pulse"})),
        ("both_motors_damped", 1000, json!({"motor_2": true, "damping": true, "crane_x_m": 0, "crane_y_m": 0})),
        ("free_with_gravity", 500, json!({"hold_centre": false, "gravity": true, "load": true, "motor_2": true})),
        ("forward_euler", 1000, json!({"simulation.integrator": "forward_euler", "crane_z_m": 2.5})),
        ("midpoint_euler", 1000, json!({"simulation.integrator": "midpoint_euler", "motor_2": true})),
        ("cut_steps", 300, json!({"torque_history": "pulse", "simulation.step_s": 0.007, "load": true})),
    ];
    cases.into_iter().map(|(name, steps, overrides)| run(name, steps, overrides)).collect()
}

fn run(name: &str, steps: usize, overrides: Value) -> Golden {
    let text = include_str!("../../../../scenarios/paper.yaml");
    let overrides = overrides.as_object().cloned().unwrap_or_default();
    let list: Vec<(String, Value)> = overrides.iter().map(|(k, v)| (k.clone(), v.clone())).collect();
    let scenario = kingpost::scenario::read(text, "paper.yaml", &list).expect("the gallery reads");
    let mut simulation = kingpost::Simulation::new(scenario.setup().expect("the gallery builds"));
    simulation.step(steps).expect("a golden run does not diverge");
    let mut row = Vec::new();
    simulation.write_row(&mut row);
    Golden { name: name.to_owned(), overrides, steps, row }
}
