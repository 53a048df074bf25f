use boundfit_formats::Source;
use boundfit_report::{EndRounding, Style};

use super::*;
use crate::form::Form;
use crate::request::Request;
use crate::surface::Surface;

/// A surface whose keys are easily told from words.
struct Keys;

impl Surface for Keys {
    fn key(&self, key: &str) -> String {
        format!("<{key}>")
    }

    fn value(&self, key: &str, text: &str) -> String {
        format!("<{key}> {text}")
    }

    fn way(&self, way: &boundfit_formats::Way) -> String {
        format!("<{}>", way.setting.name())
    }
}

fn resolved(json: &str) -> Result<Asked, String> {
    let resolve = || {
        let (request, Common { readings, .. }) = Request::with_readings(json)?;
        request.resolve(&readings, readings.table.reading(false)?)
    };
    resolve().map_err(|refusal: Refusal| refusal.words(&Keys))
}

#[test]
fn words_that_exclude_or_need_each_other_are_refused_by_their_keys() {
    let range = |own: &str| resolved(&format!("{{\"ask\": \"range\", {own}}}")).map(|_| ());
    let line = r#""x": "V", "y": "z", "eps": "1""#;
    let plane = r#""x": ["u", "v"], "y": "z", "eps": "1""#;
    assert_eq!(range(line), Ok(()));
    assert_eq!(range(plane), Ok(()));
    assert_eq!(range(r#""x": "V", "lower": "low""#), Ok(()));
    for (own, words) in [
        (r#""y": "z", "eps": "1""#.to_owned(), "<x> is missing"),
        (r#""x": "V", "eps": "1""#.to_owned(), "<y> is missing: only beside <lower> or <upper>"),
        (
            r#""x": "V", "y": "z""#.to_owned(),
            "the bound on the errors is missing: <eps>, <eps_column>, <lower> or <upper>",
        ),
        (format!("{line}, \"upper\": \"high\""), "the errors have one bound: <eps>, or <eps_column>"),
        (format!("{line}, \"eps_column\": \"e\""), "the errors have one bound: <eps>, or <eps_column>"),
        (format!("{plane}, \"through_origin\": true"), "<through_origin> is about a line"),
        (format!("{plane}, \"x_origin\": \"1\""), "<x_origin> is about a line"),
        (format!("{line}, \"strong\": true"), "<strong> is about errors in x"),
        (
            format!("{line}, \"x_eps\": \"1\", \"x_eps_column\": \"e\""),
            "the errors of x have one bound: <x_eps> or",
        ),
        (format!("{line}, \"x_eps\": \"0.1%*|x|\""), "<x_eps> 0.1%*|x|: an error of x has no law (expected"),
        (format!("{line}, \"x_eps\": \"written\""), "<x_eps> written: an error of x has no law (expected"),
        (format!("{line}, \"x_eps\": \"-1\""), "<x_eps> -1: negative (expected"),
        (
            format!("{line}, \"decimal\": \"comma\", \"thousands\": \",\""),
            "<thousands> and <decimal> name one mark",
        ),
        (format!("{line}, \"without\": \"1..\""), "<without> 1..: no row is left"),
        (format!("{line}, \"where\": [\"theta3 > 0\"]"), "<where> theta3 > 0: neither a number"),
        (format!("{line}, \"missing\": \"drop\""), "<missing> drop: expected one of \"refuse\", \"skip\""),
        (format!("{line}, \"header\": true"), "<header>: true: expected a text"),
        (
            format!("{line}, \"limits\": {{\"sets\": 3}}"),
            "<limits> sets: 'outliers' has a key for it, max_sets",
        ),
        (format!("{line}, \"limits\": {{\"depth\": 1}}"), "<limits> depth: expected one of \"digits\""),
        (
            format!("{line}, \"limits\": {{\"nesting\": 121}}"),
            "<limits> 121: no value of the limit nesting (expected an integer from 1 to 120)",
        ),
    ] {
        let refused = range(&own).unwrap_err();
        assert!(refused.starts_with(words), "{own}: {refused}");
    }
    assert!(resolved(r#"{"ask": "linearity", "x": "x", "up": "u", "down": "d"}"#).is_ok());
    let law = range(r#""x": ["u", "v"], "y": "z", "eps": "1%*|x|""#).unwrap_err();
    assert_eq!(law, "<eps> 1%*|x|: two regressors have no |x| (expected a law of |y|, range(y) and written)");
}

#[test]
fn a_limit_that_a_number_passes_is_a_way_out_and_can_be_raised() {
    let digits = "7".repeat(20_000);
    let own = |limits: &str| {
        resolved(&format!(r#"{{"ask": "range", "x": "V", "y": "z", "eps": "{digits}"{limits}}}"#)).map(|_| ())
    };
    assert!(own("").unwrap_err().ends_with("; <digits>"));
    assert_eq!(own(r#", "limits": {"digits": 20000}"#), Ok(()));
}

#[test]
fn exact_numbers_are_what_they_say_under_every_reading() {
    let epsilon = |eps: &str| {
        let json = format!(r#"{{"ask": "range", "x": "V", "y": "z", "reading": "binary64", "eps": {eps}}}"#);
        match resolved(&json).unwrap().question.columns.epsilon {
            EpsilonColumn::Uniform(number) => number,
            other => panic!("{other:?}"),
        }
    };
    assert_eq!(epsilon(r#"{"exact": "0.1"}"#), Rational::ratio(1, 10));
    assert_eq!(Some(epsilon(r#""0.1""#)), Rational::from_f64(0.1));
    assert_eq!(epsilon("3"), Rational::from(3));
}

#[test]
fn what_bounds_errors_of_x_is_a_number_or_else_a_column() {
    let bounds = |x_eps: &str| {
        let json = format!(r#"{{"ask": "fit-x-errors", "x": "V", "y": "z", "eps": "1", "x_eps": {x_eps}}}"#);
        resolved(&json).map(|asked| asked.x_errors.unwrap().bounds)
    };
    assert!(matches!(bounds(r#""0.5""#), Ok(AskedXBounds::Uniform(half)) if half == Rational::ratio(1, 2)));
    assert!(matches!(bounds(r#""ux""#), Ok(AskedXBounds::Column(column)) if *column.text() == *"ux"));
    assert!(bounds(r#"{"exact": "ux"}"#).is_err());
}

/// Asks about two readings under a uniform bound, with further keys.
fn asked(ask: &str, keys: &str) -> Result<(), String> {
    let json = format!(r#"{{"ask": "{ask}", "x": "V", "y": "z", "eps": "1"{keys}}}"#);
    let answer = || {
        let (request, Common { readings, .. }) = Request::with_readings(&json)?;
        let asked = request.resolve(&readings, readings.table.reading(false)?)?;
        let source = Source::of_bytes("table", "V,z\n0,0\n1,1.5\n".as_bytes().to_vec());
        request.answer(&asked, source, Form::Json, None, &Style::default())
    };
    answer().map(|_| ()).map_err(|refusal: Refusal| refusal.words(&Keys))
}

#[test]
fn check_says_which_key_claim_or_solver_is_at_fault() {
    for (keys, words) in [
        (r#", "directions": 2"#, "<directions> 2: expected an integer from 3 to 10000"),
        (r#", "time_limit": 0"#, "<time_limit> 0: expected an integer from 1 to 86400"),
        (
            r#", "scaled": true"#,
            "<scaled> says how directions are spread: say how many there are with <directions>",
        ),
        (r#", "tolerance": {"exact": "-1"}"#, "<tolerance> -1: expected a number that is at least 0"),
        (r#", "claim_pui": ["1,2"]"#, "<claim_pui> 1,2: 2 values (expected four"),
        (r#", "claim": [{"file": "a", "text": "[]"}]"#, "a: a list (expected"),
        (
            r#", "claim": [{"file": "a", "text": "1e9999"}], "limits": {"work": 1}"#,
            "a: refused: exact arithmetic",
        ),
        (r#", "solver": ["none"]"#, "there is no solver \"none\" in this build; it has "),
    ] {
        let refused = asked("check", keys).unwrap_err();
        assert!(refused.starts_with(words), "{keys}: {refused}");
    }
    assert_eq!(
        asked("check", r#", "solver": ["exact-simplex"], "tolerance": 0, "directions": 3, "scaled": true"#),
        Ok(())
    );
}

#[test]
fn half_planes_have_columns_of_their_own_and_no_word_about_readings() {
    let answer = |keys: &str, table: &str| {
        let answer = || {
            let json = format!(r#"{{"ask": "polygon"{keys}}}"#);
            let (request, Common { readings, .. }) = Request::with_readings(&json)?;
            let asked = request.resolve(&readings, readings.table.reading(false)?)?;
            let source = Source::of_bytes("table", table.as_bytes().to_vec());
            request.answer(&asked, source, Form::Wkt, None, &Style::default())
        };
        answer().map(|answer| answer.text).map_err(|refusal: Refusal| refusal.words(&Keys))
    };
    let triangle = "a1;a2;b\n-1;0;0\n0;-1;0\n2;3;1,5\n";
    assert_eq!(answer("", triangle).unwrap(), "POLYGON ((0 0, 0.75 0, 0 0.5, 0 0))\n");
    assert_eq!(answer(r#", "decimal": "comma""#, triangle), answer("", triangle));
    for keys in [r#", "x": "a1""#, r#", "eps": "1""#, r#", "where": ["theta1 >= 0"]"#, r#", "rows": [1]"#] {
        assert!(
            answer(keys, triangle).unwrap_err().starts_with("half-planes are rows with the columns a1"),
            "{keys}"
        );
    }
    let refused = answer("", "p,q,r\n1,2,3\n").unwrap_err();
    assert!(refused.contains("there is no column \"a1\""), "{refused}");
    assert!(refused.ends_with("; a row a1,a2,b means a1*theta1 + a2*theta2 <= b"), "{refused}");
}

#[test]
fn a_linear_program_is_read_as_its_format_says() {
    let answer = |keys: &str, form: Form, name: &str, text: &str| {
        let answer = || {
            let json = format!(r#"{{"ask": "judge"{keys}}}"#);
            let (request, Common { readings, .. }) = Request::with_readings(&json)?;
            request.refuse_vain(form, &Style::default())?;
            let asked = request.resolve(&readings, readings.table.reading(false)?)?;
            let source = Source::of_bytes(name, text.as_bytes().to_vec());
            request.answer(&asked, source, form, None, &Style::default())
        };
        answer().map_err(|refusal: Refusal| refusal.words(&Keys))
    };
    let lp = "max\n x + y\nst\n r: x + 3 y <= 4\nbounds\n x <= 1\nend\n";
    let solution =
        r#", "solution": [{"file": "a.json", "text": "{\"status\": \"optimal\", \"objective\": 3}"}]"#;
    let exact = answer("", Form::Text, "program", lp).unwrap();
    assert!(exact.text.contains("\nOptimal: obj = 2, at one point\n"), "{}", exact.text);
    assert_eq!(exact.written, crate::Written::default());
    assert!(answer(solution, Form::Sarif, "program", lp).unwrap().written.is_refuted);
    assert!(
        !answer(&format!(r#"{solution}, "tolerance": 9"#), Form::Junit, "a.lp", lp)
            .unwrap()
            .written
            .is_refuted
    );
    // Whoever asks about solutions is not told of the empty set once more.
    let none = lp.replace("x <= 1", "2 <= x <= 1");
    assert!(answer("", Form::Json, "a.LP.gz", &none).unwrap().written.is_empty);
    assert!(!answer(solution, Form::Json, "a.LP.gz", &none).unwrap().written.is_empty);
    for (keys, form, text, words) in [
        ("", Form::Sarif, lp, "sarif and junit write findings about solutions: give <solution>"),
        (
            r#", "eps": "1""#,
            Form::Text,
            lp,
            "a linear program is read as MPS or LP format say: beside it only <limits>",
        ),
        (r#", "decimal": "comma""#, Form::Text, lp, "a linear program is read as"),
        (r#", "tolerance": "-1""#, Form::Text, lp, "<tolerance> -1: expected a number that is at least 0"),
        (r#", "solution": [{"file": "a.json", "text": "[]"}]"#, Form::Text, lp, "a.json: "),
        (
            r#", "limits": {"rows": 1}"#,
            Form::Text,
            "NAME\nROWS\n N c\n L r\n",
            "line 4, column 4: \"r\": there are more than 1 rows",
        ),
        ("", Form::Text, "min\nx + y + z\nend\n", "3 columns are not fixed"),
        ("", Form::Text, "a,b\n1,2\n", "line 1, column 1: \"a,b\": this begins no section of MPS"),
    ] {
        let refused = answer(keys, form, "program", text).unwrap_err();
        assert!(refused.starts_with(words), "{keys}: {refused}");
    }
}

#[test]
fn linearity_refuses_what_only_fits_are_asked_under() {
    for (keys, words) in [
        (r#", "where": ["theta1 >= 0"]"#, "<where> is about the set of all lines that agree"),
        (r#", "through_origin": true"#, "<through_origin> is about fits"),
        (r#", "x_origin": "1980""#, "<x_origin> is about fits"),
    ] {
        assert!(asked("linearity", keys).is_err_and(|refused| refused.starts_with(words)), "{keys}");
        assert_eq!(asked("fit", keys), Ok(()));
    }
    assert_eq!(asked("linearity", r#", "x_origin": "0", "through_origin": false, "where": []"#), Ok(()));
}

#[test]
fn errors_of_x_are_refused_where_every_x_is_exact() {
    let asked = |ask: &str, keys: &str| asked(ask, &format!(r#"{keys}, "x_eps": "5""#));
    let refused = "<x_eps> says how large the errors of x may be, and this question takes every x for exact";
    for ask in ["fit", "linearity", "next", "outliers", "range", "status"] {
        assert!(asked(ask, "").is_err_and(|words| words.starts_with(refused)), "{ask}");
    }
    assert!(asked("predict", r#", "at": ["1"]"#).is_err_and(|words| words.starts_with(refused)));
    assert!(asked("window", r#", "window": 3"#).is_err_and(|words| words.starts_with(refused)));
    let fleet = "<x_eps> is about a single set, and a fleet has one for each group";
    assert!(asked("fleet", r#", "by": "V""#).is_err_and(|words| words.starts_with(fleet)));
    assert_eq!(asked("fit-x-errors", ""), Ok(()));
}

#[test]
fn tables_that_are_not_at_hand_are_no_way_out() {
    let grid = asked("predict", r#", "grid": "0..1/1000000000""#).unwrap_err();
    assert_eq!(grid, "<grid> 0..1/1000000000: refused: more than 100000 values (expected fewer)");
    let new = asked("status", r#", "new": "a.csv""#).unwrap_err();
    assert!(new.ends_with("<at> and <from> take values themselves, and <new> takes a table alone"), "{new}");
}

#[test]
fn keys_that_a_form_has_no_place_for_are_refused() {
    let refused = |json: &str, form: Form, style: Style| {
        let request = Request::parse(json).unwrap();
        request.refuse_vain(form, &style).map_err(|refusal| refusal.words(&Keys))
    };
    let usual = Style::default();
    for (json, forms, words) in [
        (r#"{"ask": "fit", "sweep": "1..2"}"#, [Form::Csv, Form::Wkt], "<sweep> needs the format text, "),
        (r#"{"ask": "fit", "confidence": "0.9"}"#, [Form::Wkt, Form::M], "<confidence> needs the format "),
        (r#"{"ask": "fit", "brief": true}"#, [Form::Json, Form::Csv], "<brief>, <full> and <inverse> need "),
        (r#"{"ask": "fit", "brief": true, "full": true}"#, [Form::Text, Form::Latex], "<brief> reports ten "),
        (r#"{"ask": "status", "repair": true}"#, [Form::Csv; 2], "<repair> needs another format than csv"),
        (r#"{"ask": "status", "all": true}"#, [Form::Csv, Form::Json], "<all> needs the format text, latex "),
        (
            r#"{"ask": "predict", "proofs": true}"#,
            [Form::Csv, Form::Json],
            "<proofs> needs the format text, ",
        ),
        (r#"{"ask": "outliers", "most": 2}"#, [Form::Csv; 2], "<most> is no part of csv: "),
    ] {
        for form in forms {
            let problem = refused(json, form, usual).unwrap_err();
            assert!(problem.starts_with(words), "{json} as {}: {problem}", form.name());
        }
        let has_place = json.contains("full") || refused(json, Form::Text, usual).is_ok();
        assert!(has_place, "{json}");
    }
    let styles = [
        ("<digits>", Style { digits: Some(3), ..usual }),
        ("<rounding>", Style { ends: EndRounding::Nearest, ..usual }),
        ("<exact>", Style { exact: true, ..usual }),
    ];
    for (key, style) in styles {
        let problem = refused(r#"{"ask": "fit"}"#, Form::Csv, style).unwrap_err();
        assert!(problem.starts_with(&format!("{key} is about decimals in text, ")), "{problem}");
        for form in [Form::Text, Form::Json, Form::Proof] {
            assert_eq!(refused(r#"{"ask": "fit"}"#, form, style), Ok(()));
        }
        // Lines of many sets are decimals in every form.
        assert_eq!(refused(r#"{"ask": "window", "window": 3}"#, Form::Csv, style), Ok(()));
        // The table of the vertices has decimals beside fractions.
        let polygon = |form| refused(r#"{"ask": "polygon"}"#, form, style);
        assert_eq!(
            (polygon(Form::Csv).is_ok(), polygon(Form::M).is_ok()),
            (key == "<digits>", false),
            "{key}"
        );
    }
}

#[test]
fn a_request_says_which_question_and_which_readings() {
    let json = r#"{"x": "V", "step": 2, "y": null, "ask": "window", "window": 5, "digits": 3}"#;
    let (request, Common { readings, answer }) = Request::with_readings(json).unwrap();
    assert_eq!(request.name(), "window");
    assert_eq!(readings, Readings { x: Some(Regressors::One("V".to_owned())), ..Readings::default() });
    assert_eq!(answer, AnswerWords { digits: Some(Digits(3)), ..AnswerWords::default() });
    for (json, words) in [
        (r#"{"ask": "rnge"}"#, "<ask> rnge: expected one of \"check\", \"fit\""),
        (r#"{"x": "V"}"#, "<ask>: it names the question"),
        (r#"{"ask": "range", "most": 1}"#, "request: unknown field `most`"),
        (
            r#"{"ask": "outliers", "max_sets": 2, "most": "1"}"#,
            "<most>: \"1\": expected an integer that is at least 0",
        ),
        (r#"{"ask": "predict", "at": "5", "proofs": true}"#, "<at>: \"5\": expected an array"),
        (
            r#"{"ask": "window", "step": -1, "window": 3}"#,
            "<step>: -1: expected an integer that is at least 0",
        ),
        (r#"{"ask": "fleet", "x": "V"}"#, "<by>: it is missing: 'fleet' needs it"),
        (r#"{"ask": "range", "by": ["x"]}"#, "<by>: an array: expected a text"),
        (r#"{"ask": "next", "within": ["1"]}"#, "<within>: an array of 1: expected an array of two"),
        (r#"{"ask": "next", "within": ["1", "2", "3"]}"#, "<within>: an array of 3: expected fewer elements"),
        (r#"{"ask": "window", "window_x": true}"#, "<window_x>: expected a number as text"),
        (r#"{"ask": "range", "x": 5}"#, "<x>: expected the name or number of a column"),
        (r#"{"ask": "range", "digits": 1e9}"#, "<digits>: 1000000000.0: expected an integer from 1 to 1000"),
        (r#"{"ask": "range", "digits": 3.5}"#, "<digits>: 3.5: expected an integer from 1 to 1000"),
        (r#"{"ask": "range", "digits": "3"}"#, "<digits>: \"3\": expected an integer from 1 to 1000"),
        (r#"{"ask": "range", "digits": -1}"#, "<digits>: -1: expected an integer from 1 to 1000"),
        (r#"{"ask": "range", "digits": 0}"#, "<digits>: 0: expected an integer from 1 to 1000"),
        (r#"{"ask": "range", "digits": 1001}"#, "<digits>: 1001: expected an integer from 1 to 1000"),
        ("[]", "request: invalid type"),
    ] {
        let refused = Request::with_readings(json).unwrap_err().words(&Keys);
        assert!(refused.starts_with(words), "{json}: {refused}");
    }
}
