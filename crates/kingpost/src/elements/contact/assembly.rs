//! Contacts: their shapes, and the check that a load does not start inside its surface.

use crate::dynamics::LinkKinematics;
use crate::elements::contact::{ContactSolid, Facing, Friction, Spot, dissipation};
use crate::elements::ropes::assembly::at_start::at_rest;
use crate::elements::{AnyElement, Contact, of_kind, of_kind_mut};
use crate::model::{Attachment, Model};
use crate::scenario::assembly::assemble::{Assemble, Surroundings};
use crate::scenario::assembly::attachments::attachment;
use crate::scenario::assembly::bodies::axis;
use crate::scenario::assembly::rigid_bodies::rigid;
use crate::scenario::assembly::{FieldError, known};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, LoadShape, Scenario, SurfaceShape};
use crate::simulation::Setup;
use crate::spatial::{Vector3, rotation_from_roll_pitch_yaw};

/// Largest number of points of one load.
const MOST_POINTS: usize = 64;

/// Smallest restitution: below it the rebound is not visible.
const LEAST_RESTITUTION: f64 = 0.1;

/// Bulge of a cylinder's ends, as a share of its radius.
const BULGE: f64 = 0.02;

impl<S: Quantity> Assemble<S> for schema::Contact<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        Ok(build(at.scenario, name, self, at.model)?.into_iter().collect())
    }
}

/// One contact, if it is enabled and both bodies exist.
fn build<S: Quantity>(
    scenario: &Scenario<S>,
    name: &str,
    given: &schema::Contact<S>,
    model: &Model<S>,
) -> Result<Option<AnyElement<S>>, FieldError> {
    let field = |rest: &str| format!("forces.{name}.contact.{rest}");
    let schema::Contact { load, surface, .. } = given;
    check_bodies(scenario, given, &field)?;
    if !given.restitution.get().all(|e| e >= LEAST_RESTITUTION) {
        let allowed = format!("a number from {LEAST_RESTITUTION} to 1");
        return Err(FieldError::new(field("restitution"), given.restitution, allowed));
    }
    let (spots, solids) = shapes(load, surface, &field)?;
    let place = |which: &str, body: &schema::Name, position_m: [S; 3], orientation_rad: [S; 3]| {
        let pin = schema::Pin { body: body.clone(), position_m };
        if pin.named_body().is_some_and(|body| model.body(body).is_none()) {
            return Ok(None);
        }
        let at = attachment(scenario, model, &field(&format!("{which}.position_m")), &pin)?;
        let rotation = rotation_from_roll_pitch_yaw(Vector3(orientation_rad));
        Ok(Some(Attachment { in_body: crate::spatial::Frame { rotation, ..at.in_body }, ..at }))
    };
    let of_load = place("load", &load.body, load.position_m, load.orientation_rad)?;
    let of_surface = place("surface", &surface.body, surface.position_m, surface.orientation_rad)?;
    let (Some(of_load), Some(of_surface), true) = (of_load, of_surface, given.enabled) else { return Ok(None) };
    let stiffness = given.stiffness_n_per_m.get();
    let coefficient = given.friction_coefficient.get();
    let along = given.friction_stiffness_n_per_m.map_or(stiffness, |along| along.get());
    Ok(Some(Box::new(Contact {
        name: name.to_owned(),
        sides: [of_load, of_surface],
        anchors: vec![Vector3::zero(); spots.len()],
        spots,
        solids,
        stiffness,
        dissipation: dissipation(given.restitution.get(), given.restitution_speed_m_s.get()),
        friction: (!coefficient.vanishes()).then_some(Friction { coefficient, stiffness: along }),
        tolerance: given.penetration_tolerance_m.get(),
        settles: false,
    })))
}

/// Checks that both bodies exist, are rigid and are different.
fn check_bodies<S: Quantity>(
    scenario: &Scenario<S>,
    given: &schema::Contact<S>,
    field: &impl Fn(&str) -> String,
) -> Result<(), FieldError> {
    let (load, surface) = (&given.load.body, &given.surface.body);
    rigid(scenario, field("load.body"), load)?;
    let bodies = scenario.bodies.keys().map(|body| body.as_str());
    known(&field("surface.body"), surface, bodies.chain([schema::WORLD]))?;
    if scenario.bodies.contains_key(surface) {
        rigid(scenario, field("surface.body"), surface)?;
    }
    if load == surface {
        let allowed = format!("another body than load.body, {load}");
        return Err(FieldError::new(field("surface.body"), surface, allowed));
    }
    Ok(())
}

type Shapes<S> = (Vec<(Facing, Spot<S>)>, [Option<ContactSolid<S>>; 2]);

/// Returns the spots of both sides and the solids that they touch.
fn shapes<S: Quantity>(
    load: &schema::ContactLoad<S>,
    surface: &schema::ContactSurface<S>,
    field: &impl Fn(&str) -> String,
) -> Result<Shapes<S>, FieldError> {
    let half = |given: &schema::BoxShape<S>| {
        [given.length_m, given.width_m, given.height_m].map(|edge| edge.get() * S::constant(0.5))
    };
    let ball = |centre: Vector3<S>, radius: S| Spot::Ball { centre, radius };
    let own = match &load.shape {
        LoadShape::Box(given) => corners(half(given)).map(|corner| ball(corner, S::ZERO)).collect(),
        LoadShape::Sphere(given) => vec![ball(Vector3::zero(), given.radius_m.get())],
        LoadShape::Cylinder(given) => ends(given, &field("load.shape.cylinder.length_m"))?,
        LoadShape::Points(given) => {
            let found = given.positions_m.len();
            if !(1..=MOST_POINTS).contains(&found) {
                let allowed = format!("1 to {MOST_POINTS} points");
                return Err(FieldError::new(
                    field("load.shape.points.positions_m"),
                    format!("{found} points"),
                    allowed,
                ));
            }
            given.positions_m.iter().map(|point| ball(Vector3(*point), S::ZERO)).collect()
        }
    };
    let solid = match &load.shape {
        LoadShape::Box(given) => Some(ContactSolid::Box { half: half(given) }),
        LoadShape::Cylinder(given) => {
            let (radius, half_length) = (given.radius_m.get(), given.length_m.get() * S::constant(0.5));
            Some(ContactSolid::Cylinder { radius, half_length, axis: axis(given.axis) })
        }
        LoadShape::Sphere(_) | LoadShape::Points(_) => None,
    };
    let of_load = |spots: Vec<Spot<S>>| spots.into_iter().map(|spot| (Facing::Load, spot));
    Ok(match (&surface.shape, &load.shape) {
        (SurfaceShape::Plane(given), _) => {
            let normal = Vector3(given.normal.get()).direction();
            (of_load(own).collect(), [None, Some(ContactSolid::Plane { normal })])
        }
        (SurfaceShape::Box(_), LoadShape::Cylinder(_)) => {
            let allowed = "box, sphere or points, on a box: a cylinder touches planes and spheres";
            return Err(FieldError::new(field("load.shape"), load.shape.kind(), allowed));
        }
        (SurfaceShape::Box(given), _) => {
            let half = half(given);
            // A ball touches edges and corners by its own distance function; feet have no solid.
            let theirs =
                corners(half).filter(|_| solid.is_some()).map(|corner| (Facing::Surface, ball(corner, S::ZERO)));
            (of_load(own).chain(theirs).collect(), [solid, Some(ContactSolid::Box { half })])
        }
        (SurfaceShape::Sphere(given), LoadShape::Sphere(_) | LoadShape::Points(_)) => {
            (of_load(own).collect(), [None, Some(ContactSolid::Sphere { radius: given.radius_m.get() })])
        }
        (SurfaceShape::Sphere(given), _) => {
            (vec![(Facing::Surface, ball(Vector3::zero(), given.radius_m.get()))], [solid, None])
        }
    })
}

fn corners<S: Quantity>(half: [S; 3]) -> impl Iterator<Item = Vector3<S>> {
    (0..8).map(move |k| Vector3(core::array::from_fn(|i| if k >> i & 1 == 0 { -half[i] } else { half[i] })))
}

/// Returns both ends of a cylinder, which must be longer than their bulges.
fn ends<S: Quantity>(given: &schema::CylinderShape<S>, field: &str) -> Result<Vec<Spot<S>>, FieldError> {
    let (radius, bulge) = (given.radius_m.get(), given.radius_m.get() * S::constant(BULGE));
    let middle = given.length_m.get() * S::constant(0.5) - bulge;
    if !middle.all(|middle| middle >= 0.0) {
        let allowed = format!("at least {}, {} of the radius", bulge + bulge, 2.0 * BULGE);
        return Err(FieldError::new(field, given.length_m, allowed));
    }
    let mut along = Vector3::zero();
    along[axis(given.axis) as usize] = S::ONE;
    let end = |centre: Vector3<S>| Spot::End { centre, axis: along, radius, bulge };
    Ok(vec![end(along * middle), end(-(along * middle))])
}

/// Sets the bristles straight at the start of a run, with loops closed.
///
/// # Errors
/// A load that penetrates its surface by more than the tolerance.
pub fn begin<S: Quantity>(setup: &mut Setup<S>) -> Result<(), FieldError> {
    let Setup { model, world, elements, q, v, .. } = setup;
    let mut links = LinkKinematics::new(model);
    links.update(model, q, v);
    at_rest(world, model, &links, (q, v), |at| {
        of_kind_mut::<S, Contact<S>>(elements).try_for_each(|contact| {
            contact.begin_at(at);
            check_depth(contact, contact.depth(at), "where the run begins")
        })
    })
}

/// Checks that a load at rest is no deeper than the tolerance.
pub fn check_rest(setup: &Setup) -> Result<(), FieldError> {
    let Setup { model, world, elements, q, v, .. } = setup;
    let mut links = LinkKinematics::new(model);
    links.update(model, q, v);
    at_rest(world, model, &links, (q, v), |at| {
        of_kind::<f64, Contact>(elements)
            .try_for_each(|contact| check_depth(contact, contact.depth(at), "at rest: make the contact stiffer"))
    })
}

fn check_depth<S: Quantity>(contact: &Contact<S>, depth: S, place: &str) -> Result<(), FieldError> {
    if (depth - contact.tolerance).all(|beyond| beyond <= 0.0) {
        return Ok(());
    }
    let field = format!("forces.{}.contact.load", contact.name);
    let allowed = format!("at most its penetration_tolerance_m, {} m, {place}", contact.tolerance);
    Err(FieldError::new(field, format!("a load {depth:.4} m inside its surface"), allowed))
}
