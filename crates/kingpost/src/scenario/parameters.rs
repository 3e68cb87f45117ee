//! Parameters and overrides: values that are written into the tree of a scenario before it is converted to
//! types.

use crate::elements::significant;
use indexmap::IndexMap;
use serde_json::Value;

use super::error::{Fault, SourcePlace};
use super::reading::FromNode;
use super::schema::{Parameter, ParameterKind, ParameterValue, Scenario};
use super::tree::{Content, Field, ScenarioNode, segments, value_child};
use super::writing::ToValue;
use super::{field_search, unit_conversion, units, wording};

/// Returns whether a name is a field at the top level of a scenario: a parameter cannot have this name.
fn is_top_field(name: &str) -> bool {
    Scenario::declared_fields().iter().any(|field| field.name == name)
}

/// A value that is set by name: the name of a parameter, or the dotted path of a field.
pub(super) struct Override<'a> {
    pub(super) name: &'a str,
    pub(super) value: &'a Value,
    /// Place in a file where it is set.
    pub(super) place: SourcePlace,
}

impl<'a> Override<'a> {
    /// Creates an override that is set from outside.
    pub(super) fn from_outside((name, value): &'a (String, Value)) -> Self {
        Self { name, value, place: SourcePlace::Set(name.clone()) }
    }
}

/// A tree to be changed, and the whole scenario with every default that the tree omits.
pub(super) struct OverrideTarget<'a> {
    pub(super) tree: &'a mut ScenarioNode,
    pub(super) whole: &'a Value,
}

/// Writes the defaults of all parameters, then the overrides in their order. Returns warnings of the values in the same
/// file that defaults replace, except those that an override replaces too.
pub(super) fn apply(
    mut target: OverrideTarget<'_>,
    parameters: &[Parameter],
    overrides: &[Override<'_>],
) -> Result<Vec<String>, Fault> {
    let mut kinds = IndexMap::new();
    for (index, parameter) in parameters.iter().enumerate() {
        let definition = Definition { parameter, index };
        let kind = definition.check(&target)?;
        if kinds.insert(parameter.name.as_str(), (parameter, kind)).is_some() {
            let found = format!("{} a second time", parameter.name);
            return Err(definition.fault(&target, "name", found, "each name once"));
        }
    }
    let definitions = || parameters.iter().enumerate().map(|(index, parameter)| Definition { parameter, index });
    let replaced = definitions().flat_map(|definition| definition.replaced(&target, overrides)).collect();
    for (index, parameter) in parameters.iter().enumerate() {
        let definition = Definition { parameter, index };
        if let Some(default) = &parameter.default {
            let place = target.tree.place_of(&definition.path("default"));
            definition.write(&mut target, default, &place)?;
        }
    }
    for Override { name, value, place } in overrides {
        match kinds.get(name) {
            Some((parameter, kind)) => {
                let fault = |allowed| Fault::new(place, *name, wording::found(value), allowed);
                let value = typed_value(parameter, *kind, value).map_err(fault)?;
                for path in &parameter.writes {
                    target.write(path, &value.to_value(), place, place)?;
                }
            }
            None if is_definition(name) => {
                return Err(Fault::new(place, *name, wording::found(value), wording::SET_BY_NAME));
            }
            None if name.contains('.') || is_top_field(name) => {
                target.write(name, value, place, place)?;
            }
            None => {
                let names: Vec<&str> = kinds.keys().copied().collect();
                let paths = field_search::paths_of(target.whole, name);
                let allowed = wording::parameter_or_path(&names, name, &paths);
                return Err(Fault::new(place, *name, wording::UNKNOWN_NAME, allowed));
            }
        }
    }
    Ok(replaced)
}

/// Returns whether a path is in the list of parameters.
fn is_definition(path: &str) -> bool {
    path == "parameters" || path.starts_with("parameters.")
}

/// A parameter and its place in the list.
struct Definition<'a> {
    parameter: &'a Parameter,
    index: usize,
}

impl Definition<'_> {
    fn path(&self, field: &str) -> Vec<String> {
        segments(&format!("parameters.{}.{field}", self.index))
    }

    fn fault(
        &self,
        target: &OverrideTarget<'_>,
        field: &str,
        found: impl ToString,
        allowed: impl Into<String>,
    ) -> Fault {
        let path = self.path(field);
        Fault::new(&target.tree.place_of(&path), path.join("."), found, allowed)
    }

    /// Returns a warning for each field with another value than the default that will replace it, in the same file.
    fn replaced(&self, target: &OverrideTarget<'_>, overrides: &[Override<'_>]) -> Vec<String> {
        let Parameter { name, default: Some(default), unit, writes, .. } = self.parameter else { return Vec::new() };
        let is_set = |path: &String| overrides.iter().any(|given| given.name == name.as_str() || given.name == path);
        let place = target.tree.place_of(&self.path("default"));
        let warning = |path: &String| {
            let written = target.number_at(path)?;
            let at = target.tree.place_of(&units::si_path(&segments(path)).0);
            (at.is_in_the_file_of(&place) && !is_set(path) && !is_close(&written, default)).then(|| {
                format!(
                    "parameters.{name}: its default, {} {unit}, replaces {path}: {}, which the same file gives: write the value \
                     that holds in one of the two places",
                    shown(default),
                    shown(&written)
                )
                .replace(" ,", ",")
            })
        };
        writes.iter().filter_map(warning).collect()
    }

    /// Returns the kind of the parameter, after a check of its definition.
    fn check(&self, target: &OverrideTarget<'_>) -> Result<ParameterKind, Fault> {
        let parameter = self.parameter;
        if is_top_field(&parameter.name) {
            let found = format!("{}, a field of the scenario", parameter.name);
            return Err(self.fault(target, "name", found, wording::OWN_NAME));
        }
        let Some(first) = parameter.writes.first() else {
            return Err(self.fault(target, "writes", "an empty list", wording::PATHS));
        };
        for (index, path) in parameter.writes.iter().enumerate() {
            self.check_path(target, index, path)?;
        }
        let standing = target.number_at(first);
        let value = parameter.default.clone().or(standing);
        let Some(value) = value else {
            let allowed = wording::default_for(first);
            return Err(self.fault(target, "default", wording::NOTHING, allowed));
        };
        self.check_limits(target, value.kind())?;
        if let Some(default) = &parameter.default {
            typed_value(parameter, value.kind(), &default.to_value())
                .map_err(|allowed| self.fault(target, "default", wording::found(&default.to_value()), allowed))?;
        }
        Ok(value.kind())
    }

    fn check_path(&self, target: &OverrideTarget<'_>, index: usize, path: &str) -> Result<(), Fault> {
        let field = format!("writes.{index}");
        if is_definition(path) {
            return Err(self.fault(target, &field, wording::quoted(path), wording::PATHS));
        }
        let (si, factor) = units::si_path(&segments(path));
        target.check(&si).map_err(|NoSuchField { found, allowed }| self.fault(target, &field, found, allowed))?;
        self.check_unit(target, path, (&si, factor))
    }

    /// Checks that the unit, which views show, is that of the field as `path` writes it: a value in kN for a field in N
    /// would be a thousand times too small.
    fn check_unit(&self, target: &OverrideTarget<'_>, path: &str, (si, factor): (&[String], f64)) -> Result<(), Fault> {
        let is_name = |segment: &&String| segment.parse::<usize>().is_err();
        let quantity = si.iter().rfind(is_name).and_then(|name| units::si_ending(name));
        let Some((_, si)) = quantity else { return Ok(()) };
        let unit = &self.parameter.unit;
        match units::factor_of(unit, si) {
            Some(shown) if (shown / factor - 1.0).abs() > UNIT_ROUNDING => {
                let of_path =
                    units::units_for(si).into_iter().find(|(_, of)| (of / factor - 1.0).abs() < UNIT_ROUNDING);
                let allowed = of_path.map_or_else(|| si.to_owned(), |(unit, _)| unit);
                Err(self.fault(target, "unit", unit, format!("{allowed}, the unit of {path}")))
            }
            _ => Ok(()),
        }
    }

    fn check_limits(&self, target: &OverrideTarget<'_>, kind: ParameterKind) -> Result<(), Fault> {
        let fault = |field, found: &str, allowed: &str| Err(self.fault(target, field, found, allowed));
        match (kind, &self.parameter.range, &self.parameter.choices) {
            (ParameterKind::Choice, None, Some(choices)) if choices.is_empty() => {
                fault("choices", "an empty list", wording::CHOICES)
            }
            (ParameterKind::Choice, None, None) => fault("choices", wording::NOTHING, wording::CHOICES),
            (ParameterKind::Number, Some([least, largest]), None) if least >= largest => {
                fault("range", &format!("{least}, {largest}"), wording::RANGE)
            }
            (ParameterKind::Boolean | ParameterKind::Choice, Some(_), _) => {
                fault("range", "a range", "no range: the value is not a number")
            }
            (ParameterKind::Boolean | ParameterKind::Number, _, Some(_)) => {
                fault("choices", "choices", "no choices: the value is not a text")
            }
            _ => Ok(()),
        }
    }

    fn write(&self, target: &mut OverrideTarget<'_>, value: &ParameterValue, place: &SourcePlace) -> Result<(), Fault> {
        let writes = self.parameter.writes.iter().enumerate();
        writes.into_iter().try_for_each(|(index, path)| {
            let name_place = target.tree.place_of(&self.path(&format!("writes.{index}")));
            target.write(path, &value.to_value(), place, &name_place)
        })
    }
}

/// Returns whether two values are the same within the rounding of a unit.
fn is_close(one: &ParameterValue, other: &ParameterValue) -> bool {
    match (one, other) {
        (ParameterValue::Number(one), ParameterValue::Number(other)) => {
            (one - other).abs() <= UNIT_ROUNDING * one.abs().max(other.abs())
        }
        _ => one == other,
    }
}

/// Returns a value as a warning shows it.
fn shown(value: &ParameterValue) -> String {
    match value {
        ParameterValue::Number(number) => significant(*number, 6),
        ParameterValue::Boolean(value) => value.to_string(),
        ParameterValue::Text(text) => text.clone(),
    }
}

/// Difference of two factors between units that is rounding: units differ by factors of 2 and more.
const UNIT_ROUNDING: f64 = 1e-9;

/// The error for a path without a field.
struct NoSuchField {
    found: String,
    allowed: String,
}

impl OverrideTarget<'_> {
    /// Returns the value at a path in the file, in the unit of the path.
    fn number_at(&self, path: &str) -> Option<ParameterValue> {
        let (si, factor) = units::si_path(&segments(path));
        in_unit(&self.tree.at(&si)?.to_value(), factor)
    }

    /// Checks that a value can be written at this path: everything above it must exist; fields that do not
    /// yet exist are checked when the tree is read.
    fn check(&self, path: &[String]) -> Result<(), NoSuchField> {
        let mut node = Some(&*self.tree);
        let mut whole = Some(self.whole);
        for (depth, segment) in path.iter().enumerate() {
            let child = node.and_then(|node| node.at(std::slice::from_ref(segment)));
            let child_of_whole = whole.and_then(|whole| value_child(whole, segment));
            let is_fields = match node {
                Some(node) => matches!(node.content, Content::Fields(_)),
                None => whole.is_some_and(Value::is_object),
            };
            let may_be_new = is_fields && depth + 1 == path.len();
            if child.is_none() && child_of_whole.is_none() && !may_be_new {
                let mut names = node.map(ScenarioNode::names).unwrap_or_default();
                if let Some(fields) = whole.and_then(Value::as_object) {
                    names.extend(fields.keys().map(String::as_str));
                }
                names.sort_unstable();
                names.dedup();
                let found = wording::no_field(segment, &path[..depth].join("."));
                let entries = node.map(ScenarioNode::to_value).or_else(|| whole.cloned());
                let allowed = wording::inside(entries.as_ref(), &names, segment);
                return Err(NoSuchField { found, allowed });
            }
            node = child;
            whole = child_of_whole;
        }
        Ok(())
    }

    /// Writes a value that comes from `place` at a path that comes from `name_place`.
    pub(super) fn write(
        &mut self,
        path: &str,
        value: &Value,
        place: &SourcePlace,
        name_place: &SourcePlace,
    ) -> Result<(), Fault> {
        let written = segments(path);
        let (si, factor) = units::si_path(&written);
        self.check(&si).map_err(|NoSuchField { found, allowed }| Fault::new(name_place, path, found, allowed))?;
        let mut node = ScenarioNode::from_value(value, place);
        unit_conversion::to_si(&mut node).map_err(|mut fault| {
            fault.error.field = format!("{path}.{}", fault.error.field);
            fault
        })?;
        if factor != 1.0 {
            unit_conversion::convert(&mut node, factor);
        }
        put(self.tree, self.whole, &FieldPath { si: &si, written: &written, place: name_place }, node);
        Ok(())
    }
}

/// A path, each name in SI and as written, and its place in the file.
struct FieldPath<'a> {
    si: &'a [String],
    written: &'a [String],
    place: &'a SourcePlace,
}

/// Writes a node at a path that [`OverrideTarget::check`] has accepted; levels that exist only in the
/// defaults are copied from them.
fn put(tree: &mut ScenarioNode, whole: &Value, path: &FieldPath<'_>, node: ScenarioNode) {
    let FieldPath { si: [segment, si @ ..], written: [name, written @ ..], place } = *path else {
        *tree = node;
        return;
    };
    let below = value_child(whole, segment).unwrap_or(&Value::Null);
    let rest = FieldPath { si, written, place };
    match &mut tree.content {
        Content::Fields(fields) => {
            let new = || Field::new(place.clone(), ScenarioNode::from_value(below, place));
            let field = fields.entry(segment.clone()).or_insert_with(new);
            if si.is_empty() {
                field.name_place = place.clone();
            }
            field.written = (segment != name).then(|| name.clone());
            put(&mut field.node, below, &rest, node);
        }
        Content::List(entries) => {
            if let Some(entry) = segment.parse::<usize>().ok().and_then(|index| entries.get_mut(index)) {
                put(entry, below, &rest, node);
            }
        }
        Content::Scalar(_) => {}
    }
}

/// Converts a value to that of a parameter; the error is the allowed form. Booleans can be written as on and
/// off.
fn typed_value(parameter: &Parameter, kind: ParameterKind, value: &Value) -> Result<ParameterValue, String> {
    match kind {
        ParameterKind::Boolean => match value {
            Value::Bool(value) => Ok(ParameterValue::Boolean(*value)),
            Value::String(text) if text == "on" => Ok(ParameterValue::Boolean(true)),
            Value::String(text) if text == "off" => Ok(ParameterValue::Boolean(false)),
            _ => Err(wording::BOOLEAN.to_owned()),
        },
        ParameterKind::Number => {
            let [least, largest] = parameter.range.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
            let number = value.as_f64().filter(|number| (least..=largest).contains(number));
            let allowed = || match parameter.range {
                Some(_) => format!("a number from {least} to {largest}"),
                None => wording::NUMBER.to_owned(),
            };
            number.map(ParameterValue::Number).ok_or_else(allowed)
        }
        ParameterKind::Choice => {
            let choices = parameter.choices.as_deref().unwrap_or_default();
            let texts: Vec<String> = match value {
                Value::String(text) => vec![text.clone()],
                Value::Bool(true) => vec!["on".to_owned(), "true".to_owned()],
                Value::Bool(false) => vec!["off".to_owned(), "false".to_owned()],
                other => vec![other.to_string()],
            };
            let names: Vec<&str> = choices.iter().map(String::as_str).collect();
            let choice = choices.iter().find(|choice| texts.contains(choice));
            choice.cloned().map(ParameterValue::Text).ok_or_else(|| wording::one_of(&names))
        }
    }
}

/// Converts a scalar to the unit of a path, by the factor of that unit.
fn in_unit(value: &Value, factor: f64) -> Option<ParameterValue> {
    match value {
        Value::Bool(value) => Some(ParameterValue::Boolean(*value)),
        Value::Number(number) => Some(ParameterValue::Number(number.as_f64()? / factor)),
        Value::String(text) => Some(ParameterValue::Text(text.clone())),
        _ => None,
    }
}

impl Scenario {
    /// Returns the parameters, in the order in which views show them.
    pub fn parameters(&self) -> &[Parameter] {
        &self.parameters
    }

    /// Returns each parameter with its value in this scenario: the value of the first field that it writes,
    /// in the unit of that path. `None` if that field does not hold a single value.
    pub fn parameter_values(&self) -> Vec<(&Parameter, Option<ParameterValue>)> {
        let whole = self.to_value();
        let value = |parameter: &Parameter| {
            let (path, factor) = units::si_path(&segments(parameter.writes.first()?));
            in_unit(super::tree::value_at(&whole, &path)?, factor)
        };
        self.parameters.iter().map(|parameter| (parameter, value(parameter))).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::is_top_field;

    #[test]
    fn only_fields_at_the_top_level_are_reserved_names() {
        for name in ["version", "title", "parameters", "simulation", "bodies", "forces", "operation", "limits"] {
            assert!(is_top_field(name), "{name}");
        }
        assert!(!is_top_field("files") && !is_top_field("crane_x_m") && !is_top_field(""));
    }
}
