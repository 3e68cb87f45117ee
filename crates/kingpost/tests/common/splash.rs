//! A load that passes through the surface of the sea.

use std::f64::consts::PI;

/// m/s2.
pub const GRAVITY: f64 = 9.80665;
/// kg/m3.
pub const DENSITY: f64 = 1025.0;

/// A load that slides vertically through the sea with a prescribed motion; the joint's axes are the load's.
pub fn lowered(joint: &str, sea: &str, submerged: &str, simulation: &str) -> String {
    format!(
        "version: 1
title: A load through the surface
simulation: {{{simulation}}}
sea: {{{sea}}}
bodies:
  load:
    mass_kg: 20000
    shape: {{point: {{}}}}
    joint: {{prismatic: {{name: lift, {joint}}}}}
forces:
  gravity: {{gravity: {{}}}}
  water: {{submerged: {{body: load, {submerged}}}}}
"
    )
}

/// A box of 24 m3.
pub const BOX: &str = "{box: {length_m: 4, width_m: 3, height_m: 2}}";

/// A regular wave of deep water at x = 0: elevation a cos(phase - w t).
pub struct Wave {
    pub amplitude: f64,
    pub frequency: f64,
    pub number: f64,
    pub phase: f64,
}

impl Wave {
    /// Returns the wave with a height, a period and a phase.
    pub fn new(height: f64, period: f64, phase: f64) -> Self {
        let frequency = 2.0 * PI / period;
        Self { amplitude: 0.5 * height, frequency, number: frequency * frequency / GRAVITY, phase }
    }

    /// Returns the wave as the text of a scenario.
    pub fn sea(&self) -> String {
        let (height, period, phase) = (2.0 * self.amplitude, 2.0 * PI / self.frequency, self.phase);
        format!(
            "waves: {{one: {{regular: {{height_m: {height}, period_s: {period}, phase_rad: {phase}}}}}}}, ramp_s: 0"
        )
    }

    /// sin and cos of the phase at x = 0.
    pub fn angle(&self, time: f64) -> (f64, f64) {
        (self.phase - self.frequency * time).sin_cos()
    }

    /// Elevation, its slope and its rate.
    pub fn surface(&self, time: f64) -> [f64; 3] {
        let (sin, cos) = self.angle(time);
        [self.amplitude * cos, -self.amplitude * self.number * sin, self.amplitude * self.frequency * sin]
    }

    /// Velocity along x and z, acceleration along x and z, at z: above the still water level those at it.
    pub fn water(&self, time: f64, z: f64) -> [f64; 4] {
        let (sin, cos) = self.angle(time);
        let speed = self.amplitude * self.frequency * (self.number * z.min(0.0)).exp();
        [speed * cos, speed * sin, speed * self.frequency * sin, -speed * self.frequency * cos]
    }
}
