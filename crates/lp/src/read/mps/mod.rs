//! MPS, free and fixed.

mod program;
mod record;
mod section;

use super::ModelLimits;
use super::error::{ModelError, ModelErrorKind};
use super::text::{Field, Line, lines};
use crate::format::ExchangeFormat;
use crate::model::{Model, ObjectiveSense};

use program::Program;
use record::{Blanks, Layout, Record, fields_with_blanks};
use section::{Section, is_comment, is_marker, is_maximize_comment};

/// Reads either form. A file is fixed if its lines of data are in the columns of that form, names in it contain
/// blanks, and it can be read so. A file that can be read either way with different meanings is refused.
pub(super) fn read(text: &str, limits: &ModelLimits) -> Result<Model, ModelError> {
    let free = read_as(text, Layout::Free, limits);
    let blanks = fields_with_blanks(text, limits);
    if blanks == Blanks::None || free.is_ok() && blanks == Blanks::BeforeOtherLines {
        return free;
    }
    match (free, read_as(text, Layout::Fixed, limits)) {
        (Ok(free), Ok(fixed)) if free != fixed => Err(ModelError::of_file(ModelErrorKind::Ambiguous)),
        (Err(free), Err(fixed)) => Err(if fixed.line() > free.line() { fixed } else { free }),
        (Ok(model), _) | (_, Ok(model)) => Ok(model),
    }
}

/// Sections of programs that are not linear, or have whole columns.
const NOT_LINEAR: [&str; 14] = [
    "QUADOBJ",
    "QMATRIX",
    "QSECTION",
    "QCMATRIX",
    "QUADS",
    "CSECTION",
    "SOS",
    "SOS1",
    "SOS2",
    "SETS",
    "INDICATORS",
    "GENCONS",
    "PWLOBJ",
    "USERCUTS",
];

fn read_as(text: &str, layout: Layout, limits: &ModelLimits) -> Result<Model, ModelError> {
    let mut reader =
        Reader { section: None, began: [None; 9], last: None, program: Program::new(limits), layout };
    for line in lines(text, limits) {
        let line = line?;
        if is_comment(line) || line.text.trim().is_empty() {
            if reader.section.is_none() && is_maximize_comment(line) {
                reader.program.maximize_comment = Some(line.whole());
            }
            continue;
        }
        reader.last = Some(line);
        if line.text.starts_with([' ', '\t']) {
            reader.data(line)?;
        } else if reader.heading(line)? {
            return reader.program.finish();
        }
    }
    Err(match reader.last {
        None => ModelError::of_file(ModelErrorKind::Empty(ExchangeFormat::Mps)),
        Some(last) => last.whole().error(ModelErrorKind::NoEnd(ExchangeFormat::Mps)),
    })
}

struct Reader<'a> {
    section: Option<Section>,
    /// The lines on which sections began, in the order of [`Section::ALL`].
    began: [Option<u64>; 9],
    /// The last line that is neither blank nor a comment.
    last: Option<Line<'a>>,
    program: Program<'a>,
    layout: Layout,
}

impl<'a> Reader<'a> {
    /// The first line of a section; tells whether it is the end.
    fn heading(&mut self, line: Line<'a>) -> Result<bool, ModelError> {
        let mut words = line.words();
        let Some(word) = words.next() else { return Ok(false) };
        let Some(section) = Section::named(word.text) else {
            let is_other = NOT_LINEAR.iter().any(|name| word.text.eq_ignore_ascii_case(name));
            return Err(word.error(match is_other {
                true => ModelErrorKind::NotLinear,
                false => ModelErrorKind::UnknownSection,
            }));
        };
        self.check_place(section, word)?;
        self.section = Some(section);
        match section {
            Section::Name => {
                let start = word.text.len();
                self.program.name = line.piece(start, line.text.len()).text;
            }
            Section::ObjSense | Section::ObjName => words.try_for_each(|word| self.word(section, word))?,
            _ => {
                if let Some(more) = words.next().filter(|more| !more.text.starts_with('$')) {
                    return Err(more.error(ModelErrorKind::SectionWithData));
                }
            }
        }
        Ok(section == Section::End)
    }

    /// Returns whether a section may begin here.
    fn check_place(&mut self, section: Section, word: Field<'a>) -> Result<(), ModelError> {
        let began_on = |wanted: Section| {
            Section::ALL
                .iter()
                .zip(&self.began)
                .find(|(section, _)| **section == wanted)
                .and_then(|(_, line)| *line)
        };
        if let Some(first) = began_on(section) {
            return Err(word.error(ModelErrorKind::SectionTwice { first }));
        }
        let missing = section.needs().filter(|needed| began_on(*needed).is_none());
        if let Some(missing) = missing {
            return Err(word.error(match section {
                Section::End => ModelErrorKind::NoSection(missing.name()),
                _ => ModelErrorKind::SectionEarly(missing.name()),
            }));
        }
        let is_empty = match self.section {
            Some(Section::ObjSense) => self.program.sense.is_none(),
            Some(Section::ObjName) => self.program.objective_name.is_none(),
            _ => false,
        };
        if let Some(section) = self.section.filter(|_| is_empty) {
            return Err(word.error(ModelErrorKind::EmptySection(section.name())));
        }
        let began = Section::ALL.iter().zip(&mut self.began).find(|(other, _)| **other == section);
        if let Some((_, began)) = began {
            *began = Some(word.line.number);
        }
        Ok(())
    }

    /// A line of data.
    fn data(&mut self, line: Line<'a>) -> Result<(), ModelError> {
        match self.section {
            None | Some(Section::Name | Section::End) => {
                Err(line.whole().error(ModelErrorKind::OutsideSection))
            }
            Some(section @ (Section::ObjSense | Section::ObjName)) => {
                line.words().try_for_each(|word| self.word(section, word))
            }
            Some(Section::Columns) if is_marker(line) => {
                self.program.set_integer(line.text.contains("'INTORG'"));
                Ok(())
            }
            Some(section) => {
                let record = Record::new(line, section, self.layout, self.program.columns())?;
                self.program.add(section, record)
            }
        }
    }

    /// A word of OBJSENSE or OBJNAME, each of which has one.
    fn word(&mut self, section: Section, word: Field<'a>) -> Result<(), ModelError> {
        let program = &mut self.program;
        let more = || word.error(ModelErrorKind::Record { section: section.name(), expected: "one word" });
        if section == Section::ObjName {
            return program.objective_name.replace(word).map_or(Ok(()), |_| Err(more()));
        }
        let is_any = |names: &[&str]| names.iter().any(|name| word.text.eq_ignore_ascii_case(name));
        let sense = match () {
            () if is_any(&["MAX", "MAXIMIZE", "MAXIMISE"]) => ObjectiveSense::Maximize,
            () if is_any(&["MIN", "MINIMIZE", "MINIMISE"]) => ObjectiveSense::Minimize,
            () => return Err(word.error(ModelErrorKind::Sense)),
        };
        program.sense.replace(sense).map_or(Ok(()), |_| Err(more()))
    }
}
