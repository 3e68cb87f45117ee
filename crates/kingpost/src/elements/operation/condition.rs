//! The condition that ends a step of an operation.

use crate::elements::significant;
use crate::scalar::Scalar;

/// A condition that ends a step.
#[derive(Clone, Debug, PartialEq)]
pub enum Condition {
    /// The step has lasted this long, s.
    After(f64),
    /// A column of the results is in a range.
    Column(ColumnRange),
    /// All of these hold at once.
    All(Vec<Condition>),
    /// One of these holds.
    Any(Vec<Condition>),
    /// A condition has held without a break for this time, s. Its number, at this place, is the time from which it holds, s
    /// after the start of the step, and negative while it does not.
    Holds(f64, usize, Box<Condition>),
    /// A condition has begun to hold this number of times. Its two numbers, from this place on, are the times so far, and 1
    /// while it holds.
    Count(u32, usize, Box<Condition>),
}

/// Range of a column, in the unit of its bounds.
#[derive(Clone, Debug, PartialEq)]
pub struct ColumnRange {
    /// Its name.
    pub column: String,
    /// Its index among the columns that the operation reads.
    pub place: usize,
    /// The value is above this.
    pub above: Option<Bound>,
    /// The value is below this.
    pub below: Option<Bound>,
    /// Unit of both bounds, and its factor to the column's SI unit.
    pub unit: (String, f64),
}

/// A bound of a column.
#[derive(Clone, Debug, PartialEq)]
pub enum Bound {
    /// A number.
    Number(f64),
    /// The value of another column, with its index among the columns that the operation reads.
    Column(String, usize),
}

/// Share of a time at which it has passed: its two ends are rounded.
const ROUNDING: f64 = 1.0 - 1e-9;
/// Number of a condition that does not hold.
const NOT_YET: f64 = -1.0;

/// The present values of the columns, and the time after the start of the step, s.
#[derive(Clone, Copy, Debug)]
pub struct Now<'a> {
    /// s.
    pub elapsed_s: f64,
    /// In SI units.
    pub columns: &'a [f64],
}

impl Condition {
    /// Returns the number of numbers that it keeps, with those of its parts.
    pub fn numbers(&self) -> usize {
        match self {
            Self::After(_) | Self::Column(_) => 0,
            Self::All(parts) | Self::Any(parts) => parts.iter().map(Self::numbers).sum(),
            Self::Holds(_, _, part) => 1 + part.numbers(),
            Self::Count(_, _, part) => 2 + part.numbers(),
        }
    }

    /// Returns the least duration of the step that it allows, s.
    pub fn least_s(&self) -> f64 {
        let each = |parts: &[Self]| parts.iter().map(Self::least_s).collect::<Vec<_>>();
        match self {
            Self::After(time_s) => *time_s,
            Self::Column(_) => 0.0,
            Self::All(parts) => each(parts).into_iter().fold(0.0, f64::max),
            Self::Any(parts) => each(parts).into_iter().fold(f64::INFINITY, f64::min),
            Self::Holds(for_s, _, part) => for_s + part.least_s(),
            Self::Count(_, _, part) => part.least_s(),
        }
    }

    /// Sets its numbers at the start of the step.
    pub fn begin<S: Scalar>(&self, kept: &mut [S]) {
        match self {
            Self::After(_) | Self::Column(_) => {}
            Self::All(parts) | Self::Any(parts) => parts.iter().for_each(|part| part.begin(kept)),
            Self::Holds(_, place, part) => {
                kept[*place] = S::constant(NOT_YET);
                part.begin(kept);
            }
            Self::Count(_, place, part) => {
                kept[*place..*place + 2].fill(S::ZERO);
                part.begin(kept);
            }
        }
    }

    /// Updates its numbers.
    pub fn observe<S: Scalar>(&self, now: Now<'_>, kept: &mut [S]) {
        match self {
            Self::After(_) | Self::Column(_) => {}
            Self::All(parts) | Self::Any(parts) => parts.iter().for_each(|part| part.observe(now, kept)),
            Self::Holds(_, place, part) => {
                part.observe(now, kept);
                let since = kept[*place].value();
                let first = if since < 0.0 { now.elapsed_s } else { since };
                kept[*place] = S::constant(if part.holds(now, kept) { first } else { NOT_YET });
            }
            Self::Count(_, place, part) => {
                part.observe(now, kept);
                let holds = part.holds(now, kept);
                if holds && kept[*place + 1].value() == 0.0 {
                    kept[*place] += S::ONE;
                }
                kept[*place + 1] = if holds { S::ONE } else { S::ZERO };
            }
        }
    }

    /// Whether the condition holds, with these numbers.
    pub fn holds<S: Scalar>(&self, now: Now<'_>, kept: &[S]) -> bool {
        match self {
            Self::After(time_s) => now.elapsed_s >= *time_s,
            Self::Column(range) => range.holds(now.columns),
            Self::All(all) => all.iter().all(|one| one.holds(now, kept)),
            Self::Any(any) => any.iter().any(|one| one.holds(now, kept)),
            Self::Holds(for_s, place, _) => {
                kept[*place].value() >= 0.0 && held_s(now, kept[*place]) >= for_s * ROUNDING
            }
            Self::Count(times, place, _) => kept[*place].value() >= f64::from(*times),
        }
    }

    /// Returns the condition as text.
    ///
    /// ```
    /// use kingpost::elements::operation::{Bound, ColumnRange, Condition};
    /// let above = Some(Bound::Number(2.0));
    /// let high = ColumnRange { column: "hook.z".into(), place: 0, above, below: None, unit: ("m".into(), 1.0) };
    /// let condition = Condition::Holds(5.0, 0, Box::new(Condition::Column(high)));
    /// assert_eq!(condition.in_words(), "hook.z above 2 m for 5 s");
    /// ```
    pub fn in_words(&self) -> String {
        let linked = |parts: &[Self], link: &str| {
            let own = |part: &Self| match part {
                Self::All(_) | Self::Any(_) => format!("({})", part.in_words()),
                _ => part.in_words(),
            };
            parts.iter().map(own).collect::<Vec<_>>().join(link)
        };
        match self {
            Self::After(time_s) => format!("after {time_s} s"),
            Self::Column(range) => format!("{} {}", range.column, range.bounds_in_words(|_| String::new())),
            Self::All(parts) => linked(parts, " and "),
            Self::Any(parts) => linked(parts, " or "),
            Self::Holds(for_s, _, part) => format!("{} for {for_s} s", part.in_words()),
            Self::Count(times, _, part) => format!("{}, {times} times", part.in_words()),
        }
    }

    /// Returns the part of the condition that does not hold, as text for an error.
    pub fn missing<S: Scalar>(&self, now: Now<'_>, kept: &[S]) -> String {
        let of = |conditions: &[Self], link: &str| {
            let open = conditions.iter().filter(|one| !one.holds(now, kept));
            open.map(|one| one.missing(now, kept)).collect::<Vec<_>>().join(link)
        };
        match self {
            Self::After(time_s) => {
                format!("found {} s since it began, allowed: at least {} s", significant(now.elapsed_s, 4), time_s)
            }
            Self::Column(range) => range.missing(now.columns),
            Self::All(all) => of(all, ", and "),
            Self::Any(any) => of(any, ", or "),
            Self::Holds(_, _, part) if !part.holds(now, kept) => part.missing(now, kept),
            Self::Holds(for_s, place, _) => {
                let held = significant(held_s(now, kept[*place]), 4);
                format!("found a condition that has held for {held} s, allowed: at least {for_s} s")
            }
            Self::Count(times, place, part) => {
                let found = kept[*place].value();
                let open = if part.holds(now, kept) { String::new() } else { format!("; {}", part.missing(now, kept)) };
                format!("found a condition that began to hold {found} times, allowed: at least {times}{open}")
            }
        }
    }
}

/// Returns the time for which a condition has held, s.
fn held_s<S: Scalar>(now: Now<'_>, since: S) -> f64 {
    now.elapsed_s - since.value()
}

impl ColumnRange {
    fn value(&self, columns: &[f64], place: usize) -> f64 {
        columns.get(place).map_or(f64::NAN, |value| value / self.unit.1)
    }

    fn bound(&self, bound: &Bound, columns: &[f64]) -> f64 {
        match bound {
            Bound::Number(number) => *number,
            Bound::Column(_, place) => self.value(columns, *place),
        }
    }

    fn holds(&self, columns: &[f64]) -> bool {
        let value = self.value(columns, self.place);
        self.above.as_ref().is_none_or(|above| value > self.bound(above, columns))
            && self.below.as_ref().is_none_or(|below| value < self.bound(below, columns))
    }

    fn missing(&self, columns: &[f64]) -> String {
        let unit = if self.unit.0 == "1" { String::new() } else { format!(" {}", self.unit.0) };
        let found = significant(self.value(columns, self.place), 4);
        let value = |bound: &Bound| format!(", {}{unit}", significant(self.bound(bound, columns), 4));
        format!("found {} {found}{unit}, allowed: {}", self.column, self.bounds_in_words(value))
    }

    /// Returns the bounds as text, the name of a column with its value.
    fn bounds_in_words(&self, value: impl Fn(&Bound) -> String) -> String {
        let unit = if self.unit.0 == "1" { String::new() } else { format!(" {}", self.unit.0) };
        let in_words = |bound: &Bound| match bound {
            Bound::Number(number) => format!("{number}{unit}"),
            Bound::Column(name, _) => format!("{name}{}", value(bound)),
        };
        let bounds = [("above", &self.above), ("below", &self.below)];
        let bounds =
            bounds.into_iter().filter_map(|(side, bound)| Some(format!("{side} {}", in_words(bound.as_ref()?))));
        bounds.collect::<Vec<_>>().join(" and ")
    }
}
