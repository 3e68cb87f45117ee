//! An input shaper: it shapes a command to leave no residual swing.

pub(crate) mod assembly;
pub(crate) mod fields;

use crate::elements::commanded::one_command;
use crate::elements::{Context, Declaration, Element, ElementState, Input, Occurrence};
use crate::scalar::Scalar;
use core::f64::consts::{PI, TAU};

/// Convolves its command with a few impulses and sets another input to the result.
///
/// For a swing of period T between two maxima and damping ratio zeta, with `K = exp(-zeta pi / sqrt(1 - zeta^2))`:
///
/// ```text
/// ZV   at 0, T/2:     (1, K)
/// ZVD  at 0, T/2, T:  (1, 2 K, K^2)
/// EI   at 0, T/2, T:  (1 + V, 2 (1 - V) K, (1 + V) K^2)
/// ```
///
/// each divided by its sum (Singer & Seering, "Preshaping command inputs to reduce system vibration", *J. Dyn. Sys.
/// Meas. Control* 112, 1990, pp. 76-82; EI: Singhose, Seering & Singer, "Residual vibration reduction using vector
/// diagrams to generate shaped inputs", *J. Mech. Des.* 116, 1994, pp. 654-659, whose weights are for zeta = 0). ZV
/// leaves no residual swing at T; ZVD leaves none at T and little near T; EI leaves the share V at T and at most about
/// V in a wider band.
///
/// Inputs are constant over each step h, so an impulse at t = (n + f) h is replaced by two, after n and n + 1 steps,
/// with the shares
///
/// ```text
/// a = e^(sigma f h) sin(w (1 - f) h) / sin(w h),    b = e^(sigma (f - 1) h) sin(w f h) / sin(w h)
/// ```
///
/// of its size, where w = 2 pi / T and sigma = zeta w / sqrt(1 - zeta^2). Both together excite exactly the same swing
/// as the impulse at t, so that sampling causes no residual swing.
#[derive(Clone, Debug)]
pub struct InputShaper<S = f64> {
    /// Name in the results, and of its command.
    pub name: String,
    /// The input that it sets.
    pub to: Input,
    /// Taps: delay in steps and weight of each command in the sum.
    pub taps: Vec<(usize, S)>,
}

/// The kind of impulses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShaperKind {
    /// No residual swing at the period.
    Zv,
    /// No residual swing at the period, with zero slope over the period.
    Zvd,
    /// A stated residual swing at the period, for a wider band.
    Ei,
}

/// The swing that a shaper suppresses.
#[derive(Clone, Copy, Debug)]
pub struct Swing<S> {
    /// T, s.
    pub period: S,
    /// zeta, below 1.
    pub damping_ratio: S,
    /// V, for [`ShaperKind::Ei`].
    pub tolerance: S,
}

/// The action, which is its output at the end of the step. The commands of earlier steps follow, then the commands at
/// the ends of these steps.
const ACTION: usize = 0;
const RING: usize = 1;
/// The only mode: the index at which the next command is stored.
const HEAD: usize = 0;

impl<S: Scalar> Element<S> for InputShaper<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let of_each = |what: &'static str| (0..self.steps_kept()).map(move |step| format!("{what}_{step}"));
        let kept = of_each("command").chain(of_each("command_at_end"));
        let numbers = core::iter::once("action".to_owned()).chain(kept).collect();
        Declaration { numbers, modes: vec!["next".to_owned()], ..one_command(&self.name, &self.to) }
    }

    /// Fills the earlier commands with the initial one: the command was the same before the run.
    fn begin(&mut self, at: &Context<'_, S>, own: &mut ElementState<'_, S>) {
        own.numbers.fill(at.inputs[0]);
    }

    fn update_controls(
        &mut self,
        at: &Context<'_, S>,
        _read: &[S],
        own: &mut ElementState<'_, S>,
        inputs: &mut [S],
    ) -> Result<Vec<Occurrence>, String> {
        let kept = self.steps_kept();
        let head = if kept == 0 { 0 } else { own.modes[HEAD].rem_euclid(kept as i64) as usize };
        let [shaped, at_end] = [(at.inputs[0], RING), (at.inputs_at_end[0], RING + kept)].map(|(command, ring)| {
            let shaped = self.shaped(command, &own.numbers[ring..][..kept], head);
            if kept > 0 {
                own.numbers[ring + head] = command;
            }
            shaped
        });
        if kept > 0 {
            own.modes[HEAD] = ((head + 1) % kept) as i64;
        }
        own.numbers[ACTION] = at_end;
        inputs.fill(shaped);
        Ok(Vec::new())
    }

    fn at_end(&self, at: &Context<'_, S>, inputs: &mut [S]) {
        inputs.fill(at.numbers[ACTION]);
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        out.push(at.numbers[ACTION]);
    }
}

impl<S: Scalar> InputShaper<S> {
    fn steps_kept(&self) -> usize {
        self.taps.iter().map(|(steps, _)| *steps).max().unwrap_or_default()
    }

    /// Returns the weighted sum of the commands: the present one, and those of earlier steps, the oldest at `head`.
    fn shaped(&self, command: S, earlier: &[S], head: usize) -> S {
        let ago = |steps: usize| match steps {
            0 => command,
            steps => earlier[(head + earlier.len() - steps) % earlier.len()],
        };
        self.taps.iter().fold(S::ZERO, |sum, &(steps, weight)| sum + weight * ago(steps))
    }
}

/// Returns the taps of a shaper for steps of this length, s; their weights add up to 1.
///
/// ```
/// use kingpost::elements::{ShaperKind, Swing, shaper_taps};
/// let swing = Swing { period: 2.0, damping_ratio: 0.0, tolerance: 0.05 };
/// let taps = shaper_taps(ShaperKind::Zv, swing, 0.5); // half a period is two steps
/// assert_eq!(taps.len(), 2);
/// assert_eq!(taps.iter().map(|(steps, _)| *steps).collect::<Vec<_>>(), [0, 2]);
/// assert!(taps.iter().all(|(_, weight)| (*weight - 0.5).abs() < 1e-15));
/// ```
pub fn shaper_taps<S: Scalar>(kind: ShaperKind, swing: Swing<S>, step_s: f64) -> Vec<(usize, S)> {
    let Swing { period, damping_ratio, tolerance } = swing;
    let slow = (S::ONE - damping_ratio * damping_ratio).sqrt();
    let k = (-(damping_ratio * S::constant(PI)) / slow).exp();
    let half = period * S::constant(0.5 / step_s);
    let two = S::ONE + S::ONE;
    let impulses = match kind {
        ShaperKind::Zv => vec![(S::ZERO, S::ONE), (half, k)],
        ShaperKind::Zvd => vec![(S::ZERO, S::ONE), (half, two * k), (half + half, k * k)],
        ShaperKind::Ei => {
            let [more, less] = [S::ONE + tolerance, S::ONE - tolerance];
            vec![(S::ZERO, more), (half, two * less * k), (half + half, more * k * k)]
        }
    };
    let turn = S::constant(TAU * step_s) / period;
    let sampled = Sampled { turn, growth: turn * damping_ratio / slow };
    let mut taps: Vec<(usize, S)> = Vec::new();
    for (time, size) in impulses {
        sampled.add(time, size, &mut taps);
    }
    taps.sort_by_key(|(steps, _)| *steps);
    let sum = taps.iter().fold(S::ZERO, |sum, (_, weight)| sum + *weight);
    taps.into_iter().map(|(steps, weight)| (steps, weight / sum)).collect()
}

/// The swing over one step: w h and sigma h.
struct Sampled<S> {
    turn: S,
    growth: S,
}

impl<S: Scalar> Sampled<S> {
    /// Adds an impulse at a time, in steps. The impulse may fall in different steps in different lanes.
    fn add(&self, time: S, size: S, taps: &mut Vec<(usize, S)>) {
        let mut steps = 0;
        // The first step that has not passed in every lane.
        while time.all(|time| time >= (steps + 1) as f64) {
            steps += 1;
        }
        loop {
            let share = time - S::constant(steps as f64);
            let [now, next] = self.split(share);
            let here = |weight: S| {
                share.select_below(0.0, || S::ZERO, || share.select_below(1.0, || size * weight, || S::ZERO))
            };
            put(taps, steps, here(now));
            if !share.all(|share| share == 0.0 || share >= 1.0) || S::HAS_DERIVATIVES {
                put(taps, steps + 1, here(next));
            }
            if share.all(|share| share < 1.0) {
                return;
            }
            steps += 1;
        }
    }

    /// Returns a and b for the share f of a step.
    fn split(&self, share: S) -> [S; 2] {
        let sine = |x: S| x.sin_cos().0;
        let (rest, whole) = (S::ONE - share, sine(self.turn));
        [
            (self.growth * share).exp() * sine(self.turn * rest) / whole,
            (-(self.growth * rest)).exp() * sine(self.turn * share) / whole,
        ]
    }
}

fn put<S: Scalar>(taps: &mut Vec<(usize, S)>, steps: usize, weight: S) {
    match taps.iter_mut().find(|(known, _)| *known == steps) {
        Some((_, sum)) => *sum += weight,
        None => taps.push((steps, weight)),
    }
}
