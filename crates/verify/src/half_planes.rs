//! Half-planes by name, and what proofs take of them.

use std::collections::{BTreeMap, BTreeSet};

use boundfit_exact::Rational;

use crate::falsehood::Falsehood;
use crate::name::{Name, Named};
use crate::plane::{HalfPlane, Vector};
use crate::shape::{EndShape, MultiplesShape, Number};

/// Half-planes, and the number of times that each is taken.
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

/// Returns the names that are of half-planes.
pub(crate) fn names<'a>(names: impl Iterator<Item = &'a Named>) -> BTreeSet<Name> {
    names.filter_map(|name| if let Named::A(name) = name { Some(*name) } else { None }).collect()
}
