//! Camera and plots of a scenario.

use kingpost_derive::fields;

use super::ColumnName;

/// Camera and plots with which the app and figures open the scenario; a user can change them.
#[fields(default)]
#[derive(Default)]
pub struct View {
    /// The camera; without it, the view chooses one.
    pub camera: Option<Camera>,
    /// The columns of each plot over time, by their names in the table of results; without them, the view chooses some.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub plots: Vec<Vec<ColumnName>>,
}

/// Viewpoint of the camera.
#[fields]
pub enum Camera {
    /// It shows the whole scene, and a user turns it.
    Free,
    /// It follows the load.
    Load,
    /// It looks from the crane's cab at the hook.
    Cab,
    /// It looks from the bridge.
    Bridge,
    /// It looks down.
    Top,
    /// It looks along the ship at a section.
    Section,
    /// It stands at a place.
    Place(CameraPlace),
}

/// Place of a camera relative to the first body, along the axes of the world.
#[fields]
pub struct CameraPlace {
    /// Position of the eye, m.
    pub eye_m: [f64; 3],
    /// Position that is in the middle of the picture, m.
    pub target_m: [f64; 3],
}
