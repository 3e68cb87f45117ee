//! Stretching: the continuation of linear wave kinematics from the still water level to the moving surface.

use crate::scalar::Scalar;

/// Method by which linear kinematics, known up to the still water level, continue to the moving surface.
///
/// With the height z above the still water level, the elevation, the depth h and the linear field u(z), the field at a
/// point below the surface is (DNV-RP-C205, *Environmental conditions and environmental loads*, sec. 3.3.3)
///
/// ```text
/// none           u(z) for z <= 0, no motion of the water above
/// vertical       u(min(z, 0))
/// Wheeler        u((z - elevation) / (1 + elevation / h))
/// extrapolated   u(z) for z <= 0, u(0) + z du/dz(0) above
/// ```
///
/// With Wheeler's method (*Journal of Petroleum Technology* 22, 1970, p. 359) the pressure at the surface is
/// exactly atmospheric, and kinematics change at every depth; with the other methods they do not change below
/// the still water level.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Stretching {
    /// No motion and no dynamic pressure above the still water level.
    None,
    /// Kinematics above the still water level equal those at this level.
    #[default]
    Vertical,
    /// Wheeler's method: the column of water is stretched from the bottom to the surface.
    Wheeler,
    /// Kinematics above the still water level continue along their tangent at this level.
    Extrapolated,
}

/// Height at which linear kinematics are evaluated, and their continuation from there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct StretchedHeight<S> {
    /// Height in still water, from -h to 0, m.
    pub z: S,
    /// Height above the still water level over which kinematics are extrapolated, m; 0 with other methods.
    pub rise: S,
}

/// Smallest share of the depth that remains under a trough with Wheeler's stretching: a trough below the
/// bottom is not physical, but must not cause a division by zero.
const LEAST_DEPTH: f64 = 1e-3;

impl Stretching {
    /// Returns the height in still water whose field applies at the height z, m, for this elevation, m.
    pub(super) fn height<S: Scalar>(self, z: S, elevation: S, depth_m: Option<f64>) -> StretchedHeight<S> {
        let bottom = S::constant(-depth_m.unwrap_or(f64::INFINITY));
        let (z, rise) = match self {
            Self::None | Self::Vertical => (z, S::ZERO),
            Self::Wheeler => (wheeler(z - elevation, elevation, depth_m), S::ZERO),
            Self::Extrapolated => {
                let wet = z.select_less(elevation, || z, || elevation);
                (z, wet.select_below(0.0, || S::ZERO, || wet))
            }
        };
        StretchedHeight { z: z.clipped(bottom, S::ZERO), rise }
    }

    /// Returns a value of the water's motion at the height z, m: zero above the still water level if the
    /// method does not continue the motion.
    pub(super) fn moving<S: Scalar>(self, z: S, value: S) -> S {
        if self != Self::None {
            return value;
        }
        S::ZERO.select_less(z, || S::ZERO, || value)
    }

    /// Returns the dynamic pressure, Pa, at the height z, m, in water of this specific weight, N/m^3: if the
    /// method does not continue it, the pressure above the still water level is atmospheric.
    pub(super) fn pressure<S: Scalar>(self, z: S, specific_weight: S, pressure: S) -> S {
        if self != Self::None {
            return pressure;
        }
        S::ZERO.select_less(z, || z * specific_weight, || pressure)
    }
}

fn wheeler<S: Scalar>(below_surface: S, elevation: S, depth_m: Option<f64>) -> S {
    let Some(depth_m) = depth_m else { return below_surface };
    let stretch = S::ONE + elevation / S::constant(depth_m);
    below_surface / stretch.select_below(LEAST_DEPTH, || S::constant(LEAST_DEPTH), || stretch)
}
