//! Ropes: what they run over, and how long they are where a run begins.

use super::super::schema::{self, PaysOut, RopePoint, RopeStation, Scenario};
use super::cylinders::attachment;
use super::{FieldError, known};
use crate::dynamics::LinkKinematics;
use crate::elements::ropes::{Drum, Efficiency, Path, Round, Station};
use crate::elements::{AnyElement, Moment, Rope, of_kind, of_kind_mut};
use crate::model::{Attachment, JointKind, Model};
use crate::scenario::leaf::Quantity;
use crate::simulation::Setup;
use crate::spatial::{Frame, Vector3};
use crate::world::World;

/// Strain at the start beyond which a length is a mistake: steel has parted long before.
const LARGEST_STRAIN: f64 = 0.05;

/// The largest angle about a sheave at the start, degrees: the rope may turn a little farther.
const LARGEST_WRAP_DEG: f64 = 260.0;

/// A rope that runs straight past a sheave, degrees.
const ROUNDING_DEG: f64 = 1.0;

/// Falls of one leg, at most.
const MOST_FALLS: u32 = 100;

/// One rope, where it is on and all that it runs over is there.
pub fn build<S: Quantity>(
    scenario: &Scenario<S>,
    name: &str,
    given: &schema::Rope<S>,
    model: &Model<S>,
) -> Result<Option<AnyElement<S>>, FieldError> {
    let field = |rest: String| format!("forces.{name}.rope.{rest}");
    check_order(&given.path, &field)?;
    let mut stations = Vec::new();
    let mut drum = None;
    for (i, station) in given.path.iter().enumerate() {
        let place = Placing { scenario, model, field: field(format!("path.{i}.{}", station.on().0)) };
        let found = match station {
            RopeStation::Point(point) => place.point(point)?,
            RopeStation::Sheave(sheave) => place.sheave(sheave)?,
            RopeStation::Drum(given) => place.drum(given)?.map(|(station, found)| {
                drum = Some(found);
                station
            }),
        };
        stations.push(found);
    }
    check_falls(&given.path, &field)?;
    let stations: Option<Vec<Station<S>>> = stations.into_iter().collect();
    let (Some(stations), true) = (stations, given.enabled) else { return Ok(None) };
    Ok(Some(Box::new(Rope {
        name: name.to_owned(),
        path: Path::new(stations),
        drum,
        unstretched_length: given.unstretched_length_m.map_or(S::ZERO, |length| length.get()),
        axial_stiffness: given.axial_stiffness_n.get(),
        series_compliance: given.series_stiffness_n_per_m.map_or(S::ZERO, |stiffness| S::ONE / stiffness.get()),
        damping_time: given.damping_time_s.get(),
        breaking_load: given.breaking_load_n.map(|load| load.get()),
    })))
}

/// A rope begins at a point or a drum and ends at a point, with no drum between.
fn check_order<S: Quantity>(path: &[RopeStation<S>], field: &impl Fn(String) -> String) -> Result<(), FieldError> {
    if path.len() < 2 {
        return Err(FieldError::new(field("path".to_owned()), format!("{} places", path.len()), "at least two"));
    }
    let last = path.len() - 1;
    for (i, station) in path.iter().enumerate() {
        let allowed = match (i, station) {
            (0, RopeStation::Sheave(_)) => "a point or a drum, where a rope begins",
            (i, RopeStation::Sheave(_) | RopeStation::Drum(_)) if i == last => "a point, where a rope ends",
            (i, RopeStation::Drum(_)) if i > 0 => "a point or a sheave: a drum stands where the rope begins",
            _ => continue,
        };
        return Err(FieldError::new(field(format!("path.{i}")), format!("a {}", station.on().0), allowed));
    }
    Ok(())
}

/// Several falls run between points: rope on a sheave is led one fall at a time.
fn check_falls<S: Quantity>(path: &[RopeStation<S>], field: &impl Fn(String) -> String) -> Result<(), FieldError> {
    if let Some(RopeStation::Point(RopePoint { falls, .. })) = path.first()
        && *falls != 1
    {
        let allowed = "1: falls lead to a point from the one before it";
        return Err(FieldError::new(field("path.0.point.falls".to_owned()), falls, allowed));
    }
    for (i, pair) in path.windows(2).enumerate() {
        let RopeStation::Point(point) = &pair[1] else { continue };
        let at = || field(format!("path.{}.point.falls", i + 1));
        if !(1..=MOST_FALLS).contains(&point.falls) {
            return Err(FieldError::new(at(), point.falls, format!("a number from 1 to {MOST_FALLS}")));
        }
        if point.falls > 1 && !matches!(pair[0], RopeStation::Point(_)) {
            let found = format!("{} from a {}", point.falls, pair[0].on().0);
            return Err(FieldError::new(at(), found, "1: several falls run between two points"));
        }
    }
    Ok(())
}

/// The station of a drum and the drum, where its joint is there.
type OnDrum<S> = Option<(Station<S>, Drum<S>)>;

/// Where a station is read, and its field.
struct Placing<'a, S> {
    scenario: &'a Scenario<S>,
    model: &'a Model<S>,
    field: String,
}

impl<S: Quantity> Placing<'_, S> {
    /// A point of a body, or of the world; `None` on a body that is not there.
    fn centre(&self, body: &schema::Name, position_m: [S; 3]) -> Result<Option<Attachment<S>>, FieldError> {
        let bodies = self.scenario.bodies.keys().map(|body| body.as_str());
        known(&format!("{}.body", self.field), body, bodies.chain([schema::WORLD]))?;
        let pin = schema::Pin { body: body.clone(), position_m };
        if pin.named_body().is_some_and(|body| self.model.body(body).is_none()) {
            return Ok(None);
        }
        attachment(self.scenario, self.model, &format!("{}.position_m", self.field), &pin).map(Some)
    }

    fn point(&self, given: &schema::RopePoint<S>) -> Result<Option<Station<S>>, FieldError> {
        let falls = S::constant(f64::from(given.falls));
        let centre = self.centre(&given.body, given.position_m)?;
        Ok(centre.map(|centre| Station { centre, round: None, falls }))
    }

    fn sheave(&self, given: &schema::Sheave<S>) -> Result<Option<Station<S>>, FieldError> {
        let [hoisting, lowering] =
            [("hoisting", given.efficiency_hoisting.get()), ("lowering", given.efficiency_lowering.get())];
        for (which, efficiency) in [hoisting, lowering] {
            if !efficiency.all(|efficiency| efficiency > 0.0) {
                let field = format!("{}.efficiency_{which}", self.field);
                return Err(FieldError::new(field, efficiency, "a number above 0, up to 1"));
            }
        }
        let efficiency = Efficiency { hoisting: hoisting.1, lowering: lowering.1 };
        let round = Round { axis: Vector3(given.axis.get()).direction(), radius: given.radius_m.get(), efficiency };
        let centre = self.centre(&given.body, given.position_m)?;
        Ok(centre.map(|centre| Station { centre, round: Some(round), falls: S::ONE }))
    }

    /// A drum stands on the body that carries its joint.
    fn drum(&self, given: &schema::RopeDrum<S>) -> Result<OnDrum<S>, FieldError> {
        let (field, joint) = (format!("{}.joint", self.field), given.joint.as_str());
        let revolute = |(_, body): &(&schema::Name, &schema::Body<S>)| matches!(body.joint, schema::Joint::Revolute(_));
        let joints =
            self.scenario.bodies.iter().filter(revolute).map(|(name, body)| super::bodies::joint_name(name, body));
        known(&field, joint, joints)?;
        let Some(coordinate) = self.model.coordinate(joint) else { return Ok(None) };
        let Some((body, _)) = self.model.owner(coordinate) else { return Ok(None) };
        let node = &self.model.tree.nodes[body];
        let JointKind::Revolute(hinge) = &node.kind else { return Ok(None) };
        let sign = match given.pays_out {
            PaysOut::WithPositiveRate => S::ONE,
            PaysOut::WithNegativeRate => -S::ONE,
        };
        let radius = given.radius_m.get();
        let round = Round {
            axis: hinge.placement().rotation * hinge.axis() * sign,
            radius,
            efficiency: Efficiency { hoisting: S::ONE, lowering: S::ONE },
        };
        let centre = self.model.attachment(node.parent, Frame::translation(hinge.placement().position));
        let drum = Drum { position: node.positions, coordinate, paid_out: radius * sign, start: S::ZERO };
        Ok(Some((Station { centre, round: Some(round), falls: S::ONE }, drum)))
    }
}

/// Takes the lengths where the run begins, its loops closed.
///
/// # Errors
/// Sheaves that overlap, or that the rope does not lie against; a rope that is shorter than its path by more than it can stretch.
pub fn begin<S: Quantity>(setup: &mut Setup<S>) -> Result<(), FieldError> {
    let Setup { model, world, elements, q, v, .. } = setup;
    let mut links = LinkKinematics::new(model);
    links.update(model, q, v);
    at_rest(world, model, &links, (q, v), |at| {
        of_kind_mut::<S, Rope<S>>(elements).try_for_each(|rope| begin_one(rope, at))
    })
}

fn begin_one<S: Quantity>(rope: &mut Rope<S>, at: &Moment<'_, S>) -> Result<(), FieldError> {
    let name = rope.name.clone();
    let field = |rest: &str| format!("forces.{name}.rope.{rest}");
    if let Some((leg, [distance, radii])) = rope.path.overlap(at) {
        let found = format!("a place {distance:.4} m from the one before it");
        let allowed = format!("one farther from it than {radii:.4} m, the radii of both");
        return Err(FieldError::new(field(&format!("path.{}", leg + 1)), found, allowed));
    }
    if rope.path.drum_is_along(at) {
        let (found, allowed) = ("an axis along the rope", "a joint whose axis stands across the rope");
        return Err(FieldError::new(field("path.0.drum.joint"), found, allowed));
    }
    let length = rope.begin_at(at);
    if !length.all(|length| length > 0.0) {
        return Err(FieldError::new(field("path"), format!("a path of {length} m"), "one longer than 0"));
    }
    check_sides(rope, at, field)?;
    if rope.unstretched_length.vanishes() {
        rope.unstretched_length = length;
    }
    let strain = rope.tension_at_rest(length - rope.unstretched_length) / rope.axial_stiffness;
    if !strain.all(|strain| strain <= LARGEST_STRAIN) {
        let found = format!("{} m, on a path of {length:.4} m: a strain of {strain:.3}", rope.unstretched_length);
        let allowed = format!("a length at which the rope stretches by {LARGEST_STRAIN} at most");
        return Err(FieldError::new(field("unstretched_length_m"), found, allowed));
    }
    Ok(())
}

/// The rope lies against every sheave, on the side that the axis says.
fn check_sides<S: Quantity>(
    rope: &mut Rope<S>,
    at: &Moment<'_, S>,
    field: impl Fn(&str) -> String,
) -> Result<(), FieldError> {
    for (i, wrap) in rope.path.wraps(at) {
        let degrees = wrap * S::constant(180.0 / core::f64::consts::PI);
        if !degrees.all(|degrees| (-ROUNDING_DEG..=LARGEST_WRAP_DEG).contains(&degrees)) {
            let found = format!("a rope that turns by {degrees:.1} degrees about the axis");
            let allowed =
                format!("0 to {LARGEST_WRAP_DEG} degrees; on the other side of the sheave, the opposite axis");
            return Err(FieldError::new(field(&format!("path.{i}.sheave.axis")), found, allowed));
        }
    }
    Ok(())
}

/// Where a run begins, ropes carry what they can.
pub fn check_loads(setup: &Setup) -> Result<(), FieldError> {
    let Setup { model, world, elements, q, v, .. } = setup;
    let mut links = LinkKinematics::new(model);
    links.update(model, q, v);
    for rope in of_kind::<f64, Rope>(elements) {
        let Some(load) = rope.breaking_load else { continue };
        let tension = at_rest(world, model, &links, (q, v), |at| rope.clone().tension_here(at));
        if tension > load {
            let (name, allowed) =
                (&rope.name, format!("more than {tension:.0} N, which it carries where the run begins"));
            return Err(FieldError::new(format!("forces.{name}.rope.breaking_load_N"), load, allowed));
        }
    }
    Ok(())
}

/// What an element without entries of its own sees of a model at rest.
pub(super) fn at_rest<S: Quantity, R>(
    world: &World<S>,
    model: &Model<S>,
    links: &LinkKinematics<S>,
    (q, v): (&[S], &[S]),
    see: impl FnOnce(&Moment<'_, S>) -> R,
) -> R {
    see(&Moment::at_rest(world, model, links, (q, v)))
}
