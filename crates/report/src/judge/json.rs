//! The JSON report of an exact answer, schema `boundfit/judge/1`.

use boundfit_exact::{Foreign, Interval, Rational};
use boundfit_judge::{Answer, Basis, Face, Item, Plane, Prices, Side, SideMultiplier};
use boundfit_lp::{Bounds, Model, ObjectiveSense};

use super::basis_name;
use super::tables::row_value;
use crate::answer::judge::{
    FaceJson, JudgeJson, ModelColumnJson, ModelJson, ModelRowJson, PlaneJson, SideJson, SideTermJson,
    SolutionJson,
};
use crate::answer::parts::{RangeJson, RegionJson};
use crate::json::to_text;
use crate::number::Number;
use crate::style::Style;

/// The material of every part of the document.
struct Parts<'a> {
    model: &'a Model,
    plane: &'a Plane,
    style: &'a Style,
}

impl JudgeJson {
    /// The document on the answer to a model, from the file of this name; `None` for standard input.
    pub fn new(
        model: &Model,
        plane: &Plane,
        answer: &Answer,
        file: Option<Foreign<&str>>,
        sha256: &str,
        style: &Style,
    ) -> Self {
        let parts = Parts { model, plane, style };
        let none = || JudgeJson {
            schema: Self::SCHEMA,
            input: parts.input(file, sha256),
            status: "optimal",
            objective: None,
            face: None,
            columns: parts.columns(None),
            rows: parts.rows(None),
            farkas: None,
            point: None,
            ray: None,
            plane: parts.plane(),
            solutions: Vec::new(),
        };
        match answer {
            Answer::Optimal { value, face, prices, basis } => {
                let first = face.vertices.iter().chain(&face.points).next();
                let solved = Solved { point: first.map_or(&[], Vec::as_slice), prices, basis };
                JudgeJson {
                    objective: Some(style.number(value)),
                    face: Some(parts.face(face)),
                    columns: parts.columns(Some(&solved)),
                    rows: parts.rows(Some(&solved)),
                    ..none()
                }
            }
            Answer::Infeasible { multipliers } => {
                let farkas = multipliers.iter().map(|term| parts.term(term)).collect();
                JudgeJson { status: "infeasible", farkas: Some(farkas), ..none() }
            }
            Answer::Unbounded { point, ray } => JudgeJson {
                status: "unbounded",
                point: Some(parts.vector(point)),
                ray: Some(parts.vector(ray)),
                ..none()
            },
        }
    }

    /// The document with what was found about solutions.
    #[must_use]
    pub fn with_solutions(self, solutions: Vec<SolutionJson>) -> Self {
        JudgeJson { solutions, ..self }
    }
}

/// The report as JSON, with a line end.
pub fn judge_json(report: &JudgeJson) -> String {
    to_text(report)
}

/// An optimum: its first point with prices and basis.
struct Solved<'a> {
    point: &'a [Rational],
    prices: &'a Prices,
    basis: &'a Basis,
}

impl Parts<'_> {
    fn input(&self, file: Option<Foreign<&str>>, sha256: &str) -> ModelJson {
        let model = self.model;
        ModelJson {
            file: file.map(Foreign::from),
            sha256: sha256.to_owned(),
            name: model.name.clone(),
            sense: if model.sense == ObjectiveSense::Minimize { "min" } else { "max" },
            objective: model.objective_name.clone(),
            constant: self.style.given_number(&model.constant),
        }
    }

    fn ends(&self, bounds: &Bounds) -> [Option<Number>; 2] {
        [&bounds.lower, &bounds.upper].map(|end| end.as_ref().map(|end| self.style.given_number(end)))
    }

    fn vector(&self, vector: &[Rational]) -> Vec<Number> {
        vector.iter().map(|entry| self.style.number(entry)).collect()
    }

    fn face(&self, face: &Face) -> FaceJson {
        let vectors = |vectors: &[Vec<Rational>]| vectors.iter().map(|vector| self.vector(vector)).collect();
        FaceJson {
            vertices: vectors(&face.vertices),
            points: vectors(&face.points),
            rays: vectors(&face.rays),
            lines: vectors(&face.lines),
        }
    }

    fn columns(&self, solved: Option<&Solved>) -> Vec<ModelColumnJson> {
        let of = |(index, column): (usize, &boundfit_lp::ModelColumn)| {
            let [lower, upper] = self.ends(&column.bounds);
            let number = |value: Option<&Rational>| value.map(|value| self.style.number(value));
            ModelColumnJson {
                name: column.name.clone(),
                lower,
                upper,
                cost: self.style.given_number(&column.cost),
                value: number(solved.and_then(|solved| solved.point.get(index))),
                reduced_cost: number(solved.and_then(|solved| solved.prices.columns.get(index))),
                basis: solved.and_then(|solved| solved.basis.columns.get(index)).map(|own| basis_name(*own)),
            }
        };
        self.model.columns.iter().enumerate().map(of).collect()
    }

    fn rows(&self, solved: Option<&Solved>) -> Vec<ModelRowJson> {
        let of = |(index, row): (usize, &boundfit_lp::ModelRow)| {
            let [lower, upper] = self.ends(&row.bounds);
            ModelRowJson {
                name: row.name.clone(),
                lower,
                upper,
                value: solved.map(|solved| self.style.number(&row_value(row, solved.point))),
                dual: solved.and_then(|solved| Some(self.style.number(solved.prices.rows.get(index)?))),
                basis: solved.and_then(|solved| solved.basis.rows.get(index)).map(|own| basis_name(*own)),
            }
        };
        self.model.rows.iter().enumerate().map(of).collect()
    }

    fn side(&self, side: Side) -> SideJson {
        let name =
            |index: usize, name: Option<&Foreign>| name.cloned().unwrap_or_else(|| index.to_string().into());
        let (row, column) = match side.item {
            Item::Row(index) => (Some(name(index, self.model.rows.get(index).map(|row| &row.name))), None),
            Item::Column(index) => {
                (None, Some(name(index, self.model.columns.get(index).map(|column| &column.name))))
            }
        };
        SideJson { row, column, side: side.end.name() }
    }

    fn term(&self, term: &SideMultiplier) -> SideTermJson {
        SideTermJson { side: self.side(term.side), multiplier: self.style.number(&term.value) }
    }

    fn plane(&self) -> PlaneJson {
        let polyhedron = self.plane.polyhedron();
        let names = self.plane.columns().iter().filter_map(|&column| self.model.columns.get(column));
        let count = self.plane.columns().len();
        let active = |indices: &[usize]| {
            let sides = indices.iter().filter_map(|&index| self.plane.side(index));
            sides.map(|side| self.side(side)).collect::<Vec<_>>().into()
        };
        let range = |interval: &Interval| RangeJson::new(interval, self.style);
        PlaneJson {
            columns: names.map(|column| column.name.clone()).collect(),
            region: RegionJson::new(
                polyhedron.region(),
                &polyhedron.region().measures(),
                self.style,
                active,
                None,
            ),
            ranges: polyhedron.bounding_box().map(|both| both.iter().take(count).map(range).collect()),
        }
    }
}
