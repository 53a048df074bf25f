//! Linear programs with at most two free columns: read from MPS and LP, solved exactly, with a proof.
//!
//! ```
//! use boundfit::judge::{Answer, ExchangeFormat, ModelLimits, read_model};
//!
//! let text = "maximize gain: 3 x + 2 y
//! subject to
//!  steel: x + y <= 4
//!  work: x + 3 y <= 9
//! bounds
//!  x <= 3
//! end
//! ";
//! let model = read_model(text, ExchangeFormat::Lp, &ModelLimits::default())?;
//! let answer = Answer::of(&model)?;
//! assert_eq!(answer.verify(&model), Ok(()));
//! let Answer::Optimal { value, face, prices, .. } = answer else { panic!("there is an optimum") };
//! assert_eq!(value.to_string(), "11");
//! assert_eq!(face.vertices, [[3.into(), 1.into()]]);
//! // One more of steel is worth 2, one more of work nothing.
//! assert_eq!(prices.rows, [2.into(), 0.into()]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub use boundfit_judge::*;
pub use boundfit_lp::{
    Bounds, End, ExchangeFormat, Model, ModelColumn, ModelError, ModelErrorKind, ModelLimits, ModelPlace,
    ModelRow, ObjectiveSense, model_text, read_model,
};
