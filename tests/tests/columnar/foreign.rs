//! Tables as other programs write them, columnar ones among them.

use boundfit_tests::foreign;

#[test]
fn foreign_tables_are_read_right_or_refused_with_a_way_out() {
    foreign::check(true);
}
