//! The shape of a JSON report, from a template that reads like the report.

use serde_json::Value;

/// The keys that `boundfit fit --format json` promises. `text`, `count`, `flag` and `number` stand for values. A key
/// with `?` may be null, and a key in brackets may be absent. A list of one stands for any number of such items, a
/// list of two for exactly two.
pub const FIT: &str = r#"{
  "schema": "text",
  "program": {"name": "text", "version": "text"},
  "input": {"file?": "text", "rows": "count", "rows_total": "count", "reading": "text", "sha256": "text"},
  "least_squares?": {"theta": ["number", "number"], "in_fps": "flag"},
  "eui?": [{"lower": "number", "upper": "number"}, {"lower": "number", "upper": "number"}],
  "fps": {
    "kind": "text",
    "vertices": [{"theta": ["number", "number"], "active": [{"row?": "count", "bound": "text"}]}],
    "rays": [["number", "number"]],
    "lines": [["number", "number"]],
    "witness?": ["number", "number"],
    "area?": "number",
    "certificate?": {"farkas": [{"row?": "count", "bound": "text", "multiplier": "number"}]}
  },
  "pui?": [
    {"lower": {"exact?": "text", "decimal?": "text", "active": [{"row?": "count", "bound": "text", "multiplier": "number"}]},
     "upper": {"exact?": "text", "decimal?": "text", "active": [{"row?": "count", "bound": "text", "multiplier": "number"}]}},
    {"lower": {"exact?": "text", "decimal?": "text", "active": [{"row?": "count", "bound": "text", "multiplier": "number"}]},
     "upper": {"exact?": "text", "decimal?": "text", "active": [{"row?": "count", "bound": "text", "multiplier": "number"}]}}
  ],
  "central?": {"theta": ["number", "number"], "guaranteed_error": ["number", "number"]},
  "slopes?": {
    "largest?": {"theta": ["number", "number"], "active": [{"row?": "count", "bound": "text"}]},
    "smallest?": {"theta": ["number", "number"], "active": [{"row?": "count", "bound": "text"}]}
  },
  "epsilon_min?": "number",
  "mended_without?": ["count"],
  "inverse?": {
    "gain": {
      "exact_range": [{"lower?": "number", "upper?": "number"}],
      "box_range": [{"lower?": "number", "upper?": "number"}],
      "central?": "number", "least_squares?": "number"},
    "offset": {
      "exact_range": [{"lower?": "number", "upper?": "number"}],
      "box_range": [{"lower?": "number", "upper?": "number"}],
      "central?": "number", "least_squares?": "number"}
  }
}"#;

/// The keys that `boundfit polygon --format json` promises.
pub const POLYGON: &str = r#"{
  "schema": "text",
  "input": {"file?": "text", "rows": "count", "reading": "text", "sha256": "text"},
  "region": {
    "kind": "text",
    "vertices": [{"theta": ["number", "number"], "active": ["count"]}],
    "rays": [["number", "number"]],
    "lines": [["number", "number"]],
    "witness?": ["number", "number"],
    "area?": "number",
    "certificate?": {"farkas": [{"row": "count", "bound": "text", "multiplier": "number"}]}
  },
  "redundant": ["count"],
  "bounds?": [
    {"lower": {"exact?": "text", "decimal?": "text", "active": [{"row": "count", "bound": "text", "multiplier": "number"}]},
     "upper": {"exact?": "text", "decimal?": "text", "active": [{"row": "count", "bound": "text", "multiplier": "number"}]}},
    {"lower": {"exact?": "text", "decimal?": "text", "active": [{"row": "count", "bound": "text", "multiplier": "number"}]},
     "upper": {"exact?": "text", "decimal?": "text", "active": [{"row": "count", "bound": "text", "multiplier": "number"}]}}
  ]
}"#;

/// The keys that `boundfit judge --format json` promises.
pub const JUDGE: &str = r#"{
  "schema": "text",
  "input": {"file?": "text", "sha256": "text", "name": "text", "sense": "text", "objective": "text", "constant": "number"},
  "status": "text",
  "objective?": "number",
  "face?": {"vertices": [["number"]], "points": [["number"]], "rays": [["number"]], "lines": [["number"]]},
  "columns": [
    {"name": "text", "lower?": "number", "upper?": "number", "cost": "number", "value?": "number",
     "reduced_cost?": "number", "basis?": "text"}
  ],
  "rows": [
    {"name": "text", "lower?": "number", "upper?": "number", "value?": "number", "dual?": "number", "basis?": "text"}
  ],
  "farkas?": [{"row?": "text", "column?": "text", "side": "text", "multiplier": "number"}],
  "point?": ["number"],
  "ray?": ["number"],
  "plane": {
    "columns": ["text"],
    "region": {
      "kind": "text",
      "vertices": [{"theta": ["number", "number"], "active": [{"row?": "text", "column?": "text", "side": "text"}]}],
      "rays": [["number", "number"]],
      "lines": [["number", "number"]],
      "witness?": ["number", "number"],
      "area?": "number"
    },
    "ranges?": [{"lower?": "number", "upper?": "number"}]
  }
}"#;

/// Checks that a report has every key of a template, with the type that stands there. A key that may be absent has
/// the type wherever it is present, and is not null. It may have more keys.
pub fn check_schema(report: &Value, template: &str) {
    check(report, &serde_json::from_str(template).unwrap(), "report");
}

fn check(value: &Value, template: &Value, path: &str) {
    match template {
        Value::Object(fields) => {
            for (key, template) in fields {
                let optional = key.strip_prefix('[').and_then(|key| key.strip_suffix(']'));
                let nullable = key.strip_suffix('?');
                let name = optional.or(nullable).unwrap_or(key);
                let path = format!("{path}.{name}");
                match value.get(name) {
                    None => assert!(optional.is_some(), "{path} is missing"),
                    Some(Value::Null) if nullable.is_some() => {}
                    Some(value) => check(value, template, &path),
                }
            }
        }
        Value::Array(templates) => {
            let items = value.as_array().unwrap_or_else(|| panic!("{path} is not a list: {value}"));
            assert!(templates.len() == 1 || templates.len() == items.len(), "{path}: {value}");
            for (index, (item, template)) in items.iter().zip(templates.iter().cycle()).enumerate() {
                check(item, template, &format!("{path}[{index}]"));
            }
        }
        template => {
            let fits = match template.as_str().unwrap() {
                "text" => value.is_string(),
                "count" => value.is_u64(),
                "flag" => value.is_boolean(),
                "number" => value["exact"].is_string() && value["decimal"].is_string(),
                other => panic!("{other} in the template"),
            };
            assert!(fits, "{path} is not a {template}: {value}");
        }
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn what_may_be_absent_may_not_be_null() {
        let check = |report: Value| std::panic::catch_unwind(|| check_schema(&report, TEMPLATE)).is_ok();
        const TEMPLATE: &str = r#"{"here": "count", "null?": "count", "[absent]": "count"}"#;
        assert!(check(json!({"here": 1, "null": null})));
        assert!(check(json!({"here": 1, "null": 2, "absent": 3})));
        for wrong in [
            json!({"null": null}),
            json!({"here": null, "null": null}),
            json!({"here": 1}),
            json!({"here": 1, "null": null, "absent": null}),
            json!({"here": 1, "null": null, "absent": "3"}),
        ] {
            assert!(!check(wrong.clone()), "{wrong}");
        }
    }
}
