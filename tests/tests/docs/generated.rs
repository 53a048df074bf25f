//! The files made from the types of answers and from the options of the command line are up to date.

#[test]
fn no_generated_file_is_stale() {
    assert_eq!(xtask::generate::stale(), "");
}
