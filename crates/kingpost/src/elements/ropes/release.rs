//! Release of a rope by its lever, and hooking on again.

use super::{IS_HOOKED_ON, IS_RELEASED, PARTED, RELEASED, Rope, SLACK};
use crate::elements::{Context, ElementState, Input};
use crate::scalar::Scalar;

/// Whether a rope in this mode carries no load, because it is released or has parted.
pub(super) fn is_off(mode: i64) -> bool {
    matches!(mode, RELEASED | PARTED)
}

impl<S: Scalar> Rope<S> {
    /// Returns the input that releases it and hooks it on.
    pub(super) fn lever(&self) -> Option<Input> {
        let start = if self.begins_released { 1.0 } else { 0.0 };
        self.can_be_released.then(|| Input::lever(&self.name, 0.0, start))
    }

    /// Returns the length by which the path must shorten before the rope can be hooked on, m; positive while the lever
    /// commands the release.
    pub(super) fn out_of_reach(&self, at: &Context<'_, S>, stretch: S) -> S {
        if at.is_let_go() { S::ONE } else { stretch }
    }

    /// Returns the mode after a move of its lever, for a rope that has not parted; `None` if the mode does not depend
    /// on the lever.
    pub(super) fn hook_or_release(&mut self, at: &Context<'_, S>, own: &mut ElementState<'_, S>) -> Option<i64> {
        match (own.modes[0] == RELEASED, at.is_let_go()) {
            (false, false) => None,
            (true, true) => Some(RELEASED),
            (false, true) => {
                own.also = Some(IS_RELEASED);
                Some(RELEASED)
            }
            (true, false) => {
                let stretch = self.laid(at).stretch;
                let within_reach = stretch.all(|more| more < 0.0);
                own.also = within_reach.then_some(IS_HOOKED_ON);
                Some(if within_reach { SLACK } else { RELEASED })
            }
        }
    }
}
