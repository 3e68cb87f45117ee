//! Lie groups in small fixed-size types: SO(3), SE(3), twists, wrenches and 6x6 inertia.
//!
//! Equation numbers are those of Jardim, Rein, Haveland, Rykkje & Impelluso (2019),
//! doi 10.1115/1.4042536. Spatial quantities are body components about the body's centre of mass,
//! angular part first.

mod cross_inertia;
mod exponential;
mod frame;
mod inertia;
mod matrix;
mod quaternion;
mod rigid_inertia;
mod rotation;
mod twist;
mod vector;

pub use cross_inertia::CrossInertia;
pub use exponential::exponential;
pub use frame::Frame;
pub use inertia::SpatialInertia;
pub use matrix::{Matrix3, Symmetric3};
pub use quaternion::Quaternion;
pub use rigid_inertia::RigidInertia;
pub use rotation::{
    dexp_inverse_body, exp, hat, log, log_of_part_turn, roll_pitch_yaw, rotation_from_roll_pitch_yaw, vee,
};
pub use twist::{Twist, Wrench};
pub use vector::Vector3;
