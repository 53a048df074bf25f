//! A region of a report against the half-planes of its file.

use boundfit_exact::{Integer, Rational};
use serde_json::Value;

use super::numbers::{exact_or_null, pair, whole};
use super::proofs::System;

type Point = [Rational; 2];

/// Returns what a kind of region has: vertices and rays from least to most, lines, boundary lines, and its area when fixed.
fn parts_of(kind: &str) -> ([usize; 2], [usize; 2], usize, usize, Option<&'static str>) {
    const MANY: usize = usize::MAX;
    match kind {
        "empty" => ([0, 0], [0, 0], 0, 0, None),
        "point" => ([1, 1], [0, 0], 0, 0, Some("0")),
        "segment" => ([2, 2], [0, 0], 0, 0, Some("0")),
        "ray" => ([1, 1], [1, 1], 0, 0, Some("0")),
        "line" => ([0, 0], [0, 0], 1, 1, Some("0")),
        "polygon" => ([3, MANY], [0, 0], 0, 0, None),
        "unbounded-polygon" => ([1, MANY], [1, 2], 0, 0, None),
        "strip" => ([0, 0], [0, 0], 1, 2, None),
        "half-plane" => ([0, 0], [1, 1], 1, 1, None),
        "plane" => ([0, 0], [0, 0], 2, 0, None),
        kind => panic!("no kind {kind}"),
    }
}

/// Checks a region.
/// - Its parts fit its kind.
/// - At every vertex and boundary exactly the half-planes that it names are tight.
/// - The order is the documented one.
/// - Directions are recession directions, and emptiness is proved.
pub fn check_region(region: &Value, system: &System) {
    let kind = region["kind"].as_str().unwrap();
    let list = |name: &str| region[name].as_array().unwrap();
    let (vertices, rays, lines, boundaries, area) = parts_of(kind);
    assert!((vertices[0]..=vertices[1]).contains(&list("vertices").len()), "{region}");
    assert!((rays[0]..=rays[1]).contains(&list("rays").len()), "{region}");
    assert_eq!((list("lines").len(), list("boundaries").len()), (lines, boundaries), "{region}");
    assert_eq!(region["certificate"].is_null(), kind != "empty", "{region}");
    assert_eq!(region["witness"].is_null(), kind == "empty", "{region}");
    if kind == "empty" {
        system.check_farkas(&region["certificate"]["farkas"]);
    } else {
        assert!(system.contains(&pair(&region["witness"])), "{region}");
    }
    check_vertices(region, system);
    for boundary in list("boundaries") {
        check_boundary(boundary, system);
    }
    check_directions(region, system);
    let area = if kind == "polygon" { Some(shoelace(&corners(region))) } else { area.map(|_| whole(0)) };
    assert_eq!(exact_or_null(&region["area"]), area, "{region}");
}

fn corners(region: &Value) -> Vec<Point> {
    region["vertices"].as_array().unwrap().iter().map(|vertex| pair(&vertex["theta"])).collect()
}

/// Vertices belong to the region, are named by exactly the half-planes that are tight there, and stand in order.
fn check_vertices(region: &Value, system: &System) {
    let corners = corners(region);
    let vertices = region["vertices"].as_array().unwrap();
    for (corner, vertex) in corners.iter().zip(vertices) {
        assert!(system.contains(corner), "{vertex}");
        assert_eq!(Value::from(system.active(corner)), vertex["active"], "{vertex}");
    }
    assert_eq!(corners.iter().min(), corners.first(), "{region}");
    // From each corner to the next there is a side, with all other corners to its left; an open region lacks one.
    let share = |one: usize, other: usize| {
        let [one, other] = [one, other].map(|index| vertices[index]["active"].as_array().unwrap());
        one.iter().any(|name| other.contains(name))
    };
    let count = corners.len();
    let is_side = |from: usize| {
        let to = (from + 1) % count;
        let left = |&other: &usize| is_left(&corners[from], &corners[to], &corners[other]);
        share(from, to) && (0..count).filter(|&other| other != from && other != to).all(|other| left(&other))
    };
    if count >= 3 {
        let missing = (0..count).filter(|&from| !is_side(from)).count();
        assert_eq!(missing, usize::from(region["kind"] != "polygon"), "{region}");
    } else if count == 2 {
        assert!(share(0, 1) && corners[0] < corners[1], "{region}");
    }
}

/// Returns whether a point lies strictly to the left of the line from one point to another.
fn is_left(from: &Point, to: &Point, point: &Point) -> bool {
    let [along, across] = [to, point].map(|end| [&end[0] - &from[0], &end[1] - &from[1]]);
    (&along[0] * &across[1] - &along[1] * &across[0]).is_positive()
}

fn shoelace(corners: &[Point]) -> Rational {
    let next = corners.iter().cycle().skip(1);
    corners
        .iter()
        .zip(next)
        .map(|(one, other)| &one[0] * &other[1] - &one[1] * &other[0])
        .sum::<Rational>()
        .half()
}

/// A boundary line belongs to the region, and the half-planes tight all along it are the ones named.
fn check_boundary(boundary: &Value, system: &System) {
    let first = system.listed(&boundary["active"][0]);
    let scale = first.b.checked_div(&first.along(&first.a)).unwrap();
    let foot = [&first.a[0] * &scale, &first.a[1] * &scale];
    let along = [-&first.a[1], first.a[0].clone()];
    let further = [&foot[0] + &along[0], &foot[1] + &along[1]];
    for point in [foot, further] {
        assert!(system.contains(&point), "{boundary}");
        assert_eq!(Value::from(system.active(&point)), boundary["active"], "{boundary}");
    }
}

/// Rays and lines are coprime integers, are recession directions, and rays are extreme.
fn check_directions(region: &Value, system: &System) {
    let directions = |name: &str| -> Vec<Point> {
        let directions: Vec<Point> = region[name].as_array().unwrap().iter().map(pair).collect();
        for direction in &directions {
            let [x, y] = direction.each_ref().map(Rational::numerator);
            assert_eq!(x.gcd(&y), Integer::one(), "{region}");
            assert!(direction.iter().all(|part| part.denominator() == Integer::one()), "{region}");
        }
        directions
    };
    let (rays, lines) = (directions("rays"), directions("lines"));
    assert!(rays.len() < 2 || rays[0] != rays[1], "{region}");
    for named in &system.0 {
        assert!(rays.iter().all(|ray| !named.half_plane.along(ray).is_positive()), "{region} {named:?}");
        assert!(lines.iter().all(|line| named.half_plane.along(line).is_zero()), "{region} {named:?}");
    }
    for line in &lines {
        let first = line.iter().find(|part| !part.is_zero()).unwrap();
        assert!(first.is_positive(), "{region}");
    }
    for ray in &rays {
        let is_extreme = match lines.first() {
            Some(line) => (&line[0] * &ray[0] + &line[1] * &ray[1]).is_zero(),
            None => system
                .0
                .iter()
                .any(|named| !named.half_plane.is_trivial() && named.half_plane.along(ray).is_zero()),
        };
        assert!(is_extreme, "{region}");
    }
}
