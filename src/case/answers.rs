//! The answers of a run as its report has them: a list, and tables of those that have many like them.

use crate::output::ReportTable;
use crate::study::{Answer, Cells};

/// What was asked and the value, of `answers` that stand in no table.
pub fn list<'a>(answers: impl Iterator<Item = &'a Answer>) -> Vec<(String, String)> {
    let alone = answers.filter(|answer| answer.cells.is_none());
    alone.map(|answer| (answer.what.clone(), answer.shown.clone())).collect()
}

/// The tables of the others: rows and columns as they come, a cell empty where nothing is said.
pub fn tables<'a>(answers: impl Iterator<Item = &'a Answer>) -> Vec<ReportTable> {
    let mut tables: Vec<ReportTable> = Vec::new();
    for Cells { table: title, of, row, columns } in answers.filter_map(|answer| answer.cells.as_ref()) {
        let place = tables.iter().position(|table| table.title == *title).unwrap_or_else(|| {
            tables.push(ReportTable {
                title: title.clone(),
                header: vec![(*of).to_owned()],
                rows: Vec::new(),
            });
            tables.len() - 1
        });
        let ReportTable { header, rows, .. } = &mut tables[place];
        let line = rows.iter().position(|cells| cells[0] == *row).unwrap_or_else(|| {
            rows.push(vec![row.clone()]);
            rows.len() - 1
        });
        for (heading, text) in columns {
            let column = header.iter().position(|known| known == heading).unwrap_or_else(|| {
                header.push(heading.clone());
                header.len() - 1
            });
            let cells = &mut rows[line];
            cells.resize(cells.len().max(column + 1), String::new());
            cells[column].clone_from(text);
        }
    }
    for ReportTable { header, rows, .. } in &mut tables {
        rows.iter_mut().for_each(|cells| cells.resize(header.len(), String::new()));
    }
    tables
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_and_columns_as_they_come() {
        let answer = |row: &str, columns: &[(&str, &str)]| {
            let columns = columns.iter().map(|(heading, text)| ((*heading).to_owned(), (*text).to_owned()));
            Answer::new("x", "X", 1.0, "m", "1 m".into()).in_table(Cells {
                table: "T".into(),
                of: "y [m]",
                row: row.into(),
                columns: columns.collect(),
            })
        };
        let answers = [
            answer("5", &[("a", "1"), ("b", "2")]),
            Answer::new("alone", "Alone", 2.0, "m", "2 m".into()),
            answer("10", &[("b", "3")]),
            answer("5", &[("c", "4")]),
        ];
        assert_eq!(list(answers.iter()), [("Alone".to_owned(), "2 m".to_owned())]);
        let [table] = &tables(answers.iter())[..] else { panic!("one table") };
        assert_eq!(
            (table.title.as_str(), &table.header[..]),
            ("T", &["y [m]", "a", "b", "c"].map(str::to_owned)[..])
        );
        assert_eq!(
            table.rows,
            [["5", "1", "2", "4"], ["10", "", "3", ""]].map(|row| row.map(str::to_owned).to_vec())
        );
    }
}
