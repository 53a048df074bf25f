//! Sums over the columns of a table.

use boundfit_exact::{Column, Rational};

use crate::moments::Sums;
use crate::products::product_sum;
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
