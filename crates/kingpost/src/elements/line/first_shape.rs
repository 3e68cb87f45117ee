//! The first shape from which the search for a tree of lines at rest begins: catenaries between ends, joints and buoys.

use super::ground::LineGround;
use super::mesh::{LineMesh, LineMeshElement, SecondEnd};
use super::one_sided::positive;
use super::strand::{LineJoint, Strand};
use crate::elements::Context;
use crate::elements::lines::{Catenary, Span};
use crate::scalar::Scalar;
use crate::spatial::Vector3;
use crate::world::CurrentAt;
use core::f64::consts::FRAC_PI_4;

/// Horizontal distance between the ends of the catenary, as a share of the length, at least.
const NEAREST: f64 = 1e-6;
/// Sweeps over the joints that let springs pull them to their first places.
const SWEEPS: usize = 40;

/// Nodes of a line whose places are known.
type Known<S> = Vec<(usize, Vector3<S>)>;

/// Writes a first shape of lines, whose ends on bodies or in the world are at the first and last of these nodes.
pub fn shape<S: Scalar>(strands: &[Strand<S>], at: &Context<'_, S>, nodes: &mut [Vec<Vector3<S>>]) {
    place_joints(strands, nodes);
    for (strand, nodes) in strands.iter().zip(nodes) {
        let (mesh, ground) = (&strand.mesh, strand.ground.as_ref());
        let known = known(mesh, nodes);
        for pair in known.windows(2) {
            lay(mesh, ground, [pair[0], pair[1]], at, nodes);
        }
        if mesh.hangs_free() {
            drop(mesh, ground, known[known.len() - 1], at, nodes);
        }
    }
}

/// Returns the nodes of a line whose places are known: its first end, joints, and its last end unless it is free.
fn known<S: Scalar>(mesh: &LineMesh<S>, nodes: &[Vector3<S>]) -> Known<S> {
    let last = (mesh.second != SecondEnd::Free).then_some(nodes.len() - 1);
    let known = core::iter::once(0).chain(mesh.joints.iter().copied()).chain(last);
    known.map(|node| (node, nodes[node])).collect()
}

/// Puts joints where springs between them and the ends, each as soft as its part of a line is long, hold them.
fn place_joints<S: Scalar>(strands: &[Strand<S>], nodes: &mut [Vec<Vector3<S>>]) {
    let start = nodes[0][0];
    for (strand, nodes) in strands.iter().zip(&mut *nodes) {
        strand.mesh.joints.iter().for_each(|node| nodes[*node] = start);
        if strand.joint.is_some() {
            nodes[strand.mesh.nodes.len() - 1] = start;
        }
    }
    let joints: Vec<LineJoint> = (0..strands.len())
        .flat_map(|strand| strands[strand].mesh.joints.iter().map(move |node| LineJoint { strand, node: *node }))
        .collect();
    for _ in 0..SWEEPS {
        for joint in &joints {
            let place = pulled_to(*joint, strands, nodes);
            nodes[joint.strand][joint.node] = place;
            for (strand, nodes) in strands.iter().zip(&mut *nodes).filter(|(strand, _)| strand.joint == Some(*joint)) {
                nodes[strand.last()] = place;
            }
        }
    }
}

/// Returns the mean place of the neighbours of a joint, weighted with their distances along the lines.
fn pulled_to<S: Scalar>(joint: LineJoint, strands: &[Strand<S>], nodes: &[Vec<Vector3<S>>]) -> Vector3<S> {
    let (mut weights, mut sum) = (S::ZERO, Vector3::zero());
    for (k, strand) in strands.iter().enumerate() {
        let known = known(&strand.mesh, &nodes[k]);
        for pair in known.windows(2) {
            let [(from, before), (to, behind)] = [pair[0], pair[1]];
            let is = |node: usize| {
                let own = LineJoint { strand: k, node };
                own == joint || (node == strand.last() && strand.joint == Some(joint))
            };
            let softness = length_of(&strand.mesh, [from, to]);
            for (_, other) in [(is(from), behind), (is(to), before)].into_iter().filter(|(is, _)| *is) {
                weights += S::ONE / softness;
                sum += other * (S::ONE / softness);
            }
        }
    }
    sum * (S::ONE / weights)
}

/// Writes a first shape of the part of a line from a node at this place to its free end: straight down, or up if it floats, as far
/// as the seabed or the surface, and beyond down the slope of the seabed, or along the current, or along x.
fn drop<S: Scalar>(
    mesh: &LineMesh<S>,
    ground: Option<&LineGround<S>>,
    (from, first): (usize, Vector3<S>),
    at: &Context<'_, S>,
    nodes: &mut [Vector3<S>],
) {
    let part = &mesh.elements[from / 2..];
    let length = length_of(mesh, [from, nodes.len() - 1]);
    let own = mean_catenary(part, length, false, at);
    let buoys = mesh.nodes[from + 1..].iter().filter_map(|node| node.clump);
    let carried =
        buoys.fold(S::ZERO, |sum, one| sum + (one.mass - one.volume * at.world.water_density) * at.world.gravity);
    let sinks = own.weight * length + carried;
    let size = |value: S| value.select_below(0.0, || -value, || value);
    let (weight, carried, half) = (size(own.weight), size(carried), S::constant(0.5));
    // The ground carries what lies on it.
    let below = ground
        .map_or(length, |ground| positive(first[2] - ground.height_at(first)) + weight / ground.stiffness_per_length);
    let room = sinks.select_below(0.0, || positive(-first[2]), || below);
    let hangs = length.select_less(room, || length, || room);
    let end_load = length.select_less(room, || carried, || S::ZERO);
    let sign = sinks.select_below(0.0, || S::ONE, || -S::ONE);
    let along_current = at.world.current_at(&CurrentAt::Depth(positive(room - first[2])));
    let flows = along_current.norm_squared();
    let falls = ground.map_or(Vector3::zero(), LineGround::fall);
    let aside = if falls.norm_squared().all(|square| square > 0.0) {
        falls.direction()
    } else if flows.all(|square| square > 0.0) {
        along_current.direction()
    } else {
        Vector3::constant([1.0, 0.0, 0.0])
    };
    let mut along = S::ZERO;
    for (k, node) in nodes[from..].iter_mut().enumerate() {
        let hanging = along.select_less(hangs, || along, || hangs);
        let stretch =
            (weight * (hangs * hanging - hanging * hanging * half) + end_load * hanging) / own.axial_stiffness;
        let down = (hanging + stretch).select_less(room, || hanging + stretch, || room);
        *node = first + aside * (along - hanging) + Vector3::new(S::ZERO, S::ZERO, sign * down);
        along += part.get(k / 2).map_or(S::ZERO, |element| element.length * half);
    }
}

/// Returns the length between two nodes at ends of elements, m.
fn length_of<S: Scalar>(mesh: &LineMesh<S>, [from, to]: [usize; 2]) -> S {
    if (from, to) == (0, mesh.nodes.len() - 1) {
        return mesh.length;
    }
    mesh.elements[from / 2..to / 2].iter().fold(S::ZERO, |sum, element| sum + element.length)
}

/// Writes a first shape of a line between two nodes at these places: catenaries between them and buoys, each buoy as high as its
/// parts of the line reach, up to the surface.
fn lay<S: Scalar>(
    mesh: &LineMesh<S>,
    ground: Option<&LineGround<S>>,
    [(start, first), (end, last)]: [(usize, Vector3<S>); 2],
    at: &Context<'_, S>,
    nodes: &mut [Vector3<S>],
) {
    let lift = |node: usize| {
        let net = mesh.nodes[node].clump.map_or(S::ZERO, |one| one.volume * at.world.water_density - one.mass);
        net * at.world.gravity
    };
    let (whole, way) = (length_of(mesh, [start, end]), last - first);
    let lower = |a: S, b: S| a.select_less(b, || a, || b);
    let across = (way[0] * way[0] + way[1] * way[1]).sqrt();
    let (mut along, mut from) = (S::ZERO, (start, first));
    for node in (start + 2..=end).step_by(2) {
        let LineMeshElement { length, section } = mesh.elements[node / 2 - 1];
        along += length;
        let net = lift(node);
        if node < end && !net.all(|net| net > 0.0) {
            continue;
        }
        let share = along / whole;
        let stretch = S::ONE + net / section.axial_stiffness;
        let reach = |length: S, span: S| {
            let square = length * length * stretch * stretch - span * span;
            square.select_below(0.0, || S::ZERO, || square).sqrt()
        };
        let by_last = last[2] + reach(whole - along, across * (S::ONE - share));
        let height = lower(lower(first[2] + reach(along, across * share), by_last), S::ZERO);
        let buoy = Vector3([first[0] + way[0] * share, first[1] + way[1] * share, height]);
        let to = if node == end { last } else { buoy };
        hang(mesh, ground, (from, (node, to)), at, nodes);
        from = (node, to);
    }
}

/// Writes the nodes of a part of a line between two of them at these places: those of the elastic catenary with the mean
/// properties of the part; those of a straight line if it floats.
fn hang<S: Scalar>(
    mesh: &LineMesh<S>,
    ground: Option<&LineGround<S>>,
    ((before, first), (behind, last)): ((usize, Vector3<S>), (usize, Vector3<S>)),
    at: &Context<'_, S>,
    nodes: &mut [Vector3<S>],
) {
    let part = &mesh.elements[before / 2..behind / 2];
    let length = part.iter().fold(S::ZERO, |sum, element| sum + element.length);
    let is_up = (last[2] - first[2]).all(|up| up < 0.0);
    let [upper, lower] = if is_up { [first, last] } else { [last, first] };
    let way = upper - lower;
    let across = (way[0] * way[0] + way[1] * way[1]).sqrt();
    let least = length * S::constant(NEAREST);
    let span = Span { across: across.select_less(least, || least, || across), up: way[2] };
    let lies = ground.is_some_and(|ground| ground.under(lower).all(|under| under >= 0.0));
    let shape = mean_catenary(part, length, lies, at);
    let sinks = shape.weight.all(|weight| weight > 0.0);
    let force = shape.force(&span);
    let mut along = S::ZERO;
    for (k, node) in nodes[before..=behind].iter_mut().enumerate() {
        let share = along / length;
        if let Some(element) = part.get(k / 2) {
            along += element.length * S::constant(0.5);
        }
        if !sinks {
            *node = first + (last - first) * share;
            continue;
        }
        let place = shape.place(&force, &span, if is_up { S::ONE - share } else { share });
        let across = place.across / span.across;
        *node = lower + Vector3::new(way[0] * across, way[1] * across, place.up);
        if let Some(ground) = ground {
            let lowest = ground.height_at(*node);
            node[2] = node[2].select_less(lowest, || lowest, || node[2]);
        }
    }
}

/// Returns the catenary with the mean weight in water and the stiffness of a part of a line.
fn mean_catenary<S: Scalar>(
    part: &[LineMeshElement<S>],
    length: S,
    on_seabed: bool,
    at: &Context<'_, S>,
) -> Catenary<S> {
    let (mut weight, mut compliance) = (S::ZERO, S::ZERO);
    for LineMeshElement { length, section } in part {
        let displaced = at.world.water_density * section.diameter * section.diameter * S::constant(FRAC_PI_4);
        weight += (section.mass_per_length - displaced) * at.world.gravity * *length;
        compliance += *length / section.axial_stiffness;
    }
    let (unstretched_length, axial_stiffness) = (length, length / compliance);
    Catenary { unstretched_length, weight: weight / length, axial_stiffness, on_seabed }
}
