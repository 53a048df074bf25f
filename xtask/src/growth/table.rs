//! The counts of each command, in a file that people can read, and what is wrong with new ones.

use std::collections::BTreeMap;
use std::fmt;

/// The words at the top of the file.
const HEAD: &str = "\
# Millions of instructions of the release program; `cargo xtask growth` counts them, `--bless` stores them.
# growth: what the rows of the last size add, over what those of the size before add: 2 where each row costs the same;
# more than 2.6 is a debt that may only fall; of a step the dearer one of its two sizes, over the cheaper one.
";

/// The factor by which the second half of the rows may cost more than the first half, unless more is stored.
const MOST_GROWTH: f64 = 2.6;
/// One row more may change the cost by this factor, unless a larger step is stored.
const MOST_STEP: f64 = 1.3;
/// A count may be larger than the stored one by this factor.
const TOLERANCE: f64 = 1.05;
/// The millions of instructions that the last rows add at least, so that their growth is not that of chance.
const LEAST_ADDED: f64 = 1.0;

/// The counts of a command at two or three sizes, in millions of instructions.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Counts(pub(super) Vec<f64>);

impl Counts {
    /// The factor by which the second half of the rows adds over the first half; of two sizes, the dearer one over the cheaper one.
    pub(super) fn growth(&self) -> f64 {
        match self.0[..] {
            [one, other] => (one / other).max(other / one),
            // Less than is worth a million is no growth.
            [first, second, third] if third - second > LEAST_ADDED => {
                (third - second) / (second - first).max(LEAST_ADDED / MOST_GROWTH)
            }
            _ => 1.0,
        }
    }

    /// The faults of counts beside stored ones.
    fn faults(&self, stored: Option<&Counts>) -> Vec<String> {
        let growth = self.growth();
        let limit = if self.0.len() == 2 { MOST_STEP } else { MOST_GROWTH };
        let most = stored.map_or(limit, |stored| limit.max(stored.growth() * TOLERANCE));
        let mut faults = Vec::new();
        if growth > most {
            faults.push(format!("grows by {growth:.2}, more than {most:.2}"));
        }
        let Some(stored) = stored else {
            faults.push("has no stored count; `cargo xtask growth --bless` stores it".to_owned());
            return faults;
        };
        for (count, before) in
            self.0.iter().zip(&stored.0).filter(|(count, before)| **count > TOLERANCE * **before)
        {
            faults.push(format!(
                "takes {count:.2} million instructions, and {before:.2} are stored; \
                 `cargo xtask growth --bless` stores the new count if there is a reason"
            ));
        }
        faults
    }
}

/// The counts of commands by name.
#[derive(Debug, Default, PartialEq)]
pub(super) struct Table(pub(super) BTreeMap<String, Counts>);

impl Table {
    /// Reads a table as it is written.
    pub(super) fn read(text: &str) -> Result<Self, String> {
        let is_row = |line: &&str| !line.starts_with('#') && !line.trim().is_empty();
        let row = |line: &str| {
            let (name, counts) = line.split_once(':')?;
            let (_, counts) = (counts.split_once("growth")?.1, counts.split_once("growth")?.0);
            let counts = counts.split_whitespace().map(str::parse).collect::<Result<Vec<f64>, _>>().ok()?;
            matches!(counts.len(), 2 | 3).then(|| (name.to_owned(), Counts(counts)))
        };
        let rows = text.lines().filter(is_row).map(|line| {
            row(line)
                .ok_or_else(|| format!("xtask/growth.txt: {line:?} is not a name with two or three counts"))
        });
        rows.collect::<Result<_, _>>().map(Self)
    }

    /// A sentence for each fault of new counts.
    pub(super) fn faults(&self, found: &Table) -> Vec<String> {
        let of = |(name, counts): (&String, &Counts)| {
            let faults = counts.faults(self.0.get(name)).into_iter();
            faults.map(|fault| format!("{name}: {fault}")).collect::<Vec<_>>()
        };
        found.0.iter().flat_map(of).collect()
    }
}

impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{HEAD}")?;
        for (name, counts) in &self.0 {
            let numbers: String = counts.0.iter().map(|count| format!(" {count:9.2}")).collect();
            let name = format!("{name}:");
            writeln!(f, "{name:18}{numbers:30}  growth {:.2}", counts.growth())?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(rows: &[(&str, &[f64])]) -> Table {
        Table(rows.iter().map(|(name, counts)| ((*name).to_owned(), Counts(counts.to_vec()))).collect())
    }

    #[test]
    fn a_table_is_read_as_it_is_written() {
        let own = table(&[("fit text", &[10.0, 12.5, 17.25]), ("step text", &[80.0, 20.0])]);
        assert_eq!(Table::read(&own.to_string()), Ok(own));
        assert!(Table::read("fit text: 1 growth 2").is_err());
        assert!(Table::read("fit text 1 2 3").is_err());
    }

    #[test]
    fn what_grows_faster_than_the_work_is_a_fault() {
        let square = table(&[("fit", &[11.0, 14.0, 26.0])]);
        assert_eq!(square.faults(&square), [""; 0], "a debt that is stored");
        let faults = table(&[("fit", &[11.0, 14.0, 20.0])]).faults(&square);
        assert!(faults[0].starts_with("fit: grows by 4.00, more than 2.60"), "{faults:?}");
        let line = table(&[("fit", &[11.0, 14.0, 20.0])]);
        assert_eq!(line.faults(&line), [""; 0]);
        // The cost of the start alone has no growth.
        let constant = table(&[("fit", &[11.0, 11.0, 11.5])]);
        assert_eq!(constant.faults(&constant), [""; 0]);
    }

    #[test]
    fn more_than_the_stored_count_is_a_fault() {
        let stored = table(&[("fit", &[11.0, 14.0, 20.0])]);
        assert_eq!(stored.faults(&table(&[("fit", &[11.5, 14.5, 20.5])])), [""; 0]);
        assert_eq!(stored.faults(&table(&[("fit", &[11.6, 14.5, 20.5])])).len(), 1);
        assert_eq!(stored.faults(&table(&[("new", &[1.0, 2.0, 3.0])])).len(), 1);
    }

    #[test]
    fn a_step_may_not_get_larger() {
        let stored = table(&[("step", &[80.0, 20.0])]);
        assert_eq!(stored.faults(&stored), [""; 0]);
        assert_eq!(stored.faults(&table(&[("step", &[80.0, 18.0])])).len(), 1);
        assert_eq!(table(&[("step", &[20.0, 20.0])]).faults(&stored).len(), 2);
    }
}
