//! Declaration of an element's states, inputs, outputs and events.

use super::DrawnLine;
use serde::Serialize;

/// The states, inputs, outputs and events of an element.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Declaration {
    /// Its continuous states.
    pub states: Vec<StateDeclaration>,
    /// Names of its discrete numbers.
    pub numbers: Vec<String>,
    /// Names of its modes.
    pub modes: Vec<String>,
    /// Its inputs, which a user or a controller sets.
    pub inputs: Vec<Input>,
    /// Its outputs, in the order in which it writes them.
    pub outputs: Vec<Output>,
    /// Its drawn lines, in the order in which it writes them.
    pub lines: Vec<DrawnLine>,
    /// Its events.
    pub events: Vec<Event>,
    /// Sampling period, s, if it samples: at each multiple of the period, first at the start of the run.
    pub period_s: Option<f64>,
    /// Delay of its sampled outputs, in samples.
    pub delay_samples: usize,
    /// Whether its states stay unchanged while an equilibrium is sought, because a user has set them.
    pub keeps_states: bool,
    /// Whether it prescribes the motion of coordinates.
    pub prescribes: bool,
    /// Number of constraints that it [holds](super::Holding) in some of its modes.
    pub holds: usize,
    /// Whether it [advances](super::Advancing) its states in explicit schemes.
    pub advances: bool,
    /// Whether runs with it are stepped singly, not in lanes, because its law changes at different times in different
    /// runs.
    pub goes_alone: bool,
    /// The columns, of the model or of any element, that it [reads](super::Element::update_controls) at the start of every step.
    pub reads: Vec<String>,
    /// The inputs of other elements that it sets at the start of every step.
    pub steers: Vec<String>,
    /// Names of the other elements whose continuous states it [sees](super::Context::of_other), in the order of its use.
    pub sees: Vec<String>,
}

/// A continuous state that an element keeps.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StateDeclaration {
    /// Name, appended to the element's name.
    pub name: String,
    /// SI unit.
    pub unit: &'static str,
    /// Whether it only stores another motion, like the state of radiated waves or of a filter. A natural mode is then
    /// named after that motion.
    pub remembers: bool,
    /// Whether explicit schemes leave it to the element, which [advances](super::Advancing) it implicitly.
    pub advanced: bool,
}

impl StateDeclaration {
    /// Returns the declaration of a state of a motion.
    pub fn new(name: impl Into<String>, unit: &'static str) -> Self {
        Self { name: name.into(), unit, remembers: false, advanced: false }
    }

    /// Returns the declaration of a state that only stores another motion.
    pub fn memory(name: impl Into<String>, unit: &'static str) -> Self {
        Self { remembers: true, ..Self::new(name, unit) }
    }
}

/// A value that a user or a controller sets, constant over each step.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Input {
    /// Name in the table of all inputs.
    pub name: String,
    /// Unit of the value.
    pub unit: &'static str,
    /// Smallest value.
    pub lower: f64,
    /// Largest value.
    pub upper: f64,
    /// The value at the start.
    pub value: f64,
    /// The sampled output from which it takes its value, as a flat column (`mru.heave_rate`); `None` if the user sets
    /// it.
    pub signal: Option<String>,
}

impl Input {
    /// Returns a lever from `lower` to 1.
    pub fn lever(name: &str, lower: f64, value: f64) -> Self {
        Self { name: name.to_owned(), unit: "1", lower, upper: 1.0, value, signal: None }
    }
}

/// An output of an element. Outputs with the same name from several elements form one variable.
#[derive(Clone, Debug, PartialEq)]
pub struct Output {
    /// Name in a data set.
    pub variable: &'static str,
    /// Its description.
    pub description: &'static str,
    /// Dimension of the data set that lists the elements: `line`, for example.
    pub dimension: &'static str,
    /// Labels of the element along that dimension: its name, or one for each of its parts.
    pub labels: Vec<String>,
    /// The components of each label's value.
    pub components: Components,
    /// SI unit of each component, or one for all.
    pub units: &'static [&'static str],
    /// Frame of the components.
    pub frame: VectorFrame,
    /// Places of its labels along lines, if they are points of lines.
    pub along: Option<PlacesAlong>,
}

/// Places along lines of the labels of an output or a channel.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct PlacesAlong {
    /// Name of the line of each label.
    pub lines: Vec<String>,
    /// Place of each label on its line, as a share of the unstretched length from its first end.
    pub shares: Vec<f64>,
    /// Variable of the results with the unstretched length of each line, m.
    pub length: &'static str,
}

impl Output {
    /// Returns an output of one number of the element `name`.
    pub fn number(
        variable: &'static str,
        description: &'static str,
        dimension: &'static str,
        name: &str,
        unit: &'static [&'static str; 1],
    ) -> Self {
        Self {
            variable,
            description,
            dimension,
            labels: vec![name.to_owned()],
            components: Components::One,
            units: unit,
            frame: VectorFrame::None,
            along: None,
        }
    }

    /// Returns an output of a force and a moment of the element `name`.
    pub fn wrench(
        variable: &'static str,
        description: &'static str,
        dimension: &'static str,
        name: &str,
        frame: VectorFrame,
    ) -> Self {
        let components = Components::Wrench;
        Self { components, units: &WRENCH, frame, ..Self::number(variable, description, dimension, name, &["N"]) }
    }

    /// Returns the number of values in a row: the components of all labels.
    pub fn len(&self) -> usize {
        self.labels.len() * self.components.labels().map_or(1, <[&str]>::len)
    }

    /// Returns its flat columns, in the order of writing: `water.excitation_force.force_x`.
    pub fn columns(&self) -> impl Iterator<Item = String> + '_ {
        let of = |label: &String| {
            let lead = format!("{label}.{}", self.variable);
            match self.components.labels() {
                None => vec![lead],
                Some(components) => components.iter().map(|component| format!("{lead}.{component}")).collect(),
            }
        };
        self.labels.iter().flat_map(of)
    }

    /// Whether the output has no values.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// Units of a force and a moment.
pub const WRENCH: [&str; 6] = ["N", "N", "N", "N m", "N m", "N m"];

/// Components of the value of a label.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Components {
    /// One number.
    One,
    /// x, y, z.
    Axis,
    /// Force and moment, x, y, z each.
    Wrench,
    /// Surge, sway and yaw.
    Planar,
}

impl Components {
    /// Returns the dimension of the data set that lists the components.
    pub fn dimension(self) -> Option<&'static str> {
        match self {
            Self::One => None,
            Self::Axis => Some("axis"),
            Self::Wrench => Some("component"),
            Self::Planar => Some("planar"),
        }
    }

    /// Returns the labels of the components.
    pub fn labels(self) -> Option<&'static [&'static str]> {
        match self {
            Self::One => None,
            Self::Axis => Some(&["x", "y", "z"]),
            Self::Wrench => Some(&["force_x", "force_y", "force_z", "moment_x", "moment_y", "moment_z"]),
            Self::Planar => Some(&["surge", "sway", "yaw"]),
        }
    }
}

/// The frame of a vector's components.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum VectorFrame {
    /// World axes.
    World,
    /// The body's own axes.
    Body,
    /// The joint's axes on the child's side.
    Joint,
    /// The axes of a closed loop's first attachment.
    Loop,
    /// The axes of a contact's surface.
    Surface,
    /// Level axes that turn slowly with the hull.
    SlowFrame,
    /// Level axes that turn with the hull's heading.
    Heading,
    /// Not a vector.
    None,
}

/// An event of an element: its indicator changes sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Event {
    /// Code of the event, in words joined by `_`: the same for all elements of a kind.
    pub code: &'static str,
    /// Description of the event, for the table of events.
    pub what: &'static str,
    /// Changes of sign that are the event.
    pub crossing: Crossing,
}

/// An entry of the table of events that an element causes when it sets inputs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Occurrence {
    /// Code of the event, in words joined by `_`.
    pub code: &'static str,
    /// Description of the event.
    pub what: String,
}

/// Change of sign of an indicator that is an event.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Crossing {
    /// From negative to positive.
    Rising,
    /// From positive to negative.
    Falling,
    /// Both changes of sign.
    Either,
}

impl Crossing {
    /// Whether a change of the indicator from `before` to `after` is a crossing.
    pub fn happened(self, before: f64, after: f64) -> bool {
        let (rising, falling) = (before < 0.0 && after >= 0.0, before > 0.0 && after <= 0.0);
        match self {
            Self::Rising => rising,
            Self::Falling => falling,
            Self::Either => rising || falling,
        }
    }
}
