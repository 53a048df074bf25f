//! Proofs with one change.

use boundfit_exact::{Limits, Rational, Reading};
use serde_json::{Value, json};

/// Every proof that differs from this one in one place, with what was changed.
pub fn tampered(proof: &Value) -> Vec<(String, Value)> {
    let mut all = Vec::new();
    let mut places = Vec::new();
    collect(proof, String::new(), &mut places);
    for place in places {
        let old = proof.pointer(&place).expect("a place of the proof");
        let mut add = |what: &str, new: Value| {
            let mut changed = proof.clone();
            *changed.pointer_mut(&place).expect("a place of the proof") = new;
            all.push((format!("{place}: {what}"), changed));
        };
        let more = Some(json!([element(&place)])).filter(|_| *old == json!([]));
        for new in replacements(old).into_iter().chain(more) {
            add(&format!("{old} to {new}"), new);
        }
    }
    all
}

/// Returns what a list that is empty might have had in it.
fn element(place: &str) -> Value {
    match place {
        "/conditions" => json!(["0", "0", "1"]),
        "/vertices" => json!(["0", "0"]),
        "/active" => json!([0, "1 upper"]),
        "/sides" => json!(["1 upper", null]),
        "/bounds" => json!([[], ["0", "0"], ["1", "0"]]),
        _ => json!(["1 upper", "1"]),
    }
}

/// Appends the place of every value within this one, and its own.
pub(super) fn collect(value: &Value, place: String, places: &mut Vec<String>) {
    match value {
        Value::Array(items) => {
            items
                .iter()
                .enumerate()
                .for_each(|(index, item)| collect(item, format!("{place}/{index}"), places));
        }
        Value::Object(fields) => {
            fields.iter().for_each(|(name, field)| collect(field, format!("{place}/{name}"), places));
        }
        _ => {}
    }
    places.push(place);
}

/// Values that might stand in place of this one.
pub(super) fn replacements(old: &Value) -> Vec<Value> {
    match old {
        Value::Null => vec![json!(0), json!(1), json!("1")],
        Value::Bool(value) => vec![json!(!value), json!(1)],
        Value::Number(number) => {
            // The change may have replaced an index by something else.
            let number = number.as_u64().unwrap_or(0);
            let less = number.checked_sub(1).map(|less| json!(less));
            let more = json!(number.saturating_add(1));
            [more, json!(null), json!(number as f64 + 0.5)].into_iter().chain(less).collect()
        }
        Value::String(text) => match Reading::Decimal.read(text, &Limits::default()) {
            Ok(number) => {
                let other =
                    [&number + Rational::one(), &number * Rational::ratio(1_000_001, 1_000_000), -&number];
                let other = other.into_iter().filter(|other| *other != number);
                other
                    .map(|other| json!(other.to_string()))
                    .chain([json!(format!("{text}/1")), json!(1)])
                    .collect()
            }
            Err(_) => {
                let other = [
                    "upper",
                    "lower",
                    "where:1",
                    "where:2",
                    "where:1 lower",
                    "=",
                    "theta1",
                    "theta2",
                    "decimal",
                    "binary64",
                ];
                let other = other
                    .into_iter()
                    .chain(["1 upper", "2 lower", ";", "point", "segment", "polygon", "empty", "0"]);
                other.filter(|other| other != text).map(|other| json!(other)).collect()
            }
        },
        Value::Array(items) => {
            let without = (0..items.len()).map(|index| {
                let mut items = items.clone();
                items.remove(index);
                items
            });
            let twice = items.iter().map(|item| [items.as_slice(), std::slice::from_ref(item)].concat());
            let swapped = (1..items.len()).map(|index| {
                let mut items = items.clone();
                items.swap(index - 1, index);
                items
            });
            let changed = without.chain(twice).chain(swapped).filter(|changed| changed != items);
            changed.map(Value::from).chain([json!(null)]).collect()
        }
        Value::Object(fields) => {
            let without = fields.keys().map(|name| {
                let mut fields = fields.clone();
                fields.remove(name);
                Value::from(fields)
            });
            let mut more = fields.clone();
            more.insert("more".to_owned(), json!(1));
            without.chain([Value::from(more)]).collect()
        }
    }
}
