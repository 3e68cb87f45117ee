//! Floating link, whose frame is that of its branch.

use crate::model::joint::Floating;
use crate::scalar::Scalar;
use crate::spatial::{Matrix3, SpatialInertia, Twist, Vector3, Wrench};

/// Returns the force along the link's coordinates in root axes; `force` starts at these coordinates.
#[inline]
pub(super) fn force<S: Scalar>(force: &[S], rotation: &Matrix3<S>) -> Wrench<S> {
    let force = &force[..6];
    Wrench { moment: Vector3::from_slice(&force[3..]), force: rotation.transpose_times(Vector3::from_slice(force)) }
}

/// Returns the link's acceleration in addition to that of free fall, `fall`, under a wrench: six equations,
/// or three if the others are held.
#[inline]
pub(super) fn accelerate<S: Scalar>(
    floating: Floating,
    inertia: &SpatialInertia<S>,
    net: &Wrench<S>,
    fall: Vector3<S>,
) -> Twist<S> {
    let still = Vector3::zero();
    match (floating.hold_translation, floating.hold_rotation) {
        (false, false) => inertia.solve(net),
        (true, false) => {
            let angular = inertia.angular.inverse() * (net.moment + inertia.coupling * fall);
            Twist { angular, linear: -fall }
        }
        (false, true) => Twist { angular: still, linear: inertia.linear.inverse() * net.force },
        (true, true) => Twist { angular: still, linear: -fall },
    }
}

/// Writes the accelerations of the link's coordinates; those of the translation are in world axes.
#[inline]
pub(super) fn write<S: Scalar>(acceleration: &Twist<S>, fall: Vector3<S>, rotation: &Matrix3<S>, out: &mut [S]) {
    let out = &mut out[..6];
    (*rotation * (acceleration.linear + fall)).write_to(out);
    acceleration.angular.write_to(&mut out[3..]);
}
