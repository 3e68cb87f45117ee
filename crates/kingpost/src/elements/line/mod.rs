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
mod descent;
mod ends;
mod feed;
pub(crate) mod fields;
mod ground;
mod in_random_sea;
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
mod supply;

pub use ground::LineGround;
pub use mesh::LinePart;
pub use section::{ClumpWeight, LineSection};
pub use supply::LineSupply;

use super::lines::{declaration_of_line, pull_at, shares, velocity};
use super::ropes::{Drum, RopePath, Station};
use super::{
    Advancing, AnyWatcher, Context, Crossing, Declaration, DrawnSeabed, Element, ElementState, EvaluationMode, Event,
    Output, RandomDrag, StateDeclaration, Support,
};
use crate::dynamics::Loads;
use crate::model::Attachment;
use crate::scalar::Scalar;
use crate::spatial::Vector3;
use along::outputs_along;
use bend::LineEnds;
use mesh::LineMesh;
use nodes::Nodes;
use slack::Slack;
use statics::LineStatics;
use step::LineStep;
use supply::Supplied;

/// A line with inertia between two points on bodies or in the world, or from one of them to a free end.
///
/// Its states are positions and velocities of the nodes between its ends, in the world. The nodes at its ends move with
/// the bodies, which get the forces of the line there, and its mass there as an added inertia.
///
/// Forward Euler and Kutta's scheme integrate the bodies only: the line is [advanced](Advancing) to each of their stages by
/// the implicit midpoint rule (`step.rs`), so that its axial waves do not limit the step. The other schemes integrate its
/// states with their exact rates.
#[derive(Clone, Debug)]
pub struct DynamicLine<S = f64> {
    /// Name in the results.
    pub name: String,
    /// Its ends.
    pub ends: [Attachment<S>; 2],
    /// Directions from the first end to the second one at clamped ends, in the axes of their bodies.
    clamps: [Option<Vector3<S>>; 2],
    /// The ground on which it can lie.
    pub ground: Option<LineGround<S>>,
    /// Drum and sheaves from which its first part is paid out.
    supply: Option<LineSupply<S>>,
    /// Positions of the nodes between the ends at the start, world, m, if it does not begin at rest.
    pub start: Option<Vec<Vector3<S>>>,
    /// Whether its nodes move by its states about rest: in natural modes and in a linear response to a random sea.
    responds: bool,
    /// Number of points along it at which the results have its tension: 0, or 2 and more.
    pub points_along: usize,
    /// Its elements and nodes.
    mesh: LineMesh<S>,
    /// Working memory.
    nodes: Nodes<S>,
    /// Its shape at rest.
    statics: LineStatics<S>,
    /// The present step.
    step: LineStep<S>,
    /// Power of its tension on its ends at the last evaluation, W.
    on_ends: S,
    /// Its integral and the energy lost to the scheme at the base of the step, J.
    at_base: [S; 2],
}

/// Number of states that are energies; behind them are the velocities of the ends by the implicit rule less those of the bodies.
const ENERGIES: usize = 2;

/// Events of a line that is paid out, in the order of [`Supplied`].
const EVENTS: [Event; 3] = [
    Event { code: "hauled_in_to_end", what: "is hauled in to its end", crossing: Crossing::Falling },
    Event {
        code: "paid_out_to_innermost_layer",
        what: "is paid out to the innermost layer of its drum",
        crossing: Crossing::Falling,
    },
    Event {
        code: "leaves_valid_path",
        what: "wraps a sheave or drum beyond the valid angle, or two neighbouring places of its path overlap",
        crossing: Crossing::Falling,
    },
];

/// The shape of a line at rest.
#[derive(Clone, Copy, Debug)]
pub struct RestingLine<S> {
    /// Positions of its ends, world, m.
    pub ends: [Vector3<S>; 2],
    /// Its largest strain.
    pub strain: S,
}

impl<S: Scalar> DynamicLine<S> {
    /// Creates a line of these parts, from its first end, which begins at rest.
    pub fn new(name: &str, ends: [Attachment<S>; 2], parts: &[LinePart<S>]) -> Self {
        Self::with_mesh(name, ends, LineMesh::new(parts))
    }

    fn with_mesh(name: &str, ends: [Attachment<S>; 2], mesh: LineMesh<S>) -> Self {
        Self {
            name: name.to_owned(),
            ends,
            clamps: [None; 2],
            ground: None,
            supply: None,
            start: None,
            responds: false,
            points_along: 0,
            nodes: Nodes::new(&mesh),
            statics: LineStatics::new(&mesh),
            step: LineStep::new(&mesh),
            mesh,
            on_ends: S::ZERO,
            at_base: [S::ZERO; 2],
        }
    }

    /// Creates a line of these parts whose second end is free, from its first end; `nowhere` is a place in the world.
    pub fn ending_free(name: &str, first: Attachment<S>, nowhere: Attachment<S>, parts: &[LinePart<S>]) -> Self {
        Self::with_mesh(name, [first, nowhere], LineMesh::new(parts).ending_free())
    }

    /// Gives the line other elements and nodes.
    fn on_mesh(self, mesh: LineMesh<S>) -> Self {
        let (nodes, statics, step) = (Nodes::new(&mesh), LineStatics::new(&mesh), LineStep::new(&mesh));
        Self { nodes, statics, step, mesh, ..self }
    }

    /// Lets the line begin with its nodes at these positions between the ends, world, m: one less than twice the number of
    /// elements.
    pub fn beginning_at(self, start: Vec<Vector3<S>>) -> Self {
        Self { start: Some(start), ..self }
    }

    /// Lets the first of these parts be paid out, over the stations of a path: its last two are the ends of the line.
    pub fn over(name: &str, stations: &[Station<S>], drum: Option<Drum<S>>, parts: &[LinePart<S>]) -> Self {
        let supply = LineSupply::new(stations, drum, parts[0].unstretched_length);
        let ends = [2, 1].map(|from_last| stations[stations.len() - from_last].centre);
        let mesh = LineMesh::new(parts).pays_out(parts[0].elements);
        Self { supply: Some(supply), ..Self::with_mesh(name, ends, mesh) }
    }

    /// Takes the start of a run as the reference of its drum and path. Returns the path to its last end, if it has one.
    pub fn begin_supply(&mut self, at: &Context<'_, S>) -> Option<&mut RopePath<S>> {
        self.supply.as_mut().map(|supply| supply.begin(at))
    }

    /// Fastens a clump weight or a buoy to the end of an element, counted from the first end, from 1.
    pub fn with_clump(mut self, element: usize, clump: ClumpWeight<S>) -> Self {
        self.mesh.nodes[2 * element].clump = Some(clump);
        self
    }

    /// Returns its path and drum, if it runs over them.
    pub fn over_sheaves(&self) -> Option<(&RopePath<S>, Option<Drum<S>>)> {
        self.supply.as_ref().map(|supply| (&supply.whole, supply.drum))
    }

    /// Lets the line lie on a ground.
    pub fn on(self, ground: LineGround<S>) -> Self {
        Self { ground: Some(ground), ..self }
    }

    /// Reads the motion of all nodes, and computes the forces on them and the accelerations between the ends. Returns the
    /// supply.
    ///
    /// At rest, the nodes are where the line rests between its ends, unless the line was given another start or moves
    /// about rest.
    fn evaluate(&mut self, at: &Context<'_, S>) -> Option<Supplied<S>> {
        let supplied = if self.moves_nodes(at.evaluation) { self.put_nodes(at, at.states) } else { self.rest(at) };
        self.nodes.stretch(&self.mesh, self.by_rule(at));
        self.book_ends(supplied.is_some(), at);
        self.nodes.load(&self.mesh, self.ground.as_ref(), at);
        supplied
    }

    /// Returns the velocities of the ends by the implicit rule less those of their bodies, m/s: zero at rest.
    fn by_rule(&self, at: &Context<'_, S>) -> [Vector3<S>; 2] {
        let from = self.motions() + ENERGIES;
        let read = |end: usize| Vector3::from_slice(&at.states[from + 3 * end..]);
        if at.evaluation.runs() { [read(0), read(1)] } else { [Vector3::zero(); 2] }
    }

    /// Whether the nodes are where its states say.
    fn moves_nodes(&self, evaluation: EvaluationMode) -> bool {
        evaluation.runs() || self.start.is_some() || (self.responds && evaluation == EvaluationMode::AtRest)
    }

    /// Sets the length of the first part, if it is paid out.
    fn supply(&mut self, at: &Context<'_, S>) -> Option<Supplied<S>> {
        let supplied = self.supply.as_mut().map(|supply| supply.now(at))?;
        self.mesh.set_first(supplied.length);
        Some(supplied)
    }

    /// Computes the power of the tension on the ends and on the supply.
    fn book_ends(&mut self, is_supplied: bool, at: &Context<'_, S>) {
        self.on_ends = self.nodes.power_on_ends([0, 1].map(|end| velocity(&self.ends[end], at)), self.turning(at));
        if is_supplied {
            self.on_ends += self.nodes.draw_supply(&self.mesh, self.ground.as_ref(), at);
        }
    }

    /// Reads the motion of the ends and of the nodes between them. Returns the supply.
    fn put_nodes(&mut self, at: &Context<'_, S>, states: &[S]) -> Option<Supplied<S>> {
        let supplied = self.supply(at);
        let LineEnds { places, directions } = self.ends_now(at);
        self.nodes.directions = directions;
        for ((end, place), node) in self.ends.iter().zip(places).zip(self.held_nodes()) {
            self.nodes.put(node, place, velocity(end, at));
        }
        let (positions, velocities) = states[..self.motions()].split_at(self.motions() / 2);
        for (k, (x, v)) in positions.chunks_exact(3).zip(velocities.chunks_exact(3)).enumerate() {
            self.nodes.put(k + 1, Vector3::from_slice(x), Vector3::from_slice(v));
        }
        if let Some(supplied) = &supplied {
            self.nodes.pay_out(&self.mesh, supplied.rate);
        }
        supplied
    }

    /// Puts the nodes where they rest between the present ends. Returns the supply.
    fn rest(&mut self, at: &Context<'_, S>) -> Option<Supplied<S>> {
        let supplied = self.supply(at);
        let ends = self.ends_now(at);
        let Self { nodes, statics, mesh, ground, .. } = self;
        nodes.directions = ends.directions;
        let calm = Context { evaluation: EvaluationMode::AtRest, ..*at };
        let found = statics.solve(mesh, ground.as_ref(), &ends, &calm);
        for (node, place) in found.iter().enumerate() {
            nodes.put(node, *place, Vector3::zero());
        }
        if supplied.is_some() {
            nodes.pay_out(mesh, S::ZERO);
        }
        supplied
    }

    /// Returns the length without tension, m.
    pub fn unstretched_length(&self) -> S {
        self.mesh.length
    }

    /// Returns its shape at rest, for a model at rest; NaN if none was found.
    pub fn at_rest(&mut self, at: &Context<'_, S>) -> RestingLine<S> {
        self.rest(at);
        self.nodes.stretch(&self.mesh, [Vector3::zero(); 2]);
        let ends = self.end_nodes().map(|node| self.nodes.node(node).position);
        RestingLine { ends, strain: self.nodes.largest_strain(&self.mesh) }
    }

    /// Returns the number of states that are positions and velocities.
    fn motions(&self) -> usize {
        6 * self.mesh.moving().len()
    }
}

impl<S: Scalar> Element<S> for DynamicLine<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let of = |what: &str, unit: &'static str| {
            let name = |k: usize, axis: &str| format!("node_{}.{what}.{axis}", k + 1);
            let axes = |k: usize| ["x", "y", "z"].map(|axis| StateDeclaration::new(name(k, axis), unit));
            (0..self.mesh.moving().len()).flat_map(axes).collect::<Vec<_>>()
        };
        let energies = ["work_on_ends", "energy_lost_to_scheme"].map(|name| StateDeclaration::memory(name, "J"));
        let by_rule = ["first", "second"].map(|end| {
            ["x", "y", "z"].map(|axis| StateDeclaration::memory(format!("{end}_end_by_rule.{axis}"), "m/s"))
        });
        let states = [of("position", "m"), of("velocity", "m/s"), energies.to_vec(), by_rule.concat()].concat();
        let mut declared = declaration_of_line(&self.name);
        let lost = "energy that the time stepping of a line took from it";
        declared.outputs.push(Output::number("line_energy_lost_to_scheme", lost, "line", &self.name, &["J"]));
        declared.lines[0].seabed = self.ground.map(|ground| DrawnSeabed {
            height_m: -ground.depth.value(),
            gradient: ground.gradient().map(|slope| slope.value()),
        });
        declared.outputs.extend(outputs_along(&self.name, self.points_along, self.ground.is_some()));
        if self.supply.is_some() {
            let rate = "rate at which the length of a line increases";
            declared.outputs.push(Output::number("line_pay_out_rate", rate, "line", &self.name, &["m/s"]));
            declared.events.extend(EVENTS);
        }
        Declaration { states, keeps_states: self.start.is_some(), advances: true, ..declared }
    }

    /// Writes the nodes at rest; their velocities vary linearly from end to end.
    fn begin(&mut self, at: &Context<'_, S>, own: &mut ElementState<'_, S>) {
        own.states.fill(S::ZERO);
        let (positions, velocities) = own.states[..self.motions()].split_at_mut(self.motions() / 2);
        if let Some(start) = &self.start {
            return start.iter().zip(positions.chunks_exact_mut(3)).for_each(|(place, state)| place.write_to(state));
        }
        let supplied = self.rest(at);
        let [first, last] = [0, 1].map(|end| velocity(&self.ends[if self.mesh.free_end { 0 } else { end }], at));
        let first = first - self.nodes.feed().drift(0) * supplied.map_or(S::ZERO, |now| now.rate);
        let parts = (self.nodes.len() - 1) as f64;
        for (k, (x, v)) in positions.chunks_exact_mut(3).zip(velocities.chunks_exact_mut(3)).enumerate() {
            self.nodes.node(k + 1).position.write_to(x);
            (first + (last - first) * S::constant((k + 1) as f64 / parts)).write_to(v);
        }
    }

    /// Adds the forces and inertias at both ends, and the power of damping and water.
    fn loads(&mut self, at: &Context<'_, S>, loads: &mut Loads<S>) {
        let stepping = at.evaluation == EvaluationMode::Stepping;
        let supplied = if stepping { self.evaluate_ends(at) } else { self.evaluate(at) };
        if let (Some(supplied), Some(supply)) = (&supplied, &self.supply) {
            let feed = self.nodes.feed();
            supply.draw(supplied, feed, self.mesh.mass_per_length(), at, loads);
            pull_at(&self.ends[0], feed.thrust, at, loads);
            loads.power.outside += feed.entering;
        }
        loads.power.dissipated += self.nodes.dissipated;
        loads.power.outside += self.nodes.outside;
        for (end, node) in self.ends.iter().zip(self.held_nodes()) {
            self.pull(end, self.nodes.node(node), at, loads);
        }
        self.turn(at, loads);
    }

    fn rates(&mut self, at: &Context<'_, S>, rates: &mut [S]) {
        let (motions, energies) = rates.split_at_mut(self.motions());
        energies.fill(S::ZERO);
        energies[0] = self.on_ends;
        if at.evaluation == EvaluationMode::Stepping {
            return motions.fill(S::ZERO);
        }
        let half = motions.len() / 2;
        let (moves, accelerates) = motions.split_at_mut(half);
        for (k, (x, v)) in moves.chunks_exact_mut(3).zip(accelerates.chunks_exact_mut(3)).enumerate() {
            self.nodes.mesh_velocity(k + 1).write_to(x);
            self.nodes.mesh_acceleration(k + 1, &self.mesh).write_to(v);
        }
    }

    /// Returns the energy of strain, weight and ground, and the kinetic energy of the nodes between the ends, J.
    fn potential_energy(&mut self, at: &Context<'_, S>) -> S {
        let supplied = self.evaluate(at);
        let energy = self.nodes.energy(&self.mesh, self.ground.as_ref(), at);
        let let_out = supplied.zip(self.supply.as_ref());
        let_out.map_or(energy, |(now, supply)| energy + supply.energy(&now, self.mesh.mass_per_length(), at))
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        let supplied = self.evaluate(at);
        let [first, last] = self.nodes.end_tensions(&self.mesh);
        let lost = at.states[self.motions() + 1];
        out.extend([first, last, self.nodes.grounded_length(&self.mesh, self.ground.as_ref()), lost]);
        self.nodes.write_along(&self.mesh, self.ground.as_ref(), self.points_along, out);
        out.extend(supplied.map(|now| now.rate));
    }

    fn event_indicators(&mut self, at: &Context<'_, S>, values: &mut [S]) {
        let Some(now) = self.supply(at) else { return };
        values.copy_from_slice(&[now.left, now.layers_left, now.range_left]);
    }

    fn draw(&mut self, at: &Context<'_, S>, points: &mut Vec<S>) {
        self.evaluate(at);
        shares().for_each(|share: f64| points.extend(self.nodes.at(share, &self.mesh).0));
    }

    fn left_out_at_rest(&self) -> Option<&'static str> {
        Some(
            "the response has this line at rest between its ends at every instant, and leaves out its inertia, the waves on it and its \
             drag, which is zero at rest; in a run the drag damps the line, most near its own periods, and the ship on it",
        )
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
        let ends = if self.ground.is_some() || self.mesh.free_end { 1 } else { 2 };
        vec![Box::new(Slack::new(&self.name, ends))]
    }

    fn advancing(&mut self) -> Option<&mut dyn Advancing<S>> {
        Some(self)
    }

    fn supports(&self) -> Vec<Support> {
        let ends = [self.ends[0].body, self.ends[1].body];
        vec![Support::Carries(ends), Support::Station(ends)]
    }
}
