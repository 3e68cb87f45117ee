//! Forces of water on a lifted object, against hand calculations: Archimedes, Morison, added mass, slamming.

use crate::common;

use common::splash::{BOX, DENSITY, GRAVITY, Wave, lowered};
use common::{simulation, values};
use kingpost::simulation::Simulation;
use std::f64::consts::PI;

/// Returns the frame at a height with this orientation, at rest.
fn held(height: f64, angles: [f64; 3], shape: &str) -> Simulation {
    // The axis is in the load's axes: upward, as any that does not move.
    let joint = format!("axis: [0, 0, 1], position_m: [0.3, -0.2, {height}], orientation_rad: {angles:?}, mode: held");
    simulation(&lowered(&joint, "", &format!("shape: {shape}"), "step_s: 0.01, duration_s: 1"))
}

/// Returns the buoyancy as a volume: divided by rho g.
fn volume(load: &mut Simulation) -> f64 {
    let force = values(load, "submerged_buoyancy");
    assert!(force[0].abs() + force[1].abs() < 1e-9 * (1.0 + force[2]), "{force:?}");
    force[2] / (DENSITY * GRAVITY)
}

#[test]
fn a_box_has_the_buoyancy_of_archimedes_at_every_cut_and_the_righting_of_a_wall_sided_body() {
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

/// An object lowered at a constant speed from a height.
fn lowering(shape: &str, rest: &str, sea: &str, height: f64, step: f64) -> Simulation {
    let joint = format!(
        "axis: [0, 0, 1], position_m: [0, 0, {height}], mode: {{prescribed: {{speed_m_s: -{SPEED}, history: constant}}}}"
    );
    simulation(&lowered(&joint, sea, &format!("shape: {shape}{rest}"), &format!("step_s: {step}, duration_s: 100")))
}

const SPEED: f64 = 0.5;

/// Returns the force that the joint carries upward, N, at steady speed: weight less the water's forces.
fn hook(load: &mut Simulation) -> f64 {
    values(load, "joint_reaction")[2]
}

#[test]
fn a_box_lowered_through_still_water_has_the_forces_of_a_hand_calculation() {
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
    let events: Vec<(f64, &str)> = load.events().iter().map(|event| (event.time_s, event.what.as_ref())).collect();
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

/// Shares of a box are depth over height; those of a sphere at the depth d are d^2 (3 R - d) / (4 R^3).
#[test]
fn the_growth_of_the_added_mass_over_depth_is_that_of_the_upright_solid() {
    let cap = |depth: f64| depth * depth * (3.0 - depth) / 4.0;
    for (shape, depths, shares, height) in [
        (BOX, "[0, 0.2, 1, 2]", [0.0, 0.1, 0.5, 1.0], 1.1),
        ("{sphere: {radius_m: 1}}", "[0, 0.5, 1.4, 2]", [0.0, cap(0.5), cap(1.4), 1.0], 1.1),
    ] {
        let rest = |growth: &str| {
            format!(", added_mass: {{coefficients: [0, 0, 0.9], growth: {{{growth}, factors: [0, 0.5, 0.8, 1]}}}}")
        };
        let mut by_depth = lowering(shape, &rest(&format!("depths_m: {depths}")), "", height, 0.05);
        let mut by_share = lowering(shape, &rest(&format!("shares: {shares:?}")), "", height, 0.05);
        for _ in 0..100 {
            by_depth.step(1).unwrap();
            by_share.step(1).unwrap();
            for name in ["submerged_added_mass", "submerged_slamming"] {
                let [found, expected] = [&mut by_depth, &mut by_share].map(|load| values(load, name)[2]);
                // The shares' last digits, over intervals of a tenth.
                assert!((found - expected).abs() < 1e-13 * DENSITY * 24.0, "{shape}: {found} {expected}");
            }
        }
    }
}

/// DNV-RP-N103, sec. 4.3.5: 1/2 rho C_S A_S w^2, in place of that of the added mass.
#[test]
fn a_slamming_coefficient_acts_from_first_contact_to_immersion() {
    for (given, area) in [("{coefficient: 5}", 12.0), ("{coefficient: 5, area_m2: 7}", 7.0)] {
        let rest = format!(", added_mass: {{coefficients: [0, 0, 0.9]}}, slamming: {given}");
        let mut load = lowering(BOX, &rest, "", 1.45, 0.05);
        for _ in 0..14 {
            load.step(10).unwrap();
            let depth = SPEED * load.time_s() - 0.45;
            let is_cut = depth > 0.0 && depth < 2.0;
            let by_hand = if is_cut { 0.5 * DENSITY * 5.0 * area * SPEED * SPEED } else { 0.0 };
            let found = values(&mut load, "submerged_slamming")[2];
            assert!((found - by_hand).abs() < 1e-12 * DENSITY * area, "{depth}: {found} {by_hand}");
        }
    }
}

#[test]
fn a_box_lowered_through_a_regular_wave_has_the_forces_of_a_hand_calculation() {
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
fn slamming_on_a_lying_cylinder_in_a_regular_wave_follows_the_rate_of_its_segment() {
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
fn perforation_reduces_the_added_mass_by_the_formula() {
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
fn a_frame_displaces_its_member_volume_and_wind_acts_on_its_dry_part() {
    let rest = ", displaced_volume_m3: 3, wind: {coefficients: [1.2, 1, 1], areas_m2: [5, 6, 7], height_m: 10}";
    let text = lowered("axis: [0, 0, 1], mode: held", "", &format!("shape: {BOX}{rest}"), "step_s: 0.1, duration_s: 1");
    let text = text.replace("bodies:", "wind: {speed_m_s: 15, direction_rad: 0, profile: uniform}\nbodies:");
    let mut load = simulation(&text);
    let force = values(&mut load, "submerged_force");
    // Half of it is under water.
    assert!((force[2] - 1.5 * DENSITY * GRAVITY).abs() < 1e-8, "{force:?}");
    assert!((force[0] - 0.5 * 0.5 * 1.225 * 1.2 * 5.0 * 225.0).abs() < 1e-9, "{force:?}");
}
