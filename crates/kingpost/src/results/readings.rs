//! Selected columns of the results, without the rest of a row.

use super::channels::Channels;
use super::{Sample, Table};
use crate::elements::Layout;
use crate::plant::ObservedPart;
use crate::scalar::Scalar;

/// Columns that are read at every step, and the part of an observation that they need: a height, for example,
/// needs no accelerations.
#[derive(Clone, Debug, Default)]
pub struct Readings<S> {
    sources: Vec<Source>,
    extent: ObservedPart,
    row: Vec<S>,
}

/// The source of a column.
#[derive(Clone, Copy, Debug)]
enum Source {
    /// A number of an entry in the table of the model's channels.
    Motion { entry: usize, number: usize },
    /// An output of the observed elements.
    Element { output: usize },
    /// An entry of a row.
    Row { place: usize },
    /// A state of an element, by its distance from the end of s.
    State { from_end: usize },
}

/// Value to which a name refers.
#[derive(Clone, Copy, Debug)]
enum Named {
    /// An entry of a row.
    Column(usize),
    /// A state of an element, by its distance from the end of s.
    State(usize),
}

impl Named {
    fn of(name: &str, channels: &Channels, layout: &Layout) -> Option<Self> {
        let state = || layout.states.iter().position(|state| state.name == name);
        channels.place(name).map(Self::Column).or_else(|| Some(Self::State(layout.states.len() - state()?)))
    }

    fn in_a_row(self) -> Source {
        match self {
            Self::Column(place) => Source::Row { place },
            Self::State(from_end) => Source::State { from_end },
        }
    }
}

impl<S: Scalar> Readings<S> {
    /// Creates the readings of these columns, or of states of elements by their names; names that do not
    /// exist are ignored.
    pub fn new(columns: &[String], channels: &Channels, layout: &Layout) -> Self {
        let named: Vec<Named> = columns.iter().filter_map(|column| Named::of(column, channels, layout)).collect();
        Self::of_motion(&named, channels, layout).unwrap_or_else(|| Self {
            sources: named.into_iter().map(Named::in_a_row).collect(),
            extent: ObservedPart::Everything,
            row: Vec::new(),
        })
    }

    /// Returns the readings if they need only the motion and the outputs of elements, otherwise `None`.
    fn of_motion(named: &[Named], channels: &Channels, layout: &Layout) -> Option<Self> {
        let writer = |named: &Named| match named {
            Named::Column(place) => Some(layout.writer(channels.output_at(*place)?)?.0),
            Named::State(_) => None,
        };
        let mut elements: Vec<usize> = named.iter().filter_map(writer).collect();
        elements.sort_unstable();
        elements.dedup();
        let source = |named: &Named| {
            let Named::Column(place) = *named else { return Some(named.in_a_row()) };
            let Some(output) = channels.output_at(place) else {
                let channel = channels.list.iter().find(|channel| channel.holds(place))?;
                let entry = Table::<S>::OF_MODEL.iter().position(|entry| entry.variable == channel.variable)?;
                let of_motion = Table::<S>::OF_MODEL[entry].of_motion;
                return of_motion.then_some(Source::Motion { entry, number: place - channel.offset });
            };
            let (element, number) = layout.writer(output)?;
            let before = elements.iter().take_while(|&&other| other != element);
            Some(Source::Element { output: before.map(|&other| layout.written_by(other)).sum::<usize>() + number })
        };
        let sources = named.iter().map(source).collect::<Option<Vec<_>>>()?;
        Some(Self { sources, extent: ObservedPart::MotionAnd(elements), row: Vec::new() })
    }

    /// Returns whether there is nothing to read.
    pub fn is_empty(&self) -> bool {
        self.sources.is_empty()
    }

    /// Returns the part that an observation must contain.
    pub fn extent(&self) -> &ObservedPart {
        &self.extent
    }

    /// Writes the columns, in their order, from an observation of this part.
    pub fn read(&mut self, sample: &Sample<'_, S>, channels: &Channels, out: &mut Vec<S>) {
        out.clear();
        let row = &mut self.row;
        row.clear();
        if self.extent == ObservedPart::Everything {
            channels.write_row(sample, row);
        }
        for source in &self.sources {
            out.push(match *source {
                Source::Row { place } => row[place],
                Source::State { from_end } => sample.s[sample.s.len() - from_end],
                Source::Element { output } => sample.observed.outputs[output],
                Source::Motion { entry, number } => {
                    row.clear();
                    (Table::OF_MODEL[entry].write)(sample, row);
                    row[number]
                }
            });
        }
    }
}
