//! Chooses the reader of an input: the only place where formats are told apart.

use std::any::Any;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};

use boundfit_exact::Foreign;

#[cfg(feature = "arrow")]
use crate::arrow::{scan_arrow, scan_batches};
use crate::budget::HeldMemory;
use crate::columns::ColumnSelector;
use crate::dialect::CommentMark;
use crate::error::{InputError, InputErrorKind};
use crate::json::scan_json;
#[cfg(feature = "matlab")]
use crate::mat::scan_mat;
use crate::memory::scan_memory;
use crate::memory_use::MemoryUse;
use crate::scan::{Batch, Consumer, Progress, ScanOptions, Scanned, scan_text};
use crate::source::{Content, Source};
use crate::table::{TableOptions, TableRow};
#[cfg(feature = "spreadsheets")]
use crate::workbook::scan_workbook;

/// Reads the columns asked for and hands their rows out in batches. Text is separated by commas, semicolons
/// or tabs, with or without a header, quotes, a byte order mark, CRLF or blank lines, which are not rows.
/// MATLAB files have stored numbers; with the feature `arrow`, it reads Parquet and Arrow IPC files too. Only
/// cells of wanted rows and columns need be numbers.
///
/// The function calls `work` for each batch of wanted rows, on the threads of the current rayon pool, in any
/// order. It calls `take` with the results of `work`, on the calling thread and in the order of the file. A
/// file of one batch needs no pool.
///
/// ```
/// use boundfit_formats::{ColumnSelector, ScanOptions, Source, scan};
///
/// let table = Source::new("data.csv", "x,y\n1,2.5\n3,4.25\n".as_bytes());
/// let columns = [ColumnSelector::name_or_number("y")];
/// let mut largest = None;
/// let largest_of = |batch: boundfit_formats::Batch| (0..batch.rows.len()).map(|row| batch.columns[0].get(row)).max();
/// let scanned =
///     scan(table, &columns, &ScanOptions::default(), largest_of, |found| largest = found.max(largest.take()))?;
/// assert_eq!((scanned.rows_total, largest.unwrap().to_string()), (2, "17/4".to_owned()));
/// # Ok::<(), boundfit_formats::InputError>(())
/// ```
///
/// The file and [`ScanOptions::chunk_bytes`] alone decide which rows make a batch. Exact. Cost: one pass;
/// memory for a few batches per thread, whatever the size of the file.
///
/// # Errors
/// The first thing wrong, with its place; by then batches before it may have been handed out.
pub fn scan<T: Send + 'static>(
    source: Source,
    columns: &[ColumnSelector],
    options: &ScanOptions,
    work: impl Fn(Batch) -> T + Sync,
    mut take: impl FnMut(T),
) -> Result<Scanned, InputError> {
    let work = |batch: Batch| -> Box<dyn Any + Send> { Box::new(work(batch)) };
    let mut take = |made: Box<dyn Any + Send>| {
        if let Ok(made) = made.downcast() {
            take(*made);
        }
    };
    scan_for(source, columns, options, Consumer::new(&work, &mut take, options.list_rows))
}

/// Reads as [`scan`] does, whatever the results of the work are.
fn scan_for(
    source: Source,
    columns: &[ColumnSelector],
    options: &ScanOptions,
    mut consumer: Consumer,
) -> Result<Scanned, InputError> {
    let (name, content, packed) = source.into_parts();
    if let Some(packed) = &packed {
        packed.set_limits(&options.table.sizes);
    }
    let hash = options.hash && packed.is_none();
    let inner = ScanOptions { hash, ..options.clone() };
    let scanned = scan_content(name.raw(), content, columns, &inner, &mut consumer)?;
    let wanted = consumer.into_wanted();
    if wanted.count == 0 && !options.allow_nothing {
        let conditions =
            options.table.conditions.iter().map(|condition| Foreign::from(condition.text())).collect();
        let problem = InputErrorKind::NoRowWanted { total: scanned.rows_total, conditions };
        return Err(InputError::of_file(&name, problem));
    }
    let ranges = wanted.rows.ranges().collect();
    let scanned = Scanned { ranges, fractions: wanted.fractions, ..scanned };
    Ok(match packed {
        Some(packed) => Scanned { layout: None, sha256: options.hash.then(|| packed.sha256()), ..scanned },
        None => scanned,
    })
}

/// Hands the rows out by the reader of the format.
fn scan_content(
    name: &str,
    content: Content,
    columns: &[ColumnSelector],
    options: &ScanOptions,
    consumer: &mut Consumer,
) -> Result<Scanned, InputError> {
    #[cfg(feature = "spreadsheets")]
    let has_sheets = matches!(content, Content::Archive(_));
    #[cfg(not(feature = "spreadsheets"))]
    let has_sheets = false;
    if options.table.sheet.is_some() && !has_sheets && !options.table.is_beside {
        return Err(InputError::of_file(name, InputErrorKind::NoSheets));
    }
    refuse_vain(&content, has_sheets, &options.table)
        .map_err(|problem| InputError::of_file(name, problem))?;
    match content {
        #[cfg(feature = "matlab")]
        Content::Matlab(file) | Content::Octave(file) => scan_mat(name, file, columns, options, consumer),
        // It refuses them by their names.
        #[cfg(not(feature = "matlab"))]
        Content::Matlab(bytes) | Content::Octave(bytes) => scan_text(name, bytes, columns, options, consumer),
        #[cfg(feature = "arrow")]
        Content::Columns(format, file) => scan_arrow(name, format, file, columns, options, consumer),
        #[cfg(feature = "spreadsheets")]
        Content::Archive(bytes) => scan_workbook(name, bytes, columns, options, consumer),
        Content::Json(bytes) => scan_json(name, bytes, columns, options, consumer),
        Content::Bytes(bytes) => scan_text(name, bytes, columns, options, consumer),
        #[cfg(feature = "arrow")]
        Content::Batches(reader) => scan_batches(name, reader, columns, options, consumer),
        Content::Memory(table) => scan_memory(name, &table, columns, options, consumer),
    }
}

/// Refuses what is asked for and could have no effect.
fn refuse_vain(content: &Content, has_sheets: bool, table: &TableOptions) -> Result<(), InputErrorKind> {
    if matches!(content, Content::Bytes(_)) || table.is_beside {
        return Ok(());
    }
    let is_json = matches!(content, Content::Json(_));
    let dialect = &table.dialect;
    // The first of arrays in JSON may name the columns.
    let header = table.header.asked().filter(|_| !is_json);
    let of_text = [
        (dialect.encoding.is_some() && !is_json, "an encoding is"),
        (dialect.delimiter.is_some(), "a delimiter is"),
    ];
    let of_text_and_sheets = [
        (table.block.is_some(), "a block is"),
        (dialect.skip_lines > 0, "lines to skip are"),
        (dialect.units_row, "a row of units is"),
        (!table.missing_as.is_empty(), "words for missing values are"),
        (dialect.decimal.is_some(), "a decimal mark is"),
        (dialect.thousands.is_some(), "a mark between digits is"),
        (dialect.comment != CommentMark::Auto, "a mark of comments is"),
        (header.is_some(), header.unwrap_or_default()),
    ];
    let first = |words: &[(bool, &'static str)]| words.iter().find(|(is_asked, _)| *is_asked).copied();
    if let Some((_, asked)) = first(&of_text_and_sheets).filter(|_| !has_sheets) {
        return Err(InputErrorKind::OnlyOfText { asked, fits_sheets: true });
    }
    match first(&of_text) {
        Some((_, asked)) => Err(InputErrorKind::OnlyOfText { asked, fits_sheets: false }),
        None => Ok(()),
    }
}

/// Stops a scan whose rows are held where more of them, or more bytes, would be in memory than may be: a stream has any number of
/// them.
pub struct HeldRows {
    limit: usize,
    memory: HeldMemory,
    /// The most bytes that were held of the budget when it did not suffice.
    beyond: AtomicU64,
    row_cost: u64,
    /// The number of rows met so far, and the number of these that are held.
    met: AtomicUsize,
    rows: AtomicUsize,
    is_stopped: AtomicBool,
    progress: Option<Arc<dyn Progress>>,
}

/// The approximate number of bytes of a batch where few rows are taken. A batch of usual size has thousands
/// of rows with the texts of their cells, and some batches are read at a time.
const CHUNK_OF_FEW_ROWS: usize = 1 << 13;

/// Bytes that a row takes at least: its number, and two of its own.
const LEAST_ROW_COST: usize = 200;

impl HeldRows {
    /// Nothing yet of a scan with these options, which from now on stops at the limits of rows and of memory.
    pub fn limiting(options: &mut ScanOptions) -> Arc<Self> {
        let TableOptions { sizes, row_cost, .. } = &options.table;
        let held = Arc::new(HeldRows {
            limit: sizes.rows,
            memory: sizes.memory.nothing(),
            beyond: AtomicU64::new(0),
            row_cost: LEAST_ROW_COST.max(*row_cost) as u64,
            met: AtomicUsize::new(0),
            rows: AtomicUsize::new(0),
            is_stopped: AtomicBool::new(false),
            progress: options.progress.take(),
        });
        options.progress = Some(held.clone());
        held
    }

    /// Counts more held rows.
    pub fn add(&self, rows: usize) {
        self.add_counted(rows, rows, 0);
    }

    /// Adds rows that were met, rows among these that are held, and bytes held beside the rows.
    pub fn add_counted(&self, met: usize, held: usize, bytes: usize) {
        self.add_bytes(met, held, (held as u64).saturating_mul(self.row_cost).saturating_add(bytes as u64));
    }

    /// Adds rows that were met, rows among these that are held, and the bytes of the held rows.
    pub fn add_bytes(&self, met: usize, held: usize, bytes: u64) {
        self.met.fetch_add(met, Ordering::Relaxed);
        self.rows.fetch_add(held, Ordering::Relaxed);
        let held = self.memory.add(bytes);
        if held > self.memory.budget().limit() {
            // By the time that this is told, others may have given back what they held.
            self.beyond.fetch_max(held, Ordering::Relaxed);
        }
    }

    /// Stops the scan.
    fn stop(&self) {
        self.is_stopped.store(true, Ordering::Relaxed);
    }

    /// Refuses more rows, or more memory for them, than there may be.
    ///
    /// # Errors
    /// [`InputErrorKind::TooManyRows`] or [`InputErrorKind::TooMuchMemory`] about this file.
    pub fn check(&self, file: &str) -> Result<(), InputError> {
        let (rows, needed) = (self.rows.load(Ordering::Relaxed), self.beyond.load(Ordering::Relaxed));
        let limit = self.limit;
        let what = MemoryUse::Rows(self.met.load(Ordering::Relaxed));
        let problem = match (rows > limit, needed > 0) {
            (true, _) => InputErrorKind::TooManyRows { limit },
            (false, true) => {
                InputErrorKind::TooMuchMemory { what, needed, limit: self.memory.budget().limit() }
            }
            (false, false) => return Ok(()),
        };
        Err(InputError::of_file(file, problem))
    }

    fn is_full(&self) -> bool {
        self.rows.load(Ordering::Relaxed) > self.limit
            || self.beyond.load(Ordering::Relaxed) > 0
            || self.is_stopped.load(Ordering::Relaxed)
    }
}

impl Progress for HeldRows {
    fn advanced(&self, bytes: u64) {
        self.progress.iter().for_each(|progress| progress.advanced(bytes));
    }

    fn is_cancelled(&self) -> bool {
        self.is_full() || self.progress.as_ref().is_some_and(|progress| progress.is_cancelled())
    }
}

/// The columns asked for, as numbers.
#[derive(Debug, Clone)]
pub struct Table {
    /// The known facts about the table.
    pub scanned: Scanned,
    /// The rows wanted.
    pub rows: Vec<TableRow>,
    /// The rows that are not wanted but hold numbers, with `keep_others`.
    pub others: Vec<TableRow>,
}

/// Reads the columns asked for like [`scan`], and keeps all rows.
///
/// Exact as `options.reading` says. Cost: one pass; memory for the wanted cells.
///
/// ```
/// use boundfit_exact::Rational;
/// use boundfit_formats::{ColumnSelector, Source, TableOptions, read_table};
///
/// let columns = ["U", "I"].map(ColumnSelector::name_or_number);
/// let text = Source::new("resistor.csv", "I;U\n0.1;1/3\n0.2;0.7\n".as_bytes());
/// let table = read_table(text, &columns, &TableOptions::default())?;
/// assert_eq!(table.rows[0].numbers, [Rational::ratio(1, 3), Rational::ratio(1, 10)]);
///
/// let text = Source::new("resistor.csv", "I;U\n0.1;o.3\n".as_bytes());
/// let error = read_table(text, &columns, &TableOptions::default()).unwrap_err();
/// assert!(error.to_string().starts_with("resistor.csv: line 2, column 2 (U): \"o.3\": not a number"));
/// # Ok::<(), boundfit_formats::InputError>(())
/// ```
///
/// # Errors
/// The first thing wrong, with its place.
pub fn read_table(
    source: Source,
    columns: &[ColumnSelector],
    options: &TableOptions,
) -> Result<Table, InputError> {
    let file = source.name().to_owned();
    let mut options = ScanOptions { table: options.clone(), ..ScanOptions::default() };
    let held = HeldRows::limiting(&mut options);
    if options.table.most_wanted.is_some() {
        options.chunk_bytes = CHUNK_OF_FEW_ROWS;
    }
    let (mut rows, mut others) = (Vec::new(), Vec::new());
    let most_wanted = options.table.most_wanted.unwrap_or(usize::MAX);
    // One more tells that they are too many.
    let most_of_batch = most_wanted.saturating_add(1);
    let rows_of =
        |batch: Batch| (batch.table_rows().take(most_of_batch).collect::<Vec<TableRow>>(), batch.others);
    let mut is_full = false;
    let scanned = scan(source, columns, &options, rows_of, |(wanted, unwanted)| {
        held.add(wanted.len() + unwanted.len());
        is_full |= rows.len().saturating_add(wanted.len()) > most_wanted;
        if is_full {
            held.stop();
        } else {
            rows.extend(wanted);
            others.extend(unwanted);
        }
    });
    if is_full {
        return Err(InputError::of_file(&file, InputErrorKind::TooManyWanted { limit: most_wanted }));
    }
    held.check(file.raw())?;
    Ok(Table { scanned: scanned?, rows, others })
}
