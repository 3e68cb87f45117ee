//! The complete state of a run, and its snapshots.

use thiserror::Error;

/// Everything that the next step depends on.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State {
    /// Steps taken: the time is `steps * step size`.
    pub steps: u64,
    /// Positions; the layout is the model's.
    pub q: Vec<f64>,
    /// Velocities.
    pub v: Vec<f64>,
    /// Continuous extra states: the ledger's integrals, then those of forces and drives.
    pub s: Vec<f64>,
    /// Discrete states, which change between steps only: the values of the inputs.
    pub d: Vec<f64>,
    /// What the integrator carries from step to step.
    pub memory: Vec<f64>,
}

/// A snapshot that does not belong to this simulation.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum SnapshotError {
    /// The bytes do not begin as a snapshot of this version does.
    #[error("these bytes are not a Kingpost snapshot of version {allowed}")]
    Format {
        /// The version that can be read.
        allowed: u8,
    },
    /// It was taken from a run of another structure.
    #[error("the snapshot has {found} numbers in {part}, this simulation has {allowed}")]
    Shape {
        /// Which part of the state.
        part: &'static str,
        /// Numbers in the snapshot.
        found: u64,
        /// Numbers in this simulation.
        allowed: usize,
    },
    /// It ends too early or too late.
    #[error("the snapshot has {found} bytes, {allowed} are needed")]
    Length {
        /// Bytes given.
        found: usize,
        /// Bytes needed.
        allowed: usize,
    },
}

const MAGIC: [u8; 7] = *b"kingpst";
const VERSION: u8 = 1;
const PARTS: [&str; 5] = ["q", "v", "s", "d", "memory"];

impl State {
    fn parts(&self) -> [&Vec<f64>; 5] {
        [&self.q, &self.v, &self.s, &self.d, &self.memory]
    }

    fn parts_mut(&mut self) -> [&mut Vec<f64>; 5] {
        [&mut self.q, &mut self.v, &mut self.s, &mut self.d, &mut self.memory]
    }

    /// Takes over the numbers of a state of the same shape; allocates nothing.
    pub fn copy_from(&mut self, other: &State) {
        self.steps = other.steps;
        for (part, other) in self.parts_mut().into_iter().zip(other.parts()) {
            part.copy_from_slice(other);
        }
    }

    /// The state as bytes, little endian; [`State::restore`] gives back the same bits.
    pub fn snapshot(&self) -> Vec<u8> {
        let mut bytes = Vec::from(MAGIC);
        bytes.push(VERSION);
        bytes.extend(self.steps.to_le_bytes());
        for part in self.parts() {
            bytes.extend((part.len() as u64).to_le_bytes());
            bytes.extend(part.iter().flat_map(|x| x.to_le_bytes()));
        }
        bytes
    }

    /// Overwrites this state with a snapshot of the same shape; on an error nothing changes.
    pub fn restore(&mut self, bytes: &[u8]) -> Result<(), SnapshotError> {
        let header = MAGIC.len() + 1;
        if bytes.len() < header || bytes[..7] != MAGIC || bytes[7] != VERSION {
            return Err(SnapshotError::Format { allowed: VERSION });
        }
        let words: Vec<u64> = bytes[header..]
            .chunks_exact(8)
            .map(|w| w.iter().rev().fold(0, |sum, byte| (sum << 8) | u64::from(*byte)))
            .collect();
        let lengths = self.parts().map(Vec::len);
        let allowed = header + 8 * (1 + lengths.iter().map(|n| n + 1).sum::<usize>());
        if bytes.len() < header + 8 {
            return Err(SnapshotError::Length { found: bytes.len(), allowed });
        }
        let mut at = 1;
        for (part, &length) in PARTS.iter().copied().zip(&lengths) {
            let found = *words.get(at).ok_or(SnapshotError::Length { found: bytes.len(), allowed })?;
            if found != length as u64 {
                return Err(SnapshotError::Shape { part, found, allowed: length });
            }
            at += 1 + length;
        }
        if bytes.len() != allowed {
            return Err(SnapshotError::Length { found: bytes.len(), allowed });
        }
        self.steps = words[0];
        let mut numbers = words[1..].iter();
        for part in self.parts_mut() {
            numbers.next();
            for (x, bits) in part.iter_mut().zip(&mut numbers) {
                *x = f64::from_bits(*bits);
            }
        }
        Ok(())
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
            memory: vec![2.0],
        }
    }

    #[test]
    fn a_snapshot_gives_back_the_same_bits() {
        let mut other = state();
        other.q[1] = 9.0;
        other.restore(&state().snapshot()).unwrap();
        assert_eq!(other, state());
        assert!(other.q[1].is_sign_negative());
    }

    #[test]
    fn a_snapshot_of_another_shape_is_refused_and_changes_nothing() {
        let mut other = State { v: vec![0.0; 2], ..state() };
        let before = other.clone();
        let refused = other.restore(&state().snapshot());
        assert_eq!(refused, Err(SnapshotError::Shape { part: "v", found: 1, allowed: 2 }));
        assert_eq!(other.restore(b"nonsense"), Err(SnapshotError::Format { allowed: 1 }));
        let short = &state().snapshot()[..20];
        assert!(matches!(other.restore(short), Err(SnapshotError::Length { .. })));
        assert_eq!(other, before);
    }
}
