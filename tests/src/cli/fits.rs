//! Fits to ask the program for, with everything that the test can work out from the file alone.

use boundfit_exact::{Limits, Rational, Reading};
use serde_json::{Value, json};

use super::numbers::whole;
use super::proofs::{HalfPlane, Named, System};
use super::{directory_with, fixture, report};

/// One data row.
pub struct Measurement {
    pub row: usize,
    pub regressor: [Rational; 2],
    pub response: Rational,
    pub epsilon: Rational,
}

/// A fit of a small table with a header, and the kind of its FPS.
pub struct Case {
    pub kind: &'static str,
    pub csv: String,
    pub x: &'static str,
    pub y: &'static str,
    /// The uniform error bound; without one there is a column `eps`.
    pub epsilon: Option<&'static str>,
    pub rows: Option<[usize; 2]>,
    /// Conditions with their coefficients `a1, a2, b` in ≤ form.
    pub conditions: &'static [(&'static str, [i64; 3])],
    pub reading: Reading,
}

impl Case {
    /// A line through columns x and y.
    pub fn line(kind: &'static str, csv: &str, epsilon: &'static str) -> Self {
        Case {
            kind,
            csv: csv.to_owned(),
            x: "x",
            y: "y",
            epsilon: Some(epsilon),
            rows: None,
            conditions: &[],
            reading: Reading::Decimal,
        }
    }

    /// A model with the two regressors a and b.
    pub fn two_regressors(kind: &'static str, csv: &str, epsilon: &'static str) -> Self {
        Case { x: "a,b", ..Case::line(kind, csv, epsilon) }
    }

    /// The same with an error bound for each row, from a column `eps`.
    pub fn epsilon_column(self) -> Self {
        Case { epsilon: None, ..self }
    }

    /// The same under conditions.
    pub fn when(self, conditions: &'static [(&'static str, [i64; 3])]) -> Self {
        Case { conditions, ..self }
    }

    /// The command line, for the table in `data.csv`.
    pub fn command_line(&self) -> String {
        let mut line =
            format!("fit data.csv --x {} --y {} --reading {}", self.x, self.y, self.reading.name());
        match self.epsilon {
            Some(epsilon) => line += &format!(" --eps {epsilon}"),
            None => line += " --eps-column eps",
        }
        if let Some([first, last]) = self.rows {
            line += &format!(" --rows {first}..{last}");
        }
        for (condition, _) in self.conditions {
            line += &format!(" --where '{condition}'");
        }
        line
    }

    /// Returns what the program answers.
    pub fn report(&self) -> Value {
        let directory = directory_with(&[("data.csv", self.csv.as_bytes())]);
        report(directory.path(), &self.command_line(), b"")
    }

    fn read(&self, text: &str) -> Rational {
        self.reading.read(text, &Limits::default()).unwrap()
    }

    /// The rows that are fitted.
    pub fn measurements(&self) -> Vec<Measurement> {
        let mut lines = self.csv.lines().map(|line| line.split(',').collect::<Vec<_>>());
        let header = lines.next().unwrap();
        let column = |name: &str| header.iter().position(|own| *own == name).unwrap();
        let wanted = |row: &usize| self.rows.is_none_or(|[first, last]| (first..=last).contains(row));
        let rows = (1..).zip(lines).filter(|(row, _)| wanted(row));
        rows.map(|(row, cells)| {
            let cell = |name: &str| self.read(cells[column(name)]);
            let regressor = match self.x.split_once(',') {
                None => [cell(self.x), whole(1)],
                Some((first, second)) => [cell(first), cell(second)],
            };
            let epsilon = self.epsilon.map_or_else(|| cell("eps"), |epsilon| self.read(epsilon));
            Measurement { row, regressor, response: cell(self.y), epsilon }
        })
        .collect()
    }

    /// The half-planes of the FPS.
    pub fn system(&self) -> System {
        self.half_planes(|row| row.epsilon.clone(), |row| row.response.clone(), whole)
    }

    /// The half-planes at error bound 0.
    pub fn system_at_zero(&self) -> System {
        self.half_planes(|_| whole(0), |row| row.response.clone(), whole)
    }

    /// Returns the growth of each half-plane's right-hand side with the error bound, in the place of that side.
    pub fn growth(&self) -> System {
        let uniform = self.epsilon.is_some();
        let growth = |row: &Measurement| if uniform { whole(1) } else { row.epsilon.clone() };
        self.half_planes(growth, |_| whole(0), |_| whole(0))
    }

    fn half_planes(
        &self,
        epsilon: impl Fn(&Measurement) -> Rational,
        response: impl Fn(&Measurement) -> Rational,
        condition: impl Fn(i64) -> Rational,
    ) -> System {
        let mut all = Vec::new();
        let mut add = |name: Value, a: [Rational; 2], b: Rational| {
            all.push(Named { in_proofs: name.clone(), in_lists: name, half_plane: HalfPlane { a, b } });
        };
        for row in self.measurements() {
            let (epsilon, response) = (epsilon(&row), response(&row));
            let upper = &response + &epsilon;
            add(json!({"row": row.row, "bound": "upper"}), row.regressor.clone(), upper);
            let opposite = row.regressor.each_ref().map(|part| -part);
            add(json!({"row": row.row, "bound": "lower"}), opposite, epsilon - response);
        }
        for (number, (_, [a1, a2, b])) in (1..).zip(self.conditions) {
            let name = json!({"row": null, "bound": format!("where:{number}")});
            add(name, [whole(*a1), whole(*a2)], condition(*b));
        }
        System(all)
    }
}

/// Fits of published data, with a bounded FPS of positive slopes; the second reads the numbers as binary64.
pub fn published_polygons() -> Vec<Case> {
    let transducer = |reading| Case {
        x: "Vz",
        y: "z",
        rows: Some([14, 36]),
        reading,
        ..Case::line("polygon", &fixture("transducer/transducer.csv"), "0.5e-3")
    };
    let steam_generator = || Case::line("polygon", &fixture("steam-generator/steam_generator.csv"), "");
    vec![
        transducer(Reading::Decimal),
        transducer(Reading::Binary64),
        steam_generator().epsilon_column().when(&[("theta1 >= 0", [-1, 0, 0])]),
        steam_generator()
            .epsilon_column()
            .when(&[("theta1 >= 11", [-1, 0, -11]), ("theta2 <= -20", [0, 1, -20])]),
    ]
}

/// Fits whose FPS is of every kind, some of them in several ways.
pub fn all() -> Vec<Case> {
    let one = "x,y\n1,2\n";
    let zero = "a,b,y\n0,0,0\n";
    let mut cases = published_polygons();
    cases.extend([
        Case::line("polygon", "x,y\n0.5,1.02\n1,1.97\n1.5,3.05\n2,3.98\n2.5,5.01\n", "0.1"),
        Case::line("polygon", "x,y\n1,0\n2,0\n", "1"),
        Case::two_regressors("polygon", "a,b,y\n1,0,3\n0,1,2\n1,1,6\n0,0,0\n", "3/2"),
        Case::line("strip", "x,y\n5,2\n5,2.5\n5,1.5\n", "1"),
        Case::line("strip", one, "1"),
        Case::line("line", one, "0"),
        Case::line("line", "x,y\n5,2\n5,4\n", "1"),
        Case::line("point", "x,y\n1,2\n2,3\n4,5\n", "0"),
        Case::line("segment", "x,y,eps\n1,2,0\n2,3,1\n3,4,5\n", "").epsilon_column(),
        Case::line("ray", one, "0").when(&[("theta1 >= 0", [-1, 0, 0])]),
        Case::line("unbounded-polygon", one, "1").when(&[("theta1 >= 0", [-1, 0, 0])]),
        Case::two_regressors("unbounded-polygon", zero, "1")
            .when(&[("theta1 >= 0", [-1, 0, 0]), ("theta1 + theta2 >= 1", [-1, -1, -1])]),
        Case::two_regressors("half-plane", zero, "1").when(&[("2*theta1 - theta2 <= 1", [2, -1, 1])]),
        Case::two_regressors("half-plane", zero, "1").when(&[("theta1 <= 1", [1, 0, 1])]),
        Case::two_regressors("plane", zero, "0").when(&[("0*theta1 <= 0", [0, 0, 0])]),
        Case::line("empty", &fixture("norris/norris.csv"), "1/2"),
        Case::two_regressors("empty", "a,b,y\n0,0,5\n", "1"),
        Case::line("empty", "x,y\n3,1\n3,2\n", "1/3"),
        Case::line("empty", "x,y,eps\n1,0,1\n2,9,1/2\n3,0,1/4\n", "").epsilon_column(),
        Case::line("empty", one, "1").when(&[("theta1 >= 1", [-1, 0, -1]), ("theta1 <= 0", [1, 0, 0])]),
    ]);
    cases
}
