//! One-step forward Euler, as in the paper (section "Computation").

use super::Tableau;

/// `v1 = v0 + h v0'`, joints `q1 = q0 + h v0`, ship `R1 = R0 exp(h hat(omega0))` (eq. 63): the
/// Munthe-Kaas scheme with a single stage. Order 1.
pub static FORWARD_EULER: Tableau = Tableau { a: &[], b: &[1.0], c: &[0.0] };
