//! The parts of the report of an answer.

use boundfit_exact::english::list;
use boundfit_exact::{Integer, Rational};
use boundfit_geometry::{Boundary, Direction, Vertex};
use boundfit_judge::{Basis, BasisStatus, Face, Prices, SideMultiplier};
use boundfit_lp::ModelRow;

use super::{Report, basis_name, priced, side_name};
use crate::document::{Block, Inline, Table, Text};
use crate::formula::absurdity;
use crate::region::kind_text;

/// Rows up to which a table has all of them.
const FEW_ROWS: usize = 20;

impl Report<'_> {
    /// Optimum, optimal points, prices, basis and proof.
    pub(super) fn optimal(
        &self,
        value: &Rational,
        face: &Face,
        prices: &Prices,
        basis: &Basis,
    ) -> Vec<Block<'static>> {
        let is_level = self.plane.gain().iter().all(Rational::is_zero);
        let place = match (face.vertices.len(), face.rays.len(), face.lines.len()) {
            (1, 0, 0) => "at one point",
            _ if is_level => "wherever it is feasible",
            (2, ..) => "all along an edge",
            (1, ..) => "all along a ray",
            _ => "all along a line",
        };
        let title = Text::from("Optimal: ").then(self.value(value)).words(format!(", {place}"));
        let mut blocks = vec![Block::Title(title)];
        blocks.extend(self.endless("the optimum goes on", &face.rays, &face.lines));
        let points: Vec<&Vec<Rational>> = face.vertices.iter().chain(&face.points).collect();
        let first = points.first().map_or(&[][..], |first| first.as_slice());
        blocks.push(self.columns(first, prices, basis));
        blocks.extend(self.rows(first, prices, basis));
        if points.len() > 1 {
            let label = if face.vertices.is_empty() { "Optimal points" } else { "Optimal vertices" };
            blocks.push(Block::Title(label.into()));
            blocks.push(self.points(&points));
        }
        let terms: Vec<_> = priced(self.model, &prices.rows, &prices.columns).collect();
        blocks.push(Block::Space);
        blocks.push(Block::Paragraph(if terms.is_empty() {
            Text::from("Proof: ").then(self.value(value)).words(" at every point.")
        } else {
            let proof = Text::from("Proof: ").then(self.proof(terms.into_iter()));
            proof.words(" gives ").then(self.bound(value)).words(".")
        }));
        blocks
    }

    /// The certificate.
    pub(super) fn infeasible(&self, multipliers: &[SideMultiplier]) -> Vec<Block<'static>> {
        let title = "Infeasible: no point fulfils all rows and bounds";
        let terms = multipliers.iter().map(|term| (term.side, &term.value));
        let sum: Rational = multipliers.iter().map(|term| -self.taken(term)).sum();
        let proof = Text::from("Proof: ").then(self.proof(terms));
        let proof = absurdity(proof, &sum, self.style).words(".");
        vec![Block::Title(title.into()), Block::Paragraph(proof)]
    }

    /// A multiplied bound, as it counts in `0 ≥ sum`.
    fn taken(&self, SideMultiplier { side, value }: &SideMultiplier) -> Rational {
        side.bound(self.model).map_or_else(Rational::zero, |bound| bound * value)
            * Rational::from(side.sign())
    }

    /// A feasible point and a direction.
    pub(super) fn unbounded(&self, point: &[Rational], ray: &[Rational]) -> Vec<Block<'static>> {
        let title = Text::from("Unbounded: ").then(self.objective()).words(" improves for ever");
        let row = |((column, value), along): ((&boundfit_lp::ModelColumn, &Rational), &Rational)| {
            vec![Text::new().given(&column.name), self.number(value), self.number(along)]
        };
        let rows = self.model.columns.iter().zip(point).zip(ray).map(row).collect();
        let costs = self.model.columns.iter().map(|column| &column.cost);
        let change: Rational = costs.zip(ray).map(|(cost, entry)| cost * entry).sum();
        let proof =
            Text::from("Proof: from this feasible point each step in the direction stays feasible and adds ");
        let proof = proof.then(self.number(&change)).words(" to ").then(self.objective()).words(".");
        let table = Table::new(["column", "feasible point", "direction"], rows);
        vec![Block::Title(title), Block::Table(table), Block::Space, Block::Paragraph(proof)]
    }

    fn columns(&self, point: &[Rational], prices: &Prices, basis: &Basis) -> Block<'static> {
        let columns = self.model.columns.iter().zip(point).zip(&prices.columns).zip(&basis.columns);
        let rows = columns.map(|(((column, value), price), status)| {
            let name = Text::new().given(&column.name);
            vec![name, self.number(value), self.number(price), basis_name(*status).into()]
        });
        Block::Table(Table::new(["column", "value", "reduced cost", "basis"], rows.collect()))
    }

    /// All rows, or of many those that matter for the optimum.
    fn rows(&self, point: &[Rational], prices: &Prices, basis: &Basis) -> Vec<Block<'static>> {
        let all = self.model.rows.len();
        let rows = self.model.rows.iter().zip(&prices.rows).zip(&basis.rows);
        let matter = |price: &Rational, status: BasisStatus| !price.is_zero() || status != BasisStatus::Basic;
        let rows = rows.filter(|((_, price), status)| all <= FEW_ROWS || matter(price, **status));
        let row = |((row, price), status): ((&ModelRow, &Rational), &BasisStatus)| {
            let value = self.number(&row_value(row, point));
            vec![Text::new().given(&row.name), value, self.number(price), basis_name(*status).into()]
        };
        let rows: Vec<_> = rows.map(row).collect();
        let others = all - rows.len();
        if all == 0 {
            return Vec::new();
        }
        let mut blocks =
            vec![Block::Space, Block::Table(Table::new(["row", "value", "dual", "basis"], rows))];
        if others > 0 {
            blocks.push(Block::Paragraph(
                format!("The other {others} rows are basic, with a dual of 0.").into(),
            ));
        }
        blocks
    }

    /// Points by the columns that are left.
    fn points(&self, points: &[&Vec<Rational>]) -> Block<'static> {
        let row = |point: &&Vec<Rational>| {
            let entries = self.plane.columns().iter().filter_map(|&column| point.get(column));
            entries.map(|value| self.number(value)).collect()
        };
        Block::Table(Table::new(self.axes(), points.iter().map(row).collect()))
    }

    /// The names of the columns that are left.
    fn axes(&self) -> Vec<Text> {
        let names = self.plane.columns().iter().filter_map(|&column| self.model.columns.get(column));
        names.map(|column| Text::new().given(&column.name)).collect()
    }

    /// Returns the directions in which points go on for ever.
    fn endless(&self, what: &str, rays: &[Vec<Rational>], lines: &[Vec<Rational>]) -> Vec<Block<'static>> {
        let towards = |words: &str, direction: &Vec<Rational>| {
            let entries = self.plane.columns().iter().filter_map(|&column| direction.get(column));
            let entries = entries.map(|entry| Text::new().number(entry));
            let entries = Text::joined(entries, &Inline::Mark(", "));
            let words = format!("{what} for ever in {words} ");
            Block::Paragraph(Text::from(words).mark("(").then(entries).mark(")"))
        };
        let rays = rays.iter().map(|ray| towards("direction", ray));
        let lines = lines.iter().map(|line| towards("both directions of", line));
        rays.chain(lines).collect()
    }

    /// The set in the plane of the columns that are left; nothing where none are.
    pub(super) fn feasible_set(&self) -> Vec<Block<'static>> {
        if self.plane.columns().is_empty() {
            return Vec::new();
        }
        let region = self.plane.polyhedron().region();
        let names = |active: &[usize]| {
            let sides = active.iter().filter_map(|&index| self.plane.side(index));
            let names: Vec<String> = sides.map(|side| side_name(self.model, side)).collect();
            list(names.into_iter())
        };
        let row = |(number, vertex): (usize, &Vertex)| {
            let theta = vertex.point().coordinates();
            let entries = theta.iter().take(self.plane.columns().len()).map(|value| self.number(value));
            let mut row = vec![Text::new().number(number)];
            row.extend(entries);
            row.push(names(vertex.active()).into());
            row
        };
        let header = [vec!["vertex".into()], self.axes(), vec!["active".into()]].concat();
        let title = format!("Feasible set: {}", kind_text(region.kind(), region.vertices().len()));
        let rows = (1..).zip(region.vertices()).map(row).collect();
        let mut blocks = vec![Block::Title(title.into()), Block::Table(Table::new(header, rows))];
        let along = |direction: &Direction| {
            let entries = [direction.dx(), direction.dy()].map(|entry: &Integer| Rational::from(entry));
            self.plane.direction(&entries)
        };
        let rays: Vec<_> = region.rays().iter().map(along).collect();
        let lines: Vec<_> = region.lines().iter().map(along).collect();
        blocks.extend(self.endless("goes on", &rays, &lines));
        let bounded = |boundary: &Boundary| names(boundary.active());
        let boundaries = region.boundaries().iter().map(bounded).filter(|names| !names.is_empty());
        blocks.extend(boundaries.map(|names| Block::Paragraph(format!("bounded by {names}").into())));
        blocks
    }
}

/// The form of a row at a point.
pub(super) fn row_value(row: &ModelRow, point: &[Rational]) -> Rational {
    row.coefficients.iter().filter_map(|(column, value)| Some(value * point.get(*column)?)).sum()
}
