//! Properties of a line per length, and the force of the water on a part of it.

use crate::elements::Context;
use crate::elements::lines::length_and_direction;
use crate::scalar::Scalar;
use crate::spatial::Vector3;
use crate::world::CurrentAt;
use core::f64::consts::{FRAC_PI_4, PI};

/// Properties of a line per length.
///
/// Axes: *across* is perpendicular to the line, *along* is tangential. The force of the water is Morison's, with the water's
/// motion relative to the line (DNV-RP-C205, sec. 6; Palm & Eskilsson, *Ocean Engineering* 200, 2020, 107057).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineSection<S = f64> {
    /// m, kg/m.
    pub mass_per_length: S,
    /// Diameter of the circular section that displaces the same volume of water, m.
    pub diameter: S,
    /// EA, N.
    pub axial_stiffness: S,
    /// tau, s: the tension is EA (e + tau e') at the strain e.
    pub damping_time: S,
    /// Added mass over the mass of the displaced water, across and along.
    pub added_mass: [S; 2],
    /// Drag coefficients: across of the area d L, along of the area pi d L.
    pub drag: [S; 2],
}

/// Mass of a part of a line, kg, with the added mass of the water.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PartMass<S> {
    /// Across the line.
    pub across: S,
    /// Along the line.
    pub along: S,
}

/// The force of the water on a part of a line at rest, and its power.
#[derive(Clone, Copy, Debug)]
pub struct WaterForce<S> {
    /// Buoyancy, drag, and the force of the accelerated water, N.
    pub force: Vector3<S>,
    /// Added mass, kg.
    pub added: PartMass<S>,
    /// Power of the drag that becomes heat, W.
    pub dissipated: S,
}

impl<S: Scalar> LineSection<S> {
    /// Returns the tension at a stretch ratio and its rate, N: the part that is stored, and the whole. A line does not push.
    pub fn tension(&self, ratio: S, rate: S) -> [S; 2] {
        let positive = |force: S| force.select_below(0.0, || S::ZERO, || force);
        let elastic = positive(self.axial_stiffness * (ratio - S::ONE));
        let damped = positive(elastic + self.axial_stiffness * self.damping_time * rate);
        [elastic, elastic.select_below(f64::MIN_POSITIVE, || S::ZERO, || damped)]
    }

    /// Returns the force of the water on a part of this length at a point, with its unit tangent and velocity.
    pub fn in_water(
        &self,
        at: &Context<'_, S>,
        length: S,
        (point, tangent, velocity): (Vector3<S>, Vector3<S>, Vector3<S>),
    ) -> WaterForce<S> {
        let half = S::constant(0.5);
        let density = at.world.water_density;
        let moving = at.world.waves.as_ref().filter(|_| at.evaluation.has_waves());
        let waves = moving.map(|field| field.kinematics(point, at.clock.time_s));
        let (elevation, by_waves, acceleration) = waves.map_or((S::ZERO, Vector3::zero(), Vector3::zero()), |waves| {
            (waves.elevation_m, waves.velocity_m_s, waves.acceleration_m_s2)
        });
        let depth = point[2].select_below(0.0, || -point[2], || S::ZERO);
        let water = by_waves + at.world.current_at(&CurrentAt::Depth(depth));
        let rise = tangent[2].select_below(0.0, || -tangent[2], || tangent[2]);
        let share = ((elevation - point[2]) / (length * rise + self.diameter) + half).clipped(S::ZERO, S::ONE);
        let wet = length * share;
        let displaced = density * self.diameter * self.diameter * wet * S::constant(FRAC_PI_4);
        let [across, along] = self.added_mass.map(|coefficient| coefficient * displaced);
        let relative = water - velocity;
        let [of_relative, of_acceleration] = [relative, acceleration].map(|vector| tangent.dot(vector));
        let tangential = tangent * of_relative;
        let normal = relative - tangential;
        let per_speed = half * density * self.diameter * wet;
        let speed = |vector| length_and_direction(vector).0;
        let drag = normal * (per_speed * self.drag[0] * speed(normal))
            + tangential * (per_speed * S::constant(PI) * self.drag[1] * speed(tangential));
        let inertial = acceleration * (displaced + across) + tangent * ((along - across) * of_acceleration);
        let buoyancy = Vector3::new(S::ZERO, S::ZERO, displaced * at.world.gravity);
        let added = PartMass { across, along };
        WaterForce { force: buoyancy + drag + inertial, added, dissipated: drag.dot(relative) }
    }
}
