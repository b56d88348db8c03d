//! Standards of vibration by name, and what their guide values depend on: kind of area, kind of line, time of day.

use schemars::JsonSchema;
use serde::Deserialize;

/// A standard that says what vibration may be.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
pub enum Guide {
    /// People in buildings: KB_Fmax and KB_FTr.
    #[serde(rename = "din4150-2")]
    Din4150Part2,
    /// Buildings: peaks of three components.
    #[serde(rename = "din4150-3")]
    Din4150Part3,
    /// People in buildings: vibration dose by day and by night.
    #[serde(rename = "bs6472-1")]
    Bs6472Part1,
    /// People in buildings: largest weighted velocity, W_m, SLOW.
    #[serde(rename = "ns8176")]
    Ns8176,
    /// People in buildings: V_max and V_per.
    #[serde(rename = "sbr-b")]
    SbrB,
    /// People in buildings: level of velocity.
    #[serde(rename = "fta")]
    Fta,
}

impl Guide {
    /// All of them.
    pub const ALL: [Self; 6] =
        [Self::Din4150Part2, Self::Din4150Part3, Self::Bs6472Part1, Self::Ns8176, Self::SbrB, Self::Fta];

    /// As case files have it: `din4150-2` …
    pub fn name(self) -> &'static str {
        match self {
            Self::Din4150Part2 => "din4150-2",
            Self::Din4150Part3 => "din4150-3",
            Self::Bs6472Part1 => "bs6472-1",
            Self::Ns8176 => "ns8176",
            Self::SbrB => "sbr-b",
            Self::Fta => "fta",
        }
    }

    /// The standard with its edition.
    pub fn standard(self) -> &'static str {
        match self {
            Self::Din4150Part2 => "DIN 4150-2:1999",
            Self::Din4150Part3 => "DIN 4150-3:1999",
            Self::Bs6472Part1 => "BS 6472-1:2008",
            Self::Ns8176 => "NS 8176:2017",
            Self::SbrB => "SBR Richtlijn B:2002",
            Self::Fta => "FTA Transit Noise and Vibration Impact Assessment Manual, 2018",
        }
    }

    /// The standard as a legend has room for it.
    pub fn short(self) -> &'static str {
        match self {
            Self::Din4150Part2 => "DIN 4150-2",
            Self::Din4150Part3 => "DIN 4150-3",
            Self::Bs6472Part1 => "BS 6472-1",
            Self::Ns8176 => "NS 8176",
            Self::SbrB => "SBR B",
            Self::Fta => "FTA",
        }
    }
}

/// Time of day: a guide value holds for one of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Period {
    /// Sixteen hours: 6 to 22 h in Germany, 7 to 23 h in Britain.
    Day,
    /// The other eight.
    Night,
}

impl Period {
    /// `day`, `night`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Day => "day",
            Self::Night => "night",
        }
    }

    /// T_r [s]: 16 h, 8 h.
    pub fn duration(self) -> f64 {
        match self {
            Self::Day => 16.0 * 3600.0,
            Self::Night => 8.0 * 3600.0,
        }
    }
}

/// Kind of area, the rows of DIN 4150-2, Table 1.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(rename_all = "kebab-case")]
pub enum Area {
    /// Row 1: commercial installations alone.
    Industrial,
    /// Row 2: mainly commercial.
    Commercial,
    /// Row 3: neither mainly commercial nor mainly dwellings.
    Mixed,
    /// Row 4: mainly or only dwellings.
    #[default]
    Residential,
    /// Row 5: hospitals, spas and the like.
    Sensitive,
}

/// Kind of line, which DIN 4150-2, 6.5.3 tells apart.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(rename_all = "kebab-case")]
pub enum Line {
    /// On the surface.
    #[default]
    Surface,
    /// Urban transport on the surface, as trams: A_u and A_r times 1.5.
    Urban,
    /// Underground.
    Underground,
}

/// A_u, A_o, A_r.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KbValues {
    /// A_u
    pub lower: f64,
    /// A_o
    pub upper: f64,
    /// A_r
    pub rating: f64,
}

impl Area {
    /// The rows, in their order.
    pub const ALL: [Self; 5] =
        [Self::Industrial, Self::Commercial, Self::Mixed, Self::Residential, Self::Sensitive];

    /// `residential` …
    pub fn name(self) -> &'static str {
        match self {
            Self::Industrial => "industrial",
            Self::Commercial => "commercial",
            Self::Mixed => "mixed",
            Self::Residential => "residential",
            Self::Sensitive => "sensitive",
        }
    }

    /// A_u, A_o, A_r beside a `line` by day or by night.
    ///
    /// Source: DIN 4150-2:1999, Table 1 and 6.5.3.3, as transcribed in the library phonometry (github.com/jmrplens/phonometry,
    /// `vibration/immission/people.py`) and, alike but for two misprints, in the manual of Metra's vibration meters.
    pub fn kb(self, line: Line, period: Period) -> KbValues {
        let (lower, upper, rating) = match (self, period) {
            (Self::Industrial, Period::Day) => (0.4, 6.0, 0.2),
            (Self::Industrial, Period::Night) => (0.3, 0.6, 0.15),
            (Self::Commercial, Period::Day) => (0.3, 6.0, 0.15),
            (Self::Commercial, Period::Night) => (0.2, 0.4, 0.1),
            (Self::Mixed, Period::Day) => (0.2, 5.0, 0.1),
            (Self::Mixed, Period::Night) => (0.15, 0.3, 0.07),
            (Self::Residential, Period::Day) => (0.15, 3.0, 0.07),
            (Self::Residential, Period::Night) => (0.1, 0.2, 0.05),
            (Self::Sensitive, Period::Day) => (0.1, 3.0, 0.05),
            (Self::Sensitive, Period::Night) => (0.1, 0.15, 0.05),
        };
        let raised = if line == Line::Urban { 1.5 } else { 1.0 };
        KbValues { lower: raised * lower, upper, rating: raised * rating }
    }
}

impl Line {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Surface, Self::Urban, Self::Underground];

    /// `surface` …
    pub fn name(self) -> &'static str {
        match self {
            Self::Surface => "surface",
            Self::Urban => "urban",
            Self::Underground => "underground",
        }
    }

    /// KB_FTi above which the cause is looked into, by night (DIN 4150-2, 6.5.3.5).
    pub fn looked_into(self, period: Period) -> Option<f64> {
        match (period, self) {
            (Period::Day, _) => None,
            (Period::Night, Self::Underground) => Some(0.3),
            (Period::Night, _) => Some(0.6),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn urban_lines_have_half_as_much_again() {
        // as Metra prints the table of urban lines: residential 0.225, 3, 0.105 by day, 0.15, 0.075 by night
        let day = Area::Residential.kb(Line::Urban, Period::Day);
        let night = Area::Residential.kb(Line::Urban, Period::Night);
        let close = |a: f64, b: f64| (a - b).abs() < 1e-15;
        assert!(close(day.lower, 0.225) && close(day.upper, 3.0) && close(day.rating, 0.105));
        assert!(close(night.lower, 0.15) && close(night.rating, 0.075));
        assert_eq!(Line::Urban.looked_into(Period::Night), Some(0.6));
        assert_eq!(Line::Underground.looked_into(Period::Day), None);
    }

    #[test]
    fn quieter_areas_are_allowed_less() {
        for period in [Period::Day, Period::Night] {
            for pair in Area::ALL.windows(2) {
                let [louder, quieter] = [pair[0], pair[1]].map(|area| area.kb(Line::Surface, period));
                assert!(quieter.lower <= louder.lower && quieter.upper <= louder.upper);
                assert!(quieter.rating <= louder.rating);
                assert!(quieter.rating < quieter.lower && quieter.lower < quieter.upper);
            }
        }
    }
}
