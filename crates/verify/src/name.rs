//! The names of half-planes.

use std::fmt;

use boundfit_exact::Foreign;
use serde::{Deserialize, Deserializer};

/// A half-plane of the data or of a condition.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Name {
    /// φ·θ ≤ the upper bound of this row, from 1: `14 upper`.
    Upper(u64),
    /// φ·θ ≥ the lower bound of this row: `14 lower`.
    Lower(u64),
    /// The inequality that is this condition, from 1: `where:1`.
    Where(u64),
    /// a·θ ≤ b of the equation that is this condition: `where:1 upper`.
    WhereUpper(u64),
    /// a·θ ≥ b of that equation: `where:1 lower`.
    WhereLower(u64),
    /// The upper bound of this row at an end of what its x may be: `14 upper +`, `14 upper -`.
    UpperAt(u64, End),
    /// The lower bound of this row at an end of its possible x: `14 lower +`, `14 lower -`.
    LowerAt(u64, End),
    /// The sign of θ1 on one side of 0: `side`.
    Side,
}

/// An end of what an x may be when it has an error.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum End {
    /// The lower one: `-`.
    Lower,
    /// The upper one: `+`.
    Upper,
}

impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Name::Upper(row) => write!(f, "{row} upper"),
            Name::Lower(row) => write!(f, "{row} lower"),
            Name::Where(number) => write!(f, "where:{number}"),
            Name::WhereUpper(number) => write!(f, "where:{number} upper"),
            Name::WhereLower(number) => write!(f, "where:{number} lower"),
            Name::UpperAt(row, end) => write!(f, "{row} upper {}", end.sign()),
            Name::LowerAt(row, end) => write!(f, "{row} lower {}", end.sign()),
            Name::Side => f.write_str("side"),
        }
    }
}

impl End {
    fn sign(self) -> char {
        match self {
            End::Lower => '-',
            End::Upper => '+',
        }
    }
}

impl Name {
    /// The row that it is a bound of, from 1; `None` where it is none of a row.
    pub(crate) fn row(self) -> Option<u64> {
        match self {
            Name::Upper(row) | Name::Lower(row) | Name::UpperAt(row, _) | Name::LowerAt(row, _) => Some(row),
            Name::Where(_) | Name::WhereUpper(_) | Name::WhereLower(_) | Name::Side => None,
        }
    }

    /// The half-plane of this very name; `None` for a text that is no name.
    fn parse(text: &str) -> Option<Self> {
        if text == "side" {
            return Some(Name::Side);
        }
        let (is_condition, rest) = match text.strip_prefix("where:") {
            Some(rest) => (true, rest),
            None => (false, text),
        };
        let (number, side) = rest.split_once(' ').map_or((rest, None), |(number, side)| (number, Some(side)));
        // One text for each name: 07 and +7 are not row 7.
        if !number.bytes().all(|byte| byte.is_ascii_digit()) || number.starts_with('0') {
            return None;
        }
        let number = number.parse().ok()?;
        Some(match (is_condition, side) {
            (false, Some("upper")) => Name::Upper(number),
            (false, Some("lower")) => Name::Lower(number),
            (true, None) => Name::Where(number),
            (true, Some("upper")) => Name::WhereUpper(number),
            (true, Some("lower")) => Name::WhereLower(number),
            (false, Some("upper +")) => Name::UpperAt(number, End::Upper),
            (false, Some("upper -")) => Name::UpperAt(number, End::Lower),
            (false, Some("lower +")) => Name::LowerAt(number, End::Upper),
            (false, Some("lower -")) => Name::LowerAt(number, End::Lower),
            _ => return None,
        })
    }
}

/// The name of a half-plane as it stands in a proof, where any text may stand.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Named {
    A(Name),
    NoHalfPlane(Foreign),
}

impl<'de> Deserialize<'de> for Named {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Text;
        impl serde::de::Visitor<'_> for Text {
            type Value = Named;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("the name of a half-plane")
            }

            fn visit_str<E>(self, text: &str) -> Result<Named, E> {
                Ok(Name::parse(text).map_or_else(|| Named::NoHalfPlane(Foreign::from(text)), Named::A))
            }
        }
        deserializer.deserialize_str(Text)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_half_plane_has_one_name() {
        for text in [
            "1 upper",
            "14 lower",
            "where:1",
            "where:2 upper",
            "where:30 lower",
            "14 upper +",
            "14 upper -",
            "7 lower +",
            "7 lower -",
            "side",
            "18446744073709551615 upper",
        ] {
            assert_eq!(Name::parse(text).map(|name| name.to_string()).as_deref(), Some(text));
        }
        for text in [
            "",
            "1",
            "01 upper",
            "0 upper",
            "+1 upper",
            " 1 upper",
            "1 upper ",
            "1  upper",
            "1 Upper",
            "where:0",
            "where:",
            "where:1 ",
            "where: 1",
            "18446744073709551616 upper",
            "1\tupper",
            "upper",
            "1 upper  +",
            "1 upper+",
            "1 +",
            "where:1 upper +",
            "Side",
        ] {
            assert_eq!(Name::parse(text), None, "{text}");
        }
    }
}
