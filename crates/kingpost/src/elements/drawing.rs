//! Drawing of an element in views: lines, tubes and pins.

use serde::Serialize;

/// A line that views draw from point to point. Its number of points is constant over a run; a single point is drawn as
/// a ball.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct DrawnLine {
    /// Name of its element.
    pub name: String,
    /// Its appearance.
    pub style: LineStyle,
    /// Radius, m; 0 if it is too thin to be drawn to scale.
    pub radius_m: f64,
    /// Number of its points.
    pub points: usize,
    /// Height of the level seabed on which it can lie, world z, m; absent if there is none.
    pub seabed_m: Option<f64>,
}

/// The appearance of a drawn line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum LineStyle {
    /// Rope, wire or chain.
    Line,
    /// The outer tube of a telescopic part.
    Barrel,
    /// The rod that slides in it.
    Rod,
    /// The pin at an end.
    Pin,
}
