//! Buoyancy of a hull in any position in still water, exact for its mesh.
//!
//! Every triangle is cut at the water plane. The pressure is linear, so its integral over the wetted part has
//! a closed form. With the height `h = z0 + n . r` (n the vertical in hull axes) and N the outward normal,
//! the divergence theorem over the submerged part needs no waterplane if the integrand vanishes there (as
//! Mirtich, *J. Graphics Tools* 1(2), 1996, 31-50, for whole polyhedra):
//!
//! ```text
//! V = Int h n.N dS,     T = Int r h n.N dS = G + n H,     G = Int_V r dV,     H = Int_V h dV
//! ```
//!
//! and `n . G = H - z0 V` gives `H = (n . T + z0 V) / 2`. The potential energy of the water is
//! `U = -rho g H`; its gradient gives the force `rho g V` along n and the moment `rho g G x n`.

use super::FloatingPosition;
use super::mesh::HullMesh;
use crate::scalar::Scalar;
use crate::spatial::{Vector3, Wrench};

/// Buoyancy of a hull: the water that it displaces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Buoyancy<S = f64> {
    /// Volume V of the submerged part, m^3.
    pub volume: S,
    /// First moment G of the submerged part about the hull's origin, hull axes, m^4.
    pub first_moment: Vector3<S>,
    /// Integral H of the height above the water plane over the submerged part, negative, m^4.
    pub height_moment: S,
    /// Vertical n, hull axes.
    pub vertical: Vector3<S>,
}

impl<S: Scalar> Buoyancy<S> {
    /// Returns force and moment on the hull about its origin, in its axes, N and N m, in water of this
    /// specific weight rho g, N/m^3.
    #[inline]
    pub fn wrench(&self, specific_weight: S) -> Wrench<S> {
        Wrench {
            moment: self.first_moment.cross(self.vertical) * specific_weight,
            force: self.vertical * (self.volume * specific_weight),
        }
    }

    /// Returns `U = -rho g Int_V z dV`, the work of submerging the hull, J; [`wrench`](Self::wrench) is minus
    /// its gradient.
    #[inline]
    pub fn potential_energy(&self, specific_weight: S) -> S {
        -(self.height_moment * specific_weight)
    }

    /// Returns the centre of buoyancy, hull axes, m; NaN for a hull out of the water.
    #[inline]
    pub fn centre(&self) -> Vector3<S> {
        Vector3(self.first_moment.0.map(|moment| moment / self.volume))
    }
}

/// Side of the water's surface on which a vertex is: dry, wet, or mixed if lanes disagree.
pub(super) const DRY: u8 = 0;
pub(super) const WET: u8 = 1;
pub(super) const MIXED: u8 = 4;

/// Returns the side of a vertex at this height; NaN counts as mixed.
#[inline]
pub(super) fn side<S: Scalar>(height: S) -> u8 {
    if height.all(|h| h < 0.0) {
        WET
    } else if height.all(|h| h >= 0.0) {
        DRY
    } else {
        MIXED
    }
}

/// Working memory for one hull, so that an evaluation allocates nothing.
#[derive(Clone, Debug)]
pub struct WettedHull<S = f64> {
    /// Height of each vertex above the water's surface, m.
    pub(super) heights: Vec<S>,
    pub(super) sides: Vec<u8>,
    /// For each vertex, its share in the integrals, or the pressure.
    pub(super) shares: Vec<S>,
    /// For each vertex, whether the water there has been evaluated.
    pub(super) asked: Vec<bool>,
}

impl<S: Scalar> WettedHull<S> {
    /// Creates the memory for this mesh.
    pub fn new(mesh: &HullMesh) -> Self {
        let vertices = mesh.vertices().len();
        let (heights, shares) = (vec![S::ZERO; vertices], vec![S::ZERO; vertices]);
        Self { heights, sides: vec![DRY; vertices], shares, asked: vec![false; vertices] }
    }

    /// Returns the buoyancy of the hull in this position. A position that is not finite gives NaN.
    ///
    /// # Panics
    /// If the memory was made for another mesh.
    pub fn buoyancy(&mut self, mesh: &HullMesh, position: &FloatingPosition<S>) -> Buoyancy<S> {
        let FloatingPosition { height, vertical } = *position;
        self.find_heights(mesh, position);
        self.shares.fill(S::ZERO);
        for triangle in mesh.faces() {
            let corners = triangle.corners.map(|i| i as usize);
            let sides = corners.map(|i| self.sides[i]);
            if sides == [DRY; 3] {
                continue;
            }
            let area_along_vertical = vertical.dot(Vector3::constant(triangle.area.0));
            let shares = corner_shares(sides, corners, &self.heights, &self.heights);
            for (corner, share) in corners.into_iter().zip(shares) {
                self.shares[corner] += area_along_vertical * share;
            }
        }
        // 0, or NaN if the height is not finite.
        let (mut volume, mut moment) = (height * S::ZERO, Vector3::zero());
        for (r, &share) in mesh.vertices().iter().zip(&self.shares) {
            volume += share;
            moment += Vector3::constant(r.0) * share;
        }
        let twelfth = S::constant(1.0 / 12.0);
        let (volume, moment) = (volume * twelfth, moment * twelfth);
        let height_moment = (vertical.dot(moment) + height * volume) * S::constant(0.5);
        Buoyancy { volume, first_moment: moment - vertical * height_moment, height_moment, vertical }
    }

    pub(super) fn find_heights(&mut self, mesh: &HullMesh, position: &FloatingPosition<S>) {
        let vertices = mesh.vertices();
        assert_eq!(vertices.len(), self.heights.len(), "the memory is of another mesh");
        for ((r, height), at) in vertices.iter().zip(&mut self.heights).zip(&mut self.sides) {
            *height = position.height + position.vertical.dot(Vector3::constant(r.0));
            *at = side(*height);
        }
    }
}

/// Returns the shares s of the corners of a triangle: for p and f linear over the triangle, with these values
/// of p at its corners, the integral over the wetted part is `Int p f dS = area / 12 (s_0 f_0 + s_1 f_1 + s_2
/// f_2)`.
///
/// Over a whole triangle `Int p f dS = area / 12 Sum_i (p_i + p_0 + p_1 + p_2) f_i` (from the means of products of
/// barycentric coordinates, 1/12 and 1/6). If the triangle is cut, either the tip at the single corner is wet, or
/// everything except the tip.
#[inline]
pub(super) fn corner_shares<S: Scalar>(sides: [u8; 3], corners: [usize; 3], heights: &[S], p: &[S]) -> [S; 3] {
    let at = |values: &[S], corners: [usize; 3]| corners.map(|i| values[i]);
    match sides[0] + sides[1] + sides[2] {
        0 => [S::ZERO; 3],
        3 => all_wet(at(p, corners)),
        wet @ (1 | 2) => {
            let apex = apex_of(sides);
            let corners = from_corner(apex, corners);
            let (heights, p) = (at(heights, corners), at(p, corners));
            let tip = tip(heights, p);
            from_corner(3 - apex, if wet == 1 { tip } else { all_but(p, tip) })
        }
        _ => lane_by_lane(at(heights, corners), at(p, corners)),
    }
}

/// Returns the corner that is alone on its side.
#[inline]
pub(super) fn apex_of([a, b, c]: [u8; 3]) -> usize {
    usize::from(b != c) * (1 + usize::from(a != c))
}

/// Returns the corners in cyclic order, starting with this one.
#[inline]
pub(super) fn from_corner<T: Copy>(first: usize, corners: [T; 3]) -> [T; 3] {
    [first, first + 1, first + 2].map(|k| corners[k % 3])
}

/// Returns the positions, from 0 to 1, at which the water's surface cuts the edges from the apex, which is
/// the first corner.
#[inline]
pub(super) fn cuts<S: Scalar>([apex, b, c]: [S; 3]) -> [S; 2] {
    [apex / (apex - b), apex / (apex - c)]
}

#[inline]
fn all_wet<S: Scalar>(p: [S; 3]) -> [S; 3] {
    let sum = p[0] + p[1] + p[2];
    p.map(|p| p + sum)
}

#[inline]
fn all_but<S: Scalar>(p: [S; 3], tip: [S; 3]) -> [S; 3] {
    let whole = all_wet(p);
    [whole[0] - tip[0], whole[1] - tip[1], whole[2] - tip[2]]
}

/// Returns the shares of the tip between the first corner and the cuts: a triangle with `b c` of the whole
/// area. The share of a cut point is divided between the corners of its edge.
#[inline]
fn tip<S: Scalar>(heights: [S; 3], [p_a, p_b, p_c]: [S; 3]) -> [S; 3] {
    let [b, c] = cuts(heights);
    let (at_b, at_c) = (p_a + (p_b - p_a) * b, p_a + (p_c - p_a) * c);
    let (part, sum) = (b * c, p_a + at_b + at_c);
    let [at_a, at_b, at_c] = [p_a, at_b, at_c].map(|p| (p + sum) * part);
    [at_a + at_b * (S::ONE - b) + at_c * (S::ONE - c), at_b * b, at_c * c]
}

/// Treats every lane by its own case, so that the result is bitwise identical to that of a run alone.
fn lane_by_lane<S: Scalar>(h: [S; 3], p: [S; 3]) -> [S; 3] {
    let turned = |apex: usize| (from_corner(apex, h), from_corner(apex, p));
    [0, 1, 2].map(|k| {
        let wet = |apex: usize| {
            let (h, p) = turned(apex);
            from_corner(3 - apex, tip(h, p))[k]
        };
        let dry = |apex: usize| {
            let (h, p) = turned(apex);
            from_corner(3 - apex, all_but(p, tip(h, p)))[k]
        };
        let first_wet = || {
            h[1].select_below(
                0.0,
                || h[2].select_below(0.0, || all_wet(p)[k], || dry(2)),
                || h[2].select_below(0.0, || dry(1), || wet(0)),
            )
        };
        let first_dry = || {
            h[1].select_below(
                0.0,
                || h[2].select_below(0.0, || dry(0), || wet(1)),
                || h[2].select_below(0.0, || wet(2), || S::ZERO),
            )
        };
        h[0].select_below(0.0, first_wet, first_dry)
    })
}
