//! The factors of the products in formulas: rotations, skew matrices, vectors by their symbols.

/// A vector by its symbol; bodies and a joint's axes are given by index.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Symbol {
    /// s_J: from the parent's centre of mass to this body's joint, parent axes.
    ToJoint(usize),
    /// s_C: from the joint to this body's centre of mass, body axes.
    ToCentre(usize),
    /// s_C(a/p) (eq. 16): from the parent's centre of mass to this body's, parent axes.
    CentreToCentre(usize),
    /// q e: the displacement of the body along an axis of its joint, in the frame after that axis.
    Extension(usize, usize),
    /// Its rate.
    ExtensionRate(usize, usize),
    /// omega of the first body relative to the second, or the world, in axes of the first.
    Omega(usize, Option<usize>),
    /// omega of the body relative to the frame after an axis of its joint, body axes.
    OmegaAfter(usize, usize),
    /// e: an axis of the body's joint, in the frame after it.
    Axis(usize, usize),
}

/// One factor of a product.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Factor {
    /// R^(a/c), from axes of a to axes of c.
    Rotation(usize, usize),
    /// Its transpose.
    RotationTransposed(usize, usize),
    /// R from a body's axes to the frame after an axis of its joint.
    After(usize, usize),
    /// Its transpose.
    AfterTransposed(usize, usize),
    /// S(s).
    Skew(Symbol),
    /// S(s)^T.
    SkewTransposed(Symbol),
}
