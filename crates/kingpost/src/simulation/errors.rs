//! Errors that end a run early, and errors of values that a caller gives.

use crate::dynamics::TemporaryConstraint;
use crate::dynamics::loops::{LARGEST_GAP, LoopFault, SMALLEST_PIVOT};
use crate::integrate::{StepError, shown};
use crate::plant::Plant;
use crate::scalar::Scalar;
use thiserror::Error;

/// Why a run stopped early.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum RunError {
    /// A number is not finite, or a rate passes the limit.
    #[error(
        "diverged at {} s: the {quantity} {coordinate} of body {body} is {value:.4e}, \
         allowed: finite, and rates of at most {limit} rad/s or m/s",
        shown(*time_s)
    )]
    Diverged {
        /// End of the step that failed, s.
        time_s: f64,
        /// The body whose joint diverges.
        body: String,
        /// The coordinate that diverges.
        coordinate: String,
        /// `rate` or `position`.
        quantity: &'static str,
        /// The value that is not finite or beyond the limit.
        value: f64,
        /// Name of the setting that limits the quantity: `rate_limit`.
        limit: f64,
    },
    /// A number of a row is not finite.
    #[error("diverged at {} s: {column} is {value}, allowed: finite numbers", shown(*time_s))]
    NoNumber {
        /// The time of the row, s.
        time_s: f64,
        /// The column.
        column: String,
        /// The value that is not finite.
        value: f64,
    },
    /// A closed loop has reached a singular position: a dead centre.
    #[error(
        "singular at {} s: constraint {constraint} of loop {name} depends on the others here, or no coordinate affects it \
         (its pivot over that at the start is {pivot:.1e}), allowed: more than {allowed:e}",
        shown(*time_s)
    )]
    SingularLoop {
        /// End of the step that failed, s.
        time_s: f64,
        /// The loop.
        name: String,
        /// Its constraint.
        constraint: String,
        /// Pivot of J M*^-1 J^T, as a ratio to its diagonal entry at the start of the run.
        pivot: f64,
        /// Smallest allowed pivot.
        allowed: f64,
    },
    /// A closed loop cannot be closed: its end is out of reach.
    #[error(
        "open at {} s: constraint {constraint} of loop {name} is off by {gap:.3e} {unit}, allowed: less than {allowed:e}",
        shown(*time_s)
    )]
    OpenLoop {
        /// End of the step that failed, s.
        time_s: f64,
        /// The loop.
        name: String,
        /// Its constraint.
        constraint: String,
        /// Error of the constraint, m or rad.
        gap: f64,
        /// Unit of the error: `m` or `rad`.
        unit: &'static str,
        /// Limit of the error, in the same unit.
        allowed: f64,
    },
    /// An element responds to infinitely many events at one time.
    #[error(
        "stuck at {} s: {element} had {what} more than {allowed} times in one step, allowed: {allowed}",
        shown(*time_s)
    )]
    TooManyEvents {
        /// Time of the events, s.
        time_s: f64,
        /// The element.
        element: String,
        /// Description of the event.
        what: &'static str,
        /// Largest number of responses at one time.
        allowed: usize,
    },
    /// An event occurs in one of several runs that are stepped together in lanes: the other runs have it at
    /// another time.
    #[error("event before {} s: found several runs in lanes, allowed: one run", shown(*time_s))]
    EventNotAlone {
        /// End of its step, s.
        time_s: f64,
    },
    /// The tension of an inextensible rope is not determined: other ropes carry the same load, or nothing on
    /// the rope can move.
    #[error(
        "not determined at {} s: the tension of the inextensible rope {name}, because other ropes or loops carry the same load, or nothing on the rope can move (its relative pivot is {pivot:.1e}), allowed: more than {allowed:e}, or a rope with \
         axial_stiffness_N",
        shown(*time_s)
    )]
    UndeterminedRope {
        /// Time of the error, s.
        time_s: f64,
        /// The rope.
        name: String,
        /// Pivot of the rope's constraint.
        pivot: f64,
        /// Smallest pivot that is not singular.
        allowed: f64,
    },
    /// An inextensible rope is shorter than its path, and nothing on it can move to shorten the path.
    #[error(
        "too short at {} s: the inextensible rope {name} is {gap:.3e} m shorter than its path, and its load cannot follow, \
         allowed: less than {allowed:e} m",
        shown(*time_s)
    )]
    ShortRope {
        /// Time of the error, s.
        time_s: f64,
        /// The rope.
        name: String,
        /// The missing length, m.
        gap: f64,
        /// Largest missing length for which the rope counts as taut, m.
        allowed: f64,
    },
    /// A steering element cannot continue, for example because a step of an operation exceeds its time limit.
    #[error("{element} at {} s: {why}", shown(*time_s))]
    Steering {
        /// Time of the error, s.
        time_s: f64,
        /// The element.
        element: String,
        /// The reason.
        why: String,
    },
    /// The scheme cannot make a step.
    #[error(transparent)]
    Step(#[from] StepError),
}

impl RunError {
    /// Converts the error of a constraint to one with the names of the model; constraints that elements hold are
    /// numbered after those of the loops.
    pub(super) fn of_loop<S: Scalar>(time_s: f64, plant: &Plant<S>, fault: LoopFault) -> Self {
        let model = &plant.model;
        let held = |constraint: usize| plant.holds_behind_loops(constraint);
        let rope = |constraint: usize| held(constraint).filter(|held| held.is_one_sided).map(|held| held.name.clone());
        let named = |constraint: usize| {
            if let Some(TemporaryConstraint { name, part: (part, unit), .. }) = held(constraint) {
                return (name.clone(), (*part).to_owned(), *unit);
            }
            let mut all = model.loops.iter().flat_map(|closed| closed.constraints.iter().map(move |c| (closed, c)));
            let (closed, (name, constraint)) = all.nth(constraint).expect("a fault is of a constraint");
            (closed.name.clone(), name.clone(), constraint.unit())
        };
        match fault {
            LoopFault::Singular { constraint, pivot } => {
                if let Some(name) = rope(constraint) {
                    return Self::UndeterminedRope { time_s, name, pivot, allowed: SMALLEST_PIVOT };
                }
                let (name, constraint, _) = named(constraint);
                Self::SingularLoop { time_s, name, constraint, pivot, allowed: SMALLEST_PIVOT }
            }
            LoopFault::Open { constraint, gap } => {
                if let Some(name) = rope(constraint) {
                    return Self::ShortRope { time_s, name, gap: -gap, allowed: LARGEST_GAP };
                }
                let (name, constraint, unit) = named(constraint);
                Self::OpenLoop { time_s, name, constraint, gap, unit, allowed: LARGEST_GAP }
            }
        }
    }

    /// Returns the place and the value of an error, if it has them: body or loop, coordinate or constraint,
    /// value, and limit.
    pub fn place(&self) -> Option<(String, String, f64, f64)> {
        let length = "length".to_owned();
        let (name, part, value, limit) = match self {
            Self::Diverged { body, coordinate, value, limit, .. } => (body, coordinate, value, limit),
            Self::SingularLoop { name, constraint, pivot, allowed, .. } => (name, constraint, pivot, allowed),
            Self::OpenLoop { name, constraint, gap, allowed, .. } => (name, constraint, gap, allowed),
            Self::UndeterminedRope { name, pivot, allowed, .. } => (name, &length, pivot, allowed),
            Self::ShortRope { name, gap, allowed, .. } => (name, &length, gap, allowed),
            Self::Step(StepError::LineNotConverged { name, move_m, allowed_m, .. }) => {
                return Some((name.clone(), "nodes".to_owned(), *move_m, *allowed_m));
            }
            Self::NoNumber { .. }
            | Self::TooManyEvents { .. }
            | Self::EventNotAlone { .. }
            | Self::Steering { .. }
            | Self::Step(_) => return None,
        };
        Some((name.clone(), part.clone(), *value, *limit))
    }

    /// Time of the error, s.
    pub fn time_s(&self) -> f64 {
        match self {
            Self::Diverged { time_s, .. }
            | Self::NoNumber { time_s, .. }
            | Self::SingularLoop { time_s, .. }
            | Self::OpenLoop { time_s, .. }
            | Self::UndeterminedRope { time_s, .. }
            | Self::ShortRope { time_s, .. }
            | Self::TooManyEvents { time_s, .. }
            | Self::EventNotAlone { time_s }
            | Self::Steering { time_s, .. }
            | Self::Step(
                StepError::NotConverged { time_s, .. }
                | StepError::LineNotConverged { time_s, .. }
                | StepError::Collapsed { time_s, .. },
            ) => *time_s,
        }
    }
}

/// A value that a caller gives and that the simulation cannot accept.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum InputError {
    /// No input has this name.
    #[error("input {found}: no such input, allowed: {allowed}")]
    Unknown {
        /// The name that was given.
        found: String,
        /// The existing names.
        allowed: String,
    },
    /// A value of an input outside its limits, or NaN.
    #[error("input {name}: found {found}, allowed: {lower} to {upper}")]
    Range {
        /// The input.
        name: String,
        /// The value.
        found: f64,
        /// Smallest value.
        lower: f64,
        /// Largest value.
        upper: f64,
    },
    /// The input is connected to a signal, which sets it.
    #[error("input {name}: found a value from the user, allowed: none, because it is connected to {signal}")]
    Wired {
        /// The input.
        name: String,
        /// The signal to which it is connected.
        signal: String,
    },
    /// Other waves for a body whose motion follows the waves: its position would jump.
    #[error("waves: found other waves, allowed: those of the run, because they move a body, which would jump")]
    MovedByWaves,
    /// An array of the wrong length.
    #[error("{name}: found {found} numbers, allowed: {allowed}")]
    Length {
        /// The array.
        name: &'static str,
        /// Its length.
        found: usize,
        /// The required length.
        allowed: usize,
    },
    /// Positions at which a closed loop is open.
    #[error("q: found constraint {constraint} off by {found:.3e} m or rad, allowed: less than {allowed:e}")]
    OpenLoop {
        /// The constraint, as `loop.constraint`.
        constraint: String,
        /// Its error.
        found: f64,
        /// Limit of the error, m or rad.
        allowed: f64,
    },
    /// An entry that is not finite, or an orientation that is not a quaternion.
    #[error("{name}[{index}]: found {found}, allowed: {allowed}")]
    Entry {
        /// The array.
        name: &'static str,
        /// Index of the entry.
        index: usize,
        /// The entry.
        found: f64,
        /// Range or form that is allowed.
        allowed: &'static str,
    },
}

/// Returns an error unless an array has the right length and finite entries.
pub(super) fn check_array(name: &'static str, values: &[f64], allowed: usize) -> Result<(), InputError> {
    if values.len() != allowed {
        return Err(InputError::Length { name, found: values.len(), allowed });
    }
    match values.iter().position(|x| !x.is_finite()) {
        Some(index) => Err(InputError::Entry { name, index, found: values[index], allowed: "a finite number" }),
        None => Ok(()),
    }
}
