use super::*;

const LP: ExchangeFormat = ExchangeFormat::Lp;

/// The columns with cost and bounds, the rows with coefficients and bounds, as text.
fn shown(text: &str) -> String {
    let model = read(text, LP);
    let bound = |value: &Option<Rational>| value.as_ref().map_or("-".to_owned(), Rational::to_string);
    let bounds = |bounds: &Bounds| format!("[{}, {}]", bound(&bounds.lower), bound(&bounds.upper));
    let sense = if model.sense == ObjectiveSense::Maximize { "max" } else { "min" };
    let mut shown = vec![format!("{sense} {} {}", model.objective_name, model.constant)];
    shown.extend(
        model
            .columns
            .iter()
            .map(|column| format!("{} {} {}", column.name, column.cost, bounds(&column.bounds))),
    );
    shown.extend(model.rows.iter().map(|row| {
        let terms: Vec<String> = row
            .coefficients
            .iter()
            .map(|(place, value)| format!("{value} {}", model.columns[*place].name))
            .collect();
        format!("{}: {} {}", row.name, terms.join(" "), bounds(&row.bounds))
    }));
    shown.join("; ")
}

#[test]
fn expressions_may_be_written_in_many_ways() {
    for (text, expected) in [
        ("min x st x >= 2 end", "min obj 0; x 1 [0, -]; c1: 1 x [2, -]"),
        ("MAXIMIZE\n cost: 3x + - 2.5 y - -1e1z\nEND", "max cost 0; x 3 [0, -]; y -5/2 [0, -]; z 10 [0, -]"),
        ("Minimise\n obj: x\n + 3\n - 0.5\nend", "min obj 5/2; x 1 [0, -]"),
        (
            "minimum\nobj:\nsubject to\n r: x + 2 y <= 4\nend",
            "min obj 0; x 0 [0, -]; y 0 [0, -]; r: 1 x 2 y [-, 4]",
        ),
        ("max - 7\nsuch that\n x\n =\n 1/3\nend", "max obj -7; x 0 [0, -]; c1: 1 x [1/3, 1/3]"),
        (
            "min x\ns.t.\n x <2\n x =<3\n x>4\n x=> -5\n c2: x=6\nend",
            "min obj 0; x 1 [0, -]; c1: 1 x [-, 2]; c2_: 1 x [-, 3]; c3: 1 x [4, -]; c4: 1 x [-5, -]; c2: 1 x [6, 6]",
        ),
        (
            "min x st.\n a: 1 <= x + y <= 2\n b: 2 >= 3 x >= -1\n c: -inf <= x <= 5\n d: 7 <= x <= 4\nend",
            "min obj 0; x 1 [0, -]; y 0 [0, -]; a: 1 x 1 y [1, 2]; b: 3 x [-1, 2]; c: 1 x [-, 5]; d: 1 x [7, 4]",
        ),
        (
            "min x \\ comment\n\\ another\nst\n c: x >= 1 \\ and so on\nend x",
            "min obj 0; x 1 [0, -]; c: 1 x [1, -]",
        ),
        (
            "min x\nst\n e: 0 x + 0 y <= -1\n f: - 0 x >= -1e30\nend",
            "min obj 0; x 1 [0, -]; y 0 [0, -]; e:  [-, -1]; f:  [-, -]",
        ),
        ("min\nst\n r: -inf <= 0 <= 5\nend", "min obj 0; r:  [-, 5]"),
        ("min x\nst\n r1: >= -2\n r2: = 0\nend", "min obj 0; x 1 [0, -]; r1:  [-2, -]; r2:  [0, 0]"),
        (
            "min x st end: x >= 1\n\n  st: x\n >= 2\nend",
            "min obj 0; x 1 [0, -]; end: 1 x [1, -]; st: 1 x [2, -]",
        ),
        (
            "min x[1] + 2 e1 + 3e + y(2,3)\nend",
            "min obj 0; x[1] 1 [0, -]; e1 2 [0, -]; e 3 [0, -]; y(2,3) 1 [0, -]",
        ),
        (
            "min 2e1x + 3.e0 y\nst\nc: 2D0 x + .5 y >= 1.\nend",
            "min obj 0; x 20 [0, -]; y 3 [0, -]; c: 2 x 1/2 y [1, -]",
        ),
    ] {
        assert_eq!(shown(text), expected, "{text}");
    }
}

#[test]
fn bounds_are_meant_as_cplex_means_them() {
    for (lines, lower, upper) in [
        ("", "0", "-"),
        ("x free", "-", "-"),
        ("x FREE", "-", "-"),
        ("-inf <= x <= 3", "-", "3"),
        ("-infinity <= x <= +inf", "-", "-"),
        ("x >= -inf", "-", "-"),
        ("x >= -1e30", "-", "-"),
        ("x = 3", "3", "3"),
        ("x <= 3", "0", "3"),
        ("x <= -3", "0", "-3"),
        ("x >= 0\nx <= -3", "0", "-3"),
        ("x <= 0", "0", "0"),
        ("2 <= x", "2", "-"),
        ("2 >= x", "0", "2"),
        ("3 >= x >= 1", "1", "3"),
        ("- 3 <= x <= - -4", "-3", "4"),
        ("x <= 3\nx <= 2\nx >= 1", "1", "2"),
        ("x free\nx >= 1", "1", "-"),
        ("1 <=\nx <=\n2", "1", "2"),
    ] {
        let text = format!("min x\nst\nbounds\n{lines}\nend");
        assert_eq!(read(&text, LP).columns[0].bounds, bounds(lower, upper), "{lines}");
    }
    assert_eq!(shown("min x bound x <= 2 end"), "min obj 0; x 1 [0, 2]");
    assert_eq!(shown("min x generals bin semi-continuous sos end"), "min obj 0; x 1 [0, -]");
}

#[test]
fn a_bound_makes_a_column_without_terms() {
    let text = "min c11 bounds\n c10 <= 5\n -3 <= t <= 9\n c10 >= 1\nend";
    assert_eq!(shown(text), "min obj 0; c11 1 [0, -]; c10 0 [1, 5]; t 0 [-3, 9]");
    let text = "min bounds\n x <= 5\nst\n x >= 1\nend";
    assert_eq!(shown(text), "min obj 0; x 0 [0, 5]; c1: 1 x [1, -]");
}

#[test]
fn refusals_say_what_would_be_accepted() {
    let file = "a linear program in LP format: minimize or maximize, subject to, bounds, end";
    let values = "columns that may have any value between two bounds";
    let relation = "this cannot stand here (expected +, - or one of <=, >= and =)";
    let term = "this cannot stand here (expected a term such as 3 x)";
    let row = "this cannot stand here (expected one number on the right side, and the next row on a line of its own)";
    let range = "this cannot stand here (expected <= on both sides, as in 1 <= x <= 2, or >= on both)";
    let bound = "this cannot stand here (expected a bound on a line of its own: x <= 3, -inf <= x <= 3, x = 3 or x free)";
    let right = "this cannot stand here (expected a number; variables belong to the left side)";
    let lp_solve = "this is lp_solve's own LP format (expected CPLEX's LP format, or MPS: lp_solve -S1 -parse_only FILE.lp -wfmps FILE.mps writes it)";
    let left = "this cannot stand here (expected a variable behind the number; numbers alone belong to the right side)";
    for (text, expected) in [
        ("", format!("there is nothing in the file (expected {file})")),
        ("\\ nothing\n\n", format!("there is nothing in the file (expected {file})")),
        ("NAME x", "line 1, column 1: \"NAME\": this cannot stand here (expected minimize or maximize, then the objective)".to_owned()),
        ("max: 3x + 2y;", format!("line 1, column 4: \":\": {lp_solve}")),
        ("/* lp_solve */\nmax: 3x + 2y;\n", format!("line 1, column 1: \"/\": {lp_solve}")),
        ("max: 3x + 2y", format!("line 1, column 4: \":\": {term}")),
        ("min x y end", format!("line 1, column 7: \"y\": {relation}")),
        ("min 3 4 end", format!("line 1, column 7: \"4\": {relation}")),
        ("min 3 * x end", "line 1, column 7: \"*\": LP format has * in quadratic terms alone (expected a blank, as in 3 x)".to_owned()),
        ("min x + [ x^2 ]/2 end", "line 1, column 9: \"[\": quadratic terms are not linear (expected terms such as 3 x)".to_owned()),
        ("min x/3 st c: x >= 4\nend", "line 1, column 5: \"x/3\": the name may be a term of the variable \"x\" (expected terms such as 1/3 x and 2 x, or another name)".to_owned()),
        ("min x st c: 2 (x) >= 4\nend", "line 1, column 15: \"(x)\": the name may be a term of the variable \"x\" (expected terms such as 1/3 x and 2 x, or another name)".to_owned()),
        ("min x^2 end", "line 1, column 6: \"^\": quadratic terms are not linear (expected terms such as 3 x)".to_owned()),
        ("min x / 2 end", format!("line 1, column 7: \"/\": {relation}")),
        ("min 2 x + 3 y - x end", "line 1, column 17: \"x\": the variable has a term on line 1 already (expected one term of each variable)".to_owned()),
        ("min x\nst\n c: x +\n y + x <= 1\nend", "line 4, column 6: \"x\": the variable has a term on line 3 already (expected one term of each variable)".to_owned()),
        ("min x st\n a: x <= 1\n a: x <= 2\nend", "line 3, column 2: \"a\": the row is on line 2 already (expected names that differ)".to_owned()),
        ("min x st\n >= -2\nend", format!("line 2, column 2: \">=\": {term}")),
        ("min x st x <= y end", format!("line 1, column 15: \"y\": {right}")),
        ("min x st x <= 4 y\nend", format!("line 1, column 17: \"y\": {row}")),
        ("min x st x <= 4 + 1\nend", format!("line 1, column 17: \"+\": {row}")),
        ("min x st x + 3 <= 4 end", format!("line 1, column 14: \"3\": {left}")),
        ("min x st 1 <= x >= 0\nend", format!("line 1, column 17: \">=\": {range}")),
        ("min x st 1 = x <= 2\nend", format!("line 1, column 12: \"=\": {range}")),
        ("min x st b: x = 1 -> x <= 2\nend", "line 1, column 19: \"->\": this is more than a linear program (expected rows, columns, right-hand sides, ranges and bounds)".to_owned()),
        ("min x st x >= inf end", "line 1, column 15: \"inf\": an infinite lower bound leaves no value (expected a number; 1e30 and more are infinite)".to_owned()),
        ("min x st x == 1 end", format!("line 1, column 13: \"=\": {right}")),
        ("min x st <= 1 end", format!("line 1, column 10: \"<=\": {term}")),
        ("min x bounds\n 2 x <= 4\nend", format!("line 2, column 2: \"2\": {bound}")),
        ("min x bounds\n x 4\nend", format!("line 2, column 4: \"4\": {bound}")),
        ("min x bounds\n x <= 4 y <= 5\nend", format!("line 2, column 9: \"y\": {bound}")),
        ("min demand bounds\n demnd <= 4\nend", "line 2, column 2: \"demnd\": there is no such column; did you mean \"demand\"? (expected a column that has coefficients; they may be 0)".to_owned()),
        ("min x bounds\n x <= 1e99999\nend", "line 2, column 7: \"1e99999\": refused: exponent beyond 10000 (the limit) at character 3".to_owned()),
        ("min x\ngenerals\n x\nend", format!("line 3, column 2: \"x\": the column is integer (expected {values})")),
        ("min x\nBinaries\n x\nend", format!("line 3, column 2: \"x\": the column is integer (expected {values})")),
        ("min x\nsemi-continuous\n x\nend", format!("line 3, column 2: \"x\": the column is semi-continuous (expected {values})")),
        ("min x\nSOS\ns1: S1:: x:1\nend", "line 3, column 1: \"s1\": this is more than a linear program (expected rows, columns, right-hand sides, ranges and bounds)".to_owned()),
        ("min x\nst\n x >= 1\n", "line 3, column 2: \"x >= 1\": the file stops without its end (expected end as the last word; was the file cut off?)".to_owned()),
        ("min x +\n", "line 1, column 1: \"min x +\": the file stops without its end (expected end as the last word; was the file cut off?)".to_owned()),
        ("min . x end", "line 1, column 5: \".\": not a number: a digit is missing at character 2 (expected a decimal such as 1.30e-2 or a fraction such as 7/19)".to_owned()),
        ("min x st\n\n y + 3 end <= 2 end", format!("line 3, column 6: \"3\": {left}")),
        ("min x\n st\n c: 3 <= 2\nend", format!("line 3, column 10: \"2\": {left}")),
    ] {
        assert_eq!(message(text, LP), expected, "{text}");
    }
    let limits = ModelLimits { rows: 1, columns: 1, entries: 2, ..ModelLimits::default() };
    for (text, expected) in [
        ("min x st x <= 1\nx <= 2\nend", "line 2, column 1: \"x\": there are more than 1 rows (the limit)"),
        ("min x + y end", "line 1, column 9: \"y\": there are more than 1 columns (the limit)"),
    ] {
        assert_eq!(read_model(text, LP, &limits).unwrap_err().to_string(), expected);
    }
}
