//! The names of keys on each surface.

use boundfit_formats::Way;

/// The names by which a surface calls its keys.
pub trait Surface {
    /// A key: an option, a keyword, a key of an object.
    fn key(&self, key: &str) -> String;

    /// A value of a key, before what is wrong with it.
    fn value(&self, key: &str, text: &str) -> String;

    /// A way out: a setting, and what it does.
    fn way(&self, way: &Way) -> String;
}
