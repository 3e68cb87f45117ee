//! A soft hold: its body, its position and its stiffness.

use crate::dynamics::LinkKinematics;
use crate::elements::hull::HullFrame;
use crate::elements::hull::assembly::memory_of_slow_motions;
use crate::elements::{AnyElement, SoftHold};
use crate::model::Model;
use crate::scenario::assembly::FieldError;
use crate::scenario::assembly::assemble::{Assemble, Surroundings};
use crate::scenario::assembly::rigid_bodies::rigid;
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, Joint, Scenario, StationTarget};
use crate::spatial::{Frame, SpatialInertia, Vector3, rotation_from_roll_pitch_yaw};

impl<S: Quantity> Assemble<S> for schema::SoftHold<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        Ok(build(at.scenario, name, self, at.model, at.start)?.into_iter().collect())
    }
}

/// Returns a soft hold, if it is enabled and its body exists; `q` and `v` are the scenario's initial state.
fn build<S: Quantity>(
    scenario: &Scenario<S>,
    name: &str,
    given: &schema::SoftHold<S>,
    model: &Model<S>,
    (q, v): (&[S], &[S]),
) -> Result<Option<AnyElement<S>>, FieldError> {
    let field = format!("forces.{name}.soft_hold");
    check(scenario, given, &field)?;
    let Some(body) = model.body(&given.body).filter(|_| given.enabled) else { return Ok(None) };
    let mut links = LinkKinematics::new(model);
    links.update(model, q, v);
    let ship = Ship::new(scenario, model, &links, body);
    let masses = ship.masses();
    let of = |k: usize| {
        let [period, ratio] = [given.natural_periods_s[k].get(), given.damping_ratios[k].get()];
        SoftHold::spring_and_damper(masses[k], period, ratio)
    };
    let each = [of(0), of(1), of(2)];
    let origin = ship.body_frame().inverse().point(ship.centre);
    let (position, heading) = ship.held(given.target, origin);
    Ok(Some(Box::new(SoftHold {
        name: name.to_owned(),
        place: HullFrame { body, origin },
        position,
        heading,
        stiffness: each.map(|[k, _]| k),
        damping: each.map(|[_, c]| c),
    })))
}

/// Checks that the body has a floating joint and that the target is finite.
fn check<S: Quantity>(scenario: &Scenario<S>, given: &schema::SoftHold<S>, field: &str) -> Result<(), FieldError> {
    rigid(scenario, format!("{field}.body"), &given.body)?;
    let joint = &scenario.bodies[&given.body].joint;
    if !matches!(joint, Joint::Floating(_)) {
        let found = format!("{}, whose joint is {}", given.body, joint.kind());
        let allowed = "a body with a floating joint: no force moves a prescribed body, and other joints already hold their bodies";
        return Err(FieldError::new(format!("{field}.body"), found, allowed));
    }
    let Some(target) = given.target else { return Ok(()) };
    let numbers = [("x_m", target.x_m), ("y_m", target.y_m), ("heading_rad", target.heading_rad)];
    match numbers.into_iter().find(|(_, number)| !number.all(f64::is_finite)) {
        Some((name, number)) => Err(FieldError::new(format!("{field}.target.{name}"), number, "a finite number")),
        None => Ok(()),
    }
}

/// A ship with all that it carries, in its initial position.
struct Ship<'a, S: Quantity> {
    scenario: &'a Scenario<S>,
    model: &'a Model<S>,
    links: &'a LinkKinematics<S>,
    body: usize,
    carried: Vec<usize>,
    /// Centre of mass of the ship with all that it carries, world, m.
    centre: Vector3<S>,
}

impl<'a, S: Quantity> Ship<'a, S> {
    fn new(scenario: &'a Scenario<S>, model: &'a Model<S>, links: &'a LinkKinematics<S>, body: usize) -> Self {
        let carried = model.carried(body);
        let none = (S::ZERO, Vector3::zero());
        let (mass, moment) = carried.iter().fold(none, |(mass, moment), &body| {
            let own = model.bodies[body].mass;
            (mass + own, moment + links.body_frame(model, body).position * own)
        });
        Self { scenario, model, links, body, carried, centre: moment * (S::ONE / mass) }
    }

    fn body_frame(&self) -> Frame<S> {
        self.links.body_frame(self.model, self.body)
    }

    fn heading(&self) -> S {
        let forward = self.body_frame().rotation.column(0);
        forward[1].atan2(forward[0])
    }

    /// Returns the position at which the centre of mass is held, and the cosine and sine of the held heading: the
    /// initial ones, or those for which the drawing frame is at the target.
    fn held(&self, target: Option<StationTarget<S>>, point: Vector3<S>) -> ([S; 2], [S; 2]) {
        let Some(StationTarget { x_m, y_m, heading_rad }) = target else {
            let (sin, cos) = self.heading().sin_cos();
            return ([self.centre[0], self.centre[1]], [cos, sin]);
        };
        let (sin, cos) = heading_rad.sin_cos();
        let name = &self.model.bodies[self.body].name;
        let [x, y, _] = (point + Vector3(self.scenario.bodies[name.as_str()].centre_of_mass_m)).0;
        ([x_m + cos * x - sin * y, y_m + sin * x + cos * y], [cos, sin])
    }

    /// Returns the masses along and across the heading and the moment of inertia about the vertical through the centre
    /// of mass, with the added mass of slow motions.
    fn masses(&self) -> [S; 3] {
        let rotation = rotation_from_roll_pitch_yaw(Vector3::new(S::ZERO, S::ZERO, self.heading()));
        let to_level = Frame { rotation, position: self.centre }.inverse();
        // The model already contains the added mass at infinite frequency.
        let in_model = self.carried.iter().map(|&body| {
            let frame = self.links.body_frame(self.model, body);
            self.model.tree.nodes[body].inertia.to_parent(&to_level.times(&frame))
        });
        let all = in_model.fold(SpatialInertia::default(), |sum, own| sum + own);
        let name = &self.model.bodies[self.body].name;
        let memory = memory_of_slow_motions(self.scenario, name).to_parent(&to_level.times(&self.body_frame()));
        let all = all + memory;
        [all.linear.xx, all.linear.yy, all.angular.zz]
    }
}
