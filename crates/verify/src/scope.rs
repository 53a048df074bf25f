//! Scopes: the half-planes of a part of the rows and conditions, at another size of the errors perhaps (section 8).

use std::collections::{BTreeMap, BTreeSet};

use boundfit_exact::Rational;

use crate::about::{About, ascending};
use crate::cells::Row;
use crate::falsehood::Falsehood;
use crate::half_planes::HalfPlanes;
use crate::name::{End, Name};
use crate::plane::HalfPlane;

/// The half-planes that a statement is about.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Scope {
    /// The first and the last of rows that follow each other, then those of the next ones; all wanted rows when `None`.
    pub rows: Option<Vec<u64>>,
    /// Rows that are left out.
    pub without: BTreeSet<u64>,
    /// The numbers of the conditions that hold, from 1; all when `None`.
    pub conditions: Option<BTreeSet<u64>>,
    /// The largest errors.
    pub errors: ErrorScale,
    /// The part of the set, where x has errors.
    pub side: Option<Side>,
}

/// The largest errors of a scope.
#[derive(Debug, Clone, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum ErrorScale {
    /// The errors that the proof states for all rows.
    #[default]
    AsStated,
    /// A multiple of the errors that the proof states.
    Times(Rational),
    /// A distance from the middle of the bounds.
    Within(Rational),
}

/// A part of the parameters that agree with readings whose x have errors.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Side {
    /// Some x, θ1 ≥ 0.
    Rising,
    /// Some x, θ1 ≤ 0.
    Falling,
    /// Every x.
    Strong,
}

/// The rows and conditions of a scope, the rows that are left out aside.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Part {
    rows: Option<Vec<[u64; 2]>>,
    conditions: Option<BTreeSet<u64>>,
}

/// The view of a scope on each row.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct View {
    errors: ErrorScale,
    side: Option<Side>,
}

impl Scope {
    /// The rows of the scope, and its view on them.
    pub(crate) fn parts(&self, about: &About) -> Result<(Part, View), Falsehood> {
        let rows = self.rows.as_deref().map(ascending).transpose()?;
        let is_negative = match &self.errors {
            ErrorScale::AsStated => false,
            ErrorScale::Times(number) | ErrorScale::Within(number) => number.is_negative(),
        };
        if is_negative {
            return Err(Falsehood::NegativeScale);
        }
        if self.side.is_some() != about.x_error.is_some() {
            return Err(Falsehood::NoSide);
        }
        let part = Part { rows, conditions: self.conditions.clone() };
        Ok((part, View { errors: self.errors.clone(), side: self.side }))
    }

    /// The half-planes of this scope.
    pub(crate) fn half_planes(
        &self,
        names: &BTreeSet<Name>,
        rows: &BTreeMap<u64, Row>,
        about: &About,
    ) -> Result<HalfPlanes, Falsehood> {
        let (part, view) = self.parts(about)?;
        let mut found: BTreeMap<Name, HalfPlane> = part.conditions(about, &view).collect();
        for number in names.iter().filter_map(|name| name.row()) {
            if let Some(row) = rows.get(&number)
                && part.has_row(number)
                && !self.without.contains(&number)
            {
                found.extend(view.half_planes(number, row));
            }
        }
        found.retain(|name, _| names.contains(name));
        Ok(HalfPlanes(found))
    }
}

impl Part {
    /// Rows under all conditions.
    pub(crate) fn of_rows(rows: Vec<[u64; 2]>) -> Self {
        Part { rows: Some(rows), conditions: None }
    }

    pub(crate) fn has_row(&self, row: u64) -> bool {
        let Some(ranges) = &self.rows else { return true };
        let next = ranges.partition_point(|[_, last]| *last < row);
        ranges.get(next).is_some_and(|[first, _]| *first <= row)
    }

    /// The half-planes of the conditions, and of the side.
    pub(crate) fn conditions(&self, about: &About, view: &View) -> impl Iterator<Item = (Name, HalfPlane)> {
        let holds = |name: &Name| match (name, &self.conditions) {
            (Name::Where(own) | Name::WhereUpper(own) | Name::WhereLower(own), Some(numbers)) => {
                numbers.contains(own)
            }
            _ => true,
        };
        let side = view.side.and_then(|side| {
            let sign = match side {
                Side::Rising => -1,
                Side::Falling => 1,
                Side::Strong => return None,
            };
            let numbers = [sign, 0, 0].map(Rational::from);
            Some((Name::Side, HalfPlane::new(&numbers)))
        });
        about.conditions_by_name().filter(move |(name, _)| holds(name)).chain(side)
    }
}

impl View {
    /// The half-planes of a row: 0 to 4.
    pub(crate) fn half_planes(&self, number: u64, row: &Row) -> Vec<(Name, HalfPlane)> {
        let Row { phi: [phi1, phi2], lower, upper, x_error, times } = self.scaled(row);
        let phi_at = |end: Option<End>| {
            let phi1 = match end {
                None => phi1.clone(),
                Some(End::Lower) => &phi1 - &x_error,
                Some(End::Upper) => &phi1 + &x_error,
            };
            [phi1, phi2.clone()]
        };
        let above = |end: Option<End>| {
            let b = upper.clone()?;
            Some(HalfPlane { a: phi_at(end), b, times: times.clone() })
        };
        let below = |end: Option<End>| {
            let b = -lower.as_ref()?;
            Some(HalfPlane { a: phi_at(end).map(|part| -part), b, times: times.clone() })
        };
        let (low, high) = (Some(End::Lower), Some(End::Upper));
        let all = match self.side {
            None => vec![(Name::Upper(number), above(None)), (Name::Lower(number), below(None))],
            // The end of the possible x that asks least of a line like that.
            Some(Side::Rising) => vec![(Name::Upper(number), above(low)), (Name::Lower(number), below(high))],
            Some(Side::Falling) => {
                vec![(Name::Upper(number), above(high)), (Name::Lower(number), below(low))]
            }
            Some(Side::Strong) => [End::Lower, End::Upper]
                .into_iter()
                .flat_map(|end| {
                    let at = Some(end);
                    [(Name::UpperAt(number, end), above(at)), (Name::LowerAt(number, end), below(at))]
                })
                .collect(),
        };
        all.into_iter().filter_map(|(name, half_plane)| Some((name, half_plane?))).collect()
    }

    /// The row with its errors as they are here.
    fn scaled(&self, row: &Row) -> Row {
        let (share, is_factor) = match &self.errors {
            ErrorScale::AsStated => return row.clone(),
            ErrorScale::Times(factor) => (factor, true),
            ErrorScale::Within(bound) => (bound, false),
        };
        let (p, q) = (share.numerator(), share.denominator());
        let two_q = &q + &q;
        let [lower, upper] = match (&row.lower, &row.upper) {
            // Twice the middle, and twice how far from there.
            (Some(lower), Some(upper)) if lower <= upper => {
                let middle = (lower + upper) * &q;
                let width = if is_factor { (upper - lower) * &p } else { (&p + &p) * &row.times };
                [Some(&middle - &width), Some(middle + width)]
            }
            (lower, upper) => [lower, upper].map(|own| own.as_ref().map(|own| own * &two_q)),
        };
        Row {
            phi: row.phi.each_ref().map(|part| part * &two_q),
            lower,
            upper,
            x_error: if is_factor { &row.x_error * (&p + &p) } else { &row.x_error * &two_q },
            times: &row.times * two_q,
        }
    }

    /// Returns how fast a bound of this row grows with the scale of the errors, at least; 0 for any other half-plane.
    pub(crate) fn growth(&self, row: Option<&Row>) -> Rational {
        let Some(Row { lower: Some(lower), upper: Some(upper), times, .. }) = row else {
            return Rational::zero();
        };
        match &self.errors {
            ErrorScale::Times(_) if lower <= upper => {
                Rational::new(upper - lower, times + times).unwrap_or_default()
            }
            ErrorScale::Within(_) if lower <= upper => Rational::one(),
            _ => Rational::zero(),
        }
    }
}
