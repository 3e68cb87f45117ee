//! The water in a free-flooding tank as a rigid body on a prismatic joint.

use crate::scalar::Scalar;
use crate::spatial::{SpatialInertia, Symmetric3};
use core::f64::consts::PI;

/// End correction of one side of the opening over its radius: a circular piston in a wall moves a water column of the
/// length `8 r / 3 pi` (Rayleigh, *The Theory of Sound*, vol. 2, sec. 307).
const END_CORRECTION: f64 = 8.0 / (3.0 * PI);
/// Factor of the reduction of the end correction by the tank's walls, with the ratio of the diameters d / D: `1 - 1.25
/// d / D` (Ingard, *J. Acoust. Soc. Am.* 25, 1953, p. 1037).
const BY_THE_WALLS: f64 = 1.25;

/// A tank with vertical walls and an opening in its bottom: m, m^2 and kg/m^3.
///
/// The water moves as a whole along the tank at the rate x' of its level, and through the opening at `u = x' A / A_o`.
/// With m = rho A L of the level L at rest, the kinetic energy is that of a rigid body on a prismatic joint, and of a rotor
/// on that joint for the water in and about the opening,
///
/// ```text
/// T = m |v + x' z|^2 / 2 + rho A^2 l / A_o x'^2 / 2,    l = l_passage + 8 r / 3 pi (1 + max(1 - 1.25 sqrt(A_o / A), 0))
/// ```
///
/// with r the radius of a circle of the area A_o.
#[derive(Clone, Copy, Debug)]
pub struct FloodedColumn<S = f64> {
    /// Edges of the tank along x, y and z.
    pub edges: [S; 3],
    /// L: level at rest above the opening.
    pub level: S,
    /// A_o.
    pub opening_area: S,
    /// l_passage: thickness of the bottom, or length of the pipe to the sea.
    pub passage_length: S,
    /// rho.
    pub density: S,
}

impl<S: Scalar> FloodedColumn<S> {
    /// A, m^2.
    pub fn area(&self) -> S {
        self.edges[0] * self.edges[1]
    }

    /// rho A, kg/m.
    pub fn mass_per_metre(&self) -> S {
        self.density * self.area()
    }

    /// m, kg.
    pub fn mass(&self) -> S {
        self.mass_per_metre() * self.level
    }

    /// Returns the inertia of the water at rest about its centre.
    pub fn inertia(&self) -> SpatialInertia<S> {
        let square = [self.edges[0], self.edges[1], self.level].map(|edge| edge * edge);
        let about = |k: usize| self.mass() * (square[(k + 1) % 3] + square[(k + 2) % 3]) * S::constant(1.0 / 12.0);
        SpatialInertia::rigid(self.mass(), Symmetric3::diagonal([about(0), about(1), about(2)]))
    }

    /// Returns the rotor inertia on the joint: the water in and about the opening, kg.
    pub fn rotor_inertia(&self) -> S {
        let share = self.opening_area / self.area();
        let radius = (self.opening_area * S::constant(1.0 / PI)).sqrt();
        let inside = S::ONE - share.sqrt() * S::constant(BY_THE_WALLS);
        let ends = S::ONE + inside.select_below(0.0, || S::ZERO, || inside);
        let length = self.passage_length + radius * ends * S::constant(END_CORRECTION);
        self.mass_per_metre() * length / share
    }

    /// Returns the force per metre of level in an upright tank, `rho g A`, N/m.
    pub fn stiffness(&self, gravity: S) -> S {
        self.mass_per_metre() * gravity
    }
}
