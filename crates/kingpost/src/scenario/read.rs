//! Text -> scenario: parse, rename units, apply parameters and overrides, type, build once to validate.

use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::Value;
use serde_path_to_error::Segment;

use super::error::{Fault, ScenarioError};
use super::files::Files;
use super::parameters::{self, Override, Target};
use super::schema::Scenario;
use super::tree::{Content, Node, segments, value_at};
#[cfg(not(target_family = "wasm"))]
use crate::plant::{Form, Number};
use crate::simulation::{Setup, Simulation};

use super::{parse, parts, wording};

/// Reads a scenario from YAML or JSON.
///
/// `file` is the name that errors carry. `overrides` are names of parameters or dotted paths of fields, each with its
/// value; they are applied in their order, after the defaults of the parameters.
///
/// # Errors
/// The first thing that is wrong, with its place: syntax, an unknown field, a wrong type, a value out of range, or
/// bodies, joints and drives that do not fit together.
pub fn read(text: &str, file: &str, overrides: &[(String, Value)]) -> Result<Scenario, ScenarioError> {
    read_with(text, file, overrides, &Files::default())
}

/// The same for a scenario that names files; see [`file_names`].
///
/// # Errors
/// As [`read`], and a file that is not there or holds something else.
pub fn read_with(
    text: &str,
    file: &str,
    overrides: &[(String, Value)],
    files: &Files,
) -> Result<Scenario, ScenarioError> {
    read_and_build(text, file, overrides, files).map(|(scenario, _)| scenario)
}

/// The same, with what a simulation of it is made of.
pub(crate) fn read_and_build(
    text: &str,
    file: &str,
    overrides: &[(String, Value)],
    files: &Files,
) -> Result<(Scenario, Setup), ScenarioError> {
    let (mut scenario, tree) = read_tree(text, file, overrides, files).map_err(|fault| fault.in_file(file))?;
    let built = scenario.take_files(files).and_then(|()| super::build::build(&scenario));
    match built {
        Ok(setup) => Ok((scenario, setup)),
        Err(error) => Err(Fault { place: tree.place_of(&segments(&error.field)), error }.in_file(file)),
    }
}

/// Names of the files that a scenario stands on, as far as the `files` that are there already tell: those of its parts,
/// and what its forces, joints and seas name. Parts name files too, so a host asks until no new name comes.
///
/// ```
/// use kingpost::scenario::{Files, file_names};
/// let text = "{version: 1, title: x, parts: {crane: {part: pedestal_crane}}}";
/// let names = file_names(text, "x.yaml", &[], &Files::default())?;
/// assert_eq!(names, ["gallery:parts/pedestal_crane.yaml"]);
/// # Ok::<(), kingpost::scenario::ScenarioError>(())
/// ```
///
/// # Errors
/// As [`read`], but for bodies, joints and drives that do not fit together, and files that are not there.
pub fn file_names(
    text: &str,
    file: &str,
    overrides: &[(String, Value)],
    files: &Files,
) -> Result<Vec<String>, ScenarioError> {
    let names = || {
        let (mut tree, overrides) = parsed(text, overrides)?;
        let (mounted, overrides) = parts::mount(&mut tree, file, overrides, files, true)?;
        let mut names = mounted.files;
        if !mounted.incomplete {
            let scenario = resolved(&mut tree, &overrides)?;
            let more = scenario.file_names().into_iter().filter(|name| !names.iter().any(|known| known == name));
            let more: Vec<String> = more.map(str::to_owned).collect();
            names.extend(more);
        }
        Ok(names)
    };
    names().map_err(|fault: Fault| fault.in_file(file))
}

/// A resolved scenario with another value of a parameter.
pub(super) fn changed(scenario: &Scenario, name: &str, value: &Value) -> Result<Scenario, ScenarioError> {
    let pair = (name.to_owned(), value.clone());
    let given = Override::from_outside(&pair);
    let mut tree = Node::from_value(&scenario.written(), &given.place);
    let resolved = resolved(&mut tree, &[given]).map_err(|fault| ScenarioError::from(fault.error))?;
    Ok(Scenario { parts: scenario.parts.clone(), files: scenario.files.clone(), ..resolved })
}

fn read_tree(text: &str, file: &str, overrides: &[(String, Value)], files: &Files) -> Result<(Scenario, Node), Fault> {
    let (mut tree, overrides) = parsed(text, overrides)?;
    let (mounted, overrides) = parts::mount(&mut tree, file, overrides, files, false)?;
    let mut scenario = resolved(&mut tree, &overrides)?;
    scenario.parts = mounted.parts;
    Ok((scenario, tree))
}

/// A text's tree, and what is set over it.
fn parsed<'a>(text: &str, overrides: &'a [(String, Value)]) -> Result<(Node, Vec<Override<'a>>), Fault> {
    let tree = parse::parse(text)?;
    check_version(&tree)?;
    Ok((tree, overrides.iter().map(Override::from_outside).collect()))
}

/// The scenario of a tree without parts, parameters and overrides in place.
fn resolved(tree: &mut Node, overrides: &[Override<'_>]) -> Result<Scenario, Fault> {
    let as_written = typed(tree)?;
    if tree.field("bodies").is_none() {
        return Err(Fault::new(&tree.place, "bodies", wording::NOTHING, wording::FIELDS));
    }
    let whole = serde_json::to_value(&as_written).unwrap_or_default();
    parameters::apply(Target { tree, whole: &whole }, &as_written.parameters, overrides)?;
    let mut scenario = typed(tree)?;
    for parameter in &mut scenario.parameters {
        parameter.default = None;
    }
    Ok(scenario)
}

pub(super) fn check_version(tree: &Node) -> Result<(), Fault> {
    match tree.field("version").map(|field| &field.node) {
        None => Err(Fault::new(&tree.place, "version", wording::NOTHING, wording::VERSION)),
        Some(node) if node.to_value().as_f64() == Some(1.0) => Ok(()),
        Some(node) => {
            let found = wording::found(&node.to_value());
            Err(Fault::new(&node.place, "version", found, wording::VERSION))
        }
    }
}

/// The types of a scenario over a tree, with the place of the first error.
pub(super) fn typed(tree: &Node) -> Result<Scenario, Fault> {
    typed_as(tree)
}

/// The same for the types of any file of ours.
pub(super) fn typed_as<T: DeserializeOwned + Serialize>(tree: &Node) -> Result<T, Fault> {
    let value = tree.to_value();
    let read: T = serde_path_to_error::deserialize(&value).map_err(|error| type_fault::<T>(tree, &value, &error))?;
    // Serde takes the fields of a type from a list too, in the order in which the type happens to have them.
    let whole = serde_json::to_value(&read).unwrap_or_default();
    list_of_fields(tree, &whole, &mut Vec::new()).map_or(Ok(read), Err)
}

/// The error of the first list that stands where fields have names.
fn list_of_fields(node: &Node, whole: &Value, path: &mut Vec<String>) -> Option<Fault> {
    let mut below = |segment: &str, node: &Node, whole: Option<&Value>| {
        path.push(segment.to_owned());
        let fault = list_of_fields(node, whole?, path);
        path.pop();
        fault
    };
    match (&node.content, whole) {
        (Content::List(_), Value::Object(_)) => {
            Some(Fault::new(&node.place, path.join("."), wording::found(&node.to_value()), wording::FIELDS))
        }
        (Content::List(entries), Value::Array(all)) => {
            entries.iter().zip(all).enumerate().find_map(|(k, (node, whole))| below(&k.to_string(), node, Some(whole)))
        }
        (Content::Fields(fields), Value::Object(all)) => {
            fields.iter().find_map(|(name, field)| below(name, &field.node, all.get(name)))
        }
        _ => None,
    }
}

pub(super) type TypeError = serde_path_to_error::Error<serde_json::Error>;

/// The path that the typed read stopped at.
pub(super) fn path_of(error: &TypeError) -> Vec<String> {
    let segment = |segment: &Segment| match segment {
        Segment::Seq { index } => Some(index.to_string()),
        Segment::Map { key } => Some(key.clone()),
        Segment::Enum { variant } => Some(variant.clone()),
        Segment::Unknown => None,
    };
    error.path().iter().filter_map(segment).collect()
}

/// A typed read's error in our words and with its place.
fn type_fault<T: DeserializeOwned>(tree: &Node, value: &Value, error: &TypeError) -> Fault {
    let mut path = path_of(error);
    let message = error.inner().to_string();
    if let Some(rest) = message.strip_prefix("unknown field ") {
        let names = wording::names_in_backquotes(rest);
        let (name, allowed) = names.split_first().map_or(("", &names[..]), |(name, rest)| (*name, rest));
        if path.last().is_none_or(|last| last.as_str() != name) || value_at(value, &path).is_none() {
            path.push(name.to_owned());
        }
        let written = tree.written_path(&path);
        let meant = written.rsplit('.').next().unwrap_or_default();
        let allowed = wording::one_of_with_hint(allowed, meant);
        return Fault::new(&tree.name_place_of(&path), &written, wording::UNKNOWN_FIELD, allowed);
    }
    if let Some(rest) = message.strip_prefix("missing field ") {
        path.extend(wording::names_in_backquotes(rest).first().map(|name| (*name).to_owned()));
    }
    let fault = name_fault(tree, &path, &message).or_else(|| kind_fault(tree, &path, &message));
    if let Some(fault) = fault.or_else(|| list_fault::<T>(tree, value, &path)) {
        return fault;
    }
    let own = expected(&message);
    let allowed = match own {
        Some(own) if message.starts_with("invalid value") && !message.starts_with("invalid value: map") => own,
        own => allowed_at::<T>(value, &path).or(own).unwrap_or_else(|| wording::REQUIRED.to_owned()),
    };
    let node = tree.at(&path);
    let found = node.map_or_else(|| wording::NOTHING.to_owned(), |node| found_in(node, &message));
    Fault::new(&tree.place_of(&path), tree.written_path(&path), found, allowed)
}

/// The error of a name that has not the form of one.
fn name_fault(tree: &Node, path: &[String], message: &str) -> Option<Fault> {
    let is_name = message.starts_with("invalid value: string") && !tree.at(path)?.to_value().is_string();
    let name = path.last().filter(|_| is_name)?;
    let field = tree.written_path(path);
    Some(Fault::new(&tree.name_place_of(path), field, wording::quoted(name), expected(message)?))
}

/// The error of a kind that is written without the fields it needs, or with fields that it has not.
fn kind_fault(tree: &Node, path: &[String], message: &str) -> Option<Fault> {
    let (kind, parent) = path.split_last()?;
    let allowed = match message.split_once(", expected ")?.1 {
        "newtype variant" => wording::with_fields(kind),
        "unit" | "unit variant" => wording::without_fields(kind),
        _ => return None,
    };
    let node = tree.at(parent)?;
    Some(Fault::new(&node.place, tree.written_path(parent), wording::found(&node.to_value()), allowed))
}

/// The error of a list that stands where fields have names: what is wrong inside of it tells nothing.
fn list_fault<T: DeserializeOwned>(tree: &Node, value: &Value, path: &[String]) -> Option<Fault> {
    let wants_fields = |path: &[String]| {
        let mut probed = value.clone();
        *slot(&mut probed, path)? = serde_json::json!({"?": null});
        let error = serde_path_to_error::deserialize::<_, T>(&probed).err()?;
        error.inner().to_string().starts_with("unknown field `?`").then_some(())
    };
    (1..=path.len()).map(|end| &path[..end]).find_map(|path| {
        let node = tree.at(path).filter(|node| matches!(node.content, Content::List(_)))?;
        wants_fields(path)?;
        Some(Fault::new(&node.place, tree.written_path(path), wording::found(&node.to_value()), wording::FIELDS))
    })
}

/// What was found: the value as written, or the name where that is what is wrong.
fn found_in(node: &Node, message: &str) -> String {
    let value = node.written_value();
    match message.strip_prefix("unknown variant ") {
        Some(rest) if value.is_object() => wording::quoted(wording::names_in_backquotes(rest).first().unwrap_or(&"")),
        _ => wording::found(&value),
    }
}

/// What a serde message says is allowed.
fn expected(message: &str) -> Option<String> {
    if message.starts_with("unknown variant ") {
        let names = wording::names_in_backquotes(message);
        return names.split_first().map(|(written, names)| wording::one_of_with_hint(names, written));
    }
    message.split_once(", expected ").map(|(_, expected)| wording::allowed(expected))
}

/// What the types allow at a path, learned by reading again with values there that nothing or only little allows. The
/// types are the one source of these words; a message about a wrong type alone would hide a range or a list of kinds.
fn allowed_at<T: DeserializeOwned>(value: &Value, path: &[String]) -> Option<String> {
    let probes = [Value::from(-1.5), Value::from("?"), serde_json::json!({"?": null})];
    let mut of_type = None;
    for probe in probes {
        let mut probed = value.clone();
        *slot(&mut probed, path)? = probe;
        let Err(error) = serde_path_to_error::deserialize::<_, T>(&probed) else { continue };
        let message = error.inner().to_string();
        if path_of(&error) != path || message.starts_with("unknown field ") {
            continue;
        }
        let Some(allowed) = expected(&message) else { continue };
        if !message.starts_with("invalid type") {
            return Some(allowed);
        }
        of_type.get_or_insert(allowed);
    }
    of_type
}

/// The value at a path; a field that is not there is made.
fn slot<'a>(value: &'a mut Value, path: &[String]) -> Option<&'a mut Value> {
    path.iter().try_fold(value, |value, segment| match value {
        Value::Object(fields) => Some(fields.entry(segment.clone()).or_insert(Value::Null)),
        Value::Array(entries) => entries.get_mut(segment.parse::<usize>().ok()?),
        _ => None,
    })
}

impl Scenario {
    /// The resolved scenario as JSON: every default written out, parameters without their defaults (their values stand
    /// in the fields). It reads back to the same scenario.
    pub fn to_json(&self) -> String {
        serde_json::to_string_pretty(self).unwrap_or_default()
    }

    /// What a simulation is made of.
    ///
    /// # Errors
    /// Bodies, joints, forces, drives or settings that do not fit together; the error has a field but no place.
    pub fn setup(&self) -> Result<Setup, ScenarioError> {
        Ok(super::build::build(self)?)
    }

    /// A simulation at time 0; where the scheme is implicit, with exact derivatives.
    ///
    /// ```
    /// let text = include_str!("../../../../scenarios/paper.yaml");
    /// let scenario = kingpost::scenario::read(text, "paper.yaml", &[])?;
    /// assert_eq!(scenario.simulation()?.time_s(), 0.0);
    /// # Ok::<(), kingpost::scenario::ScenarioError>(())
    /// ```
    ///
    /// # Errors
    /// As [`setup`](Self::setup).
    pub fn simulation(&self) -> Result<Simulation, ScenarioError> {
        self.simulation_of(self.setup()?)
    }

    /// The same from its own setup.
    pub(crate) fn simulation_of(&self, setup: Setup) -> Result<Simulation, ScenarioError> {
        #[cfg(not(target_family = "wasm"))]
        let exact = self.exact_derivatives(&setup)?;
        #[cfg_attr(target_family = "wasm", expect(unused_mut))]
        let mut simulation = Simulation::new(setup);
        #[cfg(not(target_family = "wasm"))]
        if let Some(exact) = exact {
            simulation.differentiate_with(exact);
        }
        Ok(simulation)
    }

    /// In the browser implicit schemes take differences: the engine over dual numbers would double
    /// what a phone has to load. Newton's iteration ends within its tolerance either way.
    #[cfg(not(target_family = "wasm"))]
    fn exact_derivatives(&self, setup: &Setup) -> Result<Option<Setup<Number>>, ScenarioError> {
        let wanted = setup.settings.scheme.is_implicit() && setup.settings.form == Form::Recursive;
        wanted.then(|| self.setup_over_with(setup)).transpose()
    }
}
