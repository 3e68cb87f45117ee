//! A random sea from a spectrum, as a sum of waves.

use core::f64::consts::TAU;

use super::components::{ANGLES_RAD, MOST_COMPONENTS, WaveComponent};
use super::error::{WaveError, between};
use super::noise::Noise;
use super::spectrum::{Band, Spectrum, sub_intervals};
use super::spreading::Spreading;
use super::water::Water;

/// Way in which the amplitudes of a random sea are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Amplitudes {
    /// a = sqrt(2 S dw): every realisation has the significant wave height of the spectrum.
    Deterministic,
    /// a = sqrt(2 S dw) sqrt(-ln u) with u uniform in (0, 1), a Rayleigh distribution with the same mean square: the
    /// sea is Gaussian with any number of waves, and its height varies from seed to seed as in the real sea (Tucker,
    /// Challenor & Carter, *Applied Ocean Research* 6, 1984, p. 118).
    Random,
}

/// Waves of one spectrum about one mean direction, such as a wind sea or a swell.
#[derive(Clone, Debug, PartialEq)]
pub struct WaveSystem {
    /// The spectrum.
    pub spectrum: Spectrum,
    /// Directional spreading.
    pub spreading: Spreading,
    /// Mean propagation direction, from the world's x counter-clockwise, rad.
    pub direction_rad: f64,
    /// Number of waves.
    pub components: usize,
    /// Way in which the amplitudes are drawn.
    pub amplitudes: Amplitudes,
    /// Frequencies that are kept; the waves then have only the spectrum's energy in this band. 0 and infinity
    /// for an end that is not cut off, `None` for both.
    pub band: Option<Band>,
}

/// Share of the waves that are distributed evenly over frequency, independent of their energy.
const EVEN_SHARE: f64 = 0.5;

/// Purpose of a noise channel; each system has one channel for each purpose.
#[derive(Clone, Copy)]
enum WaveDraw {
    Frequency = 0,
    Phase = 1,
    Direction = 2,
    Amplitude = 3,
}

impl WaveSystem {
    /// Returns the waves of the system, in order of frequency; an equal seed and an equal number of the
    /// system in its sea give bitwise identical waves.
    ///
    /// The waves lie in [`Spectrum::usual_band`], or between the given ends. This band is divided into as
    /// many bins as there are waves, each with the same integral of (1/2) S(w) / m0 + (1/2) / (width of the
    /// band): half of the waves are distributed like the energy and half evenly, so that the tail is resolved
    /// too. Each bin gives one wave with the energy of the bin; the energies are scaled so that their sum is
    /// the energy of the whole spectrum, or of its part in the given band. Its frequency is drawn uniformly
    /// from the bin. The frequencies have no common divisor, so the sea does not repeat. Each wave has one
    /// direction, drawn from the spreading, and a phase drawn from 0 to 2 pi.
    ///
    /// # Errors
    /// No waves or more than 20,000, a direction that is not finite or above 1e4 rad, a band that is empty or
    /// without energy.
    pub fn components(&self, seed: u64, system: u64, water: &Water) -> Result<Vec<WaveComponent>, WaveError> {
        let band = self.checked_band()?;
        let bins = self.bins(band)?;
        let (noise, count) = (Noise::new(seed), self.components as u64);
        let uniform = |draw: WaveDraw, i: u64| noise.uniform(4 * system + draw as u64, i);
        let shares: Vec<f64> = (0..count).map(|i| uniform(WaveDraw::Direction, i)).collect();
        let angles = self.spreading.quantiles_rad(&shares);
        let of_bin = |(i, bin): (u64, &Bin)| {
            let frequency = bin.start_rad_s + (bin.end_rad_s - bin.start_rad_s) * uniform(WaveDraw::Frequency, i);
            let mean_square = match self.amplitudes {
                Amplitudes::Deterministic => 1.0,
                Amplitudes::Random => -libm::log(uniform(WaveDraw::Amplitude, i)),
            };
            let amplitude = libm::sqrt(2.0 * bin.variance_m2 * mean_square);
            let direction = self.direction_rad + angles[i as usize];
            WaveComponent::in_water(water, amplitude, frequency, direction, TAU * uniform(WaveDraw::Phase, i))
        };
        Ok((0..count).zip(&bins).map(of_bin).collect())
    }

    /// Returns the band of the waves, and the factor on the spectral density in this band with which the
    /// waves have the energy of the whole spectrum, or of its part in the given band.
    ///
    /// # Errors
    /// As [`Self::components`].
    pub fn kept_band(&self) -> Result<(Band, f64), WaveError> {
        let band = self.checked_band()?;
        let [kept, whole] = self.energies(&Ladder::new(&self.spectrum, band), band)?;
        Ok((band, whole / kept))
    }

    /// Returns the share of the spectrum's energy that the given band cuts off.
    pub fn energy_cut_off(&self) -> f64 {
        let whole = self.spectrum.moment(0, self.spectrum.whole_band());
        1.0 - self.spectrum.moment(0, self.within(self.spectrum.whole_band())) / whole
    }

    /// Returns a band of the spectrum in which the given ends replace those of the spectrum.
    fn within(&self, band: Band) -> Band {
        let Some(given) = self.band else { return band };
        Band {
            lowest_rad_s: if given.lowest_rad_s > 0.0 { given.lowest_rad_s } else { band.lowest_rad_s },
            highest_rad_s: if given.highest_rad_s < f64::INFINITY { given.highest_rad_s } else { band.highest_rad_s },
        }
    }

    fn checked_band(&self) -> Result<Band, WaveError> {
        let band = self.within(self.spectrum.usual_band());
        if self.components == 0 || self.components > MOST_COMPONENTS {
            let allowed = format!("a number from 1 to {MOST_COMPONENTS}");
            return Err(WaveError::new("components", self.components, allowed));
        }
        between("direction_rad", self.direction_rad, ANGLES_RAD)?;
        between("lowest_rad_s", band.lowest_rad_s, [0.0, 1e4])?;
        between("highest_rad_s", band.highest_rad_s, [0.0, 1e5])?;
        if band.highest_rad_s <= band.lowest_rad_s {
            let allowed = format!("a number above lowest_rad_s, which is {}", band.lowest_rad_s);
            return Err(WaveError::new("highest_rad_s", band.highest_rad_s, allowed));
        }
        Ok(band)
    }

    /// Returns bins of equal blended mass, with the energy of the whole spectrum within the given ends.
    fn bins(&self, band: Band) -> Result<Vec<Bin>, WaveError> {
        let ladder = Ladder::new(&self.spectrum, band);
        let [kept, whole] = self.energies(&ladder, band)?;
        let ends = (0..=self.components).map(|i| ladder.at_mass(i as f64 / self.components as f64));
        let ends: Vec<(f64, f64)> = ends.collect();
        let bin = |ends: &[(f64, f64)]| Bin {
            start_rad_s: ends[0].0,
            end_rad_s: ends[1].0,
            variance_m2: (ends[1].1 - ends[0].1) * whole / kept,
        };
        Ok(ends.windows(2).map(bin).collect())
    }

    /// Returns the energy in the band, and the energy of the whole spectrum within the given ends, m^2.
    fn energies(&self, ladder: &Ladder, band: Band) -> Result<[f64; 2], WaveError> {
        let kept = ladder.kept();
        if kept.is_nan() || kept <= 0.0 {
            let found = format!("no energy from {} to {} rad/s", band.lowest_rad_s, band.highest_rad_s);
            return Err(WaveError::new("lowest_rad_s, highest_rad_s", found, "a band in which S(w) is above 0"));
        }
        Ok([kept, self.spectrum.moment(0, self.within(self.spectrum.whole_band()))])
    }
}

/// A part of the band that becomes one wave.
struct Bin {
    start_rad_s: f64,
    end_rad_s: f64,
    variance_m2: f64,
}

/// Cumulative energy at many frequencies of a band.
struct Ladder {
    /// Frequency, rad/s, and the energy below it, m^2.
    rungs: Vec<(f64, f64)>,
}

impl Ladder {
    fn new(spectrum: &Spectrum, band: Band) -> Self {
        let mut below = 0.0;
        let mut rungs = vec![(band.lowest_rad_s, 0.0)];
        for ends in sub_intervals(&spectrum.nodes_rad_s(), band).windows(2) {
            below += spectrum.moment(0, Band { lowest_rad_s: ends[0], highest_rad_s: ends[1] });
            rungs.push((ends[1], below));
        }
        Self { rungs }
    }

    fn kept(&self) -> f64 {
        self.rungs[self.rungs.len() - 1].1
    }

    /// Returns the blended mass below a rung: half the share of the energy plus half the share of the band's
    /// width.
    fn mass(&self, (frequency, below): (f64, f64)) -> f64 {
        let (lowest, highest) = (self.rungs[0].0, self.rungs[self.rungs.len() - 1].0);
        (1.0 - EVEN_SHARE) * below / self.kept() + EVEN_SHARE * (frequency - lowest) / (highest - lowest)
    }

    /// Returns the frequency below which this blended mass lies, and the energy below it, linear between
    /// rungs.
    fn at_mass(&self, mass: f64) -> (f64, f64) {
        let after = self.rungs.partition_point(|&rung| self.mass(rung) < mass);
        let after = after.clamp(1, self.rungs.len() - 1);
        let (low, high) = (self.rungs[after - 1], self.rungs[after]);
        let part = ((mass - self.mass(low)) / (self.mass(high) - self.mass(low))).clamp(0.0, 1.0);
        (low.0 + part * (high.0 - low.0), low.1 + part * (high.1 - low.1))
    }
}
