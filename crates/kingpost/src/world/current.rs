//! Current: steady and uniform at each depth.

use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// A current that can vary with depth.
#[derive(Clone, Debug)]
pub struct Current<S = f64> {
    /// Velocity at the surface, world, m/s.
    pub surface: Vector3<S>,
    /// Variation of the velocity with depth.
    pub profile: CurrentProfile<S>,
}

/// Profile of a current over depth.
#[derive(Clone, Debug)]
pub enum CurrentProfile<S = f64> {
    /// Velocity that is the same at all depths.
    Uniform,
    /// Exponent n of the power law U(z) = U ((h + z) / h)^n over the water depth h.
    PowerLaw(S),
    /// Velocities at given depths.
    Table(CurrentTable<S>),
}

/// Velocities at depths that increase from 0, linear between them and constant below the last.
#[derive(Clone, Debug)]
pub struct CurrentTable<S = f64> {
    /// Depths, m.
    pub depths: Vec<f64>,
    /// Velocity at each depth, world, m/s.
    pub velocities: Vec<[S; 2]>,
}

/// The velocity of a current profile that a load uses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CurrentAt<S = f64> {
    /// The velocity at the surface.
    Surface,
    /// The velocity V whose drag V |V| equals the mean drag over this draught, m.
    MeanSquareOver(S),
    /// The mean velocity over this draught, m.
    MeanOver(S),
    /// The velocity at this depth, m.
    Depth(S),
}

impl<S: Scalar> Current<S> {
    /// Returns still water.
    pub fn none() -> Self {
        Self { surface: Vector3::zero(), profile: CurrentProfile::Uniform }
    }

    /// Returns the velocity that a load uses, for a water depth in m; world, m/s.
    pub fn at(&self, place: &CurrentAt<S>, depth: Option<S>) -> Vector3<S> {
        match (&self.profile, depth) {
            (CurrentProfile::PowerLaw(exponent), Some(depth)) => self.surface * share(place, *exponent, depth),
            (CurrentProfile::Table(table), _) => match place {
                CurrentAt::Surface => self.surface,
                CurrentAt::MeanSquareOver(draught) => table.mean_square(*draught),
                CurrentAt::MeanOver(draught) => level(table.mean(*draught, |velocity| velocity)),
                CurrentAt::Depth(depth) => level(table.at(*depth)),
            },
            _ => self.surface,
        }
    }
}

/// Returns the ratio of the velocity that a load uses to the surface velocity, by the power law. Its mean
/// square over the draught T is h / T (1 - (1 - T / h)^(2 n + 1)) / (2 n + 1).
fn share<S: Scalar>(place: &CurrentAt<S>, exponent: S, depth: S) -> S {
    let mean_of_power = |exponent: S, draught: S| {
        let power = exponent + S::ONE;
        let over_part = || (power * (-draught / depth).ln_1p()).exp_m1();
        let left = (depth - draught).select_below(f64::MIN_POSITIVE, || -S::ONE, over_part);
        -left * depth / draught / power
    };
    match place {
        CurrentAt::Surface => S::ONE,
        CurrentAt::MeanSquareOver(draught) => mean_of_power(S::constant(2.0) * exponent, *draught).sqrt(),
        CurrentAt::MeanOver(draught) => mean_of_power(exponent, *draught),
        CurrentAt::Depth(below) => {
            let left = S::ONE - *below / depth;
            left.select_below(f64::MIN_POSITIVE, || S::ZERO, || left.pow(exponent))
        }
    }
}

fn level<S: Scalar>([x, y]: [S; 2]) -> Vector3<S> {
    Vector3::new(x, y, S::ZERO)
}

/// Points and weights of the Gauss-Legendre rule on (0, 1) (Abramowitz & Stegun, table 25.4, n = 4).
const RULE: [(f64, f64); 4] = [
    (0.069_431_844_202_973_71, 0.173_927_422_568_726_93),
    (0.330_009_478_207_571_87, 0.326_072_577_431_273_07),
    (0.669_990_521_792_428_1, 0.326_072_577_431_273_07),
    (0.930_568_155_797_026_3, 0.173_927_422_568_726_93),
];

/// Square of a speed below which the drag is 0, m^2/s^2.
const STILL: f64 = 1e-18;

impl<S: Scalar> CurrentTable<S> {
    /// Returns the velocity at a depth, m.
    fn at(&self, depth: S) -> [S; 2] {
        let rows = self.depths.windows(2).zip(self.velocities.windows(2));
        rows.fold(self.velocities[0], |sum, (depths, velocities)| {
            let share = self.covered(depths, depth) / S::constant(depths[1] - depths[0]);
            core::array::from_fn(|k| sum[k] + (velocities[1][k] - velocities[0][k]) * share)
        })
    }

    /// Returns the length of a row's depth interval that is above a depth, m.
    fn covered(&self, row: &[f64], depth: S) -> S {
        (depth - S::constant(row[0])).clipped(S::ZERO, S::constant(row[1] - row[0]))
    }

    /// Returns the mean of a function of the velocity over a draught, m: exact for polynomials of order 7
    /// between rows.
    fn mean(&self, draught: S, of: impl Fn([S; 2]) -> [S; 2]) -> [S; 2] {
        let mut sum = [S::ZERO; 2];
        let mut add = |velocity: [S; 2], weight: S| {
            let part = of(velocity);
            sum = core::array::from_fn(|k| sum[k] + part[k] * weight);
        };
        for (depths, velocities) in self.depths.windows(2).zip(self.velocities.windows(2)) {
            let (covered, whole) = (self.covered(depths, draught), S::constant(depths[1] - depths[0]));
            for (point, weight) in RULE {
                let share = covered * S::constant(point) / whole;
                let of_row = |k: usize| velocities[0][k] + (velocities[1][k] - velocities[0][k]) * share;
                add(core::array::from_fn(of_row), covered * S::constant(weight));
            }
        }
        let last = self.depths.len() - 1;
        let below = draught - S::constant(self.depths[last]);
        add(self.velocities[last], below.select_below(0.0, || S::ZERO, || below));
        sum.map(|x| x / draught)
    }

    /// Returns V for which `V |V|` is the mean of `U |U|`.
    fn mean_square(&self, draught: S) -> Vector3<S> {
        let size = |[x, y]: [S; 2]| {
            let square = x * x + y * y;
            square.select_below(STILL, || S::ZERO, || square.select_below(STILL, || S::ONE, || square).sqrt())
        };
        let [x, y] = self.mean(draught, |velocity| velocity.map(|component| component * size(velocity)));
        let drag = size([x, y]);
        let root = drag.select_below(STILL, || S::ONE, || drag).sqrt();
        level([x, y].map(|component| drag.select_below(STILL, || S::ZERO, || component / root)))
    }
}
