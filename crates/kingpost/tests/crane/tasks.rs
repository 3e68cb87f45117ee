//! Tasks: stages that whoever moves the levers brings about.

use crate::common;
use crate::operations::{PUSH_COAST_BRAKE, refused, run, slide};

use common::simulation;
use kingpost::scenario::read;

/// A task for the slide: beyond 2 m, and then at rest for half a second.
const TASK: &str = "task:
  text: Bring the cage beyond 2 m, and let it rest there.
  mark: {body: cage, position_m: [0.5, 0, 0.1], radius_m: 0.3}
  stages:
    - {name: beyond 2 m, until: {value: {column: slide.joint_position, above: 2}}}
    - {name: at rest, until: {holds: {for_s: 0.5, condition: {value: {column: slide.joint_velocity, above: -0.1, below: 0.1}}}}}
";

#[test]
fn stages_of_a_task_end_by_their_conditions_while_a_hand_or_an_operation_moves_the_levers() {
    let found = run(&slide(0.01, &format!("{PUSH_COAST_BRAKE}{TASK}")));
    let of_task = found.events().iter().filter(|event| event.element == "task");
    let events: Vec<(f64, &str)> = of_task.map(|event| (event.time_s, event.what.as_ref())).collect();
    // At 5 m/s^2 the cage passes 2 m at sqrt(0.8) s; it stands from 2.3 s on (steps_start_and_end_by_their_conditions).
    let [(_, "begins \"beyond 2 m\""), (beyond_s, "begins \"at rest\""), (ends_s, "ends")] = events[..] else {
        panic!("{events:?}")
    };
    assert!((0.8_f64.sqrt()..0.8_f64.sqrt() + 0.0101).contains(&beyond_s), "{beyond_s}");
    assert!((2.78..2.84).contains(&ends_s), "{ends_s}");
    // By hand: the saved moves become the operation, and the task stays.
    let mut by_hand = simulation(&slide(0.01, TASK));
    by_hand.set_input("push", 1.0).unwrap();
    by_hand.step(50).unwrap();
    let scenario = read(&slide(0.01, TASK), "slide.yaml", &[]).unwrap();
    let replay = scenario.replay(&by_hand).unwrap();
    assert!(replay.operation.is_some() && replay.task == scenario.task);
}

#[test]
fn the_description_has_the_task_with_its_mark() {
    let task = |text: &str| read(&slide(0.01, text), "slide.yaml", &[]).unwrap().describe().unwrap().task;
    let found = task(TASK).expect("a task");
    assert_eq!(found.text, "Bring the cage beyond 2 m, and let it rest there.");
    assert_eq!(found.stages[0].until, "slide.joint_position above 2 m");
    let mark = found.mark.expect("a mark");
    assert_eq!((mark.body, mark.position_m, mark.radius_m), (Some(0), [0.5, 0.0, 0.1], 0.3));
    assert_eq!(task(&TASK.replace("task:", "task:\n  enabled: false")), None);
    assert_eq!(task(""), None);
}

#[test]
fn mistakes_in_a_task_are_refused_by_their_fields() {
    refused(&slide(0.01, "task: {text: Lift, stages: []}\n"), "task.stages: found none, allowed: at least one stage");
    refused(
        &slide(0.01, &TASK.replace("slide.joint_position", "slide.position")),
        "task.stages.0.until.value.column: found",
    );
    refused(&slide(0.01, &TASK.replace("body: cage", "body: box")), "task.mark.body: found");
}
