//! The subject of a proof.

use std::io::Read;

use boundfit_exact::{Rational, Reading};

use crate::failure::{DataLimits, Failure};
use crate::falsehood::Falsehood;
use crate::name::Name;
use crate::plane::HalfPlane;
use crate::rows::{self, Rows};
use crate::shape::{Condition, Number, Quantity, Shape};

/// The subject of a proof: which rows of the data, how they are read, and what they say about the parameters.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct About {
    /// The separator of cells: a comma, a semicolon, a tab or a bar.
    pub delimiter: char,
    /// True if the first row names the columns.
    pub header: bool,
    /// The first and the last of rows that follow each other, then those of the next ones, from 1.
    pub rows: Vec<u64>,
    /// The exact number that a text stands for.
    pub reading: Reading,
    /// φ1, φ2, y and ε: a column, from 1, and how many times it is taken. Column 0 holds 1 in every row.
    pub model: [(u64, Rational); 4],
    /// The columns whose sum is added to y, each so many times.
    pub response: Vec<(u64, Rational)>,
    /// The number that is taken from each number of the column of φ1, before it is multiplied.
    pub x_origin: Rational,
    /// The distance that φ1 may be from its cell: a column, and how many times it is taken.
    pub x_error: Option<(u64, Rational)>,
    /// The columns of lower and of upper bounds, in place of y and ε.
    pub interval: Option<[Option<u64>; 2]>,
    /// The distances that φ·θ may be above and below y beside ε: sums of these quantities of columns, each so
    /// many times.
    pub law: Option<[Vec<(Quantity, u64, Rational)>; 2]>,
    /// a1, a2 and b of a1·θ1 + a2·θ2 ≤ b, and whether both sides are equal.
    pub conditions: Vec<([Rational; 3], bool)>,
}

impl About {
    pub(crate) fn read(shape: Shape) -> Self {
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

    /// Every column that is named, 0 too.
    pub fn columns(&self) -> impl Iterator<Item = u64> {
        let model = self.model.iter().map(|(column, _)| *column);
        let interval = self.interval.iter().flatten().flatten().copied();
        let law = self.law.iter().flatten().flatten().map(|(_, column, _)| *column);
        let others = self.response.iter().chain(&self.x_error).map(|(column, _)| *column);
        model.chain(interval).chain(law).chain(others)
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
