//! Forces and errors of closed loops.

use super::Sample;
use crate::model::Model;
use crate::scalar::Scalar;
use crate::spatial::Wrench;

/// Returns the names of the loops.
pub(super) fn names<S: Scalar>(model: &Model<S>) -> Vec<String> {
    model.loops.iter().map(|closed| closed.name.clone()).collect()
}

/// Writes the wrench that each loop exerts on its second body, about the second attachment, in the axes of
/// the first: `sum lambda W`. W is about the first attachment; the line of action of its force passes through
/// the second.
pub(super) fn reaction<S: Scalar>(x: &Sample<'_, S>, out: &mut Vec<S>) {
    let solver = x.observed.loops;
    let mut own = solver.rows().iter().zip(solver.multipliers());
    for closed in &x.observed.model.loops {
        let mut sum = Wrench::zero();
        for (row, lambda) in own.by_ref().take(closed.constraints.len()) {
            sum += row.at_second() * *lambda;
        }
        out.extend(sum.force.0);
        out.extend(sum.moment.0);
    }
}

/// Writes phi of each constraint.
pub(super) fn error<S: Scalar>(x: &Sample<'_, S>, out: &mut Vec<S>) {
    out.extend(x.observed.loops.rows().iter().map(|row| row.residual));
}
