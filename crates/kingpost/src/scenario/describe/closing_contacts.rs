//! Warnings of contacts that would make the step too long once they close.

use crate::dynamics::LinkKinematics;
use crate::elements::contact::ClosedContact;
use crate::elements::{Contact, Context, significant};
use crate::simulation::{SchemeName, Setup};
use core::f64::consts::{SQRT_2, TAU};

/// Warns of contacts that are open at the start and whose load, once they close, moves too fast for the step.
pub fn warnings(setup: &Setup) -> Vec<String> {
    let Setup { model, world, elements, settings, q, v, .. } = setup;
    let Some((scheme, largest_phase)) = limit(settings.scheme) else { return Vec::new() };
    let mut links = LinkKinematics::new(model);
    links.update(model, q, v);
    let at = Context::at_rest(world, model, &links, (q, v));
    let warning = |contact: &Contact| {
        let ClosedContact { spots, frequency_rad_s } = contact.once_closed(&at)?;
        let longest_s = largest_phase / frequency_rad_s;
        (settings.step_s > longest_s).then(|| {
            let points = if spots == 1 { "one point".to_owned() } else { format!("{spots} points") };
            format!(
                "{}: the step of {} s is too long for {scheme} once this contact closes: on {points} of {} kN/m the load then moves \
                 with a period down to {} s, which grows with steps longer than {} s; take shorter steps, dormand_prince, which \
                 chooses its own steps, or a softer contact",
                contact.name,
                significant(settings.step_s, 6),
                significant(contact.stiffness / 1e3, 3),
                significant(TAU / frequency_rad_s, 2),
                significant(longest_s, 2)
            )
        })
    };
    Contact::among(elements).filter_map(warning).collect()
}

/// Returns the name of an explicit scheme and the largest product of step and frequency, rad, at which it is stable: for
/// Euler's explicit methods with the best damping (Hairer & Wanner, *Solving Ordinary Differential Equations II*, 1996, sec.
/// IV.2).
fn limit(scheme: SchemeName) -> Option<(&'static str, f64)> {
    match scheme {
        SchemeName::RungeKutta4 => Some(("rk4", 2.0 * SQRT_2)),
        SchemeName::ForwardEuler => Some(("forward_euler", 2.0)),
        SchemeName::MidpointEuler => Some(("midpoint_euler", 2.0)),
        SchemeName::SemiImplicitEuler => Some(("semi_implicit_euler", 2.0)),
        SchemeName::DormandPrince(_)
        | SchemeName::Newmark { .. }
        | SchemeName::GeneralizedAlpha { .. }
        | SchemeName::ImplicitMidpoint => None,
    }
}
