//! The question, as JSON: the readings and the question in the words of every surface, and the options of the answer.

use boundfit::ask::{
    self, AnswerWords, Ask, Common, Digits, Fit, Form, OfRows, Readings, Request, RowWords, TableWords,
    named, question_of, take_key,
};
use boundfit::engine::exact::Foreign;
use boundfit::engine::formats::{RowNumbers, nearest};
use boundfit::files::{Measurements, RowRange, RowSet, Source, TableOptions};
use boundfit::lesson::{LessonOptions, MOST_ROWS, MOST_ROWS_EVER};
use boundfit::report::{EndRounding, Style};
use serde_json::{Map, Value};

use crate::refusal::Refusal;

/// The name in messages of a table without a name.
const NO_FILE: &str = "standard input";

/// The keys of a lesson.
const PAGE_KEYS: [&str; 4] = ["title", "x_unit", "y_unit", "max_readings"];

/// The keys of the object, each named as the option of the program that it is.
#[derive(Debug)]
pub(crate) struct Options {
    readings: Readings,
    /// The form of the answer, and the name of the table: without one it is standard input.
    pub(crate) answer: AnswerWords,
    title: Option<String>,
    x_unit: Option<String>,
    y_unit: Option<String>,
    max_readings: Option<u64>,
    /// The question, with its own keys.
    question: Map<String, Value>,
}

/// The format of a table, before a question about it.
#[derive(Debug)]
pub(crate) struct TableAlone {
    file: Option<String>,
    words: TableWords,
}

impl TableAlone {
    /// Reads the object.
    ///
    /// # Errors
    /// With the key that is not known, or of another type.
    pub(crate) fn parse(json: &str) -> Result<Self, Refusal> {
        let mut keys = object(json)?;
        let own = TableAlone { file: take_key(&mut keys, "file")?, words: TableWords::take(&mut keys)? };
        refuse_unknown(keys.keys(), || [&["file"], TableWords::KEYS].concat().join(", "))?;
        Ok(own)
    }

    /// The name of the table in messages.
    pub(crate) fn file(&self) -> &str {
        self.file.as_deref().unwrap_or(NO_FILE)
    }

    /// Returns the options for reading the table.
    pub(crate) fn options(&self) -> Result<TableOptions, Refusal> {
        Ok(self.words.resolve(self.words.reading(false)?, &RowWords::default())?)
    }
}

pub(crate) fn object(json: &str) -> Result<Map<String, Value>, Refusal> {
    serde_json::from_str(json).map_err(|error| format!("options: {error}").into())
}

/// The keys of every question.
fn known_keys() -> String {
    [AnswerWords::KEYS, &PAGE_KEYS, Readings::KEYS, RowWords::KEYS, TableWords::KEYS].concat().join(", ")
}

/// Refuses a key, and names those that there are.
pub(crate) fn refuse_unknown<'a>(
    mut keys: impl Iterator<Item = &'a String>,
    known: impl FnOnce() -> String,
) -> Result<(), ask::Refusal> {
    let Some(key) = keys.next() else { return Ok(()) };
    let known = known();
    let hint = nearest_of(key, known.split(", "));
    let problem = format!("there is no such key (expected one of {known}){hint}");
    Err(ask::Refusal::Key { key: key.clone(), problem })
}

/// The key that was meant, behind serde's words about one that is not known, and the other keys that there are.
fn hint(problem: &str, known: &str) -> String {
    // Keys stand between backticks, the one that is not known first.
    let mut own = problem.split('`').skip(1).step_by(2);
    own.next().map_or_else(String::new, |key| nearest_of(key, own.chain(known.split(", "))))
}

/// The fit that these keys ask for. A page's module answers nothing else.
fn fit_alone(mut keys: Map<String, Value>) -> Result<Request, ask::Refusal> {
    match keys.remove("ask") {
        Some(Value::String(name)) if name != Fit::NAME => Err(no_other(&name)),
        _ => question_of(keys).map(Request::Fit),
    }
}

/// Refuses a question other than the fit in a page.
pub(crate) fn no_other(name: &str) -> ask::Refusal {
    ask::Refusal::Request(format!("{name}: the module of a page answers fit alone"))
}

/// The nearest of these keys as a question, if one is near.
fn nearest_of<'a>(key: &str, keys: impl Iterator<Item = &'a str>) -> String {
    let keys: Vec<Foreign> = keys.map(Foreign::from).collect();
    nearest(key, &keys).map_or_else(String::new, |meant| format!("; did you mean {}?", meant.raw()))
}

impl Options {
    /// Reads the object.
    ///
    /// # Errors
    /// With the key that is not known, or of another type.
    pub(crate) fn parse(json: &str) -> Result<Self, Refusal> {
        let mut keys = object(json)?;
        let own = &mut keys;
        let Common { readings, answer } = Common::take(own)?;
        Ok(Options {
            readings,
            answer,
            title: take_key(own, "title")?,
            x_unit: take_key(own, "x_unit")?,
            y_unit: take_key(own, "y_unit")?,
            max_readings: take_key(own, "max_readings")?,
            question: keys,
        })
    }

    /// The question: the fit, where no other is asked, or that of readings whose x have errors, where these are bounded.
    ///
    /// # Errors
    /// When there is no such question, or it has no such key.
    pub(crate) fn request(&self) -> Result<Request, Refusal> {
        let mut keys = self.question.clone();
        if keys.get("ask").is_none_or(|ask| ask.is_null() || ask == "fit") {
            let has_x_errors = self.readings.x_eps.is_some() || self.readings.x_eps_column.is_some();
            let name = if has_x_errors { "fit-x-errors" } else { "fit" };
            keys.insert("ask".to_owned(), name.into());
        }
        // Unreachable code is left out of the module, and eleven other questions are a fiftieth of the page's.
        let read = if cfg!(feature = "questions") { Request::of_keys } else { fit_alone };
        let request = read(keys).map_err(|refusal| match refusal {
            // It knows the keys of the question alone.
            ask::Refusal::Request(problem) if problem.starts_with("request: unknown field") => {
                let known = known_keys();
                let hint = hint(&problem, &known);
                ask::Refusal::Request(format!("{problem}; every question has {known}{hint}"))
            }
            refusal => refusal,
        });
        Ok(request?)
    }

    /// The table, and which of its readings are asked about: by a question, or by a page.
    ///
    /// # Errors
    /// When a value makes no sense, or values exclude or need each other.
    pub(crate) fn asked(
        &self,
        table: Vec<u8>,
        request: Option<&Request>,
    ) -> Result<(Source, ask::Asked), Refusal> {
        let source = Source::of_bytes(self.file(), table);
        let reading = self.readings.table.reading(source.is_stored())?;
        let asked = match request {
            Some(request) => request.resolve(&self.readings, reading),
            None => self.readings.resolve(reading),
        };
        Ok((source, asked?))
    }

    /// Refuses what is about a page alone.
    ///
    /// # Errors
    /// With the key.
    pub(crate) fn refuse_words_of_page(&self) -> Result<(), Refusal> {
        let asked = [
            ("title", self.title.is_some()),
            ("x_unit", self.x_unit.is_some()),
            ("y_unit", self.y_unit.is_some()),
            ("max_readings", self.max_readings.is_some()),
        ];
        refuse_any(&asked, "is about a lesson, and this is a report")
    }

    /// Returns the page's statements about the readings besides those that follow from them.
    ///
    /// # Errors
    /// With a key that is about a report alone, or a number of readings that no page has.
    pub(crate) fn lesson(&self, measurements: &Measurements) -> Result<LessonOptions, Refusal> {
        if self.max_readings.is_some_and(|most| !(1..=u64::from(MOST_ROWS_EVER)).contains(&most)) {
            return Err(format!("max_readings: expected a number from 1 to {MOST_ROWS_EVER}").into());
        }
        let [x_unit, y_unit] = measurements.plane_units();
        let foreign = |text: &Option<String>| text.as_ref().map(Foreign::from);
        Ok(LessonOptions {
            file: self.file().into(),
            title: foreign(&self.title),
            x_unit: foreign(&self.x_unit).or(x_unit.cloned()),
            y_unit: foreign(&self.y_unit).or(y_unit.cloned()),
            most_rows: self.max_readings.map_or(MOST_ROWS, |most| most as usize),
            // The other options concern the page, not its content.
            ..LessonOptions::default()
        })
    }

    /// Refuses what is about a report alone.
    ///
    /// # Errors
    /// With the key.
    pub(crate) fn refuse_words_of_report(&self) -> Result<(), Refusal> {
        let asked = [
            ("format", self.answer.format.is_some()),
            ("digits", self.answer.digits.is_some()),
            ("rounding", self.answer.rounding.is_some()),
            ("exact", self.answer.exact),
            ("no_eui", self.question.contains_key("no_eui")),
            ("ask", self.question.get("ask").is_some_and(|ask| !ask.is_null() && ask != "fit")),
            ("x_eps", self.readings.x_eps.is_some()),
            ("x_eps_column", self.readings.x_eps_column.is_some()),
            ("strong", self.readings.strong),
        ];
        refuse_any(&asked, "is about a report, and this is a lesson")?;
        Ok(refuse_unknown(self.question.keys().filter(|key| *key != "ask"), known_keys)?)
    }

    /// The name of the table in messages.
    pub(crate) fn file(&self) -> &str {
        self.answer.file.as_deref().unwrap_or(NO_FILE)
    }

    /// Returns the form of the answer.
    pub(crate) fn form(&self) -> Result<Form, Refusal> {
        let names = Form::ALL.map(|form| (form.name(), form));
        Ok(named("format", self.answer.format.as_deref(), &names)?.unwrap_or(Form::Json))
    }

    /// Returns the style of numbers.
    pub(crate) fn style(&self) -> Result<Style, Refusal> {
        let AnswerWords { digits, rounding, exact, .. } = &self.answer;
        let names = EndRounding::ALL.map(|rounding| (rounding.name(), rounding));
        let ends = named("rounding", rounding.as_deref(), &names)?.unwrap_or_default();
        Ok(Style { digits: digits.map(Digits::get), ends, exact: *exact, ..Style::default() })
    }

    /// The numbers of the rows of the table, where they are not 1, 2, 3 and so on.
    ///
    /// # Errors
    /// When they do not ascend.
    pub(crate) fn numbering(&self) -> Result<Option<Numbering>, Refusal> {
        let row_numbers = &self.answer.row_numbers;
        if row_numbers.is_empty() {
            return Ok(None);
        }
        let ends = row_numbers.iter().map(|own| match *own {
            OfRows::One(row) => Some([row, row]),
            OfRows::Range(first, last) => Some([first, last?]),
        });
        let ends: Option<Vec<[usize; 2]>> = ends.collect();
        ends.and_then(|ends| Numbering::new(&ends)).map(Some).ok_or_else(|| {
            "row_numbers: expected rows from 1, ascending, such as 5 and [14, 36]: the number of each row of the table"
                .to_owned()
                .into()
        })
    }
}

fn refuse_any(asked: &[(&str, bool)], why: &str) -> Result<(), Refusal> {
    match asked.iter().find(|(_, is_asked)| *is_asked) {
        Some((key, _)) => Err(format!("{key} {why}").into()),
        None => Ok(()),
    }
}

/// The numbers of the rows of a table.
pub(crate) struct Numbering {
    pub(crate) numbers: RowNumbers,
    /// First and last number, and how many come before.
    runs: Vec<([usize; 2], usize)>,
}

impl Numbering {
    /// `None` unless they ascend from 1.
    fn new(ends: &[[usize; 2]]) -> Option<Self> {
        let (mut runs, mut before, mut last) = (Vec::new(), 0_usize, 0_usize);
        for &[first, end] in ends {
            if first <= last || end < first || end == usize::MAX {
                return None;
            }
            runs.push(([first, end], before));
            before += end - first + 1;
            last = end;
        }
        let numbers = ends.iter().map(|&[first, last]| first..last + 1).collect();
        Some(Numbering { numbers, runs })
    }

    /// Returns how many numbers there are up to this one.
    fn up_to(&self, number: usize) -> usize {
        let run = self.runs.partition_point(|([first, _], _)| *first <= number).checked_sub(1);
        run.map_or(0, |run| {
            let ([first, last], before) = self.runs[run];
            before + number.min(last) - first + 1
        })
    }

    /// The rows with these numbers, by their places in the table.
    ///
    /// # Errors
    /// When there is none.
    pub(crate) fn positions(&self, asked: &RowSet) -> Result<RowSet, Refusal> {
        let places = |ranges: &[RowRange]| -> Vec<RowRange> {
            let place = |range: &RowRange| {
                let (first, last) = range.ends();
                let after = last.map_or(self.numbers.len(), |last| self.up_to(last));
                RowRange::new(self.up_to(first - 1) + 1, after)
            };
            ranges.iter().filter_map(place).collect()
        };
        let named = places(asked.named());
        let is_none = named.is_empty() && !asked.named().is_empty();
        let rows = RowSet::new(&named, &places(asked.without())).filter(|_| !is_none);
        rows.ok_or_else(|| "rows: none of them is left".to_owned().into())
    }
}
