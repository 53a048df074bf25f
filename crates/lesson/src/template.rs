//! The page around the data: template, style and script, put into one file.

/// A module of the script: its name and its source.
macro_rules! module {
    ($name:literal) => {
        ($name, include_str!(concat!("../page/js/", $name)))
    };
}

/// The page with the tokens `{{title}}`, `{{style}}`, `{{data}}` and `{{script}}`.
const TEMPLATE: &str = include_str!("../page/index.html");
const STYLE: &str = include_str!("../page/style.css");

/// The script's modules, each after those that it imports; the last one starts everything.
const MODULES: &[(&str, &str)] = &[
    module!("dom.js"),
    module!("rational.js"),
    module!("format.js"),
    module!("ticks.js"),
    module!("axes.js"),
    module!("model.js"),
    module!("summary.js"),
    module!("inspector.js"),
    module!("clipping.js"),
    module!("corridor.js"),
    module!("view.js"),
    module!("data-frame.js"),
    module!("region.js"),
    module!("data-plane.js"),
    module!("sweep.js"),
    module!("epsilon.js"),
    module!("parameter-view.js"),
    module!("interaction.js"),
    module!("introduction.js"),
    module!("layers.js"),
    module!("leave-one-out.js"),
    module!("vertex-marks.js"),
    module!("parameter-plane.js"),
    module!("questions.js"),
    module!("state.js"),
    module!("main.js"),
];

/// The page with a title and data in JSON.
pub(crate) fn page(title: &str, data: &str) -> String {
    fill(TEMPLATE, |token| match token {
        "title" => Some(escaped(title)),
        "style" => Some(STYLE.to_owned()),
        "data" => Some(embedded(data)),
        "script" => Some(script(MODULES)),
        _ => None,
    })
}

/// Replaces each `{{token}}` that has a value. What is put in is not looked at again.
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

/// Text as HTML.
fn escaped(text: &str) -> String {
    let mut html = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => html.push_str("&amp;"),
            '<' => html.push_str("&lt;"),
            '>' => html.push_str("&gt;"),
            '"' => html.push_str("&quot;"),
            '\'' => html.push_str("&#39;"),
            _ => html.push(letter),
        }
    }
    html
}

/// JSON that cannot end the element that it is in. `<` occurs in its strings only, where an escape means the same.
fn embedded(json: &str) -> String {
    json.replace('<', "\\u003c").replace('\u{2028}', "\\u2028").replace('\u{2029}', "\\u2029")
}

/// Modules as one: without imports and the word `export`, as all of them share one scope.
fn script(modules: &[(&str, &str)]) -> String {
    let mut script = String::new();
    for (name, source) in modules {
        script.push_str(&format!("// {name}\n"));
        for line in source.lines().filter(|line| !line.starts_with("import ")) {
            script.push_str(line.strip_prefix("export ").unwrap_or(line));
            script.push('\n');
        }
    }
    script
}

#[cfg(test)]
mod tests {
    use std::collections::HashMap;

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
        let text = page("</title><b>&", "{\"a\": \"</script>\u{2028}\"}");
        assert!(text.contains("<title>&lt;/title&gt;&lt;b&gt;&amp;</title>"));
        assert!(text.contains("{\"a\": \"\\u003c/script>\\u2028\"}"));
        for source in MODULES.iter().map(|(_, source)| *source).chain([STYLE]) {
            assert!(!source.contains("</script") && !source.contains("</style") && !source.contains("<!--"));
        }
    }

    #[test]
    fn each_token_occurs_once() {
        for token in ["{{title}}", "{{style}}", "{{data}}", "{{script}}"] {
            assert_eq!(TEMPLATE.matches(token).count(), 1, "{token}");
        }
    }

    #[test]
    fn every_module_of_the_folder_is_joined_and_the_main_one_comes_last() {
        let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("page/js");
        let entries = std::fs::read_dir(folder).unwrap();
        let mut files: Vec<String> =
            entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        let mut joined: Vec<&str> = MODULES.iter().map(|(name, _)| *name).collect();
        assert_eq!(joined.last(), Some(&"main.js"));
        files.sort();
        joined.sort_unstable();
        assert_eq!(joined, files);
    }

    #[test]
    fn imports_take_exported_names_from_modules_that_come_before() {
        let mut exported: HashMap<&str, Vec<&str>> = HashMap::new();
        for (name, source) in MODULES {
            for line in source.lines().filter(|line| line.trim_start().starts_with("import")) {
                let parts = line.strip_prefix("import { ").and_then(|rest| rest.strip_suffix(".js\";"));
                let (names, from) = parts.and_then(|rest| rest.split_once(" } from \"./")).expect(line);
                let known =
                    exported.get(format!("{from}.js").as_str()).unwrap_or_else(|| panic!("{name}: {line}"));
                for import in names.split(", ") {
                    assert!(known.contains(&import), "{name}: {import} of {from}");
                }
            }
            let exports = source.lines().filter_map(|line| declared(line.strip_prefix("export ")?));
            exported.insert(*name, exports.collect());
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
        let joined = script(MODULES);
        assert!(!joined.lines().any(|line| line.starts_with("import ") || line.starts_with("export ")));
    }

    /// The name that a line without indentation declares.
    fn declared(line: &str) -> Option<&str> {
        let keywords = ["async function ", "function ", "class ", "const ", "let ", "var "];
        let rest = keywords.iter().find_map(|keyword| line.strip_prefix(keyword))?;
        rest.split(|c: char| c.is_whitespace() || "(={;".contains(c)).next()
    }
}
