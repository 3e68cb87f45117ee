//! The equations of motion, M* q'' + N* q' = F*, twice on purpose.
//!
//! [`moving_frame`] builds E, B, B', M, D, M*, N* and F* block by block as the paper does: for
//! teaching, for printing, and as the oracle. [`forward`] computes the same accelerations by
//! recursion, in time linear in the number of bodies. Tests hold them equal.
//!
//! Closed loops are [`loops`]: multipliers over the recursion, and the bordered system as its oracle. What elements hold, a
//! [`Restraint`] each, stands beside them.
//!
//! Nothing here knows where loads come from: they arrive as one struct, [`Loads`].

mod ball;
mod clock;
mod drift;
pub mod energy;
pub mod forward;
pub mod inverse;
mod kinematics;
mod link_kinematics;
mod loads;
pub mod loops;
pub mod moving_frame;
mod moving_link;
pub mod pivots;
mod restraint;

pub use clock::Clock;
pub use kinematics::Kinematics;
pub use link_kinematics::LinkKinematics;
pub use loads::{Loads, Power};
pub use restraint::Restraint;
