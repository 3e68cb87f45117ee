//! Controllers: each stands before an input, takes its command and sets it.

use kingpost_derive::fields;

use crate::scenario::schema::{
    CompensationDrive, DriveFunction, HeaveCompensation, InputShaper, PlatformCompensation, Policy, Selector,
    StateFeedback, ThreeAxisCompensation,
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
