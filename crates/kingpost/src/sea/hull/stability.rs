//! Floating position of a loaded hull, and its righting arms.

use super::afloat::{Afloat, EquilibriumSearch, heel_of, tangents, trim_of};
use super::{Buoyancy, FloatingPosition, HullMesh, HullTank, Loading, StabilityError, Waterplane};
use crate::spatial::Vector3;

/// A loaded hull at rest in still water.
///
/// If a loading, such as a symmetric one, balances exactly in an unstable position, this position is found;
/// its metacentric height is negative.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FloatingEquilibrium {
    /// Position of the hull.
    pub position: FloatingPosition,
    /// Heel to starboard, rad.
    pub heel: f64,
    /// Trim by the bow, rad.
    pub trim: f64,
    /// Depth of the hull's lowest point, m.
    pub draught: f64,
    /// Buoyancy of the hull.
    pub buoyancy: Buoyancy,
    /// Waterplane of the hull.
    pub waterplane: Waterplane,
    /// KB: height of the centre of buoyancy above the keel, which is the hull's lowest vertex, along the
    /// hull's z, m.
    pub keel_to_buoyancy: f64,
    /// BM across and along the ship, `I / V`, m.
    pub metacentric_radius: [f64; 2],
    /// GM across and along the ship: BM plus the height of the centre of buoyancy above that of gravity, m.
    pub metacentric_height: [f64; 2],
}

/// One point of a righting-arm curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RightingArm {
    /// The position of the hull.
    pub position: FloatingPosition,
    /// Heel to starboard, rad.
    pub heel: f64,
    /// Trim by the bow at which the trimming moment is 0, rad.
    pub trim: f64,
    /// GZ: distance of the line of action of buoyancy from the centre of gravity, positive to starboard, m.
    pub arm: f64,
}

impl FloatingEquilibrium {
    /// Finds draught, heel and trim at which weight and buoyancy balance: a stationary point of `Phi / W = z0
    /// + n . c - H / V` at constant displacement, by Newton's method with downhill steps from the upright
    /// position (c is the centre of gravity; see [`Buoyancy`]).
    ///
    /// # Errors
    /// [`StabilityError`].
    pub fn find(mesh: &HullMesh, loading: &Loading) -> Result<Self, StabilityError> {
        let mut floating = EquilibriumSearch::new(mesh, loading, &[])?;
        let afloat = floating.settle(FloatingPosition::upright(0.0).vertical, true)?;
        let Afloat { position, buoyancy, waterplane } = afloat;
        let lever = floating.lever(&afloat);
        let metacentric_radius = tangents(position.vertical).map(|t| waterplane.second_moment(t, t) / buoyancy.volume);
        let lever_up = lever.dot(position.vertical);
        Ok(Self {
            position,
            heel: heel_of(position.vertical),
            trim: trim_of(position.vertical),
            draught: -position.height - mesh.extent_along(position.vertical).0,
            buoyancy,
            waterplane,
            keel_to_buoyancy: buoyancy.centre()[2] - mesh.extent_along(Vector3::new(0.0, 0.0, 1.0)).0,
            metacentric_radius,
            metacentric_height: metacentric_radius.map(|radius| radius + lever_up),
        })
    }
}

impl RightingArm {
    /// Computes the curve at these angles of heel, rad, at constant displacement, free to trim.
    ///
    /// # Errors
    /// [`StabilityError`].
    pub fn curve(mesh: &HullMesh, loading: &Loading, heels: &[f64]) -> Result<Vec<Self>, StabilityError> {
        Self::curve_with_tanks(mesh, loading, &[], heels)
    }

    /// Computes the curve of a hull with slack tanks. The centre of gravity of the loading includes the
    /// liquid at its position in the upright hull; at each heel and trim the liquid is level.
    ///
    /// # Errors
    /// [`StabilityError`].
    pub fn curve_with_tanks(
        mesh: &HullMesh,
        loading: &Loading,
        tanks: &[HullTank],
        heels: &[f64],
    ) -> Result<Vec<Self>, StabilityError> {
        let mut floating = EquilibriumSearch::new(mesh, loading, tanks)?;
        let mut trim_before = 0.0;
        let mut point = |&heel: &f64| {
            if !heel.is_finite() {
                return Err(StabilityError::Loading { quantity: "the heel", found: heel, allowed: "a finite number" });
            }
            let start = FloatingPosition::heeled(0.0, heel, trim_before).vertical;
            let afloat = floating.settle(start, false)?;
            let position = afloat.position;
            trim_before = trim_of(position.vertical);
            let arm = -floating.lever(&afloat).dot(tangents(position.vertical)[0]);
            Ok(Self { position, heel, trim: trim_before, arm })
        };
        heels.iter().map(&mut point).collect()
    }
}
