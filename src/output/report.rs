//! The report: one HTML file that holds everything, for reading, sending and printing.

use super::ReportTable;
use super::markup::escape;
use super::plot::Picture;
use crate::concern::Concern;
use std::fmt::Write as _;

/// Everything a reader needs to judge a run: the answers first, then what they rest on.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Report {
    /// Title of the case.
    pub title: String,
    /// Project, client, author, …, as rows under the title.
    pub about: Vec<(String, String)>,
    /// Where the case comes from, if it reproduces something.
    pub source: Option<String>,
    /// Version of groundwave.
    pub version: String,
    /// What was asked, and the value with its unit.
    pub answers: Vec<(String, String)>,
    /// Answers that read better as a table.
    pub answer_tables: Vec<ReportTable>,
    /// Title, caption and picture of every figure.
    pub figures: Vec<(String, String, Picture)>,
    /// Tables.
    pub tables: Vec<ReportTable>,
    /// The whole case file.
    pub case_text: String,
    /// What the model takes for granted.
    pub assumptions: Vec<String>,
    /// Reasons to doubt the answers.
    pub concerns: Vec<Concern>,
    /// Literature.
    pub references: Vec<String>,
}

const STYLE: &str = include_str!("report.css");
const SCRIPT: &str = include_str!("report.js");

impl Report {
    /// The report as one self-contained HTML5 document: nothing fetched, ready to print on A4, whole without its script, which tells
    /// values under the pointer.
    ///
    /// All text is escaped; the pictures' SVG is taken as it is.
    pub fn html(&self) -> String {
        let mut html = format!(
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
             <title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n<header>\n<h1>{title}</h1>\n",
            title = escape(&self.title)
        );
        if !self.about.is_empty() {
            html.push_str("<dl class=\"about\">\n");
            for (what, text) in &self.about {
                let _ = writeln!(html, "<dt>{}</dt><dd>{}</dd>", escape(what), escape(text));
            }
            html.push_str("</dl>\n");
        }
        if let Some(source) = &self.source {
            let _ = writeln!(html, "<p class=\"source\">Source: {}</p>", escape(source));
        }
        html.push_str("</header>\n<main>\n");
        self.answers(&mut html);
        for table in &self.answer_tables {
            self::table(&mut html, table);
        }
        self.concerns(&mut html);
        self.figures(&mut html);
        for table in &self.tables {
            self::table(&mut html, table);
        }
        list(&mut html, "Assumptions", &self.assumptions);
        list(&mut html, "References", &self.references);
        let told = self.figures.iter().any(|(_, _, picture)| !picture.readout.is_empty());
        let script = if told { format!("<script>\n{SCRIPT}</script>\n") } else { String::new() };
        let _ = write!(
            html,
            "<section class=\"case\">\n<h2>Case file</h2>\n<pre>{}</pre>\n</section>\n</main>\n\
             <footer>groundwave {}</footer>\n{script}</body>\n</html>\n",
            escape(&self.case_text),
            escape(&self.version)
        );
        html
    }

    fn answers(&self, html: &mut String) {
        if self.answers.is_empty() {
            return;
        }
        html.push_str("<section>\n<h2>Answers</h2>\n<table class=\"answers\">\n");
        for (what, value) in &self.answers {
            let _ =
                writeln!(html, "<tr><th scope=\"row\">{}</th><td>{}</td></tr>", escape(what), escape(value));
        }
        html.push_str("</table>\n</section>\n");
    }

    fn concerns(&self, html: &mut String) {
        if self.concerns.is_empty() {
            html.push_str(
                "<section class=\"clear\">\n<h2>Concerns</h2>\n<p>No concerns: every check of the run passed.</p>\n\
                 </section>\n",
            );
            return;
        }
        html.push_str("<section class=\"concerns\">\n<h2>Concerns</h2>\n<ul>\n");
        for concern in &self.concerns {
            let _ = writeln!(
                html,
                "<li><strong>{}</strong> {} <em>{}</em></li>",
                escape(concern.code),
                escape(&concern.message),
                escape(&concern.remedy)
            );
        }
        html.push_str("</ul>\n</section>\n");
    }

    fn figures(&self, html: &mut String) {
        if self.figures.is_empty() {
            return;
        }
        html.push_str("<section>\n<h2>Figures</h2>\n");
        for (index, (title, caption, Picture { svg, readout, .. })) in self.figures.iter().enumerate() {
            html.push_str("<figure>\n");
            html.push_str(svg);
            if !readout.is_empty() {
                let _ = writeln!(html, "<script type=\"application/json\">{readout}</script>");
            }
            let _ = writeln!(
                html,
                "<figcaption><b>Figure {}.</b> {}{} {}</figcaption>\n</figure>",
                index + 1,
                escape(title),
                if title.ends_with(['.', '?', '!']) || title.is_empty() { "" } else { "." },
                escape(caption)
            );
        }
        html.push_str("</section>\n");
    }
}

fn table(html: &mut String, table: &ReportTable) {
    let _ = writeln!(html, "<section>\n<h2>{}</h2>\n<table>\n<thead><tr>", escape(&table.title));
    for heading in &table.header {
        let _ = write!(html, "<th scope=\"col\">{}</th>", escape(heading));
    }
    html.push_str("</tr></thead>\n<tbody>\n");
    for row in &table.rows {
        html.push_str("<tr>");
        for cell in row {
            let _ = write!(html, "<td>{}</td>", escape(cell));
        }
        html.push_str("</tr>\n");
    }
    html.push_str("</tbody>\n</table>\n</section>\n");
}

fn list(html: &mut String, title: &str, items: &[String]) {
    if items.is_empty() {
        return;
    }
    let _ = writeln!(html, "<section>\n<h2>{title}</h2>\n<ul>");
    for item in items {
        let _ = writeln!(html, "<li>{}</li>", escape(item));
    }
    html.push_str("</ul>\n</section>\n");
}

#[cfg(test)]
mod tests {
    use super::*;

    fn report() -> Report {
        let readout = "{\"frame\":[]}".to_owned();
        let picture = Picture { name: "speed".into(), svg: "<svg id=\"a\"></svg>".into(), readout };
        Report {
            title: "Soft <clay> & \"peat\"".into(),
            version: "0.1.0".into(),
            answers: vec![("Critical speed".into(), "137 m/s".into())],
            figures: vec![("Speed".into(), "c_s < v".into(), picture)],
            tables: vec![ReportTable {
                title: "Layers".into(),
                header: vec!["thickness [m]".into()],
                rows: vec![vec!["<2".into()]],
            }],
            case_text: "# a <b>\n[soil]".into(),
            ..Report::default()
        }
    }

    #[test]
    fn text_is_escaped_and_pictures_are_not() {
        let html = report().html();
        assert!(html.contains("<h1>Soft &lt;clay&gt; &amp; &quot;peat&quot;</h1>"));
        assert!(html.contains("c_s &lt; v"));
        assert!(html.contains("<td>&lt;2</td>"));
        assert!(html.contains("<pre># a &lt;b&gt;\n[soil]</pre>"));
        assert!(html.contains("<svg id=\"a\"></svg>"));
        assert!(!html.contains("<clay>"));
    }

    #[test]
    fn nothing_is_fetched_and_without_pictures_nothing_runs() {
        let mut report = report();
        for word in ["http://", "https://", "@import", "src=", "fetch(", "XMLHttpRequest", "import("] {
            assert!(!report.html().contains(word), "{word}");
        }
        assert_eq!(report.html().matches("<script").count(), 2);
        report.figures[0].2.readout.clear();
        assert!(!report.html().contains("<script"));
    }

    #[test]
    fn answers_come_first_and_concerns_are_shown_or_denied() {
        let mut report = report();
        let html = report.html();
        assert!(html.contains("No concerns"));
        assert!(html.find("137 m/s") < html.find("No concerns"));
        report.concerns = vec![Concern::new("wrap-around", "0.3 > 0.01", "Widen x.")];
        let html = report.html();
        assert!(html.contains("<strong>wrap-around</strong> 0.3 &gt; 0.01 <em>Widen x.</em>"));
        assert!(!html.contains("No concerns"));
    }
}
