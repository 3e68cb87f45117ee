//! A beam as a chain of rigid segments with elastic joints between them.

use super::Section;
use crate::scalar::Scalar;
use crate::spatial::{SpatialInertia, Symmetric3};

/// A uniform beam along x in n equal pieces, each with an elastic joint in its middle (the rigid finite
/// element method: Wittbrodt, Adamiec-Wojcik & Wojciech, Dynamics of Flexible Multibody Systems, 2006, ch.
/// 2). Between the joints the beam is rigid: it has n + 1 segments, and the first and the last one have the
/// length of half a piece.
///
/// About its middle the compliance of a piece of length l is diagonal (Przemieniecki, Theory of Matrix
/// Structural Analysis, 1968, ch. 5):
///
/// - bending `l / (E I)`, torsion `l / (G J)`,
/// - transverse `l / (k G A) + l^3 / (12 E I)`: the shear of the piece, and the bending within the piece between its
///   ends.
///
/// So the deflection of a beam with loads at its ends and in the middle of segments is exact for any n.
/// Masses are those of rigid segments; the error of frequencies is of second order in l.
#[derive(Clone, Copy, Debug)]
pub struct Beam<S = f64> {
    /// Number n of pieces, which is the number of joints.
    pub pieces: usize,
    /// Length, m.
    pub length: S,
    /// Mass, kg.
    pub mass: S,
    /// Cross-section.
    pub section: Section<S>,
    /// Young's modulus E, Pa.
    pub youngs_modulus: S,
    /// Shear modulus G, Pa.
    pub shear_modulus: S,
}

impl<S: Scalar> Beam<S> {
    /// Returns the length l of a piece, m.
    pub fn piece(&self) -> S {
        self.length / S::constant(self.pieces as f64)
    }

    /// Returns the position of the joint before segment i, with i from 1 to n, m from the beam's start.
    pub fn joint(&self, i: usize) -> S {
        self.piece() * S::constant(i as f64 - 0.5)
    }

    /// Returns the length of a segment, numbered from 0 to n, m.
    pub fn segment_length(&self, i: usize) -> S {
        self.piece() * S::constant(self.pieces_in(i))
    }

    /// Returns the middle of a segment, m from the beam's start.
    pub fn segment_middle(&self, i: usize) -> S {
        let from = if i == 0 { S::ZERO } else { self.joint(i) };
        from + self.segment_length(i) * S::constant(0.5)
    }

    /// Returns the number of the segment at a position, m from the beam's start; beyond an end, the segment
    /// at that end.
    pub fn segment_at(&self, place: S) -> S {
        let last = self.pieces as f64;
        let [segment] =
            S::from_values([place, self.piece()], &|[place, piece]| [libm::round(place / piece).clamp(0.0, last)]);
        segment
    }

    fn pieces_in(&self, segment: usize) -> f64 {
        if segment == 0 || segment == self.pieces { 0.5 } else { 1.0 }
    }

    /// Returns the mass of a segment, kg.
    pub fn segment_mass(&self, i: usize) -> S {
        self.mass * S::constant(self.pieces_in(i) / self.pieces as f64)
    }

    /// Returns the inertia of a segment about its middle, from its length and its cross-section.
    pub fn segment_inertia(&self, i: usize) -> SpatialInertia<S> {
        let (mass, length) = (self.segment_mass(i), self.segment_length(i));
        let [about_y, about_z] = self.section.second_moments.map(|moment| moment / self.section.area);
        let across = length * length * S::constant(1.0 / 12.0);
        let moments = [about_y + about_z, across + about_y, across + about_z].map(|square| mass * square);
        SpatialInertia::rigid(mass, Symmetric3::diagonal(moments))
    }

    /// Returns the stiffnesses of a joint in the order of its coordinates: shear along y and z (N/m),
    /// torsion, bending about y and about z (N m/rad).
    pub fn stiffness(&self) -> [S; 5] {
        let (l, e, g) = (self.piece(), self.youngs_modulus, self.shear_modulus);
        let Section { second_moments: [about_y, about_z], torsion_constant, shear_compliances, .. } = self.section;
        let [along_y, along_z] = shear_compliances;
        let across = |shear_compliance: S, second_moment: S| {
            S::ONE / (l * shear_compliance / g + l * l * l / (S::constant(12.0) * e * second_moment))
        };
        // Bending about z displaces a beam along y.
        [across(along_y, about_z), across(along_z, about_y), g * torsion_constant / l, e * about_y / l, e * about_z / l]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn beam(pieces: usize) -> Beam {
        let section = Section::circular_tube(0.6, 0.012, 0.3);
        Beam { pieces, length: 24.0, mass: 4000.0, section, youngs_modulus: 2.1e11, shear_modulus: 8.1e10 }
    }

    #[test]
    fn the_segments_make_up_the_beam() {
        for pieces in [1, 2, 7] {
            let beam = beam(pieces);
            let length: f64 = (0..=pieces).map(|i| beam.segment_length(i)).sum();
            let mass: f64 = (0..=pieces).map(|i| beam.segment_mass(i)).sum();
            assert!((length - 24.0).abs() < 1e-12 && (mass - 4000.0).abs() < 1e-9);
            for i in 1..=pieces {
                let before = beam.segment_middle(i - 1) + beam.segment_length(i - 1) / 2.0;
                let after = beam.segment_middle(i) - beam.segment_length(i) / 2.0;
                assert!((before - beam.joint(i)).abs() < 1e-12 && (after - beam.joint(i)).abs() < 1e-12);
                assert_eq!(beam.segment_at(beam.segment_middle(i)), i as f64);
            }
            assert_eq!([-1.0, 0.0, 99.0].map(|place| beam.segment_at(place)), [0.0, 0.0, pieces as f64]);
        }
    }

    #[test]
    fn the_deflection_by_a_tip_force_is_timoshenkos_for_any_number_of_pieces() {
        for pieces in [1, 2, 5, 16] {
            let (beam, force) = (beam(pieces), 1000.0);
            let [_, shear_z, _, bending_y, _] = beam.stiffness();
            let joints = (1..=pieces).map(|i| beam.length - beam.joint(i));
            let found: f64 = joints.map(|arm| force * (arm * arm / bending_y + 1.0 / shear_z)).sum();
            let Section { second_moments: [about_y, _], shear_compliances: [_, along_z], .. } = beam.section;
            let bent = force * beam.length.powi(3) / (3.0 * beam.youngs_modulus * about_y);
            let sheared = force * beam.length * along_z / beam.shear_modulus;
            assert!((found / (bent + sheared) - 1.0).abs() < 1e-12, "{pieces}: {found}");
        }
    }
}
