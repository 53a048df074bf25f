//! Reports for people are no wider than 80 columns.

use std::fs;

use boundfit_tests::program::{root, run};

const WIDTH: usize = 80;

/// Lines with more columns, unless a single word is at fault.
fn too_wide(text: &str) -> Vec<&str> {
    let is_at_fault = |line: &&str| {
        line.chars().count() > WIDTH && line.split(' ').all(|word| word.chars().count() < WIDTH / 2)
    };
    text.lines().filter(is_at_fault).collect()
}

fn check(line: &str) {
    let arguments: Vec<String> = line.split('|').map(str::to_owned).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let run = run(&arguments);
    assert!([0, 3, 4].contains(&run.status), "{line}: {}", run.stderr);
    assert_eq!(too_wide(&run.stdout), Vec::<&str>::new(), "{line}");
}

/// Tables of x and y, with a bound that leaves something and one that leaves nothing.
#[test]
fn reports_of_all_fixtures_fit() {
    let mut seen = 0;
    for folder in ["figures", "claims", "hard-lp", "norris", "steam-generator"] {
        for entry in fs::read_dir(root().join("fixtures").join(folder)).unwrap() {
            let path = entry.unwrap().path();
            let text = fs::read_to_string(&path).unwrap_or_default();
            let is_table = path.extension().is_some_and(|ending| ending == "csv");
            let header: Vec<&str> = text.lines().next().unwrap_or_default().split(',').collect();
            if !is_table || !["x", "y"].iter().all(|name| header.contains(name)) {
                continue;
            }
            let data = format!("{}|--x|x|--y|y", path.display());
            for options in [
                "--eps|1e9",
                "--eps|1e9|--full",
                "--eps|0|--full",
                "--eps|1e-3|--inverse|--full",
                "--eps|1/3|--sweep|0.5..2",
                "--eps|0.1|--reading|binary64",
            ] {
                check(&format!("fit|{data}|{options}"));
            }
            check(&format!("check|{data}|--eps|1/3|--directions|8"));
            seen += 1;
        }
    }
    assert!(seen >= 8, "{seen} tables");
}

#[test]
fn reports_of_half_planes_fit() {
    let mut seen = 0;
    for entry in fs::read_dir(root().join("fixtures/polygon")).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|ending| ending == "ine" || ending == "ext" || ending == "csv") {
            check(&format!("polygon|{}", path.display()));
            seen += 1;
        }
    }
    assert!(seen >= 3, "{seen} files");
}

#[test]
fn the_transducer_fits_in_every_way() {
    let data = "fixtures/transducer/transducer.csv|--x|Vz|--y|z|--rows|14..36|--eps|0.5e-3";
    check(&format!("check|{data}"));
    for options in [
        "--exact",
        "--exact|--full",
        "--digits|12",
        "--digits|30|--full",
        "--digits|40|--inverse|--full",
        "--sweep|0..3",
        "--rounding|nearest",
    ] {
        check(&format!("fit|{data}|{options}"));
    }
}
