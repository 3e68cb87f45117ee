//! Bodies and joints: the tree, inertia, geometry and the initial state.

use super::super::schema::{self, Inertia, PrismaticMode, RevoluteMode, Scenario};
use super::{FieldError, known};
use crate::model::joint::{Fixed, Floating, Prismatic, Revolute};
use crate::model::{Axis, BodyDescription, Joint, JointKind, Mode, Model, Shape};
use crate::spatial::{Frame, Quaternion, SpatialInertia, Symmetric3, Vector3, rotation_from_roll_pitch_yaw};
use std::collections::HashSet;

/// The model and where it begins.
pub struct Bodies {
    pub model: Model,
    pub q: Vec<f64>,
    pub v: Vec<f64>,
    /// Coordinate and damping of every joint that has some.
    pub dampings: Vec<(usize, f64)>,
}

pub fn build(scenario: &Scenario) -> Result<Bodies, FieldError> {
    let order = order(scenario)?;
    let mut descriptions: Vec<BodyDescription> = Vec::with_capacity(order.len());
    let (mut q, mut v, mut dampings) = (Vec::new(), Vec::new(), Vec::new());
    for name in order {
        let body = &scenario.bodies[name];
        let parent = body.parent_body().map(|parent| parent.as_str());
        let parent_index = parent.and_then(|parent| descriptions.iter().position(|d| d.name == parent));
        let parent_centre = parent.map_or(Vector3::zero(), |parent| Vector3(scenario.bodies[parent].centre_of_mass_m));
        let joint = joint(name, body, parent_centre)?;
        if let Some(damping) = damping(&body.joint) {
            dampings.push((v.len(), damping));
        }
        initial(name, body, &mut q, &mut v)?;
        let centre = Vector3(body.centre_of_mass_m);
        let point =
            |(name, point): (&schema::Name, &schema::Point)| (name.to_string(), Vector3(point.position_m) - centre);
        descriptions.push(BodyDescription {
            name: name.to_owned(),
            parent: parent_index,
            joint,
            mass: body.mass_kg.get(),
            inertia: inertia(name, body)?,
            points: body.points.iter().map(point).collect(),
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
fn joint(name: &str, body: &schema::Body, parent_centre: Vector3) -> Result<Joint, FieldError> {
    let placement = |position: [f64; 3], orientation: [f64; 3]| Frame {
        rotation: rotation_from_roll_pitch_yaw(Vector3(orientation)),
        position: Vector3(position) - parent_centre,
    };
    let to_child = |child_position: [f64; 3]| Vector3(body.centre_of_mass_m) - Vector3(child_position);
    let (kind, mode) = match &body.joint {
        schema::Joint::Floating(joint) => {
            if body.parent_body().is_some() {
                let field = format!("bodies.{name}.parent");
                return Err(FieldError::new(field, &body.parent, "world, for a body with a floating joint"));
            }
            let (hold_translation, hold_rotation) = (joint.hold_translation, joint.hold_rotation);
            (JointKind::Floating(Floating { hold_translation, hold_rotation }), Mode::Free)
        }
        schema::Joint::Revolute(joint) => {
            let mode = match joint.mode {
                RevoluteMode::Free => Mode::Free,
                RevoluteMode::Held => Mode::Held,
                RevoluteMode::Prescribed(_) => Mode::Prescribed,
            };
            let placement = placement(joint.position_m, joint.orientation_rad);
            let revolute = Revolute::new(placement, Vector3(joint.axis.unit()), to_child(joint.child_position_m));
            (JointKind::Revolute(revolute), mode)
        }
        schema::Joint::Prismatic(joint) => {
            let mode = match joint.mode {
                PrismaticMode::Free => Mode::Free,
                PrismaticMode::Held => Mode::Held,
                PrismaticMode::Prescribed(_) => Mode::Prescribed,
            };
            let placement = placement(joint.position_m, joint.orientation_rad);
            let prismatic = Prismatic::new(placement, Vector3(joint.axis.unit()), to_child(joint.child_position_m));
            (JointKind::Prismatic(prismatic), mode)
        }
        schema::Joint::Fixed(joint) => {
            let placement = placement(joint.position_m, joint.orientation_rad);
            (JointKind::Fixed(Fixed::new(placement, to_child(joint.child_position_m))), Mode::Free)
        }
    };
    Ok(Joint { name: joint_name(name, body).to_owned(), kind, mode })
}

fn damping(joint: &schema::Joint) -> Option<f64> {
    let damping = match joint {
        schema::Joint::Revolute(joint) => joint.damping_n_m_s.get(),
        schema::Joint::Prismatic(joint) => joint.damping_n_s_m.get(),
        schema::Joint::Floating(_) | schema::Joint::Fixed(_) => 0.0,
    };
    (damping > 0.0).then_some(damping)
}

/// Appends the joint's entries of q and v. Prescribed rates are set by their drive.
fn initial(name: &str, body: &schema::Body, q: &mut Vec<f64>, v: &mut Vec<f64>) -> Result<(), FieldError> {
    let field = |rest: &str| format!("bodies.{name}.joint.{}.{rest}", body.joint.kind());
    let at_rest = |rest: &str, rate: f64, free: bool| {
        if free || rate == 0.0 {
            return Ok(rate);
        }
        Err(FieldError::new(field(rest), rate, "0, for a coordinate that is held or prescribed"))
    };
    match &body.joint {
        schema::Joint::Floating(joint) => {
            let initial = &joint.initial;
            q.extend(initial.position_m);
            q.extend(Quaternion::from_matrix(&rotation_from_roll_pitch_yaw(Vector3(initial.orientation_rad))).0);
            for rate in initial.velocity_m_s {
                v.push(at_rest("initial.velocity_m_s", rate, !joint.hold_translation)?);
            }
            for rate in initial.angular_velocity_rad_s {
                v.push(at_rest("initial.angular_velocity_rad_s", rate, !joint.hold_rotation)?);
            }
        }
        schema::Joint::Revolute(joint) => {
            q.push(joint.initial_angle_rad);
            let free = joint.mode == RevoluteMode::Free;
            v.push(at_rest("initial_rate_rad_s", joint.initial_rate_rad_s, free)?);
        }
        schema::Joint::Prismatic(joint) => {
            q.push(joint.initial_extension_m);
            let free = joint.mode == PrismaticMode::Free;
            v.push(at_rest("initial_speed_m_s", joint.initial_speed_m_s, free)?);
        }
        schema::Joint::Fixed(_) => {}
    }
    Ok(())
}

/// Inertia about the centre of mass: the given one, else the shape's.
fn inertia(name: &str, body: &schema::Body) -> Result<SpatialInertia, FieldError> {
    let mass = body.mass_kg.get();
    let (moments, field) = match (&body.inertia, &body.shape) {
        (Some(Inertia::Tensor(tensor)), _) => {
            let mut moments = Symmetric3::diagonal(tensor.moments_kg_m2.map(|moment| moment.get()));
            [moments.xy, moments.xz, moments.yz] = tensor.products_kg_m2;
            (moments, "inertia.tensor.moments_kg_m2")
        }
        (Some(Inertia::RadiiOfGyration(radii)), _) => {
            let moments = radii.radii_m.map(|radius| mass * radius.get() * radius.get());
            (Symmetric3::diagonal(moments), "inertia.radii_of_gyration.radii_m")
        }
        (None, Some(shape)) => return Ok(SpatialInertia::rigid(mass, solid(shape).inertia(mass))),
        (None, None) => {
            let allowed = "a shape, or an inertia";
            return Err(FieldError::new(format!("bodies.{name}"), "neither shape nor inertia", allowed));
        }
    };
    if !moments.holds_triangle_inequality() {
        let Symmetric3 { xx, xy, xz, yy, yz, zz } = moments;
        let found = format!("moments {xx}, {yy}, {zz} kg m^2 with products {xy}, {xz}, {yz}");
        let allowed = "a body's: no principal moment greater than the sum of the other two";
        return Err(FieldError::new(format!("bodies.{name}.{field}"), found, allowed));
    }
    Ok(SpatialInertia::rigid(mass, moments))
}

/// The shape in the engine's terms.
pub fn solid(shape: &schema::Shape) -> Shape {
    match shape {
        schema::Shape::Box(cuboid) => {
            Shape::Box { edges_m: [cuboid.length_m, cuboid.width_m, cuboid.height_m].map(|edge| edge.get()) }
        }
        schema::Shape::Cylinder(cylinder) => Shape::Cylinder {
            radius_m: cylinder.radius_m.get(),
            length_m: cylinder.length_m.get(),
            axis: match cylinder.axis {
                schema::PrincipalAxis::X => Axis::X,
                schema::PrincipalAxis::Y => Axis::Y,
                schema::PrincipalAxis::Z => Axis::Z,
            },
        },
        schema::Shape::Sphere(sphere) => Shape::Sphere { radius_m: sphere.radius_m.get() },
        schema::Shape::Point(_) => Shape::Point,
    }
}
