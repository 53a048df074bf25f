//! The objective among the rows: HiGHS writes GLPK's files so, with numbers as it always prints them.

use boundfit_exact::Rational;
use boundfit_lp::{Model, NumberFormat, Printed};

use super::{Entry, Figure, Reference, SolutionFile};

/// The number of rows that are looked at as the objective. More would take long for a file of zeros.
const MOST_TRIED: usize = 16;

/// A file of HiGHS in the style of GLPK without the objective's row; `None` for other files. Of a model in MPS that row stands where
/// its N row does, of any other model it is the last. Where several rows have the objective's value, the one is taken beside which
/// the prices of the others fit the costs best. Cost: linear in the model for each row with that value.
pub(super) fn without_cost_row(file: &SolutionFile, model: &Model) -> Option<SolutionFile> {
    let (objective, line) = file.objective.as_ref()?;
    let value = &objective.finite()?.value;
    let near = Rational::scientific(1, -12) * Rational::one().max(value.abs());
    let is_near = |entry: &Entry| {
        let own = entry.value.as_ref().and_then(Figure::finite);
        own.is_some_and(|own| (&own.value - value).abs() <= near) && price_of(entry).is_zero()
    };
    if file.announced.is_none() || file.rows.len() != model.rows.len() + 1 {
        return None;
    }
    let places = || (0..file.rows.len()).filter(|&place| file.rows.get(place).is_some_and(is_near));
    let tried = places().rev().take(1).chain(places().take(MOST_TRIED));
    let place = tried.min_by_key(|&place| misfit(file, model, place))?;
    let of_model =
        |(place, row): (usize, &Entry)| Entry { of: Reference::Place(place), ..coarser_entry(row) };
    let others = file.rows.iter().enumerate().filter(|(own, _)| *own != place).map(|(_, row)| row);
    Some(SolutionFile {
        writer: "HiGHS",
        rows: others.enumerate().map(of_model).collect(),
        columns: file.columns.iter().map(coarser_entry).collect(),
        objective: Some((coarser(objective), *line)),
        ..file.clone()
    })
}

/// The difference between the costs and what the prices of the other rows and of the columns leave, whichever sign they have.
fn misfit(file: &SolutionFile, model: &Model, cost_row: usize) -> Rational {
    let mut explained = vec![Rational::zero(); model.columns.len()];
    let others = file.rows.iter().enumerate().filter(|(place, _)| *place != cost_row);
    for ((_, entry), row) in others.zip(&model.rows) {
        let price = price_of(entry);
        for (column, coefficient) in row.coefficients.iter().filter(|_| !price.is_zero()) {
            if let Some(sum) = explained.get_mut(*column) {
                *sum = &*sum + coefficient * &price;
            }
        }
    }
    for entry in &file.columns {
        if let Reference::Place(place) = entry.of
            && let Some(sum) = explained.get_mut(place)
        {
            *sum = &*sum + price_of(entry);
        }
    }
    let off = |sign: &Rational| -> Rational {
        let of_column =
            |(column, sum): (&boundfit_lp::ModelColumn, &Rational)| (&column.cost - sign * sum).abs();
        model.columns.iter().zip(&explained).map(of_column).sum()
    };
    off(&Rational::one()).min(off(&-Rational::one()))
}

/// A price; 0 where there is none.
fn price_of(entry: &Entry) -> Rational {
    entry.price.as_ref().and_then(Figure::finite).map_or_else(Rational::zero, |price| price.value.clone())
}

fn coarser_entry(entry: &Entry) -> Entry {
    Entry {
        value: entry.value.as_ref().map(coarser),
        price: entry.price.as_ref().map(coarser),
        ..entry.clone()
    }
}

/// A number with the precision of HiGHS.
fn coarser(figure: &Figure) -> Figure {
    let Figure::Finite(printed) = figure else { return Figure::NotFinite };
    let value = printed.value.clone();
    // The digits that a text has beyond those that are printed are not there.
    Figure::Finite(Printed::by_writer("0", value, NumberFormat::HIGHS))
}
