//! What a picture has of an element that is no body: lines, tubes and pins.

use serde::Serialize;

/// A line that a picture draws from point to point. Its number of points stays the same over a run; a single one is a ball.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct DrawnLine {
    /// Whose it is.
    pub name: String,
    /// What it looks like.
    pub style: LineStyle,
    /// Radius, m; 0 where it is too thin to be drawn to scale.
    pub radius_m: f64,
    /// Number of its points.
    pub points: usize,
}

/// What a drawn line looks like.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum LineStyle {
    /// Rope, wire or chain.
    Line,
    /// The outer tube of what telescopes.
    Barrel,
    /// What slides in it.
    Rod,
    /// What an end turns about.
    Pin,
}
