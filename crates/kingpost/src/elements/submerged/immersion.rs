//! The immersion of a solid, and the motion of the water there.

use super::{ROUNDING_M, has_phases};
use crate::elements::Context;
use crate::elements::hull::{HullFrame, HullMotion};
use crate::scalar::Scalar;
use crate::sea::hull::{Below, Solid};
use crate::sea::waves::{LocalSurface, WavesAtBody};
use crate::spatial::{Frame, Twist, Vector3};
use crate::world::CurrentAt;

/// The phase of a solid: out of the water, at the surface or under water. Only events change it, so that one law holds
/// throughout a step. If the lanes of a run begin in different phases, the phase follows from the level until the first
/// event in any lane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Phase {
    ByLevel = 0,
    Dry = 1,
    Cut = 2,
    Wet = 3,
}

impl Phase {
    /// Returns the phase for these depths of the lowest and the highest point below the surface.
    pub fn of<S: Scalar>(low: S, high: S) -> Self {
        if low.all(|low| low < 0.0) {
            Self::Dry
        } else if high.all(|high| high >= 0.0) {
            Self::Wet
        } else if low.all(|low| low >= 0.0) && high.all(|high| high < 0.0) {
            Self::Cut
        } else {
            Self::ByLevel
        }
    }

    pub fn at<S>(at: &Context<'_, S>) -> Self {
        match at.modes.first().filter(|_| has_phases(at.evaluation)) {
            Some(1) => Self::Dry,
            Some(2) => Self::Cut,
            Some(3) => Self::Wet,
            _ => Self::ByLevel,
        }
    }
}

/// Working memory for the waves at a solid.
#[derive(Clone, Debug, Default)]
pub struct Waters<S = f64> {
    waves: Option<WavesAtBody<S>>,
}

/// A point of a body in the water at one moment. Vectors are in the body's axes.
pub(in crate::elements) struct PointInWater<S> {
    /// The body's axes in the world, the point their origin.
    pub frame: Frame<S>,
    /// Velocity of the point, m/s.
    pub velocity: Vector3<S>,
    /// Velocity of the water, m/s.
    pub stream: Vector3<S>,
    /// Depth of the point below the sea, along the vertical, m.
    pub depth: S,
}

/// A solid in the water at one moment. Vectors are in the body's axes.
pub(super) struct Immersion<S> {
    /// The solid's axes in the world, its centre their origin.
    pub frame: Frame<S>,
    /// Twist of the body about that centre.
    pub twist: Twist<S>,
    /// The part below the surface.
    pub below: Below<S>,
    /// b: the centre of that part, m.
    pub centre: Vector3<S>,
    /// s, and its rate, 1/s.
    pub share: S,
    pub share_rate: S,
    /// phi(s), and its rate, 1/s.
    pub factor: S,
    pub factor_rate: S,
    /// u: velocity of the water, m/s.
    pub stream: Vector3<S>,
    /// a: its acceleration, m/s^2.
    pub acceleration: Vector3<S>,
    /// Whether there are waves.
    pub in_waves: bool,
    /// Elevation of the sea at the solid's centre, m, and its slopes along the world's x and y.
    elevation: S,
    slopes: [S; 2],
    /// The sea's surface in the solid's axes.
    plane: Plane<S>,
    phase: Phase,
}

impl<S: Scalar> Immersion<S> {
    /// Returns 1 while the surface cuts the solid, otherwise 0.
    pub fn is_cut(&self, solid: &Solid<S>) -> S {
        let (level, reach) = (self.plane.level, solid.reach(self.plane.normal));
        match self.phase {
            Phase::Dry | Phase::Wet => S::ZERO,
            Phase::Cut => S::ONE,
            Phase::ByLevel => {
                (-reach).select_less(level, || level.select_less(reach, || S::ONE, || S::ZERO), || S::ZERO)
            }
        }
    }

    /// Returns w, the speed at which the solid's centre sinks through the surface, m/s.
    pub fn sinking_speed(&self) -> S {
        self.plane.level_rate * self.plane.scale
    }

    /// Returns n, the upward normal of the surface.
    pub fn surface_normal(&self) -> Vector3<S> {
        self.plane.normal
    }

    /// Returns the velocity of the body at b.
    pub fn velocity_at_centre(&self) -> Vector3<S> {
        self.twist.linear + self.twist.angular.cross(self.centre)
    }

    /// Returns the depth of a point below the sea, along the vertical, m; the point is in the solid's axes.
    pub fn depth(&self, point: Vector3<S>) -> S {
        depth(&self.frame, point, self.elevation, self.slopes)
    }
}

/// Returns the depth of a point of a frame below the plane of the sea with this elevation and these slopes at the
/// frame's origin.
fn depth<S: Scalar>(frame: &Frame<S>, point: Vector3<S>, elevation: S, [x, y]: [S; 2]) -> S {
    let off = frame.rotation * point;
    elevation + x * off[0] + y * off[1] - frame.position[2] - off[2]
}

/// The surface in the solid's axes: points r with N . r < L are below it, with the normal N = (-slopes, 1); N and L are
/// divided by the length of N.
struct Plane<S> {
    normal: Vector3<S>,
    level: S,
    /// Rates of normal and level for points fixed in the body, and 1 / |N|.
    normal_rate: Vector3<S>,
    level_rate: S,
    scale: S,
}

impl<S: Scalar> Plane<S> {
    fn of(surface: &LocalSurface<S>, motion: &HullMotion<S>) -> Self {
        let (rotation, [vx, vy, vz]) = (&motion.frame.rotation, (motion.frame.rotation * motion.twist.linear).0);
        let [x, y] = surface.slopes;
        let [xx, xy, yy] = surface.curvatures;
        let upward = rotation.transpose_times(Vector3::new(-x, -y, S::ONE));
        let slope_rates = [surface.slope_rates[0] + xx * vx + xy * vy, surface.slope_rates[1] + xy * vx + yy * vy];
        let turning = rotation.transpose_times(Vector3::new(-slope_rates[0], -slope_rates[1], S::ZERO));
        let scale = S::ONE / (S::ONE + x * x + y * y).sqrt();
        Self {
            normal: upward * scale,
            level: (surface.elevation - motion.frame.position[2]) * scale,
            normal_rate: turning - motion.twist.angular.cross(upward),
            level_rate: surface.rate + x * vx + y * vy - vz,
            scale,
        }
    }

    /// Returns dV/dt, the volume of the solid that the plane sweeps per time.
    fn volume_rate(&self, below: &Below<S>) -> S {
        (self.level_rate * below.area - self.normal_rate.dot(below.area_moment)) * self.scale
    }
}

impl<S: Scalar> Waters<S> {
    /// Returns the memory for the waves of this world, if there are any.
    pub fn new(world: &crate::world::World<S>) -> Self {
        Self { waves: world.waves.as_ref().map(WavesAtBody::new) }
    }

    fn surface(&mut self, at: &Context<'_, S>, [x, y, _]: [S; 3]) -> LocalSurface<S> {
        match (&mut self.waves, &at.world.waves) {
            (Some(waves), Some(field)) if at.evaluation.has_waves() => waves.surface(field, [x, y], at.clock.time_s),
            _ => LocalSurface::still(),
        }
    }

    /// Returns the depths of the lowest and the highest point of a solid below the surface, perpendicular to the
    /// surface, m.
    pub(super) fn margins(&mut self, at: &Context<'_, S>, place: &HullFrame<S>, solid: &Solid<S>) -> [S; 2] {
        let motion = place.motion(at);
        let plane = Plane::of(&self.surface(at, motion.frame.position.0), &motion);
        let reach = solid.reach(plane.normal);
        [plane.level + reach, plane.level - reach]
    }

    /// Returns the depth of a point below the sea, along the vertical, m: [`Immersion::depth`].
    pub(super) fn depth(&mut self, at: &Context<'_, S>, place: &HullFrame<S>, point: Vector3<S>) -> S {
        let frame = place.frame(at.model, at.links);
        let surface = self.surface(at, frame.position.0);
        depth(&frame, point, surface.elevation, surface.slopes)
    }

    /// Returns a point of a body, and the water at this point.
    pub(in crate::elements) fn point(&mut self, at: &Context<'_, S>, place: &HullFrame<S>) -> PointInWater<S> {
        let motion = place.motion(at);
        let surface = self.surface(at, motion.frame.position.0);
        let [stream, _] = self.water(at, &motion, &surface, Vector3::zero());
        let depth = depth(&motion.frame, Vector3::zero(), surface.elevation, surface.slopes);
        PointInWater { frame: motion.frame, velocity: motion.twist.linear, stream, depth }
    }

    /// Returns the immersion of a solid, without phi.
    pub(super) fn immersion(&mut self, at: &Context<'_, S>, place: &HullFrame<S>, solid: &Solid<S>) -> Immersion<S> {
        let motion = place.motion(at);
        let surface = self.surface(at, motion.frame.position.0);
        let plane = Plane::of(&surface, &motion);
        let whole = solid.volume();
        let none =
            Below { volume: S::ZERO, first_moment: Vector3::zero(), area: S::ZERO, area_moment: Vector3::zero() };
        let phase = Phase::at(at);
        let below = match phase {
            Phase::Dry => none,
            Phase::Wet => Below { volume: whole, ..none },
            Phase::Cut => {
                // At first contact the waterplane must already have an area.
                let reach = solid.reach(plane.normal) - S::constant(1e-3 * ROUNDING_M);
                solid.below(plane.normal, plane.level.clipped(-reach, reach))
            }
            Phase::ByLevel => solid.below(plane.normal, plane.level),
        };
        let share = below.volume / whole;
        // Below 1e-12 of the volume the centre is a quotient of rounding errors, and every force at it is negligible.
        let divisor = share.select_below(1e-12, || whole, || below.volume);
        let centre = Vector3(below.first_moment.0.map(|moment| moment / divisor));
        let [stream, acceleration] = self.water(at, &motion, &surface, centre);
        Immersion {
            share,
            share_rate: plane.volume_rate(&below) / whole,
            factor: S::ZERO,
            factor_rate: S::ZERO,
            below,
            centre,
            stream,
            acceleration,
            in_waves: self.waves.is_some() && at.evaluation.has_waves(),
            elevation: surface.elevation,
            slopes: surface.slopes,
            plane,
            phase,
            frame: motion.frame,
            twist: motion.twist,
        }
    }

    /// Returns velocity and acceleration of the water at the depth of a solid's wet part, in the body's axes.
    fn water(
        &self,
        at: &Context<'_, S>,
        motion: &HullMotion<S>,
        surface: &LocalSurface<S>,
        centre: Vector3<S>,
    ) -> [Vector3<S>; 2] {
        let z = motion.frame.position[2] + (motion.frame.rotation * centre)[2];
        let depth = z.select_below(0.0, || -z, || S::ZERO);
        let current = at.world.current_at(&CurrentAt::Depth(depth));
        let [velocity, acceleration] = match (&self.waves, &at.world.waves) {
            (Some(waves), Some(field)) if at.evaluation.has_waves() => waves.motion(field, surface.elevation, z),
            _ => [Vector3::zero(); 2],
        };
        [velocity + current, acceleration].map(|vector| motion.frame.rotation.transpose_times(vector))
    }
}
