//! Bodies and joints: the tree, inertia, geometry and the initial state.

use super::super::schema::{self, Inertia, Scenario};
use super::axes::{axes, forces_in_axis};
use super::flexible::{ELASTIC_AXES, FlexibleBody, carrier};
use super::reading::{Gathered, Reading};
use super::{FieldError, known};
use crate::elements::{AnyElement, JointDamping};
use crate::model::joint::{AxisList, Fixed, Floating, Prismatic, Revolute, Spherical};
use crate::model::{Axis, BodyDescription, Joint, JointKind, Mode, Model, Shape};
use crate::spatial::{Frame, Quaternion, SpatialInertia, Symmetric3, Vector3, rotation_from_roll_pitch_yaw};
use std::collections::HashSet;

/// The model and where it begins.
pub struct Bodies<S> {
    pub model: Model<S>,
    pub q: Vec<S>,
    pub v: Vec<S>,
    /// What acts in the joints.
    pub forces: Vec<AnyElement<S>>,
}

pub fn build<S: Gathered>(scenario: &Reading<Scenario>) -> Result<Bodies<S>, FieldError> {
    let mut growth = Growth::default();
    for name in order(scenario.first())? {
        growth.add(scenario, name)?;
    }
    Ok(growth.finish())
}

/// The tree while it grows, parents first.
#[derive(Default)]
struct Growth<S> {
    descriptions: Vec<BodyDescription<S>>,
    q: Vec<S>,
    v: Vec<S>,
    forces: Vec<AnyElement<S>>,
    rotors: Vec<(usize, S)>,
}

impl<S: Gathered> Growth<S> {
    fn add(&mut self, scenario: &Reading<Scenario>, name: &str) -> Result<(), FieldError> {
        let body = scenario.part(|scenario| &scenario.bodies[name]);
        let flexible = FlexibleBody::read(name, &body)?;
        let (parent, parent_centre) = self.parent(scenario, body.first());
        let centre = flexible.as_ref().map_or_else(|| body.vector(|body| body.centre_of_mass_m), |beam| beam.centre(0));
        let joint = joint(name, &body, parent_centre, centre)?;
        self.forces.extend(forces_in_joint(name, &body, (self.q.len(), self.v.len()))?);
        for k in 0..axes(&body.first().joint).len() {
            self.rotors.push((self.v.len() + k, body.number(|body| axes(&body.joint)[k].rotor_inertia)));
        }
        initial(name, &body, &mut self.q, &mut self.v)?;
        match flexible {
            None => {
                let (mass, inertia) = (body.number(|body| body.mass_kg.get()), inertia(name, &body)?);
                let points = points(&body, centre, |_| true);
                self.descriptions.push(BodyDescription { name: name.to_owned(), parent, joint, mass, inertia, points });
            }
            Some(beam) => self.add_beam(&body, &beam, parent, joint),
        }
        Ok(())
    }

    /// The body that a body hangs on, and its centre of mass in the drawing frame.
    fn parent(&self, scenario: &Reading<Scenario>, body: &schema::Body) -> (Option<usize>, Vector3<S>) {
        let Some(parent) = body.parent_body().map(|parent| parent.as_str()) else { return (None, Vector3::zero()) };
        let index = self.descriptions.iter().position(|description| description.name == parent);
        let (segment, centre) = carrier(scenario, parent, body.joint.place().position_m);
        (index.map(|index| index + segment), centre)
    }

    fn add_beam(
        &mut self,
        body: &Reading<schema::Body>,
        beam: &FlexibleBody<S>,
        parent: Option<usize>,
        joint: Joint<S>,
    ) {
        let points = |segment| points(body, beam.centre(segment), |place| beam.segment_at(place) == segment);
        self.descriptions.push(beam.describe(0, parent, joint, points(0)));
        for segment in 1..=beam.joints() {
            self.forces.extend(beam.forces(self.q.len(), self.v.len()));
            let parent = Some(self.descriptions.len() - 1);
            self.descriptions.push(beam.describe(segment, parent, beam.joint(segment), points(segment)));
            self.q.extend([S::ZERO; ELASTIC_AXES]);
            self.v.extend([S::ZERO; ELASTIC_AXES]);
        }
    }

    fn finish(self) -> Bodies<S> {
        let mut model = Model::new(self.descriptions);
        for (coordinate, inertia) in self.rotors {
            model.rotor_inertia[coordinate] = inertia;
        }
        Bodies { model, q: self.q, v: self.v, forces: self.forces }
    }
}

/// The named points of a body that lie where they should, from a centre of mass.
fn points<S: Gathered>(
    body: &Reading<schema::Body>,
    centre: Vector3<S>,
    lies_there: impl Fn([f64; 3]) -> bool,
) -> Vec<(String, Vector3<S>)> {
    let there = body.first().points.iter().filter(|(_, point)| lies_there(point.position_m));
    there.map(|(name, _)| (name.to_string(), body.vector(|body| body.points[name].position_m) - centre)).collect()
}

/// Names of the bodies that are there, parents first, otherwise in the order of the file.
fn order(scenario: &Scenario) -> Result<Vec<&str>, FieldError> {
    check_names(scenario)?;
    let (mut order, mut placed) = (Vec::new(), HashSet::new());
    for name in scenario.bodies.keys() {
        let chain = chain(scenario, name)?;
        if chain.iter().all(|link| scenario.bodies[*link].enabled) {
            order.extend(chain.into_iter().rev().filter(|link| placed.insert(*link)));
        }
    }
    if order.is_empty() {
        return Err(FieldError::new("bodies", "no body that is enabled", "at least one"));
    }
    Ok(order)
}

/// Parents exist; joints have names of their own, those of bodies that are not enabled too, so that
/// a drive never changes its joint with a switch.
fn check_names(scenario: &Scenario) -> Result<(), FieldError> {
    let mut joints = HashSet::new();
    for (name, body) in &scenario.bodies {
        if name.as_str() == schema::WORLD {
            return Err(FieldError::new("bodies.world", "world", "another name: the world is what bodies stand on"));
        }
        if let Some(parent) = body.parent_body() {
            let others = scenario.bodies.keys().filter(|other| *other != name).map(|other| other.as_str());
            known(&format!("bodies.{name}.parent"), parent, others.chain([schema::WORLD]))?;
        }
        let joint = joint_name(name, body);
        if !joints.insert(joint) {
            let field = format!("bodies.{name}.joint.{}.name", body.joint.kind());
            return Err(FieldError::new(field, joint, "a name that no other joint has"));
        }
    }
    Ok(())
}

/// A joint without a name has that of its body.
pub fn joint_name<'a>(body_name: &'a str, body: &'a schema::Body) -> &'a str {
    body.joint.name().map_or(body_name, |name| name.as_str())
}

/// A body and its ancestors up to the world.
fn chain<'a>(scenario: &'a Scenario, name: &'a str) -> Result<Vec<&'a str>, FieldError> {
    let (mut chain, mut seen) = (vec![name], HashSet::from([name]));
    while let Some(parent) = scenario.bodies[chain[chain.len() - 1]].parent_body() {
        chain.push(parent);
        if !seen.insert(parent.as_str()) {
            let allowed = "a chain of parents that ends at the world";
            return Err(FieldError::new(format!("bodies.{name}.parent"), chain.join(" -> "), allowed));
        }
    }
    Ok(chain)
}

/// The joint with its geometry moved from the drawing frames to the centres of mass.
fn joint<S: Gathered>(
    name: &str,
    body: &Reading<schema::Body>,
    parent_centre: Vector3<S>,
    centre: Vector3<S>,
) -> Result<Joint<S>, FieldError> {
    let joint = body.part(|body| &body.joint);
    let placement = Frame {
        rotation: rotation_from_roll_pitch_yaw(joint.vector(|joint| joint.place().orientation_rad)),
        position: joint.vector(|joint| joint.place().position_m) - parent_centre,
    };
    let to_child = centre - joint.vector(|joint| joint.place().child_position_m);
    let direction = |k: usize| joint.vector(|joint| joint.directions()[k].1.get()).direction();
    let modes: Vec<Mode> = axes(joint.first()).iter().map(|axis| axis.mode).collect();
    let mut mode = modes.first().copied().unwrap_or(Mode::Free);
    check_perpendicular(name, joint.first())?;
    let kind = match joint.first() {
        schema::Joint::Floating(joint) => {
            if body.first().parent_body().is_some() {
                let field = format!("bodies.{name}.parent");
                return Err(FieldError::new(field, &body.first().parent, "world, for a body with a floating joint"));
            }
            let (hold_translation, hold_rotation) = (joint.hold_translation, joint.hold_rotation);
            JointKind::Floating(Floating { hold_translation, hold_rotation })
        }
        schema::Joint::Revolute(_) => JointKind::Revolute(Revolute::new(placement, direction(0), to_child)),
        schema::Joint::Prismatic(_) => JointKind::Prismatic(Prismatic::new(placement, direction(0), to_child)),
        schema::Joint::Cylindrical(_) => {
            JointKind::AxisList(AxisList::cylindrical(placement, direction(0), to_child).with_modes(&modes))
        }
        schema::Joint::Universal(_) => {
            let universal = AxisList::universal(placement, direction(0), direction(1), to_child);
            JointKind::AxisList(universal.with_modes(&modes))
        }
        schema::Joint::Planar(_) => {
            let planar = AxisList::planar(placement, direction(0), direction(1), to_child);
            JointKind::AxisList(planar.with_modes(&modes))
        }
        schema::Joint::MovedByWaves(_) => {
            if body.first().parent_body().is_some() {
                let field = format!("bodies.{name}.parent");
                return Err(FieldError::new(
                    field,
                    &body.first().parent,
                    "world, for a body that moves with the waves",
                ));
            }
            JointKind::AxisList(AxisList::six_axes(placement, to_child).with_modes(&modes))
        }
        schema::Joint::Spherical(joint) => {
            mode = if joint.held { Mode::Held } else { Mode::Free };
            JointKind::Spherical(Spherical::new(placement, to_child))
        }
        schema::Joint::Fixed(_) => JointKind::Fixed(Fixed::new(placement, to_child)),
    };
    Ok(Joint { name: joint_name(name, body.first()).to_owned(), kind, mode })
}

/// How far two directions may be from a right angle, rad: what six written digits leave.
const NEARLY_PERPENDICULAR: f64 = 1e-5;

/// An error unless the two directions of a joint that has two are perpendicular.
fn check_perpendicular(name: &str, joint: &schema::Joint) -> Result<(), FieldError> {
    let [(first, one), (second, other)] = joint.directions()[..] else { return Ok(()) };
    let cosine = Vector3(one.unit()).dot(Vector3(other.unit()));
    if cosine.abs() <= NEARLY_PERPENDICULAR {
        return Ok(());
    }
    let degrees = libm::acos(cosine.clamp(-1.0, 1.0)).to_degrees();
    let found = format!("a direction {degrees:.4} degrees from {first}");
    let field = format!("bodies.{name}.joint.{}.{second}", joint.kind());
    Err(FieldError::new(field, found, format!("one perpendicular to {first}")))
}

fn floating(body: &schema::Body) -> Option<&schema::FloatingJoint> {
    if let schema::Joint::Floating(joint) = &body.joint { Some(joint) } else { None }
}

fn spherical(body: &schema::Body) -> Option<&schema::SphericalJoint> {
    if let schema::Joint::Spherical(joint) = &body.joint { Some(joint) } else { None }
}

/// What acts in the joint of a body whose coordinates come next in q and v.
fn forces_in_joint<S: Gathered>(
    name: &str,
    body: &Reading<schema::Body>,
    (positions, velocities): (usize, usize),
) -> Result<Vec<AnyElement<S>>, FieldError> {
    let joint = body.part(|body| &body.joint);
    let path = format!("bodies.{name}.joint.{}", joint.first().kind());
    let mut forces: Vec<AnyElement<S>> = Vec::new();
    for k in 0..axes(joint.first()).len() {
        forces.extend(forces_in_axis(&path, &joint, k, (positions + k, velocities + k))?);
    }
    if let schema::Joint::Spherical(_) = joint.first() {
        let ball = body.kind(spherical);
        if ball.any_nonzero(|ball| ball.damping_n_m_s.get()) {
            let damping = ball.number(|ball| ball.damping_n_m_s.get());
            let about = |k| -> AnyElement<S> { Box::new(JointDamping { coordinate: velocities + k, damping }) };
            forces.extend((0..3).map(about));
        }
    }
    Ok(forces)
}

/// Appends the joint's entries of q and v. Prescribed rates are set by their drive.
fn initial<S: Gathered>(
    name: &str,
    body: &Reading<schema::Body>,
    q: &mut Vec<S>,
    v: &mut Vec<S>,
) -> Result<(), FieldError> {
    let field = |rest: &str| format!("bodies.{name}.joint.{}.{rest}", body.first().joint.kind());
    let at_rest = |rest: &str, rate: S, free: bool| {
        if free || rate.all(|rate| rate == 0.0) {
            return Ok(rate);
        }
        Err(FieldError::new(field(rest), rate.value(), "0, for a coordinate that is held or prescribed"))
    };
    match &body.first().joint {
        schema::Joint::Floating(joint) => {
            let initial = body.kind(floating).part(|joint| &joint.initial);
            q.extend(initial.vector::<S>(|initial| initial.position_m).0);
            let orientation = initial.vector(|initial| initial.orientation_rad);
            q.extend(Quaternion::<S>::from_roll_pitch_yaw(orientation).0);
            for rate in initial.numbers(|initial| initial.velocity_m_s) {
                v.push(at_rest("initial.velocity_m_s", rate, !joint.hold_translation)?);
            }
            for rate in initial.numbers(|initial| initial.angular_velocity_rad_s) {
                v.push(at_rest("initial.angular_velocity_rad_s", rate, !joint.hold_rotation)?);
            }
        }
        schema::Joint::Spherical(joint) => {
            let ball = body.kind(spherical);
            let orientation = ball.vector(|ball| ball.initial_orientation_rad);
            q.extend(Quaternion::<S>::from_roll_pitch_yaw(orientation).0);
            for rate in ball.numbers(|ball| ball.initial_angular_velocity_rad_s) {
                v.push(at_rest("initial_angular_velocity_rad_s", rate, !joint.held)?);
            }
        }
        joint => {
            for (k, axis) in axes(joint).iter().enumerate() {
                q.push(body.number(|body| axes(&body.joint)[k].initial));
                let rate = body.number(|body| axes(&body.joint)[k].initial_rate);
                v.push(at_rest(&axis.rate_field(), rate, axis.mode == Mode::Free)?);
            }
        }
    }
    Ok(())
}

/// Inertia about the centre of mass: the given one, else the shape's.
fn inertia<S: Gathered>(name: &str, body: &Reading<schema::Body>) -> Result<SpatialInertia<S>, FieldError> {
    let mass: S = body.number(|body| body.mass_kg.get());
    let (moments, field) = match (&body.first().inertia, &body.first().shape) {
        (Some(Inertia::Tensor(_)), _) => {
            let given = body.kind(tensor);
            let moments = given.numbers(|tensor| tensor.moments_kg_m2.map(|moment| moment.get()));
            let mut moments = Symmetric3::diagonal(moments);
            [moments.xy, moments.xz, moments.yz] = given.numbers(|tensor| tensor.products_kg_m2);
            (moments, "inertia.tensor.moments_kg_m2")
        }
        (Some(Inertia::RadiiOfGyration(_)), _) => {
            let given = body.kind(radii);
            let radii: [S; 3] = given.numbers(|given| given.radii_m.map(|radius| radius.get()));
            (Symmetric3::diagonal(radii.map(|radius| mass * radius * radius)), "inertia.radii_of_gyration.radii_m")
        }
        (None, Some(_)) => {
            let shape = body.kind(|body| body.shape.as_ref());
            return Ok(SpatialInertia::rigid(mass, solid(&shape).inertia(mass)));
        }
        (None, None) => {
            let allowed = "a shape, or an inertia";
            return Err(FieldError::new(format!("bodies.{name}"), "neither shape nor inertia", allowed));
        }
    };
    if !moments.values().holds_triangle_inequality() {
        let Symmetric3 { xx, xy, xz, yy, yz, zz } = moments.values();
        let found = format!("moments {xx}, {yy}, {zz} kg m^2 with products {xy}, {xz}, {yz}");
        let allowed = "a body's: no principal moment greater than the sum of the other two";
        return Err(FieldError::new(format!("bodies.{name}.{field}"), found, allowed));
    }
    Ok(SpatialInertia::rigid(mass, moments))
}

fn tensor(body: &schema::Body) -> Option<&schema::InertiaTensor> {
    if let Some(Inertia::Tensor(tensor)) = &body.inertia { Some(tensor) } else { None }
}

fn radii(body: &schema::Body) -> Option<&schema::RadiiOfGyration> {
    if let Some(Inertia::RadiiOfGyration(radii)) = &body.inertia { Some(radii) } else { None }
}

/// The shape in the engine's terms.
fn solid<S: Gathered>(shape: &Reading<schema::Shape>) -> Shape<S> {
    match shape.first() {
        schema::Shape::Box(_) => {
            let cuboid = shape.kind(|shape| if let schema::Shape::Box(cuboid) = shape { Some(cuboid) } else { None });
            Shape::Box { edges_m: cuboid.numbers(|c| [c.length_m, c.width_m, c.height_m].map(|edge| edge.get())) }
        }
        schema::Shape::Cylinder(first) => {
            let cylinder =
                shape.kind(|shape| if let schema::Shape::Cylinder(given) = shape { Some(given) } else { None });
            let [radius_m, length_m] = cylinder.numbers(|given| [given.radius_m.get(), given.length_m.get()]);
            let axis = match first.axis {
                schema::PrincipalAxis::X => Axis::X,
                schema::PrincipalAxis::Y => Axis::Y,
                schema::PrincipalAxis::Z => Axis::Z,
            };
            Shape::Cylinder { radius_m, length_m, axis }
        }
        schema::Shape::Sphere(_) => {
            let sphere = shape.kind(|shape| if let schema::Shape::Sphere(given) = shape { Some(given) } else { None });
            Shape::Sphere { radius_m: sphere.number(|given| given.radius_m.get()) }
        }
        schema::Shape::Point(_) => Shape::Point,
    }
}
