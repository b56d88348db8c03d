//! Guide values as data: drawn and named, never judged by.

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
    /// VDV of weighted acceleration.
    VibrationDose,
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
        }
    }

    /// Unit; `1` for pure numbers.
    pub fn unit(self) -> &'static str {
        match self {
            Self::KbFMaximum | Self::KbFRating | Self::VMaximum | Self::VPeriod => "1",
            Self::VelocityLevel(reference) => reference.name(),
            Self::VibrationDose => "m/s^1.75",
        }
    }
}

/// One published guide value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GuideValue {
    /// What the standard calls it, where and when it holds.
    pub name: &'static str,
    /// Standard with its edition.
    pub standard: &'static str,
    /// Of what.
    pub quantity: Quantity,
    /// Value in the unit of the quantity.
    pub value: f64,
    /// What it asks of the quantity, in a few words.
    pub criterion: &'static str,
    /// How the standard means it.
    pub note: &'static str,
}

const DIN_4150: &str = "DIN 4150-2:1999";
const SBR_B: &str = "SBR Richtlijn B:2002";
const FTA: &str = "FTA Transit Noise and Vibration Impact Assessment Manual, 2018";
const BS_6472: &str = "BS 6472-1:2008";

/// What is asked of a measured value, for a legend, and how the standard means it.
#[derive(Clone, Copy)]
struct Meaning {
    criterion: &'static str,
    note: &'static str,
}

const A_U: Meaning =
    Meaning { criterion: "enough if KB_Fmax ≤ A_u", note: "met if KB_Fmax is not above it" };
const A_O: Meaning = Meaning { criterion: "missed if KB_Fmax > A_o", note: "missed if KB_Fmax is above it" };
const A_O_NIGHT: Meaning = Meaning {
    criterion: A_O.criterion,
    note: "missed if KB_Fmax is above it; for surface railways 6.5.3 gives 0.6 and another meaning",
};
const A_R: Meaning = Meaning {
    criterion: "asked of KB_FTr where A_u < KB_Fmax ≤ A_o",
    note: "asked where KB_Fmax is between A_u and A_o; surface local transport: 1.5 times A_u and A_r",
};
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

const fn guide(
    standard: &'static str,
    name: &'static str,
    quantity: Quantity,
    value: f64,
    Meaning { criterion, note }: Meaning,
) -> GuideValue {
    GuideValue { name, standard, quantity, value, criterion, note }
}

/// Guide values for dwellings.
///
/// Sources: the standards named. DIN 4150-2 (Table 1, purely residential areas, and 6.5.3) and SBR-B were read in summaries of
/// instrument makers and consultants, FTA (category 2) in environmental statements, BS 6472-1 as generally quoted.
pub const GUIDE_VALUES: &[GuideValue] = &[
    guide(DIN_4150, "A_u residential, day", Quantity::KbFMaximum, 0.15, A_U),
    guide(DIN_4150, "A_o residential, day", Quantity::KbFMaximum, 3.0, A_O),
    guide(DIN_4150, "A_r residential, day", Quantity::KbFRating, 0.07, A_R),
    guide(DIN_4150, "A_u residential, night", Quantity::KbFMaximum, 0.1, A_U),
    guide(DIN_4150, "A_o residential, night", Quantity::KbFMaximum, 0.2, A_O_NIGHT),
    guide(DIN_4150, "A_r residential, night", Quantity::KbFRating, 0.05, A_R),
    guide(SBR_B, "A_1 dwellings, day and evening", Quantity::VMaximum, 0.1, A_1),
    guide(SBR_B, "A_2 dwellings, day and evening", Quantity::VMaximum, 0.4, A_2),
    guide(SBR_B, "A_3 dwellings, day and evening", Quantity::VPeriod, 0.05, A_3),
    guide(SBR_B, "A_1 dwellings, night", Quantity::VMaximum, 0.1, A_1),
    guide(SBR_B, "A_2 dwellings, night", Quantity::VMaximum, 0.2, A_2),
    guide(SBR_B, "A_3 dwellings, night", Quantity::VPeriod, 0.05, A_3),
    guide(FTA, "residences, frequent events", Quantity::VelocityLevel(Reference::VdB), 72.0, OFTEN),
    guide(FTA, "residences, infrequent events", Quantity::VelocityLevel(Reference::VdB), 80.0, SELDOM),
    guide(BS_6472, "low probability of adverse comment from, day", Quantity::VibrationDose, 0.2, DOSE_FROM),
    guide(BS_6472, "low probability of adverse comment to, day", Quantity::VibrationDose, 0.4, DOSE_TO),
];

/// The guide values of one quantity, in the order of [`GUIDE_VALUES`].
pub fn guide_values(quantity: Quantity) -> impl Iterator<Item = &'static GuideValue> {
    GUIDE_VALUES.iter().filter(move |g| g.quantity == quantity)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_value_is_named_once_with_its_standard() {
        let mut names: Vec<(&str, &str)> = GUIDE_VALUES.iter().map(|g| (g.standard, g.name)).collect();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), GUIDE_VALUES.len());
        assert!(GUIDE_VALUES.iter().all(|g| g.value > 0.0 && !g.note.is_empty() && !g.criterion.is_empty()));
    }

    #[test]
    fn values_of_one_quantity() {
        let values = |quantity| guide_values(quantity).map(|g| g.value).collect::<Vec<_>>();
        assert_eq!(values(Quantity::KbFMaximum), [0.15, 3.0, 0.1, 0.2]);
        assert_eq!(values(Quantity::KbFRating), [0.07, 0.05]);
        assert_eq!(values(Quantity::VMaximum), [0.1, 0.4, 0.1, 0.2]);
        assert_eq!(values(Quantity::VPeriod), [0.05, 0.05]);
        assert_eq!(values(Quantity::VelocityLevel(Reference::VdB)), [72.0, 80.0]);
        assert!(values(Quantity::VelocityLevel(Reference::Iso1683)).is_empty());
        assert_eq!(values(Quantity::VibrationDose), [0.2, 0.4]);
        assert_eq!(Quantity::VelocityLevel(Reference::VdB).unit(), "VdB re 2.54e-8 m/s");
    }
}
