//! A line over a part of a step, by the implicit midpoint rule: its axial waves do not limit the step of the ship.
//!
//! From the base of the step, where positions and velocities are `x_0` and `v_0`, to a time H later, where the ends have
//! moved with their bodies, the nodes between the ends move by
//!
//! ```text
//! M (v_1 - v_0) / H = F,      (x_1 - x_0) / H = (v_0 + v_1) / 2
//! ```
//!
//! F is the mean force of the interval (`span.rs`): the rule neither gains nor loses energy, at any H. Tangents, added masses
//! and the water's motion are those of the middle of the step, predicted with `v_0`. The rule has second order. The motion of
//! the material through the nodes (`pay_out.rs`) changes `x_1 - x_0` by c (L_1 - L_0), and the force by a part that its
//! derivatives leave out: it is smaller by the speed of paying out over that of the waves in the line.
//!
//! Newton's method solves for `x_1`. It begins with the mean acceleration to the last point; at another point at the same time,
//! as Kutta's scheme has two of each, with that point and the linear effect of the other places of the ends. The matrix of an
//! iteration serves for one more, also at such a point: the error falls by the change of the matrix, about as much as the first
//! move is smaller than an element, and more slowly where friction begins. Where the line became slack or left the ground since,
//! such a move can be much too short, and does not end the search. Each further iteration computes its matrix. Derivatives
//! follow by the matrix at the solution (implicit function theorem).

use super::bend::LineEnds;
use super::blocks::Blocks;
use super::descent::Descent;
use super::ground::LineGround;
use super::mesh::LineMesh;
use super::nodes::Nodes;
use super::section::WetPart;
use super::span::{LineSpan, NodeLoads};
use crate::dynamics::Clock;
use crate::elements::Context;
use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// Last move of a node, as a share of the length of an element, at which Newton's method has converged: the next move would
/// be about the square of this share.
pub const CONVERGED: f64 = 1e-6;
/// Last move with an old matrix at which it has converged: the next one would be smaller, but by the change of the matrix only.
const CONVERGED_WITH_OLD: f64 = 1e-9;
/// Largest number of iterations; 1 to 3 are usual, more if nodes touch the ground or become slack.
pub const MOST_ITERATIONS: usize = 60;
/// Longest move of a node in an iteration, as a share of the length of an element.
const LONGEST_MOVE: f64 = 0.5;
/// Change of a derivative that jumps, as a share of the jump, after which a matrix is too old to end the search.
const JUMPED: f64 = 0.1;

/// Energy of a line over a part of a step, J.
#[derive(Clone, Copy, Debug)]
pub struct Booked<S> {
    /// Heat of damping, water and ground.
    pub dissipated: S,
    /// Work of the water, without the heat.
    pub outside: S,
    /// Work of the line's tension on its ends.
    pub on_ends: S,
}

/// A step of a line: its base, and the last point to which it was advanced.
#[derive(Clone, Debug)]
pub struct LineStep<S> {
    span: LineSpan<S>,
    /// Equations, with the matrix of an iteration.
    blocks: Blocks<S>,
    /// Derivatives that jump, for that matrix.
    rises: Vec<S>,
    descent: Descent<S>,
    /// Energy of the line without its ends at the base, J.
    energy: S,
}

impl<S: Scalar> LineStep<S> {
    /// Allocates the memory for the nodes of a mesh.
    pub fn new(mesh: &LineMesh<S>) -> Self {
        let count = mesh.nodes.len();
        Self {
            rises: vec![S::ZERO; 2 * count - 1],
            span: LineSpan::new(mesh),
            blocks: Blocks::new(count, mesh.moving(), !mesh.bends.is_empty()),
            descent: Descent::new(count),
            energy: S::ZERO,
        }
    }

    /// Begins a step at the motion of these nodes, paying out at this rate (m/s); the context is that of its start. Leaves the
    /// first part of the mesh with its length in the middle of the step.
    pub fn begin(
        &mut self,
        nodes: &Nodes<S>,
        mesh: &mut LineMesh<S>,
        (ground, rate): (Option<&LineGround<S>>, S),
        at: &Context<'_, S>,
    ) {
        let Clock { time_s, middle_s } = at.clock;
        self.span.begin(nodes, mesh, [time_s, middle_s]);
        let motion = |i: usize| [self.span.base[i].position, self.span.base[i].velocity];
        self.energy = self.span.energy_of(mesh, ground, at.world.gravity, motion, &nodes.directions);
        if mesh.supplied > 0 {
            mesh.set_first(mesh.first() + rate * S::constant(middle_s - time_s));
            self.span.drift(mesh);
        }
        self.span.load_base(mesh, at);
    }

    /// Returns the water about a node, and the time from its motion to a time, s.
    pub fn water_at(&self, node: usize, time_s: f64) -> (&WetPart<S>, f64) {
        (&self.span.base[node].wet, time_s - self.span.clock[1])
    }

    /// Moves the nodes to a time, at which the ends have this motion and the first part has its length in the mesh.
    ///
    /// # Errors
    /// The last move of the iteration, m, if it does not converge.
    pub fn advance(
        &mut self,
        mesh: &LineMesh<S>,
        ground: Option<&LineGround<S>>,
        LineEnds { places, directions }: &LineEnds<S>,
        time_s: f64,
    ) -> Result<(), f64> {
        let Self { span, blocks, rises, descent, .. } = self;
        span.paid[1] = mesh.first() - span.paid[0];
        span.directions = *directions;
        let interval_s = time_s - span.clock[0];
        let is_same_time = interval_s == span.clock[2];
        if !is_same_time {
            span.predict(interval_s);
        }
        let moved = span.move_ends(*places, mesh.moving().end);
        if is_same_time {
            descent.follow(blocks, moved, &mut span.next);
            let stays = moved.iter().all(|way| way.norm_squared().all(|square| square == 0.0));
            if stays && mesh.supplied == 0 && mesh.bends.is_empty() {
                return Ok(());
            }
        }
        let [with_new, with_old, longest] =
            [CONVERGED, CONVERGED_WITH_OLD, LONGEST_MOVE].map(|share| mesh.shortest() * S::constant(share));
        descent.begin();
        for iteration in 0..MOST_ITERATIONS {
            let has_old = if is_same_time { iteration == 0 } else { iteration == 1 };
            if has_old {
                span.equations::<false>(blocks, mesh, ground);
                descent.improve(blocks, &mut span.next, [with_old, longest], have_not_jumped(rises, &span.rises));
            } else {
                span.equations::<true>(blocks, mesh, ground);
                blocks.factor();
                rises.copy_from_slice(&span.rises);
                descent.improve(blocks, &mut span.next, [with_new, longest], S::ONE);
            }
            if descent.has_arrived() {
                if S::HAS_DERIVATIVES {
                    span.equations::<true>(blocks, mesh, ground);
                    blocks.factor();
                    descent.differentiate(blocks, &mut span.next);
                }
                return Ok(());
            }
        }
        Err(descent.size().value())
    }

    /// Returns the energy of the line over the interval to the last point: its ends get what its energy loses, without heat and
    /// with the work of the water.
    pub fn booked(&self, mesh: &LineMesh<S>, ground: Option<&LineGround<S>>, gravity: S) -> Booked<S> {
        let span = &self.span;
        let interval = S::constant(span.clock[2]);
        let mut booked = Booked { dissipated: S::ZERO, outside: S::ZERO, on_ends: S::ZERO };
        for k in 0..span.points() {
            booked.dissipated += span.heat_of_damping(k, mesh);
        }
        for i in mesh.moving() {
            let NodeLoads { water, heat: [of_drag, of_ground], .. } = span.loads(i, ground, interval);
            let mut acceleration = (span.velocity(i) - span.base[i].velocity) * (S::ONE / interval);
            if i < span.drifts.len() {
                acceleration -= span.convected(i, mesh, S::ONE / interval);
            }
            // The water's part of the inertia is outside of the line.
            let of_water = water - span.base[i].added * acceleration;
            booked.dissipated += of_drag + of_ground;
            booked.outside += of_water.dot(span.way(i)) + of_drag;
        }
        let motion = |i: usize| [span.next[i], span.velocity(i)];
        let change = span.energy_of(mesh, ground, gravity, motion, &span.directions) - self.energy;
        booked.on_ends = booked.outside - booked.dissipated - change;
        booked
    }

    /// Returns the position of a node at the last point, world, m.
    pub fn position(&self, node: usize) -> Vector3<S> {
        self.span.next[node]
    }

    /// Whether the line was advanced since the base of the step.
    pub fn has_advanced(&self) -> bool {
        self.span.clock[2] > 0.0
    }

    /// Returns the velocity of a node by the midpoint rule at the last point, world, m/s.
    pub fn velocity(&self, node: usize) -> Vector3<S> {
        self.span.velocity(node)
    }
}

/// Returns 1 if derivatives that jump are the old ones, else 0.
fn have_not_jumped<S: Scalar>(old: &[S], new: &[S]) -> S {
    let squares = old.iter().zip(new).map(|(old, new)| (*new - *old) * (*new - *old));
    squares.fold(S::ONE, |so_far, square| square.select_below(JUMPED * JUMPED, || so_far, || S::ZERO))
}
