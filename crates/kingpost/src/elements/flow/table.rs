//! Coefficients over the direction of a flow.

use crate::scalar::Scalar;
use core::f64::consts::{PI, TAU};

/// An error in a table: the column, the row and what is allowed.
#[derive(Clone, Debug, PartialEq)]
pub struct TableError {
    /// The column.
    pub column: &'static str,
    /// Index of the row; `None` if the number of rows is wrong.
    pub row: Option<usize>,
    /// The value found.
    pub found: f64,
    /// Range that is allowed.
    pub allowed: &'static str,
}

/// Coefficients of surge force, sway force and yaw moment over the direction of the flow from the hull's x axis,
/// counter-clockwise: a periodic curve of cubic Hermite pieces through the given points. The slope at a point is that
/// of the parabola through the point and its two neighbours.
#[derive(Clone, Debug)]
pub struct DirectionTable<S = f64> {
    /// Start of each piece, rad, increasing, within one turn.
    directions: Vec<f64>,
    pieces: Vec<CubicPiece<S>>,
}

/// Weights of 1, t, t^2, t^3 with t the angle from the start of the piece, rad.
type CubicPiece<S> = [[S; 4]; 3];

impl<S: Scalar> DirectionTable<S> {
    /// Returns the table from directions, rad, and the three coefficients at each. The table of a `symmetric` hull goes
    /// from 0 to pi, both included. It is mirrored to the other side with sway and yaw reversed, so both are 0 in a
    /// flow along the hull.
    ///
    /// # Errors
    /// Directions that do not increase or that exceed one turn, or fewer than three directions; for a symmetric hull,
    /// sway or yaw coefficients other than 0 at the directions 0 and pi.
    pub fn new(directions_rad: &[f64], rows: &[[S; 3]], symmetric: bool) -> Result<Self, TableError> {
        check(directions_rad, symmetric)?;
        if symmetric {
            check_mirrored(rows)?;
        }
        let mut points: Vec<(f64, [S; 3])> = directions_rad.iter().copied().zip(rows.iter().copied()).collect();
        if symmetric {
            let inner = points[1..points.len() - 1].iter().rev();
            let mirrored: Vec<_> = inner.map(|(angle, [x, y, yaw])| (TAU - angle, [*x, -*y, -*yaw])).collect();
            points.extend(mirrored);
        }
        let n = points.len();
        let at = |i: usize| points[i % n];
        let width = |i: usize| at(i + 1).0 - at(i).0 + if i % n + 1 == n { TAU } else { 0.0 };
        let slope = |i: usize, k: usize| {
            let before = (i + n - 1) % n;
            let (a, b) = (S::constant(width(before)), S::constant(width(i)));
            let (left, right) = ((at(i).1[k] - at(before).1[k]) / a, (at(i + 1).1[k] - at(i).1[k]) / b);
            (left * b + right * a) / (a + b)
        };
        let piece = |i: usize| {
            core::array::from_fn(|k| hermite(width(i), [at(i).1[k], at(i + 1).1[k]], [slope(i, k), slope(i + 1, k)]))
        };
        Ok(Self { directions: points.iter().map(|(angle, _)| *angle).collect(), pieces: (0..n).map(piece).collect() })
    }

    /// Returns the coefficients at a direction in (-pi, pi], rad.
    pub fn at(&self, direction: S) -> [S; 3] {
        let first = self.directions[0];
        let [begin, place] = S::from_values([direction], &|[direction]| {
            let behind = (direction - first).rem_euclid(TAU) + first;
            let i = self.directions.partition_point(|begin| *begin <= behind).max(1) - 1;
            [self.directions[i], i as f64]
        });
        let piece = self.piece(place);
        let from_begin = direction - begin;
        // Tables from -pi to pi and from 0 to 2 pi differ by at most a full turn.
        let turned = from_begin.select_below(-1e-9, || from_begin + S::constant(TAU), || from_begin);
        core::array::from_fn(|k| {
            let c = &piece[k];
            c[0] + turned * (c[1] + turned * (c[2] + turned * c[3]))
        })
    }

    /// Returns the piece at an index; each lane may have a different one.
    fn piece(&self, place: S) -> CubicPiece<S> {
        let first = place.value();
        if place.all(|place| place == first) {
            return self.pieces[first as usize];
        }
        let weight = |k: usize, j: usize| {
            let next = |found, (i, piece): (usize, &CubicPiece<S>)| {
                place.select_below(i as f64 - 0.5, || found, || piece[k][j])
            };
            self.pieces.iter().enumerate().fold(S::ZERO, next)
        };
        core::array::from_fn(|k| core::array::from_fn(|j| weight(k, j)))
    }
}

fn hermite<S: Scalar>(width: f64, [from, to]: [S; 2], [start, end]: [S; 2]) -> [S; 4] {
    let (width, two, three) = (S::constant(width), S::constant(2.0), S::constant(3.0));
    let mean = (to - from) / width;
    [from, start, (three * mean - two * start - end) / width, (start + end - two * mean) / (width * width)]
}

/// Largest distance of the first direction from 0 and of the last from pi for a symmetric hull, rad.
const SAME_ANGLE: f64 = 1e-6;

fn check(directions: &[f64], symmetric: bool) -> Result<(), TableError> {
    let error = |row, found, allowed| Err(TableError { column: "directions_rad", row, found, allowed });
    let last = directions.len().saturating_sub(1);
    if directions.len() < 3 {
        return error(None, directions.len() as f64, "three directions or more");
    }
    let increases = |row: usize| directions[row] < directions[row + 1];
    if let Some(row) = (0..last).find(|&row| !increases(row)) {
        return error(Some(row + 1), directions[row + 1], "a direction greater than the one before");
    }
    match symmetric {
        true if directions[0].abs() > SAME_ANGLE => error(Some(0), directions[0], "0, where the hull is symmetric"),
        true if (directions[last] - PI).abs() > SAME_ANGLE => {
            error(Some(last), directions[last], "pi, where the hull is symmetric")
        }
        false if !(-PI..=PI).contains(&directions[0]) => error(Some(0), directions[0], "-pi to pi"),
        false if directions[last] - directions[0] >= TAU => {
            error(Some(last), directions[last], "less than a turn from the first: the table closes by itself")
        }
        _ => Ok(()),
    }
}

/// Share of the largest coefficient in a column below which a coefficient counts as 0 in a flow along a symmetric hull.
const ROUNDING: f64 = 1e-9;

/// Checks that side force and yaw moment are 0 in a flow along a symmetric hull.
fn check_mirrored<S: Scalar>(rows: &[[S; 3]]) -> Result<(), TableError> {
    let size = |x: S| x.select_below(0.0, || -x, || x);
    for (k, column) in [(1, "sway"), (2, "yaw")] {
        let larger = |largest: S, row: &[S; 3]| largest.select_less(size(row[k]), || size(row[k]), || largest);
        let largest = rows.iter().fold(S::ZERO, larger);
        for row in [0, rows.len() - 1] {
            let beyond = size(rows[row][k]) - S::constant(ROUNDING) * largest;
            if !beyond.all(|beyond| beyond <= 0.0) {
                let found = rows[row][k].value();
                let allowed = "0 in a flow along a symmetric hull, from ahead or astern";
                return Err(TableError { column, row: Some(row), found, allowed });
            }
        }
    }
    Ok(())
}
