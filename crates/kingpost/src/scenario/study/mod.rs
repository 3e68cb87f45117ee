//! Study file: many runs of one scenario, the values in which they differ, and the results that are kept. The
//! types of this module are its schema, as for a scenario; the program that runs a study resolves its names
//! against the scenario.

mod check;

use indexmap::IndexMap;
use kingpost_derive::fields;
use serde_json::Value;

use super::error::{Fault, ScenarioError, SourcePlace};
use super::range::{NonNegative, Positive, Probability};
use super::reading::{check_version, read as read_types};
use super::schema::{Limit, Name, ParameterValue, Version};
use super::tree::{Content, ScenarioNode};
use super::{parse, wording};

/// Largest number of runs in one study: more are probably a mistake.
pub const MOST_RUNS: u64 = 1_000_000;
/// Largest number of seeds in one study.
pub const MOST_SEEDS: u64 = 100_000;
/// Largest number of peaks that are kept of a column in a run.
pub const MOST_PEAKS: u64 = 1_000;

/// Many runs of one scenario: every case of the axes with every seed, and what is kept of each run.
#[fields]
pub struct Study {
    /// The version of the file format: 1.
    pub version: Version,
    /// Title of one line.
    pub title: String,
    /// Description of the study, for its readers.
    #[serde(default)]
    pub description: String,
    /// The scenario: a file beside the study, or a name of the gallery.
    pub scenario: String,
    /// Values that all runs set over the scenario: of parameters, or of fields by their dotted paths.
    #[serde(default)]
    pub set: IndexMap<String, Value>,
    /// Axes along which the cases differ: each names a parameter of the scenario, or a field by its dotted path. The
    /// cases are every combination, the last axis fastest; axes that are drawn together, of a Latin hypercube or of a
    /// scatter table, count as one.
    #[serde(default)]
    pub axes: IndexMap<String, StudyAxis>,
    /// How axes `latin_hypercube` are drawn.
    pub samples: Option<Samples>,
    /// Seeds of every case; all cases have the same ones.
    #[serde(default)]
    pub seeds: Seeds,
    /// Time at the start of each run that statistics, limits and extremes exclude, s.
    #[serde(default)]
    pub after_s: NonNegative,
    /// Columns whose statistics are kept, besides those of the limits: `hull.roll`; `*` stands for any text, as in `hull.*`.
    #[serde(default)]
    pub record: Vec<String>,
    /// Cycles that are counted for fatigue.
    pub rainflow: Option<Rainflow>,
    /// Largest independent peaks that are kept of each run.
    pub peaks: Option<Peaks>,
    /// Limits, over those of the scenario: one of the same name replaces it.
    #[serde(default)]
    pub limits: IndexMap<Name, Limit>,
    /// Duration to which extremes of stationary runs are extrapolated, s. By default the duration of a run
    /// without the time at its start that is excluded. Refused for runs that happen once.
    pub operation_s: Option<Positive>,
    /// Whether a run is an operation that happens once: its largest value is a sample over the seeds and is not
    /// extrapolated. By default true if the scenario has an enabled operation.
    pub one_off: Option<bool>,
    /// Steps of the operation that are stationary, by their names, with the duration to which the extremes of each are
    /// extrapolated, s.
    #[serde(default)]
    pub stationary_steps: IndexMap<String, Positive>,
    /// Probability, chosen by the user, with which a limit may be exceeded in the operation.
    #[serde(default = "acceptance")]
    pub acceptance: Probability,
    /// Scatter table, a file in the study's folder: frequency of occurrence of each sea state.
    pub scatter: Option<String>,
    /// Axis that sets each quantity of the sea. Without it, the axes that write these fields of the sea set them.
    #[serde(default)]
    pub sea: StudySea,
}

/// The values of an axis.
#[fields]
#[cfg_attr(feature = "schema", schemars(rename = "Axis"))]
pub enum StudyAxis {
    /// Values given one by one.
    Values(Vec<ParameterValue>),
    /// Numbers at equal intervals.
    Range(EvenRange),
    /// Numbers drawn together with those of the other axes of this kind; `samples` gives how many.
    LatinHypercube(DrawnInterval),
    /// Sea states that occur in the scatter table, together with the other axis of this kind.
    Scatter(ScatterQuantity),
}

/// Numbers at equal intervals, including the first and the last.
#[fields]
pub struct EvenRange {
    /// The first.
    pub from: f64,
    /// The last.
    pub to: f64,
    /// Number of values, 2 or more.
    pub count: u64,
}

/// An interval from which numbers are drawn.
#[fields]
#[cfg_attr(feature = "schema", schemars(rename = "Interval"))]
pub struct DrawnInterval {
    /// Its lower end.
    pub from: f64,
    /// Its upper end.
    pub to: f64,
}

/// Quantity that an axis takes from the scatter table.
#[fields]
#[derive(Copy, Eq)]
pub enum ScatterQuantity {
    /// The significant wave height, m.
    SignificantHeight,
    /// The peak period, s.
    PeakPeriod,
}

/// How axes `latin_hypercube` are drawn.
#[fields]
pub struct Samples {
    /// Number of samples.
    pub count: u64,
    /// Seed from which the samples are drawn.
    #[serde(default = "one")]
    pub seed: u64,
}

/// The seeds of every case.
#[fields(default)]
pub struct Seeds {
    /// The first.
    pub first: u64,
    /// Number of seeds.
    pub count: u64,
}

impl Default for Seeds {
    fn default() -> Self {
        Self { first: 1, count: 1 }
    }
}

/// Cycles that are counted by rainflow (ASTM E1049), and sums of their ranges to a power: the damage of an
/// S-N curve with this slope, except for its constant.
#[fields]
pub struct Rainflow {
    /// Columns, `*` as in `record`.
    pub columns: Vec<String>,
    /// The powers.
    pub slopes: Vec<Positive>,
}

/// Largest independent peaks: the largest between each two up-crossings of the mean.
#[fields]
pub struct Peaks {
    /// Columns, `*` as in `record`.
    pub columns: Vec<String>,
    /// Number of peaks that are kept of each run.
    #[serde(default = "peaks_kept")]
    pub keep: u64,
}

/// Axis that sets each quantity of the sea.
#[fields(default)]
#[derive(Default)]
#[cfg_attr(feature = "schema", schemars(rename = "SeaAxes"))]
pub struct StudySea {
    /// The axis of the significant wave height, m.
    pub significant_height: Option<String>,
    /// The axis of the peak period, s.
    pub peak_period: Option<String>,
    /// The axis of the direction.
    pub direction: Option<String>,
}

fn acceptance() -> Probability {
    Probability::literal(0.1)
}

const fn one() -> u64 {
    1
}

const fn peaks_kept() -> u64 {
    32
}

/// Places of the values in a study's text, as line and column from 1, by their dotted paths.
pub type Places = IndexMap<String, [usize; 2]>;

/// Reads a study from YAML or JSON, with the places of its values. `file` is the name that errors carry.
///
/// ```
/// use kingpost::scenario::study;
/// let text = "{version: 1, title: Slew, scenario: paper, axes: {crane_x_m: {values: [-10, 0]}}, seeds: {count: 3}}";
/// let (read, places) = study::read(text, "slew.yaml")?;
/// assert_eq!((read.axes.len(), read.seeds.count), (1, 3));
/// assert_eq!(places["axes.crane_x_m"], [1, 62]);
/// # Ok::<(), kingpost::scenario::ScenarioError>(())
/// ```
///
/// # Errors
/// The first error, with its place: syntax, an unknown field, a wrong type, a value out of range,
/// incompatible axes. Names that refer to the scenario are not checked.
pub fn read(text: &str, file: &str) -> Result<(Study, Places), ScenarioError> {
    let typed = || {
        let tree = parse::parse_as(text, wording::STUDY)?;
        check_version(&tree)?;
        let study: Study = read_types(&tree)?;
        check::all(&study).map_err(|(path, error)| Fault { place: tree.place_of(&path), error })?;
        let mut places = Places::new();
        list_places(&tree, "", &mut places);
        Ok((study, places))
    };
    typed().map_err(|fault: Fault| fault.in_file(file))
}

/// Adds the place of a node and of all nodes below it.
fn list_places(node: &ScenarioNode, path: &str, places: &mut Places) {
    if let SourcePlace::File { line, column } = node.place {
        places.insert(path.to_owned(), [line, column]);
    }
    let below = |name: &str| if path.is_empty() { name.to_owned() } else { format!("{path}.{name}") };
    match &node.content {
        Content::Scalar(_) => {}
        Content::List(entries) => {
            entries.iter().enumerate().for_each(|(k, entry)| list_places(entry, &below(&k.to_string()), places));
        }
        Content::Fields(fields) => {
            fields.iter().for_each(|(name, field)| list_places(&field.node, &below(name), places))
        }
    }
}
