//! One thruster.

use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// A thruster on a hull. Its thrust, in the hull's x-y plane, follows its command as
///
/// ```text
/// T' = (T_c - T) / tau
/// ```
///
/// so it stays within the limits of the command.
#[derive(Clone, Debug)]
pub struct Thruster<S = f64> {
    /// Name.
    pub name: String,
    /// Position of the thrust relative to the held point, body axes, m.
    pub position: Vector3<S>,
    /// Its kind and limits.
    pub kind: ThrusterKind<S>,
    /// tau, s.
    pub time_constant: S,
    /// Its weight in the allocation.
    pub weight: S,
}

/// The kind of a thruster and its limits. Its thrust is one or two numbers, N.
#[derive(Clone, Copy, Debug)]
pub enum ThrusterKind<S = f64> {
    /// One direction, ahead and astern.
    Fixed {
        /// Direction of the thrust ahead: a unit vector in the x-y plane.
        direction: [S; 2],
        /// Largest thrust ahead, N.
        ahead: S,
        /// Largest thrust astern, N.
        astern: S,
    },
    /// Any direction: components along x and y.
    Azimuth {
        /// Largest thrust, N.
        limit: S,
    },
}

/// The numbers of a thrust; for a fixed thruster the second is not used.
pub type Thrust<S> = [S; 2];

impl<S: Scalar> Thruster<S> {
    /// Returns the number of components of its thrust, which are extra states.
    pub fn components(&self) -> usize {
        match self.kind {
            ThrusterKind::Fixed { .. } => 1,
            ThrusterKind::Azimuth { .. } => 2,
        }
    }

    /// Returns the unit vectors of the components, in the x-y plane.
    pub(super) fn directions(&self) -> [[S; 2]; 2] {
        match self.kind {
            ThrusterKind::Fixed { direction, .. } => [direction, [S::ZERO; 2]],
            ThrusterKind::Azimuth { .. } => [[S::ONE, S::ZERO], [S::ZERO, S::ONE]],
        }
    }

    /// Returns the largest thrust, N.
    pub fn limit(&self) -> S {
        match self.kind {
            ThrusterKind::Fixed { ahead, astern, .. } => astern.select_less(ahead, || ahead, || astern),
            ThrusterKind::Azimuth { limit } => limit,
        }
    }

    /// Returns the thrust as a force in the x-y plane, N.
    pub fn force(&self, thrust: Thrust<S>) -> [S; 2] {
        let [first, second] = self.directions();
        core::array::from_fn(|k| first[k] * thrust[0] + second[k] * thrust[1])
    }

    /// Returns the thrust with its sign, or its magnitude if it has two components, N.
    pub fn signed_thrust(&self, thrust: Thrust<S>) -> S {
        match self.kind {
            ThrusterKind::Fixed { .. } => thrust[0],
            ThrusterKind::Azimuth { .. } => length(thrust),
        }
    }

    /// Returns the thrust over the limit in its direction.
    pub fn utilisation(&self, thrust: Thrust<S>) -> S {
        match self.kind {
            ThrusterKind::Fixed { ahead, astern, .. } => {
                thrust[0].select_below(0.0, || -thrust[0] / astern, || thrust[0] / ahead)
            }
            ThrusterKind::Azimuth { limit } => length(thrust) / limit,
        }
    }

    /// Returns the largest share s of `more`, from 0 to 1, for which `base + s more` is within the limits; `base` must
    /// be within them.
    pub fn room(&self, base: Thrust<S>, more: Thrust<S>) -> S {
        match self.kind {
            ThrusterKind::Fixed { ahead, astern, .. } => {
                let (from, way) = (base[0], more[0]);
                let at_once = || S::ONE;
                let astern_share = || (from + astern) / -way;
                let ahead_share = || (ahead - from) / way;
                let share = (from + way)
                    .select_less(-astern, astern_share, || ahead.select_less(from + way, ahead_share, at_once));
                share.clipped(S::ZERO, S::ONE)
            }
            ThrusterKind::Azimuth { limit } => {
                let dot = |a: Thrust<S>, b: Thrust<S>| a[0] * b[0] + a[1] * b[1];
                let whole = [base[0] + more[0], base[1] + more[1]];
                let square = limit * limit;
                // The larger root of |base + s more|^2 = limit^2.
                let share = || {
                    let (along, way) = (dot(base, more), dot(more, more));
                    let left = square - dot(base, base);
                    let left = left.select_below(0.0, || S::ZERO, || left);
                    ((along * along + way * left).sqrt() - along) / way
                };
                square.select_less(dot(whole, whole), share, || S::ONE).clipped(S::ZERO, S::ONE)
            }
        }
    }
}

/// Returns the length; 0 with zero derivatives for a vector of length 0.
fn length<S: Scalar>(thrust: Thrust<S>) -> S {
    let square = thrust[0] * thrust[0] + thrust[1] * thrust[1];
    let root = square.select_below(f64::MIN_POSITIVE, || S::ONE, || square).sqrt();
    square.select_below(f64::MIN_POSITIVE, || S::ZERO, || root)
}
