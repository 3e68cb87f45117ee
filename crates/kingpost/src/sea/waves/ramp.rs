//! Ramp of the wave amplitudes at the start of a run.

/// Returns the factor of amplitudes at a time, with its first and second derivative: 0 before time 0, 1 after
/// `length_s`, and `s^3 (10 - 15 s + 6 s^2)` with s = t / length in between, whose first two derivatives are
/// 0 at both ends.
pub fn ramp(time_s: f64, length_s: f64) -> [f64; 3] {
    if time_s >= length_s {
        return [1.0, 0.0, 0.0];
    }
    let s = (time_s / length_s).max(0.0);
    let left = 1.0 - s;
    let rate = 30.0 * s * s * left * left / length_s;
    let acceleration = 60.0 * s * left * (1.0 - 2.0 * s) / (length_s * length_s);
    [s * s * s * (10.0 - s * (15.0 - 6.0 * s)), rate, acceleration]
}
