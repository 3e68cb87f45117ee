//! Motions and deflections with known closed forms, as objects. Each states its source; none uses the engine.
#![allow(unused_imports)] // each test binary uses its own part

mod cantilever;
mod double_pendulum;
pub mod elliptic;
mod four_bar;
mod free_body;
mod heavy_top;
mod pendulum;

pub use cantilever::Cantilever;
pub use double_pendulum::DoublePendulum;
pub use four_bar::FourBar;
pub use free_body::FreeBody;
pub use heavy_top::HeavyTop;
pub use pendulum::Pendulum;

/// Acceleration of free fall, m/s^2.
pub const GRAVITY: f64 = 9.80665;
