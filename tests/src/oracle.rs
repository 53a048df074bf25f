//! The oracle: the region of integer half-planes by trying every pair of boundary lines, O(n³), in `i128`.
//! It shares no code with the engine; coefficients must stay below 2³¹.

use std::collections::BTreeSet;

/// `a1·θ1 + a2·θ2 ≤ b`.
pub type Row = [i128; 3];

/// The result of the oracle.
#[derive(Debug, Default, PartialEq, Eq)]
pub struct Answer {
    /// The kind's name in reports.
    pub kind: &'static str,
    /// Each vertex as a reduced triple `(x, y, w)`, `w > 0`, with the rows active there.
    pub vertices: BTreeSet<([i128; 3], Vec<usize>)>,
    /// Extreme recession directions that are not lines, coprime.
    pub rays: BTreeSet<[i128; 2]>,
    /// A basis of the lineality space, first non-zero component positive.
    pub lines: BTreeSet<[i128; 2]>,
}

fn gcd(a: i128, b: i128) -> i128 {
    if b == 0 { a.abs() } else { gcd(b, a % b) }
}

/// The region of the rows.
pub fn solve(rows: &[Row]) -> Answer {
    let slack = |[a, b, c]: Row, [x, y, w]: [i128; 3]| c * w - a * x - b * y;
    let feasible = |point: &[i128; 3]| rows.iter().all(|&row| slack(row, *point) >= 0);
    let reduce = |[x, y, w]: [i128; 3]| {
        let divisor = gcd(gcd(x, y), w) * w.signum();
        [x / divisor, y / divisor, w / divisor]
    };
    let direction = |[x, y]: [i128; 2]| [x / gcd(x, y), y / gcd(x, y)];
    let normals: Vec<Row> = rows.iter().copied().filter(|row| row[..2] != [0, 0]).collect();

    let mut meets: BTreeSet<[i128; 3]> = BTreeSet::new();
    for [a, b, c] in &normals {
        for [d, e, f] in &normals {
            let w = a * e - b * d;
            if w != 0 {
                meets.insert(reduce([c * e - f * b, a * f - d * c, w]));
            }
        }
    }
    let vertices: Vec<[i128; 3]> = meets.into_iter().filter(feasible).collect();
    let feet = normals.iter().map(|&[a, b, c]| reduce([a * c, b * c, a * a + b * b]));
    let feet: BTreeSet<[i128; 3]> = feet.filter(feasible).collect();

    let recedes = |d: &[i128; 2]| rows.iter().all(|[a, b, _]| a * d[0] + b * d[1] <= 0);
    let along = normals.iter().flat_map(|[a, b, _]| [[-b, *a], [*b, -a]]).map(direction);
    let along: BTreeSet<[i128; 2]> = along.filter(recedes).collect();
    let mut answer = Answer::default();
    let lines: Vec<[i128; 2]> = along.iter().copied().filter(|[x, y]| along.contains(&[-x, -y])).collect();
    answer.lines = lines.iter().copied().filter(|d| *d > [0, 0]).collect();
    answer.rays = if lines.is_empty() {
        along
    } else {
        normals.iter().map(|[a, b, _]| direction([-a, -b])).filter(recedes).collect()
    };
    answer.kind = match (vertices.len(), feet.len(), answer.rays.len(), lines.len()) {
        _ if !feasible(&[0, 0, 1]) && vertices.is_empty() && feet.is_empty() => "empty",
        _ if normals.is_empty() => "plane",
        (_, _, 1, 2) => "half-plane",
        (_, 1, 0, 2) => "line",
        (_, _, 0, 2) => "strip",
        (1, _, 0, _) => "point",
        (2, _, 0, _) => "segment",
        (_, _, 0, _) => "polygon",
        (1, _, 1, _) => "ray",
        _ => "unbounded-polygon",
    };
    if answer.kind == "empty" {
        return Answer { kind: "empty", ..Answer::default() };
    }
    if answer.kind == "plane" {
        answer.lines = [[1, 0], [0, 1]].into();
    }
    let active =
        |vertex| (0..rows.len()).filter(|&i| rows[i][..2] != [0, 0] && slack(rows[i], vertex) == 0).collect();
    answer.vertices = vertices.into_iter().map(|vertex| (vertex, active(vertex))).collect();
    answer
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_kind_by_hand() {
        let (left, right, down, up) = ([-1, 0, 0], [1, 0, 0], [0, -1, 0], [0, 1, 0]);
        let cases: [(&str, &[Row]); 13] = [
            ("plane", &[]),
            ("plane", &[[0, 0, 0]]),
            ("empty", &[[0, 0, -1]]),
            ("half-plane", &[left]),
            ("strip", &[left, [1, 0, 1]]),
            ("line", &[left, right]),
            ("ray", &[left, right, down]),
            ("segment", &[left, right, down, [0, 1, 1]]),
            ("point", &[left, right, down, up]),
            ("polygon", &[left, down, [1, 1, 1]]),
            ("unbounded-polygon", &[left, down]),
            ("unbounded-polygon", &[left, down, [0, 1, 1]]),
            ("empty", &[left, [1, 0, -1]]),
        ];
        for (kind, rows) in cases {
            assert_eq!(solve(rows).kind, kind, "{rows:?}");
        }
        let triangle = solve(&[left, down, [2, 3, 6], [1, 1, 3]]);
        let expected = [([0, 0, 1], vec![0, 1]), ([0, 2, 1], vec![0, 2]), ([3, 0, 1], vec![1, 2, 3])];
        assert_eq!(triangle.vertices, expected.into());
        assert_eq!(solve(&[left, [-1, 1, 0]]).rays, [[0, -1], [1, 1]].into());
        assert_eq!(solve(&[[-2, -4, 1]]).rays, [[1, 2]].into());
        assert_eq!(solve(&[[-2, -4, 1]]).lines, [[2, -1]].into());
    }
}
