//! The role of a controller before inputs.

/// The inputs that a controller sets.
pub trait SetsInputs {
    /// The inputs, each with its field below the controller's name.
    fn targets(&self) -> Vec<(String, &str)>;

    /// Whether they are those of drives, which no other controller commands.
    fn sets_drives(&self) -> bool {
        false
    }
}
