//! Exact numbers in files for programs: texts such as `"7"` and `"-3/4"`.

use serde::de::{Deserialize, Deserializer, Error};

use crate::{Limits, Rational, Reading};

/// Reads the text of a decimal without exponent, or of a fraction. It takes as much memory as its text.
///
/// ```
/// use boundfit_exact::Rational;
///
/// assert_eq!(serde_json::from_str::<Rational>(r#""-6/8""#)?, Rational::ratio(-3, 4));
/// assert!(serde_json::from_str::<Rational>("0.5").is_err());
/// # Ok::<(), serde_json::Error>(())
/// ```
impl<'de> Deserialize<'de> for Rational {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        let limits = Limits { digits: text.len(), exponent: 0 };
        Reading::Decimal.read(&text, &limits).map_err(|error| D::Error::custom(format!("{text:?}: {error}")))
    }
}
