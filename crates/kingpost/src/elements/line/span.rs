//! A line over an interval of a step: its way, the mean forces on its nodes, and their derivatives.
//!
//! The mean forces of tension, bending and ground have discrete gradients: their work is the change of their energy (Simo &
//! Tarnow, *ZAMP* 43, 1992; Gonzalez, *J. Nonlinear Sci.* 6, 1996).

use super::blocks::Blocks;
use super::feed::{convected, write_drifts};
use super::ground::LineGround;
use super::mesh::{LineMesh, LineMeshElement};
use super::nodes::{Nodes, tangents};
use super::one_sided::share_at_end;
use super::section::WetPart;
use super::strain::{gauss, slopes, sum};
use crate::elements::Context;
use crate::elements::lines::length_and_direction;
use crate::scalar::Scalar;
use crate::spatial::{Matrix3, Vector3};

/// Smallest stretch ratio for which a direction is computed: a line is slack there.
const LEAST_RATIO: f64 = 1e-9;

/// A node at the base of the step, with what does not change over it.
#[derive(Clone, Debug)]
pub struct BaseNode<S> {
    pub position: Vector3<S>,
    pub velocity: Vector3<S>,
    /// Unstretched length of the line that belongs to it, m.
    length: S,
    /// Mass with the added mass, kg.
    mass: Matrix3<S>,
    /// Added mass, kg.
    pub added: Matrix3<S>,
    /// Weight in air, N.
    weight: S,
    pub wet: WetPart<S>,
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

/// The mean tension of an interval at a point of Gauss's rule.
struct MeanPull<S> {
    direction: Vector3<S>,
    /// Elastic part and whole, N.
    tension: [S; 2],
    /// Derivative of the whole along the strain at the end of the interval, over EA.
    rise: S,
    /// Derivative of the force along the derivative of the position, N.
    stiffness: Matrix3<S>,
}

/// The mean loads on a node over an interval.
pub struct NodeLoads<S> {
    pub force: Vector3<S>,
    /// Derivative of the force along the position at the end, with the sign changed, N/m.
    slope: Matrix3<S>,
    /// Derivative of the support of the ground along the depth at the end of the interval, over its stiffness, and share to which
    /// it holds the node by friction.
    rise: S,
    /// Force of the water, N.
    pub water: Vector3<S>,
    /// Heat of drag and of the ground, J.
    pub heat: [S; 2],
}

/// A line from the base of a step to the last point to which it was advanced.
#[derive(Clone, Debug)]
pub struct LineSpan<S> {
    pub base: Vec<BaseNode<S>>,
    /// Derivatives of position and velocity along the line at the base, at the points of Gauss's rule.
    stretched: Vec<BaseStretch<S>>,
    /// Curvatures at the bends of the mesh at the base.
    curved: Vec<Vector3<S>>,
    /// Positions at the last point.
    pub next: Vec<Vector3<S>>,
    /// Directions of the ends at the last point.
    pub directions: [Vector3<S>; 2],
    tangents: Vec<Vector3<S>>,
    /// Start and middle of the step, and time to the last point, s.
    pub clock: [f64; 3],
    /// Drifts of the nodes in the middle of the step, if the line is paid out.
    pub drifts: Vec<Vector3<S>>,
    /// Length of the first part at the base, and what is paid out from there to the last point, m.
    pub paid: [S; 2],
    /// Derivatives of tensions and supports that jump where the line becomes slack or leaves the ground, in the last equations.
    pub rises: Vec<S>,
}

impl<S: Scalar> LineSpan<S> {
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
            clock: [0.0; 3],
            drifts: vec![zero; 2 * mesh.supplied],
            paid: [S::ZERO; 2],
            rises: vec![S::ZERO; 2 * count - 1],
        }
    }

    /// Reads the motion of the nodes at the base of a step, and predicts their positions in its middle.
    pub fn begin(&mut self, nodes: &Nodes<S>, mesh: &LineMesh<S>, clock: [f64; 2]) {
        let half = S::constant(clock[1] - clock[0]);
        (self.clock, self.paid) = ([clock[0], clock[1], 0.0], [mesh.first(), S::ZERO]);
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
    }

    /// Computes the drifts in the middle of the step.
    pub fn drift(&mut self, mesh: &LineMesh<S>) {
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
    pub fn load_base(&mut self, mesh: &LineMesh<S>, at: &Context<'_, S>) {
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

    /// Sets the first guess: with the velocities at the base, and with the mean acceleration to the last point of this step.
    pub fn predict(&mut self, interval_s: f64) {
        let before_s = self.clock[2];
        let (interval, before) = (S::constant(interval_s), S::constant(before_s));
        let square = S::constant(if before_s > 0.0 { (interval_s / before_s) * (interval_s / before_s) } else { 0.0 });
        for (base, next) in self.base.iter().zip(&mut self.next) {
            let bent = *next - base.position - base.velocity * before;
            *next = base.position + base.velocity * interval + bent * square;
        }
        self.clock[2] = interval_s;
    }

    /// Moves the ends to these places; returns their moves.
    pub fn move_ends(&mut self, [first, last]: [Vector3<S>; 2], moving_end: usize) -> [Vector3<S>; 2] {
        let moved = [first - self.next[0], self.next.get(moving_end).map_or(Vector3::zero(), |node| last - *node)];
        self.next[0] = first;
        self.next[moving_end..].fill(last);
        moved
    }

    /// Returns the number of points of Gauss's rule.
    pub fn points(&self) -> usize {
        self.stretched.len()
    }

    /// Returns the energy of strain, and that of the nodes between the ends, with these positions and velocities, J.
    pub fn energy_of(
        &self,
        mesh: &LineMesh<S>,
        ground: Option<&LineGround<S>>,
        gravity: S,
        motion: impl Fn(usize) -> [Vector3<S>; 2],
        directions: &[Vector3<S>; 2],
    ) -> S {
        let half = S::constant(0.5);
        let mut energy = S::ZERO;
        for k in 0..self.points() {
            let slopes = slopes(gauss(k), mesh.elements[k / 2].length);
            let way = sum(&slopes, &[0, 1, 2].map(|i| motion(k / 2 * 2 + i)[0]));
            let LineMeshElement { length, section } = &mesh.elements[k / 2];
            energy += section.strain_energy(way.norm()) * *length * half;
        }
        for bend in &mesh.bends {
            energy += bend.energy(bend.curvature(|node| motion(node)[0], directions));
        }
        for i in mesh.moving() {
            let ([position, velocity], part) = (motion(i), &mesh.nodes[i]);
            energy += part.dry_mass() * (gravity * position[2] + velocity.norm_squared() * half);
            if let Some(ground) = ground {
                energy += ground.held_per_length(position)[1] * part.length;
            }
        }
        energy
    }

    /// Returns the way of the material at a node, m: without the motion of the node along the line.
    pub fn way(&self, node: usize) -> Vector3<S> {
        let way = self.next[node] - self.base[node].position;
        self.drifts.get(node).map_or(way, |drift| way - *drift * self.paid[1])
    }

    /// Returns the velocity of a node by the midpoint rule at the last point, world, m/s.
    pub fn velocity(&self, node: usize) -> Vector3<S> {
        self.way(node) * S::constant(2.0 / self.clock[2]) - self.base[node].velocity
    }

    /// Returns the mean of `xi (dv/ds) L'` at a node of the first part, m/s^2.
    pub fn convected(&self, node: usize, mesh: &LineMesh<S>, per_s: S) -> Vector3<S> {
        convected(mesh, node, |node| self.way(node)) * (per_s * per_s * self.paid[1])
    }

    /// Returns the slopes of the shape functions at a point of Gauss's rule, and the derivative of the position there.
    fn stretched_to(&self, k: usize, mesh: &LineMesh<S>) -> ([S; 3], Vector3<S>) {
        let slopes = slopes(gauss(k), mesh.elements[k / 2].length);
        (slopes, sum(&slopes, &[0, 1, 2].map(|i| self.next[k / 2 * 2 + i])))
    }

    /// Returns the mean tension at a point of Gauss's rule.
    #[inline(always)]
    fn pull(&self, k: usize, mesh: &LineMesh<S>, interval: S) -> MeanPull<S> {
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
        let stiff = section.axial_stiffness;
        let (across, per_rate) = (tension[1] * per_sum, stiff * per_rate);
        let turns = (at_end - tangent * stretches) * (per_rate * share / least(ratio));
        let along = tangent * (stiff * rise + per_rate * (S::ONE + share) * per_s - across) + turns;
        let mut stiffness = Matrix3::outer(direction, along);
        (0..3).for_each(|i| stiffness.0[i][i] += across);
        MeanPull { direction, tension, rise, stiffness }
    }

    /// Returns the tension at a point of Gauss's rule with which the line pulls at its ends at the base of the interval, or at the
    /// last point, N: the mean tension, and as much of the elastic change from its mean as damping has of the rate at the end.
    pub fn tension_at(&self, is_base: bool, k: usize, mesh: &LineMesh<S>) -> S {
        let (interval, section) = (S::constant(self.clock[2]), &mesh.elements[k / 2].section);
        let [elastic, whole] = self.pull(k, mesh, interval).tension;
        let ratio = if is_base { self.stretched[k].ratio } else { self.stretched_to(k, mesh).1.norm() };
        let there = section.possible(section.axial_stiffness * (ratio - S::ONE));
        section.possible(whole + (there - elastic) * share_at_end(interval, section.damping_time))
    }

    /// Returns the mean loads on a node between the ends.
    #[inline(always)]
    pub fn loads(&self, node: usize, ground: Option<&LineGround<S>>, interval: S) -> NodeLoads<S> {
        let (base, way) = (&self.base[node], self.way(node));
        let per_s = S::ONE / interval;
        let later = S::constant(self.clock[0] - self.clock[1]) + interval * S::constant(0.5);
        let drag = base.wet.drag(way * per_s, later);
        let water = base.wet.steady + drag.force;
        let mut loads = NodeLoads {
            force: water - Vector3::new(S::ZERO, S::ZERO, base.weight),
            slope: drag.slope.scaled(per_s),
            rise: S::ZERO,
            water,
            heat: [drag.force.dot(drag.relative) * interval, S::ZERO],
        };
        if let Some(ground) = ground {
            let from = (base.position, base.velocity);
            let support = ground.mean_support(base.length, from, (self.next[node], way), interval);
            loads.force += support.force;
            loads.slope += support.slope;
            (loads.rise, loads.heat[1]) = (support.rise, support.heat);
        }
        loads
    }

    /// Writes the equations of Newton's method; without `MATRIX`, their right side only.
    pub fn equations<const MATRIX: bool>(
        &mut self,
        blocks: &mut Blocks<S>,
        mesh: &LineMesh<S>,
        ground: Option<&LineGround<S>>,
    ) {
        let (interval, half) = (S::constant(self.clock[2]), S::constant(0.5));
        blocks.clear::<MATRIX>();
        for k in 0..self.stretched.len() {
            let length = mesh.elements[k / 2].length * half;
            let (slopes, _) = self.stretched_to(k, mesh);
            let MeanPull { direction, tension: [_, whole], rise, stiffness } = self.pull(k, mesh, interval);
            self.rises[k] = rise;
            blocks.add_at::<MATRIX>(k / 2 * 2, &slopes, &stiffness.scaled(length), -(direction * (whole * length)));
        }
        for (bend, before) in mesh.bends.iter().zip(&self.curved) {
            let after = bend.curvature(|node| self.next[node], &self.directions);
            let stiffness = bend.stiffness * half;
            let along = Matrix3::identity().scaled(stiffness);
            blocks.add_at::<MATRIX>(bend.first, &bend.weights, &along, -((*before + after) * stiffness));
        }
        let (per_s, two) = (S::ONE / interval, S::constant(2.0));
        for i in mesh.moving() {
            let NodeLoads { force, slope, rise, .. } = self.loads(i, ground, interval);
            self.rises[self.stretched.len() + i] = rise;
            let inertia = self.base[i].mass.scaled(two * per_s * per_s);
            let mut balance = force - inertia * (self.way(i) - self.base[i].velocity * interval);
            if i < self.drifts.len() {
                balance += self.base[i].mass * self.convected(i, mesh, per_s);
            }
            blocks.add::<MATRIX>(i, inertia + slope, balance);
        }
    }

    /// Returns the momentum that a node gained since the base, N s.
    pub fn gained(&self, node: usize, mesh: &LineMesh<S>) -> Vector3<S> {
        let part = &mesh.nodes[node];
        let grown = mesh.mass_per_length() * S::constant(part.growth) * self.paid[1];
        let before = self.base[node].velocity;
        (self.velocity(node) - before) * part.dry_mass() + before * grown
    }

    /// Returns the mean force of tension and bending on the first end (0) or the second one (1) over the interval to the last
    /// point, world, N.
    pub fn pull_on_end(&self, end: usize, mesh: &LineMesh<S>) -> Vector3<S> {
        let (half, local) = (S::constant(0.5), 2 * end);
        let first = [0, self.next.len() - 3][end];
        let mut force = Vector3::zero();
        for k in [first, first + 1] {
            let MeanPull { direction, tension: [_, whole], .. } = self.pull(k, mesh, S::constant(self.clock[2]));
            let (slopes, _) = self.stretched_to(k, mesh);
            force -= direction * (whole * slopes[local] * mesh.elements[k / 2].length * half);
        }
        for (bend, before) in mesh.bends.iter().zip(&self.curved).filter(|(bend, _)| bend.first == first) {
            let after = bend.curvature(|node| self.next[node], &self.directions);
            force -= (*before + after) * (bend.stiffness * half * bend.weights[local]);
        }
        force
    }

    /// Returns the heat of damping at a point of Gauss's rule over the interval, J.
    pub fn heat_of_damping(&self, k: usize, mesh: &LineMesh<S>) -> S {
        let BaseStretch { ratio, drift, .. } = self.stretched[k];
        let (_, after) = self.stretched_to(k, mesh);
        let MeanPull { direction, tension: [elastic, whole], .. } = self.pull(k, mesh, S::constant(self.clock[2]));
        let lengthens = after.norm() - ratio - direction.dot(drift * self.paid[1]);
        (whole - elastic) * lengthens * mesh.elements[k / 2].length * S::constant(0.5)
    }
}
