//! No file of a crate needs itself, through whichever others.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;

use boundfit_tests::program::root;

use super::sources::lines_of_code;

/// A module as the names on the way to it, from the root of its crate.
type Module = Vec<String>;
/// Modules with their code.
type Code = BTreeMap<Module, String>;

/// The modules of a crate, each a file.
fn modules(name: &str) -> Code {
    let folder = root().join("crates").join(name).join("src");
    let mut modules = Code::new();
    for (place, line) in lines_of_code(&folder) {
        let file = place.strip_prefix(folder.to_str().unwrap()).unwrap();
        let (file, _) = file.rsplit_once(".rs:").unwrap();
        let mut module: Module = file.trim_start_matches('/').split('/').map(str::to_owned).collect();
        if module.last().is_some_and(|last| ["mod", "lib", "main"].contains(&last.as_str())) {
            module.pop();
        }
        let (code, _) = line.split_once("//").unwrap_or((&line, ""));
        *modules.entry(module).or_default() += &format!("{code} ");
    }
    modules
}

/// The paths of a `use`, without what its braces have in common.
fn paths(text: &str) -> Vec<Module> {
    let (mut depth, mut parts) = (0, vec![String::new()]);
    for letter in text.chars() {
        depth += i32::from(letter == '{') - i32::from(letter == '}');
        match (letter, depth) {
            (',', 0) => parts.push(String::new()),
            _ => parts.last_mut().unwrap().push(letter),
        }
    }
    let names = |text: &str| -> Module {
        let (text, _) = text.split_once(" as ").unwrap_or((text, ""));
        text.split("::").map(|name| name.trim().to_owned()).filter(|name| !name.is_empty()).collect()
    };
    let expanded = |part: &String| match part.trim().strip_suffix('}').and_then(|part| part.split_once('{')) {
        Some((start, inner)) => {
            let start = names(start);
            paths(inner).into_iter().map(|rest| [start.clone(), rest].concat()).collect()
        }
        None => vec![names(part)],
    };
    parts.iter().flat_map(expanded).filter(|path| !path.is_empty()).collect()
}

/// The paths that a module imports or spells out, and those that it hands on.
fn uses(code: &str) -> (Vec<Module>, Vec<Module>) {
    let (mut needed, mut handed_on) = (Vec::new(), Vec::new());
    for statement in code.split(';') {
        let (before, path) = statement.rsplit_once("use ").unwrap_or((statement, ""));
        let visibility = before.rsplit(['{', '}', ']']).next().unwrap_or_default().trim();
        let others = match visibility {
            "" => {
                needed.extend(paths(path));
                before
            }
            _ if visibility.starts_with("pub") => {
                handed_on.extend(paths(path));
                before
            }
            _ => statement,
        };
        let is_path = |letter: char| letter.is_alphanumeric() || "_:".contains(letter);
        let words = others.split(|letter| !is_path(letter));
        let spelt = words.filter(|word| word.starts_with("crate::") || word.starts_with("super::"));
        needed.extend(spelt.flat_map(paths));
    }
    // Modules within a file import `super::*` from it.
    needed.retain(|path| *path != ["super", "*"]);
    (needed, handed_on)
}

/// The module that defines what a path names, seen from another one: through all that hand it on.
fn home(code: &Code, from: &Module, path: &[String]) -> Option<Module> {
    let below = |base: &Module, name: &String| [base.as_slice(), std::slice::from_ref(name)].concat();
    let (mut base, mut rest) = match path.first()?.as_str() {
        "crate" => (Module::new(), &path[1..]),
        "self" => (from.clone(), &path[1..]),
        "super" => (from.clone(), path),
        _ if code.contains_key(&below(from, &path[0])) => (from.clone(), path),
        _ => return None,
    };
    while rest.first().is_some_and(|name| name == "super") {
        base.pop()?;
        rest = &rest[1..];
    }
    while let Some(name) = rest.first().filter(|name| code.contains_key(&below(&base, name))) {
        (base, rest) = (below(&base, name), &rest[1..]);
    }
    let Some(name) = rest.first() else { return Some(base) };
    let (_, handed_on) = uses(code.get(&base)?);
    let origin =
        handed_on.iter().find(|path| path.last() == Some(name)).and_then(|path| home(code, &base, path));
    Some(origin.unwrap_or(base))
}

/// Returns the modules that each module needs. A module does not need those below it that it hands on.
fn arrows(code: &Code) -> BTreeMap<Module, BTreeSet<Module>> {
    let of_module = |(module, text): (&Module, &String)| {
        let (needed, handed_on) = uses(text);
        let homes = |paths: Vec<Module>| paths.into_iter().filter_map(|path| home(code, module, &path));
        let needed = homes(needed).chain(homes(handed_on).filter(|other| !other.starts_with(module)));
        (module.clone(), needed.filter(|needed| needed != module).collect())
    };
    code.iter().map(of_module).collect()
}

/// The modules that need themselves through others.
fn circles(arrows: &BTreeMap<Module, BTreeSet<Module>>) -> Vec<String> {
    let is_round = |(module, _): &(&Module, &BTreeSet<Module>)| {
        let (mut reached, mut open) = (BTreeSet::new(), vec![*module]);
        while let Some(next) = open.pop() {
            open.extend(arrows[next].iter().filter(|needed| reached.insert(*needed)));
        }
        reached.contains(module)
    };
    let named =
        |(module, _): (&Module, _)| if module.is_empty() { "lib".to_owned() } else { module.join("/") };
    arrows.iter().filter(is_round).map(named).collect()
}

#[test]
fn no_file_of_a_crate_needs_itself_through_others() {
    let (mut count, mut found) = (0, Vec::new());
    for entry in fs::read_dir(root().join("crates")).unwrap() {
        let name = entry.unwrap().file_name().to_string_lossy().into_owned();
        let arrows = arrows(&modules(&name));
        count += arrows.values().map(BTreeSet::len).sum::<usize>();
        found.extend(circles(&arrows).into_iter().map(|file| format!("{name}/{file}")));
    }
    assert!(found.is_empty(), "these files need themselves: {}", found.join(", "));
    assert!(count > 1000, "{count}");
}

#[test]
fn a_circle_is_found_through_names_that_are_handed_on() {
    let code = |files: &[(&str, &str)]| -> Code {
        let module =
            |name: &str| name.split('/').filter(|name| !name.is_empty()).map(str::to_owned).collect();
        files.iter().map(|(name, text)| (module(name), (*text).to_owned())).collect()
    };
    let files = [
        ("", "pub use a::{A, B as C}; "),
        ("a", "mod b; pub(crate) use b::B; use crate::c::{self, C}; pub struct A; "),
        ("a/b", "use std::fmt; pub struct B; "),
        ("c", "fn c() -> crate::a::B { } "),
    ];
    // A name that `a` only hands on is a name of `b`.
    assert!(circles(&arrows(&code(&files))).is_empty());
    let mut round = files;
    round[3].1 = "use super::{a::{A}, d}; ";
    assert_eq!(circles(&arrows(&code(&round))), ["a", "c"]);
    round[3].1 = "fn c() -> super::a::A { } ";
    assert_eq!(circles(&arrows(&code(&round))), ["a", "c"]);
}
