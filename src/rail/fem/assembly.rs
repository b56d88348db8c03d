//! Matrices of a mesh, element by element: mass, damping and stiffness in time, or the dynamic stiffness at one frequency.

use super::mesh::Mesh;
use super::shape::{GAUSS, Shape};
use crate::math::banded::Banded;
use crate::track::{Link, Member};
use nalgebra::ComplexField;

/// What a member gives to one matrix, per metre: ∫ bend θ′ᵀθ′ + shear γᵀγ + tension w′ᵀw′ + mass wᵀw + rotary θᵀθ dx.
#[derive(Clone, Copy, Debug)]
pub(super) struct Given<T> {
    /// Times EI.
    pub bend: T,
    /// Times κGA, of beams that shear.
    pub shear: T,
    pub tension: T,
    pub mass: T,
    pub rotary: T,
}

/// What a link gives: [[upper, cross], [cross, lower]].
pub(super) type Pair<T> = [T; 3];

/// The matrix of `mesh` to which `member` and `link` give these.
pub(super) fn assemble<T: ComplexField<RealField = f64> + Copy>(
    mesh: &Mesh,
    member: &dyn Fn(&Member) -> Given<T>,
    link: &dyn Fn(&Link) -> Pair<T>,
) -> Banded<T> {
    let mut matrix = Banded::zeros(mesh.size, mesh.half);
    for beam in &mesh.elements {
        for ((xi, weight), &column) in GAUSS.iter().zip(&beam.columns) {
            let (column, weight) = (&mesh.columns[column], weight * beam.h);
            for (i, members) in column.fields.iter().enumerate() {
                for m in members {
                    bend(&mut matrix, member(m), (&beam.unknowns[i], &beam.shapes[i], *xi), weight);
                }
            }
            for (upper, lower, between) in &column.links {
                let of_field = |i: usize| (beam.unknowns[i], beam.shapes[i].displacement(*xi));
                let (upper, lower) = (of_field(*upper), lower.map(of_field));
                let below = lower.as_ref().map(|(unknowns, n)| (&unknowns[..], &n[..]));
                join(&mut matrix, link(between), (&upper.0, &upper.1), below, weight);
            }
        }
    }
    for (number, support) in mesh.supports.iter().enumerate() {
        let column = &mesh.columns[support.column];
        let at = |i: usize| [support.unknowns[i]];
        for (i, members) in column.fields.iter().enumerate() {
            for m in members {
                let g = member(m);
                put(&mut matrix, support.unknowns[i], support.unknowns[i], g.mass);
                // a spring from this support to the next
                let next = mesh.supports.get(number + 1).and_then(|next| next.unknowns.get(i));
                if let (Some(&beyond), Some(_)) = (next, m.tension) {
                    let spring = [g.tension, -g.tension, g.tension];
                    join(&mut matrix, spring, (&at(i), &[1.0]), Some((&[beyond], &[1.0])), 1.0);
                }
            }
        }
        for (upper, lower, between) in &column.links {
            let lower = lower.map(at);
            let below = lower.as_ref().map(|unknown| (&unknown[..], &[1.0][..]));
            join(&mut matrix, link(between), (&at(*upper), &[1.0]), below, 1.0);
        }
    }
    matrix
}

/// What a member gives at the point `xi` of an element, of this `weight` [m].
fn bend<T: ComplexField<RealField = f64> + Copy>(
    matrix: &mut Banded<T>,
    given: Given<T>,
    (unknowns, shape, xi): (&[usize; 4], &Shape, f64),
    weight: f64,
) {
    let (n, slope) = (shape.displacement(xi), shape.slope(xi));
    let (rotation, curvature) = (shape.rotation(xi), shape.curvature(xi));
    // γ = w′ − θ
    let gamma = [0, 1, 2, 3].map(|i| slope[i] - rotation[i]);
    for a in 0..4 {
        for b in 0..4 {
            let of = |shape: &[f64; 4]| T::from_real(weight * shape[a] * shape[b]);
            let sum = given.bend * of(&curvature)
                + given.shear * of(&gamma)
                + given.tension * of(&slope)
                + given.mass * of(&n)
                + given.rotary * of(&rotation);
            put(matrix, unknowns[a], unknowns[b], sum);
        }
    }
}

/// Adds at (i, j), once for every pair above the diagonal.
fn put<T: ComplexField + Copy>(matrix: &mut Banded<T>, i: usize, j: usize, value: T) {
    if j <= i {
        matrix.add(i, j, value);
    }
}

/// Unknowns and the displacement each of them gives.
type End<'a> = (&'a [usize], &'a [f64]);

fn join<T: ComplexField<RealField = f64> + Copy>(
    matrix: &mut Banded<T>,
    [upper, cross, lower]: Pair<T>,
    above: End,
    below: Option<End>,
    weight: f64,
) {
    let mut block = |value: T, rows: End, columns: End| {
        for (i, a) in rows.0.iter().zip(rows.1) {
            for (j, b) in columns.0.iter().zip(columns.1) {
                put(matrix, *i, *j, value * T::from_real(a * b * weight));
            }
        }
    };
    block(upper, above, above);
    if let Some(below) = below {
        block(lower, below, below);
        block(cross, above, below);
        block(cross, below, above);
    }
}
