//! Selects columns of a table whose names are no line of a text.

use boundfit_exact::{Foreign, WorkMeter};

use crate::columns::{ColumnPlace, ColumnSelector, Header, refuse_same};
use crate::error::{InputError, InputErrorKind, are_no_names};
use crate::heading::{AskedColumns, Heading};
use crate::scan::{ScanOptions, Scanned, csv_line, each_once};
use crate::selection::RowCondition;

/// A column that has a place in the table.
pub(crate) trait Placed {
    fn place(&self) -> &ColumnPlace;
}

impl Placed for ColumnPlace {
    fn place(&self) -> &ColumnPlace {
        self
    }
}

/// The columns that are wanted, by their places in the table unless something else tells where they are.
pub(crate) struct WantedColumns<'a, C = ColumnPlace> {
    pub(crate) file: &'a str,
    pub(crate) options: &'a ScanOptions,
    pub(crate) selectors: &'a [ColumnSelector],
    pub(crate) places: Vec<C>,
    pub(crate) key: Option<C>,
    pub(crate) identity: Option<C>,
    /// The conditions that wanted rows satisfy, and the places of their columns.
    pub(crate) conditions: Vec<(C, &'a RowCondition)>,
    /// The work on the numbers that were read as text.
    pub(crate) meter: WorkMeter,
}

impl<'a> WantedColumns<'a> {
    /// Finds them among the names of all columns.
    ///
    /// # Errors
    /// A column that is not there, or that a name does not tell from others.
    pub(crate) fn new(
        file: &'a str,
        names: &[Foreign],
        selectors: &'a [ColumnSelector],
        options: &'a ScanOptions,
    ) -> Result<Self, InputError> {
        let key = options.key.as_ref();
        let conditions = &options.table.conditions;
        let identity = options.identity.as_ref();
        let others: Vec<&ColumnSelector> =
            key.into_iter().chain(identity).chain(conditions.iter().map(RowCondition::column)).collect();
        let cells: Vec<&[u8]> = names.iter().map(|name| name.raw().as_bytes()).collect();
        let missing_as = &options.table.missing_as;
        let asked = AskedColumns { columns: selectors, others: &others, missing_as };
        let heading = Heading::new(file, &cells, 1, Header::Present, asked, &[])?;
        let find = |selector| {
            heading.find(file, selector).map_err(|mut error| {
                // There are no lines here, and nothing but the names tells columns apart.
                error.place.line = None;
                match &mut error.kind {
                    InputErrorKind::NameOrNumber { fits_header, .. } => *fits_header = false,
                    // Numbers are names here, too.
                    InputErrorKind::UnknownColumn { available, numbers, .. } => {
                        let is_named = available.iter().any(|name| !name.is_empty());
                        *numbers = numbers.filter(|_| !is_named || !are_no_names(available));
                    }
                    _ => {}
                }
                error
            })
        };
        let places: Vec<ColumnPlace> = selectors.iter().map(find).collect::<Result<_, _>>()?;
        refuse_same(file, places.iter().zip(selectors))?;
        Ok(WantedColumns {
            file,
            options,
            selectors,
            places,
            key: key.map(find).transpose()?,
            identity: identity.map(find).transpose()?,
            conditions: conditions
                .iter()
                .map(|condition| Ok((find(condition.column())?, condition)))
                .collect::<Result<_, InputError>>()?,
            meter: WorkMeter::default(),
        })
    }
}

impl<C: Placed> WantedColumns<'_, C> {
    /// The columns in which a wanted row has a number: those that conditions are about, and those that are read for one.
    pub(crate) fn needed(&self) -> impl Iterator<Item = &C> {
        let looked_at = self.conditions.iter().map(|(place, _)| place);
        let read = self.places.iter().zip(self.selectors);
        looked_at.chain(read.filter(|(_, selector)| selector.role().is_needed()).map(|(place, _)| place))
    }

    /// All columns that are wanted for something.
    pub(crate) fn all(&self) -> impl Iterator<Item = &C> {
        let looked_at = self.conditions.iter().map(|(place, _)| place);
        self.places.iter().chain(&self.key).chain(&self.identity).chain(looked_at)
    }

    /// The columns that rows have as text, each once.
    pub(crate) fn written(&self) -> Vec<&C> {
        let places = || self.places.iter().chain(&self.identity);
        let titles: Vec<Foreign> = places().map(|column| column.place().title()).collect();
        each_once(places(), &titles).collect()
    }

    /// The words about rows that come from no bytes.
    pub(crate) fn scanned(&self, rows_total: usize, rows_missing: usize) -> Scanned {
        let titles = || self.written().into_iter().map(|column| column.place().title().raw().to_owned());
        Scanned {
            layout: None,
            table: None,
            header_line: self.options.keep_text.then(|| csv_line(titles())),
            header: Vec::new(),
            units: vec![None; self.places.len()],
            names: self.places.iter().map(|column| column.place().title()).collect(),
            fractions: Vec::new(),
            key_name: self.key.as_ref().map(|column| column.place().title()),
            rows_total,
            ranges: Vec::new(),
            rows_missing,
            bytes: 0,
            sha256: None,
        }
    }
}
