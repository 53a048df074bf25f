//! The counts of each folder, in a file that people can read.

use std::collections::BTreeMap;
use std::fmt;

use super::sentences::Fault;

/// The beginning of the file, which explains it.
const HEAD: &str = "\
# Sentences to mend, per folder; `cargo xtask prose` counts them and fails where there are more, `--bless` lowers the numbers.
# long: more than 30 words; start: begins with Of, What, So many, Whether, Those, How or Which;
# rustdoc: a comment that begins with neither a verb nor a noun. `cargo xtask prose FOLDER` lists them.
";

/// The counts of a folder.
#[derive(Debug, Default, Clone, Copy, PartialEq, Eq)]
pub(super) struct Counts {
    long: usize,
    start: usize,
    rustdoc: usize,
}

impl Counts {
    /// Counts a fault.
    pub(super) fn add(&mut self, fault: Fault) {
        match fault {
            Fault::Long => self.long += 1,
            Fault::Start(_) => self.start += 1,
            Fault::Summary => self.rustdoc += 1,
        }
    }

    /// The smaller number of each.
    fn min(self, other: Self) -> Self {
        Counts {
            long: self.long.min(other.long),
            start: self.start.min(other.start),
            rustdoc: self.rustdoc.min(other.rustdoc),
        }
    }

    /// The three numbers with their names.
    fn named(self) -> [(&'static str, usize); 3] {
        [("long", self.long), ("start", self.start), ("rustdoc", self.rustdoc)]
    }
}

/// The counts that the folders may have.
#[derive(Debug, Default, PartialEq, Eq)]
pub(super) struct Table {
    rows: BTreeMap<String, Counts>,
}

impl Table {
    /// Reads a table as it is written.
    pub(super) fn read(text: &str) -> Result<Self, String> {
        let mut rows = BTreeMap::new();
        let is_row = |line: &&str| !line.starts_with('#') && !line.trim().is_empty();
        for line in text.lines().filter(is_row).skip(1) {
            let wrong = || format!("xtask/prose.txt: {line:?} is not a folder and three numbers");
            let mut cells = line.split_whitespace();
            let folder = cells.next().ok_or_else(wrong)?;
            let numbers: Vec<usize> = cells.map(str::parse).collect::<Result<_, _>>().map_err(|_| wrong())?;
            let [long, start, rustdoc] = numbers[..] else { return Err(wrong()) };
            // The sum follows from the rows.
            if folder != "all" {
                rows.insert(folder.to_owned(), Counts { long, start, rustdoc });
            }
        }
        Ok(Self { rows })
    }

    /// The table with the smaller of its counts and those that were found. A folder without a row gets one.
    pub(super) fn lowered(&self, found: &BTreeMap<String, Counts>) -> Self {
        let now = |folder: &String| found.get(folder).copied().unwrap_or_default();
        let mut rows: BTreeMap<String, Counts> =
            self.rows.iter().map(|(folder, counts)| (folder.clone(), counts.min(now(folder)))).collect();
        for (folder, counts) in found {
            rows.entry(folder.clone()).or_insert(*counts);
        }
        rows.retain(|_, counts| *counts != Counts::default());
        Self { rows }
    }

    /// A sentence for each count that is larger than the table's.
    pub(super) fn exceeded(&self, found: &BTreeMap<String, Counts>) -> Vec<String> {
        let mut sentences = Vec::new();
        for (folder, counts) in found {
            let most = self.rows.get(folder).copied().unwrap_or_default();
            for ((name, count), (_, most)) in counts.named().into_iter().zip(most.named()) {
                if count > most {
                    sentences.push(format!(
                        "{folder}: {count} sentences of the kind {name:?}, and at most {most} may be there; \
                         `cargo xtask prose {folder}` lists them"
                    ));
                }
            }
        }
        sentences
    }
}

impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{HEAD}\n{:20} {:>6} {:>6} {:>8}", "folder", "long", "start", "rustdoc")?;
        let mut all = Counts::default();
        for (folder, Counts { long, start, rustdoc }) in &self.rows {
            all = Counts { long: all.long + long, start: all.start + start, rustdoc: all.rustdoc + rustdoc };
            writeln!(f, "{folder:20} {long:6} {start:6} {rustdoc:8}")?;
        }
        writeln!(f, "{:20} {:6} {:6} {:8}", "all", all.long, all.start, all.rustdoc)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn counts(rows: &[(&str, [usize; 3])]) -> BTreeMap<String, Counts> {
        let counts = |[long, start, rustdoc]: [usize; 3]| Counts { long, start, rustdoc };
        rows.iter().map(|(folder, row)| ((*folder).to_owned(), counts(*row))).collect()
    }

    #[test]
    fn a_table_is_read_as_it_is_written() {
        let table = Table { rows: counts(&[("crates/exact", [1, 2, 3]), ("docs", [0, 5, 0])]) };
        assert!(table.to_string().ends_with("all                       1      7        3\n"), "{table}");
        assert_eq!(Table::read(&table.to_string()), Ok(table));
        assert!(Table::read("folder long start rustdoc\ndocs 1 2\n").is_err());
    }

    #[test]
    fn numbers_only_fall() {
        let table = Table { rows: counts(&[("docs", [4, 4, 4]), ("gone", [1, 0, 0])]) };
        let found = counts(&[("docs", [5, 3, 4]), ("new", [1, 0, 0])]);
        let lowered = table.lowered(&found);
        assert_eq!(lowered.rows, counts(&[("docs", [4, 3, 4]), ("new", [1, 0, 0])]));
        let [more] = &lowered.exceeded(&found)[..] else { panic!("{lowered}") };
        assert!(more.starts_with("docs: 5 sentences of the kind \"long\", and at most 4"), "{more}");
        assert_eq!(lowered.exceeded(&counts(&[("docs", [4, 3, 0])])), [""; 0]);
    }
}
