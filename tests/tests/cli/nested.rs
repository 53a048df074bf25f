//! `boundfit plot --sweep`: sets under growing error bounds, one in another.

use boundfit_tests::cli::{boundfit, directory_with};

const TABLE: &str = "x,y\n0,0\n1,1.5\n2,2\n3,3.5\n";

fn plot(table: &str, line: &str) -> (i32, String, String) {
    let directory = directory_with(&[("data.csv", table.as_bytes())]);
    let run = boundfit(directory.path(), &format!("plot data.csv --x x --y y --real-text {line}"));
    (run.status, run.stdout, run.stderr)
}

/// The factors that are written beside sets.
fn factors(svg: &str) -> Vec<String> {
    let texts =
        svg.split('×').skip(1).map(|text| text.split('<').next().unwrap_or_default().trim().to_owned());
    texts.filter(|text| !text.starts_with("10")).collect()
}

#[test]
fn sets_are_drawn_from_the_least_factor_on() {
    // The least error bound is 1/4.
    let (status, svg, messages) = plot(TABLE, "--eps 1/2 --sweep 0..3");
    assert_eq!((status, messages.as_str()), (0, ""));
    assert_eq!(factors(&svg), ["0.5", "1", "1.125", "1.75", "2.375", "3"]);
    for text in ["Below the factor 0.5 nothing is left.", "with error bounds as given"] {
        assert!(svg.contains(text), "{text}");
    }
    let (_, svg, _) = plot(TABLE, "--eps 1/2 --sweep 1..2");
    assert_eq!(factors(&svg), ["1", "1.25", "1.5", "1.75", "2"]);
    let (_, svg, _) = plot(TABLE, "--eps 1/2 --sweep 2..2");
    assert_eq!(factors(&svg), ["2"]);
    assert!(!svg.contains("with error bounds as given"));
}

#[test]
fn an_empty_set_is_among_the_sets_once_bounds_have_grown() {
    let (status, svg, _) = plot(TABLE, "--eps 1/8 --sweep 1..4");
    assert_eq!((status, factors(&svg)), (0, ["2", "2.5", "3", "3.5", "4"].map(String::from).to_vec()));
}

#[test]
fn sets_without_end_have_arrows() {
    let (status, svg, _) = plot("x,y\n1,1\n1,2\n", "--eps 1 --sweep 0.6..2");
    assert_eq!((status, svg.contains("Arrows: the set goes on without end.")), (0, true));
}

#[test]
fn a_line_is_in_the_sets_around_it() {
    let (status, svg, _) = plot("x,y\n1,1\n", "--eps 0.1 --sweep 0..2");
    // Four strips have an inside, the line of the factor 0 has none. No vertex bears their factors.
    assert_eq!((status, svg.matches("opacity=\"0.16\"").count()), (0, 4 + 2));
    assert!(svg.contains("From inside to outside: ×0, ×0.5, ×1, ×1.5 and ×2."), "{svg}");
    let (_, svg, _) = plot("x,y\n1,1\n", "--eps 0.1 --sweep 0..2 --figure corridor");
    for name in ["corridor when all error bounds grow by a factor", "corridor with error bounds as given"] {
        let note = format!("Where it has no edge, the {name} is unbounded.\n");
        assert_eq!(svg.matches(&note).count(), 1, "{note}: {svg}");
    }
}

#[test]
fn corridors_are_drawn_from_the_least_factor_on() {
    let (status, svg, messages) = plot(TABLE, "--eps 1/2 --sweep 0..3 --figure corridor");
    assert_eq!((status, messages.as_str()), (0, ""));
    for text in [
        "From inside to outside: ×0.5, ×1, ×1.125, ×1.75, ×2.375 and ×3.",
        "Below the factor 0.5 nothing is left.",
        "with error bounds as given",
        "corridor when all error bounds grow by a factor",
        "Corridors under growing error bounds",
    ] {
        assert!(svg.contains(text), "{text}: {svg}");
    }
    // As many bands, in each of two panels, as there are factors; the innermost is a line.
    let edges = svg.split("<polyline ").filter(|tag| tag.contains("#0072B2")).count();
    // The edges of the bounds as given are dashed, each dash a stroke of its own, and dark.
    let given = svg.matches("stroke=\"#262626\" stroke-width=\"22\"").count();
    assert!(edges >= 20 && given >= 4, "{edges} {given}");
    // Readings that contradict each other under their own bounds, and in no set but in larger ones.
    let (status, svg, _) = plot(TABLE, "--eps 1/8 --sweep 1..4 --figure corridor --flip");
    assert_eq!(status, 0);
    assert!(svg.contains("From inside to outside: ×2, ×2.5, ×3, ×3.5 and ×4."), "{svg}");
    let (status, _, messages) = plot(TABLE, "--eps 1/8 --sweep 0..1 --figure corridor");
    assert_eq!((status, messages.contains("no factor of '--sweep' leaves any parameters")), (1, true));
}

#[test]
fn sweeps_that_cannot_be_drawn_are_refused() {
    for (line, status, problem) in [
        ("--eps 1/8 --sweep 0..1", 1, "data.csv: no factor of '--sweep' leaves any parameters"),
        ("--eps 1 --sweep 2..1", 2, "expected FROM..TO with numbers 0 <= FROM <= TO"),
        (
            "--eps 1 --sweep 1..2 --figure data",
            2,
            "'--sweep' draws sets of parameters, or the corridors of their lines: with '--figure fps' or '--figure corridor'",
        ),
        (
            "--eps 1 --sweep 1..2 --figure all",
            2,
            "'--sweep' draws sets of parameters, or the corridors of their lines: with '--figure fps' or '--figure corridor'",
        ),
        ("--eps 1 --sweep 1..2 --x-eps 0.1", 2, "'--sweep <FROM..TO>' cannot be used with"),
    ] {
        let (found, output, messages) = plot(TABLE, line);
        assert_eq!((found, output.as_str()), (status, ""), "{line}");
        assert!(messages.contains(problem), "{line}: {messages}");
    }
}
