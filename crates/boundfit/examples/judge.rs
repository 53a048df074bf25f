//! Solves a linear program exactly and judges the answer that a solver has printed.
//!
//! ```sh
//! cargo run -p boundfit --example judge --features judge
//! ```
#![expect(clippy::print_stdout, reason = "an example for people at a terminal")]

use std::error::Error;

use boundfit::judge::{
    Answer, ExchangeFormat, Ground, ModelLimits, Solution, Tolerances, read_model, read_solution,
};
use boundfit::{Rational, engine::exact::Limits};

/// A shop has 4 t of steel and 9 h of work.
const MODEL: &str = "\
maximize gain: 3 x + 2 y
subject to
 steel: x + y <= 4
 work: x + 3 y <= 9
bounds
 x <= 3
end
";

/// The columns as CBC prints them: y is off by a millionth.
const SOLUTION: &str = "\
Optimal - objective value 11.00000000
      0 x                      3                       1
      1 y               1.000001                       0
";

fn main() -> Result<(), Box<dyn Error>> {
    let model = read_model(MODEL, ExchangeFormat::Lp, &ModelLimits::default())?;
    let answer = Answer::of(&model)?;
    if let Answer::Optimal { value, face, prices, .. } = &answer {
        println!("optimum {value}");
        for vertex in &face.vertices {
            println!("  at ({}, {})", vertex[0], vertex[1]);
        }
        println!("  a tonne more of steel gains {}, an hour more of work {}", prices.rows[0], prices.rows[1]);
    }
    println!("proof holds: {}", answer.verify(&model).is_ok());

    let solution = Solution::new(&read_solution(SOLUTION, &Limits::default())?, &model)?;
    let tolerances = Tolerances { relative: Rational::ratio(1, 1_000_000_000), digits_as_printed: true };
    println!("what the solver printed:");
    for finding in Ground::new(&model, &answer).judge(&solution, &tolerances).findings {
        println!("  {}: {}", finding.aspect.name(), finding.worth.name());
    }
    Ok(())
}
