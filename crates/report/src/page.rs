//! What every page has in common: run, sweep, comparison and calibration share one style sheet, one script
//! and one head.
//!
//! A page is one file that works without a network, without a server and, but for values under the pointer
//! and zoom, without scripts.

use input::printed::plain;
use serde::Serialize;

/// The head of every page; its template needs a `title`.
const HEAD: &str = include_str!("../assets/head.html");
/// The style sheet, for light and dark screens and paper.
const STYLE: &str = include_str!("../assets/style.css");
/// Values under the pointer, zoom, unfolding on paper.
const CHARTS: &str = include_str!("../assets/charts.js");

/// Fills in a template, into which it can `include` `head.html` and `charts.js`, and what `more` names.
/// Everything inserted is escaped unless the template marks it safe, and shows characters that would change
/// the order of what is read; the filter `lowered` makes subscripts, `symbols` those of symbols alone.
///
/// # Errors
/// What the template engine says; only a defect of the program can cause it.
pub fn render_page(
    template: &str,
    content: &impl Serialize,
    more: &[(&str, &str)],
) -> Result<String, minijinja::Error> {
    let mut environment = minijinja::Environment::new();
    environment.add_filter("lowered", |text: String| minijinja::Value::from_safe_string(lowered(&text)));
    environment.add_filter("symbols", |text: String| minijinja::Value::from_safe_string(symbols(&text)));
    // Because the name ends in .html, everything inserted is escaped unless it is marked safe.
    let own = [("page.html", template), ("head.html", HEAD), ("style.css", STYLE), ("charts.js", CHARTS)];
    for (name, text) in own.into_iter().chain(more.iter().copied()) {
        environment.add_template(name, text)?;
    }
    let html = environment.get_template("page.html")?.render(minijinja::value::Serde(content))?;
    Ok(plain(&html).into_owned())
}

/// Text as HTML, with subscripts: the letter after `_` is lowered.
#[must_use]
pub fn lowered(text: &str) -> String {
    let mut html = String::new();
    let mut letters = text.chars();
    while let Some(letter) = letters.next() {
        match letter {
            '_' => html.extend(letters.next().map(|low| format!("<sub>{low}</sub>"))),
            '<' => html.push_str("&lt;"),
            '&' => html.push_str("&amp;"),
            _ => html.push(letter),
        }
    }
    html
}

/// Text as HTML in which symbols have their indices lowered, F_H or φ_cv: a letter, and one or two after `_`.
/// Names such as `towed_disc` stay.
fn symbols(text: &str) -> String {
    let is_word = |c: &char| c.is_alphanumeric() || *c == '_';
    let mut html = String::new();
    let mut rest: &[char] = &text.chars().collect::<Vec<char>>();
    while let Some(first) = rest.first() {
        let length = rest.iter().take_while(|c| is_word(c)).count().max(1);
        let (word, after) = rest.split_at(length);
        match word {
            [letter, '_', index @ ..] if index.len() <= 2 && index.iter().all(|c| c.is_alphanumeric()) => {
                html.push_str(&format!("{letter}<sub>{}</sub>", index.iter().collect::<String>()));
            }
            _ if *first == '<' => html.push_str("&lt;"),
            _ if *first == '&' => html.push_str("&amp;"),
            _ => html.extend(word),
        }
        rest = after;
    }
    html
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pages_are_escaped_and_whole() {
        let template = "{% set title = name %}{% include \"head.html\" %}<p>{{ name }}</p>";
        let content = std::collections::BTreeMap::from([("name", "a<b")]);
        let html = render_page(template, &content, &[]).unwrap();
        assert!(html.contains("<title>a&lt;b – Coulter</title>") && html.ends_with("<p>a&lt;b</p>"));
        assert!(html.contains("prefers-color-scheme: dark") && !html.contains("{{"));
        let content = std::collections::BTreeMap::from([("name", "a\u{202e}b\u{1b}")]);
        assert!(render_page(template, &content, &[]).unwrap().ends_with("<p>a\\u202eb\\u001b</p>"));
        assert_eq!(lowered("F_H & <"), "F<sub>H</sub> &amp; &lt;");
        assert_eq!(symbols("φ_cv < F_H, a_disc & _"), "φ<sub>cv</sub> &lt; F<sub>H</sub>, a_disc &amp; _");
    }
}
