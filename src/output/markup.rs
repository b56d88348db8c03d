//! Text and numbers as HTML and SVG write them.

/// Text that HTML and SVG show as it stands; control characters, which XML has no word for, become spaces.
pub(super) fn escape(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '"' => safe.push_str("&quot;"),
            '\'' => safe.push_str("&#39;"),
            '\n' | '\t' => safe.push(c),
            c if c.is_control() => safe.push(' '),
            c => safe.push(c),
        }
    }
    safe
}

/// Text as [`escape`] has found it.
pub(super) fn unescape(text: &str) -> String {
    let marks = [("&lt;", "<"), ("&gt;", ">"), ("&quot;", "\""), ("&#39;", "'"), ("&amp;", "&")];
    marks.iter().fold(text.to_owned(), |text, (said, meant)| text.replace(said, meant))
}

/// A length [px] to a hundredth, without idle zeros.
pub(super) fn number(length: f64) -> String {
    let text = format!("{length:.2}");
    let short = text.trim_end_matches('0').trim_end_matches('.');
    if short == "-0" { "0".to_owned() } else { short.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_text_is_safe() {
        let shown = [3.0, 2.5, -0.001, 100.0, 774.5500000000001].map(number);
        assert_eq!(shown, ["3", "2.5", "0", "100", "774.55"]);
        assert_eq!(escape("a\u{7}<b> & \"c\"\n"), "a &lt;b&gt; &amp; &quot;c&quot;\n");
        assert_eq!(unescape(&escape("a <b> & \"c\" 'd' &lt;")), "a <b> & \"c\" 'd' &lt;");
    }
}
