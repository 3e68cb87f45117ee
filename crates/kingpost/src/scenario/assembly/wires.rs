//! Wires that connect outputs of sensors to inputs.

use crate::elements::{AnyElement, Layout};
use crate::scenario::assembly::FieldError;
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{Drive, Scenario, SetsInputs};
use crate::scenario::wording::one_of_with_hint;

/// Returns the name of the input whose value a servo adds to its target; the input exists if a wire is
/// connected to it.
pub fn offset_of(drive: &str) -> String {
    format!("{drive}.target_offset")
}

/// Returns whether a wire or a controller sets an input.
pub fn leads_to<S>(scenario: &Scenario<S>, input: &str) -> bool {
    let wired = || scenario.wires.values().any(|wire| wire.enabled && *wire.to == *input);
    scenario.controllers.values().any(|one| one.targets().iter().any(|(_, to)| *to == input)) || wired()
}

/// Returns the enabled wires, each as an input and the signal to which it is connected.
pub fn of<S: Quantity>(
    scenario: &Scenario<S>,
    elements: &[AnyElement<S>],
) -> Result<Vec<(String, String)>, FieldError> {
    let layout = Layout::new(elements, 0);
    let signals = layout.signals();
    let mut wires: Vec<(String, String)> = Vec::new();
    for (name, wire) in scenario.wires.iter().filter(|(_, wire)| wire.enabled) {
        let field = |end: &str| format!("wires.{name}.{end}");
        let Some(signal) = signals.iter().find(|signal| signal.name == *wire.from) else {
            let names: Vec<&str> = signals.iter().map(|signal| signal.name.as_str()).collect();
            return Err(FieldError::new(field("from"), &wire.from, allowed(&names, &wire.from, "an enabled sensor")));
        };
        let Some(place) = layout.inputs.iter().position(|input| input.name == *wire.to) else {
            return Err(no_input(scenario, &layout, field("to"), &wire.to));
        };
        if let Some(controller) = layout.set_by(place) {
            let found = format!("{}, which {controller} sets", wire.to);
            return Err(FieldError::new(field("to"), found, "an input that no controller sets"));
        }
        let input = &layout.inputs[place];
        if input.unit != signal.unit {
            let found = format!("{}, in {}", wire.from, signal.unit);
            return Err(FieldError::new(field("from"), found, format!("a signal in {}, as {}", input.unit, wire.to)));
        }
        if wires.iter().any(|(taken, _)| *taken == *wire.to) {
            return Err(FieldError::new(field("to"), format!("{} a second time", wire.to), "one wire to each input"));
        }
        wires.push((wire.to.to_string(), wire.from.to_string()));
    }
    Ok(wires)
}

/// Returns the error for the name of an input that does not exist.
pub fn no_input<S>(scenario: &Scenario<S>, layout: &Layout, field: String, found: &str) -> FieldError {
    let offsets: Vec<String> = scenario.drives.iter().filter_map(|(name, drive)| offset(name, drive)).collect();
    let inputs = layout.inputs.iter().map(|input| &input.name).filter(|input| !offsets.contains(input));
    let names: Vec<&str> = inputs.chain(&offsets).map(String::as_str).collect();
    FieldError::new(field, found, allowed(&names, found, "a drive with an input"))
}

/// Returns the allowed names as text for an error message. If `names` is empty, the text is that the scenario
/// does not have `none`, for example a drive with an input.
pub fn allowed(names: &[&str], found: &str, none: &str) -> String {
    if names.is_empty() { format!("none: the scenario does not have {none}") } else { one_of_with_hint(names, found) }
}

/// Returns the name of the offset input of an enabled servo.
fn offset<S>(name: &str, drive: &Drive<S>) -> Option<String> {
    let acts = match drive {
        Drive::Servo(servo) => servo.enabled,
        Drive::LinearServo(servo) => servo.enabled,
        _ => false,
    };
    acts.then(|| offset_of(name))
}
