//! Compares every algorithm on generated sets: `deep [--cases N] [--seed N] [--first N] [--threads N]`.
//!
//! Prints how often each kind of region came up in each family of sets. At the first difference it prints the seed,
//! the number of the case, the difference, and the smallest set that still shows it, as a file. It then exits with 1.

use std::process::ExitCode;
use std::time::Instant;

use boundfit_geometry::RegionKind;
use boundfit_tests::deep::{Counts, Difference, run};
use clap::Parser;

/// Compares clipping, the fast intersection, brute force, the exact simplex and all ways to fit on generated sets.
#[derive(Debug, Parser)]
struct Arguments {
    /// How many cases
    #[arg(long, default_value_t = 20_000)]
    cases: u64,
    /// What the cases follow from
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Number of the first case
    #[arg(long, default_value_t = 0)]
    first: u64,
    /// Number of threads; all processors when 0
    #[arg(long, default_value_t = 0)]
    threads: usize,
}

fn main() -> ExitCode {
    let Arguments { cases, seed, first, threads } = Arguments::parse();
    let pool = match rayon::ThreadPoolBuilder::new().num_threads(threads).build() {
        Ok(pool) => pool,
        Err(error) => {
            eprintln!("deep: {error}");
            return ExitCode::FAILURE;
        }
    };
    // A panic is one of the differences: its place is enough, shrinking repeats it.
    std::panic::set_hook(Box::new(|panic| eprintln!("{panic}")));
    let start = Instant::now();
    let result = pool.install(|| run(seed, first..first.saturating_add(cases)));
    match result {
        Ok(counts) => {
            print!("{}", table(&counts));
            println!("{cases} cases of seed {seed}, no difference");
            eprintln!("{:.1} s", start.elapsed().as_secs_f64());
            ExitCode::SUCCESS
        }
        Err(difference) => {
            let Difference { number, family, messages: [found, smallest], fixture } = *difference;
            println!("difference in case {number} of seed {seed} ({family}): {found}");
            println!("again: deep --seed {seed} --first {number} --cases 1");
            println!("the smallest set with a difference: {smallest}\n\n{fixture}");
            ExitCode::FAILURE
        }
    }
}

/// Families down, kinds across.
fn table(counts: &Counts) -> String {
    let kinds = RegionKind::ALL.map(RegionKind::name);
    let line = |name: &str, cells: Vec<String>, total: String| {
        let widths = kinds.iter().map(|kind| kind.len().max(7));
        let cells: String =
            cells.iter().zip(widths).map(|(cell, width)| format!("  {cell:>width$}")).collect();
        format!("{name:<13}{cells}  {total:>8}\n")
    };
    let of = |kinds_of: &[&std::collections::BTreeMap<&'static str, u64>], kind: &str| -> u64 {
        kinds_of.iter().filter_map(|counts| counts.get(kind)).sum()
    };
    let row = |name: &str, counts: &[&std::collections::BTreeMap<&'static str, u64>]| {
        let cells: Vec<u64> = kinds.iter().map(|kind| of(counts, kind)).collect();
        let total: u64 = cells.iter().sum();
        line(name, cells.iter().map(u64::to_string).collect(), total.to_string())
    };
    let mut text = line("", kinds.map(str::to_owned).into(), "all".to_owned());
    for (family, counts) in counts {
        text += &row(family, &[counts]);
    }
    text + &row("all", &counts.values().collect::<Vec<_>>())
}
