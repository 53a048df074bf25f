//! Octave runs our scripts, and writes the MATLAB files that we read. Needs `octave-cli`.

use std::fs;
use std::path::Path;
use std::process::Command;

use boundfit_exact::Rational;
use boundfit_formats::{ColumnSelector, Source, TableOptions, read_table};
use boundfit_tests::generate::{seeded, system, tangents};
use boundfit_tests::program::{root, run, run_with_input};
use rand::RngExt;

/// Returns the output of Octave for a program, run in a folder.
fn octave(folder: &Path, program: &str) -> String {
    fs::write(folder.join("program.m"), program).unwrap();
    let output = Command::new("octave-cli")
        .args(["--no-init-file", "--no-history", "--eval", "source('program.m')"])
        .current_dir(folder)
        .output()
        .expect("octave-cli starts: it is in Debian's package octave");
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.ends_with("done\n"), "{text}\n{}", String::from_utf8_lossy(&output.stderr));
    text
}

/// A script and the exact area of its polygon.
fn script(arguments: &[&str], input: &[u8]) -> (String, f64) {
    let of = |format: &str| {
        let run = run_with_input(&[arguments, &["--format", format]].concat(), input);
        assert_eq!((run.status, run.stderr.as_str()), (0, ""), "{arguments:?}");
        run.stdout
    };
    let json: serde_json::Value = serde_json::from_str(&of("json")).unwrap();
    let region = json.get("fps").unwrap_or(&json["region"]);
    assert_eq!(region["kind"], "polygon");
    let area = region["area"]["exact"].as_str().unwrap();
    let (p, q) = area.split_once('/').unwrap_or((area, "1"));
    let number = |digits: &str| digits.parse::<f64>().unwrap();
    (of("m"), number(p) / number(q))
}

#[test]
fn scripts_define_the_polygon() {
    let mut scripts = Vec::new();
    let transducer = ["--x", "Vz", "--y", "z", "--rows", "14..36", "--eps", "0.5e-3"];
    let csv = "fixtures/transducer/transducer.csv";
    scripts.push(script(&[&["fit", csv][..], &transducer, &["--no-lp"]].concat(), b""));
    scripts.push(script(&[&["fit", "fixtures/mat/transducer-v7.mat"][..], &transducer].concat(), b""));
    scripts.push(script(&["polygon", "fixtures/polygon/house.ine"], b""));
    let mut rng = seeded(20_261);
    for _ in 0..25 {
        let count = rng.random_range(8..60);
        // A box around them, so that every one is bounded.
        let mut rows = vec![[1, 0, 9], [-1, 0, 8], [0, 1, 7], [0, -1, 6]];
        rows.extend(tangents(&mut rng, count));
        let rows: Vec<String> = system(&rows)
            .inequalities()
            .iter()
            .map(|row| format!("{},{},{}\n", row.a[0], row.a[1], row.b))
            .collect();
        scripts.push(script(&["polygon", "-"], format!("a1,a2,b\n{}", rows.concat()).as_bytes()));
    }
    let folder = tempfile::tempdir().unwrap();
    let mut program = String::new();
    for (number, (script, area)) in scripts.iter().enumerate() {
        fs::write(folder.path().join(format!("set{number}.m")), script).unwrap();
        // A quotient of doubles is the nearest to that of the numbers where both of them are doubles.
        program.push_str(&format!(
            "set{number};\n\
             hull = convhull(theta(:,1), theta(:,2));\n\
             area = polyarea(theta(hull,1), theta(hull,2));\n\
             assert(abs(area - {area:e}) <= 1e-9 * {area:e});\n\
             assert(numel(hull), rows(theta) + 1);\n\
             assert(size(theta_exact), size(theta)); assert(rows(active), rows(theta));\n\
             assert(isempty(rays) && isempty(lines) && isempty(points) && strcmp(kind, 'polygon'));\n\
             for k = 1:numel(theta)\n\
               parts = cellfun(@str2num, strsplit(theta_exact{{k}}, '/'));\n\
               value = str2num(theta_exact{{k}});\n\
               if all(abs(parts) <= 2^53), assert(value == theta(k));\n\
               else assert(abs(value - theta(k)) <= 4 * eps(theta(k))); end\n\
             end\n"
        ));
    }
    octave(folder.path(), &(program + "disp('done')\n"));
}

#[test]
fn scripts_of_fits_have_the_whole_answer() {
    let csv = "fixtures/transducer/transducer.csv";
    let options = ["--x", "Vz", "--y", "z", "--rows", "14..36", "--eps", "0.5e-3", "--format"];
    let of = |format: &str| run(&[&["fit", csv][..], &options, &[format]].concat()).stdout;
    let json: serde_json::Value = serde_json::from_str(&of("json")).unwrap();
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("whole.m"), of("m")).unwrap();
    let mut program = String::from("whole;\nassert(strcmp(kind, 'polygon'));\n");
    let mut check = |name: String, number: &serde_json::Value, form: &str| {
        let double = number[form].as_f64().unwrap();
        program.push_str(&format!("assert({name} == {double:e});\n"));
    };
    for axis in [0, 1] {
        let at = axis + 1;
        for (name, part) in [("pui", &json["pui"]), ("eui", &json["eui"])] {
            check(format!("{name}({at}, 1)"), &part[axis]["lower"], "outward");
            check(format!("{name}({at}, 2)"), &part[axis]["upper"], "outward");
        }
        for name in ["central", "least_squares"] {
            check(format!("{name}({at})"), &json[name]["theta"][axis], "value");
            check(format!("{name}_error({at})"), &json[name]["guaranteed_error"][axis], "outward");
        }
        check(format!("minimax({at})"), &json["minimax"]["theta"][axis], "value");
    }
    check("eps_min".to_owned(), &json["epsilon_min"], "outward");
    check("area".to_owned(), &json["fps"]["area"], "value");
    for name in ["gain", "offset"] {
        let own = &json["inverse"][name];
        for (part, range) in [("pui", "box_range"), ("fps", "exact_range"), ("eui", "eui_range")] {
            check(format!("{name}_{part}(1)"), &own[range][0]["lower"], "outward");
            check(format!("{name}_{part}(2)"), &own[range][0]["upper"], "outward");
        }
        check(format!("{name}_central"), &own["central"], "value");
        check(format!("{name}_least_squares"), &own["least_squares"], "value");
    }
    program.push_str("assert(isempty(eps_factor) && strcmp(eps_min_exact{1}, '791/2005400'));\n");
    let empty = ["fit", "fixtures/norris/norris.csv", "--x", "x", "--y", "y", "--eps", "1", "--format", "m"];
    fs::write(folder.path().join("nothing.m"), run(&empty).stdout).unwrap();
    program.push_str(
        "nothing;\nassert(strcmp(kind, 'empty') && isempty(pui) && isempty(central) && area == 0);\n\
         assert(rows(minimax), 1); assert(columns(pui), 2);\n",
    );
    octave(folder.path(), &(program + "disp('done')\n"));
}

#[test]
fn unbounded_and_empty_sets_run_too() {
    let folder = tempfile::tempdir().unwrap();
    let mut program = String::new();
    for (number, (kind, rows, sizes)) in [
        ("empty", "1,0,0\n-1,0,-1\n", [0, 0, 0, 0]),
        ("ray", "1,0,1\n-1,0,-1\n0,-1,0\n", [1, 0, 1, 0]),
        ("strip", "1,2,3\n-1,-2,4\n", [0, 2, 0, 1]),
        ("plane", "0,0,3\n", [0, 1, 0, 2]),
    ]
    .into_iter()
    .enumerate()
    {
        let run = run_with_input(&["polygon", "-", "--format", "m"], format!("a1,a2,b\n{rows}").as_bytes());
        fs::write(folder.path().join(format!("set{number}.m")), run.stdout).unwrap();
        program.push_str(&format!(
            "set{number};\nassert(strcmp(kind, '{kind}'));\n\
             assert([rows(theta) rows(points) rows(rays) rows(lines)], {sizes:?});\n\
             assert([columns(theta) columns(points_exact) columns(rays) columns(lines_exact)], [2 2 2 2]);\n"
        ));
    }
    octave(folder.path(), &(program + "disp('done')\n"));
}

#[test]
fn files_of_octave_are_read_exactly() {
    let folder = tempfile::tempdir().unwrap();
    let classes =
        ["double", "single", "int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64"];
    let mut program = String::from(
        "rand('state', 7); r = (rand(40, 1) - 0.25) .* 10 .^ (6 * rand(40, 1) - 2);\nnames = {};\n",
    );
    for class in classes {
        program.push_str(&format!("v_{class} = {class}(r); names{{end+1}} = 'v_{class}';\n"));
    }
    program.push_str(
        "v_big = bitmax('int64') - int64((1:40)'); names{end+1} = 'v_big';\n\
         v_logical = r > 1; names{end+1} = 'v_logical'; v_row = r'; names{end+1} = 'v_row';\n\
         v_integers = round(r); names{end+1} = 'v_integers';\n\
         save('-v6', 'six.mat', names{:}); save('-v7', 'seven.mat', names{:});\n\
         for k = 1:numel(names)\n  x = eval(names{k});\n  for j = 1:numel(x)\n\
         \x20   if isinteger(x), printf('%s %d %s\\n', names{k}, j, num2str(x(j), '%d'));\n\
         \x20   else printf('%s %d %s\\n', names{k}, j, num2str(double(x(j)), '%.17g')); end\n  end\nend\n",
    );
    // In newer versions the largest integer is asked for in another way.
    let program = program.replace("bitmax('int64')", "intmax('int64')");
    let printed = octave(folder.path(), &(program + "disp('done')\n"));
    let mut cells = 0;
    for file in ["six.mat", "seven.mat"] {
        let path = folder.path().join(file);
        let mut expected: Vec<(String, Vec<Rational>)> = Vec::new();
        for line in printed.lines().filter(|line| *line != "done") {
            let [name, _, number] = line.split(' ').collect::<Vec<_>>()[..] else { panic!("{line}") };
            let value = match number.parse::<i64>() {
                Ok(integer) => Rational::from(integer),
                Err(_) => Rational::from_f64(number.parse().unwrap()).unwrap(),
            };
            match expected.last_mut().filter(|(last, _)| last == name) {
                Some((_, values)) => values.push(value),
                None => expected.push((name.to_owned(), vec![value])),
            }
        }
        assert_eq!(expected.len(), classes.len() + 4);
        for (name, values) in expected {
            let source = Source::open(path.to_str().unwrap()).unwrap();
            let columns = [ColumnSelector::name_or_number(&name)];
            let table = read_table(source, &columns, &TableOptions::default()).unwrap();
            let found: Vec<Rational> = table.rows.into_iter().map(|mut row| row.numbers.remove(0)).collect();
            assert_eq!(found, values, "{file} {name}");
            cells += found.len();
        }
    }
    assert_eq!(cells, 2 * 40 * (classes.len() + 4));
    let old = folder.path().join("old.mat");
    octave(folder.path(), "x = [1;2]; save('-v4', 'old.mat', 'x'); disp('done')\n");
    let columns = [ColumnSelector::name_or_number("x")];
    let table =
        read_table(Source::open(old.to_str().unwrap()).unwrap(), &columns, &TableOptions::default()).unwrap();
    assert_eq!(table.rows.iter().map(|row| row.numbers[0].to_string()).collect::<Vec<_>>(), ["1", "2"]);
    assert!(root().join("fixtures/mat/README.md").is_file());
}
