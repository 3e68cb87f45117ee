//! Fields of compensations.

pub(crate) mod forecast;
pub(crate) mod heave;
pub(crate) mod motion;
