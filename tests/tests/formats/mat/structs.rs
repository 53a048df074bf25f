//! Members of structs as columns.

use std::fs;

use boundfit_formats::TableOptions;
use boundfit_tests::program::root;

use super::files::{deflated, doubles, header, matrix, number, structure};
use super::{both, exact, message};

#[test]
fn a_member_of_a_struct_is_a_column() {
    let bytes = fs::read(root().join("fixtures/mat/transducer-v7.mat")).unwrap();
    assert_eq!(both(&bytes, &["s.a"], &TableOptions::default()).unwrap(), exact(&[1.0]));
    assert_eq!(both(&bytes, &["5"], &TableOptions::default()).unwrap(), exact(&[1.0]));
    let expected = "(expected one of \"Vz\", \"z\", \"M(:,1) to M(:,2)\", \"s.a\")";
    assert_eq!(
        message(&bytes, &["s.b"]),
        format!("there is no column \"s.b\"; did you mean \"s.a\"? {expected}")
    );
}

#[test]
fn fields_of_structs_are_columns() {
    let options = TableOptions::default();
    for is_big in [false, true] {
        let field = |rows, columns, numbers: &[f64]| matrix(&doubles("", rows, columns, numbers), is_big);
        let inner = structure("", &[("deep", field(1, 2, &[7.0, 8.0]))], is_big);
        let measured = structure(
            "meas",
            &[
                ("speed", field(2, 1, &[1.5, -2.0])),
                ("none", Vec::new()),
                ("inner", inner),
                ("M", field(2, 2, &[1.0, 2.0, 3.0, 4.0])),
                ("dist", field(2, 1, &[0.1, 0.2])),
            ],
            is_big,
        );
        let other = matrix(&doubles("x", 2, 1, &[5.0, 6.0]), is_big);
        for packed in [false, true] {
            let pack = |bytes: &[u8]| {
                let content = deflated(bytes);
                [number(15, is_big), number(content.len() as u32, is_big), content].concat()
            };
            let parts = [&measured, &other].map(|bytes| if packed { pack(bytes) } else { bytes.clone() });
            let bytes = [header(is_big), parts.concat()].concat();
            for (name, numbers) in [
                ("meas.speed", [1.5, -2.0]),
                ("meas.dist", [0.1, 0.2]),
                ("meas.inner.deep", [7.0, 8.0]),
                ("meas.M(:,2)", [3.0, 4.0]),
                ("x", [5.0, 6.0]),
            ] {
                assert_eq!(both(&bytes, &[name], &options), Ok(exact(&numbers)), "{name}");
            }
            let all =
                "\"meas.speed\", \"meas.inner.deep\", \"meas.M(:,1) to meas.M(:,2)\", \"meas.dist\", \"x\"";
            assert_eq!(
                message(&bytes, &["speed"]),
                format!("there is no column \"speed\" (expected one of {all})")
            );
            let fields = "the variable \"meas\" is a struct with the fields speed, none, inner, M, dist";
            assert!(message(&bytes, &["meas"]).starts_with(fields), "{}", message(&bytes, &["meas"]));
            for cut in [200, 300, bytes.len() - 1] {
                let cut = message(&bytes[..cut.min(bytes.len() - 1)], &["meas.dist"]);
                assert!(cut.starts_with("cannot read a MATLAB file: "), "{cut}");
            }
        }
    }
    // Nothing but what has no columns is named as what it is.
    let only = [header(false), structure("s", &[("none", Vec::new())], false)].concat();
    assert!(message(&only, &["speed"]).starts_with("the variable \"s\" is a struct with the field none"));
    let mut deep = matrix(&doubles("", 1, 1, &[1.0]), false);
    for _ in 0..100 {
        deep = structure("", &[("a", deep)], false);
    }
    let deep = [header(false), structure("s", &[("a", deep)], false)].concat();
    assert!(
        message(&deep, &["x"]).contains("is a struct in a struct in a struct"),
        "{}",
        message(&deep, &["x"])
    );
}
