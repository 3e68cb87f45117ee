//! Warns of massless rods that represent ropes and push, which a rope cannot do.

use super::watcher::{Exceeded, Extreme, Warning, Watcher, significant};
use crate::model::Attachment;
use crate::spatial::{Frame, Matrix3, Quaternion, Vector3};

/// Share of a rod's largest force in the run below which a push counts as rounding.
const SMALLEST_PUSH: f64 = 1e-6;
/// Swing angle at which a rope would go slack, degrees from the hanging position.
const LARGEST_SWING_DEG: f64 = 90.0;

/// The force of a rod.
#[derive(Clone, Copy, Debug, Default)]
struct Pull {
    /// The largest push, N, negative, and its time.
    least: Extreme,
    /// Largest absolute force, N.
    largest: f64,
}

impl Pull {
    fn see(&mut self, time_s: f64, pull: f64) {
        self.least.see(time_s, pull.min(0.0));
        self.largest = self.largest.max(pull.abs());
    }

    fn warning(&self, name: &str, what: &str) -> Option<Warning> {
        let Extreme { value, time_s } = self.least;
        let text = format!(
            "{what} pushes with {} N, at {} s: a rope would go slack; from then on the run does not represent a load on a rope",
            significant(-value, 5),
            significant(time_s, 6)
        );
        let numbers = Exceeded { value: -value, bound: 0.0, unit: "N" };
        let pushes = value < -SMALLEST_PUSH * self.largest;
        pushes.then(|| Warning::exceeded("rod_pushes", time_s, name, numbers, text))
    }
}

/// A load that swings freely about a joint above its centre of mass, as on a rope: the joint must pull and the load
/// must hang.
#[derive(Clone, Debug)]
pub struct Pendant {
    joint: String,
    body: String,
    /// Unit vector from the centre of mass to the joint, body axes.
    up: Vector3,
    pull: Pull,
    /// Largest angle from the hanging position, degrees.
    swing: Extreme,
    beyond_s: Option<f64>,
}

impl Pendant {
    /// Returns the watcher of a body with this joint; `up` points from the centre of mass to the joint, in body axes,
    /// and has any length except 0.
    pub fn new(joint: &str, body: &str, up: Vector3) -> Self {
        let up = up * (1.0 / up.norm());
        let (pull, swing) = (Pull::default(), Extreme::default());
        Self { joint: joint.to_owned(), body: body.to_owned(), up, pull, swing, beyond_s: None }
    }
}

impl Watcher for Pendant {
    fn columns(&self) -> Vec<String> {
        let force = ["x", "y", "z"].map(|axis| format!("{}.joint_reaction.force_{axis}", self.joint));
        force.into_iter().chain(orientation_columns(&self.body)).collect()
    }

    fn see(&mut self, time_s: f64, values: &[f64]) {
        let (force, quaternion) = values.split_at(3);
        self.pull.see(time_s, Vector3::from_slice(force).dot(self.up));
        let height = (Quaternion::from_slice(quaternion).to_matrix() * self.up)[2].clamp(-1.0, 1.0);
        let angle_deg = libm::acos(height).to_degrees();
        self.swing.see(time_s, angle_deg);
        if angle_deg > LARGEST_SWING_DEG {
            self.beyond_s = self.beyond_s.or(Some(time_s));
        }
    }

    fn warnings(&self) -> Vec<Warning> {
        let over = self.beyond_s.map(|time_s| {
            let text = format!(
                "{} swings to {:.1} deg from the hanging position, beyond {LARGEST_SWING_DEG} deg first at {} s: a rope would go \
                 slack; this rod does not",
                self.body,
                self.swing.value,
                significant(time_s, 6)
            );
            let numbers = Exceeded { value: self.swing.value, bound: LARGEST_SWING_DEG, unit: "deg" };
            Warning::exceeded("large_swing", time_s, &self.joint, numbers, text)
        });
        let push = self.pull.warning(&self.joint, &format!("the pendant of {}", self.body));
        push.into_iter().chain(over).collect()
    }
}

/// A closed loop with a single distance constraint.
#[derive(Clone, Debug)]
pub struct Rod {
    name: String,
    ends: [End; 2],
    pull: Pull,
}

/// An end of a rod, on a body or in the world.
#[derive(Clone, Debug)]
struct End {
    body: Option<String>,
    in_body: Frame,
}

impl Rod {
    /// Returns the watcher of a loop with this name, its attachments and their bodies.
    pub fn new(name: &str, ends: [(&Attachment, Option<&str>); 2]) -> Self {
        let ends = ends.map(|(tie, body)| End { body: body.map(str::to_owned), in_body: tie.in_body });
        Self { name: name.to_owned(), ends, pull: Pull::default() }
    }
}

impl End {
    fn columns(&self) -> Vec<String> {
        let of = |body: &String| {
            let place = ["x", "y", "z"].map(|axis| format!("{body}.position.{axis}"));
            place.into_iter().chain(orientation_columns(body)).collect()
        };
        self.body.as_ref().map_or_else(Vec::new, of)
    }

    /// Returns its frame in the world, from the values of its columns.
    fn frame(&self, values: &[f64]) -> Frame {
        if self.body.is_none() {
            return self.in_body;
        }
        let rotation: Matrix3 = Quaternion::from_slice(&values[3..]).to_matrix();
        Frame { rotation, position: Vector3::from_slice(values) }.times(&self.in_body)
    }
}

impl Watcher for Rod {
    fn columns(&self) -> Vec<String> {
        let force = ["x", "y", "z"].map(|axis| format!("{}.loop_reaction.force_{axis}", self.name));
        force.into_iter().chain(self.ends.iter().flat_map(End::columns)).collect()
    }

    /// Sees a row. The components of the loop's force on its second body are in the axes of the first attachment.
    fn see(&mut self, time_s: f64, values: &[f64]) {
        let (force, rest) = values.split_at(3);
        let (of_first, of_second) = rest.split_at(self.ends[0].columns().len());
        let (first, second) = (self.ends[0].frame(of_first), self.ends[1].frame(of_second));
        let way = second.position - first.position;
        let length = way.norm();
        let along = (first.rotation * Vector3::from_slice(force)).dot(way);
        self.pull.see(time_s, if length > 0.0 { -along / length } else { 0.0 });
    }

    fn warnings(&self) -> Vec<Warning> {
        self.pull.warning(&self.name, "the rod").into_iter().collect()
    }
}

fn orientation_columns(body: &str) -> [String; 4] {
    ["w", "x", "y", "z"].map(|part| format!("{body}.orientation.{part}"))
}
