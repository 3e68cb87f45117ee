//! Part of a box, a cylinder or a sphere below a plane: exact to rounding, in any attitude.

mod cylinder;

use super::wetted::{corner_shares, side};
use crate::scalar::Scalar;
use crate::spatial::Vector3;
use cylinder::CutCylinder;

/// Part of a solid below a plane n . r = l, with the unit vector n in the solid's axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Below<S = f64> {
    /// Volume V, m^3.
    pub volume: S,
    /// First moment G, the integral of r over V, m^4.
    pub first_moment: Vector3<S>,
    /// Area of the section with the plane, m^2: dV/dl.
    pub area: S,
    /// First moment of the section, the integral of r over it, m^3: -dV/dn.
    pub area_moment: Vector3<S>,
}

/// A simple solid about its centre, in its own axes.
///
/// ```
/// use kingpost::sea::hull::Solid;
/// use kingpost::spatial::Vector3;
/// let sphere = Solid::Sphere { radius: 2.0 };
/// let half = sphere.below(Vector3::new(0.0, 0.6, 0.8), 0.0);
/// assert!((half.volume - sphere.volume() / 2.0).abs() < 1e-13);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Solid<S = f64> {
    /// A box with its edges along the axes.
    Box {
        /// Edges along x, y and z, m.
        edges: Vector3<S>,
    },
    /// A circular cylinder along one of the axes.
    Cylinder {
        /// Radius, m.
        radius: S,
        /// Length, m.
        length: S,
        /// Index of the cylinder's axis.
        axis: usize,
    },
    /// A sphere.
    Sphere {
        /// Radius, m.
        radius: S,
    },
}

impl<S: Scalar> Solid<S> {
    /// Returns the volume of the whole solid, m^3.
    pub fn volume(&self) -> S {
        let pi = S::constant(core::f64::consts::PI);
        match *self {
            Self::Box { edges: Vector3([x, y, z]) } => x * y * z,
            Self::Cylinder { radius, length, .. } => pi * radius * radius * length,
            Self::Sphere { radius } => pi * radius * radius * radius * S::constant(4.0 / 3.0),
        }
    }

    /// Returns the projected area along x, y and z, m^2.
    pub fn projected_areas(&self) -> [S; 3] {
        let pi = S::constant(core::f64::consts::PI);
        match *self {
            Self::Box { edges: Vector3([x, y, z]) } => [y * z, x * z, x * y],
            Self::Cylinder { radius, length, axis } => {
                let aside = S::constant(2.0) * radius * length;
                core::array::from_fn(|k| if k == axis { pi * radius * radius } else { aside })
            }
            Self::Sphere { radius } => [pi * radius * radius; 3],
        }
    }

    /// Returns the extent from the centre in the direction of a unit vector, m; in the opposite direction it
    /// is equal.
    pub fn reach(&self, along: Vector3<S>) -> S {
        let size = |x: S| x.select_below(0.0, || -x, || x);
        match *self {
            Self::Box { edges } => (0..3).fold(S::ZERO, |sum, k| sum + size(along[k]) * edges[k]) * S::constant(0.5),
            Self::Cylinder { radius, length, axis } => {
                let mut across = along;
                across[axis] = S::ZERO;
                size(along[axis]) * length * S::constant(0.5) + across.norm() * radius
            }
            Self::Sphere { radius } => radius,
        }
    }

    /// Returns the part below the plane n . r = l.
    pub fn below(&self, vertical: Vector3<S>, level: S) -> Below<S> {
        match *self {
            Self::Box { edges } => Below::of_box(edges, vertical, level),
            Self::Cylinder { radius, length, axis } => CutCylinder { radius, length, axis }.below(vertical, level),
            Self::Sphere { radius } => Below::of_sphere(radius, vertical, level),
        }
    }
}

impl<S: Scalar> Below<S> {
    /// Returns the part of a box about its centre with edges along the axes, m: every triangle is cut by the
    /// plane, as for a [hull](super::WettedHull).
    pub fn of_box(edges: Vector3<S>, vertical: Vector3<S>, level: S) -> Self {
        let corners: [Vector3<S>; 8] = core::array::from_fn(|corner| corner_of(edges, corner));
        let heights = corners.map(|r| vertical.dot(r) - level);
        let sides = heights.map(side);
        let (mut volume, mut moment) = (S::ZERO, Vector3::zero());
        let (mut area, mut area_moment) = (S::ZERO, Vector3::zero());
        for (axis, triangle) in triangles() {
            let outward = if triangle[0] >> axis & 1 == 1 { 0.5 } else { -0.5 };
            let size = edges[(axis + 1) % 3] * edges[(axis + 2) % 3] * S::constant(outward / 12.0);
            let along_vertical = vertical[axis] * size;
            let sides = triangle.map(|corner| sides[corner]);
            let shares = corner_shares(sides, triangle, &heights, &heights);
            for (corner, share) in triangle.into_iter().zip(shares) {
                volume += along_vertical * share;
                moment += corners[corner] * (along_vertical * share);
            }
            // The area vectors of a closed surface sum to zero, so the area of the section is minus that of
            // the walls.
            let wet = corner_shares(sides, triangle, &heights, &[S::ONE; 8]);
            area -= along_vertical * (wet[0] + wet[1] + wet[2]);
            for (corner, wet) in triangle.into_iter().zip(wet) {
                area_moment -= corners[corner] * (along_vertical * wet);
            }
        }
        let height_moment = (vertical.dot(moment) - level * volume) * S::constant(0.5);
        // By the divergence theorem, the integral of r (n . N) over a closed surface is n V.
        let area_moment = area_moment + vertical * volume;
        Self { volume, first_moment: moment - vertical * height_moment, area, area_moment }
    }

    /// Returns the part of a sphere about its centre: with the cap's height d = R + l, V = pi d^2 (3 R - d) /
    /// 3, G = -n pi/4 (R^2 - l^2)^2.
    fn of_sphere(radius: S, vertical: Vector3<S>, level: S) -> Self {
        let pi = S::constant(core::f64::consts::PI);
        let level = level.clipped(-radius, radius);
        let cap = radius + level;
        let section = radius * radius - level * level;
        let area = pi * section;
        Self {
            volume: pi * cap * cap * (S::constant(3.0) * radius - cap) * S::constant(1.0 / 3.0),
            first_moment: vertical * -(S::constant(0.25) * pi * section * section),
            area,
            area_moment: vertical * (area * level),
        }
    }
}

/// Returns the corner of a box by its bits for x, y and z: a bit is set if the corner is forward, to port or
/// at the top.
fn corner_of<S: Scalar>(edges: Vector3<S>, bits: usize) -> Vector3<S> {
    Vector3(core::array::from_fn(|k| edges[k] * S::constant(if bits >> k & 1 == 1 { 0.5 } else { -0.5 })))
}

/// Returns two triangles for each side of a box, as corners, with the axis perpendicular to the side.
fn triangles() -> impl Iterator<Item = (usize, [usize; 3])> {
    (0..12).map(|i| {
        let axis = i / 4;
        let (one, other) = (1 << ((axis + 1) % 3), 1 << ((axis + 2) % 3));
        let (first, middle) = ((i / 2 % 2) << axis, if i % 2 == 0 { one } else { other });
        (axis, [first, first + middle, first + one + other])
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::Dual;
    use core::f64::consts::PI;
    use proptest::prelude::*;

    fn solids() -> [Solid; 5] {
        let cylinder = |axis| Solid::Cylinder { radius: 1.3, length: 4.1, axis };
        [
            Solid::Box { edges: Vector3::new(3.0, 2.0, 1.5) },
            cylinder(0),
            cylinder(1),
            cylinder(2),
            Solid::Sphere { radius: 1.7 },
        ]
    }

    proptest! {
        /// A motion of the plane sweeps dV = A dl - M . dn and dG = M dl - ...; dV/dl and dV/dn are exact by
        /// dual numbers. The gradient of the potential n . G - l V is (G, -V), which relates G to V.
        #[test]
        fn area_volume_and_moments_are_derivatives_of_one_potential(
            which in 0..5_usize,
            normal in prop::array::uniform3(-1.0..1.0_f64),
            flat in prop::array::uniform3(prop::bool::ANY),
            share in -1.1..1.1_f64,
        ) {
            let normal = Vector3(core::array::from_fn(|k| if flat[k] { 1e-9 * normal[k] } else { normal[k] }));
            prop_assume!(normal.norm() > 0.0);
            let (solid, normal) = (solids()[which], normal.direction());
            let level = share * solid.reach(normal);
            let over = |dn: Vector3, dl: f64| {
                let n = Vector3(core::array::from_fn(|k| Dual::<1> { value: normal[k], derivative: [dn[k]] }));
                let of = |x: f64| Dual::<1>::constant(x);
                let solid = match solid {
                    Solid::Box { edges } => Solid::Box { edges: Vector3(edges.0.map(of)) },
                    Solid::Cylinder { radius, length, axis } => {
                        Solid::Cylinder { radius: of(radius), length: of(length), axis }
                    }
                    Solid::Sphere { radius } => Solid::Sphere { radius: of(radius) },
                };
                let level = Dual::<1> { value: level, derivative: [dl] };
                let below = solid.below(n, level);
                let potential = n.dot(below.first_moment) - level * below.volume;
                [below.volume.derivative[0], potential.derivative[0]]
            };
            let below = solid.below(normal, level);
            let [by_level, falls] = over(Vector3::zero(), 1.0);
            prop_assert!((by_level - below.area).abs() < 1e-6, "dV/dl {by_level}, A {}", below.area);
            prop_assert!((falls + below.volume).abs() < 1e-7, "dU/dl {falls}, V {}", below.volume);
            // The derivative of a unit vector is perpendicular to it.
            let axis = if normal[0].abs() < 0.6 { Vector3::new(1.0, 0.0, 0.0) } else { Vector3::new(0.0, 1.0, 0.0) };
            let turned = normal.cross(axis).direction();
            for t in [turned, normal.cross(turned)] {
                let [by_turning, rises] = over(t, 0.0);
                prop_assert!((by_turning + t.dot(below.area_moment)).abs() < 1e-6);
                prop_assert!((rises - t.dot(below.first_moment)).abs() < 1e-6);
            }
        }

        /// Checks that the parts below a plane and below the reversed plane add up to the whole solid.
        #[test]
        fn both_sides_of_a_plane_add_up_to_the_whole_solid(
            which in 0..5_usize,
            normal in prop::array::uniform3(-1.0..1.0_f64),
            share in -1.2..1.2_f64,
        ) {
            prop_assume!(normal.iter().any(|x| *x != 0.0));
            let (solid, normal) = (solids()[which], Vector3(normal).direction());
            let level = share * solid.reach(normal);
            let (below, above) = (solid.below(normal, level), solid.below(-normal, -level));
            let whole = solid.volume();
            prop_assert!((below.volume + above.volume - whole).abs() < 1e-13 * whole);
            prop_assert!((below.first_moment + above.first_moment).norm() < 1e-12 * whole);
            prop_assert!((below.area - above.area).abs() < 1e-8 * (1.0 + below.area));
        }
    }

    #[test]
    fn the_volume_of_a_lying_cylinder_is_the_segment_of_its_circle() {
        let (radius, length) = (1.3_f64, 4.1);
        let cylinder = Solid::Cylinder { radius, length, axis: 0 };
        for level in [-1.1, -0.4, 0.0, 0.7, 1.2_f64] {
            let below = cylinder.below(Vector3::new(0.0, 0.0, 1.0), level);
            let segment = radius * radius * (-level / radius).acos() + level * (radius * radius - level * level).sqrt();
            assert!((below.volume - segment * length).abs() < 1e-13, "{level}: {}", below.volume);
            let moment = -2.0 / 3.0 * (radius * radius - level * level).powf(1.5) * length;
            assert!((below.first_moment[2] - moment).abs() < 1e-13, "{level}");
            let area = 2.0 * (radius * radius - level * level).sqrt() * length;
            assert!((below.area - area).abs() < 1e-13, "{level}: {} {area}", below.area);
        }
    }

    #[test]
    fn a_cut_through_a_cylinders_rim_is_its_ungula() {
        // A plane through the diameter of the lower end at slope tan = h / r cuts off 2/3 r^2 h
        // (Harris & Stocker, Handbook of Mathematics and Computational Science, 1998, sec. 4.6, cylindrical wedge).
        let (radius, length, height) = (1.3_f64, 4.1, 0.9);
        let cylinder = Solid::Cylinder { radius, length, axis: 2 };
        let normal = Vector3::new(-height / radius, 0.0, 1.0);
        let below = cylinder.below(normal.direction(), -length / 2.0 / normal.norm());
        assert!((below.volume - 2.0 / 3.0 * radius * radius * height).abs() < 1e-13, "{}", below.volume);
        let upright = cylinder.below(Vector3::new(0.0, 0.0, 1.0), 0.3);
        assert!((upright.volume - PI * radius * radius * (length / 2.0 + 0.3)).abs() < 1e-13);
    }
}
