//! Thrust allocation: how the thrusters share a force and a moment.

use super::thruster::{Thrust, Thruster};
use crate::scalar::Scalar;
use crate::spatial::Symmetric3;

/// Thrusters, and the allocation of a demanded force and moment to them.
///
/// With f all components of thrust (an azimuth has two: the extended thrust), the force along x and y and the moment
/// about z at the held point are tau = B f. Of all f with B f = tau, the allocation takes the one with the smallest
/// weighted sum of squared utilisations f^T W f, with w = weight / T_max^2:
///
/// ```text
/// f = W^-1 B^T (B W^-1 B^T)^-1 tau
/// ```
///
/// (Fossen, *Handbook of Marine Craft Hydrodynamics and Motion Control*, 2011, sec. 12.3.2). If that exceeds a
/// thruster's limit, the demand is scaled down until no thruster exceeds its limit: either force and moment by the same
/// factor, or the moment first and then the force, in its direction, with the remaining capacity. The demand is not
/// redistributed to thrusters with remaining capacity.
#[derive(Clone, Debug)]
pub struct Allocation<S = f64> {
    thrusters: Vec<Thruster<S>>,
    /// Rows of the pseudo-inverse, two for each thruster.
    shares: Vec<[[S; 3]; 2]>,
    /// Whether the yaw moment is given first.
    heading_first: bool,
}

/// Thrusters that cannot give every force and moment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CannotGive(pub &'static str);

/// Smallest determinant of B W^-1 B^T, with its diagonal scaled to 1, at which thrusters count as independent in surge,
/// sway and yaw.
const LEAST_DETERMINANT: f64 = 1e-9;

impl<S: Scalar> Allocation<S> {
    /// Returns the allocation for these thrusters.
    ///
    /// # Errors
    /// Thrusters that do not give surge, sway and yaw independently.
    pub fn new(thrusters: Vec<Thruster<S>>, heading_first: bool) -> Result<Self, CannotGive> {
        let columns: Vec<[[S; 3]; 2]> = thrusters.iter().map(columns).collect();
        let inverse_weight = |thruster: &Thruster<S>| thruster.limit() * thruster.limit() / thruster.weight;
        let weights: Vec<S> = thrusters.iter().map(inverse_weight).collect();
        let sum = |i: usize, j: usize| {
            let of = |(columns, weight): (&[[S; 3]; 2], &S)| {
                *weight * (columns[0][i] * columns[0][j] + columns[1][i] * columns[1][j])
            };
            columns.iter().zip(&weights).map(of).fold(S::ZERO, |sum, next| sum + next)
        };
        let gram =
            Symmetric3 { xx: sum(0, 0), xy: sum(0, 1), xz: sum(0, 2), yy: sum(1, 1), yz: sum(1, 2), zz: sum(2, 2) };
        check_rank(&gram.values())?;
        let inverse = gram.inverse().to_matrix();
        let row = |column: [S; 3], weight: S| {
            core::array::from_fn(|j| weight * (0..3).fold(S::ZERO, |sum, i| sum + column[i] * inverse.0[i][j]))
        };
        let shares = columns.iter().zip(&weights).map(|(pair, weight)| pair.map(|column| row(column, *weight)));
        Ok(Self { shares: shares.collect(), thrusters, heading_first })
    }

    /// Returns the thrusters.
    pub fn thrusters(&self) -> &[Thruster<S>] {
        &self.thrusters
    }

    /// Returns the number of components of thrust.
    pub fn components(&self) -> usize {
        self.thrusters.iter().map(Thruster::components).sum()
    }

    /// Returns the thrust of one thruster for a force (N) and moment (N m), without limits.
    pub fn thrust(&self, thruster: usize, demand: [S; 3]) -> Thrust<S> {
        self.shares[thruster].map(|row| row[0] * demand[0] + row[1] * demand[1] + row[2] * demand[2])
    }

    /// Returns the part of a demand that the thrusters can give. For this part, [`thrust`](Self::thrust) returns the
    /// thrust of each.
    pub fn limited(&self, demand: [S; 3]) -> [S; 3] {
        let [x, y, moment] = demand;
        let none = [S::ZERO; 3];
        if !self.heading_first {
            let share = self.room(none, demand);
            return demand.map(|entry| entry * share);
        }
        let turning = [S::ZERO, S::ZERO, moment * self.room(none, [S::ZERO, S::ZERO, moment])];
        let share = self.room(turning, [x, y, S::ZERO]);
        [x * share, y * share, turning[2]]
    }

    /// Returns the largest share of `more` that can be added to `base` within the limits of all thrusters.
    fn room(&self, base: [S; 3], more: [S; 3]) -> S {
        let of = |(i, thruster): (usize, &Thruster<S>)| thruster.room(self.thrust(i, base), self.thrust(i, more));
        let least = |least: S, next: S| next.select_less(least, || next, || least);
        self.thrusters.iter().enumerate().map(of).fold(S::ONE, least)
    }
}

/// Returns the columns of the thrust configuration matrix for one thruster: force along x, force along y and moment
/// about z, for unit thrust along each of its directions.
fn columns<S: Scalar>(thruster: &Thruster<S>) -> [[S; 3]; 2] {
    let [x, y, _] = thruster.position.0;
    thruster.directions().map(|[along, aside]| [along, aside, x * aside - y * along])
}

/// Lever arms (m) and shares of the force below this count as 0.
const NEGLIGIBLE: f64 = 1e-6;

/// Returns an error unless the thrusters give surge, sway and yaw independently.
fn check_rank(gram: &Symmetric3<f64>) -> Result<(), CannotGive> {
    let diagonal = [gram.xx, gram.yy, gram.zz];
    let least = NEGLIGIBLE * NEGLIGIBLE * (gram.xx + gram.yy);
    let named = ["no force along the ship", "no force athwartships", "no yaw moment"];
    if let Some((name, _)) = named.iter().zip(diagonal).find(|(_, entry)| entry.is_nan() || *entry <= least) {
        return Err(CannotGive(name));
    }
    let over = |entry: f64, i: usize, j: usize| entry / libm::sqrt(diagonal[i] * diagonal[j]);
    let (a, b, c) = (over(gram.xy, 0, 1), over(gram.xz, 0, 2), over(gram.yz, 1, 2));
    let determinant = 1.0 + 2.0 * a * b * c - a * a - b * b - c * c;
    if determinant > LEAST_DETERMINANT { Ok(()) } else { Err(CannotGive("surge, sway and yaw, but not independently")) }
}
