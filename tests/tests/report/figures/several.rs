//! Several files, error bounds and groups in one picture.

use std::fs;

use super::geometry::assert_labels_have_room;
use super::{plot, svg};

/// Three files whose sets are apart, and one in another, and a table with groups, in a folder.
fn tables() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let table = |name: &str, slope: i64, offset: i64| {
        let rows: String = (0..9).map(|x| format!("{x},{}\n", slope * x + offset + (x * 7 % 3))).collect();
        fs::write(folder.path().join(name), format!("t,U (V)\n{rows}")).unwrap();
    };
    table("north.csv", 2, 5);
    table("south.csv", 3, -4);
    table("far.csv", -8, 90);
    let groups: String = (0..30)
        .flat_map(|group| (0..5).map(move |x| format!("c_{group:02},{x},{}\n", group % 7 * x + x * 5 % 3)))
        .collect();
    fs::write(folder.path().join("cells.csv"), format!("cell,t,U\n{groups}")).unwrap();
    folder
}

/// Words in the folder of tables: names of files get its path.
fn line(folder: &tempfile::TempDir, words: &str) -> String {
    let path = |word: &str| match word.ends_with(".csv") {
        true => folder.path().join(word).display().to_string(),
        false => word.to_owned(),
    };
    words.split(' ').map(path).collect::<Vec<_>>().join(" ")
}

fn description(svg: &str) -> &str {
    svg.split_once("<desc>").unwrap().1.split_once("</desc>").unwrap().0
}

#[test]
fn legends_name_each_file_and_bound_and_say_which_sets_are_empty() {
    let folder = tables();
    for (words, status, expected) in [
        (
            "north.csv south.csv --x t --y 2 --eps 2",
            0,
            &["north: polygon with", "south: polygon with", "No parameters are in all of these sets."][..],
        ),
        (
            "north.csv --x t --y 2 --eps 0.9 --eps 2 --eps 5/2",
            3,
            &[
                "ε = 0.9: empty, rows",
                "contradict each other; ε = 2: polygon",
                "ε = 5/2: polygon",
                "In all sets that are not empty: ",
            ],
        ),
        (
            "north.csv south.csv --x t --y 2 --eps 0.1 --eps min",
            3,
            &["north, ε = 0.1: empty", "north, ε = min: ", "south, ε = 0.1: empty", "south, ε = min: "],
        ),
        (
            "north.csv south.csv far.csv --x t --y 2 --eps 2 --figure data",
            0,
            &["north: 9 readings, least-squares line; south: 9 readings", "far: 9 readings"],
        ),
        ("north.csv --x t --y 2 --eps 2 --eps 0.5 --figure data", 3, &["ε = 0.5: 9 readings", "empty, rows"]),
    ] {
        let text = svg(&line(&folder, words), status);
        let said = description(&text);
        assert!(expected.iter().all(|expected| said.contains(expected)), "{words}: {said}");
        // The legend says as much, of each.
        let real = svg(&line(&folder, &format!("{words} --real-text")), status);
        let named = said
            .split(['.', ';'])
            .filter_map(|part| part.trim().split_once(": "))
            .filter(|(name, _)| name.starts_with("north") || name.starts_with('ε'));
        for (name, _) in named {
            assert!(real.contains(&format!("{name}: ")), "{words}: {name}");
        }
    }
}

#[test]
fn what_lines_look_like_differs_in_greys_too() {
    let folder = tables();
    let words = "north.csv south.csv far.csv --x t --y 2 --eps 2 --eps 3 --greyscale --format tikz";
    let source = svg(&line(&folder, words), 0);
    let edges: Vec<&str> = source
        .lines()
        .filter(|line| line.contains("/.style={draw=") && line.contains("% "))
        .filter_map(|line| line.split_once("line width").map(|(_, rest)| rest.split('%').next().unwrap()))
        .collect();
    assert_eq!(edges.len(), 6, "{source}");
    for (index, edge) in edges.iter().enumerate() {
        assert!(!edges[..index].contains(edge), "{edge}");
    }
}

#[test]
fn groups_stand_in_panels_with_the_same_axes_in_the_order_of_rows() {
    let folder = tables();
    for (words, panels) in [
        ("cells.csv --x t --y U --eps 2 --by cell", 24),
        ("cells.csv --x t --y U --eps 2 --by cell --figure data", 24),
        ("cells.csv --x t --y U --eps 2 --by cell --rows 1..20 --figure data --flip", 4),
        ("cells.csv --x t --y U --eps 2 --by cell --rows 1..5", 1),
        ("cells.csv --x t --y U --eps 2 --by cell --size 85mm --font-size 8pt", 24),
    ] {
        let text = svg(&line(&folder, &format!("{words} --real-text")), 0);
        let place = |group: usize| text.find(&format!("c_{group:02}\n"));
        assert!((0..panels).all(|group| place(group).is_some()), "{words}");
        assert!(place(panels).is_none(), "{words}");
        let order: Vec<Option<usize>> = (0..panels).map(place).collect();
        assert!(order.is_sorted(), "{words}");
        let more = "Drawn are the first 24 of 30 groups, in the order of rows.";
        assert_eq!(text.contains(more), panels == 24, "{words}");
        assert_labels_have_room(&text, words);
    }
}

#[test]
fn an_empty_group_is_told() {
    let folder = tables();
    let text = svg(&line(&folder, "cells.csv --x t --y U --eps 0.1 --by cell --rows 1..10 --real-text"), 3);
    assert!(
        text.contains("c_00: empty") && text.contains("No parameters agree with all readings of 2 groups."),
        "{text}"
    );
}

#[test]
fn labels_of_several_fits_have_room() {
    let folder = tables();
    for words in [
        "north.csv south.csv far.csv --x t --y 2 --eps 2",
        "north.csv south.csv far.csv --x t --y 2 --eps 2 --figure data",
        "north.csv south.csv far.csv --x t --y 2 --eps 2 --figure data --flip",
        "north.csv --x t --y 2 --eps 0.9 --eps 2 --eps 5/2 --eps 3 --eps 4 --eps 5",
        "north.csv south.csv --x t --y 2 --eps 2 --size 85mm --font-size 8pt",
    ] {
        let output = plot(&line(&folder, &format!("{words} --real-text")));
        assert_labels_have_room(&String::from_utf8(output.stdout).unwrap(), words);
    }
}

#[test]
fn vertices_of_compared_sets_are_those_of_each_alone() {
    // Panels of one file and of the same file beside itself have the same window, and so the same outline.
    let folder = tables();
    let area = |text: &str, colour: &str| {
        let areas = text.split("<polygon ").skip(1).filter(|tag| tag.contains(colour));
        areas.map(|tag| tag.split_once("points=\"").unwrap().1.split_once('"').unwrap().0.to_owned()).next()
    };
    let range = "--x-range 0..4 --y-range -10..10 --real-text";
    let one = svg(&line(&folder, &format!("north.csv --x t --y 2 --eps 2 {range}")), 0);
    let both = svg(&line(&folder, &format!("north.csv south.csv --x t --y 2 --eps 2 {range}")), 0);
    let corners = |text: &str| area(text, "#0072B2").map(|points| points.split_whitespace().count());
    assert!(corners(&one).is_some_and(|count| count > 2));
    assert_eq!(corners(&one), corners(&both));
}

#[test]
fn what_is_not_drawn_of_several_is_refused() {
    let folder = tables();
    for (words, problem) in [
        (
            "north.csv south.csv --x t --y 2 --eps 2 --figure eui",
            "several files are drawn in one panel: with '--figure fps' or '--figure data'",
        ),
        (
            "north.csv --x t --y 2 --eps 2 --eps 3 --figure all -o out",
            "several '--eps' are drawn in one panel: with '--figure fps' or '--figure data'",
        ),
        (
            "north.csv south.csv --x t --y 2 --eps 2 --sweep 1..2",
            "several files are drawn in one panel, without '--x-eps', '--x-eps-column' and '--sweep'",
        ),
        (
            "north.csv south.csv --x t --y 2 --eps 2 --x-eps 1",
            "several files are drawn in one panel, without '--x-eps', '--x-eps-column' and '--sweep'",
        ),
        (
            "cells.csv --x t --y U --eps 2 --by cell --figure corridor",
            "'--by' draws a panel for each group of rows: with '--figure fps' or '--figure data'",
        ),
        (
            "cells.csv --x t --y U --eps 2 --eps 3 --by cell",
            "'--by' is about the groups of one file under one '--eps', and there are several",
        ),
        ("cells.csv --x t --y U --eps 2 --by cell --sweep 1..2", "cannot be used with"),
        (
            "north.csv south.csv far.csv --x t --y 2 --eps 2 --eps 3 --eps 4",
            "9 fits are too many to be told apart in one panel (expected at most 6 files, error bounds, or pairs of them)",
        ),
        ("north.csv none.csv --x t --y 2 --eps 2", "none.csv: cannot read"),
        ("cells.csv --x t --y U --eps 2 --by no", "there is no column \"no\""),
    ] {
        let output = plot(&line(&folder, words));
        let message = String::from_utf8_lossy(&output.stderr);
        assert!(matches!(output.status.code(), Some(1 | 2)) && output.stdout.is_empty(), "{words}");
        assert!(message.contains(problem), "{words}: {message}");
    }
}
