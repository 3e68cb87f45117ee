//! The water on a hull.

use kingpost_derive::fields;

use crate::scenario::schema::{DatabasePath, LocalName, Name, Positive, yes};

/// The water on a hull, by potential theory at zero forward speed: buoyancy, added mass, radiated and incident waves.
/// Weight is not included: `gravity` acts on every body.
#[fields]
pub struct Hydrodynamics<S = f64> {
    /// Whether the element acts.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The body that is the hull; its joint is floating.
    pub body: Name,
    /// File of the hydrodynamic database, relative to the scenario's file.
    pub database: DatabasePath,
    /// Name of the hull in a database of several hulls that feel each other; if it is left out, the name of the body. Every hull
    /// of such a database takes part, each once.
    pub hull: Option<LocalName>,
    /// The database's origin in the body's drawing frame, m; the axes are the body's. The origin lies on the waterplane
    /// at the database's draught.
    #[serde(default)]
    pub origin_m: [S; 3],
    /// How buoyancy is computed.
    #[serde(default)]
    pub hydrostatics: Hydrostatics,
    /// Whether the added mass at infinite frequency acts.
    #[serde(default = "yes")]
    pub added_mass: bool,
    /// Whether the waves that the hull radiates act on it.
    #[serde(default = "yes")]
    pub radiation: bool,
    /// Whether the sea's waves act on it.
    #[serde(default = "yes")]
    pub excitation: bool,
    /// Whether the pressure of the incident waves acts on the part of the mesh below their surface, instead of the
    /// linear Froude-Krylov force: for large motions and high waves. The linear excitation is then diffraction only.
    /// Needs `hydrostatics: mesh`.
    #[serde(default)]
    pub wave_pressure: bool,
    /// Whether the mean and slowly varying drift forces of the waves act on it, by Newman's approximation: surge and
    /// sway force, yaw moment. The database's coefficients are valid for the loading condition for which they were
    /// computed. Not together with `wave_pressure`.
    #[serde(default)]
    pub wave_drift: bool,
    /// Whether the drift forces change with the velocity of the hull through the water, by Aranha's formula for deep
    /// water: it adds wave-drift damping of slow surge and sway, and changes the drift in a current. Needs
    /// `wave_drift`.
    #[serde(default)]
    pub wave_drift_damping: bool,
    /// Cut-off of a sixth-order low-pass filter, rad/s. First-order wave loads are computed at the filtered position
    /// and heading. Choose it well below the wave frequencies and above the frequencies of the ship's slow drift, which
    /// the filter follows without lag.
    #[serde(default = "slow_motion_cutoff")]
    pub slow_motion_cutoff_rad_s: Positive,
}

impl<S> Hydrodynamics<S> {
    /// Returns the name of the hull in a database of several.
    pub fn name_in_database(&self) -> &str {
        self.hull.as_deref().unwrap_or(&self.body)
    }
}

/// The default of `slow_motion_cutoff_rad_s`.
fn slow_motion_cutoff() -> Positive {
    Positive::literal(0.075)
}

/// How buoyancy is computed.
#[fields]
#[derive(Copy, Default, Eq)]
pub enum Hydrostatics {
    /// From the waterplane at the database's draught, to second order in the motions.
    #[default]
    Linear,
    /// From the wetted part of the database's mesh in still water.
    Mesh,
    /// Not at all.
    None,
}
