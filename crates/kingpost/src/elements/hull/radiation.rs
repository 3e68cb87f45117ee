//! Radiation with memory: waves that the hull has radiated act on it later.

use crate::elements::StateDeclaration;
use crate::scalar::Scalar;
use crate::sea::database::{MODES, RadiationModel, SixBySix};

/// Radiation as a linear system in state-space form.
///
/// Cummins' equation has the force `-integral_0^t K(t - tau) nu(tau) dtau` in addition to that of the added mass at
/// infinite frequency (Cummins, *Schiffstechnik* 9, 1962). With K fitted by poles p and residues r, `K_ij(s) = sum r_ij
/// / (s - p) + conjugate`, each pole of each mode j carries one complex state:
///
/// ```text
/// z' = p z + nu_j,        F_i = -sum 2 Re(r_ij z)          (a real pole: F_i = -sum r_ij z)
/// ```
///
/// nu is the velocity of the hull's reference point relative to the water, and F acts at that point, both in the axes
/// of the slow frame. Valid for zero forward speed.
#[derive(Clone, Debug)]
pub struct Radiation {
    complex: Vec<ComplexPole>,
    real: Vec<RealPole>,
}

/// p and 2 r of one mode.
#[derive(Clone, Copy, Debug)]
struct ComplexPole {
    mode: usize,
    pole: [f64; 2],
    twice_residue: [[f64; 2]; 6],
}

/// p and r of one mode.
#[derive(Clone, Copy, Debug)]
struct RealPole {
    mode: usize,
    pole: f64,
    residue: [f64; 6],
}

impl Radiation {
    /// Returns the radiation from a database's model.
    pub fn new(model: &RadiationModel) -> Self {
        let (mut complex, mut real) = (Vec::new(), Vec::new());
        for (mode, fitted) in model.modes.iter().enumerate() {
            for (&pole, residues) in fitted.poles_rad_s.iter().zip(&fitted.residues) {
                if pole[1] == 0.0 {
                    real.push(RealPole { mode, pole: pole[0], residue: residues.map(|[re, _]| re) });
                } else {
                    let twice_residue = residues.map(|[re, im]| [2.0 * re, 2.0 * im]);
                    complex.push(ComplexPole { mode, pole, twice_residue });
                }
            }
        }
        Self { complex, real }
    }

    /// Returns A(0) - A(infinity), kg, kg m, kg m^2: the added mass of slow motions minus that at infinite frequency.
    /// It is the limit of Im K(i w) / w, `-sum 2 Re(r / p^2)`.
    pub fn added_mass(&self) -> SixBySix {
        let mut added = [[0.0; 6]; 6];
        for pole in &self.complex {
            let [re, im] = pole.pole;
            let (square, size) = ([re * re - im * im, 2.0 * re * im], (re * re + im * im) * (re * re + im * im));
            for (row, r) in added.iter_mut().zip(&pole.twice_residue) {
                row[pole.mode] -= (r[0] * square[0] + r[1] * square[1]) / size;
            }
        }
        for pole in &self.real {
            for (row, r) in added.iter_mut().zip(&pole.residue) {
                row[pole.mode] -= r / (pole.pole * pole.pole);
            }
        }
        added
    }

    /// Returns the number of states.
    pub fn state_count(&self) -> usize {
        2 * self.complex.len() + self.real.len()
    }

    /// Returns the declarations of the states by mode and pole; for a translation they are lengths.
    pub fn declared(&self) -> Vec<StateDeclaration> {
        let of = |mode: usize, rest: String| {
            StateDeclaration::memory(format!("radiation.{}.{rest}", MODES[mode]), if mode < 3 { "m" } else { "rad" })
        };
        let mut states = Vec::with_capacity(self.state_count());
        for (k, pole) in self.complex.iter().enumerate() {
            states.extend(["re", "im"].map(|part| of(pole.mode, format!("{k}.{part}"))));
        }
        states.extend(self.real.iter().enumerate().map(|(k, pole)| of(pole.mode, format!("real_{k}"))));
        states
    }

    /// Returns the force (N) and moment (N m) of the waves radiated so far.
    pub fn force<S: Scalar>(&self, states: &[S]) -> [S; 6] {
        let (pairs, singles) = states.split_at(2 * self.complex.len());
        let mut force = [S::ZERO; 6];
        for (pole, z) in self.complex.iter().zip(pairs.chunks_exact(2)) {
            for (force, r) in force.iter_mut().zip(&pole.twice_residue) {
                *force = *force - S::constant(r[0]) * z[0] + S::constant(r[1]) * z[1];
            }
        }
        for (pole, z) in self.real.iter().zip(singles) {
            for (force, r) in force.iter_mut().zip(&pole.residue) {
                *force -= S::constant(*r) * *z;
            }
        }
        force
    }

    /// Writes the rates of the states at a velocity (m/s) and angular velocity (rad/s).
    pub fn rates<S: Scalar>(&self, velocity: &[S; 6], states: &[S], rates: &mut [S]) {
        let (pairs, singles) = states.split_at(2 * self.complex.len());
        let (pair_rates, single_rates) = rates.split_at_mut(pairs.len());
        let pairs = pairs.chunks_exact(2).zip(pair_rates.chunks_exact_mut(2));
        for (pole, (z, rate)) in self.complex.iter().zip(pairs) {
            let [re, im] = pole.pole.map(S::constant);
            rate[0] = re * z[0] - im * z[1] + velocity[pole.mode];
            rate[1] = im * z[0] + re * z[1];
        }
        for (pole, (z, rate)) in self.real.iter().zip(singles.iter().zip(single_rates)) {
            *rate = S::constant(pole.pole) * *z + velocity[pole.mode];
        }
    }

    /// Writes the steady states at a constant velocity (m/s) and angular velocity (rad/s): z = -nu / p. Their force is
    /// 0, because K is 0 at zero frequency.
    pub fn steady<S: Scalar>(&self, velocity: &[S; 6], states: &mut [S]) {
        let (pairs, singles) = states.split_at_mut(2 * self.complex.len());
        for (pole, z) in self.complex.iter().zip(pairs.chunks_exact_mut(2)) {
            let [re, im] = pole.pole;
            let size_squared = re * re + im * im;
            z[0] = S::constant(-re / size_squared) * velocity[pole.mode];
            z[1] = S::constant(im / size_squared) * velocity[pole.mode];
        }
        for (pole, z) in self.real.iter().zip(singles) {
            *z = S::constant(-1.0 / pole.pole) * velocity[pole.mode];
        }
    }
}
