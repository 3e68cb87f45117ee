//! An anemometer: wind speed, and wind direction relative to a body.

use super::{Context, Declaration, Element, Output};
use crate::scalar::Scalar;
use crate::world::GustsAtHeight;

/// Outputs the wind over ground at its reference height: speed with gusts and mean speed, m/s, and the direction from
/// which it blows, relative to a body, from -pi to pi: 0 from ahead, positive from starboard. Relative to the world,
/// "ahead" is along x.
#[derive(Clone, Debug)]
pub struct Anemometer<S = f64> {
    /// Label in the results: the body's name.
    pub label: String,
    /// The body; `None` is the world.
    pub body: Option<usize>,
    /// Gusts at the reference height; `None` for a steady wind.
    pub gusts: Option<GustsAtHeight<S>>,
}

impl<S: Scalar> Element<S> for Anemometer<S> {
    fn declare(&self) -> Declaration {
        let number =
            |variable, description, unit| Output::number(variable, description, "seen_from", &self.label, unit);
        let outputs = vec![
            number("wind_speed", "wind speed at its reference height, with gusts", &["m/s"]),
            number("mean_wind_speed", "mean wind speed at its reference height", &["m/s"]),
            number(
                "wind_direction",
                "direction from which the wind blows, relative to a ship: 0 from ahead, positive from starboard",
                &["rad"],
            ),
        ];
        Declaration { outputs, ..Declaration::default() }
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        let Some(wind) = &at.world.wind else {
            out.extend([S::ZERO; 3]);
            return;
        };
        let gust = self.gusts.as_ref().filter(|_| at.evaluation.has_waves());
        let gust = gust.map_or(S::ZERO, |gusts| gusts.speed(at.clock.time_s));
        let [ahead_x, ahead_y] = self.body.map_or([S::ONE, S::ZERO], |body| {
            let ahead = at.links.body_frame(at.model, body).rotation.column(0);
            [ahead[0], ahead[1]]
        });
        let [to_x, to_y] = wind.direction;
        let (ahead, starboard) = (-(to_x * ahead_x + to_y * ahead_y), to_y * ahead_x - to_x * ahead_y);
        out.extend([wind.speed + gust, wind.speed, starboard.atan2(ahead)]);
    }
}
