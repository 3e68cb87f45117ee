//! The output that shows what a controller commands.

use super::Output;

/// What the controller commands an input of this unit to be, as a column of `label`.
pub fn commanded(label: &str, unit: &str) -> Output {
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
