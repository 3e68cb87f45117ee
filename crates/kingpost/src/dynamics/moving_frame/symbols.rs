//! The paper's symbols for the bodies and joints of a model.

use super::factors::{Factor, Symbol};
use crate::model::joint::ElementaryAxis;
use crate::model::{AxisMotion, JointKind, Model, Node};
use crate::spatial::Vector3;

/// The names of bodies in formulas.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Naming {
    /// By number from 1, as in the paper: `R^{(2/1)}`.
    Numbers,
    /// By name: `R^{(\mathrm{tower}/\mathrm{ship})}`.
    Names,
}

/// A model's symbols, with the joint data for the formulas.
///
/// Joints are numbered as in the paper, by the body that carries them: J_1 carries body 2. If a body carries several
/// joints, the carried body is added. Frames within the joint of body 2 are 2_1 after its first axis, 2_2 after its
/// second.
pub struct Symbols<'a> {
    pub(super) model: &'a Model,
    bodies: Vec<String>,
    axes: Vec<Vec<ElementaryAxis>>,
    to_joint: Vec<Vector3>,
}

/// A vector counts as zero, or as parallel to an axis, within this share of its length.
const ROUNDING: f64 = 1e-12;

impl<'a> Symbols<'a> {
    /// The symbols of a model.
    pub fn new(model: &'a Model, naming: Naming) -> Self {
        let name = |(i, body): (usize, &crate::model::Body)| match naming {
            Naming::Numbers => (i + 1).to_string(),
            Naming::Names => roman(&body.name),
        };
        let kinds = || model.tree.nodes.iter().map(|node| &node.kind);
        Self {
            model,
            bodies: model.bodies.iter().enumerate().map(name).collect(),
            axes: kinds().map(axes_of).collect(),
            to_joint: kinds().map(to_joint).collect(),
        }
    }

    /// The body's number or name.
    pub(super) fn body(&self, body: usize) -> &str {
        &self.bodies[body]
    }

    pub(super) fn node(&self, body: usize) -> &Node {
        &self.model.tree.nodes[body]
    }

    /// The axes of the body's joint, from the parent to the body; empty if it is not made of axes.
    pub(super) fn axes(&self, body: usize) -> &[ElementaryAxis] {
        &self.axes[body]
    }

    /// s_J of the body's joint, parent axes, m.
    pub(super) fn to_joint(&self, body: usize) -> Vector3 {
        self.to_joint[body]
    }

    /// Whether the body can turn relative to one of its ancestors, or to the world.
    pub(super) fn turns(&self, body: usize, against: Option<usize>) -> bool {
        let rotates = |b: usize| self.node(b).kind.quaternion().is_some() || self.turns_from(b, 0);
        self.path(body).take_while(|b| Some(*b) != against).any(rotates)
    }

    /// Whether an axis of the body's joint, from axis k on, is one of rotation.
    pub(super) fn turns_from(&self, body: usize, k: usize) -> bool {
        self.axes(body).iter().skip(k).any(|axis| axis.motion == AxisMotion::Rotation)
    }

    /// The body and those before it, up to the world.
    pub(super) fn path(&self, body: usize) -> impl Iterator<Item = usize> + '_ {
        core::iter::successors(Some(body), |b| self.node(*b).parent)
    }

    /// The vector from c's centre of mass to a's in axes of c, as skew matrices to sum (eqs. 37, 43), the far end first
    /// as in the paper. If the joint does not change it (eq. 16) it is one vector; otherwise it goes to the joint, and
    /// from there to the centre.
    pub(super) fn way(&self, c: usize, a: usize) -> Vec<Vec<Factor>> {
        let mut terms = Vec::new();
        for body in self.path(a).take_while(|b| *b != c) {
            let parent = self.node(body).parent.expect("c is on the way to the world");
            if self.keeps_centre(body) {
                terms.push(turned(parent, c, vec![Factor::SkewTransposed(Symbol::CentreToCentre(body))]));
                continue;
            }
            terms.extend(self.offset(body, 0).into_iter().map(|term| turned(body, c, term)));
            if !is_small(self.to_joint(body), 1.0) {
                terms.push(turned(parent, c, vec![Factor::SkewTransposed(Symbol::ToJoint(body))]));
            }
        }
        terms
    }

    /// The vector from the frame before axis k of the body's joint to its centre of mass, body axes, as skew matrices
    /// to sum: s_C and the displacements of the axes.
    pub(super) fn offset(&self, body: usize, k: usize) -> Vec<Vec<Factor>> {
        let mut terms = Vec::new();
        if !is_small(self.node(body).kind.to_child(), 1.0) {
            terms.push(vec![Factor::SkewTransposed(Symbol::ToCentre(body))]);
        }
        for j in (k..self.axes(body).len()).rev() {
            if self.axes(body)[j].motion == AxisMotion::Translation {
                let skew = Factor::SkewTransposed(Symbol::Extension(body, j));
                terms.push(match self.turns_from(body, j + 1) {
                    true => vec![Factor::AfterTransposed(body, j), skew, Factor::After(body, j)],
                    false => vec![skew],
                });
            }
        }
        terms
    }

    /// Whether a term of the body's offset lies along axis k of its joint, and so gives no rate.
    pub(super) fn lies_along(&self, body: usize, k: usize, term: &[Factor]) -> bool {
        let along = |v: Vector3| is_small(self.axes(body)[k].direction.cross(v), v.norm());
        match term {
            _ if self.turns_from(body, k + 1) => false,
            [Factor::SkewTransposed(Symbol::ToCentre(_))] => along(self.node(body).kind.to_child()),
            [Factor::SkewTransposed(Symbol::Extension(_, j))] => along(self.axes(body)[*j].direction),
            _ => false,
        }
    }

    /// Whether the vector from the parent's centre to the body's is constant in the parent's axes.
    fn keeps_centre(&self, body: usize) -> bool {
        let offset = self.offset(body, 0);
        match (&self.node(body).kind, self.axes(body).len()) {
            (JointKind::Fixed(_), _) => true,
            (_, 1) => self.turns_from(body, 0) && offset.iter().all(|term| self.lies_along(body, 0, term)),
            _ => false,
        }
    }

    /// R^(a), as the product of relative rotation matrices that makes it (eq. 13).
    pub(super) fn rotation(&self, body: usize) -> String {
        let step = |b: usize| match self.node(b).parent {
            Some(parent) => self.relative_rotation(b, parent),
            None => format!("R^{{({})}}", self.body(b)),
        };
        let mut factors: Vec<String> = self.path(body).map(step).collect();
        factors.reverse();
        factors.join(" ")
    }

    pub(super) fn relative_rotation(&self, a: usize, c: usize) -> String {
        format!("R^{{({}/{})}}", self.body(a), self.body(c))
    }

    pub(super) fn rotation_after(&self, body: usize, k: usize) -> String {
        format!("R^{{({})}}", self.frame_after(body, k))
    }

    /// `2/2_{1}`: body 2 relative to the frame after the first axis of its joint.
    fn frame_after(&self, body: usize, k: usize) -> String {
        let name = self.body(body);
        format!("{name}/{name}_{{{}}}", k + 1)
    }

    /// A vector in LaTeX.
    pub(super) fn vector(&self, symbol: Symbol) -> String {
        match symbol {
            Symbol::ToJoint(b) => format!("s_{{J_{{{}}}}}", self.joint(b)),
            Symbol::ToCentre(b) => format!("s_{{C_{{{}}}}}", self.body(b)),
            Symbol::CentreToCentre(b) => match self.node(b).parent {
                Some(parent) => format!("s_{{C({}/{})}}", self.body(b), self.body(parent)),
                None => format!("s_{{C({})}}", self.body(b)),
            },
            Symbol::Extension(b, k) => format!("q_{{{}}} {}", self.coordinate(b, k), self.axis(b, k)),
            Symbol::ExtensionRate(b, k) => format!("{} {}", self.rate(b, k), self.axis(b, k)),
            Symbol::Omega(b, None) => format!(r"\omega^{{({})}}", self.body(b)),
            Symbol::Omega(b, Some(c)) => format!(r"\omega^{{({}/{})}}", self.body(b), self.body(c)),
            Symbol::OmegaAfter(b, k) => format!(r"\omega^{{({})}}", self.frame_after(b, k)),
            Symbol::Axis(b, k) => self.axis(b, k),
        }
    }

    /// A coordinate's name in LaTeX.
    pub(super) fn coordinate(&self, body: usize, k: usize) -> String {
        roman(&self.model.joints[body].coordinate_names()[k])
    }

    /// A coordinate's rate in LaTeX.
    pub(super) fn rate(&self, body: usize, k: usize) -> String {
        format!(r"\dot{{q}}_{{{}}}", self.coordinate(body, k))
    }

    fn joint(&self, body: usize) -> String {
        let parent = self.node(body).parent;
        let siblings = self.model.tree.nodes.iter().filter(|node| node.parent == parent).count();
        let on = parent.map_or("0", |p| self.body(p));
        if siblings == 1 { on.to_owned() } else { format!("{on},{}", self.body(body)) }
    }

    /// e_x, e_y, e_z for an axis along one of the frame's, else a symbol of its own.
    fn axis(&self, body: usize, k: usize) -> String {
        let axis = self.axes(body)[k].direction;
        for (i, name) in ["x", "y", "z"].into_iter().enumerate() {
            let unit = Vector3(core::array::from_fn(|j| if i == j { 1.0 } else { 0.0 }));
            if is_small(axis - unit, 1.0) {
                return format!("e_{name}");
            }
            if is_small(axis + unit, 1.0) {
                return format!("(-e_{name})");
            }
        }
        format!("e_{{{}}}", self.coordinate(body, k))
    }
}

fn axes_of(kind: &JointKind) -> Vec<ElementaryAxis> {
    match kind {
        JointKind::Revolute(joint) => vec![ElementaryAxis::rotation(joint.axis())],
        JointKind::Prismatic(joint) => vec![ElementaryAxis::translation(joint.axis())],
        JointKind::AxisList(list) => list.axes().to_vec(),
        JointKind::Floating(_) | JointKind::Spherical(_) | JointKind::Fixed(_) => Vec::new(),
    }
}

/// s_J of a joint, from the position of the child's centre of mass with all coordinates at zero.
fn to_joint(kind: &JointKind) -> Vector3 {
    let mut q = [0.0; 7];
    if let Some((w, _)) = kind.quaternion() {
        q[w] = 1.0;
    }
    let relative = kind.relative(&q);
    relative.position - relative.rotation * kind.to_child()
}

/// A term in axes of `body`, transformed to axes of c.
fn turned(body: usize, c: usize, term: Vec<Factor>) -> Vec<Factor> {
    if body == c {
        return term;
    }
    let (before, after) = (Factor::Rotation(body, c), Factor::RotationTransposed(body, c));
    [before].into_iter().chain(term).chain([after]).collect()
}

fn is_small(v: Vector3, size: f64) -> bool {
    v.norm() <= ROUNDING * size
}

/// A name in upright letters.
pub(super) fn roman(name: &str) -> String {
    format!(r"\mathrm{{{}}}", name.replace('_', r"\_"))
}
