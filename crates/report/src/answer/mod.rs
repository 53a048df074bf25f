//! The answers as data: the types of which every JSON document consists, one file per question.
//!
//! A document is written from these types alone. With the feature `schema` they describe themselves: `documents` lists the JSON
//! Schema of every document. `cargo xtask generate` makes `schema`, the declarations for TypeScript and Python, and the reference in
//! docs from it. The sentence on each field says what it means, whether it is exact or rounded, and when it is null.
//!
//! Numbers are [`Number`](crate::Number)s. A field that stands in every document of its kind is never left out; one that may be
//! absent says so.

pub(crate) mod check;
#[cfg(feature = "schema")]
mod documents;
pub(crate) mod fit;
pub(crate) mod input;
pub(crate) mod judge;
pub(crate) mod linearity;
pub(crate) mod next_reading;
pub(crate) mod outliers;
pub(crate) mod parts;
#[cfg(feature = "files")]
pub(crate) mod polygon;
pub(crate) mod predict;
#[cfg(feature = "files")]
pub(crate) mod proof;
pub(crate) mod range;
pub(crate) mod status;
pub(crate) mod sweep;
pub(crate) mod table;
pub(crate) mod verify;
pub(crate) mod window;
#[cfg(feature = "schema")]
pub(crate) mod words;
pub(crate) mod x_errors;

pub use check::*;
#[cfg(feature = "schema")]
pub use documents::{DocumentSchema, documents};
pub use fit::*;
pub use input::*;
pub use judge::*;
pub use linearity::*;
pub use next_reading::*;
pub use outliers::*;
pub use parts::*;
#[cfg(feature = "files")]
pub use polygon::*;
pub use predict::*;
#[cfg(feature = "files")]
pub use proof::*;
pub use range::*;
pub use status::*;
pub use sweep::*;
pub use table::*;
pub use verify::*;
pub use window::*;
pub use x_errors::*;

/// Names the schema that a document has: `boundfit/NAME/N`. N rises when the bytes of the document change their meaning.
macro_rules! schemas {
    ($($(#[$attribute:meta])* $document:ty => $schema:literal)*) => {
        $($(#[$attribute])* impl $document {
            /// The name and number of the schema of this document.
            pub const SCHEMA: &'static str = $schema;
        })*
    };
}

schemas! {
    FitJson => "boundfit/fit/2"
    XErrorJson => "boundfit/x-errors/2"
    GroupJson<'_> => "boundfit/fleet/2"
    WindowJson<'_> => "boundfit/window/1"
    LinearRangeJson => "boundfit/range/1"
    OutliersJson => "boundfit/outliers/1"
    StatusesJson => "boundfit/status/1"
    PredictionJson => "boundfit/predict/1"
    NextReadingJson => "boundfit/next/1"
    LinearityJson => "boundfit/linearity/1"
    #[cfg(feature = "files")] PolygonJson => "boundfit/polygon/2"
    CheckJson<'_> => "boundfit/check/2"
    JudgeJson => "boundfit/judge/1"
    VerifyJson<'_> => "boundfit/verify/1"
    #[cfg(feature = "files")] ProofJson => "boundfit/proof/1"
    #[cfg(feature = "files")] StatementsJson<'_> => "boundfit/proof/2"
}
