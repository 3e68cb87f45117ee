//! The loads of the water on a solid, about its centre in the body's axes.

use super::growth::AddedMassGrowth;
use super::immersion::Immersion;
use crate::elements::Context;
use crate::scalar::Scalar;
use crate::sea::hull::Solid;
use crate::spatial::{Matrix3, SpatialInertia, Symmetric3, Twist, Vector3, Wrench};
use crate::world::GustsAtHeight;

/// The added mass for a density of 1: of the fully submerged object, and its growth with immersion.
#[derive(Clone, Debug)]
pub struct AddedMassOf<S = f64> {
    /// C_A V_R along the body's axes, m^3.
    pub linear: Vector3<S>,
    /// Added moments of inertia about the body's axes, for a density of 1, m^5.
    pub angular: Vector3<S>,
    /// phi(s).
    pub growth: AddedMassGrowth<S>,
}

/// Drag by axis.
#[derive(Clone, Copy, Debug)]
pub struct Drag<S = f64> {
    /// C_D A_p along the body's axes, m^2.
    pub areas: Vector3<S>,
    /// c along the body's axes, N s/m.
    pub linear: Vector3<S>,
}

/// Slamming by a coefficient, which replaces that of the growing added mass.
#[derive(Clone, Copy, Debug)]
pub struct Slamming<S = f64> {
    /// C_S A_S, m^2.
    pub area: S,
}

/// Drag of the wind on the dry part.
#[derive(Clone, Debug)]
pub struct WindOnDry<S = f64> {
    /// C_D A_p along the body's axes, m^2.
    pub areas: Vector3<S>,
    /// The height at which the wind speed is taken, m.
    pub height: S,
    /// The gusts at that height, if the wind has any.
    pub gusts: Option<GustsAtHeight<S>>,
}

/// The loads by cause.
#[derive(Clone, Copy, Debug)]
pub(super) struct SubmergedLoads<S> {
    pub buoyancy: Wrench<S>,
    pub drag: Wrench<S>,
    pub inertia: Wrench<S>,
    pub slamming: Wrench<S>,
    pub wind: Wrench<S>,
    pub entrained: Wrench<S>,
}

impl<S: Scalar> SubmergedLoads<S> {
    pub fn sum(&self) -> Wrench<S> {
        self.buoyancy + self.drag + self.inertia + self.slamming + self.wind + self.entrained
    }
}

/// Square of a speed below which there is no drag, m^2/s^2.
const STILL: f64 = 1e-18;

/// |v| v A by axis.
fn by_square<S: Scalar>(velocity: Vector3<S>, areas: Vector3<S>) -> Vector3<S> {
    let square = velocity.norm_squared();
    let speed = square.select_below(STILL, || S::ZERO, || square.select_below(STILL, || S::ONE, || square).sqrt());
    Vector3(core::array::from_fn(|k| areas[k] * speed * velocity[k]))
}

impl<S: Scalar> AddedMassOf<S> {
    /// Returns A times the growth factor, about the solid's centre.
    pub fn inertia(&self, density: S, factor: S) -> SpatialInertia<S> {
        let scale = density * factor;
        SpatialInertia {
            angular: Symmetric3::diagonal(self.angular.0.map(|x| x * scale)),
            coupling: Matrix3::zero(),
            linear: Symmetric3::diagonal(self.linear.0.map(|x| x * scale)),
        }
    }

    /// Returns the force F = -(A nu_r' + nu_r x* A nu_r) - A' nu_r, less the part `-(A nu' + nu x* A nu)` that is
    /// already in the body's inertia; the last term acts only while A grows. In the body's axes the rate of the water's
    /// velocity u is a - omega x u.
    pub(super) fn forces(&self, density: S, now: &Immersion<S>) -> (Wrench<S>, Wrench<S>) {
        let added = self.inertia(density, now.factor);
        let through = Twist { linear: now.twist.linear - now.stream, ..now.twist };
        let carried = now.acceleration - now.twist.angular.cross(now.stream);
        let inertia = added.times(&Twist { angular: Vector3::zero(), linear: carried })
            + now.twist.cross_momentum(&added.times(&now.twist))
            - through.cross_momentum(&added.times(&through));
        let growth = now.factor_rate.select_below(0.0, || S::ZERO, || now.factor_rate);
        (inertia, -self.inertia(density, growth).times(&through))
    }
}

impl<S: Scalar> Slamming<S> {
    /// Returns the force 1/2 rho C_S A_S w^2 along the surface's normal, at the solid's centre, while the surface cuts
    /// the solid and the solid sinks with the speed w (DNV-RP-N103, *Modelling and analysis of marine operations*, sec.
    /// 4.3.5).
    pub(super) fn force(&self, density: S, solid: &Solid<S>, now: &Immersion<S>) -> Wrench<S> {
        let speed = now.sinking_speed();
        let pressure = density * S::constant(0.5) * speed.select_below(0.0, || S::ZERO, || speed * speed);
        Wrench { moment: Vector3::zero(), force: now.surface_normal() * (pressure * self.area * now.is_cut(solid)) }
    }
}

impl<S: Scalar> Drag<S> {
    pub(super) fn force(&self, density: S, now: &Immersion<S>) -> Wrench<S> {
        let past = now.stream - now.velocity_at_centre();
        let quadratic = by_square(past, self.areas * (density * S::constant(0.5)));
        let force = Vector3(core::array::from_fn(|k| quadratic[k] + self.linear[k] * past[k])) * now.share;
        Wrench { moment: now.centre.cross(force), force }
    }
}

impl<S: Scalar> WindOnDry<S> {
    /// Returns 1/2 rho C_D A_p |w - v| (w - v) on the dry share, at the solid's centre.
    pub(super) fn force(&self, at: &Context<'_, S>, now: &Immersion<S>) -> Wrench<S> {
        let Some(wind) = &at.world.wind else { return Wrench::zero() };
        let mut flow = wind.at_height(self.height);
        if let (Some(gusts), true) = (&self.gusts, at.evaluation.has_waves()) {
            flow += wind.along(gusts.speed(at.clock.time_s));
        }
        let past = now.frame.rotation.transpose_times(flow) - now.twist.linear;
        let scale = wind.air_density * S::constant(0.5) * (S::ONE - now.share);
        Wrench { moment: Vector3::zero(), force: by_square(past, self.areas * scale) }
    }
}
