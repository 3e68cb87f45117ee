//! Everything that acts on the model or reads it: one contract, [`Element`], and one file for each kind.
//!
//! A new kind is one file here, its fields in `scenario/schema/` and one function in `scenario/build/`. It
//! [declares](Declaration) its states, inputs and outputs; the [`Layout`] of all elements gives each its place in the
//! state, in the results, in snapshots, in A and B. No other code names a kind.

mod air_gap;
mod anemometer;
mod clearance;
mod commanded;
pub mod contact;
mod context;
mod coulomb_friction;
mod damped_against;
mod declaration;
mod delay;
mod drawing;
pub mod drives;
pub mod dynamic_positioning;
mod element;
pub mod flow;
mod gravity;
pub mod hull;
mod input_shaper;
mod joint_damping;
mod joint_spring;
mod joint_stop;
mod layout;
pub mod lines;
mod mean_heading;
mod motion_reference_unit;
pub mod operation;
mod quadratic_damping;
mod regular_waves;
mod rods;
pub mod ropes;
mod slack_tank;
mod soft_hold;
mod state_feedback;
pub mod submerged;
mod viscous_damping;
mod watcher;

pub use air_gap::AirGap;
pub use anemometer::Anemometer;
pub use clearance::Clearance;
pub use contact::Contact;
pub use context::{Context, Situation};
pub use coulomb_friction::CoulombFriction;
pub use damped_against::DampedAgainst;
pub use declaration::{Components, Crossing, Declaration, ElementState, Event, Input, Output, VectorFrame, WRENCH};
pub use delay::Delay;
pub use drawing::{DrawnLine, LineStyle};
pub use dynamic_positioning::DynamicPositioning;
pub use element::{AnyElement, Boxed, Element, HOLD_IT, Holding, LinearLaw, Own, Settling, of_kind, of_kind_mut};
pub use flow::{Flow, FlowLoad};
pub use gravity::Gravity;
pub use hull::Hull;
pub use input_shaper::{InputShaper, ShaperKind, Swing, shaper_taps};
pub use joint_damping::JointDamping;
pub use joint_spring::JointSpring;
pub use joint_stop::{JointStop, StopSide, hunt_crossley};
pub use layout::{Layout, Share, Signal, Steer, UnknownSignal, Watched, Wire};
pub use lines::{CatenaryLine, SpringLine};
pub use mean_heading::MeanHeading;
pub use motion_reference_unit::MotionReferenceUnit;
pub use operation::Operation;
pub use quadratic_damping::QuadraticDamping;
pub use regular_waves::{RegularWaves, ShownWaves, WavePlace};
pub use rods::{Pendant, Rod};
pub use ropes::{Rope, TuggerLine};
pub use slack_tank::SlackTank;
pub use soft_hold::SoftHold;
pub use state_feedback::{FeedbackRead, FeedbackSteer, StateFeedback};
pub use submerged::Submerged;
pub use viscous_damping::ViscousDamping;
pub use watcher::{AnyWatcher, Extreme, Warning, Watcher, significant};
