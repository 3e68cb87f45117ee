//! Moves everything that a part's file attaches to the world to the part's mounting: root bodies, pins,
//! anchors, targets.

use serde_json::{Value, json};

use super::super::error::{Fault, SourcePlace};
use super::super::reading::{FromNode, PlaceKind};
use super::super::schema::{Drive, Force, Loop, Mounting, Sensor};
use super::super::tree::{Content, ScenarioNode};
use super::super::wording;
use super::{Mount, WORLD, numbers, put};
use crate::spatial::{Matrix3, Vector3, roll_pitch_yaw, rotation_from_roll_pitch_yaw};

/// Pose of a part relative to the body on which it is mounted.
struct Pose {
    position: [f64; 3],
    angles: [f64; 3],
    rotation: Matrix3,
}

const NONE: [f64; 3] = [0.0; 3];

impl Pose {
    fn of(mounting: &Mounting) -> Self {
        let (position, angles) = (mounting.position_m, mounting.orientation_rad);
        Self { position, angles, rotation: rotation_from_roll_pitch_yaw(Vector3(angles)) }
    }

    fn is_none(&self) -> bool {
        self.position == NONE && self.angles == NONE
    }

    /// Returns p + R x. Without a rotation there is no rounding.
    fn point(&self, x: [f64; 3]) -> [f64; 3] {
        (self.vector(x) + Vector3(self.position)).0
    }

    /// Returns R x.
    fn vector(&self, x: [f64; 3]) -> Vector3 {
        if self.angles == NONE { Vector3(x) } else { self.rotation * Vector3(x) }
    }

    /// Returns roll, pitch and yaw of R times the rotation by these angles.
    fn turned(&self, angles: [f64; 3]) -> [f64; 3] {
        match (self.angles, angles) {
            (NONE, own) => own,
            (by, NONE) => by,
            ([0.0, 0.0, by], [0.0, 0.0, own]) => [0.0, 0.0, by + own],
            _ => roll_pitch_yaw(&(self.rotation * rotation_from_roll_pitch_yaw(Vector3(angles)))).0,
        }
    }
}

/// Moves everything attached to the world to the mounting. Returns the paths of the fields that hold the
/// position of the mounting, or the path of an entry whose position is given separately.
pub fn on_the_mounting(
    tree: &mut ScenarioNode,
    whole: &Value,
    mount: &Mount<'_>,
) -> Result<Result<Vec<String>, String>, Fault> {
    let standing = Standing { whole, mount, pose: Pose::of(mount.mounting) };
    let mut frames = Ok(Vec::new());
    let bodies = whole.get("bodies").and_then(Value::as_object);
    for (name, body) in bodies.into_iter().flatten().filter(|(_, body)| body["parent"] == WORLD) {
        let Some((kind, _)) = body["joint"].as_object().and_then(|joint| joint.iter().next()) else { continue };
        match standing.root(tree, name, kind)? {
            Some(frame) => frames = frames.map(|frames: Vec<String>| [frames, vec![frame]].concat()),
            None => frames = Err(format!("bodies.{name}.joint.{kind}")),
        }
    }
    for section in ["loops", "forces", "drives", "sensors"] {
        for (name, entry) in whole.get(section).and_then(Value::as_object).into_iter().flatten() {
            let Some((kind, _)) = entry.as_object().and_then(|entry| entry.iter().next()) else { continue };
            let Some(node) = tree.at(&[section.to_owned(), name.clone()]) else { continue };
            let mut pins = Vec::new();
            world_pins(node, &mut vec![section.to_owned(), name.clone()], &mut pins);
            for pin in &pins {
                standing.pin(tree, pin);
            }
            let in_the_world = standing.in_the_world(tree, section, name, kind)?;
            if in_the_world || !pins.is_empty() {
                frames = Err(format!("{section}.{name}"));
            }
        }
    }
    Ok(frames)
}

/// Collects the paths of the fields whose `body` is the world.
fn world_pins(node: &ScenarioNode, path: &mut Vec<String>, into: &mut Vec<Vec<String>>) {
    let mut below = |name: String, node: &ScenarioNode| {
        path.push(name);
        world_pins(node, path, into);
        path.pop();
    };
    match &node.content {
        Content::Scalar(_) => {}
        Content::List(entries) => entries.iter().enumerate().for_each(|(i, entry)| below(i.to_string(), entry)),
        Content::Fields(fields) => {
            fields.iter().for_each(|(name, field)| below(name.clone(), &field.node));
            if fields.get("body").is_some_and(|field| field.node.to_value() == WORLD) {
                into.push(path.clone());
            }
        }
    }
}

/// A part during its move to the mounting.
struct Standing<'a> {
    /// The part with all defaults.
    whole: &'a Value,
    mount: &'a Mount<'a>,
    pose: Pose,
}

impl Standing<'_> {
    fn on(&self) -> &str {
        &self.mount.mounting.on
    }

    /// Returns the place of a field of the mounting in the file.
    fn place(&self, field: &str) -> SourcePlace {
        self.mount.fault(field, "", "").place
    }

    fn write(&self, tree: &mut ScenarioNode, path: &str, value: &Value) {
        let place = self.place(if path.ends_with("_rad") { "orientation_rad" } else { "position_m" });
        put(tree, &path.split('.').collect::<Vec<_>>(), value, &place);
    }

    /// Moves the point at a path; returns whether it was at the origin.
    fn move_point(&self, tree: &mut ScenarioNode, path: &str) -> bool {
        let Some(own) = numbers(self.whole, path) else { return true };
        if !self.pose.is_none() {
            self.write(tree, path, &json!(self.pose.point(own)));
        }
        own == NONE
    }

    /// Rotates the axes whose roll, pitch and yaw are at a path; returns whether they were parallel to the
    /// world's.
    fn turn_axes(&self, tree: &mut ScenarioNode, path: &str) -> bool {
        let Some(own) = numbers(self.whole, path) else { return true };
        if self.pose.angles != NONE {
            self.write(tree, path, &json!(self.pose.turned(own)));
        }
        own == NONE
    }

    /// Moves a root body of the part; returns the path of its position, unless the part's file gives a
    /// position.
    fn root(&self, tree: &mut ScenarioNode, name: &str, kind: &str) -> Result<Option<String>, Fault> {
        let joint = format!("bodies.{name}.joint.{kind}");
        let frame = match kind {
            "floating" => format!("{joint}.initial"),
            "moved_by_waves" => {
                self.needs_the_world(&format!("bodies.{name}"))?;
                self.needs_to_be_level(&format!("bodies.{name}"))?;
                self.move_point(tree, &format!("{joint}.position_m"));
                self.turn_heading(tree, &format!("{joint}.heading_rad"));
                return Ok(None);
            }
            _ => joint,
        };
        if kind == "floating" {
            self.needs_the_world(&format!("bodies.{name}"))?;
            if let Some(velocity) = numbers(self.whole, &format!("{frame}.velocity_m_s"))
                && velocity != NONE
                && self.pose.angles != NONE
            {
                self.write(tree, &format!("{frame}.velocity_m_s"), &json!(self.pose.vector(velocity).0));
            }
        }
        if self.on() != WORLD {
            put(tree, &["bodies", name, "parent"], &json!(self.on()), &self.place("on"));
        }
        let drawn = format!("{frame}.drawing_frame_m");
        let is_drawn = kind == "floating" && numbers::<3>(self.whole, &drawn).is_some();
        let at_origin = if is_drawn {
            self.move_point(tree, &drawn);
            false
        } else {
            self.move_point(tree, &format!("{frame}.position_m"))
        };
        let even = self.turn_axes(tree, &format!("{frame}.orientation_rad"));
        Ok((at_origin && even).then_some(frame))
    }

    /// Moves a point, or axes, in the world.
    fn pin(&self, tree: &mut ScenarioNode, path: &[String]) {
        let path = path.join(".");
        self.move_point(tree, &format!("{path}.position_m"));
        self.turn_axes(tree, &format!("{path}.orientation_rad"));
        if let Some(axis) = numbers(self.whole, &format!("{path}.axis"))
            && self.pose.angles != NONE
        {
            self.write(tree, &format!("{path}.axis"), &json!(self.pose.vector(axis).0));
        }
        if self.on() != WORLD {
            let body = format!("{path}.body");
            put(tree, &body.split('.').collect::<Vec<_>>(), &json!(self.on()), &self.place("on"));
        }
    }

    /// Moves entries with a position in the world that do not contain a body `world`: anchors, and the target
    /// of a ship.
    fn in_the_world(&self, tree: &mut ScenarioNode, section: &str, name: &str, kind: &str) -> Result<bool, Fault> {
        let entry = format!("{section}.{name}.{kind}");
        let kinds = match section {
            "loops" => Loop::declared_fields(),
            "forces" => Force::declared_fields(),
            "drives" => Drive::declared_fields(),
            _ => Sensor::declared_fields(),
        };
        let fields = kinds.iter().filter(|one| one.name == kind).flat_map(|one| (one.fields)());
        let places = fields.filter_map(|field| Some((format!("{entry}.{}", field.name), field.placed?)));
        let placed: Vec<(String, PlaceKind)> = places.filter(|(field, _)| self.has(field)).collect();
        for (field, place) in &placed {
            self.needs_the_world(&entry)?;
            match place {
                PlaceKind::Point => {
                    self.move_point(tree, field);
                }
                PlaceKind::Station => {
                    self.needs_to_be_level(&entry)?;
                    self.move_target(tree, field);
                }
            }
        }
        Ok(!placed.is_empty())
    }

    fn number(&self, path: &str) -> f64 {
        let found = super::super::tree::value_at(self.whole, &super::segments(path));
        found.and_then(Value::as_f64).unwrap_or_default()
    }

    fn has(&self, path: &str) -> bool {
        super::super::tree::value_at(self.whole, &super::segments(path)).is_some_and(|value| !value.is_null())
    }

    fn move_target(&self, tree: &mut ScenarioNode, target: &str) {
        if !self.pose.is_none() {
            let [x, y, _] =
                self.pose.point([self.number(&format!("{target}.x_m")), self.number(&format!("{target}.y_m")), 0.0]);
            self.write(tree, &format!("{target}.x_m"), &json!(x));
            self.write(tree, &format!("{target}.y_m"), &json!(y));
        }
        self.turn_heading(tree, &format!("{target}.heading_rad"));
    }

    fn turn_heading(&self, tree: &mut ScenarioNode, path: &str) {
        let [_, _, by] = self.pose.angles;
        if by != 0.0 {
            self.write(tree, path, &json!(self.number(path) + by));
        }
    }

    /// Returns an error if the part is mounted on a body.
    fn needs_the_world(&self, what: &str) -> Result<(), Fault> {
        if self.on() == WORLD {
            return Ok(());
        }
        let found = format!("{}, and {what} in the part", self.on());
        Err(self.mount.fault("on", found, wording::ON_THE_WORLD))
    }

    /// Returns an error if the part is tilted.
    fn needs_to_be_level(&self, what: &str) -> Result<(), Fault> {
        let [roll, pitch, _] = self.pose.angles;
        if roll == 0.0 && pitch == 0.0 {
            return Ok(());
        }
        let found = format!("roll {roll} and pitch {pitch}, and {what} in the part");
        Err(self.mount.fault("orientation_rad", found, wording::LEVEL))
    }
}
