//! `[free_field]`, what the motion is held against and what a building makes of it: `guide`, `[free_field.assessment]`,
//! `[free_field.transfer]`.

use super::error::Finding;
use crate::assessment::{Area, AssessmentError, CLOCK, Guide, Line, Period, Reference, Transfer};
use crate::columns;
use crate::study::{Assessment, Building, OtherTrain, Passes, SOUND};
use schemars::JsonSchema;
use serde::Deserialize;

/// `[free_field.assessment]`
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AssessmentInput {
    /// Passes of the train by day (16 h) and by night (8 h): { day = …, night = … }.
    pub passes: Passes,
    /// Kind of area, after DIN 4150-2; residential by default.
    #[serde(default)]
    pub area: Area,
    /// Kind of line, after DIN 4150-2; surface by default.
    #[serde(default)]
    pub line: Line,
    /// Other trains of the same days, by what one pass of them is at each receiver.
    #[serde(default)]
    pub other: Vec<OtherTrain>,
}

/// What the free field is held against.
pub fn assessment(
    guide: Option<&Vec<Guide>>,
    levels: Option<Reference>,
    whole: Option<&AssessmentInput>,
    receivers: usize,
) -> Result<Assessment, Finding> {
    let guides = match guide {
        None => Vec::new(),
        Some(list) if list.is_empty() => {
            let names = "din4150-2, din4150-3, bs6472-1, ns8176, sbr-b, fta";
            return Err(Finding::new("free_field.guide", "the list is empty")
                .help(format!("allowed: {names}; without the key all of them are drawn")));
        }
        Some(list) => {
            let twice = (1..list.len()).find(|&i| list[..i].contains(&list[i]));
            if let Some(i) = twice {
                let message = format!("{} is named twice", list[i].standard());
                return Err(Finding::new(format!("free_field.guide[{i}]"), message));
            }
            list.clone()
        }
    };
    let Some(whole) = whole else {
        return Ok(Assessment { guides, levels, ..Assessment::default() });
    };
    let root = "free_field.assessment";
    check_passes(whole.passes, &format!("{root}.passes"))?;
    for (i, other) in whole.other.iter().enumerate() {
        let at = |key: &str| format!("{root}.other[{i}].{key}");
        check_passes(other.passes, &at("passes"))?;
        let wanted = receivers;
        for (key, values, may_lack) in [("kb_ftm", &other.kb_ftm, false), ("vdv", &other.vdv, true)] {
            if values.len() != wanted && !(may_lack && values.is_empty()) {
                let message = format!("{} values for {wanted} receivers", values.len());
                return Err(Finding::new(at(key), message).help("give one for each of free_field.receivers"));
            }
            if let Some(value) = values.iter().find(|v| !(**v >= 0.0 && v.is_finite())) {
                let message = format!("{value}: it must be finite and not negative");
                return Err(Finding::new(at(key), message));
            }
        }
    }
    if whole.passes == Passes::default() {
        let finding = Finding::new("free_field.assessment.passes", "no train passes");
        return Err(finding.help("give day or night, or remove [free_field.assessment]"));
    }
    Ok(Assessment {
        guides,
        area: whole.area,
        line: whole.line,
        passes: Some(whole.passes),
        others: whole.other.clone(),
        levels,
    })
}

/// No more passes than intervals of 30 s.
fn check_passes(passes: Passes, at: &str) -> Result<(), Finding> {
    for (period, key) in [(Period::Day, "day"), (Period::Night, "night")] {
        let (most, count) = (period.duration() / CLOCK, passes.during(period));
        if f64::from(count) > most {
            let message = format!("{count} passes by {key}: more than one in 30 s, {most:.0} of them");
            return Err(Finding::new(format!("{at}.{key}"), message)
                .help("give the passes of one day, not of a week or a year"));
        }
    }
    Ok(())
}

/// `[free_field.transfer]`
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TransferInput {
    /// Velocity of the foundation over that of the open ground.
    pub foundation: Option<TransferTable>,
    /// Velocity of a floor over that of the foundation, or of the ground where there is no table for that.
    pub floor: Option<TransferTable>,
    /// Sound pressure in the room over the velocity of the last of them.
    pub noise: Option<TransferTable>,
}

/// A table of third octaves: inline, or in a file.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TransferTable {
    /// CSV file beside the case: a header, then frequency [Hz] and factor, or dB where the header says so, as in D [dB].
    pub file: Option<String>,
    /// Centres of third octaves one after another [Hz].
    pub frequencies: Option<Vec<f64>>,
    /// A factor for each [1]; of noise [Pa s/m].
    pub factors: Option<Vec<f64>>,
    /// Instead of factors: level differences [dB]; of noise L_p [dB re 20 µPa] less L_v.
    pub decibels: Option<Vec<f64>>,
    /// With level differences of noise: the velocity that L_v is a level over [m/s], as 5e-8 or 1e-9.
    pub reference: Option<f64>,
}

/// What a building makes of the motion; `files` reads a file beside the case.
pub fn building(
    transfer: Option<&TransferInput>,
    files: &dyn Fn(&str) -> Result<String, String>,
) -> Result<Building, Finding> {
    let Some(transfer) = transfer else { return Ok(Building::default()) };
    let table = |name: &str, table: &Option<TransferTable>| {
        let key = format!("free_field.transfer.{name}");
        table.as_ref().map(|table| table.read(&key, name == "noise", files)).transpose()
    };
    let building = Building {
        foundation: table("foundation", &transfer.foundation)?,
        floor: table("floor", &transfer.floor)?,
        noise: table("noise", &transfer.noise)?,
    };
    if building == Building::default() {
        let finding = Finding::new("free_field.transfer", "the table is empty");
        return Err(finding.help("give foundation, floor or noise, or remove it"));
    }
    Ok(building)
}

impl TransferTable {
    fn read(
        &self,
        key: &str,
        noise: bool,
        files: &dyn Fn(&str) -> Result<String, String>,
    ) -> Result<Transfer, Finding> {
        let at = |name: &str| format!("{key}.{name}");
        let wanted = "give file, or frequencies with factors or decibels";
        let (frequencies, values, decibels, lines) = match self {
            Self { file: Some(file), frequencies: None, factors: None, decibels: None, .. } => {
                let (columns, decibels) = read_file(file, files).map_err(|e| {
                    let header = "a header line, then frequency [Hz] and factor, or D [dB]";
                    Finding::new(at("file"), format!("{file}: {e}")).help(header)
                })?;
                let [frequencies, values] = columns.values;
                (frequencies, values, decibels, columns.lines)
            }
            Self { file: None, frequencies: Some(f), factors: Some(v), decibels: None, .. } => {
                (f.clone(), v.clone(), false, Vec::new())
            }
            Self { file: None, frequencies: Some(f), factors: None, decibels: Some(v), .. } => {
                (f.clone(), v.clone(), true, Vec::new())
            }
            _ => return Err(Finding::new(key, "it is not said once what the table holds").help(wanted)),
        };
        // p/v = p₀/v₀ · 10^{D/20}
        let unit = match (noise && decibels, self.reference) {
            (true, Some(reference)) if reference > 0.0 && reference.is_finite() => SOUND / reference,
            (true, Some(reference)) => {
                let message = format!("{reference} m/s: it must be positive and finite");
                return Err(Finding::new(at("reference"), message));
            }
            (true, None) => {
                let finding =
                    Finding::new(key, "level differences of noise need the reference of the velocity");
                return Err(finding.help("add reference = 5e-8 or 1e-9 [m/s]"));
            }
            (false, Some(_)) => {
                let finding =
                    Finding::new(at("reference"), "only level differences of noise have a reference");
                return Err(finding.help("remove it"));
            }
            (false, None) => 1.0,
        };
        let factors: Vec<f64> = match decibels {
            true => values.iter().map(|d| unit * 10f64.powf(d / 20.0)).collect(),
            false => values,
        };
        Transfer::new(&frequencies, &factors).map_err(|error| {
            let line = match error {
                AssessmentError::Bands { index, .. } => lines.get(index),
                _ => None,
            };
            let place = line.map_or(String::new(), |line| format!("line {line}: "));
            let name = if self.file.is_some() { "file" } else { "frequencies" };
            Finding::new(at(name), format!("{place}{error}"))
        })
    }
}

/// Two columns of a file, and their lines.
struct Pair {
    values: [Vec<f64>; 2],
    lines: Vec<usize>,
}

/// Frequencies [Hz] and values in a file, and whether these are decibels.
fn read_file(file: &str, files: &dyn Fn(&str) -> Result<String, String>) -> Result<(Pair, bool), String> {
    let text = files(file)?;
    let table = columns::table(&text).map_err(|e| e.to_string())?;
    let [frequencies, values] = <[Vec<f64>; 2]>::try_from(table.columns)
        .map_err(|columns| format!("{} columns, where two are wanted", columns.len()))?;
    let hertz = columns::unit(&table.names[0], table.header, &[("Hz", 1.0), ("kHz", 1e3)])
        .map_err(|e| e.to_string())?;
    let frequencies = frequencies.iter().map(|f| hertz.unwrap_or(1.0) * f).collect();
    let known = [("dB", true), ("1", false), ("-", false), ("Pa/(m/s)", false), ("Pas/m", false)];
    let decibels = columns::unit(&table.names[1], table.header, &known).map_err(|e| e.to_string())?;
    Ok((Pair { values: [frequencies, values], lines: table.lines }, decibels.unwrap_or(false)))
}

#[cfg(test)]
mod tests {
    use crate::case::Case;
    use crate::study::Study;

    const GROUND: &str = "title = \"x\"\ntrack = \"lamprea2022_ballasted\"\nsoil = \"lamprea2022_layered\"\ntrain = \"kaynia2000_x2000\"\n[free_field]\nspeed = 40.0\nreceivers = [8.0]\n";

    fn case(more: &str) -> Result<Case, String> {
        let files = |name: &str| match name {
            "floor.csv" => Ok("f [Hz];D [dB]\n8;0\n10;6,0206\n12,5;20\n".to_owned()),
            "gap.csv" => Ok("f [Hz];D [dB]\n8;0\n10;6\n# missing\n16;20\n".to_owned()),
            _ => Err("no such file".to_owned()),
        };
        let text = format!("{GROUND}{more}");
        let told = |fault| format!("{:?} ", miette::Report::new(fault));
        let plain =
            |text: String| text.split_whitespace().filter(|word| *word != "│").collect::<Vec<_>>().join(" ");
        Case::parse(&text, "x", &files).map_err(|e| plain(e.each().into_iter().map(told).collect::<String>()))
    }

    #[test]
    fn tables_inline_and_in_files() {
        let found = case("[free_field.transfer]\nfoundation = { frequencies = [8.0, 10.0], factors = [0.5, 0.4] }\nfloor.file = \"floor.csv\"\nnoise = { frequencies = [31.5, 40.0], decibels = [-20.0, 0.0], reference = 5e-8 }\n").unwrap();
        let Study::FreeField(study) = &found.studies[0] else { panic!("no free field") };
        let (floor, noise) = (study.building.floor.as_ref().unwrap(), study.building.noise.as_ref().unwrap());
        assert!((floor.at(10.0) - 2.0).abs() < 1e-5 && (floor.at(20.0) - 10.0).abs() < 1e-9);
        // 2e-5/5e-8 = 400 Pa s/m at 0 dB
        assert!((noise.at(50.0) - 400.0).abs() < 1e-9 && (noise.at(20.0) - 40.0).abs() < 1e-9);
    }

    #[test]
    fn faults_are_told_at_their_key_and_line() {
        for (more, said) in [
            ("guide = [\"din4150-4\"]\n", "did you mean `din4150-2`?"),
            ("guide = [\"bs6472\"]\n", "did you mean `bs6472-1`?"),
            ("levels = \"1e-8 m/s\"\n", "5e-8 m/s"),
            ("guide = []\n", "the list is empty"),
            ("guide = [\"fta\", \"fta\"]\n", "named twice"),
            ("[free_field.assessment]\npasses = { day = 2000 }\n", "more than one in 30 s"),
            ("[free_field.assessment]\npasses = { dya = 20 }\n", "day"),
            ("[free_field.assessment]\npasses = {}\n", "no train passes"),
            (
                "[free_field.assessment]\npasses = { day = 1 }\n[[free_field.assessment.other]]\nname = \"x\"\npasses = { day = 1 }\nkb_ftm = [0.1, 0.2]\n",
                "2 values for 1 receivers",
            ),
            ("[free_field.assessment]\narea = \"quiet\"\npasses = { day = 20 }\n", "residential"),
            (
                "[free_field.transfer]\nfloor.file = \"gap.csv\"\n",
                "line 5: value number 3 at 16 Hz stands where 12.5 Hz is wanted",
            ),
            ("[free_field.transfer]\nfloor.file = \"none.csv\"\n", "no such file"),
            ("[free_field.transfer]\nfloor = { frequencies = [8.0] }\n", "not said once"),
            ("[free_field.transfer]\nnoise = { frequencies = [8.0], decibels = [1.0] }\n", "reference"),
            ("[free_field.transfer]\nfloor = { frequencies = [8.0], factors = [-1.0] }\n", "8 Hz is -1"),
        ] {
            let why = case(more).err().unwrap_or_default();
            assert!(why.contains(said), "{more}: no \"{said}\" in {why}");
        }
    }
}
