//! The shape of a line at rest, between given ends.

use super::bend::LineEnds;
use super::blocks::Blocks;
use super::descent::Descent;
use super::ground::LineGround;
use super::mesh::{LineMesh, LineMeshElement};
use super::nodes::tangents;
use super::one_sided::positive;
use super::section::WetPart;
use super::strain::{gauss, slopes, strained};
use crate::elements::Context;
use crate::elements::lines::{Catenary, Span, length_and_direction};
use crate::scalar::Scalar;
use crate::spatial::{Matrix3, Vector3};
use crate::world::CurrentAt;
use core::f64::consts::FRAC_PI_4;

/// Last move of a node, as a share of the length of the line, at which Newton's method has converged: its square is below
/// rounding.
const CONVERGED: f64 = 1e-9;
/// Largest number of iterations; 5 to 10 are usual.
const MOST_ITERATIONS: usize = 500;
/// Shares of the stiffness of the ground with which the search goes on where it finds no rest on a stiff one: nodes that come
/// and go on a soft ground change the forces little.
const SOFTER: [f64; 5] = [1e-4, 1e-3, 1e-2, 0.1, 1.0];
/// Longest move of a node in an iteration, as a share of the length of an element.
const LONGEST_MOVE: f64 = 0.5;
/// Stiffness that holds a node where it is, over its weight per length of the line: a line that lies slack on the ground has
/// no other along the ground. It slows the convergence of the softest motions by about this share.
const HOLD: f64 = 1e-4;
/// Strain below which a point of a line with a free end is slack: rounding. The weight of its element over the length of the line
/// holds its nodes, so that rounding does not move a part that lies slack, as far as the free end.
const SLACK: f64 = 1e-12;
/// Share of EA that holds the nodes of a line without weight.
const LIGHT: f64 = 1e-12;
/// Horizontal distance between the ends of the catenary, as a share of the length, at least.
const NEAREST: f64 = 1e-6;
/// Iterations after convergence that complete the derivatives: each adds four digits, by [`HOLD`].
const FOR_DERIVATIVES: usize = 3;

/// The nodes of a line at rest, from its last solution on.
#[derive(Clone, Debug)]
pub struct LineStatics<S> {
    positions: Vec<Vector3<S>>,
    tangents: Vec<Vector3<S>>,
    blocks: Blocks<S>,
    descent: Descent<S>,
    /// Whether there is a solution.
    found: bool,
}

impl<S: Scalar> LineStatics<S> {
    /// Allocates the memory for the nodes of a mesh.
    pub fn new(mesh: &LineMesh<S>) -> Self {
        let count = mesh.nodes.len();
        let zero = vec![Vector3::zero(); count];
        let (blocks, descent) = (Blocks::new(count, mesh.moving(), !mesh.bends.is_empty()), Descent::new(count));
        Self { positions: zero.clone(), tangents: zero, blocks, descent, found: false }
    }

    /// Returns the positions of the nodes at rest, between ends at these positions, by Newton's method; it starts from the
    /// last solution, or from the catenary.
    pub fn solve(
        &mut self,
        mesh: &LineMesh<S>,
        ground: Option<&LineGround<S>>,
        LineEnds { places, directions }: &LineEnds<S>,
        at: &Context<'_, S>,
    ) -> &[Vector3<S>] {
        if !self.found {
            match mesh.free_end {
                true => drop(mesh, ground, places[0], at, &mut self.positions),
                false => lay(mesh, ground, *places, at, &mut self.positions),
            }
        }
        self.positions.iter_mut().for_each(|place| *place = Vector3(place.0.map(S::plain)));
        self.positions[0] = places[0];
        self.positions[mesh.moving().end..].fill(places[1]);
        self.descent.begin();
        self.found = self.search(mesh, ground, directions, at);
        let open = self.descent.open();
        for softness in SOFTER {
            if self.found {
                break;
            }
            let soft = ground.map(|ground| ground.softened(S::constant(softness)));
            self.descent.begin_again(open);
            self.found = self.search(mesh, soft.as_ref(), directions, at) && softness == 1.0;
        }
        if !self.found {
            self.positions.fill(Vector3(core::array::from_fn(|_| S::constant(f64::NAN))));
        }
        &self.positions
    }

    /// Moves the nodes to rest by Newton's method, from where they are. Returns whether they have arrived.
    fn search(
        &mut self,
        mesh: &LineMesh<S>,
        ground: Option<&LineGround<S>>,
        directions: &[Vector3<S>; 2],
        at: &Context<'_, S>,
    ) -> bool {
        let (limit, longest) = (mesh.length * S::constant(CONVERGED), mesh.shortest() * S::constant(LONGEST_MOVE));
        let mut more = if S::HAS_DERIVATIVES { FOR_DERIVATIVES } else { 0 };
        for _ in 0..MOST_ITERATIONS {
            self.assemble(mesh, ground, directions, at);
            self.blocks.factor();
            let may_arrive = if more > 0 { S::ZERO } else { S::ONE };
            self.descent.improve(&mut self.blocks, &mut self.positions, [limit, longest], may_arrive);
            if self.descent.is_small(limit) {
                more = more.saturating_sub(1);
            }
            if self.descent.has_arrived() {
                return true;
            }
        }
        false
    }

    /// Adds tension and bending to the equations.
    fn assemble_line(&mut self, mesh: &LineMesh<S>, directions: &[Vector3<S>; 2], gravity: S) {
        let still = [Vector3::zero(); 3];
        for k in 0..self.positions.len() - 1 {
            let LineMeshElement { length, section } = &mesh.elements[k / 2];
            let half = *length * S::constant(0.5);
            let slopes = slopes(gauss(k), *length);
            let places = [0, 1, 2].map(|i| self.positions[k / 2 * 2 + i]);
            let found = strained(section, &slopes, &places, &still);
            let ([tension, _], [ratio, _], tangent) = (found.tension, found.ratio, found.tangent);
            let stiff = section.axial_stiffness;
            let least = if mesh.free_end { stiff * S::constant(SLACK) } else { S::constant(f64::MIN_POSITIVE) };
            let rise = section.rise(tension.select_less(least, || S::ZERO, || stiff));
            let along = Matrix3::outer(tangent, tangent);
            let across = tension.select_below(f64::MIN_POSITIVE, || S::ZERO, || tension / ratio);
            let stiffness = along.scaled(rise) + (Matrix3::identity() - along).scaled(across);
            let weight = section.mass_per_length * *length * gravity;
            let held = rise.select_below(f64::MIN_POSITIVE, || weight / mesh.length, || S::ZERO);
            for node in (k / 2 * 2..k / 2 * 2 + 3).filter(|_| mesh.free_end) {
                self.blocks.add::<true>(node, Matrix3::identity().scaled(held), Vector3::zero());
            }
            self.blocks.add_at::<true>(k / 2 * 2, &slopes, &stiffness.scaled(half), -(tangent * (tension * half)));
        }
        for bend in &mesh.bends {
            let curvature = bend.curvature(|node| self.positions[node], directions);
            let stiffness = Matrix3::identity().scaled(bend.stiffness);
            self.blocks.add_at::<true>(bend.first, &bend.weights, &stiffness, -(curvature * bend.stiffness));
        }
    }

    /// Writes the equations of Newton's method.
    fn assemble(
        &mut self,
        mesh: &LineMesh<S>,
        ground: Option<&LineGround<S>>,
        directions: &[Vector3<S>; 2],
        at: &Context<'_, S>,
    ) {
        self.blocks.clear::<true>();
        tangents(&self.positions, &mut self.tangents);
        self.assemble_line(mesh, directions, at.world.gravity);
        for node in mesh.moving() {
            let (place, part) = (self.positions[node], &mesh.nodes[node]);
            let wet = part.in_water(at, place, self.tangents[node]);
            let weight = part.dry_mass() * at.world.gravity;
            let hold = (weight + part.section.axial_stiffness * S::constant(LIGHT)) / mesh.length * S::constant(HOLD);
            if let Some(next) = self.positions.get(node + 1) {
                self.blocks.turn(node, turning(&wet, *next - self.positions[node - 1]));
            }
            let mut force = wet.steady + wet.drag(Vector3::zero(), S::ZERO).force;
            force[2] -= weight;
            let mut stiffness = Matrix3::identity().scaled(hold);
            stiffness.0[2][2] += wet.stiffness;
            if let Some(ground) = ground {
                force += ground.support(part.length, place, Vector3::zero()).0;
                let stiff = ground.stiffness_per_length * part.length;
                let stiff = ground.under(place).select_below(0.0, || S::ZERO, || stiff);
                stiffness += Matrix3::outer(ground.normal, ground.normal).scaled(stiff);
            }
            self.blocks.add::<true>(node, stiffness, force);
        }
    }
}

/// Returns the derivative of the drag on a part of a line at rest along the way from the node before it to the next, with the
/// sign changed, N/m.
fn turning<S: Scalar>(wet: &WetPart<S>, way: Vector3<S>) -> Matrix3<S> {
    let (length, tangent) = length_and_direction(way);
    let per_length = S::ONE / length.select_below(f64::MIN_POSITIVE, || S::ONE, || length);
    let across = Matrix3::identity() - Matrix3::outer(tangent, tangent);
    (wet.turning_drag() * across).scaled(-per_length)
}

/// Writes a first shape of a line with a free end: straight down from its first end, or up if it floats, as far as the seabed or
/// the surface, and beyond down the slope of the seabed, or along the current, or along x.
fn drop<S: Scalar>(
    mesh: &LineMesh<S>,
    ground: Option<&LineGround<S>>,
    first: Vector3<S>,
    at: &Context<'_, S>,
    nodes: &mut [Vector3<S>],
) {
    let own = mean_catenary(&mesh.elements, mesh.length, false, at);
    let buoys = mesh.nodes.iter().filter_map(|node| node.clump);
    let carried =
        buoys.fold(S::ZERO, |sum, one| sum + (one.mass - one.volume * at.world.water_density) * at.world.gravity);
    let sinks = own.weight * mesh.length + carried;
    let size = |value: S| value.select_below(0.0, || -value, || value);
    let (weight, carried, half) = (size(own.weight), size(carried), S::constant(0.5));
    // The ground carries what lies on it.
    let below = ground.map_or(mesh.length, |ground| {
        positive(first[2] - ground.height_at(first)) + weight / ground.stiffness_per_length
    });
    let room = sinks.select_below(0.0, || positive(-first[2]), || below);
    let hangs = mesh.length.select_less(room, || mesh.length, || room);
    let end_load = mesh.length.select_less(room, || carried, || S::ZERO);
    let sign = sinks.select_below(0.0, || S::ONE, || -S::ONE);
    let along_current = at.world.current_at(&CurrentAt::Depth(positive(room - first[2])));
    let flows = along_current.norm_squared();
    let falls = ground.map_or(Vector3::zero(), LineGround::fall);
    let aside = if falls.norm_squared().all(|square| square > 0.0) {
        falls.direction()
    } else if flows.all(|square| square > 0.0) {
        along_current.direction()
    } else {
        Vector3::constant([1.0, 0.0, 0.0])
    };
    let mut along = S::ZERO;
    for (k, node) in nodes.iter_mut().enumerate() {
        let hanging = along.select_less(hangs, || along, || hangs);
        let stretch =
            (weight * (hangs * hanging - hanging * hanging * half) + end_load * hanging) / own.axial_stiffness;
        let down = (hanging + stretch).select_less(room, || hanging + stretch, || room);
        *node = first + aside * (along - hanging) + Vector3::new(S::ZERO, S::ZERO, sign * down);
        along += mesh.elements.get(k / 2).map_or(S::ZERO, |element| element.length * half);
    }
}

/// Writes a first shape of a line: catenaries between its ends and its buoys, each buoy as high as its parts of the line reach,
/// up to the surface.
fn lay<S: Scalar>(
    mesh: &LineMesh<S>,
    ground: Option<&LineGround<S>>,
    [first, last]: [Vector3<S>; 2],
    at: &Context<'_, S>,
    nodes: &mut [Vector3<S>],
) {
    let lift = |node: usize| {
        let net = mesh.nodes[node].clump.map_or(S::ZERO, |one| one.volume * at.world.water_density - one.mass);
        net * at.world.gravity
    };
    let (end, way, lower) = (nodes.len() - 1, last - first, |a: S, b: S| a.select_less(b, || a, || b));
    let across = (way[0] * way[0] + way[1] * way[1]).sqrt();
    let (mut along, mut from) = (S::ZERO, (0, first));
    for node in (2..=end).step_by(2) {
        let LineMeshElement { length, section } = mesh.elements[node / 2 - 1];
        along += length;
        let net = lift(node);
        if node < end && !net.all(|net| net > 0.0) {
            continue;
        }
        let share = along / mesh.length;
        let stretch = S::ONE + net / section.axial_stiffness;
        let reach = |length: S, span: S| {
            let square = length * length * stretch * stretch - span * span;
            square.select_below(0.0, || S::ZERO, || square).sqrt()
        };
        let by_last = last[2] + reach(mesh.length - along, across * (S::ONE - share));
        let height = lower(lower(first[2] + reach(along, across * share), by_last), S::ZERO);
        let buoy = Vector3([first[0] + way[0] * share, first[1] + way[1] * share, height]);
        let to = if node == end { last } else { buoy };
        hang(mesh, ground, (from, (node, to)), at, nodes);
        from = (node, to);
    }
}

/// Writes the nodes of a part of a line between two of them at these places: those of the elastic catenary with the mean
/// properties of the part; those of a straight line if it floats.
fn hang<S: Scalar>(
    mesh: &LineMesh<S>,
    ground: Option<&LineGround<S>>,
    ((before, first), (behind, last)): ((usize, Vector3<S>), (usize, Vector3<S>)),
    at: &Context<'_, S>,
    nodes: &mut [Vector3<S>],
) {
    let part = &mesh.elements[before / 2..behind / 2];
    let length = part.iter().fold(S::ZERO, |sum, element| sum + element.length);
    let is_up = (last[2] - first[2]).all(|up| up < 0.0);
    let [upper, lower] = if is_up { [first, last] } else { [last, first] };
    let way = upper - lower;
    let across = (way[0] * way[0] + way[1] * way[1]).sqrt();
    let least = length * S::constant(NEAREST);
    let span = Span { across: across.select_less(least, || least, || across), up: way[2] };
    let lies = ground.is_some_and(|ground| ground.under(lower).all(|under| under >= 0.0));
    let shape = mean_catenary(part, length, lies, at);
    let sinks = shape.weight.all(|weight| weight > 0.0);
    let force = shape.force(&span);
    let mut along = S::ZERO;
    for (k, node) in nodes[before..=behind].iter_mut().enumerate() {
        let share = along / length;
        if let Some(element) = part.get(k / 2) {
            along += element.length * S::constant(0.5);
        }
        if !sinks {
            *node = first + (last - first) * share;
            continue;
        }
        let place = shape.place(&force, &span, if is_up { S::ONE - share } else { share });
        let across = place.across / span.across;
        *node = lower + Vector3::new(way[0] * across, way[1] * across, place.up);
        if let Some(ground) = ground {
            let lowest = ground.height_at(*node);
            node[2] = node[2].select_less(lowest, || lowest, || node[2]);
        }
    }
}

/// Returns the catenary with the mean weight in water and the stiffness of a part of a line.
fn mean_catenary<S: Scalar>(
    part: &[LineMeshElement<S>],
    length: S,
    on_seabed: bool,
    at: &Context<'_, S>,
) -> Catenary<S> {
    let (mut weight, mut compliance) = (S::ZERO, S::ZERO);
    for LineMeshElement { length, section } in part {
        let displaced = at.world.water_density * section.diameter * section.diameter * S::constant(FRAC_PI_4);
        weight += (section.mass_per_length - displaced) * at.world.gravity * *length;
        compliance += *length / section.axial_stiffness;
    }
    let (unstretched_length, axial_stiffness) = (length, length / compliance);
    Catenary { unstretched_length, weight: weight / length, axial_stiffness, on_seabed }
}
