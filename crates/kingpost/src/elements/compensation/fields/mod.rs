//! Fields of compensations.

pub(crate) mod heave;
pub(crate) mod motion;
