//! Entrained water of a load: it enters through holes as the load sinks, and drains as the load is lifted out.

use crate::scalar::Scalar;
use crate::spatial::{Frame, Matrix3, SpatialInertia, Symmetric3, Vector3, Wrench};

/// An upright inner space of constant section A and height H about the solid's centre, with holes of area A_h in its
/// floor and open at the top.
///
/// With the level h of the water inside and the level H_o of the sea outside, both above the floor, along the vertical
/// and from 0 to H (Torricelli's law with a discharge coefficient: White, *Fluid Mechanics*, on Bernoulli's equation
/// and orifices; water that has not drained is part of the weight: DNV-RP-N103 on lifting through the surface)
///
/// ```text
/// h' = C_d A_h / A sqrt(2 g) d / (d^2 + e^2)^(1/4),   d = H_o - h,   e = 1 mm
/// F = -rho g A (h - H_o)  along the vertical, in the middle between the levels
/// m = rho A (h - H_o)     moves with the body, while it is more than 0
/// ```
///
/// e removes the infinite slope of the square root at equal levels. Water inside below the level of the sea has no net
/// weight and is part of the added mass; if the sea is higher, the empty space up to its level has buoyancy.
#[derive(Clone, Copy, Debug)]
pub struct EntrainedWater<S = f64> {
    /// A, m^2.
    pub area: S,
    /// H, m.
    pub height: S,
    /// C_d A_h, m^2.
    pub hole: S,
    /// h over H at the start of a run; `None`: the level of the sea.
    pub filling: Option<S>,
}

/// e, m.
const SMOOTHING_M: f64 = 1e-3;

/// Levels inside and outside at one moment, m above the floor.
#[derive(Clone, Copy, Debug)]
pub(super) struct Levels<S> {
    pub inside: S,
    pub outside: S,
}

impl<S: Scalar> Levels<S> {
    /// Returns the height of the water inside above the sea outside.
    fn excess(&self) -> S {
        self.inside - self.outside
    }
}

impl<S: Scalar> EntrainedWater<S> {
    /// Returns the middle of the floor in the solid's axes.
    pub(super) fn floor(&self) -> Vector3<S> {
        Vector3::new(S::ZERO, S::ZERO, self.height * S::constant(-0.5))
    }

    /// Returns H_o for a floor at this depth below the sea.
    pub(super) fn outside(&self, depth: S) -> S {
        depth.clipped(S::ZERO, self.height)
    }

    /// Returns h at the start of a run.
    pub(super) fn at_start(&self, outside: S) -> S {
        self.filling.map_or(outside, |filling| filling * self.height)
    }

    /// Returns h'.
    pub(super) fn rate(&self, gravity: S, levels: &Levels<S>) -> S {
        let head = -levels.excess();
        let softened = (head * head + S::constant(SMOOTHING_M * SMOOTHING_M)).sqrt().sqrt();
        self.hole / self.area * (gravity + gravity).sqrt() * head / softened
    }

    /// Returns rho A h, kg.
    pub(super) fn mass(&self, density: S, levels: &Levels<S>) -> S {
        density * self.area * levels.inside
    }

    /// Returns rho A (h - H_o), kg.
    pub(super) fn mass_above(&self, density: S, levels: &Levels<S>) -> S {
        density * self.area * levels.excess()
    }

    /// Returns the middle between the levels in the solid's axes.
    fn middle(&self, levels: &Levels<S>) -> Vector3<S> {
        let mut middle = self.floor();
        middle[2] += (levels.inside + levels.outside) * S::constant(0.5);
        middle
    }

    /// Returns F about the solid's centre; `weight` is rho g and `vertical` points up, in the body's axes.
    pub(super) fn force(&self, weight: S, vertical: Vector3<S>, levels: &Levels<S>) -> Wrench<S> {
        let force = vertical * -self.mass_above(weight, levels);
        Wrench { moment: self.middle(levels).cross(force), force }
    }

    /// Returns the inertia of m, about the solid's centre.
    pub(super) fn inertia(&self, density: S, levels: &Levels<S>) -> SpatialInertia<S> {
        let above = self.mass_above(density, levels);
        let mass = above.select_below(0.0, || S::ZERO, || above);
        let point = SpatialInertia {
            angular: Symmetric3::diagonal([S::ZERO; 3]),
            coupling: Matrix3::zero(),
            linear: Symmetric3::diagonal([mass; 3]),
        };
        point.to_parent(&Frame::translation(self.middle(levels)))
    }
}
