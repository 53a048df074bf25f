//! The page as the program writes it.

use std::fs;

use boundfit_geometry::RegionKind;
use boundfit_tests::shape::Tally;
use serde_json::{Value, json};

use crate::document::items;
use boundfit_tests::cli::fits::all;
use boundfit_tests::cli::{FIT_TRANSDUCER, boundfit, directory_with, files_in, printed, report};
use boundfit_tests::program::root;

/// The command line that makes a lesson where another fits.
fn lesson_line(fit: &str) -> String {
    fit.replacen("fit ", "lesson ", 1)
}

/// Returns the text of the page between two marks, the first of which occurs once.
fn between<'a>(page: &'a str, before: &str, after: &str) -> &'a str {
    let (_, rest) = page.split_once(before).unwrap_or_else(|| panic!("no {before}"));
    assert!(!rest.contains(before), "{before} twice");
    rest.split_once(after).unwrap_or_else(|| panic!("no {after}")).0
}

/// The data in a page.
fn data(page: &str) -> Value {
    let json = between(page, "<script type=\"application/json\" id=\"lesson-data\">", "</script>");
    serde_json::from_str(json).unwrap()
}

/// A report without the decimals and doubles beside its exact numbers, which a page shows in its own way.
fn exact_parts(report: &Value) -> Value {
    match report {
        Value::Object(fields) if fields.contains_key("exact") => fields["exact"].clone(),
        Value::Object(fields) => {
            fields.iter().map(|(key, value)| (key.clone(), exact_parts(value))).collect()
        }
        Value::Array(items) => items.iter().map(exact_parts).collect(),
        other => other.clone(),
    }
}

#[test]
fn every_kind_of_set_has_a_page_with_the_fit_of_the_program() {
    let mut tally = Tally::default();
    for case in all() {
        let directory = directory_with(&[("data.csv", case.csv.as_bytes())]);
        let line = lesson_line(&case.command_line());
        let run = boundfit(directory.path(), &line);
        let fit = report(directory.path(), &case.command_line(), b"");
        let status = if fit["fps"]["kind"] == "empty" { 3 } else { 0 };
        assert_eq!((run.status, run.stderr.as_str()), (status, ""), "{line}");
        let data = data(&run.stdout);
        assert_eq!(exact_parts(&data["fit"]), exact_parts(&fit), "{line}");
        assert_eq!(data["fit"]["fps"]["kind"], case.kind, "{line}");
        assert_eq!(data["reading"], case.reading.name());
        // Without scripts there is a picture of the set, and one of the readings if there are any.
        // The first one hides what needs a script, the last one has what is there without.
        let (_, still) = run.stdout.rsplit_once("<noscript>").unwrap();
        let (still, _) = still.split_once("</noscript>").unwrap();
        let pictures = still.matches("<svg aria-label=").count();
        assert_eq!(pictures, 1 + usize::from(data["readings"] != json!([])), "{line}");
        tally.count(
            RegionKind::ALL.map(RegionKind::name).into_iter().find(|kind| *kind == case.kind).unwrap(),
        );
    }
    tally.assert_each_kind(1);
}

#[test]
fn the_page_is_complete_and_asks_for_nothing_from_outside() {
    let page = printed(&root(), &lesson_line(FIT_TRANSDUCER));
    let engine = between(&page, "id=\"engine-module\">", "</script>").len();
    // It reads text in every dialect and encoding, and JSON, and answers every question; it leaves out packed files and MATLAB.
    // An eighth of it is the price of an edit of long numbers in two thirds of the time. Three hundredths are that of long numbers
    // that are read and printed sooner.
    assert!(engine <= 1_350_000, "{engine} bytes of the engine");
    assert!(page.len() - engine <= 800_000, "{} bytes without the engine", page.len() - engine);
    for token in ["{{title}}", "{{style}}", "{{data}}", "{{script}}"] {
        assert!(!page.contains(token), "{token}");
    }
    assert_eq!(between(&page, "<title>", "</title>"), "transducer.csv: z against Vz");
    let code = page.replace("http://www.w3.org/", "");
    for outside in ["http:", "https:", "url(//", "@import", "import(", "fetch(", "XMLHttpRequest", " src="] {
        assert!(!code.contains(outside), "{outside}");
    }
    for rest in code.split("href=\"").skip(1) {
        assert!(rest.starts_with('#') || rest.starts_with("data:"), "{}", rest.lines().next().unwrap());
    }
    assert!(page.contains("default-src 'none'"));
    assert_eq!(page.matches("<script").count(), page.matches("</script>").count());
    assert_eq!(page, printed(&root(), &lesson_line(FIT_TRANSDUCER)), "another page for the same data");
}

#[test]
fn text_from_outside_stays_text() {
    let title = "</title></script><b a='1'>\"x\" & {{data}} \u{2028}";
    let columns = ["<v \"1\">", "</script><!--"];
    let table = "\"<v \"\"1\"\">\",\"</script><!--\"\n1,2\n2,3\n4,4\n";
    let directory = directory_with(&[("data <&>.csv", table.as_bytes())]);
    let arguments =
        ["lesson", "data <&>.csv", "--x", columns[0], "--y", columns[1], "--eps", "1/2", "--title", title];
    let units = ["--x-unit", "<V>", "--y-unit", "µm"];
    let mut command = boundfit_tests::cli::command(directory.path());
    let run = boundfit_tests::cli::finish(command.args(arguments).args(units), b"");
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    let data = data(&run.stdout);
    assert_eq!(data["title"], title);
    assert_eq!(data["file"], "data <&>.csv");
    assert_eq!(data["model"], json!({"kind": "line", "x": columns[0], "y": columns[1]}));
    assert_eq!(data["units"], json!({"x": "<V>", "y": "µm", "theta1": "µm/(<V>)", "theta2": "µm"}));
    assert_eq!(
        between(&run.stdout, "<title>", "</title>"),
        "&lt;/title&gt;&lt;/script&gt;&lt;b a=&#39;1&#39;&gt;&quot;x&quot; &amp; {{data}} \u{2028}"
    );
    // The elements of the page are those of any other one.
    let plain = printed(&root(), &lesson_line(FIT_TRANSDUCER));
    for tag in ["<script", "</script>", "<!--", "<b a="] {
        assert_eq!(run.stdout.matches(tag).count(), plain.matches(tag).count(), "{tag}");
    }
    // In the data it is escaped: only the title of the page has it as it is.
    assert_eq!(run.stdout.matches('\u{2028}').count(), 1);
}

#[test]
fn titles_and_files_have_defaults() {
    let directory = directory_with(&[("readings.csv", b"u,v,y\n1,0,3\n0,1,2\n1,1,6\n")]);
    let path = directory.path().join("readings.csv");
    let line = format!("lesson {} --x u,v --y y --eps 2", path.display());
    let data_of_file = data(&printed(directory.path(), &line));
    assert_eq!(data_of_file["title"], "readings.csv: y against u and v");
    assert_eq!(data_of_file["file"], "readings.csv");
    let run = boundfit_tests::cli::boundfit_with_input(
        directory.path(),
        "lesson - --x 1 --y 2 --eps 1",
        b"1,2\n2,3\n",
    );
    assert_eq!(data(&run.stdout)["title"], "col2 against col1");
}

#[test]
fn the_page_goes_to_a_file_whole_or_not_at_all() {
    let directory = directory_with(&[("data.csv", b"x,y\n1,2\n2,3\n3,5\n")]);
    let line = "lesson data.csv --x x --y y --eps 1";
    assert_eq!(printed(directory.path(), &format!("{line} -o page.html")), "");
    let page = fs::read_to_string(directory.path().join("page.html")).unwrap();
    assert_eq!(page, printed(directory.path(), line));
    // An empty set has a page too; the exit status tells.
    let run = boundfit(directory.path(), "lesson data.csv --x x --y y --eps 1/8 -o empty.html");
    assert_eq!((run.status, run.stderr.as_str()), (3, ""));
    assert_eq!(files_in(directory.path()), ["data.csv", "empty.html", "page.html"]);
    assert_eq!(
        data(&fs::read_to_string(directory.path().join("empty.html")).unwrap())["fit"]["fps"]["kind"],
        "empty"
    );
}

#[test]
fn too_many_readings_are_refused() {
    let table: String = (1..=301).map(|row| format!("{row},{}\n", row % 7)).collect();
    let directory = directory_with(&[("data.csv", table.as_bytes())]);
    let line = "lesson data.csv --x 1 --y 2 --eps 4 -o page.html";
    let run = boundfit(directory.path(), line);
    assert_eq!(run.status, 1);
    assert_eq!(
        run.stderr,
        "error: data.csv: more than 300 readings are too many for a lesson; choose some with --rows FIRST..LAST, or raise it with --limit readings=N\n"
    );
    assert_eq!(files_in(directory.path()), ["data.csv"]);
    let run = boundfit(directory.path(), &format!("{line} --rows 2..301"));
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    let page = fs::read_to_string(directory.path().join("page.html")).unwrap();
    assert_eq!(items(&data(&page)["leave_one_out"]).count(), 300);
}

#[test]
fn a_long_file_shows_some_of_its_other_readings() {
    let table: String = (1..=3000).map(|row| format!("{row},{}\n", row % 7)).collect();
    let directory = directory_with(&[("data.csv", table.as_bytes())]);
    let data = data(&printed(directory.path(), "lesson data.csv --x 1 --y 2 --eps 4 --rows 1001..1020"));
    let others = items(&data["others"]).count();
    assert!((400..=500).contains(&others), "{others}");
    assert!(items(&data["others"]).all(|other| !(1001..=1020).contains(&other["row"].as_u64().unwrap())));
}

#[test]
fn numbers_of_a_thousand_digits_are_no_trouble() {
    let digits = |digit: &str| digit.repeat(999);
    let table = format!("x,y\n1.{0},2\n2,1e-999\n3e900,1.{1}\n", digits("3"), digits("7"));
    let directory = directory_with(&[("data.csv", table.as_bytes())]);
    for epsilon in ["1e-999", "1", "1e999"] {
        let run = boundfit(directory.path(), &format!("lesson data.csv --x x --y y --eps {epsilon}"));
        assert!([0, 3].contains(&run.status) && run.stderr.is_empty(), "{}", run.stderr);
        assert!(items(&data(&run.stdout)["questions"]).count() >= 6);
    }
}
