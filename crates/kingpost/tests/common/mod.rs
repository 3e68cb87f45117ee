//! Parts that the tests share: random models and states, and the paper's scenario.
#![allow(dead_code)] // each test binary uses its own part

pub mod barge;
pub mod barges;
pub mod closed_forms;
pub mod gallery_files;
pub mod hoist_part;
pub mod hulls;
pub mod paper_text;
pub mod splash;
pub mod trees;

use kingpost::analysis::Linearizer;
use kingpost::dynamics::Loads;
use kingpost::model::{JointKind, Model, MotionType};
use kingpost::scenario::{Scenario, ScenarioError};
use kingpost::simulation::{Setup, Simulation};
use kingpost::spatial::{CrossInertia, Frame, Quaternion, SpatialInertia, Symmetric3, Twist, Vector3, Wrench, exp};
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use serde_json::Value;

/// Every integrator that a scenario may name.
pub const INTEGRATORS: [&str; 8] = [
    "forward_euler",
    "midpoint_euler",
    "semi_implicit_euler",
    "rk4",
    "dormand_prince",
    "newmark",
    "generalized_alpha",
    "implicit_midpoint",
];

/// The gallery's scenario of the paper, with parameters or fields set.
pub fn paper_setup(overrides: &[(&str, Value)]) -> Setup {
    let text = include_str!("../../../../scenarios/paper.yaml");
    let overrides: Vec<(String, Value)> =
        overrides.iter().map(|(name, value)| ((*name).to_owned(), value.clone())).collect();
    let scenario = kingpost::scenario::read(text, "paper.yaml", &overrides).expect("the gallery reads");
    scenario.setup().expect("the gallery builds")
}

/// Returns a simulation of the paper's scenario, ready to step.
pub fn paper(overrides: &[(&str, Value)]) -> Simulation {
    Simulation::new(paper_setup(overrides))
}

/// A simulation of a scenario's text.
pub fn simulation(text: &str) -> Simulation {
    let scenario = kingpost::scenario::read(text, "test.yaml", &[]).expect("the scenario reads");
    scenario.simulation().expect("the scenario builds")
}

/// A simulation of a scenario's text with parameters or fields set.
pub fn with_changes(text: &str, changes: &[(&str, Value)]) -> Result<Simulation, ScenarioError> {
    let changes: Vec<(String, Value)> =
        changes.iter().map(|(path, value)| ((*path).to_owned(), value.clone())).collect();
    kingpost::scenario::read(text, "test.yaml", &changes).and_then(|scenario| scenario.simulation())
}

/// The value of a channel now.
pub fn values(simulation: &mut Simulation, variable: &str) -> Vec<f64> {
    let mut row = Vec::new();
    simulation.write_row(&mut row);
    let channel = simulation.channels().iter().find(|c| c.variable == variable).expect("a channel");
    row[channel.offset..][..channel.len].to_vec()
}

/// Checks the exact derivatives of a scenario as [`assert_derivatives`] does, and that the rates have the bits of the run.
pub fn assert_linearised(text: &str) {
    let (rates, accelerations) = assert_derivatives(text);
    assert_eq!(rates, accelerations);
}

/// Checks the exact derivatives of a scenario after 200 steps against central differences. The error of
/// differences with step h is h squared times a third derivative, plus rounding over h.
///
/// Returns the rates of the velocities by both.
pub fn assert_derivatives(text: &str) -> (Vec<f64>, Vec<f64>) {
    assert_derivatives_of(&kingpost::scenario::read(text, "test.yaml", &[]).expect("the scenario reads"))
}

/// Checks the exact derivatives of a scenario as [`assert_derivatives`] does.
pub fn assert_derivatives_of(scenario: &Scenario) -> (Vec<f64>, Vec<f64>) {
    let mut simulation = scenario.simulation().expect("the scenario builds");
    simulation.step(200).expect("some motion");
    let mut linearizer = Linearizer::new(scenario).expect("the scenario builds");
    let linear = linearizer.at(&simulation);
    let free: Vec<usize> = linearizer.positions().collect();
    let (n, h) = (free.len(), 1e-6);
    let still = vec![0.0; simulation.state().v.len()];
    let scale = linear.a.amax();
    for (k, &i) in free.iter().enumerate() {
        let along = |by: f64| {
            let mut along = still.clone();
            along[i] = by;
            along
        };
        let by_position =
            [accelerations(&simulation, &along(h), &still), accelerations(&simulation, &along(-h), &still)];
        let by_rate = [accelerations(&simulation, &still, &along(h)), accelerations(&simulation, &still, &along(-h))];
        for row in 0..n {
            for (column, [ahead, behind]) in [(k, &by_position), (n + k, &by_rate)] {
                let difference = (ahead[row] - behind[row]) / (2.0 * h);
                assert!((linear.a[(n + row, column)] - difference).abs() < 1e-7 * scale, "row {row}, column {column}");
            }
        }
    }
    (linear.rates[n..2 * n].to_vec(), simulation.acceleration(None).expect("accelerations"))
}

/// Returns the accelerations of all coordinates in a state near that of a simulation.
fn accelerations(simulation: &Simulation, xi: &[f64], dv: &[f64]) -> Vec<f64> {
    let mut moved = simulation.clone();
    let q = simulation.moved(&simulation.state().q, xi);
    let v: Vec<f64> = simulation.state().v.iter().zip(dv).map(|(v, dv)| v + dv).collect();
    moved.set_state(&q, &v, Some(&simulation.state().s)).expect("a motion of the model");
    moved.acceleration(None).expect("no forces beside its own")
}

/// Everything at once: two ships, one held in its rotation and one in its place, prescribed and
/// driven joints of both kinds, bodies fixed to bodies and to the world, a chain on the world,
/// a hydraulic cylinder, gravity, damping of a body and of joints.
pub fn everything(form: &str) -> String {
    include_str!("everything.yaml").replace("form: recursive", &format!("form: {form}"))
}

/// Two barges in free space with a crane's arm between them, far from the origin.
pub fn tied_ships(form: &str) -> String {
    include_str!("tied_ships.yaml").replace("form: recursive", &format!("form: {form}"))
}

/// Mass of each body of [`every_joint`], kg.
pub const EVERY_MASS: f64 = 2.0;
/// Its inertia about its centre of mass, kg m^2.
pub const EVERY_MOMENTS: [[f64; 3]; 3] = [[0.4, 0.05, -0.1], [0.05, 0.6, 0.02], [-0.1, 0.02, 0.9]];

/// Parent, and place of the joint in its own axes, of each body of [`every_joint`].
pub const EVERY_JOINT: [(Option<usize>, [f64; 3]); 8] = [
    (None, [0.0, 0.0, 0.0]),
    (Some(0), [0.1, 0.0, -1.0]),
    (Some(1), [0.0, 0.2, 1.0]),
    (Some(2), [0.3, 0.0, 0.8]),
    (Some(0), [0.0, 0.1, -0.3]),
    (Some(4), [0.5, 0.0, 0.0]),
    (Some(5), [-0.4, 0.1, 0.0]),
    (Some(6), [0.0, 0.0, 0.5]),
];

/// A hull with a mechanism of every kind of joint on it, all in motion.
pub fn every_joint() -> String {
    let mut text = "version: 1\ntitle: Every joint\nsimulation: {step_s: 0.0001}\nbodies:\n".to_owned();
    let kinds = [
        "floating: {initial: {orientation_rad: [0.2, 0.1, 0.3], angular_velocity_rad_s: [0.3, -0.2, 0.1]}}",
        "cylindrical: {axis: [0, 0, 1], rotation: {initial_rate_rad_s: 2}, translation: {spring: {stiffness_N_per_m: 900}}, PLACE}",
        "universal: {first_axis: [1, 0, 0], second_axis: [0, 1, 0], first: {initial_angle_rad: 0.5}, second: {initial_rate_rad_s: -1}, PLACE}",
        "spherical: {initial_angular_velocity_rad_s: [1, 2, -1], damping_N_m_s: 0.3, PLACE}",
        "planar: {normal: [0, 0, 1], x_axis: [1, 1, 0], x: {initial_speed_m_s: 1}, rotation: {initial_rate_rad_s: 3}, PLACE}",
        "revolute: {axis: [0, 1, 1], initial_rate_rad_s: 1, friction: {torque_N_m: 0.5}, limits: {upper_rad: 50, stiffness_N_m_per_rad: 1e4}, PLACE}",
        "prismatic: {axis: [1, 0, 0], mode: {prescribed: {speed_m_s: 0.5}}, PLACE}",
        "fixed: {orientation_rad: [0.4, 0, 0], PLACE}",
    ];
    for (i, ((parent, [x, y, z]), kind)) in EVERY_JOINT.into_iter().zip(kinds).enumerate() {
        let parent = parent.map_or("world".to_owned(), |p| format!("b{p}"));
        let kind = kind.replace("PLACE", &format!("position_m: [0.5, 0.3, 0.2], child_position_m: [{x}, {y}, {z}]"));
        let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = EVERY_MOMENTS;
        text += &format!(
            "  b{i}: {{parent: {parent}, mass_kg: {EVERY_MASS}, inertia: {{tensor: {{moments_kg_m2: [{xx}, {yy}, {zz}], \
             products_kg_m2: [{xy}, {xz}, {yz}]}}}}, joint: {{{kind}}}}}\n"
        );
    }
    text += "forces: {weight: {gravity: {}}}\ndrives: {turn: {motor: {joint: b2.first, torque_N_m: 1.5}}, grip: {brake: {joint: b4.rotation, torque_N_m: 0.4, state: lever}}}\n";
    text
}

/// A body between a quay and the seabed, on lines of every kind, in a stream.
pub fn moored() -> String {
    let mut text = "version: 1\ntitle: Moored\nsimulation: {step_s: 0.005, duration_s: 100}\nbodies:\n  ship:\n    mass_kg: 2000\n    \
                    shape: {box: {length_m: 6, width_m: 3, height_m: 2}}\n    joint: {floating: {initial: {velocity_m_s: [0.5, 1, 0], \
                    angular_velocity_rad_s: [0.1, -0.2, 0.3]}}}\nsea: {depth_m: 60, current_m_s: [0.5, 0.2]}\nforces:\n"
        .to_owned();
    for (name, place, anchor, seabed) in [
        ("bow", "[3, 0, -1]", "[50, 10, -60]", true),
        ("port", "[0, 1.5, 1]", "[5, 30, -60]", true),
        ("stern", "[-3, 0, 0]", "[-60, 0, -40]", false),
    ] {
        text += &format!(
            "  {name}: {{catenary_line: {{fairlead: {{body: ship, position_m: {place}}}, anchor_m: {anchor}, unstretched_length_m: 93, \
             weight_in_water_N_per_m: 15, axial_stiffness_kN: 80, seabed: {seabed}}}}}\n"
        );
    }
    text + "  hawser: {spring_line: {first: {body: ship, position_m: [1, 0, 0]}, second: {body: world, position_m: [9, 3, 12]}, \
            unstretched_length_m: 10, axial_stiffness_kN: 60, dissipation_s_per_m: 0.1}}\n  \
            drag: {quadratic_damping: {body: ship, position_m: [0.3, 0, -0.5], linear_N_s2_m2: [10, 30, 20], angular_N_m_s2: [40, 50, 60]}}\n"
}

/// A source of random models; the seed makes a failure repeatable.
pub struct Random(StdRng);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(StdRng::seed_from_u64(seed))
    }

    pub fn uniform(&mut self, lower: f64, upper: f64) -> f64 {
        self.0.random_range(lower..upper)
    }

    pub fn chance(&mut self, probability: f64) -> bool {
        self.0.random_bool(probability)
    }

    pub fn below(&mut self, n: usize) -> usize {
        self.0.random_range(0..n)
    }

    pub fn vector(&mut self, scale: f64) -> Vector3 {
        Vector3(core::array::from_fn(|_| self.uniform(-scale, scale)))
    }

    pub fn unit(&mut self) -> Vector3 {
        let v = self.vector(1.0);
        if v.norm() < 0.1 { self.unit() } else { v * (1.0 / v.norm()) }
    }

    pub fn frame(&mut self) -> Frame {
        Frame { rotation: exp(self.vector(2.0)), position: self.vector(2.0) }
    }

    pub fn rigid(&mut self) -> (f64, SpatialInertia) {
        let mass = self.uniform(0.5, 5.0);
        let edges: [f64; 3] = core::array::from_fn(|_| self.uniform(0.3, 2.0));
        let box_inertia = kingpost::model::Shape::Box { edges_m: edges }.inertia(mass);
        let turned: Symmetric3 = box_inertia.rotated(&exp(self.vector(1.0)));
        (mass, SpatialInertia::rigid(mass, turned))
    }

    /// A full symmetric positive definite 6x6.
    pub fn full_inertia(&mut self) -> SpatialInertia {
        let a: [[f64; 6]; 6] = core::array::from_fn(|_| core::array::from_fn(|_| self.uniform(-1.0, 1.0)));
        SpatialInertia::from_rows(&core::array::from_fn(|i| {
            core::array::from_fn(|j| {
                let square: f64 = (0..6).map(|k| a[i][k] * a[j][k]).sum();
                square + if i == j { 1.0 } else { 0.0 }
            })
        }))
    }

    /// A tree of 1 to 30 bodies with at least one free coordinate.
    pub fn model(&mut self) -> Model {
        trees::tree_of(self.0.random()).model()
    }

    /// Returns positions and velocities; held coordinates are at rest.
    pub fn state(&mut self, model: &Model) -> (Vec<f64>, Vec<f64>) {
        let mut q: Vec<f64> = (0..model.position_count).map(|_| self.uniform(-2.0, 2.0)).collect();
        for first in model.quaternions() {
            q[first..first + 4].copy_from_slice(&Quaternion::exp(self.vector(2.0)).0);
        }
        let v = model.modes.iter().map(|mode| if *mode == MotionType::Held { 0.0 } else { self.uniform(-2.0, 2.0) });
        let v = v.collect();
        (q, v)
    }

    /// Adds a positive semidefinite inertia of all bodies that float freely, between every two of them and of each.
    pub fn couple_floating_bodies(&mut self, model: &Model, loads: &mut Loads) {
        let floats = |body: &usize| match model.joints[*body].kind {
            JointKind::Floating(held) => !held.hold_translation && !held.hold_rotation,
            _ => false,
        };
        let floating: Vec<usize> = (0..model.bodies.len()).filter(floats).collect();
        let factors: Vec<[Twist; 6]> = floating
            .iter()
            .map(|_| core::array::from_fn(|_| Twist { angular: self.vector(1.0), linear: self.vector(1.0) }))
            .collect();
        let between = |first: &[Twist; 6], second: &[Twist; 6]| {
            CrossInertia::from_columns(|twist| {
                first.iter().zip(second).fold(Wrench::zero(), |sum, (a, b)| {
                    let rate = b.angular.dot(twist.angular) + b.linear.dot(twist.linear);
                    sum + Wrench { moment: a.angular * rate, force: a.linear * rate }
                })
            })
        };
        for (k, &body) in floating.iter().enumerate().filter(|_| floating.len() > 1) {
            let own = between(&factors[k], &factors[k]);
            let rows = core::array::from_fn(|i| core::array::from_fn(|j| own.entry(i, j)));
            loads.added_inertia.push((body, SpatialInertia::from_rows(&rows)));
            for (l, &other) in floating.iter().enumerate().skip(k + 1) {
                loads.added_inertia_between.push(([body, other], between(&factors[k], &factors[l])));
            }
        }
    }

    /// Loads of every kind that the dynamics takes.
    pub fn loads(&mut self, model: &Model) -> Loads {
        let mut loads = Loads::new(model);
        for body in 0..model.bodies.len() {
            loads.wrenches.push((body, Wrench { moment: self.vector(5.0), force: self.vector(5.0) }));
        }
        loads.force.iter_mut().for_each(|f| *f = self.uniform(-5.0, 5.0));
        loads.acceleration.iter_mut().for_each(|a| *a = self.uniform(-3.0, 3.0));
        for body in 0..model.bodies.len() {
            if self.chance(0.2) {
                loads.added_inertia.push((body, self.full_inertia()));
            }
        }
        self.couple_floating_bodies(model, &mut loads);
        loads
    }
}

/// Returns the largest difference, divided by the largest entry of both.
pub fn relative_difference(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    let (mut largest, mut difference) = (f64::MIN_POSITIVE, 0.0_f64);
    for (a, b) in a.iter().zip(b) {
        largest = largest.max(a.abs()).max(b.abs());
        difference = difference.max((a - b).abs());
        assert!(a.is_finite() && b.is_finite());
    }
    difference / largest
}
