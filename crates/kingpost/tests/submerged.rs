//! The water on a lifted object, against formulas by hand: Archimedes, Morison, added mass, slamming, energy.

mod common;

use common::{simulation, values};
use kingpost::analysis::Linearizer;
use kingpost::scenario::read;
use kingpost::simulation::Simulation;
use std::f64::consts::PI;

const GRAVITY: f64 = 9.80665;
const DENSITY: f64 = 1025.0;

/// A load that slides along the vertical as it is told, through the sea; the joint's axes are the load's.
fn lowered(joint: &str, sea: &str, submerged: &str, simulation: &str) -> String {
    format!(
        "version: 1
title: A load through the surface
simulation: {{{simulation}}}
sea: {{{sea}}}
bodies:
  load:
    mass_kg: 20000
    shape: {{point: {{}}}}
    joint: {{prismatic: {{name: lift, {joint}}}}}
forces:
  gravity: {{gravity: {{}}}}
  water: {{submerged: {{body: load, {submerged}}}}}
"
    )
}

/// At a height, turned so and at rest.
fn held(height: f64, angles: [f64; 3], shape: &str) -> Simulation {
    // The axis is in the load's axes: upward, as any that does not move.
    let joint = format!("axis: [0, 0, 1], position_m: [0.3, -0.2, {height}], orientation_rad: {angles:?}, mode: held");
    simulation(&lowered(&joint, "", &format!("shape: {shape}"), "step_s: 0.01, duration_s: 1"))
}

/// Buoyancy over rho g is a volume.
fn volume(load: &mut Simulation) -> f64 {
    let force = values(load, "submerged_buoyancy");
    assert!(force[0].abs() + force[1].abs() < 1e-9 * (1.0 + force[2]), "{force:?}");
    force[2] / (DENSITY * GRAVITY)
}

const BOX: &str = "{box: {length_m: 4, width_m: 3, height_m: 2}}";

#[test]
fn a_box_displaces_what_archimedes_says_at_every_cut_and_rights_as_a_wall_sided_body() {
    for height in [1.2_f64, 0.7, 0.0, -0.4, -0.999, -1.3] {
        let exact = 12.0 * (1.0 - height).clamp(0.0, 2.0);
        let found = volume(&mut held(height, [0.0; 3], BOX));
        assert!((found - exact).abs() < 1e-9, "{height}: {found} {exact}");
    }
    for (heel, height) in [(0.1_f64, 0.3), (-0.25, -0.2), (0.3, 0.05)] {
        let mut load = held(height, [heel, 0.0, 0.0], BOX);
        let (level, tan) = (-height / heel.cos(), heel.tan());
        let exact = 12.0 * (1.0 + level);
        assert!((volume(&mut load) - exact).abs() < 1e-9);
        // Of the wedges, and of the level above the middle: I = L B^3 / 12 (Barrass & Derrett, on wall-sided ships).
        let inertia = 4.0 * 27.0 / 12.0;
        let (across, upward) = (-inertia * tan, 12.0 * (level * level - 1.0) / 2.0 + inertia * tan * tan / 2.0);
        let moment = DENSITY * GRAVITY * (across * heel.cos() - upward * heel.sin());
        let found = values(&mut load, "submerged_force")[3];
        assert!((found - moment).abs() < 1e-6 * moment.abs(), "{heel}: {found} {moment}");
    }
}

#[test]
fn a_sphere_and_cylinders_displace_their_caps_and_segments() {
    let radius = 1.5_f64;
    for height in [1.4, 0.6, 0.0, -0.9, -2.0] {
        let cap = (radius - height).clamp(0.0, 2.0 * radius);
        let exact = PI * cap * cap * (3.0 * radius - cap) / 3.0;
        let found = volume(&mut held(height, [0.4, 0.3, 0.2], "{sphere: {radius_m: 1.5}}"));
        assert!((found - exact).abs() < 1e-9, "{height}: {found} {exact}");
        let upright = PI * radius * radius * (2.0 - height).clamp(0.0, 4.0);
        let found = volume(&mut held(height, [0.0; 3], "{cylinder: {radius_m: 1.5, length_m: 4}}"));
        assert!((found - upright).abs() < 1e-9);
        // Leant by theta, an end out of the water: the plane's height over the axis is -z / cos.
        let leant = PI * radius * radius * (2.0 - height / 0.2_f64.cos());
        if height.abs() < 1.0 {
            let found = volume(&mut held(height, [0.2, 0.0, 0.0], "{cylinder: {radius_m: 1.5, length_m: 4}}"));
            assert!((found - leant).abs() < 1e-9, "{height}: {found} {leant}");
        }
        let depth = (-height).clamp(-radius, radius);
        let segment = radius * radius * (-depth / radius).acos() + depth * (radius * radius - depth * depth).sqrt();
        for (axis, angles) in [("x", [0.3, 0.0, 0.4]), ("y", [0.0, 0.2, 1.0])] {
            let shape = format!("{{cylinder: {{radius_m: 1.5, length_m: 4, axis: {axis}}}}}");
            let found = volume(&mut held(height, angles, &shape));
            assert!((found - segment * 4.0).abs() < 1e-9, "{axis} {height}: {found}");
        }
    }
}

/// Lowered at a steady speed from a height.
fn lowering(shape: &str, rest: &str, sea: &str, height: f64, step: f64) -> Simulation {
    let joint = format!(
        "axis: [0, 0, 1], position_m: [0, 0, {height}], mode: {{prescribed: {{speed_m_s: -{SPEED}, history: constant}}}}"
    );
    simulation(&lowered(&joint, sea, &format!("shape: {shape}{rest}"), &format!("step_s: {step}, duration_s: 100")))
}

const SPEED: f64 = 0.5;

/// What the joint carries upward, at steady speed: weight less the water's forces.
fn hook(load: &mut Simulation) -> f64 {
    values(load, "joint_reaction")[2]
}

#[test]
fn a_box_that_is_lowered_through_still_water_has_the_forces_by_hand() {
    let rest =
        ", added_mass: {coefficients: [0, 0, 0.9]}, drag: {coefficients: [1, 1, 1.8], linear_N_s_m: [0, 0, 700]}";
    let mut load = lowering(BOX, rest, "", 1.45, 0.05);
    let weight = 20000.0 * GRAVITY;
    let added = DENSITY * 0.9 * 24.0;
    for _ in 0..14 {
        load.step(10).unwrap();
        let depth = (SPEED * load.time_s() - 0.45).clamp(0.0, 2.0);
        let share = depth / 2.0;
        let drag = share * (0.5 * DENSITY * 1.8 * 12.0 * SPEED + 700.0) * SPEED;
        let slam = if share > 0.0 && share < 1.0 { added / 2.0 * SPEED * SPEED } else { 0.0 };
        let by_hand = weight - DENSITY * GRAVITY * 12.0 * depth - drag - slam;
        let found = hook(&mut load);
        assert!((found - by_hand).abs() < 1e-8 * weight, "{depth}: {found} {by_hand}");
    }
    let events: Vec<(f64, &str)> = load.events().iter().map(|event| (event.time_s, event.what)).collect();
    assert_eq!(events.iter().map(|event| event.1).collect::<Vec<_>>(), ["meets the water", "is under water"]);
    assert!((events[0].0 - 0.9).abs() < 1e-9 && (events[1].0 - 4.9).abs() < 1e-9, "{events:?}");
}

/// The integral of the force of slamming by the midpoint rule, whose error for a chord that begins as a root is of order
/// 1.5 in the step.
fn impulse(load: &mut Simulation, step: f64, seconds: f64) -> f64 {
    let mut sum = 0.0;
    while load.time_s() < seconds {
        load.step(1).unwrap();
        sum += values(load, "submerged_slamming")[2] * step;
    }
    sum
}

#[test]
fn the_impulse_of_entry_is_the_added_mass_times_the_speed() {
    let step = 0.002;
    for (shape, axis_coefficient, volume, height) in [
        (BOX, 0.9, 24.0, 1.1),
        ("{cylinder: {radius_m: 0.8, length_m: 5}}", 0.35, PI * 3.2, 2.6),
        ("{cylinder: {radius_m: 0.8, length_m: 5, axis: y}}", 1.0, PI * 3.2, 0.9),
        ("{sphere: {radius_m: 1}}", 0.5, PI * 4.0 / 3.0, 1.1),
    ] {
        let rest = format!(", added_mass: {{coefficients: [0, 0, {axis_coefficient}]}}");
        let exact = DENSITY * axis_coefficient * volume * SPEED;
        let mut load = lowering(shape, &rest, "", height, step);
        let found = impulse(&mut load, step, 2.0 * height / SPEED + 1.0);
        assert!((found / exact - 1.0).abs() < 1e-3, "{shape}: {found} {exact}");
        // However it grows, its whole is the same.
        let grown = rest.replace("}", ", growth: {shares: [0, 0.1, 0.5, 1], factors: [0, 0.5, 0.8, 1]}}");
        let mut load = lowering(shape, &grown, "", height, step);
        let found = impulse(&mut load, step, 2.0 * height / SPEED + 1.0);
        assert!((found / exact - 1.0).abs() < 2e-3, "{shape}: {found} {exact}");
    }
}

/// A regular wave of deep water at x = 0: elevation a cos(phase - w t).
struct Wave {
    amplitude: f64,
    frequency: f64,
    number: f64,
    phase: f64,
}

impl Wave {
    fn new(height: f64, period: f64, phase: f64) -> Self {
        let frequency = 2.0 * PI / period;
        Self { amplitude: 0.5 * height, frequency, number: frequency * frequency / GRAVITY, phase }
    }

    fn sea(&self) -> String {
        let (height, period, phase) = (2.0 * self.amplitude, 2.0 * PI / self.frequency, self.phase);
        format!(
            "waves: {{one: {{regular: {{height_m: {height}, period_s: {period}, phase_rad: {phase}}}}}}}, ramp_s: 0"
        )
    }

    /// sin and cos of the phase at x = 0.
    fn angle(&self, time: f64) -> (f64, f64) {
        (self.phase - self.frequency * time).sin_cos()
    }

    /// Elevation, its slope and its rate.
    fn surface(&self, time: f64) -> [f64; 3] {
        let (sin, cos) = self.angle(time);
        [self.amplitude * cos, -self.amplitude * self.number * sin, self.amplitude * self.frequency * sin]
    }

    /// Velocity along x and z, acceleration along x and z, at z by Wheeler's stretching.
    fn water(&self, time: f64, z: f64) -> [f64; 4] {
        let ((sin, cos), elevation) = (self.angle(time), self.surface(time)[0]);
        let speed = self.amplitude * self.frequency * (self.number * (z - elevation)).exp();
        [speed * cos, speed * sin, speed * self.frequency * sin, -speed * self.frequency * cos]
    }
}

#[test]
fn a_box_that_is_lowered_through_a_regular_wave_has_the_forces_by_hand() {
    let wave = Wave::new(1.4, 7.5, 0.8);
    let (ca, cd) = (0.9, [1.1, 1.4, 1.8]);
    let rest = format!(", added_mass: {{coefficients: [0.6, 0.5, {ca}]}}, drag: {{coefficients: {cd:?}}}");
    let mut load = lowering(BOX, &rest, &wave.sea(), 2.6, 0.05);
    let mut phases = [0; 3];
    for _ in 0..75 {
        load.step(3).unwrap();
        let (time, z) = (load.time_s(), 2.6 - SPEED * load.time_s());
        let [elevation, slope, rate] = wave.surface(time);
        let [length, width, half] = [4.0, 3.0, 1.0];
        // Wall-sided where neither bottom nor top is cut, which the slope decides.
        let (level, lean) = (elevation - z, slope.abs() * length / 2.0);
        let cut = level.abs() + lean < half;
        if !cut && level.abs() - lean < half {
            continue;
        }
        let share = ((level + half) / 2.0).clamp(0.0, 1.0);
        let volume = 24.0 * share;
        let centre = (level * level - half * half) / 2.0 + length * length / 12.0 * slope * slope / 2.0;
        let b = if cut { z + centre / (level + half) } else { z };
        let [ux, uz, ax, az] = wave.water(time, b);
        let past = [ux, uz + SPEED];
        let size = past[0].hypot(past[1]);
        let drag = |k: usize, area: f64, cd: f64| 0.5 * DENSITY * cd * area * share * size * past[k];
        let growth = if cut { (0.5 * (rate + SPEED)).max(0.0) } else { 0.0 };
        let slam = DENSITY * 24.0 * growth * ca * past[1];
        let by_hand = [
            DENSITY * volume * (1.0 + 0.6) * ax + drag(0, width * 2.0, cd[0]) + DENSITY * 24.0 * growth * 0.6 * past[0],
            DENSITY * volume * (GRAVITY + az + ca * az) + drag(1, length * width, cd[2]) + slam,
        ];
        let reaction = values(&mut load, "joint_reaction");
        let found = [-reaction[0], 20000.0 * GRAVITY - reaction[2]];
        let scale = DENSITY * GRAVITY * 24.0;
        for k in 0..2 {
            assert!((found[k] - by_hand[k]).abs() < 1e-9 * scale, "{time}: {found:?} {by_hand:?}");
        }
        phases[if level < 0.0 && !cut { 0 } else { 1 + usize::from(!cut) }] += 1;
    }
    assert!(phases.iter().all(|count| *count > 5), "{phases:?}");
}

#[test]
fn a_lying_cylinder_in_a_regular_wave_is_slammed_by_the_rate_of_its_segment() {
    // Along the crests: the slope is square to its axis, and a circle's segment does not know it.
    let wave = Wave::new(1.2, 6.0, -0.4);
    let rest = ", added_mass: {coefficients: [1, 0, 1]}, drag: {coefficients: [0.7, 0, 0.7]}";
    let mut load = lowering("{cylinder: {radius_m: 0.8, length_m: 5, axis: y}}", rest, &wave.sea(), 1.2, 0.05);
    let (radius, length, mut seen) = (0.8_f64, 5.0, 0);
    for _ in 0..60 {
        load.step(2).unwrap();
        let (time, z) = (load.time_s(), 1.2 - SPEED * load.time_s());
        let [elevation, slope, rate] = wave.surface(time);
        let norm = (1.0 + slope * slope).sqrt();
        let level = (elevation - z) / norm;
        if level.abs() >= radius {
            continue;
        }
        seen += 1;
        let chord = 2.0 * (radius * radius - level * level).sqrt();
        let segment = radius * radius * (-level / radius).acos() + level * chord / 2.0;
        // Down the normal of the surface: the first moment over the area.
        let down = chord.powi(3) / 12.0 / segment;
        let [ux, uz, ax, az] = wave.water(time, z - down / norm);
        let slope_rate = wave.amplitude * wave.frequency * wave.number * wave.angle(time).1;
        let level_rate = (rate + SPEED) / norm - level * slope * slope_rate / (norm * norm);
        let growth = (chord * level_rate).max(0.0) * length;
        let past = [ux, uz + SPEED];
        let share = segment / (PI * radius * radius);
        let drag = 0.5 * DENSITY * 0.7 * 2.0 * radius * length * share * past[0].hypot(past[1]);
        let mass = DENSITY * segment * length;
        let by_hand = [
            2.0 * mass * ax + (drag + DENSITY * growth) * past[0],
            mass * (GRAVITY + 2.0 * az) + (drag + DENSITY * growth) * past[1],
        ];
        let reaction = values(&mut load, "joint_reaction");
        let found = [-reaction[0], 20000.0 * GRAVITY - reaction[2]];
        for k in 0..2 {
            assert!((found[k] - by_hand[k]).abs() < 1e-6 * DENSITY * GRAVITY * 10.0, "{time}: {found:?} {by_hand:?}");
        }
    }
    assert!(seen > 10, "{seen}");
}

#[test]
fn what_sinks_ends_at_its_terminal_speed() {
    let text = lowered(
        "axis: [0, 0, 1], position_m: [0, 0, -10]",
        "",
        "shape: {sphere: {radius_m: 1}}, added_mass: {coefficients: [0.5, 0.5, 0.5]}, drag: {coefficients: [0.5, 0.5, 0.5]}",
        "step_s: 0.05, duration_s: 60",
    );
    let mut load = simulation(&text);
    load.step(1200).unwrap();
    let weight = 20000.0 - DENSITY * PI * 4.0 / 3.0;
    let exact = (2.0 * weight * GRAVITY / (DENSITY * 0.5 * PI)).sqrt();
    assert!((load.state().v[0] + exact).abs() < 1e-9 * exact, "{} {exact}", load.state().v[0]);
}

#[test]
fn what_floats_heaves_by_its_waterplane_and_its_added_mass() {
    let mass = 0.6 * DENSITY * 24.0;
    let text = lowered(
        "axis: [0, 0, 1]",
        &Wave::new(1.0, 8.0, 0.0).sea(),
        &format!("shape: {BOX}, added_mass: {{coefficients: [0, 0, 0.8]}}"),
        "step_s: 0.01, duration_s: 1, begin_at_equilibrium: true",
    )
    .replace("20000", &mass.to_string());
    let scenario = read(&text, "test.yaml", &[]).unwrap();
    let load = scenario.simulation().unwrap();
    // At rest there are no waves: 0.6 of it is under water.
    assert!((load.state().q[0] + 0.2).abs() < 1e-9, "{:?}", load.state().q);
    let linear = Linearizer::new(&scenario).unwrap().at_rest().at(&load);
    let exact = -DENSITY * GRAVITY * 12.0 / (mass + DENSITY * 0.6 * 0.8 * 24.0);
    let found = linear.stiffness()[(0, 0)];
    assert!((found / exact - 1.0).abs() < 1e-7, "{found} {exact}");
}

#[test]
fn a_deep_body_as_heavy_as_water_goes_round_with_it() {
    let (wave, radius, depth) = (Wave::new(0.1, 8.0, 0.0), 0.5_f64, 6.0);
    let decay = (-wave.number * depth).exp();
    let (orbit, mass) = (wave.amplitude * decay, DENSITY * PI * 4.0 / 3.0 * radius.powi(3));
    let [ux, uz, ..] = wave.water(0.0, -depth + wave.amplitude);
    let text = format!(
        "version: 1
title: A body in a deep orbit
simulation: {{step_s: 0.02, duration_s: 8}}
sea: {{{}}}
bodies:
  load:
    mass_kg: {mass}
    shape: {{sphere: {{radius_m: 0.5}}}}
    joint: {{floating: {{initial: {{position_m: [0, 0, {}], velocity_m_s: [{ux}, 0, {uz}]}}}}}}
forces:
  gravity: {{gravity: {{}}}}
  water: {{submerged: {{body: load, shape: {{sphere: {{radius_m: 0.5}}}}, added_mass: {{coefficients: [0.5, 0.5, 0.5]}}}}}}
",
        wave.sea(),
        -depth + orbit
    );
    let mut load = simulation(&text);
    let mut worst: f64 = 0.0;
    for _ in 0..40 {
        load.step(10).unwrap();
        // Of the centre (0, -depth): along x -sin, along z cos of k x - w t.
        let (sin, cos) = wave.angle(load.time_s());
        let [x, _, z] = [load.state().q[0] + orbit * sin, 0.0, load.state().q[2] + depth - orbit * cos];
        worst = worst.max(x.hypot(z));
    }
    // Of second order: Stokes' drift k w r^2 t, and Wheeler's stretching, k a, of the orbit.
    let second_order = 2.0 * PI * wave.number * orbit + wave.number * wave.amplitude * 2.0 * PI;
    assert!(worst < 2.0 * second_order * orbit, "{} of {}", worst / orbit, second_order);
}

/// A body that is thrown into waves and current, turning.
fn thrown(scheme: &str, step: f64) -> String {
    format!(
        "version: 1
title: A body that is thrown into the sea
simulation: {{integrator: {scheme}, step_s: {step}, duration_s: 6,
  dormand_prince: {{absolute_tolerance: 1e-11, relative_tolerance: 1e-11, largest_step_s: 0.02}}}}
sea: {{waves: {{one: {{regular: {{height_m: 1, period_s: 6, direction_rad: 0.5}}}}, two: {{regular: {{height_m: 0.6, period_s: 4, direction_rad: 2}}}}}}, ramp_s: 3, current_m_s: [0.3, 0.2]}}
wind: {{speed_m_s: 12, direction_rad: 1}}
bodies:
  load:
    mass_kg: 20000
    centre_of_mass_m: [0.1, 0, -0.3]
    inertia: {{tensor: {{moments_kg_m2: [21000, 33000, 41000]}}}}
    joint: {{floating: {{initial: {{position_m: [0, 0, 1.9], orientation_rad: [0.2, 0.3, 0.1], velocity_m_s: [0.5, 0, -1], angular_velocity_rad_s: [0.2, 0.1, 0.3]}}}}}}
forces:
  gravity: {{gravity: {{}}}}
  water:
    submerged:
      body: load
      position_m: [0, 0, 0]
      shape: {BOX}
      added_mass: {{coefficients: [0.4, 0.6, 0.9], moments_kg_m2: [6000, 9000, 3000], growth: {{shares: [0, 0.3, 1], factors: [0, 0.6, 1]}}}}
      drag: {{coefficients: [1.1, 1.3, 1.8], linear_N_s_m: [500, 400, 300]}}
      wind: {{coefficients: [1, 1.1, 1]}}
"
    )
}

#[test]
fn energy_and_momentum_are_kept_by_work_and_heat() {
    let mut load = simulation(&thrown("dormand_prince", 0.02));
    load.step(250).unwrap();
    let scale = values(&mut load, "energy_dissipated")[0];
    let error = values(&mut load, "energy_error")[0];
    assert!(scale > 1e4 && error.abs() < 1e-7 * scale, "{error:e} of {scale:e}");
    for name in ["linear_momentum_error", "momentum_error"] {
        let error = values(&mut load, name)[0];
        assert!(error < 1e-7 * 20000.0, "{name}: {error:e}");
    }
    assert!(load.events().iter().any(|event| event.what == "meets the water"), "{:?}", load.events());
}

#[test]
fn the_water_only_takes_energy_from_what_bobs_in_it() {
    let text = lowered(
        "axis: [0, 0, 1], position_m: [0, 0, -4]",
        "",
        &format!("shape: {BOX}, added_mass: {{coefficients: [0, 0, 0.9]}}"),
        "step_s: 0.01, duration_s: 30",
    )
    .replace("20000", "4000");
    let mut load = simulation(&text);
    let mut before = f64::INFINITY;
    for _ in 0..1500 {
        load.step(1).unwrap();
        let energy = values(&mut load, "kinetic_energy")[0] + values(&mut load, "potential_energy")[0];
        let (rate, added) = (load.state().v[0], values(&mut load, "submerged_added_mass")[2]);
        let whole = energy + 0.5 * added * rate * rate;
        assert!(whole < before + 1e-5 * 4000.0, "{whole} after {before}");
        assert!(rate < 0.0 || values(&mut load, "submerged_slamming")[2] == 0.0);
        before = whole;
    }
    let count = |what: &str| load.events().iter().filter(|event| event.what == what).count();
    assert!(count("leaves the water") > 0 && count("meets the water") > 0, "{:?}", load.events());
}

#[test]
fn the_matrices_and_the_recursion_move_it_alike() {
    let run = |form: &str| {
        let text = thrown("rk4", 0.02).replace("integrator: rk4", &format!("integrator: rk4, form: {form}"));
        let mut load = simulation(&text);
        load.step(150).unwrap();
        load.state().q.clone()
    };
    let apart = common::relative_difference(&run("recursive"), &run("moving_frame"));
    assert!(apart < 1e-10, "{apart:e}");
}

#[test]
fn it_has_exact_derivatives_in_waves() {
    common::assert_linearised(&thrown("rk4", 0.01));
}

#[test]
fn the_order_of_the_scheme_is_kept_through_the_surface() {
    // A box falls flat into still water: its added mass grows at once.
    let end = |step: f64| {
        let text = lowered(
            "axis: [0, 0, 1], position_m: [0, 0, 1.237]",
            "",
            &format!("shape: {BOX}, added_mass: {{coefficients: [0, 0, 0.9]}}, drag: {{coefficients: [1, 1, 1.8]}}"),
            &format!("integrator: rk4, step_s: {step}, duration_s: 3"),
        )
        .replace("20000", "26000");
        let mut load = simulation(&text);
        load.step((2.4 / step).round() as usize).unwrap();
        (load.state().q[0], load.events().len())
    };
    let (exact, events) = end(0.0025);
    assert!(events >= 2, "{events}");
    let [coarse, fine] = [0.04, 0.02].map(|step| (end(step).0 - exact).abs());
    assert!(coarse / fine > 11.0, "{coarse:e} {fine:e}");
}

#[test]
fn perforation_takes_from_the_added_mass_what_the_formula_says() {
    for (perforation, left) in
        [(0.0, 1.0), (0.05, 1.0), (0.2, 0.7 + 0.3 * (PI * 15.0 / 34.0).cos()), (0.4, (-30.0_f64 / 28.0).exp())]
    {
        let rest = format!(", added_mass: {{coefficients: [0, 0, 0.5], perforation: {perforation}}}");
        let mut load = lowering(BOX, &rest, "", -3.0, 0.05);
        let found = values(&mut load, "submerged_added_mass")[2];
        assert!((found - DENSITY * 0.5 * 24.0 * left).abs() < 1e-9 * found, "{perforation}: {found}");
    }
}

#[test]
fn a_frame_displaces_its_own_volume_and_the_wind_finds_what_is_dry() {
    let rest = ", displaced_volume_m3: 3, wind: {coefficients: [1.2, 1, 1], areas_m2: [5, 6, 7], height_m: 10}";
    let text = lowered("axis: [0, 0, 1], mode: held", "", &format!("shape: {BOX}{rest}"), "step_s: 0.1, duration_s: 1");
    let text = text.replace("bodies:", "wind: {speed_m_s: 15, direction_rad: 0, profile: uniform}\nbodies:");
    let mut load = simulation(&text);
    let force = values(&mut load, "submerged_force");
    // Half of it is under water.
    assert!((force[2] - 1.5 * DENSITY * GRAVITY).abs() < 1e-8, "{force:?}");
    assert!((force[0] - 0.5 * 0.5 * 1.225 * 1.2 * 5.0 * 225.0).abs() < 1e-9, "{force:?}");
}

#[test]
fn a_current_carries_a_body_along_and_heats_what_slips() {
    let text = lowered(
        "axis: [1, 0, 0], position_m: [0, 0, -6]",
        "current_m_s: [0.8, 0]",
        &format!("shape: {BOX}, added_mass: {{coefficients: [0.6, 0, 0]}}, drag: {{linear_N_s_m: [900, 0, 0]}}"),
        "step_s: 0.05, duration_s: 60",
    );
    let mut load = simulation(&text);
    load.step(600).unwrap();
    // (m + A) v' = c (u - v) from rest.
    let time = (20000.0 + DENSITY * 0.6 * 24.0) / 900.0;
    let speed = 0.8 * (1.0 - (-30.0_f64 / time).exp());
    assert!((load.state().v[0] - speed).abs() < 1e-8, "{} {speed}", load.state().v[0]);
    // Heat is the integral of c (u - v)^2.
    let heat = 900.0 * 0.64 * time / 2.0 * (1.0 - (-60.0_f64 / time).exp());
    assert!((values(&mut load, "energy_dissipated")[0] / heat - 1.0).abs() < 1e-8);
}
