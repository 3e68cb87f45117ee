//! Waterplane: section of a hull with the plane of the still water.

use super::FloatingPosition;
use super::mesh::HullMesh;
use super::wetted::{WettedHull, apex_of, cuts, from_corner};
use crate::spatial::{Symmetric3, Vector3};

/// Area and moments of a waterplane about the hull's origin, in the hull's axes. They are derivatives of the
/// buoyancy: minus the area is dV/dz0; minus the first moments are dV/dn and dG/dz0; minus the second moments
/// are dG/dn.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Waterplane {
    /// Area S, m^2.
    pub area: f64,
    /// Integral of r over the area, m^3.
    pub first_moments: Vector3,
    /// Integral of r r^T over the area, m^4.
    pub second_moments: Symmetric3,
}

impl WettedHull<f64> {
    /// Returns the waterplane of the hull in this position: each triangle that the surface cuts gives one
    /// edge of the waterplane.
    ///
    /// # Panics
    /// If the memory was made for another mesh.
    pub fn waterplane(&mut self, mesh: &HullMesh, position: &FloatingPosition) -> Waterplane {
        self.find_heights(mesh, position);
        let foot = position.vertical * -position.height;
        let mut waterplane = Waterplane::default();
        for triangle in mesh.faces() {
            let corners = triangle.corners.map(|i| i as usize);
            let sides = corners.map(|i| self.sides[i]);
            let wet = sides[0] + sides[1] + sides[2];
            if wet != 1 && wet != 2 {
                continue;
            }
            let corners = from_corner(apex_of(sides), corners);
            let [b, c] = cuts(corners.map(|i| self.heights[i]));
            let [r_a, r_b, r_c] = corners.map(|i| mesh.vertices()[i]);
            let (b, c) = (r_a + (r_b - r_a) * b, r_a + (r_c - r_a) * c);
            let (from, to) = if wet == 1 { (c, b) } else { (b, c) };
            waterplane.add(foot, from, to, position.vertical);
        }
        waterplane
    }
}

impl Waterplane {
    /// Adds a triangle, by the means of products of barycentric coordinates.
    fn add(&mut self, a: Vector3, b: Vector3, c: Vector3, normal: Vector3) {
        let area = 0.5 * normal.dot((b - a).cross(c - a));
        let sum = a + b + c;
        let entry = |i: usize, j: usize| area / 12.0 * (a[i] * a[j] + b[i] * b[j] + c[i] * c[j] + sum[i] * sum[j]);
        self.area += area;
        self.first_moments += sum * (area / 3.0);
        self.second_moments += Symmetric3 {
            xx: entry(0, 0),
            xy: entry(0, 1),
            xz: entry(0, 2),
            yy: entry(1, 1),
            yz: entry(1, 2),
            zz: entry(2, 2),
        };
    }

    /// Returns the centre of flotation, m; the origin if the area is 0.
    pub fn centre(&self) -> Vector3 {
        if self.area > 0.0 { self.first_moments * (1.0 / self.area) } else { Vector3::zero() }
    }

    /// Returns the second moment `Int (u . (r - f)) (w . (r - f)) dS`, m^4, with the centre of flotation f,
    /// along tangents u and w of the plane; 0 if the area is 0.
    pub fn second_moment(&self, u: Vector3, w: Vector3) -> f64 {
        if self.area > 0.0 {
            u.dot(self.second_moments * w) - u.dot(self.first_moments) * w.dot(self.first_moments) / self.area
        } else {
            0.0
        }
    }
}
