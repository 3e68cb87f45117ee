//! Search for the floating position of a hull at constant displacement.

use super::{Buoyancy, FloatingPosition, HullMesh, HullTank, Loading, StabilityError, Waterplane, WettedHull};
use crate::spatial::Vector3;

/// Largest number of steps of the search.
const MOST_STEPS: usize = 100;
/// Rotation of the last step, rad: a smaller step ends the search, because convergence is quadratic.
const LAST_TURN: f64 = 1e-9;
/// Largest rotation of the hull in one step, rad.
const LARGEST_TURN: f64 = 0.2;
/// Largest number of halvings of the height's bracket.
const MOST_HALVINGS: usize = 200;

/// Returns the heel of a hull with this vertical, to starboard, rad.
pub(super) fn heel_of(vertical: Vector3) -> f64 {
    libm::atan2(vertical[1], vertical[2])
}

/// Returns the trim of a hull with this vertical, by the bow, rad.
pub(super) fn trim_of(vertical: Vector3) -> f64 {
    libm::atan2(-vertical[0], libm::hypot(vertical[1], vertical[2]))
}

/// Returns the directions in which the vertical moves in hull axes with increasing heel, and with increasing
/// trim: unit vectors across and along the ship, in the water's plane. For an upright hull they are y and -x.
pub(super) fn tangents(vertical: Vector3) -> [Vector3; 2] {
    let forward = Vector3::new(1.0, 0.0, 0.0);
    let along = (vertical * vertical[0] - forward).direction();
    [along.cross(vertical), along]
}

/// A hull in a position in which it displaces its weight.
#[derive(Clone, Copy)]
pub(super) struct Afloat {
    pub(super) position: FloatingPosition,
    pub(super) buoyancy: Buoyancy,
    pub(super) waterplane: Waterplane,
}

/// A hull, its weight and the working memory of the search.
pub(super) struct EquilibriumSearch<'a> {
    mesh: &'a HullMesh,
    wetted: WettedHull,
    volume: f64,
    mass: f64,
    /// Centre of gravity, with the liquid in tanks at its position in the upright hull.
    centre_of_gravity: Vector3,
    tanks: &'a [HullTank],
    /// Lever below which it counts as 0, m.
    rounding: f64,
}

impl<'a> EquilibriumSearch<'a> {
    pub(super) fn new(mesh: &'a HullMesh, loading: &Loading, tanks: &'a [HullTank]) -> Result<Self, StabilityError> {
        let Loading { mass, centre_of_gravity, water_density } = *loading;
        for (quantity, found) in [("the mass that floats", mass), ("the water's density", water_density)] {
            if !(found > 0.0 && found.is_finite()) {
                return Err(StabilityError::Loading { quantity, found, allowed: "a finite number greater than 0" });
            }
        }
        if let Some(&found) = centre_of_gravity.0.iter().find(|x| !x.is_finite()) {
            let quantity = "a coordinate of the centre of gravity";
            return Err(StabilityError::Loading { quantity, found, allowed: "a finite number" });
        }
        let (volume, largest_m3) = (mass / water_density, mesh.volume());
        if volume >= largest_m3 {
            return Err(StabilityError::CannotFloat { mass_t: mass / 1000.0, displacement_m3: volume, largest_m3 });
        }
        let size = mesh.vertices().iter().map(|r| r.norm()).fold(centre_of_gravity.norm(), f64::max);
        // A hundred rounding errors of the farthest position.
        Ok(Self { mesh, wetted: WettedHull::new(mesh), volume, mass, centre_of_gravity, tanks, rounding: 1e-14 * size })
    }

    /// Returns c: the centre of gravity with level liquid in the tanks.
    fn settled_centre_of_gravity(&self, vertical: Vector3) -> Vector3 {
        let shift = self.tanks.iter().fold(Vector3::zero(), |sum, tank| sum + tank.shift(vertical));
        self.centre_of_gravity + shift * (1.0 / self.mass)
    }

    /// Returns b - c: the vector from the centre of gravity to the centre of buoyancy, hull axes, m.
    pub(super) fn lever(&self, afloat: &Afloat) -> Vector3 {
        afloat.buoyancy.centre() - self.settled_centre_of_gravity(afloat.position.vertical)
    }

    /// Returns Phi / W, m.
    fn energy_height(&self, afloat: &Afloat) -> f64 {
        let FloatingPosition { height, vertical } = afloat.position;
        let centre_of_gravity = self.settled_centre_of_gravity(vertical);
        height + vertical.dot(centre_of_gravity) - afloat.buoyancy.height_moment / afloat.buoyancy.volume
    }

    /// Returns the position at the height at which the hull displaces its volume. V falls with the height, at
    /// the rate of the waterplane's area; Newton's method in a bracket from a fully emerged to a fully
    /// submerged hull.
    fn at_volume(&mut self, vertical: Vector3) -> Afloat {
        let (least, greatest) = self.mesh.extent_along(vertical);
        let (mut under, mut out) = (-greatest, -least);
        // A few rounding errors of the largest height.
        let smallest_step = 1e-15 * (out - under);
        let mut height = under + (out - under) * (1.0 - self.volume / self.mesh.volume());
        for _ in 0..MOST_HALVINGS {
            let Afloat { buoyancy, waterplane, .. } = self.at_height(vertical, height);
            let excess = buoyancy.volume - self.volume;
            if excess > 0.0 {
                under = height;
            } else {
                out = height;
            }
            let newton = height + excess / waterplane.area;
            let next = if newton > under && newton < out { newton } else { 0.5 * (under + out) };
            let step = (next - height).abs();
            height = next;
            if step <= smallest_step {
                break;
            }
        }
        self.at_height(vertical, height)
    }

    fn at_height(&mut self, vertical: Vector3, height: f64) -> Afloat {
        let position = FloatingPosition { height, vertical };
        let buoyancy = self.wetted.buoyancy(self.mesh, &position);
        Afloat { position, buoyancy, waterplane: self.wetted.waterplane(self.mesh, &position) }
    }

    /// Rotates the hull from this vertical until the trimming moment is 0, and also the heeling moment if the
    /// hull is free to heel.
    pub(super) fn settle(&mut self, start: Vector3, free_to_heel: bool) -> Result<Afloat, StabilityError> {
        let mut afloat = self.at_volume(start);
        let mut turn = 0.0;
        for _ in 0..MOST_STEPS {
            let step = self.newton_step(&afloat, free_to_heel);
            turn = step.norm();
            if turn <= LAST_TURN {
                return Ok(self.at_volume(turned(afloat.position.vertical, step)));
            }
            afloat = self.go_down(&afloat, step * (LARGEST_TURN / turn).min(1.0));
        }
        let [heel_deg, trim_deg] = [heel_of, trim_of].map(|angle| angle(afloat.position.vertical).to_degrees());
        Err(StabilityError::NotSettled {
            heel_deg,
            trim_deg,
            turn_rad: turn,
            steps: MOST_STEPS,
            allowed_rad: LAST_TURN,
        })
    }

    /// Returns Newton's step on the sphere of verticals: a tangent vector. The slope of Phi / W along t is
    /// `-(b - c).t`; its second derivatives are BM plus the height of b above c, less the reduction by free
    /// surfaces: GM. A negative GM is replaced by its absolute value, so that the step goes downhill.
    fn newton_step(&self, afloat: &Afloat, free_to_heel: bool) -> Vector3 {
        let (lever, [across, along]) = (self.lever(afloat), tangents(afloat.position.vertical));
        let metacentric = |t: Vector3, u: Vector3| {
            let radius = afloat.waterplane.second_moment(t, u) / afloat.buoyancy.volume;
            let vertical = afloat.position.vertical;
            let free_surfaces: f64 = self.tanks.iter().map(|tank| tank.second_moment(vertical, t, u)).sum();
            radius + lever.dot(vertical) * t.dot(u) - free_surfaces / self.mass
        };
        let [heel, mixed, trim] = [(across, across), (across, along), (along, along)].map(|(t, u)| metacentric(t, u));
        let step_along = |t: Vector3, curvature: f64| {
            let slope = lever.dot(t);
            if slope.abs() <= self.rounding { Vector3::zero() } else { t * (slope / curvature.abs()) }
        };
        if !free_to_heel {
            return step_along(along, trim);
        }
        // Principal directions of a symmetric 2x2 matrix.
        let (sin, cos) = libm::sincos(0.5 * libm::atan2(2.0 * mixed, heel - trim));
        let (mean, half) = (0.5 * (heel + trim), libm::hypot(0.5 * (heel - trim), mixed));
        step_along(across * cos + along * sin, mean + half) + step_along(along * cos - across * sin, mean - half)
    }

    /// Takes the step, halved until it does not increase Phi / W.
    fn go_down(&mut self, from: &Afloat, mut step: Vector3) -> Afloat {
        let height = self.energy_height(from);
        loop {
            let to = self.at_volume(turned(from.position.vertical, step));
            let more = step.norm() > LAST_TURN;
            if self.energy_height(&to) <= height + self.rounding || !more {
                return to;
            }
            step = step * 0.5;
        }
    }
}

/// Returns the vertical rotated along a great circle by this tangent vector, rad.
fn turned(vertical: Vector3, step: Vector3) -> Vector3 {
    let angle = step.norm();
    if angle == 0.0 {
        return vertical;
    }
    let (sin, cos) = libm::sincos(angle);
    (vertical * cos + step * (sin / angle)).direction()
}
