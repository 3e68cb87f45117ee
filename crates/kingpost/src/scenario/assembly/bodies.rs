//! Bodies and joints: the tree, inertia, geometry and the initial state.

use crate::elements::free_flooding_tank::assembly as free_flooding_tanks;
use crate::elements::u_tank::assembly as u_tanks;
use crate::elements::{AnyElement, JointDamping};
use crate::model::joint::{AxisList, Fixed, Floating, Prismatic, Revolute, Spherical};
use crate::model::{Axis, BodyDefinition, Joint, JointKind, Model, MotionType, Shape};
use crate::scenario::assembly::axes::{axes, forces_in_axis};
use crate::scenario::assembly::flexible::{ELASTIC_AXES, FlexibleBody, carrier};
use crate::scenario::assembly::{FieldError, known};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, Inertia, Scenario};
use crate::spatial::{Frame, Quaternion, SpatialInertia, Symmetric3, Vector3, rotation_from_roll_pitch_yaw};
use std::collections::HashSet;

/// The model and its initial state.
pub struct Bodies<S> {
    pub model: Model<S>,
    pub q: Vec<S>,
    pub v: Vec<S>,
    /// The forces in the joints.
    pub forces: Vec<AnyElement<S>>,
}

pub fn build<S: Quantity>(scenario: &Scenario<S>) -> Result<Bodies<S>, FieldError> {
    let mut growth = TreeBuilder::default();
    for name in order(scenario)? {
        growth.add(scenario, name)?;
    }
    growth.add_liquids(scenario)?;
    Ok(growth.finish())
}

/// The tree during its construction, parents first.
#[derive(Default)]
struct TreeBuilder<S> {
    descriptions: Vec<BodyDefinition<S>>,
    q: Vec<S>,
    v: Vec<S>,
    forces: Vec<AnyElement<S>>,
    rotors: Vec<(usize, S)>,
}

impl<S: Quantity> TreeBuilder<S> {
    fn add(&mut self, scenario: &Scenario<S>, name: &str) -> Result<(), FieldError> {
        let body = &scenario.bodies[name];
        let flexible = FlexibleBody::read(name, body)?;
        let (parent, parent_centre) = self.parent(scenario, name, body)?;
        let centre = flexible.as_ref().map_or(Vector3(body.centre_of_mass_m), |beam| beam.centre(0));
        let joint = joint(name, body, parent_centre, centre)?;
        self.forces.extend(forces_in_joint(name, body, (self.q.len(), self.v.len()))?);
        for (k, axis) in axes(&body.joint).iter().enumerate() {
            self.rotors.push((self.v.len() + k, axis.rotor_inertia));
        }
        initial(name, body, centre, (&mut self.q, &mut self.v))?;
        match flexible {
            None => {
                let (mass, inertia) = (body.mass_kg.get(), inertia(name, body)?);
                let points =
                    body.points.iter().map(|(name, point)| (name.to_string(), Vector3(point.position_m) - centre));
                let points = points.collect();
                self.descriptions.push(BodyDefinition { name: name.to_owned(), parent, joint, mass, inertia, points });
                Ok(())
            }
            Some(beam) => self.add_beam(body, &beam, parent, joint),
        }
    }

    /// Returns the parent of a body, and the parent's centre of mass in the drawing frame.
    fn parent(
        &self,
        scenario: &Scenario<S>,
        name: &str,
        body: &schema::Body<S>,
    ) -> Result<(Option<usize>, Vector3<S>), FieldError> {
        let Some(parent) = body.parent_body().map(|parent| parent.as_str()) else {
            return Ok((None, Vector3::zero()));
        };
        let index = self.descriptions.iter().position(|description| description.name == parent);
        let field = format!("bodies.{name}.joint.{}.position_m.0", body.joint.kind());
        let (segment, centre) = carrier(scenario, parent, &field, body.joint.place().position_m)?;
        Ok((index.map(|index| index + segment), centre))
    }

    fn add_beam(
        &mut self,
        body: &schema::Body<S>,
        beam: &FlexibleBody<S>,
        parent: Option<usize>,
        joint: Joint<S>,
    ) -> Result<(), FieldError> {
        let points = beam.points(body)?;
        let points = |segment| {
            let there = points.iter().filter(|(carrier, ..)| *carrier == segment);
            there.map(|(_, name, point)| (name.clone(), *point - beam.centre(segment))).collect::<Vec<_>>()
        };
        self.descriptions.push(beam.describe(0, parent, joint, points(0)));
        for segment in 1..=beam.joints() {
            self.forces.extend(beam.forces(self.q.len(), self.v.len()));
            let parent = Some(self.descriptions.len() - 1);
            self.descriptions.push(beam.describe(segment, parent, beam.joint(segment), points(segment)));
            self.q.extend([S::ZERO; ELASTIC_AXES]);
            self.v.extend([S::ZERO; ELASTIC_AXES]);
        }
        Ok(())
    }

    /// Adds the liquid of U-tanks and free-flooding tanks: these bodies are forces in the scenario.
    fn add_liquids(&mut self, scenario: &Scenario<S>) -> Result<(), FieldError> {
        let place = |name: &str| self.descriptions.iter().position(|description| description.name == name);
        let liquids = [u_tanks::bodies(scenario, place)?, free_flooding_tanks::bodies(scenario, place)?];
        for liquid in liquids.into_iter().flatten() {
            self.rotors.push((self.v.len(), liquid.rotor_inertia));
            self.q.push(liquid.position);
            self.v.push(S::ZERO);
            self.descriptions.push(liquid.definition);
        }
        Ok(())
    }

    fn finish(self) -> Bodies<S> {
        let mut model = Model::new(self.descriptions);
        for (coordinate, inertia) in self.rotors {
            model.rotor_inertia[coordinate] = inertia;
        }
        Bodies { model, q: self.q, v: self.v, forces: self.forces }
    }
}

/// Returns the names of the enabled bodies, parents first, otherwise in the order of the file.
fn order<S: Quantity>(scenario: &Scenario<S>) -> Result<Vec<&str>, FieldError> {
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

/// Checks that parents exist and that joint names are unique. Joints of disabled bodies count too: otherwise
/// enabling a body could change the joint that a drive acts on.
fn check_names<S: Quantity>(scenario: &Scenario<S>) -> Result<(), FieldError> {
    let mut joints = HashSet::new();
    for (name, body) in &scenario.bodies {
        if name.as_str() == schema::WORLD {
            return Err(FieldError::new("bodies.world", "world", "another name: world stands for the world itself"));
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

/// Returns the name of a joint: the given one, otherwise the name of its body.
pub fn joint_name<'a, S: Quantity>(body_name: &'a str, body: &'a schema::Body<S>) -> &'a str {
    body.joint.name().map_or(body_name, |name| name.as_str())
}

/// Returns a body and its ancestors up to the world.
fn chain<'a, S: Quantity>(scenario: &'a Scenario<S>, name: &'a str) -> Result<Vec<&'a str>, FieldError> {
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

/// Returns the joint with its geometry moved from the drawing frames to the centres of mass.
fn joint<S: Quantity>(
    name: &str,
    body: &schema::Body<S>,
    parent_centre: Vector3<S>,
    centre: Vector3<S>,
) -> Result<Joint<S>, FieldError> {
    let joint = &body.joint;
    let schema::JointPlace { position_m, child_position_m, orientation_rad } = joint.place();
    let placement = Frame {
        rotation: rotation_from_roll_pitch_yaw(Vector3(orientation_rad)),
        position: Vector3(position_m) - parent_centre,
    };
    let to_child = centre - Vector3(child_position_m);
    let direction = |k: usize| Vector3(joint.directions()[k].1.get()).direction();
    let modes: Vec<MotionType> = axes(joint).iter().map(|axis| axis.mode).collect();
    let mut mode = modes.first().copied().unwrap_or(MotionType::Free);
    check_perpendicular(name, joint)?;
    let kind = match joint {
        schema::Joint::Floating(joint) => {
            if body.parent_body().is_some() {
                let field = format!("bodies.{name}.parent");
                return Err(FieldError::new(field, &body.parent, "world, for a body with a floating joint"));
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
            if body.parent_body().is_some() {
                let field = format!("bodies.{name}.parent");
                return Err(FieldError::new(field, &body.parent, "world, for a body that moves with the waves"));
            }
            JointKind::AxisList(AxisList::six_axes(placement, to_child).with_modes(&modes))
        }
        schema::Joint::Spherical(joint) => {
            mode = if joint.held { MotionType::Held } else { MotionType::Free };
            JointKind::Spherical(Spherical::new(placement, to_child))
        }
        schema::Joint::Fixed(_) => JointKind::Fixed(Fixed::new(placement, to_child)),
    };
    Ok(Joint { name: joint_name(name, body).to_owned(), kind, mode })
}

/// Largest deviation of two directions from a right angle, rad: the rounding of six written digits.
const NEARLY_PERPENDICULAR: f64 = 1e-5;

/// Returns an error unless both directions of a joint with two directions are perpendicular.
fn check_perpendicular<S: Quantity>(name: &str, joint: &schema::Joint<S>) -> Result<(), FieldError> {
    let [(first, one), (second, other)] = joint.directions()[..] else { return Ok(()) };
    let cosine = Vector3(one.get()).direction().dot(Vector3(other.get()).direction());
    let Some(cosine) = cosine.outside(|cosine| cosine.abs() <= NEARLY_PERPENDICULAR) else { return Ok(()) };
    let degrees = libm::acos(cosine.clamp(-1.0, 1.0)).to_degrees();
    let found = format!("a direction {degrees:.4} degrees from {first}");
    let field = format!("bodies.{name}.joint.{}.{second}", joint.kind());
    Err(FieldError::new(field, found, format!("one perpendicular to {first}")))
}

/// Returns the forces in the joint of a body whose coordinates are the next ones in q and v.
fn forces_in_joint<S: Quantity>(
    name: &str,
    body: &schema::Body<S>,
    (positions, velocities): (usize, usize),
) -> Result<Vec<AnyElement<S>>, FieldError> {
    let joint = &body.joint;
    let path = format!("bodies.{name}.joint.{}", joint.kind());
    let mut forces: Vec<AnyElement<S>> = Vec::new();
    for (k, axis) in axes(joint).iter().enumerate() {
        forces.extend(forces_in_axis((joint_name(name, body), &path), axis, (positions + k, velocities + k))?);
    }
    if let schema::Joint::Spherical(ball) = joint {
        let damping = ball.damping_n_m_s.get();
        if !damping.vanishes() {
            let about = |k| -> AnyElement<S> { Box::new(JointDamping { coordinate: velocities + k, damping }) };
            forces.extend((0..3).map(about));
        }
    }
    Ok(forces)
}

/// Appends the joint's entries of q and v. Prescribed rates are set by their drive. `centre` is the centre of mass in the
/// drawing frame.
fn initial<S: Quantity>(
    name: &str,
    body: &schema::Body<S>,
    centre: Vector3<S>,
    (q, v): (&mut Vec<S>, &mut Vec<S>),
) -> Result<(), FieldError> {
    let field = |rest: &str| format!("bodies.{name}.joint.{}.{rest}", body.joint.kind());
    let at_rest = |rest: &str, rate: S, free: bool| {
        if free || rate.all(|rate| rate == 0.0) {
            return Ok(rate);
        }
        Err(FieldError::new(field(rest), rate, "0, for a coordinate that is held or prescribed"))
    };
    match &body.joint {
        schema::Joint::Floating(joint) => {
            let initial = &joint.initial;
            q.extend(initial_position(name, initial, centre)?.0);
            q.extend(Quaternion::from_roll_pitch_yaw(Vector3(initial.orientation_rad)).0);
            for rate in initial.velocity_m_s {
                v.push(at_rest("initial.velocity_m_s", rate, !joint.hold_translation)?);
            }
            for rate in initial.angular_velocity_rad_s {
                v.push(at_rest("initial.angular_velocity_rad_s", rate, !joint.hold_rotation)?);
            }
        }
        schema::Joint::Spherical(joint) => {
            q.extend(Quaternion::from_roll_pitch_yaw(Vector3(joint.initial_orientation_rad)).0);
            for rate in joint.initial_angular_velocity_rad_s {
                v.push(at_rest("initial_angular_velocity_rad_s", rate, !joint.held)?);
            }
        }
        joint => {
            for axis in axes(joint) {
                q.push(axis.initial);
                v.push(at_rest(&axis.rate_field(), axis.initial_rate, axis.mode == MotionType::Free)?);
            }
        }
    }
    Ok(())
}

/// Returns the position of the centre of mass of a floating body at the start.
fn initial_position<S: Quantity>(
    name: &str,
    initial: &schema::InitialMotion<S>,
    centre: Vector3<S>,
) -> Result<Vector3<S>, FieldError> {
    let Some(origin) = initial.drawing_frame_m else { return Ok(Vector3(initial.position_m)) };
    if !initial.position_m.into_iter().all(S::vanishes) {
        let [x, y, z] = initial.position_m;
        let field = format!("bodies.{name}.joint.floating.initial.position_m");
        return Err(FieldError::new(field, format!("[{x}, {y}, {z}]"), "none beside drawing_frame_m"));
    }
    Ok(Vector3(origin) + rotation_from_roll_pitch_yaw(Vector3(initial.orientation_rad)) * centre)
}

/// Returns the inertia about the centre of mass: the given one, otherwise that of the shape.
fn inertia<S: Quantity>(name: &str, body: &schema::Body<S>) -> Result<SpatialInertia<S>, FieldError> {
    let mass = body.mass_kg.get();
    let (moments, field) = match (&body.inertia, &body.shape) {
        (Some(Inertia::Tensor(given)), _) => {
            let mut moments = Symmetric3::diagonal(given.moments_kg_m2.map(|moment| moment.get()));
            [moments.xy, moments.xz, moments.yz] = given.products_kg_m2;
            (moments, "inertia.tensor.moments_kg_m2")
        }
        (Some(Inertia::RadiiOfGyration(given)), _) => {
            let radii = given.radii_m.map(|radius| radius.get());
            (Symmetric3::diagonal(radii.map(|radius| mass * radius * radius)), "inertia.radii_of_gyration.radii_m")
        }
        (None, Some(shape)) => return Ok(SpatialInertia::rigid(mass, solid(shape).inertia(mass))),
        (None, None) => {
            let allowed = "a shape, or an inertia";
            return Err(FieldError::new(format!("bodies.{name}"), "neither shape nor inertia", allowed));
        }
    };
    let Symmetric3 { xx, xy, xz, yy, yz, zz } = moments;
    let [sound] = S::from_values([xx, xy, xz, yy, yz, zz], &|[xx, xy, xz, yy, yz, zz]| {
        [f64::from(Symmetric3 { xx, xy, xz, yy, yz, zz }.holds_triangle_inequality())]
    });
    if !sound.all(|sound| sound == 1.0) {
        let (found, allowed) = match &body.inertia {
            Some(Inertia::RadiiOfGyration(given)) => {
                let [x, y, z] = given.radii_m.map(|radius| radius.get());
                (
                    format!("radii {x}, {y}, {z} m"),
                    "those of a real body: no square of a radius greater than the sum of the other two",
                )
            }
            _ => (
                format!("moments {xx}, {yy}, {zz} kg m^2 with products {xy}, {xz}, {yz}"),
                "those of a real body: no principal moment greater than the sum of the other two",
            ),
        };
        return Err(FieldError::new(format!("bodies.{name}.{field}"), found, allowed));
    }
    Ok(SpatialInertia::rigid(mass, moments))
}

/// Converts a shape of the scenario to the engine's type.
fn solid<S: Quantity>(shape: &schema::Shape<S>) -> Shape<S> {
    match shape {
        schema::Shape::Box(given) => {
            Shape::Box { edges_m: [given.length_m, given.width_m, given.height_m].map(|edge| edge.get()) }
        }
        schema::Shape::Cylinder(given) => {
            Shape::Cylinder { radius_m: given.radius_m.get(), length_m: given.length_m.get(), axis: axis(given.axis) }
        }
        schema::Shape::Sphere(given) => Shape::Sphere { radius_m: given.radius_m.get() },
        schema::Shape::Point(_) => Shape::Point,
    }
}

/// Converts an axis of the scenario to the engine's type.
pub(crate) fn axis(given: schema::PrincipalAxis) -> Axis {
    match given {
        schema::PrincipalAxis::X => Axis::X,
        schema::PrincipalAxis::Y => Axis::Y,
        schema::PrincipalAxis::Z => Axis::Z,
    }
}
