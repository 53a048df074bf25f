//! Sums over the columns of a table.

use std::borrow::Cow;

use boundfit_exact::{Column, Rational};

use crate::halves::Halves;
use crate::meaning::Meaning;
use crate::moments::Sums;
use crate::products::product_sum;
use crate::reduction::NoLeastSquares;
use crate::sums::{column_sum, of_narrow};

/// The sum of each column. Exact. Cost: linear.
pub(crate) fn column_totals(columns: &[Column]) -> Vec<Rational> {
    columns.iter().map(|column| column_sum(column).total()).collect()
}

impl<N> Sums<N> {
    /// The sums in the order of the fields.
    pub(crate) fn parts(&self) -> [&N; 5] {
        let Sums { uu, uv, vv, uy, vy, .. } = self;
        [uu, uv, vv, uy, vy]
    }
}

impl Sums {
    /// The sums over all rows of columns. Exact. Cost: linear.
    ///
    /// # Errors
    /// When a reading has nothing that least squares could take.
    pub(crate) fn of_readings(meaning: &Meaning, columns: &[Column]) -> Result<Sums, NoLeastSquares> {
        let regressors = meaning.regressors();
        let second = (regressors == 2).then(|| &columns[1]);
        let form =
            |sums: Sums| if regressors == 1 { sums.counted_from(&meaning.form.x_origin) } else { sums };
        if meaning.has_response {
            return Ok(form(Sums::of_columns(&columns[0], second, &columns[regressors])));
        }
        if let Some(middles) = Halves::of_columns(meaning, columns).and_then(|halves| halves.middles()) {
            return Ok(form(Sums::of_columns(&columns[0], second, &middles)));
        }
        let value = |row: usize| meaning.of_columns(columns, row, 0).value().map(Cow::into_owned);
        let values: Option<Column> = (0..columns[0].len()).map(value).collect();
        let values = values.ok_or(NoLeastSquares::NoResponse)?;
        Ok(form(Sums::of_columns(&columns[0], second, &values)))
    }

    /// The sums over columns of equal length, without v those of a line. Exact. Cost: linear; on machine integers where their
    /// bits suffice.
    pub(crate) fn of_columns(u: &Column, v: Option<&Column>, y: &Column) -> Self {
        match v {
            None => Sums::of_line(u, y).total(),
            Some(v) => Sums::of_two(u, v, y),
        }
    }

    fn of_two(u: &Column, v: &Column, y: &Column) -> Self {
        if let (Column::Narrow(u), Column::Narrow(v), Column::Narrow(y)) = (u, v, y)
            && let Some(sums) = of_narrow(u, Some(v), y)
        {
            return sums.total();
        }
        let pairs = [[u, u], [u, v], [v, v], [u, y], [v, y]];
        Sums::new(u.len(), pairs.map(|[left, right]| product_sum(left, right))).total()
    }

    /// The sums over the readings of lines whose x are counted from here, from those of x as it is. Exact.
    pub(crate) fn counted_from(self, origin: &Rational) -> Self {
        if origin.is_zero() {
            return self;
        }
        let Sums { count, uu: xx, uv: x, vv, uy: xy, vy: y } = self;
        let all = origin * Rational::from(count);
        let twice = &x + &x;
        Sums { count, uu: xx + origin * (&all - twice), uv: x - all, vv, uy: xy - origin * &y, vy: y }
    }
}
