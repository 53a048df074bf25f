//! Numbers as the engine writes them; `tests/browser/decimals.test.js` reads the same file for the page's script.

use boundfit_exact::Rounding;
use boundfit_tests::cli::numbers::rational;
use boundfit_tests::program::root;
use serde_json::Value;

use crate::document::items;

#[test]
fn the_engine_writes_the_decimals_that_the_page_writes() {
    let text = std::fs::read_to_string(root().join("fixtures/decimals/decimals.json")).unwrap();
    let cases: Value = serde_json::from_str(&text).unwrap();
    for case in items(&cases) {
        let value = rational(case["exact"].as_str().unwrap());
        let digits = usize::try_from(case["digits"].as_u64().unwrap()).unwrap();
        for (name, rounding) in
            [("nearest", Rounding::Nearest), ("down", Rounding::Down), ("up", Rounding::Up)]
        {
            assert_eq!(value.to_decimal(digits, rounding), case[name].as_str().unwrap(), "{case} {name}");
        }
    }
}
