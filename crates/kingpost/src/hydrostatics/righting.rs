//! Righting arms of a loaded hull to the side of its list.

use crate::sea::hull::{HullMesh, HullTank, Loading, RightingArm, StabilityError};
use serde::Serialize;

/// Largest heel of the reported curve, deg; the curve is computed at every degree, and every fifth point is
/// kept.
const LAST_KEPT_DEG: usize = 60;
const KEPT_EVERY: usize = 5;
/// Largest heel of the search for the vanishing angle, deg.
const LAST_HEEL_DEG: usize = 90;
/// List below which the ship counts as upright, rad: the curve is then for the side with the smaller maximum
/// arm.
const UPRIGHT_RAD: f64 = 1e-6;
/// Arm below which it counts as 0, m.
const NO_ARM_M: f64 = 1e-9;
/// Number of bisection steps in the degree of heel in which an arm passes through zero.
const HALVINGS: usize = 30;

/// A side of the ship.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Side {
    /// On the left, looking forward.
    Port,
    /// On the right.
    Starboard,
}

/// GZ over the heel to one side, at constant displacement, free to trim, with hanging loads at their suspension points
/// and slack tanks level.
///
/// For a listing ship the curve is for the side of the list, where the arms are smaller; for an upright ship
/// for the side with the smaller maximum arm, or for starboard if both are equal.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct RightingArmCurve {
    /// Side to which the ship heels.
    pub side: Side,
    /// Points at heel angles from 0 to 60 deg.
    pub points: Vec<RightingArmPoint>,
    /// Heel to the curve's side at which the arm becomes positive, rad: the list, or the angle of loll.
    /// Negative if it is on the other side: linear buoyancy and the mesh can give lists to different sides.
    /// `None` if there is none up to 90 deg.
    pub equilibrium_rad: Option<f64>,
    /// Largest arm beyond the equilibrium, m, and its heel, rad, from a parabola through three angles one
    /// degree apart.
    pub largest: Option<LargestArm>,
    /// Heel at which the arm becomes negative, rad; `None` if this does not occur up to 90 deg. The range of
    /// positive stability is from the equilibrium to this angle.
    pub vanishing_rad: Option<f64>,
}

/// One point of a righting-arm curve.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct RightingArmPoint {
    /// Heel to the curve's side, rad.
    pub heel_rad: f64,
    /// Trim by the bow, rad.
    pub trim_rad: f64,
    /// GZ, m: positive if it rights the ship.
    pub arm_m: f64,
}

/// Maximum of a righting-arm curve.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct LargestArm {
    /// Heel to the curve's side, rad.
    pub heel_rad: f64,
    /// GZ, m.
    pub arm_m: f64,
}

impl Side {
    /// Returns the side of a heel, which is positive to starboard.
    pub(super) fn of(heel_to_starboard_rad: f64) -> Self {
        if heel_to_starboard_rad < 0.0 { Self::Port } else { Self::Starboard }
    }

    /// Returns the name of the side.
    pub fn name(self) -> &'static str {
        match self {
            Self::Port => "port",
            Self::Starboard => "starboard",
        }
    }

    /// Returns the sign of a heel to this side: 1 to starboard.
    fn sign(self) -> f64 {
        match self {
            Self::Port => -1.0,
            Self::Starboard => 1.0,
        }
    }
}

impl RightingArmCurve {
    /// Returns the curve of a hull that rests at this heel to starboard, rad.
    ///
    /// # Errors
    /// [`StabilityError`].
    pub(super) fn of(
        mesh: &HullMesh,
        loading: &Loading,
        tanks: &[HullTank],
        heel_rad: f64,
    ) -> Result<Self, StabilityError> {
        if heel_rad.abs() > UPRIGHT_RAD {
            return Self::to(Side::of(heel_rad), mesh, loading, tanks);
        }
        let [port, starboard] = [Side::Port, Side::Starboard].map(|side| Self::to(side, mesh, loading, tanks));
        let (port, starboard) = (port?, starboard?);
        let top = |curve: &Self| curve.largest.map_or(0.0, |largest| largest.arm_m);
        Ok(if top(&port) < top(&starboard) - NO_ARM_M { port } else { starboard })
    }

    fn to(side: Side, mesh: &HullMesh, loading: &Loading, tanks: &[HullTank]) -> Result<Self, StabilityError> {
        let at = |heels: &[f64]| -> Result<Vec<RightingArmPoint>, StabilityError> {
            let heels: Vec<f64> = heels.iter().map(|heel| side.sign() * heel).collect();
            let curve = RightingArm::curve_with_tanks(mesh, loading, tanks, &heels)?;
            let point = |point: &RightingArm| RightingArmPoint {
                heel_rad: side.sign() * point.heel,
                trim_rad: point.trim,
                arm_m: side.sign() * point.arm,
            };
            Ok(curve.iter().map(point).collect())
        };
        let arm = |heel: f64| at(&[heel]).map(|points| points[0].arm_m);
        let heels = |degrees: core::ops::RangeInclusive<usize>| -> Vec<f64> {
            degrees.map(|degrees| (degrees as f64).to_radians()).collect()
        };
        let mut points = at(&heels(0..=LAST_KEPT_DEG))?;
        // The curve goes to 60 deg even if no trim is found at large heel.
        points.extend(at(&heels(LAST_KEPT_DEG + 1..=LAST_HEEL_DEG)).unwrap_or_default());
        let positive = |point: &RightingArmPoint| point.arm_m > NO_ARM_M;
        let before = if positive(&points[0]) { before_upright(&at)? } else { Vec::new() };
        let beyond = before.len();
        let points: Vec<RightingArmPoint> = before.into_iter().chain(points).collect();
        let rise = (1..points.len()).find(|&i| !positive(&points[i - 1]) && positive(&points[i]));
        let fall = rise.and_then(|rise| (rise..points.len()).find(|&i| !positive(&points[i])));
        let crossing = |after: usize| zero(&arm, [points[after - 1].heel_rad, points[after].heel_rad]);
        let equilibrium_rad = match rise {
            Some(1) if beyond == 0 && points[0].arm_m.abs() <= NO_ARM_M => Some(0.0),
            _ => rise.map(crossing).transpose()?,
        };
        Ok(Self {
            side,
            equilibrium_rad,
            largest: rise.map(|rise| largest(&points[rise - 1..fall.unwrap_or(points.len())])),
            vanishing_rad: fall.map(crossing).transpose()?,
            points: points.into_iter().skip(beyond).take(LAST_KEPT_DEG + 1).step_by(KEPT_EVERY).collect(),
        })
    }
}

/// Returns the points at every degree of heel to the other side, from the first point whose arm is not
/// positive to the last one before 0; empty if there is no such point.
fn before_upright(
    at: &impl Fn(&[f64]) -> Result<Vec<RightingArmPoint>, StabilityError>,
) -> Result<Vec<RightingArmPoint>, StabilityError> {
    let mut found = Vec::new();
    for degrees in 1..=LAST_KEPT_DEG {
        let point = at(&[-(degrees as f64).to_radians()])?[0];
        found.insert(0, point);
        if point.arm_m <= NO_ARM_M {
            return Ok(found);
        }
    }
    Ok(Vec::new())
}

/// Returns the heel, rad, at which an arm passes through zero between two points.
fn zero(
    arm: &impl Fn(f64) -> Result<f64, StabilityError>,
    [mut from, mut to]: [f64; 2],
) -> Result<f64, StabilityError> {
    let positive_first = arm(from)? > NO_ARM_M;
    for _ in 0..HALVINGS {
        let middle = 0.5 * (from + to);
        if (arm(middle)? > 0.0) == positive_first {
            from = middle;
        } else {
            to = middle;
        }
    }
    Ok(0.5 * (from + to))
}

/// Returns the maximum of the parabola through the largest point and its two neighbours; at an end of the
/// samples, the largest point.
fn largest(points: &[RightingArmPoint]) -> LargestArm {
    let arm = |i: usize| points[i].arm_m;
    let top = (1..points.len()).fold(0, |top, i| if arm(i) > arm(top) { i } else { top });
    let (heel_rad, arm_m) = (points[top].heel_rad, arm(top));
    if top == 0 || top + 1 == points.len() {
        return LargestArm { heel_rad, arm_m };
    }
    let step = points[top + 1].heel_rad - heel_rad;
    let (slope, bend) = (0.5 * (arm(top + 1) - arm(top - 1)), arm(top + 1) - 2.0 * arm_m + arm(top - 1));
    let share = if bend < 0.0 { -slope / bend } else { 0.0 };
    LargestArm { heel_rad: heel_rad + share * step, arm_m: arm_m + 0.5 * share * slope }
}
