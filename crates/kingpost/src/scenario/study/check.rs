//! Checks of a study beyond its types: unique values, compatible kinds, number of runs.

use super::super::writing::ToValue;
use super::{DrawnInterval, EvenRange, MOST_PEAKS, MOST_RUNS, MOST_SEEDS, ScatterQuantity, Study, StudyAxis};
use crate::scenario::error::FieldError;
use crate::scenario::schema::ParameterValue;
use crate::scenario::wording;

/// Path of a field, and its error.
type Wrong = (Vec<String>, FieldError);

/// Returns the first error.
pub(super) fn all(study: &Study) -> Result<(), Wrong> {
    if study.scenario.trim().is_empty() {
        return wrong(
            &["scenario"],
            wording::quoted(&study.scenario),
            "a file beside the study, or a name of the gallery",
        );
    }
    axes(study)?;
    drawn_together(study)?;
    counts(study)?;
    lists(study)?;
    sea(study)
}

fn wrong(path: &[&str], found: impl ToString, allowed: impl Into<String>) -> Result<(), Wrong> {
    let path: Vec<String> = path.iter().map(|segment| (*segment).to_owned()).collect();
    let field = path.join(".");
    Err((path, FieldError::new(field, found, allowed)))
}

/// Checks each axis separately.
fn axes(study: &Study) -> Result<(), Wrong> {
    for (name, axis) in &study.axes {
        if name == "seed" || name == "simulation.seed" {
            return wrong(&["axes", name], "the seed", "what cases differ in; seeds has the seeds of all of them");
        }
        if study.set.contains_key(name) {
            return wrong(&["axes", name], "a name that is in set too", "a name in axes or in set");
        }
        match axis {
            StudyAxis::Values(given) => values(name, given)?,
            StudyAxis::Range(EvenRange { count, .. }) if !(2..=MOST_RUNS).contains(count) => {
                return wrong(&["axes", name, "range", "count"], count, whole(2, MOST_RUNS));
            }
            StudyAxis::Range(EvenRange { from, to, .. }) if from == to => {
                return wrong(&["axes", name, "range", "to"], to, format!("a number other than from, {from}"));
            }
            StudyAxis::LatinHypercube(DrawnInterval { from, to }) if from >= to => {
                return wrong(
                    &["axes", name, "latin_hypercube", "to"],
                    to,
                    format!("a number greater than from, {from}"),
                );
            }
            StudyAxis::Range(_) | StudyAxis::LatinHypercube(_) | StudyAxis::Scatter(_) => {}
        }
    }
    Ok(())
}

/// Checks a list of values: at least one, all of one kind, no duplicates.
fn values(name: &str, given: &[ParameterValue]) -> Result<(), Wrong> {
    let Some(first) = given.first() else {
        return wrong(&["axes", name, "values"], "an empty list", "one value or more");
    };
    for (k, value) in given.iter().enumerate() {
        let path = ["axes", name, "values", &k.to_string()];
        if value.kind() != first.kind() {
            let allowed = "values of one kind: all numbers, all texts, or all true or false";
            return wrong(&path, wording::found(&value.to_value()), allowed);
        }
        if given[..k].contains(value) {
            return wrong(&path, format!("{} a second time", wording::found(&value.to_value())), "each value once");
        }
    }
    Ok(())
}

/// Checks the axes of a Latin hypercube and of a scatter table against the samples and the table.
fn drawn_together(study: &Study) -> Result<(), Wrong> {
    let named =
        |test: fn(&StudyAxis) -> bool| study.axes.iter().find(|(_, axis)| test(axis)).map(|(name, _)| name.as_str());
    match (named(|axis| matches!(axis, StudyAxis::LatinHypercube(_))), &study.samples) {
        (Some(name), None) => {
            return wrong(&["axes", name], "no samples", "samples: {count: 200, seed: 1} beside axes");
        }
        (None, Some(_)) => {
            return wrong(&["samples"], "no axis latin_hypercube", "samples beside an axis latin_hypercube");
        }
        _ => {}
    }
    let scattered = |wanted: ScatterQuantity| {
        study
            .axes
            .iter()
            .filter(move |(_, axis)| matches!(axis, StudyAxis::Scatter(of) if *of == wanted))
            .map(|(name, _)| name)
    };
    let mut heights = scattered(ScatterQuantity::SignificantHeight);
    let mut periods = scattered(ScatterQuantity::PeakPeriod);
    let both = "one axis {scatter: significant_height} and one {scatter: peak_period}";
    match (heights.next(), periods.next()) {
        (None, None) => {}
        (Some(name), None) | (None, Some(name)) => return wrong(&["axes", name], "one axis of a scatter table", both),
        (Some(name), Some(_)) if study.scatter.is_none() => {
            return wrong(&["axes", name], "no scatter", "scatter: the table's file, beside axes");
        }
        (Some(_), Some(_)) => {}
    }
    match heights.next().or_else(|| periods.next()) {
        Some(name) => wrong(&["axes", name], "a second axis of this kind", both),
        None => Ok(()),
    }
}

/// Checks the numbers of seeds, samples and runs.
fn counts(study: &Study) -> Result<(), Wrong> {
    let seeds = &study.seeds;
    if !(1..=MOST_SEEDS).contains(&seeds.count) {
        return wrong(&["seeds", "count"], seeds.count, whole(1, MOST_SEEDS));
    }
    if seeds.first.checked_add(seeds.count).is_none() {
        return wrong(&["seeds", "first"], seeds.first, "a seed with room for count more behind it");
    }
    let samples = study.samples.as_ref().map_or(1, |samples| samples.count);
    if !(1..=MOST_RUNS).contains(&samples) {
        return wrong(&["samples", "count"], samples, whole(1, MOST_RUNS));
    }
    let of_axis = |axis: &StudyAxis| match axis {
        StudyAxis::Values(values) => values.len() as u64,
        StudyAxis::Range(range) => range.count,
        StudyAxis::LatinHypercube(_) | StudyAxis::Scatter(_) => 1,
    };
    let runs = study.axes.values().map(of_axis).fold(samples * seeds.count, u64::saturating_mul);
    if runs > MOST_RUNS {
        let allowed = format!("at most {MOST_RUNS} runs: fewer values, samples or seeds");
        return wrong(&["axes"], format!("{runs} runs"), allowed);
    }
    Ok(())
}

/// Checks the lists of columns and of slopes.
fn lists(study: &Study) -> Result<(), Wrong> {
    let nothing = "an empty list";
    if let Some(rainflow) = &study.rainflow {
        if rainflow.columns.is_empty() {
            return wrong(&["rainflow", "columns"], nothing, "one column or more");
        }
        if rainflow.slopes.is_empty() {
            return wrong(&["rainflow", "slopes"], nothing, "one slope or more, as 3 and 5");
        }
        for (k, slope) in rainflow.slopes.iter().enumerate() {
            if rainflow.slopes[..k].contains(slope) {
                let found = format!("{slope} a second time");
                return wrong(&["rainflow", "slopes", &k.to_string()], found, "each slope once");
            }
        }
    }
    if let Some(peaks) = &study.peaks {
        if peaks.columns.is_empty() {
            return wrong(&["peaks", "columns"], nothing, "one column or more");
        }
        if !(1..=MOST_PEAKS).contains(&peaks.keep) {
            return wrong(&["peaks", "keep"], peaks.keep, whole(1, MOST_PEAKS));
        }
    }
    Ok(())
}

/// Checks that the sea's axes are axes of the study.
fn sea(study: &Study) -> Result<(), Wrong> {
    let sea = &study.sea;
    let given = [
        ("significant_height", &sea.significant_height),
        ("peak_period", &sea.peak_period),
        ("direction", &sea.direction),
    ];
    let names: Vec<&str> = study.axes.keys().map(String::as_str).collect();
    for (quantity, name) in given {
        if let Some(name) = name.as_deref().filter(|name| !names.contains(name)) {
            let allowed = if names.is_empty() {
                "an axis, of which there is none".to_owned()
            } else {
                wording::one_of_with_hint(&names, name)
            };
            return wrong(&["sea", quantity], wording::quoted(name), allowed);
        }
    }
    Ok(())
}

/// Returns the range of a whole number as text.
fn whole(least: u64, most: u64) -> String {
    format!("a whole number from {least} to {most}")
}
