//! The registry of result channels: names, units, frames and dimensions.
//!
//! Channels of the model and of the ledger are in one table; those of the elements follow from their [`Layout`].

mod channels;
mod loops;
mod readings;

pub use channels::{Channel, Channels};
use channels::{column_by, common, short_name};
pub use readings::Readings;

use crate::elements::{Components, VectorFrame, WRENCH};
use crate::ledger;
use crate::model::{AxisMotion, JointKind, Model, Node};
use crate::plant::Observation;
use crate::scalar::Scalar;
use crate::spatial::{Frame, Quaternion, Twist, Vector3, Wrench, roll_pitch_yaw};
use core::marker::PhantomData;

/// Inputs for the computation of a row.
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
    description: &'static str,
    unit: Unit,
    frame: VectorFrame,
    dims: &'static [Dimension],
    /// Whether the channel depends on positions and velocities only.
    of_motion: bool,
    write: fn(&Sample<'_, S>, &mut Vec<S>),
}

/// A dimension of the model's channels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Dimension {
    /// Bodies by name.
    Body,
    /// x, y, z.
    Axis,
    /// w, x, y, z of a unit quaternion.
    Quaternion,
    /// Coordinates of all joints except floating ones.
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
}

enum Unit {
    Plain(&'static str),
    /// Units of a force and a moment, for their components.
    Wrench,
    /// Units of a rotational and of a translational coordinate.
    Coordinate([&'static str; 2]),
    /// Units of a constraint on an angle and of one on a length.
    Constraint([&'static str; 2]),
}

use Dimension::{Axis, Body, Component, Constraint, Coordinate, Joint, Loop, Point, Quaternion as QuaternionDim};
use Unit::{Constraint as ByConstraint, Coordinate as By, Plain, Wrench as ForceAndMoment};
use VectorFrame::{Body as InBody, Joint as InJoint, Loop as InLoop, None as Number, World};

struct Table<S>(PhantomData<S>);

#[rustfmt::skip]
impl<S: Scalar> Table<S> {
    /// Every channel of the model: the single source of names, units and frames.
    const OF_MODEL: &[Entry<S>] = &[
        Entry { variable: "time", description: "time", unit: Plain("s"), frame: Number, dims: &[], of_motion: true, write: |x, out| out.push(S::constant(x.time_s)) },
        Entry { variable: "position", description: "position of the centre of mass", unit: Plain("m"), frame: World, dims: &[Body, Axis], of_motion: true,
            write: |x, out| each_frame(x, out, |frame, out| out.extend(frame.position.0)) },
        Entry { variable: "orientation", description: "unit quaternion from body to world axes", unit: Plain("1"), frame: World, dims: &[Body, QuaternionDim], of_motion: true,
            write: |x, out| each_frame(x, out, |frame, out| out.extend(Quaternion::from_matrix(&frame.rotation).0)) },
        Entry { variable: "roll", description: "roll angle, positive port side up", unit: Plain("rad"), frame: World, dims: &[Body], of_motion: true, write: |x, out| angle(x, out, 0) },
        Entry { variable: "pitch", description: "pitch angle, positive bow down", unit: Plain("rad"), frame: World, dims: &[Body], of_motion: true, write: |x, out| angle(x, out, 1) },
        Entry { variable: "yaw", description: "yaw angle, positive bow to port", unit: Plain("rad"), frame: World, dims: &[Body], of_motion: true, write: |x, out| angle(x, out, 2) },
        Entry { variable: "velocity", description: "velocity of the centre of mass", unit: Plain("m/s"), frame: World, dims: &[Body, Axis], of_motion: true, write: velocity },
        Entry { variable: "angular_velocity", description: "angular velocity: roll, pitch and yaw rate", unit: Plain("rad/s"), frame: InBody, dims: &[Body, Axis], of_motion: true,
            write: |x, out| out.extend(x.observed.bodies.twist.iter().flat_map(|twist| twist.angular.0)) },
        Entry { variable: "acceleration", description: "acceleration of the centre of mass", unit: Plain("m/s^2"), frame: World, dims: &[Body, Axis], of_motion: false, write: acceleration },
        Entry { variable: "joint_position", description: "joint angle or extension; the rotation vector of a spherical joint", unit: By(["rad", "m"]), frame: Number, dims: &[Coordinate], of_motion: true,
            write: |x, out| each_coordinate(x, out, joint_position) },
        Entry { variable: "joint_velocity", description: "joint rate; the angular velocity of a spherical joint in child axes", unit: By(["rad/s", "m/s"]), frame: Number, dims: &[Coordinate], of_motion: true,
            write: |x, out| each_coordinate(x, out, |x, c| x.v[c.index]) },
        Entry { variable: "joint_force", description: "force or moment that the joint carries along its coordinate: drive, friction, hold", unit: By(["N m", "N"]), frame: Number,
            dims: &[Coordinate], of_motion: false, write: |x, out| each_coordinate(x, out, |x, c| x.observed.inverse.joint_wrench[c.body].dot(&x.observed.bodies.columns[c.index])) },
        Entry { variable: "joint_reaction", description: "wrench of the joint on the child, at the joint, in the child's axes, drive included", unit: ForceAndMoment, frame: InJoint,
            dims: &[Joint, Component], of_motion: false, write: joint_reaction },
        Entry { variable: "loop_reaction", description: "wrench of the loop on its second body, at the second attachment, in the axes of the first", unit: ForceAndMoment, frame: InLoop,
            dims: &[Loop, Component], of_motion: false, write: loops::reaction },
        Entry { variable: "loop_error", description: "error of a constraint; for an angle, its sine", unit: ByConstraint(["rad", "m"]), frame: Number, dims: &[Constraint], of_motion: false,
            write: loops::error },
        Entry { variable: "point_position", description: "position of a named point", unit: Plain("m"), frame: World, dims: &[Point, Axis], of_motion: true,
            write: |x, out| each_point(x, out, |frame, _, p| frame.point(p)) },
        Entry { variable: "point_velocity", description: "velocity of a named point", unit: Plain("m/s"), frame: World, dims: &[Point, Axis], of_motion: true,
            write: |x, out| each_point(x, out, |frame, twist, p| frame.rotation * (twist.linear + twist.angular.cross(p))) },
    ];

    /// Energy and momentum, and their expected values.
    const OF_LEDGER: &[Entry<S>] = &[
        Entry { variable: "kinetic_energy", description: "kinetic energy, the water's part included", unit: Plain("J"), frame: Number, dims: &[], of_motion: false, write: |x, out| out.push(x.observed.totals.kinetic_energy) },
        Entry { variable: "potential_energy", description: "potential energy", unit: Plain("J"), frame: Number, dims: &[], of_motion: false, write: |x, out| out.push(x.observed.totals.potential_energy) },
        Entry { variable: "work_done", description: "work done by drives and by everything outside", unit: Plain("J"), frame: Number, dims: &[], of_motion: false, write: |x, out| out.push(work_done(x)) },
        Entry { variable: "work_by_drives", description: "work by drives", unit: Plain("J"), frame: Number, dims: &[], of_motion: false, write: |x, out| out.push(x.s[ledger::WORK_BY_DRIVES]) },
        Entry { variable: "work_by_outside", description: "work by everything outside, without potential energy", unit: Plain("J"), frame: Number, dims: &[], of_motion: false, write: |x, out| out.push(x.s[ledger::WORK_BY_OUTSIDE]) },
        Entry { variable: "energy_dissipated", description: "energy turned into heat", unit: Plain("J"), frame: Number, dims: &[], of_motion: false, write: |x, out| out.push(x.s[ledger::ENERGY_DISSIPATED]) },
        Entry { variable: "linear_momentum", description: "linear momentum", unit: Plain("kg m/s"), frame: World, dims: &[Axis], of_motion: false, write: |x, out| out.extend(x.observed.totals.linear_momentum.0) },
        Entry { variable: "angular_momentum", description: "angular momentum about the world's origin, or the held centre", unit: Plain("N m s"), frame: World, dims: &[Axis], of_motion: false,
            write: |x, out| out.extend(x.observed.totals.angular_momentum.0) },
        Entry { variable: "energy_error", description: "energy less its balance: initial energy plus work less heat", unit: Plain("J"), frame: Number, dims: &[], of_motion: false, write: |x, out| out.push(energy_error(x)) },
        Entry { variable: "momentum_error", description: "length of the angular momentum less its balance", unit: Plain("N m s"), frame: Number, dims: &[], of_motion: false, write: |x, out| out.push(momentum_error(x)) },
        Entry { variable: "linear_momentum_error", description: "length of the linear momentum less its balance", unit: Plain("kg m/s"), frame: Number, dims: &[], of_motion: false,
            write: |x, out| out.push((x.observed.totals.linear_momentum - Vector3::from_slice(&x.s[ledger::LINEAR_MOMENTUM..])).norm()) },
        Entry { variable: "energy_scale", description: "energy in play, the scale of the energy error by its largest value so far: the root of the squares of kinetic energy and work done", unit: Plain("J"), frame: Number,
            dims: &[], of_motion: false, write: |x, out| out.push(energy_scale(x)) },
        Entry { variable: "momentum_scale", description: "angular momentum in play, the scale of the momentum error by its largest value so far: the root of the squares of the total and of each body's about its own centre",
            unit: Plain("N m s"), frame: Number, dims: &[], of_motion: false, write: |x, out| out.push(momentum_scale(x)) },
    ];
}

impl<S: Scalar> Entry<S> {
    fn channel(&self, model: &Model<S>) -> Channel {
        let labels: Vec<Vec<String>> = self.dims.iter().map(|dimension| dimension.labels(model)).collect();
        let columns = self.columns(&labels);
        let units = self.unit.of_columns(model, columns.len());
        let dims: Vec<String> = self.dims.iter().map(|dimension| dimension.name().to_owned()).collect();
        Channel {
            variable: self.variable,
            long_name: short_name(self.description),
            description: self.description,
            unit: common(&units),
            units,
            frame: self.frame,
            column: column_by(self.variable, &dims, self.thing_leads()),
            dims,
            labels,
            len: columns.len(),
            columns,
            along: None,
            of_elements: false,
            offset: 0,
        }
    }

    fn thing_leads(&self) -> bool {
        self.dims.first().is_some_and(|dimension| dimension.names_things())
    }

    /// Returns the names of the columns: labels of bodies and elements precede the variable, labels of
    /// components follow it.
    fn columns(&self, labels: &[Vec<String>]) -> Vec<String> {
        let leads = self.thing_leads();
        let mut columns = vec![if leads { String::new() } else { self.variable.to_owned() }];
        for (k, along) in labels.iter().enumerate() {
            let with = |head: &String, label: &String| match k {
                0 if leads => format!("{label}.{}", self.variable),
                _ => format!("{head}.{label}"),
            };
            columns = columns.iter().flat_map(|head| along.iter().map(move |label| with(head, label))).collect();
        }
        columns
    }
}

impl Dimension {
    fn name(self) -> &'static str {
        match self {
            Body => "body",
            Axis => "axis",
            QuaternionDim => "quaternion",
            Coordinate => "coordinate",
            Joint => "joint",
            Component => "component",
            Point => "point",
            Loop => "loop",
            Constraint => "constraint",
        }
    }

    fn names_things(self) -> bool {
        !matches!(self, Axis | QuaternionDim | Component)
    }

    fn labels<S: Scalar>(self, model: &Model<S>) -> Vec<String> {
        let fixed = |labels: &[&str]| labels.iter().map(|s| (*s).to_owned()).collect();
        match self {
            Body => model.bodies.iter().map(|body| body.name.clone()).collect(),
            Axis => fixed(Components::Axis.labels().unwrap_or_default()),
            QuaternionDim => fixed(&["w", "x", "y", "z"]),
            Coordinate => {
                let names = model.coordinate_names();
                joint_coordinates(model).map(|c| names[c.index].clone()).collect()
            }
            Joint => model.joints.iter().map(|joint| joint.name.clone()).collect(),
            Component => fixed(Components::Wrench.labels().unwrap_or_default()),
            Point => {
                let names = |body: &crate::model::Body<S>| {
                    body.points.iter().map(|(point, _)| format!("{}.{point}", body.name)).collect::<Vec<_>>()
                };
                model.bodies.iter().flat_map(names).collect()
            }
            Loop => loops::names(model),
            Constraint => model.constraint_names(),
        }
    }
}

impl Unit {
    /// Returns the unit of each column.
    fn of_columns<S: Scalar>(&self, model: &Model<S>, columns: usize) -> Vec<&'static str> {
        match self {
            Plain(unit) => vec![unit; columns],
            ForceAndMoment => WRENCH.iter().copied().cycle().take(columns).collect(),
            By([turns, slides]) => joint_coordinates(model)
                .map(|c| if c.motion() == Some(AxisMotion::Translation) { *slides } else { *turns })
                .collect(),
            ByConstraint([angle, length]) => {
                let constraints = model.loops.iter().flat_map(|closed| &closed.constraints);
                let turns = |(_, constraint): &(String, crate::model::Constraint<S>)| {
                    matches!(constraint, crate::model::Constraint::Perpendicular { .. })
                };
                constraints.map(|constraint| if turns(constraint) { *angle } else { *length }).collect()
            }
        }
    }
}

/// A coordinate of a joint that is not floating.
struct JointCoordinate<'a, S> {
    node: &'a Node<S>,
    /// The body of the joint.
    body: usize,
    /// Index in v.
    index: usize,
}

impl<S: Scalar> JointCoordinate<'_, S> {
    /// Rotation or translation; `None` for a spherical joint.
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

/// Returns a smooth scale of energy, so that it has derivatives: the root of the sum of the squares of both
/// energies.
fn energy_scale<S: Scalar>(x: &Sample<'_, S>) -> S {
    Vector3::new(x.observed.totals.kinetic_energy, work_done(x), S::ZERO).norm()
}

/// Returns a smooth scale of momentum: the root of the squares of the total angular momentum and of that of each body
/// about its own centre.
fn momentum_scale<S: Scalar>(x: &Sample<'_, S>) -> S {
    let Observation { model, bodies, .. } = &x.observed;
    let spin = |(node, twist): (&Node<S>, &Twist<S>)| {
        let turning = Twist { angular: twist.angular, linear: Vector3::zero() };
        node.inertia.times(&turning).moment.norm()
    };
    let spins = model.tree.nodes.iter().zip(&bodies.twist).map(spin);
    spins.fold(x.observed.totals.angular_momentum.norm(), |sum, spin| Vector3::new(sum, spin, S::ZERO).norm())
}
