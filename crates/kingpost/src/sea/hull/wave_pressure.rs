//! Pressure of still water and of the incident wave on the part of the hull below the wave's surface.

use super::mesh::HullMesh;
use super::wetted::{DRY, WettedHull, corner_shares, side};
use crate::scalar::Scalar;
use crate::spatial::{Frame, Vector3, Wrench};

/// The undisturbed sea at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LocalWater<S = f64> {
    /// Elevation of the surface over the point, relative to still water, m.
    pub elevation: S,
    /// Pressure of the waves at the point, in addition to the still water's `-rho g z`, N/m^2. At the surface
    /// the sum should be 0; above it both continue smoothly, because partly wet triangles need values there.
    pub dynamic_pressure: S,
}

impl<S: Scalar> WettedHull<S> {
    /// Returns force and moment of the water's pressure on the hull about its origin, in its axes, N and N m:
    /// the surface integral of `-(-rho g z + p) N` over the part below the wave's surface (Froude-Krylov
    /// force and buoyancy together; Faltinsen, *Sea Loads on Ships and Offshore Structures*, 1990, ch. 3).
    /// `water` returns the sea at a point of the world; it is called once per vertex.
    ///
    /// Elevation and pressure are linear between the vertices, so the error is of second order in the size of
    /// the triangles; in still water it is zero.
    ///
    /// # Panics
    /// When the memory was made for another mesh.
    pub fn pressure_wrench(
        &mut self,
        mesh: &HullMesh,
        hull_in_world: &Frame<S>,
        specific_weight: S,
        water: impl FnMut(Vector3<S>) -> LocalWater<S>,
    ) -> Wrench<S> {
        let unbounded = S::constant(f64::INFINITY);
        self.pressure_wrench_below(mesh, hull_in_world, specific_weight, unbounded, water)
    }

    /// Computes a wrench bitwise identical to that of [`pressure_wrench`](Self::pressure_wrench), if no wave
    /// is higher than `highest_m` above still water: `water` is not called for vertices above `highest_m`
    /// whose neighbours are all dry.
    ///
    /// # Panics
    /// When the memory was made for another mesh.
    pub fn pressure_wrench_below(
        &mut self,
        mesh: &HullMesh,
        hull_in_world: &Frame<S>,
        specific_weight: S,
        highest_m: S,
        mut water: impl FnMut(Vector3<S>) -> LocalWater<S>,
    ) -> Wrench<S> {
        assert_eq!(mesh.vertices().len(), self.heights.len(), "the memory is of another mesh");
        let in_world = |vertex: usize| hull_in_world.point(Vector3::constant(mesh.vertices()[vertex].0));
        let mut ask = |point: Vector3<S>| {
            let LocalWater { elevation, dynamic_pressure } = water(point);
            (point[2] - elevation, dynamic_pressure - specific_weight * point[2])
        };
        for vertex in 0..mesh.vertices().len() {
            let point = in_world(vertex);
            self.asked[vertex] = !(point[2] - highest_m).all(|above| above > 0.0);
            self.sides[vertex] = DRY;
            if self.asked[vertex] {
                (self.heights[vertex], self.shares[vertex]) = ask(point);
                self.sides[vertex] = side(self.heights[vertex]);
            }
        }
        for triangle in mesh.faces() {
            let corners = triangle.corners.map(|i| i as usize);
            if corners.iter().all(|i| self.sides[*i] == DRY) {
                continue;
            }
            for vertex in corners {
                if !self.asked[vertex] {
                    (self.heights[vertex], self.shares[vertex]) = ask(in_world(vertex));
                    self.asked[vertex] = true;
                }
            }
        }
        // 0, or NaN if the pose is not finite.
        let nothing = hull_in_world.position[2] * S::ZERO;
        self.sum_of_wet_triangles(mesh, nothing)
    }

    /// Returns the sum over all triangles, from the heights, sides and pressures of their corners; plus a
    /// force `first` along x.
    fn sum_of_wet_triangles(&self, mesh: &HullMesh, first: S) -> Wrench<S> {
        let mut wrench = Wrench::zero();
        wrench.force[0] = first;
        for triangle in mesh.faces() {
            let corners = triangle.corners.map(|i| i as usize);
            let sides = corners.map(|i| self.sides[i]);
            if sides == [DRY; 3] {
                continue;
            }
            let shares = corner_shares(sides, corners, &self.heights, &self.shares);
            let area = Vector3::constant(triangle.area.0);
            let [a, b, c] = corners.map(|i| Vector3::constant(mesh.vertices()[i].0));
            let moment = a * shares[0] + b * shares[1] + c * shares[2];
            wrench.force -= area * (shares[0] + shares[1] + shares[2]);
            wrench.moment -= moment.cross(area);
        }
        wrench * S::constant(1.0 / 12.0)
    }
}
