//! Variables of the results, with their indices in a row.

use super::{Sample, Table};
use crate::elements::{Layout, Output, PlacesAlong, VectorFrame};
use crate::model::Model;
use crate::scalar::Scalar;
use indexmap::IndexMap;
use serde::Serialize;

/// One result variable of a model, with its place in a row.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Channel {
    /// Name in a data set.
    pub variable: &'static str,
    /// A short description, for the axis of a plot.
    pub long_name: String,
    /// Its description.
    pub description: &'static str,
    /// SI unit of all its columns; absent if they differ.
    pub unit: Option<&'static str>,
    /// SI unit of each column.
    pub units: Vec<&'static str>,
    /// Frame of the components.
    pub frame: VectorFrame,
    /// Names of the dimensions, slowest first.
    pub dims: Vec<String>,
    /// Labels along each dimension.
    pub labels: Vec<Vec<String>>,
    /// Pattern of the names of its columns, with its labels: `{body}.angular_velocity.{axis}`.
    pub column: String,
    /// Names of its columns in a flat table: `ship.angular_velocity.x`.
    pub columns: Vec<String>,
    /// Places of its labels along lines, if they are points of lines.
    pub along: Option<PlacesAlong>,
    /// Whether it is an output of elements; otherwise it is a variable of the model or the ledger.
    pub of_elements: bool,
    /// First entry in a row.
    pub offset: usize,
    /// Number of entries.
    pub len: usize,
}

/// The channels of a model and its elements, in the order of a row.
#[derive(Clone, Debug, PartialEq)]
pub struct Channels {
    /// Channels in the order of a row.
    pub list: Vec<Channel>,
    /// Index in a row of each number that the elements write.
    places: Vec<usize>,
}

impl Channel {
    /// Returns whether the channel contains the entry with this index of a row.
    pub(super) fn holds(&self, place: usize) -> bool {
        (self.offset..self.offset + self.len).contains(&place)
    }
}

impl Channels {
    /// Returns the channels of a model and its elements: the model's, then those of the elements, then the
    /// ledger's.
    pub fn new<S: Scalar>(model: &Model<S>, layout: &Layout) -> Self {
        let mut channels = Self { list: Vec::new(), places: Vec::new() };
        Table::OF_MODEL.iter().for_each(|entry| channels.push(entry.channel(model)));
        channels.push_outputs(layout);
        Table::<S>::OF_LEDGER.iter().for_each(|entry| channels.push(entry.channel(model)));
        channels
    }

    /// Returns the number of entries in a row.
    pub fn columns(&self) -> usize {
        self.list.last().map_or(0, |channel| channel.offset + channel.len)
    }

    /// Returns the index in a row of the column with this name.
    pub fn place(&self, column: &str) -> Option<usize> {
        self.list.iter().flat_map(|channel| &channel.columns).position(|name| name == column)
    }

    /// Returns the index in a row of a number that the elements write, given its index in the order of
    /// writing.
    pub fn place_of_output(&self, output: usize) -> usize {
        self.places[output]
    }

    /// Returns the index, in the order of writing, of the elements' number at an index of a row; `None` if it
    /// is not a number of an element.
    pub(super) fn output_at(&self, place: usize) -> Option<usize> {
        self.places.iter().position(|&of_output| of_output == place)
    }

    fn push(&mut self, channel: Channel) {
        let offset = self.columns();
        // A model without loops, for example, has no channels of loops.
        if channel.len > 0 {
            self.list.push(Channel { offset, ..channel });
        }
    }

    /// Appends the channels of outputs; outputs of one variable are adjacent, in the order of their elements.
    fn push_outputs(&mut self, layout: &Layout) {
        let mut by_variable: IndexMap<&str, Vec<(usize, &Output)>> = IndexMap::new();
        let mut written = 0;
        for (_, output) in &layout.outputs {
            by_variable.entry(output.variable).or_default().push((written, output));
            written += output.len();
        }
        self.places = vec![0; written];
        let widest = widest(&by_variable);
        for (variable, outputs) in by_variable {
            let mut place = self.columns();
            for (first, output) in &outputs {
                for k in 0..output.len() {
                    self.places[first + k] = place + k;
                }
                place += output.len();
            }
            let outputs: Vec<&Output> = outputs.into_iter().map(|(_, output)| output).collect();
            let dimension = outputs[0].dimension;
            let has_all = widest.get(dimension).is_none_or(|all| *all == labels_of(&outputs));
            let dimension = if has_all { dimension.to_owned() } else { format!("{dimension}_with_{variable}") };
            self.push(channel_of(&outputs, dimension));
        }
    }

    /// Appends one row.
    pub fn write_row<S: Scalar>(&self, sample: &Sample<'_, S>, out: &mut Vec<S>) {
        let first = out.len();
        Table::OF_MODEL.iter().for_each(|entry| (entry.write)(sample, out));
        let outputs = sample.observed.outputs;
        out.resize(out.len() + outputs.len(), S::ZERO);
        for (place, value) in self.places.iter().zip(outputs) {
            out[first + place] = *value;
        }
        Table::OF_LEDGER.iter().for_each(|entry| (entry.write)(sample, out));
    }
}

fn labels_of(outputs: &[&Output]) -> Vec<String> {
    outputs.iter().flat_map(|output| output.labels.clone()).collect()
}

/// Returns for each dimension the longest list of labels of its variables. A variable that only some elements
/// have, such as the torque of drives when others have a force, gets a separate dimension, because a
/// dimension has one list of labels.
fn widest<'a>(by_variable: &IndexMap<&str, Vec<(usize, &'a Output)>>) -> IndexMap<&'a str, Vec<String>> {
    let mut widest: IndexMap<&str, Vec<String>> = IndexMap::new();
    for outputs in by_variable.values() {
        let outputs: Vec<&Output> = outputs.iter().map(|(_, output)| *output).collect();
        let (labels, widest) = (labels_of(&outputs), widest.entry(outputs[0].dimension).or_default());
        if labels.len() > widest.len() {
            *widest = labels;
        }
    }
    widest
}

/// Returns the channel of all outputs of one variable, along a dimension.
fn channel_of(outputs: &[&Output], dimension: String) -> Channel {
    let one = outputs[0];
    let things = labels_of(outputs);
    let components = one.components.labels().map(|labels| labels.iter().map(|label| (*label).to_owned()).collect());
    let columns: Vec<String> = outputs.iter().flat_map(|output| output.columns()).collect();
    let units: Vec<&'static str> = one.units.iter().copied().cycle().take(columns.len()).collect();
    let components_along = one.components.dimension().map(str::to_owned);
    let dims: Vec<String> = [Some(dimension), components_along].into_iter().flatten().collect();
    Channel {
        variable: one.variable,
        long_name: short_name(one.description),
        description: one.description,
        unit: common(&units),
        len: units.len(),
        units,
        frame: one.frame,
        column: column_by(one.variable, &dims, true),
        dims,
        labels: [Some(things), components].into_iter().flatten().collect(),
        columns,
        along: along(outputs),
        of_elements: true,
        offset: 0,
    }
}

/// Returns the places of all labels, if they are points of lines.
fn along(outputs: &[&Output]) -> Option<PlacesAlong> {
    let all = || outputs.iter().filter_map(|output| output.along.as_ref());
    let length = all().next()?.length;
    let lines = all().flat_map(|along| along.lines.iter().cloned()).collect();
    let shares = all().flat_map(|along| along.shares.iter().copied()).collect();
    Some(PlacesAlong { lines, shares, length })
}

/// Returns the pattern of a column's name: the label of the element or body precedes the variable.
pub(super) fn column_by(variable: &str, dims: &[String], thing_leads: bool) -> String {
    let mut parts: Vec<String> = dims.iter().map(|dim| format!("{{{dim}}}")).collect();
    parts.insert(usize::from(thing_leads && !dims.is_empty()), variable.to_owned());
    parts.join(".")
}

/// Returns the common unit of all columns; `None` if they differ.
pub(super) fn common(units: &[&'static str]) -> Option<&'static str> {
    let (first, rest) = units.split_first()?;
    rest.iter().all(|unit| unit == first).then_some(*first)
}

/// Returns the first words of a description, for the axis of a plot.
pub(super) fn short_name(description: &str) -> String {
    let ends = [",", ";", ":", " at its ", " where the hull "].into_iter().filter_map(|end| description.find(end));
    description[..ends.min().unwrap_or(description.len())].to_owned()
}
