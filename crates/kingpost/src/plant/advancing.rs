//! Elements that advance their states themselves in explicit schemes.

use super::Plant;
use super::element_contexts::ElementContexts;
use crate::elements::{EvaluationMode, NotAdvanced};
use crate::integrate::{Stage, StepError};
use crate::ledger;
use crate::scalar::Scalar;

impl<S: Scalar> Plant<S> {
    /// Begins a step at its base.
    pub(super) fn begin_advancing(&mut self, base: Stage<'_, S>) {
        if self.layout.advancing.is_empty() || !self.evaluation.runs() {
            return;
        }
        self.evaluation = EvaluationMode::Stepping;
        self.links.update(&self.model, base.q, base.v);
        let Self { model, world, links, elements, layout, evaluation, .. } = self;
        let contexts = ElementContexts::new(layout, world, model, links, *evaluation, base);
        for &i in &layout.advancing {
            let Some(element) = elements[i].advancing() else { continue };
            element.begin_step(&contexts.shared, &base.s[layout.states_of(i)]);
        }
    }

    /// Writes the states of the elements at a stage; at the end of a step also heat and work to the ledger.
    pub(super) fn advance_elements(&mut self, at: Stage<'_, S>, s: &mut [S], is_end: bool) -> Result<(), StepError> {
        if self.evaluation != EvaluationMode::Stepping {
            return Ok(());
        }
        self.links.update(&self.model, at.q, at.v);
        let Self { model, world, links, elements, layout, evaluation, .. } = self;
        let contexts = ElementContexts::new(layout, world, model, links, *evaluation, at);
        let mut advanced = Ok(());
        for &i in &layout.advancing {
            let Some(element) = elements[i].advancing() else { continue };
            let own = &mut s[layout.states_of(i)];
            if let Err(NotAdvanced { move_m, allowed_m, iterations }) = element.advance(&contexts.shared, own) {
                let (name, time_s) = (layout.names[i].clone(), at.interval.end_s);
                advanced = Err(StepError::LineNotConverged { name, time_s, move_m, allowed_m, iterations });
                break;
            }
            if is_end {
                let [heat, work] = element.end_step(&contexts.shared, own);
                if layout.ledger > 0 {
                    s[ledger::ENERGY_DISSIPATED] += heat;
                    s[ledger::WORK_BY_OUTSIDE] += work;
                }
            }
        }
        if is_end || advanced.is_err() {
            self.evaluation = EvaluationMode::Running;
        }
        advanced
    }
}
