//! Fields of an input shaper.

use kingpost_derive::fields;

use crate::scenario::leaf::Leaf;
use crate::scenario::schema::{Fraction, Positive, SetsInputs, SignalName, yes};

/// Sets an input to its command convolved with two or three impulses, so that the command excites no residual swing of
/// the stated period and damping.
#[fields]
pub struct InputShaper<S = f64> {
    /// Whether the shaper acts; if not, its command passes unchanged.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The input that it sets: of a drive, or the command of another controller.
    pub to: SignalName,
    /// The impulses; with `none`, the command passes unchanged.
    #[serde(default)]
    pub shaper: ShaperKind,
    /// Period of the swing, between two maxima, s.
    pub period_s: Positive<S>,
    /// Damping ratio of the swing, below 1.
    #[serde(default = "undamped::<S>")]
    pub damping_ratio: Fraction<S>,
    /// For ei: the residual swing at the period, as a share of the swing without a shaper.
    #[serde(default = "tolerance::<S>")]
    pub tolerance: Fraction<S>,
}

/// The impulses of an input shaper.
#[fields]
#[derive(Copy, Default, Eq)]
pub enum ShaperKind {
    /// The command passes unchanged.
    None,
    /// Two impulses: no residual swing at the period. The command lasts half a period longer.
    Zv,
    /// Three impulses: no residual swing at the period, and little near it. The command lasts one period longer.
    #[default]
    Zvd,
    /// Three impulses: a stated residual swing at the period, and at most about that swing in a wider band. The command
    /// lasts one period longer.
    Ei,
}

fn undamped<S: Leaf>() -> Fraction<S> {
    Fraction::literal(0.0)
}

fn tolerance<S: Leaf>() -> Fraction<S> {
    Fraction::literal(0.05)
}

impl<S> SetsInputs for InputShaper<S> {
    fn targets(&self) -> Vec<(String, &str)> {
        vec![("to".to_owned(), &*self.to)]
    }
}
