//! Homogeneous shapes: for drawing a body, and for its inertia if none is given.

use crate::scalar::Scalar;
use crate::spatial::Symmetric3;

/// An axis of a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// Forward.
    X,
    /// To port.
    Y,
    /// Up.
    Z,
}

/// A homogeneous solid centred on the centre of mass; lengths in m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape<S = f64> {
    /// Cuboid with edges along x, y and z.
    Box {
        /// Edges along x, y, z, m.
        edges_m: [S; 3],
    },
    /// Circular cylinder.
    Cylinder {
        /// Radius, m.
        radius_m: S,
        /// Length, m.
        length_m: S,
        /// The body axis along the cylinder.
        axis: Axis,
    },
    /// Ball.
    Sphere {
        /// Radius, m.
        radius_m: S,
    },
    /// A point mass, without moments of inertia.
    Point,
}

impl<S: Scalar> Shape<S> {
    /// Returns the moments of inertia about the centre of mass in body axes, kg m^2, for a mass in kg.
    ///
    /// ```
    /// use kingpost::model::Shape;
    /// let ship = Shape::Box { edges_m: [20.0, 10.0, 5.0] };
    /// assert_eq!(ship.inertia(12.0).xx, 10.0 * 10.0 + 5.0 * 5.0);
    /// ```
    pub fn inertia(&self, mass: S) -> Symmetric3<S> {
        let c = S::constant;
        let moments = match *self {
            Shape::Box { edges_m: [x, y, z] } => {
                [y * y + z * z, x * x + z * z, x * x + y * y].map(|sum| mass * sum / c(12.0))
            }
            Shape::Cylinder { radius_m, length_m, axis } => {
                let along = c(0.5) * mass * radius_m * radius_m;
                let across = mass * (c(3.0) * radius_m * radius_m + length_m * length_m) / c(12.0);
                let mut moments = [across; 3];
                moments[axis as usize] = along;
                moments
            }
            Shape::Sphere { radius_m } => [c(0.4) * mass * radius_m * radius_m; 3],
            Shape::Point => [S::ZERO; 3],
        };
        Symmetric3::diagonal(moments)
    }
}
