//! Searches the variables of a file for columns, and keeps the columns that it found.

use std::io::{self, Read};
use std::sync::Arc;

use boundfit_exact::Foreign;
use flate2::read::ZlibDecoder;

use super::elements::{ByteOrder, COMPRESSED, Damage, Elements, MATRIX};
use super::file::MatFile;
use super::numbers::Numbers;
use super::variable::{Content, Variable, fields};
use crate::budget::HeldMemory;
use crate::columns::{ColumnPlace, ColumnSelector};
use crate::error::InputErrorKind;
use crate::limits::SizeLimits;
use crate::memory_use::MemoryUse;

/// The memory of a number, whatever it takes in the file.
const BYTES_PER_NUMBER: u64 = 8;

/// The memory of what is known of a variable beside its texts, twice: a list grows in steps.
const OF_A_VARIABLE: usize = 2 * size_of::<Found>();

/// A column: numbers of a variable, from one of them on.
#[derive(Clone)]
pub(super) struct MatColumn {
    pub(super) place: ColumnPlace,
    pub(super) numbers: Arc<Numbers>,
    pub(super) start: usize,
    rows: u64,
}

/// A variable as it was found, with its numbers if they may be wanted.
struct Found {
    variable: Variable,
    numbers: Option<Arc<Numbers>>,
    /// The number of columns before it.
    before: u64,
    /// The names of the fields of a struct.
    fields: Vec<String>,
}

impl Found {
    fn has_number(&self, number: u64) -> bool {
        (self.before + 1..=self.before + self.variable.content.columns()).contains(&number)
    }

    /// Returns a name, with its article, for a variable that is no matrix of numbers.
    fn what(&self) -> String {
        match &self.variable.content {
            Content::Other(what) => what.clone(),
            _ => match &self.fields[..] {
                [] => "a struct without fields".to_owned(),
                [field] => format!("a struct with the field {field}"),
                fields => format!("a struct with the fields {}", fields.join(", ")),
            },
        }
    }

    /// Rows and columns of a matrix of numbers.
    fn size(&self) -> Result<(u64, u64), InputErrorKind> {
        match &self.variable.content {
            &Content::Numbers { rows, columns } => Ok((rows, columns)),
            _ => Err(InputErrorKind::NoNumbers {
                variable: self.variable.name.clone().into(),
                what: self.what().into(),
            }),
        }
    }
}

/// The column that a selector means.
pub(super) struct Wanted<'a> {
    text: &'a str,
    /// `M` and 2 of `M(:,2)`.
    of_matrix: Option<(String, u64)>,
    number: Option<u64>,
}

impl<'a> Wanted<'a> {
    pub(super) fn new(selector: &'a ColumnSelector) -> Self {
        let text = selector.text().raw();
        let bare: String = text.split_whitespace().collect();
        let of_matrix = bare.strip_suffix(')').and_then(|bare| {
            let (name, column) = bare.split_once("(:,")?;
            Some((name.to_owned(), column.parse().ok()?))
        });
        Wanted { text, of_matrix, number: selector.number().map(|number| number as u64) }
    }

    /// Returns whether this may be a column of a variable.
    fn is_in(&self, found: &Found) -> bool {
        self.is_named(&found.variable) || self.number.is_some_and(|number| found.has_number(number))
    }

    fn is_named(&self, variable: &Variable) -> bool {
        variable.name == self.text || self.of_matrix.as_ref().is_some_and(|(name, _)| *name == variable.name)
    }
}

/// A file on its way: what is looked for, and what was found.
pub(super) struct Search<'a> {
    wanted: &'a [Wanted<'a>],
    sizes: &'a SizeLimits,
    all: Vec<Found>,
    /// The number of columns so far.
    before: u64,
    /// The number of bytes of variables in the file so far, and the number of bytes of their numbers that are
    /// held.
    packed: u64,
    held: u64,
    /// The memory of these numbers.
    pub(super) memory: HeldMemory,
}

impl<'a> Search<'a> {
    pub(super) fn new(wanted: &'a [Wanted<'a>], sizes: &'a SizeLimits) -> Self {
        let memory = sizes.memory.nothing();
        Search { wanted, sizes, all: Vec::new(), before: 0, packed: 0, held: 0, memory }
    }

    /// The columns that are looked for, and how many rows they have.
    pub(super) fn columns(&self) -> Result<(Vec<MatColumn>, usize), InputErrorKind> {
        let columns = self.wanted.iter().map(|wanted| resolve(wanted, &self.all));
        let columns = columns.collect::<Result<Vec<_>, _>>()?;
        let rows = common_length(&columns)?;
        Ok((columns, rows))
    }

    /// Adds a variable that has so many bytes in the file. Where its numbers may be wanted, `read` reads so many; else they are for
    /// whoever calls to pass over. Gives whether they were read.
    pub(super) fn add(
        &mut self,
        variable: Variable,
        bytes: u64,
        read: impl FnOnce(u64, &HeldMemory) -> Result<Numbers, Damage>,
    ) -> Result<bool, Damage> {
        self.packed = self.packed.saturating_add(bytes);
        let mut found = Found { variable, numbers: None, before: self.before, fields: Vec::new() };
        let is_wanted = self.admit(&mut found, read)?;
        self.before = self.before.saturating_add(found.variable.content.columns());
        self.hold(found)?;
        Ok(is_wanted)
    }

    /// Reads the numbers of a variable if they may be wanted and keep to the limits.
    fn admit(
        &mut self,
        found: &mut Found,
        read: impl FnOnce(u64, &HeldMemory) -> Result<Numbers, Damage>,
    ) -> Result<bool, Damage> {
        let Content::Numbers { rows, columns } = found.variable.content else { return Ok(false) };
        if !self.wanted.iter().any(|wanted| wanted.is_in(found)) {
            return Ok(false);
        }
        self.refuse_second(found)?;
        let count = rows.saturating_mul(columns);
        let limit = self.sizes.elements;
        if usize::try_from(count).map_or(true, |count| count > limit) {
            let variable = found.variable.name.clone().into();
            return Err(Damage::Refused(InputErrorKind::TooManyElements {
                variable,
                elements: count,
                limit,
            }));
        }
        self.held = self.held.saturating_add(count.saturating_mul(BYTES_PER_NUMBER));
        self.sizes.check_ratio(self.packed, self.held).map_err(Damage::Refused)?;
        found.numbers = Some(Arc::new(read(count, &self.memory)?));
        Ok(true)
    }

    /// Reads the next variable of version 5; `false` at the end of the file.
    pub(super) fn next(&mut self, file: &mut MatFile, order: ByteOrder) -> Result<bool, Damage> {
        let Some(tag) = Elements::new(file.by_ref(), order).tag()? else { return Ok(false) };
        let mut body = file.by_ref().take(tag.bytes);
        self.packed = self.packed.saturating_add(tag.bytes);
        match tag.kind {
            MATRIX => {
                self.matrix(&mut Elements::new(&mut body, order), "", self.sizes.nesting)?;
            }
            COMPRESSED => {
                let mut inflated = ZlibDecoder::new(&mut body);
                let inner = Elements::new(inflated.by_ref(), order).some_tag()?;
                if inner.kind != MATRIX {
                    return Err(Damage::format(format!("the element type {} is inflated", inner.kind)));
                }
                let content = &mut Elements::new(inflated.by_ref().take(inner.bytes), order);
                let is_read = self.matrix(content, "", self.sizes.nesting)?;
                // The end of what is inflated has a checksum.
                if is_read && inflated.read(&mut [0])? > 0 {
                    return Err(Damage::format("more is inflated than announced"));
                }
            }
            other => {
                return Err(Damage::format(format!("the element type {other} is not that of a variable")));
            }
        }
        io::copy(&mut body, &mut io::sink())?;
        if body.limit() > 0 {
            return Err(Damage::Io(io::ErrorKind::UnexpectedEof.into()));
        }
        Ok(true)
    }

    /// Reads a variable or a field of one, whose name begins like this, and its numbers if they may be wanted; gives
    /// whether it was read to its end.
    fn matrix<R: Read>(
        &mut self,
        elements: &mut Elements<R>,
        prefix: &str,
        nesting: usize,
    ) -> Result<bool, Damage> {
        let mut variable = Variable::read(elements)?;
        variable.name.insert_str(0, prefix);
        let mut found = Found { variable, numbers: None, before: self.before, fields: Vec::new() };
        if found.variable.name.is_empty() {
            found.variable.content = Content::Other("MATLAB's own".to_owned());
        }
        match found.variable.content {
            Content::Numbers { .. } => {}
            Content::Struct => return self.fields(elements, found, nesting),
            Content::Other(_) => {
                self.hold(found)?;
                return Ok(false);
            }
        }
        let is_wanted = self.admit(&mut found, |count, memory| Numbers::read(elements, count, memory))?;
        // The rest of the variable is at most padding; it is inflated for its checksum.
        if is_wanted && elements.tag()?.is_some() {
            return Err(Damage::format(format!("{:?} goes on behind its numbers", found.variable.name)));
        }
        self.before = self.before.saturating_add(found.variable.content.columns());
        self.hold(found)?;
        Ok(is_wanted)
    }

    /// Reads the fields of a struct as variables with its name, a point and theirs.
    fn fields<R: Read>(
        &mut self,
        elements: &mut Elements<R>,
        mut found: Found,
        nesting: usize,
    ) -> Result<bool, Damage> {
        let Some(nesting) = nesting.checked_sub(1) else {
            return Err(Damage::format(format!(
                "{:?} is a struct in a struct in a struct ...",
                found.variable.name
            )));
        };
        found.fields = fields(elements)?;
        let (name, names) = (found.variable.name.clone(), found.fields.clone());
        self.hold(found)?;
        for field in names {
            let tag = elements.some_tag()?;
            if tag.kind != MATRIX {
                return Err(Damage::format(format!(
                    "the field {name}.{field} has the element type {}",
                    tag.kind
                )));
            }
            // MATLAB writes nothing for what is empty.
            if tag.bytes == 0 {
                continue;
            }
            let mut content = elements.within(tag);
            self.matrix(&mut content, &format!("{name}.{field}"), nesting)?;
            content.leave()?;
        }
        Ok(false)
    }

    /// Adds what was found of a variable, for which memory is asked.
    fn hold(&mut self, found: Found) -> Result<(), Damage> {
        let names = found.fields.iter().map(|field| size_of::<String>() + field.len());
        let bytes = OF_A_VARIABLE + found.variable.name.len() + names.sum::<usize>();
        self.memory.ask(bytes as u64, MemoryUse::Variables).map_err(Damage::Refused)?;
        self.all.push(found);
        Ok(())
    }

    /// Refuses one more variable of a name that is wanted: only one of them is held.
    fn refuse_second(&self, found: &Found) -> Result<(), Damage> {
        let name = &found.variable.name;
        let is_other = |other: &Found| other.numbers.is_some() && other.variable.name == *name;
        if self.wanted.iter().any(|wanted| wanted.is_named(&found.variable)) && self.all.iter().any(is_other)
        {
            return Err(Damage::Refused(InputErrorKind::AmbiguousColumn { wanted: name.into() }));
        }
        Ok(())
    }
}

/// The column that is meant.
fn resolve(wanted: &Wanted, all: &[Found]) -> Result<MatColumn, InputErrorKind> {
    if let Some(found) = only(wanted.text, wanted, all)? {
        let (rows, columns) = found.size()?;
        let is_matrix = found.variable.content.columns() > 1;
        let whole =
            || InputErrorKind::WholeMatrix { variable: found.variable.name.clone().into(), rows, columns };
        return if is_matrix { Err(whole()) } else { column(found, 1) };
    }
    if let Some((name, number)) = &wanted.of_matrix
        && let Some(found) = only(name, wanted, all)?
    {
        // A row has as many columns as numbers in MATLAB, and is one here.
        let is_row = matches!(found.size()?, (1, 2..));
        if !is_row && (1..=found.variable.content.columns()).contains(number) {
            return column(found, *number);
        }
    }
    let numbered = |number: u64| Some((all.iter().find(|found| found.has_number(number))?, number));
    match wanted.number.and_then(numbered) {
        Some((found, number)) => column(found, number - found.before),
        None => Err(unknown(wanted, all)),
    }
}

/// The variable of this name, if there is one.
fn only<'a>(name: &str, wanted: &Wanted, all: &'a [Found]) -> Result<Option<&'a Found>, InputErrorKind> {
    let mut named = all.iter().filter(|found| found.variable.name == name);
    match (named.next(), named.next()) {
        (_, Some(_)) => Err(InputErrorKind::AmbiguousColumn { wanted: wanted.text.into() }),
        (found, None) => Ok(found),
    }
}

fn unknown(wanted: &Wanted, all: &[Found]) -> InputErrorKind {
    let names = |found: &Found| match (&found.variable, found.variable.content.columns()) {
        (_, 0) => None,
        (variable, 1) => Some(variable.name.clone()),
        (variable, last) => Some(format!("{} to {}", variable.column_name(1), variable.column_name(last))),
    };
    let total = all.last().map_or(0, |last| last.before.saturating_add(last.variable.content.columns()));
    // A file without any column has something else instead.
    if let Some(found) = all.iter().find(|found| !found.variable.name.is_empty()).filter(|_| total == 0) {
        return InputErrorKind::NoNumbers {
            variable: found.variable.name.clone().into(),
            what: found.what().into(),
        };
    }
    InputErrorKind::UnknownColumn {
        wanted: wanted.text.into(),
        available: all.iter().filter_map(names).map(Foreign::from).collect(),
        numbers: wanted.number.and(usize::try_from(total).ok()).filter(|total| *total > 0),
    }
}

/// A column of a variable, counted from 1.
fn column(found: &Found, number: u64) -> Result<MatColumn, InputErrorKind> {
    let rows = found.variable.content.rows();
    let whole = |number: u64| usize::try_from(number).unwrap_or(usize::MAX);
    let place = ColumnPlace {
        position: whole(found.before + number),
        name: Some(found.variable.column_name(number).into()),
    };
    match &found.numbers {
        Some(numbers) => {
            let start = whole((number - 1).saturating_mul(rows));
            Ok(MatColumn { place, numbers: numbers.clone(), start, rows })
        }
        // All columns that are asked for have been read.
        None => Err(InputErrorKind::Changed),
    }
}

/// The length that all columns have.
fn common_length(columns: &[MatColumn]) -> Result<usize, InputErrorKind> {
    let Some(first) = columns.first() else { return Ok(0) };
    if let Some(other) = columns.iter().find(|other| other.rows != first.rows) {
        let described = |column: &MatColumn| (column.place.title(), column.rows);
        return Err(InputErrorKind::DifferentLengths { first: described(first), other: described(other) });
    }
    Ok(usize::try_from(first.rows).unwrap_or(usize::MAX))
}
