//! A proof, and the half-planes that it speaks of.

use std::collections::{BTreeMap, BTreeSet};
use std::io::Read;

use boundfit_exact::{Foreign, Limits, Rational, Reading};

use crate::cells::Model;
use crate::failure::{DataLimits, Failure};
use crate::falsehood::Falsehood;
use crate::name::{Name, Named};
use crate::plane::{HalfPlane, Vector};
use crate::rows::{self, Cells, Rows};
use crate::shape::{Condition, NotAProof, Number, Quantity, Shape};

/// A proof, whose statements may be true or false.
#[derive(Debug, Clone)]
pub struct Proof {
    pub(crate) sha256: String,
    pub(crate) about: About,
    pub(crate) vertices: Vec<Vector>,
    /// Which vertex, an index from 0, and which half-plane touches it; in order, and none twice.
    pub(crate) active: Vec<(u64, Named)>,
    /// Which half-plane, and at which vertex the next side begins; none where a gap comes instead.
    pub(crate) sides: Vec<(Named, Option<u64>)>,
    pub(crate) farkas: Multiples,
    /// Multipliers, point and ray of each end of the parameters' ranges.
    pub(crate) bounds: Vec<(Multiples, Vector, Vector)>,
}

/// Which half-planes, and how many times each is taken.
pub(crate) type Multiples = Vec<(Named, Rational)>;

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
    /// What is taken from each number of the column of φ1, before it is multiplied.
    pub x_origin: Rational,
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
        let shape = Shape::read(text, limits.digits.saturating_mul(10))?;
        let vector = |[x, y]: [Number; 2]| [x.0, y.0];
        let multiples = |terms: Vec<(Named, Number)>| {
            terms.into_iter().map(|(name, Number(times))| (name, times)).collect()
        };
        let law = |terms: Vec<(Quantity, u64, Number)>| {
            terms.into_iter().map(|(quantity, column, Number(times))| (quantity, column, times)).collect()
        };
        let mut active = shape.active;
        active.sort_unstable();
        active.dedup();
        let about = About {
            delimiter: char::from(shape.delimiter.0),
            header: shape.header,
            rows: shape.rows,
            reading: shape.reading,
            model: shape.model.map(|(column, Number(times))| (column, times)),
            x_origin: shape.x_origin.map_or_else(Rational::zero, |Number(origin)| origin),
            interval: shape.interval,
            law: shape.law.map(|sides| sides.map(law)),
            conditions: shape
                .conditions
                .into_iter()
                .map(|Condition { numbers, is_equation }| (numbers, is_equation))
                .collect(),
        };
        Ok(Proof {
            sha256: shape.sha256.into_raw(),
            about,
            vertices: shape.vertices.into_iter().map(vector).collect(),
            active,
            sides: shape.sides,
            farkas: multiples(shape.farkas),
            bounds: shape
                .bounds
                .into_iter()
                .map(|(terms, point, ray)| (multiples(terms), vector(point), vector(ray)))
                .collect(),
        })
    }

    /// How many bits the longest vertex has.
    pub(crate) fn longest_vertex(&self) -> u64 {
        self.vertices.iter().map(|[x, y]| x.bits() + y.bits()).max().unwrap_or_default()
    }

    /// What it is about, whether it is true or not.
    pub fn about(&self) -> &About {
        &self.about
    }

    /// The half-planes that sides and multipliers name, which are few.
    pub(crate) fn names(&self) -> BTreeSet<Name> {
        let sides = self.sides.iter().map(|(name, _)| name);
        let multiples = self.bounds.iter().flat_map(|(multiples, ..)| multiples).chain(&self.farkas);
        let names = sides.chain(multiples.map(|(name, _)| name));
        names.filter_map(|name| if let Named::A(name) = name { Some(*name) } else { None }).collect()
    }
}

impl About {
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
        model.chain(interval).chain(law)
    }

    /// Hands over each half-plane of the wanted rows, then of the conditions, by its name and what computes it (section 2).
    pub(crate) fn for_each_half_plane<R: Read>(
        &self,
        rows: &mut Rows<R>,
        limits: &DataLimits,
        longest_vertex: u64,
        mut take: impl FnMut(Name, &dyn Fn() -> HalfPlane) -> Result<(), Falsehood>,
    ) -> Result<(), Failure> {
        let mut model = Model::new(self, limits, longest_vertex);
        let start = rows.count();
        for [first, last] in self.ranges()? {
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
                let [lower, upper] = model.sides();
                if lower {
                    take(Name::Lower(row), &|| model.lower())?;
                }
                if upper {
                    take(Name::Upper(row), &|| model.upper())?;
                }
            }
        }
        for (number, (numbers, is_equation)) in (1..).zip(&self.conditions) {
            let half_plane = HalfPlane::new(numbers);
            if *is_equation {
                take(Name::WhereUpper(number), &|| half_plane.clone())?;
                take(Name::WhereLower(number), &|| half_plane.opposite())?;
            } else {
                take(Name::Where(number), &|| half_plane.clone())?;
            }
        }
        Ok(())
    }

    /// The ranges of wanted rows, which ascend from 1 on.
    fn ranges(&self) -> Result<Vec<[u64; 2]>, Falsehood> {
        let mut before = 0;
        let mut ranges = Vec::new();
        for range in self.rows.chunks(2) {
            let &[first, last] = range else { return Err(Falsehood::NoRows) };
            if first <= before || last < first {
                return Err(Falsehood::NoRows);
            }
            ranges.push([first, last]);
            before = last;
        }
        if ranges.is_empty() { Err(Falsehood::NoRows) } else { Ok(ranges) }
    }
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
