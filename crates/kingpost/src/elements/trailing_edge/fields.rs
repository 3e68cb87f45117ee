//! The trailing edge of a fin.

use kingpost_derive::fields;

use crate::scenario::schema::{Name, Positive, yes};

/// The trailing edge of a swimming fin: the water leaves the edge with sideways momentum from the fin, which drives the
/// fin forward (Lighthill, 1971). The fin moves forward along the body's x axis and strikes along y; the edge is along
/// z. The fin's added mass is that of a `submerged` force on its body.
#[fields]
pub struct TrailingEdge<S = f64> {
    /// Whether the element acts.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The fin.
    pub body: Name,
    /// Middle of the edge in the body's drawing frame, m.
    pub position_m: [S; 3],
    /// Length of the edge, m.
    pub span_m: Positive<S>,
}
