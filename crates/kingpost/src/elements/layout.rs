//! Layout of the declarations of all elements: offsets, names, columns.

use super::{AnyElement, Crossing, Declaration, DrawnLine, ElementState, Event, Input, Output, StateDeclaration};
use crate::scalar::Scalar;
use core::ops::Range;
use thiserror::Error;

/// The places of one element's entries.
#[derive(Clone, Debug, PartialEq)]
pub struct StateSlices {
    /// Its states among those of all elements, which follow the ledger's entries in s.
    pub states: Range<usize>,
    /// Its inputs or numbers in d.
    pub inputs: Range<usize>,
    /// Its inputs or numbers in d.
    pub numbers: Range<usize>,
    /// Its modes in m.
    pub modes: Range<usize>,
    /// Whether any of the above has entries, or `seen`.
    pub has_own: bool,
    /// The states of other elements that it sees, among those of all elements.
    pub seen: Vec<Range<usize>>,
    /// Its sampling period, s.
    pub period_s: Option<f64>,
    /// Delay of its sampled outputs, in samples.
    pub delay_samples: usize,
    /// Whether its states stay unchanged while an equilibrium is sought.
    pub keeps_states: bool,
}

/// An indicator of an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Watched {
    /// The element.
    pub element: usize,
    /// Index among its events.
    pub event: usize,
    /// Code of the event.
    pub code: &'static str,
    /// Description of the event.
    pub what: &'static str,
    /// Changes of sign that count.
    pub crossing: Crossing,
}

/// An input that takes the sampled output of an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Wire {
    /// The element that writes the output.
    pub element: usize,
    /// Among the numbers that it writes.
    pub output: usize,
    /// The input, in d.
    pub input: usize,
}

/// An element that reads columns and sets inputs at the start of a step.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Steer {
    /// The element.
    pub element: usize,
    /// The columns that it reads.
    pub reads: Vec<String>,
    /// The inputs that it sets, in d.
    pub inputs: Vec<usize>,
}

/// An output of a sampling element, from which a wire may come.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Signal {
    /// Its flat column: `mru.measured_heave`.
    pub name: String,
    /// Its unit.
    pub unit: &'static str,
    /// The element.
    pub element: usize,
    /// Among the numbers that it writes.
    pub output: usize,
}

/// An input with a signal that does not exist, or whose element does not sample.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("input {input}: found the signal {found:?}, allowed: {allowed}")]
pub struct UnknownSignal {
    /// The input.
    pub input: String,
    /// The name that was given.
    pub found: String,
    /// The existing signals.
    pub allowed: String,
}

/// The declarations of all elements, with their places.
///
/// s holds the ledger's entries, then each element's continuous states; d the table of inputs, then each element's
/// discrete numbers; m each element's modes: always in the order of the elements.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Layout {
    /// Number of entries of s before the elements' states.
    pub ledger: usize,
    /// The places of each element's entries.
    pub slices: Vec<StateSlices>,
    /// Names of the elements.
    pub names: Vec<String>,
    /// The table of inputs with their first values.
    pub inputs: Vec<Input>,
    /// The continuous states by their full names, as `luffing.wanted_length`.
    pub states: Vec<StateDeclaration>,
    /// Names of the discrete numbers.
    pub numbers: Vec<String>,
    /// Names of the modes.
    pub modes: Vec<String>,
    /// The outputs with the element that writes each, in the order of writing.
    pub outputs: Vec<(usize, Output)>,
    /// The lines to draw, in the order of drawing.
    pub lines: Vec<DrawnLine>,
    /// The indicators of all elements.
    pub watched: Vec<Watched>,
    /// The elements that prescribe motions.
    pub prescribing: Vec<usize>,
    /// The elements that may hold constraints, with the places of these among those of all.
    pub holding: Vec<(usize, Range<usize>)>,
    /// The elements that advance their states in explicit schemes.
    pub advancing: Vec<usize>,
    /// The entries of s that are motions of these elements.
    pub motions: Vec<usize>,
    /// Inputs that take a sampled output.
    pub wires: Vec<Wire>,
    /// The elements that set inputs.
    pub steers: Vec<Steer>,
}

impl Layout {
    /// Returns the element that writes an output, and the index of the output among its numbers.
    pub fn writer(&self, output: usize) -> Option<(usize, usize)> {
        let mut first = 0;
        for (element, _) in self.names.iter().enumerate() {
            let written = self.written_by(element);
            if output < first + written {
                return Some((element, output - first));
            }
            first += written;
        }
        None
    }

    /// Returns the number of values that an element writes.
    pub fn written_by(&self, element: usize) -> usize {
        self.outputs.iter().filter(|(writer, _)| *writer == element).map(|(_, output)| output.len()).sum()
    }

    /// Returns the layout of these elements after `ledger` entries of the ledger.
    pub fn new<S: Scalar>(elements: &[AnyElement<S>], ledger: usize) -> Self {
        let declared: Vec<Declaration> = elements.iter().map(|element| element.declare()).collect();
        let mut layout = Self { ledger, ..Self::default() };
        layout.inputs = declared.iter().flat_map(|declared| declared.inputs.clone()).collect();
        let (mut input, mut number) = (0, layout.inputs.len());
        let seen: Vec<Vec<String>> = declared.iter().map(|declared| declared.sees.clone()).collect();
        layout.steers = steers(&declared, &layout.inputs);
        for (element, declared) in declared.into_iter().enumerate() {
            let name = elements[element].name();
            let full = |own: &String| format!("{name}.{own}");
            let own = [declared.states.len(), declared.numbers.len(), declared.modes.len()];
            layout.slices.push(StateSlices {
                has_own: !declared.inputs.is_empty() || !declared.sees.is_empty() || own.iter().any(|count| *count > 0),
                seen: Vec::new(),
                states: range(layout.states.len(), declared.states.len()),
                inputs: range(input, declared.inputs.len()),
                numbers: range(number, declared.numbers.len()),
                modes: range(layout.modes.len(), declared.modes.len()),
                period_s: declared.period_s,
                delay_samples: declared.delay_samples,
                keeps_states: declared.keeps_states,
            });
            (input, number) = (input + declared.inputs.len(), number + declared.numbers.len());
            layout.names.push(name.to_owned());
            let advanced = declared.advances;
            let kept = |own: &StateDeclaration| StateDeclaration { name: full(&own.name), advanced, ..own.clone() };
            layout.states.extend(declared.states.iter().map(kept));
            layout.numbers.extend(declared.numbers.iter().map(full));
            layout.modes.extend(declared.modes.iter().map(full));
            layout.outputs.extend(declared.outputs.into_iter().map(|output| (element, output)));
            layout.lines.extend(declared.lines);
            let watched = |(event, of): (usize, &Event)| {
                let Event { code, what, crossing } = *of;
                Watched { element, event, code, what, crossing }
            };
            layout.watched.extend(declared.events.iter().enumerate().map(watched));
            layout.prescribing.extend(declared.prescribes.then_some(element));
            if declared.holds > 0 {
                let first = layout.holding.last().map_or(0, |(_, places)| places.end);
                layout.holding.push((element, first..first + declared.holds));
            }
            layout.advancing.extend(declared.advances.then_some(element));
        }
        for (element, names) in seen.iter().enumerate() {
            let of =
                |name: &String| Some(layout.slices[layout.names.iter().position(|own| own == name)?].states.clone());
            layout.slices[element].seen = names.iter().filter_map(of).collect();
        }
        let states = layout.states.iter().enumerate();
        layout.motions = states.filter(|(_, own)| own.advanced && !own.remembers).map(|(i, _)| ledger + i).collect();
        layout.lay_wires();
        layout
    }

    /// Connects inputs to signals, each pair by name.
    pub fn connect(&mut self, wires: &[(String, String)]) {
        for (name, signal) in wires {
            let input = self.inputs.iter_mut().find(|input| input.name == *name);
            input.into_iter().for_each(|input| input.signal = Some(signal.clone()));
        }
        self.lay_wires();
    }

    /// Finds the inputs that take an existing signal.
    fn lay_wires(&mut self) {
        let signals = self.signals();
        let wire = |(input, declared): (usize, &Input)| {
            let wanted = declared.signal.as_ref()?;
            let Signal { element, output, .. } = *signals.iter().find(|signal| signal.name == *wanted)?;
            Some(Wire { element, output, input })
        };
        self.wires = self.inputs.iter().enumerate().filter_map(wire).collect();
    }

    /// Checks that every signal named by an input exists.
    ///
    /// # Errors
    /// The first signal that does not exist.
    pub fn check_signals(&self) -> Result<(), UnknownSignal> {
        let signals = self.signals();
        let unknown = |input: &Input| {
            let found = input.signal.clone()?;
            let names = signals.iter().map(|signal| signal.name.as_str());
            let allowed = if signals.is_empty() {
                "none: no element samples".to_owned()
            } else {
                names.collect::<Vec<_>>().join(", ")
            };
            let is_known = signals.iter().any(|signal| signal.name == found);
            (!is_known).then(|| UnknownSignal { input: input.name.clone(), found, allowed })
        };
        self.inputs.iter().find_map(unknown).map_or(Ok(()), Err)
    }

    /// Returns the outputs of the elements that sample.
    pub fn signals(&self) -> Vec<Signal> {
        let mut signals = Vec::new();
        for (element, _) in self.slices.iter().enumerate().filter(|(_, share)| share.period_s.is_some()) {
            let outputs = self.outputs.iter().filter(|(of, _)| *of == element);
            let own = outputs.flat_map(|(_, output)| output.columns().zip(output.units.iter().cycle()));
            signals.extend(own.enumerate().map(|(output, (name, unit))| Signal { name, unit, element, output }));
        }
        signals
    }

    /// Returns the name of the signal or of the element that sets an input; `None` if the user sets it.
    pub fn set_by(&self, input: usize) -> Option<&str> {
        let steered = || self.steers.iter().find(|steer| steer.inputs.contains(&input));
        self.inputs[input].signal.as_deref().or_else(|| Some(self.names[steered()?.element].as_str()))
    }

    /// Returns the length of s.
    pub fn extras(&self) -> usize {
        self.ledger + self.states.len()
    }

    /// Returns the length of d: the inputs, the numbers, the inputs at the end of the step.
    pub fn discrete(&self) -> usize {
        2 * self.inputs.len() + self.numbers.len()
    }

    /// Returns the indices in d of the values of some inputs at the end of the step.
    pub fn ends_of(&self, inputs: Range<usize>) -> Range<usize> {
        let first = self.inputs.len() + self.numbers.len();
        first + inputs.start..first + inputs.end
    }

    /// Returns the index in d of the value of an input at the end of the step.
    pub fn end_of(&self, input: usize) -> usize {
        self.inputs.len() + self.numbers.len() + input
    }

    /// Returns the indices of an element's states in s.
    pub fn states_of(&self, element: usize) -> Range<usize> {
        let Range { start, end } = self.slices[element].states;
        self.ledger + start..self.ledger + end
    }

    /// Returns an element's entries in the whole state.
    pub fn own<'a, S>(&self, element: usize, s: &'a mut [S], d: &'a mut [S], m: &'a mut [i64]) -> ElementState<'a, S> {
        let StateSlices { numbers, modes, .. } = &self.slices[element];
        let (numbers, modes) = (&mut d[numbers.clone()], &mut m[modes.clone()]);
        ElementState { states: &mut s[self.states_of(element)], numbers, modes, also: None }
    }
}

/// Returns the elements that read columns or set inputs, with the existing inputs.
fn steers(declared: &[Declaration], inputs: &[Input]) -> Vec<Steer> {
    let of = |(element, declared): (usize, &Declaration)| {
        let place = |name: &String| inputs.iter().position(|input| input.name == *name);
        let inputs: Vec<usize> = declared.steers.iter().filter_map(place).collect();
        (!inputs.is_empty() || !declared.reads.is_empty()).then(|| Steer {
            element,
            reads: declared.reads.clone(),
            inputs,
        })
    };
    declared.iter().enumerate().filter_map(of).collect()
}

fn range(start: usize, len: usize) -> Range<usize> {
    start..start + len
}
