//! A ship's hull in the water: its mesh, its buoyancy in any position, the linear form, stability; the free surfaces of
//! its slack tanks; simple solids cut by a plane.
//!
//! All wrenches, moments and centres are in the hull's axes (x forward, y to port, z up) about the hull's origin.
//! Weight is not part of it: hydrostatics concern only hull and water. Buoyancy depends on a pose through two things,
//! which [`FloatingPosition`] holds: the height of the origin and the direction of the vertical. So the force is
//! vertical, there is no moment about the vertical, and no heading is preferred.

mod afloat;
mod box_tank;
mod linear;
mod loading;
mod mesh;
mod solids;
mod stability;
mod waterplane;
mod wave_pressure;
mod wetted;

pub use box_tank::{BoxTank, HullTank};
pub use linear::{LinearHydrostatics, Restoring};
pub use loading::{Loading, StabilityError};
pub use mesh::{HullMesh, MeshError};
pub use solids::{Below, Solid};
pub use stability::{FloatingEquilibrium, RightingArm};
pub use waterplane::Waterplane;
pub use wave_pressure::LocalWater;
pub use wetted::{Buoyancy, WettedHull};

use crate::scalar::Scalar;
use crate::spatial::{Frame, Vector3};

/// The position of a hull relative to water at rest. The height of a point r of the hull is `h = z0 + n . r`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FloatingPosition<S = f64> {
    /// z0: height of the hull's origin above the still water plane, m.
    pub height: S,
    /// n: the world's vertical in the hull's axes, the third row of R; a unit vector.
    pub vertical: Vector3<S>,
}

impl<S: Scalar> FloatingPosition<S> {
    /// Returns the floating position of a hull with this pose in the world.
    #[inline]
    pub fn of(hull_in_world: &Frame<S>) -> Self {
        Self { height: hull_in_world.position[2], vertical: hull_in_world.rotation.row(2) }
    }

    /// Upright, with the origin at this height above the water, m.
    pub fn upright(height: S) -> Self {
        Self { height, vertical: Vector3::new(S::ZERO, S::ZERO, S::ONE) }
    }

    /// With heel to starboard and trim by the bow (conventions: roll and pitch), rad.
    pub fn heeled(height: S, heel: S, trim: S) -> Self {
        let ((sin_heel, cos_heel), (sin_trim, cos_trim)) = (heel.sin_cos(), trim.sin_cos());
        Self { height, vertical: Vector3::new(-sin_trim, cos_trim * sin_heel, cos_trim * cos_heel) }
    }
}
