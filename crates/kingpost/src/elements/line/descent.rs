//! Newton's method for the nodes of a tree of lines, with a line search.
//!
//! A line that only pulls, on a ground that only pushes, has a convex energy, so that its forces fall along every move: a move
//! after which they push back with more than half of the force that began it has overshot a kink, and is halved. Drag has no
//! energy: a move against the forces, which it can cause, is not judged.

use super::equations::LineEquations;
use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// Force along a move at its end over that at its start at which the move is halved.
const OVERSHOT: f64 = -0.5;

/// Positions of nodes on their way to the solution. A lane that has arrived stays, as if it were alone.
#[derive(Clone, Debug)]
pub struct Descent<S> {
    /// Newton's moves, m.
    newton: Vec<Vector3<S>>,
    /// The last move, m.
    way: Vec<Vector3<S>>,
    /// Forces at the present positions, N.
    forces: Vec<Vector3<S>>,
    /// Work of the force at the start of the last move along it, J.
    gain: S,
    /// Size of Newton's last move, m.
    size: S,
    /// 1 until the moves are small enough.
    goes_on: S,
}

impl<S: Scalar> Descent<S> {
    /// Allocates the memory for this number of nodes of all lines.
    pub fn new(count: usize) -> Self {
        let zero = vec![Vector3::zero(); count];
        let (newton, way, forces) = (zero.clone(), zero.clone(), zero);
        Self { newton, way, forces, gain: S::ZERO, size: S::ZERO, goes_on: S::ONE }
    }

    /// Begins a search.
    pub fn begin(&mut self) {
        self.way.fill(Vector3::zero());
        (self.gain, self.goes_on) = (S::ZERO, S::ONE);
    }

    /// Begins a further search of the lanes that were [open](Self::open).
    pub fn begin_again(&mut self, open: S) {
        self.begin();
        self.goes_on = open;
    }

    /// Returns 1 for lanes that have not arrived, 0 for others.
    pub fn open(&self) -> S {
        self.goes_on
    }

    /// Moves the nodes of all lines by the linear effect of moves of their ends, which the equations have the matrix for.
    pub fn follow<'a>(
        &mut self,
        equations: &mut LineEquations<S>,
        ends: &[[Vector3<S>; 2]],
        nodes: impl Iterator<Item = &'a mut Vec<Vector3<S>>>,
    ) where
        S: 'a,
    {
        equations.strands.iter_mut().zip(ends).for_each(|(blocks, ends)| blocks.move_ends(*ends));
        equations.solve(&mut self.newton);
        nodes.flatten().zip(&self.newton).for_each(|(node, move_m)| *node += *move_m);
    }

    /// Moves the nodes of all lines, whose equations are given, by at most `longest` (m). Ends the search of each lane whose Newton move is
    /// shorter than `enough` (m), if it may arrive: 1, or 0.
    pub fn improve<'a>(
        &mut self,
        equations: &mut LineEquations<S>,
        nodes: impl Iterator<Item = &'a mut Vec<Vector3<S>>>,
        [enough, longest]: [S; 2],
        may_arrive: S,
    ) where
        S: 'a,
    {
        self.forces.clear();
        equations.strands.iter().for_each(|blocks| self.forces.extend_from_slice(blocks.right()));
        equations.solve(&mut self.newton);
        let half = S::constant(0.5);
        let work = |forces: &[Vector3<S>], way: &[Vector3<S>]| {
            forces.iter().zip(way).fold(S::ZERO, |sum, (force, way)| sum + force.dot(*way))
        };
        let larger = |a: S, b: S| a.select_less(b, || b, || a);
        let squares = self.newton.iter().map(|way| way.norm_squared());
        let [most, sum] = squares.fold([S::ZERO; 2], |[most, sum], square| [larger(most, square), sum + square]);
        // NaN and infinity stay.
        self.size = (most + sum * S::ZERO).sqrt();
        let has_overshot =
            work(&self.forces, &self.way).select_less(self.gain * S::constant(OVERSHOT), || S::ONE, || S::ZERO);
        // The forces about a solution are rounding.
        let judged = self.size.select_less(enough, || S::ZERO, || has_overshot);
        let back = self.gain.select_below(0.0, || S::ZERO, || judged);
        let share = self.size.select_less(longest, || S::ONE, || longest / self.size);
        let of_newton = work(&self.forces, &self.newton) * share;
        self.gain = back.select_below(0.5, || of_newton, || self.gain * half);
        let mut first = 0;
        for nodes in nodes {
            let these = first..first + nodes.len();
            first = these.end;
            for ((node, way), newton) in nodes.iter_mut().zip(&mut self.way[these.clone()]).zip(&self.newton[these]) {
                for k in 0..3 {
                    let (halved, whole) = (way[k] * half, newton[k] * share);
                    let moved = node[k] + back.select_below(0.5, || whole, || -halved);
                    node[k] = self.goes_on.select_below(0.5, || node[k], || moved);
                    way[k] = back.select_below(0.5, || whole, || halved);
                }
            }
        }
        let arrives = self.size.select_less(enough, || may_arrive, || S::ZERO);
        self.goes_on = arrives.select_below(0.5, || self.goes_on, || S::ZERO);
    }

    /// Completes the derivatives of nodes that have arrived, whose equations are given: their values stay.
    pub fn differentiate<'a>(
        &mut self,
        equations: &mut LineEquations<S>,
        nodes: impl Iterator<Item = &'a mut Vec<Vector3<S>>>,
    ) where
        S: 'a,
    {
        equations.solve(&mut self.newton);
        for (node, newton) in nodes.flatten().zip(&self.newton) {
            *node += Vector3(newton.0.map(|move_m| move_m - move_m.plain()));
        }
    }

    /// Whether all lanes have arrived.
    pub fn has_arrived(&self) -> bool {
        self.goes_on.all(|goes_on| goes_on == 0.0)
    }

    /// Whether all Newton moves of the last iteration were shorter than this, m.
    pub fn is_small(&self, enough: S) -> bool {
        (self.size - enough).all(|excess| excess < 0.0)
    }

    /// Returns the size of Newton's last move, m.
    pub fn size(&self) -> S {
        self.size
    }
}
