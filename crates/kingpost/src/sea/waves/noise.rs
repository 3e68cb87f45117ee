//! Random numbers as a function of (seed, channel, counter), without stored state.

/// Pseudo-random numbers as a function of a seed, a channel and a counter: Philox4x32-10 of Salmon, Moraes,
/// Dror & Shaw, "Parallel random numbers: as easy as 1, 2, 3" (SC'11, 2011, sec. 3.3). The seed is the key;
/// the counter is the first half of the block and the channel the second. Equal arguments give bitwise
/// identical numbers on every machine, in any order, so that no state needs to be stored.
///
/// ```
/// use kingpost::sea::waves::Noise;
/// let noise = Noise::new(7);
/// assert_eq!(noise.uniform(0, 5), Noise::new(7).uniform(0, 5));
/// assert_ne!(noise.uniform(0, 5), noise.uniform(1, 5));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Noise {
    seed: u64,
}

impl Noise {
    /// Creates the noise of a seed.
    pub fn new(seed: u64) -> Self {
        Self { seed }
    }

    /// Returns a number from the open interval (0, 1), of 52 random bits.
    pub fn uniform(&self, channel: u64, counter: u64) -> f64 {
        let [first, second, _, _] = self.block(channel, counter);
        open_unit(first, second)
    }

    /// Returns a number from the normal distribution with mean 0 and variance 1, by the method of Box &
    /// Muller (*Annals of Mathematical Statistics* 29, 1958, p. 610).
    pub fn normal(&self, channel: u64, counter: u64) -> f64 {
        let [a, b, c, d] = self.block(channel, counter);
        let radius = libm::sqrt(-2.0 * libm::log(open_unit(a, b)));
        radius * libm::cos(core::f64::consts::TAU * open_unit(c, d))
    }

    fn block(&self, channel: u64, counter: u64) -> [u32; 4] {
        let halves = |word: u64| [word as u32, (word >> 32) as u32];
        let ([c0, c1], [c2, c3]) = (halves(counter), halves(channel));
        philox4x32_10([c0, c1, c2, c3], halves(self.seed))
    }
}

/// Returns the middle of one of 2^52 equal parts of (0, 1), so that it is never 0 or 1.
fn open_unit(low: u32, high: u32) -> f64 {
    let bits = (u64::from(high) << 32 | u64::from(low)) >> 12;
    (bits as f64 + 0.5) / (1_u64 << 52) as f64
}

/// Computes ten rounds of Philox with four words of 32 bits.
fn philox4x32_10(mut counter: [u32; 4], mut key: [u32; 2]) -> [u32; 4] {
    const MULTIPLIERS: [u32; 2] = [0xD251_1F53, 0xCD9E_8D57];
    const WEYL: [u32; 2] = [0x9E37_79B9, 0xBB67_AE85];
    for _ in 0..10 {
        let product = |k: usize, word: u32| u64::from(MULTIPLIERS[k]) * u64::from(word);
        let (even, odd) = (product(0, counter[0]), product(1, counter[2]));
        let high = |product: u64| (product >> 32) as u32;
        counter = [high(odd) ^ counter[1] ^ key[0], odd as u32, high(even) ^ counter[3] ^ key[1], even as u32];
        key = [key[0].wrapping_add(WEYL[0]), key[1].wrapping_add(WEYL[1])];
    }
    counter
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The test vectors that the authors publish with their library Random123 (`kat_vectors`).
    #[test]
    fn philox_gives_its_authors_known_answers() {
        let cases = [
            ([0; 4], [0; 2], [0x6627_e8d5, 0xe169_c58d, 0xbc57_ac4c, 0x9b00_dbd8]),
            ([u32::MAX; 4], [u32::MAX; 2], [0x408f_276d, 0x41c8_3b0e, 0xa20b_c7c6, 0x6d54_51fd]),
            (
                [0x243f_6a88, 0x85a3_08d3, 0x1319_8a2e, 0x0370_7344],
                [0xa409_3822, 0x299f_31d0],
                [0xd16c_fe09, 0x94fd_cceb, 0x5001_e420, 0x2412_6ea1],
            ),
        ];
        for (counter, key, answer) in cases {
            assert_eq!(philox4x32_10(counter, key), answer);
        }
    }

    /// Mean and variance within four standard errors: 1 / sqrt(12 n) and 1 / sqrt(180 n) of the
    /// uniform numbers, 1 / sqrt(n) and sqrt(2 / n) of the normal ones.
    #[test]
    fn the_numbers_have_the_mean_and_variance_of_their_distribution() {
        let (noise, n) = (Noise::new(3), 100_000_u32);
        let moments = |draw: &dyn Fn(u64) -> f64| {
            let mean = (0..u64::from(n)).map(draw).sum::<f64>() / f64::from(n);
            let square = (0..u64::from(n)).map(|i| (draw(i) - mean).powi(2)).sum::<f64>() / f64::from(n);
            (mean, square)
        };
        let root = f64::from(n).sqrt();
        let (mean, variance) = moments(&|i| noise.uniform(1, i));
        assert!((mean - 0.5).abs() < 4.0 / (12.0_f64.sqrt() * root));
        assert!((variance - 1.0 / 12.0).abs() < 4.0 / (180.0_f64.sqrt() * root));
        let (mean, variance) = moments(&|i| noise.normal(2, i));
        assert!(mean.abs() < 4.0 / root);
        assert!((variance - 1.0).abs() < 4.0 * 2.0_f64.sqrt() / root);
    }

    #[test]
    fn no_number_reaches_the_ends_of_its_interval() {
        assert!(open_unit(0, 0) > 0.0);
        assert!(open_unit(u32::MAX, u32::MAX) < 1.0);
    }
}
