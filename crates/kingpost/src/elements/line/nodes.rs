//! The nodes of a line: their motion, the forces on them, and their energy.

use super::bend::Bend;
use super::feed::LineFeed;
use super::ground::LineGround;
use super::mesh::{LineMesh, LineMeshElement, SecondEnd};
use super::section::{PartMass, WetPart};
use super::strain::{BEYOND_GAUSS, GAUSS, Strained, shapes, slopes, strained, sum};
use crate::elements::Context;
use crate::elements::lines::length_and_direction;
use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// A node.
#[derive(Clone, Copy, Debug)]
pub struct LineNode<S> {
    /// Position, world, m.
    pub position: Vector3<S>,
    /// Velocity, world, m/s.
    pub velocity: Vector3<S>,
    /// Unit tangent.
    pub tangent: Vector3<S>,
    /// Mass with the added mass of the water.
    pub mass: PartMass<S>,
    /// Force of the line, its weight, the water and the ground, world, N.
    pub force: Vector3<S>,
    /// Acceleration, if it is between the ends, m/s^2.
    pub acceleration: Vector3<S>,
}

/// The nodes of a line, from its first end: every second one is in the middle of an element.
#[derive(Clone, Debug)]
pub struct Nodes<S> {
    pub(super) nodes: Vec<LineNode<S>>,
    /// The line at the points of Gauss's rule.
    pub(super) points: Vec<Strained<S>>,
    /// Its motion along itself, as it is paid out.
    pub(super) feed: LineFeed<S>,
    /// Working memory: positions and tangents.
    scratch: [Vec<Vector3<S>>; 2],
    /// Power that becomes heat, W.
    pub dissipated: S,
    /// Power of the water on the line, W; without the heat.
    pub outside: S,
    /// Directions of the ends, world; those of clamped ends have an effect.
    pub directions: [Vector3<S>; 2],
    /// Moments of clamped ends on their bodies, world, N m.
    pub moments: [Vector3<S>; 2],
    /// Energy of strain and bending, J.
    strain: S,
}

impl<S: Scalar> Nodes<S> {
    /// Allocates the memory for the nodes of a mesh.
    pub fn new(mesh: &LineMesh<S>) -> Self {
        let count = mesh.nodes.len();
        let zero = Vector3::zero();
        let mass = PartMass { across: S::ZERO, along: S::ZERO };
        let node = LineNode { position: zero, velocity: zero, tangent: zero, mass, force: zero, acceleration: zero };
        Self {
            nodes: vec![node; count],
            points: Vec::with_capacity(count - 1),
            feed: LineFeed::new(mesh),
            scratch: [Vec::with_capacity(count), vec![zero; count]],
            dissipated: S::ZERO,
            outside: S::ZERO,
            directions: [zero; 2],
            moments: [zero; 2],
            strain: S::ZERO,
        }
    }

    /// Returns the number of nodes.
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Returns a node.
    pub fn node(&self, node: usize) -> &LineNode<S> {
        &self.nodes[node]
    }

    /// Returns what the line draws from its supply.
    pub fn feed(&self) -> &LineFeed<S> {
        &self.feed
    }

    /// Returns the tension at a point of Gauss's rule, N.
    pub fn tension(&self, point: usize) -> S {
        self.points[point].tension[1]
    }

    /// Sets the motion of a node.
    pub fn put(&mut self, node: usize, position: Vector3<S>, velocity: Vector3<S>) {
        let put = &mut self.nodes[node];
        (put.position, put.velocity, put.force) = (position, velocity, Vector3::zero());
    }

    fn of_element<T>(&self, element: usize, part: impl Fn(&LineNode<S>) -> T) -> [T; 3] {
        [0, 1, 2].map(|k| part(&self.nodes[2 * element + k]))
    }

    /// Adds the forces of the tension, `-T t N_i' h / 2` at each point of Gauss's rule. The rate of strain has these velocities
    /// in addition at the ends.
    pub fn stretch(&mut self, mesh: &LineMesh<S>, by_rule: [Vector3<S>; 2]) {
        let last = self.nodes.len() - 1;
        let velocities = [0, last].map(|end| self.nodes[end].velocity);
        self.nodes[0].velocity += by_rule[0];
        self.nodes[last].velocity += by_rule[1];
        self.points.clear();
        (self.dissipated, self.strain) = (S::ZERO, S::ZERO);
        for element in 0..self.nodes.len() / 2 {
            self.stretch_element(element, mesh, |_, whole| whole);
        }
        (self.nodes[0].velocity, self.nodes[last].velocity) = (velocities[0], velocities[1]);
        self.bend(mesh.bends.iter());
        let [positions, found] = &mut self.scratch;
        positions.clear();
        positions.extend(self.nodes.iter().map(|node| node.position));
        tangents(positions, found);
        self.nodes.iter_mut().zip(found).for_each(|(node, tangent)| node.tangent = *tangent);
    }

    /// Adds the forces of the tension in an element: at each point this function of its index and its tension.
    fn stretch_element(&mut self, element: usize, mesh: &LineMesh<S>, pull: impl Fn(usize, S) -> S) {
        let LineMeshElement { length, section } = &mesh.elements[element];
        let half = *length * S::constant(0.5);
        let positions = self.of_element(element, |node| node.position);
        let velocities = self.of_element(element, |node| node.velocity);
        for (xi, point) in [-GAUSS, GAUSS].into_iter().zip(2 * element..) {
            let slopes = slopes(xi, *length);
            let found = strained(section, &slopes, &positions, &velocities);
            let ([elastic, whole], [ratio, rate]) = (found.tension, found.ratio);
            let pull = pull(point, whole);
            for (node, slope) in self.nodes[2 * element..].iter_mut().zip(slopes) {
                node.force -= found.tangent * (pull * slope * half);
            }
            self.dissipated += (whole - elastic) * rate * half;
            self.strain += elastic * (ratio - S::ONE) * half * S::constant(0.5);
            self.points.push(found);
        }
    }

    /// Adds the forces of bends, `-EI x'' w_k`, and computes the moments of clamped ends.
    fn bend<'a>(&mut self, bends: impl Iterator<Item = &'a Bend<S>>) {
        self.moments = [Vector3::zero(); 2];
        for bend in bends {
            let curvature = bend.curvature(|node| self.nodes[node].position, &self.directions);
            for (node, weight) in self.nodes[bend.first..].iter_mut().zip(bend.weights) {
                node.force -= curvature * (bend.stiffness * weight);
            }
            self.strain += bend.energy(curvature);
            if let Some((end, moment)) = bend.moment(curvature, &self.directions) {
                self.moments[end] = moment;
            }
        }
    }

    /// Adds the forces of the tension at the ends alone, in the first and the last element; in all elements if the line is paid
    /// out. The forces are those of this tension at a point; what is drawn from the supply has the rate of strain of these
    /// velocities of the ends.
    pub fn stretch_ends(&mut self, mesh: &LineMesh<S>, pull: impl Fn(usize) -> S, by_rule: [Vector3<S>; 2]) {
        self.points.clear();
        let last = self.nodes.len() - 1;
        let velocities = [0, last].map(|end| self.nodes[end].velocity);
        for (end, velocity) in [0, last].into_iter().zip(by_rule) {
            self.nodes[end].velocity = velocity;
        }
        let all = mesh.supplied > 0;
        for element in (0..last / 2).filter(|element| all || *element == 0 || *element == last / 2 - 1) {
            self.stretch_element(element, mesh, |point, _| pull(point));
        }
        self.bend(mesh.bends.iter().filter(|bend| bend.first == 0 || bend.first + 2 == last));
        (self.nodes[0].velocity, self.nodes[last].velocity) = (velocities[0], velocities[1]);
        (self.dissipated, self.outside) = (S::ZERO, S::ZERO);
    }

    /// Adds these forces to those so far on the ends; returns the sums.
    pub fn pull_ends(&mut self, forces: [Vector3<S>; 2]) -> [Vector3<S>; 2] {
        let last = self.nodes.len() - 1;
        [(0, forces[0]), (last, forces[1])].map(|(end, force)| {
            self.nodes[end].force += force;
            self.nodes[end].force
        })
    }

    /// Returns the power of the forces so far, and of the moments, on the ends, W, whose bodies move there with these velocities
    /// and angular velocities.
    pub fn power_on_ends(&self, velocities: [Vector3<S>; 2], angular: [Vector3<S>; 2]) -> S {
        let [first, last] = [0, self.nodes.len() - 1].map(|end| self.nodes[end].force);
        let by_forces = first.dot(velocities[0]) + last.dot(velocities[1]);
        by_forces + self.moments[0].dot(angular[0]) + self.moments[1].dot(angular[1])
    }

    /// Adds weight, and the forces of water and ground, to an end in this water, whose motion is that of this time earlier (s).
    pub fn load_end(
        &mut self,
        end: usize,
        mesh: &LineMesh<S>,
        ground: Option<&LineGround<S>>,
        (wet, later_s): (&WetPart<S>, f64),
        at: &Context<'_, S>,
    ) {
        self.nodes[end].tangent = wet.tangent();
        let (support, heat, _) = self.on_ground(end, mesh, ground);
        self.put_loads(end, mesh.nodes[end].dry_mass(), wet, S::constant(later_s), (support, heat), at);
    }

    /// Adds weight, water and ground to a node, whose mass without water is given, kg.
    fn put_loads(
        &mut self,
        i: usize,
        dry: S,
        wet: &WetPart<S>,
        later_s: S,
        (support, heat): (Vector3<S>, S),
        at: &Context<'_, S>,
    ) {
        let node = &mut self.nodes[i];
        let drag = wet.drag(node.velocity, later_s);
        let (water, dissipated) = (wet.steady + drag.force, drag.force.dot(drag.relative));
        node.mass = PartMass { across: dry + wet.added.across, along: dry + wet.added.along };
        node.force += water + support;
        node.force[2] -= dry * at.world.gravity;
        self.dissipated += dissipated + heat;
        self.outside += water.dot(node.velocity) + dissipated;
    }

    /// Adds weight, and the forces of water and ground; computes the accelerations between the ends.
    pub fn load(&mut self, mesh: &LineMesh<S>, ground: Option<&LineGround<S>>, at: &Context<'_, S>) {
        self.outside = S::ZERO;
        let last = self.nodes.len() - 1;
        for i in 0..=last {
            let LineNode { position, velocity, tangent, .. } = self.nodes[i];
            let part = &mesh.nodes[i];
            let wet = part.in_water(at, position, tangent);
            let (support, heat, _) = self.on_ground(i, mesh, ground);
            self.put_loads(i, part.dry_mass(), &wet, S::ZERO, (support, heat), at);
            if !mesh.moving().contains(&i) || mesh.is_joint(i) {
                continue;
            }
            let node = &mut self.nodes[i];
            let along = tangent * tangent.dot(node.force);
            node.acceleration = (node.force - along) * (S::ONE / node.mass.across) + along * (S::ONE / node.mass.along);
            self.outside -= of_water(node, &wet.added).dot(velocity);
        }
    }

    /// Sets the acceleration of a node at which lines meet, m/s^2.
    pub fn accelerate(&mut self, i: usize, mesh: &LineMesh<S>, acceleration: Vector3<S>) {
        let (node, dry) = (&mut self.nodes[i], mesh.nodes[i].dry_mass());
        node.acceleration = acceleration;
        let added = PartMass { across: node.mass.across - dry, along: node.mass.along - dry };
        self.outside -= of_water(node, &added).dot(node.velocity);
    }

    /// Returns force, heat and energy of the ground at a node.
    fn on_ground(&self, node: usize, mesh: &LineMesh<S>, ground: Option<&LineGround<S>>) -> (Vector3<S>, S, S) {
        let Some(ground) = ground else { return (Vector3::zero(), S::ZERO, S::ZERO) };
        let LineNode { position, velocity, .. } = self.nodes[node];
        ground.support(mesh.nodes[node].length, position, velocity)
    }

    /// Returns the energy of strain, weight and ground, and the kinetic energy between the ends, J.
    pub fn energy(&self, mesh: &LineMesh<S>, ground: Option<&LineGround<S>>, at: &Context<'_, S>) -> S {
        let last = self.nodes.len() - 1;
        (0..=last).fold(self.strain, |sum, i| {
            let (node, mass) = (&self.nodes[i], mesh.nodes[i].dry_mass());
            let moves =
                if mesh.moving().contains(&i) { node.velocity.norm_squared() * S::constant(0.5) } else { S::ZERO };
            sum + mass * (at.world.gravity * node.position[2] + moves) + self.on_ground(i, mesh, ground).2
        })
    }

    /// Returns the tensions at the ends, N: the reactions of the bodies, with the accelerations of the ends extrapolated from
    /// the nodes beside them; that of the last element where other lines are fastened; zero at a free end.
    pub fn end_tensions(&self, mesh: &LineMesh<S>) -> [S; 2] {
        let last = self.nodes.len() - 1;
        let at_end = |end: usize, [near, far]: [usize; 2], outward: f64| {
            let LineNode { tangent, mass, force, .. } = self.nodes[end];
            let [near, far] = [near, far].map(|node| self.nodes[node].acceleration);
            let inertia = mass.along * tangent.dot(near + near - far);
            mesh.nodes[end].section.possible((inertia - tangent.dot(force)) * S::constant(outward))
        };
        // A line of one element has one node between its ends.
        let of_first = at_end(0, [1, 2.min(last - 1)], -1.0);
        let of_second = match mesh.second {
            SecondEnd::Held => at_end(last, [last - 1, (last - 2).max(1)], 1.0),
            _ if mesh.hangs_free() => S::ZERO,
            _ => self.at_last_joint(mesh),
        };
        [of_first, of_second]
    }

    /// Returns the tension of the last element at its end, N, extrapolated from the points of Gauss's rule.
    fn at_last_joint(&self, mesh: &LineMesh<S>) -> S {
        let element = mesh.elements.len() - 1;
        let [second, last] = [0, 1].map(|k| self.tension(2 * element + k));
        mesh.elements[element].section.possible(last + (last - second) * S::constant(BEYOND_GAUSS))
    }

    /// Returns the largest strain by the elastic tension; NaN if a tension is NaN.
    pub fn largest_strain(&self, mesh: &LineMesh<S>) -> S {
        let strains = self
            .points
            .iter()
            .enumerate()
            .map(|(k, point)| point.tension[1] / mesh.elements[k / 2].section.axial_stiffness);
        strains.fold(S::ZERO, |most, strain| strain.select_less(most, || most, || strain))
    }

    /// Returns the unstretched length of the line that lies on the ground, m.
    pub fn grounded_length(&self, mesh: &LineMesh<S>, ground: Option<&LineGround<S>>) -> S {
        let Some(ground) = ground else { return S::ZERO };
        (0..self.nodes.len()).fold(S::ZERO, |sum, i| {
            let above = -ground.under(self.nodes[i].position);
            sum + above.select_below(0.0, || mesh.nodes[i].length, || S::ZERO)
        })
    }

    /// Returns the position at this share of the length, world, m.
    pub fn at(&self, share: f64, mesh: &LineMesh<S>) -> Vector3<S> {
        let (mut from, mut element) = (0.0, 0);
        let place = share * mesh.length.value();
        while element + 1 < mesh.elements.len() && from + mesh.elements[element].length.value() < place {
            from += mesh.elements[element].length.value();
            element += 1;
        }
        let xi = 2.0 * (place - from) / mesh.elements[element].length.value() - 1.0;
        sum(&shapes(xi), &self.of_element(element, |node| node.position))
    }
}

/// Returns the inertial force of the added mass at a node, N: the water's part of the inertia is outside of the line.
fn of_water<S: Scalar>(LineNode { acceleration, tangent, .. }: &LineNode<S>, added: &PartMass<S>) -> Vector3<S> {
    *acceleration * added.across + *tangent * ((added.along - added.across) * tangent.dot(*acceleration))
}

/// Writes the unit tangents at nodes: between the neighbours of a node, at the ends by the shape of the element.
pub fn tangents<S: Scalar>(positions: &[Vector3<S>], out: &mut [Vector3<S>]) {
    let last = positions.len() - 1;
    let slope_at = |first: usize, xi: f64| sum(&slopes(xi, S::ONE), &[0, 1, 2].map(|k| positions[first + k]));
    for (node, tangent) in out.iter_mut().enumerate() {
        let way = match node {
            0 => slope_at(0, -1.0),
            _ if node == last => slope_at(last - 2, 1.0),
            _ => positions[node + 1] - positions[node - 1],
        };
        *tangent = length_and_direction(way).1;
    }
}
