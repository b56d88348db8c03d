//! Every layout of a track in elements.

use super::FemError;
use super::column::Column;
use super::mesh::{Fault, Mesh, Station};
use crate::foundation::Springs;
use crate::track::{Layout, Section, Supports};

/// What form the columns take.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// k*(ω) of any element.
    Frequency,
    /// Springs, dashpots, masses.
    Time,
}

/// How a track is cut, and what is wrong with it.
struct Cut<'a> {
    on: &'a Springs,
    from: f64,
    to: f64,
    per_bay: usize,
    form: Form,
    faults: &'a [(i64, Fault)],
}

impl Mesh {
    /// The track of `layout` on `on`, from `from` to `to` [m] or a little beyond, to whole bays (of `bay` [m] where it is continuous), in
    /// `per_bay` elements each. Supports stand at x = nL; of sections one after another in the middle of their bays, and x = 0 is where
    /// the first one ends. Supports by their number, counted from the first at or after x = 0, may be missing or hang.
    ///
    /// # Errors
    /// A length that is none; columns that have no such form; foundations that join supports, supports joined to one another in sections.
    pub fn of(
        layout: &Layout,
        on: &Springs,
        (from, to): (f64, f64),
        (bay, per_bay): (f64, usize),
        form: Form,
        faults: &[(i64, Fault)],
    ) -> Result<Self, FemError> {
        if !(from < to && per_bay > 0) {
            return Err(FemError::NoElement);
        }
        let cut = Cut { on, from, to, per_bay, form, faults };
        match layout {
            Layout::Continuous(stack) => {
                let column = cut.shaped(Column::new(stack, on.stack())?)?;
                let node = |x: f64| x as i64 * per_bay as i64;
                let nodes = node((from / bay).floor())..=node((to / bay).ceil());
                let x = nodes.map(|i| bay * i as f64 / per_bay as f64).collect();
                Self::continuous(x, &[], &|_, _| Ok(column.clone()))
            }
            Layout::Discrete(supports) => Self::supported(&cut.supports(supports)?),
            Layout::Varying(sections) => Self::supported(&cut.sections(sections)?),
        }
    }
}

impl Cut<'_> {
    fn shaped(&self, column: Column) -> Result<Column, FemError> {
        if self.form == Form::Time { column.in_time() } else { Ok(column) }
    }

    /// The rail, and what stands under it at a support.
    fn columns(&self, supports: &Supports) -> Result<(Column, Column), FemError> {
        Ok((self.shaped(Column::rail(supports.rail))?, self.shaped(Column::under(supports, self.on)?)?))
    }

    /// What stands at support `number`, and the gap under it.
    fn standing(&self, column: &Column, number: i64) -> Option<(Column, Option<f64>)> {
        match self.faults.iter().find(|(which, _)| *which == number) {
            Some((_, Fault::Missing)) => None,
            Some((_, Fault::Hanging(gap))) => Some((column.clone(), Some(*gap))),
            None => Some((column.clone(), None)),
        }
    }

    fn supports(&self, supports: &Supports) -> Result<Vec<Station>, FemError> {
        let (rail, column) = self.columns(supports)?;
        let spacing = supports.spacing;
        let numbers = (self.from / spacing).floor() as i64..=(self.to / spacing).ceil() as i64;
        let station = |number: i64| {
            let under = self.standing(&column, number);
            Station { x: number as f64 * spacing, under, rail: rail.clone(), elements: self.per_bay }
        };
        Ok(numbers.map(station).collect())
    }

    /// Section by section; the first one counts its bays backward from x = 0.
    fn sections(&self, sections: &[Section]) -> Result<Vec<Station>, FemError> {
        let mut stations: Vec<Station> = Vec::new();
        let (mut begin, mut number) = (0.0, 0);
        for (i, section) in sections.iter().enumerate() {
            let (rail, column) = self.columns(&section.supports)?;
            let spacing = section.supports.spacing;
            let bays = match section.bays {
                Some(bays) => bays as i64,
                None if i == 0 => -(self.from / spacing).floor().min(0.0) as i64,
                None => ((self.to - begin) / spacing).ceil().max(1.0) as i64,
            };
            if i == 0 {
                (begin, number) = (-bays as f64 * spacing, -bays);
            }
            for bay in 0..bays {
                let x = begin + bay as f64 * spacing;
                let station = |x: f64, under| Station {
                    x,
                    under,
                    rail: rail.clone(),
                    elements: self.per_bay.div_ceil(2),
                };
                stations.push(station(x, None));
                stations.push(station(x + 0.5 * spacing, self.standing(&column, number)));
                number += 1;
            }
            begin += bays as f64 * spacing;
        }
        if let Some(last) = stations.last() {
            stations.push(Station { x: begin, under: None, ..last.clone() });
        }
        Ok(stations)
    }
}
