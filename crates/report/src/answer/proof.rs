//! Proofs in a file. All numbers are exact fractions as text.

use serde::Serialize;

use crate::proof_question::ProofQuestion;

/// A proof of a fit: the feasible set and the ranges of both parameters.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ProofJson {
    /// The name and number of this schema.
    #[cfg_attr(feature = "schema", schemars(extend("const" = Self::SCHEMA)))]
    pub schema: &'static str,
    /// The question.
    #[serde(flatten)]
    pub question: ProofQuestion,
    /// The vertices θ.
    pub vertices: Vec<[String; 2]>,
    /// Every half-plane whose border passes through a vertex, with the index of the vertex from 0.
    pub active: Vec<(usize, String)>,
    /// The sides by angle, each with the index of the vertex where it meets the next one; null where it does not.
    pub sides: Vec<(String, Option<usize>)>,
    /// The terms that prove an empty set; empty for other sets.
    pub farkas: Vec<MultipleJson>,
    /// The ends of θ1 and of θ2, lower before upper; empty for an empty set.
    pub bounds: Vec<EndProofJson>,
}

/// The name of a half-plane and its multiplier.
pub type MultipleJson = (String, String);
/// A pair of exact numbers.
pub type VectorJson = [String; 2];
/// Multipliers, a point and a ray. At a finite end the ray is zero; where there is no end, there are no multipliers.
pub type EndProofJson = (Vec<MultipleJson>, VectorJson, VectorJson);

/// A proof of statements, each about the set of some of the rows.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct StatementsJson<'a> {
    /// The name and number of this schema.
    #[cfg_attr(feature = "schema", schemars(extend("const" = StatementsJson::SCHEMA)))]
    pub schema: &'static str,
    /// The question.
    #[serde(flatten)]
    pub question: &'a ProofQuestion,
    /// The statements.
    pub statements: Vec<StatementJson<'a>>,
}

/// A statement about the set of its scope.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct StatementJson<'a> {
    /// The kind of the statement.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = ["form", "point", "empty", "least", "set", "left out"])))]
    pub kind: &'static str,
    /// The scope.
    #[serde(flatten)]
    pub scope: ScopeJson,
    /// The claim.
    #[serde(flatten)]
    pub claim: &'a StatedJson,
}

/// The rows, conditions and errors that a statement is about; what is absent is as asked.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ScopeJson {
    /// First and last row of each range, one after the other.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rows: Option<Vec<usize>>,
    /// The rows that are left out.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub without: Vec<usize>,
    /// The numbers of the conditions that hold, from 1.
    #[serde(rename = "where", skip_serializing_if = "Option::is_none")]
    pub conditions: Option<Vec<usize>>,
    /// The factor on the error bounds.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub factor: Option<String>,
    /// The bound that takes the place of the error bounds.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub epsilon: Option<String>,
    /// The part of the set, with errors in x.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(extend("enum" = ["+", "-", "strong"])))]
    pub side: Option<&'static str>,
}

/// The claim of a statement.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(untagged)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum StatedJson {
    /// The range of a linear form.
    Form {
        /// The coefficients of the form.
        form: VectorJson,
        /// The lower end.
        lower: EndProofJson,
        /// The upper end.
        upper: EndProofJson,
    },
    /// The least errors that leave something.
    Least {
        /// A point that they leave.
        point: VectorJson,
        /// The terms that prove that smaller errors leave nothing.
        multipliers: Vec<MultipleJson>,
    },
    /// The walk around the set.
    Set {
        /// A point of the set.
        point: VectorJson,
        /// The vertices.
        vertices: Vec<VectorJson>,
        /// The sides by angle, each with the index of the vertex where it meets the next one; null where it does not.
        sides: Vec<(String, Option<usize>)>,
    },
    /// A point of the set.
    Point {
        /// The point.
        point: VectorJson,
    },
    /// An empty set.
    Empty {
        /// The terms that prove it.
        multipliers: Vec<MultipleJson>,
    },
    /// The least number of rows to leave out.
    LeftOut {
        /// The number of rows.
        least: usize,
        /// All sets of so many rows without which something is left; absent where they are not stated.
        #[serde(skip_serializing_if = "Option::is_none")]
        sets: Option<Vec<Vec<usize>>>,
        /// Sets of rows that are left out, each with terms that prove that the rest contradicts itself.
        contradictions: Vec<(Vec<usize>, Vec<MultipleJson>)>,
    },
}

impl StatedJson {
    /// The kind of the statement.
    pub fn kind(&self) -> &'static str {
        match self {
            StatedJson::Form { .. } => "form",
            StatedJson::Least { .. } => "least",
            StatedJson::Set { .. } => "set",
            StatedJson::Point { .. } => "point",
            StatedJson::Empty { .. } => "empty",
            StatedJson::LeftOut { .. } => "left out",
        }
    }
}
