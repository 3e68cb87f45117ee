//! Hydrostatics to second order in the motions, as a potential.

use super::{FloatingPosition, HullMesh, StabilityError, WettedHull};
use crate::scalar::Scalar;
use crate::spatial::{Vector3, Wrench};

/// A hull at its reference draught, upright, with its origin on the water plane. With z0 the height
/// of the origin and n the vertical in hull axes ([`FloatingPosition`]),
///
/// ```text
/// U = -rho g V (z0 + b.n) + rho g / 2 Int (z0 + x n_x + y n_y)^2 dS
/// ```
///
/// over the reference waterplane: the initial displacement plus the immersed and emerged wedges, whose heights are
/// taken along the hull's z. Force and moment are minus its gradient, so energy is conserved exactly and no heading is
/// preferred. At the reference its second derivatives are the buoyancy's part of the linear restoring matrix (Newman,
/// *Marine Hydrodynamics*, 1977, sec. 6.16).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinearHydrostatics {
    /// Displaced volume V, m^3.
    pub volume: f64,
    /// Centre of buoyancy b, m.
    pub centre_of_buoyancy: Vector3,
    /// Waterplane area S, m^2.
    pub waterplane_area: f64,
    /// Integrals of x and of y over the waterplane, m^3.
    pub first_moments: [f64; 2],
    /// Integrals of x^2, xy and y^2 over the waterplane, m^4.
    pub second_moments: [f64; 3],
}

/// Linear restoring coefficients: minus the derivatives of force and moment about the hull's origin with
/// respect to heave (3), roll (4) and pitch (5). The matrix is symmetric, and its other entries are 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Restoring {
    /// C33, N/m.
    pub heave: f64,
    /// C34, N.
    pub heave_roll: f64,
    /// C35, N.
    pub heave_pitch: f64,
    /// C44, N m.
    pub roll: f64,
    /// C45, N m.
    pub roll_pitch: f64,
    /// C55, N m.
    pub pitch: f64,
}

impl LinearHydrostatics {
    /// Creates the linear hydrostatics of an upright mesh with its origin on the waterplane.
    ///
    /// # Errors
    /// [`StabilityError::AboveWater`].
    pub fn of_mesh(mesh: &HullMesh) -> Result<Self, StabilityError> {
        let lowest_m = mesh.extent_along(Vector3::new(0.0, 0.0, 1.0)).0;
        if lowest_m >= 0.0 {
            return Err(StabilityError::AboveWater { lowest_m });
        }
        let (mut wetted, position) = (WettedHull::new(mesh), FloatingPosition::upright(0.0));
        let (buoyancy, waterplane) = (wetted.buoyancy(mesh, &position), wetted.waterplane(mesh, &position));
        let (first, second) = (waterplane.first_moments, waterplane.second_moments);
        Ok(Self {
            volume: buoyancy.volume,
            centre_of_buoyancy: buoyancy.centre(),
            waterplane_area: waterplane.area,
            first_moments: [first[0], first[1]],
            second_moments: [second.xx, second.xy, second.yy],
        })
    }

    /// Returns the potential energy U, J, in water of this specific weight rho g, N/m^3; it is 0 with the
    /// centre of buoyancy on the water plane.
    pub fn potential_energy<S: Scalar>(&self, position: &FloatingPosition<S>, specific_weight: S) -> S {
        let (z, [n_x, n_y, _]) = (position.height, position.vertical.0);
        let [wedge, x_wedge, y_wedge] = self.wedges(position);
        let squared = z * wedge + n_x * x_wedge + n_y * y_wedge;
        let rise = z + position.vertical.dot(Vector3::constant(self.centre_of_buoyancy.0));
        specific_weight * (squared * S::constant(0.5) - rise * S::constant(self.volume))
    }

    /// Returns the force `-dU/dz0` along the vertical and the moment `n x dU/dn` on the hull about its
    /// origin, in its axes, N and N m. (A turn by the small angle a in hull axes changes n by `n x a`, so the
    /// moment's work on it is `-dU/dn . (n x a) = (n x dU/dn) . a`.)
    #[inline]
    pub fn wrench<S: Scalar>(&self, position: &FloatingPosition<S>, specific_weight: S) -> Wrench<S> {
        let (n, volume) = (position.vertical, S::constant(self.volume));
        let [wedge, x_wedge, y_wedge] = self.wedges(position);
        let along_n = Vector3::new(x_wedge, y_wedge, S::ZERO) - Vector3::constant(self.centre_of_buoyancy.0) * volume;
        Wrench { moment: n.cross(along_n) * specific_weight, force: n * ((volume - wedge) * specific_weight) }
    }

    /// Returns the integrals of h, x h and y h over the waterplane, with `h = z0 + x n_x + y n_y`.
    #[inline]
    fn wedges<S: Scalar>(&self, position: &FloatingPosition<S>) -> [S; 3] {
        let (z, [n_x, n_y, _]) = (position.height, position.vertical.0);
        let area = S::constant(self.waterplane_area);
        let ([x, y], [xx, xy, yy]) = (self.first_moments.map(S::constant), self.second_moments.map(S::constant));
        [area * z + x * n_x + y * n_y, x * z + xx * n_x + xy * n_y, y * z + xy * n_x + yy * n_y]
    }

    /// Returns the restoring coefficients of the buoyancy, in water of this specific weight rho g, N/m^3.
    pub fn restoring(&self, specific_weight: f64) -> Restoring {
        let ([x, y], [xx, xy, yy]) = (self.first_moments, self.second_moments);
        let tall = self.volume * self.centre_of_buoyancy[2];
        Restoring {
            heave: specific_weight * self.waterplane_area,
            heave_roll: specific_weight * y,
            heave_pitch: -specific_weight * x,
            roll: specific_weight * (yy + tall),
            roll_pitch: -specific_weight * xy,
            pitch: specific_weight * (xx + tall),
        }
    }
}

impl Restoring {
    /// Returns the restoring coefficients with those of a weight, N, whose centre is at this height in hull
    /// axes, m.
    #[must_use]
    pub fn with_weight(self, weight: f64, centre_height: f64) -> Self {
        Self { roll: self.roll - weight * centre_height, pitch: self.pitch - weight * centre_height, ..self }
    }
}
