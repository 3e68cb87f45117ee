//! Texts of all errors: the found value and the allowed form.

use std::borrow::Cow;

use serde_json::Value;

use crate::scenario::units;

/// Range that a [`Positive`](super::range::Positive) allows.
pub const POSITIVE: &str = "a number greater than 0";
/// Range that a [`NonNegative`](super::range::NonNegative) allows.
pub const NON_NEGATIVE: &str = "a number not less than 0";
/// Range that a [`Fraction`](super::range::Fraction) allows.
pub const FRACTION: &str = "a number from 0 to 1";
/// Range that a [`Probability`](super::range::Probability) allows.
pub const PROBABILITY: &str = "a number greater than 0 and less than 1";
/// Range that a [`Direction`](super::range::Direction) allows.
pub const DIRECTION: &str = "three numbers, not all 0";
/// Form that a [`Name`](super::text::Name) allows.
pub const NAME: &str = "a name of small letters, digits and _ that starts with a letter";
/// Form that a [`CoordinateName`](super::text::CoordinateName) allows.
pub const COORDINATE_NAME: &str = "a name of a joint, or of an axis of a joint as joint.axis";
/// Form that a [`SignalName`](super::text::SignalName) allows.
pub const SIGNAL_NAME: &str = "a name of an input or of a column of the results, as winch or mru.measured_heave";
/// Form that a [`Colour`](super::text::Colour) allows.
pub const COLOUR: &str = "a colour as \"#rrggbb\"";
/// Value that a [`Version`](super::text::Version) allows.
pub const VERSION: &str = "1 (the version of the file format)";
/// Values that a [`ParameterValue`](super::schema::ParameterValue) allows.
pub const PARAMETER_VALUE: &str = "true or false, a number, or a text";

pub(crate) const NOTHING: &str = "nothing";
pub(crate) const FINITE: &str = "a finite number";
pub(crate) const PLAIN_SPACE: &str = "a plain space (U+0020)";
pub(crate) const BOOLEAN: &str = "true or false";
pub(crate) const NUMBER: &str = "a number";
pub(crate) const WHOLE: &str = "a whole number not less than 0";
pub(crate) const TEXT: &str = "a text";
pub(crate) const LIST: &str = "a list";
pub(crate) const FIELDS: &str = "named fields";
pub(crate) const SCENARIO: &str = "a scenario in YAML or JSON, which begins with version: 1";
pub(crate) const STUDY: &str = "a study in YAML or JSON, which begins with version: 1";
pub(crate) const UNKNOWN_FIELD: &str = "an unknown field";
pub(crate) const ASSIGNMENT: &str = "name=value";

const LONGEST_QUOTE: usize = 40;
/// Largest number of characters of an allowed name in an error: a file can contain a name of any length.
const LONGEST_NAME: usize = 120;
/// Largest number of digits and decimal points of a number that is shown in full.
const LONGEST_NUMBER: usize = 24;

/// Returns a value as text for an error.
pub(crate) fn found(value: &Value) -> String {
    match value {
        Value::Null => NOTHING.to_owned(),
        Value::Bool(value) => value.to_string(),
        Value::Number(value) => number(value),
        Value::String(value) => format!("the text {}", quoted(value)),
        Value::Array(entries) if entries.is_empty() => "an empty list".to_owned(),
        Value::Array(entries) if entries.len() <= 4 && entries.iter().all(Value::is_number) => {
            let entries: Vec<String> = entries.iter().map(found).collect();
            format!("[{}]", entries.join(", "))
        }
        Value::Array(entries) => format!("a list of {}", entries.len()),
        Value::Object(fields) if fields.is_empty() => "no fields".to_owned(),
        Value::Object(fields) => {
            let names: Vec<&str> = fields.keys().map(String::as_str).collect();
            shortened(&format!("the fields {}", names.join(", ")))
        }
    }
}

/// Returns a number as text, without the `.0` of a whole number.
fn number(number: &serde_json::Number) -> String {
    let text = number.to_string();
    text.strip_suffix(".0").map_or_else(|| text.clone(), str::to_owned)
}

/// Returns a text in which very long numbers are shown as powers of ten: 1e300, not 1 with 300 zeros.
pub(crate) fn with_powers(text: &str) -> String {
    let mut shown = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(start) = rest.find(|c: char| c.is_ascii_digit()) {
        let (before, number) = rest.split_at(start);
        let end = number.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(number.len());
        let (number, behind) = number.split_at(end);
        shown.push_str(before);
        match number.parse::<f64>() {
            Ok(value) if end > LONGEST_NUMBER => shown.push_str(&format!("{value:e}")),
            _ => shown.push_str(number),
        }
        rest = behind;
    }
    shown.push_str(rest);
    shown
}

/// Returns a text in quotes on one line, shortened if it is long.
pub(crate) fn quoted(text: &str) -> String {
    format!("{:?}", shortened(text))
}

/// Returns a text, shortened if it is long.
pub(crate) fn shortened(text: &str) -> String {
    beginning(text, LONGEST_QUOTE)
}

/// Returns a text of at most `longest` characters; a longer one is cut and followed by `...`.
pub(crate) fn beginning(text: &str, longest: usize) -> String {
    match text.char_indices().nth(longest) {
        Some((end, _)) => format!("{}...", &text[..end]),
        None => text.to_owned(),
    }
}

/// Returns a text with its control characters escaped, so that an error is on one line.
pub(crate) fn on_one_line(text: &str) -> Cow<'_, str> {
    if !text.contains(char::is_control) {
        return Cow::Borrowed(text);
    }
    let escaped = text.chars().map(|c| if c.is_control() { c.escape_debug().to_string() } else { c.to_string() });
    Cow::Owned(escaped.collect())
}

/// Returns the end of every error of a field: the found value and the allowed form, on one line.
pub(crate) fn found_and_allowed(found: &str, allowed: &str) -> String {
    format!("found {}, allowed: {}", on_one_line(found), on_one_line(allowed))
}

/// Returns names as text: `a`, `a or b`, `one of a, b, c`.
pub(crate) fn one_of(names: &[&str]) -> String {
    let shown: Vec<String> = names.iter().map(|name| beginning(name, LONGEST_NAME)).collect();
    match shown.as_slice() {
        [] => "no fields".to_owned(),
        [name] => name.clone(),
        [first, second] => format!("{first} or {second}"),
        names => format!("one of {}", names.join(", ")),
    }
}

/// Returns the allowed names, and the one that was probably meant.
pub(crate) fn one_of_with_hint(names: &[&str], written: &str) -> String {
    match nearest(names, written) {
        Some(name) => format!("{}; did you mean {}?", one_of(names), beginning(&name, LONGEST_NAME)),
        None => one_of(names),
    }
}

/// Returns the text for a list of `count` numbers.
pub(crate) fn list_of_numbers(count: usize) -> String {
    format!("a list of {count} numbers")
}

/// Returns the name most similar to `written`, also with other unit aliases, if one is similar enough.
pub(crate) fn nearest(names: &[&str], written: &str) -> Option<String> {
    // The time to compute the distance is proportional to the product of both lengths.
    let written = beginning(written, LONGEST_NAME);
    let limit = written.chars().count() / 3;
    let aliases = names.iter().flat_map(|name| units::aliases_of(name));
    let near = names
        .iter()
        .map(|name| (*name).to_owned())
        .chain(aliases)
        .map(|name| (strsim::levenshtein(&name, &written), name));
    near.min_by_key(|(distance, _)| *distance).filter(|(distance, _)| *distance <= limit).map(|(_, name)| name)
}

/// Converts a message of the YAML parser to the found value and the allowed form.
pub(crate) fn syntax(message: &str) -> (String, String) {
    let (found, allowed) = if message.contains("mapping values are not allowed") {
        (
            "a second \": \" where a value ends",
            "name: value, each on a line of its own and indented as its neighbours, or a text in quotes",
        )
    } else if message.contains("tabs disallowed") {
        ("a tab in the indentation", "spaces")
    } else if message.contains("unexpected character") {
        return (shortened_syntax(message).replace(['`', '\''], ""), SCENARIO.to_owned());
    } else if message.contains("recursion limit") || message.contains("budget breached") {
        return too_much();
    } else if message.contains("unclosed quote") || message.contains("multiline quoted scalar") {
        ("a quote that is not closed", "a closing quote")
    } else if message.contains("unclosed bracket") {
        ("a bracket that is not closed", "a closing bracket")
    } else {
        return (format!("text that is not YAML ({})", shortened_syntax(message)), SCENARIO.to_owned());
    };
    (found.to_owned(), allowed.to_owned())
}

/// Returns the first line of a parser's message, without the place that it repeats.
fn shortened_syntax(message: &str) -> &str {
    let line = message.lines().next().unwrap_or_default();
    line.split(" at line ").next().unwrap_or(line)
}

pub(crate) const EMPTY_FILE: &str = "nothing: the file is empty";

fn pair(found: &str, allowed: &str) -> (String, String) {
    (found.to_owned(), allowed.to_owned())
}

/// Returns the text for a file beyond the parser's limits.
pub(crate) fn too_much() -> (String, String) {
    pair("a file that is too deep or too large", "at most 64 levels and 250000 values")
}

/// Returns the text for a file with several documents.
pub(crate) fn second_document() -> (String, String) {
    pair("a second document after ---", "one scenario in a file")
}

/// Returns the text for an alias without its anchor.
pub(crate) fn unknown_anchor() -> (String, String) {
    pair("an alias (*name) without its anchor (&name)", "an alias whose anchor is defined before it")
}

/// Returns the text for a field whose name is null, a list or a map.
pub(crate) fn not_a_name() -> (String, String) {
    pair("a field whose name is not a text", "name: value")
}

pub(crate) const UNKNOWN_NAME: &str = "an unknown name";
pub(crate) const OWN_NAME: &str = "a name that no field at the top of the file has";
pub(crate) const PATHS: &str = "paths of fields, as bodies.ship.mass_kg";
pub(crate) const SET_BY_NAME: &str = "the name of a parameter, to set it";
pub(crate) const CHOICES: &str = "a list of the texts allowed";
pub(crate) const RANGE: &str = "two numbers, the smaller first";
pub(crate) const NO_NUMBER: &str = "no number";
pub(crate) const NO_DERIVATIVE: &str = "a number without a derivative";
pub(crate) const CONTINUOUS: &str = "a parameter, or the path of a number, that moves the model continuously";
pub(crate) const PART_THERE: &str = "a part of the gallery by its name, or an existing file";
pub(crate) const PART_ENDS: &str = "a chain of parts that ends";
pub(crate) const FEWER_PARTS: &str = "fewer";
pub(crate) const PREFIX: &str = "a name of small letters, digits and _ that starts with a letter, or \"\"";
pub(crate) const OTHER_PREFIX: &str = "a prefix that makes each name unique";
pub(crate) const OTHER_PARAMETER: &str = "a value for it in the part's parameters, or another prefix";
pub(crate) const OF_THE_PART: &str =
    "a field that a part may have: sea, wind, gravity and simulation are those of the scenario that it is mounted in";
pub(crate) const NO_REFERENCE: &str = "paths of numbers and switches: names change where a part is mounted";
pub(crate) const PLACE_OF_A_PART: &str =
    "position_m or orientation_rad of a part whose only attachments to the world are bodies at the origin";
pub(crate) const ON_THE_WORLD: &str = "world, for a part that floats, is moored or holds its position";
pub(crate) const LEVEL: &str = "roll and pitch 0";
pub(crate) const REQUIRED: &str = "a value: this field is required";

/// Returns the allowed names of an override; `paths` are those of the fields with the written name.
pub(crate) fn parameter_or_path(parameters: &[&str], written: &str, paths: &[String]) -> String {
    let allowed = match parameters {
        [] => "a dotted path of a field: the scenario has no parameters".to_owned(),
        names if paths.is_empty() => format!("a dotted path of a field, or {}", one_of_with_hint(names, written)),
        names => format!("a dotted path of a field, or {}", one_of(names)),
    };
    if paths.is_empty() { allowed } else { format!("{allowed}; did you mean {}?", paths.join(" or ")) }
}

/// Returns the text for a parameter that needs a default because the field that it writes is not in the file.
pub(crate) fn default_for(path: &str) -> String {
    format!("a default, or one value at {}", shortened(path))
}

/// Returns the text for a path to a field that does not exist.
pub(crate) fn no_field(name: &str, parent: &str) -> String {
    let kind = if name.parse::<usize>().is_ok() { "entry" } else { "field" };
    match parent {
        "" => format!("no {kind} {}", quoted(name)),
        parent => format!("no {kind} {} in {parent}", quoted(name)),
    }
}

/// Returns the form of a kind that needs its fields: `box: {...}`.
pub(crate) fn with_fields(kind: &str) -> String {
    format!("{kind} with its fields, {kind}: {{...}}")
}

/// Returns the form of a kind without fields.
pub(crate) fn without_fields(kind: &str) -> String {
    format!("the word {kind}, without fields")
}

/// Returns the allowed continuations of a path, within a value with these names.
pub(crate) fn inside(value: Option<&Value>, names: &[&str], written: &str) -> String {
    match value {
        Some(Value::Array(entries)) => match entries.len() {
            0 => "no entry: the list is empty".to_owned(),
            length => format!("an entry from 0 to {}", length - 1),
        },
        Some(Value::Object(_)) => one_of_with_hint(names, written),
        _ => "the path of a field: this one has no fields inside".to_owned(),
    }
}
