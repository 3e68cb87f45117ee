//! The complete state of a run, and its snapshots.

use thiserror::Error;

/// Everything on which the next step depends. Snapshots contain plain numbers, without derivatives.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State<S = f64> {
    /// Number of steps taken: the time is `steps * step size`.
    pub steps: u64,
    /// Positions, in the order of the model.
    pub q: Vec<S>,
    /// Velocities.
    pub v: Vec<S>,
    /// Continuous extra states: the ledger's integrals, then those of the elements.
    pub s: Vec<S>,
    /// Discrete numbers, which change only between steps: the values of the inputs, then those of the
    /// elements.
    pub d: Vec<S>,
    /// Modes of the elements, which change only between steps.
    pub m: Vec<i64>,
    /// Memory of the integrator from step to step.
    pub memory: Vec<S>,
}

/// Reason why a snapshot cannot be restored in this simulation.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum SnapshotError {
    /// The bytes do not start like a snapshot of this version.
    #[error("these bytes are not a Kingpost snapshot of version {allowed}")]
    Format {
        /// Version that can be read.
        allowed: u8,
    },
    /// The snapshot is from a simulation with another setup: another scenario, or other parameters.
    #[error("the snapshot is of another setup: its fingerprint is {found:016x}, this one's {allowed:016x}")]
    Setup {
        /// Fingerprint in the snapshot.
        found: u64,
        /// Fingerprint of this simulation.
        allowed: u64,
    },
    /// The snapshot is from a run with another structure.
    #[error("the snapshot has {found} numbers in {part}, this simulation has {allowed}")]
    Shape {
        /// The part of the state.
        part: &'static str,
        /// Number of entries in the snapshot.
        found: u64,
        /// Number of entries in this simulation.
        allowed: usize,
    },
    /// Some bytes of the snapshot have changed.
    #[error("the snapshot is damaged: its checksum is {found:016x}, that of its bytes {allowed:016x}")]
    Damaged {
        /// Checksum at the end of the snapshot.
        found: u64,
        /// Checksum of the bytes before it.
        allowed: u64,
    },
    /// The snapshot is too short or too long.
    #[error("the snapshot has {found} bytes, {allowed} are needed")]
    Length {
        /// Number of bytes given.
        found: usize,
        /// Number of bytes needed.
        allowed: usize,
    },
}

const MAGIC: [u8; 7] = *b"kingpst";
const VERSION: u8 = 3;

/// Number of bytes before the numbers: the magic word and the version.
const HEADER: usize = MAGIC.len() + 1;

/// Number of words before the parts: the fingerprint and the steps.
const LEAD: usize = 2;
const PARTS: [&str; 6] = ["q", "v", "s", "d", "memory", "m"];

/// Returns a digest of bytes: FNV-1a (Fowler, Noll & Vo). A change of one byte changes the digest.
pub(crate) fn digest(bytes: &[u8]) -> u64 {
    let byte = |hash: u64, byte: &u8| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, byte)
}

impl<S: Copy> State<S> {
    fn parts(&self) -> [&Vec<S>; 5] {
        [&self.q, &self.v, &self.s, &self.d, &self.memory]
    }

    fn parts_mut(&mut self) -> [&mut Vec<S>; 5] {
        [&mut self.q, &mut self.v, &mut self.s, &mut self.d, &mut self.memory]
    }

    /// Copies the numbers of another state; allocates nothing if it has the same shape.
    pub fn copy_from(&mut self, other: &Self) {
        self.steps = other.steps;
        for (part, other) in self.parts_mut().into_iter().zip(other.parts()) {
            part.clone_from(other);
        }
        self.m.clone_from(&other.m);
    }
}

impl State {
    /// Returns the state as bytes, little endian; [`State::restore`] restores it bitwise.
    /// `fingerprint` identifies the setup.
    pub fn snapshot(&self, fingerprint: u64) -> Vec<u8> {
        let mut bytes = Vec::from(MAGIC);
        bytes.push(VERSION);
        bytes.extend(fingerprint.to_le_bytes());
        bytes.extend(self.steps.to_le_bytes());
        for part in self.parts() {
            bytes.extend((part.len() as u64).to_le_bytes());
            bytes.extend(part.iter().flat_map(|x| x.to_le_bytes()));
        }
        bytes.extend((self.m.len() as u64).to_le_bytes());
        bytes.extend(self.m.iter().flat_map(|mode| mode.to_le_bytes()));
        bytes.extend(digest(&bytes).to_le_bytes());
        bytes
    }

    /// Replaces this state by a snapshot of the same setup and shape; on an error nothing changes.
    pub fn restore(&mut self, bytes: &[u8], fingerprint: u64) -> Result<(), SnapshotError> {
        let words = self.words(bytes, fingerprint)?;
        self.steps = words[1];
        let mut numbers = words[LEAD..].iter();
        for part in self.parts_mut() {
            numbers.next();
            for (x, bits) in part.iter_mut().zip(&mut numbers) {
                *x = f64::from_bits(*bits);
            }
        }
        numbers.next();
        for (mode, bits) in self.m.iter_mut().zip(numbers) {
            *mode = *bits as i64;
        }
        Ok(())
    }

    /// Returns the words of a snapshot, after checks that it fits this state.
    fn words(&self, bytes: &[u8], fingerprint: u64) -> Result<Vec<u64>, SnapshotError> {
        if bytes.len() < HEADER || bytes[..MAGIC.len()] != MAGIC || bytes[MAGIC.len()] != VERSION {
            return Err(SnapshotError::Format { allowed: VERSION });
        }
        let word = |w: &[u8]| w.iter().rev().fold(0, |sum, byte| (sum << 8) | u64::from(*byte));
        let words: Vec<u64> = bytes[HEADER..].chunks_exact(8).map(word).collect();
        let [q, v, s, d, memory] = self.parts().map(Vec::len);
        let lengths = [q, v, s, d, memory, self.m.len()];
        let before = HEADER + 8 * (LEAD + lengths.iter().map(|n| n + 1).sum::<usize>());
        let allowed = before + 8;
        let wrong_length = SnapshotError::Length { found: bytes.len(), allowed };
        let found = *words.first().ok_or(wrong_length.clone())?;
        if found != fingerprint {
            return Err(SnapshotError::Setup { found, allowed: fingerprint });
        }
        let mut at = LEAD;
        for (part, &length) in PARTS.iter().copied().zip(&lengths) {
            let found = *words.get(at).ok_or(wrong_length.clone())?;
            if found != length as u64 {
                return Err(SnapshotError::Shape { part, found, allowed: length });
            }
            at += 1 + length;
        }
        if bytes.len() != allowed {
            return Err(wrong_length);
        }
        let (found, allowed) = (words[at], digest(&bytes[..before]));
        if found == allowed { Ok(words) } else { Err(SnapshotError::Damaged { found, allowed }) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn state() -> State {
        State {
            steps: 7,
            q: vec![1.0, -0.0],
            v: vec![f64::MIN_POSITIVE],
            s: vec![3.5; 3],
            d: vec![],
            m: vec![-3],
            memory: vec![2.0],
        }
    }

    #[test]
    fn a_restored_snapshot_is_bitwise_identical() {
        let mut other = state();
        (other.q[1], other.m[0]) = (9.0, 4);
        other.restore(&state().snapshot(5), 5).unwrap();
        assert_eq!(other, state());
        assert!(other.q[1].is_sign_negative());
    }

    #[test]
    fn a_snapshot_with_any_bit_flipped_is_refused() {
        let good = state().snapshot(5);
        for bit in 0..8 * good.len() {
            let mut bytes = good.clone();
            bytes[bit / 8] ^= 1 << (bit % 8);
            assert!(state().restore(&bytes, 5).is_err(), "bit {bit} was flipped unseen");
        }
    }

    #[test]
    fn a_snapshot_of_another_shape_is_refused_and_changes_nothing() {
        let mut other = State { v: vec![0.0; 2], ..state() };
        let before = other.clone();
        let refused = other.restore(&state().snapshot(5), 5);
        assert_eq!(refused, Err(SnapshotError::Shape { part: "v", found: 1, allowed: 2 }));
        assert_eq!(other.restore(b"nonsense", 5), Err(SnapshotError::Format { allowed: VERSION }));
        let short = &state().snapshot(5)[..28];
        assert!(matches!(other.restore(short, 5), Err(SnapshotError::Length { .. })));
        let foreign = other.restore(&state().snapshot(4), 5);
        assert_eq!(foreign, Err(SnapshotError::Setup { found: 4, allowed: 5 }));
        assert_eq!(other, before);
    }
}
