//! CPLEX's LP format.

mod program;
mod token;

use super::ModelLimits;
use super::bounds::Extended;
use super::error::{ModelError, ModelErrorKind};
use super::text::{Field, Line};
use crate::claim::End;
use crate::model::{Model, ObjectiveSense};

use program::Program;
pub(crate) use token::ends_name;
use token::{Kind, Token, Tokens, tokens};

/// Reads a program.
pub(super) fn read(text: &str, limits: &ModelLimits) -> Result<Model, ModelError> {
    read_as_cplex(text, limits).map_err(|error| match error.kind {
        ModelErrorKind::Unexpected(_) if is_of_lp_solve(text) => {
            ModelError { kind: ModelErrorKind::LpSolve, ..error }
        }
        _ => error,
    })
}

/// Returns whether a text begins like one of lp_solve, which has a format of its own.
fn is_of_lp_solve(text: &str) -> bool {
    let start = text.trim_start();
    let word = start.split([':', ';']).next().unwrap_or_default().trim_end();
    let is_sense = SENSES.iter().any(|(_, words)| words.iter().any(|own| own.eq_ignore_ascii_case(word)));
    text.contains(';') && (is_sense || start.starts_with("/*") || start.starts_with("//"))
}

fn read_as_cplex(text: &str, limits: &ModelLimits) -> Result<Model, ModelError> {
    let mut reader = Reader { tokens: tokens(text, limits), program: Program::new(limits), limits };
    reader.objective()?;
    loop {
        match reader.heading()? {
            Section::Rows => reader.rows()?,
            Section::Bounds => reader.bounds()?,
            Section::Integers => reader.nothing_in(ModelErrorKind::Integer)?,
            Section::SemiContinuous => reader.nothing_in(ModelErrorKind::SemiContinuous)?,
            Section::Sets => reader.nothing_in(ModelErrorKind::NotLinear)?,
            Section::End => return reader.program.finish(),
        }
    }
}

/// A part of the file after the objective.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Section {
    Rows,
    Bounds,
    Integers,
    SemiContinuous,
    Sets,
    End,
}

/// The words that begin an objective.
const SENSES: [(ObjectiveSense, &[&str]); 2] = [
    (ObjectiveSense::Minimize, &["min", "minimize", "minimise", "minimum"]),
    (ObjectiveSense::Maximize, &["max", "maximize", "maximise", "maximum"]),
];

/// The words that begin the other sections; `subject to` and `such that` have two.
const SECTIONS: [(Section, &[&str]); 6] = [
    (Section::Rows, &["st", "s.t.", "st."]),
    (Section::Bounds, &["bounds", "bound"]),
    (
        Section::Integers,
        &["general", "generals", "gen", "integer", "integers", "int", "binary", "binaries", "bin"],
    ),
    (Section::SemiContinuous, &["semi", "semis"]),
    (Section::Sets, &["sos", "sos1", "sos2"]),
    (Section::End, &["end"]),
];

/// Returns whether a name would be read as a keyword.
pub(crate) fn is_keyword(name: &str) -> bool {
    let senses = SENSES.iter().flat_map(|(_, words)| *words);
    let sections = SECTIONS.iter().flat_map(|(_, words)| *words);
    let others = ["subject", "such", "free", "inf", "infinity"];
    senses.chain(sections).chain(&others).any(|word| word.eq_ignore_ascii_case(name))
}

const A_TERM: &str = "a term such as 3 x";
const A_RELATION: &str = "+, - or one of <=, >= and =";
const A_ROW: &str = "one number on the right side, and the next row on a line of its own";
const A_BOUND: &str = "a bound on a line of its own: x <= 3, -inf <= x <= 3, x = 3 or x free";
const A_RANGE: &str = "<= on both sides, as in 1 <= x <= 2, or >= on both";
const A_NUMBER: &str = "a number; variables belong to the left side";

struct Reader<'a, I> {
    tokens: Tokens<'a, I>,
    program: Program<'a>,
    limits: &'a ModelLimits,
}

/// A term of an expression.
struct Term<'a> {
    is_negative: bool,
    number: Option<Field<'a>>,
    name: Option<Field<'a>>,
}

/// A number with its place.
struct Value<'a> {
    value: Extended,
    field: Field<'a>,
}

fn unexpected(token: Token<'_>, expected: &'static str) -> ModelError {
    token.field.error(match token.kind {
        Kind::Quadratic if token.field.text == "*" => ModelErrorKind::Times,
        Kind::Quadratic => ModelErrorKind::Quadratic,
        Kind::Arrow => ModelErrorKind::NotLinear,
        _ => ModelErrorKind::Unexpected(expected),
    })
}

impl<'a, I: Iterator<Item = Result<Line<'a>, ModelError>>> Reader<'a, I> {
    /// The sense, perhaps a name, and the form.
    fn objective(&mut self) -> Result<(), ModelError> {
        let first = self.tokens.next()?;
        let sense = SENSES.iter().find(|(_, words)| first.is_word(words));
        let Some((sense, _)) = sense else {
            return Err(first
                .field
                .error(ModelErrorKind::Unexpected("minimize or maximize, then the objective")));
        };
        self.program.sense = *sense;
        if let Some(name) = self.name()? {
            self.program.objective_name = name.text;
        }
        let mut is_first = true;
        while self.section()?.is_none() {
            let Term { is_negative, number, name } = self.term(is_first)?;
            self.program.add_cost(is_negative, number, name)?;
            is_first = false;
        }
        Ok(())
    }

    /// A name with a colon behind it.
    fn name(&mut self) -> Result<Option<Field<'a>>, ModelError> {
        match (self.tokens.peek(0)?, self.tokens.peek(1)?) {
            (Some(word), Some(colon)) if word.kind == Kind::Word && colon.kind == Kind::Colon => {
                self.tokens.next()?;
                self.tokens.next()?;
                Ok(Some(word.field))
            }
            _ => Ok(None),
        }
    }

    /// The section that begins here, and how many words its name has.
    fn section(&mut self) -> Result<Option<(Section, usize)>, ModelError> {
        let Some(word) = self.tokens.peek(0)? else { return Ok(None) };
        if word.kind != Kind::Word {
            return Ok(None);
        }
        let second = self.tokens.peek(1)?;
        if second.is_some_and(|second| second.kind == Kind::Colon) {
            return Ok(None);
        }
        let is_pair = |first: &str, then: &str| {
            word.is_word(&[first]) && second.is_some_and(|second| second.is_word(&[then]))
        };
        if is_pair("subject", "to") || is_pair("such", "that") {
            return Ok(Some((Section::Rows, 2)));
        }
        let known = SECTIONS.iter().find(|(_, words)| word.is_word(words)).map(|(section, _)| *section);
        let third = self.tokens.peek(2)?;
        let is_long = known == Some(Section::SemiContinuous)
            && second.is_some_and(|second| second.kind == Kind::Minus)
            && third.is_some_and(|third| third.is_word(&["continuous"]));
        Ok(known.map(|section| (section, if is_long { 3 } else { 1 })))
    }

    /// The beginning of a section, which is passed.
    fn heading(&mut self) -> Result<Section, ModelError> {
        let Some((section, words)) = self.section()? else {
            let token = self.tokens.next()?;
            return Err(unexpected(token, "subject to, bounds or end"));
        };
        for _ in 0..words {
            self.tokens.next()?;
        }
        Ok(section)
    }

    /// A section in which a linear program has nothing.
    fn nothing_in(&mut self, kind: ModelErrorKind) -> Result<(), ModelError> {
        match self.section()? {
            Some(_) => Ok(()),
            None => Err(self.tokens.next()?.field.error(kind)),
        }
    }

    /// A term: signs, a number, a variable; the first one of an expression needs no sign.
    fn term(&mut self, is_first: bool) -> Result<Term<'a>, ModelError> {
        let (is_negative, signs) = self.signs()?;
        let token = self.tokens.next()?;
        if signs == 0 && !is_first {
            return Err(unexpected(token, A_RELATION));
        }
        let number = (token.kind == Kind::Number).then_some(token.field);
        let word = match number {
            None => Some(token),
            Some(_) => self.tokens.peek(0)?.filter(|next| next.kind == Kind::Word),
        };
        // A keyword may follow a number, but is no variable.
        let is_variable = |word: &Token<'_>| word.kind == Kind::Word && !is_keyword(word.field.text);
        match (number, word.filter(is_variable)) {
            (None, None) => Err(unexpected(token, A_TERM)),
            (Some(_), Some(_)) => {
                let name = Some(self.tokens.next()?.field);
                Ok(Term { is_negative, number, name })
            }
            (number, word) => Ok(Term { is_negative, number, name: word.map(|word| word.field) }),
        }
    }

    /// Signs, which are passed: whether they make a minus, and how many they are.
    fn signs(&mut self) -> Result<(bool, usize), ModelError> {
        let (mut is_negative, mut count) = (false, 0);
        while let Some(sign) = self.tokens.peek(0)?.filter(|token| token.kind.is_sign()) {
            is_negative ^= sign.kind == Kind::Minus;
            count += 1;
            self.tokens.next()?;
        }
        Ok((is_negative, count))
    }

    /// A number or an infinity, with signs.
    fn value(&mut self) -> Result<Value<'a>, ModelError> {
        let (is_negative, _) = self.signs()?;
        let token = self.tokens.next()?;
        if token.kind != Kind::Number && !token.is_infinity() {
            return Err(unexpected(token, A_NUMBER));
        }
        let value = token.field.extended(self.limits)?;
        Ok(Value { value: if is_negative { value.negated() } else { value }, field: token.field })
    }

    /// Returns whether a number and a relation come next.
    fn begins_with_value(&mut self) -> Result<bool, ModelError> {
        let mut place = 0;
        while self.tokens.peek(place)?.is_some_and(|token| token.kind.is_sign()) {
            place += 1;
        }
        let is_value = |token: Token<'_>| token.kind == Kind::Number || token.is_infinity();
        Ok(self.tokens.peek(place)?.is_some_and(is_value)
            && self.tokens.peek(place + 1)?.is_some_and(|token| token.kind.is_relation()))
    }

    /// The relation that comes next, which is passed.
    fn relation(&mut self) -> Result<Option<Token<'a>>, ModelError> {
        let relation = self.tokens.peek(0)?.filter(|token| token.kind.is_relation());
        if relation.is_some() {
            self.tokens.next()?;
        }
        Ok(relation)
    }

    fn rows(&mut self) -> Result<(), ModelError> {
        while self.section()?.is_none() {
            let Some(first) = self.tokens.peek(0)? else { return Err(self.tokens.end()) };
            let name = self.name()?;
            self.program.begin_row(name, first.field)?;
            self.row(name.is_some())?;
        }
        Ok(())
    }

    /// Reads what stands behind the name of a row: `3 x + y <= 2` or `1 <= 3 x + y <= 2`. Solvers write a row without terms as
    /// `<= 2`, with a name in front.
    fn row(&mut self, is_named: bool) -> Result<(), ModelError> {
        let left = self.left_side()?;
        let may_be_empty = is_named && left.is_none();
        let mut is_first = true;
        let right = loop {
            if (!is_first || may_be_empty)
                && let Some(relation) = self.relation()?
            {
                break (relation, self.value()?);
            }
            let Term { is_negative, number, name } = self.term(is_first)?;
            self.program.add_entry(is_negative, number, name)?;
            is_first = false;
        };
        for (side, value) in sides(left, Some(right))? {
            self.program.set_side(side, value);
        }
        self.end_of_line(A_ROW)
    }

    /// A number and a relation, where they come next.
    fn left_side(&mut self) -> Result<Option<(Token<'a>, Value<'a>)>, ModelError> {
        if !self.begins_with_value()? {
            return Ok(None);
        }
        let value = self.value()?;
        Ok(Some((self.tokens.next()?, value)))
    }

    /// Returns whether a row or a bound ends here.
    fn end_of_line(&mut self, expected: &'static str) -> Result<(), ModelError> {
        let before = self.tokens.passed;
        let is_section = self.section()?.is_some();
        match self.tokens.peek(0)? {
            Some(token) if token.field.line.number == before && !is_section => {
                Err(unexpected(token, expected))
            }
            _ => Ok(()),
        }
    }

    /// Lines such as `x free`, `x <= 3`, `1 <= x`, `-inf <= x <= 3` and `x = 3`.
    fn bounds(&mut self) -> Result<(), ModelError> {
        while self.section()?.is_none() {
            let left = self.left_side()?;
            let name = self.tokens.next()?;
            if name.kind != Kind::Word || is_keyword(name.field.text) {
                return Err(unexpected(name, A_BOUND));
            }
            let column = self.program.bounded_column(name.field)?;
            let is_free =
                left.is_none() && self.tokens.peek(0)?.is_some_and(|token| token.is_word(&["free"]));
            let right = match self.relation()? {
                Some(relation) => Some((relation, self.value()?)),
                None => None,
            };
            if is_free {
                self.tokens.next()?;
                self.program.set_bound(column, End::Lower, Extended::none(End::Lower));
                self.program.set_bound(column, End::Upper, Extended::none(End::Upper));
            } else if left.is_none() && right.is_none() {
                return Err(unexpected(self.tokens.next()?, A_BOUND));
            }
            for (side, value) in sides(left, right)? {
                self.program.set_bound(column, side, value);
            }
            self.end_of_line(A_BOUND)?;
        }
        Ok(())
    }
}

/// Returns what the numbers on the left and on the right of a form say about it.
fn sides<'a>(
    left: Option<(Token<'a>, Value<'a>)>,
    right: Option<(Token<'a>, Value<'a>)>,
) -> Result<Vec<(End, Extended)>, ModelError> {
    let is_range = left.is_some() && right.is_some();
    let mut sides: Vec<(End, Extended)> = Vec::new();
    for (is_left, (relation, Value { value, field })) in
        left.map(|side| (true, side)).into_iter().chain(right.map(|side| (false, side)))
    {
        let stated: &[End] = match relation.kind {
            Kind::Equal if is_range => &[],
            Kind::Equal => &[End::Lower, End::Upper],
            kind if (kind == Kind::AtMost) == is_left => &[End::Lower],
            _ => &[End::Upper],
        };
        if stated.is_empty() || sides.iter().any(|(side, _)| stated.contains(side)) {
            return Err(relation.field.error(ModelErrorKind::Unexpected(A_RANGE)));
        }
        for side in stated {
            if value == Extended::impossible(*side) {
                return Err(field.error(ModelErrorKind::Impossible(side.name())));
            }
            sides.push((*side, value.clone()));
        }
    }
    Ok(sides)
}
