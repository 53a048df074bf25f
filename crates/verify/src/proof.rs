//! A proof, and the half-planes that it speaks of.

use std::collections::BTreeMap;
use std::io::Read;

use boundfit_exact::{Foreign, Limits, Rational, Reading};

use crate::cells::Model;
use crate::failure::{DataLimits, Failure};
use crate::falsehood::Falsehood;
use crate::name::{Name, Named};
use crate::plane::{HalfPlane, Vector};
use crate::rows::{self, Cells, Rows};
use crate::shape::{Condition, EndShape, MultiplesShape, NotAProof, Number, Quantity, Shape, needed};
use crate::statements::Statement;
use crate::whole_set::WholeSet;

/// A proof, whose statements may be true or false.
#[derive(Debug, Clone)]
pub struct Proof {
    pub(crate) sha256: String,
    pub(crate) about: About,
    pub(crate) body: Body,
}

/// What a proof states.
#[derive(Debug, Clone)]
pub(crate) enum Body {
    /// Version 1: all about one set.
    Whole(WholeSet),
    /// Version 2: statements, each by itself.
    Statements(Vec<Statement>),
}

/// Which half-planes, and how many times each is taken.
pub(crate) type Multiples = Vec<(Named, Rational)>;
/// Multipliers, point and ray of one end of a range.
pub(crate) type End = (Multiples, Vector, Vector);

pub(crate) fn multiples(shape: MultiplesShape) -> Multiples {
    shape.into_iter().map(|(name, Number(times))| (name, times)).collect()
}

pub(crate) fn vector([x, y]: [Number; 2]) -> Vector {
    [x.0, y.0]
}

pub(crate) fn end((terms, point, ray): EndShape) -> End {
    (multiples(terms), vector(point), vector(ray))
}

/// What a proof is about: which rows of the data, how they are read, and what they say about the parameters.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct About {
    /// What separates cells: a comma, a semicolon, a tab or a bar.
    pub delimiter: char,
    /// Whether the first row names the columns.
    pub header: bool,
    /// The first and the last of rows that follow each other, then those of the next ones, from 1.
    pub rows: Vec<u64>,
    /// Which exact number a text stands for.
    pub reading: Reading,
    /// φ1, φ2, y and ε: a column, from 1, and how many times it is taken. Column 0 holds 1 in every row.
    pub model: [(u64, Rational); 4],
    /// The columns whose sum is added to y, each so many times.
    pub response: Vec<(u64, Rational)>,
    /// What is taken from each number of the column of φ1, before it is multiplied.
    pub x_origin: Rational,
    /// How far φ1 may be from what is read: a column, and how many times it is taken.
    pub x_error: Option<(u64, Rational)>,
    /// The columns of lower and of upper bounds, in place of y and ε.
    pub interval: Option<[Option<u64>; 2]>,
    /// How far φ·θ may be above and below y beside ε: the sum of these quantities of columns, each so many times.
    pub law: Option<[Vec<(Quantity, u64, Rational)>; 2]>,
    /// a1, a2 and b of a1·θ1 + a2·θ2 ≤ b, and whether both sides are equal.
    pub conditions: Vec<([Rational; 3], bool)>,
}

impl Proof {
    /// Reads a proof from its file, whose numbers may have ten times as many digits as those of the data: they are computed
    /// from several of these. Cost: linear in the file but for very long numbers.
    ///
    /// # Errors
    /// What keeps it from being a proof.
    pub fn read(text: &[u8], limits: &Limits) -> Result<Self, NotAProof> {
        let mut shape = Shape::read(text, limits.digits.saturating_mul(10))?;
        let body = match shape.schema.raw() {
            "boundfit/proof/1" => Body::Whole(WholeSet::read(&mut shape)?),
            "boundfit/proof/2" => {
                let statements = needed(shape.statements.take(), "statements")?;
                if statements.is_empty() {
                    return Err(NotAProof::new("it states nothing"));
                }
                Body::Statements(statements.into_iter().map(Statement::read).collect::<Result<_, _>>()?)
            }
            _ => return Err(NotAProof::new("another schema")),
        };
        if shape.has_more(matches!(body, Body::Statements(_))) {
            return Err(NotAProof::new("a field of another version"));
        }
        Ok(Proof { sha256: shape.sha256.raw().to_owned(), about: About::read(shape), body })
    }

    /// What it is about, whether it is true or not.
    pub fn about(&self) -> &About {
        &self.about
    }
}

impl About {
    fn read(shape: Shape) -> Self {
        let terms =
            |terms: Vec<(u64, Number)>| terms.into_iter().map(|(column, Number(times))| (column, times));
        let law = |terms: Vec<(Quantity, u64, Number)>| {
            terms.into_iter().map(|(quantity, column, Number(times))| (quantity, column, times)).collect()
        };
        About {
            delimiter: char::from(shape.delimiter.0),
            header: shape.header,
            rows: shape.rows,
            reading: shape.reading,
            model: shape.model.map(|(column, Number(times))| (column, times)),
            response: terms(shape.response.unwrap_or_default()).collect(),
            x_origin: shape.x_origin.map_or_else(Rational::zero, |Number(origin)| origin),
            x_error: shape.x_error.map(|(column, Number(times))| (column, times)),
            interval: shape.interval,
            law: shape.law.map(|sides| sides.map(law)),
            conditions: shape
                .conditions
                .into_iter()
                .map(|Condition { numbers, is_equation }| (numbers, is_equation))
                .collect(),
        }
    }

    /// The rows of the data, of which the cells that are needed are kept.
    pub(crate) fn open<R: Read>(&self, data: R, limits: &DataLimits) -> Result<Rows<R>, Failure> {
        let kept = self.columns().map(|column| usize::try_from(column).unwrap_or(usize::MAX)).max();
        let shape = rows::Shape {
            delimiter: u8::try_from(self.delimiter).unwrap_or(b','),
            kept: kept.unwrap_or_default(),
            longest: limits.row,
            columns: limits.columns,
        };
        Rows::new(data, shape)
    }

    /// The names of the columns, from the cells of a header.
    pub(crate) fn names(&self, header: Cells<'_>) -> BTreeMap<u64, Foreign> {
        let name = |column: u64| {
            let cell = header.get(usize::try_from(column).ok()?)?;
            Some((column, Foreign::from(String::from_utf8_lossy(cell).trim())))
        };
        self.columns().filter_map(name).collect()
    }

    /// Every column that is named, 0 too.
    pub fn columns(&self) -> impl Iterator<Item = u64> {
        let model = self.model.iter().map(|(column, _)| *column);
        let interval = self.interval.iter().flatten().flatten().copied();
        let law = self.law.iter().flatten().flatten().map(|(_, column, _)| *column);
        let others = self.response.iter().chain(&self.x_error).map(|(column, _)| *column);
        model.chain(interval).chain(law).chain(others)
    }

    /// Hands over each half-plane of the wanted rows, then of the conditions, by its name and what computes it (section 2).
    pub(crate) fn for_each_half_plane<R: Read>(
        &self,
        rows: &mut Rows<R>,
        limits: &DataLimits,
        longest_vertex: u64,
        mut take: impl FnMut(Name, &dyn Fn() -> HalfPlane) -> Result<(), Falsehood>,
    ) -> Result<(), Failure> {
        self.for_each_row(rows, limits, longest_vertex, |row, model| {
            let [lower, upper] = model.sides();
            if lower {
                take(Name::Lower(row), &|| model.lower())?;
            }
            if upper {
                take(Name::Upper(row), &|| model.upper())?;
            }
            Ok(())
        })?;
        for (name, half_plane) in self.conditions_by_name() {
            take(name, &|| half_plane.clone())?;
        }
        Ok(())
    }

    /// The half-planes of the conditions.
    pub(crate) fn conditions_by_name(&self) -> impl Iterator<Item = (Name, HalfPlane)> {
        (1..).zip(&self.conditions).flat_map(|(number, (numbers, is_equation))| {
            let half_plane = HalfPlane::new(numbers);
            let opposite = is_equation.then(|| (Name::WhereLower(number), half_plane.opposite()));
            let name = if *is_equation { Name::WhereUpper(number) } else { Name::Where(number) };
            [(name, half_plane)].into_iter().chain(opposite)
        })
    }

    /// Hands over each wanted row as it is read (section 2).
    pub(crate) fn for_each_row<R: Read>(
        &self,
        rows: &mut Rows<R>,
        limits: &DataLimits,
        longest_vertex: u64,
        mut take: impl FnMut(u64, &Model) -> Result<(), Falsehood>,
    ) -> Result<(), Failure> {
        let mut model = Model::new(self, limits, longest_vertex);
        let start = rows.count();
        for [first, last] in ascending(&self.rows)? {
            while rows.count() - start < first - 1 {
                if !rows.next()? {
                    return Err(Falsehood::MissingRow(first).into());
                }
            }
            for row in first..=last {
                if !rows.next()? {
                    return Err(Falsehood::MissingRow(row).into());
                }
                model.read_row(row, rows.cells())?;
                take(row, &model)?;
            }
        }
        Ok(())
    }
}

/// The ranges that pairs of a first and a last row make, which ascend from 1 on.
pub(crate) fn ascending(ends: &[u64]) -> Result<Vec<[u64; 2]>, Falsehood> {
    let mut before = 0;
    let mut ranges = Vec::new();
    for range in ends.chunks(2) {
        let &[first, last] = range else { return Err(Falsehood::NoRows) };
        if first <= before || last < first {
            return Err(Falsehood::NoRows);
        }
        ranges.push([first, last]);
        before = last;
    }
    if ranges.is_empty() { Err(Falsehood::NoRows) } else { Ok(ranges) }
}

/// Half-planes by name.
pub(crate) struct HalfPlanes(pub(crate) BTreeMap<Name, HalfPlane>);

impl HalfPlanes {
    pub(crate) fn get(&self, name: &Named) -> Result<(Name, &HalfPlane), Falsehood> {
        match name {
            Named::A(name) => match self.0.get(name) {
                Some(half_plane) => Ok((*name, half_plane)),
                None => Err(Falsehood::UnknownHalfPlane(name.to_string().into())),
            },
            Named::NoHalfPlane(text) => Err(Falsehood::UnknownHalfPlane(text.clone())),
        }
    }

    /// a and b of the sum of positive multiples of at most `most` half-planes. Every point of all of them is in it.
    pub(crate) fn sum(&self, multiples: &Multiples, most: usize) -> Result<(Vector, Rational), Falsehood> {
        if multiples.len() > most {
            return Err(Falsehood::TooManyMultipliers(most));
        }
        let mut sum = (Vector::default(), Rational::zero());
        for (name, times) in multiples {
            let (name, half_plane) = self.get(name)?;
            // A negative multiple would turn the inequality round, and prove nothing.
            if !times.is_positive() {
                return Err(Falsehood::MultiplierNotPositive(name));
            }
            let numbers = half_plane.numbers();
            let ([a1, a2], b) = numbers.ok_or(Falsehood::MultiplierNotPositive(name))?;
            let ([sum1, sum2], sum_b) = sum;
            sum = ([sum1 + times * a1, sum2 + times * a2], sum_b + times * b);
        }
        Ok(sum)
    }
}
