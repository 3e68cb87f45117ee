//! Watchers, which check the rows of a run and warn.

use core::fmt::Debug;
use serde::Serialize;

/// A warning of a run.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Warning {
    /// Time of the warning's cause, s.
    pub time_s: f64,
    /// Cause of the warning, in words joined by `_`; all warnings with this cause have the same code.
    pub code: &'static str,
    /// Name of the joint, closed loop, body or element that it concerns.
    pub name: String,
    /// The value that exceeds its bound, in `unit`; absent if the warning has no number.
    pub value: Option<f64>,
    /// The bound of the value, in `unit`.
    pub bound: Option<f64>,
    /// Unit of `value` and `bound`.
    pub unit: &'static str,
    /// The text of the warning.
    pub text: String,
}

/// A value and the bound that it exceeds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exceeded {
    /// The value.
    pub value: f64,
    /// Its bound.
    pub bound: f64,
    /// Unit of both.
    pub unit: &'static str,
}

impl Warning {
    /// Returns the warning of a value beyond its bound.
    pub fn exceeded(code: &'static str, time_s: f64, name: &str, numbers: Exceeded, text: String) -> Self {
        let Exceeded { value, bound, unit } = numbers;
        Self { time_s, code, name: name.to_owned(), value: Some(value), bound: Some(bound), unit, text }
    }
}

/// Sees every row of a run, and warns of a joint, a closed loop or an element.
pub trait Watcher: Debug + Send + Sync + BoxedWatcher {
    /// Returns the columns that it checks, such as `slew.joint_position`.
    fn columns(&self) -> Vec<String>;

    /// Sees the values of its columns in a row, and the row's time.
    fn see(&mut self, time_s: f64, values: &[f64]);

    /// Returns the warnings so far.
    fn warnings(&self) -> Vec<Warning>;
}

/// A watcher of any kind.
pub type AnyWatcher = Box<dyn Watcher>;

/// Methods that every watcher gets from being `Clone` and `'static`, by a blanket implementation.
pub trait BoxedWatcher {
    /// Returns a boxed copy.
    fn boxed_clone(&self) -> AnyWatcher;
}

impl<T: Watcher + Clone + 'static> BoxedWatcher for T {
    fn boxed_clone(&self) -> AnyWatcher {
        Box::new(self.clone())
    }
}

impl Clone for AnyWatcher {
    fn clone(&self) -> Self {
        (**self).boxed_clone()
    }
}

/// The value with the largest magnitude, with its sign, and its time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Extreme {
    /// The value; 0 before the first row.
    pub value: f64,
    /// Time of the value, s.
    pub time_s: f64,
}

impl Extreme {
    /// Sees a number.
    pub fn see(&mut self, time_s: f64, value: f64) {
        if value.abs() > self.value.abs() {
            *self = Self { value, time_s };
        }
    }
}

/// Formats a number for a reader: with `digits` significant digits, without trailing zeros, and with a power of ten if
/// very large or very small.
///
/// ```
/// use kingpost::elements::significant;
/// assert_eq!([980.665, 0.30000000000000004, 3.0e8].map(|x| significant(x, 5)), ["980.66", "0.3", "3e+08"]);
/// ```
pub fn significant(value: f64, digits: usize) -> String {
    let scientific = format!("{:.*e}", digits - 1, value + 0.0);
    let Some((mantissa, exponent)) = scientific.split_once('e') else { return scientific };
    let exponent: i32 = exponent.parse().unwrap_or_default();
    let trimmed = |text: &str| {
        let whole = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text };
        whole.to_owned()
    };
    match usize::try_from(digits as i32 - 1 - exponent) {
        Ok(decimals) if exponent >= -4 => trimmed(&format!("{:.*}", decimals, value + 0.0)),
        _ => format!("{}e{}{:02}", trimmed(mantissa), if exponent < 0 { '-' } else { '+' }, exponent.abs()),
    }
}
