//! Linear programs from elsewhere.

use boundfit_exact::{Foreign, Limits};
use boundfit_lp::{ExchangeFormat, Model, ModelLimits, model_text, read_model};

/// A text is refused in either format, or what it states is written in both and read back equal.
pub fn model_files(data: &[u8]) {
    let Ok(text) = model_text(data) else { return };
    for format in ExchangeFormat::ALL {
        let limits = ModelLimits { number: Limits { digits: 300, exponent: 300 }, ..ModelLimits::default() };
        match read_model(text, format, &limits) {
            Ok(model) => check_written(&model),
            Err(error) => assert!(!error.to_string().is_empty()),
        }
    }
}

fn check_written(model: &Model) {
    // A difference of two numbers has the digits of both, and a scale those of many.
    let number = Limits { digits: 1_000_000, exponent: 10_000 };
    for format in ExchangeFormat::ALL {
        let text = model.text(format);
        let back = read_model(&text, format, &ModelLimits { number, ..ModelLimits::default() });
        let mut remarks = text.lines().take_while(|line| line.starts_with(['*', '\\']));
        let equivalent = [" is multiplied by ", " are those of "];
        if !remarks.any(|line| equivalent.iter().any(|remark| line.contains(remark))) {
            let back = back.unwrap_or_else(|error| panic!("{error}\n{text}"));
            assert_eq!(without_names(&back), without_names(model), "{text}");
        }
    }
}

/// The program without names: not every name is one in every format.
fn without_names(model: &Model) -> Model {
    let mut model = Model { name: Foreign::default(), objective_name: Foreign::default(), ..model.clone() };
    model.columns.iter_mut().for_each(|column| column.name = Foreign::default());
    model.rows.iter_mut().for_each(|row| row.name = Foreign::default());
    model
}
