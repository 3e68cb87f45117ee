//! The output with a controller's command, and the declaration of controllers that pass on commands.

use super::{Declaration, Input, Output};

/// Returns the output with the command to an input of this unit, under the label `label`.
fn commanded(label: &str, unit: &str) -> Output {
    let (variable, description, unit): (_, _, &'static [&'static str; 1]) = match unit {
        "rad" => ("commanded_angle", "angle that a controller commands", &["rad"]),
        "m" => ("commanded_length", "length that a controller commands", &["m"]),
        "rad/s" => ("commanded_rate", "rate that a controller commands", &["rad/s"]),
        "m/s" => ("commanded_speed", "speed that a controller commands", &["m/s"]),
        "N m" => ("commanded_torque", "torque that a controller commands", &["N m"]),
        "N" => ("commanded_force", "force that a controller commands", &["N"]),
        _ => ("commanded_lever", "position of a lever that a controller commands", &["1"]),
    };
    Output::number(variable, description, "controller", label, unit)
}

/// Declares a controller that sets one input and takes its command as an input with the controller's name.
pub fn one_command(name: &str, to: &Input) -> Declaration {
    Declaration {
        inputs: vec![command_of(to, name)],
        outputs: vec![commanded(name, to.unit)],
        steers: vec![to.name.clone()],
        ..Declaration::default()
    }
}

/// Returns the command of an input, under the command's name.
fn command_of(to: &Input, name: &str) -> Input {
    Input { name: name.to_owned(), signal: None, ..to.clone() }
}

/// Declares a controller that passes on a command to each input that it sets, after a change by a number that it
/// `holds` between its samples. The command is an input of the controller.
pub fn changed_commands<'a>(
    holds: &str,
    steers: impl Iterator<Item = (&'a Input, &'a str)> + Clone,
    reads: Vec<String>,
) -> Declaration {
    Declaration {
        numbers: steers.clone().map(|(to, _)| format!("{holds}_{}", to.name)).collect(),
        inputs: steers.clone().map(|(to, command)| command_of(to, command)).collect(),
        outputs: steers.clone().map(|(to, command)| commanded(command, to.unit)).collect(),
        reads,
        steers: steers.map(|(to, _)| to.name.clone()).collect(),
        ..Declaration::default()
    }
}
