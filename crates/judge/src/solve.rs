//! The exact answer: found by the polygon engine, confirmed by the exact simplex, and proved by multiplying it out.

use boundfit_exact::{Integer, Rational};
use boundfit_geometry::{self as geometry, Direction, Multiplier, Support, Vertex};
use boundfit_lp::{ExactOutcome, Model, Program, Row, exact_simplex};

use crate::answer::{Answer, Basis, BasisStatus, Face, Item, Prices, Side, SideMultiplier};
use crate::certificate::{proves_infeasible, proves_optimal, proves_unbounded, sign_of, value_of};
use crate::error::SolveError;
use crate::plane::{Plane, point_on_axis};
use boundfit_lp::End;

impl Answer {
    /// Solves a model. Exact. Cost: O(n log n) in the number of bounds for the set. Each pivot of the simplex method
    /// that confirms it takes a pass over the rows, and so does each proved statement.
    ///
    /// # Errors
    /// As [`Plane::new`] says, and [`SolveError::Disagreement`], which means a bug.
    ///
    /// ```
    /// use boundfit_judge::Answer;
    /// use boundfit_lp::{Bounds, Model, ModelColumn, ModelRow};
    ///
    /// // The least x + 2·y with x + y ≥ 3, 0 ≤ x ≤ 2 and y ≥ 0.
    /// let column = |name: &str, cost: i64, upper: Option<i64>| ModelColumn {
    ///     name: name.into(),
    ///     cost: cost.into(),
    ///     bounds: Bounds { lower: Some(0.into()), upper: upper.map(Into::into) },
    /// };
    /// let model = Model {
    ///     columns: vec![column("x", 1, Some(2)), column("y", 2, None)],
    ///     rows: vec![ModelRow {
    ///         name: "need".into(),
    ///         coefficients: vec![(0, 1.into()), (1, 1.into())],
    ///         bounds: Bounds { lower: Some(3.into()), upper: None },
    ///     }],
    ///     ..Model::default()
    /// };
    /// let Answer::Optimal { value, face, prices, .. } = Answer::of(&model)? else { panic!("there is an optimum") };
    /// assert_eq!((value, face.vertices), (4.into(), vec![vec![2.into(), 1.into()]]));
    /// // One more of what is needed costs 2; one more of x saves 1.
    /// assert_eq!((prices.rows, prices.columns), (vec![2.into()], vec![(-1).into(), 0.into()]));
    /// # Ok::<(), boundfit_judge::SolveError>(())
    /// ```
    pub fn of(model: &Model) -> Result<Self, SolveError> {
        Answer::in_plane(model, &Plane::new(model)?)
    }

    /// Solves a model whose [`Plane`] is at hand.
    ///
    /// # Errors
    /// [`SolveError::Disagreement`], which means a bug.
    pub fn in_plane(model: &Model, plane: &Plane) -> Result<Self, SolveError> {
        let support = plane.polyhedron().support(plane.gain());
        confirm(plane, &support)?;
        match support {
            Support::Empty(farkas) => infeasible(model, plane, farkas.multipliers()),
            Support::Unbounded(proof) => unbounded(model, plane, &proof.ray),
            Support::Bounded { proof, face } => optimal(model, plane, &proof.multipliers, &face),
        }
    }
}

/// Has the exact simplex say the same, from the half-planes alone.
fn confirm(plane: &Plane, support: &Support) -> Result<(), SolveError> {
    let rows = plane.polyhedron().system().inequalities().iter();
    let rows: Vec<Row> = rows.map(|row| Row { a: row.a.clone(), b: row.b.clone() }).collect();
    let program = Program { rows: &rows, objective: plane.gain().each_ref().map(|gain| -gain) };
    let outcome = exact_simplex(&program);
    if !outcome.verify(&program) {
        return disagreement("the simplex does not prove what it says");
    }
    match (&outcome, support) {
        (ExactOutcome::Optimal { value, .. }, Support::Bounded { proof, .. }) if *value == -&proof.value => {
            Ok(())
        }
        (ExactOutcome::Optimal { .. }, Support::Bounded { .. }) => disagreement("two optima"),
        (ExactOutcome::Infeasible { .. }, Support::Empty(_))
        | (ExactOutcome::Unbounded { .. }, Support::Unbounded(_)) => Ok(()),
        _ => disagreement("two statuses"),
    }
}

fn disagreement<T>(what: &str) -> Result<T, SolveError> {
    Err(SolveError::Disagreement(what.to_owned()))
}

/// Refuses an answer whose proof does not hold in the model as it was given.
fn proved(answer: Answer, proof: Result<(), &'static str>) -> Result<Answer, SolveError> {
    match proof {
        Ok(()) => Ok(answer),
        Err(what) => disagreement(what),
    }
}

fn infeasible(model: &Model, plane: &Plane, multipliers: &[Multiplier]) -> Result<Answer, SolveError> {
    let mut terms = Vec::new();
    for Multiplier { index, value } in multipliers {
        if let Some(side) = plane.side(*index) {
            terms.push(SideMultiplier { side, value: value.clone() });
        }
    }
    // The bounds of fixed columns take away whatever the rows leave over in them.
    let mut left: Vec<Rational> = vec![Rational::zero(); model.columns.len()];
    for SideMultiplier { side, value } in &terms {
        let Item::Row(row) = side.item else { continue };
        let times = if side.end == End::Lower { value.clone() } else { -value };
        for (column, coefficient) in model.rows.get(row).map_or(&[][..], |row| &row.coefficients) {
            if let Some(sum) = left.get_mut(*column) {
                *sum = &*sum - coefficient * &times;
            }
        }
    }
    for (index, (column, sum)) in model.columns.iter().zip(left).enumerate() {
        if column.bounds.fixed().is_some() && !sum.is_zero() {
            let end = if sum.is_positive() { End::Lower } else { End::Upper };
            terms.push(SideMultiplier { side: Side { item: Item::Column(index), end }, value: sum.abs() });
        }
    }
    terms.sort_by_key(|term| (term.side.item, term.side.end == End::Upper));
    let proof = proves_infeasible(model, &terms);
    proved(Answer::Infeasible { multipliers: terms }, proof)
}

fn unbounded(model: &Model, plane: &Plane, ray: &Direction) -> Result<Answer, SolveError> {
    let point = plane.point(&first_point(plane));
    let ray = plane.direction(&vector(ray));
    let proof = proves_unbounded(model, &point, &ray);
    proved(Answer::Unbounded { point, ray }, proof)
}

fn optimal(
    model: &Model,
    plane: &Plane,
    multipliers: &[Multiplier],
    face: &geometry::Face,
) -> Result<Answer, SolveError> {
    let start = Start::of(plane, multipliers, face);
    let face = face_of(plane, face, &start);
    let sign = sign_of(model.sense);
    let mut prices = Prices {
        rows: vec![Rational::zero(); model.rows.len()],
        columns: vec![Rational::zero(); model.columns.len()],
    };
    for Multiplier { index, value } in multipliers {
        let Some(Side { item, end }) = plane.side(*index) else {
            return disagreement("a coordinate that is not there has a price");
        };
        let price = if end == End::Lower { value * &sign } else { -(value * &sign) };
        let place = match item {
            Item::Row(row) => prices.rows.get_mut(row),
            Item::Column(column) => prices.columns.get_mut(column),
        };
        if let Some(place) = place {
            *place = price;
        }
    }
    price_fixed_columns(model, &mut prices);
    let basis = basis(model, plane, &prices, &start);
    let points = face.vertices.iter().chain(&face.points);
    let first = points.clone().next().cloned().unwrap_or_default();
    let value = value_of(model, &first);
    let proof = proves_optimal(model, &value, &prices, points.take(2));
    proved(Answer::Optimal { value, face, prices, basis }, proof)
}

/// Gives each fixed column the reduced cost that the rows leave to it.
fn price_fixed_columns(model: &Model, prices: &mut Prices) {
    let mut left: Vec<Rational> = model.columns.iter().map(|column| column.cost.clone()).collect();
    for (row, price) in model.rows.iter().zip(&prices.rows).filter(|(_, price)| !price.is_zero()) {
        for (column, coefficient) in &row.coefficients {
            if let Some(left) = left.get_mut(*column) {
                *left = &*left - coefficient * price;
            }
        }
    }
    for ((column, price), left) in model.columns.iter().zip(&mut prices.columns).zip(left) {
        if column.bounds.fixed().is_some() {
            *price = left;
        }
    }
}

/// The optimal point that the basis belongs to, with the half-planes that meet there.
struct Start {
    /// A point of the plane; a coordinate along a line without end is 0.
    point: [Rational; 2],
    /// Half-planes whose boundaries meet in the point alone, or in a line.
    half_planes: Vec<usize>,
}

impl Start {
    fn of(plane: &Plane, multipliers: &[Multiplier], face: &geometry::Face) -> Self {
        let polyhedron = plane.polyhedron();
        let optimal = |vertex: &&Vertex| multipliers.iter().all(|m| vertex.active().contains(&m.index));
        let proof = multipliers.iter().map(|multiplier| multiplier.index);
        if let Some(vertex) = polyhedron.region().vertices().iter().find(optimal) {
            // Half-planes of missing coordinates come last in the system.
            let half_planes = independent(plane, proof.chain(vertex.active().iter().copied()));
            return Start { point: vertex.point().coordinates(), half_planes };
        }
        let boundary = polyhedron.region().boundaries().first();
        let active = boundary.map_or(&[][..], |boundary| boundary.active());
        let of_face = if matches!(face, geometry::Face::Whole) { active } else { &[] };
        let half_planes = independent(plane, proof.chain(of_face.iter().copied()));
        let line = half_planes.first().and_then(|&index| polyhedron.system().half_plane(index));
        let origin = [Rational::zero(), Rational::zero()];
        Start { point: line.map_or(origin, point_on_axis), half_planes }
    }
}

/// The first of these half-planes, and the first whose boundary is not parallel to it.
fn independent(plane: &Plane, indices: impl Iterator<Item = usize>) -> Vec<usize> {
    let system = plane.polyhedron().system();
    let mut chosen: Vec<usize> = Vec::new();
    for index in indices {
        let Some(own) = system.half_plane(index) else { continue };
        let parallel = |&other: &usize| {
            let other = system.half_plane(other);
            other.is_some_and(|other| own.a1() * other.a2() == own.a2() * other.a1())
        };
        if chosen.len() < 2 && !chosen.iter().any(parallel) {
            chosen.push(index);
        }
    }
    chosen
}

/// The optimal points with all columns.
fn face_of(plane: &Plane, face: &geometry::Face, start: &Start) -> Face {
    let region = plane.polyhedron().region();
    let place = |point: &geometry::Point| plane.point(&point.coordinates());
    let along = |direction: &Direction| plane.direction(&vector(direction));
    let none = Face { vertices: Vec::new(), points: Vec::new(), rays: Vec::new(), lines: Vec::new() };
    match face {
        geometry::Face::Vertex(point) => Face { vertices: vec![place(point)], ..none },
        geometry::Face::Segment(ends) => {
            // The basis belongs to the first vertex.
            let [one, other] = ends;
            let is_first = one.coordinates() == start.point;
            let ends = if is_first { [one, other] } else { [other, one] };
            Face { vertices: ends.map(place).into(), ..none }
        }
        geometry::Face::Ray { apex, direction } => {
            Face { vertices: vec![place(apex)], rays: vec![along(direction)], ..none }
        }
        geometry::Face::Line { direction, .. } => {
            Face { points: vec![plane.point(&start.point)], lines: vec![along(direction)], ..none }
        }
        geometry::Face::Whole => {
            let vertices: Vec<_> = region.vertices().iter().map(|vertex| place(vertex.point())).collect();
            let others = region.boundaries().iter().skip(1).map(|b| point_on_axis(b.half_plane()));
            let points = std::iter::once(start.point.clone()).chain(others);
            let points = points.map(|point| plane.point(&point)).collect();
            Face {
                points: if vertices.is_empty() { points } else { Vec::new() },
                vertices,
                rays: region.rays().iter().map(along).collect(),
                lines: region.lines().iter().map(along).collect(),
            }
        }
    }
}

/// Returns the basis of a start. The bounds behind its half-planes and fixed columns are not basic. If the
/// half-planes leave a line, a column that they do not hold is not basic, either.
fn basis(model: &Model, plane: &Plane, prices: &Prices, start: &Start) -> Basis {
    let at = |end: End| if end == End::Lower { BasisStatus::AtLower } else { BasisStatus::AtUpper };
    let sign = sign_of(model.sense);
    let fixed = |(column, price): (&boundfit_lp::ModelColumn, &Rational)| match column.bounds.fixed() {
        Some(_) if (price * &sign).is_negative() => BasisStatus::AtUpper,
        Some(_) => BasisStatus::AtLower,
        None => BasisStatus::Basic,
    };
    let mut basis = Basis {
        rows: vec![BasisStatus::Basic; model.rows.len()],
        columns: model.columns.iter().zip(&prices.columns).map(fixed).collect(),
    };
    let mut set = |item: Item, status: BasisStatus| {
        let place = match item {
            Item::Row(row) => basis.rows.get_mut(row),
            Item::Column(column) => basis.columns.get_mut(column),
        };
        if let Some(place) = place {
            *place = status;
        }
    };
    for side in start.half_planes.iter().filter_map(|&index| plane.side(index)) {
        set(side.item, at(side.end));
    }
    let system = plane.polyhedron().system();
    let line = start.half_planes.first().and_then(|&index| system.half_plane(index));
    for (axis, &column) in plane.columns().iter().enumerate() {
        // A line that is held meets the axis on which this coordinate is 0 in one point.
        let free = match (line, start.half_planes.len()) {
            (None, _) => true,
            (Some(line), 1) => axis == usize::from(!line.a1().is_zero()),
            _ => false,
        };
        if free {
            set(Item::Column(column), BasisStatus::Free);
        }
    }
    basis
}

/// A feasible point of a set that is not empty: a vertex if there is one.
fn first_point(plane: &Plane) -> [Rational; 2] {
    let region = plane.polyhedron().region();
    match (region.vertices().first(), region.boundaries().first()) {
        (Some(vertex), _) => vertex.point().coordinates(),
        (None, Some(boundary)) => point_on_axis(boundary.half_plane()),
        (None, None) => [Rational::zero(), Rational::zero()],
    }
}

fn vector(direction: &Direction) -> [Rational; 2] {
    [direction.dx(), direction.dy()].map(|entry: &Integer| Rational::from(entry))
}
