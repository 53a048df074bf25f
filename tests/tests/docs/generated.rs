//! What is made from the types of answers and from the options of the command line is as it would be made now.

#[test]
fn no_generated_file_is_stale() {
    assert_eq!(xtask::generate::stale(), "");
}
