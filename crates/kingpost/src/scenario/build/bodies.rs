//! Bodies and joints: the tree, inertia, geometry and the initial state.

use super::super::schema::{self, Inertia, PrismaticMode, RevoluteMode, Scenario};
use super::reading::{Gathered, Reading};
use super::{FieldError, known};
use crate::model::joint::{Fixed, Floating, Prismatic, Revolute};
use crate::model::{Axis, BodyDescription, Joint, JointKind, Mode, Model, Shape};
use crate::spatial::{Frame, Quaternion, SpatialInertia, Symmetric3, Vector3, rotation_from_roll_pitch_yaw};
use std::collections::HashSet;

/// The model and where it begins.
pub struct Bodies<S> {
    pub model: Model<S>,
    pub q: Vec<S>,
    pub v: Vec<S>,
    /// Coordinate and damping of every joint that has some.
    pub dampings: Vec<(usize, S)>,
}

pub fn build<S: Gathered>(scenario: &Reading<Scenario>) -> Result<Bodies<S>, FieldError> {
    let order = order(scenario.first())?;
    let mut descriptions: Vec<BodyDescription<S>> = Vec::with_capacity(order.len());
    let (mut q, mut v, mut dampings) = (Vec::new(), Vec::new(), Vec::new());
    for name in order {
        let body = scenario.part(|scenario| &scenario.bodies[name]);
        let parent = body.first().parent_body().map(|parent| parent.as_str());
        let parent_index = parent.and_then(|parent| descriptions.iter().position(|d| d.name == parent));
        let parent_centre = parent
            .map_or(Vector3::zero(), |parent| scenario.vector(|scenario| scenario.bodies[parent].centre_of_mass_m));
        let joint = joint(name, &body, parent_centre)?;
        if let Some(damping) = damping(&body) {
            dampings.push((v.len(), damping));
        }
        initial(name, &body, &mut q, &mut v)?;
        let centre: Vector3<S> = body.vector(|body| body.centre_of_mass_m);
        let point =
            |point: &schema::Name| (point.to_string(), body.vector(|body| body.points[point].position_m) - centre);
        descriptions.push(BodyDescription {
            name: name.to_owned(),
            parent: parent_index,
            joint,
            mass: body.number(|body| body.mass_kg.get()),
            inertia: inertia(name, &body)?,
            points: body.first().points.keys().map(point).collect(),
        });
    }
    Ok(Bodies { model: Model::new(descriptions), q, v, dampings })
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
) -> Result<Joint<S>, FieldError> {
    let centre: Vector3<S> = body.vector(|body| body.centre_of_mass_m);
    let placement = |position: Vector3<S>, orientation: Vector3<S>| Frame {
        rotation: rotation_from_roll_pitch_yaw(orientation),
        position: position - parent_centre,
    };
    let (kind, mode) = match &body.first().joint {
        schema::Joint::Floating(joint) => {
            if body.first().parent_body().is_some() {
                let field = format!("bodies.{name}.parent");
                return Err(FieldError::new(field, &body.first().parent, "world, for a body with a floating joint"));
            }
            let (hold_translation, hold_rotation) = (joint.hold_translation, joint.hold_rotation);
            (JointKind::Floating(Floating { hold_translation, hold_rotation }), Mode::Free)
        }
        schema::Joint::Revolute(_) => {
            let joint = body.kind(revolute);
            let mode = match joint.first().mode {
                RevoluteMode::Free => Mode::Free,
                RevoluteMode::Held => Mode::Held,
                RevoluteMode::Prescribed(_) => Mode::Prescribed,
            };
            let placement = placement(joint.vector(|j| j.position_m), joint.vector(|j| j.orientation_rad));
            let to_child = centre - joint.vector(|j| j.child_position_m);
            let axis = joint.vector(|j| j.axis.get()).direction();
            (JointKind::Revolute(Revolute::new(placement, axis, to_child)), mode)
        }
        schema::Joint::Prismatic(_) => {
            let joint = body.kind(prismatic);
            let mode = match joint.first().mode {
                PrismaticMode::Free => Mode::Free,
                PrismaticMode::Held => Mode::Held,
                PrismaticMode::Prescribed(_) => Mode::Prescribed,
            };
            let placement = placement(joint.vector(|j| j.position_m), joint.vector(|j| j.orientation_rad));
            let to_child = centre - joint.vector(|j| j.child_position_m);
            let axis = joint.vector(|j| j.axis.get()).direction();
            (JointKind::Prismatic(Prismatic::new(placement, axis, to_child)), mode)
        }
        schema::Joint::Fixed(_) => {
            let joint = body.kind(fixed);
            let placement = placement(joint.vector(|j| j.position_m), joint.vector(|j| j.orientation_rad));
            let to_child = centre - joint.vector(|j| j.child_position_m);
            (JointKind::Fixed(Fixed::new(placement, to_child)), Mode::Free)
        }
    };
    Ok(Joint { name: joint_name(name, body.first()).to_owned(), kind, mode })
}

fn revolute(body: &schema::Body) -> Option<&schema::RevoluteJoint> {
    if let schema::Joint::Revolute(joint) = &body.joint { Some(joint) } else { None }
}

fn prismatic(body: &schema::Body) -> Option<&schema::PrismaticJoint> {
    if let schema::Joint::Prismatic(joint) = &body.joint { Some(joint) } else { None }
}

fn floating(body: &schema::Body) -> Option<&schema::FloatingJoint> {
    if let schema::Joint::Floating(joint) = &body.joint { Some(joint) } else { None }
}

fn fixed(body: &schema::Body) -> Option<&schema::FixedJoint> {
    if let schema::Joint::Fixed(joint) = &body.joint { Some(joint) } else { None }
}

fn damping<S: Gathered>(body: &Reading<schema::Body>) -> Option<S> {
    let damping = |body: &schema::Body| match &body.joint {
        schema::Joint::Revolute(joint) => joint.damping_n_m_s.get(),
        schema::Joint::Prismatic(joint) => joint.damping_n_s_m.get(),
        schema::Joint::Floating(_) | schema::Joint::Fixed(_) => 0.0,
    };
    body.any_nonzero(damping).then(|| body.number(damping))
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
        schema::Joint::Revolute(first) => {
            let joint = body.kind(revolute);
            q.push(joint.number(|joint| joint.initial_angle_rad));
            let rate = joint.number(|joint| joint.initial_rate_rad_s);
            v.push(at_rest("initial_rate_rad_s", rate, first.mode == RevoluteMode::Free)?);
        }
        schema::Joint::Prismatic(first) => {
            let joint = body.kind(prismatic);
            q.push(joint.number(|joint| joint.initial_extension_m));
            let rate = joint.number(|joint| joint.initial_speed_m_s);
            v.push(at_rest("initial_speed_m_s", rate, first.mode == PrismaticMode::Free)?);
        }
        schema::Joint::Fixed(_) => {}
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
