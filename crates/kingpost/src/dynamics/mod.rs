//! Equations of motion, M* q'' + N* q' = F*, in two independent forms.
//!
//! [`moving_frame`] builds E, B, B', M, D, M*, N* and F* block by block as in the paper: for teaching, for printing,
//! and as a reference in tests. [`forward`] computes the same accelerations by recursion, in time linear in the number
//! of bodies. Tests check that both agree.
//!
//! Closed loops are in [`loops`]: multipliers over the recursion, with the bordered system as reference. Temporary
//! constraints of elements, each a [`TemporaryConstraint`], are added to them.
//!
//! Nothing here knows where loads come from: they arrive as one struct, [`Loads`].

mod ball;
mod bias_acceleration;
mod cholesky;
mod clock;
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
mod temporary_constraint;

pub use clock::Clock;
pub use kinematics::Kinematics;
pub use link_kinematics::LinkKinematics;
pub use loads::{Loads, Power};
pub use temporary_constraint::TemporaryConstraint;
