//! The mass that moves with each body.

/// The mass of each body with all bodies that its joints carry, by the index of the body.
///
/// ```
/// use kingpost::elements::MovedMass;
/// let moved = MovedMass { dry_kg: vec![80e3], wet_kg: vec![280e3] };
/// assert_eq!((moved.dry(0), moved.with_added_mass(0)), (80e3, 280e3));
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MovedMass {
    /// Mass, kg.
    pub dry_kg: Vec<f64>,
    /// Mass with the added mass of the water in the vertical direction, kg.
    pub wet_kg: Vec<f64>,
}

impl MovedMass {
    /// Returns the mass without that of the water, kg.
    pub fn dry(&self, body: usize) -> f64 {
        self.dry_kg[body]
    }

    /// Returns the mass with the added mass of the water, kg.
    pub fn with_added_mass(&self, body: usize) -> f64 {
        self.wet_kg[body]
    }
}
