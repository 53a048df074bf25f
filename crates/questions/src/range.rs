//! The linear range: which runs of readings a line, or a pair of parameters, agrees with.
//!
//! A calibration's linear range, the "linear interval" of analytical chemistry, is the range of x within which the readings
//! follow a line, all readings at one x or none. Under a stated error bound this is a question with an exact answer: a run of readings is linear when its
//! feasible parameter set is not empty. Runs within linear runs are linear too, so the longest possible ones say everything.

use boundfit_estimation::{Model, Problem};

use crate::window::{Contradiction, Refusal, Window};

/// The order in which runs are taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Order {
    /// Runs are taken by ascending x. Readings at one x are one place: a run has all of them or none. They stand in
    /// the order of their rows.
    X,
    /// Runs are taken in the order of the rows in the file.
    Row,
}

impl Order {
    /// The order that a question means unless it says another one: by x for a line, by row for two regressors.
    pub fn natural(model: &Model) -> Self {
        match model {
            Model::Line { .. } => Order::X,
            Model::TwoRegressors { .. } => Order::Row,
        }
    }
}

/// A run of readings that some θ agrees with, and that cannot be made longer.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Run {
    /// The position of its first reading in the order that is used, from 0.
    pub first: usize,
    /// The position of its last reading.
    pub last: usize,
    /// The reason why the run cannot begin one place earlier; `None` at the very first reading.
    pub before: Option<Contradiction>,
    /// The reason why the run cannot go on with the next place; `None` at the very last one.
    pub after: Option<Contradiction>,
}

impl Order {
    /// Returns the name of the order in reports.
    pub fn name(self) -> &'static str {
        match self {
            Order::X => "x",
            Order::Row => "row",
        }
    }
}

impl Run {
    /// Returns the number of readings of the run.
    #[allow(clippy::len_without_is_empty, reason = "a run has a reading")]
    pub fn len(&self) -> usize {
        self.last + 1 - self.first
    }
}

/// All runs of readings that some θ agrees with, as far as they cannot be made longer.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LinearRange {
    /// The positions of the readings in [`Measurements::kept`](boundfit_estimation::Measurements::kept), in the order used.
    pub order: Vec<usize>,
    /// The runs, by ascending first reading, and so by ascending last one.
    pub runs: Vec<Run>,
    /// Readings in no run, since no θ agrees with those at their place even alone, under the conditions: by position in the order used.
    pub alone: Vec<(usize, Contradiction)>,
}

impl LinearRange {
    /// The runs of a problem's readings, each under all of its conditions.
    ///
    /// Exact. Cost: O(N log N) for sorting. Every reading enters and leaves a [`Window`] once. A known line that
    /// agrees with a next reading decides at once that it fits, and otherwise the test costs O(log² h) for h
    /// half-planes that are not superfluous. If it does not fit, all readings up to the oldest one that contradicts
    /// it leave at once. (O'Rourke, "An on-line algorithm for fitting straight lines between data ranges",
    /// Communications of the ACM 24, 1981, finds one run in linear time; here the earliest reading leaves, too.)
    pub fn of(problem: &Problem, order: Order) -> Self {
        let rows = problem.measurements.kept();
        let positions = in_order(problem, order);
        let mut window = Window::new(&problem.conditions);
        let (mut runs, mut alone) = (Vec::new(), Vec::new());
        let (mut first, mut before) = (0, None);
        let ends = place_ends(problem, order, &positions);
        let mut start = 0;
        while let Some(&end) = ends.get(start) {
            let mut is_told = false;
            let mut next = start;
            while next < end {
                let Err(refusal) = window.push_or_refuse(rows[positions[next]].clone()) else {
                    next += 1;
                    continue;
                };
                let Refusal { contradiction, oldest } = refusal;
                let earlier = start - first;
                if earlier > 0 && !is_told {
                    let after = Some(contradiction.clone());
                    runs.push(Run { first, last: start - 1, before: before.take(), after });
                    is_told = true;
                }
                if oldest >= earlier {
                    // The readings at this place contradict each other, or one contradicts itself.
                    alone.extend((start..end).map(|position| (position, contradiction.clone())));
                    while window.pop().is_some() {}
                    (first, before) = (end, Some(contradiction));
                    break;
                }
                // Until the place of the oldest reading that contradicts has left, too, the next one does not come in.
                let leaving = ends[first + oldest] - first;
                (0..leaving).for_each(|_| drop(window.pop()));
                (first, before) = (first + leaving, Some(contradiction));
            }
            start = end;
        }
        if !window.is_empty() {
            runs.push(Run { first, last: positions.len() - 1, before, after: None });
        }
        LinearRange { order: positions, runs, alone }
    }

    /// The problem of the readings of a run alone, in the order of rows; the others of the problem are to be shown, if that is
    /// asked for.
    pub fn problem_of(&self, run: &Run, problem: &Problem, shows_rest: bool) -> Problem {
        let mut positions = self.order[run.first..=run.last].to_vec();
        positions.sort_unstable();
        let measurements = problem.measurements.only(&positions, shows_rest);
        Problem { measurements, conditions: problem.conditions.clone() }
    }

    /// The run with the most readings, of several the first; `None` where every reading contradicts the conditions or itself.
    pub fn longest(&self) -> Option<&Run> {
        self.runs.iter().rev().max_by_key(|run| run.len())
    }

    /// The run that reaches over the most of x, of several the first; `None` without runs.
    pub fn widest(&self, problem: &Problem) -> Option<&Run> {
        let rows = problem.measurements.kept();
        let x = |position: usize| &rows[self.order[position]].regressor[0];
        self.runs.iter().rev().max_by_key(|run| x(run.last) - x(run.first))
    }

    /// The fewest runs that have every reading that is in one. Cost: linear.
    ///
    /// Takes the longest run that has the first uncovered reading: no other choice leaves fewer.
    pub fn fewest(&self) -> Vec<&Run> {
        let mut chosen: Vec<&Run> = Vec::new();
        for (index, run) in self.runs.iter().enumerate() {
            let covered = chosen.last().map_or(0, |last: &&Run| last.last + 1);
            // Both ends ascend: a run is needed when the next one begins too late for what is not yet covered.
            let gap = covered.max(run.first);
            let is_needed = self.runs.get(index + 1).is_none_or(|next| next.first > gap);
            if gap <= run.last && is_needed {
                chosen.push(run);
            }
        }
        chosen
    }
}

/// Returns, for each position of an order, the end of its place: the first position behind it. By x, readings at one
/// x are one place.
fn place_ends(problem: &Problem, order: Order, positions: &[usize]) -> Vec<usize> {
    let rows = problem.measurements.kept();
    let is_same = |f: usize, g: usize| order == Order::X && rows[f].regressor[0] == rows[g].regressor[0];
    let mut ends = Vec::with_capacity(positions.len());
    for place in positions.chunk_by(|&f, &g| is_same(f, g)) {
        let end = ends.len() + place.len();
        ends.resize(end, end);
    }
    ends
}

/// The positions of a problem's readings in memory, in an order. Cost: O(N log N).
pub(crate) fn in_order(problem: &Problem, order: Order) -> Vec<usize> {
    let rows = problem.measurements.kept();
    let mut positions: Vec<usize> = (0..rows.len()).collect();
    if order == Order::X {
        // Stable: readings at the same x stay in the order of their rows.
        positions.sort_by(|&f, &g| rows[f].regressor[0].cmp(&rows[g].regressor[0]));
    }
    positions
}
