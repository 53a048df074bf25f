//! Readings that wait in their columns.

use std::sync::Arc;

use boundfit_exact::Rational;
use boundfit_formats::Batch;

use crate::meaning::Meaning;
use crate::measurement::Measurement;

/// All readings of a table, in its columns.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct InColumns(Arc<[Batch]>);

/// No number of a column is unlike itself.
impl Eq for InColumns {}

impl InColumns {
    /// Takes all batches; `None` where none were kept.
    pub(super) fn new(batches: Vec<Batch>) -> Option<Self> {
        (!batches.is_empty()).then(|| InColumns(batches.into()))
    }

    /// The readings. Exact. Cost: linear.
    pub(crate) fn readings(&self, meaning: &Meaning) -> Vec<Measurement> {
        readings_of(&self.0, meaning)
    }

    /// The readings one after the other. Exact. Cost: linear; memory for one.
    pub(crate) fn each<'a>(&'a self, meaning: &'a Meaning) -> impl Iterator<Item = Measurement> + 'a {
        self.0.iter().flat_map(move |batch| of_batch(batch, meaning))
    }

    /// The reading at a position. Exact. Cost: that of a look at each batch.
    pub(crate) fn reading(&self, mut position: usize, meaning: &Meaning) -> Option<Measurement> {
        for batch in self.0.iter() {
            match position.checked_sub(batch.rows.len()) {
                Some(further) => position = further,
                None => {
                    return Some(meaning.of_columns(&batch.columns, position, batch.rows.get(position)));
                }
            }
        }
        None
    }

    /// The position of a row.
    pub(crate) fn position_of(&self, row: usize) -> Option<usize> {
        let mut before = 0;
        self.0.iter().find_map(|batch| {
            let own = batch.rows.position(row).map(|position| before + position);
            before += batch.rows.len();
            own
        })
    }

    /// x and y of each reading of a line by [`Rational::near_f64`]. Cost: some nanoseconds for
    /// short decimals.
    pub(crate) fn near_f64(&self, meaning: &Meaning) -> Vec<[f64; 2]> {
        let of_batch = |batch: &Batch| -> Vec<[f64; 2]> {
            match batch.columns.as_slice() {
                [x, y] if meaning.form.x_origin.is_zero() => {
                    x.near_f64().into_iter().zip(y.near_f64()).map(<[f64; 2]>::from).collect()
                }
                _ => readings_of(std::slice::from_ref(batch), meaning).iter().map(near_f64).collect(),
            }
        };
        self.0.iter().flat_map(of_batch).collect()
    }
}

/// x and y of a reading of a line.
fn near_f64(reading: &Measurement) -> [f64; 2] {
    [&reading.regressor[0], reading.y_and_epsilon().0].map(Rational::near_f64)
}

/// The readings in some batches. Exact. Cost: linear.
pub(super) fn readings_of(batches: &[Batch], meaning: &Meaning) -> Vec<Measurement> {
    let mut readings = Vec::with_capacity(batches.iter().map(|batch| batch.rows.len()).sum());
    batches.iter().for_each(|batch| readings.extend(of_batch(batch, meaning)));
    readings
}

fn of_batch<'a>(batch: &'a Batch, meaning: &'a Meaning) -> impl Iterator<Item = Measurement> + 'a {
    let rows = batch.rows.ranges().flat_map(|[first, last]| first..=last).enumerate();
    rows.map(move |(position, row)| meaning.of_columns(&batch.columns, position, row))
}
