//! Assembly of a selector.

use crate::elements::{AnyElement, Selector};
use crate::scenario::assembly::FieldError;
use crate::scenario::assembly::assemble::{Assemble, Surroundings};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema;
use crate::scenario::wording::one_of_with_hint;

impl<S: Quantity> Assemble<S> for schema::Selector {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        let lead = format!("controllers.{name}.selector");
        if self.steers.is_empty() {
            return Err(FieldError::new(format!("{lead}.steers"), "none", "at least one"));
        }
        let branches: Vec<&str> = self.branches.iter().map(|branch| branch.as_str()).collect();
        if let Some(k) = (1..branches.len()).find(|&k| branches[..k].contains(&branches[k])) {
            let found = format!("{} a second time", branches[k]);
            return Err(FieldError::new(format!("{lead}.branches.{k}"), found, "each name once"));
        }
        let Some(selected) = branches.iter().position(|branch| *branch == self.selected.as_str()) else {
            let allowed = one_of_with_hint(&branches, &self.selected);
            return Err(FieldError::new(format!("{lead}.selected"), &self.selected, allowed));
        };
        let branches = branches.into_iter().map(str::to_owned).collect();
        let to = self.steers.iter().filter_map(|target| at.input(&target.to)).collect();
        Ok(vec![Box::new(Selector { name: name.to_owned(), branches, selected, to })])
    }
}
