//! The sum of the factors near a point, and along a ray.

use std::collections::BTreeMap;

use boundfit_estimation::BoundName;
use boundfit_exact::{Rational, Sign};
use boundfit_geometry::predicates::angle_order;
use boundfit_geometry::{Direction, Inequality};

/// A reading whose bound may be wider: max(1, |φ·θ - middle| / half width) is its factor.
#[derive(Debug, Clone)]
pub(super) struct Soft {
    pub(super) row: usize,
    pub(super) form: [Rational; 2],
    pub(super) middle: Rational,
    /// Positive.
    pub(super) half_width: Rational,
}

/// A half-plane that holds as it is.
#[derive(Debug, Clone)]
pub(super) struct Hard {
    pub(super) name: BoundName,
    pub(super) inequality: Inequality,
}

/// The bound that a reading is at, or beyond.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Side {
    Upper,
    Lower,
}

impl Side {
    /// 1 or -1 over a width.
    pub(super) fn over(self, half_width: &Rational) -> Rational {
        let inverse = half_width.recip().unwrap_or_default();
        if self == Side::Upper { inverse } else { -inverse }
    }
}

impl Soft {
    /// |φ·θ - middle| / half width.
    pub(super) fn factor(&self, theta: &[Rational; 2]) -> Rational {
        self.off(theta).abs().checked_div(&self.half_width).unwrap_or_default()
    }

    /// Returns the growth of the factor beyond a bound.
    pub(super) fn gradient(&self, side: Side) -> [Rational; 2] {
        let inverse = side.over(&self.half_width);
        self.form.each_ref().map(|own| own * &inverse)
    }

    fn off(&self, theta: &[Rational; 2]) -> Rational {
        along(&self.form, theta) - &self.middle
    }

    fn is_flat(&self) -> bool {
        self.form.iter().all(Rational::is_zero)
    }
}

/// The sum near a point: its gradient, as far as no bound is met with equality there, and the bounds that are.
#[derive(Debug)]
pub(super) struct Local {
    gradient: [Rational; 2],
    outside: Vec<(usize, Side)>,
    active: Vec<(usize, Side)>,
    limits: Vec<usize>,
    /// The directions of all lines through the point, each with what meets there.
    lines: Vec<Line>,
}

/// Everything that changes along one line through the point.
#[derive(Debug)]
struct Line {
    normal: Direction,
    /// The terms of the gradient on the side of the normal, and on the other side.
    beyond: [[Rational; 2]; 2],
    /// `true` if nothing is allowed on that side.
    is_closed: [bool; 2],
}

pub(super) fn along(form: &[Rational; 2], vector: &[Rational; 2]) -> Rational {
    &form[0] * &vector[0] + &form[1] * &vector[1]
}

fn plus(one: &[Rational; 2], other: &[Rational; 2]) -> [Rational; 2] {
    [&one[0] + &other[0], &one[1] + &other[1]]
}

fn minus(one: &[Rational; 2], other: &[Rational; 2]) -> [Rational; 2] {
    [&one[0] - &other[0], &one[1] - &other[1]]
}

pub(super) fn vector(direction: &Direction) -> [Rational; 2] {
    [Rational::from(direction.dx()), Rational::from(direction.dy())]
}

/// The behaviour of the sum near a point that all fixed half-planes allow.
pub(super) fn local(soft: &[Soft], hard: &[Hard], theta: &[Rational; 2]) -> Local {
    let mut here = Local {
        gradient: [Rational::zero(), Rational::zero()],
        outside: Vec::new(),
        active: Vec::new(),
        limits: Vec::new(),
        lines: Vec::new(),
    };
    // By the direction of the normal that has a positive first component.
    let mut lines: BTreeMap<(Rational, bool), Line> = BTreeMap::new();
    let mut meet = |gradient: &[Rational; 2], is_closed: bool| {
        let Some(direction) = Direction::from_rational(gradient) else { return };
        let normal = direction.of_line();
        let slope = Rational::new(normal.dy().clone(), normal.dx().clone());
        let line = lines.entry((slope.clone().unwrap_or_default(), slope.is_none())).or_insert_with(|| {
            let nothing = || [Rational::zero(), Rational::zero()];
            Line { normal: normal.clone(), beyond: [nothing(), nothing()], is_closed: [false; 2] }
        });
        let side = usize::from(direction != normal);
        if is_closed {
            line.is_closed[side] = true;
        } else {
            line.beyond[side] = plus(&line.beyond[side], gradient);
        }
    };
    for (index, term) in soft.iter().enumerate() {
        let off = term.off(theta);
        let side = if off.is_negative() { Side::Lower } else { Side::Upper };
        let beyond = off.abs() - &term.half_width;
        match beyond.sign() {
            Sign::Negative => {}
            Sign::Zero => {
                here.active.push((index, side));
                meet(&term.gradient(side), false);
            }
            Sign::Positive => {
                here.outside.push((index, side));
                here.gradient = plus(&here.gradient, &term.gradient(side));
            }
        }
    }
    for (index, own) in hard.iter().enumerate() {
        if own.inequality.slack(theta).is_zero() {
            here.limits.push(index);
            meet(&own.inequality.a, true);
        }
    }
    here.lines = lines.into_values().collect();
    here
}

impl Local {
    /// A direction in which the sum becomes less, and how fast; `None` at a minimiser.
    ///
    /// The sum is linear between neighbouring rays along the lines through the point. So one of these rays descends
    /// if any direction does; with one line, or none, also the direction across it, or against the gradient.
    pub(super) fn descent(&self) -> Option<(Direction, Rational)> {
        let mut steepest: Option<(Direction, Rational, Rational)> = None;
        for (direction, slope) in self.slopes() {
            if !slope.is_negative() {
                continue;
            }
            let [dx, dy] = vector(&direction);
            let Some(relative) = slope.checked_div(&(dx.abs() + dy.abs())) else { continue };
            if steepest.as_ref().is_none_or(|(.., most)| relative < *most) {
                steepest = Some((direction, slope, relative));
            }
        }
        steepest.map(|(direction, slope, _)| (direction, slope))
    }

    /// Directions along which the sum stays as it is, of a point with at most one line through it.
    pub(super) fn flat(&self) -> Vec<Direction> {
        let axes = || {
            let units = [(1, 0), (-1, 0), (0, 1), (0, -1)];
            units.into_iter().filter_map(|(x, y)| Direction::new(x.into(), y.into())).collect()
        };
        match self.lines.as_slice() {
            [] if self.gradient.iter().all(Rational::is_zero) => axes(),
            [line] => {
                let rays = [line.normal.turned_left(), line.normal.turned_right()];
                rays.into_iter().filter(|ray| along(&self.gradient, &vector(ray)).is_zero()).collect()
            }
            _ => Vec::new(),
        }
    }

    /// The slopes of the sum along the directions of which one descends if any does, as far as they are allowed.
    fn slopes(&self) -> Vec<(Direction, Rational)> {
        match self.lines.as_slice() {
            [] => {
                let against = self.gradient.each_ref().map(|own| -own);
                let direction = Direction::from_rational(&against).into_iter();
                direction.map(|own| (own.clone(), along(&self.gradient, &vector(&own)))).collect()
            }
            [line] => {
                let rays = [line.normal.turned_left(), line.normal.turned_right()];
                let flat = rays.into_iter().map(|ray| {
                    let slope = along(&self.gradient, &vector(&ray));
                    (ray, slope)
                });
                let across = [line.normal.clone(), line.normal.reversed()].into_iter().enumerate();
                let across = across.filter(|(side, _)| !line.is_closed[*side]).map(|(side, ray)| {
                    let slope = along(&plus(&self.gradient, &line.beyond[side]), &vector(&ray));
                    (ray, slope)
                });
                flat.chain(across).collect()
            }
            lines => self.around(lines),
        }
    }

    /// The slopes along all rays, once around: passing a ray changes what comes to the gradient by what belongs to its line.
    fn around(&self, lines: &[Line]) -> Vec<(Direction, Rational)> {
        let mut rays: Vec<(Direction, usize, usize)> = lines
            .iter()
            .enumerate()
            .flat_map(|(line, own)| {
                // Behind the ray to the right of a normal, counter-clockwise, lies the side of the normal.
                [(own.normal.turned_right(), line, 0), (own.normal.turned_left(), line, 1)]
            })
            .collect();
        rays.sort_by(|(one, ..), (other, ..)| angle_order((one.dx(), one.dy()), (other.dx(), other.dy())));
        // Just before the first ray.
        let mut gradient = self.gradient.clone();
        let mut closed = 0_usize;
        let Some((first, first_line, _)) = rays.first() else { return Vec::new() };
        let first_vector = vector(first);
        for (index, line) in lines.iter().enumerate() {
            let side = match index == *first_line {
                true => 1 - rays[0].2,
                false => usize::from(along(&vector(&line.normal), &first_vector).is_negative()),
            };
            gradient = plus(&gradient, &line.beyond[side]);
            closed += usize::from(line.is_closed[side]);
        }
        let mut slopes = Vec::new();
        for (ray, line, side) in rays {
            let own = &lines[line];
            let without = minus(&gradient, &own.beyond[1 - side]);
            closed -= usize::from(own.is_closed[1 - side]);
            if closed == 0 {
                let slope = along(&without, &vector(&ray));
                slopes.push((ray, slope));
            }
            gradient = plus(&without, &own.beyond[side]);
            closed += usize::from(own.is_closed[side]);
        }
        slopes
    }

    /// The readings that are beyond a bound.
    pub(super) fn outside<'a>(&self, soft: &'a [Soft]) -> impl Iterator<Item = (&'a Soft, Side)> {
        self.outside.iter().map(|(index, side)| (&soft[*index], *side))
    }

    /// The readings that meet a bound with equality.
    pub(super) fn soft_active<'a>(&self, soft: &'a [Soft]) -> impl Iterator<Item = (&'a Soft, Side)> {
        self.active.iter().map(|(index, side)| (&soft[*index], *side))
    }

    /// The half-planes that hold as they are, and with equality.
    pub(super) fn hard_active<'a>(&self, hard: &'a [Hard]) -> impl Iterator<Item = &'a Hard> {
        self.limits.iter().map(|index| &hard[*index])
    }

    /// The sum that the bounds met with equality must compensate.
    pub(super) fn opposite_gradient(&self) -> [Rational; 2] {
        self.gradient.each_ref().map(|own| -own)
    }
}

/// The first point with the least sum along a ray from a point, where the slope at the point is not positive. Where it is 0, and
/// nothing ends it, the point itself.
pub(super) fn line_search(
    soft: &[Soft],
    hard: &[Hard],
    theta: &[Rational; 2],
    direction: &Direction,
    mut slope: Rational,
) -> [Rational; 2] {
    let ray = vector(direction);
    // Where the slope grows, and by how much; without a number where nothing lies beyond.
    let mut steps: Vec<(Rational, Option<Rational>)> = Vec::new();
    for term in soft.iter().filter(|term| !term.is_flat()) {
        let speed = along(&term.form, &ray);
        if speed.is_zero() {
            continue;
        }
        let off = term.off(theta);
        let growth = speed.abs().checked_div(&term.half_width);
        for bound in [-&term.half_width, term.half_width.clone()] {
            if let Some(step) = (bound - &off).checked_div(&speed).filter(Rational::is_positive) {
                steps.push((step, growth.clone()));
            }
        }
    }
    for own in hard {
        let speed = along(&own.inequality.a, &ray);
        if speed.is_positive()
            && let Some(step) = own.inequality.slack(theta).checked_div(&speed)
        {
            steps.push((step, None));
        }
    }
    steps.sort_unstable();
    for (step, growth) in steps {
        slope = match growth {
            Some(growth) => slope + growth,
            None => Rational::zero(),
        };
        if !slope.is_negative() {
            return plus(theta, &ray.each_ref().map(|own| own * &step));
        }
    }
    theta.clone()
}
