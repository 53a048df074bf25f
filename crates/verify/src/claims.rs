//! The checks of statements: what half-planes by name prove of each, and then all points, rays and sets of all of them in one
//! pass over the data (section 9).

use std::collections::{BTreeMap, BTreeSet};
use std::io::Read;

use boundfit_exact::Rational;

use crate::about::{About, ascending};
use crate::cells::{Model, Row};
use crate::data::Data;
use crate::failure::{DataLimits, Failure};
use crate::falsehood::Falsehood;
use crate::half_planes::{End, HalfPlanes, Multiples};
use crate::name::Name;
use crate::plane::{HalfPlane, Point, Vector, dot};
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
        probes.check_conditions(about)?;
        let longest = bits_of_points(statements);
        data.look_again(open()?, limits, |about, rows| {
            about.for_each_row(rows, limits, longest, |row, model| probes.check_row(row, model))
        })?;
    }
    Ok(claims)
}

fn in_statement<T>(number: usize, found: Result<T, Falsehood>) -> Result<T, Falsehood> {
    found.map_err(|falsehood| Falsehood::InStatement { number, falsehood: Box::new(falsehood) })
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

/// The objects to be compared with each row: points, rays and sets of all statements.
#[derive(Default)]
struct Probes<'a> {
    views: Vec<View>,
    vectors: BTreeMap<Key, Probe<'a>>,
    sets: Vec<SetProbe<'a>>,
}

/// The key of points and rays of statements that differ only in the rows that they leave out. It says whether it is a
/// ray, its vector, how rows are seen (an index of `views`), and its part.
type Key = (bool, Vector, usize, Part);

struct Probe<'a> {
    at: Point,
    /// Rows that all of these statements leave out.
    without: BTreeSet<u64>,
    /// The numbers of the statements and the rows that each leaves out.
    statements: Vec<(usize, &'a BTreeSet<u64>)>,
}

struct SetProbe<'a> {
    number: usize,
    view: usize,
    part: Part,
    without: &'a BTreeSet<u64>,
    sides: Sides<'a>,
}

impl<'a> Probes<'a> {
    fn is_empty(&self) -> bool {
        self.vectors.is_empty() && self.sets.is_empty()
    }

    fn add(
        &mut self,
        number: usize,
        statement: &'a Statement,
        half_planes: &'a HalfPlanes,
        about: &About,
    ) -> Result<(), Falsehood> {
        let (part, view) = statement.scope.parts(about)?;
        let known = self.views.iter().position(|known| *known == view);
        let view = known.unwrap_or_else(|| {
            self.views.push(view);
            self.views.len() - 1
        });
        let without = &statement.scope.without;
        let [points, rays] = statement.points_and_rays().map(Vec::into_iter);
        for (is_ray, vector) in points.map(|point| (false, point)).chain(rays.map(|ray| (true, ray))) {
            let key = (is_ray, vector.clone(), view, part.clone());
            let probe = self.vectors.entry(key).or_insert_with(|| Probe {
                at: Point::new(vector),
                without: without.clone(),
                statements: Vec::new(),
            });
            probe.without.retain(|row| without.contains(row));
            probe.statements.push((number, without));
        }
        if let Kind::Set { vertices, sides, .. } = &statement.kind {
            let sides = Sides::of(vertices, sides, half_planes)?;
            self.sets.push(SetProbe { number, view, part, without, sides });
        }
        Ok(())
    }

    /// Compares everything with the half-planes that are of no row.
    fn check_conditions(&self, about: &About) -> Result<(), Falsehood> {
        for ((is_ray, _, view, part), probe) in &self.vectors {
            let Some(view) = self.views.get(*view) else { continue };
            for (name, half_plane) in part.conditions(about, view) {
                probe.check(*is_ray, name, &half_plane)?;
            }
        }
        for set in &self.sets {
            let Some(view) = self.views.get(set.view) else { continue };
            for (name, half_plane) in set.part.conditions(about, view) {
                set.check(name, &half_plane)?;
            }
        }
        Ok(())
    }

    /// Compares everything with the half-planes of a row.
    fn check_row(&self, row: u64, model: &Model) -> Result<(), Falsehood> {
        let numbers = model.row();
        let seen: Vec<_> = self.views.iter().map(|view| view.half_planes(row, &numbers)).collect();
        let of_view = |view: usize| seen.get(view).into_iter().flatten();
        for ((is_ray, _, view, part), probe) in &self.vectors {
            if part.has_row(row) && !probe.without.contains(&row) {
                of_view(*view).try_for_each(|(name, own)| probe.check(*is_ray, *name, own))?;
            }
        }
        for set in &self.sets {
            if set.part.has_row(row) && !set.without.contains(&row) {
                of_view(set.view).try_for_each(|(name, own)| set.check(*name, own))?;
            }
        }
        Ok(())
    }
}

impl Probe<'_> {
    fn check(&self, is_ray: bool, name: Name, half_plane: &HalfPlane) -> Result<(), Falsehood> {
        let (is_within, falsehood) = if is_ray {
            (half_plane.compare_along(&self.at).is_le(), Falsehood::Leaves(name))
        } else {
            (half_plane.compare_at(&self.at).is_le(), Falsehood::Outside(name))
        };
        if is_within {
            return Ok(());
        }
        // The first that does not leave this row out.
        let is_about =
            |(_, without): &&(usize, &BTreeSet<u64>)| name.row().is_none_or(|row| !without.contains(&row));
        let number = self.statements.iter().find(is_about).map_or(0, |(number, _)| *number);
        in_statement(number, Err(falsehood))
    }
}

impl SetProbe<'_> {
    fn check(&self, name: Name, half_plane: &HalfPlane) -> Result<(), Falsehood> {
        let is_around = self.sides.support(half_plane).is_some_and(|support| support.against_b.is_le());
        let found = if is_around { Ok(()) } else { Err(Falsehood::CutsOff(name)) };
        in_statement(self.number, found)
    }
}
