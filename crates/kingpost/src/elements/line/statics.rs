//! The shape of a tree of lines at rest, between given ends.

use super::bend::LineEnds;
use super::blocks::Blocks;
use super::descent::Descent;
use super::equations::LineEquations;
use super::first_shape::shape;
use super::ground::LineGround;
use super::mesh::{LineMesh, LineMeshElement};
use super::nodes::tangents;
use super::section::WetPart;
use super::strain::{gauss, slopes, strained};
use super::strand::{Strand, shortest};
use crate::elements::Context;
use crate::elements::lines::length_and_direction;
use crate::scalar::Scalar;
use crate::spatial::{Matrix3, Vector3};

/// Last move of a node, as a share of the length of the lines, at which Newton's method has converged: its square is below
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
/// Iterations after convergence that complete the derivatives: each adds four digits, by [`HOLD`].
const FOR_DERIVATIVES: usize = 3;

/// The nodes of lines at rest, from their last solution on.
#[derive(Clone, Debug)]
pub struct LineStatics<S> {
    positions: Vec<Vec<Vector3<S>>>,
    tangents: Vec<Vector3<S>>,
    equations: LineEquations<S>,
    descent: Descent<S>,
    /// Whether there is a solution.
    found: bool,
}

impl<S: Scalar> LineStatics<S> {
    /// Allocates the memory for the nodes of lines.
    pub fn new(strands: &[Strand<S>]) -> Self {
        let positions: Vec<_> = strands.iter().map(|strand| vec![Vector3::zero(); strand.mesh.nodes.len()]).collect();
        let count = positions.iter().map(Vec::len).sum();
        let (equations, descent) = (LineEquations::new(strands), Descent::new(count));
        Self { positions, tangents: Vec::new(), equations, descent, found: false }
    }

    /// Returns the positions of the nodes of each line at rest, between ends at these positions, by Newton's method; it starts
    /// from the last solution, or from catenaries.
    pub fn solve(&mut self, strands: &[Strand<S>], ends: &[LineEnds<S>], at: &Context<'_, S>) -> &[Vec<Vector3<S>>] {
        if !self.found {
            self.put_ends(strands, ends);
            shape(strands, at, &mut self.positions);
        }
        let places = self.positions.iter_mut().flatten();
        places.for_each(|place| *place = Vector3(place.0.map(S::plain)));
        self.put_ends(strands, ends);
        self.descent.begin();
        self.found = self.search(strands, ends, S::ONE, at);
        let open = self.descent.open();
        for softness in SOFTER {
            if self.found {
                break;
            }
            self.descent.begin_again(open);
            self.found = self.search(strands, ends, S::constant(softness), at) && softness == 1.0;
        }
        if !self.found {
            let nowhere = Vector3(core::array::from_fn(|_| S::constant(f64::NAN)));
            self.positions.iter_mut().for_each(|places| places.fill(nowhere));
        }
        &self.positions
    }

    /// Moves the nodes to rest by Newton's method, from where they are, on grounds with this share of their stiffness. Returns
    /// whether they have arrived.
    fn search(&mut self, strands: &[Strand<S>], ends: &[LineEnds<S>], softness: S, at: &Context<'_, S>) -> bool {
        let length = strands.iter().fold(S::ZERO, |sum, strand| sum + strand.mesh.length);
        let (limit, longest) = (length * S::constant(CONVERGED), shortest(strands) * S::constant(LONGEST_MOVE));
        let mut more = if S::HAS_DERIVATIVES { FOR_DERIVATIVES } else { 0 };
        for _ in 0..MOST_ITERATIONS {
            self.assemble(strands, ends, softness, at);
            self.equations.factor();
            let may_arrive = if more > 0 { S::ZERO } else { S::ONE };
            self.descent.improve(&mut self.equations, self.positions.iter_mut(), [limit, longest], may_arrive);
            if self.descent.is_small(limit) {
                more = more.saturating_sub(1);
            }
            if self.descent.has_arrived() {
                return true;
            }
        }
        false
    }

    /// Puts the ends on bodies or in the world.
    fn put_ends(&mut self, strands: &[Strand<S>], ends: &[LineEnds<S>]) {
        for ((positions, strand), LineEnds { places, .. }) in self.positions.iter_mut().zip(strands).zip(ends) {
            positions[0] = places[0];
            positions[strand.mesh.moving().end..].fill(places[1]);
        }
    }

    /// Writes the equations of Newton's method, on grounds with this share of their stiffness.
    fn assemble(&mut self, strands: &[Strand<S>], ends: &[LineEnds<S>], softness: S, at: &Context<'_, S>) {
        let Self { positions, tangents: found, equations, .. } = self;
        for (k, (strand, LineEnds { directions, .. })) in strands.iter().zip(ends).enumerate() {
            let (blocks, positions) = (&mut equations.strands[k], &positions[k]);
            blocks.clear::<true>();
            found.resize(positions.len(), Vector3::zero());
            tangents(positions, found);
            stretch(blocks, &strand.mesh, positions, directions, at.world.gravity);
            let ground = strand.ground.map(|ground| ground.softened(softness));
            load(blocks, (&strand.mesh, ground.as_ref()), (positions, found), at);
        }
    }
}

/// Adds tension and bending of a line with nodes at these positions to its equations.
fn stretch<S: Scalar>(
    blocks: &mut Blocks<S>,
    mesh: &LineMesh<S>,
    positions: &[Vector3<S>],
    directions: &[Vector3<S>; 2],
    gravity: S,
) {
    let hangs_free = mesh.hangs_free();
    let still = [Vector3::zero(); 3];
    for k in 0..positions.len() - 1 {
        let LineMeshElement { length, section } = &mesh.elements[k / 2];
        let half = *length * S::constant(0.5);
        let slopes = slopes(gauss(k), *length);
        let places = [0, 1, 2].map(|i| positions[k / 2 * 2 + i]);
        let found = strained(section, &slopes, &places, &still);
        let ([tension, _], [ratio, _], tangent) = (found.tension, found.ratio, found.tangent);
        let stiff = section.axial_stiffness;
        let least = if hangs_free { stiff * S::constant(SLACK) } else { S::constant(f64::MIN_POSITIVE) };
        let rise = section.rise(tension.select_less(least, || S::ZERO, || stiff));
        let along = Matrix3::outer(tangent, tangent);
        let across = tension.select_below(f64::MIN_POSITIVE, || S::ZERO, || tension / ratio);
        let stiffness = along.scaled(rise) + (Matrix3::identity() - along).scaled(across);
        let weight = section.mass_per_length * *length * gravity;
        let held = rise.select_below(f64::MIN_POSITIVE, || weight / mesh.length, || S::ZERO);
        for node in (k / 2 * 2..k / 2 * 2 + 3).filter(|_| hangs_free) {
            blocks.add::<true>(node, Matrix3::identity().scaled(held), Vector3::zero());
        }
        blocks.add_at::<true>(k / 2 * 2, &slopes, &stiffness.scaled(half), -(tangent * (tension * half)));
    }
    for bend in &mesh.bends {
        let curvature = bend.curvature(|node| positions[node], directions);
        let stiffness = Matrix3::identity().scaled(bend.stiffness);
        blocks.add_at::<true>(bend.first, &bend.weights, &stiffness, -(curvature * bend.stiffness));
    }
}

/// Adds weight, water and ground of a line with nodes at these positions and with these tangents to its equations.
fn load<S: Scalar>(
    blocks: &mut Blocks<S>,
    (mesh, ground): (&LineMesh<S>, Option<&LineGround<S>>),
    (positions, tangents): (&[Vector3<S>], &[Vector3<S>]),
    at: &Context<'_, S>,
) {
    for node in mesh.moving() {
        let (place, part) = (positions[node], &mesh.nodes[node]);
        let wet = part.in_water(at, place, tangents[node]);
        let weight = part.dry_mass() * at.world.gravity;
        let hold = (weight + part.section.axial_stiffness * S::constant(LIGHT)) / mesh.length * S::constant(HOLD);
        if let Some(next) = positions.get(node + 1) {
            blocks.turn(node, turning(&wet, *next - positions[node - 1]));
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
        blocks.add::<true>(node, stiffness, force);
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
