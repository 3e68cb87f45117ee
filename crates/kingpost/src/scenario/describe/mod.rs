//! Description of a scenario for a view, which draws it and shows its parameters.

mod afloat;
mod closing_contacts;
mod facts;
mod in_water;
mod operation;
mod under_water;
mod units;
mod warnings;

pub use afloat::{CutSpectrum, HullDescription, MeshDescription, SeaDescription, WindDescription};
pub use facts::{ElementDescription, Fact};
pub use in_water::{ImmersionDescription, ObjectInWater};
pub use operation::{MarkDescription, MoveDescription, StageDescription, StepDescription, TaskDescription};

use crate::elements::{Connection, DrawnTank, Submerged};
use crate::model::{Attachment, Loop, Model, Node};
use crate::scenario::assembly::assemble::Assemble;
use crate::scenario::assembly::flexible::{owner, shape};
use crate::scenario::assembly::view::plots;
use crate::scenario::schema::{self, LIVE_SETTINGS, Parameter, ParameterKind, ParameterValue, Scenario};
use crate::scenario::writing::ToValue;
use crate::simulation::{Limit, Setup};
use crate::spatial::{Quaternion, Twist, Vector3};
use serde::Serialize;
use serde_json::Value;

/// The description of a scenario for a view.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Description {
    /// Title of one line.
    pub title: String,
    /// The text of the scenario.
    pub description: String,
    /// Length of the run, s.
    pub duration_s: f64,
    /// Time step, s.
    pub step_s: f64,
    /// Interval between recorded rows, s.
    pub record_every_s: f64,
    /// Name of the integrator.
    pub integrator: schema::Integrator,
    /// The parts that it includes, also those within parts.
    pub parts: Vec<PartDescription>,
    /// The bodies in the order of results.
    pub bodies: Vec<BodyDescription>,
    /// Their joints, in the same order.
    pub joints: Vec<JointDescription>,
    /// The closed loops, in the order of results.
    pub loops: Vec<LoopDescription>,
    /// The loops that an input releases and engages.
    pub connections: Vec<ConnectionDescription>,
    /// The steps of the operation; none without one.
    pub steps: Vec<StepDescription>,
    /// The task for whoever moves the levers, if there is one.
    pub task: Option<TaskDescription>,
    /// The forces and the drives.
    pub elements: Vec<ElementDescription>,
    /// Acceleration of gravity, m/s^2; 0 if it is disabled.
    pub gravity_m_s2: f64,
    /// The sea, if there is one.
    pub sea: Option<SeaDescription>,
    /// The wind, if there is any.
    pub wind: Option<WindDescription>,
    /// The hulls in it, in the order of results.
    pub hulls: Vec<HullDescription>,
    /// The tanks with liquids that move.
    pub tanks: Vec<DrawnTank>,
    /// The objects that are lowered through its surface, in the order of results.
    pub objects_in_water: Vec<ObjectInWater>,
    /// The limits on columns of the results.
    pub limits: Vec<LimitDescription>,
    /// Camera and plots at first.
    pub view: ViewDescription,
    /// The parameters with their values.
    pub parameters: Vec<ParameterDescription>,
    /// Settings that can be set during a run, by their paths in the scenario.
    pub live_settings: Vec<&'static str>,
    /// Warnings about the model before it runs.
    pub warnings: Vec<String>,
}

/// A part and where it is mounted.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct PartDescription {
    /// Name of its mounting.
    pub name: String,
    /// A part of the gallery, or a file.
    pub part: String,
    /// Body on which the part is mounted, or `world`.
    pub on: String,
    /// Position in the drawing frame of that body, m.
    pub position_m: [f64; 3],
    /// Orientation of the part's axes relative to the axes of that body: roll, pitch, yaw, rad.
    pub orientation_rad: [f64; 3],
}

/// A body to draw.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct BodyDescription {
    /// Name.
    pub name: String,
    /// Parent, or `world`.
    pub parent: String,
    /// Whether it is a ship or floats like one: its joint to the world is floating or moved by waves.
    pub floats: bool,
    /// Whether a `submerged` force acts on it.
    pub is_submerged: bool,
    /// Mass, kg.
    pub mass_kg: f64,
    /// Inertia about its centre of mass, body axes, kg m^2, without added mass.
    pub inertia_kg_m2: [[f64; 3]; 3],
    /// The shape in the scenario; absent if only an inertia is given.
    pub shape: Option<schema::Shape>,
    /// Colour, as `#rrggbb`.
    pub colour: Option<schema::Colour>,
    /// Where it is at the start, if its joint is floating and its drawing frame does not begin at its centre of mass.
    pub at_start: Option<PlaceAtStart>,
}

/// The place of a floating body at the start of a run, in the world.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct PlaceAtStart {
    /// Position of the centre of mass, m.
    pub centre_of_mass_m: [f64; 3],
    /// Position of the origin of the drawing frame, m.
    pub drawing_frame_m: [f64; 3],
}

/// A joint, with its coordinates.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct JointDescription {
    /// Name.
    pub name: String,
    /// The child body.
    pub body: String,
    /// `floating`, `revolute` and so on, as in the scenario; `elastic` between the segments of a flexible body.
    pub kind: &'static str,
    /// Unit vector of the axis about which it turns, axes of the child body; absent if it has no such axis, or several.
    pub axis: Option<[f64; 3]>,
    /// Names of its coordinates that move freely.
    pub free_coordinates: Vec<String>,
    /// The given data of its prescribed motion.
    pub prescribed: Vec<Fact>,
}

/// A point on a body, or in the world.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct PointDescription {
    /// The body that carries it, or its segment if it is flexible, or `world`.
    pub body: String,
    /// Position from the body's centre of mass in body axes, or from the world's origin, m.
    pub position_m: [f64; 3],
}

/// A closed loop to draw.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct LoopDescription {
    /// Name.
    pub name: String,
    /// The attachment to the first body.
    pub first: PointDescription,
    /// The attachment to the second body.
    pub second: PointDescription,
    /// Its constraints, as named in the scenario.
    pub constraints: Vec<String>,
}

/// A loop that an input releases and engages.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ConnectionDescription {
    /// The loop.
    #[serde(flatten)]
    pub closed: LoopDescription,
    /// Whether it begins released.
    pub begins_released: bool,
}

/// A limit against which the results of a run are checked.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct LimitDescription {
    /// Its name in the scenario.
    pub name: String,
    /// The column.
    pub column: String,
    /// Unit of the bounds.
    pub unit: String,
    /// Value of this unit in the column's SI unit.
    pub unit_si: f64,
    /// The smallest value that is allowed.
    pub at_least: Option<f64>,
    /// The largest value that is allowed.
    pub at_most: Option<f64>,
    /// Time from which it applies, s.
    pub from_s: f64,
    /// Time until which it applies, s; absent if it does to the end.
    pub until_s: Option<f64>,
    /// Numbers of the steps of the operation in which it applies, from 1; none if it applies in all.
    pub steps: Vec<f64>,
    /// Percentage of the rows that must be within the bounds; 100 for all.
    pub percentile: f64,
}

/// Camera and plots with which views open the scenario.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ViewDescription {
    /// Name of the camera, or the six coordinates of the eye and of its target relative to the first body, m; empty if the view
    /// chooses it.
    pub camera: String,
    /// The columns of each plot; none if the view chooses them.
    pub plots: Vec<Vec<String>>,
}

/// A parameter of the scenario, with its value.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ParameterDescription {
    /// Name, as used in `--set`.
    pub name: String,
    /// Label for users.
    pub label: String,
    /// Unit.
    pub unit: String,
    /// Kind of control in a view.
    pub kind: ParameterKind,
    /// The value in this scenario.
    #[cfg_attr(feature = "schema", schemars(with = "ParameterValue"))]
    pub value: Value,
    /// Smallest and largest number.
    pub range: Option<[f64; 2]>,
    /// Allowed texts.
    pub choices: Option<Vec<String>>,
    /// Whether it can change during a run.
    pub live: bool,
}

impl Scenario {
    /// Describes a scenario that builds, without its disabled bodies.
    pub fn describe(&self) -> Result<Description, super::ScenarioError> {
        Ok(self.description_of(&self.setup()?))
    }

    /// Describes the scenario, with its setup.
    pub(super) fn description_of(&self, setup: &Setup) -> Description {
        let (sea, hulls) = (afloat::sea(self, setup), afloat::hulls(self, setup));
        let objects_in_water = in_water::objects(setup);
        let (view, of_view) = self.view.as_ref().map(|view| describe_view(view, setup)).unwrap_or_default();
        let Setup { model, world, elements, limits, q, .. } = setup;
        let modes = model.coordinate_names().into_iter().zip(&model.modes);
        let free: Vec<String> =
            modes.filter(|(_, mode)| **mode == crate::model::MotionType::Free).map(|(name, _)| name).collect();
        let body = |(index, (body, node)): (usize, (&crate::model::Body, &Node))| {
            let (owner, segment) = owner(&body.name);
            // A body that is not in the scenario is the liquid of a tank.
            let given = self.bodies.get(owner);
            let parent = node.parent.map_or(schema::WORLD, |parent| model.bodies[parent].name.as_str());
            BodyDescription {
                name: body.name.clone(),
                parent: parent.to_owned(),
                floats: segment == 0 && given.is_some_and(|given| afloat::floats(&given.joint)),
                is_submerged: Submerged::among(elements).any(|object| object.place.body == index),
                mass_kg: body.mass,
                inertia_kg_m2: dry_inertia(model, index, node),
                shape: given.and_then(|given| shape(given, segment)),
                colour: given.and_then(|given| given.colour.clone()),
                at_start: given.filter(|_| segment == 0).and_then(|given| place_at_start(given, node, q)),
            }
        };
        let joint = |(joint, body): (&crate::model::Joint, &crate::model::Body)| JointDescription {
            name: joint.name.clone(),
            body: body.name.clone(),
            kind: match owner(&body.name) {
                (name, 0) => self.bodies.get(name).map_or("revolute", |body| body.joint.kind()),
                _ => "elastic",
            },
            prescribed: match owner(&body.name) {
                (name, 0) => self.bodies.get(name).map_or_else(Vec::new, |body| facts::prescribed(&body.joint)),
                _ => Vec::new(),
            },
            axis: joint
                .kind
                .axis_twist()
                .map(|twist| twist.angular)
                .filter(|axis| axis.norm() > 0.0)
                .map(|axis| axis.0),
            free_coordinates: joint.coordinate_names().into_iter().filter(|name| free.contains(name)).collect(),
        };
        Description {
            title: self.title.clone(),
            description: self.description.clone(),
            duration_s: self.simulation.duration_s.get(),
            step_s: self.simulation.step_s.get(),
            record_every_s: self.simulation.record_every_s.get(),
            integrator: self.simulation.integrator,
            parts: self.parts.iter().map(|(name, mounting)| describe_part(name, mounting)).collect(),
            bodies: model.bodies.iter().zip(&model.tree.nodes).enumerate().map(body).collect(),
            joints: model.joints.iter().zip(&model.bodies).map(joint).collect(),
            loops: model.loops.iter().map(|closed| describe_loop(model, closed)).collect(),
            connections: Connection::among(elements).map(|own| describe_connection(model, own)).collect(),
            steps: operation::steps(elements),
            task: operation::task(self, model, elements),
            elements: facts::elements(self),
            gravity_m_s2: world.gravity,
            sea,
            wind: afloat::wind(setup),
            hulls,
            tanks: self.tanks(model),
            objects_in_water,
            limits: limits.iter().cloned().map(describe_limit).collect(),
            view,
            live_settings: LIVE_SETTINGS.into(),
            parameters: self.parameter_values().into_iter().map(describe_parameter).collect(),
            warnings: warnings::of(self, model, world, elements)
                .into_iter()
                .chain(warnings::at_start(self, setup))
                .chain(of_view)
                .collect(),
        }
    }
}

impl Scenario {
    /// Returns the tanks on bodies that are enabled.
    fn tanks(&self, model: &Model) -> Vec<DrawnTank> {
        let drawn = self.forces.iter().filter_map(|(name, force)| force.tank(name, self));
        drawn.filter(|tank| model.body(&tank.body).is_some()).collect()
    }
}

/// Returns the place of a floating rigid body whose centre of mass is not at the origin of its drawing frame.
fn place_at_start(given: &schema::Body, node: &Node, q: &[f64]) -> Option<PlaceAtStart> {
    let drawn_apart = given.flexible.is_none() && given.centre_of_mass_m != [0.0; 3];
    if !drawn_apart || !matches!(given.joint, schema::Joint::Floating(_)) {
        return None;
    }
    let [x, y, z, turn @ ..] = q.get(node.positions..node.positions + 7)? else { return None };
    let centre = Vector3([*x, *y, *z]);
    let rotation = Quaternion(core::array::from_fn(|k| turn[k])).to_matrix();
    let origin = centre - rotation * Vector3(given.centre_of_mass_m);
    Some(PlaceAtStart { centre_of_mass_m: centre.0, drawing_frame_m: origin.0 })
}

fn describe_part(name: &str, mounting: &schema::Mounting) -> PartDescription {
    let schema::Mounting { part, on, position_m, orientation_rad, .. } = mounting.clone();
    PartDescription { name: name.to_owned(), part, on: on.to_string(), position_m, orientation_rad }
}

fn describe_loop(model: &Model, closed: &Loop) -> LoopDescription {
    LoopDescription {
        name: closed.name.clone(),
        first: describe_point(model, &closed.first),
        second: describe_point(model, &closed.second),
        constraints: closed.constraints.iter().map(|(name, _)| name.clone()).collect(),
    }
}

fn describe_connection(model: &Model, connection: &Connection) -> ConnectionDescription {
    let [first, second] = connection.ends.each_ref().map(|end| describe_point(model, end));
    let constraints = connection.constraints.iter().map(|(name, _)| (*name).to_owned()).collect();
    let closed = LoopDescription { name: connection.name.clone(), first, second, constraints };
    ConnectionDescription { closed, begins_released: connection.begins_released }
}

/// Returns the inertia of a body without added mass.
fn dry_inertia(model: &Model, body: usize, node: &Node) -> [[f64; 3]; 3] {
    let water = || model.added_inertias.iter().filter(|(of, _)| *of == body).map(|(_, added)| added);
    let along = |column: usize| {
        let axis = core::array::from_fn(|row| if row == column { 1.0 } else { 0.0 });
        let turning = Twist { angular: Vector3(axis), linear: Vector3::zero() };
        let dry = water().fold(node.inertia.times(&turning).moment, |sum, added| sum - added.times(&turning).moment);
        dry.0
    };
    let columns: [[f64; 3]; 3] = core::array::from_fn(along);
    core::array::from_fn(|row| core::array::from_fn(|column| columns[column][row]))
}

fn describe_point(model: &Model, place: &Attachment) -> PointDescription {
    let body = place.body.map_or(schema::WORLD, |body| model.bodies[body].name.as_str());
    PointDescription { body: body.to_owned(), position_m: place.in_body.position.0 }
}

/// Describes camera and plots, with warnings of columns that do not exist.
fn describe_view(view: &schema::View, setup: &Setup) -> (ViewDescription, Vec<String>) {
    let camera = match &view.camera {
        None => String::new(),
        Some(schema::Camera::Place(place)) => {
            place.eye_m.iter().chain(&place.target_m).map(ToString::to_string).collect::<Vec<_>>().join(" ")
        }
        Some(named) => named.to_value().as_str().unwrap_or_default().to_owned(),
    };
    let (plots, warnings) = plots(view, setup);
    (ViewDescription { camera, plots }, warnings)
}

fn describe_limit(
    Limit { name, column, unit: (unit, unit_si), bounds: [at_least, at_most], from_s, until_s, steps, percentile }: Limit,
) -> LimitDescription {
    let until_s = until_s.is_finite().then_some(until_s);
    LimitDescription { name, column, unit, unit_si, at_least, at_most, from_s, until_s, steps, percentile }
}

fn describe_parameter((parameter, value): (&Parameter, Option<ParameterValue>)) -> ParameterDescription {
    let kind = value.as_ref().map_or(ParameterKind::Choice, ParameterValue::kind);
    let value = value.as_ref().map(ParameterValue::to_value).unwrap_or_default();
    ParameterDescription {
        name: parameter.name.to_string(),
        label: parameter.shown().to_owned(),
        unit: parameter.unit.clone(),
        kind,
        value,
        range: parameter.range,
        choices: parameter.choices.clone(),
        live: parameter.live,
    }
}
