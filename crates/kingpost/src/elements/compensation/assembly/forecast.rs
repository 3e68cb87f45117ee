//! Assembly of a forecast of the heave.

use crate::elements::AnyElement;
use crate::elements::compensation::assembly::{MotionSource, MotionUnit, band, check, unit};
use crate::elements::compensation::{Dynamics, Estimator, FilterBank, HeaveForecast, Prediction, SCORED};
use crate::scenario::assembly::FieldError;
use crate::scenario::assembly::assemble::{Assemble, Surroundings};
use crate::scenario::assembly::attachments::attachment;
use crate::scenario::leaf::Quantity;
use crate::scenario::schema;

/// Leads in the shortest period: between two of them a peak is missed by less than 1 - cos(pi / 16), 2 %.
const LEADS: f64 = 16.0;
/// Longest periods in which the filters settle: their slowest state decays over 1.25 of them.
const SETTLING: f64 = 2.0;
/// Longest periods over which errors are measured before a forecast is ready: a few independent ones.
const MEASURING: f64 = 4.0;
/// Largest number of samples up to the horizon: it limits the kept forecasts.
const MOST_SAMPLES: f64 = 1e3;

impl<S: Quantity> Assemble<S> for schema::HeaveForecast<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        let lead = format!("controllers.{name}.heave_forecast");
        let (period_s, horizon_s) = (self.period_s.get(), self.horizon_s.get());
        check(at.scenario, name, &lead, period_s)?;
        if !self.enabled {
            return Ok(Vec::new());
        }
        let pin = schema::Pin { body: self.body.clone(), position_m: self.position_m };
        let point = attachment(at.scenario, at.model, &format!("{lead}.position_m"), &pin)?;
        let least_s = SCORED as f64 * period_s;
        if horizon_s < least_s || horizon_s > MOST_SAMPLES * period_s {
            let allowed = format!("{least_s} s to {} s, 4 to {MOST_SAMPLES} times period_s", MOST_SAMPLES * period_s);
            return Err(FieldError::new(format!("{lead}.horizon_s"), horizon_s, allowed));
        }
        let periods_s = [self.shortest_period_s.get(), self.longest_period_s.get()];
        let mut band = band(&lead, periods_s, self.noise_share.get(), period_s)?;
        band.peak_period_s = self.peak_period_s.map(|period| period.get());
        if let Some(found) = band.peak_period_s.filter(|peak_s| !(periods_s[0]..=periods_s[1]).contains(peak_s)) {
            let allowed = format!("{} to {} s, the shortest and the longest period", periods_s[0], periods_s[1]);
            return Err(FieldError::new(format!("{lead}.peak_period_s"), found, allowed));
        }
        let bank = FilterBank::new(band);
        let source = MotionSource { sensor: Some(&self.sensor), horizontal: false, prediction: None };
        let Some(unit) = unit(&lead, &source, at.elements)? else { return Ok(Vec::new()) };
        let samples = |time_s: f64| libm::round(time_s / period_s) as i64;
        let (leads, scored) = leads(samples(horizon_s), periods_s[0] / LEADS / period_s);
        let leads_s: Vec<f64> = leads.iter().map(|samples| *samples as f64 * period_s).collect();
        let prediction = prediction(bank, &unit, &leads_s);
        let settles = samples(SETTLING * periods_s[1]);
        Ok(vec![Box::new(HeaveForecast {
            name: name.to_owned(),
            error_share: error_share(&prediction.bank, unit.age_s + horizon_s),
            estimator: Estimator { measurement: unit.measurement(), prediction: Some(prediction), period_s },
            point,
            leads_s,
            scored,
            margin: self.margin.get(),
            settles: [settles, settles + samples(horizon_s) + samples(MEASURING * periods_s[1])],
        })])
    }
}

/// Returns the leads in samples, from 0 to the horizon, and the places of those whose errors are measured.
fn leads(horizon: i64, apart: f64) -> (Vec<i64>, [(usize, usize); SCORED]) {
    let scored: [i64; SCORED] = core::array::from_fn(|k| horizon * (k as i64 + 1) / SCORED as i64);
    let apart = (libm::floor(apart) as usize).max(1);
    let mut leads: Vec<i64> = (0..horizon).step_by(apart).chain(scored).collect();
    leads.sort_unstable();
    leads.dedup();
    let place = |samples: i64| (leads.partition_point(|lead| *lead < samples), samples as usize);
    let scored = scored.map(place);
    (leads, scored)
}

/// Returns the prediction of the height at these leads, s.
fn prediction<S: Quantity>(bank: FilterBank, unit: &MotionUnit<S>, leads_s: &[f64]) -> Prediction<S> {
    let weights = |lead_s: &f64, high_pass| {
        let height = Dynamics { high_pass, delay: S::constant(unit.age_s + lead_s), lag: S::ZERO };
        bank.position_weights(|frequency| height.position(frequency))
    };
    // The high-pass filter acts on heave only, not on roll and pitch.
    let results =
        leads_s.iter().map(|lead_s| [unit.high_pass, None].map(|high_pass| weights(lead_s, high_pass))).collect();
    Prediction {
        results,
        position: Vec::new(),
        age: S::constant(unit.age_s),
        fades: bank.fades(),
        correction: bank.correction_rad_s(),
        bank,
    }
}

/// Returns the mean square of the error of a height after this time, s, over that of the height, without a high-pass filter.
fn error_share(bank: &FilterBank, delay: f64) -> f64 {
    let height = Dynamics { high_pass: None, delay, lag: 0.0 };
    let weights = bank.position_weights(|frequency| height.position(frequency));
    bank.error_share(&weights, |frequency| height.position(frequency))
}
