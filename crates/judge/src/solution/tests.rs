use boundfit_exact::Limits;

use super::{SolverStatus, read_solution};

fn refusal(text: &str) -> String {
    read_solution(text, &Limits::default()).map(|file| panic!("{text}: {file:?}")).unwrap_err().to_string()
}

fn status(text: &str) -> SolverStatus {
    read_solution(text, &Limits::default()).unwrap_or_else(|error| panic!("{text}: {error}")).status
}

/// A solution as GLPK writes it for programs.
const PLAIN: &str = "c Status:     OPTIMAL\nc Objective:  COST = 31.5 (MAXimum)\nc\ns bas 2 2 f f 31.5\ni 1 u 12 2.25\ni 2 u 18 0.25\nj 1 b 3 0\nj 2 b 4.5 0\ne o f\n";
const PRINTED: &str = "Problem:    T\nRows:       2\nColumns:    2\nStatus:     OPTIMAL\nObjective:  COST = 31.5 (MAXimum)\n\n   No.   Row name   St   Activity     Lower bound   Upper bound    Marginal\n     1 R1           NU            12                          12          2.25\n     2 R2           NU            18                          18          0.25\n\n   No. Column name  St   Activity     Lower bound   Upper bound    Marginal\n     1 X1           B              3             0\n     2 X2           B            4.5             0\n\nKarush-Kuhn-Tucker optimality conditions:\n\nKKT.PE: max.abs.err = 0.00e+00 on row 0\n\nEnd of output\n";
const RAW: &str = "Model status\nOptimal\n\n# Primal solution values\nFeasible\nObjective 31.5\n# Columns 2\nX1 3\nX2 4.5\n# Rows 2\nR1 12\nR2 18\n\n# Dual solution values\nFeasible\n# Columns 2\nX1 0\nX2 0\n# Rows 2\nR1 2.25\nR2 0.25\n\n# Basis\nHiGHS_basis_file v2\nNone\n";

#[test]
fn files_that_were_cut_off_are_refused() {
    for text in [PLAIN, PRINTED, RAW] {
        assert_eq!(status(text), SolverStatus::Optimal, "{text}");
        // All that HiGHS says in its last section does not matter.
        let end = text.find("\n# Basis").unwrap_or(text.len());
        let lines: Vec<&str> = text[..end].lines().collect();
        for count in 0..lines.len() {
            let cut = lines[..count].join("\n") + "\n";
            refusal(&cut);
        }
    }
    let cut = "(was the file cut off?)";
    for (text, from, to, message) in [
        (PLAIN, "s bas 2 2", "s bas 3 2", "line 4: \"s bas 3 2 f f 31.5\": the file lists 2 rows"),
        (
            PLAIN,
            "i 1 u 12 2.25\ni 2 u 18 0.25\n",
            "",
            "line 4: \"s bas 2 2 f f 31.5\": the file lists 0 rows",
        ),
        (PLAIN, "j 2 b 4.5 0\n", "", "line 4: \"s bas 2 2 f f 31.5\": the file lists 1 column"),
        (PLAIN, "e o f\n", "", "the file stops without its last line \"e o f\", which GLPK writes"),
        (
            PRINTED,
            "     2 R2           NU            18                          18          0.25\n",
            "",
            "line 2: \"Rows:       2\": the file lists 1 row",
        ),
        (PRINTED, "Columns:    2", "Columns:    3", "line 3: \"Columns:    3\": the file lists 2 columns"),
        (
            PRINTED,
            "End of output\n",
            "",
            "the file stops without its last line \"End of output\", which GLPK writes",
        ),
        (RAW, "# Columns 2\nX1 3", "# Columns 3\nX1 3", "line 7: \"# Columns 3\": the file lists 2 columns"),
        (RAW, "R1 12\nR2 18\n", "R1 12\n", "line 10: \"# Rows 2\": the file lists 1 row"),
        (RAW, "R2 0.25\n", "", "line 19: \"# Rows 2\": the file lists 1 row"),
        (
            RAW,
            "# Rows 2\nR1 2.25\nR2 0.25\n",
            "",
            "the file stops without the rows of its duals, which HiGHS writes",
        ),
    ] {
        assert!(text.contains(from), "{from}");
        assert_eq!(refusal(&text.replacen(from, to, 1)), format!("{message} {cut}"), "{to}");
    }
}

#[test]
fn files_that_contradict_themselves_are_refused() {
    let stated = "line 4: \"s bas 2 2 n n 31.5\" contradicts line 1: \"c Status:     OPTIMAL\"";
    assert_eq!(refusal(&PLAIN.replace("f f 31.5", "n n 31.5")), stated);
    let stated = "line 4: \"s bas 2 2 f f 31.5\" contradicts line 1: \"c Status:     UNBOUNDED\"";
    assert_eq!(refusal(&PLAIN.replace("OPTIMAL", "UNBOUNDED")), stated);
    let stated = "line 4: \"s bas 2 2 f f 31.5\" contradicts line 2: \"c Objective:  COST = 77 (MAXimum)\"";
    assert_eq!(refusal(&PLAIN.replace("COST = 31.5", "COST = 77")), stated);
    // Rounding is no contradiction, nor are letters of HiGHS that decide nothing.
    let rounded =
        PLAIN.replace("COST = 31.5", "COST = 31.66666667").replace("f f 31.5", "f f 31.6666666666667");
    assert_eq!(status(&rounded), SolverStatus::Optimal);
    assert_eq!(status(&PLAIN.replace("f f 31.5", "f i 31.5")), SolverStatus::Optimal);
}

#[test]
fn highs_without_a_point_stops_after_its_heading() {
    let empty =
        "c Problem:    \nc Rows:       1\nc Columns:    0\nc Non-zeros:  0\nc Status:     UNDEFINED\n\n";
    assert_eq!(status(empty), SolverStatus::Other("UNDEFINED".to_owned()));
    let infeasible =
        "c Problem:    T\nc Rows:       3\nc Status:     INFEASIBLE (FINAL)\nc\ns bas 3 2 u u 0\n";
    assert_eq!(status(infeasible), SolverStatus::Infeasible);
    let cut = "c Problem:    T\nc Status:     OPTIMAL\n";
    assert_eq!(refusal(cut), "the file stops without a line \"s bas\", which GLPK writes");
}
