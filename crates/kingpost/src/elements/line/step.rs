//! A line over a part of a step, by the implicit midpoint rule: its axial waves do not limit the step of the ship.
//!
//! From the base of the step, where positions and velocities are `x_0` and `v_0`, to a time H later, where the ends have
//! moved with their bodies, the nodes between the ends move by
//!
//! ```text
//! M (v_1 - v_0) / H = F,      (x_1 - x_0) / H = (v_0 + v_1) / 2
//! ```
//!
//! F is the mean force of the interval. Tension and ground have discrete gradients (Simo & Tarnow, *ZAMP* 43, 1992; Gonzalez,
//! *J. Nonlinear Sci.* 6, 1996): their work is the change of their energy, so that the rule neither gains nor loses energy,
//! at any H. Tangents, added masses and the water's motion are those of the middle of the step, predicted with `v_0`. The
//! rule has second order. Newton's method solves for `x_1`, with exact derivatives. The motion of the material through the
//! nodes (`pay_out.rs`) changes `x_1 - x_0` by c (L_1 - L_0), and the force by a part that its derivatives leave out: it is
//! smaller by the speed of paying out over that of the waves in the line.

use super::bend::LineEnds;
use super::blocks::Blocks;
use super::descent::Descent;
use super::feed::write_drifts;
use super::ground::LineGround;
use super::mesh::{LineMesh, LineMeshElement};
use super::nodes::{Nodes, tangents};
use super::one_sided::share_at_end;
use super::section::WetPart;
use super::strain::{gauss, slopes, sum};
use crate::dynamics::Clock;
use crate::elements::Context;
use crate::elements::lines::length_and_direction;
use crate::scalar::Scalar;
use crate::spatial::{Matrix3, Vector3};

/// Last move of a node, as a share of the length of an element, at which Newton's method has converged: the next move would
/// be about the square of this share.
pub const CONVERGED: f64 = 1e-6;
/// Largest number of iterations; 2 or 3 are usual, more if nodes touch the ground or become slack.
pub const MOST_ITERATIONS: usize = 60;
/// Longest move of a node in an iteration, as a share of the length of an element.
const LONGEST_MOVE: f64 = 0.5;

/// Smallest stretch ratio for which a direction is computed: a line is slack there.
const LEAST_RATIO: f64 = 1e-9;

/// A node at the base of the step, with what does not change over it.
#[derive(Clone, Debug)]
struct BaseNode<S> {
    position: Vector3<S>,
    velocity: Vector3<S>,
    /// Unstretched length of the line that belongs to it, m.
    length: S,
    /// Mass with the added mass, kg.
    mass: Matrix3<S>,
    /// Added mass, kg.
    added: Matrix3<S>,
    /// Weight in air, N.
    weight: S,
    wet: WetPart<S>,
}

/// Derivatives of position and velocity along a line at the base of the step.
#[derive(Clone, Copy, Debug)]
struct BaseStretch<S> {
    way: Vector3<S>,
    /// Length of `way`: the stretch ratio.
    ratio: S,
    /// Rate of `way` of the material, 1/s.
    rate: Vector3<S>,
    /// Change of `way` at a point that moves along the material, per length that is paid out.
    drift: Vector3<S>,
}

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

/// The loads on a node over a part of a step.
struct NodeLoads<S> {
    force: Vector3<S>,
    /// Derivative of the force along the position at the end, with the sign changed, N/m.
    slope: Matrix3<S>,
    /// Force of the water, N.
    water: Vector3<S>,
    /// Heat of drag and of the ground, J.
    heat: [S; 2],
}

/// A step of a line: its base, and the last point to which it was advanced.
#[derive(Clone, Debug)]
pub struct LineStep<S> {
    base: Vec<BaseNode<S>>,
    /// Derivatives of position and velocity along the line at the base, at the points of Gauss's rule.
    stretched: Vec<BaseStretch<S>>,
    /// Curvatures at the bends of the mesh at the base.
    curved: Vec<Vector3<S>>,
    next: Vec<Vector3<S>>,
    /// Directions of the ends at the last point.
    directions: [Vector3<S>; 2],
    tangents: Vec<Vector3<S>>,
    blocks: Blocks<S>,
    descent: Descent<S>,
    /// Start and middle of the step, and time to the last point, s.
    clock: [f64; 3],
    /// Drifts of the nodes in the middle of the step, if the line is paid out.
    drifts: Vec<Vector3<S>>,
    /// Length of the first part at the base, and what is paid out from there to the last point, m.
    paid: [S; 2],
    /// Energy of the line without its ends at the base, J.
    energy: S,
}

impl<S: Scalar> LineStep<S> {
    /// Allocates the memory for the nodes of a mesh.
    pub fn new(mesh: &LineMesh<S>) -> Self {
        let count = mesh.nodes.len();
        let (zero, none) = (Vector3::zero(), Matrix3::zero());
        let node = BaseNode {
            position: zero,
            velocity: zero,
            length: S::ZERO,
            mass: none,
            added: none,
            weight: S::ZERO,
            wet: WetPart::dry(),
        };
        Self {
            base: vec![node; count],
            stretched: vec![BaseStretch { way: zero, ratio: S::ZERO, rate: zero, drift: zero }; count - 1],
            curved: vec![zero; mesh.bends.len()],
            next: vec![zero; count],
            directions: [zero; 2],
            tangents: vec![zero; count],
            blocks: Blocks::new(count, !mesh.bends.is_empty()),
            descent: Descent::new(count),
            clock: [0.0; 3],
            drifts: vec![zero; 2 * mesh.supplied],
            paid: [S::ZERO; 2],
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
        let half = S::constant(middle_s - time_s);
        (self.clock, self.paid) = ([time_s, middle_s, 0.0], [mesh.first(), S::ZERO]);
        for (i, (base, next)) in self.base.iter_mut().zip(&mut self.next).enumerate() {
            let node = nodes.node(i);
            (base.position, base.velocity) = (node.position, node.velocity);
            *next = node.position + nodes.mesh_velocity(i) * half;
        }
        for (k, stretched) in self.stretched.iter_mut().enumerate() {
            let slopes = slopes(gauss(k), mesh.elements[k / 2].length);
            let way = sum(&slopes, &[0, 1, 2].map(|i| self.base[k / 2 * 2 + i].position));
            let rate = sum(&slopes, &[0, 1, 2].map(|i| self.base[k / 2 * 2 + i].velocity));
            *stretched = BaseStretch { way, ratio: way.norm(), rate, drift: Vector3::zero() };
        }
        for (curved, bend) in self.curved.iter_mut().zip(&mesh.bends) {
            *curved = bend.curvature(|node| self.base[node].position, &nodes.directions);
        }
        let motion = |i: usize| [self.base[i].position, self.base[i].velocity];
        self.energy = self.energy_of(mesh, ground, at.world.gravity, motion, &nodes.directions);
        if mesh.supplied > 0 {
            mesh.set_first(mesh.first() + rate * half);
            self.drift(mesh);
        }
        self.load_base(mesh, at);
    }

    /// Computes the drifts in the middle of the step.
    fn drift(&mut self, mesh: &LineMesh<S>) {
        let Self { next, drifts, stretched, .. } = self;
        write_drifts(mesh, |node| next[node], drifts);
        let drift = |node: usize| drifts.get(node).copied().unwrap_or(Vector3::zero());
        for (k, point) in stretched[..2 * mesh.supplied].iter_mut().enumerate() {
            let slopes = slopes(gauss(k), mesh.elements[k / 2].length);
            let [way, change] = [
                sum(&slopes, &[0, 1, 2].map(|i| next[k / 2 * 2 + i])),
                sum(&slopes, &[0, 1, 2].map(|i| drift(k / 2 * 2 + i))),
            ];
            point.drift = change - way * (S::ONE / mesh.first());
        }
    }

    /// Computes masses and water of the nodes in the middle of the step.
    fn load_base(&mut self, mesh: &LineMesh<S>, at: &Context<'_, S>) {
        tangents(&self.next, &mut self.tangents);
        let mut at = *at;
        at.clock.time_s = at.clock.middle_s;
        for (i, (base, part)) in self.base.iter_mut().zip(&mesh.nodes).enumerate() {
            let (place, tangent, dry) = (self.next[i], self.tangents[i], part.dry_mass());
            base.length = part.length;
            base.wet = part.in_water(&at, place, tangent);
            base.added = base.wet.added.about(tangent);
            base.mass = base.added + Matrix3::identity().scaled(dry);
            base.weight = dry * at.world.gravity;
        }
    }

    /// Returns the energy of strain, and that of the nodes between the ends, with these positions and velocities, J.
    fn energy_of(
        &self,
        mesh: &LineMesh<S>,
        ground: Option<&LineGround<S>>,
        gravity: S,
        motion: impl Fn(usize) -> [Vector3<S>; 2],
        directions: &[Vector3<S>; 2],
    ) -> S {
        let half = S::constant(0.5);
        let mut energy = S::ZERO;
        for k in 0..self.stretched.len() {
            let slopes = slopes(gauss(k), mesh.elements[k / 2].length);
            let way = sum(&slopes, &[0, 1, 2].map(|i| motion(k / 2 * 2 + i)[0]));
            let LineMeshElement { length, section } = &mesh.elements[k / 2];
            energy += section.strain_energy(way.norm()) * *length * half;
        }
        for bend in &mesh.bends {
            energy += bend.energy(bend.curvature(|node| motion(node)[0], directions));
        }
        for i in 1..self.base.len() - 1 {
            let ([position, velocity], part) = (motion(i), &mesh.nodes[i]);
            energy += part.dry_mass() * (gravity * position[2] + velocity.norm_squared() * half);
            if let Some(ground) = ground {
                energy += ground.held_per_length(-ground.depth - position[2])[1] * part.length;
            }
        }
        energy
    }

    /// Returns the water about a node, and the time from its motion to a time, s.
    pub fn water_at(&self, node: usize, time_s: f64) -> (&WetPart<S>, f64) {
        (&self.base[node].wet, time_s - self.clock[1])
    }

    /// Moves the nodes to a time, at which the ends are at these positions and the first part has its length in the mesh.
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
        let interval_s = time_s - self.clock[0];
        self.paid[1] = mesh.first() - self.paid[0];
        self.directions = *directions;
        self.predict(interval_s, *places);
        let limits = [CONVERGED, LONGEST_MOVE].map(|share| mesh.shortest() * S::constant(share));
        self.descent.begin();
        for _ in 0..MOST_ITERATIONS {
            self.assemble(mesh, ground, S::constant(interval_s));
            self.descent.improve(&mut self.blocks, &mut self.next, limits, false);
            if self.descent.has_arrived() {
                return Ok(());
            }
        }
        Err(self.descent.size().value())
    }

    /// Sets the first guess: along the way to the last point of this step, or with the velocities at the base.
    fn predict(&mut self, interval_s: f64, [first, last]: [Vector3<S>; 2]) {
        let [_, _, before_s] = self.clock;
        let (ratio, interval) = (S::constant(interval_s / before_s), S::constant(interval_s));
        for (base, next) in self.base.iter().zip(&mut self.next) {
            let way = if before_s > 0.0 { (*next - base.position) * ratio } else { base.velocity * interval };
            *next = base.position + way;
        }
        let end = self.next.len() - 1;
        (self.next[0], self.next[end], self.clock[2]) = (first, last, interval_s);
    }

    /// Writes the equations of Newton's method.
    fn assemble(&mut self, mesh: &LineMesh<S>, ground: Option<&LineGround<S>>, interval: S) {
        self.blocks.clear();
        for k in 0..self.stretched.len() {
            let half = mesh.elements[k / 2].length * S::constant(0.5);
            let (slopes, _) = self.stretched_to(k, mesh);
            let (direction, [_, whole], stiffness) = self.pull(k, mesh, interval);
            self.blocks.add_at(k / 2 * 2, &slopes, &stiffness.scaled(half), -(direction * (whole * half)));
        }
        for (bend, before) in mesh.bends.iter().zip(&self.curved) {
            let after = bend.curvature(|node| self.next[node], &self.directions);
            let half = bend.stiffness * S::constant(0.5);
            self.blocks.add_at(
                bend.first,
                &bend.weights,
                &Matrix3::identity().scaled(half),
                -((*before + after) * half),
            );
        }
        let (per_s, two) = (S::ONE / interval, S::constant(2.0));
        for i in 1..self.base.len() - 1 {
            let NodeLoads { force, slope, .. } = self.loads(i, ground, interval);
            let inertia = self.base[i].mass.scaled(two * per_s * per_s);
            let mut balance = force - inertia * (self.way(i) - self.base[i].velocity * interval);
            if i < self.drifts.len() {
                balance += self.base[i].mass * self.convected(i, mesh, per_s);
            }
            self.blocks.add(i, inertia + slope, balance);
        }
    }

    /// Returns the way of the material at a node, m: without the motion of the node along the line.
    fn way(&self, node: usize) -> Vector3<S> {
        let way = self.next[node] - self.base[node].position;
        self.drifts.get(node).map_or(way, |drift| way - *drift * self.paid[1])
    }

    /// Returns the mean of `xi (dv/ds) L'` at a node of the first part, m/s^2.
    fn convected(&self, node: usize, mesh: &LineMesh<S>, per_s: S) -> Vector3<S> {
        let per_length = S::constant(mesh.nodes[node].share) / mesh.elements[node / 2].length;
        (self.way(node - 1) - self.way(node + 1)) * (per_length * per_s * per_s * self.paid[1])
    }

    /// Returns the slopes of the shape functions at a point of Gauss's rule, and the derivative of the position there.
    fn stretched_to(&self, k: usize, mesh: &LineMesh<S>) -> ([S; 3], Vector3<S>) {
        let slopes = slopes(gauss(k), mesh.elements[k / 2].length);
        (slopes, sum(&slopes, &[0, 1, 2].map(|i| self.next[k / 2 * 2 + i])))
    }

    /// Returns the direction of the mean tension at a point of Gauss's rule, its elastic and its whole value (N), and the
    /// derivative of the force along the derivative of the position.
    fn pull(&self, k: usize, mesh: &LineMesh<S>, interval: S) -> (Vector3<S>, [S; 2], Matrix3<S>) {
        let (BaseStretch { way: before, ratio: ratio_before, rate: rate_before, drift }, per_s) =
            (self.stretched[k], S::ONE / interval);
        let section = &mesh.elements[k / 2].section;
        let (_, after) = self.stretched_to(k, mesh);
        let (ratio, tangent) = length_and_direction(after);
        let share = share_at_end(interval, section.damping_time);
        // The rate at the end by the midpoint rule, and its part along the line.
        let sum = ratio_before + ratio;
        let least = |ratio: S| ratio.select_below(LEAST_RATIO, || S::constant(LEAST_RATIO), || ratio);
        let per_sum = S::ONE / least(sum);
        let direction = (before + after) * per_sum;
        let drifted = drift * self.paid[1];
        let at_end = (after - before - drifted) * (per_s + per_s) - rate_before;
        let stretches = tangent.dot(at_end);
        let mean = (ratio - ratio_before - direction.dot(drifted)) * per_s;
        let rate = mean * (S::ONE - share) + stretches * share;
        let (tension, [rise, per_rate]) = section.mean_tension([ratio_before, ratio], rate);
        let across = Matrix3::identity() - Matrix3::outer(direction, tangent);
        let turns = (at_end - tangent * stretches) * (per_rate * share / least(ratio));
        let along = tangent * (rise + per_rate * (S::ONE + share) * per_s) + turns;
        (direction, tension, Matrix3::outer(direction, along) + across.scaled(tension[1] * per_sum))
    }

    /// Returns the mean loads on a node between the ends.
    fn loads(&self, node: usize, ground: Option<&LineGround<S>>, interval: S) -> NodeLoads<S> {
        let (base, way) = (&self.base[node], self.way(node));
        let per_s = S::ONE / interval;
        let later = S::constant(self.clock[0] - self.clock[1]) + interval * S::constant(0.5);
        let drag = base.wet.drag(way * per_s, later);
        let water = base.wet.steady + drag.force;
        let mut loads = NodeLoads {
            force: water - Vector3::new(S::ZERO, S::ZERO, base.weight),
            slope: drag.slope.scaled(per_s),
            water,
            heat: [drag.force.dot(drag.relative) * interval, S::ZERO],
        };
        if let Some(ground) = ground {
            let depths = [base.position[2], self.next[node][2]].map(|z| -ground.depth - z);
            let sinking = -base.velocity[2];
            let (support, heat, slope) = ground.mean_support(base.length, (depths, sinking), way, interval);
            loads.force += support;
            loads.slope += slope;
            loads.heat[1] = heat;
        }
        loads
    }

    /// Returns the energy of the line over the interval to the last point: its ends get what its energy loses, without heat and
    /// with the work of the water.
    pub fn booked(&self, mesh: &LineMesh<S>, ground: Option<&LineGround<S>>, gravity: S) -> Booked<S> {
        let interval = S::constant(self.clock[2]);
        let mut booked = Booked { dissipated: S::ZERO, outside: S::ZERO, on_ends: S::ZERO };
        for k in 0..self.stretched.len() {
            let BaseStretch { ratio, drift, .. } = self.stretched[k];
            let half = mesh.elements[k / 2].length * S::constant(0.5);
            let (_, after) = self.stretched_to(k, mesh);
            let (direction, [elastic, whole], _) = self.pull(k, mesh, interval);
            let lengthens = after.norm() - ratio - direction.dot(drift * self.paid[1]);
            booked.dissipated += (whole - elastic) * lengthens * half;
        }
        for i in 1..self.base.len() - 1 {
            let NodeLoads { water, heat: [of_drag, of_ground], .. } = self.loads(i, ground, interval);
            let mut acceleration = (self.velocity(i) - self.base[i].velocity) * (S::ONE / interval);
            if i < self.drifts.len() {
                acceleration -= self.convected(i, mesh, S::ONE / interval);
            }
            // The water's part of the inertia is outside of the line.
            let of_water = water - self.base[i].added * acceleration;
            booked.dissipated += of_drag + of_ground;
            booked.outside += of_water.dot(self.way(i)) + of_drag;
        }
        let motion = |i: usize| [self.next[i], self.velocity(i)];
        let change = self.energy_of(mesh, ground, gravity, motion, &self.directions) - self.energy;
        booked.on_ends = booked.outside - booked.dissipated - change;
        booked
    }

    /// Returns the position of a node at the last point, world, m.
    pub fn position(&self, node: usize) -> Vector3<S> {
        self.next[node]
    }

    /// Whether the line was advanced since the base of the step.
    pub fn has_advanced(&self) -> bool {
        self.clock[2] > 0.0
    }

    /// Returns the velocity of a node by the midpoint rule at the last point, world, m/s.
    pub fn velocity(&self, node: usize) -> Vector3<S> {
        self.way(node) * S::constant(2.0 / self.clock[2]) - self.base[node].velocity
    }
}
