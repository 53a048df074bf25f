//! The checks of statements: what half-planes by name prove of each, and then all points, rays and sets of all of them in one
//! pass over the data (section 9).

use std::collections::{BTreeMap, BTreeSet};
use std::io::Read;

use boundfit_exact::Rational;

use crate::about::{About, ascending};
use crate::cells::Row;
use crate::data::Data;
use crate::failure::{DataLimits, Failure};
use crate::falsehood::{Falsehood, in_statement};
use crate::half_planes::{End, HalfPlanes, Multiples};
use crate::name::Name;
use crate::plane::{Vector, dot};
use crate::probes::{Comparisons, Probes};
use crate::scope::{ErrorScale, Part, Scope, Side, View};
use crate::sides::Sides;
use crate::statements::{Claim, ClaimKind, Contradictions, Kind, Statement};

/// Checks statements against the rows that they name, then the rest of them against all data, if there is a rest.
pub(crate) fn check_statements<R: Read>(
    data: &Data,
    statements: &[Statement],
    rows: &BTreeMap<u64, Row>,
    open: impl FnOnce() -> Result<R, Failure>,
    limits: &DataLimits,
) -> Result<Vec<Claim>, Failure> {
    let about = &data.about;
    let comparisons = Comparisons::of(about)?;
    comparisons.refuse_conditions(statements.len(), limits.work)?;
    let named: Vec<HalfPlanes> = (1..)
        .zip(statements)
        .map(|(number, own)| in_statement(number, own.scope.half_planes(&own.names(), rows, about)))
        .collect::<Result<_, _>>()?;
    let mut probes = Probes::default();
    let mut claims = Vec::new();
    let shown = Shown::of(statements, about)?;
    for ((number, own), half_planes) in (1..).zip(statements).zip(&named) {
        let claim = in_statement(number, own.check(half_planes, rows, about, &shown))?;
        claims.push(Claim { scope: own.scope.clone(), kind: claim });
        in_statement(number, probes.add(number, own, half_planes, about))?;
    }
    if !probes.is_empty() {
        comparisons.refuse_rows(&probes, limits.work)?;
        probes.check_conditions(about)?;
        let longest = bits_of_points(statements);
        let look = data.look(open()?, limits, |about, rows| {
            about.for_each_row(rows, limits, longest, |row, model| probes.check_row(row, model))
        })?;
        look.again()?;
    }
    Ok(claims)
}

/// The rows that statements name.
pub(crate) fn named_rows(statements: &[Statement]) -> BTreeSet<u64> {
    statements.iter().flat_map(|own| own.names().into_iter().filter_map(Name::row)).collect()
}

/// Returns how many bits all points and rays have that each row is compared with.
pub(crate) fn bits_of_points(statements: &[Statement]) -> u64 {
    let points = statements.iter().flat_map(|own| own.points_and_rays().concat());
    points.map(|[x, y]| x.bits() + y.bits()).fold(0, u64::saturating_add)
}

impl Statement {
    /// Returns what half-planes by name prove of it.
    fn check(
        &self,
        half_planes: &HalfPlanes,
        rows: &BTreeMap<u64, Row>,
        about: &About,
        shown: &Shown,
    ) -> Result<ClaimKind, Falsehood> {
        match &self.kind {
            Kind::Form { form, ends: [lower, upper] } => {
                let opposite = form.each_ref().map(|part| -part);
                let lower = check_end(lower, &opposite, half_planes, false)?.map(|value| -value);
                let upper = check_end(upper, form, half_planes, true)?;
                Ok(ClaimKind::Form { form: form.clone(), range: [lower, upper] })
            }
            Kind::Point(point) => Ok(ClaimKind::Point(point.clone())),
            Kind::Empty(multiples) => check_contradiction(multiples, half_planes).map(|()| ClaimKind::Empty),
            Kind::Least { multiples, .. } => {
                let (_, view) = self.scope.parts(about)?;
                check_least(&self.scope, multiples, half_planes, &view, rows)
            }
            Kind::Set { vertices, sides, .. } => {
                let walk = Sides::of(vertices, sides, half_planes)?;
                let (extent, vertices, sides) = (walk.extent(), vertices.len(), sides.len());
                Ok(ClaimKind::Set { extent, vertices, sides })
            }
            Kind::LeftOut { least, sets, contradictions } => {
                let sets = match sets {
                    Some(sets) => Some(shown.check_sets(&self.scope, *least, sets, about)?),
                    None if *least == 0 => return Err(Falsehood::NoRowsToLeaveOut),
                    None => None,
                };
                check_left_out(*least, sets.as_ref(), contradictions, half_planes)?;
                Ok(ClaimKind::LeftOut { least: *least, sets })
            }
        }
    }
}

/// Scopes in which points are shown to be, by statements about these or about all of their sets.
struct Shown(BTreeSet<(Part, View, BTreeSet<u64>)>);

impl Shown {
    fn of(statements: &[Statement], about: &About) -> Result<Self, Falsehood> {
        let mut shown = BTreeSet::new();
        if statements.iter().any(|own| matches!(own.kind, Kind::LeftOut { sets: Some(_), .. })) {
            for (number, own) in (1..).zip(statements) {
                if matches!(own.kind, Kind::Point(_) | Kind::Set { .. }) {
                    let (part, view) = in_statement(number, own.scope.parts(about))?;
                    shown.insert((part, view, own.scope.without.clone()));
                }
            }
        }
        Ok(Shown(shown))
    }

    /// Each of these sets has so many different rows of the scope, none is there twice, and something is left without each.
    fn check_sets(
        &self,
        scope: &Scope,
        least: u64,
        sets: &[Vec<u64>],
        about: &About,
    ) -> Result<BTreeSet<BTreeSet<u64>>, Falsehood> {
        let wanted = Part::of_rows(ascending(&about.rows)?);
        let (part, view) = scope.parts(about)?;
        let has_row = |row: &u64| wanted.has_row(*row) && part.has_row(*row) && !scope.without.contains(row);
        let mut all = BTreeSet::new();
        for listed in sets {
            let rows: BTreeSet<u64> = listed.iter().copied().collect();
            let is_set = rows.len() == listed.len() && rows.len() as u64 == least && rows.iter().all(has_row);
            if !is_set || all.contains(&rows) {
                return Err(Falsehood::NotASet(listed.clone()));
            }
            let without = scope.without.union(&rows).copied().collect();
            if !self.0.contains(&(part.clone(), view.clone(), without)) {
                return Err(Falsehood::NotShownToBeEnough(listed.clone()));
            }
            all.insert(rows);
        }
        Ok(all)
    }
}

/// The largest value of a form, or `None` where nothing bounds it; that the point and the ray are in the set is not looked at.
fn check_end(
    (multiples, point, ray): &End,
    form: &Vector,
    half_planes: &HalfPlanes,
    is_upper: bool,
) -> Result<Option<Rational>, Falsehood> {
    let value = dot(form, point);
    let (a, b) = half_planes.sum(multiples, 2)?;
    if *ray == Vector::default() && a == *form && b == value {
        return Ok(Some(value));
    }
    if multiples.is_empty() && dot(form, ray).is_positive() {
        return Ok(None);
    }
    Err(Falsehood::NotAnEnd { is_upper })
}

/// Half-planes add up to 0 ≤ b with b < 0.
fn check_contradiction(multiples: &Multiples, half_planes: &HalfPlanes) -> Result<(), Falsehood> {
    let (a, b) = half_planes.sum(multiples, 3)?;
    if a == Vector::default() && b.is_negative() { Ok(()) } else { Err(Falsehood::NoContradiction) }
}

/// Half-planes add up to 0 ≤ 0, and some of them grow.
fn check_least(
    scope: &Scope,
    multiples: &Multiples,
    half_planes: &HalfPlanes,
    view: &View,
    rows: &BTreeMap<u64, Row>,
) -> Result<ClaimKind, Falsehood> {
    let scale = match &scope.errors {
        ErrorScale::AsStated => return Err(Falsehood::NotLeast),
        // With smaller bounds on errors in x as well the strong set need not be smaller.
        ErrorScale::Times(_) if scope.side == Some(Side::Strong) => return Err(Falsehood::NotLeast),
        ErrorScale::Times(scale) | ErrorScale::Within(scale) => scale,
    };
    let (a, b) = half_planes.sum(multiples, 3)?;
    let mut grows = false;
    for (name, _) in multiples {
        let (name, _) = half_planes.get(name)?;
        grows |= view.growth(name.row().and_then(|row| rows.get(&row))).is_positive();
    }
    let is_least = a == Vector::default() && b.is_zero() && (grows || scale.is_zero());
    if is_least { Ok(ClaimKind::Least) } else { Err(Falsehood::NotLeast) }
}

/// Tries every row of each contradiction, starting with no row left out: one of its rows has to be left out.
fn check_left_out(
    least: u64,
    sets: Option<&BTreeSet<BTreeSet<u64>>>,
    contradictions: &Contradictions,
    half_planes: &HalfPlanes,
) -> Result<(), Falsehood> {
    let mut next = vec![BTreeSet::new()];
    let mut seen: BTreeSet<BTreeSet<u64>> = BTreeSet::new();
    while let Some(left_out) = next.pop() {
        let is_enough = left_out.len() as u64 >= least;
        if is_enough && sets.is_none_or(|sets| sets.contains(&left_out)) || seen.contains(&left_out) {
            continue;
        }
        let Some(multiples) = contradictions.get(&left_out) else {
            return Err(Falsehood::MayBeEnough(left_out.into_iter().collect()));
        };
        check_contradiction(multiples, half_planes)?;
        for (name, _) in multiples {
            let (name, _) = half_planes.get(name)?;
            let Some(row) = name.row() else { continue };
            if left_out.contains(&row) {
                return Err(Falsehood::MayBeEnough(left_out.into_iter().collect()));
            }
            if !is_enough {
                let mut more = left_out.clone();
                more.insert(row);
                next.push(more);
            }
        }
        seen.insert(left_out);
    }
    Ok(())
}
