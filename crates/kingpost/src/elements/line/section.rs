//! Properties of a line per length, and the force of the water on a part of it.

use super::one_sided::{OneSided, mean_one_sided, one_sided, positive};
use crate::elements::Context;
use crate::elements::lines::length_and_direction;
use crate::scalar::Scalar;
use crate::spatial::{Matrix3, Symmetric3, Vector3};
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
    /// EI, N m^2: a line with bending stiffness also pushes, one without becomes slack.
    pub bending_stiffness: S,
    /// Added mass over the mass of the displaced water, across and along.
    pub added_mass: [S; 2],
    /// Drag coefficients: across of the area d L, along of the area pi d L.
    pub drag: [S; 2],
}

/// A clump weight or a buoy on a line: a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClumpWeight<S = f64> {
    /// kg.
    pub mass: S,
    /// Displaced volume, m^3.
    pub volume: S,
    /// Drag coefficient times area, in every direction, m^2.
    pub drag_area: S,
    /// Added mass over the mass of the displaced water.
    pub added_mass: S,
}

impl<S: Scalar> ClumpWeight<S> {
    /// Returns the diameter of a sphere of its volume, m.
    fn diameter(&self) -> S {
        let cube = self.volume * S::constant(6.0 / PI);
        cube.select_below(f64::MIN_POSITIVE, || S::ZERO, || cube.pow(S::constant(1.0 / 3.0)))
    }
}

/// Mass of a part of a line, kg, with the added mass of the water.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PartMass<S> {
    /// Across the line.
    pub across: S,
    /// Along the line.
    pub along: S,
}

impl<S: Scalar> PartMass<S> {
    /// Returns the mass as a matrix, world axes, for a part with this unit tangent.
    pub fn about(&self, tangent: Vector3<S>) -> Matrix3<S> {
        Matrix3::identity().scaled(self.across) + Matrix3::outer(tangent, tangent).scaled(self.along - self.across)
    }
}

/// A part of a line in water: the motion of the water, and the coefficients of its force.
#[derive(Clone, Copy, Debug)]
pub struct WetPart<S> {
    /// Unit tangent of the part.
    pub(super) tangent: Vector3<S>,
    /// Velocity of the water, m/s.
    pub(super) velocity: Vector3<S>,
    /// Acceleration of the water, m/s^2.
    pub(super) acceleration: Vector3<S>,
    /// Mass of the displaced water, kg.
    pub(super) displaced: S,
    /// Buoyancy and the force of the accelerated water, N.
    pub steady: Vector3<S>,
    /// Added mass, kg.
    pub added: PartMass<S>,
    /// Drag over the square of the relative speed, across and along, N s^2/m^2.
    pub(super) drag: [S; 2],
    /// Loss of buoyancy per height, N/m: above 0 at the surface.
    pub stiffness: S,
    /// Covariance of the relative velocity in a random sea, m^2/s^2, if the drag is its mean over it.
    pub(super) spread: Option<Symmetric3>,
}

/// The drag on a part of a line.
#[derive(Clone, Copy, Debug)]
pub struct LineDrag<S> {
    /// Force, N.
    pub force: Vector3<S>,
    /// Velocity of the water relative to the part, m/s.
    pub relative: Vector3<S>,
    /// Derivative of the force along the relative velocity, N s/m.
    pub slope: Matrix3<S>,
}

impl<S: Scalar> WetPart<S> {
    /// A part without water.
    pub fn dry() -> Self {
        let zero = Vector3::zero();
        let added = PartMass { across: S::ZERO, along: S::ZERO };
        Self {
            tangent: zero,
            velocity: zero,
            acceleration: zero,
            displaced: S::ZERO,
            steady: zero,
            added,
            drag: [S::ZERO; 2],
            stiffness: S::ZERO,
            spread: None,
        }
    }

    /// Returns the part with a clump weight, whose middle is at this depth under the surface, m.
    fn with_clump(self, clump: &ClumpWeight<S>, depth: S, [density, gravity]: [S; 2]) -> Self {
        let (diameter, half) = (clump.diameter(), S::constant(0.5));
        let least = diameter.select_below(f64::MIN_POSITIVE, || S::ONE, || diameter);
        let [share, per_height] = share_under(depth, least);
        let displaced = density * clump.volume * share;
        let added = clump.added_mass * displaced;
        let up = Vector3::new(S::ZERO, S::ZERO, displaced * gravity);
        let of_area = half * density * clump.drag_area * share;
        Self {
            displaced: self.displaced + displaced,
            steady: self.steady + up + self.acceleration * (displaced + added),
            added: PartMass { across: self.added.across + added, along: self.added.along + added },
            drag: self.drag.map(|drag| drag + of_area),
            stiffness: self.stiffness + density * clump.volume * gravity * per_height,
            ..self
        }
    }

    /// Returns the unit tangent of the part.
    pub fn tangent(&self) -> Vector3<S> {
        self.tangent
    }

    /// Returns the drag on the part at its velocity, this time (s) after that of the water's velocity.
    #[inline(always)]
    pub fn drag(&self, velocity: Vector3<S>, later_s: S) -> LineDrag<S> {
        let relative = self.velocity + self.acceleration * later_s - velocity;
        if let Some(spread) = &self.spread {
            return self.mean_drag(relative, spread);
        }
        let along = self.tangent.dot(relative);
        let normal = relative - self.tangent * along;
        let (speed, direction) = length_and_direction(normal);
        let [across, tangential] = self.drag;
        let along_speed = along.select_below(0.0, || -along, || along);
        let tangents = Matrix3::outer(self.tangent, self.tangent);
        let normals = Matrix3::identity() - tangents + Matrix3::outer(direction, direction);
        LineDrag {
            force: normal * (across * speed) + self.tangent * (tangential * along_speed * along),
            relative,
            slope: normals.scaled(across * speed) + tangents.scaled(tangential * along_speed * S::constant(2.0)),
        }
    }
}

impl<S: Scalar> WetPart<S> {
    /// Returns the derivative of the drag on the part at rest along its tangent, N.
    pub fn turning_drag(&self) -> Matrix3<S> {
        let ([across, tangential], water) = (self.drag, self.velocity);
        let along = self.tangent.dot(water);
        let (speed, direction) = length_and_direction(water - self.tangent * along);
        let along_speed = along.select_below(0.0, || -along, || along);
        let turned = Matrix3::outer(self.tangent, water);
        let same = Matrix3::identity().scaled(along);
        let normals = (Matrix3::identity() + Matrix3::outer(direction, direction)).scaled(across * speed);
        let of_tangent = (turned.scaled(S::constant(2.0)) + same).scaled(tangential * along_speed);
        of_tangent - normals * (turned + same)
    }
}

impl<S: Scalar> LineSection<S> {
    /// Returns the first numbers for a line that also pushes, the second ones for a line that only pulls.
    fn if_pushes<const N: usize>(&self, pushes: [S; N], pulls: [S; N]) -> [S; N] {
        core::array::from_fn(|k| self.bending_stiffness.select_below(f64::MIN_POSITIVE, || pulls[k], || pushes[k]))
    }

    /// Returns a tension if the line can have it: one that only pulls has no negative one.
    pub fn possible(&self, tension: S) -> S {
        self.if_pushes([tension], [positive(tension)])[0]
    }

    /// Returns the derivative of the tension along the strain, N, from that of a line that only pulls.
    pub fn rise(&self, pulls: S) -> S {
        self.if_pushes([self.axial_stiffness], [pulls])[0]
    }

    /// Returns the tension at a stretch ratio and its rate, N: the part that is stored, and the whole.
    pub fn tension(&self, ratio: S, rate: S) -> [S; 2] {
        let (strain, tau) = (ratio - S::ONE, self.damping_time);
        self.if_pushes([strain, strain + tau * rate], one_sided(strain, rate, tau))
            .map(|part| self.axial_stiffness * part)
    }

    /// Returns the energy of strain per length at a stretch ratio, J/m.
    pub fn strain_energy(&self, ratio: S) -> S {
        let strain = self.possible(ratio - S::ONE);
        self.axial_stiffness * (strain * strain * S::constant(0.5))
    }

    /// Returns the mean tension of an interval between two stretch ratios with this rate, N, as [`tension`](Self::tension), and
    /// over EA its derivatives along the ratio at the end and along the rate.
    #[inline(always)]
    pub fn mean_tension(&self, ratios: [S; 2], rate: S) -> ([S; 2], [S; 2]) {
        let (strains, half) = (ratios.map(|ratio| ratio - S::ONE), S::constant(0.5));
        let OneSided { elastic, whole, slopes: [along, per_rate] } = mean_one_sided(strains, rate, self.damping_time);
        let mean = (strains[0] + strains[1]) * half;
        let pushes = [mean, mean + self.damping_time * rate, half, self.damping_time];
        let [elastic, whole, along, per_rate] = self.if_pushes(pushes, [elastic, whole, along, per_rate]);
        ([self.axial_stiffness * elastic, self.axial_stiffness * whole], [along, per_rate])
    }

    /// Returns a part of this length in the water at a point, with the height of its middle and its unit tangent, and with what
    /// is fastened to it.
    pub fn in_water(
        &self,
        at: &Context<'_, S>,
        length: S,
        (point, middle, tangent): (Vector3<S>, S, Vector3<S>),
        clump: Option<&ClumpWeight<S>>,
    ) -> WetPart<S> {
        let half = S::constant(0.5);
        let density = at.world.water_density;
        let rise = tangent[2].select_below(0.0, || -tangent[2], || tangent[2]);
        let extent = length * rise + self.diameter;
        let waves = at.world.waves.as_ref().filter(|field| at.evaluation.has_waves() && !field.is_empty());
        let (elevation, [by_waves, acceleration]) = waves.map_or((S::ZERO, [Vector3::zero(); 2]), |field| {
            let highest = clump.map_or(extent, |clump| extent + clump.diameter());
            let is_under = field.is_always_under(middle + highest);
            let time_s = at.clock.time_s;
            let elevation = if is_under { S::ZERO } else { field.elevation_m([point[0], point[1]], time_s) };
            (elevation, field.motion(point, elevation, time_s))
        });
        let depth = point[2].select_below(0.0, || -point[2], || S::ZERO);
        let velocity = by_waves + at.world.current_at(&CurrentAt::Depth(depth));
        let [share, per_height] = share_under(elevation - middle, extent);
        let wet = length * share;
        let displaced = density * self.diameter * self.diameter * wet * S::constant(FRAC_PI_4);
        let [across, along] = self.added_mass.map(|coefficient| coefficient * displaced);
        let per_speed = half * density * self.diameter * wet;
        let drag = [per_speed * self.drag[0], per_speed * S::constant(PI) * self.drag[1]];
        let inertial = acceleration * (displaced + across) + tangent * ((along - across) * tangent.dot(acceleration));
        let buoyancy = Vector3::new(S::ZERO, S::ZERO, displaced * at.world.gravity);
        let added = PartMass { across, along };
        let per_share = density * self.diameter * self.diameter * length * S::constant(FRAC_PI_4) * at.world.gravity;
        let steady = buoyancy + inertial;
        let stiffness = per_share * per_height;
        let part = WetPart { tangent, velocity, acceleration, displaced, steady, added, drag, stiffness, spread: None };
        clump.map_or(part, |clump| part.with_clump(clump, elevation - point[2], [density, at.world.gravity]))
    }
}

/// Returns the share of a body of this height, whose middle is at a depth, that is under the surface, and its decrease per
/// height of the middle, 1/m.
fn share_under<S: Scalar>(depth: S, height: S) -> [S; 2] {
    let share = depth / height + S::constant(0.5);
    let within = share.select_below(0.0, || S::ZERO, || (S::ONE - share).select_below(0.0, || S::ZERO, || S::ONE));
    [share.clipped(S::ZERO, S::ONE), within / height]
}
