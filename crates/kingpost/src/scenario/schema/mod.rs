//! The types of a scenario: the only schema. The reader, the JSON Schema, the TypeScript types and the reference page
//! come from here. SI units and radians; the unit of a quantity is in its name. No flattened or untagged enums: with
//! them serde loses the place of an error.

use kingpost_derive::fields;
mod axes;
mod bodies;
mod controllers;
mod flexible;
pub(crate) mod flow;
mod forces;
mod gusts;
mod integrators;
mod joints;
mod joints_of_several_axes;
mod loops;
mod mounting;
mod moved_by_waves;
mod parameter;
mod sea;
mod sensors;
mod sets_inputs;
mod view;
mod waves;

use indexmap::IndexMap;

pub use crate::elements::clearance::fields::{AirGap, Clearance, ClearanceFrom, ClearanceShape};
pub use crate::elements::compensation::fields::forecast::HeaveForecast;
pub use crate::elements::compensation::fields::heave::{HeaveCompensation, HeavePrediction};
pub use crate::elements::compensation::fields::motion::{
    CompensationDrive, PlatformCompensation, ThreeAxisCompensation,
};
pub use crate::elements::contact::fields::{
    CapsuleShape, ConeShape, Contact, ContactLoad, ContactPlane, ContactPoints, ContactSurface, ConvexShape, LoadShape,
    RingShape, SurfaceShape,
};
pub use crate::elements::drive_function::fields::DriveFunction;
pub use crate::elements::drives::fields::controlled::{
    AngleSetPoint, AngleSetPoints, ControlledDrive, ExtensionSetPoint, ForceSetPoint, LengthSetPoints,
    LinearControlledDrive, RateSetPoint, SpeedSetPoint, TorqueSetPoint,
};
pub use crate::elements::drives::fields::cylinder::{Cylinder, CylinderTarget, Pin, TargetLength};
pub use crate::elements::drives::fields::histories::{
    AngleOscillation, AngleTravel, History, HistoryList, LengthOscillation, LengthTravel, RatePulse,
};
pub use crate::elements::drives::fields::{
    Brake, BrakeState, Drive, LinearBrake, LinearMotor, LinearServo, Motor, Pulse, Servo,
};
pub use crate::elements::dynamic_positioning::fields::{
    AzimuthThruster, DynamicPositioning, MainPropeller, NaturalPeriods, PositioningGains, RotationTuning, StatedGains,
    StationTarget, ThrustPriority, Thruster, TranslationTuning, TunnelThruster, WaveFilter,
};
pub use crate::elements::flow::fields::{CurrentAtDepth, CurrentLoad, CurrentSpeed, FlowCoefficients, WindLoad};
pub use crate::elements::free_flooding_tank::fields::{AirPump, FreeFloodingTank};
pub use crate::elements::gangway::fields::Gangway;
pub use crate::elements::gas_spring::fields::GasSpring;
pub use crate::elements::gravity::fields::Gravity;
pub use crate::elements::hull::fields::{Hydrodynamics, Hydrostatics};
pub use crate::elements::inertial_unit::fields::{InertialFilter, InertialUnit};
pub use crate::elements::input_shaper::fields::{InputShaper, ShaperKind};
pub use crate::elements::line::fields::{DynamicLine, DynamicLineSection, LineClumpWeight, LineSeabed, SectionEnd};
pub use crate::elements::lines::fields::{CatenaryLine, SpringLine};
pub use crate::elements::motion_reference_unit::fields::{HeaveFilter, MotionReferenceUnit};
pub use crate::elements::operation::fields::{
    ColumnRange, Condition, InputMove, Limit, Mark, Operation, OperationStep, Task, TaskStage,
};
pub use crate::elements::policy::fields::{AlsoRead, Policy, PolicyLayer, PolicyRead, PolicySteer};
pub use crate::elements::quadratic_damping::fields::QuadraticDamping;
pub use crate::elements::ropes::fields::{
    CarriedByRope, DrumLayers, LoadChart, PaysOut, Rope, RopeDrum, RopePoint, RopeStation, Sheave, TuggerLine,
};
pub use crate::elements::selector::fields::{Selector, SelectorTarget};
pub use crate::elements::sensing::fields::crane::{Encoder, LinearEncoder, LoadCell, RopeEnd, SatelliteReceiver};
pub use crate::elements::sensing::fields::errors::{
    AccelerationErrors, AngleErrors, DropOuts, ForceErrors, LengthErrors, RateErrors, SpeedErrors,
};
pub use crate::elements::slack_tank::fields::SlackTank;
pub use crate::elements::soft_hold::fields::SoftHold;
pub use crate::elements::state_feedback::fields::{FeedbackRead, FeedbackSteer, StateFeedback};
pub use crate::elements::submerged::fields::{
    EntrainedWater, Submerged, SubmergedAddedMass, SubmergedDrag, SubmergedGrowth, SubmergedShape, SubmergedWind,
};
pub use crate::elements::swing_estimator::fields::{SwingEstimator, SwingFilter};
pub use crate::elements::trailing_edge::fields::TrailingEdge;
pub use crate::elements::u_tank::fields::{UTank, UTankPump};
pub use crate::elements::viscous_damping::fields::{DampedAgainst, ViscousDamping};
pub use crate::scenario::named_files::NamedFiles;
pub use crate::scenario::range::{Direction, Fraction, NonNegative, Positive};
pub use crate::scenario::text::{
    Colour, ColumnName, CoordinateName, DatabasePath, FilePath, LocalName, Name, RaosPath, RecordPath, SignalName,
    Version, WORLD,
};
pub use axes::{
    AngleAxis, AngleFriction, AngleLimits, AngleSpring, LengthAxis, LengthFriction, LengthLimits, LengthSpring,
    PrescribedRate, PrescribedSpeed, PrismaticMode, RevoluteMode,
};
pub use bodies::{
    Body, BoxShape, CylinderShape, Inertia, InertiaTensor, Point, PointShape, PrincipalAxis, RadiiOfGyration, Shape,
    SphereShape,
};
pub use controllers::Controller;
pub use flexible::{
    CircularTube, DampingRatio, Flexible, FlexibleDamping, GeneralSection, RectangularTube, Section, StiffnessTime,
};
pub use flow::{CurrentProfile, CurrentTable, Logarithmic, PowerLaw, Wind, WindProfile};
pub use forces::Force;
pub use gusts::{ApiGusts, GustSpectrum, Gusts, KaimalGusts};
pub use integrators::{DormandPrinceSettings, GeneralizedAlphaSettings, Integrator, NewmarkSettings};
pub use joints::{FixedJoint, FloatingJoint, InitialMotion, Joint, JointPlace, PrismaticJoint, RevoluteJoint};
pub use joints_of_several_axes::{CylindricalJoint, PlanarJoint, SphericalJoint, UniversalJoint};
pub use loops::{Attachment, Constraint, Distance, Loop};
pub use mounting::Mounting;
pub use moved_by_waves::MovedByWaves;
pub use parameter::{Parameter, ParameterKind, ParameterValue};
pub use sea::{Sea, Stretching};
pub use sensors::{Sensor, Wire};
pub use sets_inputs::SetsInputs;
pub use view::{Camera, CameraPlace, View};
pub use waves::{
    ElevationRecord, Jonswap, OchiHubble, OchiHubblePart, PiersonMoskowitz, RegularWave, SpectrumTable, WaveAmplitudes,
    WaveRealisation, Waves,
};

/// One description of a run: bodies and joints, the forces and drives that act on them, and the settings.
#[fields]
pub struct Scenario<S = f64> {
    /// The version of the file format: 1.
    pub version: Version,
    /// A title of one line.
    pub title: String,
    /// A description: sources, assumptions, choices.
    #[serde(default)]
    pub description: String,
    /// The parameters that a user can change, in the order in which views show them.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub parameters: Vec<Parameter>,
    /// Time stepping and recording.
    #[serde(default)]
    pub simulation: SimulationSettings,
    /// Other files that this scenario includes, by name. In a resolved scenario their contents stand among its own
    /// bodies, loops, forces, drives and parameters.
    #[serde(default, skip_serializing_if = "mounted")]
    pub parts: IndexMap<Name, Mounting>,
    /// The bodies by name.
    #[serde(default)]
    pub bodies: IndexMap<Name, Body<S>>,
    /// Constraints between bodies in addition to their joints, by name.
    #[serde(default, skip_serializing_if = "IndexMap::is_empty")]
    pub loops: IndexMap<Name, Loop<S>>,
    /// The water, its depth and its waves.
    pub sea: Option<Sea<S>>,
    /// The wind.
    pub wind: Option<Wind<S>>,
    /// Forces on the bodies from outside, by name.
    #[serde(default)]
    pub forces: IndexMap<Name, Force<S>>,
    /// Drives between the bodies, in their joints, by name.
    #[serde(default)]
    pub drives: IndexMap<Name, Drive<S>>,
    /// Sensors by name.
    #[serde(default, skip_serializing_if = "IndexMap::is_empty")]
    pub sensors: IndexMap<Name, Sensor<S>>,
    /// Controllers by name: each stands before an input and sets it.
    #[serde(default, skip_serializing_if = "IndexMap::is_empty")]
    pub controllers: IndexMap<Name, Controller<S>>,
    /// Connections from a sensor's output to an input, by name.
    #[serde(default, skip_serializing_if = "IndexMap::is_empty")]
    pub wires: IndexMap<Name, Wire>,
    /// The timeline that moves levers and set-points.
    pub operation: Option<Operation<S>>,
    /// The task for whoever moves the levers.
    pub task: Option<Task<S>>,
    /// Limits on columns of the results, by name.
    #[serde(default, skip_serializing_if = "IndexMap::is_empty")]
    pub limits: IndexMap<Name, Limit>,
    /// Camera and plots at first.
    pub view: Option<View>,
    /// Warnings of fields of the file that the default of a parameter has replaced.
    #[serde(skip)]
    #[cfg_attr(feature = "schema", schemars(skip))]
    pub overwritten: Vec<String>,
    /// The contents of the files that it names, once read.
    #[serde(skip)]
    #[cfg_attr(feature = "schema", schemars(skip))]
    pub files: NamedFiles,
}

/// Settings that can be changed during a run like a `live` parameter: another integrator can continue with the same
/// model.
pub const LIVE_SETTINGS: [&str; 1] = ["simulation.integrator"];

/// Time stepping and recording.
#[fields(default)]
pub struct SimulationSettings {
    /// The scheme that steps the state.
    pub integrator: Integrator,
    /// The form in which the equations of motion are solved.
    pub form: EquationForm,
    /// Time step, s.
    pub step_s: Positive,
    /// Length of the run, s.
    pub duration_s: Positive,
    /// Interval between recorded rows, s.
    pub record_every_s: Positive,
    /// Whether the run begins at the equilibrium near the given positions, found without waves: a ship at its draught,
    /// heel and trim.
    pub begin_at_equilibrium: bool,
    /// A run counts as diverged when a rate exceeds this, rad/s or m/s.
    pub rate_limit: Positive,
    /// Seed of every random number in the run.
    pub seed: u64,
    /// Settings of the dormand_prince integrator.
    pub dormand_prince: DormandPrinceSettings,
    /// Settings of the newmark integrator.
    pub newmark: NewmarkSettings,
    /// Settings of the generalized_alpha integrator.
    pub generalized_alpha: GeneralizedAlphaSettings,
}

impl Default for SimulationSettings {
    fn default() -> Self {
        Self {
            integrator: Integrator::Rk4,
            form: EquationForm::Recursive,
            step_s: Positive::literal(0.001),
            duration_s: Positive::literal(10.0),
            record_every_s: Positive::literal(0.01),
            begin_at_equilibrium: false,
            rate_limit: Positive::literal(1.0e4),
            seed: 0,
            dormand_prince: DormandPrinceSettings::default(),
            newmark: NewmarkSettings::default(),
            generalized_alpha: GeneralizedAlphaSettings::default(),
        }
    }
}

/// The form in which the equations of motion are solved. The first two give the same motion.
#[fields]
#[derive(Copy, Default, Eq)]
pub enum EquationForm {
    /// The recursion: fast.
    #[default]
    Recursive,
    /// The matrices of the moving frame method, as the paper writes them.
    MovingFrame,
    /// Matrices of the moving frame method with D set to zero: wrong on purpose, to show why the restricted variation
    /// is needed.
    MovingFrameWithoutD,
}

/// A scenario that has been read holds no parts: they are mounted.
const fn mounted(_: &IndexMap<Name, Mounting>) -> bool {
    true
}

/// The default of `enabled`.
pub(crate) const fn yes() -> bool {
    true
}
