//! Declaration that an element makes once.

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
    /// The inputs, which are set from outside.
    pub inputs: Vec<Input>,
    /// Its outputs, in the order in which it writes them.
    pub outputs: Vec<Output>,
    /// The lines that views draw of it, in the order in which it writes them.
    pub lines: Vec<DrawnLine>,
    /// Its events.
    pub events: Vec<Event>,
    /// Its sampling period, s, if it samples: at whole multiples of it, first at the start of the run.
    pub period_s: Option<f64>,
    /// Delay of its sampled outputs, in samples.
    pub delay_samples: usize,
    /// Whether its states stay as they are while an equilibrium is sought, because a user has moved them there.
    pub keeps_states: bool,
    /// Whether it prescribes the motion of coordinates.
    pub prescribes: bool,
    /// Whether it may hold a constraint.
    pub holds: bool,
    /// Whether runs with it are stepped one by one, not in lanes: its law changes in each run at a different time.
    pub goes_alone: bool,
    /// The columns, of the model or of any element, that it [reads](super::Element::update_controls) at the start of every step.
    pub reads: Vec<String>,
    /// The inputs of other elements that it sets then.
    pub steers: Vec<String>,
}

/// A continuous state that an element keeps.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StateDeclaration {
    /// Its name, which follows the name of its element.
    pub name: String,
    /// SI unit.
    pub unit: &'static str,
    /// Whether it is only a memory of another motion, as radiated waves or a filter are. A mode of the model is then
    /// named after the other motion.
    pub remembers: bool,
}

impl StateDeclaration {
    /// A state that is no memory.
    pub fn new(name: impl Into<String>, unit: &'static str) -> Self {
        Self { name: name.into(), unit, remembers: false }
    }

    /// A state that only remembers.
    pub fn memory(name: impl Into<String>, unit: &'static str) -> Self {
        Self { remembers: true, ..Self::new(name, unit) }
    }
}

/// A value that a user or a controller sets from outside, constant over each step.
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
    /// The sampled output that it takes, as a flat column (`mru.heave_rate`); `None` if the user sets it.
    pub signal: Option<String>,
}

impl Input {
    /// A lever from `lower` to 1.
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
    /// The dimension along which the elements stand: `line`, for example.
    pub dimension: &'static str,
    /// The element's labels along it: its name, or one for each of its parts.
    pub labels: Vec<String>,
    /// The components of each label's value.
    pub components: Components,
    /// SI unit of each component, or one for all.
    pub units: &'static [&'static str],
    /// Frame of the components.
    pub frame: VectorFrame,
}

impl Output {
    /// One number of the element `name`.
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
        }
    }

    /// A force and a moment of the element `name`.
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

    /// Numbers in a row of the element: all labels' components.
    pub fn len(&self) -> usize {
        self.labels.len() * self.components.labels().map_or(1, <[&str]>::len)
    }

    /// Names of its numbers as flat columns, in the order of writing: `water.excitation_force.force_x`.
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

    /// Whether no numbers are declared.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// Units of a force and a moment.
pub const WRENCH: [&str; 6] = ["N", "N", "N", "N m", "N m", "N m"];

/// The kind of a label's numbers.
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
    /// The dimension that they stand along.
    pub fn dimension(self) -> Option<&'static str> {
        match self {
            Self::One => None,
            Self::Axis => Some("axis"),
            Self::Wrench => Some("component"),
            Self::Planar => Some("planar"),
        }
    }

    /// Their labels.
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
    /// Description of the event, for the table of events.
    pub what: &'static str,
    /// Changes of sign that count.
    pub crossing: Crossing,
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
    /// Whether an indicator that was `before` and is `after` has crossed.
    pub fn happened(self, before: f64, after: f64) -> bool {
        let (rising, falling) = (before < 0.0 && after >= 0.0, before > 0.0 && after <= 0.0);
        match self {
            Self::Rising => rising,
            Self::Falling => falling,
            Self::Either => rising || falling,
        }
    }
}
