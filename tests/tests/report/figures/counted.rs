//! The numbers of readings and optimisers that a figure says it shows.

use std::process::Command;

use boundfit_tests::program::binary;

use super::{TRANSDUCER, picture};

#[test]
fn figures_of_a_reduction_show_the_readings_that_it_keeps() {
    let folder = tempfile::tempdir().unwrap();
    let rows: String = (0..100).map(|row| format!("{row},{}\n", row * row % 7)).collect();
    std::fs::write(folder.path().join("data.csv"), format!("x,y\n{rows}")).unwrap();
    let reduce = ["reduce", "data.csv", "--x", "x", "--y", "y", "-o", "reduced.csv"];
    assert!(Command::new(binary()).args(reduce).current_dir(folder.path()).status().unwrap().success());
    let reduced = folder.path().join("reduced.csv").display().to_string();
    let kept = std::fs::read_to_string(&reduced).unwrap().lines().count() - 2;
    assert!(kept < 100);
    for figure in ["data", "pui", "corridor"] {
        let svg = picture(&format!("{reduced} --x x --y y --eps 4 --figure {figure}"), 0);
        let svg = String::from_utf8(svg).unwrap();
        assert!(svg.contains(&format!("Fitted, with error bars: {kept} readings.")), "{figure}");
        let note =
            format!("Drawn are {kept} of 100 readings: the data are a reduction, which keeps no others.");
        assert!(svg.contains(&note), "{figure}");
    }
}

#[test]
fn optimisers_outside_a_view_are_counted() {
    let all = String::from_utf8(picture(&format!("{TRANSDUCER} --figure directions"), 0)).unwrap();
    assert!(!all.contains("optimisers."), "{all}");
    let part = picture(&format!("{TRANSDUCER} --figure directions --x-range 0.00181..0.00183"), 0);
    let part = String::from_utf8(part).unwrap();
    assert!(part.contains("Outside this view: 5 of 6 optimisers."), "{part}");
}
