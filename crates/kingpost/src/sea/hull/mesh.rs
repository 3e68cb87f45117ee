//! Closed triangle meshes of hulls, checked at construction.

use crate::spatial::Vector3;
use thiserror::Error;

/// Smallest volume that counts, as a share of the cube of the mesh's extent.
const SMALLEST_VOLUME: f64 = 1e-9;

/// A hull's outer surface: a closed set of triangles with outward normals (corners counter-clockwise as seen from
/// outside). It may have several parts, like a catamaran.
///
/// ```
/// use kingpost::sea::hull::HullMesh;
/// let corners = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// let tetrahedron = HullMesh::new(corners, vec![[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]).unwrap();
/// assert!((tetrahedron.volume() - 1.0 / 6.0).abs() < 1e-15);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct HullMesh {
    vertices: Vec<Vector3>,
    triangles: Vec<Triangle>,
    volume: f64,
}

/// One triangle of a [`HullMesh`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Triangle {
    /// Indices of its vertices.
    pub(super) corners: [u32; 3],
    /// Its area along its outward normal, hull axes, m^2.
    pub(super) area: Vector3,
}

/// Reason why triangles are not a valid hull.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum MeshError {
    /// There are too few triangles to enclose a volume.
    #[error("the hull has {triangles} triangles, allowed: at least 4, as a closed surface")]
    TooFew {
        /// Number of triangles.
        triangles: usize,
    },
    /// A coordinate is NaN or infinite.
    #[error("vertex {vertex} of the hull: {axis} is {found}, allowed: a finite number")]
    NotFinite {
        /// Index of the vertex, from 0.
        vertex: usize,
        /// `x`, `y` or `z`.
        axis: char,
        /// The value found.
        found: f64,
    },
    /// A corner refers to a vertex that does not exist.
    #[error("triangle {triangle} of the hull: corner {found}, allowed: 0 to {}", vertices.saturating_sub(1))]
    NoSuchVertex {
        /// Index of the triangle, from 0.
        triangle: usize,
        /// Index of the vertex that does not exist.
        found: usize,
        /// Number of vertices.
        vertices: usize,
    },
    /// Some edges have a triangle on one side only.
    #[error(
        "the hull has holes: {edges} open edges, one from {from_m:?} to {to_m:?} m, allowed: none; \
         close the hull with its deck and transom, and merge coincident vertices"
    )]
    Open {
        /// Number of edges.
        edges: usize,
        /// Start of one of these edges, hull axes, m.
        from_m: [f64; 3],
        /// End of this edge, hull axes, m.
        to_m: [f64; 3],
    },
    /// Some neighbouring triangles have opposite orientation.
    #[error(
        "the hull's triangles disagree which side is outside: along {edges} edges, one from {from_m:?} to {to_m:?} m, \
         allowed: all normals outward"
    )]
    Inconsistent {
        /// Number of edges between such neighbours.
        edges: usize,
        /// Start of one of these edges, hull axes, m.
        from_m: [f64; 3],
        /// End of this edge, hull axes, m.
        to_m: [f64; 3],
    },
    /// The corners of a part run clockwise as seen from outside.
    #[error(
        "the hull's normals point inward: the part at {at_m:?} m encloses {volume_m3:.4e} m3, allowed: more than 0; \
         reverse the order of every triangle's corners"
    )]
    Inward {
        /// A vertex of the part, hull axes, m.
        at_m: [f64; 3],
        /// Volume of the part, negative, m^3.
        volume_m3: f64,
    },
    /// A part is flat.
    #[error(
        "the hull has no volume: the part at {at_m:?} m encloses {volume_m3:.1e} m3, allowed: more than {smallest_m3:.1e}"
    )]
    NoVolume {
        /// A vertex of the part, hull axes, m.
        at_m: [f64; 3],
        /// Volume that the part encloses, m^3.
        volume_m3: f64,
        /// Smallest volume that counts for a mesh of this size, m^3.
        smallest_m3: f64,
    },
}

impl HullMesh {
    /// Creates a hull from vertices in the hull's axes, m, and triangles of vertex indices from 0.
    ///
    /// # Errors
    /// [`MeshError`], for the first error.
    pub fn new(vertices_m: Vec<[f64; 3]>, triangles: Vec<[usize; 3]>) -> Result<Self, MeshError> {
        check_numbers(&vertices_m, &triangles)?;
        check_edges(&vertices_m, &triangles)?;
        let vertices: Vec<Vector3> = vertices_m.into_iter().map(Vector3).collect();
        let volume = check_volumes(&vertices, &triangles)?;
        let triangle = |corners: [usize; 3]| {
            let [a, b, c] = corners.map(|i| vertices[i]);
            Triangle { corners: corners.map(|i| i as u32), area: (b - a).cross(c - a) * 0.5 }
        };
        let triangles = triangles.into_iter().map(triangle).collect();
        Ok(Self { vertices, triangles, volume })
    }

    /// Returns the vertices, hull axes, m.
    pub fn vertices(&self) -> &[Vector3] {
        &self.vertices
    }

    /// Returns the vertex indices of each triangle, counter-clockwise as seen from outside.
    pub fn triangles(&self) -> impl ExactSizeIterator<Item = [u32; 3]> + '_ {
        self.triangles.iter().map(|triangle| triangle.corners)
    }

    /// Returns the volume of the whole hull, which is its largest displacement, m^3.
    pub fn volume(&self) -> f64 {
        self.volume
    }

    pub(super) fn faces(&self) -> &[Triangle] {
        &self.triangles
    }

    /// Returns the smallest and the largest `direction . r` over the vertices, m.
    pub(super) fn extent_along(&self, direction: Vector3) -> (f64, f64) {
        let along = self.vertices.iter().map(|&r| direction.dot(r));
        along.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, greatest), h| (least.min(h), greatest.max(h)))
    }
}

fn check_numbers(vertices: &[[f64; 3]], triangles: &[[usize; 3]]) -> Result<(), MeshError> {
    if triangles.len() < 4 {
        return Err(MeshError::TooFew { triangles: triangles.len() });
    }
    for (vertex, r) in vertices.iter().enumerate() {
        if let Some(axis) = r.iter().position(|x| !x.is_finite()) {
            return Err(MeshError::NotFinite { vertex, axis: ['x', 'y', 'z'][axis], found: r[axis] });
        }
    }
    // Indices are stored as u32.
    let vertices = vertices.len().min(u32::MAX as usize);
    for (triangle, corners) in triangles.iter().enumerate() {
        if let Some(&found) = corners.iter().find(|&&corner| corner >= vertices) {
            return Err(MeshError::NoSuchVertex { triangle, found, vertices });
        }
    }
    Ok(())
}

/// Checks the edges: in a closed surface with consistent orientation, every edge occurs equally often in both
/// directions.
fn check_edges(vertices: &[[f64; 3]], triangles: &[[usize; 3]]) -> Result<(), MeshError> {
    let mut walks: Vec<([usize; 2], bool)> = triangles
        .iter()
        .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
        .map(|[from, to]| ([from.min(to), from.max(to)], from < to))
        .collect();
    walks.sort_unstable();
    let balanced = |edge: &[([usize; 2], bool)]| edge.iter().filter(|(_, up)| *up).count() * 2 == edge.len();
    let unbalanced = || walks.chunk_by(|a, b| a.0 == b.0).filter(|edge| !balanced(edge));
    let place = |edge: &[([usize; 2], bool)]| edge[0].0.map(|i| vertices[i]);
    let open = || unbalanced().filter(|edge| edge.len() % 2 == 1);
    if let Some([from_m, to_m]) = open().next().map(place) {
        return Err(MeshError::Open { edges: open().count(), from_m, to_m });
    }
    if let Some([from_m, to_m]) = unbalanced().next().map(place) {
        return Err(MeshError::Inconsistent { edges: unbalanced().count(), from_m, to_m });
    }
    Ok(())
}

/// Checks the volume of each part, computed by the divergence theorem; a part is a set of connected
/// triangles.
fn check_volumes(vertices: &[Vector3], triangles: &[[usize; 3]]) -> Result<f64, MeshError> {
    let mut part_of: Vec<usize> = (0..vertices.len()).collect();
    for &[a, b, c] in triangles {
        let [a, b, c] = [a, b, c].map(|i| root(&part_of, i));
        let first = a.min(b).min(c);
        for part in [a, b, c] {
            part_of[part] = first;
        }
    }
    // The volume is computed about a vertex of the part, so that a mesh far from its origin does not lose
    // digits.
    let mut volumes = vec![0.0; vertices.len()];
    for &corners in triangles {
        let part = root(&part_of, corners[0]);
        let [a, b, c] = corners.map(|i| vertices[i] - vertices[part]);
        volumes[part] += a.dot(b.cross(c)) / 6.0;
    }
    let corner = |pick: fn(f64, f64) -> f64, start: f64| {
        let along = |axis: usize| vertices.iter().fold(start, |found, r| pick(found, r[axis]));
        Vector3::new(along(0), along(1), along(2))
    };
    let extent = (corner(f64::max, f64::NEG_INFINITY) - corner(f64::min, f64::INFINITY)).norm();
    let smallest_m3 = SMALLEST_VOLUME * extent * extent * extent;
    for part in triangles.iter().map(|corners| root(&part_of, corners[0])) {
        let (at_m, volume_m3) = (vertices[part].0, volumes[part]);
        let solid = volume_m3.abs() > smallest_m3;
        if !solid {
            return Err(MeshError::NoVolume { at_m, volume_m3, smallest_m3 });
        }
        if volume_m3 < 0.0 {
            return Err(MeshError::Inward { at_m, volume_m3 });
        }
    }
    Ok(volumes.iter().sum())
}

/// Returns the vertex that represents the part of vertex `i`.
fn root(part_of: &[usize], mut i: usize) -> usize {
    while part_of[i] != i {
        i = part_of[i];
    }
    i
}
