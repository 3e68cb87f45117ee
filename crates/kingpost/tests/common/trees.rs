//! Random trees of bodies, described so that a failing case can shrink: to fewer bodies, all on the first
//! one, with fixed joints and nothing held. The numbers of a body come from a separate seed, so that they do
//! not change when another body is removed.

use super::Random;
use kingpost::dynamics::Loads;
use kingpost::model::joint::{AxisList, ElementaryAxis, Fixed, Floating, Prismatic, Revolute, Spherical};
use kingpost::model::{BodyDefinition, Joint, JointKind, Model, MotionType};
use kingpost::spatial::{Quaternion, Wrench, exp};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{RngSeed, TestCaseResult, TestError, TestRunner};

/// Most bodies of a tree.
const MOST_BODIES: usize = 30;
/// Most axes of a joint.
const MOST_AXES: usize = 5;

/// Streams of a body's random numbers.
const STATE: u64 = 1;
const LOADS: u64 = 2;
const ROTORS: u64 = 3;
const COUPLING: u64 = 4;

/// The kind of a body's joint, the simplest first.
#[derive(Clone, Copy, Debug)]
pub enum Kind {
    Fixed,
    Revolute,
    Prismatic,
    Spherical,
    Cylindrical,
    Universal,
    Planar,
    Elastic,
    /// So many axes that move independently of one another near q = 0 and far from it.
    Axes(usize),
    /// Whether the body is on the world, independent of the parent.
    Floating {
        hold_translation: bool,
        hold_rotation: bool,
    },
}

/// A body, with its parent and its joint.
#[derive(Clone, Debug)]
pub struct Branch {
    /// Counted modulo the bodies before it; `None` is the world.
    pub parent: Option<usize>,
    pub kind: Kind,
    /// Modes of the axes, as many as there are.
    pub modes: [MotionType; MOST_AXES],
    /// Whether its inertia is a full 6x6.
    pub full_inertia: bool,
    /// Seed of its masses, lengths, angles, rates and loads.
    pub numbers: u64,
}

/// A tree of 1 to 30 bodies with at least one free coordinate.
#[derive(Clone, Debug)]
pub struct Tree(pub Vec<Branch>);

/// Trees that shrink.
pub fn trees() -> impl Strategy<Value = Tree> {
    let of_any_size = prop::collection::vec(branch(), 1..=MOST_BODIES).prop_map(Tree);
    of_any_size.prop_filter("nothing moves freely", |tree| !tree.model().free_coordinates().is_empty())
}

fn branch() -> impl Strategy<Value = Branch> {
    let parent = prop::option::weighted(0.9, 0..MOST_BODIES);
    let mode = prop_oneof![4 => Just(MotionType::Free), 1 => Just(MotionType::Held), 1 => Just(MotionType::Prescribed)];
    let modes = proptest::array::uniform5(mode);
    let parts = (parent, kind(), modes, prop::bool::weighted(0.3), any::<u64>().no_shrink());
    parts.prop_map(|(parent, kind, modes, full_inertia, numbers)| Branch { parent, kind, modes, full_inertia, numbers })
}

fn kind() -> impl Strategy<Value = Kind> {
    let floating = (prop::bool::weighted(0.3), prop::bool::weighted(0.2));
    prop_oneof![
        5 => Just(Kind::Fixed),
        10 => Just(Kind::Revolute),
        10 => Just(Kind::Prismatic),
        10 => Just(Kind::Spherical),
        2 => Just(Kind::Cylindrical),
        2 => Just(Kind::Universal),
        2 => Just(Kind::Planar),
        2 => Just(Kind::Elastic),
        2 => (1..=MOST_AXES).prop_map(Kind::Axes),
        2 => floating.prop_map(|(hold_translation, hold_rotation)| Kind::Floating { hold_translation, hold_rotation }),
    ]
}

/// The tree of a seed.
pub fn tree_of(seed: u64) -> Tree {
    trees().new_tree(&mut runner(1, seed)).expect("most trees have a free coordinate").current()
}

/// Checks a property for this number of random trees, which are equal in every run of the tests.
///
/// # Panics
/// If the property fails, with the smallest tree found for which it does.
#[track_caller]
pub fn for_all(count: u32, property: impl Fn(&Tree) -> TestCaseResult) {
    if let Err(failure) = smallest_failure(count, property) {
        panic!("{failure}");
    }
}

/// Tests a property like [`for_all`], with the failure as a value.
pub fn smallest_failure(count: u32, property: impl Fn(&Tree) -> TestCaseResult) -> Result<(), TestError<Tree>> {
    runner(count, 2019).run(&trees(), |tree| property(&tree))
}

fn runner(cases: u32, seed: u64) -> TestRunner {
    let rng_seed = RngSeed::Fixed(seed);
    TestRunner::new(ProptestConfig { cases, rng_seed, failure_persistence: None, ..ProptestConfig::default() })
}

impl Tree {
    pub fn model(&self) -> Model {
        let describe = |(i, branch): (usize, &Branch)| {
            let mut random = branch.random(0);
            let floats = matches!(branch.kind, Kind::Floating { .. });
            let parent = branch.parent.filter(|_| i > 0 && !floats).map(|parent| parent % i);
            let joint = Joint { name: format!("joint_{i}"), kind: branch.joint(&mut random), mode: branch.mode() };
            let (mass, rigid) = random.rigid();
            let inertia = if branch.full_inertia { random.full_inertia() } else { rigid };
            BodyDefinition { name: format!("body_{i}"), parent, joint, mass, inertia, points: Vec::new() }
        };
        let mut model = Model::new(self.0.iter().enumerate().map(describe).collect());
        for (body, branch) in self.0.iter().enumerate() {
            let mut random = branch.random(ROTORS);
            for coordinate in velocities(&model, body) {
                if model.axis_coordinate(coordinate).is_some() && random.chance(0.3) {
                    model.rotor_inertia[coordinate] = random.uniform(0.0, 3.0);
                }
            }
        }
        model
    }

    /// Random numbers of one kind that belong to the whole tree.
    pub fn numbers(&self, sort: u64) -> Random {
        self.0[0].random(sort)
    }

    /// Returns positions and velocities; held coordinates are at rest.
    pub fn state(&self, model: &Model) -> (Vec<f64>, Vec<f64>) {
        let (mut q, mut v) = (Vec::new(), Vec::new());
        for (body, branch) in self.0.iter().enumerate() {
            let (mut random, node) = (branch.random(STATE), &model.tree.nodes[body]);
            q.extend((0..node.kind.position_count()).map(|_| random.uniform(-2.0, 2.0)));
            if let Some((first, _)) = node.kind.quaternion() {
                q[node.positions + first..][..4].copy_from_slice(&Quaternion::exp(random.vector(2.0)).0);
            }
            let rate = |i| if model.modes[i] == MotionType::Held { 0.0 } else { random.uniform(-2.0, 2.0) };
            v.extend(velocities(model, body).map(rate));
        }
        (q, v)
    }

    /// Loads of every kind that the dynamics takes.
    pub fn loads(&self, model: &Model) -> Loads {
        let mut loads = Loads::new(model);
        for (body, branch) in self.0.iter().enumerate() {
            let mut random = branch.random(LOADS);
            loads.wrenches.push((body, Wrench { moment: random.vector(5.0), force: random.vector(5.0) }));
            for i in velocities(model, body) {
                loads.force[i] = random.uniform(-5.0, 5.0);
                loads.acceleration[i] = random.uniform(-3.0, 3.0);
            }
            if random.chance(0.2) {
                loads.added_inertia.push((body, random.full_inertia()));
            }
        }
        self.numbers(COUPLING).couple_floating_bodies(model, &mut loads);
        loads
    }
}

/// Indices in v of a body's coordinates.
fn velocities(model: &Model, body: usize) -> core::ops::Range<usize> {
    let node = &model.tree.nodes[body];
    node.velocities..node.velocities + node.kind.velocity_count()
}

impl Branch {
    /// Random numbers of one kind that belong to the body.
    pub fn random(&self, sort: u64) -> Random {
        Random::new(self.numbers.wrapping_add(sort))
    }

    /// The mode of a joint that has one for all of it; a spherical joint cannot be prescribed.
    fn mode(&self) -> MotionType {
        match (self.kind, self.modes[0]) {
            (Kind::Revolute | Kind::Prismatic, mode) => mode,
            (Kind::Spherical, MotionType::Held) => MotionType::Held,
            _ => MotionType::Free,
        }
    }

    fn joint(&self, random: &mut Random) -> JointKind {
        let (placement, axis, to_child) = (random.frame(), random.unit(), random.vector(1.5));
        let across = axis.cross(random.unit());
        let across = if across.norm() < 0.1 { axis.cross(random.unit()) } else { across };
        let across = across * (1.0 / across.norm());
        let list = match self.kind {
            Kind::Fixed => return JointKind::Fixed(Fixed::new(placement, to_child)),
            Kind::Revolute => return JointKind::Revolute(Revolute::new(placement, axis, to_child)),
            Kind::Prismatic => return JointKind::Prismatic(Prismatic::new(placement, axis, to_child)),
            Kind::Spherical => return JointKind::Spherical(Spherical::new(placement, to_child)),
            Kind::Floating { hold_translation, hold_rotation } => {
                return JointKind::Floating(Floating { hold_translation, hold_rotation });
            }
            Kind::Cylindrical => AxisList::cylindrical(placement, axis, to_child),
            Kind::Universal => AxisList::universal(placement, axis, across, to_child),
            Kind::Planar => AxisList::planar(placement, axis, across, to_child),
            Kind::Elastic => AxisList::elastic(placement, to_child),
            Kind::Axes(count) => {
                AxisList::new(placement, &axes(random, count), &["a", "b", "c", "d", "e"][..count], to_child)
            }
        };
        JointKind::AxisList(list.with_modes(&self.modes[..list.axes().len()]))
    }
}

/// Some of three translations and two rotations about perpendicular axes, in any order.
fn axes(random: &mut Random, count: usize) -> Vec<ElementaryAxis> {
    let turned = exp(random.vector(2.0));
    let mut axes: Vec<ElementaryAxis> = (0..3).map(|k| ElementaryAxis::translation(turned.column(k))).collect();
    axes.extend((0..2).map(|k| ElementaryAxis::rotation(turned.column(k))));
    for i in (1..axes.len()).rev() {
        axes.swap(i, random.below(i + 1));
    }
    axes.truncate(count);
    axes
}
