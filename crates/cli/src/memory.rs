//! Keeps freed memory.

/// Lets the allocator keep freed memory, as far as it learns from its use. The C library of GNU gives freed memory
/// back to the system from 128 KiB on. Until a larger piece is freed, it gets the memory anew for each batch of a
/// table. That took a fifth of the processor time of a scan. It is for the program to decide, not for a library: the
/// piece is never touched, but the process stays as large as it once was.
pub(crate) fn keep_freed() {
    const LARGER_THAN_THE_COLUMNS_OF_A_GROUP_OF_CHUNKS: usize = 1 << 24;
    drop(std::hint::black_box(Vec::<u8>::with_capacity(LARGER_THAN_THE_COLUMNS_OF_A_GROUP_OF_CHUNKS)));
}

/// Bytes that the budget counts for each reading where a command wants every one, with all that the command makes of
/// it. This number is an estimate, as are those below: the maximum resident set of the program of the tests with 10⁵
/// different readings, less that with one reading. The difference is divided by the number of readings and rounded
/// up. Measured were `convert`, before it left readings in their columns, and `fit --window` (390).
pub(crate) const OF_A_READING: usize = 400;
/// Bytes for each reading in a figure, estimated as [`OF_A_READING`] (380 for its data, more for other figures).
pub(crate) const OF_A_FIGURE: usize = 700;
