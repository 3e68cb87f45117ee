//! Bending of a line.
//!
//! The energy of bending is that of Garrett's slender rod (*Ocean Engineering* 9, 1982, eq. 13), on whose unstretched length s
//! the curvature is the second derivative of the position:
//!
//! ```text
//! U = 1/2 integral EI |x''|^2 ds
//! ```
//!
//! At each node x'' is the second difference of its neighbours, over half of the way to each of them. At a clamped end, where
//! the line has the direction d of a body, x'' is `2 ((x_1 - x_0) / l - d) / l` over half of the way l to the next node. The
//! energy is quadratic in positions and directions, so that its mean force over an interval is that of the mean position, and
//! the errors are of second order in the distance of nodes.

use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// Positions and directions of the ends of a line, world; the direction of an end that is not clamped has no effect.
#[derive(Clone, Copy, Debug)]
pub struct LineEnds<S> {
    /// m.
    pub places: [Vector3<S>; 2],
    /// Unit vectors, from the first end to the second one.
    pub directions: [Vector3<S>; 2],
}

/// The bending at a node: curvature `sum w_k x_k + w_d d`.
#[derive(Clone, Copy, Debug)]
pub struct Bend<S> {
    /// The first of the three nodes.
    pub first: usize,
    /// Their weights, 1/m^2.
    pub weights: [S; 3],
    /// The clamped end whose direction counts, and its weight, 1/m.
    pub clamp: Option<(usize, S)>,
    /// EI times the length over which it acts, N m^3.
    pub stiffness: S,
}

impl<S: Scalar> Bend<S> {
    /// Returns the vector of curvature, 1/m, with nodes at these positions and clamped ends in these directions; their rates
    /// with velocities.
    pub fn curvature(&self, position: impl Fn(usize) -> Vector3<S>, directions: &[Vector3<S>; 2]) -> Vector3<S> {
        let nodes = (0..3).fold(Vector3::zero(), |sum, k| sum + position(self.first + k) * self.weights[k]);
        self.clamp.map_or(nodes, |(end, weight)| nodes + directions[end] * weight)
    }

    /// Returns the energy at a curvature, J.
    pub fn energy(&self, curvature: Vector3<S>) -> S {
        self.stiffness * curvature.norm_squared() * S::constant(0.5)
    }

    /// Returns the moment on the body of a clamped end with a direction at a curvature, world, N m.
    pub fn moment(&self, curvature: Vector3<S>, directions: &[Vector3<S>; 2]) -> Option<(usize, Vector3<S>)> {
        self.clamp.map(|(end, weight)| (end, curvature.cross(directions[end]) * (self.stiffness * weight)))
    }
}

/// Returns the bends of a line with elements of these lengths (m) and bending stiffnesses (N m^2), clamped at some of its ends;
/// none if no element has bending stiffness.
pub fn bends<S: Scalar>(elements: &[(S, S)], clamped: [bool; 2]) -> Vec<Bend<S>> {
    if elements.iter().all(|(_, stiffness)| stiffness.all(|stiffness| stiffness == 0.0)) {
        return Vec::new();
    }
    let last = 2 * elements.len();
    let half = |interval: usize| {
        let (length, stiffness) = elements[interval / 2];
        (length * S::constant(0.5), stiffness)
    };
    let mut bends: Vec<Bend<S>> = (1..last).map(|node| between(node, [half(node - 1), half(node)])).collect();
    for end in [0, 1].into_iter().filter(|end| clamped[*end]) {
        bends.push(at_clamp(end, last, half([0, last - 1][end])));
    }
    bends
}

/// Returns the bend at a node between intervals of these lengths and stiffnesses.
fn between<S: Scalar>(node: usize, [before, behind]: [(S, S); 2]) -> Bend<S> {
    let two = S::constant(2.0);
    let sum = before.0 + behind.0;
    let [first, last] = [before.0, behind.0].map(|length| two / (length * sum));
    // The moment is continuous: compliances add up. A part without stiffness is a hinge.
    let compliance = before.0 * behind.1 + behind.0 * before.1;
    let safe = compliance.select_below(f64::MIN_POSITIVE, || S::ONE, || compliance);
    let stiffness = before.1 * behind.1 * sum * sum * S::constant(0.5) / safe;
    Bend { first: node - 1, weights: [first, -(first + last), last], clamp: None, stiffness }
}

/// Returns the bend at a clamped end of a line with this last node, beside an interval of this length and stiffness.
fn at_clamp<S: Scalar>(end: usize, last: usize, (length, stiffness): (S, S)) -> Bend<S> {
    let per_length = S::constant(2.0) / length;
    let per_square = per_length / length;
    let (first, weights, weight) = match end {
        0 => (0, [-per_square, per_square, S::ZERO], -per_length),
        _ => (last - 2, [S::ZERO, per_square, -per_square], per_length),
    };
    Bend { first, weights, clamp: Some((end, weight)), stiffness: stiffness * length * S::constant(0.5) }
}
