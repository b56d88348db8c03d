//! What moves over one place of the track, from the rail down to rock: a track and its foundation of springs in one.

use super::FemError;
use crate::foundation::Springs;
use crate::track::{Element, Link, Member, Stack, Supports};

/// Fields of displacement from the rail downward, each with the members that move with it, and what joins them.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Members of each field; a massless one has none.
    pub(super) fields: Vec<Vec<Member>>,
    /// Upper field, lower field (None: rock) and what lies between.
    pub(super) links: Vec<(usize, Option<usize>, Link)>,
}

impl Column {
    /// `track` standing on the stack `on`, which stands on rock.
    ///
    /// # Errors
    /// A rail straight on rock.
    pub fn new(track: &Stack, on: &Stack) -> Result<Self, FemError> {
        let mut fields: Vec<Vec<Member>> = track.members().iter().map(|&member| vec![member]).collect();
        let mut links = Vec::new();
        let ends_on_base = track.links().len() == fields.len();
        for (i, link) in track.links().iter().enumerate() {
            let on_rock = on.is_empty() && i + 1 == fields.len();
            links.push((i, (!on_rock).then_some(i + 1), *link));
        }
        if on.is_empty() {
            return if ends_on_base && !fields.is_empty() {
                Ok(Self { fields, links })
            } else {
                Err(FemError::OnRock)
            };
        }
        if ends_on_base {
            fields.push(Vec::new());
        }
        let base = fields.len() - 1;
        for (i, member) in on.members().iter().enumerate() {
            if i > 0 {
                fields.push(Vec::new());
            }
            fields[base + i].push(*member);
        }
        let last = fields.len() - 1;
        for (i, link) in on.links().iter().enumerate() {
            links.push((base + i, (base + i < last).then_some(base + i + 1), *link));
        }
        Ok(Self { fields, links })
    }

    /// The rail alone, over which discrete supports stand.
    pub fn rail(rail: Member) -> Self {
        Self { fields: vec![vec![rail]], links: Vec::new() }
    }

    /// What stands under one of `supports` on its share of the springs `on`.
    ///
    /// # Errors
    /// Springs that join supports; as [`Column::new`].
    pub fn under(supports: &Supports, on: &Springs) -> Result<Self, FemError> {
        if on.joined() {
            return Err(FemError::Joined);
        }
        let members = on.stack().members().iter().map(|member| member.times(supports.spacing)).collect();
        let links = on.stack().links().iter().map(|link| link.times(supports.spacing)).collect();
        Self::new(&supports.under, &Stack::new(members, links))
    }

    /// Half of everything but what joins it to its neighbours.
    pub(super) fn halved(&self) -> Self {
        let half = |member: &Member| Member { tension: member.tension, ..member.times(0.5) };
        Self {
            fields: self.fields.iter().map(|members| members.iter().map(half).collect()).collect(),
            links: self.links.iter().map(|&(upper, lower, link)| (upper, lower, link.times(0.5))).collect(),
        }
    }

    /// The same in springs and dashpots alone, every node between two of them a massless field of its own.
    ///
    /// # Errors
    /// Hysteretic loss, bars with waves in them: they have no form in time.
    pub fn in_time(mut self) -> Result<Self, FemError> {
        for member in self.fields.iter().flatten() {
            if member.loss_factor > 0.0 {
                return Err(FemError::Hysteretic {
                    of: "a member that bends",
                    instead: "damping in proportion to mass and stiffness",
                });
            }
            if let Some(tension) = member.tension {
                voigt(tension, "a tension")?;
            }
        }
        for (upper, lower, link) in std::mem::take(&mut self.links) {
            match link {
                Link::Bars { .. } => return Err(FemError::Bars),
                Link::ConsistentMass { loss_factor, .. } if loss_factor > 0.0 => {
                    return Err(FemError::Hysteretic { of: "ballast with its mass", instead: VOIGT });
                }
                Link::ConsistentMass { .. } => self.links.push((upper, lower, link)),
                Link::Element(element) => self.expand(upper, lower, element)?,
            }
        }
        Ok(self)
    }

    /// Springs and dashpots of `element` between two fields.
    fn expand(&mut self, upper: usize, lower: Option<usize>, element: Element) -> Result<(), FemError> {
        let spring =
            |stiffness, damping| Link::Element(Element::Spring { stiffness, damping, loss_factor: 0.0 });
        let inner = self.fields.len();
        let mut between = |parallel: Option<Link>, above: Link, below: Link| {
            if let Some(link) = parallel {
                self.links.push((upper, lower, link));
            }
            self.fields.push(Vec::new());
            self.links.push((upper, Some(inner), above));
            self.links.push((inner, lower, below));
        };
        match element {
            Element::Spring { .. } => {
                voigt(element, "a spring")?;
                self.links.push((upper, lower, Link::Element(element)));
            }
            Element::Maxwell { stiffness, damping } => {
                between(None, spring(stiffness, 0.0), spring(0.0, damping))
            }
            Element::Zener { stiffness, second_stiffness, damping } => {
                between(Some(spring(stiffness, 0.0)), spring(second_stiffness, 0.0), spring(0.0, damping));
            }
            Element::PoyntingThomson1 { stiffness, second_stiffness, damping } => {
                between(None, spring(stiffness, 0.0), spring(second_stiffness, damping));
            }
            Element::PoyntingThomson2 { stiffness, damping, second_damping } => {
                between(None, spring(stiffness, damping), spring(0.0, second_damping));
            }
            Element::DashpotParallelMaxwell { stiffness, damping, second_damping } => {
                between(Some(spring(0.0, second_damping)), spring(stiffness, 0.0), spring(0.0, damping));
            }
            Element::CausalHysteretic { .. } => {
                return Err(FemError::Hysteretic { of: "element \"causal-hysteretic\"", instead: VOIGT });
            }
        }
        Ok(())
    }

    /// The beam of field `i`, if one of its members bends.
    pub(super) fn beam(&self, i: usize) -> Option<&Member> {
        self.fields[i].iter().find(|member| member.bends())
    }

    /// Whether nothing in field `i` resists a difference along the track: the field may jump.
    pub(super) fn is_loose(&self, i: usize) -> bool {
        self.fields[i].iter().all(Member::is_mass)
    }

    /// Takes out the spring and dashpot under the sleeper of a support, to be joined by what closes and opens.
    ///
    /// # Errors
    /// Supports without a sleeper on springs and dashpots.
    pub(super) fn loosen(&mut self) -> Result<Loosened, FemError> {
        let found = self.links.iter().position(|(upper, _, link)| {
            *upper == 1 && matches!(link, Link::Element(Element::Spring { .. }))
        });
        match found.map(|i| self.links.remove(i)) {
            Some((_, lower, Link::Element(Element::Spring { stiffness, damping, .. }))) => {
                Ok(Loosened { stiffness, damping, lower })
            }
            _ => Err(FemError::NothingToHang),
        }
    }
}

/// The spring and dashpot under a sleeper that hangs.
#[derive(Clone, Copy, Debug)]
pub(super) struct Loosened {
    /// k [N/m]
    pub stiffness: f64,
    /// c [N s/m]
    pub damping: f64,
    /// The field below, or rock.
    pub lower: Option<usize>,
}

const VOIGT: &str = "a spring and a dashpot abreast (Kelvin–Voigt: stiffness and damping)";

/// Refuses what is not spring and dashpot abreast.
fn voigt(element: Element, of: &'static str) -> Result<(), FemError> {
    match element {
        Element::Spring { loss_factor: 0.0, .. } => Ok(()),
        _ => Err(FemError::Hysteretic { of, instead: VOIGT }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::foundation::{FoundationModel, Kerr, Pasternak, Springs};

    #[test]
    fn track_and_foundation_make_one_column() {
        let springs = Link::spring(1e8, 1e4, 0.0).unwrap();
        let two = Stack::new(
            vec![Member::beam(6e6, 60.0, 0.0).unwrap(), Member::mass(245.0).unwrap()],
            vec![springs],
        );
        let beam = Stack::new(vec![Member::beam(6e6, 60.0, 0.0).unwrap()], vec![]);
        let on = |model| Springs::new(model).unwrap();
        let pasternak = on(FoundationModel::Pasternak(Pasternak { springs, shear: 1e7 }));
        let kerr = on(FoundationModel::Kerr(Kerr { springs, shear: 1e7, upper_stiffness: 2e8 }));
        let column = Column::new(&two, pasternak.stack()).unwrap();
        // the sleepers lie on the layer that shears
        assert_eq!((column.fields.len(), column.fields[1].len(), column.links.len()), (2, 2, 2));
        assert!(!column.is_loose(1) && column.links[1].1.is_none());
        let column = Column::new(&beam, kerr.stack()).unwrap();
        assert_eq!((column.fields.len(), column.links[0].1, column.links[1].1), (2, Some(1), None));
        let rigid = Stack::default();
        assert!(matches!(Column::new(&beam, &rigid), Err(FemError::OnRock)));
        let pads = Stack::new(beam.members().to_vec(), vec![springs]);
        assert_eq!(Column::new(&pads, &rigid).unwrap().links, [(0, None, springs)]);
    }

    #[test]
    fn what_has_no_form_in_time_is_refused_by_name() {
        let rail = Member::beam(6e6, 60.0, 0.0).unwrap();
        let on = |rail: Member, link| {
            Column::new(&Stack::new(vec![rail], vec![link]), &Stack::default()).unwrap().in_time()
        };
        let springs = Link::spring(1e8, 1e4, 0.0).unwrap();
        assert!(on(rail, springs).is_ok());
        let lossy = Member::beam(6e6, 60.0, 0.02).unwrap();
        let bars = Link::Bars { axial_stiffness: 1e8, height: 0.3, wave_speed: 300.0, loss_factor: 0.0 };
        let causal =
            Element::CausalHysteretic { stiffness: 1e8, loss_factor: 0.1, reference_frequency: 50.0 };
        for (error, word) in [
            (on(rail, Link::spring(1e8, 0.0, 0.1).unwrap()), "Kelvin–Voigt"),
            (on(rail, Link::Element(causal)), "Kelvin–Voigt"),
            (on(lossy, springs), "proportion"),
            (on(rail, bars), "bars"),
        ] {
            let error = error.unwrap_err().to_string();
            assert!(error.contains(word), "{error}");
        }
        let zener = Element::Zener { stiffness: 1e8, second_stiffness: 2e8, damping: 1e4 };
        let column = on(rail, Link::Element(zener)).unwrap();
        assert_eq!((column.fields.len(), column.links.len()), (2, 3));
    }
}
