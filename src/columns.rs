//! Two columns of lengths from a CSV file: positions, and what was measured there, as track recording cars and spreadsheets write them.

use thiserror::Error;

/// Two columns [m].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Columns {
    /// The first column [m].
    pub x: Vec<f64>,
    /// The second one [m].
    pub values: Vec<f64>,
    /// The line each pair stands in, from 1.
    pub lines: Vec<usize>,
}

/// Why a file is not two columns.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum ColumnsError {
    /// The first line is not a header.
    #[error(
        "line {line} reads \"{found}\": it must be a header naming the two columns, such as x [m], r [mm]"
    )]
    Header {
        /// From 1.
        line: usize,
        /// The line.
        found: String,
    },
    /// A line that is not two numbers.
    #[error(
        "line {line} reads \"{found}\": it must be two finite numbers with a comma, a semicolon or a tab between them; decimal commas need one of the latter"
    )]
    Line {
        /// From 1.
        line: usize,
        /// The line.
        found: String,
    },
    /// A header in a unit that is not known.
    #[error(
        "line {line} names the unit \"{unit}\", which is not known: write m, cm, mm, µm or nm, and Hz or kHz of a frequency"
    )]
    Unit {
        /// From 1.
        line: usize,
        /// What stands in the brackets.
        unit: String,
    },
}

/// Units of length and of frequency, and their size [m, Hz].
const UNITS: [(&str, f64); 10] = [
    ("m", 1.0),
    ("cm", 1e-2),
    ("mm", 1e-3),
    ("um", 1e-6),
    ("µm", 1e-6),
    ("μm", 1e-6),
    ("nm", 1e-9),
    ("km", 1e3),
    ("Hz", 1.0),
    ("kHz", 1e3),
];

/// The pairs in `text`: a header, then two numbers a line, in metres unless the header names another unit (`r [mm]`, `r (µm)`,
/// `r_mm`). Between them stands a comma, or a semicolon or a tab, with which numbers may have decimal commas. Empty lines and
/// lines that begin with # are skipped.
///
/// # Errors
/// No header, an unknown unit in square brackets, a line that is not two finite numbers.
pub fn read(text: &str) -> Result<Columns, ColumnsError> {
    let text = text.trim_start_matches('\u{feff}');
    let header = text.lines().find(|line| !skipped(line)).unwrap_or_default();
    let between = [';', '\t'].into_iter().find(|c| header.contains(*c)).unwrap_or(',');
    let reader = csv::ReaderBuilder::new()
        .delimiter(between as u8)
        .has_headers(false)
        .flexible(true)
        .comment(Some(b'#'))
        .trim(csv::Trim::All)
        .from_reader(text.as_bytes());
    let mut columns = Columns::default();
    let mut sizes: Option<[f64; 2]> = None;
    // no record fails: text of any number of fields
    for record in reader.into_records().map_while(Result::ok).filter(|r| r.iter().any(|f| !f.is_empty())) {
        let line = line(text, &record);
        let found = || text.lines().nth(line - 1).unwrap_or_default().trim().to_owned();
        match (sizes, pair(&record, between)) {
            (Some(sizes), Some([x, value])) => {
                columns.x.push(sizes[0] * x);
                columns.values.push(sizes[1] * value);
                columns.lines.push(line);
            }
            (Some(_), None) => return Err(ColumnsError::Line { line, found: found() }),
            (None, Some(_)) => return Err(ColumnsError::Header { line, found: found() }),
            (None, None) => {
                let size = |i| record.get(i).map_or(Ok(1.0), |name| size(name, line));
                sizes = Some([size(0)?, size(1)?]);
            }
        }
    }
    Ok(columns)
}

/// Whether `line` holds nothing.
fn skipped(line: &str) -> bool {
    line.trim().is_empty() || line.starts_with('#')
}

/// The line `record` stands in, from 1: its position in `text` is that of the lines skipped before it.
fn line(text: &str, record: &csv::StringRecord) -> usize {
    let (from, line) = record.position().map_or((0, 1), |at| (at.byte() as usize, at.line() as usize));
    line + text.get(from..).unwrap_or_default().lines().take_while(|line| skipped(line)).count()
}

/// Two finite numbers and nothing else.
fn pair(record: &csv::StringRecord, between: char) -> Option<[f64; 2]> {
    let number = |text: &str| {
        let text = if between == ',' { text.to_owned() } else { text.replace(',', ".") };
        text.parse().ok().filter(|v: &f64| v.is_finite())
    };
    let rest_is_empty = record.iter().skip(2).all(str::is_empty);
    rest_is_empty.then_some(())?;
    Some([number(record.get(0)?)?, number(record.get(1)?)?])
}

/// Size [m] of the unit in the name of a column; 1 where there is none.
fn size(name: &str, line: usize) -> Result<f64, ColumnsError> {
    let within = |text: &str| {
        let mut words = text.split(|c: char| !c.is_alphanumeric());
        words.find_map(|word| UNITS.iter().find(|unit| unit.0 == word)).map(|unit| unit.1)
    };
    match name.split_once('[').map(|(_, rest)| rest.split(']').next().unwrap_or(rest)) {
        Some(unit) => within(unit).ok_or_else(|| ColumnsError::Unit { line, unit: unit.trim().to_owned() }),
        None => Ok(within(name).unwrap_or(1.0)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_of_the_header_are_obeyed() {
        for (header, x, value) in [
            ("x,r", 1.0, 1.0),
            ("x_m,r_mm", 1.0, 1e-3),
            ("x [m], r [mm, positive down]", 1.0, 1e-3),
            ("chainage (km);Längshöhe (µm)", 1e3, 1e-6),
            ("x/cm\tr in um", 1e-2, 1e-6),
        ] {
            let between = [';', '\t'].into_iter().find(|c| header.contains(*c)).unwrap_or(',');
            let found = read(&format!("# a comment\n{header}\n\n2{between}3\n")).unwrap();
            assert_eq!((found.x, found.values), (vec![2.0 * x], vec![3.0 * value]), "{header}");
            assert_eq!(found.lines, [4]);
        }
    }

    #[test]
    fn lines_are_counted_past_what_is_skipped() {
        let text = "# made by\r\n\r\nx;r;\r\n# from here\r\n0;1;\r\n \r\n;;\r\n1;2\r\n\r\n2;3";
        assert_eq!(read(text).unwrap().lines, [5, 8, 10]);
        assert_eq!(read(&text.replace("\r", "")).unwrap().lines, [5, 8, 10]);
        assert_eq!(read("# nothing\n").unwrap(), Columns::default());
    }

    #[test]
    fn decimal_commas_with_semicolons() {
        let found = read("\u{feff}\"x [m]\";\"r [mm]\"\r\n0,25;-1,5\r\n").unwrap();
        assert_eq!((found.x, found.values), (vec![0.25], vec![-1.5e-3]));
    }

    #[test]
    fn says_what_is_wrong_and_where() {
        let why = |text: &str| read(text).unwrap_err().to_string();
        assert!(why("0, 1\n1, 2").starts_with("line 1 reads \"0, 1\": it must be a header"));
        assert!(why("x,r\n0, 1\n\n1; 2").starts_with("line 4 reads \"1; 2\": it must be two finite numbers"));
        assert!(why("x,r\n0, inf").starts_with("line 2"));
        assert!(why("x,r\n0, 1, 2").starts_with("line 2"));
        assert!(why("x [m], r [in]\n0, 1").contains("the unit \"in\", which is not known"));
    }
}
