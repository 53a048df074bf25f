//! The properties of every picture.

use std::fs;

use boundfit_tests::program::root;
use resvg::tiny_skia::Pixmap;
use resvg::usvg::{Options, Tree};

use super::{KINDS, TRANSDUCER, of_kind, picture, svg};

const FIGURES: [&str; 7] = ["data", "eui", "pui", "fps", "corridor", "directions", "status"];

/// Fits that have little in common.
fn fits() -> Vec<(String, i32)> {
    let more = [
        ("two-regressors.csv --x u,v --y y --eps 0.3", 0),
        ("two-regressors.csv --x u,v --y y --eps 0.2", 3),
        ("one-bound-per-row.csv --x x --y y --eps-column e", 0),
        ("two-readings.csv --x x --y y --eps 1e-300", 0),
        ("contradicting.csv --x x --y y --eps 0 --rows 2..2", 0),
        ("nothing.csv --x u,v --y y --eps 1 --where theta1>=2 --where theta1<=1", 3),
        ("nothing.csv --x u,v --y y --eps 1 --where 0*theta1<=-1", 3),
        ("twice-at-zero.csv --x x --y y --eps 0.05 --rows 1..2", 3),
    ];
    let kinds = KINDS.map(|(_, fit, status)| (fit, status));
    kinds.into_iter().chain(more).map(|(fit, status)| (of_kind(fit), status)).collect()
}

/// Draws the paths of an SVG again, as any other program would, without a font.
fn drawn_again(svg: &str) -> Tree {
    Tree::from_str(svg, &Options::default()).unwrap()
}

#[test]
fn every_figure_of_every_fit_is_a_whole_picture() {
    for (fit, status) in fits() {
        for figure in FIGURES {
            let line = format!("{fit} --figure {figure}");
            let text = svg(&line, status);
            for foreign in ["<text", "font-family", "href", "NaN", "inf"] {
                assert!(!text.contains(foreign), "{line}: {foreign}");
            }
            assert!(text.starts_with("<svg ") && text.contains(" viewBox=\"0 0 800 "), "{line}");
            assert!(text.contains("<title>") && text.contains("<desc>"), "{line}");
            let size = drawn_again(&text).size();
            assert_eq!(size.width(), 800.0, "{line}");
            assert!(text.len() < 250_000, "{line}: {} bytes", text.len());
        }
    }
}

#[test]
fn both_encodings_show_the_same() {
    for line in [TRANSDUCER.to_owned(), format!("{TRANSDUCER} --figure data --flip")] {
        let tree = drawn_again(&svg(&line, 0));
        let png = Pixmap::decode_png(&picture(&format!("{line} --format png"), 0)).unwrap();
        let size = tree.size();
        assert_eq!((png.width(), png.height()), (1600, (size.height() * 2.0).round() as u32), "{line}");
        let mut again = Pixmap::new(png.width(), png.height()).unwrap();
        let scale = resvg::tiny_skia::Transform::from_scale(2.0, 2.0);
        resvg::render(&tree, scale, &mut again.as_mut());
        // Outlines of letters are rounded to a tenth of a pixel in the SVG; nothing else differs.
        let pairs = png.data().iter().zip(again.data());
        let different = pairs.filter(|(one, other)| one.abs_diff(**other) > 64).count();
        assert!(different * 1000 < png.data().len(), "{line}: {different} bytes");
    }
}

#[test]
fn the_same_bytes_on_every_run() {
    for format in ["svg", "png"] {
        let line = format!("{TRANSDUCER} --figure corridor --format {format}");
        assert_eq!(picture(&line, 0), picture(&line, 0), "{line}");
    }
}

#[test]
fn conflicting_rows_are_named_in_every_figure() {
    for figure in FIGURES {
        let text = svg(&of_kind(&format!("contradicting.csv --x x --y y --eps 0.3 --figure {figure}")), 3);
        assert!(text.contains("Rows 1, 2 and 3 contradict each other."), "{figure}");
    }
    let conditions = "nothing.csv --x u,v --y y --eps 1 --where theta1>=2 --where theta1<=1";
    assert!(svg(&of_kind(conditions), 3).contains("Conditions 1 and 2 contradict each other."));
}

#[test]
fn titles_say_what_is_there() {
    let two = "two-readings.csv --x x --y y --eps 0.1";
    for (fit, status, title) in [
        (format!("{two} --where theta1<=0"), 3, "Readings and conditions that no line can meet together"),
        (
            "one-reading.csv --x x --y y --eps 0.1 --where theta1>=1 --where theta1<=0".to_owned(),
            3,
            "Readings, and conditions that contradict each other",
        ),
        (format!("{two} --where 0*theta1>=1"), 3, "Readings, and a condition that no line can meet"),
        ("contradicting.csv --x x --y y --eps 0.5".to_owned(), 3, "Readings that no line can explain"),
        ("one-reading.csv --x x --y y --eps 0.1".to_owned(), 0, "Readings and minimax line"),
        (two.to_owned(), 0, "Readings and least-squares line"),
    ] {
        let text = svg(&of_kind(&format!("{fit} --figure data")), status);
        let found = text.split("<title>").nth(1).and_then(|rest| rest.split("</title>").next());
        assert_eq!(found, Some(title.replace('<', "&lt;").as_str()), "{fit}");
    }
}

#[test]
fn titles_and_names_from_outside_stay_harmless() {
    let folder = tempfile::tempdir().unwrap();
    let data = folder.path().join("odd.csv");
    fs::write(&data, "\"<x&\u{7f}\",\"]]> y \u{202e}\u{1F600}\"\n1,2\n2,3\n4,4\n").unwrap();
    let line = format!(
        "{} --header yes --x 1 --y 2 --eps 1 --figure data --x-unit <V> --title a&b<i>",
        data.display()
    );
    let text = svg(&line, 0);
    assert!(text.contains("<title>a&amp;b&lt;i&gt;</title>"));
    drawn_again(&text);
}

#[test]
fn many_rows_make_no_large_files() {
    let folder = tempfile::tempdir().unwrap();
    for count in [1_000_usize, 100_000] {
        let data = folder.path().join("many.csv");
        // A walk through residues spreads like noise and is the same everywhere.
        let noise = |k: usize| (k * 7919 + k * k % 104_729) % 4001;
        let row = |k: usize| format!("{}e-3,{}e-4\n", k * 10_000 / count, k * 180_000 / count + noise(k));
        let rows: String = (0..count).map(row).collect();
        fs::write(&data, format!("t,U\n{rows}")).unwrap();
        let fit = format!("{} --x t --y U --eps 0.25", data.display());
        for figure in ["corridor", "fps"] {
            for format in ["svg", "png"] {
                let bytes = picture(&format!("{fit} --figure {figure} --format {format}"), 0).len();
                assert!(bytes < 1_000_000, "{count} rows, {figure}, {format}: {bytes} bytes");
            }
        }
    }
}

/// All of very many readings wait in their columns. Where rows are chosen, even if these are all, each reading is held as numbers.
#[test]
fn readings_that_wait_in_columns_are_drawn_as_others_are() {
    let folder = tempfile::tempdir().unwrap();
    let data = folder.path().join("many.csv");
    let count = 10_500_usize;
    let noise = |k: usize| (k * 7919 + k * k % 104_729) % 4001;
    // Short decimals, few steps of x with equal rows, seventeen digits, one x, and numbers that a float does not tell apart.
    let rows: [&dyn Fn(usize) -> String; 5] = [
        &|k| format!("{}e-3,{}e-4", k * 31 % 10_007, k * 31 % 10_007 * 18 + noise(k)),
        &|k| format!("{},{}", k % 7, k % 7 * 2_000 + noise(k) % 50 * 80),
        &|k| {
            format!(
                "0.{:017},1.{:016}",
                k * 7_919_000_000_017 % 99_999_999_999_999_999,
                noise(k) * 1_000_000_007
            )
        },
        &|k| format!("5,{}", noise(k)),
        &|k| format!("1000000000000000000{:05},{}", k * 31 % 10_007, noise(k)),
    ];
    for (own, (row, bound)) in rows.iter().zip(["0.25", "2500", "0.5", "2100", "2500"]).enumerate() {
        let rows: String = (0..count).map(|k| row(k) + "\n").collect();
        fs::write(&data, format!("t,U\n{rows}")).unwrap();
        // The second bound leaves nothing.
        for (bound, status) in [(bound, 0), ("0.0001", 3)] {
            for options in ["--figure data --flip", "--figure corridor", "--figure data --x-range 0..3"] {
                let fit = format!("{} --x t --y U --eps {bound} {options}", data.display());
                let [waiting, held] = [svg(&fit, status), svg(&format!("{fit} --rows 1..{count}"), status)];
                assert!(waiting == held, "{own}: {fit}");
                assert!(waiting.contains("counted in squares"), "{own}: {fit}");
            }
        }
    }
}

#[test]
fn all_figures_go_into_a_folder() {
    let folder = tempfile::tempdir().unwrap();
    let inside = folder.path().join("new/figures");
    let line = format!("{TRANSDUCER} --figure all -o {}", inside.display());
    assert_eq!(picture(&line, 0), b"");
    assert_eq!(picture(&format!("{line} --format png"), 0), b"");
    // The figures of a fit alone.
    for figure in &FIGURES[..6] {
        let expected = root().join(format!("fixtures/figures/transducer-{figure}.svg"));
        assert_eq!(fs::read(inside.join(format!("{figure}.svg"))).unwrap(), fs::read(expected).unwrap());
        let png = fs::read(inside.join(format!("{figure}.png"))).unwrap();
        assert_eq!(Pixmap::decode_png(&png).unwrap().width(), 1600);
    }
    assert_eq!(fs::read_dir(&inside).unwrap().count(), 12);
}

#[test]
fn the_name_of_the_file_tells_the_format() {
    let folder = tempfile::tempdir().unwrap();
    let fit = of_kind("two-readings.csv --x x --y y --eps 0.1");
    for (name, start) in [("a.svg", &b"<svg"[..]), ("b.PNG", &b"\x89PNG"[..])] {
        let file = folder.path().join(name);
        assert_eq!(picture(&format!("{fit} -o {}", file.display()), 0), b"");
        assert!(fs::read(&file).unwrap().starts_with(start), "{name}");
    }
    assert!(picture(&format!("{fit} --format png -o -"), 0).starts_with(b"\x89PNG"));
}

/// The texts of an SVG.
fn texts(svg: &str) -> Vec<String> {
    // Where an axis has no numbers, there are texts without letters.
    let parts = svg.split("<text ").skip(1);
    let texts =
        parts.filter_map(|part| Some(part.split_once('>')?.1.split_once("</text>")?.0.trim().to_owned()));
    texts.filter(|text| !text.is_empty()).collect()
}

#[test]
fn source_for_tikz_says_what_the_svg_says() {
    let mut lines: Vec<(String, i32)> =
        FIGURES.iter().map(|figure| (format!("{TRANSDUCER} --figure {figure}"), 0)).collect();
    lines.extend(KINDS.map(|(_, fit, status)| (of_kind(fit), status)));
    lines.push((of_kind("two-regressors.csv --x u,v --y y --eps 0.3 --figure corridor"), 0));
    for (line, status) in lines {
        let svg = texts(&svg(&format!("{line} --real-text"), status));
        let source = String::from_utf8(picture(&format!("{line} --format tikz"), status)).unwrap();
        let nodes = source.split("\\node[").skip(1);
        let tikz: Vec<String> = nodes
            .filter_map(|node| {
                let (_, text) = node.split_once(" {")?;
                Some(text.split_once("};\n")?.0.to_owned())
            })
            .collect();
        assert_eq!(tikz.len(), svg.len(), "{line}");
        // Words and numbers that need no command are the same in both, as often.
        let plain = |texts: &[String]| {
            let is_plain = |c: char| c.is_ascii_alphanumeric() || " .()[]/:=".contains(c);
            let mut plain: Vec<String> =
                texts.iter().filter(|text| text.chars().all(is_plain)).cloned().collect();
            plain.sort();
            plain
        };
        assert!(plain(&svg).len() > 3, "{line}");
        assert_eq!(plain(&tikz), plain(&svg), "{line}");
        assert!(!source.contains("NaN") && !source.contains("inf,"), "{line}");
        assert_eq!(source.matches("\\begin{").count(), source.matches("\\end{").count(), "{line}");
    }
}

#[test]
fn a_document_has_the_picture_for_tikz_in_it() {
    let line = format!("{TRANSDUCER} --figure corridor --greyscale --size 85mm --font-size 8pt");
    let text = |format: &str| String::from_utf8(picture(&format!("{line} --format {format}"), 0)).unwrap();
    let [picture, document] = ["tikz", "tex"].map(text);
    let drawn = picture.split_once("\\begin{tikzpicture}").unwrap().1;
    assert!(document.contains(drawn) && document.ends_with("\\end{document}\n"));
    assert!(picture.starts_with("% A figure written by boundfit: \\input it"), "{picture}");
    // Greys alone.
    for colour in picture.split("{HTML}{").skip(1) {
        assert!(colour[..2] == colour[2..4] && colour[..2] == colour[4..6], "{colour}");
    }
}

#[test]
fn letters_that_the_font_lacks_stay_where_texts_do() {
    let line = format!("{TRANSDUCER} --figure fps --x-label 温度");
    let [outlined, real] = ["", " --real-text"].map(|option| svg(&format!("{line}{option}"), 0));
    assert!(real.contains("温度") && !real.contains("◊</text>"), "{real}");
    assert!(!outlined.contains("◊</text>"));
    let note = "stands for letters that the font Inter lacks";
    assert!(real.contains(note));
    let source = String::from_utf8(picture(&format!("{line} --format tikz"), 0)).unwrap();
    assert!(source.contains("{温度}") && !source.contains("diamond"), "{source}");
    assert!(!svg(&format!("{TRANSDUCER} --figure fps --real-text"), 0).contains(note));
}

/// The description of a picture has its notes.
fn description(text: &str) -> &str {
    text.split_once("<desc").and_then(|(_, rest)| rest.split_once("</desc>")).map_or("", |(own, _)| own)
}

#[test]
fn readings_on_the_border_are_drawn_and_those_outside_counted() {
    let data = |options: &str| {
        let line =
            format!("fixtures/transducer/transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 {options}");
        svg(&line, 0)
    };
    // The readings of rows 14 and 36 are at 0.013 and 0.035, those of rows 1 and 46 at 0 and 0.045.
    let close = data("--figure data --y-range 0.0129..0.0351");
    let on_border = data("--figure data --y-range 0.013..0.035");
    let wide = data("--figure data --y-range 0.0127..0.0353");
    for text in [&close, &on_border, &wide] {
        assert!(
            description(text).contains("Outside the first panel: 23 of 46 readings."),
            "{}",
            description(text)
        );
    }
    let all = data("--figure data --y-range 0..0.045");
    assert!(!description(&all).contains("the first panel"), "{}", description(&all));
    let none = data("--figure data --y-range 1..2");
    let place =
        "No reading is in the first panel: they lie from −6.9582 to 7.5844 across and from 0 to 0.045 up.";
    assert!(description(&none).contains(place), "{}", description(&none));
    // Neither is the set where no parameters are looked for.
    let set = data("--figure fps --x-range 5..6");
    assert!(
        description(&set).contains("The set is not in this view: it has vertices from "),
        "{}",
        description(&set)
    );
}

#[test]
fn why_there_is_no_eui_is_the_true_reason() {
    let folder = tempfile::tempdir().unwrap();
    let data = folder.path().join("one-sided.csv");
    fs::write(&data, "x,low,high\n0,1,\n1,,3\n2,2,\n3,,6\n").unwrap();
    for figure in ["eui", "fps"] {
        let line = format!("{} --x x --lower low --upper high --figure {figure}", data.display());
        let text = svg(&line, 0);
        let words = description(&text);
        assert!(words.contains("a reading with one bound only has no middle"), "{words}");
        assert!(!text.contains("dependent") && !text.contains("proportional"), "{words}");
    }
}

#[test]
fn readings_with_one_bound_contradict_each_other_in_pictures() {
    let folder = tempfile::tempdir().unwrap();
    let data = folder.path().join("one-sided.csv");
    for (text, sides) in [
        ("x,low,high\n0,1,\n0,,0\n", ["row 1 (lower", "row 2 (upper"]),
        ("x,low,high\n0,,0\n0,1,\n", ["row 1 (upper", "row 2 (lower"]),
        ("x,low,high\n0,0,1\n0,2,\n", ["row 1 (upper", "row 2 (lower"]),
    ] {
        fs::write(&data, text).unwrap();
        let text =
            svg(&format!("{} --x x --lower low --upper high --figure fps --real-text", data.display()), 3);
        for side in sides {
            assert!(text.contains(&format!("allowed by {side} bound thick)")), "{side}: {text}");
        }
    }
}
