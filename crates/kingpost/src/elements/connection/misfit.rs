//! The misfit of two attachments, along and about the axes that constraints hold.

use crate::model::Constraint;
use crate::scalar::Scalar;
use crate::spatial::{Frame, Vector3};

/// Largest misfit with which a connection engages.
#[derive(Clone, Copy, Debug)]
pub struct PoseTolerance<S = f64> {
    /// m.
    pub distance: S,
    /// rad.
    pub angle: S,
}

/// Misfit of the second of two attachments relative to the first.
#[derive(Clone, Copy, Debug)]
pub struct Misfit<S = f64> {
    /// Length of its offset along the constrained axes, m.
    pub distance: S,
    /// Angle about the constrained axes, from 0 to pi, rad: of the whole rotation if all three are constrained, and of the axis
    /// of a hinge if two are.
    pub angle: S,
}

impl<S: Scalar> PoseTolerance<S> {
    /// Returns the largest share of a tolerance by which a misfit exceeds it; negative within both.
    pub fn exceeded(&self, misfit: &Misfit<S>) -> S {
        let [far, turned] = [misfit.distance / self.distance, misfit.angle / self.angle];
        far.select_less(turned, || turned, || far) - S::ONE
    }
}

impl<S: Scalar> Misfit<S> {
    /// Returns the misfit for constraints, from the pose of the second attachment in the axes of the first.
    pub fn new(pose: &Frame<S>, constraints: &[Constraint<S>]) -> Self {
        let mut offset = Vector3::zero();
        let mut turns = Vec::new();
        for constraint in constraints {
            match *constraint {
                Constraint::Offset(axis) => offset[axis] = pose.position[axis],
                Constraint::Perpendicular { first, second } => turns.push((first, second)),
                Constraint::Distance(_) => {}
            }
        }
        Self { distance: length(offset.norm_squared()), angle: angle(pose, &turns) }
    }
}

/// Returns the angle of constrained rotations.
fn angle<S: Scalar>(pose: &Frame<S>, turns: &[(usize, usize)]) -> S {
    let axes = [0, 1, 2].map(|axis| pose.rotation.column(axis));
    let half = S::constant(0.5);
    match *turns {
        [] => S::ZERO,
        [(first, second)] => {
            let sine = axes[second][first];
            let cosine = (axes[first][first] + axes[second][second]) * half;
            sine.select_below(0.0, || -sine, || sine).atan2(cosine)
        }
        // The axis of the hinge is the second one of both.
        [(_, hinge), _] => {
            let [x, y, z] = axes[hinge].0;
            let across = [x, y, z].into_iter().enumerate().filter(|(axis, _)| *axis != hinge);
            let sine = length(across.fold(S::ZERO, |sum, (_, part)| sum + part * part));
            sine.atan2(axes[hinge][hinge])
        }
        _ => {
            let twice = Vector3([axes[1][2] - axes[2][1], axes[2][0] - axes[0][2], axes[0][1] - axes[1][0]]);
            let cosine = (axes[0][0] + axes[1][1] + axes[2][2] - S::ONE) * half;
            (length(twice.norm_squared()) * half).atan2(cosine)
        }
    }
}

/// Returns the square root of a sum of squares, 0 where it would have no derivative.
fn length<S: Scalar>(squares: S) -> S {
    squares.select_below(f64::MIN_POSITIVE, || S::ZERO, || squares.sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::RotationAxis::{self, Pitch, Roll, Yaw};
    use crate::spatial::exp;

    /// The misfit of an offset of (3, 4, 12) m and a rotation, with these constraints.
    fn misfit(rotation: [f64; 3], offsets: &[usize], turns: &[RotationAxis]) -> Misfit {
        let constraints = offsets.iter().map(|axis| Constraint::Offset(*axis));
        let constraints: Vec<_> =
            constraints.chain(turns.iter().map(|turn| Constraint::rotation(*turn, turns))).collect();
        Misfit::new(&Frame { rotation: exp(Vector3(rotation)), position: Vector3([3.0, 4.0, 12.0]) }, &constraints)
    }

    #[test]
    fn only_constrained_axes_misfit() {
        for (rotation, offsets, turns, distance, angle) in [
            ([0.3, 0.0, 0.0], vec![0, 1, 2], vec![Roll, Pitch, Yaw], 13.0, 0.3),
            ([0.0, 2.8, 0.0], vec![0, 1], vec![Roll, Pitch, Yaw], 5.0, 2.8),
            ([0.0, 0.9, 0.0], vec![0], vec![Roll, Yaw], 3.0, 0.0),
            ([2.0, 0.0, 0.0], vec![], vec![Roll, Yaw], 0.0, 2.0),
            ([0.0, 0.0, -0.2], vec![2], vec![Yaw], 12.0, 0.2),
            ([0.0, 0.0, 3.0], vec![2], vec![Yaw], 12.0, 3.0),
        ] {
            let found = misfit(rotation, &offsets, &turns);
            assert!((found.distance - distance).abs() < 1e-14 && (found.angle - angle).abs() < 1e-14, "{found:?}");
        }
    }
}
