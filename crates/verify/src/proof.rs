//! The proof as it stands in its file (section 1), and the half-planes that it speaks of.

use std::collections::{BTreeMap, BTreeSet};

use boundfit_exact::{Limits, Rational, Reading};
use serde::Deserialize;

use crate::falsehood::Falsehood;
use crate::plane::{HalfPlane, Vector};
use crate::table::{Table, half_unit_at, number_at, side_at};

/// A proof, whose statements may be true or false. The fields are those of the file, tuples included.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Proof {
    pub(crate) schema: String,
    pub(crate) sha256: String,
    delimiter: char,
    header: bool,
    /// The first and the last of wanted rows that follow each other, then those of the next ones, ascending, from 1.
    pub(crate) rows: Vec<usize>,
    reading: Reading,
    /// φ1, φ2, y and ε: a column, from 1, and how many times it is taken. Column 0 holds 1 in every row.
    model: [(usize, Rational); 4],
    /// The columns of lower and of upper bounds, in place of y and ε.
    #[serde(default)]
    interval: Option<[Option<usize>; 2]>,
    /// How far φ·θ may be above and below y beside ε: the sum of these quantities of columns, each so many times.
    #[serde(default)]
    law: Option<[Vec<(Quantity, usize, Rational)>; 2]>,
    /// Taken from each number of the column of φ1, before it is multiplied.
    #[serde(default)]
    x_origin: Rational,
    conditions: Vec<Condition>,
    pub(crate) vertices: Vec<Vector>,
    /// Which vertex, an index from 0, and which half-plane touches it.
    pub(crate) active: BTreeSet<(usize, String)>,
    /// Which half-plane, and at which vertex the next side begins; none where a gap comes instead.
    pub(crate) sides: Vec<(String, Option<usize>)>,
    pub(crate) farkas: Multiples,
    /// Multipliers, point and ray of each end of the parameters' ranges.
    pub(crate) bounds: Vec<(Multiples, Vector, Vector)>,
}

/// A condition: `["a1", "a2", "b"]`, or with a fourth text `"="` an equation.
#[derive(Debug, Clone, Deserialize)]
#[serde(untagged)]
enum Condition {
    Inequality(HalfPlane),
    Equation(Rational, Rational, Rational, EqualsSign),
}

#[derive(Debug, Clone, Copy, Deserialize)]
enum EqualsSign {
    #[serde(rename = "=")]
    Equals,
}

/// What a law takes from a cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
enum Quantity {
    /// The number without its sign.
    Abs,
    /// Half a unit of the last digit written.
    Written,
}

/// Which half-planes, and how many times each is taken.
pub(crate) type Multiples = Vec<(String, Rational)>;

/// Half-planes by name.
pub(crate) struct Named(BTreeMap<String, HalfPlane>);

impl Named {
    pub(crate) fn get(&self, name: &str) -> Result<&HalfPlane, Falsehood> {
        self.0.get(name).ok_or_else(|| Falsehood::UnknownHalfPlane(name.to_owned()))
    }

    /// The sum of positive multiples of at most `most` half-planes. Every point of all of them is in it.
    pub(crate) fn sum(&self, multiples: &Multiples, most: usize) -> Result<HalfPlane, Falsehood> {
        if multiples.len() > most {
            return Err(Falsehood::TooManyMultipliers(most));
        }
        let mut sum = HalfPlane::default();
        for (name, times) in multiples {
            // A negative multiple would turn the inequality round, and prove nothing.
            if !times.is_positive() {
                return Err(Falsehood::MultiplierNotPositive(name.clone()));
            }
            let HalfPlane { a: [a1, a2], b } = self.get(name)?;
            let [sum1, sum2] = &sum.a;
            sum = HalfPlane { a: [sum1 + times * a1, sum2 + times * a2], b: &sum.b + times * b };
        }
        Ok(sum)
    }
}

impl Proof {
    /// The wanted rows in order.
    fn wanted_rows(&self) -> Result<impl Iterator<Item = usize> + '_, Falsehood> {
        // An end that is left over makes a range without rows.
        let ranges = || {
            self.rows.chunks(2).map(|range| if let &[first, last] = range { [first, last] } else { [1, 0] })
        };
        let mut before = 0;
        for [first, last] in ranges() {
            if first <= before || last < first {
                return Err(Falsehood::NoRows);
            }
            before = last;
        }
        if before == 0 { Err(Falsehood::NoRows) } else { Ok(ranges().flat_map(|[first, last]| first..=last)) }
    }

    /// Hands over each half-plane of the wanted rows, then of the conditions, with its name (section 2).
    pub(crate) fn for_each_half_plane(
        &self,
        data: &[u8],
        limits: &Limits,
        mut take: impl FnMut(String, HalfPlane) -> Result<(), Falsehood>,
    ) -> Result<(), Falsehood> {
        let mut table = Table::new(data, self.delimiter).skip(usize::from(self.header));
        let mut passed = 0;
        for row in self.wanted_rows()? {
            let cells = table.nth(row - passed - 1).ok_or(Falsehood::MissingRow(row))?;
            passed = row;
            let read = |column: usize| number_at(row, column, &cells, self.reading, limits);
            let number = |(column, times): &(usize, Rational)| -> Result<Rational, Falsehood> {
                Ok(read(*column)? * times)
            };
            let [(x, times), phi2, y, epsilon] = &self.model;
            let phi1 = (read(*x)? - &self.x_origin) * times;
            let (phi2, y, epsilon) = (number(phi2)?, number(y)?, number(epsilon)?);
            let (lower, upper) = match &self.interval {
                Some(sides) => {
                    let side = |column: Option<usize>| {
                        column.map_or(Ok(None), |column| side_at(row, column, &cells, self.reading, limits))
                    };
                    (side(sides[0])?, side(sides[1])?)
                }
                None => {
                    let [above, below] = match &self.law {
                        Some([above, below]) => {
                            let sum = |terms| self.sum(row, terms, &cells, limits);
                            [&epsilon + sum(above)?, &epsilon + sum(below)?]
                        }
                        None => [epsilon.clone(), epsilon],
                    };
                    if above.is_negative() || below.is_negative() {
                        return Err(Falsehood::NegativeErrorBound(row));
                    }
                    (Some(&y - below), Some(y + above))
                }
            };
            if let Some(lower) = lower {
                take(format!("{row} lower"), HalfPlane { a: [-&phi1, -&phi2], b: -lower })?;
            }
            if let Some(upper) = upper {
                take(format!("{row} upper"), HalfPlane { a: [phi1, phi2], b: upper })?;
            }
        }
        for (number, condition) in (1..).zip(&self.conditions) {
            match condition {
                Condition::Inequality(half_plane) => take(format!("where:{number}"), half_plane.clone())?,
                Condition::Equation(a1, a2, b, EqualsSign::Equals) => {
                    let upper = HalfPlane { a: [a1.clone(), a2.clone()], b: b.clone() };
                    let lower = HalfPlane { a: [-a1, -a2], b: -b };
                    take(format!("where:{number} upper"), upper)?;
                    take(format!("where:{number} lower"), lower)?;
                }
            }
        }
        Ok(())
    }

    /// What a law adds up for a row.
    fn sum(
        &self,
        row: usize,
        terms: &[(Quantity, usize, Rational)],
        cells: &[Vec<u8>],
        limits: &Limits,
    ) -> Result<Rational, Falsehood> {
        let mut sum = Rational::zero();
        for (quantity, column, times) in terms {
            let value = match quantity {
                Quantity::Abs => number_at(row, *column, cells, self.reading, limits)?.abs(),
                Quantity::Written => half_unit_at(row, *column, cells, limits)?,
            };
            sum = sum + value * times;
        }
        Ok(sum)
    }

    /// The half-planes that sides and multipliers name, which are few, and how many there are in all.
    pub(crate) fn named_half_planes(
        &self,
        data: &[u8],
        limits: &Limits,
    ) -> Result<(Named, usize), Falsehood> {
        let sides = self.sides.iter().map(|(name, _)| name);
        let multiples = self.bounds.iter().flat_map(|(multiples, ..)| multiples).chain(&self.farkas);
        let wanted: BTreeSet<&String> = sides.chain(multiples.map(|(name, _)| name)).collect();
        let (mut named, mut count) = (BTreeMap::new(), 0);
        self.for_each_half_plane(data, limits, |name, half_plane| {
            count += 1;
            if wanted.contains(&name) {
                named.insert(name, half_plane);
            }
            Ok(())
        })?;
        Ok((Named(named), count))
    }
}
