//! Flexible bodies: the segments of a beam as bodies, and its elastic joints with springs and dampers.

use crate::elements::{AnyElement, JointDamping, JointSpring};
use crate::model::joint::AxisList;
use crate::model::{Beam, BodyDefinition, Joint, JointKind, Model, MotionType, Section};
use crate::scenario::assembly::FieldError;
use crate::scenario::leaf::{Leaf, Quantity};
use crate::scenario::schema::{self, Flexible, FlexibleDamping, Positive, Scenario, Section as SectionSchema};
use crate::spatial::{Frame, Matrix3, Vector3};

/// Axes of an elastic joint.
pub const ELASTIC_AXES: usize = 5;

/// Largest number of elastic joints in one body.
const MOST_SEGMENTS: u64 = 64;

/// A flexible body and its position in its drawing frame.
pub struct FlexibleBody<S> {
    name: String,
    beam: Beam<S>,
    /// Start of the beam in the drawing frame, m.
    start: Vector3<S>,
    /// Ratio of damping to stiffness, s.
    damping_time: S,
}

/// Returns the scenario's name of the body to which a segment belongs, and the segment's number; 0 for a
/// rigid body and for the first segment.
pub fn owner(name: &str) -> (&str, usize) {
    match name.split_once('.') {
        Some((owner, segment)) => (owner, segment.parse().unwrap_or_default()),
        None => (name, 0),
    }
}

/// Returns the number of a body's segment at a position in its drawing frame, and the segment's centre of
/// mass; the number is 0 for the first segment and for a rigid body.
///
/// # Errors
/// A position that is on different segments in different lanes; `field` is the path of its x.
pub fn carrier<S: Quantity>(
    scenario: &Scenario<S>,
    name: &str,
    field: &str,
    place_m: [S; 3],
) -> Result<(usize, Vector3<S>), FieldError> {
    let body = &scenario.bodies[name];
    match FlexibleBody::read(name, body) {
        Ok(Some(beam)) => {
            let segment = beam.segment_at(field, place_m)?;
            Ok((segment, beam.centre(segment)))
        }
        _ => Ok((0, Vector3(body.centre_of_mass_m))),
    }
}

/// Returns the body of the model at a position on a named body, or in the world, and the centre of mass of
/// that body in the drawing frame. `field` is the path of the position.
///
/// # Errors
/// As [`carrier`].
pub fn carrier_in_model<S: Quantity>(
    scenario: &Scenario<S>,
    model: &Model<S>,
    name: Option<&schema::Name>,
    field: &str,
    place_m: [S; 3],
) -> Result<(Option<usize>, Vector3<S>), FieldError> {
    let Some(name) = name else { return Ok((None, Vector3::zero())) };
    let (segment, centre) = carrier(scenario, name, &format!("{field}.0"), place_m)?;
    Ok((model.body(name).map(|body| body + segment), centre))
}

impl<S: Quantity> FlexibleBody<S> {
    /// Returns the beam of a body; `None` if the body is rigid.
    pub fn read(name: &str, body: &schema::Body<S>) -> Result<Option<Self>, FieldError> {
        let Some(flexible) = &body.flexible else { return Ok(None) };
        let length = check(name, body, flexible)?;
        let (youngs_modulus, poissons_ratio) = (flexible.youngs_modulus_pa.get(), flexible.poissons_ratio);
        let beam = Beam {
            pieces: flexible.segments as usize,
            length,
            mass: body.mass_kg.get(),
            section: section(flexible, poissons_ratio),
            youngs_modulus,
            shear_modulus: youngs_modulus * S::constant(0.5) / (S::ONE + poissons_ratio),
        };
        let start = Vector3(body.centre_of_mass_m) - Vector3([beam.length * S::constant(0.5), S::ZERO, S::ZERO]);
        let read = Self { name: name.to_owned(), beam, start, damping_time: damping_time(flexible) };
        read.check_root(body)?;
        Ok(Some(read))
    }

    /// Checks that the body's joint is in its first segment.
    fn check_root(&self, body: &schema::Body<S>) -> Result<(), FieldError> {
        if let schema::Joint::Floating(_) = body.joint {
            let allowed = "a joint to another body or to the world, for a flexible body";
            return Err(FieldError::new(format!("bodies.{}.joint", self.name), "floating", allowed));
        }
        let place = body.joint.place().child_position_m;
        let (from, to) = (self.start.0[0], self.start.0[0] + self.beam.joint(1));
        if (place[0] - from).all(|beyond| beyond >= 0.0) && (to - place[0]).all(|left| left >= 0.0) {
            return Ok(());
        }
        let field = format!("bodies.{}.joint.{}.child_position_m.0", self.name, body.joint.kind());
        let allowed = format!("{from} to {to}: the joint of a flexible body is in its first segment");
        Err(FieldError::new(field, place[0], allowed))
    }

    /// Returns the segment at a position in the drawing frame; `field` is the path of its x.
    fn segment_at(&self, field: &str, place_m: [S; 3]) -> Result<usize, FieldError> {
        Ok(self.beam.segment_at(place_m[0] - self.start.0[0]).same(field)? as usize)
    }

    /// Returns the named points of the body, each with its segment and its position in the drawing frame.
    pub fn points(&self, body: &schema::Body<S>) -> Result<Vec<(usize, String, Vector3<S>)>, FieldError> {
        let point = |(name, point): (&schema::Name, &schema::Point<S>)| {
            let field = format!("bodies.{}.points.{name}.position_m.0", self.name);
            Ok((self.segment_at(&field, point.position_m)?, name.to_string(), Vector3(point.position_m)))
        };
        body.points.iter().map(point).collect()
    }

    /// Returns the centre of mass of a segment in the drawing frame, m.
    pub fn centre(&self, segment: usize) -> Vector3<S> {
        self.start + Vector3([self.beam.segment_middle(segment), S::ZERO, S::ZERO])
    }

    /// Returns the segment as a body: the first one with the joint and the parent of the flexible body, each
    /// other one attached to the segment before it.
    pub fn describe(
        &self,
        segment: usize,
        parent: Option<usize>,
        joint: Joint<S>,
        points: Vec<(String, Vector3<S>)>,
    ) -> BodyDefinition<S> {
        let name = if segment == 0 { self.name.clone() } else { self.segment_name(segment) };
        let (mass, inertia) = (self.beam.segment_mass(segment), self.beam.segment_inertia(segment));
        BodyDefinition { name, parent, joint, mass, inertia, points }
    }

    fn segment_name(&self, segment: usize) -> String {
        format!("{}.{segment}", self.name)
    }

    /// Returns the number of elastic joints: one before each segment except the first.
    pub fn joints(&self) -> usize {
        self.beam.pieces
    }

    /// Returns the elastic joint before a segment.
    pub fn joint(&self, segment: usize) -> Joint<S> {
        let joint = self.start + Vector3([self.beam.joint(segment), S::ZERO, S::ZERO]);
        let placement = Frame { rotation: Matrix3::identity(), position: joint - self.centre(segment - 1) };
        let kind = JointKind::AxisList(AxisList::elastic(placement, self.centre(segment) - joint));
        Joint { name: self.segment_name(segment), kind, mode: MotionType::Free }
    }

    /// Returns the springs and dampers of an elastic joint whose coordinates start at these indices in q and
    /// v.
    pub fn forces(&self, position: usize, coordinate: usize) -> impl Iterator<Item = AnyElement<S>> {
        let time = self.damping_time;
        let damped = !time.vanishes();
        self.beam.stiffness().into_iter().enumerate().flat_map(move |(i, stiffness)| {
            let (position, coordinate) = (position + i, coordinate + i);
            let spring: AnyElement<S> = Box::new(JointSpring { position, coordinate, stiffness, rest: S::ZERO });
            let damper: AnyElement<S> = Box::new(JointDamping { coordinate, damping: stiffness * time });
            [Some(spring), damped.then_some(damper)].into_iter().flatten()
        })
    }
}

fn length<S: Leaf>(body: &schema::Body<S>) -> Option<S> {
    let of_shape = || match body.shape.as_ref()? {
        schema::Shape::Box(cuboid) => Some(cuboid.length_m),
        schema::Shape::Cylinder(cylinder) if cylinder.axis == schema::PrincipalAxis::X => Some(cylinder.length_m),
        _ => None,
    };
    let length = body.flexible.as_ref()?.length_m.or_else(of_shape)?;
    Some(length.get())
}

/// Returns the length, after the checks that the types do not make.
fn check<S: Quantity>(name: &str, body: &schema::Body<S>, flexible: &Flexible<S>) -> Result<S, FieldError> {
    let error = |field: &str, found: String, allowed: &str| {
        Err(FieldError::new(format!("bodies.{name}.{field}"), found, allowed))
    };
    if body.inertia.is_some() {
        return error(
            "inertia",
            "an inertia of a flexible body".to_owned(),
            "none: it follows from section and length",
        );
    }
    if !(1..=MOST_SEGMENTS).contains(&flexible.segments) {
        return error("flexible.segments", flexible.segments.to_string(), "a whole number from 1 to 64");
    }
    if !flexible.poissons_ratio.all(|ratio| ratio > -1.0 && ratio <= 0.5) {
        let found = flexible.poissons_ratio.to_string();
        return error("flexible.poissons_ratio", found, "a number greater than -1 and not greater than 0.5");
    }
    let Some(length) = length(body) else {
        let allowed = "a length, or the shape of a box or of a cylinder along x";
        return error("flexible.length_m", "nothing".to_owned(), allowed);
    };
    let half = S::constant(0.5);
    match &flexible.section {
        SectionSchema::CircularTube(tube)
            if !(tube.outer_diameter_m.get() * half - tube.wall_m.get()).all(|left| left >= 0.0) =>
        {
            let allowed = "at most half of the outer diameter";
            error("flexible.section.circular_tube.wall_m", tube.wall_m.get().to_string(), allowed)
        }
        SectionSchema::RectangularTube(tube)
            if [tube.width_m, tube.height_m]
                .iter()
                .any(|side| !(side.get() * half - tube.wall_m.get()).all(|left| left > 0.0)) =>
        {
            let allowed = "less than half of width and height";
            error("flexible.section.rectangular_tube.wall_m", tube.wall_m.get().to_string(), allowed)
        }
        _ => Ok(length),
    }
}

fn section<S: Quantity>(flexible: &Flexible<S>, poissons_ratio: S) -> Section<S> {
    match &flexible.section {
        SectionSchema::CircularTube(tube) => {
            Section::circular_tube(tube.outer_diameter_m.get(), tube.wall_m.get(), poissons_ratio)
        }
        SectionSchema::RectangularTube(tube) => {
            let [width, height, wall] = [tube.width_m, tube.height_m, tube.wall_m].map(|length| length.get());
            Section::rectangular_tube(width, height, wall)
        }
        SectionSchema::General(given) => {
            let shear_compliances = given.shear_areas_m2.map_or([S::ZERO; 2], |areas| areas.map(|a| S::ONE / a.get()));
            let second_moments = given.second_moments_m4.map(|moment| moment.get());
            let (area, torsion_constant) = (given.area_m2.get(), given.torsion_constant_m4.get());
            Section { area, second_moments, torsion_constant, shear_compliances }
        }
    }
}

/// Returns the ratio of damping to stiffness, s: 2 ratio / (2 pi frequency).
fn damping_time<S: Quantity>(flexible: &Flexible<S>) -> S {
    match &flexible.damping {
        None => S::ZERO,
        Some(FlexibleDamping::StiffnessTime(given)) => given.time_s.get(),
        Some(FlexibleDamping::Ratio(given)) => {
            given.ratio.get() / (S::constant(core::f64::consts::PI) * given.frequency_hz.get())
        }
    }
}

/// Returns the shape for drawing a body or a segment: the body's shape, cut to the length and the
/// cross-section of the segment.
pub fn shape(body: &schema::Body, segment: usize) -> Option<schema::Shape> {
    let (Some(flexible), Some(length)) = (&body.flexible, length(body)) else { return body.shape.clone() };
    let at_an_end = segment == 0 || segment as u64 == flexible.segments;
    let length_m = Positive::new(length / flexible.segments as f64 * if at_an_end { 0.5 } else { 1.0 })?;
    let cylinder = |radius_m| {
        schema::Shape::Cylinder(schema::CylinderShape { radius_m, length_m, axis: schema::PrincipalAxis::X })
    };
    match (&flexible.section, &body.shape) {
        (SectionSchema::CircularTube(tube), _) => Some(cylinder(Positive::new(tube.outer_diameter_m.get() / 2.0)?)),
        (SectionSchema::RectangularTube(tube), _) => {
            let (width_m, height_m) = (tube.width_m, tube.height_m);
            Some(schema::Shape::Box(schema::BoxShape { length_m, width_m, height_m }))
        }
        (SectionSchema::General(_), Some(schema::Shape::Box(whole))) => {
            Some(schema::Shape::Box(schema::BoxShape { length_m, ..whole.clone() }))
        }
        (SectionSchema::General(_), Some(schema::Shape::Cylinder(whole))) => Some(cylinder(whole.radius_m)),
        (SectionSchema::General(_), _) => None,
    }
}
