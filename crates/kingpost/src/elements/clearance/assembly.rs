//! Clearances and air gaps: their points, and the solids from which the distance is measured.

use crate::elements::contact::ContactSolid;
use crate::elements::{AirGap, AnyElement, Clearance};
use crate::model::{Attachment, Model};
use crate::scenario::assembly::assemble::{Assemble, Surroundings};
use crate::scenario::assembly::attachments::attachment;
use crate::scenario::assembly::bodies::axis;
use crate::scenario::assembly::rigid_bodies::rigid;
use crate::scenario::assembly::{FieldError, known};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, ClearanceShape, LocalName, Name, Pin, Scenario, WORLD};
use crate::scenario::wording::one_of_with_hint;
use crate::spatial::{Frame, Vector3, rotation_from_roll_pitch_yaw};

impl<S: Quantity> Assemble<S> for schema::Clearance<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        let field = |rest: &str| format!("sensors.{name}.clearance.{rest}");
        let Self { first, second, .. } = self;
        let of_first = pin(at.scenario, &field("first"), &first.body, first.point.as_ref(), first.position_m)?;
        let of_second = pin(at.scenario, &field("second"), &second.body, second.point.as_ref(), second.position_m)?;
        let bends = at.scenario.bodies.get(&first.body).is_some_and(|body| body.flexible.is_some());
        if first.body == second.body && !bends {
            let allowed = format!("another body than first.body, {}", first.body);
            return Err(FieldError::new(field("second.body"), &second.body, allowed));
        }
        let solid = solid(at.scenario, &field("second"), second)?;
        let (Some(point), Some(place), true) = (
            place(at.scenario, at.model, &field("first"), &of_first)?,
            place(at.scenario, at.model, &field("second"), &of_second)?,
            self.enabled,
        ) else {
            return Ok(Vec::new());
        };
        let rotation = rotation_from_roll_pitch_yaw(Vector3(second.orientation_rad));
        let position = if is_own(second) { Vector3::zero() } else { place.in_body.position };
        let place = Attachment { in_body: Frame { rotation, position }, ..place };
        Ok(vec![Box::new(Clearance { name: name.to_owned(), point, place, solid })])
    }
}

impl<S: Quantity> Assemble<S> for schema::AirGap<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        let field = format!("sensors.{name}.air_gap");
        let pin = pin(at.scenario, &field, &self.body, self.point.as_ref(), self.position_m)?;
        let Some(point) = place(at.scenario, at.model, &field, &pin)?.filter(|_| self.enabled) else {
            return Ok(Vec::new());
        };
        Ok(vec![Box::new(AirGap { name: name.to_owned(), point })])
    }
}

/// Returns a point as its attachment to a body, if the body exists.
fn pin<S: Quantity>(
    scenario: &Scenario<S>,
    field: &str,
    body: &Name,
    point: Option<&LocalName>,
    position_m: [S; 3],
) -> Result<Pin<S>, FieldError> {
    known(&format!("{field}.body"), body, scenario.bodies.keys().map(|body| body.as_str()).chain([WORLD]))?;
    let Some(point) = point else { return Ok(Pin { body: body.clone(), position_m }) };
    let points = scenario.bodies.get(body).map(|body| &body.points);
    let Some(named) = points.and_then(|points| points.get(point.as_str())) else {
        let names: Vec<&str> = points.into_iter().flatten().map(|(name, _)| name.as_str()).collect();
        let allowed = match names.as_slice() {
            [] => format!("none: {body} has no points"),
            names => one_of_with_hint(names, point),
        };
        return Err(FieldError::new(format!("{field}.point"), point, allowed));
    };
    let position_m = core::array::from_fn(|k| named.position_m[k] + position_m[k]);
    Ok(Pin { body: body.clone(), position_m })
}

/// Returns its attachment in the model; `None` if the body does not exist.
fn place<S: Quantity>(
    scenario: &Scenario<S>,
    model: &Model<S>,
    field: &str,
    pin: &Pin<S>,
) -> Result<Option<Attachment<S>>, FieldError> {
    if pin.named_body().is_some_and(|body| model.body(body).is_none()) {
        return Ok(None);
    }
    attachment(scenario, model, &format!("{field}.position_m"), pin).map(Some)
}

fn is_own<S>(given: &schema::ClearanceFrom<S>) -> bool {
    matches!(given.shape, Some(ClearanceShape::Own))
}

/// Returns the solid from which the clearance is measured; a point is a sphere of radius 0.
fn solid<S: Quantity>(
    scenario: &Scenario<S>,
    field: &str,
    given: &schema::ClearanceFrom<S>,
) -> Result<ContactSolid<S>, FieldError> {
    let Some(shape) = &given.shape else { return Ok(ContactSolid::Sphere { radius: S::ZERO }) };
    if scenario.bodies.contains_key(&given.body) {
        rigid(scenario, format!("{field}.body"), &given.body)?;
    }
    Ok(match shape {
        ClearanceShape::Own => own(scenario, field, given)?,
        ClearanceShape::Plane(given) => ContactSolid::Plane { normal: Vector3(given.normal.get()).direction() },
        ClearanceShape::Box(given) => of_box(given),
        ClearanceShape::Cylinder(given) => of_cylinder(given),
        ClearanceShape::Sphere(given) => ContactSolid::Sphere { radius: given.radius_m.get() },
    })
}

/// The shape of the body itself, on its centre of mass.
fn own<S: Quantity>(
    scenario: &Scenario<S>,
    field: &str,
    given: &schema::ClearanceFrom<S>,
) -> Result<ContactSolid<S>, FieldError> {
    let is_placed = |numbers: &[S; 3]| !numbers.iter().all(|number| number.vanishes());
    for (name, placed) in [
        ("point", given.point.is_some()),
        ("position_m", is_placed(&given.position_m)),
        ("orientation_rad", is_placed(&given.orientation_rad)),
    ] {
        if placed {
            let allowed = "none: a body's own shape is centred on its centre of mass";
            return Err(FieldError::new(format!("{field}.{name}"), "a place", allowed));
        }
    }
    match scenario.bodies.get(&given.body).and_then(|body| body.shape.as_ref()) {
        Some(schema::Shape::Box(given)) => Ok(of_box(given)),
        Some(schema::Shape::Cylinder(given)) => Ok(of_cylinder(given)),
        Some(schema::Shape::Sphere(given)) => Ok(ContactSolid::Sphere { radius: given.radius_m.get() }),
        Some(schema::Shape::Point(_)) | None => {
            let found = format!("own, but {} is not a solid", given.body);
            Err(FieldError::new(format!("{field}.shape"), found, "plane, box, cylinder or sphere, with its fields"))
        }
    }
}

fn of_box<S: Quantity>(given: &schema::BoxShape<S>) -> ContactSolid<S> {
    let edges = [given.length_m, given.width_m, given.height_m];
    ContactSolid::Box { half: edges.map(|edge| edge.get() * S::constant(0.5)) }
}

fn of_cylinder<S: Quantity>(given: &schema::CylinderShape<S>) -> ContactSolid<S> {
    let (radius, half_length) = (given.radius_m.get(), given.length_m.get() * S::constant(0.5));
    ContactSolid::Cylinder { radius, half_length, axis: axis(given.axis) }
}
