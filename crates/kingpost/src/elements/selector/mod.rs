//! A selector: it passes one of several commands to each of its inputs.

pub mod assembly;
pub mod fields;

use super::{Context, Declaration, Element, ElementState, Input, Occurrence};
use crate::scalar::Scalar;

/// Passes the commands of one of its branches to the inputs that it sets; the commands of the other branches have no
/// effect.
#[derive(Clone, Debug)]
pub struct Selector {
    /// Name in the results.
    pub name: String,
    /// The branches.
    pub branches: Vec<String>,
    /// Index of the branch whose commands pass.
    pub selected: usize,
    /// Inputs that it sets.
    pub to: Vec<Input>,
}

impl<S: Scalar> Element<S> for Selector {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let command = |branch: &String, to: &Input| {
            let name = format!("{}.{branch}.{}", self.name, to.name);
            Input { name, signal: None, ..to.clone() }
        };
        let commands = self.branches.iter().flat_map(|branch| self.to.iter().map(move |to| command(branch, to)));
        Declaration {
            inputs: commands.collect(),
            steers: self.to.iter().map(|to| to.name.clone()).collect(),
            ..Declaration::default()
        }
    }

    fn update_controls(
        &mut self,
        at: &Context<'_, S>,
        _read: &[S],
        _own: &mut ElementState<'_, S>,
        inputs: &mut [S],
    ) -> Result<Vec<Occurrence>, String> {
        inputs.copy_from_slice(self.chosen(at.inputs));
        Ok(Vec::new())
    }

    fn at_end(&self, at: &Context<'_, S>, inputs: &mut [S]) {
        inputs.copy_from_slice(self.chosen(at.inputs_at_end));
    }

    fn passes_to(&self, command: usize) -> Option<usize> {
        let (branch, input) = (command / self.to.len(), command % self.to.len());
        (branch == self.selected).then_some(input)
    }
}

impl Selector {
    /// Returns the commands of the selected branch.
    fn chosen<'a, S>(&self, commands: &'a [S]) -> &'a [S] {
        let first = self.selected * self.to.len();
        &commands[first..first + self.to.len()]
    }
}
