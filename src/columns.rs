//! Columns of numbers from a CSV file: positions and what was measured there, as track recording cars and spreadsheets write them.

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

/// Columns of numbers with the names their header gives them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// As the header has them.
    pub names: Vec<String>,
    /// Column after column, as they stand.
    pub columns: Vec<Vec<f64>>,
    /// The line each row stands in, from 1.
    pub lines: Vec<usize>,
    /// The line of the header.
    pub header: usize,
}

/// Why a file is no table of numbers.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum ColumnsError {
    /// The first line is not a header.
    #[error("line {line} reads \"{found}\": it must be a header naming the {}columns, such as x [m], r [mm]", many(*wanted))]
    Header {
        /// From 1.
        line: usize,
        /// The line.
        found: String,
        /// How many columns there must be; 0 where any number will do.
        wanted: usize,
    },
    /// A line that is not as many numbers.
    #[error(
        "line {line} reads \"{found}\": it must be {}finite numbers with a comma, a semicolon or a tab between them; decimal commas need one of the latter",
        many(*wanted)
    )]
    Line {
        /// From 1.
        line: usize,
        /// The line.
        found: String,
        /// How many numbers there must be.
        wanted: usize,
    },
    /// A header in a unit that is not known.
    #[error("line {line} names the unit \"{unit}\", which is not known: write {known}")]
    Unit {
        /// From 1.
        line: usize,
        /// What stands in the brackets.
        unit: String,
        /// What may stand there.
        known: String,
    },
}

/// "two " …
fn many(count: usize) -> String {
    match count {
        0 => String::new(),
        2 => "two ".to_owned(),
        3 => "three ".to_owned(),
        4 => "four ".to_owned(),
        count => format!("{count} "),
    }
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
/// `r_mm`), as [`table`] reads them.
///
/// # Errors
/// No header, an unknown unit in square brackets, a line that is not two finite numbers.
pub fn read(text: &str) -> Result<Columns, ColumnsError> {
    let Table { columns, lines, .. } = lengths(read_table(text, Some(2))?)?;
    let mut columns = columns.into_iter();
    let mut next = || columns.next().unwrap_or_default();
    Ok(Columns { x: next(), values: next(), lines })
}

/// `table` with each column in metres, by the unit its name gives.
///
/// # Errors
/// An unknown unit in square brackets.
pub fn lengths(mut table: Table) -> Result<Table, ColumnsError> {
    for (column, name) in table.columns.iter_mut().zip(&table.names) {
        let size = length(name, table.header)?;
        column.iter_mut().for_each(|value| *value *= size);
    }
    Ok(table)
}

/// The table in `text`: a header, then as many numbers a line as the header has names. Between them stands a comma, or a semicolon or
/// a tab, with which numbers may have decimal commas. Empty lines and lines that begin with #, % or // are skipped.
///
/// # Errors
/// No header; a line that is not as many finite numbers: a gap is none.
pub fn table(text: &str) -> Result<Table, ColumnsError> {
    read_table(text, None)
}

fn read_table(text: &str, wanted: Option<usize>) -> Result<Table, ColumnsError> {
    let text = text.trim_start_matches('\u{feff}');
    let first = text.lines().find(|line| !skipped(line)).unwrap_or_default();
    let between = [';', '\t'].into_iter().find(|c| first.contains(*c)).unwrap_or(',');
    let mut table = Table::default();
    for (i, found) in text.lines().enumerate() {
        let fields = fields(found, between);
        if skipped(found) || fields.iter().all(String::is_empty) {
            continue;
        }
        let (line, found) = (i + 1, found.trim().to_owned());
        let count = wanted.unwrap_or(if table.header == 0 { fields.len() } else { table.columns.len() });
        match (table.header, numbers(&fields, count, between)) {
            (0, Some(_)) => return Err(ColumnsError::Header { line, found, wanted: wanted.unwrap_or(0) }),
            (0, None) => {
                let count = wanted
                    .unwrap_or_else(|| fields.iter().rposition(|f| !f.is_empty()).map_or(0, |at| at + 1));
                table.header = line;
                table.columns = vec![Vec::new(); count];
                table.names = fields.into_iter().take(count).collect();
            }
            (_, Some(row)) => {
                table.columns.iter_mut().zip(row).for_each(|(column, value)| column.push(value));
                table.lines.push(line);
            }
            (_, None) => return Err(ColumnsError::Line { line, found, wanted: count }),
        }
    }
    Ok(table)
}

/// Whether `line` holds nothing.
fn skipped(line: &str) -> bool {
    let line = line.trim();
    line.is_empty() || ["#", "%", "//"].iter().any(|mark| line.starts_with(mark))
}

/// The fields of a `line`, which may be quoted.
fn fields(line: &str, between: char) -> Vec<String> {
    let reader = csv::ReaderBuilder::new()
        .delimiter(between as u8)
        .has_headers(false)
        .flexible(true)
        .trim(csv::Trim::All)
        .from_reader(line.as_bytes());
    // one record, which does not fail: text of any number of fields
    let record = reader.into_records().next().and_then(Result::ok).unwrap_or_default();
    record.iter().map(str::to_owned).collect()
}

/// `count` finite numbers and nothing else.
fn numbers(fields: &[String], count: usize, between: char) -> Option<Vec<f64>> {
    let number = |text: &String| {
        let text = if between == ',' { text.clone() } else { text.replace(',', ".") };
        text.parse().ok().filter(|v: &f64| v.is_finite())
    };
    let rest_is_empty = fields.iter().skip(count).all(String::is_empty);
    (rest_is_empty && fields.len() >= count).then(|| fields[..count].iter().map(number).collect())?
}

/// Size [m] of the unit in the name of a column; 1 where there is none.
fn length(name: &str, line: usize) -> Result<f64, ColumnsError> {
    let within = |text: &str| {
        let mut words = text.split(|c: char| !c.is_alphanumeric());
        words.find_map(|word| UNITS.iter().find(|unit| unit.0 == word)).map(|unit| unit.1)
    };
    match name.split_once('[').map(|(_, rest)| rest.split(']').next().unwrap_or(rest)) {
        Some(unit) => within(unit).ok_or_else(|| ColumnsError::Unit {
            line,
            unit: unit.trim().to_owned(),
            known: "m, cm, mm, µm or nm, and Hz or kHz of a frequency".to_owned(),
        }),
        None => Ok(within(name).unwrap_or(1.0)),
    }
}

/// The one of `known` units that the name of a column gives: in brackets or parentheses, or behind its last `_`, `/` or blank; None
/// where it gives none. ² and ^2 are read as 2, µ as u.
///
/// # Errors
/// A unit in brackets or parentheses that is none of them.
pub fn unit<T: Copy>(name: &str, line: usize, known: &[(&str, T)]) -> Result<Option<T>, ColumnsError> {
    let plain = |text: &str| -> String {
        text.replace(['^', ' ', '·'], "").replace('²', "2").replace('³', "3").replace(['µ', 'μ'], "u")
    };
    let find = |text: &str| {
        let found = [text.replace(' ', ""), plain(text)];
        known.iter().find(|(unit, _)| found.iter().any(|text| text == unit)).map(|(_, size)| *size)
    };
    for (open, close) in [('[', ']'), ('(', ')')] {
        if let Some((_, rest)) = name.split_once(open) {
            let within = rest.rsplit_once(close).map_or(rest, |(within, _)| within).trim();
            let known = known.iter().map(|(unit, _)| *unit).collect::<Vec<_>>().join(", ");
            let unknown = || ColumnsError::Unit { line, unit: within.to_owned(), known };
            return find(within).map(Some).ok_or_else(unknown);
        }
    }
    let marks = |c: char| "_ /".contains(c);
    Ok(name.match_indices(marks).find_map(|(at, mark)| find(&name[at + mark.len()..])))
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
    fn tables_of_any_width() {
        let text = "% car 7\n// run 3\nx [m]\tleft [mm]\tright [mm]\n0,0\t1,5\t-2\n\n# on\n0,5\t2\t3\n";
        let found = table(text).unwrap();
        assert_eq!(found.names, ["x [m]", "left [mm]", "right [mm]"]);
        assert_eq!(found.columns, [vec![0.0, 0.5], vec![1.5, 2.0], vec![-2.0, 3.0]]);
        assert_eq!((found.lines, found.header), (vec![4, 7], 3));
        // a gap is told at its line
        let gap = table("x;l;r\n0;1;2\n1;;2\n").unwrap_err().to_string();
        assert!(gap.starts_with("line 3 reads \"1;;2\": it must be three finite numbers"), "{gap}");
    }

    #[test]
    fn units_by_a_list() {
        let known = [("m/s", 1.0), ("mm/s", 1e-3), ("m/s2", 2.0), ("um/s", 1e-6)];
        let of = |name: &str| unit(name, 1, &known);
        for (name, size) in [
            ("v [mm/s]", 1e-3),
            ("v (µm/s)", 1e-6),
            ("a_z [m/s^2]", 2.0),
            ("a in m/s²", 2.0),
            ("v_mm/s", 1e-3),
            ("v mm/s", 1e-3),
        ] {
            assert_eq!(of(name), Ok(Some(size)), "{name}");
        }
        assert_eq!(of("velocity"), Ok(None));
        let why = of("v [in/s]").unwrap_err().to_string();
        assert!(why.contains("\"in/s\"") && why.contains("m/s, mm/s"), "{why}");
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
