//! The registry of result channels: names, units, frames and dimensions, in one table.

mod loops;

use crate::elements::drives::Drive;
use crate::elements::{DynamicPositioning, Force};
use crate::ledger;
use crate::model::{AxisMotion, JointKind, Model, Node};
use crate::plant::Observation;
use crate::scalar::Scalar;
use crate::spatial::{Frame, Quaternion, Twist, Vector3, Wrench, roll_pitch_yaw};
use core::marker::PhantomData;
use serde::Serialize;

/// A dimension of a channel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Dimension {
    /// Bodies by name.
    Body,
    /// x, y, z.
    Axis,
    /// w, x, y, z.
    Quaternion,
    /// Coordinates of all joints but floating ones.
    Coordinate,
    /// Joints by name.
    Joint,
    /// Force and moment, x, y, z each.
    Component,
    /// Named points as `body.point`.
    Point,
    /// Closed loops by name.
    Loop,
    /// Constraints of closed loops as `loop.constraint`.
    Constraint,
    /// Hydraulic cylinders by name.
    Cylinder,
    /// Hulls in the water by the name of their force.
    Hull,
    /// Lines by the name of their force.
    Line,
    /// Loads of wind and current by the name of their force.
    Flow,
    /// Dynamic positioning by the name of its force.
    Station,
    /// Thrusters as `force.thruster`.
    Thruster,
    /// Surge, sway and yaw.
    Planar,
}

/// The frame of a vector's components.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Components {
    /// World axes.
    World,
    /// The body's own axes.
    Body,
    /// The joint's axes on the child's side.
    Joint,
    /// The axes of a closed loop's first attachment.
    Loop,
    /// Level axes that turn slowly with the hull.
    SlowFrame,
    /// Level axes that turn with the hull's heading.
    Heading,
    /// Not a vector.
    None,
}

/// One result variable of a model, with its place in a row.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Channel {
    /// Name in a data set.
    pub variable: &'static str,
    /// What it is.
    pub long_name: &'static str,
    /// SI unit.
    pub unit: &'static str,
    /// Frame of the components.
    pub frame: Components,
    /// Dimensions, slowest first.
    pub dims: Vec<Dimension>,
    /// Labels along each dimension.
    pub labels: Vec<Vec<String>>,
    /// First entry in a row.
    pub offset: usize,
    /// Number of entries.
    pub len: usize,
}

/// Everything that a row is computed from.
pub struct Sample<'a, S = f64> {
    /// Time, s.
    pub time_s: f64,
    /// Positions.
    pub q: &'a [S],
    /// Velocities.
    pub v: &'a [S],
    /// The ledger's entries.
    pub s: &'a [S],
    /// Bodies, reactions and loads.
    pub observed: Observation<'a, S>,
}

struct Entry<S> {
    variable: &'static str,
    long_name: &'static str,
    unit: Unit,
    frame: Components,
    dims: &'static [Dimension],
    write: fn(&Sample<'_, S>, &mut Vec<S>),
}

enum Unit {
    Plain(&'static str),
    /// By what the coordinates are: all rotations, all translations, or both.
    Coordinate([&'static str; 3]),
}

use Components::{
    Body as InBody, Heading as InHeading, Joint as InJoint, Loop as InLoop, None as Number, SlowFrame as InSlowFrame,
    World,
};
use Dimension::{
    Axis, Body, Component, Constraint, Coordinate, Cylinder, Flow, Hull, Joint, Line, Loop, Planar, Point,
    Quaternion as QuaternionDim, Station, Thruster,
};
use Unit::{Coordinate as By, Plain};

struct Table<S>(PhantomData<S>);

#[rustfmt::skip]
impl<S: Scalar> Table<S> {
    /// Every channel: the single source of names, units and frames.
    const ENTRIES: [Entry<S>; 47] = [
        Entry { variable: "time", long_name: "time", unit: Plain("s"), frame: Number, dims: &[], write: |x, out| out.push(S::constant(x.time_s)) },
        Entry { variable: "position", long_name: "position of the centre of mass", unit: Plain("m"), frame: World, dims: &[Body, Axis],
            write: |x, out| each_frame(x, out, |frame, out| out.extend(frame.position.0)) },
        Entry { variable: "orientation", long_name: "unit quaternion from body to world axes", unit: Plain("1"), frame: World, dims: &[Body, QuaternionDim],
            write: |x, out| each_frame(x, out, |frame, out| out.extend(Quaternion::from_matrix(&frame.rotation).0)) },
        Entry { variable: "roll", long_name: "roll angle, positive port side up", unit: Plain("rad"), frame: World, dims: &[Body], write: |x, out| angle(x, out, 0) },
        Entry { variable: "pitch", long_name: "pitch angle, positive bow down", unit: Plain("rad"), frame: World, dims: &[Body], write: |x, out| angle(x, out, 1) },
        Entry { variable: "yaw", long_name: "yaw angle, positive bow to port", unit: Plain("rad"), frame: World, dims: &[Body], write: |x, out| angle(x, out, 2) },
        Entry { variable: "velocity", long_name: "velocity of the centre of mass", unit: Plain("m/s"), frame: World, dims: &[Body, Axis], write: velocity },
        Entry { variable: "angular_velocity", long_name: "angular velocity: roll, pitch and yaw rate", unit: Plain("rad/s"), frame: InBody, dims: &[Body, Axis],
            write: |x, out| out.extend(x.observed.bodies.twist.iter().flat_map(|twist| twist.angular.0)) },
        Entry { variable: "acceleration", long_name: "acceleration of the centre of mass", unit: Plain("m/s^2"), frame: World, dims: &[Body, Axis], write: acceleration },
        Entry { variable: "joint_position", long_name: "joint angle or extension; the rotation vector of a spherical joint", unit: By(["rad", "m", "rad or m"]), frame: Number, dims: &[Coordinate],
            write: |x, out| each_coordinate(x, out, joint_position) },
        Entry { variable: "joint_velocity", long_name: "joint rate; the angular velocity of a spherical joint in child axes", unit: By(["rad/s", "m/s", "rad/s or m/s"]), frame: Number, dims: &[Coordinate],
            write: |x, out| each_coordinate(x, out, |x, c| x.v[c.index]) },
        Entry { variable: "joint_force", long_name: "force or moment that the joint carries along its coordinate: drive, friction, hold", unit: By(["N m", "N", "N m or N"]), frame: Number,
            dims: &[Coordinate], write: |x, out| each_coordinate(x, out, |x, c| x.observed.inverse.joint_wrench[c.body].dot(&x.observed.bodies.columns[c.index])) },
        Entry { variable: "joint_reaction", long_name: "wrench of the joint on the child, at the joint, in the child's axes, drive included", unit: Plain("N, N m"), frame: InJoint,
            dims: &[Joint, Component], write: joint_reaction },
        Entry { variable: "loop_reaction", long_name: "wrench of the loop on its second body, at the second attachment, in the axes of the first", unit: Plain("N, N m"), frame: InLoop,
            dims: &[Loop, Component], write: loops::reaction },
        Entry { variable: "loop_error", long_name: "what is left open along a constraint; of an angle, its sine", unit: Plain("m or rad"), frame: Number, dims: &[Constraint],
            write: loops::error },
        Entry { variable: "cylinder_length", long_name: "length of a cylinder between its pins", unit: Plain("m"), frame: Number, dims: &[Cylinder],
            write: |x, out| out.extend(x.observed.cylinders.iter().map(|cylinder| cylinder.length)) },
        Entry { variable: "cylinder_rate", long_name: "rate of a cylinder's length", unit: Plain("m/s"), frame: Number, dims: &[Cylinder],
            write: |x, out| out.extend(x.observed.cylinders.iter().map(|cylinder| cylinder.rate)) },
        Entry { variable: "cylinder_force", long_name: "force of a cylinder, positive where it pushes, stops included", unit: Plain("N"), frame: Number, dims: &[Cylinder],
            write: |x, out| out.extend(x.observed.cylinders.iter().map(|cylinder| cylinder.force)) },
        Entry { variable: "wave_elevation", long_name: "elevation of the incident waves where the hull is on average", unit: Plain("m"), frame: Number, dims: &[Hull],
            write: |x, out| out.extend(x.observed.hulls.iter().map(|hull| hull.wave_elevation)) },
        Entry { variable: "excitation_force", long_name: "force and moment of the incident waves, about the hull's reference point", unit: Plain("N, N m"), frame: InSlowFrame, dims: &[Hull, Component],
            write: |x, out| out.extend(x.observed.hulls.iter().flat_map(|hull| hull.excitation_force)) },
        Entry { variable: "drift_force", long_name: "mean and slowly varying force and moment of the waves on a hull, about its reference point", unit: Plain("N, N m"), frame: InSlowFrame, dims: &[Hull, Component],
            write: |x, out| out.extend(x.observed.hulls.iter().flat_map(|hull| hull.drift_force)) },
        Entry { variable: "radiation_force", long_name: "force and moment of the waves that the hull has made, added mass apart, about its reference point", unit: Plain("N, N m"), frame: InSlowFrame, dims: &[Hull, Component],
            write: |x, out| out.extend(x.observed.hulls.iter().flat_map(|hull| hull.radiation_force)) },
        Entry { variable: "water_kinetic_energy", long_name: "the water's part of the kinetic energy, by the infinite-frequency added mass", unit: Plain("J"), frame: Number, dims: &[Hull],
            write: |x, out| out.extend(x.observed.hulls.iter().map(|hull| hull.water_kinetic_energy)) },
        Entry { variable: "line_tension", long_name: "tension of a line at its first end, or its fairlead", unit: Plain("N"), frame: Number, dims: &[Line],
            write: |x, out| out.extend(x.observed.lines.iter().map(|line| line.tension)) },
        Entry { variable: "line_end_tension", long_name: "tension of a line at its second end, or its anchor", unit: Plain("N"), frame: Number, dims: &[Line],
            write: |x, out| out.extend(x.observed.lines.iter().map(|line| line.end_tension)) },
        Entry { variable: "line_grounded_length", long_name: "unstretched length of a line that lies on the seabed", unit: Plain("m"), frame: Number, dims: &[Line],
            write: |x, out| out.extend(x.observed.lines.iter().map(|line| line.grounded_length)) },
        Entry { variable: "flow_force", long_name: "force and moment of wind or current about the reference point of its coefficients", unit: Plain("N, N m"), frame: InBody, dims: &[Flow, Component],
            write: |x, out| out.extend(x.observed.flow_forces.iter().flatten()) },
        Entry { variable: "station_error", long_name: "surge and sway from a ship on dynamic positioning to its target, and the heading that lacks", unit: Plain("m, rad"), frame: InHeading, dims: &[Station, Planar],
            write: |x, out| out.extend(x.observed.positioning.iter().flat_map(|station| station.error)) },
        Entry { variable: "station_demand", long_name: "force and yaw moment that dynamic positioning asks for, about the point that is kept", unit: Plain("N, N m"), frame: InHeading, dims: &[Station, Planar],
            write: |x, out| out.extend(x.observed.positioning.iter().flat_map(|station| station.demand)) },
        Entry { variable: "station_command", long_name: "what of that the thrusters are told to give", unit: Plain("N, N m"), frame: InBody, dims: &[Station, Planar],
            write: |x, out| out.extend(x.observed.positioning.iter().flat_map(|station| station.command)) },
        Entry { variable: "station_force", long_name: "force and yaw moment that the thrusters give, about the point that is kept", unit: Plain("N, N m"), frame: InBody, dims: &[Station, Planar],
            write: |x, out| out.extend(x.observed.positioning.iter().flat_map(|station| station.delivered)) },
        Entry { variable: "thruster_thrust", long_name: "thrust, negative astern; of an azimuth thruster its length", unit: Plain("N"), frame: Number, dims: &[Thruster],
            write: |x, out| out.extend(x.observed.thrusters.iter().map(|thruster| thruster.thrust)) },
        Entry { variable: "thruster_force", long_name: "thrust as a force", unit: Plain("N"), frame: InBody, dims: &[Thruster, Axis],
            write: |x, out| out.extend(x.observed.thrusters.iter().flat_map(|thruster| [thruster.force[0], thruster.force[1], S::ZERO])) },
        Entry { variable: "thruster_utilisation", long_name: "thrust as a share of what the thruster can give that way", unit: Plain("1"), frame: Number, dims: &[Thruster],
            write: |x, out| out.extend(x.observed.thrusters.iter().map(|thruster| thruster.utilisation)) },
        Entry { variable: "point_position", long_name: "position of a named point", unit: Plain("m"), frame: World, dims: &[Point, Axis],
            write: |x, out| each_point(x, out, |frame, _, p| frame.point(p)) },
        Entry { variable: "point_velocity", long_name: "velocity of a named point", unit: Plain("m/s"), frame: World, dims: &[Point, Axis],
            write: |x, out| each_point(x, out, |frame, twist, p| frame.rotation * (twist.linear + twist.angular.cross(p))) },
        Entry { variable: "kinetic_energy", long_name: "kinetic energy, the water's part included", unit: Plain("J"), frame: Number, dims: &[], write: |x, out| out.push(x.observed.totals.kinetic_energy) },
        Entry { variable: "potential_energy", long_name: "potential energy", unit: Plain("J"), frame: Number, dims: &[], write: |x, out| out.push(x.observed.totals.potential_energy) },
        Entry { variable: "work_done", long_name: "work by drives and by everything outside", unit: Plain("J"), frame: Number, dims: &[], write: |x, out| out.push(work_done(x)) },
        Entry { variable: "work_by_drives", long_name: "work by motors, servos and prescribed motions", unit: Plain("J"), frame: Number, dims: &[], write: |x, out| out.push(x.s[ledger::WORK_BY_DRIVES]) },
        Entry { variable: "work_by_outside", long_name: "work by everything outside, potential energy apart", unit: Plain("J"), frame: Number, dims: &[], write: |x, out| out.push(x.s[ledger::WORK_BY_OUTSIDE]) },
        Entry { variable: "energy_dissipated", long_name: "energy turned into heat", unit: Plain("J"), frame: Number, dims: &[], write: |x, out| out.push(x.s[ledger::ENERGY_DISSIPATED]) },
        Entry { variable: "linear_momentum", long_name: "linear momentum", unit: Plain("kg m/s"), frame: World, dims: &[Axis], write: |x, out| out.extend(x.observed.totals.linear_momentum.0) },
        Entry { variable: "angular_momentum", long_name: "angular momentum about the world's origin, or the held centre", unit: Plain("N m s"), frame: World, dims: &[Axis],
            write: |x, out| out.extend(x.observed.totals.angular_momentum.0) },
        Entry { variable: "energy_error", long_name: "energy less what work and heat leave of it", unit: Plain("J"), frame: Number, dims: &[], write: |x, out| out.push(energy_error(x)) },
        Entry { variable: "momentum_error", long_name: "length of the angular momentum less its balance", unit: Plain("N m s"), frame: Number, dims: &[], write: |x, out| out.push(momentum_error(x)) },
        Entry { variable: "linear_momentum_error", long_name: "length of the linear momentum less its balance", unit: Plain("kg m/s"), frame: Number, dims: &[],
            write: |x, out| out.push((x.observed.totals.linear_momentum - Vector3::from_slice(&x.s[ledger::LINEAR_MOMENTUM..])).norm()) },
    ];
}

/// The channels of a model, its drives and forces, in the order of a row.
pub fn channels<S: Scalar>(model: &Model<S>, drives: &[Drive<S>], forces: &[Force<S>]) -> Vec<Channel> {
    let mut offset = 0;
    let place = |entry: &Entry<S>| {
        let labels: Vec<Vec<String>> =
            entry.dims.iter().map(|dimension| dimension.labels(model, drives, forces)).collect();
        let len = labels.iter().map(Vec::len).product();
        let channel = Channel {
            variable: entry.variable,
            long_name: entry.long_name,
            unit: entry.unit.of(model),
            frame: entry.frame,
            dims: entry.dims.to_vec(),
            labels,
            offset,
            len,
        };
        offset += len;
        channel
    };
    Table::ENTRIES.iter().map(place).collect()
}

/// Appends one row.
pub fn write_row<S: Scalar>(sample: &Sample<'_, S>, out: &mut Vec<S>) {
    for entry in &Table::ENTRIES {
        (entry.write)(sample, out);
    }
}

impl Dimension {
    fn labels<S: Scalar>(self, model: &Model<S>, drives: &[Drive<S>], forces: &[Force<S>]) -> Vec<String> {
        let fixed = |labels: &[&str]| labels.iter().map(|s| (*s).to_owned()).collect();
        match self {
            Body => model.bodies.iter().map(|body| body.name.clone()).collect(),
            Axis => fixed(&["x", "y", "z"]),
            QuaternionDim => fixed(&["w", "x", "y", "z"]),
            Coordinate => {
                let names = model.coordinate_names();
                joint_coordinates(model).map(|c| names[c.index].clone()).collect()
            }
            Joint => model.joints.iter().map(|joint| joint.name.clone()).collect(),
            Component => fixed(&["force_x", "force_y", "force_z", "moment_x", "moment_y", "moment_z"]),
            Point => {
                let names = |body: &crate::model::Body<S>| {
                    body.points.iter().map(|(point, _)| format!("{}.{point}", body.name)).collect::<Vec<_>>()
                };
                model.bodies.iter().flat_map(names).collect()
            }
            Loop => loops::names(model),
            Constraint => model.constraint_names(),
            Hull => forces.iter().filter_map(Force::hull).map(|hull| hull.name.clone()).collect(),
            Line => forces.iter().filter_map(Force::line).map(str::to_owned).collect(),
            Flow => forces.iter().filter_map(Force::flow_load).map(|load| load.name.clone()).collect(),
            Station => {
                forces.iter().filter_map(Force::dynamic_positioning).map(|station| station.name.clone()).collect()
            }
            Thruster => forces.iter().filter_map(Force::dynamic_positioning).flat_map(thruster_names).collect(),
            Planar => fixed(&["surge", "sway", "yaw"]),
            Cylinder => drives.iter().filter_map(Drive::cylinder).map(|cylinder| cylinder.name.clone()).collect(),
        }
    }
}

fn thruster_names<S: Scalar>(station: &DynamicPositioning<S>) -> impl Iterator<Item = String> + '_ {
    station.allocation.thrusters().iter().map(|thruster| format!("{}.{}", station.name, thruster.name))
}

impl Unit {
    fn of<S: Scalar>(&self, model: &Model<S>) -> &'static str {
        match self {
            Plain(unit) => unit,
            By([rotation, translation, both]) => {
                let slides = |c: JointCoordinate<'_, S>| c.motion() == Some(AxisMotion::Translation);
                match (joint_coordinates(model).any(|c| !slides(c)), joint_coordinates(model).any(slides)) {
                    (true, true) => both,
                    (false, true) => translation,
                    _ => rotation,
                }
            }
        }
    }
}

/// A coordinate of a joint that does not float.
struct JointCoordinate<'a, S> {
    node: &'a Node<S>,
    /// The body whose joint it is.
    body: usize,
    /// In v.
    index: usize,
}

impl<S: Scalar> JointCoordinate<'_, S> {
    /// `None` for a spherical joint's.
    fn motion(&self) -> Option<AxisMotion> {
        self.node.kind.axis_motion(self.index - self.node.velocities)
    }
}

fn joint_coordinates<S: Scalar>(model: &Model<S>) -> impl Iterator<Item = JointCoordinate<'_, S>> + '_ {
    let joints = model.tree.nodes.iter().enumerate();
    joints.filter(|(_, node)| !matches!(node.kind, JointKind::Floating(_))).flat_map(|(body, node)| {
        (node.velocities..).take(node.kind.velocity_count()).map(move |index| JointCoordinate { node, body, index })
    })
}

fn each_frame<S: Scalar>(x: &Sample<'_, S>, out: &mut Vec<S>, write: impl Fn(&Frame<S>, &mut Vec<S>)) {
    x.observed.bodies.world.iter().for_each(|frame| write(frame, out));
}

fn angle<S: Scalar>(x: &Sample<'_, S>, out: &mut Vec<S>, which: usize) {
    each_frame(x, out, |frame, out| out.push(roll_pitch_yaw(&frame.rotation)[which]));
}

fn each_coordinate<S: Scalar>(
    x: &Sample<'_, S>,
    out: &mut Vec<S>,
    value: impl Fn(&Sample<'_, S>, JointCoordinate<'_, S>) -> S,
) {
    out.extend(joint_coordinates(x.observed.model).map(|c| value(x, c)));
}

fn each_point<S: Scalar>(
    x: &Sample<'_, S>,
    out: &mut Vec<S>,
    value: impl Fn(&Frame<S>, &Twist<S>, Vector3<S>) -> Vector3<S>,
) {
    let bodies = x.observed.bodies;
    for (i, body) in x.observed.model.bodies.iter().enumerate() {
        for (_, point) in &body.points {
            out.extend(value(&bodies.world[i], &bodies.twist[i], *point).0);
        }
    }
}

fn velocity<S: Scalar>(x: &Sample<'_, S>, out: &mut Vec<S>) {
    let bodies = x.observed.bodies;
    out.extend(bodies.world.iter().zip(&bodies.twist).flat_map(|(frame, twist)| (frame.rotation * twist.linear).0));
}

fn acceleration<S: Scalar>(x: &Sample<'_, S>, out: &mut Vec<S>) {
    let Observation { bodies, inverse, .. } = &x.observed;
    for (i, frame) in bodies.world.iter().enumerate() {
        let twist = &bodies.twist[i];
        let body = inverse.acceleration[i].linear + twist.angular.cross(twist.linear);
        out.extend((frame.rotation * body).0);
    }
}

fn joint_position<S: Scalar>(x: &Sample<'_, S>, c: JointCoordinate<'_, S>) -> S {
    let (q, k) = (&x.q[c.node.positions..], c.index - c.node.velocities);
    match c.node.kind {
        JointKind::Spherical(_) => Quaternion::from_slice(q).log()[k],
        _ => q[k],
    }
}

fn joint_reaction<S: Scalar>(x: &Sample<'_, S>, out: &mut Vec<S>) {
    for (joint, Wrench { moment, force }) in x.observed.model.joints.iter().zip(&x.observed.inverse.joint_wrench) {
        let from_joint_to_centre = joint.kind.to_child();
        out.extend(force.0);
        out.extend((*moment + from_joint_to_centre.cross(*force)).0);
    }
}

fn work_done<S: Scalar>(x: &Sample<'_, S>) -> S {
    x.s[ledger::WORK_BY_DRIVES] + x.s[ledger::WORK_BY_OUTSIDE]
}

fn energy_error<S: Scalar>(x: &Sample<'_, S>) -> S {
    let expected = x.s[ledger::INITIAL_ENERGY] + work_done(x) - x.s[ledger::ENERGY_DISSIPATED];
    x.observed.totals.kinetic_energy + x.observed.totals.potential_energy - expected
}

fn momentum_error<S: Scalar>(x: &Sample<'_, S>) -> S {
    (x.observed.totals.angular_momentum - Vector3::from_slice(&x.s[ledger::ANGULAR_MOMENTUM..])).norm()
}
