//! Formulas of 3x3 and 3x1 blocks in the paper's notation: as LaTeX, and as numbers at a state.
//!
//! A block is `R (T1 + T2 + ...) e`, where the terms are products of rotation matrices between two frames, skew
//! matrices S(.) of vectors, and their transposes. Each symbol also has a value, so a test compares every formula with
//! the block that the engine computes.

use super::MovingFrame;
use super::blocks::omega_of;
use super::factors::{Factor, Symbol};
use super::symbols::Symbols;
use crate::model::AxisMotion;
use crate::spatial::{Frame, Matrix3, Vector3, hat};
use nalgebra::DMatrix;

/// A 3x3 block, or a 3x1 block if it ends with an axis.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Formula {
    /// The leading R, of this body.
    pub rotation: Option<usize>,
    /// The sum in the middle; without terms the block is zero, a term without factors is the identity.
    pub terms: Vec<Vec<Factor>>,
    /// The axis at the end.
    pub axis: Option<Symbol>,
}

/// A state and its matrices, from which formulas take their values.
#[derive(Clone, Copy)]
pub struct Instant<'a> {
    /// Positions.
    pub q: &'a [f64],
    /// Velocities.
    pub v: &'a [f64],
    /// The matrices at both.
    pub matrices: &'a MovingFrame,
}

impl Formula {
    /// A block of zeros.
    pub fn zero() -> Self {
        Self { rotation: None, terms: Vec::new(), axis: None }
    }

    /// The rate by the product rule, with R' = R S(omega) (eq. 62).
    pub(super) fn rate(&self, symbols: &Symbols<'_>) -> Self {
        let mut terms = Vec::new();
        if let Some(body) = self.rotation.filter(|&body| symbols.turns(body, None)) {
            let skew = Factor::Skew(Symbol::Omega(body, None));
            terms.extend(self.terms.iter().map(|term| [&[skew], term.as_slice()].concat()));
        }
        for term in &self.terms {
            for (i, factor) in term.iter().enumerate() {
                if let Some(rate) = factor.rate(symbols) {
                    terms.push([&term[..i], &rate, &term[i + 1..]].concat());
                }
            }
        }
        Self { terms, ..self.clone() }
    }

    /// The formula in LaTeX.
    pub(super) fn latex(&self, symbols: &Symbols<'_>) -> String {
        if self.terms.is_empty() {
            return "0".to_owned();
        }
        let product = |term: &Vec<Factor>| term.iter().map(|f| f.latex(symbols)).collect::<Vec<_>>().join(" ");
        let sum = self.terms.iter().map(product).collect::<Vec<_>>().join(" + ");
        let first = self.rotation.map_or(String::new(), |body| symbols.rotation(body));
        let last = self.axis.map_or(String::new(), |axis| symbols.vector(axis));
        let alone = first.is_empty() && last.is_empty();
        let between = match (self.terms.len(), alone) {
            (1, true) if sum.is_empty() => "I".to_owned(),
            (1, _) | (_, true) => sum,
            _ => format!(r"\left( {sum} \right)"),
        };
        [first, between, last].into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join(" ")
    }

    /// The block's value at a state, 3x3 or 3x1.
    pub(super) fn value(&self, symbols: &Symbols<'_>, at: Instant<'_>) -> DMatrix<f64> {
        let product =
            |term: &Vec<Factor>| term.iter().fold(Matrix3::identity(), |all, factor| all * factor.value(symbols, at));
        let sum = self.terms.iter().fold(Matrix3::zero(), |sum, term| sum + product(term));
        let all = self.rotation.map_or(sum, |body| at.matrices.frames[body].rotation * sum);
        match self.axis {
            Some(axis) => DMatrix::from_column_slice(3, 1, &(all * axis.value(symbols, at)).0),
            None => DMatrix::from_fn(3, 3, |i, j| all.0[i][j]),
        }
    }
}

impl Factor {
    /// The factors that replace it in the product rule; `None` for a constant.
    fn rate(self, symbols: &Symbols<'_>) -> Option<Vec<Self>> {
        let omega = |a, c| Symbol::Omega(a, Some(c));
        match self {
            Self::Rotation(a, c) if symbols.turns(a, Some(c)) => Some(vec![self, Self::Skew(omega(a, c))]),
            Self::RotationTransposed(a, c) if symbols.turns(a, Some(c)) => {
                Some(vec![Self::SkewTransposed(omega(a, c)), self])
            }
            Self::After(a, k) => Some(vec![self, Self::Skew(Symbol::OmegaAfter(a, k))]),
            Self::AfterTransposed(a, k) => Some(vec![Self::SkewTransposed(Symbol::OmegaAfter(a, k)), self]),
            Self::SkewTransposed(Symbol::Extension(a, k)) => {
                Some(vec![Self::SkewTransposed(Symbol::ExtensionRate(a, k))])
            }
            _ => None,
        }
    }

    fn latex(self, symbols: &Symbols<'_>) -> String {
        match self {
            Self::Rotation(a, c) => symbols.relative_rotation(a, c),
            Self::RotationTransposed(a, c) => format!("({})^T", symbols.relative_rotation(a, c)),
            Self::After(a, k) => symbols.rotation_after(a, k),
            Self::AfterTransposed(a, k) => format!("({})^T", symbols.rotation_after(a, k)),
            Self::Skew(symbol) => format!("S({})", symbols.vector(symbol)),
            Self::SkewTransposed(symbol) => format!("S({})^T", symbols.vector(symbol)),
        }
    }

    fn value(self, symbols: &Symbols<'_>, at: Instant<'_>) -> Matrix3 {
        let frames = &at.matrices.frames;
        match self {
            Self::Rotation(a, c) => frames[c].rotation.transpose() * frames[a].rotation,
            Self::RotationTransposed(a, c) => frames[a].rotation.transpose() * frames[c].rotation,
            Self::After(a, k) => rotation_after(symbols, at, a, k),
            Self::AfterTransposed(a, k) => rotation_after(symbols, at, a, k).transpose(),
            Self::Skew(symbol) => hat(symbol.value(symbols, at)),
            Self::SkewTransposed(symbol) => hat(symbol.value(symbols, at)).transpose(),
        }
    }
}

/// The product of the rotations of a joint's axes after axis k.
fn rotation_after(symbols: &Symbols<'_>, at: Instant<'_>, body: usize, k: usize) -> Matrix3 {
    let q = &at.q[symbols.node(body).positions..];
    let frames = symbols.axes(body).iter().zip(q).skip(k + 1).map(|(axis, q)| axis.frame(*q));
    frames.fold(Frame::identity(), |all, frame| all.times(&frame)).rotation
}

impl Symbol {
    /// The vector at a state, in the axes that its definition names.
    fn value(self, symbols: &Symbols<'_>, at: Instant<'_>) -> Vector3 {
        let (frames, x_dot) = (&at.matrices.frames, &at.matrices.x_dot);
        let along = |a: usize, k: usize, amount: f64| symbols.axes(a)[k].direction * amount;
        match self {
            Self::ToJoint(a) => symbols.to_joint(a),
            Self::ToCentre(a) => symbols.node(a).kind.to_child(),
            Self::CentreToCentre(a) => at.matrices.relative[a].position,
            Self::Extension(a, k) => along(a, k, at.q[symbols.node(a).positions + k]),
            Self::ExtensionRate(a, k) => along(a, k, at.v[symbols.node(a).velocities + k]),
            Self::Omega(a, None) => omega_of(x_dot, a),
            Self::Omega(a, Some(c)) => {
                let in_world = frames[c].rotation * omega_of(x_dot, c);
                omega_of(x_dot, a) - frames[a].rotation.transpose_times(in_world)
            }
            Self::OmegaAfter(a, k) => {
                let v = &at.v[symbols.node(a).velocities..];
                let turning = |i: &usize| symbols.axes(a)[*i].motion == AxisMotion::Rotation;
                let part = |i: usize| rotation_after(symbols, at, a, i).transpose_times(along(a, i, v[i]));
                (k + 1..symbols.axes(a).len()).filter(turning).fold(Vector3::zero(), |sum, i| sum + part(i))
            }
            Self::Axis(a, k) => along(a, k, 1.0),
        }
    }
}
