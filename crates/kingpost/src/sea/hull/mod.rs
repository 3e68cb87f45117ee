//! Hull of a ship in the water: mesh, buoyancy in any position, linear hydrostatics, stability, free surfaces
//! of slack tanks; also simple solids cut by a plane.
//!
//! All wrenches, moments and centres are in the hull's axes (x forward, y to port, z up) about the hull's
//! origin. They do not contain the weight: hydrostatics concern only hull and water. Buoyancy depends on two
//! properties of a pose, which [`FloatingPosition`] holds: the height of the origin and the direction of the
//! vertical. So the force is vertical, there is no moment about the vertical, and the heading has no effect.

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

/// Position of a hull relative to water at rest. The height of a point r of the hull is `h = z0 + n . r`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FloatingPosition<S = f64> {
    /// Height z0 of the hull's origin above the still water plane, m.
    pub height: S,
    /// Vertical n of the world in the hull's axes, the third row of R; a unit vector.
    pub vertical: Vector3<S>,
}

impl<S: Scalar> FloatingPosition<S> {
    /// Returns the floating position of a hull with this pose in the world.
    #[inline]
    pub fn of(hull_in_world: &Frame<S>) -> Self {
        Self { height: hull_in_world.position[2], vertical: hull_in_world.rotation.row(2) }
    }

    /// Returns the upright position with the origin at this height above the water, m.
    pub fn upright(height: S) -> Self {
        Self { height, vertical: Vector3::new(S::ZERO, S::ZERO, S::ONE) }
    }

    /// Returns the position with heel to starboard and trim by the bow, rad (signs of roll and pitch).
    pub fn heeled(height: S, heel: S, trim: S) -> Self {
        let ((sin_heel, cos_heel), (sin_trim, cos_trim)) = (heel.sin_cos(), trim.sin_cos());
        Self { height, vertical: Vector3::new(-sin_trim, cos_trim * sin_heel, cos_trim * cos_heel) }
    }
}
