//! Keys of an object of JSON, each taken out of it by whoever knows it.

use serde::de::DeserializeOwned;
use serde_json::{Map, Value};

use crate::refusal::Refusal;
use crate::wrong_type::wrong_type;

/// Takes a key out of an object. A key that is null is as good as one that is not there.
///
/// # Errors
/// When the value is of another type.
pub fn take_key<T: DeserializeOwned + Default>(
    object: &mut Map<String, Value>,
    key: &'static str,
) -> Result<T, Refusal> {
    match object.remove(key) {
        None | Some(Value::Null) => Ok(T::default()),
        Some(value) => serde_json::from_value(value)
            .map_err(|error| Refusal::Key { key: key.to_owned(), problem: wrong_type(&error) }),
    }
}

/// A type whose fields are keys, some of which may be those of other such types.
macro_rules! keys {
    (
        $(#[$about:meta])*
        $name:ident { $($(#[$doc:meta])* $key:literal $field:ident: $type:ty,)* }
        $(with { $($(#[$part_doc:meta])* $part:ident: $part_type:ty,)* })?
    ) => {
        $(#[$about])*
        #[derive(Debug, Clone, Default, PartialEq, Eq)]
        #[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
        pub struct $name {
            $($(#[$doc])* #[cfg_attr(feature = "schema", schemars(rename = $key, default))] pub $field: $type,)*
            $($($(#[$part_doc])* #[cfg_attr(feature = "schema", schemars(flatten))] pub $part: $part_type,)*)?
        }

        impl $name {
            /// The keys of its own.
            pub const KEYS: &'static [&'static str] = &[$($key),*];

            /// Takes its keys out of an object, and leaves the others there.
            ///
            /// # Errors
            /// With the key whose value is of another type.
            pub fn take(
                object: &mut serde_json::Map<String, serde_json::Value>,
            ) -> Result<Self, $crate::refusal::Refusal> {
                Ok($name {
                    $($field: $crate::readings::take_key(object, $key)?,)*
                    $($($part: <$part_type>::take(object)?,)*)?
                })
            }
        }
    };
}

pub(crate) use keys;
