//! Fits a line to readings of a transducer and proves every end of the answer.
//!
//! ```sh
//! cargo run -p boundfit --example fit
//! ```
#![expect(clippy::print_stdout, reason = "an example for people at a terminal")]

use boundfit::{Error, Observations, Rounding};

fn main() -> Result<(), Error> {
    // Positions in metres, set to within half a millimetre, and the voltages that were read.
    let voltages = ["-4.8248", "-3.1966", "-1.4082", "0.4051", "2.2189", "4.0117"];
    let positions = ["0.014", "0.017", "0.020", "0.0235", "0.0268", "0.030"];
    let problem = Observations::line(&voltages, &positions)?.error_bound("0.5e-3")?;
    let fit = problem.fit();

    // An empty set is an answer, too: it names the readings that contradict each other.
    let Some([slope, offset]) = fit.pui_intervals() else {
        println!("no line agrees with all readings");
        return Ok(());
    };
    println!("slope   {slope}");
    println!("offset  {offset}");

    println!("vertices, exactly and rounded to nearest:");
    for [theta1, theta2] in fit.vertices() {
        let decimals = [&theta1, &theta2].map(|number| number.to_decimal(6, Rounding::Nearest));
        println!("  {theta1} {theta2}  =  {} {}", decimals[0], decimals[1]);
    }

    if let Some(minimax) = &fit.minimax {
        println!("the smallest bound that leaves a line: {}", minimax.least);
    }
    // Each interval end, and the set itself, is recomputed from the readings.
    println!("proofs hold: {}", fit.verify(&problem).is_ok());
    Ok(())
}
