//! The fastest motion of a load on the spots that would touch first.

use super::sides::Met;
use super::{Contact, Facing};
use crate::elements::{AnyElement, Context, of_kind};
use crate::spatial::{Frame, SpatialInertia, Twist, Vector3, Wrench};

/// Number of steps of the power iteration: its eigenvalue is then right to a few per cent, from below, even if another
/// one is near.
const ITERATIONS: usize = 50;
/// Height over the middle of all spots up to which a spot counts as on the lower side, m: rounding.
const ROUNDING_M: f64 = 1e-9;

/// The fastest motion of a load on the spots that touch first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClosedContact {
    /// Number of spots that touch at once.
    pub spots: usize,
    /// Frequency of the load on them, without damping, rad/s.
    pub frequency_rad_s: f64,
}

/// A direction in which a spot is stiff.
struct Spring {
    stiffness: f64,
    direction: Vector3,
    /// The point on each side where it acts, world, m.
    points: [Vector3; 2],
}

/// The bodies of a side that are fixed to each other, and move freely.
struct Mover {
    frame: Frame,
    inertia: SpatialInertia,
}

impl Contact {
    /// Returns the contacts among the elements.
    pub fn among(elements: &[AnyElement]) -> impl Iterator<Item = &Self> {
        of_kind(elements)
    }

    /// Returns the fastest motion of the load once the spots on its lower side touch, as if nothing else held it;
    /// `None` if a spot touches at the present positions.
    ///
    /// With the directions w_i of the springs on both bodies and the masses M, the squares of the frequencies are the
    /// eigenvalues of `sqrt(k_i k_j) w_i^T M^-1 w_j`, for a load on n spots under its centre n k / m in the vertical.
    pub fn once_closed(&self, at: &Context<'_>) -> Option<ClosedContact> {
        let (springs, spots) = self.springs(at)?;
        let movers = self.sides.each_ref().map(|side| mover(at, side.body?));
        let accelerations = |efforts: &[f64]| {
            [0, 1].map(|side| {
                let sign = if side == 0 { 1.0 } else { -1.0 };
                movers[side].as_ref().map(|mover| mover.accelerated(&springs, efforts, side, sign))
            })
        };
        let (mut efforts, mut largest) = (seed(springs.len()), 0.0);
        for _ in 0..ITERATIONS {
            let moved = accelerations(&efforts);
            let along = |spring: &Spring| {
                let of = |side: usize| {
                    moved[side].map_or(0.0, |(linear, angular, origin)| {
                        spring.direction.dot(linear + angular.cross(spring.points[side] - origin))
                    })
                };
                libm::sqrt(spring.stiffness) * (of(0) - of(1))
            };
            let next: Vec<f64> = springs.iter().map(along).collect();
            largest = libm::sqrt(next.iter().map(|x| x * x).sum());
            if largest.is_nan() || largest <= 0.0 {
                return None;
            }
            efforts = next.into_iter().map(|x| x / largest).collect();
        }
        Some(ClosedContact { spots, frequency_rad_s: libm::sqrt(largest) })
    }

    /// Returns the springs of the spots that touch first, and their number.
    fn springs(&self, at: &Context<'_>) -> Option<(Vec<Spring>, usize)> {
        let sides = self.sides_at(at);
        let met: Vec<_> = (0..self.spots.len()).map(|i| (self.spots[i].0, self.met(i, &sides))).collect();
        let first = met.iter().max_by(|(_, one), (_, other)| one.depth.total_cmp(&other.depth))?;
        let (facing, normal) = (first.0, first.1.normal);
        if first.1.depth >= 0.0 {
            return None;
        }
        let alike: Vec<_> = met.iter().filter(|(of, _)| *of == facing).map(|(_, met)| met).collect();
        let middle = alike.iter().fold(Vector3::zero(), |sum, met| sum + met.middle) * (1.0 / alike.len() as f64);
        let is_low = |met: &&&Met<f64>| normal.dot(met.middle - middle) <= ROUNDING_M;
        let low: Vec<_> = alike.iter().filter(is_low).collect();
        let normal = first.1.in_world(normal);
        let across =
            normal.cross(if normal[2].abs() < 0.9 { Vector3::new(0.0, 0.0, 1.0) } else { Vector3::new(1.0, 0.0, 0.0) });
        let across = across.direction();
        let along = self.friction.map_or(0.0, |friction| friction.stiffness);
        let stiff = [(normal, self.stiffness), (across, along), (normal.cross(across), along)];
        let springs = low.iter().flat_map(|met| {
            let own = met.point;
            let other = own + normal * met.depth;
            let points = if facing == Facing::Load { [own, other] } else { [other, own] };
            stiff.into_iter().filter(|(_, k)| *k > 0.0).map(move |(direction, stiffness)| Spring {
                stiffness,
                direction,
                points,
            })
        });
        Some((springs.collect(), low.len()))
    }
}

/// Returns a vector that is not perpendicular to an eigenvector by symmetry.
fn seed(length: usize) -> Vec<f64> {
    (0..length).map(|i| 1.0 + 0.37 * libm::sin(1.0 + 2.3 * i as f64)).collect()
}

/// Returns the link of a body; `None` if it is fixed to the world.
fn mover(at: &Context<'_>, body: usize) -> Option<Mover> {
    let of = &at.model.bodies[body];
    let link = of.link?;
    let frame = at.links.body_frame(at.model, body).times(&of.in_link.inverse());
    Some(Mover { frame, inertia: at.model.links.nodes[link].inertia })
}

impl Mover {
    /// Returns the linear and the angular acceleration of the link under the efforts of the springs, and the point to
    /// which the linear one belongs, world axes.
    fn accelerated(&self, springs: &[Spring], efforts: &[f64], side: usize, sign: f64) -> (Vector3, Vector3, Vector3) {
        let Frame { rotation, position } = self.frame;
        let (mut force, mut moment) = (Vector3::zero(), Vector3::zero());
        for (spring, effort) in springs.iter().zip(efforts) {
            let pull = spring.direction * (sign * effort * libm::sqrt(spring.stiffness));
            force += pull;
            moment += (spring.points[side] - position).cross(pull);
        }
        let own = Wrench { moment: rotation.transpose_times(moment), force: rotation.transpose_times(force) };
        let Twist { angular, linear } = self.inertia.solve(&own);
        (rotation * linear, rotation * angular, position)
    }
}
