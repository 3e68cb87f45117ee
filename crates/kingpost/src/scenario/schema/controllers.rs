//! Controllers: each stands before an input, takes its command and sets it.

use kingpost_derive::fields;

use crate::scenario::leaf::Leaf;
use crate::scenario::schema::{
    ColumnName, CompensationDrive, DriveFunction, Fraction, HeaveCompensation, PlatformCompensation, Policy, Positive,
    Selector, SignalName, ThreeAxisCompensation, yes,
};

/// Controller between a command, of a user or of the operation, and an input. Its own command is an input with its
/// name. A controller may stand before another.
#[fields]
pub enum Controller<S = f64> {
    /// Shapes a command so that it leaves no swing.
    InputShaper(InputShaper<S>),
    /// Adds a function of time to a command.
    DriveFunction(DriveFunction<S>),
    /// Feeds columns of the results back to inputs.
    StateFeedback(StateFeedback<S>),
    /// A small neural network reads columns of the results and sets inputs.
    Policy(Policy<S>),
    /// Passes one of several commands for the same inputs.
    Selector(Selector),
    /// A winch pays out what the crane's tip rises, so that the load keeps its height.
    HeaveCompensation(HeaveCompensation<S>),
    /// Slewing and luffing hold the crane's tip over a point of the world, the winch the load's height.
    ThreeAxisCompensation(ThreeAxisCompensation<S>),
    /// Driven joints below the pedestal keep it level and at its height.
    PlatformCompensation(PlatformCompensation<S>),
}

impl<S> Controller<S> {
    /// The inputs that it sets, each with its field below the controller's name.
    pub fn targets(&self) -> Vec<(String, &str)> {
        match self {
            Self::InputShaper(shaper) => vec![("input_shaper.to".to_owned(), &*shaper.to)],
            Self::DriveFunction(function) => vec![("drive_function.to".to_owned(), &*function.to)],
            Self::StateFeedback(feedback) => {
                let steered = feedback.steers.iter().enumerate();
                steered.map(|(k, steer)| (format!("state_feedback.steers.{k}.to"), &*steer.to)).collect()
            }
            Self::Policy(policy) => {
                let steered = policy.steers.iter().enumerate();
                steered.map(|(k, steer)| (format!("policy.steers.{k}.to"), &*steer.to)).collect()
            }
            Self::Selector(selector) => {
                let set = selector.steers.iter().enumerate();
                set.map(|(k, target)| (format!("selector.steers.{k}.to"), &*target.to)).collect()
            }
            Self::HeaveCompensation(given) if given.enabled => {
                vec![("heave_compensation.drive".to_owned(), &*given.drive)]
            }
            Self::ThreeAxisCompensation(given) if given.enabled => {
                let winch = ("three_axis_compensation.drive".to_owned(), &*given.drive);
                joint_targets("three_axis_compensation", &given.joints).chain([winch]).collect()
            }
            Self::PlatformCompensation(given) if given.enabled => {
                joint_targets("platform_compensation", &given.joints).collect()
            }
            Self::HeaveCompensation(_) | Self::ThreeAxisCompensation(_) | Self::PlatformCompensation(_) => Vec::new(),
        }
    }

    /// Whether it sets drives and nothing that another controller commands.
    pub fn is_compensation(&self) -> bool {
        matches!(self, Self::HeaveCompensation(_) | Self::ThreeAxisCompensation(_) | Self::PlatformCompensation(_))
    }
}

fn joint_targets<'a>(kind: &'static str, joints: &'a [CompensationDrive]) -> impl Iterator<Item = (String, &'a str)> {
    joints.iter().enumerate().map(move |(k, joint)| (format!("{kind}.joints.{k}.drive"), &*joint.drive))
}

/// Sets an input to its command convolved with two or three impulses, after which a swing of the stated period and damping
/// is zero.
#[fields]
pub struct InputShaper<S = f64> {
    /// Whether the shaper acts; if not, its command passes.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The input that it sets: of a drive, or the command of another controller.
    pub to: SignalName,
    /// The impulses, or none: then its command passes.
    #[serde(default)]
    pub shaper: ShaperKind,
    /// Period of the swing, between two maxima, s.
    pub period_s: Positive<S>,
    /// Damping ratio of the swing, below 1.
    #[serde(default = "undamped::<S>")]
    pub damping_ratio: Fraction<S>,
    /// For ei: the swing that remains at the period, as a share of that without a shaper.
    #[serde(default = "tolerance::<S>")]
    pub tolerance: Fraction<S>,
}

/// The impulses of an input shaper.
#[fields]
#[derive(Copy, Default, Eq)]
pub enum ShaperKind {
    /// The command passes.
    None,
    /// Two: no swing at the period. The command lasts half a period longer.
    Zv,
    /// Three: no swing at the period, and little near it. The command lasts one period longer.
    #[default]
    Zvd,
    /// Three: a stated swing at the period, and no more in a wider band. The command lasts one period longer.
    Ei,
}

/// Sets inputs to `c - K e - K_I (integral of e)`, `e = x - reference`, within limits: c their commands, x the columns that it
/// reads, K and K_I the gains.
#[fields]
pub struct StateFeedback<S = f64> {
    /// Whether the controller acts; if not, its commands pass.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The columns that it reads.
    pub reads: Vec<FeedbackRead<S>>,
    /// The inputs that it sets. The command of a single one has the controller's name, of several `name.input`.
    pub steers: Vec<FeedbackSteer<S>>,
    /// Time between two samples, s: a whole number of steps; without it, one step.
    pub period_s: Option<Positive>,
}

/// A column that is fed back.
#[fields]
pub struct FeedbackRead<S = f64> {
    /// The column of the results, `slew.joint_position`, or a state of a drive as the linear analysis names it,
    /// `slewing.position`.
    pub column: ColumnName,
    /// Its value where nothing is corrected, in its SI unit.
    #[serde(default)]
    pub reference: S,
    /// The input in `steers` whose command is added to the reference; both have the same unit.
    pub follows: Option<SignalName>,
}

/// An input that a feedback sets.
#[fields]
pub struct FeedbackSteer<S = f64> {
    /// The input.
    pub to: SignalName,
    /// Its row of K: a gain for each column, the input's unit over the column's.
    pub gains: Vec<S>,
    /// Its row of K_I: a gain for the integral of each column over time, the input's unit over the column's and over s.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub integral_gains: Vec<S>,
    /// The smallest value that it is set to, in its SI unit; without it, the smallest that it can have.
    pub lower: Option<S>,
    /// The largest.
    pub upper: Option<S>,
}

fn undamped<S: Leaf>() -> Fraction<S> {
    Fraction::literal(0.0)
}

fn tolerance<S: Leaf>() -> Fraction<S> {
    Fraction::literal(0.05)
}
