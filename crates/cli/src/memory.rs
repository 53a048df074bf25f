//! How freed memory is kept.

/// Has the allocator keep what is freed, as far as it learns from what it sees: the C library of GNU gives freed memory
/// back to the system from 128 KiB on, and gets it anew for the next batch of a table, until a larger piece is freed.
/// That took a fifth of the processor time of a scan. It is for the program to decide, not for a library: the piece is
/// never touched, but the process stays as large as it once was.
pub(crate) fn keep_freed() {
    const LARGER_THAN_THE_COLUMNS_OF_A_GROUP_OF_CHUNKS: usize = 1 << 24;
    drop(std::hint::black_box(Vec::<u8>::with_capacity(LARGER_THAN_THE_COLUMNS_OF_A_GROUP_OF_CHUNKS)));
}

/// Bytes that the budget counts for each reading where a command wants every one, with all that the command makes of it. An estimate,
/// as are those below: the maximum resident set of the program of the tests with 10⁵ different readings of x and y, less that with one,
/// divided by their number and rounded up. Measured were `convert` and `fit --window` (390).
pub(crate) const OF_A_READING: usize = 400;
/// As [`OF_A_READING`], of readings in a figure (380 of its data, more of other figures).
pub(crate) const OF_A_FIGURE: usize = 700;
/// As [`OF_A_READING`], of a half-plane of which the polygon is asked: 10⁶ of them took 2.1 GB.
pub(crate) const OF_A_HALF_PLANE: usize = 2_300;
