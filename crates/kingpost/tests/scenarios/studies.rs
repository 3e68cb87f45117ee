//! Study files: defaults, and errors with their place.

use kingpost::scenario::schema::ParameterValue;
use kingpost::scenario::study::{self, Study, StudyAxis};

const HEAD: &str = "version: 1\ntitle: Slewing\nscenario: paper\n";

fn read(rest: &str) -> Result<Study, String> {
    study::read(&format!("{HEAD}{rest}"), "s.yaml").map(|(study, _)| study).map_err(|error| error.to_string())
}

#[test]
fn omitted_fields_of_a_study_have_defaults() {
    let study = read("").unwrap();
    assert_eq!((study.seeds.first, study.seeds.count), (1, 1));
    assert_eq!((study.after_s.get(), study.acceptance.get(), study.operation_s), (0.0, 0.1, None));
    assert!(study.axes.is_empty() && study.limits.is_empty() && study.record.is_empty());
    assert!(study.one_off.is_none() && study.stationary_steps.is_empty());
}

#[test]
fn a_study_reads_back_from_what_it_is_written_as() {
    let study = read(
        "axes:\n  crane_x_m: {range: {from: -10, to: 0, count: 6}}\n  load: {values: [true, false]}\n  x: {latin_hypercube: {from: \
         0, to: 1}}\nsamples: {count: 9}\nlimits:\n  roll: {column: ship.roll, within: 3, unit: deg}\npeaks: {columns: \
         [ship.roll]}\nrainflow: {columns: ['*'], slopes: [3, 5]}\nsea: {direction: x}\none_off: \
         true\nstationary_steps: {hold over the side: 1800}\n",
    )
    .unwrap();
    let text = serde_json::to_string(&study).unwrap();
    assert_eq!(study::read(&text, "again.json").unwrap().0, study);
    assert_eq!(study.axes["load"], StudyAxis::Values([true, false].map(ParameterValue::Boolean).to_vec()));
    assert_eq!((study.one_off, study.stationary_steps["hold over the side"].get()), (Some(true), 1800.0));
    assert_eq!((study.samples.unwrap().seed, study.peaks.unwrap().keep), (1, 32));
}

#[test]
fn places_are_those_in_the_text() {
    let text = format!("{HEAD}axes:\n  crane_x_m: {{values: [1, 2]}}\n");
    let (_, places) = study::read(&text, "s.yaml").unwrap();
    assert_eq!(places["axes.crane_x_m.values.1"], [5, 27]);
    assert_eq!(places["title"], [2, 8]);
}

#[test]
fn an_error_has_its_place_the_found_value_and_the_allowed_values() {
    for (rest, message) in [
        ("axes: {x: {values: []}}", "s.yaml:4:20: axes.x.values: found an empty list, allowed: one value or more"),
        (
            "axes: {x: {values: [1, 1]}}",
            "s.yaml:4:24: axes.x.values.1: found 1 a second time, allowed: each value once",
        ),
        ("axes: {x: {values: [1, a]}}", "axes.x.values.1: found the text \"a\", allowed: values of one kind"),
        ("axes: {x: {valus: [1]}}", "axes.x: found \"valus\", allowed: one of values, range, latin_hypercube, scatter"),
        ("axes: {x: [1, 2]}", "axes.x: found [1, 2], allowed: one of values, range"),
        (
            "axes: {x: {range: {from: 1, to: 1, count: 3}}}",
            "axes.x.range.to: found 1, allowed: a number other than from, 1",
        ),
        (
            "axes: {x: {range: {from: 1, to: 2, count: 1}}}",
            "axes.x.range.count: found 1, allowed: a whole number from 2",
        ),
        ("axes: {x: {latin_hypercube: {from: 1, to: 2}}}", "axes.x: found no samples, allowed: samples: {count: 200"),
        ("samples: {count: 3}", "samples: found no axis latin_hypercube"),
        ("axes: {x: {scatter: peak_period}}", "axes.x: found one axis of a scatter table, allowed: one axis {scatter:"),
        (
            "axes: {x: {scatter: peak_period}, y: {scatter: significant_height}}",
            "axes.y: found no scatter, allowed: scatter: the table's file",
        ),
        ("set: {x: 1}\naxes: {x: {values: [1]}}", "s.yaml:5:11: axes.x: found a name that is in set too"),
        ("axes: {seed: {values: [1]}}", "axes.seed: found the seed, allowed: what cases differ in; seeds has"),
        ("seeds: {count: 0}", "s.yaml:4:16: seeds.count: found 0, allowed: a whole number from 1 to 100000"),
        ("seeds: {count: 1000000000}", "seeds.count: found 1000000000, allowed: a whole number from 1 to 100000"),
        ("seeds: {first: 18446744073709551615, count: 2}", "seeds.first: found 18446744073709551615"),
        (
            "axes: {x: {range: {from: 0, to: 1, count: 1000}}}\nseeds: {count: 2000}",
            "axes: found 2000000 runs, allowed: at most 1000000 runs",
        ),
        ("peaks: {columns: [a], keep: 0}", "peaks.keep: found 0, allowed: a whole number from 1 to 1000"),
        ("rainflow: {columns: [a], slopes: [3, 3]}", "rainflow.slopes.1: found 3 a second time"),
        ("rainflow: {columns: [a], slopes: [0]}", "rainflow.slopes.0: found 0, allowed: a number greater than 0"),
        ("stationary_steps: {hold: 0}", "stationary_steps.hold: found 0, allowed: a number greater than 0"),
        ("acceptance: 1", "acceptance: found 1, allowed: a number greater than 0 and less than 1"),
        ("acceptence: 0.1", "found an unknown field"),
        ("axes: {x: {values: [1]}}\nsea: {direction: y}", "s.yaml:5:18: sea.direction: found \"y\", allowed: x"),
        ("scenario: ' '", "scenario a second time"),
        ("[", "s.yaml:"),
    ] {
        let found = read(rest).unwrap_err();
        assert!(found.contains(message), "{rest}\n{found}\n{message}");
    }
    assert!(study::read("", "s.yaml").unwrap_err().to_string().contains("allowed: a study in YAML or JSON"));
    assert!(study::read("title: x", "s.yaml").unwrap_err().to_string().contains("version: found nothing"));
}
