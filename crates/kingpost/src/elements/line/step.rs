//! Lines over a part of a step, by the implicit midpoint rule: their axial waves do not limit the step of the ship.
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
use super::descent::Descent;
use super::equations::LineEquations;
use super::mesh::LineMesh;
use super::section::WetPart;
use super::span::{LineSpan, NodeLoads};
use super::strand::{Strand, shortest};
use crate::dynamics::Clock;
use crate::elements::Context;
use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// Last move of a node, as a share of the length of an element, at which Newton's method has converged. The next move would be
/// about the square of this share; where friction begins, which it does over 1e-4 of an element, 1e-12 of an element.
pub const CONVERGED: f64 = 1e-8;
/// Last move with an old matrix at which it has converged: the next one would be smaller, but by the change of the matrix only.
const CONVERGED_WITH_OLD: f64 = 1e-9;
/// Largest number of iterations; 1 to 3 are usual, more if nodes touch the ground or become slack.
pub const MOST_ITERATIONS: usize = 60;
/// Longest move of a node in an iteration, as a share of the length of an element.
const LONGEST_MOVE: f64 = 0.5;
/// Change of a derivative that jumps, as a share of the jump, after which a matrix is too old to end the search.
const JUMPED: f64 = 0.1;

/// Energy of lines over a part of a step, J.
#[derive(Clone, Copy, Debug)]
pub struct Booked<S> {
    /// Heat of damping, water and ground.
    pub dissipated: S,
    /// Work of the water, without the heat.
    pub outside: S,
    /// Work of the lines' tensions on the ends on bodies.
    pub on_ends: S,
}

/// A step of lines: its base, and the last point to which they were advanced.
#[derive(Clone, Debug)]
pub struct LineStep<S> {
    /// Each line, behind the one to which it is fastened.
    spans: Vec<LineSpan<S>>,
    /// Equations, with the matrix of an iteration.
    equations: LineEquations<S>,
    /// Derivatives that jump, for that matrix.
    rises: Vec<S>,
    /// Moves of the ends of each line from the last point to the next, m.
    moved: Vec<[Vector3<S>; 2]>,
    descent: Descent<S>,
    /// Tensions with which the elements at the ends of each line pull there, N.
    tensions: Vec<Vec<S>>,
    /// Impulses on the ends of each line over the interval to the last point, world, N s: zero where it is not held.
    impulses: Vec<[Vector3<S>; 2]>,
    /// Energy of the lines without their ends on bodies at the base, J.
    energy: S,
}

impl<S: Scalar> LineStep<S> {
    /// Allocates the memory for the nodes of lines.
    pub fn new(strands: &[Strand<S>]) -> Self {
        let spans: Vec<_> = strands.iter().map(|strand| LineSpan::new(&strand.mesh)).collect();
        Self {
            rises: vec![S::ZERO; spans.iter().map(|span| span.rises.len()).sum()],
            moved: Vec::new(),
            descent: Descent::new(spans.iter().map(|span| span.base.len()).sum()),
            tensions: spans.iter().map(|span| vec![S::ZERO; span.points()]).collect(),
            impulses: vec![[Vector3::zero(); 2]; spans.len()],
            spans,
            equations: LineEquations::new(strands),
            energy: S::ZERO,
        }
    }

    /// Begins a step at the motion of the nodes of lines, the first of which is paid out at this rate (m/s); the context is that
    /// of its start. Leaves the first part of the mesh with its length in the middle of the step.
    pub fn begin(&mut self, strands: &mut [Strand<S>], rate: S, at: &Context<'_, S>) {
        let Clock { time_s, middle_s } = at.clock;
        for (span, strand) in self.spans.iter_mut().zip(&*strands) {
            span.begin(&strand.nodes, &strand.mesh, [time_s, middle_s]);
        }
        self.energy =
            self.energy_of(strands, at.world.gravity, |span, i| [span.base[i].position, span.base[i].velocity]);
        for (span, strand) in self.spans.iter_mut().zip(strands) {
            let mesh = &mut strand.mesh;
            if mesh.supplied > 0 {
                mesh.set_first(mesh.first() + rate * S::constant(middle_s - time_s));
                span.drift(mesh);
            }
            span.load_base(mesh, at);
        }
    }

    /// Returns the energy of lines without their ends on bodies, J, with these positions and velocities of their nodes.
    fn energy_of(
        &self,
        strands: &[Strand<S>],
        gravity: S,
        motion: impl Fn(&LineSpan<S>, usize) -> [Vector3<S>; 2],
    ) -> S {
        let of = |(span, strand): (&LineSpan<S>, &Strand<S>)| {
            let Strand { mesh, ground, nodes, .. } = strand;
            let directions = if self.has_advanced() { &span.directions } else { &nodes.directions };
            span.energy_of(mesh, ground.as_ref(), gravity, |i| motion(span, i), directions)
        };
        self.spans.iter().zip(strands).map(of).fold(S::ZERO, |sum, energy| sum + energy)
    }

    /// Returns the water about a node of a line, and the time from its motion to a time, s.
    pub fn water_at(&self, strand: usize, node: usize, time_s: f64) -> (&WetPart<S>, f64) {
        let span = &self.spans[strand];
        (&span.base[node].wet, time_s - span.clock[1])
    }

    /// Moves the nodes to a time, at which the ends have these motions and the first part has its length in the mesh.
    ///
    /// # Errors
    /// The last move of the iteration, m, if it does not converge.
    pub fn advance(
        &mut self,
        strands: &[Strand<S>],
        ends: impl Iterator<Item = LineEnds<S>>,
        time_s: f64,
    ) -> Result<(), f64> {
        self.solve(strands, ends, time_s)?;
        self.pull(strands, false);
        Ok(())
    }

    /// Computes the tensions at the ends at the base of the interval, or at its last point.
    pub fn pull(&mut self, strands: &[Strand<S>], is_base: bool) {
        for ((span, tensions), strand) in self.spans.iter().zip(&mut self.tensions).zip(strands) {
            let last = tensions.len() - 1;
            for point in [0, 1, last - 1, last] {
                tensions[point] = span.tension_at(is_base, point, &strand.mesh);
            }
        }
    }

    fn solve(
        &mut self,
        strands: &[Strand<S>],
        ends: impl Iterator<Item = LineEnds<S>>,
        time_s: f64,
    ) -> Result<(), f64> {
        let Self { spans, equations, rises, moved, descent, .. } = self;
        let interval_s = time_s - spans[0].clock[0];
        let is_same_time = interval_s == spans[0].clock[2];
        let points = spans.iter_mut().zip(strands).zip(ends);
        moved.clear();
        moved.extend(points.map(|((span, line), ends)| to_point(span, &line.mesh, &ends, (interval_s, is_same_time))));
        let mut open = S::ONE;
        if is_same_time {
            descent.follow(equations, moved, spans.iter_mut().map(|span| &mut span.next));
            if strands.iter().all(|Strand { mesh, .. }| mesh.supplied == 0 && mesh.bends.is_empty()) {
                open = have_moved(moved);
            }
        }
        descent.begin_again(open);
        if descent.has_arrived() {
            self.differentiate(strands);
            return Ok(());
        }
        let shortest = shortest(strands);
        let [with_new, with_old, longest] =
            [CONVERGED, CONVERGED_WITH_OLD, LONGEST_MOVE].map(|share| shortest * S::constant(share));
        for iteration in 0..MOST_ITERATIONS {
            let has_old = if is_same_time { iteration == 0 } else { iteration == 1 };
            let (mut may_arrive, mut enough) = (S::ONE, with_new);
            if has_old {
                write::<S, false>(equations, spans, strands);
                (may_arrive, enough) = (have_not_jumped(rises, spans), with_old);
            } else {
                // Lanes that have arrived keep their matrix, as if they were alone.
                let open = descent.open();
                let kept = (!open.all(|open| open == 1.0)).then(|| equations.clone());
                write::<S, true>(equations, spans, strands);
                equations.factor();
                kept.iter().for_each(|kept| equations.keep(kept, open));
                for (old, new) in rises.iter_mut().zip(spans.iter().flat_map(|span| &span.rises)) {
                    *old = open.select_below(0.5, || *old, || *new);
                }
            }
            let nodes = spans.iter_mut().map(|span| &mut span.next);
            descent.improve(equations, nodes, [enough, longest], may_arrive);
            if descent.has_arrived() {
                self.differentiate(strands);
                return Ok(());
            }
        }
        Err(descent.size().value())
    }

    /// Completes the derivatives of positions that have arrived. The matrix of the values stays: the next point begins as it does
    /// without derivatives.
    fn differentiate(&mut self, strands: &[Strand<S>]) {
        if !S::HAS_DERIVATIVES {
            return;
        }
        let Self { spans, equations, descent, .. } = self;
        let kept = equations.clone();
        write::<S, true>(equations, spans, strands);
        equations.factor();
        descent.differentiate(equations, spans.iter_mut().map(|span| &mut span.next));
        *equations = kept;
    }

    /// Returns the energy of lines over the interval to the last point: the ends on bodies get what their energy loses, without
    /// heat and with the work of the water. Computes the impulses on the ends: the first end of a line that is paid out gets
    /// what the momentum of all lines loses, without the impulses on the others.
    pub fn booked(&mut self, strands: &[Strand<S>], gravity: S) -> Booked<S> {
        let mut booked = Booked { dissipated: S::ZERO, outside: S::ZERO, on_ends: S::ZERO };
        let mut lost = Vector3::zero();
        for ((span, strand), impulses) in self.spans.iter().zip(strands).zip(&mut self.impulses) {
            lost += book(span, strand, &mut booked);
            let interval = S::constant(span.clock[2]);
            let of = |end: usize| {
                strand.ends[end].map_or(Vector3::zero(), |_| span.pull_on_end(end, &strand.mesh) * interval)
            };
            *impulses = [0, 1].map(of);
        }
        if strands[0].mesh.supplied > 0 {
            let others = self.impulses.iter().flatten().skip(1).fold(Vector3::zero(), |sum, impulse| sum + *impulse);
            self.impulses[0][0] = lost - others;
        }
        let change = self.energy_of(strands, gravity, |span, i| [span.next[i], span.velocity(i)]) - self.energy;
        booked.on_ends = booked.outside - booked.dissipated - change;
        booked
    }

    /// Returns the position of a node of a line at the last point, world, m.
    pub fn position(&self, strand: usize, node: usize) -> Vector3<S> {
        self.spans[strand].next[node]
    }

    /// Returns the impulse on an end of a line over the interval to the last point, world, N s.
    pub fn impulse(&self, strand: usize, end: usize) -> Vector3<S> {
        self.impulses[strand][end]
    }

    /// Returns the tension at a point of Gauss's rule in an element at an end, with which the line pulls there at a stage, N.
    pub fn tension(&self, strand: usize, point: usize) -> S {
        self.tensions[strand][point]
    }

    /// Whether the lines were advanced since the base of the step.
    pub fn has_advanced(&self) -> bool {
        self.spans[0].clock[2] > 0.0
    }

    /// Returns the velocity of a node of a line by the midpoint rule at the last point, world, m/s.
    pub fn velocity(&self, strand: usize, node: usize) -> Vector3<S> {
        self.spans[strand].velocity(node)
    }
}

/// Predicts a line at a point this time (s) after the base, unless it is the time of the last point. Returns the moves of its ends
/// to their places there.
fn to_point<S: Scalar>(
    span: &mut LineSpan<S>,
    mesh: &LineMesh<S>,
    ends: &LineEnds<S>,
    (interval_s, is_same_time): (f64, bool),
) -> [Vector3<S>; 2] {
    span.paid[1] = mesh.first() - span.paid[0];
    span.directions = ends.directions;
    if !is_same_time {
        span.predict(interval_s);
    }
    span.move_ends(ends.places, mesh.moving().end)
}

/// Writes the equations of Newton's method for lines; without `MATRIX`, their right sides only.
fn write<S: Scalar, const MATRIX: bool>(
    equations: &mut LineEquations<S>,
    spans: &mut [LineSpan<S>],
    strands: &[Strand<S>],
) {
    for ((blocks, span), strand) in equations.strands.iter_mut().zip(spans).zip(strands) {
        span.equations::<MATRIX>(blocks, &strand.mesh, strand.ground.as_ref());
    }
}

/// Adds heat and work of the water of a line over the interval to the last point. Returns the momentum that the nodes that move by
/// themselves lost to others, N s.
fn book<S: Scalar>(span: &LineSpan<S>, Strand { mesh, ground, .. }: &Strand<S>, booked: &mut Booked<S>) -> Vector3<S> {
    let mut lost = Vector3::zero();
    let interval = S::constant(span.clock[2]);
    for k in 0..span.points() {
        booked.dissipated += span.heat_of_damping(k, mesh);
    }
    for i in mesh.moving() {
        let NodeLoads { force, water, heat: [of_drag, of_ground], .. } = span.loads(i, ground.as_ref(), interval);
        let mut acceleration = (span.velocity(i) - span.base[i].velocity) * (S::ONE / interval);
        if i < span.drifts.len() {
            acceleration -= span.convected(i, mesh, S::ONE / interval);
        }
        // The water's part of the inertia is outside of the line.
        let of_inertia = span.base[i].added * acceleration;
        let of_water = water - of_inertia;
        lost += (force - of_inertia) * interval - span.gained(i, mesh);
        booked.dissipated += of_drag + of_ground;
        booked.outside += of_water.dot(span.way(i)) + of_drag;
    }
    lost
}

/// Returns 1 for lanes in which an end has moved, else 0.
fn have_moved<S: Scalar>(moved: &[[Vector3<S>; 2]]) -> S {
    let squares = moved.iter().flatten().map(|way| way.norm_squared());
    squares.fold(S::ZERO, |so_far, square| square.select_below(f64::MIN_POSITIVE, || so_far, || S::ONE))
}

/// Returns 1 if derivatives that jump are the old ones, else 0.
fn have_not_jumped<S: Scalar>(old: &[S], spans: &[LineSpan<S>]) -> S {
    let new = spans.iter().flat_map(|span| &span.rises);
    let squares = old.iter().zip(new).map(|(old, new)| (*new - *old) * (*new - *old));
    squares.fold(S::ONE, |so_far, square| square.select_below(JUMPED * JUMPED, || so_far, || S::ZERO))
}
