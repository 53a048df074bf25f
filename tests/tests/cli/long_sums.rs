//! Areas and centroids of sets with many vertices, whose fractions have thousands of digits.

use boundfit_exact::{Limits, Rational, Reading, Rounding};
use boundfit_tests::cli::{boundfit, directory_with, printed};
use serde_json::Value;

/// A smooth curve at uneven places, printed as programs print doubles: each reading shapes the set with a denominator of its
/// own.
fn curve(rows: u32) -> String {
    let mut seed = 1_u64;
    let mut places: Vec<f64> = (0..rows)
        .map(|_| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64 / 2_f64.powi(51)
        })
        .collect();
    places.sort_by(f64::total_cmp);
    let lines = places.iter().map(|x| format!("{x:.15},{:.15}\n", x.sqrt()));
    format!("x,y\n{}", lines.collect::<String>())
}

const FIT: &str = "fit curve.csv --x x --y y --eps 0.5 --no-lp";

fn number(value: &Value) -> Rational {
    let limits = Limits { digits: usize::MAX, exponent: u32::MAX };
    Reading::Decimal.read(value["exact"].as_str().unwrap(), &limits).unwrap()
}

fn corners(report: &Value) -> Vec<[Rational; 2]> {
    let vertices = report["fps"]["vertices"].as_array().unwrap().iter();
    vertices.map(|vertex| [0, 1].map(|axis| number(&vertex["theta"][axis]))).collect()
}

/// Twice the signed area of the triangle of the origin and each edge, with the sum of both ends.
fn triangles(corners: &[[Rational; 2]]) -> impl Iterator<Item = (Rational, [Rational; 2])> {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(p, q)| (&p[0] * &q[1] - &p[1] * &q[0], [&p[0] + &q[0], &p[1] + &q[1]]))
}

/// Returns the text behind a label of the text report, up to the next label, on one line.
fn said<'a>(text: &'a str, label: &str) -> String {
    let mut lines = text.lines().map(str::trim).skip_while(|line| !line.starts_with(label));
    let first = lines.next().unwrap();
    let labels = ["area", "centroid", "diameter", "least squares"];
    let rest = lines.take_while(|line| !labels.iter().any(|label| line.starts_with(label)));
    [first.strip_prefix(label).unwrap().trim()].into_iter().chain(rest).collect::<Vec<&'a str>>().join(" ")
}

#[test]
fn digits_and_fractions_of_long_sums_are_those_of_naive_ones() {
    let directory = directory_with(&[("curve.csv", curve(150).as_bytes())]);
    let report: Value =
        serde_json::from_str(&printed(directory.path(), &format!("{FIT} --format json"))).unwrap();
    let corners = corners(&report);
    assert!(corners.len() > 60, "{}", corners.len());
    let doubled: Rational = triangles(&corners).map(|(doubled, _)| doubled).sum();
    let area = doubled.half();
    assert_eq!(number(&report["fps"]["area"]), area);
    let width = |axis: usize| number(&report["pui"][axis]["upper"]) - number(&report["pui"][axis]["lower"]);
    let tightness = area.checked_div(&(width(0) * width(1))).unwrap();
    assert_eq!(number(&report["tightness"]), tightness);
    let centroid = [0, 1].map(|axis| {
        let moment: Rational = triangles(&corners).map(|(doubled, sum)| doubled * &sum[axis]).sum();
        moment.checked_div(&(&area * Rational::from(6))).unwrap()
    });
    assert_eq!([0, 1].map(|axis| number(&report["area_centroid"][axis])), centroid);
    for digits in [5, 12, 30] {
        let text = printed(directory.path(), &format!("{FIT} --full --digits {digits}"));
        let shown = |value: &Rational| value.to_decimal(digits, Rounding::Nearest);
        assert_eq!(said(&text, "area"), format!("{}, {} of its PUI box", shown(&area), shown(&tightness)));
        assert_eq!(said(&text, "centroid"), format!("({}, {})", shown(&centroid[0]), shown(&centroid[1])));
    }
    let text = printed(directory.path(), &format!("{FIT} --full --exact"));
    assert_eq!(said(&text, "area"), format!("{area}, {tightness} of its PUI box"));
    assert_eq!(said(&text, "centroid"), format!("({}, {})", centroid[0], centroid[1]));
}

#[test]
fn fractions_beyond_the_limit_are_left_out_with_the_reason() {
    let directory = directory_with(&[("curve.csv", curve(3000).as_bytes())]);
    let report: Value =
        serde_json::from_str(&printed(directory.path(), &format!("{FIT} --format json"))).unwrap();
    assert!(report["fps"]["vertices"].as_array().unwrap().len() > 1000);
    let reason = "the exact fraction takes more than 10000 digits (the limit 'fraction')";
    let text = printed(directory.path(), &format!("{FIT} --full --exact"));
    let decimal = |part: &Value| {
        assert_eq!(part["exact"], Value::Null);
        let (decimal, value) = (part["decimal"].as_str().unwrap(), part["value"].as_f64().unwrap());
        assert!((decimal.parse::<f64>().unwrap() / value - 1.0).abs() < 5e-5, "{part}");
        value
    };
    let area = decimal(&report["fps"]["area"]);
    let centroid = [0, 1].map(|axis| decimal(&report["area_centroid"][axis]));
    decimal(&report["tightness"]);
    for part in ["fps.area", "area_centroid", "tightness"] {
        assert_eq!(report["reasons"][part], reason, "{part}");
    }
    assert_eq!(said(&text, "area").matches(reason).count(), 2);
    assert_eq!(said(&text, "centroid").matches(reason).count(), 2);
    // The shoelace formula in doubles around the centroid, where it cancels little.
    let corners: Vec<[f64; 2]> = report["fps"]["vertices"]
        .as_array()
        .unwrap()
        .iter()
        .map(|vertex| [0, 1].map(|axis| vertex["theta"][axis]["value"].as_f64().unwrap() - centroid[axis]))
        .collect();
    let next = corners.iter().cycle().skip(1);
    let doubled: f64 = corners.iter().zip(next).map(|(p, q)| p[0] * q[1] - p[1] * q[0]).sum();
    assert!((doubled / 2.0 / area - 1.0).abs() < 1e-9, "{doubled} {area}");
    // Whoever asks for more gets it.
    let longer = printed(directory.path(), &format!("{FIT} --format json --limit fraction=1000000"));
    let longer: Value = serde_json::from_str(&longer).unwrap();
    let exact = number(&longer["fps"]["area"]);
    assert_eq!((exact.to_f64().to_bits(), longer["reasons"]["fps.area"].is_null()), (area.to_bits(), true));
    assert!(longer["fps"]["area"]["exact"].as_str().unwrap().len() > 20_000);
}

#[test]
fn polygons_of_any_half_planes_have_the_limit_too() {
    let directory = directory_with(&[("square.csv", b"a1,a2,b\n3,0,1\n-1,0,0\n0,7,1\n0,-1,0\n" as &[u8])]);
    let report: Value = serde_json::from_str(&printed(
        directory.path(),
        "polygon square.csv --format json --limit fraction=1",
    ))
    .unwrap();
    let reason = "the exact fraction takes more than 1 digit (the limit 'fraction')";
    assert_eq!(report["region"]["area"]["exact"], Value::Null);
    assert_eq!(report["region"]["area"]["decimal"], "4.7619e-2");
    assert_eq!(report["reasons"]["region.area"], reason);
    assert_eq!(report["reasons"]["area_centroid"], reason);
    assert_eq!(report["area_centroid"][0]["exact"], Value::Null);
    let text = printed(directory.path(), "polygon square.csv --exact --limit fraction=1");
    assert_eq!(said(&text, "area"), format!("about 0.047619 ({reason})"));
    let longer: Value = serde_json::from_str(&printed(
        directory.path(),
        "polygon square.csv --format json --limit fraction=3",
    ))
    .unwrap();
    assert_eq!(longer["region"]["area"]["exact"], "1/21");
    assert!(longer["reasons"]["region.area"].is_null());
    let refused = boundfit(directory.path(), "polygon square.csv --limit fraction=0");
    assert_eq!(refused.status, 2);
    assert!(
        refused
            .stderr
            .contains("\"0\" is no value of the limit fraction (expected an integer from 1 to 1000000)"),
        "{}",
        refused.stderr
    );
}
