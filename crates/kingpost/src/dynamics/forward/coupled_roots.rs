//! Floating roots with added inertia between them: hulls that feel each other through the water.
//!
//! With I the articulated inertia of each root and C the inertia between two of them, the accelerations a of all these
//! roots follow from one symmetric system, six rows for each root:
//!
//! ```text
//! I_r a_r + sum_s C_rs a_s = f_r - p_r
//! ```

use super::articulated::Articulated;
use crate::dynamics::cholesky::CholeskyFactor;
use crate::dynamics::moving_link::MovingLink;
use crate::dynamics::{LinkKinematics, Loads};
use crate::model::Model;
use crate::scalar::Scalar;
use crate::spatial::{CrossInertia, Twist, Vector3, Wrench};

/// Roots with inertia between them, in their root axes.
#[derive(Clone, Debug)]
pub(super) struct CoupledRoots<S> {
    /// Links, each once.
    roots: Vec<usize>,
    /// Inertia between two of them, by their places in `roots`.
    between: Vec<([usize; 2], CrossInertia<S>)>,
    factor: CholeskyFactor<S>,
    /// Rows for which `factor` has memory.
    capacity: usize,
}

impl<S: Scalar> CoupledRoots<S> {
    pub fn new() -> Self {
        Self { roots: Vec::new(), between: Vec::new(), factor: CholeskyFactor::new(0), capacity: 0 }
    }

    /// Returns the place of a link among the coupled roots.
    #[inline]
    pub fn place(&self, link: usize) -> Option<usize> {
        self.roots.iter().position(|root| *root == link)
    }

    #[inline]
    pub fn is_empty(&self) -> bool {
        self.roots.is_empty()
    }

    /// Transforms the inertias between bodies to root axes.
    pub fn take(&mut self, model: &Model<S>, links: &LinkKinematics<S>, loads: &Loads<S>) {
        self.roots.clear();
        self.between.clear();
        for ([first, second], added) in &loads.added_inertia_between {
            let ends = [*first, *second].map(|body| &model.bodies[body]);
            let [Some(one), Some(other)] = ends.map(|body| body.link) else { continue };
            let [on_one, on_other] =
                [(one, ends[0]), (other, ends[1])].map(|(link, body)| links.in_root(link).times(&body.in_link));
            let places = [one, other].map(|link| self.place_of(model.roots[link]));
            self.between.push((places, added.to_parents(&on_one, &on_other)));
        }
        if self.capacity < 6 * self.roots.len() {
            self.capacity = 6 * self.roots.len();
            self.factor = CholeskyFactor::new(self.capacity);
        }
    }

    /// Returns the place of a root, which is added if it is new.
    fn place_of(&mut self, root: usize) -> usize {
        self.place(root).unwrap_or_else(|| {
            self.roots.push(root);
            self.roots.len() - 1
        })
    }

    /// Adds to each root the force of the others' bias acceleration and free fall, with Kirchhoff's term: `C a + nu x* C nu`.
    pub fn add_bias(&self, moving: &[MovingLink<S>], fall: &[Vector3<S>], of_links: &mut [Articulated<S>]) {
        let known = |root: usize| {
            let fall = Twist { angular: Vector3::zero(), linear: fall[root] };
            (moving[root].motion.twist, moving[root].spatial_bias_acceleration() + fall)
        };
        for ([first, second], inertia) in &self.between {
            let [first, second] = [self.roots[*first], self.roots[*second]];
            let ((twist, rate), (other, rate_of_other)) = (known(first), known(second));
            of_links[first].bias += inertia.times(&rate_of_other) + twist.cross_momentum(&inertia.times(&other));
            of_links[second].bias +=
                inertia.transpose_times(&rate) + other.cross_momentum(&inertia.transpose_times(&twist));
        }
    }

    /// Factors the system with the present articulated inertias.
    pub fn factor(&mut self, moving: &[MovingLink<S>], of_links: &[Articulated<S>]) {
        let count = 6 * self.roots.len();
        self.factor.begin(count);
        for row in 0..count {
            (0..=row).for_each(|column| self.factor.set(row, column, S::ZERO));
        }
        for (place, &root) in self.roots.iter().enumerate() {
            let rows = of_links[root].inertia(&moving[root]).to_rows();
            for (i, row) in rows.iter().enumerate() {
                row.iter().take(i + 1).enumerate().for_each(|(j, entry)| {
                    self.factor.set(6 * place + i, 6 * place + j, *entry);
                });
            }
        }
        for ([first, second], inertia) in &self.between {
            for (i, j) in (0..6).flat_map(|i| (0..6).map(move |j| (i, j))) {
                // The lower triangle has the rows of the later root.
                let (row, column) = (6 * first + i, 6 * second + j);
                self.factor.add(row.max(column), row.min(column), inertia.entry(i, j));
            }
        }
        (0..count).for_each(|row| self.factor.take_reference(row, S::ONE));
        self.factor.factor();
    }

    /// Solves for the accelerations under a wrench on each root, `net(root)`; they are in `found`, for the other functions.
    pub fn solve(&self, net: impl Fn(usize) -> Wrench<S>, found: &mut Vec<S>) {
        found.clear();
        for &root in &self.roots {
            let Wrench { moment, force } = net(root);
            found.extend(moment.0.into_iter().chain(force.0));
        }
        self.factor.solve(found);
    }

    /// Returns each root with its acceleration.
    pub fn accelerations<'a>(&'a self, found: &'a [S]) -> impl Iterator<Item = (usize, Twist<S>)> + 'a {
        self.roots.iter().enumerate().map(|(place, root)| (*root, twist_at(found, place)))
    }

    /// Returns each root with the reaction `C a` from the acceleration of one other root.
    pub fn reactions<'a>(&'a self, found: &'a [S]) -> impl Iterator<Item = (usize, Wrench<S>)> + 'a {
        self.between.iter().flat_map(|([first, second], inertia)| {
            let on_first = inertia.times(&twist_at(found, *second));
            let on_second = inertia.transpose_times(&twist_at(found, *first));
            [(self.roots[*first], on_first), (self.roots[*second], on_second)]
        })
    }
}

/// Returns the acceleration of the root at a place.
fn twist_at<S: Scalar>(found: &[S], place: usize) -> Twist<S> {
    let entries = &found[6 * place..][..6];
    Twist { angular: Vector3::from_slice(entries), linear: Vector3::from_slice(&entries[3..]) }
}
