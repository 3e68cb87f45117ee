//! A connection: a closed loop that an input releases and engages during a run.

pub(crate) mod assembly;
pub(crate) mod fields;
mod misfit;

pub use misfit::{Misfit, PoseTolerance};

use crate::dynamics::{LinkKinematics, TemporaryConstraint, loops};
use crate::elements::{
    AnyElement, Components, Context, Crossing, Declaration, Element, ElementState, EvaluationMode, Event, Holding,
    Input, Output, PresentSupport, Support, VectorFrame, of_kind,
};
use crate::model::{Attachment, Constraint, Model};
use crate::scalar::Scalar;
use crate::spatial::{Frame, Matrix3, Vector3, Wrench};

/// A connection between two bodies: a hinge that lets go, a gripper that closes, a sea fastening that is cut.
///
/// While it is engaged it holds the constraints phi = 0 of a [closed loop](crate::model::Loop) between its ends, with the
/// multipliers of `dynamics/loops`. It is released without an impulse: its wrench is zero from then on. It engages with an impact,
/// v+ = v - M*^-1 J^T (J M*^-1 J^T)^-1 J v: the energy of the opposing motion becomes heat, and momentum is conserved (Pfeiffer &
/// Glocker, *Multibody Dynamics with Unilateral Contacts*, 1996, ch. 8, with a coefficient of restitution of 0). Where it engages it
/// holds: a misfit within the tolerance remains.
#[derive(Clone, Debug)]
pub struct Connection<S = f64> {
    /// Name of the loop, of its input and of its results.
    pub name: String,
    /// Ends on the first and the second body. While it is engaged, a frame on the second body coincides with the first end; it
    /// is that of the second end if the run began engaged.
    pub ends: [Attachment<S>; 2],
    /// Its constraints, each with its name.
    pub constraints: Vec<(&'static str, Constraint<S>)>,
    /// Largest misfit with which it engages; `None` if it engages where it is.
    pub tolerance: Option<PoseTolerance<S>>,
    /// Whether it begins released.
    pub begins_released: bool,
    /// Frame on the second body that coincides with the first end at the start, if it begins engaged.
    at_start: Attachment<S>,
    held: HeldConstraints<S>,
}

/// Constraints as they were last held.
#[derive(Clone, Debug)]
struct HeldConstraints<S> {
    constraints: Vec<Constraint<S>>,
    /// Frame on the second body that coincides with the first end.
    second: Attachment<S>,
    /// Wrench of each unit multiplier on the second body, about the second attachment in the axes of the first.
    wrenches: Vec<Wrench<S>>,
    /// Wrench of all multipliers from the last solution for the accelerations.
    reaction: Wrench<S>,
}

/// The only mode.
const ENGAGED: i64 = 0;
const RELEASED: i64 = 1;
/// It is to engage, and waits until its ends fit.
const WAITS: i64 = 2;

/// Misfit with which it still holds as at the start, m and rad: that of the loops of a state from outside, with six digits.
const AS_BUILT: f64 = 1e-6;

const EVENTS: [Event; 3] = [
    Event { code: "engages", what: "engages", crossing: Crossing::Falling },
    Event { code: "released", what: "is released", crossing: Crossing::Rising },
    Event {
        code: "out_of_tolerance",
        what: "is out of its tolerance, and engages when it comes within it",
        crossing: Crossing::Rising,
    },
];
const ENGAGES: usize = 0;
const IS_RELEASED: usize = 1;
const OUT_OF_TOLERANCE: usize = 2;

/// Number of discrete numbers of a frame; behind it are those of the impulse of impacts.
const FRAME: usize = 12;

impl<S: Scalar> Connection<S> {
    /// Returns a connection that begins engaged at its second end, unless it begins released.
    pub fn new(
        name: &str,
        ends: [Attachment<S>; 2],
        constraints: Vec<(&'static str, Constraint<S>)>,
        tolerance: Option<PoseTolerance<S>>,
        begins_released: bool,
    ) -> Self {
        let held = HeldConstraints {
            constraints: constraints.iter().map(|(_, constraint)| *constraint).collect(),
            second: ends[1],
            wrenches: vec![Wrench::zero(); constraints.len()],
            reaction: Wrench::zero(),
        };
        Self { name: name.to_owned(), ends, constraints, tolerance, begins_released, at_start: ends[1], held }
    }

    /// Returns the connections among elements.
    pub fn among(elements: &[AnyElement<S>]) -> impl Iterator<Item = &Self> {
        of_kind(elements)
    }

    /// Returns its ends as it holds at the start of a run; `None` if it begins released.
    pub fn held_at_start(&self) -> Option<[Attachment<S>; 2]> {
        (!self.begins_released).then_some([self.ends[0], self.at_start])
    }

    /// Takes the positions at the start of a run as those at which it holds, if it begins engaged where it is.
    pub fn take_start(&mut self, model: &Model<S>, links: &LinkKinematics<S>) {
        if self.tolerance.is_none() {
            self.at_start = self.here(model, links);
        }
    }

    /// Returns the frame on the second body that now coincides with the first end.
    fn here(&self, model: &Model<S>, links: &LinkKinematics<S>) -> Attachment<S> {
        let [first, second] = &self.ends;
        let pose = loops::relative_pose(model, links, [first, second]);
        model.attachment(second.body, second.in_body.times(&pose.inverse()))
    }

    /// Returns the misfit of its ends.
    fn misfit(&self, at: &Context<'_, S>) -> Misfit<S> {
        let pose = loops::relative_pose(at.model, at.links, self.ends.each_ref());
        Misfit::new(&pose, &self.held.constraints)
    }

    /// Returns the indicator of its engaging: negative within the tolerance.
    fn out_of_tolerance(&self, at: &Context<'_, S>) -> S {
        self.tolerance.map_or(-S::ONE, |tolerance| tolerance.exceeded(&self.misfit(at)))
    }

    /// Holds with this frame on the second body from now on.
    fn engage(frame: &Frame<S>, own: &mut ElementState<'_, S>) {
        own.modes[0] = ENGAGED;
        for (k, vector) in [0, 1, 2].map(|k| frame.rotation.column(k)).into_iter().chain([frame.position]).enumerate() {
            vector.write_to(&mut own.numbers[3 * k..]);
        }
        own.numbers[FRAME..].fill(S::ZERO);
    }
}

/// Returns the frame of its discrete numbers.
fn frame<S: Scalar>(numbers: &[S]) -> Frame<S> {
    Frame { rotation: Matrix3::from_fn(|i, j| numbers[3 * j + i]), position: Vector3::from_slice(&numbers[9..]) }
}

impl<S: Scalar> Element<S> for Connection<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let number = |variable, what, unit| Output::number(variable, what, "connection", &self.name, unit);
        let wrench = |variable, what| Output::wrench(variable, what, "connection", &self.name, VectorFrame::Loop);
        let of_frame = (0..FRAME).map(|k| format!("frame_{k}"));
        let of_impulse = Components::Wrench.labels().unwrap_or_default().iter().map(|label| format!("impulse_{label}"));
        Declaration {
            holds: self.constraints.len(),
            goes_alone: true,
            modes: vec!["condition".to_owned()],
            numbers: of_frame.chain(of_impulse).collect(),
            inputs: vec![Input::lever(&self.name, 0.0, if self.begins_released { 1.0 } else { 0.0 })],
            outputs: vec![
                number("connection_engaged", "1 while a connection is engaged, else 0", &["1"]),
                number(
                    "connection_distance",
                    "distance of a connection's second end from its first, along its constrained axes",
                    &["m"],
                ),
                number(
                    "connection_angle",
                    "angle of a connection's second end from its first, about its constrained axes",
                    &["rad"],
                ),
                wrench(
                    "connection_reaction",
                    "wrench of a connection on its second body, where it engaged, in the axes of the first end",
                ),
                Output {
                    units: &["N s", "N s", "N s", "N m s", "N m s", "N m s"],
                    ..wrench(
                        "connection_impulse",
                        "impulse of a connection on its second body by impacts since it engaged, in the axes of the first end",
                    )
                },
            ],
            events: EVENTS.to_vec(),
            ..Declaration::default()
        }
    }

    fn begin(&mut self, at: &Context<'_, S>, own: &mut ElementState<'_, S>) {
        // A state that is set during a run may be another one than that of the start; the search for an equilibrium is not.
        let pose = loops::relative_pose(at.model, at.links, [&self.ends[0], &self.at_start]);
        let Misfit { distance, angle } = Misfit::new(&pose, &self.held.constraints);
        let is_as_built = at.evaluation == EvaluationMode::Settling
            || [distance, angle].iter().all(|off| off.all(|off| off < AS_BUILT));
        Self::engage(&if is_as_built { self.at_start } else { self.here(at.model, at.links) }.in_body, own);
        if self.begins_released || at.is_let_go() {
            own.modes[0] = RELEASED;
            self.renew(at, own);
        }
    }

    fn renew(&mut self, at: &Context<'_, S>, own: &mut ElementState<'_, S>) {
        match (own.modes[0], at.is_let_go()) {
            (ENGAGED, true) => {
                own.modes[0] = RELEASED;
                own.also = Some(IS_RELEASED);
            }
            (WAITS, true) => own.modes[0] = RELEASED,
            (RELEASED | WAITS, false) => {
                if self.out_of_tolerance(at).all(|exceeded| exceeded <= 0.0) {
                    Self::engage(&self.here(at.model, at.links).in_body, own);
                    own.also = Some(ENGAGES);
                } else if own.modes[0] == RELEASED {
                    own.modes[0] = WAITS;
                    own.also = Some(OUT_OF_TOLERANCE);
                }
            }
            _ => {}
        }
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        let Misfit { distance, angle } = self.misfit(at);
        let engaged = if self.holds(at.modes) { S::ONE } else { S::ZERO };
        out.extend([engaged, distance, angle]);
        out.extend(self.held.reaction.force.0.into_iter().chain(self.held.reaction.moment.0));
        out.extend_from_slice(&at.numbers[FRAME..]);
    }

    fn event_indicators(&mut self, at: &Context<'_, S>, values: &mut [S]) {
        values.copy_from_slice(&[S::ONE, -S::ONE, -S::ONE]);
        if at.modes.first() == Some(&WAITS) {
            values[ENGAGES] = self.out_of_tolerance(at);
        }
    }

    fn handle_event(&mut self, event: usize, at: &Context<'_, S>, own: &mut ElementState<'_, S>, _v: &mut [S]) {
        if event == ENGAGES {
            Self::engage(&self.here(at.model, at.links).in_body, own);
        }
    }

    fn supports(&self) -> Vec<Support> {
        let bodies = self.ends.each_ref().map(|end| end.body);
        if self.begins_released { Vec::new() } else { vec![Support::Carries(bodies), Support::Station(bodies)] }
    }

    fn present_supports(&mut self, at: &Context<'_, S>) -> Vec<PresentSupport<S>> {
        let holds = self.holds(at.modes);
        holds.then(|| PresentSupport::Contact(self.ends.each_ref().map(|end| end.body))).into_iter().collect()
    }

    fn holding(&self) -> Option<&dyn Holding<S>> {
        Some(self)
    }

    fn holding_mut(&mut self) -> Option<&mut dyn Holding<S>> {
        Some(self)
    }
}

impl<S: Scalar> Holding<S> for Connection<S> {
    /// Without modes, as it begins.
    fn holds(&self, modes: &[i64]) -> bool {
        modes.first().map_or(!self.begins_released, |mode| *mode == ENGAGED)
    }

    fn restrain(&mut self, at: &Context<'_, S>, held: &mut [TemporaryConstraint<S>]) {
        let [first, second] = &self.ends;
        let HeldConstraints { constraints, second: with, wrenches, .. } = &mut self.held;
        if !at.numbers.is_empty() {
            *with = at.model.attachment(second.body, frame(at.numbers));
        }
        loops::hold(at.model, at.links, [first, with], constraints, held, wrenches);
        for (held, &(name, constraint)) in held.iter_mut().zip(&self.constraints) {
            (held.is_one_sided, held.part) = (false, (name, constraint.unit()));
        }
    }

    fn carry(&mut self, multipliers: &[S]) {
        self.held.reaction = self.held.sum(multipliers);
    }

    fn strike(&mut self, impulses: &[S], numbers: &mut [S]) {
        let Wrench { force, moment } = self.held.sum(impulses);
        for (number, more) in numbers[FRAME..].iter_mut().zip(force.0.into_iter().chain(moment.0)) {
            *number += more;
        }
    }
}

impl<S: Scalar> HeldConstraints<S> {
    /// Returns the wrench of these multipliers, about the second attachment in the axes of the first.
    fn sum(&self, multipliers: &[S]) -> Wrench<S> {
        self.wrenches
            .iter()
            .zip(multipliers)
            .fold(Wrench::zero(), |sum, (wrench, multiplier)| sum + *wrench * *multiplier)
    }
}
