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
            &[
                "north, ε = 0.1: empty",
                "north, ε = min (|e| ≤ 1): ",
                "south, ε = 0.1: empty",
                "south, ε = min (|e| ≤ 1): ",
            ],
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
fn a_long_name_is_cut_before_what_is_found() {
    let folder = tempfile::tempdir().unwrap();
    let name = "a long name of a group ".repeat(9);
    let rows: String = (0..12).map(|x| format!("{}{},{x},{}\n", name, x % 4, x * x)).collect();
    fs::write(folder.path().join("long.csv"), format!("g,x,y\n{rows}")).unwrap();
    for (figure, found) in [("sets", "…: empty\n"), ("data", "…: no line\n")] {
        let words = format!("long.csv --x x --y y --eps 1e-7 --by g --figure {figure} --real-text");
        let text = svg(&line(&folder, &words.replace("--figure sets ", "")), 3);
        assert_eq!(text.matches(found).count(), 4, "{words}: {text}");
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
        ("- - --x t --y 2 --eps 2", "'-' is standard input, which is read once, and it is given twice"),
        ("north.csv none.csv --x t --y 2 --eps 2", "none.csv: cannot read"),
        ("cells.csv --x t --y U --eps 2 --by no", "there is no column \"no\""),
    ] {
        let output = plot(&line(&folder, words));
        let message = String::from_utf8_lossy(&output.stderr);
        assert!(matches!(output.status.code(), Some(1 | 2)) && output.stdout.is_empty(), "{words}");
        assert!(message.contains(problem), "{words}: {message}");
    }
}

#[test]
fn units_of_files_are_their_own() {
    let folder = tempfile::tempdir().unwrap();
    for (name, header) in
        [("volts.csv", "x [V],y [m]"), ("millivolts.csv", "x [mV],y [mm]"), ("also.csv", "x [V],y [m]")]
    {
        fs::write(folder.path().join(name), format!("{header}\n0,0\n1,1\n2,2.5\n")).unwrap();
    }
    for (words, named, unnamed) in [
        (
            "volts.csv millivolts.csv --x 1 --y 2 --eps 1",
            &["θ₁ [m/V], θ₁ [mm/mV]", "θ₂ [m], θ₂ [mm]", "Units differ: "][..],
            &["|e|", "of these sets"][..],
        ),
        (
            "volts.csv millivolts.csv --x 1 --y 2 --eps 1 --figure data",
            &["x [V], x [mV]\n", "y [m], y [mm]\n"],
            &["|e|", "[mV] [V]", "[mm] [m]"],
        ),
        ("volts.csv also.csv --x 1 --y 2 --eps 1", &["θ₁ [m/V]\n", "|e| ≤ 1 m\n"], &[]),
        (
            "volts.csv millivolts.csv --x 1 --y 2 --eps 1 --x-unit s --y-unit K",
            &["θ₁ [K/s]\n", "|e| ≤ 1 K\n"],
            &[],
        ),
    ] {
        let text = svg(&line(&folder, &format!("{words} --real-text")), 0);
        assert!(named.iter().all(|expected| text.contains(expected)), "{words}: {text}");
        assert!(!unnamed.iter().any(|other| text.contains(other)), "{words}: {text}");
    }
}

#[test]
fn files_of_one_name_are_told_apart_by_their_folders() {
    let folder = tempfile::tempdir().unwrap();
    let deep = folder.path().join("a-folder-with-a-name-that-is-longer-than-what-a-legend-has-room-for");
    for run in ["first", "second"] {
        fs::create_dir_all(deep.join(run)).unwrap();
        fs::write(deep.join(run).join("log.csv"), "x,y\n0,0\n1,1\n2,2.5\n").unwrap();
    }
    let path = |run: &str| deep.join(run).join("log.csv").display().to_string();
    let text = svg(&format!("{} {} --x x --y y --eps 1", path("first"), path("second")), 0);
    let said = description(&text).replace('\\', "/");
    assert!(said.contains("first/log.csv: polygon") && said.contains("second/log.csv: polygon"), "{said}");
    assert!(!said.contains("a-folder"), "{said}");
}

/// The height at which each of some texts stands.
fn heights(text: &str, part: &str) -> Vec<String> {
    let tags = text
        .split("<text ")
        .skip(1)
        .filter(|tag| tag.split_once('>').is_some_and(|(_, said)| said.trim_start().starts_with(part)));
    tags.map(|tag| tag.split_once("y=\"").unwrap().1.split_once('"').unwrap().0.to_owned()).collect()
}

#[test]
fn long_names_of_groups_stand_as_close_above_their_panels_as_short_ones() {
    let folder = tempfile::tempdir().unwrap();
    let table = |name: &str| {
        let rows: String =
            (0..12).map(|row| format!("{},{},{name}{}\n", row % 3, row % 3, row / 3)).collect();
        fs::write(folder.path().join("groups.csv"), format!("x,y,g\n{rows}")).unwrap();
        let words = "groups.csv --x x --y y --eps 1 --by g --size 85mm --font-size 8pt --real-text";
        let text = svg(&line(&folder, words), 0);
        heights(&text, &name[..4])
    };
    let long = table("name of a sensor that a panel has no room for ");
    assert_eq!((long.len(), long), (4, table("name")));
}

#[test]
fn panels_are_as_wide_as_the_scales_of_their_axes() {
    let folder = tempfile::tempdir().unwrap();
    let rows: String = (0..28)
        .map(|row| format!("1000000.{:04},{}e-5,g{}\n", row % 4 * 7, row % 4 + row / 4, row / 4))
        .collect();
    fs::write(folder.path().join("groups.csv"), format!("x,y,g\n{rows}")).unwrap();
    for (more, panels) in
        [("", 7), (" --size 60mm --font-size 6pt", 7), (" --size 60mm --font-size 6pt --flip", 7)]
    {
        let words = format!("groups.csv --x x --y y --eps 1e-5 --by g --figure data --real-text{more}");
        let text = svg(&line(&folder, &words), 0);
        assert_eq!(heights(&text, "g").len(), panels, "{words}");
        assert!(text.contains("+ 1000000\n"), "{words}");
        let is_cut = |part: &str| part.contains('…') && (part.contains('×') || part.contains("+ 1"));
        assert!(!text.split('<').any(is_cut), "{words}");
        assert_labels_have_room(&text, &words);
    }
}

#[test]
fn bars_and_points_are_called_what_they_are() {
    let folder = tempfile::tempdir().unwrap();
    let rows: String =
        (0..8).map(|row| format!("{row},{row},{},{},g{}\n", row - 1, row + 1, row / 4)).collect();
    fs::write(folder.path().join("groups.csv"), format!("x,y,low,high,g\n{rows}")).unwrap();
    let drawn = |words: &str| svg(&line(&folder, &format!("groups.csv --x x --y y {words} --real-text")), 0);
    assert!(drawn("--lower low --upper high --by g --figure data").contains("bounds of a reading\n"));
    assert!(drawn("--eps 0 --by g --figure data").contains("reading (ε = 0)\n"));
    // The legend of one point has no area.
    assert!(!drawn("--eps 0 --eps min").contains("opacity=\"0.14\""));
}
