//! The page around the data: template, style, script and words, put into one file.

use crate::engine;
use crate::texts::{self, Language, Message, Value, escaped};
use crate::unscripted::Facts;

/// A module of the script: its path in the folder `page/js`, and its source.
macro_rules! module {
    ($name:literal) => {
        ($name, include_str!(concat!("../page/js/", $name)))
    };
}

/// The page with the tokens `{{policy}}`, `{{title}}`, `{{language}}`, `{{languages}}`, `{{style}}`, `{{data}}`, `{{texts}}`,
/// `{{engine}}` and `{{script}}`; the element `data-text="key"` has the text of a key, the label of `data-text-label="key"` is one.
const TEMPLATE: &str = include_str!("../page/index.html");
const STYLE: &str = include_str!("../page/style.css");

/// The module that starts everything.
const MAIN: &str = "main.js";

/// All modules of the script by name; their order in the page follows from what they import.
const MODULES: &[(&str, &str)] = &[
    module!("dom.js"),
    module!("editor/actions.js"),
    module!("editor/address.js"),
    module!("editor/controls.js"),
    module!("editor/drag.js"),
    module!("editor/export.js"),
    module!("editor/fragment.js"),
    module!("editor/grid.js"),
    module!("editor/importing.js"),
    module!("editor/look.js"),
    module!("editor/marks.js"),
    module!("editor/moving.js"),
    module!("editor/panel.js"),
    module!("editor/question-form.js"),
    module!("editor/refusals.js"),
    module!("editor/session.js"),
    module!("editor/sheet.js"),
    module!("editor/table-notes.js"),
    module!("engine.js"),
    module!("fragment-parts.js"),
    module!("main.js"),
    module!("model/format.js"),
    module!("model/intersection.js"),
    module!("model/lesson.js"),
    module!("model/rational.js"),
    module!("model/sweep.js"),
    module!("model/table.js"),
    module!("model/worst-line.js"),
    module!("panels/clipping.js"),
    module!("panels/epsilon.js"),
    module!("panels/inspector.js"),
    module!("panels/introduction.js"),
    module!("panels/language.js"),
    module!("panels/layers.js"),
    module!("panels/leave-one-out.js"),
    module!("panels/questions.js"),
    module!("panels/start.js"),
    module!("panels/summary.js"),
    module!("panels/teacher.js"),
    module!("panels/worst-line.js"),
    module!("picture.js"),
    module!("planes/axes.js"),
    module!("planes/corridor.js"),
    module!("planes/data-frame.js"),
    module!("planes/data-plane.js"),
    module!("planes/end-labels.js"),
    module!("planes/interaction.js"),
    module!("planes/parameter-plane.js"),
    module!("planes/parameter-view.js"),
    module!("planes/region.js"),
    module!("planes/ticks.js"),
    module!("planes/vertex-marks.js"),
    module!("planes/view.js"),
    module!("planes/worst-lines.js"),
    module!("polytope/document.js"),
    module!("polytope/drawing.js"),
    module!("polytope/editing.js"),
    module!("polytope/editor.js"),
    module!("polytope/exercise-panel.js"),
    module!("polytope/exercises.js"),
    module!("polytope/gestures.js"),
    module!("polytope/half-planes.js"),
    module!("polytope/random.js"),
    module!("polytope/scene.js"),
    module!("polytope/store.js"),
    module!("polytope/story.js"),
    module!("polytope/view.js"),
    module!("state.js"),
    module!("texts.js"),
];

/// The page with a title and data in JSON, in a language; with what it says of the data, and what shows where scripts are off.
pub(crate) fn page(
    title: &str,
    data: &str,
    language: Language,
    facts: Option<(&Facts<'_>, &str)>,
) -> Result<String, serde_json::Error> {
    let table = texts::table()?;
    let values = facts.map(|(facts, _)| facts.values()).unwrap_or_default();
    let template = with_texts(TEMPLATE, language, &values);
    let template = facts.map(|(facts, _)| with_names(&template, facts)).unwrap_or(template);
    Ok(fill(&template, |token| match token {
        "unscripted" => Some(facts.map_or_else(
            || format!("<p>{}</p>", texts::html(&Message::new("page.no-script"), language)),
            |(_, unscripted)| unscripted.to_owned(),
        )),
        "policy" => Some(engine::POLICY.to_owned()),
        "title" => Some(escaped(title)),
        "language" => Some(language.code().to_owned()),
        "languages" => Some(languages(language)),
        "style" => Some(STYLE.to_owned()),
        "data" => Some(embedded(data)),
        "texts" => Some(embedded(&table)),
        "engine" => Some(engine::elements()),
        "script" => Some(script()),
        _ => None,
    }))
}

/// The choice between the languages, each under its own name.
fn languages(chosen: Language) -> String {
    let option = |language: Language| {
        let (code, selected) = (language.code(), if language == chosen { " selected" } else { "" });
        format!("<option value=\"{code}\" lang=\"{code}\"{selected}>{}</option>", language.name())
    };
    Language::ALL.map(option).concat()
}

/// The template with the texts of its keys, so that it can be read without a script.
fn with_texts(template: &str, language: Language, values: &[(&str, Value)]) -> String {
    let message = |key: &str| {
        values.iter().fold(Message::new(key), |message, (name, value)| message.with(name, value.clone()))
    };
    let of = |key: &str| texts::html(&message(key), language);
    let labelled = each(template, "data-text-label=\"", |key, rest| {
        (format!("{key}\" aria-label=\"{}\"", of(key)), rest.strip_prefix('"').unwrap_or(rest))
    });
    each(&labelled, "data-text=\"", |key, rest| {
        let (attributes, after) = rest.split_once('>').unwrap_or((rest, ""));
        (format!("{key}{attributes}>{}", of(key)), after)
    })
}

/// The template with the columns of the data in its formulas, and without what belongs to the other model.
fn with_names(template: &str, facts: &Facts<'_>) -> String {
    let names = facts.names_in_formulas();
    let named = each(template, "data-name=\"", |key, rest| {
        let name = names.iter().find(|(name, _)| *name == key).map_or("", |(_, column)| column);
        (format!("{key}\">{}", escaped(name)), rest.strip_prefix("\">").unwrap_or(rest))
    });
    each(&named, "data-model=\"", |model, rest| {
        let off = if model == facts.model() { "" } else { " data-off" };
        (format!("{model}\"{off}"), rest.strip_prefix('"').unwrap_or(rest))
    })
}

/// Replaces the text behind each `mark`. `replaced` takes the text up to the next quotation mark and the rest, and
/// returns the replacement and the remaining rest.
fn each<'a>(text: &'a str, mark: &str, replaced: impl Fn(&str, &'a str) -> (String, &'a str)) -> String {
    let mut done = String::with_capacity(2 * text.len());
    let mut rest = text;
    while let Some((before, after)) = rest.split_once(mark) {
        let key = after.split('"').next().unwrap_or_default();
        let (new, left) = replaced(key, after.strip_prefix(key).unwrap_or(after));
        done.extend([before, mark, &new]);
        rest = left;
    }
    done + rest
}

/// Replaces each `{{token}}` that has a value. Replacements are not searched again.
fn fill(template: &str, value: impl Fn(&str) -> Option<String>) -> String {
    let mut page = String::with_capacity(template.len());
    let mut rest = template;
    while let Some((before, after)) = rest.split_once("{{") {
        page.push_str(before);
        match after.split_once("}}").and_then(|(token, after)| Some((value(token)?, after))) {
            Some((text, after)) => {
                page.push_str(&text);
                rest = after;
            }
            None => {
                page.push_str("{{");
                rest = after;
            }
        }
    }
    page + rest
}

/// JSON that cannot end the element that it is in. `<` occurs in its strings only, where an escape means the same.
fn embedded(json: &str) -> String {
    json.replace('<', "\\u003c").replace('\u{2028}', "\\u2028").replace('\u{2029}', "\\u2029")
}

/// The modules as one: without imports and the word `export`, as all of them share one scope, and without lines of comments.
fn script() -> String {
    let mut script = String::new();
    for (name, source) in in_order() {
        script.push_str(&format!("// {name}\n"));
        let mut is_comment = false;
        for line in source.lines().filter(|line| !line.starts_with("import ")) {
            let text = line.trim();
            is_comment |= text.starts_with("/**") && !text.contains("*/");
            if is_comment {
                is_comment = !text.ends_with("*/");
                continue;
            }
            if text.starts_with("//") || text.starts_with("/**") && text.ends_with("*/") {
                continue;
            }
            script.push_str(line.strip_prefix("export ").unwrap_or(line));
            script.push('\n');
        }
    }
    script
}

/// The modules that the main one needs, each after those that it imports: a constant must be there before it is used.
fn in_order() -> Vec<(&'static str, &'static str)> {
    let mut order = Vec::new();
    add(MAIN, &mut Vec::new(), &mut order);
    order
}

/// Adds a module that was not met before to the order, those that it imports first.
fn add(name: &str, met: &mut Vec<String>, order: &mut Vec<(&'static str, &'static str)>) {
    if met.iter().any(|known| known == name) {
        return;
    }
    met.push(name.to_owned());
    let Some(&module) = MODULES.iter().find(|(known, _)| *known == name) else { return };
    for line in module.1.lines() {
        if let Some(imported) = imported(name, line) {
            add(&imported, met, order);
        }
    }
    order.push(module);
}

/// The module that a line of another one imports: `import { … } from "../model/format.js";` in `panels/layers.js`.
fn imported(importer: &str, line: &str) -> Option<String> {
    let (_, rest) = line.strip_prefix("import { ")?.split_once(" } from \"")?;
    let mut path: Vec<&str> = importer.split('/').collect();
    path.pop();
    for part in rest.strip_suffix("\";")?.split('/') {
        match part {
            "." => {}
            ".." => {
                path.pop();
            }
            part => path.push(part),
        }
    }
    Some(path.join("/"))
}

#[cfg(test)]
mod tests {
    use std::collections::HashMap;
    use std::path::Path;

    use super::*;

    #[test]
    fn what_is_put_in_is_not_looked_at_again() {
        let value = |token: &str| match token {
            "one" => Some("{{two}}".to_owned()),
            "two" => Some("2".to_owned()),
            _ => None,
        };
        assert_eq!(fill("a {{one}} b {{two}} c {{three}} {{", value), "a {{two}} b 2 c {{three}} {{");
    }

    #[test]
    fn titles_and_data_cannot_end_their_elements() {
        let text = page("</title><b>&", "{\"a\": \"</script>\u{2028}\"}", Language::English, None).unwrap();
        assert!(text.contains("<title>&lt;/title&gt;&lt;b&gt;&amp;</title>"));
        assert!(text.contains("{\"a\": \"\\u003c/script>\\u2028\"}"));
        for source in MODULES.iter().map(|(_, source)| *source).chain([STYLE]) {
            assert!(!source.contains("</script") && !source.contains("</style") && !source.contains("<!--"));
        }
    }

    #[test]
    fn each_token_occurs_once() {
        let tokens = [
            "policy",
            "title",
            "language",
            "languages",
            "style",
            "data",
            "texts",
            "unscripted",
            "engine",
            "script",
        ];
        for token in tokens.map(|token| format!("{{{{{token}}}}}")) {
            assert_eq!(TEMPLATE.matches(&token).count(), 1, "{token}");
        }
    }

    #[test]
    fn the_page_has_its_texts_where_their_keys_are() {
        let page = |language| page("t", "{}", language, None).unwrap();
        let english = page(Language::English);
        assert!(english.starts_with("<!doctype html>\n<html lang=\"en\">"));
        assert!(english.contains("<h3 data-text=\"data-plane.title\">Data plane</h3>"));
        assert!(english.contains("data-text-label=\"view.zoom-in\" aria-label=\"Zoom in\">+</button>"));
        assert!(english.contains("<option value=\"en\" lang=\"en\" selected>English</option>"));
        let german = page(Language::German);
        assert!(german.starts_with("<!doctype html>\n<html lang=\"de\">"));
        assert!(german.contains("<h3 data-text=\"data-plane.title\">Datenebene</h3>"));
        assert!(german.contains("<option value=\"de\" lang=\"de\" selected>Deutsch</option>"));
    }

    /// The scripts in a folder and below it, by their paths from the first one.
    fn scripts(folder: &Path, prefix: &str) -> Vec<String> {
        let mut found = Vec::new();
        for entry in std::fs::read_dir(folder).unwrap() {
            let entry = entry.unwrap();
            let name = format!("{prefix}{}", entry.file_name().to_str().unwrap());
            if entry.path().is_dir() {
                found.extend(scripts(&entry.path(), &format!("{name}/")));
            } else if name.ends_with(".js") {
                found.push(name);
            }
        }
        found
    }

    #[test]
    fn every_script_of_the_folder_is_in_the_page_and_the_main_one_comes_last() {
        let mut files = scripts(&Path::new(env!("CARGO_MANIFEST_DIR")).join("page/js"), "");
        let mut joined: Vec<&str> = in_order().into_iter().map(|(name, _)| name).collect();
        assert_eq!(joined.last(), Some(&MAIN));
        files.sort();
        joined.sort_unstable();
        assert_eq!(joined, files);
    }

    /// Two modules that import each other have no order. That what is imported exists is checked with the types, in
    /// `tests/browser`.
    #[test]
    fn modules_come_after_those_that_they_import() {
        let mut before: Vec<&str> = Vec::new();
        for (name, source) in in_order() {
            for line in source.lines().filter(|line| line.trim_start().starts_with("import")) {
                let imported = imported(name, line).unwrap_or_else(|| panic!("{name}: {line}"));
                assert!(before.contains(&imported.as_str()), "{name}: {line}");
                assert!(!line.contains(" as "), "{name}: in one scope there is one name: {line}");
            }
            before.push(name);
        }
    }

    #[test]
    fn modules_can_share_one_scope() {
        let mut owners: HashMap<&str, &str> = HashMap::new();
        for (name, source) in MODULES {
            for line in source.lines() {
                let plain = line.strip_prefix("export ").unwrap_or(line);
                let own = declared(plain);
                assert!(own.is_some() || plain == line, "{name}: {line}");
                if let Some(own) = own {
                    assert!(own.chars().all(|c| c.is_alphanumeric() || "_$".contains(c)), "{name}: {line}");
                    assert_eq!(owners.insert(own, name), None, "{own} of {name} is taken");
                }
            }
        }
        let joined = script();
        assert!(!joined.lines().any(|line| line.starts_with("import ") || line.starts_with("export ")));
    }

    /// The name that a line without indentation declares.
    fn declared(line: &str) -> Option<&str> {
        let keywords = ["async function ", "function ", "class ", "const ", "let ", "var "];
        let rest = keywords.iter().find_map(|keyword| line.strip_prefix(keyword))?;
        rest.split(|c: char| c.is_whitespace() || "(={;".contains(c)).next()
    }
}
