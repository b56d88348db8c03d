//! The track cut into elements: nodes, what lies along each element, what stands under each support, and their unknowns.

use super::FemError;
use super::column::{Column, Loosened};
use super::shape::{GAUSS, Shape};

/// One element: the unknowns of its fields and its properties at the points of Gauss.
#[derive(Clone, Debug)]
pub(super) struct Beam {
    pub h: f64,
    /// (u, θ) left and right of each field.
    pub unknowns: Vec<[usize; 4]>,
    pub shapes: Vec<Shape>,
    /// Numbers of its columns, at each point of [`GAUSS`].
    pub columns: [usize; GAUSS.len()],
}

/// One support: the unknowns of its fields, the rail's first.
#[derive(Clone, Debug)]
pub struct Support {
    /// Where it stands [m].
    pub x: f64,
    pub(super) unknowns: Vec<usize>,
    pub(super) column: usize,
}

/// A spring and dashpot that only push: R = k(Δ − g) + c Δ̇ where Δ > g and that is above zero.
#[derive(Clone, Debug, PartialEq)]
pub struct Gap {
    /// Number of its support in [`Mesh::supports`].
    pub support: usize,
    /// Unknown above and, unless it is rock, below.
    pub(crate) unknowns: (usize, Option<usize>),
    /// k [N/m]
    pub stiffness: f64,
    /// c [N s/m]
    pub damping: f64,
    /// g [m]
    pub gap: f64,
}

/// What is wrong with one support.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fault {
    /// It is not there.
    Missing,
    /// It hangs under the rail, so far above its bed [m].
    Hanging(f64),
}

/// A track of finite length in elements.
#[derive(Clone, Debug, Default)]
pub struct Mesh {
    /// Places of the nodes [m], rising.
    pub x: Vec<f64>,
    pub(super) elements: Vec<Beam>,
    pub(super) columns: Vec<Column>,
    /// Its supports, rising in x.
    pub supports: Vec<Support>,
    /// Supports that hang.
    pub gaps: Vec<Gap>,
    /// Unknown of the rail's displacement at each node.
    pub(crate) rail: Vec<usize>,
    /// Unknowns that do not move, which no force reaches.
    pub(super) held: Vec<usize>,
    pub(super) size: usize,
    pub(super) half: usize,
}

/// A place of the track where something stands or changes, and the rail from it to the next one.
#[derive(Clone, Debug)]
pub struct Station {
    /// [m]
    pub x: f64,
    /// What stands under the rail there, and the gap [m] under its sleeper, if it hangs.
    pub under: Option<(Column, Option<f64>)>,
    /// The rail from here on.
    pub rail: Column,
    /// Elements from here to the next station.
    pub elements: usize,
}

/// A support before it is numbered.
struct Standing {
    node: usize,
    column: Column,
    hangs: Option<f64>,
}

impl Mesh {
    /// A continuous track with nodes at `x` [m], `along(e, x)` what lies over place x of element e; at the nodes `jumps` it changes at
    /// once, and fields that nothing holds together along the track jump with it, as sleepers do whose bed jumps.
    ///
    /// # Errors
    /// Fewer than two nodes.
    pub fn continuous(
        x: Vec<f64>,
        jumps: &[usize],
        along: &dyn Fn(usize, f64) -> Result<Column, FemError>,
    ) -> Result<Self, FemError> {
        Self::new(x, jumps, along, Vec::new())
    }

    /// A rail on supports: `stations`, rising in x, the last of which ends the track.
    ///
    /// # Errors
    /// Fewer than two, supports that cannot hang.
    pub fn supported(stations: &[Station]) -> Result<Self, FemError> {
        let Some((last, pieces)) = stations.split_last() else { return Err(FemError::NoElement) };
        let mut x = Vec::new();
        let mut of_element = Vec::new();
        let mut standing = Vec::new();
        for (i, station) in stations.iter().enumerate() {
            if let Some((column, hangs)) = &station.under {
                standing.push(Standing { node: x.len(), column: column.clone(), hangs: *hangs });
            }
            let Some(next) = stations.get(i + 1) else { break };
            for j in 0..station.elements {
                x.push(station.x + (next.x - station.x) * j as f64 / station.elements as f64);
                of_element.push(i);
            }
        }
        x.push(last.x);
        Self::new(x, &[], &|e, _| Ok(pieces[of_element[e]].rail.clone()), standing)
    }

    fn new(
        x: Vec<f64>,
        jumps: &[usize],
        along: &dyn Fn(usize, f64) -> Result<Column, FemError>,
        mut standing: Vec<Standing>,
    ) -> Result<Self, FemError> {
        if x.len() < 2 {
            return Err(FemError::NoElement);
        }
        let mut columns: Vec<Column> = Vec::new();
        let mut number = |column: Column| {
            // neighbours are alike
            let same = columns.iter().rposition(|other| *other == column);
            same.unwrap_or_else(|| {
                columns.push(column);
                columns.len() - 1
            })
        };
        let mut of_elements = Vec::with_capacity(x.len() - 1);
        for e in 0..x.len() - 1 {
            let mut found = [0; GAUSS.len()];
            for (place, (xi, _)) in found.iter_mut().zip(GAUSS) {
                *place = number(along(e, x[e] + xi * (x[e + 1] - x[e]))?);
            }
            of_elements.push(found);
        }
        let mut loosened = Vec::new();
        for s in &mut standing {
            let loose = s.hangs.map(|gap| s.column.loosen().map(|loose| (gap, loose)));
            loosened.push(loose.transpose()?);
        }
        let of_supports: Vec<usize> = standing.iter().map(|s| number(s.column.clone())).collect();
        let mut mesh = Self { x, columns, ..Self::default() };
        let mut nodes = Vec::with_capacity(mesh.x.len());
        let mut next = standing.iter().zip(of_supports).zip(loosened).peekable();
        for node in 0..mesh.x.len() {
            let column = of_elements[node.min(of_elements.len() - 1)][0];
            nodes.push(mesh.number_node(column, jumps.contains(&node)));
            if let Some(((_, column), loosened)) = next.next_if(|((s, _), _)| s.node == node) {
                mesh.number_support(node, nodes[node].0[0], column, loosened);
            }
        }
        mesh.rail = nodes.iter().map(|(left, _)| left[0]).collect();
        mesh.elements = of_elements.iter().enumerate().map(|(e, of)| mesh.beam(e, of, &nodes)).collect();
        mesh.half = mesh.half_bandwidth();
        Ok(mesh)
    }

    /// First unknowns of the fields of `column` left and right of the next node: the same, but of loose fields where the column jumps.
    fn number_node(&mut self, column: usize, jump: bool) -> (Vec<usize>, Vec<usize>) {
        let column = &self.columns[column];
        let mut pair = || {
            self.size += 2;
            self.size - 2
        };
        let left: Vec<usize> = column.fields.iter().map(|_| pair()).collect();
        let right = (0..left.len()).map(|i| if jump && column.is_loose(i) { pair() } else { left[i] });
        let right = right.collect();
        (left, right)
    }

    /// The support of `column` at `node` under the unknown `rail`; loosened by a gap [m] above its bed.
    fn number_support(&mut self, node: usize, rail: usize, column: usize, loosened: Option<(f64, Loosened)>) {
        let below = self.columns[column].fields.len() - 1;
        let unknowns: Vec<usize> = std::iter::once(rail).chain(self.size..self.size + below).collect();
        self.size += below;
        if let Some((gap, Loosened { stiffness, damping, lower })) = loosened {
            let unknowns = (unknowns[1], lower.map(|lower| unknowns[lower]));
            self.gaps.push(Gap { support: self.supports.len(), unknowns, stiffness, damping, gap });
        }
        self.supports.push(Support { x: self.x[node], unknowns, column });
    }

    /// Element `e` between its `nodes`.
    fn beam(&self, e: usize, columns: &[usize; GAUSS.len()], nodes: &[(Vec<usize>, Vec<usize>)]) -> Beam {
        let (h, column) = (self.x[e + 1] - self.x[e], &self.columns[columns[0]]);
        let unknowns = nodes[e].1.iter().zip(&nodes[e + 1].0);
        // fields that do not bend follow the shapes of the rail
        let shape = |i: usize| Shape::new(h, column.beam(i).or(column.beam(0)));
        Beam {
            h,
            unknowns: unknowns.map(|(left, right)| [*left, left + 1, *right, right + 1]).collect(),
            shapes: (0..column.fields.len()).map(shape).collect(),
            columns: *columns,
        }
    }

    fn half_bandwidth(&self) -> usize {
        let spread = |unknowns: &mut dyn Iterator<Item = usize>| {
            let (least, most) = unknowns.fold((usize::MAX, 0), |(a, b), u| (a.min(u), b.max(u)));
            most - least
        };
        // neighbours may be joined
        let chained = self.supports.windows(2).flat_map(|pair| {
            let fields = &self.columns[pair[0].column].fields;
            let both = fields.iter().zip(pair[0].unknowns.iter().zip(&pair[1].unknowns));
            both.filter(|(members, _)| members.iter().any(|m| m.tension.is_some())).map(|(_, (a, b))| b - a)
        });
        let of_beams = self.elements.iter().map(|e| spread(&mut e.unknowns.iter().flatten().copied()));
        let of_supports = self.supports.iter().map(|s| spread(&mut s.unknowns.iter().copied()));
        of_beams.chain(of_supports).chain(chained).max().unwrap_or(0)
    }

    /// Unknowns of the first and of the last cross-section: of the node, and of a support that stands there.
    pub(super) fn ends(&self) -> [Vec<usize>; 2] {
        let (first, last) = (&self.elements[0], &self.elements[self.elements.len() - 1]);
        let of = |x: f64, nodal: Vec<usize>| {
            let stands = self.supports.iter().filter(|support| support.x == x);
            nodal.into_iter().chain(stands.flat_map(|support| support.unknowns[1..].to_vec())).collect()
        };
        [
            of(self.x[0], first.unknowns.iter().flat_map(|u| [u[0], u[1]]).collect()),
            of(self.x[self.x.len() - 1], last.unknowns.iter().flat_map(|u| [u[2], u[3]]).collect()),
        ]
    }

    /// Which of the unknowns of [`Mesh::ends`] are rotations.
    pub(super) fn turns(&self) -> Vec<bool> {
        let nodal = 2 * self.elements[0].unknowns.len();
        (0..self.ends()[0].len()).map(|i| i < nodal && i % 2 == 1).collect()
    }

    /// Leaves half of the supports at both ends, so that tracks of equal cells can be put together there.
    pub(super) fn halve_ends(&mut self) {
        let ends = [self.x[0], self.x[self.x.len() - 1]];
        for support in self.supports.iter_mut().filter(|support| ends.contains(&support.x)) {
            self.columns.push(self.columns[support.column].halved());
            support.column = self.columns.len() - 1;
        }
    }

    /// Number of unknowns.
    pub fn size(&self) -> usize {
        self.size
    }

    /// Element over `x` [m] and ξ in it, the ends' for what lies beyond.
    fn element(&self, x: f64) -> (usize, f64) {
        let e = self.x.partition_point(|node| *node <= x).clamp(1, self.elements.len()) - 1;
        (e, ((x - self.x[e]) / self.elements[e].h).clamp(0.0, 1.0))
    }

    /// The rail at `x` [m]: its unknowns there with their shapes N, and the flexibility [m/N] of the element that nodal values miss under
    /// a force at the same place.
    pub fn rail_at(&self, x: f64) -> ([(usize, f64); 4], f64) {
        let (e, xi) = self.element(x);
        let beam = &self.elements[e];
        let n = beam.shapes[0].displacement(xi);
        let column = &self.columns[beam.columns[0]];
        let bending = column.beam(0).map_or(f64::INFINITY, |rail| rail.bending_stiffness);
        let moves = |i: usize| !self.held.contains(&beam.unknowns[0][i]);
        let unknowns = [0, 1, 2, 3].map(|i| (beam.unknowns[0][i], if moves(i) { n[i] } else { 0.0 }));
        (unknowns, beam.shapes[0].held_flexibility(xi) / bending)
    }

    /// Slope u_r′ of the rail at `x` [m] per unknown [1/m, 1, …].
    pub fn rail_slope_at(&self, x: f64) -> [(usize, f64); 4] {
        let (e, xi) = self.element(x);
        let slope = self.elements[e].shapes[0].slope(xi);
        [0, 1, 2, 3].map(|i| (self.elements[e].unknowns[0][i], slope[i]))
    }

    /// Field number `field` below the rail (1: the sleepers) at `x` [m] by its unknowns: of the nearest support, or of a continuous track
    /// there; empty where there is none.
    pub fn below_at(&self, field: usize, x: f64) -> Vec<(usize, f64)> {
        let near = |a: &&Support, b: &&Support| (a.x - x).abs().total_cmp(&(b.x - x).abs());
        if let Some(support) = self.supports.iter().min_by(near) {
            return support.unknowns.get(field).map(|&unknown| (unknown, 1.0)).into_iter().collect();
        }
        let (e, xi) = self.element(x);
        let beam = &self.elements[e];
        let Some(unknowns) = beam.unknowns.get(field) else { return Vec::new() };
        unknowns.iter().copied().zip(beam.shapes[field].displacement(xi)).collect()
    }
}
