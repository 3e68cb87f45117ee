//! Local coordinates of all joints, in lists by kind of joint.

use super::joint::{Floating, JointKind, Spherical};
use super::tree::Node;
use crate::scalar::Scalar;

/// Indices of joints in q and in v, so that [`retract`](super::Tree::retract) and
/// [`dexp_inverse`](super::Tree::dexp_inverse) of a model's links become loops over lists.
#[derive(Clone, Debug, Default)]
pub struct Charts {
    floating: Vec<(usize, usize)>,
    balls: Vec<(usize, usize)>,
    /// Coordinates that are updated by a sum.
    axes: Vec<(usize, usize)>,
}

impl Charts {
    /// Returns the lists for these nodes.
    pub(super) fn of<S: Scalar>(nodes: &[Node<S>]) -> Self {
        let mut charts = Self::default();
        for Node { kind, positions, velocities, .. } in nodes {
            let place = |k: usize| (positions + k, velocities + k);
            match kind {
                JointKind::Floating(_) => charts.floating.push(place(0)),
                JointKind::Spherical(_) => charts.balls.push(place(0)),
                kind => charts.axes.extend((0..kind.velocity_count()).map(place)),
            }
        }
        charts
    }

    /// `out = q` moved by the local coordinates `xi`.
    #[inline]
    pub fn retract<S: Scalar>(&self, q: &[S], xi: &[S], out: &mut [S]) {
        for &(p, v) in &self.floating {
            Floating::retract(&q[p..], &xi[v..], &mut out[p..]);
        }
        for &(p, v) in &self.balls {
            Spherical::retract(&q[p..], &xi[v..], &mut out[p..]);
        }
        for &(p, v) in &self.axes {
            out[p] = q[p] + xi[v];
        }
    }

    /// Computes `out = xi'`, the rate of the local coordinates for the velocity `v`.
    #[inline]
    pub fn dexp_inverse<S: Scalar>(&self, xi: &[S], v: &[S], out: &mut [S]) {
        for &(_, i) in &self.floating {
            Floating::dexp_inverse(&xi[i..], &v[i..], &mut out[i..]);
        }
        for &(_, i) in &self.balls {
            Spherical::dexp_inverse(&xi[i..], &v[i..], &mut out[i..]);
        }
        for &(_, i) in &self.axes {
            out[i] = v[i];
        }
    }
}
