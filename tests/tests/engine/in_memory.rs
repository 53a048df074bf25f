//! Columns in memory: fits, reductions and fleets of them are those of the same numbers as text.

use boundfit_estimation::{
    Columns, EpsilonColumn, Fit, Fleet, Keep, LineForm, Measurements, Problem, Question,
};
use boundfit_exact::{Limits, Rational, Reading};
use boundfit_formats::{
    ColumnSelector, MemoryNumbers, MemoryTable, RowRange, ScanOptions, Source, TableOptions, read_table,
};
use boundfit_tests::generate::{seeded, share};
use boundfit_tests::reducing::{essence, options, reduced, reduced_source, try_reduced};
use boundfit_tests::streams::Case;
use rand::RngExt;

/// Names and cells of a table.
fn cells(text: &str) -> (Vec<&str>, Vec<Vec<&str>>) {
    let mut lines = text.lines();
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    let mut columns = vec![Vec::new(); names.len()];
    for line in lines {
        columns.iter_mut().zip(line.split(',')).for_each(|(column, cell)| column.push(cell));
    }
    (names, columns)
}

fn text_of(text: &str) -> Source {
    Source::new("text", std::io::Cursor::new(text.as_bytes().to_vec()))
}

/// Returns the ways in which a table of text may stand in memory. It may be texts, exact numbers if none is missing
/// and the reading is decimal, or doubles if the reading is binary64.
fn ways(text: &str, reading: Reading, is_written_asked: bool) -> Vec<MemoryTable> {
    let (names, columns) = cells(text);
    let exact = |cell: &str| reading.read(cell, &Limits::default()).ok();
    let table = |numbers: &dyn Fn(&[&str]) -> Option<MemoryNumbers>| {
        let mut table = MemoryTable::default();
        for (name, column) in names.iter().zip(&columns) {
            table.push(*name, numbers(column)?);
        }
        Some(table)
    };
    let texts =
        |column: &[&str]| Some(MemoryNumbers::Texts(column.iter().map(ToString::to_string).collect()));
    let fractions = |column: &[&str]| {
        let numbers: Option<Vec<Rational>> = column.iter().map(|cell| exact(cell)).collect();
        numbers.map(MemoryNumbers::Exact)
    };
    let doubles = |column: &[&str]| {
        let double = |cell: &&str| exact(cell).map_or(f64::NAN, |number| number.to_f64());
        Some(MemoryNumbers::Doubles(column.iter().map(double).collect()))
    };
    let mut ways = vec![table(&texts)];
    match reading {
        _ if is_written_asked => {}
        Reading::Decimal => ways.push(table(&fractions)),
        Reading::Binary64 => ways.push(table(&doubles)),
    }
    ways.into_iter().flatten().collect()
}

#[test]
fn columns_in_memory_are_fitted_and_reduced_like_their_text() {
    let mut rng = seeded(1717);
    for count in 0..share(2000) {
        let mut case = Case::random(&mut rng, 1..=30);
        case.reading = if count % 2 == 0 { Reading::Decimal } else { Reading::Binary64 };
        let scanned = |source: Source, most_rows: usize| -> (Problem, Fit) {
            let keep = Keep { most_rows, ..Keep::default() };
            let options = options(case.reading, 1);
            let conditions = case.all_conditions();
            let measurements = Measurements::scan(source, &case.columns, &conditions, &options, keep);
            case.fitted(measurements.unwrap_or_else(|error| panic!("{error}\n{}", case.text)))
        };
        let whole = essence(&scanned(text_of(&case.text), usize::MAX), &|row| row);
        let of_text = reduced(&case.text, &case.columns, &options(case.reading, 1));
        let of_text = essence(&scanned(text_of(&of_text), usize::MAX), &|row| row);
        for table in ways(&case.text, case.reading, case.needs_written()) {
            let source = || Source::of_table("memory", table.clone());
            for most_rows in [0, usize::MAX] {
                let found = essence(&scanned(source(), most_rows), &|row| row);
                assert_eq!(found, whole, "{most_rows} {:?}\n{}", case.columns, case.text);
            }
            let own = reduced_source(source(), &case.columns, &options(case.reading, 1));
            let own = own.unwrap_or_else(|error| panic!("{error}\n{}", case.text));
            let found = essence(&scanned(text_of(&own), usize::MAX), &|row| row);
            assert_eq!(found, of_text, "{:?}\n{}\n{own}", case.columns, case.text);
        }
    }
}

#[test]
fn fleets_in_memory_are_those_of_their_text() {
    let mut rng = seeded(1718);
    for _ in 0..300 {
        let case = Case::random(&mut rng, 1..=30);
        let (names, columns) = cells(&case.text);
        let keys: Vec<String> =
            (0..columns[0].len()).map(|_| format!("s{}", rng.random_range(0..4))).collect();
        let mut table = MemoryTable::default();
        for (name, column) in names.iter().zip(&columns) {
            table.push(*name, MemoryNumbers::Texts(column.iter().map(ToString::to_string).collect()));
        }
        table.push("sensor", MemoryNumbers::Texts(keys.iter().map(|key| format!(" {key}\t")).collect()));
        let mut lines = case.text.lines();
        let mut text = format!("{},sensor\n", lines.next().unwrap());
        lines.zip(&keys).for_each(|(line, key)| text.push_str(&format!("{line},{key}\n")));
        let by = ColumnSelector::name("sensor");
        let fleet = |source| {
            let fleet = Fleet::read(source, &case.columns, &by, options(case.reading, 1));
            let fleet = fleet.unwrap_or_else(|error| panic!("{error}\n{text}"));
            let group = |group| {
                let key = fleet.key(group).raw().to_owned();
                (key, fleet.measurements(group), fleet.group_fit(group))
            };
            (0..fleet.len()).map(group).collect::<Vec<_>>()
        };
        assert_eq!(fleet(Source::of_table("memory", table)), fleet(text_of(&text)), "{text}");
    }
}

#[test]
fn groups_of_which_every_row_lacks_a_number_are_known_by_name() {
    let text = "x,y,key\n1,2,a\n,3,b\n2,,c\n3,4,a\nNaN,1,b\n5,NaN,d\n6,7,d\n1,,e\n";
    let lines: Vec<Vec<&str>> = text.lines().skip(1).map(|line| line.split(',').collect()).collect();
    let column = |index: usize| lines.iter().map(|line| line[index].to_owned()).collect();
    let mut texts = MemoryTable::default();
    let mut numbers = MemoryTable::default();
    for (index, name) in ["x", "y"].into_iter().enumerate() {
        texts.push(name, MemoryNumbers::Texts(column(index)));
        let number = |text: String| text.parse().unwrap_or(f64::NAN);
        numbers.push(name, MemoryNumbers::Doubles(column(index).into_iter().map(number).collect()));
    }
    texts.push("key", MemoryNumbers::Texts(column(2)));
    numbers.push("key", MemoryNumbers::Texts(column(2)));
    let columns = Question::line(ColumnSelector::name("x"), Some(ColumnSelector::name("y"))).columns;
    let with = |conditions: &[&str], source: Source| {
        let condition = |text: &&str| {
            boundfit_formats::RowCondition::parse(text, Reading::Decimal, &Limits::default()).unwrap()
        };
        let table = TableOptions {
            missing: boundfit_formats::Missing::Skip,
            conditions: conditions.iter().map(condition).collect(),
            ..TableOptions::default()
        };
        let options = ScanOptions { table, ..ScanOptions::default() };
        let fleet = Fleet::read(source, &columns, &ColumnSelector::name("key"), options).unwrap();
        fleet.without_readings().map(|name| name.raw().to_owned()).collect::<Vec<_>>()
    };
    for (conditions, empty) in
        [(&[][..], &["b", "c", "e"][..]), (&["x != 1"], &["b", "c"]), (&["x >= 5"], &["b"])]
    {
        let sources = [
            text_of(text),
            Source::of_table("texts", texts.clone()),
            Source::of_table("numbers", numbers.clone()),
        ];
        for source in sources {
            assert_eq!(with(conditions, source), empty, "{conditions:?}");
        }
    }
}

fn doubles(columns: &[(&str, &[f64])]) -> MemoryTable {
    let mut table = MemoryTable::default();
    columns.iter().for_each(|(name, column)| table.push(*name, MemoryNumbers::Doubles(column.to_vec())));
    table
}

#[test]
fn a_float_is_its_shortest_text_or_itself() {
    let mut table = doubles(&[("double", &[0.1])]);
    table.push("float", MemoryNumbers::Floats(vec![0.1]));
    table.push("integer", MemoryNumbers::Integers(vec![(1 << 53) + 1]));
    let columns = ["double", "float", "integer"].map(ColumnSelector::name);
    let read = |reading| {
        let options = TableOptions { reading, ..TableOptions::default() };
        let table = read_table(Source::of_table("memory", table.clone()), &columns, &options).unwrap();
        table.rows[0].numbers.iter().map(Rational::to_string).collect::<Vec<_>>().join(" ")
    };
    assert_eq!(read(Reading::Decimal), "1/10 1/10 9007199254740993");
    assert_eq!(
        read(Reading::Binary64),
        "3602879701896397/36028797018963968 13421773/134217728 9007199254740992"
    );
}

#[test]
fn chosen_rows_keep_their_numbers() {
    let table = doubles(&[("x", &[1.0, f64::NAN, 3.0, 4.0, 5.0])]);
    let table_options = TableOptions {
        rows: RowRange::new(2, 5).into(),
        missing: boundfit_formats::Missing::Skip,
        conditions: vec![
            boundfit_formats::RowCondition::parse("x != 4", Reading::Decimal, &Limits::default()).unwrap(),
        ],
        keep_others: true,
        ..TableOptions::default()
    };
    let read = read_table(Source::of_table("memory", table), &[ColumnSelector::name("x")], &table_options);
    let read = read.unwrap();
    assert_eq!(read.rows.iter().map(|row| row.row).collect::<Vec<_>>(), [3, 5]);
    assert_eq!(read.others.iter().map(|row| row.row).collect::<Vec<_>>(), [1, 4]);
    let read = read.scanned;
    assert_eq!((read.rows_total, read.rows_missing, read.ranges), (5, 1, vec![[3, 3], [5, 5]]));
}

#[test]
fn what_is_wrong_is_told_with_row_and_column() {
    let refusal = |table: MemoryTable, selectors: &[ColumnSelector]| {
        let options = TableOptions::default();
        read_table(Source::of_table("memory", table), selectors, &options).unwrap_err().to_string()
    };
    let x = ColumnSelector::name("x");
    let texts = |texts: &[&str]| {
        let mut table = MemoryTable::default();
        table.push("x", MemoryNumbers::Texts(texts.iter().map(ToString::to_string).collect()));
        table
    };
    for (table, selector, message) in [
        (
            doubles(&[("x", &[1.0, f64::NAN])]),
            x.clone(),
            "memory: row 2, column 1 (x): \"NaN\": the value is missing, in this row only (expected a number in every row)",
        ),
        (
            doubles(&[("x", &[f64::INFINITY])]),
            x.clone(),
            "memory: row 1, column 1 (x): \"inf\": not a number: not a finite number at character 1 (expected a decimal such as \
             1.30e-2 or a fraction such as 7/19)",
        ),
        (
            doubles(&[("x", &[1.0, 2.0, -0.5])]),
            x.clone().non_negative(),
            "memory: row 3, column 1 (x): \"-0.5\": the error bound is negative (expected a number that is at least 0)",
        ),
        (
            doubles(&[("x", &[1.0]), ("y", &[1.0, 2.0])]),
            x.clone(),
            "memory: the column \"x\" has 1 number, but \"y\" has 2 (expected columns of one length)",
        ),
        (doubles(&[("x", &[])]), x.clone(), "memory: the file has a header but no data rows"),
        (doubles(&[("z", &[1.0])]), x.clone(), "memory: there is no column \"x\""),
        (texts(&["1", "1o"]), x.clone(), "memory: row 2, column 1 (x): \"1o\": not a number"),
        (
            doubles(&[("x", &[1.0])]),
            x.clone().half_unit(),
            "memory: row 1, column 1 (x): \"1.0\": 'written' is half a unit of the last digit written, and a column that is not \
             of texts stores numbers without their digits",
        ),
    ] {
        let found = refusal(table, &[selector]);
        assert!(found.starts_with(message), "{found}\n{message}");
    }
    let scan = ScanOptions::default();
    let none = Fleet::read(
        Source::of_table("memory", doubles(&[("x", &[1.0]), ("y", &[2.0])])),
        &boundfit_estimation::Columns {
            first: x,
            second: None,
            response: Some(ColumnSelector::name("y")),
            epsilon: boundfit_estimation::EpsilonColumn::Uniform(Rational::one()),
            form: boundfit_estimation::LineForm::default(),
        },
        &ColumnSelector::name("sensor"),
        scan,
    );
    assert!(none.unwrap_err().to_string().starts_with("memory: there is no column \"sensor\""));
}

#[test]
fn rows_that_are_kept_have_their_identities_and_none_are_a_reduction_too() {
    let mut table = doubles(&[("x", &[0.0, 1.0, 2.0, 3.0]), ("y", &[0.0, 1.5, 1.5, 3.0])]);
    let names = ["a", "two\nlines", "c,\"d\"", ""];
    table.push("id", MemoryNumbers::Texts(names.map(str::to_owned).to_vec()));
    let columns = Columns {
        first: ColumnSelector::name("x"),
        second: None,
        response: Some(ColumnSelector::name("y")),
        epsilon: EpsilonColumn::Uniform(Rational::zero()),
        form: LineForm::default(),
    };
    let named = ScanOptions {
        identity: Some(ColumnSelector::name("id")),
        allow_nothing: true,
        ..ScanOptions::default()
    };
    let reduced = |table: &MemoryTable, options: &ScanOptions| {
        reduced_source(Source::of_table("memory", table.clone()), &columns, options)
    };
    let sums = "\"reading\":\"decimal\",\"x\":\"x\",\"y\":\"y\",\"epsilon\":null,\"sums\"";
    assert_eq!(
        reduced(&table, &named).unwrap(),
        // A row of two lines needs a count beside rows with counts of other parts.
        format!(
            "# boundfit/reduced/3 {{\"rows\":4,\"kept\":5,\"header\":true,{sums}:[\"6\",\"6\",\"14\",\"27/2\"]}}\nx,y,id\n1 0.0,0.0,a\n\
             1 1.0,1.5,\"two\n0 lines\"\n1 2.0,1.5,\"c,\"\"d\"\"\"\n1 3.0,3.0,\n"
        )
    );
    let nothing = doubles(&[("x", &[]), ("y", &[]), ("id", &[])]);
    let none = format!(
        "# boundfit/reduced/1 {{\"rows\":0,\"kept\":0,\"header\":true,{sums}:[\"0\",\"0\",\"0\",\"0\"]}}\nx,y,id\n"
    );
    assert_eq!(reduced(&nothing, &named).unwrap(), none);
    let skip = TableOptions { missing: boundfit_formats::Missing::Skip, ..TableOptions::default() };
    let missing = doubles(&[("x", &[f64::NAN]), ("y", &[1.0]), ("id", &[7.0])]);
    assert_eq!(reduced(&missing, &ScanOptions { table: skip, ..named.clone() }).unwrap(), none);
    let refusal =
        |table: &MemoryTable, options: &ScanOptions| reduced(table, options).unwrap_err().to_string();
    assert_eq!(
        refusal(&nothing, &ScanOptions::default()),
        "memory: the file has a header but no data rows (expected at least one row of numbers)"
    );
    let elsewhere = ScanOptions { identity: Some(ColumnSelector::name("key")), ..named };
    assert_eq!(
        refusal(&table, &elsewhere),
        "memory: there is no column \"key\" (expected one of \"x\", \"y\", \"id\" or a number from 1 to 3)"
    );
    // Reductions of nothing go together with other reductions, and with each other.
    let text = |text: String| try_reduced(&text, &columns, &ScanOptions::default());
    let whole = reduced(&table, &ScanOptions { identity: None, ..elsewhere }).unwrap();
    let nothing = none.replace(",id", "");
    assert_eq!(text(format!("{nothing}{whole}{nothing}")).unwrap(), whole);
    assert_eq!(text(format!("{nothing}{nothing}")).unwrap(), nothing);
}
