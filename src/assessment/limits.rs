//! Guide values as data: drawn and named, never judged by.

use super::guide::{Area, Guide, Line, Period};
use super::level::Reference;

/// What a guide value is a value of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// KB_Fmax, a pure number.
    KbFMaximum,
    /// KB_FTr: KB_F over passages and the time of assessment, a pure number.
    KbFRating,
    /// V_max of SBR-B: the largest running r.m.s. FAST of the KB-weighted velocity, a pure number as KB_Fmax.
    VMaximum,
    /// V_per of SBR-B: V over the period of assessment, a pure number.
    VPeriod,
    /// Level of the largest r.m.s. velocity, averaged over 1 s, unweighted.
    VelocityLevel(Reference),
    /// VDV of weighted acceleration by day or by night.
    VibrationDose,
    /// Peak of the largest of three components at a foundation, for vibration that does not make the building resonate [mm/s].
    PeakVelocity,
}

impl Quantity {
    /// Symbol for an axis or a legend.
    pub fn name(self) -> &'static str {
        match self {
            Self::KbFMaximum => "KB_Fmax",
            Self::KbFRating => "KB_FTr",
            Self::VMaximum => "V_max",
            Self::VPeriod => "V_per",
            Self::VelocityLevel(_) => "L_v",
            Self::VibrationDose => "VDV",
            Self::PeakVelocity => "PPV",
        }
    }

    /// Unit; `1` for pure numbers.
    pub fn unit(self) -> &'static str {
        match self {
            Self::KbFMaximum | Self::KbFRating | Self::VMaximum | Self::VPeriod => "1",
            Self::VelocityLevel(reference) => reference.name(),
            Self::VibrationDose => "m/s^1.75",
            Self::PeakVelocity => "mm/s",
        }
    }
}

/// One published guide value.
#[derive(Clone, Debug, PartialEq)]
pub struct GuideValue {
    /// What the standard calls it, where and when it holds.
    pub name: String,
    /// Whose it is.
    pub guide: Guide,
    /// Of what.
    pub quantity: Quantity,
    /// Value in the unit of the quantity.
    pub value: f64,
    /// What it asks of the quantity, in a few words.
    pub criterion: &'static str,
    /// How the standard means it.
    pub note: &'static str,
}

/// What is asked of a measured value, for a legend, and how the standard means it.
#[derive(Clone, Copy)]
struct Meaning {
    criterion: &'static str,
    note: &'static str,
}

const A_U: Meaning =
    Meaning { criterion: "enough if KB_Fmax ≤ A_u", note: "met if KB_Fmax is not above it" };
const A_O: Meaning = Meaning {
    criterion: "missed if KB_Fmax > A_o",
    note: "missed if KB_Fmax is above it; of a railway A_u and A_r are asked, not A_o (6.5.3)",
};
const CAUSE: Meaning = Meaning {
    criterion: "above it the cause is looked into",
    note: "6.5.3.5: a train above it is a reason to look into the cause, as flat wheels, and no verdict",
};
const A_R: Meaning =
    Meaning { criterion: "asked of KB_FTr where KB_Fmax > A_u", note: "asked where KB_Fmax is above A_u" };
const A_1: Meaning = Meaning {
    criterion: "enough if V_max < A_1",
    note: "met if V_max is below it; vibration that goes on for long",
};
const A_2: Meaning = Meaning {
    criterion: "enough if V_max < A_2 and V_per < A_3",
    note: "with V_per below A_3, met if V_max is below it",
};
const A_3: Meaning = Meaning {
    criterion: "asked of V_per where A_1 ≤ V_max < A_2",
    note: "asked where V_max is between A_1 and A_2",
};
const OFTEN: Meaning =
    Meaning { criterion: "more than 70 a day", note: "more than 70 events of one kind a day" };
const SELDOM: Meaning = Meaning {
    criterion: "fewer than 30 a day",
    note: "fewer than 30 events of one kind a day; before 2006, fewer than 70",
};
const DOSE_FROM: Meaning = Meaning {
    criterion: "all of 16 h",
    note: "residential, 16 h; W_b vertically, W_d horizontally; below it adverse comment is not expected",
};
const DOSE_TO: Meaning = Meaning {
    criterion: DOSE_FROM.criterion,
    note: "residential, 16 h; W_b vertically, W_d horizontally; above it adverse comment is possible",
};
const SLOW_WAVES: Meaning = Meaning {
    criterion: "no damage seen below it, 1 to 10 Hz",
    note: "largest of three components at the foundation, short-term vibration, 1 to 10 Hz; more is allowed above 10 Hz",
};

/// The guide values that hold beside a `line` in an `area`, standard by standard.
///
/// Sources: the standards named. DIN 4150-2 (Table 1, 6.5.3.3, 6.5.3.5) and DIN 4150-3 (Table 1) are known by way of the library
/// phonometry (github.com/jmrplens/phonometry), which transcribes them, and agree with the summaries of Metra and of Innomic, makers
/// of instruments; SBR-B was read in summaries of consultants, FTA (category 2) in environmental statements, BS 6472-1 as generally
/// quoted. Left out for want of a source that can be cited: the classes of NS 8176, the night of BS 6472-1.
pub fn all_guide_values(area: Area, line: Line) -> Vec<GuideValue> {
    let mut values = Vec::new();
    let mut add = |guide, name: String, quantity, value, Meaning { criterion, note }: Meaning| {
        values.push(GuideValue { name, guide, quantity, value, criterion, note });
    };
    for period in [Period::Day, Period::Night] {
        let (at, when) = (area.kb(line, period), format!("{}, {}", area.name(), period.name()));
        add(Guide::Din4150Part2, format!("A_u {when}"), Quantity::KbFMaximum, at.lower, A_U);
        add(Guide::Din4150Part2, format!("A_o {when}"), Quantity::KbFMaximum, at.upper, A_O);
        if let Some(cause) = line.looked_into(period) {
            add(Guide::Din4150Part2, "6.5.3.5 night".into(), Quantity::KbFMaximum, cause, CAUSE);
        }
        add(Guide::Din4150Part2, format!("A_r {when}"), Quantity::KbFRating, at.rating, A_R);
    }
    for (when, a_2) in [("day and evening", 0.4), ("night", 0.2)] {
        add(Guide::SbrB, format!("A_1 dwellings, {when}"), Quantity::VMaximum, 0.1, A_1);
        add(Guide::SbrB, format!("A_2 dwellings, {when}"), Quantity::VMaximum, a_2, A_2);
        add(Guide::SbrB, format!("A_3 dwellings, {when}"), Quantity::VPeriod, 0.05, A_3);
    }
    let level = Quantity::VelocityLevel(Reference::VdB);
    add(Guide::Fta, "residences, frequent events".into(), level, 72.0, OFTEN);
    add(Guide::Fta, "residences, infrequent events".into(), level, 80.0, SELDOM);
    let dose = |end: &str| format!("low probability of adverse comment {end}, day");
    add(Guide::Bs6472Part1, dose("from"), Quantity::VibrationDose, 0.2, DOSE_FROM);
    add(Guide::Bs6472Part1, dose("to"), Quantity::VibrationDose, 0.4, DOSE_TO);
    for (building, value) in [("commercial", 20.0), ("dwellings", 5.0), ("sensitive", 3.0)] {
        add(Guide::Din4150Part3, building.into(), Quantity::PeakVelocity, value, SLOW_WAVES);
    }
    values
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_value_is_named_once_with_its_standard() {
        for area in Area::ALL {
            for line in [Line::Surface, Line::Urban, Line::Underground] {
                let values = all_guide_values(area, line);
                let mut names: Vec<(&str, &str)> =
                    values.iter().map(|g| (g.guide.standard(), g.name.as_str())).collect();
                names.sort_unstable();
                names.dedup();
                assert_eq!(names.len(), values.len());
                assert!(
                    values.iter().all(|g| g.value > 0.0 && !g.note.is_empty() && !g.criterion.is_empty())
                );
            }
        }
    }

    #[test]
    fn values_of_one_quantity() {
        let values = |quantity| -> Vec<f64> {
            let all = all_guide_values(Area::Residential, Line::Surface);
            all.iter().filter(|g| g.quantity == quantity).map(|g| g.value).collect()
        };
        assert_eq!(values(Quantity::KbFMaximum), [0.15, 3.0, 0.1, 0.2, 0.6]);
        assert_eq!(values(Quantity::KbFRating), [0.07, 0.05]);
        assert_eq!(values(Quantity::VMaximum), [0.1, 0.4, 0.1, 0.2]);
        assert_eq!(values(Quantity::VPeriod), [0.05, 0.05]);
        assert_eq!(values(Quantity::VelocityLevel(Reference::VdB)), [72.0, 80.0]);
        assert!(values(Quantity::VelocityLevel(Reference::Iso1683)).is_empty());
        assert_eq!(values(Quantity::VibrationDose), [0.2, 0.4]);
        assert_eq!(values(Quantity::PeakVelocity), [20.0, 5.0, 3.0]);
        assert_eq!(Quantity::VelocityLevel(Reference::VdB).unit(), "VdB re 2.54e-8 m/s");
    }
}
