//! Elements, which act on the model or read it: one trait, [`Element`], and one module for each kind.
//!
//! A new kind is one module here: its physics, its `fields` in a file and its `assembly` from these fields. It
//! [declares](Declaration) its states, inputs and outputs; the [`Layout`] of all elements assigns their positions in
//! the state, in the results, in snapshots, and in A and B. No other code names a kind.

mod air_gap;
mod anemometer;
pub mod clearance;
mod commanded;
pub mod compensation;
pub mod connection;
pub mod contact;
mod context;
mod coulomb_friction;
mod damped_against;
mod declaration;
mod delay;
mod drawing;
pub mod drive_function;
pub mod drives;
pub mod dynamic_positioning;
mod element;
pub mod flow;
pub mod free_flooding_tank;
pub mod gangway;
pub mod gas_spring;
pub mod gravity;
pub mod hull;
pub mod inertial_unit;
pub mod input_shaper;
mod joint_damping;
mod joint_spring;
mod joint_stop;
mod layout;
pub mod line;
pub mod lines;
mod mean_heading;
pub mod motion_reference_unit;
pub mod operation;
pub mod policy;
pub mod quadratic_damping;
mod random_drag;
mod regular_waves;
mod rods;
pub mod ropes;
pub mod selector;
pub mod sensing;
pub mod slack_tank;
pub mod soft_hold;
pub mod state_feedback;
pub mod submerged;
mod support;
pub mod swing_estimator;
mod tank_levels;
mod ticks;
pub mod trailing_edge;
pub mod u_tank;
pub mod viscous_damping;
mod watcher;

pub use air_gap::AirGap;
pub use anemometer::Anemometer;
pub use clearance::Clearance;
pub use compensation::{HeaveCompensation, HeaveForecast, PlatformCompensation, ThreeAxisCompensation};
pub use connection::Connection;
pub use contact::Contact;
pub use context::{Context, EvaluationMode};
pub use coulomb_friction::CoulombFriction;
pub use damped_against::DampedAgainst;
pub use declaration::{
    Components, Crossing, Declaration, Event, Input, Occurrence, Output, PlacesAlong, StateDeclaration, VectorFrame,
    WRENCH,
};
pub use delay::Delay;
pub use drawing::{DrawnLine, DrawnSeabed, DrawnTank, LineStyle, TankRoom};
pub use drive_function::{CubicSpline, DriveFunction};
pub use dynamic_positioning::DynamicPositioning;
pub use element::{
    Advancing, AnyElement, Boxed, Element, ElementState, HOLD_IT, Holding, LinearLaw, NotAdvanced, Settling, of_kind,
    of_kind_mut,
};
pub use flow::{Flow, FlowLoad};
pub use free_flooding_tank::FreeFloodingTank;
pub use gas_spring::GasSpring;
pub use gravity::Gravity;
pub use hull::Hull;
pub use inertial_unit::InertialUnit;
pub use input_shaper::{InputShaper, ShaperKind, Swing, shaper_taps};
pub use joint_damping::JointDamping;
pub use joint_spring::JointSpring;
pub use joint_stop::{JointStop, StopSide, hunt_crossley};
pub use layout::{Layout, Signal, StateSlices, Steer, UnknownSignal, Watched, Wire};
pub use line::{ClumpWeight, DynamicLine, LineGround, LinePart, LineSection, LineSupply};
pub use lines::{CatenaryLine, SpringLine};
pub use mean_heading::MeanHeading;
pub use motion_reference_unit::{HeaveFilter, MotionReferenceUnit};
pub use operation::Operation;
pub use policy::{Policy, PolicyLayer, PolicyRead, PolicySteer};
pub use quadratic_damping::QuadraticDamping;
pub use random_drag::{RandomDrag, WATER_COMPONENTS, WaterMotion};
pub use regular_waves::{RegularWaves, ShownWaves, WavePlace};
pub use rods::{Pendant, Rod};
pub use ropes::{Rope, TuggerLine};
pub use selector::Selector;
pub use sensing::{Encoder, LoadCell, SatelliteReceiver};
pub use slack_tank::SlackTank;
pub use soft_hold::SoftHold;
pub use state_feedback::{FeedbackRead, FeedbackSteer, StateFeedback};
pub use submerged::Submerged;
pub use support::{BodyPair, PresentSupport, Support};
pub use swing_estimator::{SwingEstimator, SwingFilter};
pub use tank_levels::{LevelEnd, TankLevels};
pub use trailing_edge::TrailingEdge;
pub use u_tank::UTank;
pub use viscous_damping::ViscousDamping;
pub use watcher::{AnyWatcher, Exceeded, Extreme, Warning, Watcher, significant};
