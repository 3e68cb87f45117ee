//! Fields of sensors of the crane and of the errors of all sensors.

pub(crate) mod crane;
pub(crate) mod errors;
