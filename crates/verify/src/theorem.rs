//! A theorem for Coq, whose rows are compared with the data. Coq checks what follows from them.

mod sentences;
mod text;
mod theory;

use std::collections::BTreeMap;
use std::io::Read;

use boundfit_exact::{Foreign, Integer, Rational};
use sha2::{Digest, Sha256};

use crate::about::{About, ascending};
use crate::cells::Row;
use crate::data::Data;
use crate::failure::{DataLimits, Failure};
use crate::falsehood::{Falsehood, OtherNumber};
use crate::rows::{Rows, hexadecimal};
use crate::shape::{NotAProof, Shape};
pub use theory::THEORIES;

/// The rows and conditions that stand in a theorem, and what it says of each.
#[derive(Debug, Clone)]
pub(crate) struct Theorem {
    rows: Vec<Stated>,
    /// a, b, and the bounds of a·θ1 + b·θ2 as far as there are any.
    conditions: Vec<[Option<Rational>; 4]>,
}

/// The numbers of a row by their names in the theorem.
#[derive(Debug, Clone)]
struct Stated {
    phi: [(&'static str, Rational); 2],
    bounds: Bounds,
}

#[derive(Debug, Clone)]
enum Bounds {
    /// y and the error bound.
    Around([Rational; 2]),
    /// The lower and the upper bound, and their names.
    Between([(&'static str, Option<Rational>); 2]),
}

impl Theorem {
    /// Returns whether a text has rows of a theorem.
    pub(crate) fn is_without_head(text: &[u8]) -> bool {
        memchr::memmem::find(text, text::ROWS.as_bytes()).is_some()
    }

    /// Reads the question in the head of a file, and the rows.
    pub(crate) fn read(text: &str, most_digits: usize) -> Result<(Shape, Self), NotAProof> {
        let shape = Shape::read(text::question(text)?.as_bytes(), most_digits)?;
        if shape.schema.raw() != "boundfit/theorem/1" {
            let schema = shape.schema.borrowed().quoted();
            return Err(NotAProof::new(format_args!(
                "the question in its head has the schema {schema} (expected boundfit/theorem/1)"
            )));
        }
        let theorem = text::theorem(text)?;
        let hash = text::data(text)?.map(|data| hexadecimal(&Sha256::digest(data)));
        if hash.is_some_and(|hash| hash != *shape.sha256.raw()) {
            return Err(NotAProof::new("the data in this theorem do not have the SHA-256 of its head"));
        }
        Ok((shape, theorem))
    }

    /// Compares every row and condition with the data, which are read once. Exact; one row of the data is in
    /// memory at a time.
    pub(crate) fn check<R: Read>(
        &self,
        data: &Data,
        from: R,
        limits: &DataLimits,
    ) -> Result<Agreed, Failure> {
        let mut stated = self.rows.iter();
        let (mut half_planes, mut seen) = (0, 0);
        let read = |about: &About, rows: &mut Rows<R>| {
            about.for_each_row(rows, limits, 0, |row, model| {
                half_planes += model.sides().into_iter().filter(|is_there| *is_there).count();
                seen += 1;
                let wanted = || ascending(&about.rows).map(|all| all.iter().map(|[a, b]| b - a + 1).sum());
                let Some(stated) = stated.next() else {
                    return Err(Falsehood::OtherCount { theorem: self.rows.len(), data: wanted()? });
                };
                stated
                    .difference(row, &model.row())
                    .map_or(Ok(()), |other| Err(Falsehood::OtherNumber(other)))
            })?;
            match stated.next() {
                Some(_) => Err(Falsehood::OtherCount { theorem: self.rows.len(), data: seen }.into()),
                None => Ok(self.compare_conditions(about)?),
            }
        };
        // A number that differs tells more than the hash does.
        let (rows_total, names) = data.look(from, limits, read)?.by_rows()?;
        half_planes += data.about.conditions_by_name().count();
        Ok(Agreed { rows_total, names, half_planes })
    }

    fn compare_conditions(&self, about: &About) -> Result<(), Falsehood> {
        let mut asked = about.conditions.iter().map(|([a, b, bound], is_equation)| {
            [Some(a), Some(b), is_equation.then_some(bound), Some(bound)]
        });
        let mut stated = self.conditions.iter().map(|own| own.each_ref().map(Option::as_ref));
        let count = asked.len().max(self.conditions.len());
        match (1..=count).find(|_| stated.next() != asked.next()) {
            Some(number) => Err(Falsehood::OtherCondition(number)),
            None => Ok(()),
        }
    }

    /// The number of rows.
    pub(crate) fn count(&self) -> usize {
        self.rows.len()
    }
}

/// The facts about data that agree.
pub(crate) struct Agreed {
    pub(crate) rows_total: u64,
    pub(crate) names: BTreeMap<u64, Foreign>,
    pub(crate) half_planes: usize,
}

impl Stated {
    /// The first number that differs from that of a row of the data.
    fn difference(&self, row: u64, data: &Row) -> Option<Box<OtherNumber>> {
        let number = |own: &Integer| Rational::new(own.clone(), data.times.clone());
        let phi = self.phi.iter().zip(&data.phi);
        let mut pairs: Vec<_> =
            phi.map(|((name, own), data)| (*name, Some(own.clone()), number(data))).collect();
        let [lower, upper] = [&data.lower, &data.upper].map(|own| own.as_ref().and_then(number));
        match &self.bounds {
            Bounds::Between([(least, own_lower), (most, own_upper)]) => {
                pairs.push((least, own_lower.clone(), lower));
                pairs.push((most, own_upper.clone(), upper));
            }
            Bounds::Around([y, epsilon]) => {
                let half = Rational::ratio(1, 2);
                let both = lower.zip(upper);
                let middle = both.as_ref().map(|(lower, upper)| &(lower + upper) * &half);
                let width = both.as_ref().map(|(lower, upper)| &(upper - lower) * &half);
                pairs.push(("y", Some(y.clone()), middle));
                pairs.push(("eps", Some(epsilon.clone()), width));
            }
        }
        let (name, theorem, data) = pairs.into_iter().find(|(_, theorem, data)| theorem != data)?;
        Some(Box::new(OtherNumber { row, name, theorem, data }))
    }
}
