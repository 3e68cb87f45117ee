//! Actions of elements during the search for an equilibrium.

use super::Plant;
use super::element_contexts::ElementContexts;
use crate::elements::{AnyElement, EvaluationMode};
use crate::integrate::{Interval, Stage};
use crate::scalar::Scalar;
use crate::spatial::Symmetric3;

impl<S: Scalar> Plant<S> {
    /// Sets the purpose of the following evaluations.
    pub fn set_evaluation_mode(&mut self, evaluation: EvaluationMode) {
        self.evaluation = evaluation;
        if let Some(tangent) = self.tangent_mut() {
            tangent.set_evaluation_mode(evaluation);
        }
    }

    /// Returns the trims of the elements that hold the model in place, in the order of the elements.
    pub fn trims(&self) -> Vec<Vec<S>> {
        self.elements.iter().filter_map(|element| Some(element.settling()?.trim().to_vec())).collect()
    }

    /// Sets the trims of the elements that hold the model in place.
    pub fn set_trims(&mut self, trims: &[Vec<S>]) {
        let settling = self.elements.iter_mut().filter_map(|element| element.settling_mut());
        settling.zip(trims).for_each(|(settling, trim)| settling.set_trim(trim));
    }

    /// Returns the elements of the plant, mutable.
    pub fn elements_mut(&mut self) -> &mut [AnyElement<S>] {
        &mut self.elements
    }

    /// Sets the covariances of the water's relative velocities at the nodes of each element with
    /// [random drag](crate::elements::RandomDrag), in the order of the elements.
    pub fn set_spreads(&mut self, spreads: &[Vec<Symmetric3>]) {
        let drags = self.elements.iter_mut().filter_map(|element| element.random_drag_mut());
        drags.zip(spreads).for_each(|(drag, spread)| drag.set_spread(spread));
        if let Some(tangent) = self.tangent_mut() {
            tangent.plant_mut().set_spreads(spreads);
        }
    }

    /// Transfers the holding forces to the elements' trims, during the search for an equilibrium. Returns the
    /// largest remaining deviation, m or rad.
    pub fn take_over(&mut self, q: &[S], v: &[S], s: &[S]) -> S {
        self.links.update(&self.model, q, v);
        let Self { model, world, links, layout, evaluation, elements, .. } = self;
        let mut contexts = ElementContexts::new(layout, world, model, links, *evaluation, at_rest(q, v, s));
        let off = elements
            .iter_mut()
            .enumerate()
            .filter_map(|(i, element)| element.settling_mut().map(|settling| settling.take_over(contexts.of(i))));
        let off = off.fold(S::ZERO, |most, off| most.select_less(off, || off, || most));
        let trims: Vec<Vec<f64>> =
            self.trims().iter().map(|trim| trim.iter().map(|entry| entry.value()).collect()).collect();
        if let Some(tangent) = self.tangent_mut() {
            tangent.set_trims(&trims);
        }
        off
    }

    /// Returns, during the search for an equilibrium, the first element that cannot provide its holding
    /// force, and the required utilisation.
    pub fn overloaded(&mut self, q: &[S], v: &[S], s: &[S]) -> Option<(String, S)> {
        self.links.update(&self.model, q, v);
        let at = at_rest(q, v, s);
        let mut contexts =
            ElementContexts::new(&self.layout, &self.world, &self.model, &self.links, self.evaluation, at);
        let mut used = self.elements.iter().enumerate().filter_map(|(i, element)| {
            Some((element.name().to_owned(), element.settling()?.utilisation(contexts.of(i))))
        });
        used.find(|(_, utilisation)| !utilisation.all(|utilisation| utilisation <= 1.0))
    }
}

fn at_rest<'a, S>(q: &'a [S], v: &'a [S], s: &'a [S]) -> Stage<'a, S> {
    Stage { time_s: 0.0, interval: Interval { start_s: 0.0, end_s: 0.0 }, q, v, s, d: &[], m: &[] }
}
