//! Windows one after the other, over readings in memory.

use boundfit_estimation::Problem;
use boundfit_exact::Rational;

use super::Window;
use crate::range::{Order, in_order};

/// The reach of a window back from its newest reading.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Extent {
    /// A number of readings, at least one, in the order of rows.
    Readings(usize),
    /// The readings whose x is less by at most this much, in the order of x; with two regressors x is the first one.
    X(Rational),
}

/// The windows that are asked for: as far as they reach back, the first whole one and the next ones at equal steps of
/// readings.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Moving {
    /// The reach of each window.
    pub extent: Extent,
    /// The number of readings that the window moves on each time; 0 is taken for 1.
    pub step: usize,
}

/// A window that has its turn.
#[derive(Debug)]
pub struct Turn<'a> {
    /// The readings of the window.
    pub window: &'a Window,
    /// The positions of its first and last reading in the order used, from 0.
    pub span: [usize; 2],
}

/// The readings after the last window.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Moved {
    /// The number of windows.
    pub windows: usize,
    /// `true` if all readings together do not fill a window, so that the only one has all of them.
    pub is_short: bool,
    /// The number of readings after the last window.
    pub left: usize,
}

impl Moving {
    /// The order of the readings: windows of so much of x go by x.
    pub fn order(&self) -> Order {
        match self.extent {
            Extent::Readings(_) => Order::Row,
            Extent::X(_) => Order::X,
        }
    }

    /// Shows every window in turn. Exact. Cost: amortised that of a [`Window`] for each reading, and an answer where one is
    /// asked for.
    ///
    /// # Errors
    /// The result of `see`.
    pub fn each<E>(
        &self,
        problem: &Problem,
        mut see: impl FnMut(Turn<'_>) -> Result<(), E>,
    ) -> Result<Moved, E> {
        let rows = problem.measurements.kept();
        let positions = in_order(problem, self.order());
        let (count, step) = (positions.len(), self.step.max(1));
        let x = |position: usize| &rows[positions[position]].regressor[0];
        // Where the first whole window ends.
        let end = match &self.extent {
            Extent::Readings(most) => most.max(&1) - 1,
            Extent::X(span) => (0..count).find(|&last| x(last) - x(0) >= *span).unwrap_or(count),
        };
        let is_short = end >= count;
        let (mut window, mut first) = (Window::new(&problem.conditions), 0);
        let mut moved = Moved { windows: 0, is_short, left: 0 };
        for last in 0..count {
            window.push(rows[positions[last]].clone());
            let is_old = |first: usize| match &self.extent {
                Extent::Readings(most) => last + 1 - first > *(most.max(&1)),
                Extent::X(span) => x(last) - x(first) > *span,
            };
            while is_old(first) {
                window.pop();
                first += 1;
            }
            moved.left += 1;
            let is_turn = if is_short { last + 1 == count } else { last >= end && (last - end) % step == 0 };
            if is_turn {
                moved = Moved { windows: moved.windows + 1, left: 0, ..moved };
                see(Turn { window: &window, span: [first, last] })?;
            }
        }
        Ok(moved)
    }
}
