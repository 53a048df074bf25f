use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use serde_json::json;

use super::message::{Part, parts};
use super::*;

/// The folder with the sources of the page.
fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("page")
}

/// The files below a folder that end so, with their text.
fn files(folder: &Path, end: &str) -> Vec<(String, String)> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        if path.is_dir() {
            found.extend(files(&path, end));
        } else if name.ends_with(end) {
            found.push((name, fs::read_to_string(&path).unwrap()));
        }
    }
    found.sort();
    found
}

#[test]
fn every_file_of_the_table_is_read_and_no_key_is_there_twice() {
    let written: Vec<String> =
        files(&folder().join("texts"), ".json").into_iter().map(|(name, _)| name).collect();
    let mut known: Vec<String> = PARTS.iter().map(|(name, _)| format!("{name}.json")).collect();
    known.sort();
    assert_eq!(known, written);
    let keys: usize =
        PARTS.iter().map(|(name, part)| read(part).unwrap_or_else(|e| panic!("{name}: {e}")).len()).sum();
    assert_eq!(TABLE.len(), keys);
    for (name, part) in PARTS {
        // The reader of JSON keeps the last of several equal keys.
        let lines = part.lines().filter(|line| line.starts_with("  \"")).count();
        assert_eq!(read(part).unwrap().len(), lines, "{name}");
    }
}

/// The places for values in a text, and its mark-up, each once.
fn places(parts: &[Part]) -> BTreeSet<String> {
    let of_part = |part: &Part| match part {
        Part::Plain(_) => BTreeSet::new(),
        Part::Value { name, forms, .. } => {
            let mut places: BTreeSet<String> = forms.iter().flat_map(|form| self::places(form)).collect();
            places.insert(name.clone());
            places
        }
        Part::Tag { tag, parts } => {
            let mut places = self::places(parts);
            places.insert(format!("<{tag}>"));
            places
        }
    };
    parts.iter().flat_map(of_part).collect()
}

#[test]
fn every_text_is_there_in_every_language_with_the_same_places() {
    let codes: BTreeSet<&str> = Language::ALL.map(Language::code).into();
    for (key, texts) in TABLE.iter() {
        assert_eq!(texts.keys().map(String::as_str).collect::<BTreeSet<_>>(), codes, "{key}");
        let places: BTreeSet<BTreeSet<String>> = texts.values().map(|text| places(&parts(text))).collect();
        assert_eq!(places.len(), 1, "{key}: {places:?}");
        for text in texts.values() {
            let is_edge = |edge: Option<char>| edge.is_some_and(|letter| letter == ' ');
            assert!(
                key.starts_with("list.") || !is_edge(text.chars().next()) && !is_edge(text.chars().last()),
                "{key}: {text:?}"
            );
            for (open, close) in [('{', '}'), ('<', '>')] {
                assert_eq!(text.matches(open).count(), text.matches(close).count(), "{key}: {text}");
            }
            assert_eq!(text.matches('<').count(), 2 * text.matches("</").count(), "{key}: {text}");
            assert!(!text.contains(['&', '\'']), "{key}: {text}");
        }
    }
}

#[test]
fn a_language_addresses_the_reader_in_one_way() {
    let others = [
        // German says Sie, or uses an infinitive.
        (
            Language::German,
            &["du", "dein", "deine", "betrachte", "berechne", "vergleiche", "zeichne", "skizziere"][..],
        ),
        // Italian uses an infinitive, and the second person singular on buttons. A boundary is a bordo.
        (Language::Italian, &["spostate", "inventate", "aprite", "scrivete", "frontiera", "frontiere"]),
    ];
    for (key, texts) in TABLE.iter() {
        for (language, others) in others {
            let text = texts[language.code()].to_lowercase();
            let mut words = text.split(|letter: char| !letter.is_alphabetic());
            assert!(!words.any(|word| others.contains(&word)), "{key}: {text}");
        }
    }
}

/// Returns the texts that may be keys: in quotation marks, or the start of one that is put together.
fn mentioned(source: &str) -> (BTreeSet<&str>, BTreeSet<&str>) {
    let is_key = |text: &&str| {
        let is_word = |word: &str| word.starts_with(|c: char| c.is_ascii_lowercase());
        text.contains('.')
            && text.split('.').next().is_some_and(is_word)
            && text.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || "-.".contains(c))
    };
    let (some, whole): (BTreeSet<&str>, BTreeSet<&str>) =
        source.split('"').filter(is_key).partition(|text| text.ends_with('.'));
    let put_together = source.split('"').filter_map(|text| text.strip_suffix("{}"));
    let starts = source.split('`').filter_map(|text| text.split_once("${")).map(|(start, _)| start);
    (whole, some.into_iter().chain(starts.chain(put_together).filter(is_key)).collect())
}

#[test]
fn every_key_is_used_and_every_used_key_is_there() {
    let mut sources = files(&folder().join("js"), ".js");
    sources.push(("index.html".to_owned(), fs::read_to_string(folder().join("index.html")).unwrap()));
    sources.extend(files(&folder().join("../src"), ".rs").into_iter().filter(|(name, _)| name != "tests.rs"));
    let mut used = BTreeSet::new();
    let mut starts = BTreeSet::new();
    for (name, source) in &sources {
        let (whole, some) = mentioned(source);
        for key in whole {
            let is_name = [".js", ".json", ".csv", ".css", ".html", ".rs", "boundfit.", "1.", "0."];
            if TABLE.contains_key(key) {
                used.insert(key);
            } else if name.ends_with(".js") && !is_name.iter().any(|part| key.contains(part)) {
                panic!("{name}: no text has the key {key}");
            }
        }
        starts.extend(some);
    }
    let html = &sources.iter().find(|(name, _)| name == "index.html").unwrap().1;
    for mark in ["data-text=\"", "data-text-label=\""] {
        for key in html.split(mark).skip(1).map(|rest| rest.split('"').next().unwrap()) {
            assert!(TABLE.contains_key(key), "index.html: no text has the key {key}");
        }
    }
    for key in TABLE.keys() {
        let is_used = used.contains(key.as_str()) || starts.iter().any(|start| key.starts_with(start));
        assert!(is_used, "nothing uses {key}");
    }
    for start in starts {
        assert!(TABLE.keys().any(|key| key.starts_with(start)), "no key begins with {start}");
    }
}

#[test]
fn lists_and_counts_are_said_in_every_language() {
    let list = json!({"list": ["a", {"number": "-1.5"}, 3]});
    let said = |language| said(&list, language);
    assert_eq!(said(Language::English), "a, -1.5 and 3");
    assert_eq!(said(Language::Italian), "a, -1,5 e 3");
    assert_eq!(said(Language::German), "a, -1,5 und 3");
    let long = json!({"list": [1, 2], "more": 5});
    assert_eq!(super::said(&long, Language::English), "1, 2 and 5 more");
    assert_eq!(super::said(&json!({"text": "no such key"}), Language::German), "no such key");
    assert_eq!(super::said(&json!(null), Language::German), "");
}

/// The texts in quotation marks of a script, comments and the code within templates left out.
fn literals(source: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut letters = source.chars().peekable();
    // Templates that are open, each with the braces open in its code.
    let mut templates: Vec<usize> = Vec::new();
    let mut open: Option<(char, String)> = None;
    let mut last = '(';
    while let Some(letter) = letters.next() {
        let before = last;
        last = if letter.is_whitespace() { last } else { letter };
        if let Some((quote, mut text)) = open.take() {
            if letter == '\\' {
                text.extend(letters.next());
            } else if quote == '`' && letter == '$' && letters.peek() == Some(&'{') {
                letters.next();
                templates.push(0);
                found.push(text);
                continue;
            } else if letter == quote {
                found.push(text);
                continue;
            } else {
                text.push(letter);
            }
            open = Some((quote, text));
            continue;
        }
        match (letter, letters.peek()) {
            ('/', Some('/')) => while letters.next_if(|letter| *letter != '\n').is_some() {},
            ('/', Some('*')) => {
                let mut previous = ' ';
                for next in letters.by_ref() {
                    if previous == '*' && next == '/' {
                        break;
                    }
                    previous = next;
                }
            }
            // A slash behind what cannot end a value begins a regular expression.
            ('/', _) if "(,=:[!&|?{;".contains(before) => {
                let mut in_class = false;
                while let Some(next) = letters.next() {
                    match next {
                        '\\' => drop(letters.next()),
                        '[' => in_class = true,
                        ']' => in_class = false,
                        '/' if !in_class => break,
                        _ => {}
                    }
                }
            }
            ('"' | '`' | '\'', _) => open = Some((letter, String::new())),
            ('{', _) => templates.iter_mut().last().into_iter().for_each(|braces| *braces += 1),
            ('}', _) => match templates.last_mut() {
                Some(0) => {
                    templates.pop();
                    open = Some(('`', String::new()));
                }
                Some(braces) => *braces -= 1,
                None => {}
            },
            _ => {}
        }
    }
    found
}

/// Returns whether a literal is words for the reader: several with a mark or a capital letter among them, or one with a capital letter.
fn is_wording(literal: &str) -> bool {
    const KEYS: [&str; 9] =
        ["Arrow", "Escape", "Enter", "Home", "End", "Page", "Delete", "Backspace", "Worker"];
    let is_word = |word: &&str| word.chars().filter(|c| c.is_alphabetic()).count() > 1;
    let words = literal.split_whitespace().filter(is_word).count();
    let begins_large = literal.starts_with(|c: char| c.is_ascii_uppercase())
        && literal.chars().nth(1).is_some_and(|c| c.is_ascii_lowercase());
    let marks = literal.ends_with(['.', '?', '!', ':']) || literal.contains(". ") || literal.contains(", ");
    let small = [" of ", " the ", " is ", " are ", " no ", " at ", " to ", " and "];
    (words > 1 && (marks || begins_large || small.iter().any(|word| format!(" {literal} ").contains(word))))
        || (words == 1 && begins_large && !KEYS.iter().any(|key| literal.starts_with(key)))
}

#[test]
fn no_words_are_left_in_the_scripts() {
    assert_eq!(
        literals("a(`x ${b(\"y\", { c: `z` }, /[\"/]\"/)} w`); // \"no\"\n\"\\\"v\""),
        ["x ", "y", "z", " w", "\"v"]
    );
    assert!(
        ["Forward", "It is.", "None of them", "reading of", "a polygon is"]
            .map(is_wording)
            .iter()
            .all(|is| *is)
    );
    assert!(
        !["bound current", "ArrowUp", "M-20 0H-4", "translate(-99 -99)", "url(#hatch)"]
            .iter()
            .any(|text| is_wording(text))
    );
    let mut left = Vec::new();
    for (name, source) in files(&folder().join("js"), ".js") {
        left.extend(
            literals(&source)
                .into_iter()
                .filter(|text| is_wording(text))
                .map(|text| format!("{name}: {text}")),
        );
    }
    assert_eq!(left, Vec::<String>::new());
}
