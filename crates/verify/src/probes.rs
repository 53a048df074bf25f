//! All that statements say is in a set, or around it, compared with every row in one pass over the data.

use std::collections::{BTreeMap, BTreeSet};

use crate::about::{About, ascending};
use crate::cells::Model;
use crate::failure::{Failure, Refusal};
use crate::falsehood::{Falsehood, in_statement};
use crate::half_planes::HalfPlanes;
use crate::name::Name;
use crate::plane::{HalfPlane, Point, Vector};
use crate::scope::{Part, View};
use crate::sides::Sides;
use crate::statements::{Kind, Statement};

/// Products of machine words that take as long as the comparison of a point with a row. Measured: 1e8 such comparisons take 4 s.
const WORK_OF_POINT: u64 = 10;
/// Points that are compared with a row while the row is seen in one view, or compared with a set, or while a condition is taken for a
/// statement. Measured: 5 to 7.
const POINTS_PER_VIEW: u64 = 8;

/// The rows and conditions that statements are compared with.
pub(crate) struct Comparisons {
    rows: u64,
    conditions: u64,
}

impl Comparisons {
    pub(crate) fn of(about: &About) -> Result<Self, Falsehood> {
        let rows =
            ascending(&about.rows)?.iter().map(|[first, last]| last - first + 1).fold(0, u64::saturating_add);
        Ok(Comparisons { rows, conditions: about.conditions_by_name().count() as u64 })
    }

    /// Refuses more statements than can be about all conditions within a limit on work.
    pub(crate) fn refuse_conditions(&self, statements: usize, limit: u64) -> Result<(), Failure> {
        self.refuse(statements, (statements as u64).saturating_mul(POINTS_PER_VIEW), self.conditions, limit)
    }

    /// Refuses more than can be compared with all rows and conditions within a limit on work.
    pub(crate) fn refuse_rows(&self, probes: &Probes<'_>, limit: u64) -> Result<(), Failure> {
        let others = (probes.views.len() + probes.sets.len()) as u64;
        let points = (probes.vectors.len() as u64).saturating_add(others.saturating_mul(POINTS_PER_VIEW));
        let parts = probes.vectors.len() + probes.sets.len();
        self.refuse(parts, points, self.rows.saturating_add(self.conditions), limit)
    }

    fn refuse(&self, parts: usize, points: u64, half_planes: u64, limit: u64) -> Result<(), Failure> {
        // So few are compared with a row in about the time that reading it takes.
        const FREE: u64 = 64;
        let products = points.saturating_sub(FREE).saturating_mul(half_planes).saturating_mul(WORK_OF_POINT);
        match products > limit {
            true => Err(Failure::Refused(Refusal::Comparisons { parts, half_planes, products, limit })),
            false => Ok(()),
        }
    }
}

/// The objects to be compared with each row: points, rays and sets of all statements.
#[derive(Default)]
pub(crate) struct Probes<'a> {
    views: Vec<View>,
    /// The index of each view.
    indices: BTreeMap<View, usize>,
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
    pub(crate) fn is_empty(&self) -> bool {
        self.vectors.is_empty() && self.sets.is_empty()
    }

    pub(crate) fn add(
        &mut self,
        number: usize,
        statement: &'a Statement,
        half_planes: &'a HalfPlanes,
        about: &About,
    ) -> Result<(), Falsehood> {
        let (part, view) = statement.scope.parts(about)?;
        let view = *self.indices.entry(view).or_insert_with_key(|view| {
            self.views.push(view.clone());
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
    pub(crate) fn check_conditions(&self, about: &About) -> Result<(), Falsehood> {
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
    pub(crate) fn check_row(&self, row: u64, model: &Model) -> Result<(), Falsehood> {
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
