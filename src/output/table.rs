//! A table as a report shows it.

/// A table of the report.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ReportTable {
    /// Title above the table.
    pub title: String,
    /// Column headings, with units.
    pub header: Vec<String>,
    /// Rows of cells.
    pub rows: Vec<Vec<String>>,
}
