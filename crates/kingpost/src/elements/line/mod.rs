//! A line with mass: a wire or a chain between two points, in waves and current and on the seabed.
//!
//! The line is divided into finite elements with three nodes each, on which the position is quadratic along the line
//! (`strain.rs`). The masses, and all loads per length, are lumped at the nodes by Simpson's rule, so that the mass
//! matrix has 3x3 blocks on its diagonal only. Natural frequencies have an error of fourth order in the length of an
//! element, as those of quadratic elements with consistent masses (Cook et al., *Concepts and Applications of Finite
//! Element Analysis*, 2002, sec. 11.3).

mod advancing;
mod along;
pub(crate) mod assembly;
mod bend;
mod blocks;
mod building;
mod descent;
mod equations;
mod feed;
pub(crate) mod fields;
mod first_shape;
mod ground;
mod in_random_sea;
mod joints;
mod mesh;
mod nodes;
mod one_sided;
mod pay_out;
mod section;
mod slack;
mod span;
mod statics;
mod step;
mod strain;
mod strand;
mod supply;

pub use ground::LineGround;
pub use mesh::LinePart;
pub use section::{ClumpWeight, LineSection};
pub use strand::RestingLine;
pub use supply::LineSupply;

use super::lines::{declaration_of_line, pull_at, shares};
use super::ropes::{Drum, RopePath};
use super::{
    Advancing, AnyWatcher, Context, Declaration, DrawnLine, DrawnSeabed, Element, ElementState, EvaluationMode, Output,
    RandomDrag, StateDeclaration, Support,
};
use crate::dynamics::Loads;
use crate::scalar::Scalar;
use crate::spatial::Vector3;
use along::outputs_along;
use bend::LineEnds;
use slack::Slack;
use statics::LineStatics;
use step::LineStep;
use strand::Strand;
use supply::{EVENTS, Supplied};

/// Lines with inertia that are fastened to each other: a line between two points on bodies or in the world, or from one of them to
/// a free end, and its branches, whose second ends are fastened to nodes of it or of each other.
///
/// Its states are positions and velocities of the nodes between the ends, in the world. The nodes at the ends on bodies move with
/// them, which get the forces of the lines there, and their mass there as an added inertia.
///
/// Forward Euler and Kutta's scheme integrate the bodies only: the lines are [advanced](Advancing) together to each of their stages
/// by the implicit midpoint rule (`step.rs`), so that their axial waves do not limit the step. The other schemes integrate their
/// states with their exact rates.
#[derive(Clone, Debug)]
pub struct DynamicLine<S = f64> {
    /// Its lines, each behind the one to which it is fastened: the first one has the element's name.
    strands: Vec<Strand<S>>,
    /// Drum and sheaves from which the first part of the first line is paid out.
    supply: Option<LineSupply<S>>,
    /// Positions of the nodes between the ends at the start, world, m, if it does not begin at rest.
    pub start: Option<Vec<Vector3<S>>>,
    /// Whether its nodes move by its states about rest: in natural modes and in a linear response to a random sea.
    responds: bool,
    /// Its shape at rest.
    statics: LineStatics<S>,
    /// The present step.
    step: LineStep<S>,
    /// Power of the tensions on the ends at the last evaluation, W.
    on_ends: S,
    /// Its integral and the energy lost to the scheme at the base of the step, J.
    at_base: [S; 2],
}

/// Number of states that are energies; behind them are the velocities of the ends by the implicit rule less those of the bodies.
const ENERGIES: usize = 2;

/// Returns the number of ends of a line for which there are such velocities: a branch has one end on a body.
fn ends_by_rule(strand: usize) -> usize {
    if strand == 0 { 2 } else { 1 }
}

/// Parts of a line, and of several that are fastened to each other, that a response about rest leaves out.
const LEFT_OUT: &str = "the response has this line at rest between its ends at every instant, and leaves out its inertia, the waves on \
     it and its drag, which is zero at rest; in a run the drag damps the line, most near its own periods, and the ship on it";
const LEFT_OUT_OF_ALL: &str = "the response has this line and those that are fastened to it at rest between their ends at every \
     instant, and leaves out their inertia, the waves on them and their drag, which is zero at rest; in a run the drag damps the \
     lines, most near their own periods, and the ship on them";

impl<S: Scalar> DynamicLine<S> {
    /// Takes the start of a run as the reference of its drum and path. Returns the path to its last end, if it has one.
    pub fn begin_supply(&mut self, at: &Context<'_, S>) -> Option<&mut RopePath<S>> {
        self.supply.as_mut().map(|supply| supply.begin(at))
    }

    /// Returns its path and drum, if it runs over them.
    pub fn over_sheaves(&self) -> Option<(&RopePath<S>, Option<Drum<S>>)> {
        self.supply.as_ref().map(|supply| (&supply.whole, supply.drum))
    }

    /// Reads the motion of all nodes, and computes the forces on them and the accelerations between the ends. Returns the
    /// supply.
    ///
    /// At rest, the nodes are where the lines rest between their ends, unless the line was given another start or moves
    /// about rest.
    fn evaluate(&mut self, at: &Context<'_, S>) -> Option<Supplied<S>> {
        let supplied = if self.moves_nodes(at.evaluation) { self.put_nodes(at, at.states) } else { self.rest(at) };
        let by_rule = if at.evaluation.runs() { &at.states[self.motions() + ENERGIES..] } else { &[] };
        let mut by_rule = by_rule.chunks_exact(3).map(Vector3::from_slice);
        for (k, strand) in self.strands.iter_mut().enumerate() {
            let mut of_ends = [Vector3::zero(); 2];
            of_ends.iter_mut().take(ends_by_rule(k)).zip(&mut by_rule).for_each(|(end, by_rule)| *end = by_rule);
            strand.nodes.stretch(&strand.mesh, of_ends);
        }
        self.book_ends(supplied.is_some(), at);
        for strand in &mut self.strands {
            strand.nodes.load(&strand.mesh, strand.ground.as_ref(), at);
        }
        self.accelerate_joints();
        supplied
    }

    /// Whether the nodes are where its states say.
    fn moves_nodes(&self, evaluation: EvaluationMode) -> bool {
        evaluation.runs() || self.start.is_some() || (self.responds && evaluation == EvaluationMode::AtRest)
    }

    /// Sets the length of the first part, if it is paid out.
    fn supply(&mut self, at: &Context<'_, S>) -> Option<Supplied<S>> {
        let supplied = self.supply.as_mut().map(|supply| supply.now(at))?;
        self.strands[0].mesh.set_first(supplied.length);
        Some(supplied)
    }

    /// Computes the power of the tension on the ends and on the supply.
    fn book_ends(&mut self, is_supplied: bool, at: &Context<'_, S>) {
        let of = |strand: &Strand<S>| strand.nodes.power_on_ends(strand.end_velocities(at), strand.turning(at));
        self.on_ends = self.strands.iter().map(of).fold(S::ZERO, |sum, power| sum + power);
        if is_supplied {
            let Strand { nodes, mesh, ground, .. } = &mut self.strands[0];
            self.on_ends += nodes.draw_supply(mesh, ground.as_ref(), at);
        }
    }

    /// Reads the motion of the ends and of the nodes between them. Returns the supply.
    fn put_nodes(&mut self, at: &Context<'_, S>, states: &[S]) -> Option<Supplied<S>> {
        let supplied = self.supply(at);
        let mut rest = states;
        for k in 0..self.strands.len() {
            let strand = &mut self.strands[k];
            let (motions, others) = rest.split_at(strand.motions());
            strand.put(&strand.ends_now(at), at, motions);
            self.follow_joint(k);
            rest = others;
        }
        if let Some(supplied) = &supplied {
            let Strand { nodes, mesh, .. } = &mut self.strands[0];
            nodes.pay_out(mesh, supplied.rate);
        }
        supplied
    }

    /// Puts the nodes where they rest between the present ends. Returns the supply.
    fn rest(&mut self, at: &Context<'_, S>) -> Option<Supplied<S>> {
        let supplied = self.supply(at);
        let ends: Vec<LineEnds<S>> = self.strands.iter().map(|strand| strand.ends_now(at)).collect();
        let calm = Context { evaluation: EvaluationMode::AtRest, ..*at };
        let found = self.statics.solve(&self.strands, &ends, &calm);
        for ((strand, ends), places) in self.strands.iter_mut().zip(&ends).zip(found) {
            strand.nodes.directions = ends.directions;
            for (node, place) in places.iter().enumerate() {
                strand.nodes.put(node, *place, Vector3::zero());
            }
        }
        if supplied.is_some() {
            let Strand { nodes, mesh, .. } = &mut self.strands[0];
            nodes.pay_out(mesh, S::ZERO);
        }
        supplied
    }

    /// Returns the shapes of its lines at rest, for a model at rest.
    pub fn at_rest(&mut self, at: &Context<'_, S>) -> Vec<RestingLine<S>> {
        self.rest(at);
        let fields = if self.supply.is_some() { ["path"; 2] } else { ["first", "second"] };
        self.strands.iter_mut().map(|strand| strand.resting(fields)).collect()
    }

    /// Returns the velocities of the ends of a line at the start: both that of its first end if the second one is free.
    fn first_velocities(&self, strand: usize, supplied: Option<&Supplied<S>>, at: &Context<'_, S>) -> [Vector3<S>; 2] {
        let line = &self.strands[strand];
        let [first, last] = line.end_velocities(at);
        let last = match line.joint {
            Some(joint) => self.strands[joint.strand].nodes.node(joint.node).velocity,
            None if line.ends[1].is_none() => first,
            None => last,
        };
        let drawn = supplied.filter(|_| strand == 0).map_or(S::ZERO, |now| now.rate);
        [first - line.nodes.feed().drift(0) * drawn, last]
    }

    /// Adds the outputs and the drawn line of one of its lines.
    fn declare_line(&self, k: usize, declared: &mut Declaration) {
        let strand = &self.strands[k];
        let of_line = declaration_of_line(&strand.name);
        declared.outputs.extend(of_line.outputs);
        if k == 0 {
            let lost =
                "energy that the time stepping of a line took from it and from the lines that are fastened to it";
            declared.outputs.push(Output::number("line_energy_lost_to_scheme", lost, "line", &strand.name, &["J"]));
        }
        let seabed = strand.ground.map(|ground| DrawnSeabed {
            height_m: -ground.depth.value(),
            gradient: ground.gradient().map(|slope| slope.value()),
        });
        declared.lines.extend(of_line.lines.into_iter().map(|drawn| DrawnLine { seabed, ..drawn }));
        declared.outputs.extend(outputs_along(&strand.name, strand.points_along, strand.ground.is_some()));
        if k == 0 && self.supply.is_some() {
            let rate = "rate at which the length of a line increases";
            declared.outputs.push(Output::number("line_pay_out_rate", rate, "line", &strand.name, &["m/s"]));
        }
    }

    /// Returns the index, behind the motions, of the impulses that the lines owe to their ends.
    fn owed(&self) -> usize {
        ENERGIES + 3 * (0..self.strands.len()).map(ends_by_rule).sum::<usize>()
    }

    /// Returns the number of states that are positions and velocities.
    fn motions(&self) -> usize {
        self.strands.iter().map(Strand::motions).sum()
    }
}

impl<S: Scalar> Element<S> for DynamicLine<S> {
    fn name(&self) -> &str {
        &self.strands[0].name
    }

    fn declare(&self) -> Declaration {
        let energies = ["work_on_ends", "energy_lost_to_scheme"].map(|name| StateDeclaration::memory(name, "J"));
        let mut declared = Declaration::default();
        let (mut by_rule, mut owed) = (Vec::new(), Vec::new());
        for (k, strand) in self.strands.iter().enumerate() {
            let prefix = if k == 0 { String::new() } else { format!("{}.", strand.name) };
            declared.states.extend(strand.declared_motions(&prefix));
            for end in ["first", "second"].into_iter().take(ends_by_rule(k)) {
                for axis in ["x", "y", "z"] {
                    let name = |what: &str| format!("{prefix}{end}_end_{what}.{axis}");
                    by_rule.push(StateDeclaration::memory(name("by_rule"), "m/s"));
                    owed.push(StateDeclaration::memory(name("owed_impulse"), "N s"));
                }
            }
            self.declare_line(k, &mut declared);
        }
        declared.states.extend(energies.into_iter().chain(by_rule).chain(owed));
        if self.supply.is_some() {
            declared.events.extend(EVENTS);
        }
        Declaration { keeps_states: self.start.is_some(), advances: true, ..declared }
    }

    /// Writes the nodes at rest; their velocities vary linearly from end to end.
    fn begin(&mut self, at: &Context<'_, S>, own: &mut ElementState<'_, S>) {
        own.states.fill(S::ZERO);
        if let Some(start) = &self.start {
            return start.iter().zip(own.states.chunks_exact_mut(3)).for_each(|(place, state)| place.write_to(state));
        }
        let supplied = self.rest(at);
        let mut rest = &mut *own.states;
        for k in 0..self.strands.len() {
            let [first, last] = self.first_velocities(k, supplied.as_ref(), at);
            let (motions, others) = rest.split_at_mut(self.strands[k].motions());
            self.strands[k].begin([first, last], motions);
            self.follow_joint(k);
            rest = others;
        }
    }

    /// Adds the forces and inertias at the ends on bodies, and the power of damping and water.
    fn loads(&mut self, at: &Context<'_, S>, loads: &mut Loads<S>) {
        let stepping = at.evaluation == EvaluationMode::Stepping;
        let supplied = if stepping { self.evaluate_ends(at) } else { self.evaluate(at) };
        let Strand { nodes, mesh, ends, .. } = &self.strands[0];
        if let (Some(supplied), Some(supply), Some(first)) = (&supplied, &self.supply, &ends[0]) {
            let thrust = supply.draw(supplied, nodes.feed(), mesh.mass_per_length(), at, loads);
            pull_at(first, thrust, at, loads);
        }
        for strand in &self.strands {
            loads.power.dissipated += strand.nodes.dissipated;
            loads.power.outside += strand.nodes.outside;
            strand.pull(at, loads);
            strand.turn(at, loads);
        }
    }

    fn rates(&mut self, at: &Context<'_, S>, rates: &mut [S]) {
        let (mut motions, energies) = rates.split_at_mut(self.motions());
        energies.fill(S::ZERO);
        energies[0] = self.on_ends;
        if at.evaluation == EvaluationMode::Stepping {
            let mut owed = energies[self.owed()..].chunks_exact_mut(3);
            for (k, strand) in self.strands.iter().enumerate() {
                let pulls = strand.pulls.into_iter().take(ends_by_rule(k));
                pulls.zip(&mut owed).for_each(|(pull, rate)| (-pull).write_to(rate));
            }
            return motions.fill(S::ZERO);
        }
        for strand in &self.strands {
            let (own, others) = motions.split_at_mut(strand.motions());
            strand.rates(own);
            motions = others;
        }
    }

    /// Returns the energy of strain, weight and ground, and the kinetic energy of the nodes between the ends, J.
    fn potential_energy(&mut self, at: &Context<'_, S>) -> S {
        let supplied = self.evaluate(at);
        let of = |strand: &Strand<S>| strand.nodes.energy(&strand.mesh, strand.ground.as_ref(), at);
        let energy = self.strands.iter().map(of).fold(S::ZERO, |sum, energy| sum + energy);
        let let_out = supplied.zip(self.supply.as_ref());
        let mass_per_length = self.strands[0].mesh.mass_per_length();
        let_out.map_or(energy, |(now, supply)| energy + supply.energy(&now, mass_per_length, at))
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        let supplied = self.evaluate(at);
        let (mut rate, mut lost) = (supplied.map(|now| now.rate), Some(at.states[self.motions() + 1]));
        for Strand { nodes, mesh, ground, points_along, .. } in &self.strands {
            out.extend(nodes.end_tensions(mesh));
            out.push(nodes.grounded_length(mesh, ground.as_ref()));
            out.extend(lost.take());
            nodes.write_along(mesh, ground.as_ref(), *points_along, out);
            out.extend(rate.take());
        }
    }

    fn event_indicators(&mut self, at: &Context<'_, S>, values: &mut [S]) {
        let mass_per_length = self.strands[0].mesh.mass_per_length();
        let Some((now, supply)) = self.supply(at).zip(self.supply.as_ref()) else { return };
        values.copy_from_slice(&supply.indicators(&now, mass_per_length, at));
    }

    fn draw(&mut self, at: &Context<'_, S>, points: &mut Vec<S>) {
        self.evaluate(at);
        for Strand { nodes, mesh, .. } in &self.strands {
            shares().for_each(|share: f64| points.extend(nodes.at(share, mesh).0));
        }
    }

    fn left_out_at_rest(&self) -> Option<&'static str> {
        Some(if self.strands.len() == 1 { LEFT_OUT } else { LEFT_OUT_OF_ALL })
    }

    fn move_about_rest(&mut self, moves: bool) {
        self.responds = moves;
    }

    fn random_drag(&self) -> Option<&dyn RandomDrag<S>> {
        self.has_random_drag().then_some(self as _)
    }

    fn random_drag_mut(&mut self) -> Option<&mut dyn RandomDrag<S>> {
        self.has_random_drag().then_some(self as _)
    }

    fn watchers(&self) -> Vec<AnyWatcher> {
        let of = |Strand { name, mesh, ground, .. }: &Strand<S>| -> AnyWatcher {
            let ends = if ground.is_some() || mesh.hangs_free() { 1 } else { 2 };
            Box::new(Slack::new(name, ends))
        };
        self.strands.iter().map(of).collect()
    }

    fn advancing(&mut self) -> Option<&mut dyn Advancing<S>> {
        Some(self)
    }

    fn supports(&self) -> Vec<Support> {
        let held: Vec<Option<usize>> = self.strands.iter().flat_map(Strand::held).map(|(_, end)| end.body).collect();
        let pairs = held.iter().enumerate().flat_map(|(k, one)| held[k + 1..].iter().map(|other| [*one, *other]));
        pairs.flat_map(|ends| [Support::Carries(ends), Support::Station(ends)]).collect()
    }
}
