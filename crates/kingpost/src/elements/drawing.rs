//! Drawing of an element in views: lines, tubes and pins, and liquids in tanks.

use serde::Serialize;

/// A line that views draw from point to point. Its number of points is constant over a run; a single point is drawn as
/// a ball.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct DrawnLine {
    /// Name of its element, or of a line of several in one element.
    pub name: String,
    /// Its appearance.
    pub style: LineStyle,
    /// Radius, m; 0 if it is too thin to be drawn to scale.
    pub radius_m: f64,
    /// Number of its points.
    pub points: usize,
    /// The seabed on which it can lie; absent if there is none.
    pub seabed: Option<DrawnSeabed>,
}

impl DrawnLine {
    /// A line with this name, appearance and number of points, too thin to be drawn to scale, without a seabed.
    pub fn thin(name: &str, style: LineStyle, points: usize) -> Self {
        Self { name: name.to_owned(), style, radius_m: 0.0, points, seabed: None }
    }
}

/// A plane seabed under a drawn line.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct DrawnSeabed {
    /// Height at the origin of the world, world z, m.
    pub height_m: f64,
    /// Gradient of the height along x and y.
    pub gradient: [f64; 2],
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

/// A tank in a body, with the liquid in it.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct DrawnTank {
    /// Name of its element, and of the liquid's body.
    pub name: String,
    /// The body that carries it.
    pub body: String,
    /// Its rooms, each a box with its edges along the axes of that body.
    pub rooms: Vec<TankRoom>,
}

/// A room of a tank, with a surface of the liquid that stays parallel to its bottom.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct TankRoom {
    /// Corner with the smallest coordinates, from the body's centre of mass, m.
    pub low_m: [f64; 3],
    /// Corner with the largest coordinates, m.
    pub high_m: [f64; 3],
    /// Level of the liquid at rest above the bottom, m.
    pub level_m: f64,
    /// Column of the results with the level; absent if the level is constant.
    pub level_column: Option<String>,
    /// Height above the bottom at which this column is 0, m.
    pub level_zero_m: f64,
}
