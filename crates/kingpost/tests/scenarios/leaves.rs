//! Every number of a scenario reaches all formulas: in a batch it can differ between runs, and a gradient is
//! its derivative. A number for which this is not possible is refused by name.

use crate::leaf_cases::{Case, gallery};

use kingpost::analysis::gradient;
use kingpost::batch::{self, Built, Members, run_built};
use kingpost::elements::{DynamicPositioning, FlowLoad, of_kind};
use kingpost::plant::Number;
use kingpost::results::Channel;
use kingpost::scenario::{Scenario, read_with};
use kingpost::simulation::{Run, Simulation};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use std::{env, fs};

fn case(name: &'static str, steps: f64) -> Case {
    let made_up = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/leaves").join(name);
    let (text, files) = match fs::read_to_string(made_up) {
        Ok(text) => (text, gallery("barge.yaml").1),
        Err(_) => gallery(name),
    };
    let scenario = read_with(&text, name, &[], &files).expect("the scenario reads");
    let step = scenario.simulation.step_s.get();
    let mut short = vec![("simulation.duration_s".to_owned(), json!(steps * step))];
    short.push(("simulation.record_every_s".to_owned(), json!(steps * step)));
    // An equilibrium is found to 1e-8, too coarse for these differences: tests/sea/water.rs holds its derivatives.
    short.push(("simulation.begin_at_equilibrium".to_owned(), json!(false)));
    for (sea, waves) in scenario.sea.iter().flat_map(|sea| &sea.waves) {
        if ["jonswap", "pierson_moskowitz"].contains(&waves.kind()) {
            short.push((format!("sea.waves.{sea}.{}.realisation.components", waves.kind()), json!(3)));
        }
    }
    // The resolved scenario is the text: every number stands in it, and no parameter has a default.
    let text = read_with(&text, name, &short, &files).expect("the scenario reads").to_json();
    Case { name, text, files }
}

/// The numbers of a scenario: paths, values, and whether they are whole.
fn leaves(value: &Value, path: &str, into: &mut Vec<(String, f64, bool)>) {
    let below = |name: &str| if path.is_empty() { name.to_owned() } else { format!("{path}.{name}") };
    match value {
        Value::Number(number) => into.push((path.to_owned(), number.as_f64().unwrap_or_default(), !number.is_f64())),
        Value::Array(entries) => {
            entries.iter().enumerate().for_each(|(i, entry)| leaves(entry, &below(&i.to_string()), into));
        }
        Value::Object(fields) => fields.iter().for_each(|(name, field)| leaves(field, &below(name), into)),
        _ => {}
    }
}

/// By default every eighth number represents its kind; each requires five models to be built.
fn stride() -> usize {
    if env::var("KINGPOST_LANE").as_deref() == Ok("thorough") { 1 } else { 8 }
}

/// Change of a number: derivatives are compared at this step and at twice this step.
fn step_of(value: f64, whole: bool) -> f64 {
    if whole { 1.0 } else { 1e-4 * value.abs().max(0.1) }
}

impl Case {
    fn with(&self, path: &str, value: f64, whole: bool) -> batch::Variant {
        let value = if whole { json!(value as i64) } else { json!(value) };
        vec![(path.to_owned(), value)]
    }

    /// Rounding of a few steps, of a run's numbers; what is found by iteration, an implicit step, is found to within a hundred
    /// times as much; of a closed loop and of a stiff cylinder, whose force is the rounding of its length times its stiffness,
    /// a thousand times. So are weights that solve equations of the condition 1e7.
    fn noise(&self) -> f64 {
        let implicit = ["\"newmark\",", "\"generalized_alpha\",", "\"implicit_midpoint\","];
        match ["\"loops\"", "\"cylinder\"", "\"prediction\""].iter().any(|part| self.text.contains(part)) {
            true => 1e-9,
            false if implicit.iter().any(|part| self.text.contains(part)) => 1e-10,
            false => 1e-12,
        }
    }

    /// Variants, read and built, and their runs together.
    fn together(&self, variants: &[batch::Variant]) -> Result<(Members, batch::Batch), batch::BatchError> {
        let members = Members::new(&self.text, self.name, &self.files, variants)?;
        let batch = run_built(&members, 1, |_| true)?;
        Ok((members, batch))
    }
}

fn bits(run: &Run) -> Vec<u64> {
    run.rows.iter().map(|x| x.to_bits()).collect()
}

/// The last row.
fn end(run: &Run) -> &[f64] {
    &run.rows[run.rows.len() - run.columns..]
}

/// One leaf: its runs with the number moved by -2, -1, 1 and 2 steps.
struct Moved {
    path: String,
    step: f64,
    runs: Vec<Run>,
}

/// The leaves whose moved values are all allowed; the others are refused in words about a field. One run of each batch is also
/// made alone, in each lane in turn.
fn moved(case: &Case, [start, every]: [usize; 2], failures: &mut Vec<String>) -> Vec<Moved> {
    let whole: Value = serde_json::from_str(&case.text).expect("the resolved scenario is JSON");
    let mut found = Vec::new();
    for name in ["simulation", "bodies", "loops", "sea", "wind", "forces", "drives", "sensors", "controllers"] {
        leaves(&whole[name], name, &mut found);
    }
    let mut all = Vec::new();
    for (number, (path, value, is_whole)) in found.into_iter().skip(start).step_by(every).enumerate() {
        let step = step_of(value, is_whole);
        let moves = if is_whole { [1.0, 2.0, 3.0, 4.0] } else { [-2.0, -1.0, 1.0, 2.0] };
        let variants = moves.map(|k| case.with(&path, value + k * step, is_whole));
        let (members, runs) = match case.together(&variants) {
            Ok((members, batch)) => (members, batch.runs),
            Err(error) if error.to_string().contains("allowed: ") => continue,
            Err(error) => {
                failures.push(format!("{}: {path}: {error}", case.name));
                continue;
            }
        };
        let lane = number % runs.len();
        let (together, alone) = (&runs[lane], members.simulation(lane).run(|_| true));
        if bits(together) != bits(&alone) || together.status != alone.status {
            failures.push(format!("{}: {path}: another run in a batch", case.name));
        }
        all.push(Moved { path, step, runs });
    }
    all
}

/// Fields that determine the structure of a run: no derivative exists.
const STRUCTURE: [&str; 49] = [
    "simulation.",
    ".pulse.",
    ".travel.start_s",
    ".travel.duration_s",
    ".list.time_s",
    ".realisation.",
    ".peak_period_s",
    ".gamma",
    ".ramp_s",
    ".start_gap_m",
    ".directions_rad.",
    ".slow_motion_cutoff_rad_s",
    ".segments",
    ".torsethaugen.",
    ".ochi_hubble.",
    ".spectrum.rows.",
    ".spectrum.direction_rad",
    ".record.",
    ".regular.period_s",
    ".regular.direction_rad",
    ".regular.phase_rad",
    ".jonswap.direction_rad",
    ".pierson_moskowitz.direction_rad",
    ".acceleration_m_s2",
    ".motion_reference_unit.period_s",
    ".inertial_unit.period_s",
    ".inertial_unit.filter.",
    ".swing_estimator.period_s",
    ".swing_estimator.filter.",
    ".state_feedback.period_s",
    ".policy.period_s",
    ".drive_function.time_s",
    ".drive_function.period_s",
    "encoder.period_s",
    ".load_cell.period_s",
    ".satellite_receiver.period_s",
    ".heave_compensation.period_s",
    ".three_axis_compensation.period_s",
    ".platform_compensation.period_s",
    ".prediction.",
    ".delay_samples",
    ".gusts.components",
    ".gusts.lowest_Hz",
    ".gusts.highest_Hz",
    ".table.depths_m.",
    ".load_chart.radii_m.",
    ".growth.shares.",
    ".growth.depths_m.",
    "sea.depth_m",
];

/// Checks gradients with respect to leaves; the error of a structural leaf without a gradient contains its
/// name.
fn check_gradients(case: &Case, leaves: &[Moved], failures: &mut Vec<String>) {
    let scenario = read_with(&case.text, case.name, &[], &case.files).expect("the scenario reads");
    let decides = |leaf: &&Moved| STRUCTURE.iter().any(|part| leaf.path.contains(part));
    let (structural, continuous): (Vec<&Moved>, Vec<&Moved>) = leaves.iter().partition(decides);
    let refused = |leaf: &&Moved| {
        gradient(&scenario, &[&leaf.path], |_| true).is_err_and(|error| error.to_string().starts_with(&leaf.path))
    };
    for leaf in structural.into_iter().filter(|leaf| !refused(leaf)) {
        // A number that decides nothing here may have its derivative.
        check_derivatives(case, &scenario, &[leaf], failures);
    }
    if !continuous.is_empty() {
        check_derivatives(case, &scenario, &continuous, failures);
    }
}

fn check_derivatives(case: &Case, scenario: &Scenario, leaves: &[&Moved], failures: &mut Vec<String>) {
    let names: Vec<&str> = leaves.iter().map(|leaf| leaf.path.as_str()).collect();
    match gradient(scenario, &names, |_| true) {
        Ok(found) => {
            for (leaf, derivatives) in leaves.iter().zip(&found.derivatives) {
                let exact = &derivatives[derivatives.len() - found.columns..];
                let off = difference(leaf, &found.channels, exact, case.noise());
                failures.extend(off.map(|off| format!("{}: {}: {off}", case.name, leaf.path)));
            }
        }
        Err(error) => failures.push(format!("{}: no gradient: {error}", case.name)),
    }
}

/// The first entry in which derivatives are not what differences say. Those err by a third of what the step of twice the size
/// differs by, and by rounding over the step: of the channel's largest number, or of the run's, whose parts a small number of
/// the channel may be the difference of. Derivatives round by their largest in each of a dozen sums: a free joint's reaction
/// is zero, as the difference of forces that are not.
fn difference(leaf: &Moved, channels: &[Channel], exact: &[f64], noise: f64) -> Option<String> {
    let rows: Vec<&[f64]> = leaf.runs.iter().map(end).collect();
    let by = |k: usize, column: usize| (rows[3 - k][column] - rows[k][column]) / (2.0 * leaf.step * (2 - k) as f64);
    let steepest = exact.iter().fold(0.0_f64, |steepest, x| steepest.max(x.abs()));
    let largest = rows[1].iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
    // The ledger's errors, and what is left open of loops, are themselves of the size of rounding.
    let told = |channel: &&Channel| !channel.variable.ends_with("_error") || channel.variable == "station_error";
    for Channel { variable, offset, len, .. } in channels.iter().filter(told) {
        let columns = *offset..offset + len;
        // The force along a joint is a component of its reaction.
        let whole = if *variable == "joint_force" { "joint_reaction" } else { variable };
        let whole = channels
            .iter()
            .find(|channel| channel.variable == whole)
            .map_or(columns.clone(), |c| c.offset..c.offset + c.len);
        let size = whole.fold(0.0_f64, |size, column| size.max(rows[1][column].abs()));
        for column in columns {
            let (fine, coarse) = (by(1, column), by(0, column));
            let rounding = noise * (size + 1e-4 * largest.min(1e4 * size.max(1.0))) / leaf.step;
            let allowed = (fine - coarse).abs() + 1e-7 * fine.abs() + rounding + 16.0 * f64::EPSILON * steepest;
            let off = (exact[column] - fine).abs();
            // The length of a thrust that begins at 0 has a kink there; an angle, or a quaternion's sign, jumps at half a turn.
            let [left, right] = [0, 2].map(|k| (rows[k + 1][column] - rows[k][column]) / leaf.step);
            let kink = (right - left).abs() > 0.5 * (right.abs() + left.abs());
            let jump = (fine - 2.0 * coarse).abs() < 1e-2 * fine.abs();
            if kink || jump {
                continue;
            }
            if off.is_nan() || off > allowed {
                let (exact, column) = (exact[column], column - offset);
                return Some(format!("{variable}[{column}]: {exact:e}, by differences {fine:e} +- {allowed:e}"));
            }
        }
    }
    None
}

fn check(names: &[&'static str], steps: f64) {
    let mut failures = Vec::new();
    for (number, name) in names.iter().enumerate() {
        let case = case(name, steps);
        // Three of the gallery are one ship: each takes a third of its numbers.
        let share = if name.starts_with("offshore_vessel") { [number, names.len()] } else { [0, stride()] };
        let leaves = moved(&case, share, &mut failures);
        assert!(!leaves.is_empty(), "{name}: no number may be moved");
        check_gradients(&case, &leaves, &mut failures);
    }
    assert!(failures.is_empty(), "{} failures:\n{}", failures.len(), failures.join("\n"));
}

#[test]
fn every_number_of_every_element_can_differ_between_runs_and_has_its_derivative() {
    check(&["every_element.yaml"], 3.0);
}

#[test]
fn every_number_of_winds_and_currents_can_differ_between_runs_and_has_its_derivative() {
    check(&["wind_and_current.yaml"], 3.0);
}

#[test]
fn every_number_in_the_splash_zone_can_differ_between_runs_and_has_its_derivative() {
    check(&["splash_zone.yaml"], 3.0);
}

#[test]
fn every_number_of_controllers_can_differ_between_runs_and_has_its_derivative() {
    check(&["controllers.yaml"], 4.0);
}

#[test]
fn every_number_of_motion_control_can_differ_between_runs_and_has_its_derivative() {
    check(&["motion_control.yaml"], 3.0);
}

#[test]
fn every_number_of_contacts_can_differ_between_runs_and_has_its_derivative() {
    check(&["contact.yaml"], 3.0);
}

#[test]
fn every_number_of_closed_loops_can_differ_between_runs_and_has_its_derivative() {
    check(&["closed_loop.yaml"], 3.0);
}

#[test]
#[ignore = "thorough"]
fn every_number_of_the_gallerys_closed_loops_can_differ_between_runs_and_has_its_derivative() {
    check(&["dual_draglink_crane.yaml", "knuckle_boom_crane.yaml"], 3.0);
}

#[test]
#[ignore = "thorough"]
fn every_number_on_land_can_differ_between_runs_and_has_its_derivative() {
    check(&["paper.yaml", "paper_true_draught.yaml", "tennis_racket.yaml", "chain.yaml", "flexible_boom.yaml"], 3.0);
}

#[test]
#[ignore = "thorough"]
fn every_number_at_sea_can_differ_between_runs_and_has_its_derivative() {
    check(&["barge.yaml", "floating_hemisphere.yaml", "sphere_decay.yaml"], 2.0);
}

#[test]
#[ignore = "thorough"]
fn every_number_of_an_offshore_vessel_can_differ_between_runs_and_has_its_derivative() {
    check(&["offshore_vessel.yaml", "offshore_vessel_moored_quasi_static.yaml", "offshore_vessel_on_dp.yaml"], 2.0);
}

/// The height of a wind can differ between runs: by the power law, a greater height gives a higher speed.
#[test]
fn a_batch_over_the_height_of_a_wind_load_has_four_winds() {
    let case = case("offshore_vessel_on_dp.yaml", 8.0);
    let heights = [10.0, 30.0, 60.0, 120.0];
    let variants = heights.map(|height| case.with("forces.wind_on_hull.wind_load.height_m", height, false));
    let (members, batch) = case.together(&variants).expect("each variant builds");
    let simulation = Simulation::new(read_with(&case.text, case.name, &[], &case.files).unwrap().setup().unwrap());
    let force =
        simulation.channels().iter().find(|channel| channel.variable == "flow_force").expect("a wind load").offset;
    let forces: Vec<f64> = batch.runs.iter().map(|run| run.rows[force]).collect();
    for (k, (run, (height, found))) in batch.runs.iter().zip(heights.iter().zip(&forces)).enumerate() {
        assert!(bits(run) == bits(&members.simulation(k).run(|_| true)), "height {height} m");
        // The ship begins at rest, at an angle that hardly depends on the wind.
        let expected = forces[0] * libm::pow(height / 10.0, 2.0 / 7.0);
        assert!((found / expected - 1.0).abs() < 0.05, "height {height} m: {found} N, by the power law {expected} N");
    }
}

/// J n^2, 2 pi / T and m (2 pi / T)^2 have the derivatives 2 J n, -2 pi / T^2 and -2 K / T.
#[test]
fn a_result_not_proportional_to_a_number_also_has_its_derivative() {
    let case = case("every_element.yaml", 2.0);
    let scenario = read_with(&case.text, case.name, &[], &case.files).expect("it reads");
    let names = [
        "bodies.tower.joint.revolute.gear_ratio",
        "forces.dp.dynamic_positioning.gains.natural_periods.surge.period_s",
        "forces.wind_on_ship.wind_load.height_m",
    ];
    let setup = scenario.setup_along(&names).expect("it builds");
    let tower = setup.model.coordinate("tower").expect("the tower turns");
    assert_eq!(setup.model.rotor_inertia[tower].derivative[0], 2.0 * 20.0 * 5.0);
    let gains = of_kind::<_, DynamicPositioning<Number>>(&setup.elements).next().expect("it is there").gains;
    let stiffness = gains.stiffness[0];
    assert!((stiffness.derivative[1] / (-2.0 * stiffness.value / 200.0) - 1.0).abs() < 1e-14, "{stiffness:?}");
    let damping = gains.damping[0];
    assert!((damping.derivative[1] / (-damping.value / 200.0) - 1.0).abs() < 1e-14, "{damping:?}");
    // U ln(z / z0) / ln(10 / z0) along z.
    let wind = of_kind::<_, FlowLoad<Number>>(&setup.elements).next().expect("a wind");
    let flow = wind.flow.in_world(&setup.world).0[0];
    let expected = flow.value / (14.0 * libm::log(14.0 / 0.003));
    assert!((flow.derivative[2] / expected - 1.0).abs() < 1e-13, "{flow:?}");
}

fn files_below(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path());
    entries.flat_map(|path| if path.is_dir() { files_below(&path) } else { vec![path] }).collect()
}

/// Builders use the whole number: none uses only its first lane, or its value without its derivatives.
#[test]
fn no_builder_uses_only_the_first_of_several_numbers() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let of_rooms = files_below(&source.join("elements"));
    let of_rooms = of_rooms.into_iter().filter(|file| file.to_string_lossy().contains("/assembly"));
    let files: Vec<PathBuf> = files_below(&source.join("scenario/assembly")).into_iter().chain(of_rooms).collect();
    assert!(files.len() > 40, "{files:?}");
    for file in files {
        let code = fs::read_to_string(&file).expect("it reads");
        for escape in [".value()", ".values()", ".to_array()", ".value,", ".shared()"] {
            let found = code.lines().find(|line| {
                let of_a_map = [
                    "bodies.values()",
                    "forces.values()",
                    "thrusters.values()",
                    "waves.values()",
                    "wires.values()",
                    "controllers.values()",
                ];
                line.contains(escape) && !of_a_map.iter().any(|map| line.contains(map))
            });
            assert!(found.is_none(), "{}: {found:?}", file.display());
        }
    }
}
