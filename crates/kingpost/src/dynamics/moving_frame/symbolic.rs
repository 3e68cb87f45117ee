//! The method's matrices as formulas, generated from the tree: each block of B and of the other matrices, for any
//! mechanism.

use super::factors::{Factor, Symbol};
use super::formula::{Formula, Instant};
use super::symbols::Symbols;
use crate::model::{AxisMotion, JointKind, MotionType};
use nalgebra::DMatrix;
use serde::Serialize;

/// One matrix by blocks, in LaTeX.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SymbolicMatrix {
    /// Name, as in [`NamedMatrix`](super::NamedMatrix): `B`, `M_star`, `E_tower/ship`.
    pub name: String,
    /// The symbol on the left-hand side.
    pub symbol: String,
    /// The paper's equation.
    pub equation: &'static str,
    /// The meaning of each block row, in LaTeX.
    pub rows: Vec<String>,
    /// The meaning of each block column, in LaTeX.
    pub columns: Vec<String>,
    /// Blocks by row, in LaTeX.
    pub blocks: Vec<Vec<String>>,
}

/// A matrix of formulas.
pub struct BlockMatrix {
    /// Formulas by block row.
    pub blocks: Vec<Vec<Formula>>,
    /// Columns of numbers in each block column.
    widths: Vec<usize>,
}

impl BlockMatrix {
    /// All blocks in numbers at a state.
    pub fn value(&self, symbols: &Symbols<'_>, at: Instant<'_>) -> DMatrix<f64> {
        let mut out = DMatrix::zeros(3 * self.blocks.len(), self.widths.iter().sum());
        for (i, row) in self.blocks.iter().enumerate() {
            let mut column = 0;
            for (block, width) in row.iter().zip(&self.widths) {
                if !block.terms.is_empty() {
                    out.view_mut((3 * i, column), (3, *width)).copy_from(&block.value(symbols, at));
                }
                column += width;
            }
        }
        out
    }
}

/// A block column of B: coordinates of a joint that form one block.
#[derive(Clone, Copy)]
enum BlockColumn {
    /// x' of a floating body.
    Translation,
    /// omega of a floating body, or of a spherical joint.
    Rotation,
    /// One axis.
    Axis(usize),
}

impl Symbols<'_> {
    /// B (eq. 46, as corrected) by blocks: rows x' and omega of each body; columns the translation
    /// and the rotation of a floating body, the rotation of a spherical joint, the rate of each axis.
    pub fn b(&self) -> BlockMatrix {
        let bodies = self.model.bodies.len();
        let (mut blocks, mut widths) = (vec![Vec::new(); 2 * bodies], Vec::new());
        for (c, column) in (0..bodies).flat_map(|c| self.columns(c).into_iter().map(move |column| (c, column))) {
            for a in 0..bodies {
                let below = self.path(a).any(|b| b == c);
                let formulas = if below { self.rates_of(a, c, column) } else { [Formula::zero(), Formula::zero()] };
                for (row, formula) in blocks[2 * a..].iter_mut().zip(formulas) {
                    row.push(formula);
                }
            }
            widths.push(if matches!(column, BlockColumn::Axis(_)) { 1 } else { 3 });
        }
        BlockMatrix { blocks, widths }
    }

    /// B' by the product rule.
    pub fn b_dot(&self) -> BlockMatrix {
        let BlockMatrix { blocks, widths } = self.b();
        let rates = |row: Vec<Formula>| row.iter().map(|block| block.rate(self)).collect();
        BlockMatrix { blocks: blocks.into_iter().map(rates).collect(), widths }
    }

    fn columns(&self, c: usize) -> Vec<BlockColumn> {
        match self.node(c).kind {
            JointKind::Floating(_) => vec![BlockColumn::Translation, BlockColumn::Rotation],
            JointKind::Spherical(_) => vec![BlockColumn::Rotation],
            _ => (0..self.axes(c).len()).map(BlockColumn::Axis).collect(),
        }
    }

    /// The contribution of a column of c's joint to x' and to omega of body a.
    fn rates_of(&self, a: usize, c: usize, column: BlockColumn) -> [Formula; 2] {
        let rotation = Some(c);
        let to_a = if a == c { Vec::new() } else { vec![Factor::RotationTransposed(a, c)] };
        match column {
            BlockColumn::Translation => [Formula { terms: vec![Vec::new()], ..Formula::zero() }, Formula::zero()],
            BlockColumn::Rotation => {
                let terms = [self.way(c, a), self.offset(c, 0)].concat();
                [Formula { rotation, terms, axis: None }, Formula { rotation: None, terms: vec![to_a], axis: None }]
            }
            BlockColumn::Axis(k) => {
                let axis = Some(Symbol::Axis(c, k));
                let in_body = self.turns_from(c, k + 1).then_some(Factor::AfterTransposed(c, k));
                if self.axes(c)[k].motion == AxisMotion::Translation {
                    return [Formula { rotation, terms: vec![in_body.into_iter().collect()], axis }, Formula::zero()];
                }
                let own = self.offset(c, k + 1).into_iter().filter(|term| !self.lies_along(c, k, term));
                let turned = |term: Vec<Factor>| term.into_iter().chain(in_body).collect();
                let terms = self.way(c, a).into_iter().chain(own).map(turned).collect();
                [Formula { rotation, terms, axis }, Formula { rotation: None, terms: vec![turned(to_a)], axis }]
            }
        }
    }

    /// The meaning of the columns of c's joint, in LaTeX (eq. 44b).
    fn column_labels(&self, c: usize) -> Vec<String> {
        let label = |column| match column {
            BlockColumn::Translation => self.x_dot(c),
            BlockColumn::Rotation => self.vector(Symbol::Omega(c, self.node(c).parent)),
            BlockColumn::Axis(k) => self.rate(c, k),
        };
        self.columns(c).into_iter().map(label).collect()
    }

    fn x_dot(&self, body: usize) -> String {
        format!(r"\dot{{x}}_C^{{({})}}", self.body(body))
    }

    /// Every matrix, in the order of the theory. B of M*, N* and F* has the columns of the free
    /// coordinates; J_r are the inertias of rotors, and q_g the prescribed coordinates.
    pub fn matrices(&self) -> Vec<SymbolicMatrix> {
        let bodies = 0..self.model.bodies.len();
        let omega = |a: usize| self.vector(Symbol::Omega(a, None));
        let rows: Vec<String> = bodies.clone().flat_map(|a| [self.x_dot(a), omega(a)]).collect();
        let columns: Vec<String> = bodies.clone().flat_map(|c| self.column_labels(c)).collect();
        let by_blocks = |name, symbol, equation, matrix: BlockMatrix| {
            let row = |row: &Vec<Formula>| row.iter().map(|block| block.latex(self)).collect();
            let blocks = matrix.blocks.iter().map(row).collect();
            SymbolicMatrix { rows: rows.clone(), columns: columns.clone(), blocks, ..one(name, symbol, equation, "") }
        };
        let diagonal = |name, symbol, equation, entry: &dyn Fn(usize) -> [String; 2]| {
            let entries: Vec<String> = bodies.clone().flat_map(entry).collect();
            let block = |i: usize, j: usize| if i == j { entries[i].clone() } else { "0".to_owned() };
            let blocks = (0..entries.len()).map(|i| (0..entries.len()).map(|j| block(i, j)).collect()).collect();
            SymbolicMatrix { rows: rows.clone(), columns: rows.clone(), blocks, ..one(name, symbol, equation, "") }
        };
        let list = |name, symbol, equation, labels: Vec<String>, entries: &[String]| {
            let blocks = entries.iter().map(|entry| vec![entry.clone()]).collect();
            SymbolicMatrix { rows: labels, blocks, ..one(name, symbol, equation, "") }
        };
        let mut all: Vec<SymbolicMatrix> = bodies.clone().map(|a| self.frame(a)).collect();
        all.push(list("q_dot", r"\{\dot{q}\}", "44b", columns.clone(), &columns));
        all.push(list("X_dot", r"\{\dot{X}\}", "44a", rows.clone(), &rows));
        all.push(by_blocks("B", "[B]", "46", self.b()));
        all.push(by_blocks("B_dot", r"[\dot{B}]", "60b", self.b_dot()));
        let mass = |a: usize| [format!("m^{{({})}} I", self.body(a)), format!("J_C^{{({})}}", self.body(a))];
        all.push(diagonal("M", "[M]", "48", &mass));
        all.push(diagonal("D", "[D]", "57", &|a| ["0".to_owned(), format!("S({})", omega(a))]));
        let loads: Vec<String> = bodies.clone().flat_map(|a| self.loads_on(a)).collect();
        all.push(list("F", r"\{F\}", "59", rows.clone(), &loads));
        let rotors = self.model.rotor_inertia.iter().any(|inertia| *inertia != 0.0);
        let rotors = if rotors { r" + \mathrm{diag}(J_r)" } else { "" };
        all.push(one("M_star", "[M^*]", "60a", &format!("[B]^T [M] [B]{rotors}")));
        all.push(one("N_star", "[N^*]", "60b", r"[B]^T \left( [M] [\dot{B}] + [D] [M] [B] \right)"));
        let given = match self.model.modes.contains(&MotionType::Prescribed) {
            true => {
                r"\left( \{F\} - [M] ([B] \{\ddot{q}_g\} + [\dot{B}] \{\dot{q}_g\}) - [D] [M] [B] \{\dot{q}_g\} \right)"
            }
            false => r"\{F\}",
        };
        all.push(one("F_star", r"\{F^*\}", "60c", &format!("[B]^T {given}")));
        all
    }

    /// E of a body relative to its parent: translate, rotate and slide by each axis, translate (before eq. 36); for a
    /// floating body, as a whole.
    fn frame(&self, a: usize) -> SymbolicMatrix {
        let step = |rotation: &str, position: &str| {
            format!(r"\begin{{bmatrix}} {rotation} & {position} \\ 0^T & 1 \end{{bmatrix}}")
        };
        let body = &self.model.bodies[a].name;
        let (turn, (name, symbol, equation)) = match self.node(a).parent {
            Some(p) => {
                let name = format!("E_{body}/{}", self.model.bodies[p].name);
                (self.relative_rotation(a, p), (name, format!("E^{{({}/{})}}", self.body(a), self.body(p)), "24"))
            }
            None => (self.rotation(a), (format!("E_{body}"), format!("E^{{({})}}", self.body(a)), "20")),
        };
        if let JointKind::Floating(_) = self.node(a).kind {
            return one(&name, &symbol, equation, &step(&turn, &format!("x_C^{{({})}}", self.body(a))));
        }
        let mut steps = vec![step("I", &self.vector(Symbol::ToJoint(a)))];
        match (self.axes(a).len(), self.turns_from(a, 0)) {
            (2.., _) => steps.extend((0..self.axes(a).len()).map(|k| match self.axes(a)[k].motion {
                AxisMotion::Rotation => {
                    step(&format!("R(q_{{{}}}, {})", self.coordinate(a, k), self.vector(Symbol::Axis(a, k))), "0")
                }
                AxisMotion::Translation => step("I", &self.vector(Symbol::Extension(a, k))),
            })),
            (1, false) => steps.push(step(&turn, &format!("{turn} {}", self.vector(Symbol::Extension(a, 0))))),
            _ => steps.push(step(&turn, "0")),
        }
        steps.push(step("I", &self.vector(Symbol::ToCentre(a))));
        one(&name, &symbol, equation, &steps.join(" "))
    }

    /// Force (world) and moment (body axes) on a body (eq. 59): from outside, from the drive in its joint, and back
    /// from the drives in the joints that it carries. For joints of several axes F_J^(a/p) and M_J^(a/p) are the loads
    /// of their drives on a, from p.
    fn loads_on(&self, a: usize) -> [String; 2] {
        let mut loads = [format!("F^{{({})}}", self.body(a)), format!("M^{{({})}}", self.body(a))];
        let mut add = |linear: String, angular: String| {
            loads[0] += &linear;
            loads[1] += &angular;
        };
        for (c, node) in self.model.tree.nodes.iter().enumerate() {
            let (own, carried) = (c == a, node.parent == Some(a));
            if !(own || carried) || matches!(node.kind, JointKind::Floating(_) | JointKind::Fixed(_)) {
                continue;
            }
            if self.axes(c).len() != 1 {
                let other = if own { node.parent.map_or("0", |p| self.body(p)) } else { self.body(c) };
                let wrench = |what: &str| format!(" + {what}_J^{{({}/{other})}}", self.body(a));
                add(wrench("F"), wrench("M"));
                continue;
            }
            let along = format!(r"\tau_{{{}}}", self.coordinate(c, 0));
            let axis = self.vector(Symbol::Axis(c, 0));
            let in_parent = format!("{} {axis}", self.relative_rotation(c, a));
            let slides = !self.turns_from(c, 0);
            let lever = self.vector(if own { Symbol::ToCentre(c) } else { Symbol::ToJoint(c) });
            match (slides, own) {
                (false, true) => add(String::new(), format!(" + {along} {axis}")),
                (false, false) => add(String::new(), format!(" - {along} {in_parent}")),
                (true, true) => {
                    add(format!(" + {along} {} {axis}", self.rotation(c)), format!(" - {along} S({lever}) {axis}"));
                }
                (true, false) => {
                    add(
                        format!(" - {along} {} {axis}", self.rotation(c)),
                        format!(" - {along} S({lever}) {in_parent}"),
                    );
                }
            }
        }
        loads
    }
}

/// A matrix as one formula.
fn one(name: &str, symbol: &str, equation: &'static str, formula: &str) -> SymbolicMatrix {
    SymbolicMatrix {
        name: name.to_owned(),
        symbol: symbol.to_owned(),
        equation,
        rows: vec![String::new()],
        columns: vec![String::new()],
        blocks: vec![vec![formula.to_owned()]],
    }
}
