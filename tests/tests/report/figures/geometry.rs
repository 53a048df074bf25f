//! Every figure of every fit of `fixtures/tables`, by geometry: no two labels cover each other, nothing leaves the picture, ticks
//! match the data.

use std::fs;
use std::sync::{Arc, LazyLock, OnceLock};

use boundfit_tests::generate::{one_in, share};
use boundfit_tests::program::root;
use resvg::tiny_skia::Pixmap;
use resvg::usvg::{Group, Node, Options, Tree, fontdb::Database};

use super::{picture, svg};

const FIGURES: [&str; 6] = ["data", "eui", "pui", "fps", "corridor", "directions"];

/// A fit of `fixtures/tables/fits.txt`.
struct Fit {
    status: i32,
    line: String,
    plain: OnceLock<Vec<String>>,
}

static FITS: LazyLock<Vec<Fit>> = LazyLock::new(|| {
    let text = fs::read_to_string(root().join("fixtures/tables/fits.txt")).unwrap();
    let lines = text.lines().filter(|line| !line.starts_with('#'));
    let fits: Vec<Fit> = lines
        .map(|line| {
            let (status, rest) = line.split_once(' ').unwrap();
            let line = format!("fixtures/{rest}");
            Fit { status: status.parse().unwrap(), line, plain: OnceLock::new() }
        })
        .collect();
    assert!(fits.len() >= 40, "{}", fits.len());
    fits
});

impl Fit {
    /// All of [`FIGURES`], from one run of the program: starting it takes about half as long as a figure does.
    fn drawn(&self, look: &str) -> Vec<String> {
        let folder = tempfile::tempdir().unwrap();
        let line = format!("{} --figure all --real-text{look} -o {}", self.line, folder.path().display());
        assert_eq!(picture(&line, self.status), b"");
        FIGURES.map(|figure| fs::read_to_string(folder.path().join(format!("{figure}.svg"))).unwrap()).into()
    }

    /// A figure that is drawn once for all tests.
    fn plain(&self, figure: &str) -> &str {
        let figures = self.plain.get_or_init(|| self.drawn(""));
        &figures[FIGURES.iter().position(|own| *own == figure).unwrap()]
    }
}

/// A label, and left, top, right and bottom of its letters.
type Label = (String, [f32; 4]);

/// All labels of a figure whose texts are texts, and the size of the picture.
fn labels(svg: &str) -> (Vec<Label>, [f32; 2]) {
    static OPTIONS: LazyLock<Options> = LazyLock::new(|| {
        let mut fonts = Database::new();
        fonts.load_font_data(fs::read(root().join("crates/figures/fonts/Inter-Regular-subset.otf")).unwrap());
        Options { fontdb: Arc::new(fonts), ..Options::default() }
    });
    let tree = Tree::from_str(svg, &OPTIONS).unwrap();
    let mut found = Vec::new();
    collect(tree.root(), &mut found);
    (found, [tree.size().width(), tree.size().height()])
}

fn collect(group: &Group, found: &mut Vec<Label>) {
    for node in group.children() {
        match node {
            Node::Group(group) => collect(group, found),
            Node::Text(text) => {
                let words: String = text.chunks().iter().map(|chunk| chunk.text()).collect();
                let bounds = text.flattened().abs_bounding_box();
                found.push((words, [bounds.left(), bounds.top(), bounds.right(), bounds.bottom()]));
            }
            _ => {}
        }
    }
}

fn overlap(one: &[f32; 4], other: &[f32; 4]) -> bool {
    one[0] < other[2] && other[0] < one[2] && one[1] < other[3] && other[1] < one[3]
}

/// No two labels of a figure cover each other, and none leaves the picture; `line` drew it.
pub fn assert_labels_have_room(svg: &str, line: &str) {
    let (labels, [width, height]) = labels(svg);
    assert!(labels.len() > 4, "{line}");
    for (index, (text, bounds)) in labels.iter().enumerate() {
        let [left, top, right, bottom] = *bounds;
        let is_inside = left >= 0.0 && top >= 0.0 && right <= width && bottom <= height;
        assert!(is_inside, "{line}: \"{text}\" at {bounds:?} leaves {width} by {height}");
        for (other, others) in &labels[..index] {
            assert!(!overlap(bounds, others), "{line}: \"{text}\" {bounds:?} and \"{other}\" {others:?}");
        }
    }
}

#[test]
fn no_two_labels_overlap_and_none_leaves_the_picture() {
    for fit in FITS.iter().step_by(one_in()) {
        for look in ["", " --flip", " --size 85mm --font-size 8pt", " --size 85mm --font-size 8pt --flip"] {
            let drawn = if look.is_empty() { Vec::new() } else { fit.drawn(look) };
            for (index, figure) in FIGURES.iter().enumerate() {
                let svg = drawn.get(index).map_or_else(|| fit.plain(figure), String::as_str);
                if look.ends_with("--flip") && matches!(*figure, "fps" | "directions") {
                    continue;
                }
                assert_labels_have_room(svg, &format!("{} --figure {figure} --real-text{look}", fit.line));
            }
        }
    }
}

/// A number as figures write it.
fn number(text: &str) -> Option<f64> {
    text.replace('−', "-").parse().ok()
}

/// Ticks on one line of labels, as places and values: the slope and the value at 0, and how far they are from a line.
fn scale(ticks: &[(f64, f64)]) -> Option<([f64; 2], f64)> {
    let ((first, start), (last, end)) = (ticks.first()?, ticks.last()?);
    let slope = (end - start) / (last - first);
    let off =
        ticks.iter().map(|(at, value)| (start + slope * (at - first) - value).abs()).fold(0.0, f64::max);
    Some(([slope, start - slope * first], off / slope.abs()))
}

/// The ticks of the lowest horizontal axis, and of the vertical axis farthest to the left.
fn ticks(labels: &[Label]) -> [Vec<(f64, f64)>; 2] {
    let middle = |low: f32, high: f32| f64::from(low + high) / 2.0;
    let numbers: Vec<(f64, &[f32; 4])> =
        labels.iter().filter_map(|(text, bounds)| Some((number(text.trim())?, bounds))).collect();
    // Labels of an axis stand on one line: digits have one bottom, and upright axes one right edge.
    let in_line = |edge: usize, most: &dyn Fn(f32, f32) -> bool, from: &[usize; 2]| {
        let count =
            |line: f32| numbers.iter().filter(|(_, bounds)| (bounds[edge] - line).abs() < 1.5).count();
        let lines = numbers.iter().map(|(_, bounds)| bounds[edge]).filter(|&line| count(line) > 1);
        let line = lines.reduce(|best, line| if most(line, best) { line } else { best });
        let on =
            numbers.iter().filter(|(_, bounds)| line.is_some_and(|line| (bounds[edge] - line).abs() < 1.5));
        on.map(|(value, bounds)| (middle(bounds[from[0]], bounds[from[1]]), *value)).collect::<Vec<_>>()
    };
    [in_line(3, &|line, best| line > best, &[0, 2]), in_line(2, &|line, best| line < best, &[1, 3])]
}

#[test]
fn ticks_stand_where_their_numbers_are() {
    for fit in FITS.iter().step_by(one_in()) {
        for figure in ["data", "fps"] {
            let line = format!("{} --figure {figure}", fit.line);
            let (labels, _) = labels(fit.plain(figure));
            for (axis, ticks) in ticks(&labels).iter().enumerate() {
                let mut ticks = ticks.clone();
                ticks.sort_by(|one, other| one.0.total_cmp(&other.0));
                // The ticks of the first panel; to those of the next one there is another step.
                let step = |pair: &[(f64, f64)]| [pair[1].0 - pair[0].0, pair[1].1 - pair[0].1];
                let first = ticks.windows(2).next().map_or([0.0; 2], step);
                let is_next = |pair: &[(f64, f64)]| {
                    let [far, by] = step(pair);
                    (far - first[0]).abs() > 4.0 || (by - first[1]).abs() > 1e-6 * first[1].abs()
                };
                let next = ticks.windows(2).position(is_next);
                ticks.truncate(next.map_or(ticks.len(), |end| end + 1));
                let Some((_, off)) = scale(&ticks).filter(|_| ticks.len() > 2) else { continue };
                // A label is centred to within the side bearings of its digits and its sign.
                assert!(off < 4.5, "{line}: axis {axis}: {off} pixels: {ticks:?}");
            }
        }
    }
}

/// The number behind `name="` in a tag.
fn attribute(tag: &str, name: &str) -> Option<f64> {
    tag.split_once(&format!(" {name}=\""))?.1.split_once('"')?.0.parse().ok()
}

/// Values at the ticks of the first panel: those on the line of labels nearest below or beside its frame.
fn first_panel(svg: &str, across: bool) -> Vec<(f64, f64)> {
    let anchor = if across { "text-anchor=\"middle\"" } else { "text-anchor=\"end\"" };
    let [along, fixed] = if across { ["x", "y"] } else { ["y", "x"] };
    let tags = svg.split("<text ").skip(1).filter(|tag| tag.contains(anchor) && !tag.contains("rotate"));
    let numbered = tags.filter_map(|tag| {
        let words = tag.split_once('>')?.1.split_once('<')?.0;
        Some((
            attribute(&format!(" {tag}"), fixed)?,
            attribute(&format!(" {tag}"), along)?,
            number(words.trim())?,
        ))
    });
    let numbered: Vec<(f64, f64, f64)> = numbered.collect();
    // Panels are drawn one after the other, the largest first.
    let Some((line, ..)) = numbered.first().copied() else { return Vec::new() };
    let mut ticks: Vec<(f64, f64)> =
        numbered.iter().take_while(|(at, ..)| *at == line).map(|(_, at, value)| (*at, *value)).collect();
    let rises = |pair: &[(f64, f64)]| (pair[1].1 > pair[0].1) == (ticks[1].1 > ticks[0].1);
    let end = ticks.windows(2).position(|pair| !rises(pair)).map_or(ticks.len(), |end| end + 1);
    ticks.truncate(end);
    ticks
}

#[test]
fn vertices_stand_at_their_numbers() {
    let mut checked = 0;
    for drawn in FITS.iter().step_by(one_in()) {
        let (fit, text) = (&drawn.line, drawn.plain("fps"));
        // A factor taken out of tick labels is written beside the axis.
        if !text.contains("Feasible parameter set: polygon") || text.contains("×10") || text.contains("\n+")
        {
            continue;
        }
        let [across, up] = [true, false].map(|across| scale(&first_panel(text, across)));
        let (Some((across, _)), Some((up, _))) = (across, up) else { continue };
        let plain: Vec<&str> = fit.split_whitespace().collect();
        let plain: Vec<&str> = plain
            .iter()
            .scan(false, |unit, word| {
                let drop = std::mem::replace(unit, word.ends_with("-unit")) || word.ends_with("-unit");
                Some((!drop).then_some(*word))
            })
            .flatten()
            .collect();
        let output = std::process::Command::new(boundfit_tests::program::binary())
            .arg("fit")
            .args(&plain)
            .args(["--format", "json"])
            .current_dir(root())
            .output()
            .unwrap();
        let report: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        let found: Vec<[f64; 2]> = text
            .split("<circle ")
            .skip(1)
            .map(|tag| format!(" {tag}"))
            .filter(|tag| attribute(tag, "r") == Some(28.0) && tag.contains("fill=\"#0072B2\""))
            .filter_map(|tag| {
                let [x, y] = ["cx", "cy"].map(|name| attribute(&tag, name));
                Some([across[0] * x? + across[1], up[0] * y? + up[1]])
            })
            .collect();
        let vertices = report["fps"]["vertices"].as_array().unwrap();
        if vertices.len() > 12 {
            continue;
        }
        for vertex in vertices {
            let theta = [0, 1].map(|j| vertex["theta"][j]["value"].as_f64().unwrap());
            // Within a pixel, of ten units each.
            let near = |point: &[f64; 2]| {
                (point[0] - theta[0]).abs() < 10.0 * across[0].abs()
                    && (point[1] - theta[1]).abs() < 10.0 * up[0].abs()
            };
            assert!(found.iter().any(near), "{fit}: {theta:?} is not among {found:?}");
            checked += 1;
        }
    }
    assert!(checked > share(60), "only {checked}");
}

#[test]
fn rows_of_two_regressors_are_counted_from_one() {
    for fit in FITS.iter().filter(|fit| fit.line.contains("--x ") && fit.line.contains(",")) {
        let line = &fit.line;
        let (labels, _) = labels(fit.plain("corridor"));
        if !labels.iter().any(|(text, _)| text.contains("data row")) {
            continue;
        }
        let [across, _] = ticks(&labels);
        assert!(across.iter().all(|(_, row)| *row >= 1.0 && row.fract() == 0.0), "{line}: {across:?}");
    }
}

#[test]
fn every_reading_up_to_a_thousand_is_drawn() {
    let folder = tempfile::tempdir().unwrap();
    let data = folder.path().join("many.csv");
    for (count, is_each) in [(272_usize, true), (1_000, true), (1_001, false), (10_001, false)] {
        let rows: String =
            (0..count).map(|k| format!("{k},{}\n", k * 7919 % 10_007 + k * k % 104_729)).collect();
        fs::write(&data, format!("t,U\n{rows}")).unwrap();
        let text = svg(&format!("{} --x t --y U --eps 200000 --figure data", data.display()), 0);
        // Squares of two pixels, in one path in each of two panels.
        let squares = text
            .lines()
            .filter(|line| line.contains("fill=\"#262626\""))
            .map(|line| line.matches(" Z").count());
        let most = squares.max().unwrap_or(0);
        assert_eq!(most >= count, is_each, "{count} readings, {most} marks");
        assert_eq!(text.contains("counted in squares"), !is_each, "{count}");
        assert!(text.len() < 3_000_000, "{count}: {} bytes", text.len());
    }
}

#[test]
fn a_set_of_one_point_is_seen_around_its_estimates() {
    let text = svg("fixtures/figures/on-a-line.csv --x x --y y --eps 0 --real-text", 0);
    assert!(text.contains("<circle cx=") && text.contains("r=\"95\""), "no ring");
}

#[test]
fn directions_are_spread_where_the_box_is_a_square() {
    for fit in [
        "tables/cars.csv --x speed --y dist --eps 45",
        "tables/trees.csv --x Girth,Height --y Volume --eps 30",
    ] {
        let text = svg(&format!("fixtures/{fit} --figure directions --scaled"), 0);
        let areas = text.split("Inner area: ").nth(1).and_then(|rest| rest.split(" %").next()).unwrap();
        let part: f64 = areas.replace("×10⁻", "e-").parse().unwrap();
        assert!(part > 50.0, "{fit}: {part} %");
    }
}

#[test]
fn a_pdf_is_one_page_of_the_size_of_the_svg() {
    for figure in FIGURES {
        let line = format!("fixtures/tables/cars.csv --x speed --y dist --eps 45 --figure {figure}");
        let pdf = picture(&format!("{line} --format pdf"), 0);
        let text = String::from_utf8_lossy(&pdf);
        assert!(text.starts_with("%PDF-1.7") && text.trim_end().ends_with("%%EOF"), "{figure}");
        let tree = Tree::from_str(&svg(&line, 0), &Options::default()).unwrap();
        let [width, height] = [tree.size().width(), tree.size().height()].map(|length| length * 0.75);
        assert!(text.contains(&format!("[0 0 {width} {height}]")), "{figure}: {width} {height}");
        assert!(text.contains("(boundfit)"), "{figure}");
        assert_eq!(pdf, picture(&format!("{line} --format pdf"), 0), "{figure}: another run, other bytes");
    }
}

#[test]
fn a_picture_is_as_large_as_it_is_asked_to_be() {
    let fit = "fixtures/tables/cars.csv --x speed --y dist --eps 45";
    for (size, pixels, points) in [("84mm", 84.0 / 25.4 * 96.0, 84.0 / 25.4 * 72.0), ("2in", 192.0, 144.0)] {
        let line = format!("{fit} --size {size}");
        let tree = Tree::from_str(&svg(&line, 0), &Options::default()).unwrap();
        assert!((f64::from(tree.size().width()) - pixels).abs() < 0.01, "{size}: {}", tree.size().width());
        let png = Pixmap::decode_png(&picture(&format!("{line} --format png --dpi 300"), 0)).unwrap();
        assert_eq!(png.width(), (pixels / 96.0 * 300.0).round() as u32, "{size}");
        let pdf = picture(&format!("{line} --format pdf"), 0);
        let text = String::from_utf8_lossy(&pdf).into_owned();
        let page = text.split_once("[0 0 ").unwrap().1.split_once(' ').unwrap().0;
        assert!((page.parse::<f64>().unwrap() - points).abs() < 0.01, "{size}: {page}");
    }
    // 192 dots per inch are 7559 in a metre.
    let png = picture(&format!("{fit} --format png"), 0);
    assert!(
        png.windows(12)
            .any(|part| part == [&b"pHYs"[..], &7559_u32.to_be_bytes(), &7559_u32.to_be_bytes()].concat())
    );
}

#[test]
fn axes_names_and_colours_are_those_asked_for() {
    let fit = "fixtures/tables/cars.csv --x speed --y dist --eps 45 --real-text";
    let words = |more: &str| {
        let (labels, _) = labels(&svg(&format!("{fit} {more}"), 0));
        labels.into_iter().map(|(text, _)| text.trim().to_owned()).collect::<Vec<_>>()
    };
    let found = words("--x-label a --y-label b --x-range -10..10 --y-range -200..200");
    for label in ["a", "b", "−10", "10", "−200", "200"] {
        assert!(found.iter().any(|text| text == label), "{label} is not among {found:?}");
    }
    let data = words("--figure data --x-range 0..50 --y-range -50..400 --title Cars");
    for label in ["Cars", "50", "400", "residuals of the least-squares line"] {
        assert!(data.iter().any(|text| text == label), "{label} is not among {data:?}");
    }
    let grey = svg(&format!("{fit} --greyscale"), 0);
    for part in grey.split("=\"#").skip(1) {
        assert!(part[..2] == part[2..4] && part[2..4] == part[4..6], "{}", &part[..6]);
    }
}
