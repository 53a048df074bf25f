//! Record batches out of files, by the libraries of the formats.

use std::cell::Cell;
use std::fs::File;
use std::io::{BufReader, Seek};
use std::panic::{self, AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, Once};

use arrow_array::cast::AsArray;
use arrow_array::{ArrayRef, RecordBatch};
use arrow_ipc::reader::{FileReader, StreamReader};
use arrow_schema::{ArrowError, DataType, Schema};
use arrow_select::take::take;
use boundfit_exact::Foreign;
use parquet::arrow::ProjectionMask;
use parquet::arrow::arrow_reader::ParquetRecordBatchReaderBuilder;

use crate::binary::BinaryFormat;
use crate::error::InputErrorKind;

/// The most rows that are decoded at a time. They are few enough to stay in the cache, and the allocator
/// hands the same memory out again. With eight times as many rows, 17 digits take a fifth longer.
const BATCH_ROWS: usize = 1 << 13;

/// The most rows of text: a page may have one long text that all of them are.
const BATCH_ROWS_OF_TEXT: usize = 1 << 10;

/// Returns the number of rows of columns of these types that are decoded at a time.
pub(super) fn rows_at_a_time<'a>(mut types: impl Iterator<Item = &'a DataType>) -> usize {
    if types.all(DataType::is_primitive) { BATCH_ROWS } else { BATCH_ROWS_OF_TEXT }
}

/// The names of all columns.
pub(super) fn column_names(format: BinaryFormat, file: &File) -> Result<Vec<Foreign>, InputErrorKind> {
    let fail = |error| unreadable(format, error);
    let schema: Arc<Schema> = match format {
        BinaryFormat::Parquet => {
            let builder = ParquetRecordBatchReaderBuilder::try_new(file.try_clone()?);
            builder.map_err(|error| fail(error.into()))?.schema().clone()
        }
        BinaryFormat::ArrowFile => FileReader::try_new(buffered(file)?, None).map_err(fail)?.schema(),
        BinaryFormat::ArrowStream => StreamReader::try_new(buffered(file)?, None).map_err(fail)?.schema(),
        BinaryFormat::Matlab | BinaryFormat::Archive => return Ok(Vec::new()),
    };
    Ok(schema.fields().iter().map(|field| Foreign::from(field.name())).collect())
}

thread_local! {
    /// `true` while a library works whose crash is an error of the file.
    static IS_GUARDED: Cell<bool> = const { Cell::new(false) };
}

/// Lets a library work. Damaged files make the libraries crash in places; that is an error like the others, and nothing else is
/// written about it.
pub(super) fn guarded<T>(
    format: BinaryFormat,
    work: impl FnOnce() -> Result<T, InputErrorKind>,
) -> Result<T, InputErrorKind> {
    let crashed = || InputErrorKind::Unreadable { format: format.name(), reason: "it is damaged".into() };
    static HOOK: Once = Once::new();
    HOOK.call_once(|| {
        let before = panic::take_hook();
        panic::set_hook(Box::new(move |crash| {
            if !IS_GUARDED.get() {
                before(crash);
            }
        }));
    });
    let was_guarded = IS_GUARDED.replace(true);
    let made = catch_unwind(AssertUnwindSafe(work));
    IS_GUARDED.set(was_guarded);
    made.unwrap_or_else(|_| Err(crashed()))
}

type Batches = Box<dyn Iterator<Item = Result<RecordBatch, InputErrorKind>>>;

/// The columns at these indices, which ascend, of all rows.
pub(super) fn batches(
    format: BinaryFormat,
    file: &File,
    columns: Vec<usize>,
) -> Result<Batches, InputErrorKind> {
    let fail = move |error| unreadable(format, error);
    Ok(match format {
        BinaryFormat::Parquet => {
            let builder = ParquetRecordBatchReaderBuilder::try_new(file.try_clone()?)
                .map_err(|error| fail(error.into()))?;
            let fields = builder.schema().fields();
            let types =
                columns.iter().filter_map(|column| fields.get(*column)).map(|field| field.data_type());
            let rows = rows_at_a_time(types);
            let mask = ProjectionMask::roots(builder.parquet_schema(), columns);
            let reader = builder.with_projection(mask).with_batch_size(rows).build();
            let reader = reader.map_err(|error| fail(error.into()))?;
            Box::new(reader.map(move |batch| batch.map_err(fail)))
        }
        BinaryFormat::ArrowFile => {
            let reader = FileReader::try_new(buffered(file)?, Some(columns)).map_err(fail)?;
            Box::new(reader.map(move |batch| batch.map_err(fail)))
        }
        BinaryFormat::ArrowStream => {
            let reader = StreamReader::try_new(buffered(file)?, Some(columns)).map_err(fail)?;
            Box::new(reader.map(move |batch| batch.map_err(fail)))
        }
        BinaryFormat::Matlab | BinaryFormat::Archive => Box::new(std::iter::empty()),
    })
}

/// The array with its dictionary, when it has one, looked up.
pub(super) fn plain(array: &ArrayRef) -> Result<ArrayRef, InputErrorKind> {
    match array.as_any_dictionary_opt() {
        Some(dictionary) => take(dictionary.values(), dictionary.keys(), None)
            .map_err(|error| unreadable(BinaryFormat::ArrowFile, error)),
        None => Ok(array.clone()),
    }
}

fn buffered(file: &File) -> Result<BufReader<File>, InputErrorKind> {
    let mut file = file.try_clone()?;
    file.rewind()?;
    Ok(BufReader::new(file))
}

pub(super) fn unreadable(format: BinaryFormat, error: ArrowError) -> InputErrorKind {
    InputErrorKind::Unreadable { format: format.name(), reason: error.to_string().into() }
}
