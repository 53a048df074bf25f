//! H-representations and V-representations, read and written.

use boundfit_tests::program::root;
use serde_json::{Value, json};

use super::{answer, for_each_region};
use boundfit_tests::cli::half_plane_files::{h_representation, shape};
use boundfit_tests::cli::numbers::{exact, pair, whole};
use boundfit_tests::cli::schema::{POLYGON, check_schema};
use boundfit_tests::cli::{boundfit_with_input, printed, printed_with_input, report};

#[test]
fn a_v_representation_is_the_set_that_its_rows_generate() {
    let house = report(&root(), "polygon fixtures/polygon/house.csv", b"");
    let report = report(&root(), "polygon fixtures/polygon/gable.ext", b"");
    check_schema(&report, POLYGON);
    assert_eq!(shape(&report["region"]), shape(&house["region"]));
    assert_eq!(report["region"]["area"], house["region"]["area"]);
    assert_eq!((&report["input"]["rows"], &report["redundant"]), (&json!(9), &json!([6, 7, 8, 9])));
    // Active are the rows that equal the vertex.
    let active: Vec<&Value> =
        report["region"]["vertices"].as_array().unwrap().iter().map(|vertex| &vertex["active"]).collect();
    assert_eq!(active, [&json!([1]), &json!([2]), &json!([3]), &json!([4]), &json!([5, 7])]);
    // By the angle of their normals.
    let facets: Vec<[String; 3]> = report["facets"]
        .as_array()
        .unwrap()
        .iter()
        .map(|facet| [&facet["a"][0], &facet["a"][1], &facet["b"]].map(|number| exact(number).to_string()))
        .collect();
    assert_eq!(
        facets,
        [["1", "0", "4"], ["1", "1", "6"], ["-1", "1", "2"], ["-1", "0", "0"], ["0", "-1", "0"]]
    );
    let upper = &report["bounds"][1]["upper"];
    let half = json!({"exact": "1/2", "decimal": "0.5", "value": 0.5});
    let term = |facet: usize| json!({"row": facet, "bound": "facet", "multiplier": half});
    assert_eq!((exact(upper), &upper["active"]), (whole(4), &json!([term(2), term(3)])));
    // Half-planes have no facets beside their rows.
    assert!(house.get("facets").is_none());
}

#[test]
fn rays_without_a_point_start_at_the_origin() {
    let report = report(&root(), "polygon fixtures/polygon/cone.ext", b"");
    let region = &report["region"];
    assert_eq!((&region["kind"], &report["redundant"]), (&json!("half-plane"), &json!([])));
    assert_eq!(pair(&region["lines"][0]), [whole(1), whole(-1)]);
    assert_eq!(pair(&region["rays"][0]), [whole(1), whole(1)]);
    assert_eq!(region["boundaries"][0]["active"], json!([]));
    assert_eq!(answer("V-representation\nbegin\n0 3 integer\nend\n")["region"]["kind"], "empty");
}

#[test]
fn the_text_on_generators_lists_half_planes_and_what_is_redundant() {
    let text = printed(&root(), "polygon fixtures/polygon/gable.ext");
    assert!(text.starts_with(
        "Generators of fixtures/polygon/gable.ext, 9 rows\n\nRegion: polygon with 5 vertices\n"
    ));
    let (_, rest) = text.split_once("\n\n5 half-planes").unwrap();
    let expected = " a1*theta1 + a2*theta2 <= b\n\
        \x20 facet  a1  a2  b\n\
        \x20 1      1   0   4\n\
        \x20 2      1   1   6\n\
        \x20 3      -1  1   2\n\
        \x20 4      -1  0   0\n\
        \x20 5      0   -1  0\n\
        \n\
        Redundant rows: 6, 7, 8, 9\n\
        \x20 row  why\n\
        \x20 6    a point of the set that the others generate\n\
        \x20 7    the same point as row 5\n\
        \x20 8    a point of the set that the others generate\n\
        \x20 9    has no direction\n";
    assert_eq!(rest, expected);
}

#[test]
fn what_lrs_and_cddlib_write_is_read_as_they_mean_it() {
    let region =
        |file: &str| report(&root(), &format!("polygon fixtures/polygon/{file}"), b"")["region"].clone();
    let house = shape(&region("house.csv"));
    for file in ["house-by-lrs.ext", "house-by-cdd.ext"] {
        assert_eq!(shape(&region(file)), house, "{file}");
    }
    assert_eq!(shape(&region("segment-by-lrs.ext")), shape(&region("segment.ine")));
    for file in ["empty-by-lrs.ext", "empty-by-cdd.ext"] {
        assert_eq!(region(file)["kind"], "empty", "{file}");
    }
    let upper_half = answer("begin\n1 3 integer\n0 0 1\nend\n");
    assert_eq!(shape(&region("upper-half-by-cdd.ext")), shape(&upper_half["region"]));
    let corners = answer("V-representation\nbegin\n3 3 integer\n1 0 0\n1 2 0\n1 0 3\nend\n");
    assert_eq!(shape(&region("triangle-by-lrs.ine")), shape(&corners["region"]));
}

/// Returns the document that the program writes for a set in a format, with status 0, or 3 for the empty set.
fn converted(input: &str, format: &str) -> String {
    let run = boundfit_with_input(&root(), &format!("polygon - --format {format}"), input.as_bytes());
    assert!([0, 3].contains(&run.status) && run.stderr.is_empty(), "{run:?}");
    run.stdout
}

#[test]
fn every_kind_of_set_survives_both_representations() {
    for_each_region(|case, report| {
        let given = h_representation(&case.csv, case.equations);
        let (h, v) = (converted(&given, "ine"), converted(&given, "ext"));
        assert!(h.starts_with("H-representation\n") && v.starts_with("V-representation\n"), "{h}{v}");
        for text in [&h, &v] {
            let again = answer(text);
            assert_eq!(shape(&again["region"]), shape(&report["region"]), "{text}");
            // The plane alone needs a row that says nothing.
            let redundant = again["redundant"].as_array().unwrap().len();
            let is_plane = case.kind == "plane" && text.starts_with("H-");
            assert_eq!(redundant, usize::from(is_plane), "{text}");
        }
        assert_eq!(converted(&v, "ext"), v);
        assert_eq!(shape(&answer(&converted(&v, "ine"))["region"]), shape(&report["region"]));
    });
}

#[test]
fn the_representations_are_written_exactly() {
    let house = printed(&root(), "polygon fixtures/polygon/house.csv --format ine");
    assert_eq!(house, "H-representation\nbegin\n5 3 integer\n0 1 0\n4 -1 0\n0 0 1\n2 1 -1\n6 -1 -1\nend\n");
    let segment = "H-representation\nlinearity 1 1\nbegin\n3 3 integer\n2 -1 -1\n0 1 0\n0 0 1\nend\n";
    assert_eq!(printed(&root(), "polygon fixtures/polygon/segment.ine --format ine"), segment);
    let strip = "V-representation\nlinearity 1 3\nbegin\n3 3 rational\n1 0 1/3\n1 0 -7\n0 1 0\nend\n";
    assert_eq!(converted("a1,a2,b\n0,3,1\n0,-1,7\n", "ext"), strip);
    assert_eq!(converted("a1,a2,b\n1,0,0\n-1,0,-1\n", "ext"), "V-representation\nbegin\n0 3 integer\nend\n");
    let point = "H-representation\nlinearity 2 1 2\nbegin\n2 3 rational\n-1/2 1 0\n-3 0 1\nend\n";
    assert_eq!(converted("V-representation\nbegin\n1 3 real\n1 0.5 3\nend\n", "ine"), point);
}

#[test]
fn a_fit_is_written_as_a_representation_of_its_feasible_set() {
    let fit = "fit - --x x --y y --eps 1";
    let table = b"x,y\n0,0\n1,1\n2,3\n";
    let expected = shape(&report(&root(), fit, table)["fps"]);
    for format in ["ine", "ext"] {
        let text = printed_with_input(&root(), &format!("{fit} --format {format}"), table);
        assert_eq!(shape(&answer(&text)["region"]), expected, "{text}");
    }
}
